using System;
using System.Globalization;

namespace UnityEngine
{
    [Serializable]
    public struct RectInt : IEquatable<RectInt>, IFormattable
    {
        public int x { get; set; }
        public int y { get; set; }
        public int width { get; set; }
        public int height { get; set; }

        public RectInt(int xMin, int yMin, int width, int height)
        {
            x = xMin;
            y = yMin;
            this.width = width;
            this.height = height;
        }

        public RectInt(Vector2Int position, Vector2Int size) : this(position.x, position.y, size.x, size.y) { }

        public Vector2 center => new Vector2(x + width / 2f, y + height / 2f);
        public Vector2Int position { get => new Vector2Int(x, y); set { x = value.x; y = value.y; } }
        public Vector2Int size { get => new Vector2Int(width, height); set { width = value.x; height = value.y; } }
        public Vector2Int min { get => new Vector2Int(xMin, yMin); set { xMin = value.x; yMin = value.y; } }
        public Vector2Int max { get => new Vector2Int(xMax, yMax); set { xMax = value.x; yMax = value.y; } }

        // A negative width or height extends towards lower x or y; setting one end leaves the other where it is.
        public int xMin { get => Math.Min(x, x + width); set { int old = xMax; x = value; width = old - x; } }
        public int yMin { get => Math.Min(y, y + height); set { int old = yMax; y = value; height = old - y; } }
        public int xMax { get => Math.Max(x, x + width); set => width = value - x; }
        public int yMax { get => Math.Max(y, y + height); set => height = value - y; }

        public void SetMinMax(Vector2Int minPosition, Vector2Int maxPosition)
        {
            min = minPosition;
            max = maxPosition;
        }

        public void ClampToBounds(RectInt bounds)
        {
            position = new Vector2Int(Math.Max(Math.Min(bounds.xMax, x), bounds.xMin), Math.Max(Math.Min(bounds.yMax, y), bounds.yMin));
            size = new Vector2Int(Math.Min(bounds.xMax - x, width), Math.Min(bounds.yMax - y, height));
        }

        public bool Contains(Vector2Int position) => position.x >= xMin && position.y >= yMin && position.x < xMax && position.y < yMax;
        public bool Overlaps(RectInt other) => other.xMin < xMax && other.xMax > xMin && other.yMin < yMax && other.yMax > yMin;
        public bool Equals(RectInt other) => x == other.x && y == other.y && width == other.width && height == other.height;
        public override bool Equals(object other) => other is RectInt rect && Equals(rect);
        public override int GetHashCode() => HashCode.Combine(x, y, width, height);

        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);
        public string ToString(string format, IFormatProvider formatProvider)
        {
            formatProvider ??= CultureInfo.InvariantCulture;
            return $"(x:{x.ToString(format, formatProvider)}, y:{y.ToString(format, formatProvider)}, " +
                $"width:{width.ToString(format, formatProvider)}, height:{height.ToString(format, formatProvider)})";
        }
    }
}
