using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Calls by a script between two steps are neither lost nor held back by whatever else happens there: a fluid that is disabled,
    /// teleported, restarted, restored or destroyed.</summary>
    public class PendingCallsTests : CallsFixture
    {
        public enum Between { DisableAndEnable, TeleportInPlace, SnapshotAndRestore, StandStill }

        static readonly SnapshotSection[] Compared =
        {
            SnapshotSection.Solver, SnapshotSection.Time, SnapshotSection.Counters, SnapshotSection.Positions, SnapshotSection.Velocities,
            SnapshotSection.Ids, SnapshotSection.Tags, SnapshotSection.Calls, SnapshotSection.Emitters, SnapshotSection.EmitterStates,
            SnapshotSection.Drains, SnapshotSection.Colliders
        };

        // Runs a scene that stands still, part of it asleep: a wake is pending too.
        [Test, Category("LongRun")]
        public void A_call_acts_in_the_next_step_whatever_happens_before_it([Values(Call.Nothing, Call.AddParticles, Call.RemoveInside,
            Call.Clear, Call.TeleportCollider, Call.RemoveCollider, Call.RemoveField, Call.Gravity, Call.Settings, Call.ResizeCollider)]
            Call call)
        {
            (ParticleState expected, uint[] regions) = Play(call, () => { });
            foreach (Between between in Enum.GetValues(typeof(Between)))
            {
                (ParticleState found, uint[] regionsThen) = Play(call, () => Do(between));
                TestFluid.AssertSame(found, expected);
                Assert.That(regionsThen, Is.EqualTo(regions), $"{between}");
            }
        }

        void Do(Between between)
        {
            FluidSimulation fluid = scene.Fluid;
            switch (between)
            {
                case Between.DisableAndEnable:
                    fluid.enabled = false;
                    fluid.enabled = true;
                    break;
                case Between.TeleportInPlace: fluid.Teleport(); break;
                case Between.SnapshotAndRestore: fluid.Restore(Take()); break;
                case Between.StandStill: fluid.Advance(0f); break;
            }
        }

        (ParticleState, uint[]) Play(Call call, Action between)
        {
            Make(true);
            Run(Asleep);
            Assert.That(RegionStates(), Does.Contain((uint)RegionState.Asleep), "some of it sleeps");
            Do(call);
            between();
            Run(After);
            (ParticleState, uint[]) result = (scene.Read(), RegionStates());
            LeaveNothing();
            return result;
        }

        [Test, Category("LongRun")]
        public void Nothing_of_a_call_is_left_after_a_restart_or_a_restore([Values(Call.AddParticles, Call.FillShape, Call.FillVolume,
            Call.RemoveInside, Call.Clear, Call.Pause, Call.DisableAndEnable, Call.TeleportCollider, Call.TeleportEmitter,
            Call.TeleportDrain)] Call call, [Values] bool restores)
        {
            (SnapshotContents atOnce, ParticleState later) expected = Again(Call.Nothing), found = Again(call);
            foreach (SnapshotSection section in Compared)
                if (restores || section != SnapshotSection.Colliders)       // after a restart none goes on that has moved since
                    Assert.That(found.atOnce.Bytes(section), Is.EqualTo(expected.atOnce.Bytes(section)), section.ToString());
            TestFluid.AssertSame(found.later, expected.later);

            (SnapshotContents, ParticleState) Again(Call before)
            {
                Make(false);
                Run(Before);
                FluidSnapshot first = Take();
                Do(before);
                GoBack();
                if (restores)
                    scene.Fluid.Restore(first);
                else
                    scene.Fluid.Restart();
                SnapshotContents atOnce = Take().Contents;
                Run(After);
                ParticleState later = scene.Read();
                LeaveNothing();
                return (atOnce, later);
            }
        }

        [Test]
        public void A_fluid_with_a_pending_call_ends_quietly([Values(Call.AddParticles, Call.FillShape, Call.Clear,
            Call.StartEmission, Call.TeleportFluid, Call.Recenter, Call.DisableAndEnable, Call.RemoveCollider, Call.Settings)] Call call)
        {
            Make(false);
            Run(Before);
            Do(call);
            FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
            Do(Call.RemoveInside);
            Object.DestroyImmediate(scene.Fluid);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(request.IsDone);
            LogAssert.NoUnexpectedReceived();
        }

        // A request gets the state of its time, whatever is called before it arrives.
        [Test]
        public void A_snapshot_is_of_the_time_when_it_was_asked_for([Values(Call.AddParticles, Call.FillShape, Call.RemoveInside, Call.Clear,
            Call.TeleportFluid, Call.Recenter, Call.DisableAndEnable)] Call call, [Values] bool steps)
        {
            Make(false);
            Run(Before);
            SnapshotContents expected = Take().Contents;
            FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
            Do(call);
            if (steps)
                Run(1);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(request.Problem, Is.Null);
            foreach (SnapshotSection section in Compared)
                Assert.That(request.Snapshot.Contents.Bytes(section), Is.EqualTo(expected.Bytes(section)), section.ToString());
        }
    }
}
