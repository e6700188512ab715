using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The textures in which the fields of colliders lie. A box of 24 x 20 x 24 d, d = 5 cm, over ground that leans, with a ball
    /// in it.</summary>
    public class FieldAtlasTests
    {
        const float Spacing = 0.05f, Radius = 4f, Voxel = 0.2f, Slope = 0.25f;
        const int Side = 64, GroundSide = 513;
        const long HalfFloat = 2;
        static readonly float3 Box = new float3(24f, 20f, 24f), WorldCenter = new float3(12f, 14f, 12f);

        readonly List<Object> made = new List<Object>();
        HeightField ground;

        [TearDown]
        public void DestroyFields()
        {
            made.ForEach(Object.DestroyImmediate);
            made.Clear();
            ground?.Dispose();
            ground = null;
        }

        [Test]
        public void Ground_and_a_mesh_take_the_bytes_of_each_and_keep_their_distances()
        {
            using (TestFluid fluid = Fluid())
            {
                ColliderTests.Use(fluid, Ball(Side), Ground());
                var random = new Unity.Mathematics.Random(3u);
                fluid.Add(Enumerable.Range(0, 2000).Select(_ => random.NextFloat3(0.6f, Box - 0.6f) * Spacing).ToArray());
                fluid.Step();
                GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));

                long mesh = HalfFloat * Side * Side * Side, heights = HalfFloat * GroundSide * GroundSide;
                Assert.That(Bytes(fluid, "Fields"), Is.EqualTo(mesh));
                Assert.That(Bytes(fluid, "Heights"), Is.EqualTo(heights));
                Assert.That(BytesAlive("Fields") + BytesAlive("Heights"), Is.EqualTo(mesh + heights), "what is reported is what exists");

                ParticleState state = fluid.Read();
                float[] distances = GpuTest.Read<float>(fluid.Solver.Colliders.ContactOffsets, state.Count);
                int nearBall = 0, nearGround = 0;
                for (int i = 0; i < state.Count; i++)
                {
                    float3 p = state.positions[i].xyz;
                    float toBall = math.distance(p, WorldCenter) - Radius, toGround = (p.y - Height(p.xz)) * math.rsqrt(1f + Slope * Slope);
                    float wanted = math.min(math.min(toBall, toGround), 2f);
                    if (wanted < -1f)
                        continue;
                    // Between voxels a ball's distance is off by its curvature: Voxel * Voxel / Radius = 0.01 d.
                    Assert.That(distances[i], Is.EqualTo(wanted).Within(0.03f), $"at {p}");
                    nearBall += toBall < 1.9f && toBall < toGround ? 1 : 0;
                    nearGround += toGround < 1.9f && toGround < toBall ? 1 : 0;
                }
                Assert.That(new[] { nearBall, nearGround }, Is.All.GreaterThan(50));
            }
        }

        [Test]
        public void There_is_an_atlas_only_while_a_field_of_its_kind_is_in_the_box()
        {
            using (TestFluid fluid = Fluid())
            {
                var pose = new RigidPose(WorldCenter, quaternion.identity);
                var sphere = new ColliderMotion { shape = ColliderShape.Sphere, size = Radius, start = pose, end = pose, contributesDensity = true };
                ColliderMotion ball = Ball(16), other = Ball(8), field = Ground();
                void Holds(int voxels, int heights, params ColliderMotion[] colliders)
                {
                    ColliderTests.Use(fluid, colliders);
                    fluid.Step();
                    Assert.That((Bytes(fluid, "Fields"), Bytes(fluid, "Heights")), Is.EqualTo((HalfFloat * voxels, HalfFloat * heights)));
                    Assert.That((BytesAlive("Fields"), BytesAlive("Heights")), Is.EqualTo((HalfFloat * voxels, HalfFloat * heights)));
                }

                const int Heights = GroundSide * GroundSide;
                Holds(0, 0, sphere);
                Holds(0, Heights, field);
                Holds(16 * 16 * 16, Heights, field, ball);
                Holds(16 * 16 * (16 + 8), 0, ball, other, sphere, ball);
                Holds(8 * 8 * 8, 0, other);
                Holds(0, 0, sphere);
            }
        }

        // Neither a cube nor a multiple of a group along any axis, the balls beside the center of their fields, and all of it turned.
        [Test]
        public void Fields_of_any_sides_lie_one_behind_the_other_and_keep_their_distances_where_they_are_turned([Values] bool swapped)
        {
            using (TestFluid fluid = Fluid())
            {
                ColliderMotion first = Ball(new int3(37, 23, 41), 0.3f, new float3(1.1f, -0.5f, 2f), 2.5f, new float3(8f, 9f, 8f), 0.9f);
                ColliderMotion second = Ball(new int3(22, 43, 18), 0.3f, new float3(-0.6f, 2.2f, 0.3f), 2f, new float3(17f, 11f, 16f), 2.3f);
                ColliderTests.Use(fluid, swapped ? second : first, swapped ? first : second);
                var random = new Unity.Mathematics.Random(5u);
                fluid.Add(Enumerable.Range(0, 3000).Select(_ => random.NextFloat3(0.6f, Box - 0.6f) * Spacing).ToArray());
                fluid.Step();
                GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
                Assert.That(Bytes(fluid, "Fields"), Is.EqualTo(HalfFloat * 37 * 43 * (41 + 18)));

                ParticleState state = fluid.Read();
                float[] distances = GpuTest.Read<float>(fluid.Solver.Colliders.ContactOffsets, state.Count);
                int[] near = new int[2];
                for (int i = 0; i < state.Count; i++)
                {
                    float3 p = state.positions[i].xyz;
                    float toFirst = DistanceTo(first, new float3(1.1f, -0.5f, 2f), 2.5f, p), toSecond = DistanceTo(second,
                        new float3(-0.6f, 2.2f, 0.3f), 2f, p), wanted = math.min(toFirst, toSecond);
                    ColliderMotion nearest = toFirst < toSecond ? first : second;
                    bool isInside = math.all(math.abs(math.mul(math.inverse(nearest.end.rotation), p - nearest.end.position)) < nearest.size - 0.3f);
                    if (!isInside || wanted > 1.9f || wanted < -1f)
                        continue;
                    // 0.3 * 0.3 / 2 = 0.045 d at most, between voxels of the smaller ball
                    Assert.That(distances[i], Is.EqualTo(wanted).Within(0.05f), $"at {p}");
                    near[toFirst < toSecond ? 0 : 1]++;
                }
                Assert.That(near, Is.All.GreaterThan(30));
            }
        }

        // Distance from the ball of a field, d.
        static float DistanceTo(in ColliderMotion collider, float3 center, float radius, float3 p)
            => math.distance(math.mul(math.inverse(collider.end.rotation), p - collider.end.position), center) - radius;

        // Bakes into an asset that is in use.
        [Test]
        public void A_field_that_changes_in_place_is_copied_again_and_one_that_does_not_is_not()
        {
            using (TestFluid fluid = Fluid())
            {
                ColliderMotion ball = Ball(16);
                ColliderTests.Use(fluid, ball);
                fluid.Add(new[] { (WorldCenter + new float3(0f, 0f, Radius + 1f)) * Spacing });
                Assert.That(Distance(), Is.EqualTo(1f).Within(0.05f));
                NativeArray<float> texels = ball.field.GetPixelData<float>(0);
                for (int i = 0; i < texels.Length; i++)
                    texels[i] -= 0.3f;
                Assert.That(Distance(), Is.EqualTo(1f).Within(0.05f), "not before it is applied");
                ball.field.Apply(false, false);
                Assert.That(Distance(), Is.EqualTo(0.7f).Within(0.05f));

                float Distance()
                {
                    fluid.Step();
                    GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
                    return GpuTest.Read<float>(fluid.Solver.Colliders.ContactOffsets, 1)[0];
                }
            }
        }

        static TestFluid Fluid()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.Off;
            var fluid = new TestFluid(Box * Spacing, Spacing, 4000, settings);
            fluid.Input.gravity = 0f;
            return fluid;
        }

        static long Bytes(TestFluid fluid, string atlas) =>
            Colliders.Describe(fluid.Solver.Colliders, fluid.Input).Buffers.Where(buffer => buffer.name == "Rill.Colliders." + atlas)
            .Sum(buffer => buffer.bytes);

        static long BytesAlive(string atlas) => Resources.FindObjectsOfTypeAll<RenderTexture>()
            .Where(texture => texture.name == "Rill.Colliders." + atlas && texture.IsCreated())
                .Sum(texture => HalfFloat * texture.width * texture.height * texture.volumeDepth);

        static float Height(float2 position) => 2f + Slope * position.x;

        ColliderMotion Ground()
        {
            var heights = new float[GroundSide, GroundSide];
            for (int z = 0; z < GroundSide; z++)
                for (int x = 0; x < GroundSide; x++)
                    heights[z, x] = Spacing * Height(Box.xz * new float2(x, z) / (GroundSide - 1));
            ground = new HeightField(heights, Box.x * Spacing, Box.z * Spacing);
            var pose = new RigidPose(ground.Center / Spacing, quaternion.identity);
            return new ColliderMotion
            {
                shape = ColliderShape.HeightField, size = ground.Extents / Spacing, start = pose, end = pose, contributesDensity = true,
                field = ground.Texture, fieldUnit = 1f / Spacing, minFraction = ground.MinFraction,
            };
        }

        ColliderMotion Ball(int side) => Ball(side, Voxel * Side / side, 0f, Radius, WorldCenter, 0f);

        // Distances in d, as a bake would have them.
        ColliderMotion Ball(int3 sides, float voxel, float3 center, float radius, float3 position, float turn)
        {
            var field = new Texture3D(sides.x, sides.y, sides.z, TextureFormat.RFloat, false) { name = "Ball" };
            made.Add(field);
            NativeArray<float> texels = field.GetPixelData<float>(0);
            for (int i = 0; i < texels.Length; i++)
            {
                float3 point = new float3(i % sides.x, i / sides.x % sides.y, i / (sides.x * sides.y)) + 0.5f;
                texels[i] = math.distance(voxel * (point - 0.5f * (float3)sides), center) - radius;
            }
            field.Apply(false, false);
            var pose = new RigidPose(position, quaternion.AxisAngle(math.normalize(new float3(1f, 2f, 3f)), turn));
            return new ColliderMotion
            {
                shape = ColliderShape.Mesh, size = 0.5f * (float3)sides * voxel, start = pose, end = pose, contributesDensity = true,
                field = field, fieldUnit = 1f, voxel = voxel,
            };
        }
    }
}
