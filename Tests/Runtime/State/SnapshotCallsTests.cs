using System;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Calls by a script between the last step and a snapshot are in the snapshot: a fluid that is restored goes on as one that
    /// never stopped.</summary>
    public class SnapshotCallsTests : CallsFixture
    {
        // Colliders are told apart by their sizes: one with another begins at rest after a restore.
        static Call[] AllButAnotherSize => Enum.GetValues(typeof(Call)).Cast<Call>().Where(call => call != Call.ResizeCollider).ToArray();

        [Test, Category("LongRun")]
        public void A_call_is_in_the_next_snapshot([ValueSource(nameof(AllButAnotherSize))] Call call)
        {
            Make(false);
            Run(Before);
            AssertGoesOn(call);
        }

        [Test, Category("LongRun")]
        public void A_call_after_a_restore_is_in_the_next_snapshot([Values(Call.Nothing, Call.FillShape, Call.RemoveInside, Call.TeleportFluidAlone,
            Call.StartEmission, Call.Recenter)] Call call)
        {
            Make(false);
            Run(Before);
            FluidSnapshot first = Take();
            int at = frame;
            Run(3);
            GoTo(at);
            scene.Fluid.Restore(first);
            AssertGoesOn(call);
        }

        [Test]
        public void What_a_call_wakes_wakes_after_a_restore([Values(Call.Nothing, Call.AddParticles, Call.FillShape, Call.RemoveInside,
            Call.TeleportCollider, Call.AddCollider, Call.RemoveCollider, Call.RemoveField, Call.Gravity, Call.Settings, Call.Material,
            Call.MoveCollider, Call.TurnCollider, Call.ResizeCollider, Call.ChangeField)] Call call, [Values] bool afterRestore)
        {
            Make(true);
            Run(Asleep);
            Assert.That(RegionStates(), Does.Contain((uint)RegionState.Asleep), "some of it sleeps");
            if (afterRestore)
                scene.Fluid.Restore(Take());
            AssertGoesOn(call);
        }

        [Test]
        public void A_box_that_has_just_begun_to_move_goes_on_as_it_did([Values(1, 2, 3)] int steps)
        {
            Make(false);
            Run(steps);
            AssertGoesOn(Call.Nothing);
        }

        [Test]
        public void What_is_removed_is_known_as_removed_after_a_restore()
        {
            Make(false);
            Run(Before);
            Do(Call.RemoveInside);
            FluidSnapshot snapshot = FluidSnapshot.FromBytes(Take().ToBytes());
            Run(1);
            scene.Fluid.Restore(snapshot);
            Assert.That(scene.Fluid.Solver.HasMarked, "until the next step, which leaves them out");
            Run(1);
            Assert.That(scene.Fluid.Solver.HasMarked, Is.False);
        }

        [Test]
        public void A_new_layout_acts_before_the_snapshot()
        {
            Make(false);
            Run(2);
            scene.Fluid.Configure(new Vector3(1f, 1f, 0.8f), 0.05f, 7000);
            Assert.That(Take().StepCount, Is.Zero, "it began again");
            Assert.That(scene.Fluid.Solver.Layout.Capacity, Is.EqualTo(7000));
        }

        void AssertGoesOn(Call call)
        {
            Do(call);
            FluidSnapshot snapshot = Take();
            bool isKnown = collider.TryGetForce(out Vector3 forceThen, out Vector3 torqueThen);
            int at = frame;
            Run(After);
            ParticleState expected = scene.Read();
            (Vector3 force, Vector3 torque) = ForceOnCollider();
            int steps = scene.Fluid.StepCount;
            uint[] asleep = RegionStates();
            foreach (FluidSnapshot from in new[] { snapshot, FluidSnapshot.FromBytes(snapshot.ToBytes()) })
            {
                GoTo(at);
                scene.Fluid.Restore(from);
                bool isNew = call == Call.TeleportCollider || call == Call.ResizeCollider;      // to a fluid that is restored: its force too
                if (!isNew)
                {
                    Assert.That(collider.TryGetForce(out Vector3 restored, out Vector3 restoredTorque), Is.EqualTo(isKnown));
                    Assert.That((restored, restoredTorque), Is.EqualTo((forceThen, torqueThen)), "N and N m, as before");
                }
                Run(After);
                TestFluid.AssertSame(scene.Read(), expected);
                if (!isNew)
                    Assert.That(ForceOnCollider(), Is.EqualTo((force, torque)), "N and N m");
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(steps));
                Assert.That(RegionStates(), Is.EqualTo(asleep));
            }
        }

        // The newest that has come by now.
        (Vector3, Vector3) ForceOnCollider()
        {
            AsyncGPUReadback.WaitAllRequests();
            scene.Fluid.Advance(0f);
            collider.TryGetForce(out Vector3 force, out Vector3 torque);
            return (force, torque);
        }
    }
}
