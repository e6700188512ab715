using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Blocks of water at 100 m/s, 33 spacings in a step: nothing passes a wall and the energy of the start is not reached again.</summary>
    public class ImpactTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void A_block_onto_a_thin_layer_stays_inside_and_gains_no_energy([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(0f, new float3(18f, 2f, 18f) * Spacing)
                .AddBlock(new float3(6f, 14f, 6f) * Spacing, 6f * Spacing, new float3(0f, -100f, 0f)))
                AssertCalmsDown(fluid);
        }

        [Test]
        public void A_block_against_a_wall_stays_inside_and_gains_no_energy([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(6f * Spacing, 6f * Spacing, new float3(100f, 0f, 0f)))
                AssertCalmsDown(fluid);
        }

        [Test]
        public void A_block_into_a_corner_stays_inside_and_gains_no_energy([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(6f * Spacing, 6f * Spacing, new float3(-60f, -60f, -60f)))
                AssertCalmsDown(fluid);
        }

        // Plain iterations move pairs by as much to either side. The coarse grid's gradients do not sum to nothing over cells that are
        // partly full, and of a small block most are: see "Momentum of a splash" in Research~/colliders-study.md.
        [TestCase(DeepWater.Off, 1, 0.001f, 0.01f)]
        [TestCase(DeepWater.On, 1, 0.08f, 0.08f)]
        [TestCase(DeepWater.On, 2, 0.02f, 0.02f)]
        [Category("LongRun")]
        public void Two_blocks_that_meet_in_free_space_keep_momentum_and_spin(DeepWater deepWater, int scale, float momentumError, float spinError)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            settings.iterations = 2;
            using (var fluid = new TestFluid(64f * scale * Spacing, Spacing, 8000 * scale * scale * scale, settings))
            {
                fluid.Input.gravity = 0f;
                float length = scale * Spacing;
                // beside the other's center, so that they turn
                fluid.AddBlock(new float3(14f, 32f, 26f) * length, 12f * length, new float3(2.5f, 0f, 0f));
                fluid.AddBlock(new float3(29f, 23f, 23f) * length, 18f * length);
                (double3 momentum, double3 spin) before = Momentum(fluid.Read());
                fluid.Step(20).MeasureWhole();
                (double3 momentum, double3 spin) after = Momentum(fluid.Read());
                double gained = math.length(after.momentum - before.momentum) / math.length(before.momentum);
                double spun = math.length(after.spin - before.spin) / (math.length(before.momentum) * 6.0 * scale);
                TestContext.Out.WriteLine($"{100.0 * gained:0.00} % of the momentum gained or lost, {100.0 * spun:0.00} % of it at " +
                    $"half the small block's side in spin");
                Assert.That(gained, Is.LessThan(momentumError), "momentum");
                Assert.That(spun, Is.LessThan(spinError), "spin");
            }
        }

        [Test]
        public void Water_that_meets_water_at_33_spacings_in_a_step_is_not_pressed_together()
        {
            const float spacing = 0.0125f;
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.On;
            settings.iterations = 2;
            using (TestFluid fluid = new TestFluid(new float3(32f, 80f, 32f) * spacing, spacing, 6700, settings)
                .AddBlock(0f, new float3(32f, 4f, 32f) * spacing)
                .AddBlock(new float3(10f, 40f, 10f) * spacing, new float3(12f, 16f, 12f) * spacing, new float3(0f, -25f, 0f)))
            {
                float mean = 0f, largest = 0f;
                int coincident = 0;
                float last = fluid.Measure().Energy;
                for (int step = 0; step < 6; step++)
                {
                    FluidStatistics statistics = fluid.Step().MeasureWhole();
                    mean = math.max(mean, statistics.densityError);
                    largest = math.max(largest, statistics.densityErrorMax);
                    coincident = math.max(coincident, statistics.coincident);
                    Assert.That(statistics.Energy, Is.LessThan(1.001f * last), $"step {step}");
                    last = statistics.Energy;
                }
                TestContext.Out.WriteLine($"highest C+ {100f * mean:0.0} %, largest {largest:0.0}, most coincident {coincident}");
                Assert.That(mean, Is.LessThan(0.15f));
                Assert.That(largest, Is.LessThan(3f));
                Assert.That(coincident, Is.LessThan(20));
            }
        }

        static void AssertCalmsDown(TestFluid fluid)
        {
            float last = fluid.Measure().Energy, first = last;
            for (int part = 0; part < 15; part++)
            {
                FluidStatistics statistics = fluid.Step(part < 10 ? 1 : 6).MeasureWhole();
                // Compressed water expands again: that little may come back of what the impact took.
                Assert.That(statistics.Energy, Is.LessThan(math.min(last + 0.01f * first, first)), $"part {part}");
                last = statistics.Energy;
            }
            Assert.That(fluid.Measure().densityError, Is.LessThan(0.05f));
        }

        // Sums of velocities and of their moments about the center of the box, in d/s and d²/s.
        static (double3 momentum, double3 spin) Momentum(ParticleState state)
        {
            double3 momentum = 0.0, spin = 0.0;
            for (int i = 0; i < state.Count; i++)
            {
                double3 velocity = state.velocities[i].xyz;
                momentum += velocity;
                spin += math.cross(state.positions[i].xyz - (double3)state.box * 0.5, velocity);
            }
            return (momentum, spin);
        }

        static TestFluid Box(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return new TestFluid(new float3(18f, 24f, 18f) * Spacing, Spacing, 1000, settings);
        }
    }
}
