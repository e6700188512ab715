using NUnit.Framework;
using UnityEngine;

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
                scene.Fluid.Restore(first);
                SnapshotContents atOnce = Take().Contents;
                Vector3 leaving = emitter.LeavingVelocity;
                Run(After);
                ParticleState later = scene.Read();
                LeaveNothing();
                return (atOnce, leaving, later);
            }
        }
    }
}
