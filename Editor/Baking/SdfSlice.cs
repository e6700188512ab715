using System;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>One layer of voxels across an axis, as numbers and as a picture.</summary>
    readonly struct SdfSlice
    {
        /// <summary>Axes that run to the right, upwards, and through the slice; y is up where it is in the slice.</summary>
        public readonly int Right, Up, Normal;

        SdfSlice(int right, int up, int normal) => (Right, Up, Normal) = (right, up, normal);

        /// <summary>By the axis that they lie across: 0 x, 1 y, 2 z.</summary>
        public static SdfSlice Across(int axis) => axis == 0 ? new SdfSlice(2, 1, 0) : axis == 1 ? new SdfSlice(0, 2, 1) : new SdfSlice(0, 1, 2);

        /// <summary>[up, right] of the voxels of one layer, m.</summary>
        public float[,] Values(SdfVolume volume, int layer)
        {
            Vector3Int n = volume.Resolution, at = default;
            var values = new float[n[Up], n[Right]];
            at[Normal] = layer;
            for (at[Up] = 0; at[Up] < n[Up]; at[Up]++)
                for (at[Right] = 0; at[Right] < n[Right]; at[Right]++)
                    values[at[Up], at[Right]] = volume[at.x, at.y, at.z];
            return values;
        }

        /// <summary>Largest distance of a layer, without its sign, m: what the colors span.</summary>
        public float MaxDistance(SdfVolume volume, int layer)
        {
            float most = 0f;
            foreach (float distance in Values(volume, layer))
                most = math.max(most, math.abs(distance));
            return most;
        }

        /// <summary>Position of a layer's center along its axis, m.</summary>
        public float PositionOf(SdfVolume volume, int layer) => volume.Bounds.min[Normal] + (layer + 0.5f) * volume.VoxelSize;

        /// <summary>Pixels of a picture of the slice whose longer side has so many.</summary>
        public Vector2Int SizeOf(SdfVolume volume, int longest)
        {
            int right = volume.Resolution[Right], up = volume.Resolution[Up], most = math.max(right, up);
            return new Vector2Int(math.max(1, longest * right / most), math.max(1, longest * up / most));
        }

        /// <summary>Colors of a layer, lowest row first, blended between voxels, with a line where the distance is 0.</summary>
        /// <param name="range">Distance of the darkest colors, m, above 0.</param>
        /// <param name="pixels">size.x * size.y of them.</param>
        public void Paint(SdfVolume volume, int layer, float range, Vector2Int size, Color32[] pixels)
        {
            if (pixels.Length != size.x * size.y)
                throw new ArgumentException(Invariant($"{pixels.Length} pixels are not {size.x} x {size.y}."), nameof(pixels));
            Vector3 at = default, low = volume.Bounds.min, extent = volume.Bounds.size;
            at[Normal] = PositionOf(volume, layer);
            float pixel = math.max(extent[Right] / size.x, extent[Up] / size.y);
            for (int y = 0; y < size.y; y++)
                for (int x = 0; x < size.x; x++)
                {
                    at[Right] = low[Right] + (x + 0.5f) / size.x * extent[Right];
                    at[Up] = low[Up] + (y + 0.5f) / size.y * extent[Up];
                    float distance = volume.Sample(at);
                    pixels[y * size.x + x] = math.abs(distance) < 0.75f * pixel ? DistanceColors.Zero : DistanceColors.At(distance / range);
                }
        }
    }
}
