using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Thin closed vessels of signed distance fields that are shaken and turned: what is in them stays in them.</summary>
    [Category("LongRun")]
    public class ContainerTests
    {
        const float Spacing = 0.05f;
        const float Voxel = 0.5f;           // d
        const float Radius = 7f, Half = 8f; // of the can, inside, d

        // A second of fluid time is 60 steps; the minute that the bar asks for was run with Seconds = 60.
        [TestCase(0.25f, DeepWater.On)]
        [TestCase(0.25f, DeepWater.Off)]
        [TestCase(1f, DeepWater.On, Category = "GpuOnly")]
        [TestCase(1f, DeepWater.Off, Category = "GpuOnly")]
        public void A_shaken_can_with_a_thin_wall_holds_its_water(float wall, DeepWater deepWater)
        {
            Texture3D can = Can(wall, out float3 halfSize);
            try
            {
                SolverSettings settings = SolverSettings.Default;
                settings.deepWater = deepWater;
                settings.iterations = 2;
                using (var fluid = new TestFluid(48f * Spacing, Spacing, 2000, settings))
                {
                    ColliderMotion motion = ColliderTests.Still(ColliderShape.Mesh, halfSize, 24f, quaternion.identity);
                    motion.field = can;
                    motion.voxel = Voxel;
                    motion.fieldUnit = 1f;
                    fluid.AddBlock(new float3(20f, 17f, 20f) * Spacing, new float3(8f, 12f, 8f) * Spacing);
                    for (int step = 1; step <= Seconds * 60; step++)
                    {
                        motion.start = motion.end;
                        motion.end = Shaken(step / 60f);
                        ColliderTests.Use(fluid, motion);
                        fluid.Step();
                        if (step % 30 == 0)
                            AssertInside(fluid, motion.end, $"after {step} steps");
                    }
                    Assert.That(fluid.Alive, Is.EqualTo(fluid.Added));
                }
            }
            finally
            {
                Object.DestroyImmediate(can);
            }
        }

        static float Seconds => 2f;

        // 0.3 m to and fro and 0.15 m up and down, up to 4 g, while it turns over.
        static RigidPose Shaken(float time)
        {
            float ease = math.saturate(time);
            float3 position = 24f + ease * new float3(6f * math.sin(11f * time), 3f * math.sin(17f * time), 4f * math.sin(7f * time));
            return new RigidPose(position, quaternion.Euler(ease * 1.5f * math.sin(2f * time), 0.7f * time, ease * 2.5f * math.sin(3f * time)));
        }

        static void AssertInside(TestFluid fluid, RigidPose can, string when)
        {
            foreach (float4 p in fluid.Read().positions)
            {
                float3 local = math.mul(math.conjugate(can.rotation), p.xyz - can.position);
                if (math.length(local.xz) > Radius - 0.3f || math.abs(local.y) > Half - 0.3f)
                    Assert.Fail($"a particle is at {local} in the can's frame {when}");
            }
        }

        // A cylinder around y whose wall lies outside Radius and Half.
        static Texture3D Can(float wall, out float3 halfSize)
        {
            const float padding = 2f;
            int3 counts = (int3)math.ceil(2f * (new float3(Radius, Half, Radius) + wall + padding) / Voxel);
            halfSize = 0.5f * Voxel * (float3)counts;
            var distances = new float[counts.x * counts.y * counts.z];
            for (int i = 0; i < distances.Length; i++)
            {
                var voxel = new int3(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y));
                float3 p = ((float3)voxel + 0.5f) * Voxel - halfSize;
                float2 beyond = new float2(math.length(p.xz) - Radius - 0.5f * wall, math.abs(p.y) - Half - 0.5f * wall);
                float cylinder = math.length(math.max(beyond, 0f)) + Math.Min(math.cmax(beyond), 0f);
                distances[i] = math.abs(cylinder) - 0.5f * wall;
            }
            var texture = new Texture3D(counts.x, counts.y, counts.z, TextureFormat.RFloat, false);
            texture.SetPixelData(distances, 0);
            texture.Apply(false, false);
            return texture;
        }
    }
}
