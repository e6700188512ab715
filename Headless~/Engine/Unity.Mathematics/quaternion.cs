using System;
using System.Globalization;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Unity.Mathematics
{
    /// <summary>Angles in radians. EulerXYZ turns about x first, then y, then z.</summary>
    [Serializable]
    public struct quaternion : IEquatable<quaternion>, IFormattable
    {
        public float4 value;

        public static readonly quaternion identity = new quaternion(0, 0, 0, 1);

        public quaternion(float x, float y, float z, float w) { value = new float4(x, y, z, w); }
        public quaternion(float4 value) { this.value = value; }
        public quaternion(float4x4 m) : this(new float3x3(m)) { }

        public quaternion(float3x3 m)
        {
            Quaternion q = new Matrix4x4(new float4(m.c0, 0), new float4(m.c1, 0), new float4(m.c2, 0), new float4(0, 0, 0, 1)).rotation;
            value = new float4(q.x, q.y, q.z, q.w);
        }

        public static implicit operator quaternion(float4 v) => new quaternion(v);
        public static implicit operator Quaternion(quaternion q) => new Quaternion(q.value.x, q.value.y, q.value.z, q.value.w);
        public static implicit operator quaternion(Quaternion q) => new quaternion(q.x, q.y, q.z, q.w);

        public static quaternion AxisAngle(float3 axis, float angle)
        {
            sincos(0.5f * angle, out float s, out float c);
            return new quaternion(new float4(axis * s, c));
        }

        public static quaternion RotateX(float angle) => AxisAngle(new float3(1, 0, 0), angle);
        public static quaternion RotateY(float angle) => AxisAngle(new float3(0, 1, 0), angle);
        public static quaternion RotateZ(float angle) => AxisAngle(new float3(0, 0, 1), angle);

        public static quaternion EulerXYZ(float3 xyz) => mul(RotateZ(xyz.z), mul(RotateY(xyz.y), RotateX(xyz.x)));
        public static quaternion EulerXZY(float3 xyz) => mul(RotateY(xyz.y), mul(RotateZ(xyz.z), RotateX(xyz.x)));
        public static quaternion EulerYXZ(float3 xyz) => mul(RotateZ(xyz.z), mul(RotateX(xyz.x), RotateY(xyz.y)));
        public static quaternion EulerYZX(float3 xyz) => mul(RotateX(xyz.x), mul(RotateZ(xyz.z), RotateY(xyz.y)));
        public static quaternion EulerZXY(float3 xyz) => mul(RotateY(xyz.y), mul(RotateX(xyz.x), RotateZ(xyz.z)));
        public static quaternion EulerZYX(float3 xyz) => mul(RotateX(xyz.x), mul(RotateY(xyz.y), RotateZ(xyz.z)));
        public static quaternion EulerXYZ(float x, float y, float z) => EulerXYZ(new float3(x, y, z));
        public static quaternion EulerXZY(float x, float y, float z) => EulerXZY(new float3(x, y, z));
        public static quaternion EulerYXZ(float x, float y, float z) => EulerYXZ(new float3(x, y, z));
        public static quaternion EulerYZX(float x, float y, float z) => EulerYZX(new float3(x, y, z));
        public static quaternion EulerZXY(float x, float y, float z) => EulerZXY(new float3(x, y, z));
        public static quaternion EulerZYX(float x, float y, float z) => EulerZYX(new float3(x, y, z));

        public static quaternion Euler(float3 xyz, RotationOrder order = RotationOrder.ZXY) => order switch
        {
            RotationOrder.XYZ => EulerXYZ(xyz),
            RotationOrder.XZY => EulerXZY(xyz),
            RotationOrder.YXZ => EulerYXZ(xyz),
            RotationOrder.YZX => EulerYZX(xyz),
            RotationOrder.ZYX => EulerZYX(xyz),
            _ => EulerZXY(xyz),
        };

        public static quaternion Euler(float x, float y, float z, RotationOrder order = RotationOrder.Default) => Euler(new float3(x, y, z), order);

        public static quaternion LookRotation(float3 forward, float3 up)
        {
            float3 x = normalize(cross(up, forward));
            return new quaternion(new float3x3(x, cross(forward, x), forward));
        }

        /// <summary>The identity where the directions leave none.</summary>
        public static quaternion LookRotationSafe(float3 forward, float3 up)
        {
            float3 z = normalizesafe(forward), x = normalizesafe(cross(normalizesafe(up), z));
            return lengthsq(x) > 0 && all(isfinite(x)) && all(isfinite(z)) ? new quaternion(new float3x3(x, cross(z, x), z)) : identity;
        }

        public bool Equals(quaternion x) => value.Equals(x.value);
        public override bool Equals(object x) => x is quaternion q && Equals(q);
        public override int GetHashCode() => (int)hash(this);
        public override string ToString() => ToString(null, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"quaternion({value.x.ToString(format, formatProvider)}f, {value.y.ToString(format, formatProvider)}f, " +
                $"{value.z.ToString(format, formatProvider)}f, {value.w.ToString(format, formatProvider)}f)";
    }
}
