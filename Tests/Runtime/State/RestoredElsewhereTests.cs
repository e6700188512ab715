using System.Linq;
using System.Runtime.InteropServices;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>A fluid that is restored where its snapshot does not know it, or with parts that the snapshot does not know, begins there
    /// as one that has just been made: nothing of how it came there is left.</summary>
    public class RestoredElsewhereTests : CallsFixture
    {
        const int More = 7;     // frames from the snapshot to the restore: no multiple of the readbacks' interval

        static readonly SnapshotSection[] Compared =
        {
            SnapshotSection.Solver, SnapshotSection.Time, SnapshotSection.Counters, SnapshotSection.Positions, SnapshotSection.Velocities,
            SnapshotSection.Ids, SnapshotSection.Tags, SnapshotSection.Calls, SnapshotSection.Emitters, SnapshotSection.EmitterStates,
            SnapshotSection.Drains, SnapshotSection.DrainStates, SnapshotSection.Colliders
        };

        [Test]
        public void Nothing_is_left_of_what_box_and_parts_did_after_the_snapshot([Values] bool elsewhere)
        {
            Make(false);
            Run(Before);
            FluidSnapshot first = Take();
            LeaveNothing();
            (SnapshotContents atOnce, Vector3 leaving, ParticleState later) expected = Again(false), found = Again(true);
            foreach (SnapshotSection section in Compared)
                Assert.That(found.atOnce.Bytes(section), Is.EqualTo(expected.atOnce.Bytes(section)), section.ToString());
            Assert.That(found.leaving, Is.EqualTo(expected.leaving), "m/s, of an emitter that has let nothing in yet");
            TestFluid.AssertSame(found.later, expected.later);

            (SnapshotContents, Vector3, ParticleState) Again(bool runs)
            {
                Make(false);
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(-0.2f, 0.3f, 0.1f), Vector3.down, e =>
                {
                    e.Rate = 0.01f;
                    e.Speed = 1f;
                    e.Radius = 0.1f;
                });
                scene.Add<FluidDrain>(new Vector3(0.3f, -0.4f, 0f), Vector3.forward, d =>
                {
                    d.Size = 0.2f * Vector3.one;
                    d.RateLimit = 0.01f;
                });
                if (runs)
                {
                    Run(Before + More);
                    emitter.StopEmission();
                    emitter.transform.localPosition += 0.2f * Vector3.right;
                    Run(1);
                    emitter.transform.localPosition -= 0.2f * Vector3.right;
                }
                GoTo(Before);
                if (elsewhere)
                    PutElsewhere(new Vector3(3f, 1f, 0f));
                if (elsewhere && runs)
                    scene.Fluid.Teleport();
                scene.Fluid.Restore(first);
                SnapshotContents atOnce = Take().Contents;
                Vector3 leaving = emitter.LeavingVelocity;
                Run(After);
                ParticleState later = scene.Read();
                LeaveNothing();
                return (atOnce, leaving, later);
            }
        }

        // It came to rest without the field, or under it: under other forces nothing rests.
        [Test]
        public void Water_that_slept_wakes_where_it_is_restored_under_other_fields([Values] bool comes)
        {
            Make(true);
            if (comes)
                Do(Call.RemoveField);
            Run(Asleep);
            Assert.That(RegionStates(), Does.Contain((uint)RegionState.Asleep), "some of it sleeps");
            FluidSnapshot asleep = Take();
            if (comes)
                scene.Add<FluidForceField>(new Vector3(0.2f, -0.2f, 0f), Vector3.up, f => f.Kind = ForceFieldKind.Vortex);
            else
                Do(Call.RemoveField);
            Run(More);
            scene.Fluid.Restore(asleep);
            Run(1);
            Assert.That(RegionStates(), Is.All.EqualTo((uint)RegionState.Awake));
        }

        // Like with a restart, a query of the old water does not answer for the new one.
        [Test]
        public void Answers_from_before_a_restore_are_none_of_the_restored_water([Values] bool elsewhere)
        {
            Make(false);
            FluidProbe probe = scene.Add<FluidProbe>(new Vector3(0f, -0.3f, 0f), Vector3.forward);
            FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.3f, 0f), Vector3.forward, d => d.Size = 0.2f * Vector3.one);
            Run(Before);
            FluidSnapshot first = Take();
            scene.Fluid.FlushQueries();
            Assert.That((probe.TryGetSample(out _), detector.Latest.valid), Is.EqualTo((true, true)));
            if (elsewhere)
                PutElsewhere(new Vector3(3f, 1f, 0f));
            scene.Fluid.Restore(first);
            Assert.That((probe.TryGetSample(out _), detector.Latest.valid), Is.EqualTo((false, false)));
            Run(1);
            scene.Fluid.FlushQueries();
            Assert.That((probe.TryGetSample(out _), detector.Latest.valid), Is.EqualTo((true, true)));
        }

        [Test]
        public void Statistics_come_as_many_steps_after_a_restore_as_after_a_start()
        {
            Make(false);
            Run(Before);
            FluidSnapshot first = Take();
            LeaveNothing();
            Assert.That(MeasuredSteps(true), Is.EqualTo(MeasuredSteps(false)));

            int[] MeasuredSteps(bool runs)
            {
                Make(false);
                scene.Fluid.StatisticsInterval = 5;
                if (runs)
                    Run(Before + 3);
                GoTo(Before);
                scene.Fluid.Restore(first);
                var steps = new int[12];
                for (int i = 0; i < steps.Length; i++)
                {
                    Run(1);
                    AsyncGPUReadback.WaitAllRequests();
                    steps[i] = scene.Fluid.TryGetStatistics(out FluidStatistics statistics) ? statistics.step : -1;
                }
                Assert.That(steps, Has.Member(Before + 5).And.Member(-1));
                LeaveNothing();
                return steps;
            }
        }

        // The snapshot's emitter and drain are gone: what waits for the one, and what the other counted, is given up by the next step.
        [Test]
        public void What_waits_for_an_emitter_that_is_no_more_is_given_up()
        {
            Make(false);
            Run(Before);
            FluidSnapshot first = Take();
            uint[] before = MemoryMarshal.Cast<byte, uint>(first.Contents.Bytes(SnapshotSection.EmitterStates)).ToArray();
            Assert.That(before.Take(EmitterStates.Words), Has.Some.Not.Zero);
            Do(Call.RemoveEmitter);
            Do(Call.RemoveDrain);
            Run(2);
            GoTo(Before);
            scene.Fluid.Restore(first);
            TimeRecord time = Take().Contents.Get<TimeRecord>(SnapshotSection.Time);
            Assert.That((time.goneEmitters, time.goneDrains), Is.EqualTo((1u, 1u)), "until the next step");
            Run(1);
            Assert.That((scene.Count(ParticleCounter.Waiting), scene.AssertConserved().recycling), Is.EqualTo((0, 0)));
        }
    }
}
