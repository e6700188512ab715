using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Ground by its heights over a rectangle: set as <see cref="FluidCollider.Heights"/>. All below it is solid, however deep.</summary>
    /// <remarks>
    /// Between four heights the ground is bilinear. The solver keeps heights as half floats over their center: they are off by at
    /// most 1/4096 of what they span. Along a normal the distance is that from the plane that touches the ground below a point.
    /// </remarks>
    public sealed class HeightField : IDisposable
    {
        /// <summary>Most heights along a side, as of a 3D texture.</summary>
        public const int MaxHeights = 2048;

        /// <param name="heights">[z, x], m, upwards.</param>
        /// <param name="width">From the first to the last height along x, m, above 0.</param>
        /// <param name="length">From the first to the last height along z, m, above 0.</param>
        /// <param name="origin">Position of the first height, from the object's position, m; its y adds to all heights.</param>
        /// <exception cref="ArgumentNullException">No heights.</exception>
        /// <exception cref="ArgumentException">Fewer than 2 or more than <see cref="MaxHeights"/> along a side, a side that is not a length,
        /// or a height that is not finite; the message says which.</exception>
        public HeightField(float[,] heights, float width, float length, Vector3 origin = default)
        {
            if (heights == null)
                throw new ArgumentNullException(nameof(heights));
            int2 counts = new int2(heights.GetLength(1), heights.GetLength(0));
            if (math.any(counts < 2) || math.any(counts > MaxHeights))
                throw new ArgumentException(Invariant($"A height field has 2 to {MaxHeights} heights along a side, not {counts.x} x ") +
                    Invariant($"{counts.y}. Take every second, or a part of the ground."), nameof(heights));
            CheckSide(width, nameof(width));
            CheckSide(length, nameof(length));
            if (!math.all(math.isfinite((float3)origin)))
                throw new ArgumentException(Invariant($"A height field's origin is {origin}. Set it to numbers."), nameof(origin));
            FindSpan(heights, out float lowest, out float highest);
            float center = 0.5f * (lowest + highest);
            float2 spacing = new float2(width, length) / (counts - 1);
            Center = (float3)origin + new float3(0.5f * width, center, 0.5f * length);
            Extents = new float3(0.5f * width, highest - center, 0.5f * length);
            MinFraction = 1f / math.sqrt(1f + SteepestSquared(heights, spacing));
            Texture = new Texture3D(counts.x, 1, counts.y, TextureFormat.RFloat, false)
            {
                name = "Rill.HeightField",
                hideFlags = HideFlags.HideAndDontSave
            };
            NativeArray<float> texels = Texture.GetPixelData<float>(0);
            for (int z = 0; z < counts.y; z++)
                for (int x = 0; x < counts.x; x++)
                    texels[z * counts.x + x] = heights[z, x] - center;
            Texture.Apply(false, false);        // stays readable: bodies on the ground look at it
        }

        /// <summary>Center of the rectangle at the center of its heights, from the object's position, m.</summary>
        internal float3 Center { get; }

        /// <summary>Half sides along x and z, and half of what the heights span, m.</summary>
        internal float3 Extents { get; }

        /// <summary>Fraction of a height over the ground that is free on all sides even at its steepest point.</summary>
        internal float MinFraction { get; }

        /// <summary>Heights over <see cref="Center"/>, m; null once disposed of.</summary>
        internal Texture3D Texture { get; private set; }

        /// <summary>Frees the texture; a collider that still has these heights is left out, which is logged.</summary>
        public void Dispose()
        {
            if (Texture != null)
                UnityEngine.Object.DestroyImmediate(Texture);       // nothing else can hold it
            Texture = null;
        }

        static void CheckSide(float side, string name)
        {
            if (!(side > 0f) || float.IsInfinity(side))
                throw new ArgumentException(Invariant($"A height field's {name} is {side} m. Give one above 0."), name);
        }

        static void FindSpan(float[,] heights, out float lowest, out float highest)
        {
            lowest = float.PositiveInfinity;
            highest = float.NegativeInfinity;
            for (int z = 0; z < heights.GetLength(0); z++)
                for (int x = 0; x < heights.GetLength(1); x++)
                {
                    float height = heights[z, x];
                    if (float.IsNaN(height) || float.IsInfinity(height))
                        throw new ArgumentException(Invariant($"The height at [{z}, {x}] is {height}. Set it to a ") +
                            "number.", nameof(heights));
                    lowest = math.min(lowest, height);
                    highest = math.max(highest, height);
                }
        }

        // Square of the largest slope of a bilinear patch: at its corners, of one edge along each axis.
        static float SteepestSquared(float[,] heights, float2 spacing)
        {
            float steepest = 0f;
            for (int z = 0; z + 1 < heights.GetLength(0); z++)
                for (int x = 0; x + 1 < heights.GetLength(1); x++)
                {
                    float near = heights[z, x + 1] - heights[z, x], far = heights[z + 1, x + 1] - heights[z + 1, x];
                    float left = heights[z + 1, x] - heights[z, x], right = heights[z + 1, x + 1] - heights[z, x + 1];
                    float2 slope = math.max(math.abs(new float2(near, left)), math.abs(new float2(far, right))) / spacing;
                    steepest = math.max(steepest, math.lengthsq(slope));
                }
            return steepest;
        }
    }
}
