using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Particles that are loose balls. Lengths in d.</summary>
    public class ContactsTests
    {
        const float Spacing = 0.01f;
        const float StepRate = 60f;
        const float Friction = 0.1f;
        const float OverRelaxation = 1.5f;

        [TestCase(20f, 0f)]
        [TestCase(20f, 0.7f)]
        [TestCase(55f, 0f)]
        [TestCase(55f, 0.3f)]
        [TestCase(110f, 0f)]
        [TestCase(110f, 0.1f)]
        public void Two_balls_that_meet_do_not_pass_and_keep_their_momentum(float speed, float offset)
        {
            using (TestFluid fluid = Balls(40f, 2, weightless: true))
            {
                Add(fluid, (new float3(7f, 20f, 20f), new float3(speed, 0f, 0f)), (new float3(10f, 20f + offset, 20f), float3.zero));
                for (int step = 0; step < 12; step++)
                {
                    (float3 position, float3 velocity)[] balls = Sorted(fluid.Step());
                    Assert.That(math.distance(balls[0].position, balls[1].position), Is.GreaterThan(0.99f), $"step {step}");
                    if (offset == 0f)
                        Assert.That(balls[1].position.x, Is.GreaterThan(balls[0].position.x), $"step {step}");
                    Assert.That(math.length(Momentum(fluid) - new float3(speed, 0f, 0f)), Is.LessThan(1e-4f * speed), $"step {step}");
                }
                (float3 position, float3 velocity)[] end = Sorted(fluid);
                if (offset == 0f)
                    Assert.That(end.Select(ball => ball.velocity.x), Is.All.EqualTo(0.5f * speed).Within(1e-3f * speed), "without a bounce");
                else
                    Assert.That(end[1].velocity.x, Is.InRange(0.1f * speed, 0.9f * speed));
            }
        }

        [Test]
        public void A_heavy_ball_gives_a_light_one_the_speed_that_keeps_the_momentum()
        {
            using (TestFluid fluid = Balls(40f, 2, weightless: true))
            {
                fluid.Input.phases.Set(1, 250f, 0f);
                fluid.AddPhase(0, new[] { new float3(10f, 20f, 20f) }).AddPhase(1, new[] { new float3(12f, 20f, 20f) });
                fluid.Solver.Velocities.SetData(new[] { new float4(30f, 0f, 0f, 0f), float4.zero });
                fluid.Step(10);
                Assert.That(Sorted(fluid).Select(ball => ball.velocity.x), Is.All.EqualTo(24f).Within(0.05f));
            }
        }

        // Most lie inside several others, so that each moves by many contacts at once, with friction.
        [TestCase(60, 3f, 1)]
        [TestCase(300, 5f, 1)]
        [TestCase(300, 5f, 3)]
        [TestCase(257, 6f, 4)]
        public void Passes_are_those_of_the_reference_and_keep_momentum(int count, float side, int passes)
        {
            var random = new Unity.Mathematics.Random(7u);
            var balls = new (float3 position, float3 velocity)[count];
            for (int i = 0; i < count; i++)
                balls[i] = (20f + random.NextFloat3(side), random.NextFloat3(-10f, 10f));
            balls[1].position = balls[0].position;      // with velocities of their own
            using (TestFluid fluid = Balls(40f, count, weightless: true, set: s =>
            {
                s.iterations = passes;
                s.neighborCapacity = 256;
                return s;
            }))
            {
                Add(fluid, balls);
                fluid.Step();
                float3 momentum = balls.Aggregate(float3.zero, (sum, ball) => sum + ball.velocity);
                Assert.That(math.length(Momentum(fluid) - momentum), Is.LessThan(1e-3f * count));
                double3[] expected = Passes(balls, passes);
                (float3 position, float3 velocity)[] actual = Sorted(fluid);
                double moved = 0.0;
                for (int i = 0; i < count; i++)
                {
                    Assert.That(math.distance((double3)actual[i].position, expected[i]), Is.LessThan(5e-4), $"ball {i}");
                    moved += math.distance(expected[i], balls[i].position + (double3)balls[i].velocity / StepRate);
                }
                Assert.That(moved / count, Is.GreaterThan(0.05), "contacts moved them");
            }
        }

        [TestCase(6f, 1)]
        [TestCase(0f, 2)]
        public void A_cube_of_balls_falls_spreads_and_comes_to_rest_one_layer_deep(float height, int substeps)
        {
            const int side = 5, total = side * side * side;
            using (TestFluid fluid = Balls(new float3(60f, 20f, 60f), total, set: s =>
            {
                s.substeps = substeps;
                return s;
            }))
            {
                fluid.AddBlock(new float3(28f, height, 28f) * Spacing, side * Spacing, jitter: 0.05f).Step(240);
                (float3 position, float3 velocity)[] balls = Sorted(fluid);
                float nearest = Nearest(fluid), top = balls.Max(ball => ball.position.y), fastest = balls.Max(ball => math.length(ball.velocity));
                float width = balls.Max(ball => ball.position.x) - balls.Min(ball => ball.position.x);
                TestContext.Out.WriteLine($"nearest pair {nearest:0.000} d, top {top:0.00} d, width {width:0.0} d, fastest {fastest:0.000} d/s");
                Assert.That(nearest, Is.GreaterThan(0.9f));
                Assert.That(balls.Count(ball => ball.position.y > 0.7f), Is.LessThan(0.05 * total), "balls above the first layer");
                Assert.That(fastest, Is.LessThan(0.1f));
                Assert.That(width, Is.GreaterThan(2f * side));
            }
        }

        // The cases of Research~/solver-study.md: a square lattice that fills the box, after two seconds.
        [TestCase(0.01f, 1, 1)]
        [TestCase(0.01f, 2, 2)]
        [TestCase(0.01f, 4, 3)]
        [TestCase(0.05f, 1, 2)]
        [TestCase(0.05f, 2, 3)]
        [TestCase(0.05f, 4, 4)]
        public void As_many_layers_hold_as_the_inspector_says(float spacing, int substeps, int layers)
        {
            Assert.That(Contacts.LayersHeld(9.81f, spacing, 1f / (StepRate * substeps)), Is.EqualTo(layers));
            float nearest = Layers(spacing, substeps, layers);
            TestContext.Out.WriteLine($"{layers} layers of {spacing * 100f} cm, {substeps} substeps: nearest pair {nearest:0.000} d");
            Assert.That(nearest, Is.GreaterThan(0.84f));
            if (substeps == 1)
                Assert.That(Layers(spacing, substeps, layers + 1), Is.LessThan(0.84f), "one more");
        }

        [Test]
        public void A_ball_that_slides_is_braked_by_friction()
        {
            using (TestFluid fluid = Balls(new float3(60f, 10f, 10f), 1))
            {
                Add(fluid, (new float3(5f, 0.5f, 5f), new float3(60f, 0f, 0f)));
                fluid.Step(15);
                float expected = 60f - Friction * 9.81f / Spacing * 15f / StepRate;
                Assert.That(Sorted(fluid)[0].velocity.x, Is.EqualTo(expected).Within(0.5f));
                fluid.Step(120);
                Assert.That(Sorted(fluid)[0].velocity, Is.EqualTo(float3.zero));
            }
        }

        [Test]
        public void Balls_rest_on_a_collider_and_sleep()
        {
            using (TestFluid fluid = Balls(new float3(12f, 20f, 12f), 200, set: s =>
            {
                s.sleepSpeed = 0.05f;
                return s;
            }))
            {
                ColliderTests.Use(fluid, ColliderTests.Still(ColliderShape.Plane, 0f, new float3(6f, 5f, 6f), quaternion.identity));
                fluid.AddBlock(new float3(2f, 6f, 2f) * Spacing, new float3(8f, 1f, 8f) * Spacing).Step(120);
                (float3 position, float3 velocity)[] balls = Sorted(fluid);
                Assert.That(balls.Select(ball => ball.position.y), Is.All.EqualTo(5.5f).Within(0.02f));
                Assert.That(balls.Select(ball => ball.velocity), Is.All.EqualTo(float3.zero));
            }
        }

        [Test]
        public void Two_runs_are_equal_and_water_after_them_is_as_before()
        {
            var runs = new List<ParticleState>();
            foreach (bool contacts in new[] { false, true, true, false })
                using (TestFluid fluid = Balls(new float3(20f, 20f, 20f), 300))
                {
                    fluid.Input.material.contacts = contacts;
                    runs.Add(fluid.AddBlock(new float3(6f, 3f, 6f) * Spacing, 6f * Spacing).Step(20).Read());
                }
            TestFluid.AssertSame(runs[2], runs[1]);
            TestFluid.AssertSame(runs[3], runs[0]);
            Assert.That(runs[1].positions, Is.Not.EqualTo(runs[0].positions));
        }

        [Test]
        public void Balls_have_no_pressure_tension_or_grains()
        {
            using (TestFluid fluid = Balls(new float3(20f, 20f, 20f), 1000, set: s =>
            {
                (s.deepWater, s.numericalDamping) = (DeepWater.On, 0.5f);
                return s;
            }))
            {
                (fluid.Input.material.surfaceTension, fluid.Input.material.frictionAngle) = (1f, 30f);
                fluid.AddBlock(0f, new float3(10f, 6f, 10f) * Spacing).Step();
                Assert.That(fluid.Solver.Coarse, Is.Null);
                Assert.That(SurfaceTension.IsNeeded(fluid.Input) || GrainFriction.IsNeeded(fluid.Input)
                    || VelocityExtrapolation.IsNeeded(fluid.Input), Is.False);
                fluid.Input.material.contacts = false;
                fluid.Step();
                Assert.That(fluid.Solver.Coarse, Is.Not.Null);
            }
        }

        static TestFluid Balls(float3 box, int capacity, bool weightless = false, Func<SolverSettings, SolverSettings> set = null,
            float spacing = Spacing)
        {
            SolverSettings settings = SolverSettings.Default;
            var fluid = new TestFluid(box * spacing, spacing, capacity, set == null ? settings : set(settings));
            fluid.Input.timeStep = 1f / StepRate;
            fluid.Input.material.contacts = true;
            fluid.Input.material.velocitySmoothing = 0f;
            if (weightless)
                fluid.Input.gravity = float3.zero;
            return fluid;
        }

        // Nearest pair of a lattice of so many layers, after two seconds.
        static float Layers(float spacing, int substeps, int layers)
        {
            const int side = 12;
            using (TestFluid fluid = Balls(new float3(side, 20f, side), side * side * layers, set: s =>
            {
                s.substeps = substeps;
                return s;
            }, spacing: spacing))
            {
                ParticleState block = ParticleState.Lattice(0f, 0.5f, new int3(side, layers, side), 0.02f);
                fluid.Add(block.positions.Select(p => p.xyz * spacing).ToArray()).Step(120);
                return Nearest(fluid);
            }
        }

        static void Add(TestFluid fluid, params (float3 position, float3 velocity)[] balls)
            => fluid.Add(balls.Select(ball => ball.position * Spacing).ToArray(), balls.Select(ball => ball.velocity * Spacing).ToArray());

        // By id: the order of the buffers changes.
        static (float3 position, float3 velocity)[] Sorted(TestFluid fluid)
        {
            ParticleState state = fluid.Read();
            return Enumerable.Range(0, state.Count).OrderBy(i => state.ids[i]).Select(i => (state.positions[i].xyz, state.velocities[i].xyz))
                .ToArray();
        }

        static float Nearest(TestFluid fluid)
        {
            float3[] p = fluid.Read().positions.Select(x => x.xyz).OrderBy(x => x.x).ToArray();
            float least = float.MaxValue;
            for (int i = 0; i < p.Length; i++)
                for (int j = i + 1; j < p.Length && p[j].x - p[i].x < least; j++)
                    least = math.min(least, math.distance(p[i], p[j]));
            return least;
        }

        static float3 Momentum(TestFluid fluid) => fluid.Read().velocities.Aggregate(float3.zero, (sum, v) => sum + v.xyz);

        // The passes of Contacts.compute for balls of one mass, far from walls.
        static double3[] Passes((float3 position, float3 velocity)[] balls, int passes)
        {
            double3[] start = balls.Select(ball => (double3)ball.position).ToArray();
            double3[] at = balls.Select(ball => (double3)ball.position + (double3)ball.velocity / StepRate).ToArray();
            for (int pass = 0; pass < passes; pass++)
            {
                var counts = new int[at.Length];
                ForContacts(at, (i, j) => counts[i]++);
                double3[] next = at.ToArray();
                ForContacts(at, (i, j) =>
                {
                    double3 apart = at[i] - at[j], before = start[i] - start[j];
                    bool hasPassed = math.dot(apart, before) < 0.0 && math.lengthsq(before) > 1e-8;
                    double3 normal = math.normalize(hasPassed ? before : apart);
                    double depth = 1.0 - math.dot(apart, normal);
                    double3 slip = apart - before;
                    slip -= normal * math.dot(normal, slip);
                    double length = math.length(slip);
                    if (length > Friction * depth)
                        slip *= Friction * depth / length;
                    next[i] += (depth * normal - slip) / Math.Max((counts[i] + counts[j]) / OverRelaxation, 2.0);
                });
                at = next;
            }
            return at;
        }

        static void ForContacts(double3[] at, Action<int, int> visit)
        {
            for (int i = 0; i < at.Length; i++)
                for (int j = 0; j < at.Length; j++)
                    if (i != j && math.distance(at[i], at[j]) < 1.0)
                        visit(i, j);
        }
    }
}
