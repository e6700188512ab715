using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Fluid at the start, by shape.</summary>
    public class FluidVolumeTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void A_sphere_is_full_to_its_surface_and_no_further()
        {
            AssertBall(volume =>
            {
                volume.Shape = VolumeShape.Sphere;
                volume.Radius = 0.4f;
            }, new float3(0.1f, 0f, 0f), 0.4f);
        }

        [Test]
        public void The_inside_of_a_field_is_full_where_the_mesh_is_and_as_large_as_the_object([Values(1f, 0.5f, 1.3f)] float scale)
        {
            SignedDistanceField field = BallField(new float3(0.2f, -0.1f, 0f), 0.3f);
            try
            {
                AssertBall(volume =>
                {
                    volume.Shape = VolumeShape.SignedDistanceField;
                    volume.Field = field;
                    volume.transform.localScale = Vector3.one * scale;
                }, new float3(0.1f, 0f, 0f) + scale * new float3(0.2f, -0.1f, 0f), 0.3f * scale);
            }
            finally
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        }

        [Test]
        public void A_negative_scale_fills_the_mirror_image()
        {
            SignedDistanceField field = BallField(new float3(0.2f, -0.1f, 0f), 0.3f);
            try
            {
                AssertBall(volume =>
                {
                    volume.Shape = VolumeShape.SignedDistanceField;
                    volume.Field = field;
                    volume.transform.localScale = new Vector3(-1f, 1f, 1f);
                }, new float3(0.1f, 0f, 0f) + new float3(-0.2f, -0.1f, 0f), 0.3f);
            }
            finally
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        }

        [Test]
        public void A_field_that_is_not_there_or_stretched_is_said_by_name()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 100))
            {
                FluidVolume volume = Volume(scene, v => v.Shape = VolumeShape.SignedDistanceField);
                LogAssert.Expect(LogType.Error, new Regex("FluidVolume 'Ball' was not filled: it has no signed distance field"));
                scene.Fluid.Restart();
                volume.Field = ScriptableObject.CreateInstance<SignedDistanceField>();
                volume.Field.name = "Empty";
                LogAssert.Expect(LogType.Error, new Regex("FluidVolume 'Ball' was not filled: its field 'Empty' has no distances"));
                scene.Fluid.Restart();
                Object.DestroyImmediate(volume.Field);
                volume.Field = BallField(0f, 0.2f);
                volume.transform.localScale = new Vector3(1f, 2f, 1f);
                LogAssert.Expect(LogType.Error, new Regex("FluidVolume 'Ball' was not filled: its scale .* is not the same along all axes"));
                scene.Fluid.Restart();
                Object.DestroyImmediate(volume.Field.Texture);
                Object.DestroyImmediate(volume.Field);
            }
        }

        // To the bit: a scene that is played again begins as it did.
        [Test]
        public void Positions_are_those_of_the_lattice_point_by_point([Values(VolumeShape.Box, VolumeShape.Sphere)] VolumeShape shape)
        {
            var volume = new GameObject("Volume").AddComponent<FluidVolume>();
            try
            {
                volume.transform.SetPositionAndRotation(new Vector3(1f, -2f, 3f), Quaternion.Euler(10f, 20f, 30f));
                volume.Shape = shape;
                volume.Size = new Vector3(0.5f, 0.35f, 0.6f);
                volume.Radius = 0.31f;
                int3 counts = volume.LatticeCounts(Spacing);
                float3 Point(int i) => (float3)(counts - 1) * -0.5f + new float3(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y));
                int[] inside = Enumerable.Range(0, counts.x * counts.y * counts.z)
                    .Where(i => shape == VolumeShape.Box || math.length(Point(i) * Spacing) <= (0.31f - 0.5f * Spacing) * (1f + 1e-4f)).ToArray();
                var random = new Unity.Mathematics.Random(math.hash(new int2(7, inside.Length)) | 1u);
                float4[] expected = inside.Select(i => float3.zero + (Point(i) + random.NextFloat3(-0.02f, 0.02f)) * Spacing)
                    .Select(local => new float4((float3)volume.transform.position + (float3)(volume.transform.rotation * (Vector3)local),
                        0f)).ToArray();
                using (Unity.Collections.NativeArray<float4> positions = volume.CreatePositions(Spacing, 7))
                    Compare.Same("positions", positions.ToArray(), expected);
                Assert.That(expected.Length, Is.GreaterThan(500));
            }
            finally
            {
                Object.DestroyImmediate(volume.gameObject);
            }
        }

        static void AssertBall(Action<FluidVolume> set, float3 center, float radius)
        {
            using (var scene = new SourceScene(new Vector3(2f, 2f, 2f), Spacing, 5000))
            {
                Volume(scene, set);
                scene.Fluid.Restart();
                float[] distances = scene.Read().positions.Select(p => math.distance(p.xyz * Spacing - 1f, center)).ToArray();
                float volume = 4f / 3f * math.PI * radius * radius * radius;
                TestContext.Out.WriteLine(
                    $"{distances.Length} particles, {volume / scene.ParticleVolume:0} by volume, furthest {distances.Max():0.000} m");
                Assert.That(distances.Max(), Is.LessThan(radius - 0.4f * Spacing));
                Assert.That(distances.Max(), Is.GreaterThan(radius - 1.2f * Spacing));
                float whole = math.pow(1f - 0.5f * Spacing / radius, 3f);       // places whose particles are all inside
                Assert.That(distances.Length, Is.EqualTo(whole * volume / scene.ParticleVolume).Within(20).Percent);
            }
        }

        static FluidVolume Volume(SourceScene scene, Action<FluidVolume> set)
        {
            var gameObject = new GameObject("Ball");
            gameObject.transform.SetParent(scene.Fluid.transform, false);
            gameObject.transform.position = new Vector3(0.1f, 0f, 0f);
            var volume = gameObject.AddComponent<FluidVolume>();
            set(volume);
            return volume;
        }

        // Result of a bake of a finely meshed ball.
        static SignedDistanceField BallField(float3 center, float radius)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 24;
            var grid = new SdfGrid(new Bounds(center, Vector3.one * (2f * radius)), settings, false);
            int3 resolution = grid.Resolution;
            var distances = new float[resolution.x * resolution.y * resolution.z];
            for (int i = 0; i < distances.Length; i++)
            {
                var voxel = new float3(i % resolution.x, i / resolution.x % resolution.y, i / (resolution.x * resolution.y));
                distances[i] = math.distance(grid.Min + (voxel + 0.5f) * grid.VoxelSize, center) - radius;
            }
            return SignedDistanceField.Create(new SdfBake("Ball", grid, distances, settings, MeshSdfSign.WindingNumber, 1));
        }
    }
}
