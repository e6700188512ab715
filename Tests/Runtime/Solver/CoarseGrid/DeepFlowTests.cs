using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The blend of deep particles' velocities to the flow of the coarse grid: what it leaves alone and what it takes. Its sums are
    /// compared with the reference's by <see cref="CoarseCorrectionTests"/>.</summary>
    public class DeepFlowTests
    {
        const int Side = 24;
        const float Speed = 30f;        // d/s
        const double Taken = 0.09968;   // of a departure, in 1/60 s: 1 - exp(-6.3 / 60)

        static IEnumerable<TestCaseData> Flows()
        {
            yield return new TestCaseData((Func<float3, float3>)(p => new float3(p.y - 12f, 0f, 0f) / 12f), 0.02).SetName("{m}(shear)");
            yield return new TestCaseData((Func<float3, float3>)(p => Vortex(p, math.PI / Side)), 0.02).SetName("{m}(vortex as wide as the box)");
            yield return new TestCaseData((Func<float3, float3>)(p => Vortex(p, 2f * math.PI / Side)), 0.1)
                .SetName("{m}(vortices half as wide)");
        }

        static float3 Vortex(float3 p, float wave)
            => new float3(math.sin(wave * p.x) * math.cos(wave * p.z), 0f, -math.cos(wave * p.x) * math.sin(wave * p.z));

        // Averaged over cells and looked up between their centers alone, the vortices would lose 7 and 25 % of what is taken of a departure.
        [TestCaseSource(nameof(Flows))]
        public void A_flow_that_the_grid_resolves_stays(Func<float3, float3> flow, double bound)
        {
            ParticleState state = Full().With(p => Speed * flow(p));
            double3[] changes = Changes(state, 1);
            double along = Enumerable.Range(0, state.Count).Sum(i => math.dot(changes[i], (double3)state.velocities[i].xyz))
                / state.velocities.Sum(v => (double)math.lengthsq(v.xyz));
            TestContext.Out.WriteLine($"{along / Taken:0.0000} of what a departure would lose");
            Assert.That(Math.Abs(along), Is.LessThan(bound * Taken));
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(4)]
        public void Noise_is_taken_at_one_rate_whatever_the_substeps(int substeps)
        {
            var random = new Unity.Mathematics.Random(5u);
            ParticleState state = Full().With(_ => Speed * (random.NextFloat3() - 0.5f));
            double3[] changes = Changes(state, substeps);
            double left = 1.0 + Enumerable.Range(0, state.Count).Sum(i => math.dot(changes[i], (double3)state.velocities[i].xyz))
                / state.velocities.Sum(v => (double)math.lengthsq(v.xyz));
            TestContext.Out.WriteLine($"{left:0.0000} left");
            // A cell's mean has an eighth of its 64 particles' noise.
            Assert.That(Math.Pow(left, substeps), Is.EqualTo(1.0 - Taken).Within(0.01));
        }

        [Test]
        public void Particles_near_the_surface_keep_their_velocities()
        {
            var random = new Unity.Mathematics.Random(6u);
            float3 box = new float3(Side, 2 * Side, Side);
            ParticleState state = ParticleState.Lattice(box, 0.5f, new int3(Side), 0.02f).With(_ => Speed * (random.NextFloat3() - 0.5f));
            double3[] changes = Changes(state, 1);
            for (int i = 0; i < state.Count; i++)
            {
                // The uppermost of six cells is at the surface and the next is beside it; the last deep one's center is at 14 d.
                bool isNear = state.positions[i].y > 18.5f;
                if (isNear)
                    Assert.That(math.length(changes[i]), Is.LessThan(1e-3), $"particle {i} at {state.positions[i]}");
            }
            double below = changes.Where((_, i) => state.positions[i].y < 13f).Average(change => math.length(change));
            Assert.That(below, Is.GreaterThan(0.05 * Speed * Taken));
        }

        // Water's own smoothing is left to the coarse flow where the water is deep. Whoever asks for more, or for densities, gets them everywhere.
        // The mean flow of several liquids is that of none.
        [TestCase(0.01f, false, 1, true)]
        [TestCase(0.05f, false, 1, false)]
        [TestCase(0.01f, true, 1, false)]
        [TestCase(0f, false, 1, false)]
        [TestCase(0.01f, false, 2, false)]
        public void Deep_particles_are_smoothed_by_neighbors_only_where_more_is_asked(float smoothing, bool needsDensity, int liquids, bool leavesOut)
        {
            using (var fluid = new TestFluid(new float3(12, 24, 12) * 0.05f, 0.05f, 12 * 16 * 12, Deep()).AddBlock(0f,
                new float3(12, 16, 12) * 0.05f))
            {
                fluid.Input.material.velocitySmoothing = smoothing;
                fluid.Input.needsDensity = needsDensity;
                if (liquids > 1)
                    fluid.Input.phases.Set(1, 800f, 0f);
                fluid.Step(1);
                string[] kernels = fluid.Solver.Describe(fluid.Input, 0).SelectMany(stage => stage.Kernels).Select(kernel => kernel.kernel).ToArray();
                Assert.That(kernels.Any(name => name.Contains("UpdateVelocityDeep")), Is.EqualTo(leavesOut), string.Join(", ", kernels));
            }
        }

        static SolverSettings Deep()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.On;
            return settings;
        }

        static ParticleState Full() => ParticleState.Lattice(Side, 0.5f, new int3(Side), 0.02f);

        // Changes of the velocities by the blend alone, d/s: what the projection adds is taken off.
        static double3[] Changes(ParticleState state, int substeps)
        {
            for (int i = 0; i < state.Count; i++)
                state.velocities[i].w = 1f;
            using (var stages = new CoarseStages(state, substeps: substeps).Project())
            {
                double timeStep = CoarseStages.TimeStep / substeps;
                CoarseCells cells = stages.Cells;
                double3[] displacements = Compare.Points(stages.Displacements);
                float4[] after = stages.Velocities;
                return Enumerable.Range(0, state.Count).Select(i =>
                {
                    double3 velocity = state.velocities[i].xyz;
                    double3 along = math.clamp((double3)state.positions[i].xyz + velocity * timeStep, 0.5, (double3)state.box - 0.5);
                    return (double3)after[i].xyz - velocity - cells.LookUp(displacements, along, 40.0) / timeStep;
                }).ToArray();
            }
        }
    }
}
