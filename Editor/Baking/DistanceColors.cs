using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>How signed distances are colored: blue inside, orange outside, dark far from the surface, black at 0.</summary>
    static class DistanceColors
    {
        // The two halves do not meet in one color, so that the sign of the smallest distance shows.
        static readonly (float Fraction, Color32 Color)[] stops =
        {
            (-1f, new Color32(0x08, 0x30, 0x6B, 255)), (-0.4f, new Color32(0x2B, 0x7B, 0xBA, 255)), (0f, new Color32(0xD6, 0xE6, 0xF4, 255)),
            (0f, new Color32(0xFD, 0xEB, 0xD5, 255)), (0.4f, new Color32(0xEE, 0x7F, 0x26, 255)), (1f, new Color32(0x7F, 0x27, 0x04, 255)),
        };

        public static readonly Color32 Zero = new Color32(0, 0, 0, 255);

        /// <summary>Colors between which is blended, by the distance's fraction of the largest, -1 to 1. Two at 0: inside's comes first.</summary>
        public static IReadOnlyList<(float Fraction, Color32 Color)> Stops => stops;

        /// <param name="fraction">Distance over the largest, negative inside; beyond 1 as at 1.</param>
        public static Color32 At(float fraction)
        {
            int half = fraction < 0f ? 0 : stops.Length / 2, last = half + stops.Length / 2 - 1;
            fraction = math.clamp(fraction, -1f, 1f);
            int next = half + 1;
            while (next < last && stops[next].Fraction < fraction)
                next++;
            return Color32.Lerp(stops[next - 1].Color, stops[next].Color, math.unlerp(stops[next - 1].Fraction, stops[next].Fraction, fraction));
        }
    }
}
