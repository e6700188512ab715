using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>What the viscosity setting is in Pa s.</summary>
    public class FluidViscosityTests
    {
        const float Spacing = 0.05f;
        const double TimeStep = 1.0 / 60.0;

        [TestCase(16, 0.04)]
        [TestCase(32, 0.01)]
        public void A_shear_wave_decays_as_the_stated_viscosity_says(int wavelength, double tolerance)
        {
            FluidMaterial material = FluidMaterial.Water;
            material.viscosity = 0.5f;
            double waveNumber = 2.0 * Math.PI / (wavelength * Spacing);
            double expected = material.DynamicViscosity(Spacing) / material.density * waveNumber * waveNumber * TimeStep;

            // Five layers around a crest are all that one pass reaches.
            double3[] points = (from x in Enumerable.Range(-2, 5) from y in Enumerable.Range(-2, 5) from z in Enumerable.Range(-2, 5) select new double3(x, y, z)).ToArray();
            double3[] velocities = points.Select(p => new double3(Math.Cos(waveNumber * Spacing * p.y), 0.0, 0.0)).ToArray();
            int crest = Array.FindIndex(points, p => math.all(p == 0.0));
            var reference = new Reference.Velocities(points, velocities, Reference.Neighbors.BruteForce(points, Reference.Kernels.H));
            double decay = 1.0 - reference.Smoothed(crest, material.viscosity).x;
            TestContext.Out.WriteLine($"share lost in a step {decay:G4}, by the viscosity {expected:G4}");
            Assert.That(decay, Is.EqualTo(expected).Within(tolerance * expected));
        }

        [Test]
        public void A_material_like_a_fluid_has_that_fluids_viscosity_at_its_spacing()
        {
            foreach (float spacing in new[] { 0.01f, 0.05f, 0.2f })
            {
                FluidMaterial honey = FluidMaterial.Like(1420f, 10f, spacing);
                Assert.That(honey.DynamicViscosity(spacing), Is.EqualTo(10f).Within(1e-3f));
                Assert.That(honey.DynamicViscosity(2f * spacing), Is.EqualTo(40f).Within(4e-3f), "the setting is thicker at a coarser spacing");
                Assert.That(honey.density, Is.EqualTo(1420f));
            }
            Assert.That(FluidMaterial.Like(1420f, 10f, 0.05f).viscosity, Is.InRange(0.2f, 0.3f));
        }
    }
}
