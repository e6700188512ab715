using System;
using System.Globalization;

namespace UnityEngine
{
    public struct Rect : IEquatable<Rect>, IFormattable
    {
        float m_XMin;
        float m_YMin;
        float m_Width;
        float m_Height;

        public Rect(float x, float y, float width, float height) { m_XMin = x; m_YMin = y; m_Width = width; m_Height = height; }
        public Rect(Vector2 position, Vector2 size) : this(position.x, position.y, size.x, size.y) { }
        public Rect(Rect source) => this = source;

        public static Rect zero => default;
        public static Rect MinMaxRect(float xmin, float ymin, float xmax, float ymax) => new Rect(xmin, ymin, xmax - xmin, ymax - ymin);

        public float x { get => m_XMin; set => m_XMin = value; }
        public float y { get => m_YMin; set => m_YMin = value; }
        public float width { get => m_Width; set => m_Width = value; }
        public float height { get => m_Height; set => m_Height = value; }
        public float xMin { get => m_XMin; set { m_Width += m_XMin - value; m_XMin = value; } }
        public float yMin { get => m_YMin; set { m_Height += m_YMin - value; m_YMin = value; } }
        public float xMax { get => m_XMin + m_Width; set => m_Width = value - m_XMin; }
        public float yMax { get => m_YMin + m_Height; set => m_Height = value - m_YMin; }
        public Vector2 position { get => new Vector2(m_XMin, m_YMin); set { m_XMin = value.x; m_YMin = value.y; } }
        public Vector2 size { get => new Vector2(m_Width, m_Height); set { m_Width = value.x; m_Height = value.y; } }
        public Vector2 center { get => position + size / 2; set => position = value - size / 2; }
        public Vector2 min { get => position; set { xMin = value.x; yMin = value.y; } }
        public Vector2 max { get => new Vector2(xMax, yMax); set { xMax = value.x; yMax = value.y; } }

        public void Set(float x, float y, float width, float height) => this = new Rect(x, y, width, height);

        public bool Contains(Vector2 point) => point.x >= xMin && point.x < xMax && point.y >= yMin && point.y < yMax;
        public bool Contains(Vector3 point) => Contains((Vector2)point);

        public bool Contains(Vector3 point, bool allowInverse)
        {
            if (!allowInverse)
                return Contains(point);
            return Within(point.x, xMin, xMax) && Within(point.y, yMin, yMax);

            static bool Within(float value, float a, float b) => a <= b ? value >= a && value < b : value <= a && value > b;
        }

        public bool Overlaps(Rect other) => other.xMax > xMin && other.xMin < xMax && other.yMax > yMin && other.yMin < yMax;
        public bool Overlaps(Rect other, bool allowInverse) => allowInverse ? Ordered(this).Overlaps(Ordered(other)) : Overlaps(other);

        static Rect Ordered(Rect r)
            => MinMaxRect(MathF.Min(r.xMin, r.xMax), MathF.Min(r.yMin, r.yMax), MathF.Max(r.xMin, r.xMax), MathF.Max(r.yMin, r.yMax));

        public static Vector2 NormalizedToPoint(Rect rectangle, Vector2 normalizedRectCoordinates)
            => new Vector2(Mathf.Lerp(rectangle.xMin, rectangle.xMax, normalizedRectCoordinates.x),
                Mathf.Lerp(rectangle.yMin, rectangle.yMax, normalizedRectCoordinates.y));

        public static Vector2 PointToNormalized(Rect rectangle, Vector2 point)
            => new Vector2(Mathf.InverseLerp(rectangle.xMin, rectangle.xMax, point.x), Mathf.InverseLerp(rectangle.yMin, rectangle.yMax, point.y));

        public static bool operator ==(Rect lhs, Rect rhs) => lhs.Equals(rhs);
        public static bool operator !=(Rect lhs, Rect rhs) => !lhs.Equals(rhs);
        public bool Equals(Rect other) => x == other.x && y == other.y && width == other.width && height == other.height;
        public override bool Equals(object other) => other is Rect r && Equals(r);
        public override int GetHashCode() => HashCode.Combine(x, y, width, height);
        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F2" : format;
            formatProvider ??= CultureInfo.InvariantCulture;
            return $"(x:{x.ToString(format, formatProvider)}, y:{y.ToString(format, formatProvider)}, " +
                $"width:{width.ToString(format, formatProvider)}, height:{height.ToString(format, formatProvider)})";
        }
    }
}
