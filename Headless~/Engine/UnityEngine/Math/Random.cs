using System;
using System.Runtime.InteropServices;

namespace UnityEngine
{
    /// <summary>Marsaglia's xorshift with 128 bits of state; the same seed gives the same numbers in every run.</summary>
    public static class Random
    {
        [Serializable, StructLayout(LayoutKind.Sequential)]
        public struct State
        {
            internal uint s0, s1, s2, s3;
        }

        static State current = Seeded(Environment.TickCount);

        public static State state { get => current; set => current = value; }
        public static void InitState(int seed) => current = Seeded(seed);

        static State Seeded(int seed)
        {
            State s;
            s.s0 = (uint)seed;
            s.s1 = s.s0 * 1812433253u + 1;
            s.s2 = s.s1 * 1812433253u + 1;
            s.s3 = s.s2 * 1812433253u + 1;
            return s;
        }

        static uint Next()
        {
            uint t = current.s0 ^ current.s0 << 11;
            current.s0 = current.s1;
            current.s1 = current.s2;
            current.s2 = current.s3;
            current.s3 = current.s3 ^ current.s3 >> 19 ^ t ^ t >> 8;
            return current.s3;
        }

        /// <summary>0 to 1, both included.</summary>
        public static float value => (Next() & 0x7FFFFF) / 8388607f;

        public static float Range(float minInclusive, float maxInclusive)
        {
            float t = value;
            return minInclusive * t + maxInclusive * (1 - t);
        }

        public static int Range(int minInclusive, int maxExclusive)
        {
            if (minInclusive == maxExclusive)
                return minInclusive;
            if (minInclusive < maxExclusive)
                return (int)(minInclusive + (long)(Next() % (uint)((long)maxExclusive - minInclusive)));
            return (int)(minInclusive - (long)(Next() % (uint)((long)minInclusive - maxExclusive)));
        }

        public static Vector3 onUnitSphere
        {
            get
            {
                float z = Range(-1f, 1f), angle = Range(0, 2 * Mathf.PI), r = Mathf.Sqrt(Mathf.Max(0, 1 - z * z));
                return new Vector3(r * Mathf.Cos(angle), r * Mathf.Sin(angle), z);
            }
        }

        public static Vector3 insideUnitSphere => onUnitSphere * Mathf.Pow(value, 1f / 3);

        public static Vector2 insideUnitCircle
        {
            get
            {
                float angle = Range(0, 2 * Mathf.PI), r = Mathf.Sqrt(value);
                return new Vector2(r * Mathf.Cos(angle), r * Mathf.Sin(angle));
            }
        }

        public static Quaternion rotation => rotationUniform;

        public static Quaternion rotationUniform
        {
            get
            {
                // Shoemake, "Uniform random rotations", Graphics Gems III.
                float u = value, a = Range(0, 2 * Mathf.PI), b = Range(0, 2 * Mathf.PI);
                float p = Mathf.Sqrt(1 - u), q = Mathf.Sqrt(u);
                return new Quaternion(p * Mathf.Sin(a), p * Mathf.Cos(a), q * Mathf.Sin(b), q * Mathf.Cos(b));
            }
        }

        public static Color ColorHSV() => ColorHSV(0, 1, 0, 1, 0, 1, 1, 1);
        public static Color ColorHSV(float hueMin, float hueMax) => ColorHSV(hueMin, hueMax, 0, 1, 0, 1, 1, 1);
        public static Color ColorHSV(float hueMin, float hueMax, float saturationMin, float saturationMax)
            => ColorHSV(hueMin, hueMax, saturationMin, saturationMax, 0, 1, 1, 1);
        public static Color ColorHSV(float hueMin, float hueMax, float saturationMin, float saturationMax, float valueMin, float valueMax)
            => ColorHSV(hueMin, hueMax, saturationMin, saturationMax, valueMin, valueMax, 1, 1);

        public static Color ColorHSV(float hueMin, float hueMax, float saturationMin, float saturationMax, float valueMin, float valueMax,
            float alphaMin, float alphaMax)
        {
            Color color = Color.HSVToRGB(Mathf.Lerp(hueMin, hueMax, value), Mathf.Lerp(saturationMin, saturationMax, value),
                Mathf.Lerp(valueMin, valueMax, value), true);
            color.a = Mathf.Lerp(alphaMin, alphaMax, value);
            return color;
        }
    }
}
