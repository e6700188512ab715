using System;
using System.Buffers.Binary;

namespace Rill
{
    /// <summary>The CRC-32C checksum (Castagnoli's polynomial, as of iSCSI, RFC 3720): finds every change of up to 32 bits in a
    /// row.</summary>
    /// <remarks>Sixteen bytes at a time by sixteen tables, after Kounavis and Berry, "Novel Table Lookup-Based Algorithms for
    /// High-Performance CRC Generation", 2008. .NET Standard 2.1 does not reach the instructions that processors have for it.</remarks>
    static class Crc32C
    {
        const uint Polynomial = 0x82F63B78u;                // reflected: the highest bit stands for x^0
        const uint One = 1u << 31, ByteShift = 1u << 23;    // x^0 and x^8
        const int Slice = 16, Bytes = 256;

        static readonly uint[] Tables = MakeTables();       // the one of byte k of a slice from k * Bytes on, the last byte first

        public static uint Of(ReadOnlySpan<byte> bytes) => Append(0u, bytes);

        /// <summary>The checksum of what <paramref name="crc"/> is of, followed by more.</summary>
        public static uint Append(uint crc, ReadOnlySpan<byte> bytes)
        {
            uint[] tables = Tables;
            crc = ~crc;
            for (; bytes.Length >= Slice; bytes = bytes.Slice(Slice))
            {
                ulong first = BinaryPrimitives.ReadUInt64LittleEndian(bytes) ^ crc;
                ulong last = BinaryPrimitives.ReadUInt64LittleEndian(bytes.Slice(Slice / 2));
                // The last eight do not wait for the checksum so far.
                uint ofLast = tables[7 * Bytes + (byte)last] ^ tables[6 * Bytes + (byte)(last >> 8)]
                    ^ tables[5 * Bytes + (byte)(last >> 16)] ^ tables[4 * Bytes + (byte)(last >> 24)]
                    ^ tables[3 * Bytes + (byte)(last >> 32)] ^ tables[2 * Bytes + (byte)(last >> 40)]
                    ^ tables[Bytes + (byte)(last >> 48)] ^ tables[(byte)(last >> 56)];
                crc = ofLast ^ tables[15 * Bytes + (byte)first] ^ tables[14 * Bytes + (byte)(first >> 8)]
                    ^ tables[13 * Bytes + (byte)(first >> 16)] ^ tables[12 * Bytes + (byte)(first >> 24)]
                    ^ tables[11 * Bytes + (byte)(first >> 32)] ^ tables[10 * Bytes + (byte)(first >> 40)]
                    ^ tables[9 * Bytes + (byte)(first >> 48)] ^ tables[8 * Bytes + (byte)(first >> 56)];
            }
            foreach (byte value in bytes)
                crc = tables[(byte)crc ^ value] ^ crc >> 8;
            return ~crc;
        }

        /// <summary>The checksum of two pieces, one after the other, by those of each.</summary>
        /// <param name="shift"><see cref="Shift"/> of the second piece's length.</param>
        public static uint Combine(uint first, uint second, uint shift) => Multiply(first, shift) ^ second;

        /// <summary>x^(8 n) modulo the polynomial: what moves a checksum by n bytes.</summary>
        /// <param name="length">n, 0 or more.</param>
        /// <remarks>As M. Adler joins checksums in zlib (crc32_combine, 1.2.12): by repeated squaring.</remarks>
        public static uint Shift(long length)
        {
            uint product = One;
            for (uint square = ByteShift; length > 0; length >>= 1)
            {
                if ((length & 1) != 0)
                    product = Multiply(product, square);
                square = Multiply(square, square);
            }
            return product;
        }

        // Multiplies two polynomials, modulo the polynomial.
        static uint Multiply(uint a, uint b)
        {
            uint product = 0u;
            for (; a != 0; a <<= 1)
            {
                if ((a & One) != 0)
                    product ^= b;
                b = (b & 1) != 0 ? Polynomial ^ b >> 1 : b >> 1;
            }
            return product;
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
