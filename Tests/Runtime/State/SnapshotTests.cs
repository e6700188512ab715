using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>A fluid that goes on from a snapshot is the one that never stopped, bit for bit.</summary>
    public class SnapshotTests
    {
        const int After = 8;

        static IEnumerable<SnapshotCase> Cases()
        {
            yield return new SnapshotCase { name = "plain" };
            yield return new SnapshotCase { name = "substeps", substeps = 2 };
            yield return new SnapshotCase { name = "little numerical damping", numericalDamping = 0.2f };
            yield return new SnapshotCase { name = "deep water", deepWater = DeepWater.On, depth = 0.6f };
            yield return new SnapshotCase { name = "viscous", dynamicViscosity = 5f, substeps = 2 };
            yield return new SnapshotCase { name = "viscous deep water", dynamicViscosity = 5f, deepWater = DeepWater.On, depth = 0.6f };
            yield return new SnapshotCase { name = "grains", frictionAngle = 30f, deepWater = DeepWater.On, depth = 0.6f, colliders = true };
            yield return new SnapshotCase { name = "contacts", contacts = true, colliders = true, density = 500f, emitter = true, steps = 20 };
            yield return new SnapshotCase { name = "elastic", shearModulus = 100f };
            yield return new SnapshotCase { name = "vorticity", vorticity = 0.3f };
            yield return new SnapshotCase { name = "moving colliders", colliders = true, frameSteps = 0.7f };
            yield return new SnapshotCase { name = "moving box", moves = true, frameSteps = 1.3f };
            yield return new SnapshotCase
            {
                name = "moving colliders in deep water", colliders = true, moves = true,
                deepWater = DeepWater.On, depth = 0.6f
            };
            yield return new SnapshotCase { name = "emitter with phase and lifetime", emitter = true, steps = 20 };
            yield return new SnapshotCase
            {
                name = "two liquids", emitter = true, density = 500f, deepWater = DeepWater.On, depth = 0.6f, steps = 20
            };
            yield return new SnapshotCase
            {
                name = "two liquids that mix", emitter = true, density = 900f, diffusion = 0.01f, substeps = 2, depth = 0.3f, steps = 20
            };
            yield return new SnapshotCase { name = "drain that recycles", emitter = true, drain = true, steps = 20, frameSteps = 0.7f };
            yield return new SnapshotCase { name = "falling asleep", sleepSpeed = 0.5f, stands = true, colliders = true, field = true, steps = 28 };
            yield return new SnapshotCase { name = "sleep", sleepSpeed = 0.5f, stands = true, colliders = true, field = true, steps = 56 };
            yield return new SnapshotCase
            {
                name = "all together", deepWater = DeepWater.On, depth = 0.5f, substeps = 2, numericalDamping = 0.5f,
                dynamicViscosity = 0.5f, colliders = true, emitter = true,
                drain = true, field = true, moves = true, frameSteps = 0.7f, sleepSpeed = 0.02f,
            };
        }

        [TestCaseSource(nameof(Cases))]
        [Category("LongRun")]
        public void A_restored_fluid_goes_on_as_one_that_never_stopped(SnapshotCase made)
        {
            byte[] bytes;
            int taken;
            ParticleState expected;
            int steps;
            using (var scene = new SnapshotScene(made))
            {
                FluidSnapshot snapshot = scene.Run(made.steps).Take();
                taken = scene.Frame;
                bytes = snapshot.ToBytes();
                Assert.That(snapshot.ParticleCount, Is.EqualTo(scene.Count(ParticleCounter.Alive)).And.GreaterThan(500));
                expected = scene.Run(After).Read();
                if (made.stands)
                    Assert.That(scene.RegionStates(), Does.Contain((uint)RegionState.Asleep), "some of it sleeps");
                steps = scene.Fluid.StepCount;
                TestContext.Out.WriteLine(
                    $"{made}: {snapshot.ParticleCount} particles, {bytes.Length} bytes, {bytes.Length / snapshot.ParticleCount} a particle");

                scene.GoTo(taken).Fluid.Restore(snapshot);
                TestFluid.AssertSame(scene.Run(After).Read(), expected);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(steps));
            }
            using (var fresh = new SnapshotScene(made))
            {
                fresh.GoTo(taken).Fluid.Restore(FluidSnapshot.FromBytes(bytes));
                Assert.That(fresh.Take().ToBytes(), Is.EqualTo(bytes), "what is restored is what was taken");
                TestFluid.AssertSame(fresh.Run(After).Read(), expected);
                Assert.That(fresh.Fluid.StepCount, Is.EqualTo(steps));
            }
        }

        // Tests a buffer larger than the device binds; a snapshot does not know of it.
        [Test]
        public void Neighbor_lists_in_two_buffers_go_on_in_one_and_in_two()
        {
            using (TestFluid two = Viscous(240000), one = Viscous(0), again = Viscous(240000))
            {
                Assert.That(two.Solver.Layout.TwoLists && !one.Solver.Layout.TwoLists);
                two.AddBlock(0.1f, 0.6f).Step(4);
                Assert.That(two.Alive, Is.GreaterThan(two.Solver.Layout.FirstListParticles), "both are in use");
                SnapshotContents contents = null;
                two.Solver.Capture(new SnapshotContents()).Request((came, problem) => contents = came);
                AsyncGPUReadback.WaitAllRequests();
                ParticleState expected = two.Step(4).Read();
                foreach (TestFluid other in new[] { one, again })
                {
                    Assert.That(other.Solver.ProblemOf(contents), Is.Null);
                    other.Solver.Restore(contents, Features.Viscosity);
                    TestFluid.AssertSame(other.Step(4).Read(), expected);
                }
            }
        }

        static TestFluid Viscous(long maxBinding)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.Off;
            var fluid = new TestFluid(new float3(1f, 1f, 1f), 0.05f, 1800, settings, maxBinding);
            fluid.Input.material.dynamicViscosity = 2f;
            return fluid;
        }
    }
}
