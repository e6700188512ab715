using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using UnityEngine;

namespace Host.Assets
{
    /// <summary>A PNG file as 8-bit pixels, the bottom row first as Unity's textures have it.</summary>
    /// <remarks>Portable Network Graphics specification, second edition. Interlaced files are refused; 16 bits are cut to 8.</remarks>
    internal sealed class PngImage
    {
        public readonly int Width, Height;
        public readonly Color32[] Pixels;

        PngImage(int width, int height, Color32[] pixels) { Width = width; Height = height; Pixels = pixels; }

        /// <exception cref="AssetException">The file is no PNG, is damaged, or is interlaced.</exception>
        public static PngImage Read(byte[] file, string shownAs)
        {
            AssetException Bad(string what) => new AssetException($"{shownAs}: {what}");
            if (file.Length < 33 || BinaryPrimitives.ReadUInt64BigEndian(file) != 0x89504E470D0A1A0A) throw Bad("this is no PNG file");

            int width = 0, height = 0, depth = 0, kind = 0;
            byte[] palette = null, transparency = null;
            using var packed = new MemoryStream();
            for (var at = 8; at + 12 <= file.Length;)
            {
                var length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
                var tag = System.Text.Encoding.ASCII.GetString(file, at + 4, 4);
                if (length < 0 || at + 12 + length > file.Length) throw Bad($"its chunk {tag} is cut off");
                var data = file.AsSpan(at + 8, length);
                switch (tag)
                {
                    case "IHDR":
                        width = BinaryPrimitives.ReadInt32BigEndian(data);
                        height = BinaryPrimitives.ReadInt32BigEndian(data.Slice(4));
                        depth = data[8];
                        kind = data[9];
                        if (data[12] != 0) throw Bad("interlaced PNG files are not supported: save it without interlacing");
                        break;
                    case "PLTE": palette = data.ToArray(); break;
                    case "tRNS": transparency = data.ToArray(); break;
                    case "IDAT": packed.Write(data); break;
                }
                at += 12 + length;
            }

            var channels = kind switch { 0 => 1, 2 => 3, 3 => 1, 4 => 2, 6 => 4, _ => throw Bad($"color type {kind} does not exist") };
            if (kind == 3 && palette == null) throw Bad("its palette is missing");
            var rows = Unfilter(packed, width, height, depth * channels, Bad);
            var pixels = new Color32[width * height];
            var stride = (width * depth * channels + 7) / 8;
            for (var y = 0; y < height; y++)
            {
                var row = rows.AsSpan(y * stride, stride);
                for (var x = 0; x < width; x++)
                    pixels[(height - 1 - y) * width + x] = kind == 3
                        ? Indexed(palette, transparency, Sample(row, x, depth, false))
                        : Direct(row, x * channels, channels, depth);
            }
            return new PngImage(width, height, pixels);
        }

        static Color32 Indexed(byte[] palette, byte[] transparency, int index) =>
            new Color32(palette[index * 3], palette[index * 3 + 1], palette[index * 3 + 2], transparency != null
            && index < transparency.Length ? transparency[index] : (byte)255);

        /// <summary>One channel is gray, two gray and alpha, three and four colors.</summary>
        static Color32 Direct(ReadOnlySpan<byte> row, int first, int channels, int depth)
        {
            var red = Sample(row, first, depth, true);
            var alpha = channels % 2 == 0 ? Sample(row, first + channels - 1, depth, true) : (byte)255;
            return channels < 3 ? new Color32(red, red, red, alpha)
                : new Color32(red, Sample(row, first + 1, depth, true), Sample(row, first + 2, depth, true), alpha);
        }

        static byte Sample(ReadOnlySpan<byte> row, int index, int depth, bool scale)
        {
            if (depth == 8) return row[index];
            if (depth == 16) return row[index * 2];
            var perByte = 8 / depth;
            var most = (1 << depth) - 1;
            var value = row[index / perByte] >> (8 - depth * (index % perByte + 1)) & most;
            return (byte)(scale ? value * 255 / most : value);
        }

        /// <summary>Each row tells by its first byte from which neighbors its bytes are differences (section 9).</summary>
        static byte[] Unfilter(MemoryStream packed, int width, int height, int bitsPerPixel, Func<string, AssetException> bad)
        {
            var stride = (width * bitsPerPixel + 7) / 8;
            var step = Math.Max(1, bitsPerPixel / 8);
            var rows = new byte[stride * height];
            packed.Position = 0;
            using var inflated = new ZLibStream(packed, CompressionMode.Decompress);
            for (var y = 0; y < height; y++)
            {
                var filter = inflated.ReadByte();
                var row = rows.AsSpan(y * stride, stride);
                if (filter < 0 || inflated.ReadAtLeast(row, stride, false) < stride) throw bad($"its data ends in row {y} of {height}");
                var above = y > 0 ? rows.AsSpan((y - 1) * stride, stride) : default;
                for (var i = 0; i < stride; i++)
                {
                    int left = i >= step ? row[i - step] : 0, up = y > 0 ? above[i] : 0, corner = y > 0 && i >= step ? above[i - step] : 0;
                    row[i] += filter switch { 0 => (byte)0, 1 => (byte)left, 2 => (byte)up, 3 => (byte)((left + up) / 2),
                        4 => (byte)Paeth(left, up, corner), _ => throw bad($"row filter {filter} does not exist") };
                }
            }
            return rows;
        }

        static int Paeth(int left, int up, int corner)
        {
            var guess = left + up - corner;
            int toLeft = Math.Abs(guess - left), toUp = Math.Abs(guess - up), toCorner = Math.Abs(guess - corner);
            return toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
        }
    }
}
