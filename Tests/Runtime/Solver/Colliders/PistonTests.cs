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
                TestContext.Out.WriteLine($"C+ {100f * statistics.densityError:0.00} %, p99.9 {100f * statistics.densityError999:0.00} " +
                    $"%, jitter {statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError, Is.InRange(0.006f, 0.026f));
                Assert.That(statistics.densityError999, Is.LessThan(5f * statistics.densityError));
                Assert.That(statistics.jitter, Is.LessThan(0.15f));
            }
        }

        // The constraint seeks the density that the room has left for the particles, or they would fight over it.
        [Test]
        public void Water_of_which_a_piston_takes_a_fifth_of_the_room_calms_down_and_none_passes_it(
            [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Press(deepWater, 0.2f, 30, 50))
            {
                FluidStatistics statistics = fluid.Measure();
                TestContext.Out.WriteLine($"C+ {100f * statistics.densityError:0.0} %, p99.9 {100f * statistics.densityError999:0.0} " +
                    $"%, jitter {statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError, Is.InRange(0.1f, 0.26f));
                Assert.That(statistics.densityError999, Is.LessThan(3f * statistics.densityError));
                Assert.That(statistics.jitter, Is.LessThan(0.1f));
            }
        }

        // Balls, boxes at any angle, and of two in one place no more than one; what lies outside of the domain does not count.
        [Test]
        public void What_colliders_take_of_the_domain_is_measured()
        {
            const float box = 24f;
            ColliderMotion ball = ColliderTests.Still(ColliderShape.Sphere, 5f, new float3(7f, 8f, 9f), quaternion.identity);
            ColliderMotion tilted = ColliderTests.Still(ColliderShape.Box, new float3(3f, 4f, 2f), new float3(16f, 15f, 15f),
                quaternion.Euler(0.3f, 0.4f, 0.5f));
            ColliderMotion floor = ColliderTests.Still(ColliderShape.Plane, 1f, new float3(0f, 1.3f, 0f), quaternion.identity);
            ColliderMotion shell = ball;
            shell.insideOut = true;
            float sphere = 4f / 3f * math.PI * 125f;
            foreach ((ColliderMotion[] solids, float volume) in new[] { (new[] { ball }, sphere), (new[] { ball, ball }, sphere),
                (new[] { tilted }, 192f), (new[] { ball, tilted }, sphere + 192f), (new[] { floor }, 1.3f * box * box),
                (new[] { shell }, box * box * box - sphere) })
            {
                using (TestFluid fluid = new TestFluid(box * Spacing, Spacing, 1).AddBlock(11f * Spacing, Spacing))
                {
                    ColliderTests.Use(fluid, solids);
                    fluid.Step();
                    double measured = GpuTest.Read<uint>(fluid.Solver.Colliders.ColliderVolume, 1)[0] / (double)(1 << 30) * box * box * box;
                    Assert.That(measured, Is.EqualTo(volume).Within(0.03 * volume), $"{solids.Length} x {solids[0].shape}");
                }
            }
        }

        static TestFluid Press(DeepWater deepWater, float fraction, int closing, int after)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            TestFluid fluid = new TestFluid(new float3(Side, Layers + Thickness, Side) * Spacing, Spacing, Side * Layers * Side, settings)
                .AddBlock(0f, new float3(Side, Layers, Side) * Spacing);
            ColliderMotion piston = ColliderTests.Still(ColliderShape.Box, new float3(2f * Side, Thickness, 2f * Side), At(Layers),
                quaternion.identity);
            for (int step = 1; step <= closing + after; step++)
            {
                piston.start = piston.end;
                float surface = Layers - math.min(step / (float)closing, 1f) * (Layers - Layers / (1f + fraction));
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
