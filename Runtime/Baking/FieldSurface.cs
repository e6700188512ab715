using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>The surface of a signed distance field in patches, for sums over it.</summary>
    static class FieldSurface
    {
        const int Bins = 8;         // along a side of the field's volume
        const int Directions = 6;   // that a patch looks along, mostly

        /// <summary>Patches in the frame of the mesh: of each bin and direction the area as a vector, and its center. Their sum errs by some
        /// percent; none where the texture cannot be read.</summary>
        public static SurfaceSample[] Find(Texture3D texture, Bounds bounds, float voxelSize)
        {
            if (texture == null || !texture.isReadable)
                return System.Array.Empty<SurfaceSample>();
            var voxels = new FieldVoxels(texture);
            var counts = new int3(texture.width, texture.height, texture.depth);
            var sums = new SurfaceSample[Bins * Bins * Bins * Directions];
            var areas = new float[sums.Length];
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++)
                    {
                        // A layer a voxel thick on both sides: each of its voxels has a part of the surface.
                        float distance = voxels[x, y, z] / voxelSize;
                        if (!(math.abs(distance) < 1f))
                            continue;
                        var at = new int3(x, y, z);
                        float3 slope = Slope(voxels, at, counts);
                        float steepness = math.length(slope);
                        if (!(steepness > 1e-4f))
                            continue;
                        float3 normal = slope / steepness;
                        float area = (1f - math.abs(distance)) * voxelSize * voxelSize;
                        int3 bin = at * Bins / counts;
                        int index = ((bin.z * Bins + bin.y) * Bins + bin.x) * Directions + Direction(normal);
                        sums[index].position += area * ((float3)bounds.min + ((float3)at + 0.5f - distance * normal) * voxelSize);
                        sums[index].area += area * normal;
                        areas[index] += area;
                    }
            var patches = new List<SurfaceSample>();
            for (int i = 0; i < sums.Length; i++)
                if (areas[i] > 0f)
                    patches.Add(new SurfaceSample { position = sums[i].position / areas[i], area = sums[i].area });
            return patches.ToArray();
        }

        static float3 Slope(in FieldVoxels voxels, int3 at, int3 counts)
        {
            int3 low = math.max(at - 1, 0), high = math.min(at + 1, counts - 1);
            return new float3(voxels[high.x, at.y, at.z] - voxels[low.x, at.y, at.z], voxels[at.x, high.y, at.z] - voxels[at.x, low.y, at.z],
                voxels[at.x, at.y, high.z] - voxels[at.x, at.y, low.z]);
        }

        static int Direction(float3 normal)
        {
            float3 size = math.abs(normal);
            int axis = size.x >= math.max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
            return 2 * axis + (normal[axis] > 0f ? 1 : 0);
        }
    }
}
