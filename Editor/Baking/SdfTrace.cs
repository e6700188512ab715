using System;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>
    /// A picture of a field's surface, found by sphere tracing (Hart 1996) on the CPU: the same in every render pipeline and
    /// without a window, and quick enough for a preview.
    /// </summary>
    static class SdfTrace
    {
        const int MaxSteps = 200;
        // Fraction of the distance that a step goes: blended voxels overestimate it a little around edges.
        const float Caution = 0.9f;
        // Voxels: a step's least, and what counts as arrived.
        const float MinStep = 0.05f, Arrived = 0.02f;

        static readonly float3 Light = math.normalize(new float3(-0.4f, 0.8f, -0.6f));
        static readonly float3 Surface = new float3(0.72f, 0.80f, 0.86f);

        public static readonly Color32 Background = new Color32(49, 49, 49, 255);

        /// <summary>All of the field from far away, in parallel rays.</summary>
        /// <param name="yaw">About the vertical axis, degrees; 0 looks along +z.</param>
        /// <param name="pitch">Downwards, degrees.</param>
        /// <param name="pixels">size.x * size.y of them, lowest row first.</param>
        public static void Paint(SdfVolume volume, float yaw, float pitch, Vector2Int size, Color32[] pixels)
        {
            if (pixels.Length != size.x * size.y)
                throw new ArgumentException(Invariant($"{pixels.Length} pixels are not {size.x} x {size.y}."), nameof(pixels));
            quaternion look = math.mul(quaternion.RotateY(math.radians(yaw)), quaternion.RotateX(math.radians(pitch)));
            float3 right = math.mul(look, new float3(1f, 0f, 0f)), up = math.mul(look, new float3(0f, 1f, 0f)),
                along = math.mul(look, new float3(0f, 0f, 1f));
            float radius = 0.5f * math.length((float3)volume.Bounds.size), pixel = 2f * radius / math.min(size.x, size.y);
            float3 light = math.mul(look, Light);
            for (int y = 0; y < size.y; y++)
                for (int x = 0; x < size.x; x++)
                {
                    float3 from = (float3)volume.Bounds.center - 2f * radius * along
                        + pixel * ((x + 0.5f - 0.5f * size.x) * right + (y + 0.5f - 0.5f * size.y) * up);
                    pixels[y * size.x + x] = TryHit(volume, from, along, out float3 hit) ? Shade(volume.Normal(hit), light) : Background;
                }
        }

        /// <summary>The first place along a ray where the distance is 0, or has become negative.</summary>
        /// <param name="along">Direction, of length 1.</param>
        public static bool TryHit(SdfVolume volume, float3 from, float3 along, out float3 hit)
        {
            hit = default;
            if (!TryEnter(volume.Bounds, from, along, out float t, out float end))
                return false;
            float before = t;
            for (int step = 0; step < MaxSteps && t <= end; step++)
            {
                float distance = volume.Sample(from + t * along);
                if (distance < 0f)
                    t = Crossing(volume, from, along, before, t);
                if (distance < Arrived * volume.VoxelSize)
                {
                    hit = from + t * along;
                    return true;
                }
                before = t;
                t += math.max(Caution * distance, MinStep * volume.VoxelSize);
            }
            return false;
        }

        // Halves the interval in which the sign changed.
        static float Crossing(SdfVolume volume, float3 from, float3 along, float outside, float inside)
        {
            for (int i = 0; i < 8; i++)
            {
                float mid = 0.5f * (outside + inside);
                if (volume.Sample(from + mid * along) < 0f)
                    inside = mid;
                else
                    outside = mid;
            }
            return inside;
        }

        static bool TryEnter(Bounds bounds, float3 from, float3 along, out float start, out float end)
        {
            // An axis along which the ray does not move gives infinities, which compare as they should.
            float3 a = ((float3)bounds.min - from) / along, b = ((float3)bounds.max - from) / along;
            start = math.max(math.cmax(math.min(a, b)), 0f);
            end = math.cmin(math.max(a, b));
            return start < end;
        }

        static Color32 Shade(float3 normal, float3 light)
        {
            float3 linear = Surface * (0.25f + 0.75f * math.saturate(math.dot(normal, light)));
            return new Color32((byte)(255f * linear.x), (byte)(255f * linear.y), (byte)(255f * linear.z), 255);
        }
    }
}
