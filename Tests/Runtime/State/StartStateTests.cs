using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A snapshot as an asset, with which a fluid starts instead of its volumes.</summary>
    public class StartStateTests
    {
        static readonly Vector3 Box = new Vector3(1f, 1f, 0.8f);

        FluidSnapshotAsset asset;

        [TearDown]
        public void Destroy() => Object.DestroyImmediate(asset);

        [Test]
        public void A_fluid_starts_with_it_again_and_again()
        {
            ParticleState taken;
            using (SourceScene scene = new SourceScene(Box, 0.05f, 4000).Fill(0.2f).Step(20))
            {
                taken = scene.Read();
                asset = FluidSnapshotAsset.Create(Take(scene));
            }
            Assert.That(asset.Snapshot.StepCount, Is.EqualTo(20));
            using (SourceScene scene = new SourceScene(Box, 0.05f, 4000).Fill(0.5f))
            {
                scene.Fluid.StartState = asset;
                scene.Fluid.Restart();
                TestFluid.AssertSame(scene.Read(), taken);
                Assert.That((scene.Fluid.StepCount, scene.Fluid.FluidTime), Is.EqualTo((0, 0.0)));
                ParticleState later = scene.Step(3).Read();
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That((statistics.added, statistics.emitted), Is.EqualTo((taken.Count, 0)));
                scene.Fluid.Restart();
                TestFluid.AssertSame(scene.Step(3).Read(), later);
            }
        }

        [Test]
        public void One_that_does_not_fit_is_named_and_the_volumes_are_filled()
        {
            using (SourceScene scene = new SourceScene(Box, 0.05f, 4000).Fill(0.2f).Step())
                asset = FluidSnapshotAsset.Create(Take(scene));
            using (var scene = new SourceScene(Box, 0.04f, 4000))
            {
                scene.Fluid.StartState = asset;
                LogAssert.Expect(LogType.Error,
                    new Regex("fills its volumes instead of its start state 'Fluid Snapshot'.*Set the Particle Spacing to 0.05"));
                scene.Fill(0.1f);
                Assert.That(scene.Count(ParticleCounter.Alive), Is.EqualTo(25 * 2 * 20));
                scene.Fluid.Restart();      // logged once
                var problems = new List<string>();
                ((IHasProblems)scene.Fluid).ListProblems(problems);
                Assert.That(problems.Single(), Does.Contain("start state"));
                scene.Fluid.StartState = null;
                problems.Clear();
                ((IHasProblems)scene.Fluid).ListProblems(problems);
                Assert.That(problems, Is.Empty);
            }
        }

        [Test]
        public void One_without_content_says_so()
        {
            asset = ScriptableObject.CreateInstance<FluidSnapshotAsset>();
            Assert.That(asset.Validate(out string problem), Is.False);
            Assert.That(problem, Does.Contain("holds no snapshot"));
            Assert.That(asset.Snapshot, Is.Null);
        }

        static FluidSnapshot Take(SourceScene scene)
        {
            FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            return request.Snapshot;
        }
    }
}
