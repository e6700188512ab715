using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Drift over a thousand steps. The report's page has a hundred thousand.</summary>
    [Category("LongRun")]
    public class LongRunTests
    {
        const float Spacing = 0.05f;
        const int Steps = 1000;

        [Test]
        public void Still_water_keeps_its_energy_its_volume_and_its_place([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (var fluid = new TestFluid(new float3(5f, 10f, 5f) * Spacing, Spacing, 100, Settings(deepWater))
                .AddBlock(0f, new float3(5f, 4f, 5f) * Spacing))
            {
                FluidStatistics early = fluid.Step(300).MeasureWhole(), late = fluid.Step(Steps).MeasureWhole();
                TestContext.Out.WriteLine($"energy {late.Energy / early.Energy:0.0000}, volume {early.volumeRatio:0.000} then " +
                    $"{late.volumeRatio:0.000}, speed {late.speed:0.0000} m/s");
                Assert.That(late.Energy, Is.EqualTo(early.Energy).Within(2).Percent);
                Assert.That(late.volumeRatio, Is.EqualTo(early.volumeRatio).Within(0.02f));
            }
        }

        [Test]
        public void Water_afloat_without_gravity_stays_where_it_is([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (var fluid = new TestFluid(20f * Spacing, Spacing, 125, Settings(deepWater)).AddBlock(7.5f * Spacing, 5f * Spacing))
            {
                fluid.Input.gravity = 0f;
                FluidStatistics early = fluid.Measure(), late = fluid.Step(Steps).MeasureWhole();
                TestContext.Out.WriteLine($"moved {math.distance(late.centerOfMass, early.centerOfMass) / Spacing:g3} d, speed {late.speed:g3} m/s");
                Assert.That(math.distance(late.centerOfMass, early.centerOfMass), Is.LessThan(0.1f * Spacing));
                Assert.That(late.speed, Is.LessThan(0.01f));
            }
        }

        static SolverSettings Settings(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return settings;
        }
    }
}
