using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>The distances of a field in memory, for pictures: sampling an asset's texture one by one is slower by far.</summary>
    sealed class SdfVolume
    {
        /// <summary>Larger fields are not shown: their copy would take more than 256 MiB.</summary>
        public const long MaxVoxels = 1L << 26;

        readonly float[] distances;

        SdfVolume(string name, Vector3Int resolution, Bounds bounds, float voxelSize, float[] distances)
        {
            Name = name;
            Resolution = resolution;
            Bounds = bounds;
            VoxelSize = voxelSize;
            this.distances = distances;
        }

        public static SdfVolume Of(SdfBake bake) => new SdfVolume(bake.Name, bake.Resolution, bake.Bounds, bake.VoxelSize, bake.Distances);

        /// <param name="problem">Why there is nothing to show; null where there is.</param>
        /// <returns>Null for a field without distances that can be read.</returns>
        public static SdfVolume Of(SignedDistanceField field, out string problem)
        {
            if (!field.Validate(out problem))
                return null;
            Vector3Int n = field.Resolution;
            if (!field.Texture.isReadable)
                problem = $"The texture of '{field.name}' cannot be read by scripts: bake it again.";
            else if ((long)n.x * n.y * n.z > MaxVoxels)
                problem = Invariant($"{n.x} x {n.y} x {n.z} voxels are too many for a preview.");
            if (problem != null)
                return null;

            var distances = new float[n.x * n.y * n.z];
            if (field.Texture.format == TextureFormat.RFloat)
                field.Texture.GetPixelData<float>(0).CopyTo(distances);
            else
            {
                NativeArray<ushort> halves = field.Texture.GetPixelData<ushort>(0);
                for (int i = 0; i < distances.Length; i++)
                    distances[i] = Mathf.HalfToFloat(halves[i]);
            }
            return new SdfVolume(field.name, n, field.Bounds, field.VoxelSize, distances);
        }

        public string Name { get; }

        /// <summary>Voxels along each axis.</summary>
        public Vector3Int Resolution { get; }

        /// <summary>m.</summary>
        public Bounds Bounds { get; }

        /// <summary>m.</summary>
        public float VoxelSize { get; }

        public float this[int x, int y, int z] => distances[(z * Resolution.y + y) * Resolution.x + x];

        /// <summary>Distance, m, trilinear between the voxels' centers; beyond the outermost of them theirs.</summary>
        /// <param name="local">In the frame of the mesh, m.</param>
        public float Sample(float3 local)
        {
            int3 last = new int3(Resolution.x, Resolution.y, Resolution.z) - 1;
            float3 at = math.clamp((local - (float3)Bounds.min) / VoxelSize - 0.5f, 0f, last);
            int3 a = (int3)at, b = math.min(a + 1, last);
            float3 weight = at - a;
            float4 row = math.lerp(
                new float4(this[a.x, a.y, a.z], this[a.x, b.y, a.z], this[a.x, a.y, b.z], this[a.x, b.y, b.z]),
                new float4(this[b.x, a.y, a.z], this[b.x, b.y, a.z], this[b.x, a.y, b.z], this[b.x, b.y, b.z]), weight.x);
            float2 plane = math.lerp(row.xz, row.yw, weight.y);
            return math.lerp(plane.x, plane.y, weight.z);
        }

        /// <summary>The direction in which the distance grows, from voxels on both sides; 0 where it does in none.</summary>
        public float3 Normal(float3 local)
        {
            float h = 0.75f * VoxelSize;
            float3 x = new float3(h, 0f, 0f), y = new float3(0f, h, 0f), z = new float3(0f, 0f, h);
            return math.normalizesafe(new float3(Sample(local + x) - Sample(local - x), Sample(local + y) - Sample(local - y),
                Sample(local + z) - Sample(local - z)));
        }
    }
}
