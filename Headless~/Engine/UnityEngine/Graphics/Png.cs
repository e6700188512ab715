using System;
using System.IO;
using System.IO.Compression;

namespace UnityEngine.Headless
{
    /// <summary>Writes 8-bit RGBA as PNG (RFC 2083): one IHDR, one IDAT in zlib's format, IEND.</summary>
    internal static class Png
    {
        static readonly byte[] signature = { 0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10 };
        static readonly uint[] crcTable = CrcTable();

        /// <param name="rgba">Top row first.</param>
        public static byte[] Encode(byte[] rgba, int width, int height)
        {
            using var file = new MemoryStream();
            file.Write(signature, 0, signature.Length);

            var header = new byte[13];
            BigEndian(header, 0, (uint)width);
            BigEndian(header, 4, (uint)height);
            header[8] = 8;      // bits a channel
            header[9] = 6;      // red, green, blue, alpha
            Chunk(file, "IHDR", header);
            Chunk(file, "IDAT", Zlib(Filtered(rgba, width, height)));
            Chunk(file, "IEND", Array.Empty<byte>());
            return file.ToArray();
        }

        // Each row as differences to the row above (filter 2): cheap, and flat backgrounds become zeros.
        static byte[] Filtered(byte[] rgba, int width, int height)
        {
            int row = width * 4;
            var filtered = new byte[(row + 1) * height];
            for (int y = 0; y < height; y++)
            {
                int to = y * (row + 1);
                filtered[to] = 2;
                for (int x = 0; x < row; x++)
                    filtered[to + 1 + x] = (byte)(rgba[y * row + x] - (y > 0 ? rgba[(y - 1) * row + x] : 0));
            }
            return filtered;
        }

        // .NET Standard has raw deflate only: zlib adds two bytes before and a checksum behind.
        static byte[] Zlib(byte[] data)
        {
            using var stream = new MemoryStream();
            stream.WriteByte(0x78);
            stream.WriteByte(0x9C);
            using (var deflate = new DeflateStream(stream, CompressionLevel.Fastest, leaveOpen: true))
                deflate.Write(data, 0, data.Length);

            uint a = 1, b = 0;
            foreach (byte value in data)
            {
                a = (a + value) % 65521;
                b = (b + a) % 65521;
            }
            var adler = new byte[4];
            BigEndian(adler, 0, b << 16 | a);
            stream.Write(adler, 0, 4);
            return stream.ToArray();
        }

        static void Chunk(Stream file, string type, byte[] data)
        {
            var bytes = new byte[12 + data.Length];
            BigEndian(bytes, 0, (uint)data.Length);
            for (int i = 0; i < 4; i++)
                bytes[4 + i] = (byte)type[i];
            data.CopyTo(bytes, 8);

            uint crc = 0xFFFFFFFF;
            for (int i = 4; i < 8 + data.Length; i++)
                crc = crcTable[(crc ^ bytes[i]) & 0xFF] ^ crc >> 8;
            BigEndian(bytes, 8 + data.Length, ~crc);
            file.Write(bytes, 0, bytes.Length);
        }

        static void BigEndian(byte[] bytes, int at, uint value)
        {
            bytes[at] = (byte)(value >> 24);
            bytes[at + 1] = (byte)(value >> 16);
            bytes[at + 2] = (byte)(value >> 8);
            bytes[at + 3] = (byte)value;
        }

        static uint[] CrcTable()
        {
            var table = new uint[256];
            for (uint n = 0; n < 256; n++)
            {
                uint c = n;
                for (int k = 0; k < 8; k++)
                    c = (c & 1) != 0 ? 0xEDB88320 ^ c >> 1 : c >> 1;
                table[n] = c;
            }
            return table;
        }
    }
}
