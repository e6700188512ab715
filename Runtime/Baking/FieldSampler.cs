using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Distances of a <see cref="SignedDistanceField"/> at any point; valid until its texture changes.</summary>
    readonly struct FieldSampler
    {
        readonly FieldVoxels voxels;
        readonly float3 low, high;
        readonly int3 last;
        readonly float voxelSize;

        /// <param name="texture">Readable.</param>
        /// <param name="voxelSize">m, above 0.</param>
        public FieldSampler(Texture3D texture, Bounds bounds, float voxelSize)
        {
            voxels = new FieldVoxels(texture);
            low = bounds.min;
            high = bounds.max;
            last = new int3(texture.width, texture.height, texture.depth) - 1;
            this.voxelSize = voxelSize;
        }

        /// <summary>Samples the field like <see cref="SignedDistanceField.TrySample"/>.</summary>
        public bool TrySample(float3 local, out float distance)
        {
            distance = float.PositiveInfinity;
            if (!math.all(math.isfinite(local)))
                return false;
            float3 inside = math.clamp(local, low, high);
            float3 at = math.clamp((inside - low) / voxelSize - 0.5f, 0f, last);
            int3 a = math.min((int3)math.floor(at), last), b = math.min(a + 1, last);
            float3 weight = at - a;

            float4 row = math.lerp(
                new float4(voxels[a.x, a.y, a.z], voxels[a.x, b.y, a.z], voxels[a.x, a.y, b.z], voxels[a.x, b.y, b.z]),
                new float4(voxels[b.x, a.y, a.z], voxels[b.x, b.y, a.z], voxels[b.x, a.y, b.z], voxels[b.x, b.y, b.z]), weight.x);
            float2 plane = math.lerp(row.xz, row.yw, weight.y);
            distance = math.lerp(plane.x, plane.y, weight.z) + math.distance(local, inside);
            return true;
        }
    }

    /// <summary>The copy in memory of a field's texture.</summary>
    readonly struct FieldVoxels
    {
        readonly NativeArray<ushort> halves;
        readonly NativeArray<float> floats;
        readonly int width, height;

        public FieldVoxels(Texture3D texture)
        {
            bool isHalf = texture.format == TextureFormat.RHalf;
            halves = isHalf ? texture.GetPixelData<ushort>(0) : default;
            floats = isHalf ? default : texture.GetPixelData<float>(0);
            width = texture.width;
            height = texture.height;
        }

        public float this[int x, int y, int z]
        {
            get
            {
                int index = (z * height + y) * width + x;
                return halves.IsCreated ? Mathf.HalfToFloat(halves[index]) : floats[index];
            }
        }
    }
}
