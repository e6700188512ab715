using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Drops against theory and against what particles can do of it; Research~/solver-study.md has the figures.</summary>
    public class SurfaceTensionTests
    {
        const double MaxStrength = 0.05, MaxStrengthOfTwo = 0.02;       // of Σ; with two iterations
        const double Unit = 3600.0;         // σ/(ρ d³) at which Σ is 1 in 1/60 s, 1/s²

        public enum Wall { Domain, Collider, Reacting, OnFloor }

        // One particle has no multiplier so near a wall, and feels nothing else: each pass of two draws it in by the plane's attraction where it is.
        [Test]
        public void A_wall_or_collider_draws_a_particle_in_as_the_reference_has_it_and_is_drawn_as_much([Values] Wall wall,
            [Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            const float Height = 0.9f;
            double strength = deepWater == DeepWater.On ? MaxStrength : MaxStrengthOfTwo;
            double pass = 2.6 * strength / 2.0 * 1.25, height = Height;     // of 60 degrees
            using (TestFluid fluid = FreeDrop.Make(24f, p => false, 1.0, 2, 60f))
            {
                fluid.Input.settings.deepWater = deepWater;
                float floor = wall == Wall.Domain ? 0f : wall == Wall.OnFloor ? 0.4f : 8f;
                if (wall != Wall.Domain)
                {
                    ColliderMotion plane = ColliderTests.Still(ColliderShape.Plane, 1f, new float3(12f, floor, 12f), quaternion.identity);
                    plane.reacts = wall == Wall.Reacting;
                    ColliderTests.Use(fluid, plane);
                }
                fluid.Add(new[] { new float3(12f, floor + Height, 12f) * FreeDrop.Spacing }).Step();
                for (int i = 0; i < 2; i++)
                    height = Math.Max(height - pass * Reference.Tension.Plane(height), 0.5);
                Assert.That(height, Is.InRange(0.55, Height - 0.02), "the case");
                float3 end = fluid.Read().positions[0].xyz;
                Assert.That(math.distance(end.xz, 12f), Is.LessThan(1e-4f));
                Assert.That(end.y - floor, Is.EqualTo(height).Within(1e-4));
                if (wall == Wall.Reacting)
                    Assert.That(TakeReaction(fluid).y, Is.EqualTo(height - Height).Within(2e-4));
            }
        }

        // Phase 1 is half as heavy as phase 2 and moves twice as far. Two liquids attract each other by what the tension between them leaves of half
        // the sum of theirs: by the smaller one where that is their difference. Each is limited by its own density: the 1 of the light one is 0.02
        // of its own density, and 0.01 of the heavy one's.
        [TestCase(0.005, 0.01, 0.0, 0.005)]
        [TestCase(0.01, 0.004, 0.0, 0.004)]
        [TestCase(0.0, 0.01, 0.0, 0.0)]
        [TestCase(1.0, 0.02, 0.0, 0.01)]
        [TestCase(0.01, 0.01, 0.004, 0.008)]
        [TestCase(0.01, 0.004, 0.01, 0.002)]
        [TestCase(0.01, 0.004, 1.0, 0.0)]
        [TestCase(0.01, 0.004, 0.01, 0.007, 1e-9f)]
        public void Particles_of_two_liquids_attract_each_other_by_what_the_tension_between_them_leaves(double light, double heavy, double between,
            double acting, float diffusion = 0f)
        {
            using (TestFluid fluid = FreeDrop.Make(24f, p => false, 0.0, 2))
            {
                fluid.Input.phases.Set(1, 500f, 0f, FreeDrop.Tension(light));
                fluid.Input.phases.Set(2, 1000f, 0f, FreeDrop.Tension(heavy));
                fluid.Input.phases.SetPair(2, 1, diffusion, FreeDrop.Tension(between));
                fluid.AddPhase(1, new[] { new float3(11.2f, 12f, 12f) });
                fluid.AddPhase(2, new[] { new float3(12.8f, 12f, 12f) });
                fluid.Step();
                double left = 11.2f, right = 12.8f;
                for (int i = 0; i < 2; i++)
                {
                    double pull = 2.6 * acting / 2.0 * Reference.Tension.Pair(right - left);
                    left += 2.0 * pull;
                    right -= pull;
                }
                float[] x = fluid.Read().positions.Select(p => p.x).OrderBy(p => p).ToArray();
                Assert.That(acting == 0.0 || left > 11.2f + 1e-3, "the case");
                Assert.That(x[0], Is.EqualTo(left).Within(2e-5));
                Assert.That(x[1], Is.EqualTo(right).Within(2e-5));
            }
        }

        // The other liquid is twice as heavy, and has none: what acts on this one is its own.
        [Test]
        public void A_wall_draws_each_liquid_by_its_own_contact_angle_and_mass([Values(60f, 120f)] float angle, [Values] bool isCollider)
        {
            const float Height = 0.9f;
            float floor = isCollider ? 8f : 0f;
            using (TestFluid fluid = FreeDrop.Make(24f, p => false, 0.0, 2))
            {
                fluid.Input.phases.Set(1, 1000f, 0f, FreeDrop.Tension(0.02), angle);
                fluid.Input.phases.Set(2, 2000f, 0f, FreeDrop.Tension(0.0));
                if (isCollider)
                    ColliderTests.Use(fluid, Floor(floor));
                fluid.AddPhase(1, new[] { new float3(6f, floor + Height, 12f) });
                fluid.AddPhase(2, new[] { new float3(18f, floor + Height, 12f) });
                fluid.Step();
                double pass = 2.6 * 0.02 / 2.0 * (angle == 60f ? 1.25 : 0.35355339), height = Height;      // of WallFraction
                for (int i = 0; i < 2; i++)
                    height -= pass * Reference.Tension.Plane(height);
                float4[] ends = fluid.Read().positions.OrderBy(p => p.x).ToArray();
                Assert.That(height, Is.LessThan(Height - 0.005), "the case");
                Assert.That(ends[0].y - floor, Is.EqualTo(height).Within(1e-4));
                Assert.That(ends[1].y - floor, Is.EqualTo(Height).Within(2e-6));
            }
        }

        static ColliderMotion Floor(float height)
            => ColliderTests.Still(ColliderShape.Plane, 1f, new float3(12f, height, 12f), quaternion.identity);

        // Nothing attracts like more than all that lies behind the surface.
        [Test]
        public void Colliders_in_one_place_draw_a_particle_in_as_one_of_them_does()
        {
            double End(int planes)
            {
                using (TestFluid fluid = FreeDrop.Make(24f, p => false, 1.0, 2, 60f))
                {
                    ColliderTests.Use(fluid, Enumerable.Repeat(Floor(8f), planes).ToArray());
                    fluid.Add(new[] { new float3(12f, 8.9f, 12f) * FreeDrop.Spacing }).Step();
                    return fluid.Read().positions[0].y;
                }
            }
            double one = End(1);
            Assert.That(one, Is.LessThan(8.88), "it is drawn in");
            Assert.That(End(3), Is.EqualTo(one).Within(1e-5));
        }

        [Test]
        [Category("LongRun")]
        public void A_cube_becomes_a_ball_that_goes_nowhere_and_comes_to_rest([Values(2, 4, 8)] int iterations)
        {
            const double Cube = 6.0 * 64.0, Ball = 309.5;       // d², of 512 d³
            double strength = iterations == 2 ? MaxStrengthOfTwo : MaxStrength;
            using (TestFluid fluid = FreeDrop.Make(24f, p => math.cmax(math.abs(p)) < 4f, strength, iterations))
            {
                double most = 0.0;
                for (int i = 0; i < 12; i++)
                    most = Math.Max(most, FreeDrop.Kinetic(fluid.Step(10).Read()));
                ParticleState state = fluid.Read();
                double drift = math.length(FreeDrop.Drift(state)), roundness = FreeDrop.Roundness(state), left = FreeDrop.Kinetic(state);
                double released = strength * Unit * (Cube - Ball) / state.Count;
                TestContext.Out.WriteLine($"{state.Count} particles: roundness {roundness:0.000}, drift {drift:g2} d/s; of {released:g3} d²/s² " +
                    $"that the surface gives {most:g3} at most move, {left:g3} in the end");
                Assert.That(roundness, Is.GreaterThan(0.85));
                Assert.That(drift, Is.LessThan(5e-5 * Math.Sqrt(2.0 * most)), "momentum");
                Assert.That(most, Is.LessThan(released));
                Assert.That(left, Is.LessThan(0.1 * released));
                Assert.That(fluid.MeasureWhole().jitter, Is.LessThan(1f * FreeDrop.Spacing));
            }
        }

        // The frequency of the second mode is √(8 σ / (ρ R³)) / 2π (Rayleigh 1879). One of 7 d keeps its shape at weaker tensions.
        [TestCase(0.0125, 6)]
        [TestCase(0.05, 6)]
        [TestCase(0.05, 7)]
        [Category("LongRun")]
        public void A_drop_oscillates_about_as_fast_as_Rayleigh_says(double strength, int radius)
        {
            const float Stretch = 1.15f;
            float across = radius / math.sqrt(Stretch), along = radius * Stretch;
            using (TestFluid fluid = FreeDrop.Make(24f, p => math.lengthsq(p / new float3(across, along, across)) < 1f, strength, 4))
            {
                double size = Math.Pow(fluid.Added * 3.0 / (4.0 * Math.PI), 1.0 / 3.0);
                double expected = Math.Sqrt(8.0 * strength * Unit / (size * size * size)) / (2.0 * Math.PI);
                double[] values = Enumerable.Range(0, (int)(1.4 / expected / FreeDrop.TimeStep))
                    .Select(_ => FreeDrop.Ellipticity(fluid.Step().Read())).ToArray();
                (double ratio, double damping, double mean) = FreeDrop.Fit(values, FreeDrop.TimeStep, expected);
                TestContext.Out.WriteLine($"{fluid.Added} particles, {values.Length} steps: {ratio:0.00} of the frequency, damping {damping:0.00}, " +
                    $"at rest {mean:0.000} long");
                Assert.That(ratio, Is.InRange(0.8, 1.3));
                Assert.That(mean, Is.EqualTo(0.0).Within(0.1));
            }
        }

        // Of water between two walls that it meets at 90°, which are mirrors to it: as of an endless jet. A wave grows if it is longer than the
        // jet's circumference (Plateau 1873), and by √(σ/(ρ a³)) times a function of that (Rayleigh 1878): 0.34 at 9 radii. Particles hold a
        // thread of four or five across, so it does not part: see Documentation~/solver.md.
        [Test]
        [Category("LongRun")]
        public void A_wave_on_a_jet_dies_if_it_is_shorter_than_the_circumference_and_grows_if_it_is_longer()
        {
            const double Rate = 0.343;
            double longGrowth = Growth(28, 3f, 90, out int thinnest), shortGrowth = Growth(8, 3f, 90, out _);
            double expected = Math.Cosh(Rate * Math.Sqrt(MaxStrength * Unit / 27.0) * 90.0 * FreeDrop.TimeStep);
            TestContext.Out.WriteLine($"a wave of 9.3 radii grows by {longGrowth:0.00}, in theory {expected:0.00}; its neck has {thinnest} " +
                $"particles in a spacing, one of 2.7 radii by {shortGrowth:0.00}");
            Assert.That(longGrowth, Is.GreaterThan(1.5));
            Assert.That(shortGrowth, Is.LessThan(0.6));
        }

        [TestCase(180f, 165.0, 180.0)]
        [TestCase(120f, 90.0, 150.0)]
        [TestCase(90f, 80.0, 100.0)]
        [TestCase(60f, 40.0, 80.0)]
        [TestCase(0f, 0.0, 35.0)]
        [Category("LongRun")]
        public void A_drop_meets_the_floor_at_about_its_contact_angle(float angle, double least, double most)
        {
            using (TestFluid fluid = FreeDrop.Make(new float3(32f, 24f, 32f), p => math.lengthsq(p) < 49f, MaxStrength, 4, angle, floor: 0f))
                AssertAngle(fluid.Step(120), 0f, least, most);
        }

        // A plane 1 d above the floor, which lies behind it and adds nothing.
        [TestCase(120f, 90.0, 150.0)]
        [TestCase(60f, 40.0, 80.0)]
        [Category("LongRun")]
        public void A_drop_meets_a_collider_at_the_same_angle(float angle, double least, double most)
        {
            using (TestFluid fluid = FreeDrop.Make(new float3(32f, 24f, 32f), p => math.lengthsq(p) < 49f, MaxStrength, 4, angle, floor: 1f))
            {
                ColliderTests.Use(fluid, ColliderTests.Still(ColliderShape.Plane, 1f, new float3(16f, 1f, 16f), quaternion.identity));
                AssertAngle(fluid.Step(120), 1f, least, most);
            }
        }

        [TestCase(40f, true)]
        [TestCase(180f, false)]
        [Category("LongRun")]
        public void A_drop_hangs_from_a_ball_that_it_wets_and_falls_off_another(float angle, bool hangs)
        {
            const float Radius = 8f;
            float3 ball = new float3(16f, 32f, 16f);
            using (TestFluid fluid = FreeDrop.Make(new float3(32f, 48f, 32f), p => math.lengthsq(p - new float3(0f, -4f, 0f)) < 16f, MaxStrength, 4,
                angle))
            {
                ColliderMotion motion = ColliderTests.Still(ColliderShape.Sphere, Radius, ball, quaternion.identity);
                motion.reacts = true;
                ColliderTests.Use(fluid, motion);
                fluid.Input.gravity = new float3(0f, -0.04f, 0f);
                fluid.Step(150);
                fluid.MeasureWhole();
                ParticleState state = fluid.Read();
                double touching = state.positions.Count(p => math.distance(p.xyz, ball) < Radius + 1.5f) / (double)state.Count;
                double3 given = TakeReaction(fluid) / FreeDrop.TimeStep, momentum = FreeDrop.Drift(state) * state.Count;
                double pulled = 0.04 / FreeDrop.Spacing * 150 * FreeDrop.TimeStep * state.Count;
                TestContext.Out.WriteLine($"{state.Count} particles, of which {100.0 * touching:0} % touch; velocity {FreeDrop.Drift(state).y:0.00} " +
                    $"d/s; the ball gave {given.y:0.0}, gravity {-pulled:0.0}, left {momentum.y:0.0}");
                Assert.That(touching, hangs ? Is.GreaterThan(0.2) : (NUnit.Framework.Constraints.Constraint)Is.Zero);
                Assert.That(given.y - pulled, Is.EqualTo(momentum.y).Within(0.01 * pulled));
            }
        }

        // Without tension such a pool is pressed together more, and jitters more once it has lost its lattice.
        [TestCase(4, DeepWater.Off, 3, 0.05)]
        [TestCase(2, DeepWater.Off, 3, 0.02)]
        [TestCase(4, DeepWater.On, 5, 0.05)]
        [TestCase(2, DeepWater.On, 5, 0.05)]
        [TestCase(2, DeepWater.On, 5, 0.0125)]
        [Category("LongRun")]
        public void A_pool_is_no_less_calm_with_it_and_keeps_its_volume(int iterations, DeepWater deepWater, int layers, double strength)
        {
            FluidStatistics without = Pool(0.0), with = Pool(strength);
            TestContext.Out.WriteLine($"jitter {without.jitter / FreeDrop.Spacing:0.00} d/s without, {with.jitter / FreeDrop.Spacing:0.00} with; " +
                $"C+ {100f * without.densityError:0.0}, {100f * with.densityError:0.0} %; volume {without.volumeRatio:0.000}, {with.volumeRatio:0.000}");
            Assert.That(with.jitter, Is.LessThan(1.25f * without.jitter));
            Assert.That(with.densityError, Is.LessThan(0.1f));
            Assert.That(with.volumeRatio, Is.EqualTo(without.volumeRatio).Within(0.03f));

            FluidStatistics Pool(double tension)
            {
                using (TestFluid fluid = FreeDrop.Make(new float3(12f, 16f, 12f), p => p.y < layers, tension, iterations, floor: 0f, jitter: 0.25f))
                {
                    fluid.Input.gravity = new float3(0f, -9.81f, 0f);
                    fluid.Input.settings.deepWater = deepWater;
                    return fluid.Step(100).MeasureWhole();
                }
            }
        }

        [Test]
        [Category("LongRun")]
        public void A_pool_with_it_falls_asleep([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            using (TestFluid fluid = FreeDrop.Make(new float3(16f, 16f, 16f), p => p.y < 4f, 0.02, 4, floor: 0f))
            {
                fluid.Input.gravity = new float3(0f, -9.81f, 0f);
                fluid.Input.settings.deepWater = deepWater;
                fluid.Input.settings.sleepSpeed = 0.02f;
                int steps = 0;
                uint[] states;
                do
                {
                    fluid.Step(20);
                    steps += 20;
                    states = GpuTest.Read<uint>(fluid.Solver.Resting.States, fluid.Solver.Resting.States.count);
                }
                while (steps < 240 && states.Any(state => state != (uint)RegionState.Asleep));
                TestContext.Out.WriteLine($"asleep after {steps} steps");
                Assert.That(states, Is.All.EqualTo((uint)RegionState.Asleep), $"after {steps} steps");
            }
        }

        [Test]
        [Category("LongRun")]
        public void Less_numerical_damping_leaves_a_drop_in_one_piece()
        {
            using (TestFluid fluid = FreeDrop.Make(24f, p => math.cmax(math.abs(p)) < 4f, MaxStrength, 4))
            {
                fluid.Input.settings.numericalDamping = 0.33f;
                ParticleState state = fluid.Step(120).Read();
                TestContext.Out.WriteLine($"roundness {FreeDrop.Roundness(state):0.00}, kinetic {FreeDrop.Kinetic(state):g3} d²/s²");
                Assert.That(FreeDrop.Roundness(state), Is.GreaterThan(0.7));
                Assert.That(FreeDrop.Kinetic(state), Is.LessThan(10.0));
            }
        }

        // Sum of the displacements that the only collider gave to particles, d.
        static double3 TakeReaction(TestFluid fluid)
        {
            ColliderReactions reactions = fluid.Solver.Reactions;
            GpuTest.Run(reactions.RecordTake);
            reactions.Request();
            AsyncGPUReadback.WaitAllRequests();
            reactions.Get(0, out double3 sum, out _);
            return sum;
        }

        // Growth of a wave along a cylinder of water between two walls, and the fewest particles in a spacing along it in the end.
        static double Growth(int length, float radius, int steps, out int thinnest)
        {
            const float Amplitude = 0.12f;
            double wave = 2.0 * Math.PI / length;
            using (TestFluid fluid = FreeDrop.Make(new float3(length, 20f, 20f),
                p => math.length(p.yz) < radius * (1f + Amplitude * math.cos((float)wave * (p.x + 0.5f * length))), MaxStrength, 4, jitter: 0.2f))
            {
                double before = Measure(fluid.Read());
                ParticleState state = fluid.Step(steps).Read();
                thinnest = Enumerable.Range(0, length).Min(x => state.positions.Count(p => (int)p.x == x));
                return Measure(state) / before;
            }

            double Measure(ParticleState state) => state.positions.Average(p => Math.Cos(wave * p.x));
        }

        static void AssertAngle(TestFluid fluid, float floor, double least, double most)
        {
            ParticleState state = fluid.Read();
            double angle = FreeDrop.Angle(state, floor);
            TestContext.Out.WriteLine($"{angle:0} of {fluid.Input.material.contactAngle} degrees, kinetic {FreeDrop.Kinetic(state):g3} d²/s²");
            Assert.That(angle, Is.InRange(least, most));
        }
    }
}
