using System;

namespace Rill
{
    /// <summary>The CRC-32C checksum (Castagnoli's polynomial, as of iSCSI, RFC 3720): finds every change of up to 32 bits in a row.</summary>
    static class Crc32C
    {
        const uint Polynomial = 0x82F63B78u;        // reflected

        static readonly uint[] Table = MakeTable();

        public static uint Of(ReadOnlySpan<byte> bytes) => Append(0u, bytes);

        /// <summary>The checksum of what <paramref name="crc"/> is of, followed by more.</summary>
        public static uint Append(uint crc, ReadOnlySpan<byte> bytes)
        {
            crc = ~crc;
            foreach (byte value in bytes)
                crc = Table[(byte)crc ^ value] ^ crc >> 8;
            return ~crc;
        }

        static uint[] MakeTable()
        {
            var table = new uint[256];
            for (uint i = 0; i < table.Length; i++)
            {
                uint entry = i;
                for (int bit = 0; bit < 8; bit++)
                    entry = (entry & 1) != 0 ? Polynomial ^ entry >> 1 : entry >> 1;
                table[i] = entry;
            }
            return table;
        }
    }
}
