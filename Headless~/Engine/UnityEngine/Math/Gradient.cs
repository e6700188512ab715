using System;
using System.Linq;

namespace UnityEngine
{
    public class Gradient : IEquatable<Gradient>
    {
        GradientColorKey[] colors = { new GradientColorKey(Color.white, 0), new GradientColorKey(Color.white, 1) };
        GradientAlphaKey[] alphas = { new GradientAlphaKey(1, 0), new GradientAlphaKey(1, 1) };

        public Gradient() { }

        public GradientMode mode { get; set; }
        public ColorSpace colorSpace { get; set; } = ColorSpace.Uninitialized;
        public GradientColorKey[] colorKeys { get => (GradientColorKey[])colors.Clone(); set => colors = Checked(value, k => k.time, "color"); }
        public GradientAlphaKey[] alphaKeys { get => (GradientAlphaKey[])alphas.Clone(); set => alphas = Checked(value, k => k.time, "alpha"); }

        public void SetKeys(GradientColorKey[] colorKeys, GradientAlphaKey[] alphaKeys)
        {
            this.colorKeys = colorKeys;
            this.alphaKeys = alphaKeys;
        }

        static T[] Checked<T>(T[] keys, Func<T, float> time, string kind)
        {
            if (keys == null || keys.Length == 0 || keys.Length > 8)
                throw new ArgumentException($"A gradient takes 1 to 8 {kind} keys, not {keys?.Length ?? 0}.");
            return keys.OrderBy(time).ToArray();
        }

        public Color Evaluate(float time)
        {
            time = Mathf.Clamp01(time);
            Color color = EvaluateColor(time);
            color.a = EvaluateAlpha(time);
            return color;
        }

        Color EvaluateColor(float time)
        {
            int after = Array.FindIndex(colors, k => k.time >= time);
            if (after == 0) return colors[0].color;
            if (after < 0) return colors[colors.Length - 1].color;
            if (mode == GradientMode.Fixed) return colors[after].color;
            GradientColorKey a = colors[after - 1], b = colors[after];
            float t = (time - a.time) / (b.time - a.time);
            return mode == GradientMode.Blend ? Color.LerpUnclamped(a.color, b.color, t) : LerpOklab(a.color, b.color, t);
        }

        float EvaluateAlpha(float time)
        {
            int after = Array.FindIndex(alphas, k => k.time >= time);
            if (after == 0) return alphas[0].alpha;
            if (after < 0) return alphas[alphas.Length - 1].alpha;
            if (mode == GradientMode.Fixed) return alphas[after].alpha;
            GradientAlphaKey a = alphas[after - 1], b = alphas[after];
            return Mathf.LerpUnclamped(a.alpha, b.alpha, (time - a.time) / (b.time - a.time));
        }

        // Ottosson's Oklab (2020), where equal steps look equal.
        static Color LerpOklab(Color a, Color b, float t)
        {
            Vector3 lab = Vector3.LerpUnclamped(ToOklab(a.linear), ToOklab(b.linear), t);
            float l = Cube(lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z);
            float m = Cube(lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z);
            float s = Cube(lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z);
            return new Color(
                4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s,
                -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s,
                -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s).gamma;

            static float Cube(float x) => x * x * x;
        }

        static Vector3 ToOklab(Color c)
        {
            float l = MathF.Cbrt(0.4122214708f * c.r + 0.5363325363f * c.g + 0.0514459929f * c.b);
            float m = MathF.Cbrt(0.2119034982f * c.r + 0.6806995451f * c.g + 0.1073969566f * c.b);
            float s = MathF.Cbrt(0.0883024619f * c.r + 0.2817188376f * c.g + 0.6299787005f * c.b);
            return new Vector3(
                0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
                1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
                0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s);
        }

        internal Gradient Copy() => new Gradient { mode = mode, colorSpace = colorSpace, colors = colorKeys, alphas = alphaKeys };

        public bool Equals(Gradient other)
            => other != null && mode == other.mode && colorSpace == other.colorSpace && colors.SequenceEqual(other.colors)
                && alphas.SequenceEqual(other.alphas);
        public override bool Equals(object o) => Equals(o as Gradient);
        public override int GetHashCode() => HashCode.Combine(mode, colors.Length, alphas.Length);
    }

    public struct GradientColorKey
    {
        public Color color;
        public float time;
        public GradientColorKey(Color col, float time) { color = col; this.time = time; }
    }

    public struct GradientAlphaKey
    {
        public float alpha;
        public float time;
        public GradientAlphaKey(float alpha, float time) { this.alpha = alpha; this.time = time; }
    }

    public enum GradientMode { Blend = 0, Fixed = 1, PerceptualBlend = 2 }
}
