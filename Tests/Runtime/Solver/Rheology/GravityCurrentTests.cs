using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>A viscous fluid that spreads on a floor by its weight (Huppert, J. Fluid Mech. 121, 1982), in a narrow tank whose sides
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
            var settings = SolverSettings.Default;
            settings.deepWater = DeepWater.On;
            settings.substeps = 4;
            using (var fluid = new TestFluid(new float3(80f, Floor + 20f, Thickness) * Spacing, Spacing, Side * Side * Thickness, settings))
            {
                fluid.Input.material = FluidMaterial.Viscous(1000f, 1000f * Viscosity);
                fluid.Input.material.wallFriction = 0f;
                ColliderMotion floor = ColliderTests.Still(ColliderShape.Box, new float3(1000f, Floor, 1000f), 0f, quaternion.identity);
                floor.friction = 1f;
                ColliderTests.Use(fluid, floor);
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

        // Distance from the wall where it started, d.
        static double Mean(TestFluid fluid) => fluid.Read().positions.Average(p => (double)p.x);
    }
}
