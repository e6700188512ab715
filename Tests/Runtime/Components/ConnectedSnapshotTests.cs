using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Snapshots of two fluids with water going between them.</summary>
    public class ConnectedSnapshotTests : ConnectedFluidFixture
    {
        const int After = 12;       // frames from the snapshots to what is compared

        [UnityTest, Category("LongRun")]
        public IEnumerator Two_fluids_restored_together_go_on_as_ones_that_never_stopped([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.9f, 0.5f), new Vector3(2f, 0.5f, 0.5f), deepWater);
            Connect(left, right);
            yield return Frames(25);
            int step = left.StepCount;
            FluidSnapshotRequest ofLeft = left.RequestSnapshot(), ofRight = right.RequestSnapshot();
            yield return Frames(After);
            Assert.That(left.StepCount, Is.EqualTo(step + After));
            ParticleState expectedLeft = TestFluid.Read(left.Solver), expectedRight = TestFluid.Read(right.Solver);
            Assert.That(expectedRight.Count, Is.Not.EqualTo(ofRight.Snapshot.ParticleCount), "water went through meanwhile");

            left.Restore(ofLeft.Snapshot);
            right.Restore(ofRight.Snapshot);
            Assert.That((left.StepCount, right.StepCount), Is.EqualTo((step, step)));
            yield return Frames(After);
            Assert.That(left.StepCount, Is.EqualTo(step + After));
            TestContext.Out.WriteLine($"{expectedLeft.Count} and {expectedRight.Count} particles");
            TestFluid.AssertSame(TestFluid.Read(left.Solver), expectedLeft);
            TestFluid.AssertSame(TestFluid.Read(right.Solver), expectedRight);
        }
    }
}
