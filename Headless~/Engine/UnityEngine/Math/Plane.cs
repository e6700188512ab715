using System;

namespace UnityEngine
{
    /// <summary>Points p with Dot(normal, p) + distance = 0.</summary>
    public struct Plane : IFormattable
    {
        Vector3 m_Normal;
        float m_Distance;

        public Plane(Vector3 inNormal, Vector3 inPoint)
        {
            m_Normal = inNormal.normalized;
            m_Distance = -Vector3.Dot(m_Normal, inPoint);
        }

        public Plane(Vector3 inNormal, float d)
        {
            // The distance is scaled with the normal, so that (n, d) stays the same plane.
            float length = inNormal.magnitude;
            m_Normal = inNormal.normalized;
            m_Distance = length > Vector3.kEpsilon ? d / length : d;
        }

        public Plane(Vector3 a, Vector3 b, Vector3 c) : this(Vector3.Cross(b - a, c - a), a) { }

        public Vector3 normal { get => m_Normal; set => m_Normal = value; }
        public float distance { get => m_Distance; set => m_Distance = value; }
        public Plane flipped { get { Plane p = this; p.Flip(); return p; } }

        public void Set3Points(Vector3 a, Vector3 b, Vector3 c) => this = new Plane(a, b, c);
        public void SetNormalAndPosition(Vector3 inNormal, Vector3 inPoint) => this = new Plane(inNormal, inPoint);
        public void Flip() { m_Normal = -m_Normal; m_Distance = -m_Distance; }
        public void Translate(Vector3 translation) => m_Distance += Vector3.Dot(m_Normal, translation);

        public static Plane Translate(Plane plane, Vector3 translation)
        {
            plane.Translate(translation);
            return plane;
        }

        public float GetDistanceToPoint(Vector3 point) => Vector3.Dot(m_Normal, point) + m_Distance;
        public bool GetSide(Vector3 point) => GetDistanceToPoint(point) > 0;
        public bool SameSide(Vector3 inPt0, Vector3 inPt1) => GetSide(inPt0) == GetSide(inPt1);
        public Vector3 ClosestPointOnPlane(Vector3 point) => point - m_Normal * GetDistanceToPoint(point);

        public bool Raycast(Ray ray, out float enter)
        {
            float speed = Vector3.Dot(ray.direction, m_Normal);
            if (Mathf.Approximately(speed, 0))
            {
                enter = 0;
                return false;
            }
            enter = -GetDistanceToPoint(ray.origin) / speed;
            return enter > 0;
        }

        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F2" : format;
            formatProvider ??= System.Globalization.CultureInfo.InvariantCulture;
            return $"(normal:{m_Normal.ToString(format, formatProvider)}, distance:{m_Distance.ToString(format, formatProvider)})";
        }
    }
}
