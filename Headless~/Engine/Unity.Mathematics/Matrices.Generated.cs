// Written by generate.py; change that instead.
#pragma warning disable CS8981
using System;
using System.Globalization;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    /// <summary>Columns c0 to c1; multiplies column vectors by math.mul.</summary>
    [Serializable]
    public partial struct float2x2 : IEquatable<float2x2>, IFormattable
    {
        public float2 c0;
        public float2 c1;

        public static readonly float2x2 identity = new float2x2(1f, 0f, 0f, 1f);
        public static readonly float2x2 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2x2(float2 c0, float2 c1) { this.c0 = c0; this.c1 = c1; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2x2(float m00, float m01, float m10, float m11) { c0 = new float2(m00, m10); c1 = new float2(m01, m11); }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2x2(float v) { c0 = v; c1 = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float2x2(float v) => new float2x2(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator +(float2x2 lhs, float2x2 rhs) => new float2x2(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator +(float2x2 lhs, float rhs) => new float2x2(lhs.c0 + rhs, lhs.c1 + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator +(float lhs, float2x2 rhs) => new float2x2(lhs + rhs.c0, lhs + rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator -(float2x2 lhs, float2x2 rhs) => new float2x2(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator -(float2x2 lhs, float rhs) => new float2x2(lhs.c0 - rhs, lhs.c1 - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator -(float lhs, float2x2 rhs) => new float2x2(lhs - rhs.c0, lhs - rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator *(float2x2 lhs, float2x2 rhs) => new float2x2(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator *(float2x2 lhs, float rhs) => new float2x2(lhs.c0 * rhs, lhs.c1 * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator *(float lhs, float2x2 rhs) => new float2x2(lhs * rhs.c0, lhs * rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator /(float2x2 lhs, float2x2 rhs) => new float2x2(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator /(float2x2 lhs, float rhs) => new float2x2(lhs.c0 / rhs, lhs.c1 / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator /(float lhs, float2x2 rhs) => new float2x2(lhs / rhs.c0, lhs / rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator %(float2x2 lhs, float2x2 rhs) => new float2x2(lhs.c0 % rhs.c0, lhs.c1 % rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator %(float2x2 lhs, float rhs) => new float2x2(lhs.c0 % rhs, lhs.c1 % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator %(float lhs, float2x2 rhs) => new float2x2(lhs % rhs.c0, lhs % rhs.c1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator +(float2x2 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2x2 operator -(float2x2 val) => new float2x2(-val.c0, -val.c1);

        public unsafe ref float2 this[int index]
        {
            get
            {
                if ((uint)index >= 2) throw new ArgumentException($"float2x2 has columns 0 to 1, not {index}.");
                fixed (float2* p = &c0) return ref p[index];
            }
        }

        public bool Equals(float2x2 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1);
        public override bool Equals(object o) => o is float2x2 m && Equals(m);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"float2x2({c0.x.ToString(format, formatProvider)}f, {c1.x.ToString(format, formatProvider)}f,  {c0.y.ToString(format, formatProvider)}f, {c1.y.ToString(format, formatProvider)}f)";
    }

    /// <summary>Columns c0 to c2; multiplies column vectors by math.mul.</summary>
    [Serializable]
    public partial struct float3x3 : IEquatable<float3x3>, IFormattable
    {
        public float3 c0;
        public float3 c1;
        public float3 c2;

        public static readonly float3x3 identity = new float3x3(1f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f);
        public static readonly float3x3 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3x3(float3 c0, float3 c1, float3 c2) { this.c0 = c0; this.c1 = c1; this.c2 = c2; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3x3(float m00, float m01, float m02, float m10, float m11, float m12, float m20, float m21, float m22) { c0 = new float3(m00, m10, m20); c1 = new float3(m01, m11, m21); c2 = new float3(m02, m12, m22); }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3x3(float v) { c0 = v; c1 = v; c2 = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float3x3(float v) => new float3x3(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator +(float3x3 lhs, float3x3 rhs) => new float3x3(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator +(float3x3 lhs, float rhs) => new float3x3(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator +(float lhs, float3x3 rhs) => new float3x3(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator -(float3x3 lhs, float3x3 rhs) => new float3x3(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator -(float3x3 lhs, float rhs) => new float3x3(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator -(float lhs, float3x3 rhs) => new float3x3(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator *(float3x3 lhs, float3x3 rhs) => new float3x3(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator *(float3x3 lhs, float rhs) => new float3x3(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator *(float lhs, float3x3 rhs) => new float3x3(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator /(float3x3 lhs, float3x3 rhs) => new float3x3(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator /(float3x3 lhs, float rhs) => new float3x3(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator /(float lhs, float3x3 rhs) => new float3x3(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator %(float3x3 lhs, float3x3 rhs) => new float3x3(lhs.c0 % rhs.c0, lhs.c1 % rhs.c1, lhs.c2 % rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator %(float3x3 lhs, float rhs) => new float3x3(lhs.c0 % rhs, lhs.c1 % rhs, lhs.c2 % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator %(float lhs, float3x3 rhs) => new float3x3(lhs % rhs.c0, lhs % rhs.c1, lhs % rhs.c2);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator +(float3x3 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3x3 operator -(float3x3 val) => new float3x3(-val.c0, -val.c1, -val.c2);

        public unsafe ref float3 this[int index]
        {
            get
            {
                if ((uint)index >= 3) throw new ArgumentException($"float3x3 has columns 0 to 2, not {index}.");
                fixed (float3* p = &c0) return ref p[index];
            }
        }

        public bool Equals(float3x3 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2);
        public override bool Equals(object o) => o is float3x3 m && Equals(m);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"float3x3({c0.x.ToString(format, formatProvider)}f, {c1.x.ToString(format, formatProvider)}f, {c2.x.ToString(format, formatProvider)}f,  {c0.y.ToString(format, formatProvider)}f, {c1.y.ToString(format, formatProvider)}f, {c2.y.ToString(format, formatProvider)}f,  {c0.z.ToString(format, formatProvider)}f, {c1.z.ToString(format, formatProvider)}f, {c2.z.ToString(format, formatProvider)}f)";
    }

    /// <summary>Columns c0 to c3; multiplies column vectors by math.mul.</summary>
    [Serializable]
    public partial struct float4x4 : IEquatable<float4x4>, IFormattable
    {
        public float4 c0;
        public float4 c1;
        public float4 c2;
        public float4 c3;

        public static readonly float4x4 identity = new float4x4(1f, 0f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 0f, 1f);
        public static readonly float4x4 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4x4(float4 c0, float4 c1, float4 c2, float4 c3) { this.c0 = c0; this.c1 = c1; this.c2 = c2; this.c3 = c3; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4x4(float m00, float m01, float m02, float m03, float m10, float m11, float m12, float m13, float m20, float m21, float m22, float m23, float m30, float m31, float m32, float m33) { c0 = new float4(m00, m10, m20, m30); c1 = new float4(m01, m11, m21, m31); c2 = new float4(m02, m12, m22, m32); c3 = new float4(m03, m13, m23, m33); }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4x4(float v) { c0 = v; c1 = v; c2 = v; c3 = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float4x4(float v) => new float4x4(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator +(float4x4 lhs, float4x4 rhs) => new float4x4(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2, lhs.c3 + rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator +(float4x4 lhs, float rhs) => new float4x4(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs, lhs.c3 + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator +(float lhs, float4x4 rhs) => new float4x4(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2, lhs + rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator -(float4x4 lhs, float4x4 rhs) => new float4x4(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2, lhs.c3 - rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator -(float4x4 lhs, float rhs) => new float4x4(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs, lhs.c3 - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator -(float lhs, float4x4 rhs) => new float4x4(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2, lhs - rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator *(float4x4 lhs, float4x4 rhs) => new float4x4(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2, lhs.c3 * rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator *(float4x4 lhs, float rhs) => new float4x4(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs, lhs.c3 * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator *(float lhs, float4x4 rhs) => new float4x4(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2, lhs * rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator /(float4x4 lhs, float4x4 rhs) => new float4x4(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2, lhs.c3 / rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator /(float4x4 lhs, float rhs) => new float4x4(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs, lhs.c3 / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator /(float lhs, float4x4 rhs) => new float4x4(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2, lhs / rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator %(float4x4 lhs, float4x4 rhs) => new float4x4(lhs.c0 % rhs.c0, lhs.c1 % rhs.c1, lhs.c2 % rhs.c2, lhs.c3 % rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator %(float4x4 lhs, float rhs) => new float4x4(lhs.c0 % rhs, lhs.c1 % rhs, lhs.c2 % rhs, lhs.c3 % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator %(float lhs, float4x4 rhs) => new float4x4(lhs % rhs.c0, lhs % rhs.c1, lhs % rhs.c2, lhs % rhs.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator +(float4x4 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4x4 operator -(float4x4 val) => new float4x4(-val.c0, -val.c1, -val.c2, -val.c3);

        public unsafe ref float4 this[int index]
        {
            get
            {
                if ((uint)index >= 4) throw new ArgumentException($"float4x4 has columns 0 to 3, not {index}.");
                fixed (float4* p = &c0) return ref p[index];
            }
        }

        public bool Equals(float4x4 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2) && c3.Equals(rhs.c3);
        public override bool Equals(object o) => o is float4x4 m && Equals(m);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"float4x4({c0.x.ToString(format, formatProvider)}f, {c1.x.ToString(format, formatProvider)}f, {c2.x.ToString(format, formatProvider)}f, {c3.x.ToString(format, formatProvider)}f,  {c0.y.ToString(format, formatProvider)}f, {c1.y.ToString(format, formatProvider)}f, {c2.y.ToString(format, formatProvider)}f, {c3.y.ToString(format, formatProvider)}f,  {c0.z.ToString(format, formatProvider)}f, {c1.z.ToString(format, formatProvider)}f, {c2.z.ToString(format, formatProvider)}f, {c3.z.ToString(format, formatProvider)}f,  {c0.w.ToString(format, formatProvider)}f, {c1.w.ToString(format, formatProvider)}f, {c2.w.ToString(format, formatProvider)}f, {c3.w.ToString(format, formatProvider)}f)";
    }
}
