using System;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>Rotations of a left-handed frame; angles in degrees; Euler angles turn about z, then x, then y.</summary>
    public struct Quaternion : IEquatable<Quaternion>, IFormattable
    {
        public const float kEpsilon = 1e-6f;

        public float x;
        public float y;
        public float z;
        public float w;

        public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }

        public static Quaternion identity => new Quaternion(0, 0, 0, 1);

        public float this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new IndexOutOfRangeException("Invalid Quaternion index!") };
            set
            {
                switch (index)
                {
                    case 0: x = value; break;
                    case 1: y = value; break;
                    case 2: z = value; break;
                    case 3: w = value; break;
                    default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
                }
            }
        }

        public Quaternion normalized => Normalize(this);
        public Vector3 eulerAngles { get => ToEuler(this); set => this = Euler(value); }

        public void Set(float newX, float newY, float newZ, float newW) { x = newX; y = newY; z = newZ; w = newW; }
        public void Normalize() => this = Normalize(this);
        public void SetLookRotation(Vector3 view) => this = LookRotation(view, Vector3.up);
        public void SetLookRotation(Vector3 view, Vector3 up) => this = LookRotation(view, up);
        public void SetFromToRotation(Vector3 fromDirection, Vector3 toDirection) => this = FromToRotation(fromDirection, toDirection);

        public void ToAngleAxis(out float angle, out Vector3 axis)
        {
            Quaternion q = Normalize(this);
            float sine = MathF.Sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
            angle = 2 * MathF.Atan2(sine, q.w) * Mathf.Rad2Deg;
            axis = sine > 1e-6f ? new Vector3(q.x, q.y, q.z) / sine : Vector3.right;
        }

        public static float Dot(Quaternion a, Quaternion b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

        public static Quaternion Normalize(Quaternion q)
        {
            float length = MathF.Sqrt(Dot(q, q));
            return length < Mathf.Epsilon ? identity : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
        }

        /// <summary>Inverse of a unit quaternion.</summary>
        public static Quaternion Inverse(Quaternion rotation) => new Quaternion(-rotation.x, -rotation.y, -rotation.z, rotation.w);

        public static float Angle(Quaternion a, Quaternion b)
        {
            float dot = Mathf.Min(MathF.Abs(Dot(a, b)), 1);
            return dot > 1 - kEpsilon ? 0 : MathF.Acos(dot) * 2 * Mathf.Rad2Deg;
        }

        public static Quaternion AngleAxis(float angle, Vector3 axis)
        {
            float length = axis.magnitude;
            if (length < 1e-6f)
                return identity;
            float half = angle * Mathf.Deg2Rad * 0.5f;
            Vector3 v = axis / length * MathF.Sin(half);
            return new Quaternion(v.x, v.y, v.z, MathF.Cos(half));
        }

        public static Quaternion Euler(Vector3 euler) => Euler(euler.x, euler.y, euler.z);

        public static Quaternion Euler(float x, float y, float z)
        {
            float hx = x * Mathf.Deg2Rad * 0.5f, hy = y * Mathf.Deg2Rad * 0.5f, hz = z * Mathf.Deg2Rad * 0.5f;
            float sx = MathF.Sin(hx), cx = MathF.Cos(hx), sy = MathF.Sin(hy), cy = MathF.Cos(hy), sz = MathF.Sin(hz), cz = MathF.Cos(hz);
            return new Quaternion(
                cy * sx * cz + sy * cx * sz,
                sy * cx * cz - cy * sx * sz,
                cy * cx * sz - sy * sx * cz,
                cy * cx * cz + sy * sx * sz);
        }

        // Reads the angles off the rotation matrix Y X Z: its second row's last element is -sin x.
        static Vector3 ToEuler(Quaternion rotation)
        {
            Quaternion q = Normalize(rotation);
            float sinX = 2 * (q.w * q.x - q.y * q.z);
            Vector3 radians;
            if (MathF.Abs(sinX) > 0.999999f)
            {
                // Looking straight up or down: y and z turn about the same axis, all of it goes to y.
                radians = new Vector3(Mathf.Sign(sinX) * Mathf.PI / 2, MathF.Atan2(2 * (q.w * q.y - q.x * q.z), 1 - 2 * (q.y * q.y + q.z * q.z)), 0);
            }
            else
            {
                radians = new Vector3(
                    MathF.Asin(sinX),
                    MathF.Atan2(2 * (q.w * q.y + q.x * q.z), 1 - 2 * (q.x * q.x + q.y * q.y)),
                    MathF.Atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.x * q.x + q.z * q.z)));
            }
            return new Vector3(Positive(radians.x), Positive(radians.y), Positive(radians.z));
        }

        // [0, 360); an angle that is zero but for rounding stays zero instead of becoming 359.9999.
        static float Positive(float radians)
        {
            float degrees = radians * Mathf.Rad2Deg;
            return degrees < -0.005729578f ? degrees + 360 : degrees < 0 ? 0 : degrees;
        }

        public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

        public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
        {
            if (forward.magnitude < Vector3.kEpsilon)
            {
                Debug.Log("Look rotation viewing vector is zero");
                return identity;
            }
            Vector3 z = forward.normalized;
            Vector3 x = Vector3.Cross(upwards, z);
            if (x.magnitude < Vector3.kEpsilon)
                return FromToRotation(Vector3.forward, z);
            x = x.normalized;
            return FromBasis(x, Vector3.Cross(z, x), z);
        }

        /// <summary>From an orthonormal basis: the images of the x, y and z axes.</summary>
        internal static Quaternion FromBasis(Vector3 x, Vector3 y, Vector3 z)
        {
            float trace = x.x + y.y + z.z;
            if (trace > 0)
            {
                float s = MathF.Sqrt(trace + 1) * 2;
                return new Quaternion((y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s, s / 4);
            }
            if (x.x >= y.y && x.x >= z.z)
            {
                float s = MathF.Sqrt(1 + x.x - y.y - z.z) * 2;
                return new Quaternion(s / 4, (x.y + y.x) / s, (x.z + z.x) / s, (y.z - z.y) / s);
            }
            if (y.y >= z.z)
            {
                float s = MathF.Sqrt(1 + y.y - x.x - z.z) * 2;
                return new Quaternion((x.y + y.x) / s, s / 4, (y.z + z.y) / s, (z.x - x.z) / s);
            }
            else
            {
                float s = MathF.Sqrt(1 + z.z - x.x - y.y) * 2;
                return new Quaternion((x.z + z.x) / s, (y.z + z.y) / s, s / 4, (x.y - y.x) / s);
            }
        }

        public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection)
        {
            Vector3 from = fromDirection.normalized, to = toDirection.normalized;
            if (from == Vector3.zero || to == Vector3.zero)
                return identity;
            float cosine = Vector3.Dot(from, to);
            if (cosine < -0.999999f)
            {
                Vector3 axis = Vector3.AnyPerpendicular(from);
                return new Quaternion(axis.x, axis.y, axis.z, 0);
            }
            Vector3 cross = Vector3.Cross(from, to);
            return Normalize(new Quaternion(cross.x, cross.y, cross.z, 1 + cosine));
        }

        public static Quaternion Lerp(Quaternion a, Quaternion b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Quaternion LerpUnclamped(Quaternion a, Quaternion b, float t)
        {
            float sign = Dot(a, b) < 0 ? -1 : 1;
            float s = 1 - t, u = t * sign;
            return Normalize(new Quaternion(s * a.x + u * b.x, s * a.y + u * b.y, s * a.z + u * b.z, s * a.w + u * b.w));
        }

        public static Quaternion Slerp(Quaternion a, Quaternion b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Quaternion SlerpUnclamped(Quaternion a, Quaternion b, float t)
        {
            float dot = Dot(a, b), sign = 1;
            if (dot < 0)
            {
                dot = -dot;
                sign = -1;
            }
            if (dot > 0.9995f)
                return LerpUnclamped(a, b, t);
            float angle = MathF.Acos(dot), sine = MathF.Sin(angle);
            float s = MathF.Sin((1 - t) * angle) / sine, u = MathF.Sin(t * angle) / sine * sign;
            return new Quaternion(s * a.x + u * b.x, s * a.y + u * b.y, s * a.z + u * b.z, s * a.w + u * b.w);
        }

        public static Quaternion RotateTowards(Quaternion from, Quaternion to, float maxDegreesDelta)
        {
            float angle = Angle(from, to);
            return angle == 0 ? to : SlerpUnclamped(from, to, Mathf.Min(1, maxDegreesDelta / angle));
        }

        /// <summary>Applies <paramref name="rhs"/> first.</summary>
        public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new Quaternion(
            lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
            lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
            lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
            lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);

        public static Vector3 operator *(Quaternion rotation, Vector3 point)
        {
            Vector3 v = new Vector3(rotation.x, rotation.y, rotation.z);
            Vector3 t = 2 * Vector3.Cross(v, point);
            return point + rotation.w * t + Vector3.Cross(v, t);
        }

        public static bool operator ==(Quaternion lhs, Quaternion rhs) => Dot(lhs, rhs) > 1 - kEpsilon;
        public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

        public bool Equals(Quaternion other) => x == other.x && y == other.y && z == other.z && w == other.w;
        public override bool Equals(object other) => other is Quaternion q && Equals(q);
        public override int GetHashCode() => HashCode.Combine(x, y, z, w);
        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F5" : format;
            formatProvider ??= CultureInfo.InvariantCulture;
            return $"({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, " +
                $"{z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";
        }
    }
}
