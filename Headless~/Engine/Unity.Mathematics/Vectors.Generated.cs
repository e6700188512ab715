// Written by generate.py; change that instead.
#pragma warning disable CS8981
using System;
using System.Globalization;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    [Serializable]
    public partial struct float2 : IEquatable<float2>, IFormattable
    {
        public float x;
        public float y;

        public static readonly float2 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(float x, float y) { this.x = x; this.y = y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(float2 xy) { this.x = xy.x; this.y = xy.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(float v) { this.x = v; this.y = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(bool v) { this.x = v ? 1f : 0f; this.y = v ? 1f : 0f; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(bool2 v) { this.x = v.x ? 1f : 0f; this.y = v.y ? 1f : 0f; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(int v) { this.x = (float)v; this.y = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(int2 v) { this.x = (float)v.x; this.y = (float)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(uint v) { this.x = (float)v; this.y = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(uint2 v) { this.x = (float)v.x; this.y = (float)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(double v) { this.x = (float)v; this.y = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float2(double2 v) { this.x = (float)v.x; this.y = (float)v.y; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float2(float v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float2(bool v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float2(bool2 v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float2(int v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float2(int2 v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float2(uint v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float2(uint2 v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float2(double v) => new float2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float2(double2 v) => new float2(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator +(float2 lhs, float2 rhs) => new float2(lhs.x + rhs.x, lhs.y + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator +(float2 lhs, float rhs) => new float2(lhs.x + rhs, lhs.y + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator +(float lhs, float2 rhs) => new float2(lhs + rhs.x, lhs + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator -(float2 lhs, float2 rhs) => new float2(lhs.x - rhs.x, lhs.y - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator -(float2 lhs, float rhs) => new float2(lhs.x - rhs, lhs.y - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator -(float lhs, float2 rhs) => new float2(lhs - rhs.x, lhs - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator *(float2 lhs, float2 rhs) => new float2(lhs.x * rhs.x, lhs.y * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator *(float2 lhs, float rhs) => new float2(lhs.x * rhs, lhs.y * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator *(float lhs, float2 rhs) => new float2(lhs * rhs.x, lhs * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator /(float2 lhs, float2 rhs) => new float2(lhs.x / rhs.x, lhs.y / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator /(float2 lhs, float rhs) => new float2(lhs.x / rhs, lhs.y / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator /(float lhs, float2 rhs) => new float2(lhs / rhs.x, lhs / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator %(float2 lhs, float2 rhs) => new float2(lhs.x % rhs.x, lhs.y % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator %(float2 lhs, float rhs) => new float2(lhs.x % rhs, lhs.y % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator %(float lhs, float2 rhs) => new float2(lhs % rhs.x, lhs % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(float2 lhs, float2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(float2 lhs, float rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(float lhs, float2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(float2 lhs, float2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(float2 lhs, float rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(float lhs, float2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(float2 lhs, float2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(float2 lhs, float rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(float lhs, float2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(float2 lhs, float2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(float2 lhs, float rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(float lhs, float2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator +(float2 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator -(float2 val) => new float2(-val.x, -val.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator ++(float2 val) => new float2(val.x + 1, val.y + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float2 operator --(float2 val) => new float2(val.x - 1, val.y - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(float2 lhs, float2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(float2 lhs, float rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(float lhs, float2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(float2 lhs, float2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(float2 lhs, float rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(float lhs, float2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        public float this[int index]
        {
            get => index switch { 0 => x, 1 => y, _ => throw new ArgumentException($"float2 has components 0 to 1, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; default: throw new ArgumentException($"float2 has components 0 to 1, not {index}."); } }
        }

        public float2 xx => new float2(x, x);
        public float2 xy { get => new float2(x, y); set { x = value.x; y = value.y; } }
        public float2 yx { get => new float2(y, x); set { y = value.x; x = value.y; } }
        public float2 yy => new float2(y, y);
        public float3 xxx => new float3(x, x, x);
        public float3 xxy => new float3(x, x, y);
        public float3 xyx => new float3(x, y, x);
        public float3 xyy => new float3(x, y, y);
        public float3 yxx => new float3(y, x, x);
        public float3 yxy => new float3(y, x, y);
        public float3 yyx => new float3(y, y, x);
        public float3 yyy => new float3(y, y, y);
        public float4 xxxx => new float4(x, x, x, x);
        public float4 xxxy => new float4(x, x, x, y);
        public float4 xxyx => new float4(x, x, y, x);
        public float4 xxyy => new float4(x, x, y, y);
        public float4 xyxx => new float4(x, y, x, x);
        public float4 xyxy => new float4(x, y, x, y);
        public float4 xyyx => new float4(x, y, y, x);
        public float4 xyyy => new float4(x, y, y, y);
        public float4 yxxx => new float4(y, x, x, x);
        public float4 yxxy => new float4(y, x, x, y);
        public float4 yxyx => new float4(y, x, y, x);
        public float4 yxyy => new float4(y, x, y, y);
        public float4 yyxx => new float4(y, y, x, x);
        public float4 yyxy => new float4(y, y, x, y);
        public float4 yyyx => new float4(y, y, y, x);
        public float4 yyyy => new float4(y, y, y, y);

        public bool Equals(float2 rhs) => x == rhs.x && y == rhs.y;
        public override bool Equals(object o) => o is float2 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"float2({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f)";
    }

    [Serializable]
    public partial struct float3 : IEquatable<float3>, IFormattable
    {
        public float x;
        public float y;
        public float z;

        public static readonly float3 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(float x, float2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(float2 xy, float z) { this.x = xy.x; this.y = xy.y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(float3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(float v) { this.x = v; this.y = v; this.z = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(bool v) { this.x = v ? 1f : 0f; this.y = v ? 1f : 0f; this.z = v ? 1f : 0f; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(bool3 v) { this.x = v.x ? 1f : 0f; this.y = v.y ? 1f : 0f; this.z = v.z ? 1f : 0f; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(int v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(int3 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(uint v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(uint3 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(double v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float3(double3 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float3(float v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float3(bool v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float3(bool3 v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float3(int v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float3(int3 v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float3(uint v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float3(uint3 v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float3(double v) => new float3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float3(double3 v) => new float3(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator +(float3 lhs, float3 rhs) => new float3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator +(float3 lhs, float rhs) => new float3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator +(float lhs, float3 rhs) => new float3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator -(float3 lhs, float3 rhs) => new float3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator -(float3 lhs, float rhs) => new float3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator -(float lhs, float3 rhs) => new float3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator *(float3 lhs, float3 rhs) => new float3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator *(float3 lhs, float rhs) => new float3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator *(float lhs, float3 rhs) => new float3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator /(float3 lhs, float3 rhs) => new float3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator /(float3 lhs, float rhs) => new float3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator /(float lhs, float3 rhs) => new float3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator %(float3 lhs, float3 rhs) => new float3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator %(float3 lhs, float rhs) => new float3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator %(float lhs, float3 rhs) => new float3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(float3 lhs, float3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(float3 lhs, float rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(float lhs, float3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(float3 lhs, float3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(float3 lhs, float rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(float lhs, float3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(float3 lhs, float3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(float3 lhs, float rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(float lhs, float3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(float3 lhs, float3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(float3 lhs, float rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(float lhs, float3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator +(float3 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator -(float3 val) => new float3(-val.x, -val.y, -val.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator ++(float3 val) => new float3(val.x + 1, val.y + 1, val.z + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float3 operator --(float3 val) => new float3(val.x - 1, val.y - 1, val.z - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(float3 lhs, float3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(float3 lhs, float rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(float lhs, float3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(float3 lhs, float3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(float3 lhs, float rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(float lhs, float3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        public float this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new ArgumentException($"float3 has components 0 to 2, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; default: throw new ArgumentException($"float3 has components 0 to 2, not {index}."); } }
        }

        public float2 xx => new float2(x, x);
        public float2 xy { get => new float2(x, y); set { x = value.x; y = value.y; } }
        public float2 xz { get => new float2(x, z); set { x = value.x; z = value.y; } }
        public float2 yx { get => new float2(y, x); set { y = value.x; x = value.y; } }
        public float2 yy => new float2(y, y);
        public float2 yz { get => new float2(y, z); set { y = value.x; z = value.y; } }
        public float2 zx { get => new float2(z, x); set { z = value.x; x = value.y; } }
        public float2 zy { get => new float2(z, y); set { z = value.x; y = value.y; } }
        public float2 zz => new float2(z, z);
        public float3 xxx => new float3(x, x, x);
        public float3 xxy => new float3(x, x, y);
        public float3 xxz => new float3(x, x, z);
        public float3 xyx => new float3(x, y, x);
        public float3 xyy => new float3(x, y, y);
        public float3 xyz { get => new float3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public float3 xzx => new float3(x, z, x);
        public float3 xzy { get => new float3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public float3 xzz => new float3(x, z, z);
        public float3 yxx => new float3(y, x, x);
        public float3 yxy => new float3(y, x, y);
        public float3 yxz { get => new float3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public float3 yyx => new float3(y, y, x);
        public float3 yyy => new float3(y, y, y);
        public float3 yyz => new float3(y, y, z);
        public float3 yzx { get => new float3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public float3 yzy => new float3(y, z, y);
        public float3 yzz => new float3(y, z, z);
        public float3 zxx => new float3(z, x, x);
        public float3 zxy { get => new float3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public float3 zxz => new float3(z, x, z);
        public float3 zyx { get => new float3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public float3 zyy => new float3(z, y, y);
        public float3 zyz => new float3(z, y, z);
        public float3 zzx => new float3(z, z, x);
        public float3 zzy => new float3(z, z, y);
        public float3 zzz => new float3(z, z, z);
        public float4 xxxx => new float4(x, x, x, x);
        public float4 xxxy => new float4(x, x, x, y);
        public float4 xxxz => new float4(x, x, x, z);
        public float4 xxyx => new float4(x, x, y, x);
        public float4 xxyy => new float4(x, x, y, y);
        public float4 xxyz => new float4(x, x, y, z);
        public float4 xxzx => new float4(x, x, z, x);
        public float4 xxzy => new float4(x, x, z, y);
        public float4 xxzz => new float4(x, x, z, z);
        public float4 xyxx => new float4(x, y, x, x);
        public float4 xyxy => new float4(x, y, x, y);
        public float4 xyxz => new float4(x, y, x, z);
        public float4 xyyx => new float4(x, y, y, x);
        public float4 xyyy => new float4(x, y, y, y);
        public float4 xyyz => new float4(x, y, y, z);
        public float4 xyzx => new float4(x, y, z, x);
        public float4 xyzy => new float4(x, y, z, y);
        public float4 xyzz => new float4(x, y, z, z);
        public float4 xzxx => new float4(x, z, x, x);
        public float4 xzxy => new float4(x, z, x, y);
        public float4 xzxz => new float4(x, z, x, z);
        public float4 xzyx => new float4(x, z, y, x);
        public float4 xzyy => new float4(x, z, y, y);
        public float4 xzyz => new float4(x, z, y, z);
        public float4 xzzx => new float4(x, z, z, x);
        public float4 xzzy => new float4(x, z, z, y);
        public float4 xzzz => new float4(x, z, z, z);
        public float4 yxxx => new float4(y, x, x, x);
        public float4 yxxy => new float4(y, x, x, y);
        public float4 yxxz => new float4(y, x, x, z);
        public float4 yxyx => new float4(y, x, y, x);
        public float4 yxyy => new float4(y, x, y, y);
        public float4 yxyz => new float4(y, x, y, z);
        public float4 yxzx => new float4(y, x, z, x);
        public float4 yxzy => new float4(y, x, z, y);
        public float4 yxzz => new float4(y, x, z, z);
        public float4 yyxx => new float4(y, y, x, x);
        public float4 yyxy => new float4(y, y, x, y);
        public float4 yyxz => new float4(y, y, x, z);
        public float4 yyyx => new float4(y, y, y, x);
        public float4 yyyy => new float4(y, y, y, y);
        public float4 yyyz => new float4(y, y, y, z);
        public float4 yyzx => new float4(y, y, z, x);
        public float4 yyzy => new float4(y, y, z, y);
        public float4 yyzz => new float4(y, y, z, z);
        public float4 yzxx => new float4(y, z, x, x);
        public float4 yzxy => new float4(y, z, x, y);
        public float4 yzxz => new float4(y, z, x, z);
        public float4 yzyx => new float4(y, z, y, x);
        public float4 yzyy => new float4(y, z, y, y);
        public float4 yzyz => new float4(y, z, y, z);
        public float4 yzzx => new float4(y, z, z, x);
        public float4 yzzy => new float4(y, z, z, y);
        public float4 yzzz => new float4(y, z, z, z);
        public float4 zxxx => new float4(z, x, x, x);
        public float4 zxxy => new float4(z, x, x, y);
        public float4 zxxz => new float4(z, x, x, z);
        public float4 zxyx => new float4(z, x, y, x);
        public float4 zxyy => new float4(z, x, y, y);
        public float4 zxyz => new float4(z, x, y, z);
        public float4 zxzx => new float4(z, x, z, x);
        public float4 zxzy => new float4(z, x, z, y);
        public float4 zxzz => new float4(z, x, z, z);
        public float4 zyxx => new float4(z, y, x, x);
        public float4 zyxy => new float4(z, y, x, y);
        public float4 zyxz => new float4(z, y, x, z);
        public float4 zyyx => new float4(z, y, y, x);
        public float4 zyyy => new float4(z, y, y, y);
        public float4 zyyz => new float4(z, y, y, z);
        public float4 zyzx => new float4(z, y, z, x);
        public float4 zyzy => new float4(z, y, z, y);
        public float4 zyzz => new float4(z, y, z, z);
        public float4 zzxx => new float4(z, z, x, x);
        public float4 zzxy => new float4(z, z, x, y);
        public float4 zzxz => new float4(z, z, x, z);
        public float4 zzyx => new float4(z, z, y, x);
        public float4 zzyy => new float4(z, z, y, y);
        public float4 zzyz => new float4(z, z, y, z);
        public float4 zzzx => new float4(z, z, z, x);
        public float4 zzzy => new float4(z, z, z, y);
        public float4 zzzz => new float4(z, z, z, z);

        public bool Equals(float3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
        public override bool Equals(object o) => o is float3 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"float3({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f, {z.ToString(format, formatProvider)}f)";
    }

    [Serializable]
    public partial struct float4 : IEquatable<float4>, IFormattable
    {
        public float x;
        public float y;
        public float z;
        public float w;

        public static readonly float4 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float x, float y, float2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float x, float2 yz, float w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float x, float3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float2 xy, float z, float w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float2 xy, float2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float3 xyz, float w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(float v) { this.x = v; this.y = v; this.z = v; this.w = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(bool v) { this.x = v ? 1f : 0f; this.y = v ? 1f : 0f; this.z = v ? 1f : 0f; this.w = v ? 1f : 0f; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(bool4 v) { this.x = v.x ? 1f : 0f; this.y = v.y ? 1f : 0f; this.z = v.z ? 1f : 0f; this.w = v.w ? 1f : 0f; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(int v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; this.w = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(int4 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; this.w = (float)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(uint v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; this.w = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(uint4 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; this.w = (float)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(double v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; this.w = (float)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public float4(double4 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; this.w = (float)v.w; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float4(float v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float4(bool v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float4(bool4 v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float4(int v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float4(int4 v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float4(uint v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float4(uint4 v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float4(double v) => new float4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator float4(double4 v) => new float4(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator +(float4 lhs, float4 rhs) => new float4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator +(float4 lhs, float rhs) => new float4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator +(float lhs, float4 rhs) => new float4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator -(float4 lhs, float4 rhs) => new float4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator -(float4 lhs, float rhs) => new float4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator -(float lhs, float4 rhs) => new float4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator *(float4 lhs, float4 rhs) => new float4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator *(float4 lhs, float rhs) => new float4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator *(float lhs, float4 rhs) => new float4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator /(float4 lhs, float4 rhs) => new float4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator /(float4 lhs, float rhs) => new float4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator /(float lhs, float4 rhs) => new float4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator %(float4 lhs, float4 rhs) => new float4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator %(float4 lhs, float rhs) => new float4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator %(float lhs, float4 rhs) => new float4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(float4 lhs, float4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(float4 lhs, float rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(float lhs, float4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(float4 lhs, float4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(float4 lhs, float rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(float lhs, float4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(float4 lhs, float4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(float4 lhs, float rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(float lhs, float4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(float4 lhs, float4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(float4 lhs, float rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(float lhs, float4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator +(float4 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator -(float4 val) => new float4(-val.x, -val.y, -val.z, -val.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator ++(float4 val) => new float4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static float4 operator --(float4 val) => new float4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(float4 lhs, float4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(float4 lhs, float rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(float lhs, float4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(float4 lhs, float4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(float4 lhs, float rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(float lhs, float4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        public float this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new ArgumentException($"float4 has components 0 to 3, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; case 3: w = value; break; default: throw new ArgumentException($"float4 has components 0 to 3, not {index}."); } }
        }

        public float2 xx => new float2(x, x);
        public float2 xy { get => new float2(x, y); set { x = value.x; y = value.y; } }
        public float2 xz { get => new float2(x, z); set { x = value.x; z = value.y; } }
        public float2 xw { get => new float2(x, w); set { x = value.x; w = value.y; } }
        public float2 yx { get => new float2(y, x); set { y = value.x; x = value.y; } }
        public float2 yy => new float2(y, y);
        public float2 yz { get => new float2(y, z); set { y = value.x; z = value.y; } }
        public float2 yw { get => new float2(y, w); set { y = value.x; w = value.y; } }
        public float2 zx { get => new float2(z, x); set { z = value.x; x = value.y; } }
        public float2 zy { get => new float2(z, y); set { z = value.x; y = value.y; } }
        public float2 zz => new float2(z, z);
        public float2 zw { get => new float2(z, w); set { z = value.x; w = value.y; } }
        public float2 wx { get => new float2(w, x); set { w = value.x; x = value.y; } }
        public float2 wy { get => new float2(w, y); set { w = value.x; y = value.y; } }
        public float2 wz { get => new float2(w, z); set { w = value.x; z = value.y; } }
        public float2 ww => new float2(w, w);
        public float3 xxx => new float3(x, x, x);
        public float3 xxy => new float3(x, x, y);
        public float3 xxz => new float3(x, x, z);
        public float3 xxw => new float3(x, x, w);
        public float3 xyx => new float3(x, y, x);
        public float3 xyy => new float3(x, y, y);
        public float3 xyz { get => new float3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public float3 xyw { get => new float3(x, y, w); set { x = value.x; y = value.y; w = value.z; } }
        public float3 xzx => new float3(x, z, x);
        public float3 xzy { get => new float3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public float3 xzz => new float3(x, z, z);
        public float3 xzw { get => new float3(x, z, w); set { x = value.x; z = value.y; w = value.z; } }
        public float3 xwx => new float3(x, w, x);
        public float3 xwy { get => new float3(x, w, y); set { x = value.x; w = value.y; y = value.z; } }
        public float3 xwz { get => new float3(x, w, z); set { x = value.x; w = value.y; z = value.z; } }
        public float3 xww => new float3(x, w, w);
        public float3 yxx => new float3(y, x, x);
        public float3 yxy => new float3(y, x, y);
        public float3 yxz { get => new float3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public float3 yxw { get => new float3(y, x, w); set { y = value.x; x = value.y; w = value.z; } }
        public float3 yyx => new float3(y, y, x);
        public float3 yyy => new float3(y, y, y);
        public float3 yyz => new float3(y, y, z);
        public float3 yyw => new float3(y, y, w);
        public float3 yzx { get => new float3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public float3 yzy => new float3(y, z, y);
        public float3 yzz => new float3(y, z, z);
        public float3 yzw { get => new float3(y, z, w); set { y = value.x; z = value.y; w = value.z; } }
        public float3 ywx { get => new float3(y, w, x); set { y = value.x; w = value.y; x = value.z; } }
        public float3 ywy => new float3(y, w, y);
        public float3 ywz { get => new float3(y, w, z); set { y = value.x; w = value.y; z = value.z; } }
        public float3 yww => new float3(y, w, w);
        public float3 zxx => new float3(z, x, x);
        public float3 zxy { get => new float3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public float3 zxz => new float3(z, x, z);
        public float3 zxw { get => new float3(z, x, w); set { z = value.x; x = value.y; w = value.z; } }
        public float3 zyx { get => new float3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public float3 zyy => new float3(z, y, y);
        public float3 zyz => new float3(z, y, z);
        public float3 zyw { get => new float3(z, y, w); set { z = value.x; y = value.y; w = value.z; } }
        public float3 zzx => new float3(z, z, x);
        public float3 zzy => new float3(z, z, y);
        public float3 zzz => new float3(z, z, z);
        public float3 zzw => new float3(z, z, w);
        public float3 zwx { get => new float3(z, w, x); set { z = value.x; w = value.y; x = value.z; } }
        public float3 zwy { get => new float3(z, w, y); set { z = value.x; w = value.y; y = value.z; } }
        public float3 zwz => new float3(z, w, z);
        public float3 zww => new float3(z, w, w);
        public float3 wxx => new float3(w, x, x);
        public float3 wxy { get => new float3(w, x, y); set { w = value.x; x = value.y; y = value.z; } }
        public float3 wxz { get => new float3(w, x, z); set { w = value.x; x = value.y; z = value.z; } }
        public float3 wxw => new float3(w, x, w);
        public float3 wyx { get => new float3(w, y, x); set { w = value.x; y = value.y; x = value.z; } }
        public float3 wyy => new float3(w, y, y);
        public float3 wyz { get => new float3(w, y, z); set { w = value.x; y = value.y; z = value.z; } }
        public float3 wyw => new float3(w, y, w);
        public float3 wzx { get => new float3(w, z, x); set { w = value.x; z = value.y; x = value.z; } }
        public float3 wzy { get => new float3(w, z, y); set { w = value.x; z = value.y; y = value.z; } }
        public float3 wzz => new float3(w, z, z);
        public float3 wzw => new float3(w, z, w);
        public float3 wwx => new float3(w, w, x);
        public float3 wwy => new float3(w, w, y);
        public float3 wwz => new float3(w, w, z);
        public float3 www => new float3(w, w, w);
        public float4 xxxx => new float4(x, x, x, x);
        public float4 xxxy => new float4(x, x, x, y);
        public float4 xxxz => new float4(x, x, x, z);
        public float4 xxxw => new float4(x, x, x, w);
        public float4 xxyx => new float4(x, x, y, x);
        public float4 xxyy => new float4(x, x, y, y);
        public float4 xxyz => new float4(x, x, y, z);
        public float4 xxyw => new float4(x, x, y, w);
        public float4 xxzx => new float4(x, x, z, x);
        public float4 xxzy => new float4(x, x, z, y);
        public float4 xxzz => new float4(x, x, z, z);
        public float4 xxzw => new float4(x, x, z, w);
        public float4 xxwx => new float4(x, x, w, x);
        public float4 xxwy => new float4(x, x, w, y);
        public float4 xxwz => new float4(x, x, w, z);
        public float4 xxww => new float4(x, x, w, w);
        public float4 xyxx => new float4(x, y, x, x);
        public float4 xyxy => new float4(x, y, x, y);
        public float4 xyxz => new float4(x, y, x, z);
        public float4 xyxw => new float4(x, y, x, w);
        public float4 xyyx => new float4(x, y, y, x);
        public float4 xyyy => new float4(x, y, y, y);
        public float4 xyyz => new float4(x, y, y, z);
        public float4 xyyw => new float4(x, y, y, w);
        public float4 xyzx => new float4(x, y, z, x);
        public float4 xyzy => new float4(x, y, z, y);
        public float4 xyzz => new float4(x, y, z, z);
        public float4 xyzw { get => new float4(x, y, z, w); set { x = value.x; y = value.y; z = value.z; w = value.w; } }
        public float4 xywx => new float4(x, y, w, x);
        public float4 xywy => new float4(x, y, w, y);
        public float4 xywz { get => new float4(x, y, w, z); set { x = value.x; y = value.y; w = value.z; z = value.w; } }
        public float4 xyww => new float4(x, y, w, w);
        public float4 xzxx => new float4(x, z, x, x);
        public float4 xzxy => new float4(x, z, x, y);
        public float4 xzxz => new float4(x, z, x, z);
        public float4 xzxw => new float4(x, z, x, w);
        public float4 xzyx => new float4(x, z, y, x);
        public float4 xzyy => new float4(x, z, y, y);
        public float4 xzyz => new float4(x, z, y, z);
        public float4 xzyw { get => new float4(x, z, y, w); set { x = value.x; z = value.y; y = value.z; w = value.w; } }
        public float4 xzzx => new float4(x, z, z, x);
        public float4 xzzy => new float4(x, z, z, y);
        public float4 xzzz => new float4(x, z, z, z);
        public float4 xzzw => new float4(x, z, z, w);
        public float4 xzwx => new float4(x, z, w, x);
        public float4 xzwy { get => new float4(x, z, w, y); set { x = value.x; z = value.y; w = value.z; y = value.w; } }
        public float4 xzwz => new float4(x, z, w, z);
        public float4 xzww => new float4(x, z, w, w);
        public float4 xwxx => new float4(x, w, x, x);
        public float4 xwxy => new float4(x, w, x, y);
        public float4 xwxz => new float4(x, w, x, z);
        public float4 xwxw => new float4(x, w, x, w);
        public float4 xwyx => new float4(x, w, y, x);
        public float4 xwyy => new float4(x, w, y, y);
        public float4 xwyz { get => new float4(x, w, y, z); set { x = value.x; w = value.y; y = value.z; z = value.w; } }
        public float4 xwyw => new float4(x, w, y, w);
        public float4 xwzx => new float4(x, w, z, x);
        public float4 xwzy { get => new float4(x, w, z, y); set { x = value.x; w = value.y; z = value.z; y = value.w; } }
        public float4 xwzz => new float4(x, w, z, z);
        public float4 xwzw => new float4(x, w, z, w);
        public float4 xwwx => new float4(x, w, w, x);
        public float4 xwwy => new float4(x, w, w, y);
        public float4 xwwz => new float4(x, w, w, z);
        public float4 xwww => new float4(x, w, w, w);
        public float4 yxxx => new float4(y, x, x, x);
        public float4 yxxy => new float4(y, x, x, y);
        public float4 yxxz => new float4(y, x, x, z);
        public float4 yxxw => new float4(y, x, x, w);
        public float4 yxyx => new float4(y, x, y, x);
        public float4 yxyy => new float4(y, x, y, y);
        public float4 yxyz => new float4(y, x, y, z);
        public float4 yxyw => new float4(y, x, y, w);
        public float4 yxzx => new float4(y, x, z, x);
        public float4 yxzy => new float4(y, x, z, y);
        public float4 yxzz => new float4(y, x, z, z);
        public float4 yxzw { get => new float4(y, x, z, w); set { y = value.x; x = value.y; z = value.z; w = value.w; } }
        public float4 yxwx => new float4(y, x, w, x);
        public float4 yxwy => new float4(y, x, w, y);
        public float4 yxwz { get => new float4(y, x, w, z); set { y = value.x; x = value.y; w = value.z; z = value.w; } }
        public float4 yxww => new float4(y, x, w, w);
        public float4 yyxx => new float4(y, y, x, x);
        public float4 yyxy => new float4(y, y, x, y);
        public float4 yyxz => new float4(y, y, x, z);
        public float4 yyxw => new float4(y, y, x, w);
        public float4 yyyx => new float4(y, y, y, x);
        public float4 yyyy => new float4(y, y, y, y);
        public float4 yyyz => new float4(y, y, y, z);
        public float4 yyyw => new float4(y, y, y, w);
        public float4 yyzx => new float4(y, y, z, x);
        public float4 yyzy => new float4(y, y, z, y);
        public float4 yyzz => new float4(y, y, z, z);
        public float4 yyzw => new float4(y, y, z, w);
        public float4 yywx => new float4(y, y, w, x);
        public float4 yywy => new float4(y, y, w, y);
        public float4 yywz => new float4(y, y, w, z);
        public float4 yyww => new float4(y, y, w, w);
        public float4 yzxx => new float4(y, z, x, x);
        public float4 yzxy => new float4(y, z, x, y);
        public float4 yzxz => new float4(y, z, x, z);
        public float4 yzxw { get => new float4(y, z, x, w); set { y = value.x; z = value.y; x = value.z; w = value.w; } }
        public float4 yzyx => new float4(y, z, y, x);
        public float4 yzyy => new float4(y, z, y, y);
        public float4 yzyz => new float4(y, z, y, z);
        public float4 yzyw => new float4(y, z, y, w);
        public float4 yzzx => new float4(y, z, z, x);
        public float4 yzzy => new float4(y, z, z, y);
        public float4 yzzz => new float4(y, z, z, z);
        public float4 yzzw => new float4(y, z, z, w);
        public float4 yzwx { get => new float4(y, z, w, x); set { y = value.x; z = value.y; w = value.z; x = value.w; } }
        public float4 yzwy => new float4(y, z, w, y);
        public float4 yzwz => new float4(y, z, w, z);
        public float4 yzww => new float4(y, z, w, w);
        public float4 ywxx => new float4(y, w, x, x);
        public float4 ywxy => new float4(y, w, x, y);
        public float4 ywxz { get => new float4(y, w, x, z); set { y = value.x; w = value.y; x = value.z; z = value.w; } }
        public float4 ywxw => new float4(y, w, x, w);
        public float4 ywyx => new float4(y, w, y, x);
        public float4 ywyy => new float4(y, w, y, y);
        public float4 ywyz => new float4(y, w, y, z);
        public float4 ywyw => new float4(y, w, y, w);
        public float4 ywzx { get => new float4(y, w, z, x); set { y = value.x; w = value.y; z = value.z; x = value.w; } }
        public float4 ywzy => new float4(y, w, z, y);
        public float4 ywzz => new float4(y, w, z, z);
        public float4 ywzw => new float4(y, w, z, w);
        public float4 ywwx => new float4(y, w, w, x);
        public float4 ywwy => new float4(y, w, w, y);
        public float4 ywwz => new float4(y, w, w, z);
        public float4 ywww => new float4(y, w, w, w);
        public float4 zxxx => new float4(z, x, x, x);
        public float4 zxxy => new float4(z, x, x, y);
        public float4 zxxz => new float4(z, x, x, z);
        public float4 zxxw => new float4(z, x, x, w);
        public float4 zxyx => new float4(z, x, y, x);
        public float4 zxyy => new float4(z, x, y, y);
        public float4 zxyz => new float4(z, x, y, z);
        public float4 zxyw { get => new float4(z, x, y, w); set { z = value.x; x = value.y; y = value.z; w = value.w; } }
        public float4 zxzx => new float4(z, x, z, x);
        public float4 zxzy => new float4(z, x, z, y);
        public float4 zxzz => new float4(z, x, z, z);
        public float4 zxzw => new float4(z, x, z, w);
        public float4 zxwx => new float4(z, x, w, x);
        public float4 zxwy { get => new float4(z, x, w, y); set { z = value.x; x = value.y; w = value.z; y = value.w; } }
        public float4 zxwz => new float4(z, x, w, z);
        public float4 zxww => new float4(z, x, w, w);
        public float4 zyxx => new float4(z, y, x, x);
        public float4 zyxy => new float4(z, y, x, y);
        public float4 zyxz => new float4(z, y, x, z);
        public float4 zyxw { get => new float4(z, y, x, w); set { z = value.x; y = value.y; x = value.z; w = value.w; } }
        public float4 zyyx => new float4(z, y, y, x);
        public float4 zyyy => new float4(z, y, y, y);
        public float4 zyyz => new float4(z, y, y, z);
        public float4 zyyw => new float4(z, y, y, w);
        public float4 zyzx => new float4(z, y, z, x);
        public float4 zyzy => new float4(z, y, z, y);
        public float4 zyzz => new float4(z, y, z, z);
        public float4 zyzw => new float4(z, y, z, w);
        public float4 zywx { get => new float4(z, y, w, x); set { z = value.x; y = value.y; w = value.z; x = value.w; } }
        public float4 zywy => new float4(z, y, w, y);
        public float4 zywz => new float4(z, y, w, z);
        public float4 zyww => new float4(z, y, w, w);
        public float4 zzxx => new float4(z, z, x, x);
        public float4 zzxy => new float4(z, z, x, y);
        public float4 zzxz => new float4(z, z, x, z);
        public float4 zzxw => new float4(z, z, x, w);
        public float4 zzyx => new float4(z, z, y, x);
        public float4 zzyy => new float4(z, z, y, y);
        public float4 zzyz => new float4(z, z, y, z);
        public float4 zzyw => new float4(z, z, y, w);
        public float4 zzzx => new float4(z, z, z, x);
        public float4 zzzy => new float4(z, z, z, y);
        public float4 zzzz => new float4(z, z, z, z);
        public float4 zzzw => new float4(z, z, z, w);
        public float4 zzwx => new float4(z, z, w, x);
        public float4 zzwy => new float4(z, z, w, y);
        public float4 zzwz => new float4(z, z, w, z);
        public float4 zzww => new float4(z, z, w, w);
        public float4 zwxx => new float4(z, w, x, x);
        public float4 zwxy { get => new float4(z, w, x, y); set { z = value.x; w = value.y; x = value.z; y = value.w; } }
        public float4 zwxz => new float4(z, w, x, z);
        public float4 zwxw => new float4(z, w, x, w);
        public float4 zwyx { get => new float4(z, w, y, x); set { z = value.x; w = value.y; y = value.z; x = value.w; } }
        public float4 zwyy => new float4(z, w, y, y);
        public float4 zwyz => new float4(z, w, y, z);
        public float4 zwyw => new float4(z, w, y, w);
        public float4 zwzx => new float4(z, w, z, x);
        public float4 zwzy => new float4(z, w, z, y);
        public float4 zwzz => new float4(z, w, z, z);
        public float4 zwzw => new float4(z, w, z, w);
        public float4 zwwx => new float4(z, w, w, x);
        public float4 zwwy => new float4(z, w, w, y);
        public float4 zwwz => new float4(z, w, w, z);
        public float4 zwww => new float4(z, w, w, w);
        public float4 wxxx => new float4(w, x, x, x);
        public float4 wxxy => new float4(w, x, x, y);
        public float4 wxxz => new float4(w, x, x, z);
        public float4 wxxw => new float4(w, x, x, w);
        public float4 wxyx => new float4(w, x, y, x);
        public float4 wxyy => new float4(w, x, y, y);
        public float4 wxyz { get => new float4(w, x, y, z); set { w = value.x; x = value.y; y = value.z; z = value.w; } }
        public float4 wxyw => new float4(w, x, y, w);
        public float4 wxzx => new float4(w, x, z, x);
        public float4 wxzy { get => new float4(w, x, z, y); set { w = value.x; x = value.y; z = value.z; y = value.w; } }
        public float4 wxzz => new float4(w, x, z, z);
        public float4 wxzw => new float4(w, x, z, w);
        public float4 wxwx => new float4(w, x, w, x);
        public float4 wxwy => new float4(w, x, w, y);
        public float4 wxwz => new float4(w, x, w, z);
        public float4 wxww => new float4(w, x, w, w);
        public float4 wyxx => new float4(w, y, x, x);
        public float4 wyxy => new float4(w, y, x, y);
        public float4 wyxz { get => new float4(w, y, x, z); set { w = value.x; y = value.y; x = value.z; z = value.w; } }
        public float4 wyxw => new float4(w, y, x, w);
        public float4 wyyx => new float4(w, y, y, x);
        public float4 wyyy => new float4(w, y, y, y);
        public float4 wyyz => new float4(w, y, y, z);
        public float4 wyyw => new float4(w, y, y, w);
        public float4 wyzx { get => new float4(w, y, z, x); set { w = value.x; y = value.y; z = value.z; x = value.w; } }
        public float4 wyzy => new float4(w, y, z, y);
        public float4 wyzz => new float4(w, y, z, z);
        public float4 wyzw => new float4(w, y, z, w);
        public float4 wywx => new float4(w, y, w, x);
        public float4 wywy => new float4(w, y, w, y);
        public float4 wywz => new float4(w, y, w, z);
        public float4 wyww => new float4(w, y, w, w);
        public float4 wzxx => new float4(w, z, x, x);
        public float4 wzxy { get => new float4(w, z, x, y); set { w = value.x; z = value.y; x = value.z; y = value.w; } }
        public float4 wzxz => new float4(w, z, x, z);
        public float4 wzxw => new float4(w, z, x, w);
        public float4 wzyx { get => new float4(w, z, y, x); set { w = value.x; z = value.y; y = value.z; x = value.w; } }
        public float4 wzyy => new float4(w, z, y, y);
        public float4 wzyz => new float4(w, z, y, z);
        public float4 wzyw => new float4(w, z, y, w);
        public float4 wzzx => new float4(w, z, z, x);
        public float4 wzzy => new float4(w, z, z, y);
        public float4 wzzz => new float4(w, z, z, z);
        public float4 wzzw => new float4(w, z, z, w);
        public float4 wzwx => new float4(w, z, w, x);
        public float4 wzwy => new float4(w, z, w, y);
        public float4 wzwz => new float4(w, z, w, z);
        public float4 wzww => new float4(w, z, w, w);
        public float4 wwxx => new float4(w, w, x, x);
        public float4 wwxy => new float4(w, w, x, y);
        public float4 wwxz => new float4(w, w, x, z);
        public float4 wwxw => new float4(w, w, x, w);
        public float4 wwyx => new float4(w, w, y, x);
        public float4 wwyy => new float4(w, w, y, y);
        public float4 wwyz => new float4(w, w, y, z);
        public float4 wwyw => new float4(w, w, y, w);
        public float4 wwzx => new float4(w, w, z, x);
        public float4 wwzy => new float4(w, w, z, y);
        public float4 wwzz => new float4(w, w, z, z);
        public float4 wwzw => new float4(w, w, z, w);
        public float4 wwwx => new float4(w, w, w, x);
        public float4 wwwy => new float4(w, w, w, y);
        public float4 wwwz => new float4(w, w, w, z);
        public float4 wwww => new float4(w, w, w, w);

        public bool Equals(float4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
        public override bool Equals(object o) => o is float4 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"float4({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f, {z.ToString(format, formatProvider)}f, {w.ToString(format, formatProvider)}f)";
    }

    [Serializable]
    public partial struct int2 : IEquatable<int2>, IFormattable
    {
        public int x;
        public int y;

        public static readonly int2 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(int x, int y) { this.x = x; this.y = y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(int2 xy) { this.x = xy.x; this.y = xy.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(int v) { this.x = v; this.y = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(bool v) { this.x = v ? 1 : 0; this.y = v ? 1 : 0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(bool2 v) { this.x = v.x ? 1 : 0; this.y = v.y ? 1 : 0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(uint v) { this.x = (int)v; this.y = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(uint2 v) { this.x = (int)v.x; this.y = (int)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(float v) { this.x = (int)v; this.y = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(float2 v) { this.x = (int)v.x; this.y = (int)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(double v) { this.x = (int)v; this.y = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int2(double2 v) { this.x = (int)v.x; this.y = (int)v.y; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator int2(int v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(bool v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(bool2 v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(uint v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(uint2 v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(float v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(float2 v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(double v) => new int2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int2(double2 v) => new int2(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator +(int2 lhs, int2 rhs) => new int2(lhs.x + rhs.x, lhs.y + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator +(int2 lhs, int rhs) => new int2(lhs.x + rhs, lhs.y + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator +(int lhs, int2 rhs) => new int2(lhs + rhs.x, lhs + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator -(int2 lhs, int2 rhs) => new int2(lhs.x - rhs.x, lhs.y - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator -(int2 lhs, int rhs) => new int2(lhs.x - rhs, lhs.y - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator -(int lhs, int2 rhs) => new int2(lhs - rhs.x, lhs - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator *(int2 lhs, int2 rhs) => new int2(lhs.x * rhs.x, lhs.y * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator *(int2 lhs, int rhs) => new int2(lhs.x * rhs, lhs.y * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator *(int lhs, int2 rhs) => new int2(lhs * rhs.x, lhs * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator /(int2 lhs, int2 rhs) => new int2(lhs.x / rhs.x, lhs.y / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator /(int2 lhs, int rhs) => new int2(lhs.x / rhs, lhs.y / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator /(int lhs, int2 rhs) => new int2(lhs / rhs.x, lhs / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator %(int2 lhs, int2 rhs) => new int2(lhs.x % rhs.x, lhs.y % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator %(int2 lhs, int rhs) => new int2(lhs.x % rhs, lhs.y % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator %(int lhs, int2 rhs) => new int2(lhs % rhs.x, lhs % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(int2 lhs, int2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(int2 lhs, int rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(int lhs, int2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(int2 lhs, int2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(int2 lhs, int rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(int lhs, int2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(int2 lhs, int2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(int2 lhs, int rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(int lhs, int2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(int2 lhs, int2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(int2 lhs, int rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(int lhs, int2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator +(int2 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator -(int2 val) => new int2(-val.x, -val.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator ++(int2 val) => new int2(val.x + 1, val.y + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator --(int2 val) => new int2(val.x - 1, val.y - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator &(int2 lhs, int2 rhs) => new int2(lhs.x & rhs.x, lhs.y & rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator &(int2 lhs, int rhs) => new int2(lhs.x & rhs, lhs.y & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator &(int lhs, int2 rhs) => new int2(lhs & rhs.x, lhs & rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator |(int2 lhs, int2 rhs) => new int2(lhs.x | rhs.x, lhs.y | rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator |(int2 lhs, int rhs) => new int2(lhs.x | rhs, lhs.y | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator |(int lhs, int2 rhs) => new int2(lhs | rhs.x, lhs | rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator ^(int2 lhs, int2 rhs) => new int2(lhs.x ^ rhs.x, lhs.y ^ rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator ^(int2 lhs, int rhs) => new int2(lhs.x ^ rhs, lhs.y ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator ^(int lhs, int2 rhs) => new int2(lhs ^ rhs.x, lhs ^ rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator ~(int2 val) => new int2(~val.x, ~val.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator <<(int2 x, int n) => new int2(x.x << n, x.y << n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int2 operator >>(int2 x, int n) => new int2(x.x >> n, x.y >> n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(int2 lhs, int2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(int2 lhs, int rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(int lhs, int2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(int2 lhs, int2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(int2 lhs, int rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(int lhs, int2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        public int this[int index]
        {
            get => index switch { 0 => x, 1 => y, _ => throw new ArgumentException($"int2 has components 0 to 1, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; default: throw new ArgumentException($"int2 has components 0 to 1, not {index}."); } }
        }

        public int2 xx => new int2(x, x);
        public int2 xy { get => new int2(x, y); set { x = value.x; y = value.y; } }
        public int2 yx { get => new int2(y, x); set { y = value.x; x = value.y; } }
        public int2 yy => new int2(y, y);
        public int3 xxx => new int3(x, x, x);
        public int3 xxy => new int3(x, x, y);
        public int3 xyx => new int3(x, y, x);
        public int3 xyy => new int3(x, y, y);
        public int3 yxx => new int3(y, x, x);
        public int3 yxy => new int3(y, x, y);
        public int3 yyx => new int3(y, y, x);
        public int3 yyy => new int3(y, y, y);
        public int4 xxxx => new int4(x, x, x, x);
        public int4 xxxy => new int4(x, x, x, y);
        public int4 xxyx => new int4(x, x, y, x);
        public int4 xxyy => new int4(x, x, y, y);
        public int4 xyxx => new int4(x, y, x, x);
        public int4 xyxy => new int4(x, y, x, y);
        public int4 xyyx => new int4(x, y, y, x);
        public int4 xyyy => new int4(x, y, y, y);
        public int4 yxxx => new int4(y, x, x, x);
        public int4 yxxy => new int4(y, x, x, y);
        public int4 yxyx => new int4(y, x, y, x);
        public int4 yxyy => new int4(y, x, y, y);
        public int4 yyxx => new int4(y, y, x, x);
        public int4 yyxy => new int4(y, y, x, y);
        public int4 yyyx => new int4(y, y, y, x);
        public int4 yyyy => new int4(y, y, y, y);

        public bool Equals(int2 rhs) => x == rhs.x && y == rhs.y;
        public override bool Equals(object o) => o is int2 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"int2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct int3 : IEquatable<int3>, IFormattable
    {
        public int x;
        public int y;
        public int z;

        public static readonly int3 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(int x, int y, int z) { this.x = x; this.y = y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(int x, int2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(int2 xy, int z) { this.x = xy.x; this.y = xy.y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(int3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(int v) { this.x = v; this.y = v; this.z = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(bool v) { this.x = v ? 1 : 0; this.y = v ? 1 : 0; this.z = v ? 1 : 0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(bool3 v) { this.x = v.x ? 1 : 0; this.y = v.y ? 1 : 0; this.z = v.z ? 1 : 0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(uint v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(uint3 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(float v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(float3 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(double v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int3(double3 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator int3(int v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(bool v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(bool3 v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(uint v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(uint3 v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(float v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(float3 v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(double v) => new int3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int3(double3 v) => new int3(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator +(int3 lhs, int3 rhs) => new int3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator +(int3 lhs, int rhs) => new int3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator +(int lhs, int3 rhs) => new int3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator -(int3 lhs, int3 rhs) => new int3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator -(int3 lhs, int rhs) => new int3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator -(int lhs, int3 rhs) => new int3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator *(int3 lhs, int3 rhs) => new int3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator *(int3 lhs, int rhs) => new int3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator *(int lhs, int3 rhs) => new int3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator /(int3 lhs, int3 rhs) => new int3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator /(int3 lhs, int rhs) => new int3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator /(int lhs, int3 rhs) => new int3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator %(int3 lhs, int3 rhs) => new int3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator %(int3 lhs, int rhs) => new int3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator %(int lhs, int3 rhs) => new int3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(int3 lhs, int3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(int3 lhs, int rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(int lhs, int3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(int3 lhs, int3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(int3 lhs, int rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(int lhs, int3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(int3 lhs, int3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(int3 lhs, int rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(int lhs, int3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(int3 lhs, int3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(int3 lhs, int rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(int lhs, int3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator +(int3 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator -(int3 val) => new int3(-val.x, -val.y, -val.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator ++(int3 val) => new int3(val.x + 1, val.y + 1, val.z + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator --(int3 val) => new int3(val.x - 1, val.y - 1, val.z - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator &(int3 lhs, int3 rhs) => new int3(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator &(int3 lhs, int rhs) => new int3(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator &(int lhs, int3 rhs) => new int3(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator |(int3 lhs, int3 rhs) => new int3(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator |(int3 lhs, int rhs) => new int3(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator |(int lhs, int3 rhs) => new int3(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator ^(int3 lhs, int3 rhs) => new int3(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator ^(int3 lhs, int rhs) => new int3(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator ^(int lhs, int3 rhs) => new int3(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator ~(int3 val) => new int3(~val.x, ~val.y, ~val.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator <<(int3 x, int n) => new int3(x.x << n, x.y << n, x.z << n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int3 operator >>(int3 x, int n) => new int3(x.x >> n, x.y >> n, x.z >> n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(int3 lhs, int3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(int3 lhs, int rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(int lhs, int3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(int3 lhs, int3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(int3 lhs, int rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(int lhs, int3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        public int this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new ArgumentException($"int3 has components 0 to 2, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; default: throw new ArgumentException($"int3 has components 0 to 2, not {index}."); } }
        }

        public int2 xx => new int2(x, x);
        public int2 xy { get => new int2(x, y); set { x = value.x; y = value.y; } }
        public int2 xz { get => new int2(x, z); set { x = value.x; z = value.y; } }
        public int2 yx { get => new int2(y, x); set { y = value.x; x = value.y; } }
        public int2 yy => new int2(y, y);
        public int2 yz { get => new int2(y, z); set { y = value.x; z = value.y; } }
        public int2 zx { get => new int2(z, x); set { z = value.x; x = value.y; } }
        public int2 zy { get => new int2(z, y); set { z = value.x; y = value.y; } }
        public int2 zz => new int2(z, z);
        public int3 xxx => new int3(x, x, x);
        public int3 xxy => new int3(x, x, y);
        public int3 xxz => new int3(x, x, z);
        public int3 xyx => new int3(x, y, x);
        public int3 xyy => new int3(x, y, y);
        public int3 xyz { get => new int3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public int3 xzx => new int3(x, z, x);
        public int3 xzy { get => new int3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public int3 xzz => new int3(x, z, z);
        public int3 yxx => new int3(y, x, x);
        public int3 yxy => new int3(y, x, y);
        public int3 yxz { get => new int3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public int3 yyx => new int3(y, y, x);
        public int3 yyy => new int3(y, y, y);
        public int3 yyz => new int3(y, y, z);
        public int3 yzx { get => new int3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public int3 yzy => new int3(y, z, y);
        public int3 yzz => new int3(y, z, z);
        public int3 zxx => new int3(z, x, x);
        public int3 zxy { get => new int3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public int3 zxz => new int3(z, x, z);
        public int3 zyx { get => new int3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public int3 zyy => new int3(z, y, y);
        public int3 zyz => new int3(z, y, z);
        public int3 zzx => new int3(z, z, x);
        public int3 zzy => new int3(z, z, y);
        public int3 zzz => new int3(z, z, z);
        public int4 xxxx => new int4(x, x, x, x);
        public int4 xxxy => new int4(x, x, x, y);
        public int4 xxxz => new int4(x, x, x, z);
        public int4 xxyx => new int4(x, x, y, x);
        public int4 xxyy => new int4(x, x, y, y);
        public int4 xxyz => new int4(x, x, y, z);
        public int4 xxzx => new int4(x, x, z, x);
        public int4 xxzy => new int4(x, x, z, y);
        public int4 xxzz => new int4(x, x, z, z);
        public int4 xyxx => new int4(x, y, x, x);
        public int4 xyxy => new int4(x, y, x, y);
        public int4 xyxz => new int4(x, y, x, z);
        public int4 xyyx => new int4(x, y, y, x);
        public int4 xyyy => new int4(x, y, y, y);
        public int4 xyyz => new int4(x, y, y, z);
        public int4 xyzx => new int4(x, y, z, x);
        public int4 xyzy => new int4(x, y, z, y);
        public int4 xyzz => new int4(x, y, z, z);
        public int4 xzxx => new int4(x, z, x, x);
        public int4 xzxy => new int4(x, z, x, y);
        public int4 xzxz => new int4(x, z, x, z);
        public int4 xzyx => new int4(x, z, y, x);
        public int4 xzyy => new int4(x, z, y, y);
        public int4 xzyz => new int4(x, z, y, z);
        public int4 xzzx => new int4(x, z, z, x);
        public int4 xzzy => new int4(x, z, z, y);
        public int4 xzzz => new int4(x, z, z, z);
        public int4 yxxx => new int4(y, x, x, x);
        public int4 yxxy => new int4(y, x, x, y);
        public int4 yxxz => new int4(y, x, x, z);
        public int4 yxyx => new int4(y, x, y, x);
        public int4 yxyy => new int4(y, x, y, y);
        public int4 yxyz => new int4(y, x, y, z);
        public int4 yxzx => new int4(y, x, z, x);
        public int4 yxzy => new int4(y, x, z, y);
        public int4 yxzz => new int4(y, x, z, z);
        public int4 yyxx => new int4(y, y, x, x);
        public int4 yyxy => new int4(y, y, x, y);
        public int4 yyxz => new int4(y, y, x, z);
        public int4 yyyx => new int4(y, y, y, x);
        public int4 yyyy => new int4(y, y, y, y);
        public int4 yyyz => new int4(y, y, y, z);
        public int4 yyzx => new int4(y, y, z, x);
        public int4 yyzy => new int4(y, y, z, y);
        public int4 yyzz => new int4(y, y, z, z);
        public int4 yzxx => new int4(y, z, x, x);
        public int4 yzxy => new int4(y, z, x, y);
        public int4 yzxz => new int4(y, z, x, z);
        public int4 yzyx => new int4(y, z, y, x);
        public int4 yzyy => new int4(y, z, y, y);
        public int4 yzyz => new int4(y, z, y, z);
        public int4 yzzx => new int4(y, z, z, x);
        public int4 yzzy => new int4(y, z, z, y);
        public int4 yzzz => new int4(y, z, z, z);
        public int4 zxxx => new int4(z, x, x, x);
        public int4 zxxy => new int4(z, x, x, y);
        public int4 zxxz => new int4(z, x, x, z);
        public int4 zxyx => new int4(z, x, y, x);
        public int4 zxyy => new int4(z, x, y, y);
        public int4 zxyz => new int4(z, x, y, z);
        public int4 zxzx => new int4(z, x, z, x);
        public int4 zxzy => new int4(z, x, z, y);
        public int4 zxzz => new int4(z, x, z, z);
        public int4 zyxx => new int4(z, y, x, x);
        public int4 zyxy => new int4(z, y, x, y);
        public int4 zyxz => new int4(z, y, x, z);
        public int4 zyyx => new int4(z, y, y, x);
        public int4 zyyy => new int4(z, y, y, y);
        public int4 zyyz => new int4(z, y, y, z);
        public int4 zyzx => new int4(z, y, z, x);
        public int4 zyzy => new int4(z, y, z, y);
        public int4 zyzz => new int4(z, y, z, z);
        public int4 zzxx => new int4(z, z, x, x);
        public int4 zzxy => new int4(z, z, x, y);
        public int4 zzxz => new int4(z, z, x, z);
        public int4 zzyx => new int4(z, z, y, x);
        public int4 zzyy => new int4(z, z, y, y);
        public int4 zzyz => new int4(z, z, y, z);
        public int4 zzzx => new int4(z, z, z, x);
        public int4 zzzy => new int4(z, z, z, y);
        public int4 zzzz => new int4(z, z, z, z);

        public bool Equals(int3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
        public override bool Equals(object o) => o is int3 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"int3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct int4 : IEquatable<int4>, IFormattable
    {
        public int x;
        public int y;
        public int z;
        public int w;

        public static readonly int4 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int x, int y, int z, int w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int x, int y, int2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int x, int2 yz, int w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int x, int3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int2 xy, int z, int w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int2 xy, int2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int3 xyz, int w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(int v) { this.x = v; this.y = v; this.z = v; this.w = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(bool v) { this.x = v ? 1 : 0; this.y = v ? 1 : 0; this.z = v ? 1 : 0; this.w = v ? 1 : 0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(bool4 v) { this.x = v.x ? 1 : 0; this.y = v.y ? 1 : 0; this.z = v.z ? 1 : 0; this.w = v.w ? 1 : 0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(uint v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; this.w = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(uint4 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; this.w = (int)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(float v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; this.w = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(float4 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; this.w = (int)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(double v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; this.w = (int)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public int4(double4 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; this.w = (int)v.w; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator int4(int v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(bool v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(bool4 v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(uint v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(uint4 v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(float v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(float4 v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(double v) => new int4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator int4(double4 v) => new int4(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator +(int4 lhs, int4 rhs) => new int4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator +(int4 lhs, int rhs) => new int4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator +(int lhs, int4 rhs) => new int4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator -(int4 lhs, int4 rhs) => new int4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator -(int4 lhs, int rhs) => new int4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator -(int lhs, int4 rhs) => new int4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator *(int4 lhs, int4 rhs) => new int4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator *(int4 lhs, int rhs) => new int4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator *(int lhs, int4 rhs) => new int4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator /(int4 lhs, int4 rhs) => new int4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator /(int4 lhs, int rhs) => new int4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator /(int lhs, int4 rhs) => new int4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator %(int4 lhs, int4 rhs) => new int4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator %(int4 lhs, int rhs) => new int4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator %(int lhs, int4 rhs) => new int4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(int4 lhs, int4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(int4 lhs, int rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(int lhs, int4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(int4 lhs, int4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(int4 lhs, int rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(int lhs, int4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(int4 lhs, int4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(int4 lhs, int rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(int lhs, int4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(int4 lhs, int4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(int4 lhs, int rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(int lhs, int4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator +(int4 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator -(int4 val) => new int4(-val.x, -val.y, -val.z, -val.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator ++(int4 val) => new int4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator --(int4 val) => new int4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator &(int4 lhs, int4 rhs) => new int4(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator &(int4 lhs, int rhs) => new int4(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator &(int lhs, int4 rhs) => new int4(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator |(int4 lhs, int4 rhs) => new int4(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator |(int4 lhs, int rhs) => new int4(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator |(int lhs, int4 rhs) => new int4(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator ^(int4 lhs, int4 rhs) => new int4(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator ^(int4 lhs, int rhs) => new int4(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator ^(int lhs, int4 rhs) => new int4(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator ~(int4 val) => new int4(~val.x, ~val.y, ~val.z, ~val.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator <<(int4 x, int n) => new int4(x.x << n, x.y << n, x.z << n, x.w << n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static int4 operator >>(int4 x, int n) => new int4(x.x >> n, x.y >> n, x.z >> n, x.w >> n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(int4 lhs, int4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(int4 lhs, int rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(int lhs, int4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(int4 lhs, int4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(int4 lhs, int rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(int lhs, int4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        public int this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new ArgumentException($"int4 has components 0 to 3, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; case 3: w = value; break; default: throw new ArgumentException($"int4 has components 0 to 3, not {index}."); } }
        }

        public int2 xx => new int2(x, x);
        public int2 xy { get => new int2(x, y); set { x = value.x; y = value.y; } }
        public int2 xz { get => new int2(x, z); set { x = value.x; z = value.y; } }
        public int2 xw { get => new int2(x, w); set { x = value.x; w = value.y; } }
        public int2 yx { get => new int2(y, x); set { y = value.x; x = value.y; } }
        public int2 yy => new int2(y, y);
        public int2 yz { get => new int2(y, z); set { y = value.x; z = value.y; } }
        public int2 yw { get => new int2(y, w); set { y = value.x; w = value.y; } }
        public int2 zx { get => new int2(z, x); set { z = value.x; x = value.y; } }
        public int2 zy { get => new int2(z, y); set { z = value.x; y = value.y; } }
        public int2 zz => new int2(z, z);
        public int2 zw { get => new int2(z, w); set { z = value.x; w = value.y; } }
        public int2 wx { get => new int2(w, x); set { w = value.x; x = value.y; } }
        public int2 wy { get => new int2(w, y); set { w = value.x; y = value.y; } }
        public int2 wz { get => new int2(w, z); set { w = value.x; z = value.y; } }
        public int2 ww => new int2(w, w);
        public int3 xxx => new int3(x, x, x);
        public int3 xxy => new int3(x, x, y);
        public int3 xxz => new int3(x, x, z);
        public int3 xxw => new int3(x, x, w);
        public int3 xyx => new int3(x, y, x);
        public int3 xyy => new int3(x, y, y);
        public int3 xyz { get => new int3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public int3 xyw { get => new int3(x, y, w); set { x = value.x; y = value.y; w = value.z; } }
        public int3 xzx => new int3(x, z, x);
        public int3 xzy { get => new int3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public int3 xzz => new int3(x, z, z);
        public int3 xzw { get => new int3(x, z, w); set { x = value.x; z = value.y; w = value.z; } }
        public int3 xwx => new int3(x, w, x);
        public int3 xwy { get => new int3(x, w, y); set { x = value.x; w = value.y; y = value.z; } }
        public int3 xwz { get => new int3(x, w, z); set { x = value.x; w = value.y; z = value.z; } }
        public int3 xww => new int3(x, w, w);
        public int3 yxx => new int3(y, x, x);
        public int3 yxy => new int3(y, x, y);
        public int3 yxz { get => new int3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public int3 yxw { get => new int3(y, x, w); set { y = value.x; x = value.y; w = value.z; } }
        public int3 yyx => new int3(y, y, x);
        public int3 yyy => new int3(y, y, y);
        public int3 yyz => new int3(y, y, z);
        public int3 yyw => new int3(y, y, w);
        public int3 yzx { get => new int3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public int3 yzy => new int3(y, z, y);
        public int3 yzz => new int3(y, z, z);
        public int3 yzw { get => new int3(y, z, w); set { y = value.x; z = value.y; w = value.z; } }
        public int3 ywx { get => new int3(y, w, x); set { y = value.x; w = value.y; x = value.z; } }
        public int3 ywy => new int3(y, w, y);
        public int3 ywz { get => new int3(y, w, z); set { y = value.x; w = value.y; z = value.z; } }
        public int3 yww => new int3(y, w, w);
        public int3 zxx => new int3(z, x, x);
        public int3 zxy { get => new int3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public int3 zxz => new int3(z, x, z);
        public int3 zxw { get => new int3(z, x, w); set { z = value.x; x = value.y; w = value.z; } }
        public int3 zyx { get => new int3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public int3 zyy => new int3(z, y, y);
        public int3 zyz => new int3(z, y, z);
        public int3 zyw { get => new int3(z, y, w); set { z = value.x; y = value.y; w = value.z; } }
        public int3 zzx => new int3(z, z, x);
        public int3 zzy => new int3(z, z, y);
        public int3 zzz => new int3(z, z, z);
        public int3 zzw => new int3(z, z, w);
        public int3 zwx { get => new int3(z, w, x); set { z = value.x; w = value.y; x = value.z; } }
        public int3 zwy { get => new int3(z, w, y); set { z = value.x; w = value.y; y = value.z; } }
        public int3 zwz => new int3(z, w, z);
        public int3 zww => new int3(z, w, w);
        public int3 wxx => new int3(w, x, x);
        public int3 wxy { get => new int3(w, x, y); set { w = value.x; x = value.y; y = value.z; } }
        public int3 wxz { get => new int3(w, x, z); set { w = value.x; x = value.y; z = value.z; } }
        public int3 wxw => new int3(w, x, w);
        public int3 wyx { get => new int3(w, y, x); set { w = value.x; y = value.y; x = value.z; } }
        public int3 wyy => new int3(w, y, y);
        public int3 wyz { get => new int3(w, y, z); set { w = value.x; y = value.y; z = value.z; } }
        public int3 wyw => new int3(w, y, w);
        public int3 wzx { get => new int3(w, z, x); set { w = value.x; z = value.y; x = value.z; } }
        public int3 wzy { get => new int3(w, z, y); set { w = value.x; z = value.y; y = value.z; } }
        public int3 wzz => new int3(w, z, z);
        public int3 wzw => new int3(w, z, w);
        public int3 wwx => new int3(w, w, x);
        public int3 wwy => new int3(w, w, y);
        public int3 wwz => new int3(w, w, z);
        public int3 www => new int3(w, w, w);
        public int4 xxxx => new int4(x, x, x, x);
        public int4 xxxy => new int4(x, x, x, y);
        public int4 xxxz => new int4(x, x, x, z);
        public int4 xxxw => new int4(x, x, x, w);
        public int4 xxyx => new int4(x, x, y, x);
        public int4 xxyy => new int4(x, x, y, y);
        public int4 xxyz => new int4(x, x, y, z);
        public int4 xxyw => new int4(x, x, y, w);
        public int4 xxzx => new int4(x, x, z, x);
        public int4 xxzy => new int4(x, x, z, y);
        public int4 xxzz => new int4(x, x, z, z);
        public int4 xxzw => new int4(x, x, z, w);
        public int4 xxwx => new int4(x, x, w, x);
        public int4 xxwy => new int4(x, x, w, y);
        public int4 xxwz => new int4(x, x, w, z);
        public int4 xxww => new int4(x, x, w, w);
        public int4 xyxx => new int4(x, y, x, x);
        public int4 xyxy => new int4(x, y, x, y);
        public int4 xyxz => new int4(x, y, x, z);
        public int4 xyxw => new int4(x, y, x, w);
        public int4 xyyx => new int4(x, y, y, x);
        public int4 xyyy => new int4(x, y, y, y);
        public int4 xyyz => new int4(x, y, y, z);
        public int4 xyyw => new int4(x, y, y, w);
        public int4 xyzx => new int4(x, y, z, x);
        public int4 xyzy => new int4(x, y, z, y);
        public int4 xyzz => new int4(x, y, z, z);
        public int4 xyzw { get => new int4(x, y, z, w); set { x = value.x; y = value.y; z = value.z; w = value.w; } }
        public int4 xywx => new int4(x, y, w, x);
        public int4 xywy => new int4(x, y, w, y);
        public int4 xywz { get => new int4(x, y, w, z); set { x = value.x; y = value.y; w = value.z; z = value.w; } }
        public int4 xyww => new int4(x, y, w, w);
        public int4 xzxx => new int4(x, z, x, x);
        public int4 xzxy => new int4(x, z, x, y);
        public int4 xzxz => new int4(x, z, x, z);
        public int4 xzxw => new int4(x, z, x, w);
        public int4 xzyx => new int4(x, z, y, x);
        public int4 xzyy => new int4(x, z, y, y);
        public int4 xzyz => new int4(x, z, y, z);
        public int4 xzyw { get => new int4(x, z, y, w); set { x = value.x; z = value.y; y = value.z; w = value.w; } }
        public int4 xzzx => new int4(x, z, z, x);
        public int4 xzzy => new int4(x, z, z, y);
        public int4 xzzz => new int4(x, z, z, z);
        public int4 xzzw => new int4(x, z, z, w);
        public int4 xzwx => new int4(x, z, w, x);
        public int4 xzwy { get => new int4(x, z, w, y); set { x = value.x; z = value.y; w = value.z; y = value.w; } }
        public int4 xzwz => new int4(x, z, w, z);
        public int4 xzww => new int4(x, z, w, w);
        public int4 xwxx => new int4(x, w, x, x);
        public int4 xwxy => new int4(x, w, x, y);
        public int4 xwxz => new int4(x, w, x, z);
        public int4 xwxw => new int4(x, w, x, w);
        public int4 xwyx => new int4(x, w, y, x);
        public int4 xwyy => new int4(x, w, y, y);
        public int4 xwyz { get => new int4(x, w, y, z); set { x = value.x; w = value.y; y = value.z; z = value.w; } }
        public int4 xwyw => new int4(x, w, y, w);
        public int4 xwzx => new int4(x, w, z, x);
        public int4 xwzy { get => new int4(x, w, z, y); set { x = value.x; w = value.y; z = value.z; y = value.w; } }
        public int4 xwzz => new int4(x, w, z, z);
        public int4 xwzw => new int4(x, w, z, w);
        public int4 xwwx => new int4(x, w, w, x);
        public int4 xwwy => new int4(x, w, w, y);
        public int4 xwwz => new int4(x, w, w, z);
        public int4 xwww => new int4(x, w, w, w);
        public int4 yxxx => new int4(y, x, x, x);
        public int4 yxxy => new int4(y, x, x, y);
        public int4 yxxz => new int4(y, x, x, z);
        public int4 yxxw => new int4(y, x, x, w);
        public int4 yxyx => new int4(y, x, y, x);
        public int4 yxyy => new int4(y, x, y, y);
        public int4 yxyz => new int4(y, x, y, z);
        public int4 yxyw => new int4(y, x, y, w);
        public int4 yxzx => new int4(y, x, z, x);
        public int4 yxzy => new int4(y, x, z, y);
        public int4 yxzz => new int4(y, x, z, z);
        public int4 yxzw { get => new int4(y, x, z, w); set { y = value.x; x = value.y; z = value.z; w = value.w; } }
        public int4 yxwx => new int4(y, x, w, x);
        public int4 yxwy => new int4(y, x, w, y);
        public int4 yxwz { get => new int4(y, x, w, z); set { y = value.x; x = value.y; w = value.z; z = value.w; } }
        public int4 yxww => new int4(y, x, w, w);
        public int4 yyxx => new int4(y, y, x, x);
        public int4 yyxy => new int4(y, y, x, y);
        public int4 yyxz => new int4(y, y, x, z);
        public int4 yyxw => new int4(y, y, x, w);
        public int4 yyyx => new int4(y, y, y, x);
        public int4 yyyy => new int4(y, y, y, y);
        public int4 yyyz => new int4(y, y, y, z);
        public int4 yyyw => new int4(y, y, y, w);
        public int4 yyzx => new int4(y, y, z, x);
        public int4 yyzy => new int4(y, y, z, y);
        public int4 yyzz => new int4(y, y, z, z);
        public int4 yyzw => new int4(y, y, z, w);
        public int4 yywx => new int4(y, y, w, x);
        public int4 yywy => new int4(y, y, w, y);
        public int4 yywz => new int4(y, y, w, z);
        public int4 yyww => new int4(y, y, w, w);
        public int4 yzxx => new int4(y, z, x, x);
        public int4 yzxy => new int4(y, z, x, y);
        public int4 yzxz => new int4(y, z, x, z);
        public int4 yzxw { get => new int4(y, z, x, w); set { y = value.x; z = value.y; x = value.z; w = value.w; } }
        public int4 yzyx => new int4(y, z, y, x);
        public int4 yzyy => new int4(y, z, y, y);
        public int4 yzyz => new int4(y, z, y, z);
        public int4 yzyw => new int4(y, z, y, w);
        public int4 yzzx => new int4(y, z, z, x);
        public int4 yzzy => new int4(y, z, z, y);
        public int4 yzzz => new int4(y, z, z, z);
        public int4 yzzw => new int4(y, z, z, w);
        public int4 yzwx { get => new int4(y, z, w, x); set { y = value.x; z = value.y; w = value.z; x = value.w; } }
        public int4 yzwy => new int4(y, z, w, y);
        public int4 yzwz => new int4(y, z, w, z);
        public int4 yzww => new int4(y, z, w, w);
        public int4 ywxx => new int4(y, w, x, x);
        public int4 ywxy => new int4(y, w, x, y);
        public int4 ywxz { get => new int4(y, w, x, z); set { y = value.x; w = value.y; x = value.z; z = value.w; } }
        public int4 ywxw => new int4(y, w, x, w);
        public int4 ywyx => new int4(y, w, y, x);
        public int4 ywyy => new int4(y, w, y, y);
        public int4 ywyz => new int4(y, w, y, z);
        public int4 ywyw => new int4(y, w, y, w);
        public int4 ywzx { get => new int4(y, w, z, x); set { y = value.x; w = value.y; z = value.z; x = value.w; } }
        public int4 ywzy => new int4(y, w, z, y);
        public int4 ywzz => new int4(y, w, z, z);
        public int4 ywzw => new int4(y, w, z, w);
        public int4 ywwx => new int4(y, w, w, x);
        public int4 ywwy => new int4(y, w, w, y);
        public int4 ywwz => new int4(y, w, w, z);
        public int4 ywww => new int4(y, w, w, w);
        public int4 zxxx => new int4(z, x, x, x);
        public int4 zxxy => new int4(z, x, x, y);
        public int4 zxxz => new int4(z, x, x, z);
        public int4 zxxw => new int4(z, x, x, w);
        public int4 zxyx => new int4(z, x, y, x);
        public int4 zxyy => new int4(z, x, y, y);
        public int4 zxyz => new int4(z, x, y, z);
        public int4 zxyw { get => new int4(z, x, y, w); set { z = value.x; x = value.y; y = value.z; w = value.w; } }
        public int4 zxzx => new int4(z, x, z, x);
        public int4 zxzy => new int4(z, x, z, y);
        public int4 zxzz => new int4(z, x, z, z);
        public int4 zxzw => new int4(z, x, z, w);
        public int4 zxwx => new int4(z, x, w, x);
        public int4 zxwy { get => new int4(z, x, w, y); set { z = value.x; x = value.y; w = value.z; y = value.w; } }
        public int4 zxwz => new int4(z, x, w, z);
        public int4 zxww => new int4(z, x, w, w);
        public int4 zyxx => new int4(z, y, x, x);
        public int4 zyxy => new int4(z, y, x, y);
        public int4 zyxz => new int4(z, y, x, z);
        public int4 zyxw { get => new int4(z, y, x, w); set { z = value.x; y = value.y; x = value.z; w = value.w; } }
        public int4 zyyx => new int4(z, y, y, x);
        public int4 zyyy => new int4(z, y, y, y);
        public int4 zyyz => new int4(z, y, y, z);
        public int4 zyyw => new int4(z, y, y, w);
        public int4 zyzx => new int4(z, y, z, x);
        public int4 zyzy => new int4(z, y, z, y);
        public int4 zyzz => new int4(z, y, z, z);
        public int4 zyzw => new int4(z, y, z, w);
        public int4 zywx { get => new int4(z, y, w, x); set { z = value.x; y = value.y; w = value.z; x = value.w; } }
        public int4 zywy => new int4(z, y, w, y);
        public int4 zywz => new int4(z, y, w, z);
        public int4 zyww => new int4(z, y, w, w);
        public int4 zzxx => new int4(z, z, x, x);
        public int4 zzxy => new int4(z, z, x, y);
        public int4 zzxz => new int4(z, z, x, z);
        public int4 zzxw => new int4(z, z, x, w);
        public int4 zzyx => new int4(z, z, y, x);
        public int4 zzyy => new int4(z, z, y, y);
        public int4 zzyz => new int4(z, z, y, z);
        public int4 zzyw => new int4(z, z, y, w);
        public int4 zzzx => new int4(z, z, z, x);
        public int4 zzzy => new int4(z, z, z, y);
        public int4 zzzz => new int4(z, z, z, z);
        public int4 zzzw => new int4(z, z, z, w);
        public int4 zzwx => new int4(z, z, w, x);
        public int4 zzwy => new int4(z, z, w, y);
        public int4 zzwz => new int4(z, z, w, z);
        public int4 zzww => new int4(z, z, w, w);
        public int4 zwxx => new int4(z, w, x, x);
        public int4 zwxy { get => new int4(z, w, x, y); set { z = value.x; w = value.y; x = value.z; y = value.w; } }
        public int4 zwxz => new int4(z, w, x, z);
        public int4 zwxw => new int4(z, w, x, w);
        public int4 zwyx { get => new int4(z, w, y, x); set { z = value.x; w = value.y; y = value.z; x = value.w; } }
        public int4 zwyy => new int4(z, w, y, y);
        public int4 zwyz => new int4(z, w, y, z);
        public int4 zwyw => new int4(z, w, y, w);
        public int4 zwzx => new int4(z, w, z, x);
        public int4 zwzy => new int4(z, w, z, y);
        public int4 zwzz => new int4(z, w, z, z);
        public int4 zwzw => new int4(z, w, z, w);
        public int4 zwwx => new int4(z, w, w, x);
        public int4 zwwy => new int4(z, w, w, y);
        public int4 zwwz => new int4(z, w, w, z);
        public int4 zwww => new int4(z, w, w, w);
        public int4 wxxx => new int4(w, x, x, x);
        public int4 wxxy => new int4(w, x, x, y);
        public int4 wxxz => new int4(w, x, x, z);
        public int4 wxxw => new int4(w, x, x, w);
        public int4 wxyx => new int4(w, x, y, x);
        public int4 wxyy => new int4(w, x, y, y);
        public int4 wxyz { get => new int4(w, x, y, z); set { w = value.x; x = value.y; y = value.z; z = value.w; } }
        public int4 wxyw => new int4(w, x, y, w);
        public int4 wxzx => new int4(w, x, z, x);
        public int4 wxzy { get => new int4(w, x, z, y); set { w = value.x; x = value.y; z = value.z; y = value.w; } }
        public int4 wxzz => new int4(w, x, z, z);
        public int4 wxzw => new int4(w, x, z, w);
        public int4 wxwx => new int4(w, x, w, x);
        public int4 wxwy => new int4(w, x, w, y);
        public int4 wxwz => new int4(w, x, w, z);
        public int4 wxww => new int4(w, x, w, w);
        public int4 wyxx => new int4(w, y, x, x);
        public int4 wyxy => new int4(w, y, x, y);
        public int4 wyxz { get => new int4(w, y, x, z); set { w = value.x; y = value.y; x = value.z; z = value.w; } }
        public int4 wyxw => new int4(w, y, x, w);
        public int4 wyyx => new int4(w, y, y, x);
        public int4 wyyy => new int4(w, y, y, y);
        public int4 wyyz => new int4(w, y, y, z);
        public int4 wyyw => new int4(w, y, y, w);
        public int4 wyzx { get => new int4(w, y, z, x); set { w = value.x; y = value.y; z = value.z; x = value.w; } }
        public int4 wyzy => new int4(w, y, z, y);
        public int4 wyzz => new int4(w, y, z, z);
        public int4 wyzw => new int4(w, y, z, w);
        public int4 wywx => new int4(w, y, w, x);
        public int4 wywy => new int4(w, y, w, y);
        public int4 wywz => new int4(w, y, w, z);
        public int4 wyww => new int4(w, y, w, w);
        public int4 wzxx => new int4(w, z, x, x);
        public int4 wzxy { get => new int4(w, z, x, y); set { w = value.x; z = value.y; x = value.z; y = value.w; } }
        public int4 wzxz => new int4(w, z, x, z);
        public int4 wzxw => new int4(w, z, x, w);
        public int4 wzyx { get => new int4(w, z, y, x); set { w = value.x; z = value.y; y = value.z; x = value.w; } }
        public int4 wzyy => new int4(w, z, y, y);
        public int4 wzyz => new int4(w, z, y, z);
        public int4 wzyw => new int4(w, z, y, w);
        public int4 wzzx => new int4(w, z, z, x);
        public int4 wzzy => new int4(w, z, z, y);
        public int4 wzzz => new int4(w, z, z, z);
        public int4 wzzw => new int4(w, z, z, w);
        public int4 wzwx => new int4(w, z, w, x);
        public int4 wzwy => new int4(w, z, w, y);
        public int4 wzwz => new int4(w, z, w, z);
        public int4 wzww => new int4(w, z, w, w);
        public int4 wwxx => new int4(w, w, x, x);
        public int4 wwxy => new int4(w, w, x, y);
        public int4 wwxz => new int4(w, w, x, z);
        public int4 wwxw => new int4(w, w, x, w);
        public int4 wwyx => new int4(w, w, y, x);
        public int4 wwyy => new int4(w, w, y, y);
        public int4 wwyz => new int4(w, w, y, z);
        public int4 wwyw => new int4(w, w, y, w);
        public int4 wwzx => new int4(w, w, z, x);
        public int4 wwzy => new int4(w, w, z, y);
        public int4 wwzz => new int4(w, w, z, z);
        public int4 wwzw => new int4(w, w, z, w);
        public int4 wwwx => new int4(w, w, w, x);
        public int4 wwwy => new int4(w, w, w, y);
        public int4 wwwz => new int4(w, w, w, z);
        public int4 wwww => new int4(w, w, w, w);

        public bool Equals(int4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
        public override bool Equals(object o) => o is int4 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"int4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct uint2 : IEquatable<uint2>, IFormattable
    {
        public uint x;
        public uint y;

        public static readonly uint2 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(uint x, uint y) { this.x = x; this.y = y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(uint2 xy) { this.x = xy.x; this.y = xy.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(uint v) { this.x = v; this.y = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(bool v) { this.x = v ? 1u : 0u; this.y = v ? 1u : 0u; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(bool2 v) { this.x = v.x ? 1u : 0u; this.y = v.y ? 1u : 0u; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(int v) { this.x = (uint)v; this.y = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(int2 v) { this.x = (uint)v.x; this.y = (uint)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(float v) { this.x = (uint)v; this.y = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(float2 v) { this.x = (uint)v.x; this.y = (uint)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(double v) { this.x = (uint)v; this.y = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint2(double2 v) { this.x = (uint)v.x; this.y = (uint)v.y; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator uint2(uint v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(bool v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(bool2 v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(int v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(int2 v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(float v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(float2 v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(double v) => new uint2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint2(double2 v) => new uint2(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator +(uint2 lhs, uint2 rhs) => new uint2(lhs.x + rhs.x, lhs.y + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator +(uint2 lhs, uint rhs) => new uint2(lhs.x + rhs, lhs.y + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator +(uint lhs, uint2 rhs) => new uint2(lhs + rhs.x, lhs + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator -(uint2 lhs, uint2 rhs) => new uint2(lhs.x - rhs.x, lhs.y - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator -(uint2 lhs, uint rhs) => new uint2(lhs.x - rhs, lhs.y - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator -(uint lhs, uint2 rhs) => new uint2(lhs - rhs.x, lhs - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator *(uint2 lhs, uint2 rhs) => new uint2(lhs.x * rhs.x, lhs.y * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator *(uint2 lhs, uint rhs) => new uint2(lhs.x * rhs, lhs.y * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator *(uint lhs, uint2 rhs) => new uint2(lhs * rhs.x, lhs * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator /(uint2 lhs, uint2 rhs) => new uint2(lhs.x / rhs.x, lhs.y / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator /(uint2 lhs, uint rhs) => new uint2(lhs.x / rhs, lhs.y / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator /(uint lhs, uint2 rhs) => new uint2(lhs / rhs.x, lhs / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator %(uint2 lhs, uint2 rhs) => new uint2(lhs.x % rhs.x, lhs.y % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator %(uint2 lhs, uint rhs) => new uint2(lhs.x % rhs, lhs.y % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator %(uint lhs, uint2 rhs) => new uint2(lhs % rhs.x, lhs % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(uint2 lhs, uint2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(uint2 lhs, uint rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(uint lhs, uint2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(uint2 lhs, uint2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(uint2 lhs, uint rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(uint lhs, uint2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(uint2 lhs, uint2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(uint2 lhs, uint rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(uint lhs, uint2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(uint2 lhs, uint2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(uint2 lhs, uint rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(uint lhs, uint2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator +(uint2 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator -(uint2 val) => new uint2((uint)(-val.x), (uint)(-val.y));
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator ++(uint2 val) => new uint2(val.x + 1, val.y + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator --(uint2 val) => new uint2(val.x - 1, val.y - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator &(uint2 lhs, uint2 rhs) => new uint2(lhs.x & rhs.x, lhs.y & rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator &(uint2 lhs, uint rhs) => new uint2(lhs.x & rhs, lhs.y & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator &(uint lhs, uint2 rhs) => new uint2(lhs & rhs.x, lhs & rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator |(uint2 lhs, uint2 rhs) => new uint2(lhs.x | rhs.x, lhs.y | rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator |(uint2 lhs, uint rhs) => new uint2(lhs.x | rhs, lhs.y | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator |(uint lhs, uint2 rhs) => new uint2(lhs | rhs.x, lhs | rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator ^(uint2 lhs, uint2 rhs) => new uint2(lhs.x ^ rhs.x, lhs.y ^ rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator ^(uint2 lhs, uint rhs) => new uint2(lhs.x ^ rhs, lhs.y ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator ^(uint lhs, uint2 rhs) => new uint2(lhs ^ rhs.x, lhs ^ rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator ~(uint2 val) => new uint2(~val.x, ~val.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator <<(uint2 x, int n) => new uint2(x.x << n, x.y << n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint2 operator >>(uint2 x, int n) => new uint2(x.x >> n, x.y >> n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(uint2 lhs, uint2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(uint2 lhs, uint rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(uint lhs, uint2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(uint2 lhs, uint2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(uint2 lhs, uint rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(uint lhs, uint2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        public uint this[int index]
        {
            get => index switch { 0 => x, 1 => y, _ => throw new ArgumentException($"uint2 has components 0 to 1, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; default: throw new ArgumentException($"uint2 has components 0 to 1, not {index}."); } }
        }

        public uint2 xx => new uint2(x, x);
        public uint2 xy { get => new uint2(x, y); set { x = value.x; y = value.y; } }
        public uint2 yx { get => new uint2(y, x); set { y = value.x; x = value.y; } }
        public uint2 yy => new uint2(y, y);
        public uint3 xxx => new uint3(x, x, x);
        public uint3 xxy => new uint3(x, x, y);
        public uint3 xyx => new uint3(x, y, x);
        public uint3 xyy => new uint3(x, y, y);
        public uint3 yxx => new uint3(y, x, x);
        public uint3 yxy => new uint3(y, x, y);
        public uint3 yyx => new uint3(y, y, x);
        public uint3 yyy => new uint3(y, y, y);
        public uint4 xxxx => new uint4(x, x, x, x);
        public uint4 xxxy => new uint4(x, x, x, y);
        public uint4 xxyx => new uint4(x, x, y, x);
        public uint4 xxyy => new uint4(x, x, y, y);
        public uint4 xyxx => new uint4(x, y, x, x);
        public uint4 xyxy => new uint4(x, y, x, y);
        public uint4 xyyx => new uint4(x, y, y, x);
        public uint4 xyyy => new uint4(x, y, y, y);
        public uint4 yxxx => new uint4(y, x, x, x);
        public uint4 yxxy => new uint4(y, x, x, y);
        public uint4 yxyx => new uint4(y, x, y, x);
        public uint4 yxyy => new uint4(y, x, y, y);
        public uint4 yyxx => new uint4(y, y, x, x);
        public uint4 yyxy => new uint4(y, y, x, y);
        public uint4 yyyx => new uint4(y, y, y, x);
        public uint4 yyyy => new uint4(y, y, y, y);

        public bool Equals(uint2 rhs) => x == rhs.x && y == rhs.y;
        public override bool Equals(object o) => o is uint2 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"uint2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct uint3 : IEquatable<uint3>, IFormattable
    {
        public uint x;
        public uint y;
        public uint z;

        public static readonly uint3 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(uint x, uint y, uint z) { this.x = x; this.y = y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(uint x, uint2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(uint2 xy, uint z) { this.x = xy.x; this.y = xy.y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(uint3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(uint v) { this.x = v; this.y = v; this.z = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(bool v) { this.x = v ? 1u : 0u; this.y = v ? 1u : 0u; this.z = v ? 1u : 0u; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(bool3 v) { this.x = v.x ? 1u : 0u; this.y = v.y ? 1u : 0u; this.z = v.z ? 1u : 0u; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(int v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(int3 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(float v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(float3 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(double v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint3(double3 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator uint3(uint v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(bool v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(bool3 v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(int v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(int3 v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(float v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(float3 v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(double v) => new uint3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint3(double3 v) => new uint3(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator +(uint3 lhs, uint3 rhs) => new uint3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator +(uint3 lhs, uint rhs) => new uint3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator +(uint lhs, uint3 rhs) => new uint3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator -(uint3 lhs, uint3 rhs) => new uint3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator -(uint3 lhs, uint rhs) => new uint3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator -(uint lhs, uint3 rhs) => new uint3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator *(uint3 lhs, uint3 rhs) => new uint3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator *(uint3 lhs, uint rhs) => new uint3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator *(uint lhs, uint3 rhs) => new uint3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator /(uint3 lhs, uint3 rhs) => new uint3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator /(uint3 lhs, uint rhs) => new uint3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator /(uint lhs, uint3 rhs) => new uint3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator %(uint3 lhs, uint3 rhs) => new uint3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator %(uint3 lhs, uint rhs) => new uint3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator %(uint lhs, uint3 rhs) => new uint3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(uint3 lhs, uint3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(uint3 lhs, uint rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(uint lhs, uint3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(uint3 lhs, uint3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(uint3 lhs, uint rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(uint lhs, uint3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(uint3 lhs, uint3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(uint3 lhs, uint rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(uint lhs, uint3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(uint3 lhs, uint3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(uint3 lhs, uint rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(uint lhs, uint3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator +(uint3 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator -(uint3 val) => new uint3((uint)(-val.x), (uint)(-val.y), (uint)(-val.z));
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator ++(uint3 val) => new uint3(val.x + 1, val.y + 1, val.z + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator --(uint3 val) => new uint3(val.x - 1, val.y - 1, val.z - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator &(uint3 lhs, uint3 rhs) => new uint3(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator &(uint3 lhs, uint rhs) => new uint3(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator &(uint lhs, uint3 rhs) => new uint3(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator |(uint3 lhs, uint3 rhs) => new uint3(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator |(uint3 lhs, uint rhs) => new uint3(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator |(uint lhs, uint3 rhs) => new uint3(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator ^(uint3 lhs, uint3 rhs) => new uint3(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator ^(uint3 lhs, uint rhs) => new uint3(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator ^(uint lhs, uint3 rhs) => new uint3(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator ~(uint3 val) => new uint3(~val.x, ~val.y, ~val.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator <<(uint3 x, int n) => new uint3(x.x << n, x.y << n, x.z << n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint3 operator >>(uint3 x, int n) => new uint3(x.x >> n, x.y >> n, x.z >> n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(uint3 lhs, uint3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(uint3 lhs, uint rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(uint lhs, uint3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(uint3 lhs, uint3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(uint3 lhs, uint rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(uint lhs, uint3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        public uint this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new ArgumentException($"uint3 has components 0 to 2, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; default: throw new ArgumentException($"uint3 has components 0 to 2, not {index}."); } }
        }

        public uint2 xx => new uint2(x, x);
        public uint2 xy { get => new uint2(x, y); set { x = value.x; y = value.y; } }
        public uint2 xz { get => new uint2(x, z); set { x = value.x; z = value.y; } }
        public uint2 yx { get => new uint2(y, x); set { y = value.x; x = value.y; } }
        public uint2 yy => new uint2(y, y);
        public uint2 yz { get => new uint2(y, z); set { y = value.x; z = value.y; } }
        public uint2 zx { get => new uint2(z, x); set { z = value.x; x = value.y; } }
        public uint2 zy { get => new uint2(z, y); set { z = value.x; y = value.y; } }
        public uint2 zz => new uint2(z, z);
        public uint3 xxx => new uint3(x, x, x);
        public uint3 xxy => new uint3(x, x, y);
        public uint3 xxz => new uint3(x, x, z);
        public uint3 xyx => new uint3(x, y, x);
        public uint3 xyy => new uint3(x, y, y);
        public uint3 xyz { get => new uint3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public uint3 xzx => new uint3(x, z, x);
        public uint3 xzy { get => new uint3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public uint3 xzz => new uint3(x, z, z);
        public uint3 yxx => new uint3(y, x, x);
        public uint3 yxy => new uint3(y, x, y);
        public uint3 yxz { get => new uint3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public uint3 yyx => new uint3(y, y, x);
        public uint3 yyy => new uint3(y, y, y);
        public uint3 yyz => new uint3(y, y, z);
        public uint3 yzx { get => new uint3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public uint3 yzy => new uint3(y, z, y);
        public uint3 yzz => new uint3(y, z, z);
        public uint3 zxx => new uint3(z, x, x);
        public uint3 zxy { get => new uint3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public uint3 zxz => new uint3(z, x, z);
        public uint3 zyx { get => new uint3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public uint3 zyy => new uint3(z, y, y);
        public uint3 zyz => new uint3(z, y, z);
        public uint3 zzx => new uint3(z, z, x);
        public uint3 zzy => new uint3(z, z, y);
        public uint3 zzz => new uint3(z, z, z);
        public uint4 xxxx => new uint4(x, x, x, x);
        public uint4 xxxy => new uint4(x, x, x, y);
        public uint4 xxxz => new uint4(x, x, x, z);
        public uint4 xxyx => new uint4(x, x, y, x);
        public uint4 xxyy => new uint4(x, x, y, y);
        public uint4 xxyz => new uint4(x, x, y, z);
        public uint4 xxzx => new uint4(x, x, z, x);
        public uint4 xxzy => new uint4(x, x, z, y);
        public uint4 xxzz => new uint4(x, x, z, z);
        public uint4 xyxx => new uint4(x, y, x, x);
        public uint4 xyxy => new uint4(x, y, x, y);
        public uint4 xyxz => new uint4(x, y, x, z);
        public uint4 xyyx => new uint4(x, y, y, x);
        public uint4 xyyy => new uint4(x, y, y, y);
        public uint4 xyyz => new uint4(x, y, y, z);
        public uint4 xyzx => new uint4(x, y, z, x);
        public uint4 xyzy => new uint4(x, y, z, y);
        public uint4 xyzz => new uint4(x, y, z, z);
        public uint4 xzxx => new uint4(x, z, x, x);
        public uint4 xzxy => new uint4(x, z, x, y);
        public uint4 xzxz => new uint4(x, z, x, z);
        public uint4 xzyx => new uint4(x, z, y, x);
        public uint4 xzyy => new uint4(x, z, y, y);
        public uint4 xzyz => new uint4(x, z, y, z);
        public uint4 xzzx => new uint4(x, z, z, x);
        public uint4 xzzy => new uint4(x, z, z, y);
        public uint4 xzzz => new uint4(x, z, z, z);
        public uint4 yxxx => new uint4(y, x, x, x);
        public uint4 yxxy => new uint4(y, x, x, y);
        public uint4 yxxz => new uint4(y, x, x, z);
        public uint4 yxyx => new uint4(y, x, y, x);
        public uint4 yxyy => new uint4(y, x, y, y);
        public uint4 yxyz => new uint4(y, x, y, z);
        public uint4 yxzx => new uint4(y, x, z, x);
        public uint4 yxzy => new uint4(y, x, z, y);
        public uint4 yxzz => new uint4(y, x, z, z);
        public uint4 yyxx => new uint4(y, y, x, x);
        public uint4 yyxy => new uint4(y, y, x, y);
        public uint4 yyxz => new uint4(y, y, x, z);
        public uint4 yyyx => new uint4(y, y, y, x);
        public uint4 yyyy => new uint4(y, y, y, y);
        public uint4 yyyz => new uint4(y, y, y, z);
        public uint4 yyzx => new uint4(y, y, z, x);
        public uint4 yyzy => new uint4(y, y, z, y);
        public uint4 yyzz => new uint4(y, y, z, z);
        public uint4 yzxx => new uint4(y, z, x, x);
        public uint4 yzxy => new uint4(y, z, x, y);
        public uint4 yzxz => new uint4(y, z, x, z);
        public uint4 yzyx => new uint4(y, z, y, x);
        public uint4 yzyy => new uint4(y, z, y, y);
        public uint4 yzyz => new uint4(y, z, y, z);
        public uint4 yzzx => new uint4(y, z, z, x);
        public uint4 yzzy => new uint4(y, z, z, y);
        public uint4 yzzz => new uint4(y, z, z, z);
        public uint4 zxxx => new uint4(z, x, x, x);
        public uint4 zxxy => new uint4(z, x, x, y);
        public uint4 zxxz => new uint4(z, x, x, z);
        public uint4 zxyx => new uint4(z, x, y, x);
        public uint4 zxyy => new uint4(z, x, y, y);
        public uint4 zxyz => new uint4(z, x, y, z);
        public uint4 zxzx => new uint4(z, x, z, x);
        public uint4 zxzy => new uint4(z, x, z, y);
        public uint4 zxzz => new uint4(z, x, z, z);
        public uint4 zyxx => new uint4(z, y, x, x);
        public uint4 zyxy => new uint4(z, y, x, y);
        public uint4 zyxz => new uint4(z, y, x, z);
        public uint4 zyyx => new uint4(z, y, y, x);
        public uint4 zyyy => new uint4(z, y, y, y);
        public uint4 zyyz => new uint4(z, y, y, z);
        public uint4 zyzx => new uint4(z, y, z, x);
        public uint4 zyzy => new uint4(z, y, z, y);
        public uint4 zyzz => new uint4(z, y, z, z);
        public uint4 zzxx => new uint4(z, z, x, x);
        public uint4 zzxy => new uint4(z, z, x, y);
        public uint4 zzxz => new uint4(z, z, x, z);
        public uint4 zzyx => new uint4(z, z, y, x);
        public uint4 zzyy => new uint4(z, z, y, y);
        public uint4 zzyz => new uint4(z, z, y, z);
        public uint4 zzzx => new uint4(z, z, z, x);
        public uint4 zzzy => new uint4(z, z, z, y);
        public uint4 zzzz => new uint4(z, z, z, z);

        public bool Equals(uint3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
        public override bool Equals(object o) => o is uint3 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"uint3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct uint4 : IEquatable<uint4>, IFormattable
    {
        public uint x;
        public uint y;
        public uint z;
        public uint w;

        public static readonly uint4 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint x, uint y, uint z, uint w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint x, uint y, uint2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint x, uint2 yz, uint w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint x, uint3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint2 xy, uint z, uint w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint2 xy, uint2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint3 xyz, uint w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(uint v) { this.x = v; this.y = v; this.z = v; this.w = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(bool v) { this.x = v ? 1u : 0u; this.y = v ? 1u : 0u; this.z = v ? 1u : 0u; this.w = v ? 1u : 0u; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(bool4 v) { this.x = v.x ? 1u : 0u; this.y = v.y ? 1u : 0u; this.z = v.z ? 1u : 0u; this.w = v.w ? 1u : 0u; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(int v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; this.w = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(int4 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; this.w = (uint)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(float v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; this.w = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(float4 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; this.w = (uint)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(double v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; this.w = (uint)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public uint4(double4 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; this.w = (uint)v.w; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator uint4(uint v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(bool v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(bool4 v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(int v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(int4 v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(float v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(float4 v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(double v) => new uint4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator uint4(double4 v) => new uint4(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator +(uint4 lhs, uint4 rhs) => new uint4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator +(uint4 lhs, uint rhs) => new uint4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator +(uint lhs, uint4 rhs) => new uint4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator -(uint4 lhs, uint4 rhs) => new uint4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator -(uint4 lhs, uint rhs) => new uint4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator -(uint lhs, uint4 rhs) => new uint4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator *(uint4 lhs, uint4 rhs) => new uint4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator *(uint4 lhs, uint rhs) => new uint4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator *(uint lhs, uint4 rhs) => new uint4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator /(uint4 lhs, uint4 rhs) => new uint4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator /(uint4 lhs, uint rhs) => new uint4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator /(uint lhs, uint4 rhs) => new uint4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator %(uint4 lhs, uint4 rhs) => new uint4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator %(uint4 lhs, uint rhs) => new uint4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator %(uint lhs, uint4 rhs) => new uint4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(uint4 lhs, uint4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(uint4 lhs, uint rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(uint lhs, uint4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(uint4 lhs, uint4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(uint4 lhs, uint rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(uint lhs, uint4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(uint4 lhs, uint4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(uint4 lhs, uint rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(uint lhs, uint4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(uint4 lhs, uint4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(uint4 lhs, uint rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(uint lhs, uint4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator +(uint4 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator -(uint4 val) => new uint4((uint)(-val.x), (uint)(-val.y), (uint)(-val.z), (uint)(-val.w));
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator ++(uint4 val) => new uint4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator --(uint4 val) => new uint4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator &(uint4 lhs, uint4 rhs) => new uint4(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator &(uint4 lhs, uint rhs) => new uint4(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator &(uint lhs, uint4 rhs) => new uint4(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator |(uint4 lhs, uint4 rhs) => new uint4(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator |(uint4 lhs, uint rhs) => new uint4(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator |(uint lhs, uint4 rhs) => new uint4(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator ^(uint4 lhs, uint4 rhs) => new uint4(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator ^(uint4 lhs, uint rhs) => new uint4(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator ^(uint lhs, uint4 rhs) => new uint4(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator ~(uint4 val) => new uint4(~val.x, ~val.y, ~val.z, ~val.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator <<(uint4 x, int n) => new uint4(x.x << n, x.y << n, x.z << n, x.w << n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static uint4 operator >>(uint4 x, int n) => new uint4(x.x >> n, x.y >> n, x.z >> n, x.w >> n);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(uint4 lhs, uint4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(uint4 lhs, uint rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(uint lhs, uint4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(uint4 lhs, uint4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(uint4 lhs, uint rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(uint lhs, uint4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        public uint this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new ArgumentException($"uint4 has components 0 to 3, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; case 3: w = value; break; default: throw new ArgumentException($"uint4 has components 0 to 3, not {index}."); } }
        }

        public uint2 xx => new uint2(x, x);
        public uint2 xy { get => new uint2(x, y); set { x = value.x; y = value.y; } }
        public uint2 xz { get => new uint2(x, z); set { x = value.x; z = value.y; } }
        public uint2 xw { get => new uint2(x, w); set { x = value.x; w = value.y; } }
        public uint2 yx { get => new uint2(y, x); set { y = value.x; x = value.y; } }
        public uint2 yy => new uint2(y, y);
        public uint2 yz { get => new uint2(y, z); set { y = value.x; z = value.y; } }
        public uint2 yw { get => new uint2(y, w); set { y = value.x; w = value.y; } }
        public uint2 zx { get => new uint2(z, x); set { z = value.x; x = value.y; } }
        public uint2 zy { get => new uint2(z, y); set { z = value.x; y = value.y; } }
        public uint2 zz => new uint2(z, z);
        public uint2 zw { get => new uint2(z, w); set { z = value.x; w = value.y; } }
        public uint2 wx { get => new uint2(w, x); set { w = value.x; x = value.y; } }
        public uint2 wy { get => new uint2(w, y); set { w = value.x; y = value.y; } }
        public uint2 wz { get => new uint2(w, z); set { w = value.x; z = value.y; } }
        public uint2 ww => new uint2(w, w);
        public uint3 xxx => new uint3(x, x, x);
        public uint3 xxy => new uint3(x, x, y);
        public uint3 xxz => new uint3(x, x, z);
        public uint3 xxw => new uint3(x, x, w);
        public uint3 xyx => new uint3(x, y, x);
        public uint3 xyy => new uint3(x, y, y);
        public uint3 xyz { get => new uint3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public uint3 xyw { get => new uint3(x, y, w); set { x = value.x; y = value.y; w = value.z; } }
        public uint3 xzx => new uint3(x, z, x);
        public uint3 xzy { get => new uint3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public uint3 xzz => new uint3(x, z, z);
        public uint3 xzw { get => new uint3(x, z, w); set { x = value.x; z = value.y; w = value.z; } }
        public uint3 xwx => new uint3(x, w, x);
        public uint3 xwy { get => new uint3(x, w, y); set { x = value.x; w = value.y; y = value.z; } }
        public uint3 xwz { get => new uint3(x, w, z); set { x = value.x; w = value.y; z = value.z; } }
        public uint3 xww => new uint3(x, w, w);
        public uint3 yxx => new uint3(y, x, x);
        public uint3 yxy => new uint3(y, x, y);
        public uint3 yxz { get => new uint3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public uint3 yxw { get => new uint3(y, x, w); set { y = value.x; x = value.y; w = value.z; } }
        public uint3 yyx => new uint3(y, y, x);
        public uint3 yyy => new uint3(y, y, y);
        public uint3 yyz => new uint3(y, y, z);
        public uint3 yyw => new uint3(y, y, w);
        public uint3 yzx { get => new uint3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public uint3 yzy => new uint3(y, z, y);
        public uint3 yzz => new uint3(y, z, z);
        public uint3 yzw { get => new uint3(y, z, w); set { y = value.x; z = value.y; w = value.z; } }
        public uint3 ywx { get => new uint3(y, w, x); set { y = value.x; w = value.y; x = value.z; } }
        public uint3 ywy => new uint3(y, w, y);
        public uint3 ywz { get => new uint3(y, w, z); set { y = value.x; w = value.y; z = value.z; } }
        public uint3 yww => new uint3(y, w, w);
        public uint3 zxx => new uint3(z, x, x);
        public uint3 zxy { get => new uint3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public uint3 zxz => new uint3(z, x, z);
        public uint3 zxw { get => new uint3(z, x, w); set { z = value.x; x = value.y; w = value.z; } }
        public uint3 zyx { get => new uint3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public uint3 zyy => new uint3(z, y, y);
        public uint3 zyz => new uint3(z, y, z);
        public uint3 zyw { get => new uint3(z, y, w); set { z = value.x; y = value.y; w = value.z; } }
        public uint3 zzx => new uint3(z, z, x);
        public uint3 zzy => new uint3(z, z, y);
        public uint3 zzz => new uint3(z, z, z);
        public uint3 zzw => new uint3(z, z, w);
        public uint3 zwx { get => new uint3(z, w, x); set { z = value.x; w = value.y; x = value.z; } }
        public uint3 zwy { get => new uint3(z, w, y); set { z = value.x; w = value.y; y = value.z; } }
        public uint3 zwz => new uint3(z, w, z);
        public uint3 zww => new uint3(z, w, w);
        public uint3 wxx => new uint3(w, x, x);
        public uint3 wxy { get => new uint3(w, x, y); set { w = value.x; x = value.y; y = value.z; } }
        public uint3 wxz { get => new uint3(w, x, z); set { w = value.x; x = value.y; z = value.z; } }
        public uint3 wxw => new uint3(w, x, w);
        public uint3 wyx { get => new uint3(w, y, x); set { w = value.x; y = value.y; x = value.z; } }
        public uint3 wyy => new uint3(w, y, y);
        public uint3 wyz { get => new uint3(w, y, z); set { w = value.x; y = value.y; z = value.z; } }
        public uint3 wyw => new uint3(w, y, w);
        public uint3 wzx { get => new uint3(w, z, x); set { w = value.x; z = value.y; x = value.z; } }
        public uint3 wzy { get => new uint3(w, z, y); set { w = value.x; z = value.y; y = value.z; } }
        public uint3 wzz => new uint3(w, z, z);
        public uint3 wzw => new uint3(w, z, w);
        public uint3 wwx => new uint3(w, w, x);
        public uint3 wwy => new uint3(w, w, y);
        public uint3 wwz => new uint3(w, w, z);
        public uint3 www => new uint3(w, w, w);
        public uint4 xxxx => new uint4(x, x, x, x);
        public uint4 xxxy => new uint4(x, x, x, y);
        public uint4 xxxz => new uint4(x, x, x, z);
        public uint4 xxxw => new uint4(x, x, x, w);
        public uint4 xxyx => new uint4(x, x, y, x);
        public uint4 xxyy => new uint4(x, x, y, y);
        public uint4 xxyz => new uint4(x, x, y, z);
        public uint4 xxyw => new uint4(x, x, y, w);
        public uint4 xxzx => new uint4(x, x, z, x);
        public uint4 xxzy => new uint4(x, x, z, y);
        public uint4 xxzz => new uint4(x, x, z, z);
        public uint4 xxzw => new uint4(x, x, z, w);
        public uint4 xxwx => new uint4(x, x, w, x);
        public uint4 xxwy => new uint4(x, x, w, y);
        public uint4 xxwz => new uint4(x, x, w, z);
        public uint4 xxww => new uint4(x, x, w, w);
        public uint4 xyxx => new uint4(x, y, x, x);
        public uint4 xyxy => new uint4(x, y, x, y);
        public uint4 xyxz => new uint4(x, y, x, z);
        public uint4 xyxw => new uint4(x, y, x, w);
        public uint4 xyyx => new uint4(x, y, y, x);
        public uint4 xyyy => new uint4(x, y, y, y);
        public uint4 xyyz => new uint4(x, y, y, z);
        public uint4 xyyw => new uint4(x, y, y, w);
        public uint4 xyzx => new uint4(x, y, z, x);
        public uint4 xyzy => new uint4(x, y, z, y);
        public uint4 xyzz => new uint4(x, y, z, z);
        public uint4 xyzw { get => new uint4(x, y, z, w); set { x = value.x; y = value.y; z = value.z; w = value.w; } }
        public uint4 xywx => new uint4(x, y, w, x);
        public uint4 xywy => new uint4(x, y, w, y);
        public uint4 xywz { get => new uint4(x, y, w, z); set { x = value.x; y = value.y; w = value.z; z = value.w; } }
        public uint4 xyww => new uint4(x, y, w, w);
        public uint4 xzxx => new uint4(x, z, x, x);
        public uint4 xzxy => new uint4(x, z, x, y);
        public uint4 xzxz => new uint4(x, z, x, z);
        public uint4 xzxw => new uint4(x, z, x, w);
        public uint4 xzyx => new uint4(x, z, y, x);
        public uint4 xzyy => new uint4(x, z, y, y);
        public uint4 xzyz => new uint4(x, z, y, z);
        public uint4 xzyw { get => new uint4(x, z, y, w); set { x = value.x; z = value.y; y = value.z; w = value.w; } }
        public uint4 xzzx => new uint4(x, z, z, x);
        public uint4 xzzy => new uint4(x, z, z, y);
        public uint4 xzzz => new uint4(x, z, z, z);
        public uint4 xzzw => new uint4(x, z, z, w);
        public uint4 xzwx => new uint4(x, z, w, x);
        public uint4 xzwy { get => new uint4(x, z, w, y); set { x = value.x; z = value.y; w = value.z; y = value.w; } }
        public uint4 xzwz => new uint4(x, z, w, z);
        public uint4 xzww => new uint4(x, z, w, w);
        public uint4 xwxx => new uint4(x, w, x, x);
        public uint4 xwxy => new uint4(x, w, x, y);
        public uint4 xwxz => new uint4(x, w, x, z);
        public uint4 xwxw => new uint4(x, w, x, w);
        public uint4 xwyx => new uint4(x, w, y, x);
        public uint4 xwyy => new uint4(x, w, y, y);
        public uint4 xwyz { get => new uint4(x, w, y, z); set { x = value.x; w = value.y; y = value.z; z = value.w; } }
        public uint4 xwyw => new uint4(x, w, y, w);
        public uint4 xwzx => new uint4(x, w, z, x);
        public uint4 xwzy { get => new uint4(x, w, z, y); set { x = value.x; w = value.y; z = value.z; y = value.w; } }
        public uint4 xwzz => new uint4(x, w, z, z);
        public uint4 xwzw => new uint4(x, w, z, w);
        public uint4 xwwx => new uint4(x, w, w, x);
        public uint4 xwwy => new uint4(x, w, w, y);
        public uint4 xwwz => new uint4(x, w, w, z);
        public uint4 xwww => new uint4(x, w, w, w);
        public uint4 yxxx => new uint4(y, x, x, x);
        public uint4 yxxy => new uint4(y, x, x, y);
        public uint4 yxxz => new uint4(y, x, x, z);
        public uint4 yxxw => new uint4(y, x, x, w);
        public uint4 yxyx => new uint4(y, x, y, x);
        public uint4 yxyy => new uint4(y, x, y, y);
        public uint4 yxyz => new uint4(y, x, y, z);
        public uint4 yxyw => new uint4(y, x, y, w);
        public uint4 yxzx => new uint4(y, x, z, x);
        public uint4 yxzy => new uint4(y, x, z, y);
        public uint4 yxzz => new uint4(y, x, z, z);
        public uint4 yxzw { get => new uint4(y, x, z, w); set { y = value.x; x = value.y; z = value.z; w = value.w; } }
        public uint4 yxwx => new uint4(y, x, w, x);
        public uint4 yxwy => new uint4(y, x, w, y);
        public uint4 yxwz { get => new uint4(y, x, w, z); set { y = value.x; x = value.y; w = value.z; z = value.w; } }
        public uint4 yxww => new uint4(y, x, w, w);
        public uint4 yyxx => new uint4(y, y, x, x);
        public uint4 yyxy => new uint4(y, y, x, y);
        public uint4 yyxz => new uint4(y, y, x, z);
        public uint4 yyxw => new uint4(y, y, x, w);
        public uint4 yyyx => new uint4(y, y, y, x);
        public uint4 yyyy => new uint4(y, y, y, y);
        public uint4 yyyz => new uint4(y, y, y, z);
        public uint4 yyyw => new uint4(y, y, y, w);
        public uint4 yyzx => new uint4(y, y, z, x);
        public uint4 yyzy => new uint4(y, y, z, y);
        public uint4 yyzz => new uint4(y, y, z, z);
        public uint4 yyzw => new uint4(y, y, z, w);
        public uint4 yywx => new uint4(y, y, w, x);
        public uint4 yywy => new uint4(y, y, w, y);
        public uint4 yywz => new uint4(y, y, w, z);
        public uint4 yyww => new uint4(y, y, w, w);
        public uint4 yzxx => new uint4(y, z, x, x);
        public uint4 yzxy => new uint4(y, z, x, y);
        public uint4 yzxz => new uint4(y, z, x, z);
        public uint4 yzxw { get => new uint4(y, z, x, w); set { y = value.x; z = value.y; x = value.z; w = value.w; } }
        public uint4 yzyx => new uint4(y, z, y, x);
        public uint4 yzyy => new uint4(y, z, y, y);
        public uint4 yzyz => new uint4(y, z, y, z);
        public uint4 yzyw => new uint4(y, z, y, w);
        public uint4 yzzx => new uint4(y, z, z, x);
        public uint4 yzzy => new uint4(y, z, z, y);
        public uint4 yzzz => new uint4(y, z, z, z);
        public uint4 yzzw => new uint4(y, z, z, w);
        public uint4 yzwx { get => new uint4(y, z, w, x); set { y = value.x; z = value.y; w = value.z; x = value.w; } }
        public uint4 yzwy => new uint4(y, z, w, y);
        public uint4 yzwz => new uint4(y, z, w, z);
        public uint4 yzww => new uint4(y, z, w, w);
        public uint4 ywxx => new uint4(y, w, x, x);
        public uint4 ywxy => new uint4(y, w, x, y);
        public uint4 ywxz { get => new uint4(y, w, x, z); set { y = value.x; w = value.y; x = value.z; z = value.w; } }
        public uint4 ywxw => new uint4(y, w, x, w);
        public uint4 ywyx => new uint4(y, w, y, x);
        public uint4 ywyy => new uint4(y, w, y, y);
        public uint4 ywyz => new uint4(y, w, y, z);
        public uint4 ywyw => new uint4(y, w, y, w);
        public uint4 ywzx { get => new uint4(y, w, z, x); set { y = value.x; w = value.y; z = value.z; x = value.w; } }
        public uint4 ywzy => new uint4(y, w, z, y);
        public uint4 ywzz => new uint4(y, w, z, z);
        public uint4 ywzw => new uint4(y, w, z, w);
        public uint4 ywwx => new uint4(y, w, w, x);
        public uint4 ywwy => new uint4(y, w, w, y);
        public uint4 ywwz => new uint4(y, w, w, z);
        public uint4 ywww => new uint4(y, w, w, w);
        public uint4 zxxx => new uint4(z, x, x, x);
        public uint4 zxxy => new uint4(z, x, x, y);
        public uint4 zxxz => new uint4(z, x, x, z);
        public uint4 zxxw => new uint4(z, x, x, w);
        public uint4 zxyx => new uint4(z, x, y, x);
        public uint4 zxyy => new uint4(z, x, y, y);
        public uint4 zxyz => new uint4(z, x, y, z);
        public uint4 zxyw { get => new uint4(z, x, y, w); set { z = value.x; x = value.y; y = value.z; w = value.w; } }
        public uint4 zxzx => new uint4(z, x, z, x);
        public uint4 zxzy => new uint4(z, x, z, y);
        public uint4 zxzz => new uint4(z, x, z, z);
        public uint4 zxzw => new uint4(z, x, z, w);
        public uint4 zxwx => new uint4(z, x, w, x);
        public uint4 zxwy { get => new uint4(z, x, w, y); set { z = value.x; x = value.y; w = value.z; y = value.w; } }
        public uint4 zxwz => new uint4(z, x, w, z);
        public uint4 zxww => new uint4(z, x, w, w);
        public uint4 zyxx => new uint4(z, y, x, x);
        public uint4 zyxy => new uint4(z, y, x, y);
        public uint4 zyxz => new uint4(z, y, x, z);
        public uint4 zyxw { get => new uint4(z, y, x, w); set { z = value.x; y = value.y; x = value.z; w = value.w; } }
        public uint4 zyyx => new uint4(z, y, y, x);
        public uint4 zyyy => new uint4(z, y, y, y);
        public uint4 zyyz => new uint4(z, y, y, z);
        public uint4 zyyw => new uint4(z, y, y, w);
        public uint4 zyzx => new uint4(z, y, z, x);
        public uint4 zyzy => new uint4(z, y, z, y);
        public uint4 zyzz => new uint4(z, y, z, z);
        public uint4 zyzw => new uint4(z, y, z, w);
        public uint4 zywx { get => new uint4(z, y, w, x); set { z = value.x; y = value.y; w = value.z; x = value.w; } }
        public uint4 zywy => new uint4(z, y, w, y);
        public uint4 zywz => new uint4(z, y, w, z);
        public uint4 zyww => new uint4(z, y, w, w);
        public uint4 zzxx => new uint4(z, z, x, x);
        public uint4 zzxy => new uint4(z, z, x, y);
        public uint4 zzxz => new uint4(z, z, x, z);
        public uint4 zzxw => new uint4(z, z, x, w);
        public uint4 zzyx => new uint4(z, z, y, x);
        public uint4 zzyy => new uint4(z, z, y, y);
        public uint4 zzyz => new uint4(z, z, y, z);
        public uint4 zzyw => new uint4(z, z, y, w);
        public uint4 zzzx => new uint4(z, z, z, x);
        public uint4 zzzy => new uint4(z, z, z, y);
        public uint4 zzzz => new uint4(z, z, z, z);
        public uint4 zzzw => new uint4(z, z, z, w);
        public uint4 zzwx => new uint4(z, z, w, x);
        public uint4 zzwy => new uint4(z, z, w, y);
        public uint4 zzwz => new uint4(z, z, w, z);
        public uint4 zzww => new uint4(z, z, w, w);
        public uint4 zwxx => new uint4(z, w, x, x);
        public uint4 zwxy { get => new uint4(z, w, x, y); set { z = value.x; w = value.y; x = value.z; y = value.w; } }
        public uint4 zwxz => new uint4(z, w, x, z);
        public uint4 zwxw => new uint4(z, w, x, w);
        public uint4 zwyx { get => new uint4(z, w, y, x); set { z = value.x; w = value.y; y = value.z; x = value.w; } }
        public uint4 zwyy => new uint4(z, w, y, y);
        public uint4 zwyz => new uint4(z, w, y, z);
        public uint4 zwyw => new uint4(z, w, y, w);
        public uint4 zwzx => new uint4(z, w, z, x);
        public uint4 zwzy => new uint4(z, w, z, y);
        public uint4 zwzz => new uint4(z, w, z, z);
        public uint4 zwzw => new uint4(z, w, z, w);
        public uint4 zwwx => new uint4(z, w, w, x);
        public uint4 zwwy => new uint4(z, w, w, y);
        public uint4 zwwz => new uint4(z, w, w, z);
        public uint4 zwww => new uint4(z, w, w, w);
        public uint4 wxxx => new uint4(w, x, x, x);
        public uint4 wxxy => new uint4(w, x, x, y);
        public uint4 wxxz => new uint4(w, x, x, z);
        public uint4 wxxw => new uint4(w, x, x, w);
        public uint4 wxyx => new uint4(w, x, y, x);
        public uint4 wxyy => new uint4(w, x, y, y);
        public uint4 wxyz { get => new uint4(w, x, y, z); set { w = value.x; x = value.y; y = value.z; z = value.w; } }
        public uint4 wxyw => new uint4(w, x, y, w);
        public uint4 wxzx => new uint4(w, x, z, x);
        public uint4 wxzy { get => new uint4(w, x, z, y); set { w = value.x; x = value.y; z = value.z; y = value.w; } }
        public uint4 wxzz => new uint4(w, x, z, z);
        public uint4 wxzw => new uint4(w, x, z, w);
        public uint4 wxwx => new uint4(w, x, w, x);
        public uint4 wxwy => new uint4(w, x, w, y);
        public uint4 wxwz => new uint4(w, x, w, z);
        public uint4 wxww => new uint4(w, x, w, w);
        public uint4 wyxx => new uint4(w, y, x, x);
        public uint4 wyxy => new uint4(w, y, x, y);
        public uint4 wyxz { get => new uint4(w, y, x, z); set { w = value.x; y = value.y; x = value.z; z = value.w; } }
        public uint4 wyxw => new uint4(w, y, x, w);
        public uint4 wyyx => new uint4(w, y, y, x);
        public uint4 wyyy => new uint4(w, y, y, y);
        public uint4 wyyz => new uint4(w, y, y, z);
        public uint4 wyyw => new uint4(w, y, y, w);
        public uint4 wyzx { get => new uint4(w, y, z, x); set { w = value.x; y = value.y; z = value.z; x = value.w; } }
        public uint4 wyzy => new uint4(w, y, z, y);
        public uint4 wyzz => new uint4(w, y, z, z);
        public uint4 wyzw => new uint4(w, y, z, w);
        public uint4 wywx => new uint4(w, y, w, x);
        public uint4 wywy => new uint4(w, y, w, y);
        public uint4 wywz => new uint4(w, y, w, z);
        public uint4 wyww => new uint4(w, y, w, w);
        public uint4 wzxx => new uint4(w, z, x, x);
        public uint4 wzxy { get => new uint4(w, z, x, y); set { w = value.x; z = value.y; x = value.z; y = value.w; } }
        public uint4 wzxz => new uint4(w, z, x, z);
        public uint4 wzxw => new uint4(w, z, x, w);
        public uint4 wzyx { get => new uint4(w, z, y, x); set { w = value.x; z = value.y; y = value.z; x = value.w; } }
        public uint4 wzyy => new uint4(w, z, y, y);
        public uint4 wzyz => new uint4(w, z, y, z);
        public uint4 wzyw => new uint4(w, z, y, w);
        public uint4 wzzx => new uint4(w, z, z, x);
        public uint4 wzzy => new uint4(w, z, z, y);
        public uint4 wzzz => new uint4(w, z, z, z);
        public uint4 wzzw => new uint4(w, z, z, w);
        public uint4 wzwx => new uint4(w, z, w, x);
        public uint4 wzwy => new uint4(w, z, w, y);
        public uint4 wzwz => new uint4(w, z, w, z);
        public uint4 wzww => new uint4(w, z, w, w);
        public uint4 wwxx => new uint4(w, w, x, x);
        public uint4 wwxy => new uint4(w, w, x, y);
        public uint4 wwxz => new uint4(w, w, x, z);
        public uint4 wwxw => new uint4(w, w, x, w);
        public uint4 wwyx => new uint4(w, w, y, x);
        public uint4 wwyy => new uint4(w, w, y, y);
        public uint4 wwyz => new uint4(w, w, y, z);
        public uint4 wwyw => new uint4(w, w, y, w);
        public uint4 wwzx => new uint4(w, w, z, x);
        public uint4 wwzy => new uint4(w, w, z, y);
        public uint4 wwzz => new uint4(w, w, z, z);
        public uint4 wwzw => new uint4(w, w, z, w);
        public uint4 wwwx => new uint4(w, w, w, x);
        public uint4 wwwy => new uint4(w, w, w, y);
        public uint4 wwwz => new uint4(w, w, w, z);
        public uint4 wwww => new uint4(w, w, w, w);

        public bool Equals(uint4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
        public override bool Equals(object o) => o is uint4 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"uint4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct double2 : IEquatable<double2>, IFormattable
    {
        public double x;
        public double y;

        public static readonly double2 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(double x, double y) { this.x = x; this.y = y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(double2 xy) { this.x = xy.x; this.y = xy.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(double v) { this.x = v; this.y = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(bool v) { this.x = v ? 1.0 : 0.0; this.y = v ? 1.0 : 0.0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(bool2 v) { this.x = v.x ? 1.0 : 0.0; this.y = v.y ? 1.0 : 0.0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(int v) { this.x = (double)v; this.y = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(int2 v) { this.x = (double)v.x; this.y = (double)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(uint v) { this.x = (double)v; this.y = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(uint2 v) { this.x = (double)v.x; this.y = (double)v.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(float v) { this.x = (double)v; this.y = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double2(float2 v) { this.x = (double)v.x; this.y = (double)v.y; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double2(double v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator double2(bool v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator double2(bool2 v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double2(int v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double2(int2 v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double2(uint v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double2(uint2 v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double2(float v) => new double2(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double2(float2 v) => new double2(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator +(double2 lhs, double2 rhs) => new double2(lhs.x + rhs.x, lhs.y + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator +(double2 lhs, double rhs) => new double2(lhs.x + rhs, lhs.y + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator +(double lhs, double2 rhs) => new double2(lhs + rhs.x, lhs + rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator -(double2 lhs, double2 rhs) => new double2(lhs.x - rhs.x, lhs.y - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator -(double2 lhs, double rhs) => new double2(lhs.x - rhs, lhs.y - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator -(double lhs, double2 rhs) => new double2(lhs - rhs.x, lhs - rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator *(double2 lhs, double2 rhs) => new double2(lhs.x * rhs.x, lhs.y * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator *(double2 lhs, double rhs) => new double2(lhs.x * rhs, lhs.y * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator *(double lhs, double2 rhs) => new double2(lhs * rhs.x, lhs * rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator /(double2 lhs, double2 rhs) => new double2(lhs.x / rhs.x, lhs.y / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator /(double2 lhs, double rhs) => new double2(lhs.x / rhs, lhs.y / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator /(double lhs, double2 rhs) => new double2(lhs / rhs.x, lhs / rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator %(double2 lhs, double2 rhs) => new double2(lhs.x % rhs.x, lhs.y % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator %(double2 lhs, double rhs) => new double2(lhs.x % rhs, lhs.y % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator %(double lhs, double2 rhs) => new double2(lhs % rhs.x, lhs % rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(double2 lhs, double2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(double2 lhs, double rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <(double lhs, double2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(double2 lhs, double2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(double2 lhs, double rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator <=(double lhs, double2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(double2 lhs, double2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(double2 lhs, double rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >(double lhs, double2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(double2 lhs, double2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(double2 lhs, double rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator >=(double lhs, double2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator +(double2 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator -(double2 val) => new double2(-val.x, -val.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator ++(double2 val) => new double2(val.x + 1, val.y + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double2 operator --(double2 val) => new double2(val.x - 1, val.y - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(double2 lhs, double2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(double2 lhs, double rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(double lhs, double2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(double2 lhs, double2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(double2 lhs, double rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(double lhs, double2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        public double this[int index]
        {
            get => index switch { 0 => x, 1 => y, _ => throw new ArgumentException($"double2 has components 0 to 1, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; default: throw new ArgumentException($"double2 has components 0 to 1, not {index}."); } }
        }

        public double2 xx => new double2(x, x);
        public double2 xy { get => new double2(x, y); set { x = value.x; y = value.y; } }
        public double2 yx { get => new double2(y, x); set { y = value.x; x = value.y; } }
        public double2 yy => new double2(y, y);
        public double3 xxx => new double3(x, x, x);
        public double3 xxy => new double3(x, x, y);
        public double3 xyx => new double3(x, y, x);
        public double3 xyy => new double3(x, y, y);
        public double3 yxx => new double3(y, x, x);
        public double3 yxy => new double3(y, x, y);
        public double3 yyx => new double3(y, y, x);
        public double3 yyy => new double3(y, y, y);
        public double4 xxxx => new double4(x, x, x, x);
        public double4 xxxy => new double4(x, x, x, y);
        public double4 xxyx => new double4(x, x, y, x);
        public double4 xxyy => new double4(x, x, y, y);
        public double4 xyxx => new double4(x, y, x, x);
        public double4 xyxy => new double4(x, y, x, y);
        public double4 xyyx => new double4(x, y, y, x);
        public double4 xyyy => new double4(x, y, y, y);
        public double4 yxxx => new double4(y, x, x, x);
        public double4 yxxy => new double4(y, x, x, y);
        public double4 yxyx => new double4(y, x, y, x);
        public double4 yxyy => new double4(y, x, y, y);
        public double4 yyxx => new double4(y, y, x, x);
        public double4 yyxy => new double4(y, y, x, y);
        public double4 yyyx => new double4(y, y, y, x);
        public double4 yyyy => new double4(y, y, y, y);

        public bool Equals(double2 rhs) => x == rhs.x && y == rhs.y;
        public override bool Equals(object o) => o is double2 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"double2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct double3 : IEquatable<double3>, IFormattable
    {
        public double x;
        public double y;
        public double z;

        public static readonly double3 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(double x, double y, double z) { this.x = x; this.y = y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(double x, double2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(double2 xy, double z) { this.x = xy.x; this.y = xy.y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(double3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(double v) { this.x = v; this.y = v; this.z = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(bool v) { this.x = v ? 1.0 : 0.0; this.y = v ? 1.0 : 0.0; this.z = v ? 1.0 : 0.0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(bool3 v) { this.x = v.x ? 1.0 : 0.0; this.y = v.y ? 1.0 : 0.0; this.z = v.z ? 1.0 : 0.0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(int v) { this.x = (double)v; this.y = (double)v; this.z = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(int3 v) { this.x = (double)v.x; this.y = (double)v.y; this.z = (double)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(uint v) { this.x = (double)v; this.y = (double)v; this.z = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(uint3 v) { this.x = (double)v.x; this.y = (double)v.y; this.z = (double)v.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(float v) { this.x = (double)v; this.y = (double)v; this.z = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double3(float3 v) { this.x = (double)v.x; this.y = (double)v.y; this.z = (double)v.z; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double3(double v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator double3(bool v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator double3(bool3 v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double3(int v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double3(int3 v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double3(uint v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double3(uint3 v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double3(float v) => new double3(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double3(float3 v) => new double3(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator +(double3 lhs, double3 rhs) => new double3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator +(double3 lhs, double rhs) => new double3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator +(double lhs, double3 rhs) => new double3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator -(double3 lhs, double3 rhs) => new double3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator -(double3 lhs, double rhs) => new double3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator -(double lhs, double3 rhs) => new double3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator *(double3 lhs, double3 rhs) => new double3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator *(double3 lhs, double rhs) => new double3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator *(double lhs, double3 rhs) => new double3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator /(double3 lhs, double3 rhs) => new double3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator /(double3 lhs, double rhs) => new double3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator /(double lhs, double3 rhs) => new double3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator %(double3 lhs, double3 rhs) => new double3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator %(double3 lhs, double rhs) => new double3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator %(double lhs, double3 rhs) => new double3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(double3 lhs, double3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(double3 lhs, double rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <(double lhs, double3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(double3 lhs, double3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(double3 lhs, double rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator <=(double lhs, double3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(double3 lhs, double3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(double3 lhs, double rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >(double lhs, double3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(double3 lhs, double3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(double3 lhs, double rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator >=(double lhs, double3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator +(double3 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator -(double3 val) => new double3(-val.x, -val.y, -val.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator ++(double3 val) => new double3(val.x + 1, val.y + 1, val.z + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double3 operator --(double3 val) => new double3(val.x - 1, val.y - 1, val.z - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(double3 lhs, double3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(double3 lhs, double rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(double lhs, double3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(double3 lhs, double3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(double3 lhs, double rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(double lhs, double3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        public double this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new ArgumentException($"double3 has components 0 to 2, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; default: throw new ArgumentException($"double3 has components 0 to 2, not {index}."); } }
        }

        public double2 xx => new double2(x, x);
        public double2 xy { get => new double2(x, y); set { x = value.x; y = value.y; } }
        public double2 xz { get => new double2(x, z); set { x = value.x; z = value.y; } }
        public double2 yx { get => new double2(y, x); set { y = value.x; x = value.y; } }
        public double2 yy => new double2(y, y);
        public double2 yz { get => new double2(y, z); set { y = value.x; z = value.y; } }
        public double2 zx { get => new double2(z, x); set { z = value.x; x = value.y; } }
        public double2 zy { get => new double2(z, y); set { z = value.x; y = value.y; } }
        public double2 zz => new double2(z, z);
        public double3 xxx => new double3(x, x, x);
        public double3 xxy => new double3(x, x, y);
        public double3 xxz => new double3(x, x, z);
        public double3 xyx => new double3(x, y, x);
        public double3 xyy => new double3(x, y, y);
        public double3 xyz { get => new double3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public double3 xzx => new double3(x, z, x);
        public double3 xzy { get => new double3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public double3 xzz => new double3(x, z, z);
        public double3 yxx => new double3(y, x, x);
        public double3 yxy => new double3(y, x, y);
        public double3 yxz { get => new double3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public double3 yyx => new double3(y, y, x);
        public double3 yyy => new double3(y, y, y);
        public double3 yyz => new double3(y, y, z);
        public double3 yzx { get => new double3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public double3 yzy => new double3(y, z, y);
        public double3 yzz => new double3(y, z, z);
        public double3 zxx => new double3(z, x, x);
        public double3 zxy { get => new double3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public double3 zxz => new double3(z, x, z);
        public double3 zyx { get => new double3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public double3 zyy => new double3(z, y, y);
        public double3 zyz => new double3(z, y, z);
        public double3 zzx => new double3(z, z, x);
        public double3 zzy => new double3(z, z, y);
        public double3 zzz => new double3(z, z, z);
        public double4 xxxx => new double4(x, x, x, x);
        public double4 xxxy => new double4(x, x, x, y);
        public double4 xxxz => new double4(x, x, x, z);
        public double4 xxyx => new double4(x, x, y, x);
        public double4 xxyy => new double4(x, x, y, y);
        public double4 xxyz => new double4(x, x, y, z);
        public double4 xxzx => new double4(x, x, z, x);
        public double4 xxzy => new double4(x, x, z, y);
        public double4 xxzz => new double4(x, x, z, z);
        public double4 xyxx => new double4(x, y, x, x);
        public double4 xyxy => new double4(x, y, x, y);
        public double4 xyxz => new double4(x, y, x, z);
        public double4 xyyx => new double4(x, y, y, x);
        public double4 xyyy => new double4(x, y, y, y);
        public double4 xyyz => new double4(x, y, y, z);
        public double4 xyzx => new double4(x, y, z, x);
        public double4 xyzy => new double4(x, y, z, y);
        public double4 xyzz => new double4(x, y, z, z);
        public double4 xzxx => new double4(x, z, x, x);
        public double4 xzxy => new double4(x, z, x, y);
        public double4 xzxz => new double4(x, z, x, z);
        public double4 xzyx => new double4(x, z, y, x);
        public double4 xzyy => new double4(x, z, y, y);
        public double4 xzyz => new double4(x, z, y, z);
        public double4 xzzx => new double4(x, z, z, x);
        public double4 xzzy => new double4(x, z, z, y);
        public double4 xzzz => new double4(x, z, z, z);
        public double4 yxxx => new double4(y, x, x, x);
        public double4 yxxy => new double4(y, x, x, y);
        public double4 yxxz => new double4(y, x, x, z);
        public double4 yxyx => new double4(y, x, y, x);
        public double4 yxyy => new double4(y, x, y, y);
        public double4 yxyz => new double4(y, x, y, z);
        public double4 yxzx => new double4(y, x, z, x);
        public double4 yxzy => new double4(y, x, z, y);
        public double4 yxzz => new double4(y, x, z, z);
        public double4 yyxx => new double4(y, y, x, x);
        public double4 yyxy => new double4(y, y, x, y);
        public double4 yyxz => new double4(y, y, x, z);
        public double4 yyyx => new double4(y, y, y, x);
        public double4 yyyy => new double4(y, y, y, y);
        public double4 yyyz => new double4(y, y, y, z);
        public double4 yyzx => new double4(y, y, z, x);
        public double4 yyzy => new double4(y, y, z, y);
        public double4 yyzz => new double4(y, y, z, z);
        public double4 yzxx => new double4(y, z, x, x);
        public double4 yzxy => new double4(y, z, x, y);
        public double4 yzxz => new double4(y, z, x, z);
        public double4 yzyx => new double4(y, z, y, x);
        public double4 yzyy => new double4(y, z, y, y);
        public double4 yzyz => new double4(y, z, y, z);
        public double4 yzzx => new double4(y, z, z, x);
        public double4 yzzy => new double4(y, z, z, y);
        public double4 yzzz => new double4(y, z, z, z);
        public double4 zxxx => new double4(z, x, x, x);
        public double4 zxxy => new double4(z, x, x, y);
        public double4 zxxz => new double4(z, x, x, z);
        public double4 zxyx => new double4(z, x, y, x);
        public double4 zxyy => new double4(z, x, y, y);
        public double4 zxyz => new double4(z, x, y, z);
        public double4 zxzx => new double4(z, x, z, x);
        public double4 zxzy => new double4(z, x, z, y);
        public double4 zxzz => new double4(z, x, z, z);
        public double4 zyxx => new double4(z, y, x, x);
        public double4 zyxy => new double4(z, y, x, y);
        public double4 zyxz => new double4(z, y, x, z);
        public double4 zyyx => new double4(z, y, y, x);
        public double4 zyyy => new double4(z, y, y, y);
        public double4 zyyz => new double4(z, y, y, z);
        public double4 zyzx => new double4(z, y, z, x);
        public double4 zyzy => new double4(z, y, z, y);
        public double4 zyzz => new double4(z, y, z, z);
        public double4 zzxx => new double4(z, z, x, x);
        public double4 zzxy => new double4(z, z, x, y);
        public double4 zzxz => new double4(z, z, x, z);
        public double4 zzyx => new double4(z, z, y, x);
        public double4 zzyy => new double4(z, z, y, y);
        public double4 zzyz => new double4(z, z, y, z);
        public double4 zzzx => new double4(z, z, z, x);
        public double4 zzzy => new double4(z, z, z, y);
        public double4 zzzz => new double4(z, z, z, z);

        public bool Equals(double3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
        public override bool Equals(object o) => o is double3 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"double3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct double4 : IEquatable<double4>, IFormattable
    {
        public double x;
        public double y;
        public double z;
        public double w;

        public static readonly double4 zero;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double x, double y, double z, double w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double x, double y, double2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double x, double2 yz, double w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double x, double3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double2 xy, double z, double w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double2 xy, double2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double3 xyz, double w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(double v) { this.x = v; this.y = v; this.z = v; this.w = v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(bool v) { this.x = v ? 1.0 : 0.0; this.y = v ? 1.0 : 0.0; this.z = v ? 1.0 : 0.0; this.w = v ? 1.0 : 0.0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(bool4 v) { this.x = v.x ? 1.0 : 0.0; this.y = v.y ? 1.0 : 0.0; this.z = v.z ? 1.0 : 0.0; this.w = v.w ? 1.0 : 0.0; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(int v) { this.x = (double)v; this.y = (double)v; this.z = (double)v; this.w = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(int4 v) { this.x = (double)v.x; this.y = (double)v.y; this.z = (double)v.z; this.w = (double)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(uint v) { this.x = (double)v; this.y = (double)v; this.z = (double)v; this.w = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(uint4 v) { this.x = (double)v.x; this.y = (double)v.y; this.z = (double)v.z; this.w = (double)v.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(float v) { this.x = (double)v; this.y = (double)v; this.z = (double)v; this.w = (double)v; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public double4(float4 v) { this.x = (double)v.x; this.y = (double)v.y; this.z = (double)v.z; this.w = (double)v.w; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double4(double v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator double4(bool v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static explicit operator double4(bool4 v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double4(int v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double4(int4 v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double4(uint v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double4(uint4 v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double4(float v) => new double4(v);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator double4(float4 v) => new double4(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator +(double4 lhs, double4 rhs) => new double4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator +(double4 lhs, double rhs) => new double4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator +(double lhs, double4 rhs) => new double4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator -(double4 lhs, double4 rhs) => new double4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator -(double4 lhs, double rhs) => new double4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator -(double lhs, double4 rhs) => new double4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator *(double4 lhs, double4 rhs) => new double4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator *(double4 lhs, double rhs) => new double4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator *(double lhs, double4 rhs) => new double4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator /(double4 lhs, double4 rhs) => new double4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator /(double4 lhs, double rhs) => new double4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator /(double lhs, double4 rhs) => new double4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator %(double4 lhs, double4 rhs) => new double4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator %(double4 lhs, double rhs) => new double4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator %(double lhs, double4 rhs) => new double4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(double4 lhs, double4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(double4 lhs, double rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <(double lhs, double4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(double4 lhs, double4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(double4 lhs, double rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator <=(double lhs, double4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(double4 lhs, double4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(double4 lhs, double rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >(double lhs, double4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(double4 lhs, double4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(double4 lhs, double rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator >=(double lhs, double4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator +(double4 val) => val;
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator -(double4 val) => new double4(-val.x, -val.y, -val.z, -val.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator ++(double4 val) => new double4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static double4 operator --(double4 val) => new double4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(double4 lhs, double4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(double4 lhs, double rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(double lhs, double4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(double4 lhs, double4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(double4 lhs, double rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(double lhs, double4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        public double this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new ArgumentException($"double4 has components 0 to 3, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; case 3: w = value; break; default: throw new ArgumentException($"double4 has components 0 to 3, not {index}."); } }
        }

        public double2 xx => new double2(x, x);
        public double2 xy { get => new double2(x, y); set { x = value.x; y = value.y; } }
        public double2 xz { get => new double2(x, z); set { x = value.x; z = value.y; } }
        public double2 xw { get => new double2(x, w); set { x = value.x; w = value.y; } }
        public double2 yx { get => new double2(y, x); set { y = value.x; x = value.y; } }
        public double2 yy => new double2(y, y);
        public double2 yz { get => new double2(y, z); set { y = value.x; z = value.y; } }
        public double2 yw { get => new double2(y, w); set { y = value.x; w = value.y; } }
        public double2 zx { get => new double2(z, x); set { z = value.x; x = value.y; } }
        public double2 zy { get => new double2(z, y); set { z = value.x; y = value.y; } }
        public double2 zz => new double2(z, z);
        public double2 zw { get => new double2(z, w); set { z = value.x; w = value.y; } }
        public double2 wx { get => new double2(w, x); set { w = value.x; x = value.y; } }
        public double2 wy { get => new double2(w, y); set { w = value.x; y = value.y; } }
        public double2 wz { get => new double2(w, z); set { w = value.x; z = value.y; } }
        public double2 ww => new double2(w, w);
        public double3 xxx => new double3(x, x, x);
        public double3 xxy => new double3(x, x, y);
        public double3 xxz => new double3(x, x, z);
        public double3 xxw => new double3(x, x, w);
        public double3 xyx => new double3(x, y, x);
        public double3 xyy => new double3(x, y, y);
        public double3 xyz { get => new double3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public double3 xyw { get => new double3(x, y, w); set { x = value.x; y = value.y; w = value.z; } }
        public double3 xzx => new double3(x, z, x);
        public double3 xzy { get => new double3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public double3 xzz => new double3(x, z, z);
        public double3 xzw { get => new double3(x, z, w); set { x = value.x; z = value.y; w = value.z; } }
        public double3 xwx => new double3(x, w, x);
        public double3 xwy { get => new double3(x, w, y); set { x = value.x; w = value.y; y = value.z; } }
        public double3 xwz { get => new double3(x, w, z); set { x = value.x; w = value.y; z = value.z; } }
        public double3 xww => new double3(x, w, w);
        public double3 yxx => new double3(y, x, x);
        public double3 yxy => new double3(y, x, y);
        public double3 yxz { get => new double3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public double3 yxw { get => new double3(y, x, w); set { y = value.x; x = value.y; w = value.z; } }
        public double3 yyx => new double3(y, y, x);
        public double3 yyy => new double3(y, y, y);
        public double3 yyz => new double3(y, y, z);
        public double3 yyw => new double3(y, y, w);
        public double3 yzx { get => new double3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public double3 yzy => new double3(y, z, y);
        public double3 yzz => new double3(y, z, z);
        public double3 yzw { get => new double3(y, z, w); set { y = value.x; z = value.y; w = value.z; } }
        public double3 ywx { get => new double3(y, w, x); set { y = value.x; w = value.y; x = value.z; } }
        public double3 ywy => new double3(y, w, y);
        public double3 ywz { get => new double3(y, w, z); set { y = value.x; w = value.y; z = value.z; } }
        public double3 yww => new double3(y, w, w);
        public double3 zxx => new double3(z, x, x);
        public double3 zxy { get => new double3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public double3 zxz => new double3(z, x, z);
        public double3 zxw { get => new double3(z, x, w); set { z = value.x; x = value.y; w = value.z; } }
        public double3 zyx { get => new double3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public double3 zyy => new double3(z, y, y);
        public double3 zyz => new double3(z, y, z);
        public double3 zyw { get => new double3(z, y, w); set { z = value.x; y = value.y; w = value.z; } }
        public double3 zzx => new double3(z, z, x);
        public double3 zzy => new double3(z, z, y);
        public double3 zzz => new double3(z, z, z);
        public double3 zzw => new double3(z, z, w);
        public double3 zwx { get => new double3(z, w, x); set { z = value.x; w = value.y; x = value.z; } }
        public double3 zwy { get => new double3(z, w, y); set { z = value.x; w = value.y; y = value.z; } }
        public double3 zwz => new double3(z, w, z);
        public double3 zww => new double3(z, w, w);
        public double3 wxx => new double3(w, x, x);
        public double3 wxy { get => new double3(w, x, y); set { w = value.x; x = value.y; y = value.z; } }
        public double3 wxz { get => new double3(w, x, z); set { w = value.x; x = value.y; z = value.z; } }
        public double3 wxw => new double3(w, x, w);
        public double3 wyx { get => new double3(w, y, x); set { w = value.x; y = value.y; x = value.z; } }
        public double3 wyy => new double3(w, y, y);
        public double3 wyz { get => new double3(w, y, z); set { w = value.x; y = value.y; z = value.z; } }
        public double3 wyw => new double3(w, y, w);
        public double3 wzx { get => new double3(w, z, x); set { w = value.x; z = value.y; x = value.z; } }
        public double3 wzy { get => new double3(w, z, y); set { w = value.x; z = value.y; y = value.z; } }
        public double3 wzz => new double3(w, z, z);
        public double3 wzw => new double3(w, z, w);
        public double3 wwx => new double3(w, w, x);
        public double3 wwy => new double3(w, w, y);
        public double3 wwz => new double3(w, w, z);
        public double3 www => new double3(w, w, w);
        public double4 xxxx => new double4(x, x, x, x);
        public double4 xxxy => new double4(x, x, x, y);
        public double4 xxxz => new double4(x, x, x, z);
        public double4 xxxw => new double4(x, x, x, w);
        public double4 xxyx => new double4(x, x, y, x);
        public double4 xxyy => new double4(x, x, y, y);
        public double4 xxyz => new double4(x, x, y, z);
        public double4 xxyw => new double4(x, x, y, w);
        public double4 xxzx => new double4(x, x, z, x);
        public double4 xxzy => new double4(x, x, z, y);
        public double4 xxzz => new double4(x, x, z, z);
        public double4 xxzw => new double4(x, x, z, w);
        public double4 xxwx => new double4(x, x, w, x);
        public double4 xxwy => new double4(x, x, w, y);
        public double4 xxwz => new double4(x, x, w, z);
        public double4 xxww => new double4(x, x, w, w);
        public double4 xyxx => new double4(x, y, x, x);
        public double4 xyxy => new double4(x, y, x, y);
        public double4 xyxz => new double4(x, y, x, z);
        public double4 xyxw => new double4(x, y, x, w);
        public double4 xyyx => new double4(x, y, y, x);
        public double4 xyyy => new double4(x, y, y, y);
        public double4 xyyz => new double4(x, y, y, z);
        public double4 xyyw => new double4(x, y, y, w);
        public double4 xyzx => new double4(x, y, z, x);
        public double4 xyzy => new double4(x, y, z, y);
        public double4 xyzz => new double4(x, y, z, z);
        public double4 xyzw { get => new double4(x, y, z, w); set { x = value.x; y = value.y; z = value.z; w = value.w; } }
        public double4 xywx => new double4(x, y, w, x);
        public double4 xywy => new double4(x, y, w, y);
        public double4 xywz { get => new double4(x, y, w, z); set { x = value.x; y = value.y; w = value.z; z = value.w; } }
        public double4 xyww => new double4(x, y, w, w);
        public double4 xzxx => new double4(x, z, x, x);
        public double4 xzxy => new double4(x, z, x, y);
        public double4 xzxz => new double4(x, z, x, z);
        public double4 xzxw => new double4(x, z, x, w);
        public double4 xzyx => new double4(x, z, y, x);
        public double4 xzyy => new double4(x, z, y, y);
        public double4 xzyz => new double4(x, z, y, z);
        public double4 xzyw { get => new double4(x, z, y, w); set { x = value.x; z = value.y; y = value.z; w = value.w; } }
        public double4 xzzx => new double4(x, z, z, x);
        public double4 xzzy => new double4(x, z, z, y);
        public double4 xzzz => new double4(x, z, z, z);
        public double4 xzzw => new double4(x, z, z, w);
        public double4 xzwx => new double4(x, z, w, x);
        public double4 xzwy { get => new double4(x, z, w, y); set { x = value.x; z = value.y; w = value.z; y = value.w; } }
        public double4 xzwz => new double4(x, z, w, z);
        public double4 xzww => new double4(x, z, w, w);
        public double4 xwxx => new double4(x, w, x, x);
        public double4 xwxy => new double4(x, w, x, y);
        public double4 xwxz => new double4(x, w, x, z);
        public double4 xwxw => new double4(x, w, x, w);
        public double4 xwyx => new double4(x, w, y, x);
        public double4 xwyy => new double4(x, w, y, y);
        public double4 xwyz { get => new double4(x, w, y, z); set { x = value.x; w = value.y; y = value.z; z = value.w; } }
        public double4 xwyw => new double4(x, w, y, w);
        public double4 xwzx => new double4(x, w, z, x);
        public double4 xwzy { get => new double4(x, w, z, y); set { x = value.x; w = value.y; z = value.z; y = value.w; } }
        public double4 xwzz => new double4(x, w, z, z);
        public double4 xwzw => new double4(x, w, z, w);
        public double4 xwwx => new double4(x, w, w, x);
        public double4 xwwy => new double4(x, w, w, y);
        public double4 xwwz => new double4(x, w, w, z);
        public double4 xwww => new double4(x, w, w, w);
        public double4 yxxx => new double4(y, x, x, x);
        public double4 yxxy => new double4(y, x, x, y);
        public double4 yxxz => new double4(y, x, x, z);
        public double4 yxxw => new double4(y, x, x, w);
        public double4 yxyx => new double4(y, x, y, x);
        public double4 yxyy => new double4(y, x, y, y);
        public double4 yxyz => new double4(y, x, y, z);
        public double4 yxyw => new double4(y, x, y, w);
        public double4 yxzx => new double4(y, x, z, x);
        public double4 yxzy => new double4(y, x, z, y);
        public double4 yxzz => new double4(y, x, z, z);
        public double4 yxzw { get => new double4(y, x, z, w); set { y = value.x; x = value.y; z = value.z; w = value.w; } }
        public double4 yxwx => new double4(y, x, w, x);
        public double4 yxwy => new double4(y, x, w, y);
        public double4 yxwz { get => new double4(y, x, w, z); set { y = value.x; x = value.y; w = value.z; z = value.w; } }
        public double4 yxww => new double4(y, x, w, w);
        public double4 yyxx => new double4(y, y, x, x);
        public double4 yyxy => new double4(y, y, x, y);
        public double4 yyxz => new double4(y, y, x, z);
        public double4 yyxw => new double4(y, y, x, w);
        public double4 yyyx => new double4(y, y, y, x);
        public double4 yyyy => new double4(y, y, y, y);
        public double4 yyyz => new double4(y, y, y, z);
        public double4 yyyw => new double4(y, y, y, w);
        public double4 yyzx => new double4(y, y, z, x);
        public double4 yyzy => new double4(y, y, z, y);
        public double4 yyzz => new double4(y, y, z, z);
        public double4 yyzw => new double4(y, y, z, w);
        public double4 yywx => new double4(y, y, w, x);
        public double4 yywy => new double4(y, y, w, y);
        public double4 yywz => new double4(y, y, w, z);
        public double4 yyww => new double4(y, y, w, w);
        public double4 yzxx => new double4(y, z, x, x);
        public double4 yzxy => new double4(y, z, x, y);
        public double4 yzxz => new double4(y, z, x, z);
        public double4 yzxw { get => new double4(y, z, x, w); set { y = value.x; z = value.y; x = value.z; w = value.w; } }
        public double4 yzyx => new double4(y, z, y, x);
        public double4 yzyy => new double4(y, z, y, y);
        public double4 yzyz => new double4(y, z, y, z);
        public double4 yzyw => new double4(y, z, y, w);
        public double4 yzzx => new double4(y, z, z, x);
        public double4 yzzy => new double4(y, z, z, y);
        public double4 yzzz => new double4(y, z, z, z);
        public double4 yzzw => new double4(y, z, z, w);
        public double4 yzwx { get => new double4(y, z, w, x); set { y = value.x; z = value.y; w = value.z; x = value.w; } }
        public double4 yzwy => new double4(y, z, w, y);
        public double4 yzwz => new double4(y, z, w, z);
        public double4 yzww => new double4(y, z, w, w);
        public double4 ywxx => new double4(y, w, x, x);
        public double4 ywxy => new double4(y, w, x, y);
        public double4 ywxz { get => new double4(y, w, x, z); set { y = value.x; w = value.y; x = value.z; z = value.w; } }
        public double4 ywxw => new double4(y, w, x, w);
        public double4 ywyx => new double4(y, w, y, x);
        public double4 ywyy => new double4(y, w, y, y);
        public double4 ywyz => new double4(y, w, y, z);
        public double4 ywyw => new double4(y, w, y, w);
        public double4 ywzx { get => new double4(y, w, z, x); set { y = value.x; w = value.y; z = value.z; x = value.w; } }
        public double4 ywzy => new double4(y, w, z, y);
        public double4 ywzz => new double4(y, w, z, z);
        public double4 ywzw => new double4(y, w, z, w);
        public double4 ywwx => new double4(y, w, w, x);
        public double4 ywwy => new double4(y, w, w, y);
        public double4 ywwz => new double4(y, w, w, z);
        public double4 ywww => new double4(y, w, w, w);
        public double4 zxxx => new double4(z, x, x, x);
        public double4 zxxy => new double4(z, x, x, y);
        public double4 zxxz => new double4(z, x, x, z);
        public double4 zxxw => new double4(z, x, x, w);
        public double4 zxyx => new double4(z, x, y, x);
        public double4 zxyy => new double4(z, x, y, y);
        public double4 zxyz => new double4(z, x, y, z);
        public double4 zxyw { get => new double4(z, x, y, w); set { z = value.x; x = value.y; y = value.z; w = value.w; } }
        public double4 zxzx => new double4(z, x, z, x);
        public double4 zxzy => new double4(z, x, z, y);
        public double4 zxzz => new double4(z, x, z, z);
        public double4 zxzw => new double4(z, x, z, w);
        public double4 zxwx => new double4(z, x, w, x);
        public double4 zxwy { get => new double4(z, x, w, y); set { z = value.x; x = value.y; w = value.z; y = value.w; } }
        public double4 zxwz => new double4(z, x, w, z);
        public double4 zxww => new double4(z, x, w, w);
        public double4 zyxx => new double4(z, y, x, x);
        public double4 zyxy => new double4(z, y, x, y);
        public double4 zyxz => new double4(z, y, x, z);
        public double4 zyxw { get => new double4(z, y, x, w); set { z = value.x; y = value.y; x = value.z; w = value.w; } }
        public double4 zyyx => new double4(z, y, y, x);
        public double4 zyyy => new double4(z, y, y, y);
        public double4 zyyz => new double4(z, y, y, z);
        public double4 zyyw => new double4(z, y, y, w);
        public double4 zyzx => new double4(z, y, z, x);
        public double4 zyzy => new double4(z, y, z, y);
        public double4 zyzz => new double4(z, y, z, z);
        public double4 zyzw => new double4(z, y, z, w);
        public double4 zywx { get => new double4(z, y, w, x); set { z = value.x; y = value.y; w = value.z; x = value.w; } }
        public double4 zywy => new double4(z, y, w, y);
        public double4 zywz => new double4(z, y, w, z);
        public double4 zyww => new double4(z, y, w, w);
        public double4 zzxx => new double4(z, z, x, x);
        public double4 zzxy => new double4(z, z, x, y);
        public double4 zzxz => new double4(z, z, x, z);
        public double4 zzxw => new double4(z, z, x, w);
        public double4 zzyx => new double4(z, z, y, x);
        public double4 zzyy => new double4(z, z, y, y);
        public double4 zzyz => new double4(z, z, y, z);
        public double4 zzyw => new double4(z, z, y, w);
        public double4 zzzx => new double4(z, z, z, x);
        public double4 zzzy => new double4(z, z, z, y);
        public double4 zzzz => new double4(z, z, z, z);
        public double4 zzzw => new double4(z, z, z, w);
        public double4 zzwx => new double4(z, z, w, x);
        public double4 zzwy => new double4(z, z, w, y);
        public double4 zzwz => new double4(z, z, w, z);
        public double4 zzww => new double4(z, z, w, w);
        public double4 zwxx => new double4(z, w, x, x);
        public double4 zwxy { get => new double4(z, w, x, y); set { z = value.x; w = value.y; x = value.z; y = value.w; } }
        public double4 zwxz => new double4(z, w, x, z);
        public double4 zwxw => new double4(z, w, x, w);
        public double4 zwyx { get => new double4(z, w, y, x); set { z = value.x; w = value.y; y = value.z; x = value.w; } }
        public double4 zwyy => new double4(z, w, y, y);
        public double4 zwyz => new double4(z, w, y, z);
        public double4 zwyw => new double4(z, w, y, w);
        public double4 zwzx => new double4(z, w, z, x);
        public double4 zwzy => new double4(z, w, z, y);
        public double4 zwzz => new double4(z, w, z, z);
        public double4 zwzw => new double4(z, w, z, w);
        public double4 zwwx => new double4(z, w, w, x);
        public double4 zwwy => new double4(z, w, w, y);
        public double4 zwwz => new double4(z, w, w, z);
        public double4 zwww => new double4(z, w, w, w);
        public double4 wxxx => new double4(w, x, x, x);
        public double4 wxxy => new double4(w, x, x, y);
        public double4 wxxz => new double4(w, x, x, z);
        public double4 wxxw => new double4(w, x, x, w);
        public double4 wxyx => new double4(w, x, y, x);
        public double4 wxyy => new double4(w, x, y, y);
        public double4 wxyz { get => new double4(w, x, y, z); set { w = value.x; x = value.y; y = value.z; z = value.w; } }
        public double4 wxyw => new double4(w, x, y, w);
        public double4 wxzx => new double4(w, x, z, x);
        public double4 wxzy { get => new double4(w, x, z, y); set { w = value.x; x = value.y; z = value.z; y = value.w; } }
        public double4 wxzz => new double4(w, x, z, z);
        public double4 wxzw => new double4(w, x, z, w);
        public double4 wxwx => new double4(w, x, w, x);
        public double4 wxwy => new double4(w, x, w, y);
        public double4 wxwz => new double4(w, x, w, z);
        public double4 wxww => new double4(w, x, w, w);
        public double4 wyxx => new double4(w, y, x, x);
        public double4 wyxy => new double4(w, y, x, y);
        public double4 wyxz { get => new double4(w, y, x, z); set { w = value.x; y = value.y; x = value.z; z = value.w; } }
        public double4 wyxw => new double4(w, y, x, w);
        public double4 wyyx => new double4(w, y, y, x);
        public double4 wyyy => new double4(w, y, y, y);
        public double4 wyyz => new double4(w, y, y, z);
        public double4 wyyw => new double4(w, y, y, w);
        public double4 wyzx { get => new double4(w, y, z, x); set { w = value.x; y = value.y; z = value.z; x = value.w; } }
        public double4 wyzy => new double4(w, y, z, y);
        public double4 wyzz => new double4(w, y, z, z);
        public double4 wyzw => new double4(w, y, z, w);
        public double4 wywx => new double4(w, y, w, x);
        public double4 wywy => new double4(w, y, w, y);
        public double4 wywz => new double4(w, y, w, z);
        public double4 wyww => new double4(w, y, w, w);
        public double4 wzxx => new double4(w, z, x, x);
        public double4 wzxy { get => new double4(w, z, x, y); set { w = value.x; z = value.y; x = value.z; y = value.w; } }
        public double4 wzxz => new double4(w, z, x, z);
        public double4 wzxw => new double4(w, z, x, w);
        public double4 wzyx { get => new double4(w, z, y, x); set { w = value.x; z = value.y; y = value.z; x = value.w; } }
        public double4 wzyy => new double4(w, z, y, y);
        public double4 wzyz => new double4(w, z, y, z);
        public double4 wzyw => new double4(w, z, y, w);
        public double4 wzzx => new double4(w, z, z, x);
        public double4 wzzy => new double4(w, z, z, y);
        public double4 wzzz => new double4(w, z, z, z);
        public double4 wzzw => new double4(w, z, z, w);
        public double4 wzwx => new double4(w, z, w, x);
        public double4 wzwy => new double4(w, z, w, y);
        public double4 wzwz => new double4(w, z, w, z);
        public double4 wzww => new double4(w, z, w, w);
        public double4 wwxx => new double4(w, w, x, x);
        public double4 wwxy => new double4(w, w, x, y);
        public double4 wwxz => new double4(w, w, x, z);
        public double4 wwxw => new double4(w, w, x, w);
        public double4 wwyx => new double4(w, w, y, x);
        public double4 wwyy => new double4(w, w, y, y);
        public double4 wwyz => new double4(w, w, y, z);
        public double4 wwyw => new double4(w, w, y, w);
        public double4 wwzx => new double4(w, w, z, x);
        public double4 wwzy => new double4(w, w, z, y);
        public double4 wwzz => new double4(w, w, z, z);
        public double4 wwzw => new double4(w, w, z, w);
        public double4 wwwx => new double4(w, w, w, x);
        public double4 wwwy => new double4(w, w, w, y);
        public double4 wwwz => new double4(w, w, w, z);
        public double4 wwww => new double4(w, w, w, w);

        public bool Equals(double4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
        public override bool Equals(object o) => o is double4 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"double4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";
    }

    [Serializable]
    public partial struct bool2 : IEquatable<bool2>
    {
        public bool x;
        public bool y;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool2(bool x, bool y) { this.x = x; this.y = y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool2(bool2 xy) { this.x = xy.x; this.y = xy.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool2(bool v) { this.x = v; this.y = v; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator bool2(bool v) => new bool2(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator &(bool2 lhs, bool2 rhs) => new bool2(lhs.x & rhs.x, lhs.y & rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator &(bool2 lhs, bool rhs) => new bool2(lhs.x & rhs, lhs.y & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator &(bool lhs, bool2 rhs) => new bool2(lhs & rhs.x, lhs & rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator |(bool2 lhs, bool2 rhs) => new bool2(lhs.x | rhs.x, lhs.y | rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator |(bool2 lhs, bool rhs) => new bool2(lhs.x | rhs, lhs.y | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator |(bool lhs, bool2 rhs) => new bool2(lhs | rhs.x, lhs | rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ^(bool2 lhs, bool2 rhs) => new bool2(lhs.x ^ rhs.x, lhs.y ^ rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ^(bool2 lhs, bool rhs) => new bool2(lhs.x ^ rhs, lhs.y ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ^(bool lhs, bool2 rhs) => new bool2(lhs ^ rhs.x, lhs ^ rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !(bool2 val) => new bool2(!val.x, !val.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(bool2 lhs, bool2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(bool2 lhs, bool rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator ==(bool lhs, bool2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(bool2 lhs, bool2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(bool2 lhs, bool rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool2 operator !=(bool lhs, bool2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        public bool this[int index]
        {
            get => index switch { 0 => x, 1 => y, _ => throw new ArgumentException($"bool2 has components 0 to 1, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; default: throw new ArgumentException($"bool2 has components 0 to 1, not {index}."); } }
        }

        public bool2 xx => new bool2(x, x);
        public bool2 xy { get => new bool2(x, y); set { x = value.x; y = value.y; } }
        public bool2 yx { get => new bool2(y, x); set { y = value.x; x = value.y; } }
        public bool2 yy => new bool2(y, y);
        public bool3 xxx => new bool3(x, x, x);
        public bool3 xxy => new bool3(x, x, y);
        public bool3 xyx => new bool3(x, y, x);
        public bool3 xyy => new bool3(x, y, y);
        public bool3 yxx => new bool3(y, x, x);
        public bool3 yxy => new bool3(y, x, y);
        public bool3 yyx => new bool3(y, y, x);
        public bool3 yyy => new bool3(y, y, y);
        public bool4 xxxx => new bool4(x, x, x, x);
        public bool4 xxxy => new bool4(x, x, x, y);
        public bool4 xxyx => new bool4(x, x, y, x);
        public bool4 xxyy => new bool4(x, x, y, y);
        public bool4 xyxx => new bool4(x, y, x, x);
        public bool4 xyxy => new bool4(x, y, x, y);
        public bool4 xyyx => new bool4(x, y, y, x);
        public bool4 xyyy => new bool4(x, y, y, y);
        public bool4 yxxx => new bool4(y, x, x, x);
        public bool4 yxxy => new bool4(y, x, x, y);
        public bool4 yxyx => new bool4(y, x, y, x);
        public bool4 yxyy => new bool4(y, x, y, y);
        public bool4 yyxx => new bool4(y, y, x, x);
        public bool4 yyxy => new bool4(y, y, x, y);
        public bool4 yyyx => new bool4(y, y, y, x);
        public bool4 yyyy => new bool4(y, y, y, y);

        public bool Equals(bool2 rhs) => x == rhs.x && y == rhs.y;
        public override bool Equals(object o) => o is bool2 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => $"bool2({x}, {y})";
    }

    [Serializable]
    public partial struct bool3 : IEquatable<bool3>
    {
        public bool x;
        public bool y;
        public bool z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool3(bool x, bool y, bool z) { this.x = x; this.y = y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool3(bool x, bool2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool3(bool2 xy, bool z) { this.x = xy.x; this.y = xy.y; this.z = z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool3(bool3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool3(bool v) { this.x = v; this.y = v; this.z = v; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator bool3(bool v) => new bool3(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator &(bool3 lhs, bool3 rhs) => new bool3(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator &(bool3 lhs, bool rhs) => new bool3(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator &(bool lhs, bool3 rhs) => new bool3(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator |(bool3 lhs, bool3 rhs) => new bool3(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator |(bool3 lhs, bool rhs) => new bool3(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator |(bool lhs, bool3 rhs) => new bool3(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ^(bool3 lhs, bool3 rhs) => new bool3(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ^(bool3 lhs, bool rhs) => new bool3(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ^(bool lhs, bool3 rhs) => new bool3(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !(bool3 val) => new bool3(!val.x, !val.y, !val.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(bool3 lhs, bool3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(bool3 lhs, bool rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator ==(bool lhs, bool3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(bool3 lhs, bool3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(bool3 lhs, bool rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool3 operator !=(bool lhs, bool3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        public bool this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new ArgumentException($"bool3 has components 0 to 2, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; default: throw new ArgumentException($"bool3 has components 0 to 2, not {index}."); } }
        }

        public bool2 xx => new bool2(x, x);
        public bool2 xy { get => new bool2(x, y); set { x = value.x; y = value.y; } }
        public bool2 xz { get => new bool2(x, z); set { x = value.x; z = value.y; } }
        public bool2 yx { get => new bool2(y, x); set { y = value.x; x = value.y; } }
        public bool2 yy => new bool2(y, y);
        public bool2 yz { get => new bool2(y, z); set { y = value.x; z = value.y; } }
        public bool2 zx { get => new bool2(z, x); set { z = value.x; x = value.y; } }
        public bool2 zy { get => new bool2(z, y); set { z = value.x; y = value.y; } }
        public bool2 zz => new bool2(z, z);
        public bool3 xxx => new bool3(x, x, x);
        public bool3 xxy => new bool3(x, x, y);
        public bool3 xxz => new bool3(x, x, z);
        public bool3 xyx => new bool3(x, y, x);
        public bool3 xyy => new bool3(x, y, y);
        public bool3 xyz { get => new bool3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public bool3 xzx => new bool3(x, z, x);
        public bool3 xzy { get => new bool3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public bool3 xzz => new bool3(x, z, z);
        public bool3 yxx => new bool3(y, x, x);
        public bool3 yxy => new bool3(y, x, y);
        public bool3 yxz { get => new bool3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public bool3 yyx => new bool3(y, y, x);
        public bool3 yyy => new bool3(y, y, y);
        public bool3 yyz => new bool3(y, y, z);
        public bool3 yzx { get => new bool3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public bool3 yzy => new bool3(y, z, y);
        public bool3 yzz => new bool3(y, z, z);
        public bool3 zxx => new bool3(z, x, x);
        public bool3 zxy { get => new bool3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public bool3 zxz => new bool3(z, x, z);
        public bool3 zyx { get => new bool3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public bool3 zyy => new bool3(z, y, y);
        public bool3 zyz => new bool3(z, y, z);
        public bool3 zzx => new bool3(z, z, x);
        public bool3 zzy => new bool3(z, z, y);
        public bool3 zzz => new bool3(z, z, z);
        public bool4 xxxx => new bool4(x, x, x, x);
        public bool4 xxxy => new bool4(x, x, x, y);
        public bool4 xxxz => new bool4(x, x, x, z);
        public bool4 xxyx => new bool4(x, x, y, x);
        public bool4 xxyy => new bool4(x, x, y, y);
        public bool4 xxyz => new bool4(x, x, y, z);
        public bool4 xxzx => new bool4(x, x, z, x);
        public bool4 xxzy => new bool4(x, x, z, y);
        public bool4 xxzz => new bool4(x, x, z, z);
        public bool4 xyxx => new bool4(x, y, x, x);
        public bool4 xyxy => new bool4(x, y, x, y);
        public bool4 xyxz => new bool4(x, y, x, z);
        public bool4 xyyx => new bool4(x, y, y, x);
        public bool4 xyyy => new bool4(x, y, y, y);
        public bool4 xyyz => new bool4(x, y, y, z);
        public bool4 xyzx => new bool4(x, y, z, x);
        public bool4 xyzy => new bool4(x, y, z, y);
        public bool4 xyzz => new bool4(x, y, z, z);
        public bool4 xzxx => new bool4(x, z, x, x);
        public bool4 xzxy => new bool4(x, z, x, y);
        public bool4 xzxz => new bool4(x, z, x, z);
        public bool4 xzyx => new bool4(x, z, y, x);
        public bool4 xzyy => new bool4(x, z, y, y);
        public bool4 xzyz => new bool4(x, z, y, z);
        public bool4 xzzx => new bool4(x, z, z, x);
        public bool4 xzzy => new bool4(x, z, z, y);
        public bool4 xzzz => new bool4(x, z, z, z);
        public bool4 yxxx => new bool4(y, x, x, x);
        public bool4 yxxy => new bool4(y, x, x, y);
        public bool4 yxxz => new bool4(y, x, x, z);
        public bool4 yxyx => new bool4(y, x, y, x);
        public bool4 yxyy => new bool4(y, x, y, y);
        public bool4 yxyz => new bool4(y, x, y, z);
        public bool4 yxzx => new bool4(y, x, z, x);
        public bool4 yxzy => new bool4(y, x, z, y);
        public bool4 yxzz => new bool4(y, x, z, z);
        public bool4 yyxx => new bool4(y, y, x, x);
        public bool4 yyxy => new bool4(y, y, x, y);
        public bool4 yyxz => new bool4(y, y, x, z);
        public bool4 yyyx => new bool4(y, y, y, x);
        public bool4 yyyy => new bool4(y, y, y, y);
        public bool4 yyyz => new bool4(y, y, y, z);
        public bool4 yyzx => new bool4(y, y, z, x);
        public bool4 yyzy => new bool4(y, y, z, y);
        public bool4 yyzz => new bool4(y, y, z, z);
        public bool4 yzxx => new bool4(y, z, x, x);
        public bool4 yzxy => new bool4(y, z, x, y);
        public bool4 yzxz => new bool4(y, z, x, z);
        public bool4 yzyx => new bool4(y, z, y, x);
        public bool4 yzyy => new bool4(y, z, y, y);
        public bool4 yzyz => new bool4(y, z, y, z);
        public bool4 yzzx => new bool4(y, z, z, x);
        public bool4 yzzy => new bool4(y, z, z, y);
        public bool4 yzzz => new bool4(y, z, z, z);
        public bool4 zxxx => new bool4(z, x, x, x);
        public bool4 zxxy => new bool4(z, x, x, y);
        public bool4 zxxz => new bool4(z, x, x, z);
        public bool4 zxyx => new bool4(z, x, y, x);
        public bool4 zxyy => new bool4(z, x, y, y);
        public bool4 zxyz => new bool4(z, x, y, z);
        public bool4 zxzx => new bool4(z, x, z, x);
        public bool4 zxzy => new bool4(z, x, z, y);
        public bool4 zxzz => new bool4(z, x, z, z);
        public bool4 zyxx => new bool4(z, y, x, x);
        public bool4 zyxy => new bool4(z, y, x, y);
        public bool4 zyxz => new bool4(z, y, x, z);
        public bool4 zyyx => new bool4(z, y, y, x);
        public bool4 zyyy => new bool4(z, y, y, y);
        public bool4 zyyz => new bool4(z, y, y, z);
        public bool4 zyzx => new bool4(z, y, z, x);
        public bool4 zyzy => new bool4(z, y, z, y);
        public bool4 zyzz => new bool4(z, y, z, z);
        public bool4 zzxx => new bool4(z, z, x, x);
        public bool4 zzxy => new bool4(z, z, x, y);
        public bool4 zzxz => new bool4(z, z, x, z);
        public bool4 zzyx => new bool4(z, z, y, x);
        public bool4 zzyy => new bool4(z, z, y, y);
        public bool4 zzyz => new bool4(z, z, y, z);
        public bool4 zzzx => new bool4(z, z, z, x);
        public bool4 zzzy => new bool4(z, z, z, y);
        public bool4 zzzz => new bool4(z, z, z, z);

        public bool Equals(bool3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
        public override bool Equals(object o) => o is bool3 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => $"bool3({x}, {y}, {z})";
    }

    [Serializable]
    public partial struct bool4 : IEquatable<bool4>
    {
        public bool x;
        public bool y;
        public bool z;
        public bool w;

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool x, bool y, bool z, bool w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool x, bool y, bool2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool x, bool2 yz, bool w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool x, bool3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool2 xy, bool z, bool w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool2 xy, bool2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool3 xyz, bool w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public bool4(bool v) { this.x = v; this.y = v; this.z = v; this.w = v; }

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator bool4(bool v) => new bool4(v);

        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator &(bool4 lhs, bool4 rhs) => new bool4(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator &(bool4 lhs, bool rhs) => new bool4(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator &(bool lhs, bool4 rhs) => new bool4(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator |(bool4 lhs, bool4 rhs) => new bool4(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator |(bool4 lhs, bool rhs) => new bool4(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator |(bool lhs, bool4 rhs) => new bool4(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ^(bool4 lhs, bool4 rhs) => new bool4(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ^(bool4 lhs, bool rhs) => new bool4(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ^(bool lhs, bool4 rhs) => new bool4(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !(bool4 val) => new bool4(!val.x, !val.y, !val.z, !val.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(bool4 lhs, bool4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(bool4 lhs, bool rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator ==(bool lhs, bool4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(bool4 lhs, bool4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(bool4 lhs, bool rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static bool4 operator !=(bool lhs, bool4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        public bool this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new ArgumentException($"bool4 has components 0 to 3, not {index}.") };
            set { switch (index) { case 0: x = value; break; case 1: y = value; break; case 2: z = value; break; case 3: w = value; break; default: throw new ArgumentException($"bool4 has components 0 to 3, not {index}."); } }
        }

        public bool2 xx => new bool2(x, x);
        public bool2 xy { get => new bool2(x, y); set { x = value.x; y = value.y; } }
        public bool2 xz { get => new bool2(x, z); set { x = value.x; z = value.y; } }
        public bool2 xw { get => new bool2(x, w); set { x = value.x; w = value.y; } }
        public bool2 yx { get => new bool2(y, x); set { y = value.x; x = value.y; } }
        public bool2 yy => new bool2(y, y);
        public bool2 yz { get => new bool2(y, z); set { y = value.x; z = value.y; } }
        public bool2 yw { get => new bool2(y, w); set { y = value.x; w = value.y; } }
        public bool2 zx { get => new bool2(z, x); set { z = value.x; x = value.y; } }
        public bool2 zy { get => new bool2(z, y); set { z = value.x; y = value.y; } }
        public bool2 zz => new bool2(z, z);
        public bool2 zw { get => new bool2(z, w); set { z = value.x; w = value.y; } }
        public bool2 wx { get => new bool2(w, x); set { w = value.x; x = value.y; } }
        public bool2 wy { get => new bool2(w, y); set { w = value.x; y = value.y; } }
        public bool2 wz { get => new bool2(w, z); set { w = value.x; z = value.y; } }
        public bool2 ww => new bool2(w, w);
        public bool3 xxx => new bool3(x, x, x);
        public bool3 xxy => new bool3(x, x, y);
        public bool3 xxz => new bool3(x, x, z);
        public bool3 xxw => new bool3(x, x, w);
        public bool3 xyx => new bool3(x, y, x);
        public bool3 xyy => new bool3(x, y, y);
        public bool3 xyz { get => new bool3(x, y, z); set { x = value.x; y = value.y; z = value.z; } }
        public bool3 xyw { get => new bool3(x, y, w); set { x = value.x; y = value.y; w = value.z; } }
        public bool3 xzx => new bool3(x, z, x);
        public bool3 xzy { get => new bool3(x, z, y); set { x = value.x; z = value.y; y = value.z; } }
        public bool3 xzz => new bool3(x, z, z);
        public bool3 xzw { get => new bool3(x, z, w); set { x = value.x; z = value.y; w = value.z; } }
        public bool3 xwx => new bool3(x, w, x);
        public bool3 xwy { get => new bool3(x, w, y); set { x = value.x; w = value.y; y = value.z; } }
        public bool3 xwz { get => new bool3(x, w, z); set { x = value.x; w = value.y; z = value.z; } }
        public bool3 xww => new bool3(x, w, w);
        public bool3 yxx => new bool3(y, x, x);
        public bool3 yxy => new bool3(y, x, y);
        public bool3 yxz { get => new bool3(y, x, z); set { y = value.x; x = value.y; z = value.z; } }
        public bool3 yxw { get => new bool3(y, x, w); set { y = value.x; x = value.y; w = value.z; } }
        public bool3 yyx => new bool3(y, y, x);
        public bool3 yyy => new bool3(y, y, y);
        public bool3 yyz => new bool3(y, y, z);
        public bool3 yyw => new bool3(y, y, w);
        public bool3 yzx { get => new bool3(y, z, x); set { y = value.x; z = value.y; x = value.z; } }
        public bool3 yzy => new bool3(y, z, y);
        public bool3 yzz => new bool3(y, z, z);
        public bool3 yzw { get => new bool3(y, z, w); set { y = value.x; z = value.y; w = value.z; } }
        public bool3 ywx { get => new bool3(y, w, x); set { y = value.x; w = value.y; x = value.z; } }
        public bool3 ywy => new bool3(y, w, y);
        public bool3 ywz { get => new bool3(y, w, z); set { y = value.x; w = value.y; z = value.z; } }
        public bool3 yww => new bool3(y, w, w);
        public bool3 zxx => new bool3(z, x, x);
        public bool3 zxy { get => new bool3(z, x, y); set { z = value.x; x = value.y; y = value.z; } }
        public bool3 zxz => new bool3(z, x, z);
        public bool3 zxw { get => new bool3(z, x, w); set { z = value.x; x = value.y; w = value.z; } }
        public bool3 zyx { get => new bool3(z, y, x); set { z = value.x; y = value.y; x = value.z; } }
        public bool3 zyy => new bool3(z, y, y);
        public bool3 zyz => new bool3(z, y, z);
        public bool3 zyw { get => new bool3(z, y, w); set { z = value.x; y = value.y; w = value.z; } }
        public bool3 zzx => new bool3(z, z, x);
        public bool3 zzy => new bool3(z, z, y);
        public bool3 zzz => new bool3(z, z, z);
        public bool3 zzw => new bool3(z, z, w);
        public bool3 zwx { get => new bool3(z, w, x); set { z = value.x; w = value.y; x = value.z; } }
        public bool3 zwy { get => new bool3(z, w, y); set { z = value.x; w = value.y; y = value.z; } }
        public bool3 zwz => new bool3(z, w, z);
        public bool3 zww => new bool3(z, w, w);
        public bool3 wxx => new bool3(w, x, x);
        public bool3 wxy { get => new bool3(w, x, y); set { w = value.x; x = value.y; y = value.z; } }
        public bool3 wxz { get => new bool3(w, x, z); set { w = value.x; x = value.y; z = value.z; } }
        public bool3 wxw => new bool3(w, x, w);
        public bool3 wyx { get => new bool3(w, y, x); set { w = value.x; y = value.y; x = value.z; } }
        public bool3 wyy => new bool3(w, y, y);
        public bool3 wyz { get => new bool3(w, y, z); set { w = value.x; y = value.y; z = value.z; } }
        public bool3 wyw => new bool3(w, y, w);
        public bool3 wzx { get => new bool3(w, z, x); set { w = value.x; z = value.y; x = value.z; } }
        public bool3 wzy { get => new bool3(w, z, y); set { w = value.x; z = value.y; y = value.z; } }
        public bool3 wzz => new bool3(w, z, z);
        public bool3 wzw => new bool3(w, z, w);
        public bool3 wwx => new bool3(w, w, x);
        public bool3 wwy => new bool3(w, w, y);
        public bool3 wwz => new bool3(w, w, z);
        public bool3 www => new bool3(w, w, w);
        public bool4 xxxx => new bool4(x, x, x, x);
        public bool4 xxxy => new bool4(x, x, x, y);
        public bool4 xxxz => new bool4(x, x, x, z);
        public bool4 xxxw => new bool4(x, x, x, w);
        public bool4 xxyx => new bool4(x, x, y, x);
        public bool4 xxyy => new bool4(x, x, y, y);
        public bool4 xxyz => new bool4(x, x, y, z);
        public bool4 xxyw => new bool4(x, x, y, w);
        public bool4 xxzx => new bool4(x, x, z, x);
        public bool4 xxzy => new bool4(x, x, z, y);
        public bool4 xxzz => new bool4(x, x, z, z);
        public bool4 xxzw => new bool4(x, x, z, w);
        public bool4 xxwx => new bool4(x, x, w, x);
        public bool4 xxwy => new bool4(x, x, w, y);
        public bool4 xxwz => new bool4(x, x, w, z);
        public bool4 xxww => new bool4(x, x, w, w);
        public bool4 xyxx => new bool4(x, y, x, x);
        public bool4 xyxy => new bool4(x, y, x, y);
        public bool4 xyxz => new bool4(x, y, x, z);
        public bool4 xyxw => new bool4(x, y, x, w);
        public bool4 xyyx => new bool4(x, y, y, x);
        public bool4 xyyy => new bool4(x, y, y, y);
        public bool4 xyyz => new bool4(x, y, y, z);
        public bool4 xyyw => new bool4(x, y, y, w);
        public bool4 xyzx => new bool4(x, y, z, x);
        public bool4 xyzy => new bool4(x, y, z, y);
        public bool4 xyzz => new bool4(x, y, z, z);
        public bool4 xyzw { get => new bool4(x, y, z, w); set { x = value.x; y = value.y; z = value.z; w = value.w; } }
        public bool4 xywx => new bool4(x, y, w, x);
        public bool4 xywy => new bool4(x, y, w, y);
        public bool4 xywz { get => new bool4(x, y, w, z); set { x = value.x; y = value.y; w = value.z; z = value.w; } }
        public bool4 xyww => new bool4(x, y, w, w);
        public bool4 xzxx => new bool4(x, z, x, x);
        public bool4 xzxy => new bool4(x, z, x, y);
        public bool4 xzxz => new bool4(x, z, x, z);
        public bool4 xzxw => new bool4(x, z, x, w);
        public bool4 xzyx => new bool4(x, z, y, x);
        public bool4 xzyy => new bool4(x, z, y, y);
        public bool4 xzyz => new bool4(x, z, y, z);
        public bool4 xzyw { get => new bool4(x, z, y, w); set { x = value.x; z = value.y; y = value.z; w = value.w; } }
        public bool4 xzzx => new bool4(x, z, z, x);
        public bool4 xzzy => new bool4(x, z, z, y);
        public bool4 xzzz => new bool4(x, z, z, z);
        public bool4 xzzw => new bool4(x, z, z, w);
        public bool4 xzwx => new bool4(x, z, w, x);
        public bool4 xzwy { get => new bool4(x, z, w, y); set { x = value.x; z = value.y; w = value.z; y = value.w; } }
        public bool4 xzwz => new bool4(x, z, w, z);
        public bool4 xzww => new bool4(x, z, w, w);
        public bool4 xwxx => new bool4(x, w, x, x);
        public bool4 xwxy => new bool4(x, w, x, y);
        public bool4 xwxz => new bool4(x, w, x, z);
        public bool4 xwxw => new bool4(x, w, x, w);
        public bool4 xwyx => new bool4(x, w, y, x);
        public bool4 xwyy => new bool4(x, w, y, y);
        public bool4 xwyz { get => new bool4(x, w, y, z); set { x = value.x; w = value.y; y = value.z; z = value.w; } }
        public bool4 xwyw => new bool4(x, w, y, w);
        public bool4 xwzx => new bool4(x, w, z, x);
        public bool4 xwzy { get => new bool4(x, w, z, y); set { x = value.x; w = value.y; z = value.z; y = value.w; } }
        public bool4 xwzz => new bool4(x, w, z, z);
        public bool4 xwzw => new bool4(x, w, z, w);
        public bool4 xwwx => new bool4(x, w, w, x);
        public bool4 xwwy => new bool4(x, w, w, y);
        public bool4 xwwz => new bool4(x, w, w, z);
        public bool4 xwww => new bool4(x, w, w, w);
        public bool4 yxxx => new bool4(y, x, x, x);
        public bool4 yxxy => new bool4(y, x, x, y);
        public bool4 yxxz => new bool4(y, x, x, z);
        public bool4 yxxw => new bool4(y, x, x, w);
        public bool4 yxyx => new bool4(y, x, y, x);
        public bool4 yxyy => new bool4(y, x, y, y);
        public bool4 yxyz => new bool4(y, x, y, z);
        public bool4 yxyw => new bool4(y, x, y, w);
        public bool4 yxzx => new bool4(y, x, z, x);
        public bool4 yxzy => new bool4(y, x, z, y);
        public bool4 yxzz => new bool4(y, x, z, z);
        public bool4 yxzw { get => new bool4(y, x, z, w); set { y = value.x; x = value.y; z = value.z; w = value.w; } }
        public bool4 yxwx => new bool4(y, x, w, x);
        public bool4 yxwy => new bool4(y, x, w, y);
        public bool4 yxwz { get => new bool4(y, x, w, z); set { y = value.x; x = value.y; w = value.z; z = value.w; } }
        public bool4 yxww => new bool4(y, x, w, w);
        public bool4 yyxx => new bool4(y, y, x, x);
        public bool4 yyxy => new bool4(y, y, x, y);
        public bool4 yyxz => new bool4(y, y, x, z);
        public bool4 yyxw => new bool4(y, y, x, w);
        public bool4 yyyx => new bool4(y, y, y, x);
        public bool4 yyyy => new bool4(y, y, y, y);
        public bool4 yyyz => new bool4(y, y, y, z);
        public bool4 yyyw => new bool4(y, y, y, w);
        public bool4 yyzx => new bool4(y, y, z, x);
        public bool4 yyzy => new bool4(y, y, z, y);
        public bool4 yyzz => new bool4(y, y, z, z);
        public bool4 yyzw => new bool4(y, y, z, w);
        public bool4 yywx => new bool4(y, y, w, x);
        public bool4 yywy => new bool4(y, y, w, y);
        public bool4 yywz => new bool4(y, y, w, z);
        public bool4 yyww => new bool4(y, y, w, w);
        public bool4 yzxx => new bool4(y, z, x, x);
        public bool4 yzxy => new bool4(y, z, x, y);
        public bool4 yzxz => new bool4(y, z, x, z);
        public bool4 yzxw { get => new bool4(y, z, x, w); set { y = value.x; z = value.y; x = value.z; w = value.w; } }
        public bool4 yzyx => new bool4(y, z, y, x);
        public bool4 yzyy => new bool4(y, z, y, y);
        public bool4 yzyz => new bool4(y, z, y, z);
        public bool4 yzyw => new bool4(y, z, y, w);
        public bool4 yzzx => new bool4(y, z, z, x);
        public bool4 yzzy => new bool4(y, z, z, y);
        public bool4 yzzz => new bool4(y, z, z, z);
        public bool4 yzzw => new bool4(y, z, z, w);
        public bool4 yzwx { get => new bool4(y, z, w, x); set { y = value.x; z = value.y; w = value.z; x = value.w; } }
        public bool4 yzwy => new bool4(y, z, w, y);
        public bool4 yzwz => new bool4(y, z, w, z);
        public bool4 yzww => new bool4(y, z, w, w);
        public bool4 ywxx => new bool4(y, w, x, x);
        public bool4 ywxy => new bool4(y, w, x, y);
        public bool4 ywxz { get => new bool4(y, w, x, z); set { y = value.x; w = value.y; x = value.z; z = value.w; } }
        public bool4 ywxw => new bool4(y, w, x, w);
        public bool4 ywyx => new bool4(y, w, y, x);
        public bool4 ywyy => new bool4(y, w, y, y);
        public bool4 ywyz => new bool4(y, w, y, z);
        public bool4 ywyw => new bool4(y, w, y, w);
        public bool4 ywzx { get => new bool4(y, w, z, x); set { y = value.x; w = value.y; z = value.z; x = value.w; } }
        public bool4 ywzy => new bool4(y, w, z, y);
        public bool4 ywzz => new bool4(y, w, z, z);
        public bool4 ywzw => new bool4(y, w, z, w);
        public bool4 ywwx => new bool4(y, w, w, x);
        public bool4 ywwy => new bool4(y, w, w, y);
        public bool4 ywwz => new bool4(y, w, w, z);
        public bool4 ywww => new bool4(y, w, w, w);
        public bool4 zxxx => new bool4(z, x, x, x);
        public bool4 zxxy => new bool4(z, x, x, y);
        public bool4 zxxz => new bool4(z, x, x, z);
        public bool4 zxxw => new bool4(z, x, x, w);
        public bool4 zxyx => new bool4(z, x, y, x);
        public bool4 zxyy => new bool4(z, x, y, y);
        public bool4 zxyz => new bool4(z, x, y, z);
        public bool4 zxyw { get => new bool4(z, x, y, w); set { z = value.x; x = value.y; y = value.z; w = value.w; } }
        public bool4 zxzx => new bool4(z, x, z, x);
        public bool4 zxzy => new bool4(z, x, z, y);
        public bool4 zxzz => new bool4(z, x, z, z);
        public bool4 zxzw => new bool4(z, x, z, w);
        public bool4 zxwx => new bool4(z, x, w, x);
        public bool4 zxwy { get => new bool4(z, x, w, y); set { z = value.x; x = value.y; w = value.z; y = value.w; } }
        public bool4 zxwz => new bool4(z, x, w, z);
        public bool4 zxww => new bool4(z, x, w, w);
        public bool4 zyxx => new bool4(z, y, x, x);
        public bool4 zyxy => new bool4(z, y, x, y);
        public bool4 zyxz => new bool4(z, y, x, z);
        public bool4 zyxw { get => new bool4(z, y, x, w); set { z = value.x; y = value.y; x = value.z; w = value.w; } }
        public bool4 zyyx => new bool4(z, y, y, x);
        public bool4 zyyy => new bool4(z, y, y, y);
        public bool4 zyyz => new bool4(z, y, y, z);
        public bool4 zyyw => new bool4(z, y, y, w);
        public bool4 zyzx => new bool4(z, y, z, x);
        public bool4 zyzy => new bool4(z, y, z, y);
        public bool4 zyzz => new bool4(z, y, z, z);
        public bool4 zyzw => new bool4(z, y, z, w);
        public bool4 zywx { get => new bool4(z, y, w, x); set { z = value.x; y = value.y; w = value.z; x = value.w; } }
        public bool4 zywy => new bool4(z, y, w, y);
        public bool4 zywz => new bool4(z, y, w, z);
        public bool4 zyww => new bool4(z, y, w, w);
        public bool4 zzxx => new bool4(z, z, x, x);
        public bool4 zzxy => new bool4(z, z, x, y);
        public bool4 zzxz => new bool4(z, z, x, z);
        public bool4 zzxw => new bool4(z, z, x, w);
        public bool4 zzyx => new bool4(z, z, y, x);
        public bool4 zzyy => new bool4(z, z, y, y);
        public bool4 zzyz => new bool4(z, z, y, z);
        public bool4 zzyw => new bool4(z, z, y, w);
        public bool4 zzzx => new bool4(z, z, z, x);
        public bool4 zzzy => new bool4(z, z, z, y);
        public bool4 zzzz => new bool4(z, z, z, z);
        public bool4 zzzw => new bool4(z, z, z, w);
        public bool4 zzwx => new bool4(z, z, w, x);
        public bool4 zzwy => new bool4(z, z, w, y);
        public bool4 zzwz => new bool4(z, z, w, z);
        public bool4 zzww => new bool4(z, z, w, w);
        public bool4 zwxx => new bool4(z, w, x, x);
        public bool4 zwxy { get => new bool4(z, w, x, y); set { z = value.x; w = value.y; x = value.z; y = value.w; } }
        public bool4 zwxz => new bool4(z, w, x, z);
        public bool4 zwxw => new bool4(z, w, x, w);
        public bool4 zwyx { get => new bool4(z, w, y, x); set { z = value.x; w = value.y; y = value.z; x = value.w; } }
        public bool4 zwyy => new bool4(z, w, y, y);
        public bool4 zwyz => new bool4(z, w, y, z);
        public bool4 zwyw => new bool4(z, w, y, w);
        public bool4 zwzx => new bool4(z, w, z, x);
        public bool4 zwzy => new bool4(z, w, z, y);
        public bool4 zwzz => new bool4(z, w, z, z);
        public bool4 zwzw => new bool4(z, w, z, w);
        public bool4 zwwx => new bool4(z, w, w, x);
        public bool4 zwwy => new bool4(z, w, w, y);
        public bool4 zwwz => new bool4(z, w, w, z);
        public bool4 zwww => new bool4(z, w, w, w);
        public bool4 wxxx => new bool4(w, x, x, x);
        public bool4 wxxy => new bool4(w, x, x, y);
        public bool4 wxxz => new bool4(w, x, x, z);
        public bool4 wxxw => new bool4(w, x, x, w);
        public bool4 wxyx => new bool4(w, x, y, x);
        public bool4 wxyy => new bool4(w, x, y, y);
        public bool4 wxyz { get => new bool4(w, x, y, z); set { w = value.x; x = value.y; y = value.z; z = value.w; } }
        public bool4 wxyw => new bool4(w, x, y, w);
        public bool4 wxzx => new bool4(w, x, z, x);
        public bool4 wxzy { get => new bool4(w, x, z, y); set { w = value.x; x = value.y; z = value.z; y = value.w; } }
        public bool4 wxzz => new bool4(w, x, z, z);
        public bool4 wxzw => new bool4(w, x, z, w);
        public bool4 wxwx => new bool4(w, x, w, x);
        public bool4 wxwy => new bool4(w, x, w, y);
        public bool4 wxwz => new bool4(w, x, w, z);
        public bool4 wxww => new bool4(w, x, w, w);
        public bool4 wyxx => new bool4(w, y, x, x);
        public bool4 wyxy => new bool4(w, y, x, y);
        public bool4 wyxz { get => new bool4(w, y, x, z); set { w = value.x; y = value.y; x = value.z; z = value.w; } }
        public bool4 wyxw => new bool4(w, y, x, w);
        public bool4 wyyx => new bool4(w, y, y, x);
        public bool4 wyyy => new bool4(w, y, y, y);
        public bool4 wyyz => new bool4(w, y, y, z);
        public bool4 wyyw => new bool4(w, y, y, w);
        public bool4 wyzx { get => new bool4(w, y, z, x); set { w = value.x; y = value.y; z = value.z; x = value.w; } }
        public bool4 wyzy => new bool4(w, y, z, y);
        public bool4 wyzz => new bool4(w, y, z, z);
        public bool4 wyzw => new bool4(w, y, z, w);
        public bool4 wywx => new bool4(w, y, w, x);
        public bool4 wywy => new bool4(w, y, w, y);
        public bool4 wywz => new bool4(w, y, w, z);
        public bool4 wyww => new bool4(w, y, w, w);
        public bool4 wzxx => new bool4(w, z, x, x);
        public bool4 wzxy { get => new bool4(w, z, x, y); set { w = value.x; z = value.y; x = value.z; y = value.w; } }
        public bool4 wzxz => new bool4(w, z, x, z);
        public bool4 wzxw => new bool4(w, z, x, w);
        public bool4 wzyx { get => new bool4(w, z, y, x); set { w = value.x; z = value.y; y = value.z; x = value.w; } }
        public bool4 wzyy => new bool4(w, z, y, y);
        public bool4 wzyz => new bool4(w, z, y, z);
        public bool4 wzyw => new bool4(w, z, y, w);
        public bool4 wzzx => new bool4(w, z, z, x);
        public bool4 wzzy => new bool4(w, z, z, y);
        public bool4 wzzz => new bool4(w, z, z, z);
        public bool4 wzzw => new bool4(w, z, z, w);
        public bool4 wzwx => new bool4(w, z, w, x);
        public bool4 wzwy => new bool4(w, z, w, y);
        public bool4 wzwz => new bool4(w, z, w, z);
        public bool4 wzww => new bool4(w, z, w, w);
        public bool4 wwxx => new bool4(w, w, x, x);
        public bool4 wwxy => new bool4(w, w, x, y);
        public bool4 wwxz => new bool4(w, w, x, z);
        public bool4 wwxw => new bool4(w, w, x, w);
        public bool4 wwyx => new bool4(w, w, y, x);
        public bool4 wwyy => new bool4(w, w, y, y);
        public bool4 wwyz => new bool4(w, w, y, z);
        public bool4 wwyw => new bool4(w, w, y, w);
        public bool4 wwzx => new bool4(w, w, z, x);
        public bool4 wwzy => new bool4(w, w, z, y);
        public bool4 wwzz => new bool4(w, w, z, z);
        public bool4 wwzw => new bool4(w, w, z, w);
        public bool4 wwwx => new bool4(w, w, w, x);
        public bool4 wwwy => new bool4(w, w, w, y);
        public bool4 wwwz => new bool4(w, w, w, z);
        public bool4 wwww => new bool4(w, w, w, w);

        public bool Equals(bool4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
        public override bool Equals(object o) => o is bool4 v && Equals(v);
        public override int GetHashCode() => (int)math.hash(this);
        public override string ToString() => $"bool4({x}, {y}, {z}, {w})";
    }
}
