using System;
using System.Globalization;
using System.Text;

namespace UnityEngine
{
    /// <summary>128 bits, written as 32 hexadecimal digits byte by byte from the lowest.</summary>
    [Serializable]
    public struct Hash128 : IComparable, IComparable<Hash128>, IEquatable<Hash128>
    {
        ulong low, high;

        public Hash128(ulong u64_0, ulong u64_1) { low = u64_0; high = u64_1; }
        public Hash128(uint u32_0, uint u32_1, uint u32_2, uint u32_3) : this(u32_0 | (ulong)u32_1 << 32, u32_2 | (ulong)u32_3 << 32) { }

        public bool isValid => low != 0 || high != 0;

        /// <summary>Text that is not a hash gives the invalid one, as in Unity.</summary>
        public static Hash128 Parse(string hashString)
        {
            var hash = new Hash128();
            if (hashString == null || hashString.Length != 32)
                return hash;
            for (int i = 0; i < 16; i++)
            {
                if (!byte.TryParse(hashString.Substring(2 * i, 2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out byte part))
                    return default;
                if (i < 8) hash.low |= (ulong)part << 8 * i;
                else hash.high |= (ulong)part << 8 * (i - 8);
            }
            return hash;
        }

        public override string ToString()
        {
            var text = new StringBuilder(32);
            for (int i = 0; i < 16; i++)
                text.Append(((byte)((i < 8 ? low : high) >> 8 * (i & 7))).ToString("x2", CultureInfo.InvariantCulture));
            return text.ToString();
        }

        public int CompareTo(Hash128 rhs) => high != rhs.high ? high.CompareTo(rhs.high) : low.CompareTo(rhs.low);
        public int CompareTo(object obj) => obj is Hash128 other ? CompareTo(other) : 1;
        public bool Equals(Hash128 obj) => low == obj.low && high == obj.high;
        public override bool Equals(object obj) => obj is Hash128 other && Equals(other);
        public override int GetHashCode() => HashCode.Combine(low, high);
        public static bool operator ==(Hash128 hash1, Hash128 hash2) => hash1.Equals(hash2);
        public static bool operator !=(Hash128 hash1, Hash128 hash2) => !hash1.Equals(hash2);
        public static bool operator <(Hash128 x, Hash128 y) => x.CompareTo(y) < 0;
        public static bool operator >(Hash128 x, Hash128 y) => x.CompareTo(y) > 0;
    }
}
