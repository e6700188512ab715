using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>How walls hold a fluid of a given viscosity, by the whole solver: flows between plates whose profile is known.</summary>
    [Category("LongRun")]
    public class ViscousWallTests
    {
        const float Spacing = 0.05f, TimeStep = 0.01f;
        const float PathPerStep = 0.02f;           // d of the fastest, so that the block keeps its shape
        const int Thickness = 6, Margin = 3;        // d

        // Starts at rest; the profile after some steps is that of implicit steps of the heat equation. At first the fluid beside the plates
        // shears within 2 layers, which ten across are too few for: 2.5 %.
        [Test]
        public void Fluid_that_falls_between_plates_has_the_profile_of_its_viscosity([Values(1, 2)] int finer,
            [Values(0.06f, 0.6f, 6f)] float strength)
        {
            int gap = 10 * finer, steps = Steps(strength);
            strength *= finer * finer;
            using (TestFluid fluid = Between(gap, 0f, finer, strength))
            {
                float fall = 8f * strength * PathPerStep / (gap * gap);        // g Δt²
                fluid.Input.gravity = new float3(0f, -fall * fluid.Spacing / (TimeStep * TimeStep), 0f);
                fluid.Step(1 + steps);
                AssertProfile(fluid, gap, x => -Sum(m => m % 2 == 0 ? 0.0
                    : 4.0 / (m * Math.PI) * Math.Sin(m * Math.PI * x / gap) * fall * Gained(Left(m, gap, strength), steps)), gap == 10
                    && strength < 0.1f ? 0.03 : 0.02);
            }
        }

        // Layers that have slid past each other by 2 d are not a lattice any more and up to 3 % less viscous, so the plate slides half a
        // spacing at most.
        [Test]
        public void Fluid_beside_a_plate_that_slides_is_dragged_by_its_viscosity([Values(1, 2)] int finer, [Values(0.06f, 0.6f, 6f)] float strength)
        {
            int gap = 10 * finer, steps = Steps(strength);
            strength *= finer * finer;
            using (TestFluid fluid = Between(gap, Margin, finer, strength))
            {
                float path = Math.Min(PathPerStep, 0.5f / steps);
                Slide(fluid, gap, friction: 1f, path, 1 + steps);
                AssertProfile(fluid, gap, x => path
                    * (x / gap + Sum(m => 2.0 / (m * Math.PI) * (m % 2 == 0 ? 1.0 : -1.0) * Math.Sin(m * Math.PI * x / gap)
                    * Math.Pow(Left(m, gap, strength), steps))));
            }
        }

        [Test]
        public void Between_plates_without_friction_fluid_falls_freely()
        {
            using (TestFluid fluid = Between(10, 0f, 1, 0.6f))
            {
                const float Fall = 1e-3f;
                const int Steps = 21;
                fluid.Input.material.wallFriction = 0f;
                fluid.Input.gravity = new float3(0f, -Fall * Spacing / (TimeStep * TimeStep), 0f);
                double[] speeds = Profile(fluid.Step(Steps), 10).Select(layer => layer.speed).ToArray();
                TestContext.Out.WriteLine(
                    $"falls by {-speeds.Average():g4} d a step, {Steps * Fall:g4} freely, layers by {speeds.Max() - speeds.Min():g3}");
                Assert.That(speeds, Is.All.EqualTo(-Steps * Fall).Within(0.005 * Steps * Fall));
            }
        }

        [Test]
        public void A_plate_without_friction_drags_nothing()
        {
            using (TestFluid fluid = Between(10, Margin, 1, 0.6f))
            {
                Slide(fluid, 10, friction: 0f, PathPerStep, 21);
                Assert.That(Profile(fluid, 10).Select(layer => layer.speed), Is.All.EqualTo(0.0).Within(0.01 * PathPerStep));
            }
        }

        [Test]
        public void The_hold_of_a_wall_is_the_kernels_integral_behind_it([Values(0.5, 0.8, 1.2, 1.7)] double distance)
        {
            const double Step = 0.02;
            double sum = 0.0;
            for (double y = distance + 0.5 * Step; y < LatticeKernels.Support; y += Step)
                for (double x = -2.0 + 0.5 * Step; x < 2.0; x += Step)
                    for (double z = -2.0 + 0.5 * Step; z < 2.0; z += Step)
                        sum += LatticeKernels.ViscosityWeight(Math.Sqrt(x * x + y * y + z * z)) * x * x * y;
            double integral = Math.PI / 480.0 * LatticeKernels.ViscosityWallShape(distance);
            Assert.That(sum * Step * Step * Step, Is.EqualTo(integral).Within(0.003 * integral + 1e-4));
        }

        static int Steps(float strength) => strength < 0.1f ? 100 : strength < 1f ? 20 : 4;

        // Fluid on a lattice between x = 0 and a gap, free on all other sides; lengths in d. The box ends 'behind' beyond the gap.
        static TestFluid Between(int gap, float behind, int finer, float strength)
        {
            float spacing = Spacing / finer;
            int length = 4 * gap;
            var fluid = new TestFluid(new float3(gap + behind, length + 2 * Margin, Thickness + 2 * Margin) * spacing, spacing,
                gap * length * Thickness);
            fluid.Input.gravity = 0f;
            fluid.Input.timeStep = TimeStep;
            fluid.Input.material.velocitySmoothing = 0f;
            fluid.Input.material.dynamicViscosity = strength * spacing * spacing / TimeStep * fluid.Input.material.density;
            return fluid.AddBlock(new float3(0f, Margin, Margin) * spacing, new float3(gap, length, Thickness) * spacing, jitter: 0f);
        }

        static void Slide(TestFluid fluid, int gap, float friction, float pathPerStep, int steps)
        {
            float3 size = new float3(Margin, 1000f, 1000f);
            ColliderMotion plate = ColliderTests.Still(ColliderShape.Box, size, new float3(gap + Margin, 0f, 0f), quaternion.identity);
            plate.friction = friction;
            for (int i = 0; i < steps; i++)
            {
                plate.end.position.y = plate.start.position.y + pathPerStep;
                ColliderTests.Use(fluid, plate);
                fluid.Step();
                plate.start = plate.end;
            }
        }

        // Mean velocity along y of each layer halfway along the block, d a step, and where the layer is.
        static (double x, double speed)[] Profile(TestFluid fluid, int gap)
        {
            ParticleState state = fluid.Read();
            float center = 0.5f * state.box.y;
            return (from i in Enumerable.Range(0, state.Count)
                    where math.abs(state.positions[i].y - center) < 0.3f * gap
                    group i by (int)math.floor(state.positions[i].x) into layer
                    orderby layer.Key
                    select (layer.Average(i => (double)state.positions[i].x), layer.Average(i => (double)state.velocities[i].y) * TimeStep))
                    .ToArray();
        }

        static void AssertProfile(TestFluid fluid, int gap, Func<double, double> expected, double tolerance = 0.02)
        {
            (double x, double speed)[] profile = Profile(fluid, gap);
            double largest = profile.Max(layer => Math.Abs(expected(layer.x)));
            double[] errors = profile.Select(layer => (layer.speed - expected(layer.x)) / largest).ToArray();
            TestContext.Out.WriteLine($"largest {largest:g3} d a step; off by " + string.Join(" ", errors.Select(e => $"{100.0 * e:0.0}"))
                + " % of it");
            Assert.That(profile.Length, Is.EqualTo(gap), "layers");
            Assert.That(errors, Is.All.EqualTo(0.0).Within(tolerance));
        }

        // Fraction of a wave of m half lengths across the gap that an implicit step leaves.
        static double Left(int m, int gap, float strength) => 1.0 / (1.0 + strength * Math.Pow(m * Math.PI / gap, 2));

        // Sum over n steps of a velocity gained in each, and in the one before that has no neighbors yet: q + q² + ... qⁿ, + qⁿ.
        static double Gained(double q, int n) => q * (1.0 - Math.Pow(q, n)) / (1.0 - q) + Math.Pow(q, n);

        static double Sum(Func<int, double> term) => Enumerable.Range(1, 400).Sum(term);
    }
}
