using System;

namespace Unity.Mathematics
{
    public static partial class math
    {
        public enum RotationOrder : byte { XYZ, XZY, YXZ, YZX, ZXY, ZYX, Default = ZXY }

        public const float E = 2.71828182f;
        public const float LOG2E = 1.44269504f;
        public const float LOG10E = 0.434294481f;
        public const float LN2 = 0.693147180f;
        public const float LN10 = 2.30258509f;
        public const float PI = 3.14159274f;
        public const float PI2 = PI * 2;
        public const float TAU = PI * 2;
        public const float PIHALF = PI / 2;
        public const float SQRT2 = 1.41421356f;
        public const float TODEGREES = 57.2957795f;
        public const float TORADIANS = 0.0174532925f;
        public const float EPSILON = 1.1920928955078125e-7f;
        public const float FLT_MIN_NORMAL = 1.175494351e-38f;
        public const float INFINITY = float.PositiveInfinity;
        public const float NAN = float.NaN;

        public static float mul(float a, float b) => a * b;
        public static int mul(int a, int b) => a * b;
        public static uint mul(uint a, uint b) => a * b;

        // ---- long
        public static long min(long x, long y) => x < y ? x : y;
        public static long max(long x, long y) => x > y ? x : y;
        public static long clamp(long valueToClamp, long lowerBound, long upperBound) => max(lowerBound, min(upperBound, valueToClamp));
        public static ulong min(ulong x, ulong y) => x < y ? x : y;
        public static ulong max(ulong x, ulong y) => x > y ? x : y;
        public static ulong clamp(ulong valueToClamp, ulong lowerBound, ulong upperBound) => max(lowerBound, min(upperBound, valueToClamp));
        public static long abs(long x) => Math.Abs(x);

        // ---- bits
        static int CountBits(uint x)
        {
            x -= x >> 1 & 0x55555555;
            x = (x & 0x33333333) + (x >> 2 & 0x33333333);
            return (int)((x + (x >> 4) & 0x0F0F0F0F) * 0x01010101 >> 24);
        }

        static uint Fill(uint x)
        {
            x |= x >> 1; x |= x >> 2; x |= x >> 4; x |= x >> 8;
            return x | x >> 16;
        }

        static int LeadingZeros(uint x) => 32 - CountBits(Fill(x));

        static uint ReverseBits(uint x)
        {
            x = x >> 1 & 0x55555555 | (x & 0x55555555) << 1;
            x = x >> 2 & 0x33333333 | (x & 0x33333333) << 2;
            x = x >> 4 & 0x0F0F0F0F | (x & 0x0F0F0F0F) << 4;
            x = x >> 8 & 0x00FF00FF | (x & 0x00FF00FF) << 8;
            return x >> 16 | x << 16;
        }

        public static int bitmask(bool4 value) => (value.x ? 1 : 0) | (value.y ? 2 : 0) | (value.z ? 4 : 0) | (value.w ? 8 : 0);

        /// <summary>The magnitude of x with its sign flipped where y is negative.</summary>
        public static float4 chgsign(float4 x, float4 y) => asfloat(asuint(x) ^ asuint(y) & 0x80000000);
        public static float3 chgsign(float3 x, float3 y) => asfloat(asuint(x) ^ asuint(y) & 0x80000000);
        public static float2 chgsign(float2 x, float2 y) => asfloat(asuint(x) ^ asuint(y) & 0x80000000);

        // ---- hashes: any good mixing, not the package's own numbers
        static uint Hash(uint a, uint b) => Mix(Mix(0x9E3779B9, a), b);
        static uint Hash(uint a, uint b, uint c) => Mix(Hash(a, b), c);
        static uint Hash(uint a, uint b, uint c, uint d) => Mix(Hash(a, b, c), d);

        static uint Mix(uint h, uint x)
        {
            h ^= x * 0xCC9E2D51;
            h = rol(h, 13) * 5 + 0xE6546B64;
            h ^= h >> 16;
            h *= 0x85EBCA6B;
            return h ^ h >> 13;
        }

        static uint Fold(double x)
        {
            long bits = BitConverter.DoubleToInt64Bits(x);
            return (uint)bits ^ (uint)(bits >> 32);
        }

        // ---- 2x2
        public static float determinant(float2x2 m) => m.c0.x * m.c1.y - m.c1.x * m.c0.y;
        public static float2x2 inverse(float2x2 m) => new float2x2(m.c1.y, -m.c1.x, -m.c0.y, m.c0.x) * (1 / determinant(m));

        // ---- 3x3: rows of the inverse are cross products of the columns
        public static float determinant(float3x3 m) => dot(m.c0, cross(m.c1, m.c2));

