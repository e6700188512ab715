using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The ground as a collider. A box of 24 x 20 x 24 d over it, d = 5 cm.</summary>
    public class HeightFieldTests
    {
        const float Spacing = 0.05f;
        static readonly float3 Box = new float3(24f, 20f, 24f);

        HeightField ground;

        [TearDown]
        public void DisposeGround() => ground?.Dispose();

        [Test]
        public void Ground_that_leans_is_as_far_away_as_the_plane_that_it_is()
        {
            Func<float2, float> height = p => 3f + 0.5f * p.x - 0.25f * p.y;
            using (TestFluid fluid = Fluid(DeepWater.Off, height))
            {
                fluid.Input.gravity = 0f;
                var random = new Unity.Mathematics.Random(3u);
                fluid.Add(Enumerable.Range(0, 1000).Select(_ => random.NextFloat3(0.6f, Box - 0.6f) * Spacing).ToArray());
                fluid.Step();
                GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
                ParticleState state = fluid.Read();
                float[] distances = GpuTest.Read<float>(fluid.Solver.Colliders.ContactOffsets, state.Count);
                float3 normal = math.normalize(new float3(-0.5f, 1f, 0.25f));
                int near = 0;
                for (int i = 0; i < state.Count; i++)
                {
                    float wanted = math.min((state.positions[i].y - height(state.positions[i].xz)) * normal.y, 2f);
                    Assert.That(distances[i], Is.EqualTo(wanted).Within(0.02f + 0.004f * math.abs(wanted)), $"at {state.positions[i].xyz}");
                    near += math.abs(wanted) < 1.9f ? 1 : 0;
                }
                Assert.That(near, Is.GreaterThan(50));
            }
        }

        [Test, Category("LongRun")]
        public void Water_lies_on_hills_and_in_valleys_and_none_gets_under_them([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            Func<float2, float> height = p => 5f + 3f * math.sin(0.5f * p.x) * math.cos(0.4f * p.y);
            using (TestFluid fluid = Fluid(deepWater, height))
            {
                ParticleState block = ParticleState.Lattice(0f, 0.5f, (int3)new float3(24f, 16f, 24f), 0.02f);
                fluid.Add(block.positions.Select(p => p.xyz).Where(p => p.y > height(p.xz) + 0.7f && p.y < 14f).Select(p => p * Spacing).ToArray());
                FluidStatistics statistics = fluid.Step(120).MeasureWhole();
                ParticleState state = fluid.Read();
                Assert.That(state.positions.Min(p => p.y - height(p.xz)), Is.GreaterThan(0.3f), "above the ground");
                float[] heights = state.positions.Select(p => p.y).OrderByDescending(y => y).ToArray();
                TestContext.Out.WriteLine($"highest {heights[0]:0.00} d, all but three below {heights[3]:0.00} d of {heights.Length}");
                Assert.That(heights[3], Is.InRange(12f, 15f), "the surface is level, but for three that may still fly");
                Assert.That(statistics.densityError, Is.LessThan(deepWater == DeepWater.On ? 0.01f : 0.05f));
                Assert.That(statistics.jitter, Is.LessThan(0.1f));
            }
        }

        [Test]
        public void What_flies_at_a_steep_ridge_does_not_get_through()
        {
            // 2 d across at the top, its sides 4 to 1: a step is 33 d.
            Func<float2, float> height = p => math.clamp(16f - 4f * (math.abs(p.x - 14f) - 1f), 0.5f, 16f);
            using (TestFluid fluid = Fluid(DeepWater.Off, height))
            {
                fluid.Input.gravity = 0f;
                fluid.AddBlock(new float3(2f, 3f, 4f) * Spacing, new float3(3f, 3f, 12f) * Spacing, new float3(100f, 0f, 0f));
                for (int i = 0; i < 6; i++)
                {
                    fluid.Step();
                    ParticleState state = fluid.Read();
                    Assert.That(state.positions.Min(p => p.y - height(p.xz)), Is.GreaterThan(-0.05f));
                    if (i == 0)
                        Assert.That(state.positions.Max(p => p.x), Is.LessThan(14f), "on the near side");
                }
                fluid.MeasureWhole();
            }
        }

        [Test]
        public void A_steep_place_does_not_raise_the_ground_elsewhere()
        {
            Func<float2, float> height = p => math.clamp(16f - 4f * (math.abs(p.x - 20f) - 1f), 4f, 16f);
            using (TestFluid fluid = Fluid(DeepWater.Off, height))
            {
                fluid.Input.gravity = 0f;
                fluid.Add(new[] { new float3(6f, 5f, 4f) * Spacing }, new float3(0f, 0f, 10f));
                fluid.Add(new[] { new float3(12f, 10f, 12f) * Spacing }, new float3(0f, -30f, 0f));
                ParticleState state = fluid.Step().Read();
                float4 along = state.positions.Single(p => p.x < 8f), down = state.positions.Single(p => p.x > 8f);
                Assert.That(along.z, Is.EqualTo(4f + 10f / 60f / Spacing).Within(1e-3f), "a spacing over the ground nothing stops it");
                Assert.That(along.y, Is.EqualTo(5f).Within(1e-3f));
                Assert.That(down.y, Is.EqualTo(4.5f).Within(0.05f), "lands on the ground");
            }
        }

        [Test]
        public void There_is_no_ground_beside_it()
        {
            using (TestFluid fluid = Fluid(DeepWater.Off, p => 8f, 12f))
            {
                fluid.AddBlock(new float3(15f, 9f, 4f) * Spacing, new float3(4f, 3f, 12f) * Spacing);
                fluid.AddBlock(new float3(4f, 9f, 8f) * Spacing, new float3(4f, 2f, 4f) * Spacing);
                ParticleState state = fluid.Step(60).Read();
                Assert.That(state.positions.Count(p => p.x > 12.5f && p.y < 3f), Is.GreaterThan(100), "fell beside it");
                Assert.That(state.positions.Where(p => p.x < 11f).Min(p => p.y), Is.GreaterThan(8.3f), "lies on it");
                Assert.That(state.positions.Where(p => p.y < 8f).Min(p => p.x), Is.GreaterThan(12.3f), "stopped by its side");
            }
        }

        [Test]
        public void Heights_that_are_no_ground_are_refused_by_name()
        {
            var heights = new float[3, 3];
            heights[1, 2] = float.NaN;
            Assert.That(() => new HeightField(heights, 1f, 1f), Throws.ArgumentException.With.Message.Contains("height at [1, 2] is NaN"));
            Assert.That(() => new HeightField(new float[1, 3], 1f, 1f), Throws.ArgumentException.With.Message.Contains("not 3 x 1"));
            Assert.That(() => new HeightField(new float[2, 2049], 1f, 1f), Throws.ArgumentException.With.Message.Contains("2048"));
            Assert.That(() => new HeightField(new float[2, 2], 0f, 1f), Throws.ArgumentException.With.Message.Contains("width is 0"));
            Assert.That(() => new HeightField(new float[2, 2], 1f, 1f, new Vector3(0f, float.NaN, 0f)),
                Throws.ArgumentException.With.Message.Contains("origin"));
            Assert.That(() => new HeightField(null, 1f, 1f), Throws.ArgumentNullException);
        }

        [Test]
        public void A_collider_without_its_heights_is_left_out_and_says_so_once()
        {
            var thing = new GameObject("Ground");
            var collider = thing.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.HeightField;
            LogAssert.Expect(LogType.Error, new Regex("'Ground' is left out: it is a height field without heights"));
            Assert.That(collider.TryDescribe(out _), Is.False);
            Assert.That(collider.TryDescribe(out _), Is.False);
            collider.Heights = ground = new HeightField(new float[2, 2], 4f, 2f, new Vector3(1f, 0f, 0f));
            Assert.That(collider.TryDescribe(out ColliderMotion motion), Is.True);
            Assert.That((Vector3)motion.end.position, Is.EqualTo(new Vector3(3f, 0f, 1f)));
            ground.Dispose();
            LogAssert.Expect(LogType.Error, new Regex("its heights were disposed of"));
            Assert.That(collider.TryDescribe(out _), Is.False);
            UnityEngine.Object.DestroyImmediate(thing);
        }

        // Ground under the box, or under the first of it along x; heights and places in d.
        TestFluid Fluid(DeepWater deepWater, Func<float2, float> height, float width = 24f)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            var fluid = new TestFluid(Box * Spacing, Spacing, 8000, settings);
            const int Count = 97;
            var heights = new float[Count, Count];
            for (int z = 0; z < Count; z++)
                for (int x = 0; x < Count; x++)
                    heights[z, x] = Spacing * height(new float2(width, Box.z) * new float2(x, z) / (Count - 1));
            ground = new HeightField(heights, width * Spacing, Box.z * Spacing);
            var pose = new RigidPose(ground.Center / Spacing, quaternion.identity);
            ColliderTests.Use(fluid, new ColliderMotion
            {
                shape = ColliderShape.HeightField,
                size = ground.Extents / Spacing,
                start = pose,
                end = pose,
                contributesDensity = true,
                field = ground.Texture,
                fieldUnit = 1f / Spacing,
                minFraction = ground.MinFraction,
            });
            return fluid;
        }
    }
}
