using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Gravity and steps far from what a scene has.</summary>
    public class StrongForceTests
    {
        const float Spacing = 0.05f;

        [Test, Category("LongRun")]
        public void A_hundred_times_gravity_leaves_the_water_inside_and_gives_it_no_energy([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Dam(deepWater))
            {
                fluid.Input.gravity = new float3(0f, -981f, 0f);
                fluid.Input.settings.substeps = SolverSettings.Default.StableSubsteps(981f / 3600f / Spacing);
                AssertGainsNothing(fluid, parts: 10, steps: 6);
            }
        }

        [Test]
        public void Steps_of_a_fifteenth_of_a_second_leave_the_water_inside_and_give_it_no_energy(
            [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Dam(deepWater))
            {
                fluid.Input.timeStep = 1f / 15f;
                fluid.Input.settings.substeps = SolverSettings.Default.StableSubsteps(9.81f / 225f / Spacing);
                AssertGainsNothing(fluid, parts: 10, steps: 6);
                FluidStatistics end = fluid.Measure();
                Assert.That(end.volumeRatio, Is.InRange(0.85f, 1.15f));
                Assert.That(end.densityError, Is.LessThan(0.05f));
            }
        }

        [Test, Category("LongRun")]
        public void Gravity_that_flips_each_second_keeps_throwing_the_water_about_and_no_more(
            [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            const float height = 12f * Spacing;
            using (var fluid = new TestFluid(new float3(8f * Spacing, height, 8f * Spacing), Spacing, 400, Settings(deepWater))
                .AddBlock(0f, new float3(8f, 6f, 8f) * Spacing))
            {
                for (int second = 0; second < 4; second++)
                {
                    for (int part = 0; part < 4; part++)
                        Assert.That(fluid.Step(15).MeasureWhole().speedMax, Is.LessThan(1.5f * math.sqrt(2f * 9.81f * height) + 1f),
                            $"second {second}");
                    fluid.Input.gravity = -fluid.Input.gravity;
                }
                Assert.That(fluid.Measure().densityError, Is.LessThan(0.05f));
            }
        }

        static void AssertGainsNothing(TestFluid fluid, int parts, int steps)
        {
            float start = fluid.Measure().Energy;
            for (int part = 0; part < parts; part++)
                Assert.That(fluid.Step(steps).MeasureWhole().Energy, Is.LessThan(1.005f * start), $"part {part}");
        }

        static TestFluid Dam(DeepWater deepWater) => new TestFluid(new float3(16f, 16f, 8f) * Spacing, Spacing, 512, Settings(deepWater))
            .AddBlock(0f, 8f * Spacing);

        static SolverSettings Settings(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return settings;
        }
    }
}
