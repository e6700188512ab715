using System;

namespace UnityEngine
{
    [Serializable]
    public struct BoundsInt : IEquatable<BoundsInt>, IFormattable
    {
        public Vector3Int position { get; set; }
        public Vector3Int size { get; set; }

        public BoundsInt(Vector3Int position, Vector3Int size)
        {
            this.position = position;
            this.size = size;
        }

        public BoundsInt(int xMin, int yMin, int zMin, int sizeX, int sizeY, int sizeZ)
            : this(new Vector3Int(xMin, yMin, zMin), new Vector3Int(sizeX, sizeY, sizeZ)) { }

        public int x { get => position.x; set => position = new Vector3Int(value, y, z); }
        public int y { get => position.y; set => position = new Vector3Int(x, value, z); }
        public int z { get => position.z; set => position = new Vector3Int(x, y, value); }
        public Vector3 center => new Vector3(x + size.x / 2f, y + size.y / 2f, z + size.z / 2f);

        // A negative size points the other way; setting one end leaves the other where it is.
        public Vector3Int min
        {
            get => new Vector3Int(Math.Min(x, x + size.x), Math.Min(y, y + size.y), Math.Min(z, z + size.z));
            set { Vector3Int old = max; position = value; size = old - value; }
        }

        public Vector3Int max
        {
            get => new Vector3Int(Math.Max(x, x + size.x), Math.Max(y, y + size.y), Math.Max(z, z + size.z));
            set => size = value - position;
        }

        public int xMin { get => min.x; set { int old = xMax; x = value; size = new Vector3Int(old - x, size.y, size.z); } }
        public int yMin { get => min.y; set { int old = yMax; y = value; size = new Vector3Int(size.x, old - y, size.z); } }
        public int zMin { get => min.z; set { int old = zMax; z = value; size = new Vector3Int(size.x, size.y, old - z); } }
        public int xMax { get => max.x; set => size = new Vector3Int(value - x, size.y, size.z); }
        public int yMax { get => max.y; set => size = new Vector3Int(size.x, value - y, size.z); }
        public int zMax { get => max.z; set => size = new Vector3Int(size.x, size.y, value - z); }

        public void SetMinMax(Vector3Int minPosition, Vector3Int maxPosition)
        {
            min = minPosition;
            max = maxPosition;
        }

        public void ClampToBounds(BoundsInt bounds)
        {
            position = Vector3Int.Max(Vector3Int.Min(bounds.max, position), bounds.min);
            size = Vector3Int.Min(bounds.max - position, size);
        }

        public bool Contains(Vector3Int position)
            => position.x >= xMin && position.y >= yMin && position.z >= zMin && position.x < xMax && position.y < yMax && position.z < zMax;

        public bool Equals(BoundsInt other) => position == other.position && size == other.size;
        public override bool Equals(object other) => other is BoundsInt bounds && Equals(bounds);
        public override int GetHashCode() => HashCode.Combine(position, size);
        public static bool operator ==(BoundsInt lhs, BoundsInt rhs) => lhs.Equals(rhs);
        public static bool operator !=(BoundsInt lhs, BoundsInt rhs) => !lhs.Equals(rhs);

        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);
        public string ToString(string format, IFormatProvider formatProvider)
            => $"Position: {position.ToString(format, formatProvider)}, Size: {size.ToString(format, formatProvider)}";
    }
}
