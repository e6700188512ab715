using System;
using System.Globalization;

namespace UnityEngine
{
    public struct Bounds : IEquatable<Bounds>, IFormattable
    {
        Vector3 m_Center;
        Vector3 m_Extents;

        public Bounds(Vector3 center, Vector3 size) { m_Center = center; m_Extents = size * 0.5f; }

        public Vector3 center { get => m_Center; set => m_Center = value; }
        public Vector3 extents { get => m_Extents; set => m_Extents = value; }
        public Vector3 size { get => m_Extents * 2; set => m_Extents = value * 0.5f; }
        public Vector3 min { get => m_Center - m_Extents; set => SetMinMax(value, max); }
        public Vector3 max { get => m_Center + m_Extents; set => SetMinMax(min, value); }

        public void SetMinMax(Vector3 min, Vector3 max)
        {
            m_Extents = (max - min) * 0.5f;
            m_Center = min + m_Extents;
        }

        public void Encapsulate(Vector3 point) => SetMinMax(Vector3.Min(min, point), Vector3.Max(max, point));

        public void Encapsulate(Bounds bounds)
        {
            Encapsulate(bounds.min);
            Encapsulate(bounds.max);
        }

        public void Expand(float amount) => Expand(new Vector3(amount, amount, amount));
        public void Expand(Vector3 amount) => m_Extents += amount * 0.5f;

        public bool Contains(Vector3 point)
        {
            Vector3 d = point - m_Center;
            return MathF.Abs(d.x) <= m_Extents.x && MathF.Abs(d.y) <= m_Extents.y && MathF.Abs(d.z) <= m_Extents.z;
        }

        public bool Intersects(Bounds bounds)
        {
            Vector3 d = bounds.m_Center - m_Center, e = bounds.m_Extents + m_Extents;
            return MathF.Abs(d.x) <= e.x && MathF.Abs(d.y) <= e.y && MathF.Abs(d.z) <= e.z;
        }

        public Vector3 ClosestPoint(Vector3 point) => Vector3.Min(max, Vector3.Max(min, point));
        public float SqrDistance(Vector3 point) => (ClosestPoint(point) - point).sqrMagnitude;
        public bool IntersectRay(Ray ray) => IntersectRay(ray, out _);

        /// <summary>Negative distance when the origin lies inside.</summary>
        public bool IntersectRay(Ray ray, out float distance)
        {
            float enter = float.NegativeInfinity, leave = float.PositiveInfinity;
            distance = 0;
            for (int axis = 0; axis < 3; axis++)
            {
                float toCenter = m_Center[axis] - ray.origin[axis], speed = ray.direction[axis], extent = m_Extents[axis];
                if (MathF.Abs(speed) < 1e-12f)
                {
                    if (MathF.Abs(toCenter) > extent)
                        return false;
                    continue;
                }
                float a = (toCenter - extent) / speed, b = (toCenter + extent) / speed;
                enter = MathF.Max(enter, MathF.Min(a, b));
                leave = MathF.Min(leave, MathF.Max(a, b));
            }
            if (enter > leave || leave < 0)
                return false;
            distance = enter;
            return true;
        }

        public static bool operator ==(Bounds lhs, Bounds rhs) => lhs.m_Center == rhs.m_Center && lhs.m_Extents == rhs.m_Extents;
        public static bool operator !=(Bounds lhs, Bounds rhs) => !(lhs == rhs);
        public bool Equals(Bounds other) => m_Center.Equals(other.m_Center) && m_Extents.Equals(other.m_Extents);
        public override bool Equals(object other) => other is Bounds b && Equals(b);
        public override int GetHashCode() => HashCode.Combine(m_Center, m_Extents);
        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
            => $"Center: {m_Center.ToString(format, formatProvider)}, Extents: {m_Extents.ToString(format, formatProvider)}";
    }
}
