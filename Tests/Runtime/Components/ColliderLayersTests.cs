using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = NUnit.Framework.Is;

namespace Rill.Tests
{
    /// <summary>Which Fluid Colliders act on a fluid, by their layers.</summary>
    public class ColliderLayersTests : PlayedFluidFixture
    {
        const int Layer = 8, Other = 9;

        readonly List<string> told = new List<string>();

        [UnityTest]
        public IEnumerator A_fluid_takes_the_Fluid_Colliders_of_its_layers_and_all_by_default()
        {
            FluidSimulation all = Pool("All"), one = Pool("One"), none = Pool("None");
            Assert.That((int)all.FluidColliderLayers, Is.EqualTo(~0));
            one.FluidColliderLayers = 1 << Layer;
            none.FluidColliderLayers = 0;
            FluidCollider stone = Ball("Stone", Layer), other = Ball("Other", Other);
            stone.MeasuresForce = other.MeasuresForce = true;
            other.Friction = 0.5f;
            yield return Frames(8);
            Assert.That((all.Inputs.Colliders.Set.Count, one.Inputs.Colliders.Set.Count, none.Inputs.Colliders.Set.Count), Is.EqualTo((2, 1, 0)));
            Assert.That(one.Input.colliders.Items[0].friction, Is.Zero, "that of the stone");
            Assert.That(none.Results.Describe().Single(stage => stage.Name == "Colliders").IsUsed, Is.False, "which costs nothing");
            Assert.That(stone.TryGetForceOf(all, out _) && stone.TryGetForceOf(one, out _) && other.TryGetForceOf(all, out _));
            Assert.That(stone.TryGetForceOf(none, out _) || other.TryGetForceOf(one, out _) || other.TryGetForceOf(none, out _), Is.False);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator What_is_taken_out_at_run_time_has_left_the_fluid([Values] bool byMask)
        {
            told.Clear();
            FluidSimulation fluid = Pool("Pool"), second = Pool("Second");
            FluidCollider stone = Ball("Stone", Layer);
            stone.MeasuresForce = true;
            stone.OnEnter += contact => told.Add($"touched {contact.Fluid.name}");
            stone.OnExit += contact => told.Add($"left {contact.Fluid.name} {contact.Impulse}");
            second.FluidColliderLayers = 1 << Layer | 1 << Other;
            fluid.FluidColliderLayers = 1 << Layer;
            yield return Frames(10);
            Assert.That(told, Is.EquivalentTo(new[] { "touched Pool", "touched Second" }));
            Assert.That(stone.TryGetForceOf(fluid, out _));

            if (byMask)
                fluid.FluidColliderLayers = 1 << Other;
            else
                stone.gameObject.layer = Other;
            yield return null;
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.Zero, "from the next step on");
            Assert.That(stone.TryGetForceOf(fluid, out _), Is.False, "it no more feels that fluid");
            yield return Frames(6);
            Assert.That(stone.TryGetForceOf(fluid, out _), Is.False, "nor a pending result");
            Assert.That(stone.TryGetForceOf(second, out _), "it still is in the other");
            Assert.That(told.Skip(2), Is.EqualTo(new[] { $"left Pool {Vector3.zero}" }), "once");

            fluid.FluidColliderLayers = ~0;
            yield return Frames(10);
            Assert.That(stone.TryGetForceOf(fluid, out _));
            Assert.That(told.Skip(3), Is.EqualTo(new[] { "touched Pool" }));
        }

        // One without a field would log an error where it is looked at.
        [UnityTest]
        public IEnumerator Those_of_other_layers_are_not_looked_at_and_nothing_is_allocated()
        {
            FluidSimulation fluid = Pool("Pool");
            fluid.FluidColliderLayers = 1 << Layer;
            Ball("Broken", Other).Shape = ColliderShape.Mesh;
            Ball("Stone", Layer);
            TestDelegate frame = () => fluid.Advance(1f / 60f);
            for (int i = 0; i < 24; i++)
            {
                frame();        // twice a frame, as the check calls it
                frame();
                yield return null;
            }
            Assert.That(frame, Is.Not.AllocatingGCMemory());
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.EqualTo(1));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_restored_fluid_takes_what_its_layers_are_now()
        {
            FluidSimulation fluid = Pool("Pool");
            FluidCollider stone = Ball("Stone", Layer);
            stone.MeasuresForce = true;
            yield return Frames(4);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return Frames(4);
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.EqualTo(1));
            fluid.Restore(request.Snapshot);
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.EqualTo(1));
            fluid.FluidColliderLayers = 1 << Other;
            fluid.Restore(request.Snapshot);
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.Zero);
            yield return Frames(4);
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.Zero);
            Assert.That(stone.TryGetForceOf(fluid, out _), Is.False);
        }

        FluidSimulation Pool(string name) => Fluid(name, 0.6f * Vector3.one, 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));

        FluidCollider Ball(string name, int layer)
        {
            var ball = new GameObject(name) { layer = layer };
            made.Add(ball);
            ball.transform.position = new Vector3(0f, -0.2f, 0f);
            var collider = ball.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Sphere;
            collider.Radius = 0.1f;
            return collider;
        }
    }
}
