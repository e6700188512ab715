using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Liquids of several densities, against what theory says of waves and fronts between them. Lengths in d.</summary>
    public class MaterialTableTests
    {
        const float Spacing = 0.01f;
        const float Gravity = 9.81f / Spacing;      // d/s²
        const float StepRate = 60f;

        static SolverSettings Settings
        {
            get
            {
                SolverSettings settings = SolverSettings.Default;
                settings.iterations = 2;
                settings.deepWater = DeepWater.On;
                return settings;
            }
        }

        // Phase 0 is water, phase 1 as much lighter or heavier as the ratio says.
        static TestFluid Fluid(float3 box, int3 counts, float density, Func<float3, bool> isOther, SolverSettings settings,
            float stepRate = StepRate, float spacing = Spacing)
        {
            var fluid = new TestFluid(box * spacing, spacing, counts.x * counts.y * counts.z, settings);
            fluid.Input.timeStep = 1f / stepRate;
            fluid.Input.phases.Set(1, density, 0f);
            ParticleState block = ParticleState.Lattice(0f, 0.5f, counts, 0.02f);
            foreach (IGrouping<bool, float3> group in block.positions.Select(p => p.xyz).GroupBy(isOther).OrderBy(group => group.Key))
                fluid.AddPhase(group.Key ? 1 : 0, group);
            return fluid;
        }

        static (float3 position, float3 velocity, bool isOther)[] Particles(TestFluid fluid)
        {
            ParticleState state = fluid.Read();
            uint[] phases = fluid.Phases();
            return Enumerable.Range(0, state.Count).Select(i => (state.positions[i].xyz, state.velocities[i].xyz, phases[i] == 1)).ToArray();
        }

        // Amplitude of the interface, from the number of water's particles along x: those of a wave η = a cos(2π x / L) above it.
        static double Amplitude(TestFluid fluid, float length, float depth)
            => -2.0 * Particles(fluid).Where(p => !p.isOther).Sum(p => Math.Cos(2.0 * Math.PI * p.position.x / length)) / (length * depth);

        // Rayleigh (1883), Taylor (1950): a wave of a heavy liquid on a light one grows as cosh(σ t), σ² = A g k tanh(k h).
        [TestCase(1.2f, StepRate, Spacing)]
        [TestCase(3f, StepRate, Spacing)]
        [TestCase(10f, StepRate, Spacing)]
        [TestCase(3f, 240f, Spacing)]
        [TestCase(3f, StepRate, 0.5f * Spacing)]
        [Category("LongRun")]
        public void Heavy_water_on_light_sinks_as_fast_as_theory_says(float ratio, float stepRate, float spacing)
        {
            const float length = 48f, depth = 4f, height = 48f, amplitude = 2f;
            bool IsLight(float3 p) => p.y < 0.5f * height + amplitude * math.cos(2f * math.PI * p.x / length);
            using (TestFluid fluid = Fluid(new float3(length, height + 8f, depth), new int3((int)length, (int)height, (int)depth), 1000f / ratio,
                IsLight, Settings, stepRate, spacing))
            {
                double wave = 2.0 * Math.PI / length;
                double expected = Math.Sqrt((ratio - 1.0) / (ratio + 1.0) * 9.81 / spacing * wave * Math.Tanh(wave * 0.5 * height));
                double start = Amplitude(fluid, length, depth);
                var times = new List<double>();
                var exponents = new List<double>();     // σ t of cosh(σ t)
                for (int step = 1; step <= stepRate; step++)
                {
                    double grown = Amplitude(fluid.Step(), length, depth) / start;
                    if (grown > 2.5)
                        break;
                    if (grown > 1.2)
                    {
                        times.Add(step / stepRate);
                        exponents.Add(Math.Log(grown + Math.Sqrt(grown * grown - 1.0)));
                    }
                }
                Assert.That(times.Count, Is.GreaterThan(1), "the wave does not grow");
                double rate = Slope(times, exponents);
                TestContext.Out.WriteLine($"ratio {ratio}, {stepRate} Hz, d {spacing}: growth {rate:0.00}/s, theory {expected:0.00}/s, " +
                    $"{rate / expected:0.00} of it");
                Assert.That(rate / expected, Is.InRange(0.75, 1.1));
            }
        }

        static double Slope(List<double> x, List<double> y)
        {
            double meanX = x.Average(), meanY = y.Average();
            return x.Zip(y, (a, b) => (a - meanX) * (b - meanY)).Sum() / x.Sum(a => (a - meanX) * (a - meanX));
        }

        // In units of √(g (1 - 1/r) h). Benjamin (1968): where nothing is lost the light liquid runs along the top with a half, and the heavy one
        // along the floor, against a lighter one, with half of √r (Lowe, Rottman and Linden 2005). Real fronts are slower. Below a free surface,
        // which yields, the light one may be some percent faster than below a lid.
        [TestCase(1.2f)]
        [TestCase(2f)]
        [Category("LongRun")]
        public void A_lock_opens_with_the_speed_of_a_gravity_current(float ratio)
        {
            const float length = 64f, depth = 4f, height = 16f;
            using (TestFluid fluid = Fluid(new float3(length, height + 8f, depth), new int3((int)length, (int)height, (int)depth), 1000f / ratio,
                p => p.x > 0.5f * length, Settings))
            {
                var heavy = new Front();
                var light = new Front();
                for (int step = 1; step <= 120 && !(heavy.HasArrived && light.HasArrived); step++)
                {
                    (float3 position, float3 velocity, bool isOther)[] particles = Particles(fluid.Step());
                    heavy.Add(step / StepRate, particles.Where(p => !p.isOther && p.position.y < 3f).Select(p => p.position.x / length));
                    light.Add(step / StepRate, particles.Where(p => p.isOther && p.position.y > height - 3f).Select(p => 1f - p.position.x / length));
                }
                double unit = Math.Sqrt(Gravity * (1.0 - 1.0 / ratio) * height) / length;
                double ofHeavy = heavy.Speed / unit, ofLight = light.Speed / unit, most = 0.5 * Math.Sqrt(ratio);
                TestContext.Out.WriteLine($"ratio {ratio}: heavy front {ofHeavy:0.00} of {most:0.00} at most, light front {ofLight:0.00} of 0.5");
                Assert.That(ofHeavy, Is.InRange(0.35, most));
                Assert.That(ofLight, Is.InRange(0.35, 0.53));
            }
        }

        // The front of a current, from 0.6 to 0.85 of the lock's length; 99 of 100 particles are behind it.
        sealed class Front
        {
            readonly List<double> times = new List<double>(), positions = new List<double>();

            public bool HasArrived { get; private set; }

            public double Speed
            {
                get
                {
                    Assert.That(times.Count, Is.GreaterThan(3), "the front does not run");
                    return Slope(times, positions);
                }
            }

            public void Add(double time, IEnumerable<float> particles)
            {
                float[] sorted = particles.OrderBy(x => x).ToArray();
                float front = sorted[(int)(0.99f * (sorted.Length - 1))];
                HasArrived |= front > 0.85f;
                if (HasArrived || front < 0.6f)
                    return;
                times.Add(time);
                positions.Add(front);
            }
        }

        [TestCase(2f, 0.005, StepRate, Spacing)]
        [TestCase(10f, 0.005, StepRate, Spacing)]
        [TestCase(10f, 0.005, 240f, Spacing)]
        [TestCase(10f, 0.005, StepRate, 0.5f * Spacing)]
        [TestCase(100f, 0.01, StepRate, Spacing)]
        [TestCase(1000f, 0.015, StepRate, Spacing)]
        [Category("LongRun")]
        public void Layers_at_rest_stay_so_and_apart(float ratio, double maxSpeed, float stepRate, float spacing)
        {
            const int side = 16, height = 16;
            using (TestFluid fluid = Fluid(new float3(side, 24f, side), new int3(side, height, side), 1000f / ratio,
                p => p.y > 0.5f * height, Settings, stepRate, spacing))
            {
                (float3 position, float3 velocity, bool isOther)[] particles = Particles(fluid.Step((int)(3f * stepRate)));
                double speed = Math.Sqrt(particles.Average(p => math.lengthsq(p.velocity)));
                double limit = maxSpeed * Math.Sqrt(9.81 / spacing * height);
                double wrong = particles.Count(p => p.isOther != p.position.y > 0.5f * height && math.abs(p.position.y - 0.5f * height) > 0.5f)
                    / (double)particles.Length;
                FluidStatistics statistics = fluid.Measure();
                TestContext.Out.WriteLine($"ratio {ratio}, {stepRate} Hz, d {spacing}: {speed:0.00} d/s, at most {limit:0.00}; " +
                    $"{100.0 * wrong:0.00} % on the wrong side; " +
                    $"C+ {100f * statistics.densityError:0.00} %, volume {statistics.volumeRatio:0.000}");
                Assert.That(speed, Is.LessThan(limit));
                Assert.That(wrong, Is.LessThan(0.01));
                Assert.That(statistics.densityError, Is.LessThan(0.01f));
            }
        }

        [TestCase(2f, 3f)]
        [TestCase(10f, 3f)]
        [TestCase(10f, 2f)]
        [TestCase(1000f, 3f)]
        [Category("LongRun")]
        public void A_bubble_rises_to_the_top(float ratio, float radius)
        {
            const int side = 16, height = 24;
            float3 center = new float3(0.5f * side, radius + 2f, 0.5f * side);
            using (TestFluid fluid = Fluid(new float3(side, 32f, side), new int3(side, height, side), 1000f / ratio,
                p => math.distance(p, center) < radius, Settings))
            {
                fluid.Step(72);
                double mean = Particles(fluid).Where(p => p.isOther).Average(p => p.position.y);
                TestContext.Out.WriteLine($"ratio {ratio}, radius {radius}: {mean:0.0} d after 1.2 s, from {center.y} of {height}");
                Assert.That(mean, Is.GreaterThan(0.75 * height));
            }
        }

        // Relative to the fluid of density ρ', a sphere of density ρ accelerates by (ρ' − ρ) / (ρ + ρ' / 2) times what acts on that: it takes half
        // of the fluid that it displaces along (Lamb 1932, section 92). A lone particle has 20 to 60 neighbors, and counts itself for the sphere.
        [TestCase(100f, 1.5f)]
        [TestCase(4000f, -2f / 3f)]
        public void A_lone_particle_of_another_density_slips_as_a_sphere_and_layers_do_not(float density, float expected)
        {
            const int side = 12;
            using (TestFluid fluid = Fluid(side, side, density, p => math.all(math.abs(p - 5.5f) < 0.1f), Settings))
            {
                (float slip, bool isOther)[] slips = Slips(fluid.Step());
                Assert.That(slips.Count(p => p.isOther), Is.EqualTo(1));
                float lone = slips.Single(p => p.isOther).slip - 1f;
                TestContext.Out.WriteLine($"{lone:0.000} more than the fluid, of {expected:0.000}");
                Assert.That(lone / expected, Is.InRange(0.9f, 0.97f));
                Assert.That(slips.Where(p => !p.isOther).Select(p => p.slip), Is.All.EqualTo(1f), "its neighbors");
            }
            using (TestFluid fluid = Fluid(side, side, density, p => p.y > 0.5f * side, Settings))
                Assert.That(Slips(fluid.Step()).Select(p => p.slip), Is.All.EqualTo(1f), "two layers");
        }

        static (float slip, bool isOther)[] Slips(TestFluid fluid)
        {
            GraphicsBuffer buffer = SolverBuffers.Of(fluid.Solver)["Rill.Slips"];
            return GpuTest.Read<float>(buffer, fluid.Alive).Zip(Particles(fluid), (slip, p) => (slip, p.isOther)).ToArray();
        }

        [Test]
        public void Passes_keep_the_momentum_of_heavy_and_light_particles()
        {
            SolverSettings settings = Settings;
            settings.deepWater = DeepWater.Off;
            using (TestFluid fluid = Fluid(40f, 8, 100f, p => p.x > 4f, settings))
            {
                fluid.Input.gravity = 0f;
                fluid.Solver.Shift(16f);
                (double3 sum, double parts) = Momentum(fluid);
                Assert.That(parts, Is.Zero);
                (sum, parts) = Momentum(fluid.Step());
                TestContext.Out.WriteLine($"momentum {math.length(sum) / parts:g3} of its parts");
                Assert.That(parts, Is.GreaterThan(1.0));
                Assert.That(math.length(sum) / parts, Is.LessThan(1e-4));
            }
        }

        static (double3 sum, double parts) Momentum(TestFluid fluid)
        {
            double3 sum = 0.0;
            double parts = 0.0;
            foreach ((float3 _, float3 velocity, bool isOther) in Particles(fluid))
            {
                double3 own = (isOther ? 0.1 : 1.0) * (double3)velocity;
                sum += own;
                parts += math.length(own);
            }
            return (sum, parts);
        }

        [Test]
        public void Phases_of_one_density_are_bit_for_bit_as_without_phases()
        {
            ParticleState Run(float density)
            {
                using (TestFluid fluid = Fluid(new float3(12f, 20f, 12f), 12, density, p => p.y > 6f, Settings))
                    return fluid.Step(20).Read();
            }
            TestFluid.AssertSame(Run(1000f), Run(0f));      // 0: phase 1 has no material of its own
        }
    }
}
