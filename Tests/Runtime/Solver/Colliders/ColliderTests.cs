using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Solid colliders in a solver: no particle inside, no particle through, and what lies behind a surface counts as water.</summary>
    public class ColliderTests
    {
        const float Spacing = 0.05f;

        [Test, Category("LongRun")]
        public void Water_that_falls_on_a_shape_goes_around_it([Values(ColliderShape.Sphere, ColliderShape.Box,
            ColliderShape.Capsule)] ColliderShape kind, [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(new float3(0f, 14f, 0f) * Spacing, new float3(18f, 8f, 18f) * Spacing))
            {
                ColliderMotion shape = Still(kind, new float3(4f, 3f, 4f), new float3(9f, 7f, 9f), quaternion.Euler(0.4f, 0.3f, 0.2f));
                Use(fluid, shape);
                for (int i = 0; i < 12; i++)
                {
                    fluid.Step(5).MeasureWhole();
                    Assert.That(Nearest(fluid, shape), Is.GreaterThan(0.45f), $"step {5 * i + 5}");
                }
            }
        }

        [Test]
        public void A_wall_of_one_spacing_stops_a_block_at_100_meters_a_second([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater,
            [Values(0f, 0.5f)] float tilt)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(6f * Spacing, 6f * Spacing, new float3(100f, 0f, 0f)))
            {
                quaternion turn = quaternion.Euler(0f, 0f, tilt);
                ColliderMotion wall = Still(ColliderShape.Box, new float3(0.5f, 40f, 40f), new float3(15f, 9f, 9f), turn);
                Use(fluid, wall);
                for (int i = 0; i < 20; i++)
                {
                    fluid.Step().MeasureWhole();
                    foreach (float4 p in fluid.Read().positions)
                        Assert.That(math.mul(math.conjugate(turn), p.xyz - wall.start.position).x, Is.LessThan(-0.95f), $"step {i + 1}, {p}");
                }
            }
        }

        [Test]
        public void A_plate_that_moves_faster_than_its_thickness_in_a_step_leaves_no_particle_behind([Values(1f, 4f)] float spacingsPerStep,
            [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(new float3(4f, 0f, 0f) * Spacing, new float3(6f, 6f, 18f) * Spacing))
            {
                float x = 2f;
                while (x < 12f)
                {
                    ColliderMotion plate = Still(ColliderShape.Box, new float3(0.5f, 40f, 40f), new float3(x, 9f, 9f), quaternion.identity);
                    x += spacingsPerStep;
                    plate.end.position.x = x;
                    Use(fluid, plate);
                    fluid.Step().MeasureWhole();
                    foreach (float4 p in fluid.Read().positions)
                        Assert.That(p.x, Is.GreaterThan(x + 0.95f), $"plate at {x}");
                }
            }
        }

        // A pass moves a particle by half a spacing at most, the coarse grid by two; who is not near is not kept out in the passes.
        [Test]
        public void Near_a_shape_is_whom_the_passes_of_a_step_can_drive_into_it([Values(2, 8)] int iterations,
            [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(0f, 18f * Spacing))
            {
                fluid.Input.settings.iterations = iterations;
                fluid.Input.gravity = 0f;
                ColliderMotion ball = Still(ColliderShape.Sphere, 2f, 3f, quaternion.identity);
                Use(fluid, ball);
                fluid.Step();
                ParticleState state = fluid.Read();
                float[] contactOffsets = GpuTest.Read<float>(fluid.Solver.Colliders.ContactOffsets, state.Count);
                float reach = math.max(2f, 0.5f + 0.5f * iterations + (deepWater == DeepWater.On ? 2f : 0f));
                for (int i = 0; i < state.Count; i++)
                {
                    float distance = (float)Reference.Shapes.Distance(ball, state.positions[i].xyz);
                    if (distance > 1f && math.abs(distance - reach) > 0.3f)       // they move a little
                        Assert.That(contactOffsets[i], Is.EqualTo(distance < reach ? 0.5f : 1f).Within(1e-3f), $"{distance} d away");
                }
            }
        }

        [Test]
        public void What_is_not_finite_beside_a_shape_is_culled_alone([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            ColliderMotion ball = Still(ColliderShape.Sphere, 3f, new float3(9f, 7f, 9f), quaternion.identity);
            using (TestFluid fluid = Box(deepWater).AddAround(ball, 0f, new float3(18f, 6f, 18f)))
            {
                float none = float.NaN, endless = float.PositiveInfinity;
                fluid.Add(new[] { new float3(none, 0.4f, 0.4f), new float3(0.4f, endless, 0.4f), new float3(0.4f, 0.4f, -endless) });
                fluid.Add(new[] { new float3(0.2f, 0.5f, 0.2f), new float3(0.4f, 0.5f, 0.7f), new float3(0.7f, 0.5f, 0.4f) },
                    p => p.x < 0.3f ? none : p.x < 0.5f ? endless : new float3(0f, -endless, none));
                Use(fluid, ball);
                Assert.That(fluid.Step(3).MeasureWhole().nonFinite, Is.EqualTo(6));
                Assert.That(Nearest(fluid, ball), Is.LessThan(1.5f));       // water that it has met
            }
        }

        [Test]
        public void A_collider_adds_the_density_of_what_lies_behind_its_surface([Values(ColliderShape.Sphere, ColliderShape.Box,
            ColliderShape.Capsule, ColliderShape.Plane, ColliderShape.Mesh)] ColliderShape shape, [Values] bool insideOut)
        {
            if (shape == ColliderShape.Mesh)
                return;     // whose distances are those of its field: MeshColliderTests
            ColliderMotion motion = Still(shape, new float3(3f, 2f, 4f), new float3(9f, 12f, 9f), quaternion.Euler(0.4f, 0.3f, 0.2f));
            motion.insideOut = insideOut;
            var random = new Unity.Mathematics.Random(7u);
            float3[] positions = Enumerable.Range(0, 400).Select(_ => motion.end.position + random.NextFloat3(-6f, 6f)).ToArray();
            using (TestFluid fluid = Box(DeepWater.Off).Add(positions.Select(p => p * Spacing).ToArray()))
            {
                Use(fluid, motion);
                GpuTest.Run(cmd => fluid.Solver.Step(cmd, fluid.Input));
                ParticleState state = fluid.Read();
                GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
                float4[] boundary = GpuTest.Read<float4>(fluid.Solver.Colliders.Boundary, state.Count);
                float[] distances = GpuTest.Read<float>(fluid.Solver.Colliders.ContactOffsets, state.Count);
                int touched = 0;
                for (int i = 0; i < state.Count; i++)
                {
                    double3 p = state.positions[i].xyz;
                    double distance = Reference.Shapes.Distance(motion, p);
                    Assert.That(distances[i], Is.EqualTo(math.min(distance, 2.0)).Within(1e-4), $"distance at {p}");
                    if (math.any(p < 2.1) || math.any(p > (double3)state.box - 2.1))
                        continue;       // where the domain's walls add theirs
                    double density = Reference.Shapes.Density(motion, p);
                    Assert.That(boundary[i].w, Is.EqualTo(density).Within(2e-3), $"density at {p}, {distance} away");
                    touched += density > 0.01 ? 1 : 0;
                }
                Assert.That(touched, Is.GreaterThan(20));
            }
        }

        [Test]
        public void Two_boxes_in_one_plane_add_what_one_does()
        {
            // A floor of one box, and of two that meet under the particles.
            float3[] positions = Enumerable.Range(0, 40).Select(i => new float3(6f + 0.15f * i, 5.5f + 0.01f * i, 9f) * Spacing).ToArray();
            float4[] one = BoundaryOver(positions, Still(ColliderShape.Box, new float3(20f, 2f, 20f), new float3(9f, 3f, 9f), quaternion.identity));
            float4[] two = BoundaryOver(positions, Still(ColliderShape.Box, new float3(10f, 2f, 20f), new float3(-1f, 3f, 9f), quaternion.identity),
                Still(ColliderShape.Box, new float3(10f, 2f, 20f), new float3(19f, 3f, 9f), quaternion.identity));
            for (int i = 0; i < positions.Length; i++)
                Assert.That(math.length(two[i] - one[i]), Is.LessThan(0.01f * math.length(one[i])), $"particle {i}: {two[i]} instead of {one[i]}");
        }

        [Test]
        public void What_touches_loses_the_fraction_of_its_velocity_that_friction_says([Values(1, 2)] int substeps,
            [Values(0f, 0.3f, 1f)] float friction)
        {
            using (TestFluid fluid = Box(DeepWater.Off))
            {
                fluid.Input.settings.substeps = substeps;
                ColliderMotion floor = Still(ColliderShape.Plane, 0f, new float3(0f, 6f, 0f), quaternion.identity);
                floor.friction = friction;
                Use(fluid, floor);
                fluid.Add(new[] { new float3(4f, 6.5f, 9f) * Spacing }, new float3(0.6f, 0f, 0f)).Step();
                Assert.That(fluid.Read().velocities[0].x * Spacing, Is.EqualTo(0.6f * (1f - friction)).Within(0.005f));
            }
        }

        [Test]
        public void A_drop_comes_back_with_the_fraction_of_its_velocity_that_bounce_says([Values(0f, 0.5f, 1f)] float bounciness)
        {
            using (TestFluid fluid = Box(DeepWater.Off))
            {
                fluid.Input.gravity = 0f;
                quaternion turn = quaternion.Euler(0f, 0f, 0.25f);
                float3 normal = math.mul(turn, math.up());
                ColliderMotion floor = Still(ColliderShape.Plane, 0f, new float3(9f, 6f, 9f), turn);
                floor.bounciness = bounciness;
                Use(fluid, floor);
                fluid.Add(new[] { new float3(9f, 12f, 9f) * Spacing }, -4f * normal);
                for (int i = 0; i < 8; i++)
                    fluid.Step();
                float3 velocity = fluid.Read().velocities[0].xyz * Spacing;
                Assert.That(math.dot(velocity, normal), Is.EqualTo(4f * bounciness).Within(0.05f));
                Assert.That(math.length(velocity - normal * math.dot(velocity, normal)), Is.LessThan(0.01f));
            }
        }

        [Test, Category("LongRun")]
        public void A_collider_switched_on_in_water_lets_it_out_slowly([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (TestFluid fluid = Box(deepWater).AddBlock(0f, new float3(18f, 12f, 18f) * Spacing).Step(10))
            {
                ColliderMotion body = Still(ColliderShape.Sphere, 4f, new float3(9f, 6f, 9f), quaternion.identity);
                Use(fluid, body);
                for (int i = 0; i < 40; i++)
                    Assert.That(fluid.Step().Measure().speedMax, Is.LessThan(4f), $"m/s at step {i}");
                Assert.That(Nearest(fluid, body), Is.GreaterThan(0.4f));
            }
        }

        static float4[] BoundaryOver(float3[] positions, params ColliderMotion[] motions)
        {
            using (TestFluid fluid = Box(DeepWater.Off).Add(positions))
            {
                fluid.Input.gravity = 0f;
                fluid.Input.material.density = 1000f;
                Use(fluid, motions);
                fluid.Step();
                fluid.Solver.Clear();
                fluid.Add(positions);
                GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
                return GpuTest.Read<float4>(fluid.Solver.Colliders.Boundary, positions.Length);
            }
        }

        static TestFluid Box(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return new TestFluid(new float3(18f, 24f, 18f) * Spacing, Spacing, 4000, settings);
        }

        internal static ColliderMotion Still(ColliderShape kind, float3 size, float3 position, quaternion rotation)
        {
            var pose = new RigidPose(position, rotation);
            return new ColliderMotion { shape = kind, size = size, start = pose, end = pose, contributesDensity = true };
        }

        internal static void Use(TestFluid fluid, params ColliderMotion[] motions)
        {
            var set = new ColliderSet { Count = motions.Length, Version = 1 };
            motions.CopyTo(set.Items, 0);
            fluid.Input.colliders = set;
            fluid.Input.frameTo = 1f;
        }

        // Least distance of a particle from the surface of a shape, d.
        static float Nearest(TestFluid fluid, ColliderMotion shape)
            => fluid.Read().positions.Min(p => (float)Reference.Shapes.Distance(shape, p.xyz));
    }
}
