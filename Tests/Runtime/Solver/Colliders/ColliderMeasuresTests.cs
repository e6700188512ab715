using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Volumes and widths of colliders, against counted points of a lattice.</summary>
    public class ColliderMeasuresTests
    {
        const int Half = 40;
        const float Cell = 0.1f;

        [Test]
        public void Volume_and_width_are_those_of_the_points_inside([Values(ColliderShape.Sphere, ColliderShape.Box,
            ColliderShape.Capsule)] ColliderShape kind)
        {
            ColliderMotion shape = ColliderTests.Still(kind, new float3(1.5f, 1f, 0.8f), 0f, quaternion.Euler(0.3f, 0.5f, 0.2f));
            float3 direction = math.normalize(new float3(0.3f, 1f, 0.2f));
            int inside = 0;
            float reach = 0f;
            for (int x = -Half; x < Half; x++)
                for (int y = -Half; y < Half; y++)
                    for (int z = -Half; z < Half; z++)
                    {
                        float3 p = (new float3(x, y, z) + 0.5f) * Cell;
                        if (Reference.Shapes.Distance(shape, p) > 0.0)
                            continue;
                        inside++;
                        reach = math.max(reach, math.dot(p, direction));
                    }
            float volume = inside * Cell * Cell * Cell;
            Assert.That(ColliderMeasures.Volume(shape), Is.EqualTo(volume).Within(0.02f * volume));
            Assert.That(ColliderMeasures.Width(shape, direction), Is.EqualTo(2f * reach).Within(3f * Cell));
        }

        [Test]
        public void The_volume_of_a_field_is_that_inside_its_surface()
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.voxelSize = 0.1f;
            settings.padding = 2;
            var grid = new SdfGrid(new Bounds(Vector3.zero, Vector3.one * 2f), settings, false);
            var distances = new float[grid.VoxelCount];
            for (int i = 0; i < distances.Length; i++)
            {
                var voxel = new float3(i % grid.Resolution.x, i / grid.Resolution.x % grid.Resolution.y, i / (grid.Resolution.x * grid.Resolution.y));
                distances[i] = math.length(grid.Min + (voxel + 0.5f) * grid.VoxelSize) - 1f;
            }
            SignedDistanceField field = SignedDistanceField.Create(new SdfBake("Ball", grid, distances, settings, MeshSdfSign.WindingNumber, 0));
            Assert.That(field.Volume, Is.EqualTo(4f / 3f * math.PI).Within(0.02f));
            Texture3D texture = field.Texture;
            Object.DestroyImmediate(field);
            Object.DestroyImmediate(texture);
        }
    }
}
