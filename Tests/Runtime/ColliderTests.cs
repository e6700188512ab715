using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Solid obstacles in a solver: nobody inside, nobody through, and what lies behind a surface counts as water.</summary>
    public class ColliderTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void Water_that_falls_on_a_shape_goes_around_it([Values(ColliderShape.Sphere, ColliderShape.Box, ColliderShape.Capsule)] ColliderShape kind, [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
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
        public void A_wall_of_one_spacing_stops_a_block_at_100_metres_a_second([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater, [Values(0f, 0.5f)] float tilt)
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
        public void A_plate_that_moves_faster_than_its_thickness_in_a_step_leaves_nobody_behind([Values(1f, 4f)] float spacingsPerStep, [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
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

        static TestFluid Box(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return new TestFluid(new float3(18f, 24f, 18f) * Spacing, Spacing, 4000, settings);
        }

        internal static ColliderMotion Still(ColliderShape kind, float3 size, float3 position, quaternion rotation)
        {
            var pose = new RigidPose(position, rotation);
            return new ColliderMotion { shape = kind, size = size, start = pose, end = pose, carriesDensity = true };
        }

        internal static void Use(TestFluid fluid, params ColliderMotion[] motions)
        {
            var set = new ColliderSet { Count = motions.Length, Version = 1 };
            motions.CopyTo(set.Items, 0);
            fluid.Input.colliders = set;
            fluid.Input.frameTo = 1f;
        }

        // Least distance of a particle from the surface of a shape, d.
        static float Nearest(TestFluid fluid, ColliderMotion shape) => fluid.Read().positions.Min(p => (float)Reference.Shapes.Distance(shape, p.xyz));
    }
}
