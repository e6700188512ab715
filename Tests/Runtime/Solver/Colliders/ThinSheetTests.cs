using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Water of a few layers where the coarse grid runs, and spray above it.</summary>
    [Category("LongRun")]
    public class ThinSheetTests
    {
        [Test]
        public void A_droplet_above_deep_water_falls_as_gravity_says()
        {
            const float spacing = 0.05f;
            using (TestFluid fluid = new TestFluid(new float3(16f, 32f, 16f) * spacing, spacing, 3000, Settings())
                .AddBlock(0f, new float3(16f, 8f, 16f) * spacing))
            {
                fluid.Step(2);
                // In the second of the layers of coarse cells that displacements continue into.
                fluid.Add(new[] { new float3(8f, 13f, 8f) * spacing });
                const int steps = 12;
                fluid.Step(steps);
                ParticleState state = fluid.Read();
                int droplet = System.Array.IndexOf(state.ids, (uint)(fluid.Added - 1));
                float fallen = 13f - state.positions[droplet].y, expected = 9.81f / 3600f / spacing * steps * (steps + 1) / 2f;
                TestContext.Out.WriteLine($"fallen {fallen:0.00} of {expected:0.00} d");
                Assert.That(fallen, Is.EqualTo(expected).Within(0.2f * expected));      // in its first step it counts as water
            }
        }

        [Test]
        public void Three_layers_of_water_hold_where_the_coarse_cells_are_8_spacings()
        {
            // Gravity moves a particle 0.54 d in a step: passes alone press such water together.
            const float spacing = 0.005f;
            using (TestFluid fluid = Spill(spacing, 12, 24))
            {
                FluidStatistics statistics = fluid.Step(120).MeasureWhole();
                TestContext.Out.WriteLine($"volume {statistics.volumeRatio:0.000}, C+ {100f * statistics.densityError:0.00} %, jitter " +
                    $"{statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError, Is.LessThan(0.01f));
                Assert.That(statistics.volumeRatio, Is.InRange(0.95f, 1.2f));
                Assert.That(statistics.jitter, Is.LessThan(0.06f));
            }
        }

        // A cube that runs out over the floor.
        static TestFluid Spill(float spacing, int side, int floor) =>
            new TestFluid(new float3(floor, 2 * side, floor) * spacing, spacing, side * side * side, Settings()).AddBlock(0f, (float)side * spacing);

        static SolverSettings Settings()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.On;
            settings.iterations = 2;
            return settings;
        }
    }
}
