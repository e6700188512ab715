using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Deep water and solid colliders: the coarse grid's pressure stops at them, and holds the water above and beside them.</summary>
    [Category("LongRun")]
    public class ColliderDeepWaterTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void A_column_between_solid_walls_stands_as_one_between_the_walls_of_the_domain([Values(12f, 10f)] float left)
        {
            // The domain goes on behind a box on the left and below a plane: the column of 40 layers is 12 x 12 across.
            var corner = new float3(left, 5f, 0f);
            var size = new float3(12f, 40f, 12f);
            using (var fluid = new TestFluid((corner + size + new float3(0f, 10f, 0f)) * Spacing, Spacing, 6000, Deep))
            {
                fluid.AddBlock(corner * Spacing, size * Spacing);
                ColliderTests.Use(fluid,
                    ColliderTests.Still(ColliderShape.Box, new float3(0.5f * left, 60f, 60f), new float3(0.5f * left, 20f, 5f), quaternion.identity),
                    ColliderTests.Still(ColliderShape.Plane, 0f, corner, quaternion.identity));
                FluidStatistics settled = fluid.Step(120).MeasureWhole();
                Assert.That(settled.densityError, Is.LessThan(0.005f));
                Assert.That(settled.jitter, Is.LessThan(0.05f));
                Assert.That(2f * (settled.centerOfMass.y / Spacing - corner.y) / size.y, Is.EqualTo(1f).Within(0.03f), "volume ratio");
            }
        }

        // Without closed faces the water flows into the collider's cells as into air: 0.1 m/s and more of jitter.
        [Test]
        public void Water_stands_still_around_a_submerged_collider([Values(ColliderShape.Sphere, ColliderShape.Box)] ColliderShape shape)
        {
            using (var fluid = new TestFluid(32f * Spacing, Spacing, 25000, Deep))
            {
                ColliderMotion collider = ColliderTests.Still(shape, 6f, new float3(15f, 10f, 17f), quaternion.Euler(0.3f, 0.2f, 0.1f));
                fluid.AddAround(collider, 0f, new float3(32f, 24f, 32f));
                ColliderTests.Use(fluid, collider);
                FluidStatistics settled = fluid.Step(60).MeasureWhole();
                Assert.That(settled.densityError, Is.LessThan(0.005f));
                Assert.That(settled.jitter, Is.LessThan(0.05f));
                Assert.That(settled.speed, Is.LessThan(0.08f));
            }
        }

        // At each face of a cell that it closes: all of its displacement, and of its rotation what goes out of the surface.
        [Test]
        public void The_flow_of_a_collider_is_its_way_and_what_its_turn_moves_outwards([Values(ColliderShape.Sphere, ColliderShape.Box)]
            ColliderShape shape, [Values] bool isCube)
        {
            float3 box = isCube ? 32f : new float3(29f, 34.5f, 31f);
            var shift = new float3(0.1f, -0.05f, 0.08f);
            float3 turn = 0.06f * math.normalize(new float3(1f, 2f, 0.5f)), center = new float3(15.3f, 14.7f, 16.4f);
            using (var fluid = new TestFluid(box * Spacing, Spacing, 25000, Deep))
            {
                ColliderMotion collider = ColliderTests.Still(shape, shape == ColliderShape.Box ? new float3(7f, 6f, 2f) : 6f, center,
                    quaternion.Euler(0.3f, 0.2f, 0.1f));
                quaternion back = quaternion.AxisAngle(math.normalize(turn), -math.length(turn));
                collider.start = new RigidPose(center - shift, math.mul(back, collider.end.rotation));
                fluid.AddAround(collider, 0f, new float3(box.x, 24f, box.z));
                ColliderTests.Use(fluid, collider);
                fluid.Step();
                CoarseGrid grid = fluid.Solver.Coarse.Grid;
                float4[] flow = GpuTest.Read<float4>(fluid.Solver.Coarse.Colliders.Flow, grid.Total);
                int closed = 0;
                float turned = 0f;
                for (int i = 0; i < grid.Total * 3; i++)
                {
                    float found = flow[i / 3][i % 3];
                    if (found == 0f)
                        continue;
                    int3 cell = new int3(i / 3 % grid.Counts.x, i / 3 / grid.Counts.x % grid.Counts.y, i / 3 / grid.Counts.x / grid.Counts.y);
                    float3 axis = default, normal = default;
                    axis[i % 3] = 1f;
                    float3 face = ((float3)cell + 0.5f - 0.5f * axis) * (box / grid.Counts);
                    for (int k = 0; k < 3; k++)
                    {
                        float3 off = default;
                        off[k] = 0.01f;
                        double ahead = Reference.Shapes.Distance(collider, face + off), behind = Reference.Shapes.Distance(collider, face - off);
                        normal[k] = (float)(ahead - behind) / 0.02f;
                    }
                    if (math.abs(math.length(normal) - 1f) > 0.02f)
                        continue;       // as near to another side
                    float3 surface = face - (float)Reference.Shapes.Distance(collider, face) * normal;
                    float outwards = math.dot(math.cross(turn, surface - center), normal);
                    Assert.That(found, Is.EqualTo(math.dot(axis, shift + outwards * normal)).Within(0.01f), $"cell {cell}, axis {i % 3}, d");
                    turned = math.max(turned, math.abs(outwards));
                    closed++;
                }
                TestContext.Out.WriteLine($"{closed} faces, turned by up to {turned:0.00} d");
                Assert.That(closed, Is.GreaterThan(20));
                Assert.That(turned, shape == ColliderShape.Box ? Is.GreaterThan(0.1f) : Is.LessThan(0.01f));
            }
        }

        // Kernels are shared by all fluids of a scene, and what rests is not recorded again.
        [Test]
        public void Two_fluids_with_colliders_at_rest_do_not_disturb_each_other([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            ParticleState alone, otherAlone;
            using (TestFluid fluid = Fluid(0.05f, 24f))
                alone = fluid.Step(10).Read();
            using (TestFluid other = Fluid(0.1f, 16f))
                otherAlone = other.Step(10).Read();
            using (TestFluid fluid = Fluid(0.05f, 24f), other = Fluid(0.1f, 16f))
            {
                for (int i = 0; i < 10; i++)
                {
                    fluid.Step();
                    other.Step();
                }
                TestFluid.AssertSame(fluid.Read(), alone);
                TestFluid.AssertSame(other.Read(), otherAlone);
            }

            TestFluid Fluid(float spacing, float side)
            {
                SolverSettings settings = Deep;
                settings.deepWater = deepWater;
                var fluid = new TestFluid(side * spacing, spacing, 5000, settings);
                ColliderTests.Use(fluid, ColliderTests.Still(ColliderShape.Box, 3f, new float3(0.5f * side, 4f, 0.5f * side),
                    quaternion.RotateY(0.3f)));
                return fluid.AddBlock(new float3(0f, 9f, 0f) * spacing, new float3(side, 4f, side) * spacing, new float3(0f, -3f, 0f));
            }
        }

        internal static SolverSettings Deep
        {
            get
            {
                SolverSettings settings = SolverSettings.Default;
                settings.deepWater = DeepWater.On;
                settings.iterations = 2;
                return settings;
            }
        }
    }
}
