using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Contacts of a playing fluid with Fluid Colliders.</summary>
    public class FluidContactTests : PlayedFluidFixture
    {
        readonly List<string> told = new List<string>();

        [UnityTest]
        public IEnumerator A_block_that_falls_on_a_plate_touches_hits_and_leaves_it_once([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.8f, 1f, 0.8f), 0.05f, 500, Vector3.zero, made =>
            {
                AddWater(made, new Vector3(0.3f, 0.3f, 0.3f), new Vector3(0f, 0.3f, 0f));
                SolverSettings settings = made.Settings;
                settings.deepWater = deepWater;
                made.Settings = settings;
            });
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            FluidContact touch = default, hit = default;
            plate.Touched += contact => { told.Add("touched"); touch = contact; };
            plate.Hit += contact => { told.Add("hit"); hit = contact; };
            plate.Left += contact => told.Add("left");
            plate.HitImpulse = 5f;          // the block brings 216 particles of 0.125 kg at 2.5 m/s, 67 N s
            yield return Frames(12);
            Assert.That(told, Is.Empty, "while it falls");
            yield return Frames(24);
            Assert.That(told, Is.EqualTo(new[] { "touched", "hit" }));
            Assert.That(touch.Collider, Is.SameAs(plate));
            Assert.That(touch.Fluid, Is.SameAs(fluid));
            Assert.That(touch.Step, Is.InRange(10, fluid.StepCount));
            Assert.That(hit.Impulse.y, Is.InRange(-67f, -5f));
            Assert.That(plate.TryGetForce(out _, out _), Is.False, "which Measures Force would bring");

            plate.transform.position = new Vector3(0f, 0.44f, 0f);
            plate.Teleport();
            yield return Frames(24);
            Assert.That(told, Is.EqualTo(new[] { "touched", "hit", "left" }), "the water is below it");
        }

        [UnityTest]
        public IEnumerator What_leaves_the_box_leaves_the_water_and_listeners_may_disable_anything()
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            plate.Touched += contact => told.Add("touched");
            plate.Left += contact =>
            {
                told.Add($"left {contact.Fluid.name} {contact.Impulse}");
                plate.enabled = fluid.enabled = false;
            };
            yield return Frames(10);
            plate.transform.position = new Vector3(10f, 0f, 0f);
            yield return Frames(3);
            Assert.That(told, Is.EqualTo(new[] { "touched", $"left Fluid {Vector3.zero}" }));
            Assert.That(fluid.enabled, Is.False);
        }

        [UnityTest]
        public IEnumerator A_fluid_that_begins_again_or_is_restored_forgets_what_it_did_to_colliders([Values(true, false)] bool restarts)
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            yield return Frames(2);
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            plate.MeasuresForce = true;
            plate.Touched += contact => told.Add("touched");
            plate.Left += contact => told.Add("left");
            yield return Frames(10);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return Frames(6);
            Assert.That(plate.TryGetForce(out _, out _));
            Assert.That(told, Is.EqualTo(new[] { "touched" }));
            if (restarts)
                fluid.Restart();
            else
                fluid.Restore(request.Snapshot);
            Assert.That(plate.TryGetForce(out _, out _), Is.False, "of before");
            int step = fluid.StepCount;
            int touched = 0;
            plate.Touched += contact => touched = contact.Step;
            yield return Frames(10);
            Assert.That(plate.TryGetForce(out _, out _), "of now");
            Assert.That(told, Is.EqualTo(new[] { "touched", "touched" }), "it did not leave");
            Assert.That(touched, Is.GreaterThan(step), "no step of before");
        }

        [UnityTest]
        public IEnumerator Without_a_listener_no_force_is_read_back()
        {
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            void Listen(FluidContact contact) => told.Add("touched");
            yield return Frames(3);
            Assert.That(fluid.Solver.Reactions, Is.Null);
            plate.Touched += Listen;
            yield return Frames(2);
            Assert.That(fluid.Solver.Reactions, Is.Not.Null);
            plate.Touched -= Listen;
            yield return Frames(2);
            Assert.That(fluid.Solver.Reactions, Is.Null);
        }

        [Test]
        public void An_impulse_out_of_range_is_clamped_and_said()
        {
            FluidCollider plate = Plate(Vector3.zero);
            LogAssert.Expect(LogType.Warning, new Regex("FluidCollider 'Plate': hit impulse 0 is outside"));
            plate.HitImpulse = 0f;
            Assert.That(plate.HitImpulse, Is.GreaterThan(0f));
        }

        FluidCollider Plate(Vector3 position)
        {
            var thing = new GameObject("Plate");
            made.Add(thing);
            thing.transform.position = position;
            var plate = thing.AddComponent<FluidCollider>();
            plate.Size = new Vector3(0.4f, 0.1f, 0.4f);
            return plate;
        }
    }
}
