using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>A viscous fluid that spreads on a floor without slip by its weight (Huppert, J. Fluid Mech. 121, 1982). The sides of the tank
    /// slip.</summary>
    [Category("LongRun")]
    public class GravityCurrentTests
    {
        const float Spacing = 0.01f, Viscosity = 0.02f, Gravity = 9.81f;      // m, m²/s, m/s²
        const int Side = 16, Thickness = 6, Floor = 3;                        // d
        const int First = 80, Last = 160;                                     // steps

        // A fixed volume q spreads as x_N = 1.411 (g q³ t / 3 ν)^(1/5), h ~ (1 - x²/x_N²)^(1/3), so that its mean is 0.446 x_N.
        [Test]
        public void A_fixed_volume_spreads_by_the_fifth_root_of_time()
        {
            var box = new float3(80f, Floor + 20f, Thickness);
            using (TestFluid fluid = OnAFloor(box, Side * Side * Thickness))
            {
                fluid.AddBlock(new float3(0f, Floor, 0f) * Spacing, new float3(Side, Side, Thickness) * Spacing);

                double first = Mean(fluid.Step(First)), last = Mean(fluid.Step(Last - First));
                double exponent = Math.Log(last / first) / Math.Log((double)Last / First);
                double theory = 0.4457 * 1.411
                    * Math.Pow(Gravity * Math.Pow(Side * Spacing, 6) * Last * fluid.Input.timeStep / (3.0 * Viscosity), 0.2) / Spacing;
                TestContext.Out.WriteLine($"mean at {first:0.00} and {last:0.00} d, {theory:0.00} by theory; as t^{exponent:0.000}");
                Assert.That(exponent, Is.EqualTo(0.2).Within(0.01));
                Assert.That(last, Is.EqualTo(theory).Within(0.04 * theory));
            }
        }

        // A heap of volume V spreads as r_N = 0.894 (g V³ t / 3 ν)^(1/8), h ~ (1 - r²/r_N²)^(1/3), so that its mean is 0.612 r_N. A quarter of
        // it, between two sides.
        [Test]
        public void A_heap_spreads_by_the_eighth_root_of_time()
        {
            const int radius = 16, height = 20, last = 240;
            var box = new float3(52f, Floor + height + 8f, 52f);
            using (TestFluid fluid = OnAFloor(box, radius * radius * height))
            {
                var positions = new List<float3>();
                for (int i = 0; i < radius * radius * height; i++)
                {
                    float3 position = new float3(i % radius, i / (radius * radius), i / radius % radius) + 0.5f;
                    if (math.length(position.xz) < radius)
                        positions.Add((position + new float3(0f, Floor, 0f)) * Spacing);
                }
                fluid.Add(positions.ToArray());

                double before = MeanRadius(fluid.Step(First)), after = MeanRadius(fluid.Step(last - First));
                double exponent = Math.Log(after / before) / Math.Log((double)last / First);
                double volume = 4 * positions.Count * Math.Pow(Spacing, 3);
                double theory = 0.6119 * 0.894
                    * Math.Pow(Gravity * Math.Pow(volume, 3) * last * fluid.Input.timeStep / (3.0 * Viscosity), 0.125) / Spacing;
                TestContext.Out.WriteLine($"{positions.Count} particles, mean radius {before:0.00} and {after:0.00} d, {theory:0.00} by theory; " +
                    $"as t^{exponent:0.000}");
                Assert.That(exponent, Is.EqualTo(0.125).Within(0.01));
                Assert.That(after, Is.EqualTo(theory).Within(0.05 * theory));
            }

            double MeanRadius(TestFluid fluid) => fluid.Read().positions.Average(p => (double)math.length(p.xz));
        }

        // Box in d.
        static TestFluid OnAFloor(float3 box, int capacity)
        {
            var settings = SolverSettings.Default;
            settings.deepWater = DeepWater.On;
            settings.substeps = 4;
            var fluid = new TestFluid(box * Spacing, Spacing, capacity, settings);
            fluid.Input.material = FluidMaterial.Viscous(1000f, 1000f * Viscosity);
            fluid.Input.material.wallFriction = 0f;
            ColliderMotion floor = ColliderTests.Still(ColliderShape.Box, new float3(1000f, Floor, 1000f), 0f, quaternion.identity);
            floor.friction = 1f;
            ColliderTests.Use(fluid, floor);
            return fluid;
        }

        // Distance from the wall where it started, d.
        static double Mean(TestFluid fluid) => fluid.Read().positions.Average(p => (double)p.x);
    }
}
