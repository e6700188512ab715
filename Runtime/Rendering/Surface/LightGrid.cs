using UnityEngine;

namespace Rill
{
    /// <summary>A grid of parallel rays of light through a fluid's box, square across the light, in the domain's frame, d.</summary>
    readonly struct LightGrid
    {
        const float TexelSize = 0.25f;      // d, or more where the grid would be too large
        const int SizeStep = 32;            // texels: a light that turns slowly must not ask for another texture in each frame

        /// <summary>(p, 1) times these: x and y in the grid, texels.</summary>
        public readonly Vector4 AxisX, AxisY;

        /// <summary>Before the box, of the ray at (0, 0), and from each ray to the next.</summary>
        public readonly Vector3 Origin, StepX, StepY;

        /// <summary>Texels.</summary>
        public readonly int Width, Height;

        /// <param name="light">Unit, towards the light.</param>
        /// <param name="above">How far before the box rays begin.</param>
        /// <param name="maxTexels">Along a side.</param>
        public LightGrid(Vector3 light, Vector3 box, float above, int maxTexels)
        {
            Vector3 x = Vector3.Cross(light, Mathf.Abs(light.y) < 0.9f ? Vector3.up : Vector3.right).normalized;
            Vector3 y = Vector3.Cross(light, x);
            Vector2 alongX = Extent(x, box), alongY = Extent(y, box);
            float texel = Mathf.Max(TexelSize, Mathf.Max(alongX.y - alongX.x, alongY.y - alongY.x) / (maxTexels - 2));
            Width = Mathf.Min(Steps((alongX.y - alongX.x) / texel + 2f), maxTexels);
            Height = Mathf.Min(Steps((alongY.y - alongY.x) / texel + 2f), maxTexels);
            // The box in the center.
            float left = 0.5f * (alongX.x + alongX.y) - 0.5f * Width * texel, bottom = 0.5f * (alongY.x + alongY.y) - 0.5f * Height * texel;
            AxisX = x / texel;
            AxisX.w = -left / texel;
            AxisY = y / texel;
            AxisY.w = -bottom / texel;
            Origin = x * left + y * bottom + light * (Extent(light, box).y + above);
            StepX = x * texel;
            StepY = y * texel;
        }

        /// <summary>Returns the lowest and the highest coordinate of a box along an axis, d.</summary>
        public static Vector2 Extent(Vector3 axis, Vector3 box)
        {
            Vector3 reach = Vector3.Scale(axis, box);
            return new Vector2(Mathf.Min(reach.x, 0f) + Mathf.Min(reach.y, 0f) + Mathf.Min(reach.z, 0f),
                Mathf.Max(reach.x, 0f) + Mathf.Max(reach.y, 0f) + Mathf.Max(reach.z, 0f));
        }

        static int Steps(float texels) => (Mathf.CeilToInt(texels) + SizeStep - 1) / SizeStep * SizeStep;
    }
}
