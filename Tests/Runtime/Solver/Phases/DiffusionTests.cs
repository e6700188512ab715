using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Constraints;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Materials that mix, against the spread that Fick's law gives. Lengths in d.</summary>
    public class DiffusionTests
    {
        const float Spacing = 0.01f;
        const float StepRate = 60f;
        const float Unit = Spacing * Spacing * StepRate;        // m²/s of 1 d² a step
        const float Center = 16f;
        static readonly float3 Box = new float3(2f * Center, 16f, 14f);
        static readonly int3 Counts = new int3(32, 12, 14);

        /// <summary>A still tank. Phase 1 has a density in kg/m³, phase 0 is water.</summary>
        static TestFluid Tank(float diffusion, Func<float3, int> phaseOf, float density = 1000f, Action<StepSettings> set = null)
        {
            var settings = new StepSettings { solver = SolverSettings.Default };
            settings.solver.iterations = 2;
            set?.Invoke(settings);
            var fluid = new TestFluid(Box * Spacing, Spacing, Counts.x * Counts.y * Counts.z, settings.solver);
            fluid.Input.timeStep = 1f / StepRate;
            fluid.Input.gravity = settings.gravity;
            for (int phase = 1; phase < 4; phase++)
                fluid.Input.phases.Set(phase, phase == 1 ? density : 1000f, 0f);
            fluid.Input.phases.SetPair(0, 1, diffusion);
            ParticleState block = ParticleState.Lattice(0f, 0.5f, Counts, 0.02f);
            foreach (IGrouping<int, float3> group in block.positions.Select(p => p.xyz).GroupBy(phaseOf))
                fluid.AddPhase(group.Key, group);
            return fluid;
        }

        sealed class StepSettings
        {
            public SolverSettings solver;
            public float3 gravity;
        }

        static int Beyond(float3 p) => p.x > Center ? 1 : 0;

        static (float3 position, float3 velocity, uint phase)[] Particles(TestFluid fluid)
        {
            ParticleState state = fluid.Read();
            uint[] phases = fluid.Phases();
            return Enumerable.Range(0, state.Count).Select(i => (state.positions[i].xyz, state.velocities[i].xyz, phases[i])).ToArray();
        }

        // Particles of each half in the other spread as erfc(x / √(4 D t)) / 2, of which ∫ |x| dx over both halves is D t. A particle is 1 d³.
        static double Spread(TestFluid fluid) => Particles(fluid).Where(p => p.phase != Beyond(p.position)).Sum(p => math.abs(p.position.x - Center))
            / (Counts.y * Counts.z);

        // Walls and the surface, where half of the neighbors are missing, slow nothing down. In a still lattice the mean of r² is 0.95 of that of a
        // ball within two spacings, and 1.14 of it within two and a half.
        [TestCase(0.01f, 1, 1f, 1.0)]
        [TestCase(0.05f, 1, 1f, 0.95)]
        [TestCase(0.05f, 3, 1f, 0.95)]
        [TestCase(0.05f, 1, 1.25f, 1.14)]
        [Category("LongRun")]
        public void A_border_of_two_liquids_widens_by_ficks_law(float strength, int substeps, float listMargin, double lattice)
        {
            int steps = (int)Math.Round(2f / strength);      // D t = 2 d²
            using (TestFluid fluid = Tank(strength * Unit, Beyond, set: s => (s.solver.substeps, s.solver.listMargin) = (substeps, listMargin)))
            {
                double spread = Spread(fluid.Step(steps));
                TestContext.Out.WriteLine($"D Δt {strength} d², {substeps} substeps, margin {listMargin}: D t {spread:0.00} of 2 d²");
                Assert.That(spread, Is.EqualTo(2.0 * lattice).Within(0.2));
            }
        }

        [Test]
        public void More_than_a_tenth_of_a_squared_spacing_a_substep_acts_like_that()
        {
            using (TestFluid fluid = Tank(5f * Unit, Beyond))
                Assert.That(Spread(fluid.Step(20)), Is.EqualTo(2.0).Within(0.25));
        }

        [Test]
        public void Nothing_of_a_liquid_is_lost_and_two_runs_are_equal()
        {
            var runs = new List<(float3 position, float3 velocity, uint phase)[]>();
            for (int run = 0; run < 2; run++)
            {
                using (TestFluid fluid = Tank(0.05f * Unit, Beyond, 800f))
                {
                    for (int step = 0; step < 10; step++)
                        Assert.That(Particles(fluid.Step()).Count(p => p.phase == 1), Is.EqualTo(Counts.x * Counts.y * Counts.z / 2), $"step {step}");
                    runs.Add(Particles(fluid));
                }
            }
            Assert.That(runs[1], Is.EqualTo(runs[0]));
            Assert.That(runs[0].Count(p => p.phase != Beyond(p.position)), Is.GreaterThan(100), "it mixes");
        }

        [Test]
        public void Liquids_that_do_not_mix_stay_apart_beside_two_that_do()
        {
            using (TestFluid fluid = Tank(0.05f * Unit, p => p.z > 7f ? 2 + Beyond(p) : Beyond(p)))
            {
                (float3 position, float3 velocity, uint phase)[] particles = Particles(fluid.Step(10));
                Assert.That(particles.Where(p => p.position.z < 5f).Count(p => p.phase != Beyond(p.position)), Is.GreaterThan(25));
                foreach (uint phase in new[] { 2u, 3u })
                    Assert.That(particles.Where(p => p.phase == phase).All(p => p.position.z > 6f && 2 + Beyond(p.position) == phase),
                        $"phase {phase}");
            }
        }

        // The heavier of two particles that change places would otherwise bring its neighbor's velocity with it.
        [Test]
        public void Particles_of_different_masses_change_places_without_a_push()
        {
            var momenta = new float3[2];
            for (int run = 0; run < 2; run++)
            {
                using (TestFluid fluid = Tank(run * 0.1f * Unit, Beyond, 250f))
                {
                    fluid.Input.material.velocitySmoothing = 0f;
                    ParticleState state = fluid.Read();
                    var velocities = state.positions.Select(p => new float4(p.y > 6f ? 3f : -3f, 0f, 0f, 0f)).ToArray();
                    fluid.Solver.Velocities.SetData(velocities);
                    (float3 position, float3 velocity, uint phase)[] particles = Particles(fluid.Step());
                    momenta[run] = particles.Aggregate(float3.zero, (sum, p) => sum + (p.phase == 1 ? 0.25f : 1f) * p.velocity);
                    Assert.That(particles.Count(p => p.phase != Beyond(p.position)), run == 0 ? (IResolveConstraint)Is.Zero : Is.GreaterThan(20));
                }
            }
            TestContext.Out.WriteLine($"momentum {momenta[0]} without, {momenta[1]} with");
            Assert.That(math.length(momenta[1] - momenta[0]), Is.LessThan(0.02f));
        }

        // Alone among others of another density a particle would rise or sink, see PhaseSlip.hlsl, and undo what diffusion does.
        [Test, Category("LongRun")]
        public void What_is_mixed_does_not_part_again([Values] bool mixes)
        {
            using (TestFluid fluid = Tank(mixes ? 1e-9f : 0f, p => (int)(math.hash(p) & 1u), 500f, s =>
            {
                s.gravity = new float3(0f, -9.81f, 0f);
                s.solver.deepWater = DeepWater.On;
            }))
            {
                (float3 position, float3 velocity, uint phase)[] particles = Particles(fluid.Step(60));
                double light = particles.Where(p => p.phase == 1).Average(p => p.position.y);
                double heavy = particles.Where(p => p.phase == 0).Average(p => p.position.y);
                TestContext.Out.WriteLine($"mixes {mixes}: light liquid at {light:0.00} d, heavy at {heavy:0.00} d");
                Assert.That(light - heavy, mixes ? Is.LessThan(0.4) : Is.GreaterThan(0.8));
            }
        }

        [Test]
        public void What_sleeps_does_not_mix()
        {
            using (TestFluid fluid = Tank(0.05f * Unit, Beyond, set: s => s.solver.sleepSpeed = 0.05f))
            {
                fluid.Step(60);
                uint[] before = Particles(fluid).Select(p => p.phase).ToArray();
                Assert.That(fluid.Read().velocities.All(v => math.all(v.xyz == 0f)), "asleep");
                Assert.That(Particles(fluid.Step(5)).Select(p => p.phase), Is.EqualTo(before));
            }
        }
    }
}
