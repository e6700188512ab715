using System;
using System.Globalization;

namespace UnityEngine
{
    public struct Vector3 : IEquatable<Vector3>, IFormattable
    {
        public const float kEpsilon = 1e-5f;
        public const float kEpsilonNormalSqrt = 1e-15f;

        public float x;
        public float y;
        public float z;

        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public Vector3(float x, float y) : this(x, y, 0) { }

        public static Vector3 zero => default;
        public static Vector3 one => new Vector3(1, 1, 1);
        public static Vector3 forward => new Vector3(0, 0, 1);
        public static Vector3 back => new Vector3(0, 0, -1);
        public static Vector3 up => new Vector3(0, 1, 0);
        public static Vector3 down => new Vector3(0, -1, 0);
        public static Vector3 left => new Vector3(-1, 0, 0);
        public static Vector3 right => new Vector3(1, 0, 0);
        public static Vector3 positiveInfinity => new Vector3(float.PositiveInfinity, float.PositiveInfinity, float.PositiveInfinity);
        public static Vector3 negativeInfinity => new Vector3(float.NegativeInfinity, float.NegativeInfinity, float.NegativeInfinity);

        public float this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new IndexOutOfRangeException("Invalid Vector3 index!") };
            set
            {
                switch (index)
                {
                    case 0: x = value; break;
                    case 1: y = value; break;
                    case 2: z = value; break;
                    default: throw new IndexOutOfRangeException("Invalid Vector3 index!");
                }
            }
        }

        public float magnitude => MathF.Sqrt(x * x + y * y + z * z);
        public float sqrMagnitude => x * x + y * y + z * z;
        public Vector3 normalized => Normalize(this);

        public void Set(float newX, float newY, float newZ) { x = newX; y = newY; z = newZ; }
        public void Scale(Vector3 scale) { x *= scale.x; y *= scale.y; z *= scale.z; }
        public void Normalize() => this = Normalize(this);

        public static Vector3 Normalize(Vector3 value)
        {
            float length = value.magnitude;
            return length > kEpsilon ? value / length : zero;
        }

        public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;
        public static Vector3 Cross(Vector3 lhs, Vector3 rhs)
            => new Vector3(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);
        public static float Magnitude(Vector3 vector) => vector.magnitude;
        public static float SqrMagnitude(Vector3 vector) => vector.sqrMagnitude;
        public static float Distance(Vector3 a, Vector3 b) => (a - b).magnitude;
        public static Vector3 Scale(Vector3 a, Vector3 b) => new Vector3(a.x * b.x, a.y * b.y, a.z * b.z);
        public static Vector3 Min(Vector3 lhs, Vector3 rhs) => new Vector3(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y), Mathf.Min(lhs.z, rhs.z));
        public static Vector3 Max(Vector3 lhs, Vector3 rhs) => new Vector3(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y), Mathf.Max(lhs.z, rhs.z));
        public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));
        public static Vector3 LerpUnclamped(Vector3 a, Vector3 b, float t)
            => new Vector3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t);
        public static Vector3 Reflect(Vector3 inDirection, Vector3 inNormal) => inDirection - 2 * Dot(inNormal, inDirection) * inNormal;

        public static Vector3 ClampMagnitude(Vector3 vector, float maxLength)
            => vector.sqrMagnitude > maxLength * maxLength ? vector / vector.magnitude * maxLength : vector;

        public static Vector3 Project(Vector3 vector, Vector3 onNormal)
        {
            float square = onNormal.sqrMagnitude;
            return square < Mathf.Epsilon ? zero : onNormal * (Dot(vector, onNormal) / square);
        }

        public static Vector3 ProjectOnPlane(Vector3 vector, Vector3 planeNormal) => vector - Project(vector, planeNormal);

        public static Vector3 MoveTowards(Vector3 current, Vector3 target, float maxDistanceDelta)
        {
            Vector3 offset = target - current;
            float distance = offset.magnitude;
            if (distance == 0 || (maxDistanceDelta >= 0 && distance <= maxDistanceDelta))
                return target;
            return current + offset / distance * maxDistanceDelta;
        }

        /// <summary>Unsigned, degrees.</summary>
        public static float Angle(Vector3 from, Vector3 to)
        {
            float lengths = MathF.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
            return lengths < kEpsilonNormalSqrt ? 0 : MathF.Acos(Mathf.Clamp(Dot(from, to) / lengths, -1, 1)) * Mathf.Rad2Deg;
        }

        public static float SignedAngle(Vector3 from, Vector3 to, Vector3 axis) => Angle(from, to) * Mathf.Sign(Dot(axis, Cross(from, to)));

        public static Vector3 Slerp(Vector3 a, Vector3 b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Vector3 SlerpUnclamped(Vector3 a, Vector3 b, float t)
        {
            float lengthA = a.magnitude, lengthB = b.magnitude;
            if (lengthA < kEpsilon || lengthB < kEpsilon)
                return LerpUnclamped(a, b, t);
            Vector3 from = a / lengthA, to = b / lengthB;
            float cosine = Mathf.Clamp(Dot(from, to), -1, 1);
            if (cosine > 0.99999f)
                return LerpUnclamped(a, b, t);
            // Opposite vectors turn about any axis across them.
            Vector3 axis = cosine < -0.99999f ? AnyPerpendicular(from) : Cross(from, to).normalized;
            float angle = MathF.Acos(cosine) * t;
            Vector3 direction = from * MathF.Cos(angle) + Cross(axis, from) * MathF.Sin(angle);
            return direction * (lengthA + (lengthB - lengthA) * t);
        }

        public static Vector3 RotateTowards(Vector3 current, Vector3 target, float maxRadiansDelta, float maxMagnitudeDelta)
        {
            float lengthCurrent = current.magnitude, lengthTarget = target.magnitude;
            if (lengthCurrent < kEpsilon || lengthTarget < kEpsilon)
                return MoveTowards(current, target, maxMagnitudeDelta);
            float angle = MathF.Acos(Mathf.Clamp(Dot(current, target) / (lengthCurrent * lengthTarget), -1, 1));
            float turn = angle == 0 ? 1 : Mathf.Clamp(maxRadiansDelta / angle, angle == 0 ? 0 : (angle - Mathf.PI) / angle, 1);
            Vector3 direction = SlerpUnclamped(current / lengthCurrent, target / lengthTarget, turn).normalized;
            return direction * Mathf.MoveTowards(lengthCurrent, lengthTarget, maxMagnitudeDelta);
        }

        public static void OrthoNormalize(ref Vector3 normal, ref Vector3 tangent)
        {
            normal = normal.magnitude > kEpsilon ? normal.normalized : right;
            tangent -= normal * Dot(normal, tangent);
            tangent = tangent.magnitude > kEpsilon ? tangent.normalized : AnyPerpendicular(normal);
        }

        public static void OrthoNormalize(ref Vector3 normal, ref Vector3 tangent, ref Vector3 binormal)
        {
            OrthoNormalize(ref normal, ref tangent);
            binormal -= normal * Dot(normal, binormal);
            binormal -= tangent * Dot(tangent, binormal);
            binormal = binormal.magnitude > kEpsilon ? binormal.normalized : Cross(normal, tangent);
        }

        public static Vector3 SmoothDamp(Vector3 current, Vector3 target, ref Vector3 currentVelocity, float smoothTime)
            => SmoothDamp(current, target, ref currentVelocity, smoothTime, Mathf.Infinity, Time.deltaTime);

        public static Vector3 SmoothDamp(Vector3 current, Vector3 target, ref Vector3 currentVelocity, float smoothTime, float maxSpeed)
            => SmoothDamp(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

        /// <summary>A critically damped spring (see Mathf.SmoothDamp), with the speed limit on the whole vector.</summary>
        public static Vector3 SmoothDamp(Vector3 current, Vector3 target, ref Vector3 currentVelocity, float smoothTime, float maxSpeed,
            float deltaTime)
        {
            smoothTime = Mathf.Max(0.0001f, smoothTime);
            float omega = 2 / smoothTime;
            float decay = Mathf.SpringDecay(omega * deltaTime);
            Vector3 change = ClampMagnitude(current - target, maxSpeed * smoothTime);
            Vector3 goal = current - change;
            Vector3 pull = (currentVelocity + omega * change) * deltaTime;
            currentVelocity = (currentVelocity - omega * pull) * decay;
            Vector3 next = goal + (change + pull) * decay;
            if (Dot(target - current, next - target) > 0)
            {
                next = target;
                currentVelocity = deltaTime > 0 ? (next - target) / deltaTime : zero;
            }
            return next;
        }

        internal static Vector3 AnyPerpendicular(Vector3 unit)
            => Cross(unit, MathF.Abs(unit.x) < 0.7f ? right : up).normalized;

        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Vector3 operator -(Vector3 a) => new Vector3(-a.x, -a.y, -a.z);
        public static Vector3 operator *(Vector3 a, float d) => new Vector3(a.x * d, a.y * d, a.z * d);
        public static Vector3 operator *(float d, Vector3 a) => a * d;
        public static Vector3 operator /(Vector3 a, float d) => new Vector3(a.x / d, a.y / d, a.z / d);
        public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
        public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);

        public bool Equals(Vector3 other) => x == other.x && y == other.y && z == other.z;
        public override bool Equals(object other) => other is Vector3 v && Equals(v);
        public override int GetHashCode() => HashCode.Combine(x, y, z);
        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F2" : format;
            formatProvider ??= CultureInfo.InvariantCulture;
            return $"({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
        }
    }
}
