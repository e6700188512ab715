using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Value of the viscosity setting in Pa s.</summary>
    public class VelocitySmoothingTests
    {
        const float Spacing = 0.05f;
        const double TimeStep = 1.0 / 60.0;

        [TestCase(16, 0.04)]
        [TestCase(32, 0.01)]
        public void A_shear_wave_decays_as_the_stated_viscosity_says(int wavelength, double tolerance)
        {
            FluidMaterial material = FluidMaterial.Water;
            material.velocitySmoothing = 0.5f;
            double waveNumber = 2.0 * Math.PI / (wavelength * Spacing);
            double expected = material.SmoothingViscosity(Spacing) / material.density * waveNumber * waveNumber * TimeStep;

            // Five layers around a crest are all that one pass reaches.
            double3[] points = (from x in Enumerable.Range(-2, 5)
                                from y in Enumerable.Range(-2, 5)
                                from z in Enumerable.Range(-2,
                5)
                                select new double3(x, y, z)).ToArray();
            double3[] velocities = points.Select(p => new double3(Math.Cos(waveNumber * Spacing * p.y), 0.0, 0.0)).ToArray();
            int crest = Array.FindIndex(points, p => math.all(p == 0.0));
            var reference = new Reference.Velocities(points, velocities, Reference.Neighbors.BruteForce(points, Reference.Kernels.H));
            double decay = 1.0 - reference.Smoothed(crest, material.velocitySmoothing).x;
            TestContext.Out.WriteLine($"fraction lost in a step {decay:G4}, by the viscosity {expected:G4}");
            Assert.That(decay, Is.EqualTo(expected).Within(tolerance * expected));
        }

        [Test]
        public void Smoothing_is_a_thicker_fluid_at_a_coarser_spacing()
        {
            FluidMaterial water = FluidMaterial.Water;
            Assert.That(water.SmoothingViscosity(0.05f), Is.InRange(0.2f, 0.4f));
            Assert.That(water.SmoothingViscosity(0.1f), Is.EqualTo(4f * water.SmoothingViscosity(0.05f)).Within(1e-4f));
        }

        [Test]
        public void A_viscous_material_is_water_with_its_viscosity_in_place_of_smoothing()
        {
            FluidMaterial honey = FluidMaterial.Viscous(1420f, 10f), expected = FluidMaterial.Water;
            expected.density = 1420f;
            Assert.That(FluidMaterial.Viscous(1420f, 0f), Is.EqualTo(expected));
            expected.dynamicViscosity = 10f;
            expected.velocitySmoothing = 0f;
            Assert.That(honey, Is.EqualTo(expected));
        }
    }
}