        public static float3x3 inverse(float3x3 m)
        {
            float3 a = cross(m.c1, m.c2), b = cross(m.c2, m.c0), c = cross(m.c0, m.c1);
            return transpose(new float3x3(a, b, c)) * (1 / dot(m.c0, a));
        }

        // ---- 4x4
        public static float determinant(float4x4 m) => ((UnityEngine.Matrix4x4)m).determinant;

        public static float4x4 inverse(float4x4 m)
        {
            UnityEngine.Matrix4x4 matrix = m;
            // The package divides by a zero determinant; Unity's matrix answers zeros.
            return matrix.determinant != 0 ? (float4x4)matrix.inverse : new float4x4(float.NaN);
        }

        /// <summary>Inverse of a rotation and translation alone.</summary>
        public static float4x4 fastinverse(float4x4 m)
        {
            float3x3 r = transpose(new float3x3(m));
            return new float4x4(r, -mul(r, m.c3.xyz));
        }

        public static float3 rotate(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z).xyz;
        public static float3 transform(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3).xyz;
        public static float4x4 float4x4(float3x3 rotation, float3 translation) => new float4x4(rotation, translation);
        public static float4x4 float4x4(quaternion rotation, float3 translation) => new float4x4(rotation, translation);
        public static float3x3 float3x3(quaternion rotation) => new float3x3(rotation);
        public static float3x3 float3x3(float4x4 f4x4) => new float3x3(f4x4);

        /// <summary>Modified Gram-Schmidt on the columns.</summary>
        public static float3x3 orthonormalize(float3x3 i)
        {
            float3 x = normalizesafe(i.c0);
            float3 y = normalizesafe(i.c1 - x * dot(i.c1, x));
            return new float3x3(x, y, cross(x, y) * (dot(cross(x, y), i.c2) < 0 ? -1 : 1));
        }

        // ---- directions
        public static float3 up() => new float3(0, 1, 0);
        public static float3 down() => new float3(0, -1, 0);
        public static float3 forward() => new float3(0, 0, 1);
        public static float3 back() => new float3(0, 0, -1);
        public static float3 left() => new float3(-1, 0, 0);
        public static float3 right() => new float3(1, 0, 0);

        // ---- quaternions
        public static quaternion quaternion(float x, float y, float z, float w) => new quaternion(x, y, z, w);
        public static quaternion quaternion(float4 value) => new quaternion(value);
        public static quaternion quaternion(float3x3 m) => new quaternion(m);
        public static quaternion quaternion(float4x4 m) => new quaternion(m);
        public static quaternion conjugate(quaternion q) => new quaternion(q.value * new float4(-1, -1, -1, 1));
        public static quaternion inverse(quaternion q) => new quaternion(conjugate(q).value * rcp(dot(q.value, q.value)));
        public static float dot(quaternion a, quaternion b) => dot(a.value, b.value);
        public static float length(quaternion q) => length(q.value);
        public static float lengthsq(quaternion q) => lengthsq(q.value);
        public static quaternion normalize(quaternion q) => new quaternion(normalize(q.value));
        public static quaternion normalizesafe(quaternion q) => normalizesafe(q, Mathematics.quaternion.identity);
        public static quaternion normalizesafe(quaternion q, quaternion defaultvalue) => new quaternion(normalizesafe(q.value, defaultvalue.value));
        public static uint hash(quaternion q) => hash(q.value);
        /// <summary>Radians.</summary>
        public static float angle(quaternion q1, quaternion q2) => 2 * asin(min(1, length(normalize(mul(conjugate(q1), q2)).value.xyz)));

        public static quaternion mul(quaternion a, quaternion b)
            => new quaternion(new float4(a.value.w * b.value.xyz + b.value.w * a.value.xyz + cross(a.value.xyz, b.value.xyz),
                a.value.w * b.value.w - dot(a.value.xyz, b.value.xyz)));

        public static float3 mul(quaternion q, float3 v)
        {
            float3 t = 2 * cross(q.value.xyz, v);
            return v + q.value.w * t + cross(q.value.xyz, t);
        }

        public static float3 rotate(quaternion q, float3 v) => mul(q, v);
        public static float3 forward(quaternion q) => mul(q, forward());

        public static quaternion nlerp(quaternion q1, quaternion q2, float t)
            => normalize(new quaternion(q1.value + t * (select(q2.value, -q2.value, dot(q1, q2) < 0) - q1.value)));

        public static quaternion slerp(quaternion q1, quaternion q2, float t)
        {
            float cosine = dot(q1, q2);
            if (cosine < 0)
            {
                cosine = -cosine;
                q2.value = -q2.value;
            }
            if (cosine >= 0.9995f)
                return nlerp(q1, q2, t);
            float angle = acos(cosine), s = rsqrt(1 - cosine * cosine);
            return new quaternion(q1.value * (sin(angle * (1 - t)) * s) + q2.value * (sin(angle * t) * s));
        }
    }
}
