using System;
using System.Buffers.Binary;

namespace Rill
{
    /// <summary>The CRC-32C checksum (Castagnoli's polynomial, as of iSCSI, RFC 3720): finds every change of up to 32 bits in a row.</summary>
    /// <remarks>Eight bytes at a time by eight tables, as Kounavis and Berry, "Novel Table Lookup-Based Algorithms for High-Performance CRC
    /// Generation", 2008.</remarks>
    static class Crc32C
    {
        const uint Polynomial = 0x82F63B78u;        // reflected
        const int Slice = 8, Bytes = 256;

        static readonly uint[] Tables = MakeTables();       // the one of byte k of a slice from k * Bytes on, the last byte first

        public static uint Of(ReadOnlySpan<byte> bytes) => Append(0u, bytes);

        /// <summary>The checksum of what <paramref name="crc"/> is of, followed by more.</summary>
        public static uint Append(uint crc, ReadOnlySpan<byte> bytes)
        {
            uint[] tables = Tables;
            crc = ~crc;
            for (; bytes.Length >= Slice; bytes = bytes.Slice(Slice))
            {
                ulong eight = BinaryPrimitives.ReadUInt64LittleEndian(bytes) ^ crc;
                crc = tables[7 * Bytes + (byte)eight] ^ tables[6 * Bytes + (byte)(eight >> 8)] ^ tables[5 * Bytes
                    + (byte)(eight >> 16)] ^ tables[4 * Bytes + (byte)(eight >> 24)]
                    ^ tables[3 * Bytes + (byte)(eight >> 32)] ^ tables[2 * Bytes + (byte)(eight >> 40)] ^ tables[Bytes
                        + (byte)(eight >> 48)] ^ tables[(byte)(eight >> 56)];
            }
            foreach (byte value in bytes)
                crc = tables[(byte)crc ^ value] ^ crc >> 8;
            return ~crc;
        }

        static uint[] MakeTables()
        {
            var tables = new uint[Slice * Bytes];
            for (uint i = 0; i < Bytes; i++)
            {
                uint entry = i;
                for (int bit = 0; bit < 8; bit++)
                    entry = (entry & 1) != 0 ? Polynomial ^ entry >> 1 : entry >> 1;
                tables[i] = entry;
            }
            for (int i = Bytes; i < tables.Length; i++)
                tables[i] = tables[(byte)tables[i - Bytes]] ^ tables[i - Bytes] >> 8;
            return tables;
        }
    }
}
