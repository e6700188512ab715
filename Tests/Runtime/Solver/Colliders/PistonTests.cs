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
            using (TestFluid fluid = Press(DeepWater.On, Layers, 0.02f, 45, 45))
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
            using (TestFluid fluid = Press(deepWater, Layers, 0.2f, 30, 50))
            {
                FluidStatistics statistics = fluid.Measure();
                TestContext.Out.WriteLine($"C+ {100f * statistics.densityError:0.0} %, p99.9 {100f * statistics.densityError999:0.0} " +
                    $"%, jitter {statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError, Is.InRange(0.1f, 0.26f));
                Assert.That(statistics.densityError999, Is.LessThan(3f * statistics.densityError));
                Assert.That(statistics.jitter, Is.LessThan(0.1f));
            }
        }

        // The piston starts at the sides of the coarse grid's cells, 24 of 28 d up, where the cells above it have no water and those below no
        // solid in them. By a fifth it passes to the next ones.
        [TestCase(0.002f)]
        [TestCase(0.02f)]
        [TestCase(0.2f)]
        [Category("LongRun")]
        public void Full_boxes_are_calm_wherever_in_a_coarse_cell_the_piston_ends(float fraction)
        {
            using (TestFluid fluid = Press(DeepWater.On, 24, fraction, 60, 60))
            {
                FluidStatistics statistics = fluid.Measure();
                TestContext.Out.WriteLine($"p99.9 of C+ {100f * statistics.densityError999:0.0} %, jitter {statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError999, Is.LessThan(fraction + 0.03f));
                Assert.That(statistics.jitter, Is.LessThan(0.1f));
            }
        }

        // It is too dense by 2 %, and what is under pressure rises, by 0.5 d and what its inertia adds.
        [Test, Category("LongRun")]
        public void A_full_box_whose_lid_is_taken_off_does_not_burst()
        {
            using (TestFluid fluid = Press(DeepWater.On, 24, 0.02f, 60, 30))
            {
                ColliderTests.Use(fluid);
                float fastest = 0f;
                for (int step = 0; step < 10; step++)
                    fastest = math.max(fastest, fluid.Step().MeasureWhole().speedMax);
                TestContext.Out.WriteLine($"fastest {fastest:0.0} m/s, highest {fluid.Read().positions.Max(p => p.y):0.0} d");
                Assert.That(fastest, Is.LessThan(3f));
                Assert.That(fluid.Read().positions.Max(p => p.y), Is.LessThan(27f));
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

        static TestFluid Press(DeepWater deepWater, int layers, float fraction, int closing, int after)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            TestFluid fluid = new TestFluid(new float3(Side, layers + Thickness, Side) * Spacing, Spacing, Side * layers * Side, settings)
                .AddBlock(0f, new float3(Side, layers, Side) * Spacing);
            ColliderMotion piston = ColliderTests.Still(ColliderShape.Box, new float3(2f * Side, Thickness, 2f * Side), At(layers),
                quaternion.identity);
            for (int step = 1; step <= closing + after; step++)
            {
                piston.start = piston.end;
                float surface = layers - math.min(step / (float)closing, 1f) * (layers - layers / (1f + fraction));
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
