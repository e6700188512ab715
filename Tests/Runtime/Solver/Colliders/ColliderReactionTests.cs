using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Reactions on colliders: as much as they do to the fluid, and what Archimedes says.</summary>
    [Category("LongRun")]
    public class ColliderReactionTests
    {
        const float Spacing = 0.05f;

        // A block of 6 d times the scale meets a ball or a box about as large. The coarse grid moves spray too, without an opposite, and of
        // a small block most is spray: that is what the looser bars are for. 1.3 d off the grid's cells it is worst.
        [TestCase(DeepWater.Off, 1, 0.01f, ColliderShape.Sphere, ColliderShape.Box)]
        [TestCase(DeepWater.On, 2, 0.1f, ColliderShape.Sphere, ColliderShape.Box)]
        [TestCase(DeepWater.On, 4, 0.05f, ColliderShape.Sphere, Category = "GpuOnly")]
        public void An_impact_gives_a_collider_the_momentum_that_the_fluid_loses(DeepWater deepWater, int scale, float error,
            params ColliderShape[] shapes)
        {
            foreach (ColliderShape shape in shapes)
                using (TestFluid fluid = Box(deepWater, 40f * scale, 216 * scale * scale * scale))
                {
                    fluid.Input.gravity = 0f;
                    fluid.AddBlock((1.3f + new float3(8f, 17f, 17f) * scale) * Spacing, 6f * scale * Spacing, new float3(2.5f, 0f, 0f));
                    Use(fluid, ColliderTests.Still(shape, 4f * scale, 1.3f + new float3(21f, 21f, 20f) * scale, quaternion.Euler(0.2f, 0.3f, 0.1f)));
                    float3 before = fluid.Measure().momentum;
                    float3 impulse = 0f;
                    for (int i = 0; i < 18 * scale; i++)     // then the fastest reach the walls
                    {
                        fluid.Step();
                        impulse += Take(fluid, out _) * fluid.Solver.Reactions.Duration;
                    }
                    float3 lost = before - fluid.MeasureWhole().momentum;
                    Assert.That(math.length(lost), Is.GreaterThan(0.2f * math.length(before)), "an impact worth the name");
                    TestContext.WriteLine($"{shape}: {100 * math.distance(impulse, lost) / math.length(lost):0.0} % of the impulse is " +
                        $"missing, {100 * math.distance(impulse, lost) / math.length(before):0.0} % of the block's momentum");
                    Assert.That(math.distance(impulse, lost), Is.LessThan(error * math.length(lost)), $"{shape}");
                }
        }

        [TestCase(ColliderShape.Sphere)]
        [TestCase(ColliderShape.Box)]
        public void Still_water_lifts_a_collider_by_the_weight_of_the_water_in_its_place(ColliderShape shape)
        {
            float size = shape == ColliderShape.Sphere ? 6.3f : 5f;
            using (TestFluid fluid = Box(DeepWater.On))
            {
                ColliderMotion obstacle = ColliderTests.Still(shape, size, new float3(11f, 10f, 13f), quaternion.Euler(0.3f, 0.2f, 0.1f));
                fluid.AddAround(obstacle, 0f, new float3(24f, 22f, 24f));
                Use(fluid, obstacle);
                fluid.Step(40);
                Take(fluid, out _);
                fluid.Step(40);
                float3 force = Take(fluid, out float3 torque);
                float volume = (shape == ColliderShape.Sphere ? 4f / 3f * math.PI : 8f) * math.pow(size * Spacing, 3);
                float weight = fluid.Input.material.density * 9.81f * volume;
                TestContext.Out.WriteLine(
                    $"{force.y / weight:0.000} of the displaced water's weight, {math.length(force.xz) / weight:0.0000} sideways");
                Assert.That(force.y, Is.EqualTo(weight).Within(0.05f * weight));
                Assert.That(math.length(force.xz), Is.LessThan(0.05f * weight));
                Assert.That(math.length(torque), Is.LessThan(0.05f * weight * size * Spacing));
            }
        }

        // The cells beside it are in part empty: what is above the surface weighs nothing.
        [Test]
        public void Still_water_lifts_what_stands_out_of_it_by_the_water_below_its_surface()
        {
            const float half = 5f, depth = 15f;
            using (TestFluid fluid = Box(DeepWater.On, 20f, 6000))
            {
                ColliderMotion solid = ColliderTests.Still(ColliderShape.Box, half, new float3(10f, 15.5f, 10f), quaternion.identity);
                fluid.AddAround(solid, 0f, new float3(20f, depth, 20f));
                Use(fluid, solid);
                fluid.Step(30);
                Take(fluid, out _);
                float3 force = Take(fluid.Step(30), out _);
                float immersed = depth - (15.5f - half);      // d
                float weight = fluid.Input.material.density * 9.81f * 4f * half * half * immersed * math.pow(Spacing, 3);
                TestContext.Out.WriteLine($"{force.y / weight:0.000} of the displaced water's weight");
                Assert.That(force.y, Is.EqualTo(weight).Within(0.33f / immersed * weight), "a third of a spacing of its draft");
                Assert.That(math.length(force.xz), Is.LessThan(0.05f * weight));
            }
        }

        // Two boxes under water and a ball in the air, each by its own number.
        [Test]
        public void Of_several_colliders_each_is_lifted_by_the_water_in_its_own_place()
        {
            var box = new float3(25f, 26f, 12f);
            ColliderMotion[] solids =
            {
                ColliderTests.Still(ColliderShape.Sphere, 1f, new float3(22f, 24f, 9f), quaternion.identity),
                ColliderTests.Still(ColliderShape.Box, new float3(3.4f, 3f, 3f), new float3(7f, 8.3f, 6f), quaternion.identity),
                ColliderTests.Still(ColliderShape.Box, new float3(2.5f, 4f, 2.5f), new float3(19f, 9f, 6f), quaternion.identity),
            };
            SolverSettings settings = SolverSettings.Default;
            settings.iterations = 2;
            settings.deepWater = DeepWater.On;
            using (var fluid = new TestFluid(box * Spacing, Spacing, 7000, settings))
            {
                fluid.Add(ParticleState.Lattice(0f, 0.5f, new int3(25, 22, 12), 0.02f).positions.Select(p => p.xyz)
                    .Where(p => solids.All(solid => Reference.Shapes.Distance(solid, p) >= 0.5)).Select(p => p * Spacing).ToArray());
                for (int i = 0; i < solids.Length; i++)
                    solids[i].reacts = true;
                ColliderTests.Use(fluid, solids);
                fluid.Step(15);
                Take(fluid, out _);
                fluid.Step(15);
                Take(fluid, out _);
                for (int i = 0; i < solids.Length; i++)
                {
                    float3 force = ForceOn(fluid, i, out _), size = 2f * Spacing * solids[i].size;
                    float weight = i == 0 ? 0f : fluid.Input.material.density * 9.81f * size.x * size.y * size.z;
                    TestContext.Out.WriteLine($"collider {i}: {force.y:0.0} N of {weight:0.0} N, {math.length(force.xz):0.0} N sideways");
                    Assert.That(force.y, Is.EqualTo(weight).Within(0.15f * weight), $"collider {i}");
                    Assert.That(math.length(force.xz), Is.LessThanOrEqualTo(0.1f * weight), $"collider {i}");
                }
            }
        }

        // In endless water half of the displaced water (Lamb 1932, section 92); the walls of a small tank add to it.
        [Test]
        public void A_ball_that_is_jerked_in_deep_water_feels_the_added_mass_of_the_water()
        {
            const float radius = 5f, speed = 1.5f;
            using (TestFluid fluid = Box(DeepWater.On))
            {
                ColliderMotion ball = ColliderTests.Still(ColliderShape.Sphere, radius, new float3(11.5f, 10f, 12f), quaternion.identity);
                fluid.AddAround(ball, 0f, new float3(24f, 20f, 24f));
                Use(fluid, ball);
                fluid.Step(40);
                float still = Take(fluid, out _).x;
                ball.end.position.x += speed * fluid.Input.timeStep / Spacing;
                Use(fluid, ball);
                fluid.Step();
                float force = Take(fluid, out _).x;
                ball.start = ball.end;
                Use(fluid, ball);
                float water = fluid.Input.material.density * 4f / 3f * math.PI * math.pow(radius * Spacing, 3);
                float fraction = (still - force) * fluid.Input.timeStep / (water * speed);
                TestContext.Out.WriteLine($"{fraction:0.00} of the displaced water");
                Assert.That(fraction, Is.InRange(0.45f, 0.75f));
            }
        }

        // Ideal water resists in the first step alone. What it takes after that, the solver's own friction takes: see
        // Research~/floating-study.md.
        [TestCase(DeepWater.Off, 4f, 5.5f)]
        [TestCase(DeepWater.On, 4f, 3.3f)]
        [TestCase(DeepWater.On, 6f, 2.5f, Category = "GpuOnly")]
        public void Water_soon_moves_along_with_a_ball_that_is_set_moving(DeepWater deepWater, float radius, float most)
        {
            const float speed = 0.3f;
            const int steps = 24;
            using (TestFluid fluid = Box(deepWater))
            {
                fluid.Input.settings.iterations = 4;
                ColliderMotion ball = ColliderTests.Still(ColliderShape.Sphere, radius, new float3(10f, 9f, 12f), quaternion.identity);
                fluid.AddAround(ball, 0f, new float3(24f, 20f, 24f));
                Use(fluid, ball);
                fluid.Step(40);
                Take(fluid, out _);
                float still = Take(fluid.Step(10), out _).x;
                float momentum = fluid.Input.material.density * 4f / 3f * math.PI * math.pow(radius * Spacing, 3) * speed;
                var impulses = new float[steps];
                for (int i = 0; i < steps; i++)
                {
                    ball.start = ball.end;
                    ball.end.position.x += speed * fluid.Input.timeStep / Spacing;
                    Use(fluid, ball);
                    impulses[i] = (still - Take(fluid.Step(), out _).x) * fluid.Input.timeStep / momentum;
                }
                TestContext.Out.WriteLine($"impulses {string.Join(" ", impulses.Select(i => i.ToString("0.00")))}, in all " +
                    $"{impulses.Sum():0.0} of the displaced water's mass times the velocity");
                Assert.That(impulses[0], Is.InRange(0.4f, 0.9f));
                Assert.That(impulses.Sum(), Is.InRange(0.5f, most));
            }
        }

        static TestFluid Box(DeepWater deepWater, float side = 24f, int capacity = 13000)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            settings.iterations = 2;
            return new TestFluid(side * Spacing, Spacing, capacity, settings);
        }

        static void Use(TestFluid fluid, ColliderMotion motion)
        {
            motion.reacts = true;
            ColliderTests.Use(fluid, motion);
        }

        // Mean force on the only collider since the last call, N, and torque, N m.
        static float3 Take(TestFluid fluid, out float3 torque)
        {
            ColliderReactions reactions = fluid.Solver.Reactions;
            GpuTest.Run(reactions.RecordTake);
            reactions.Request();
            AsyncGPUReadback.WaitAllRequests();
            return ForceOn(fluid, 0, out torque);
        }

        // Returns the force and torque of the reactions that were taken last.
        static float3 ForceOn(TestFluid fluid, int index, out float3 torque)
        {
            ColliderReactions reactions = fluid.Solver.Reactions;
            reactions.Get(index, out double3 sum, out double3 moment);
            float substep = fluid.Input.timeStep / fluid.Input.settings.substeps;
            double mass = fluid.Input.material.density * math.pow(Spacing, 3);
            double scale = -mass * Spacing / (substep * reactions.Duration);
            torque = (float3)(moment * scale * Spacing * fluid.Input.colliders.Items[index].MomentArm);
            return (float3)(sum * scale);
        }
    }
}
