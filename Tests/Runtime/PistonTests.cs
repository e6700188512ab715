using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>A closed box of water that a piston makes smaller.</summary>
    public class PistonTests
    {
        const float Spacing = 0.05f, Thickness = 4f;
        const int Side = 10, Layers = 12;

        // Spread evenly, the mean is what the piston took; the 50 layers of the report's extremes show the same.
        [Test]
        public void The_error_that_a_closing_piston_makes_spreads_over_all_the_water()
        {
            using (TestFluid fluid = Press(DeepWater.On, 0.02f, 45, 45))
            {
                FluidStatistics statistics = fluid.Measure();
                TestContext.Out.WriteLine($"C+ {100f * statistics.densityError:0.00} %, p99.9 {100f * statistics.densityError999:0.00} %, jitter {statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError, Is.InRange(0.006f, 0.026f));
                Assert.That(statistics.densityError999, Is.LessThan(5f * statistics.densityError));
                Assert.That(statistics.jitter, Is.LessThan(0.15f));
            }
        }

        [Test]
        public void A_piston_that_takes_a_fifth_of_the_room_loses_nobody_past_it([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Press(deepWater, 0.2f, 30, 20))
                Assert.That(fluid.Measure().densityError, Is.InRange(0.1f, 0.26f));
        }

        static TestFluid Press(DeepWater deepWater, float share, int closing, int after)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            TestFluid fluid = new TestFluid(new float3(Side, Layers + Thickness, Side) * Spacing, Spacing, Side * Layers * Side, settings).AddBlock(0f, new float3(Side, Layers, Side) * Spacing);
            ColliderMotion piston = ColliderTests.Still(ColliderShape.Box, new float3(2f * Side, Thickness, 2f * Side), At(Layers), quaternion.identity);
            for (int step = 1; step <= closing + after; step++)
            {
                piston.start = piston.end;
                float surface = Layers - math.min(step / (float)closing, 1f) * (Layers - Layers / (1f + share));
                piston.end.position = At(surface);
                ColliderTests.Use(fluid, piston);
                fluid.Step();
                if (step % 10 != 0)
                    continue;
                fluid.MeasureWhole();
                Assert.That(fluid.Read().positions.Max(p => p.y), Is.LessThan(surface), $"step {step}");
            }
            return fluid;
        }

        // Its lower side at a height, d.
        static float3 At(float surface) => new float3(0.5f * Side, surface + Thickness, 0.5f * Side);
    }
}
