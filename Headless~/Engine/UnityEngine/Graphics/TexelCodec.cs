using System;
using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    /// <summary>One texel of each format that scripts can read and write, to a color and back.</summary>
    internal static class TexelCodec
    {
        public static Color Decode(ReadOnlySpan<byte> bytes, int index, TextureFormat format)
        {
            switch (format)
            {
                case TextureFormat.Alpha8: return new Color(1, 1, 1, U8(bytes[index]));
                case TextureFormat.R8: return new Color(U8(bytes[index]), 0, 0, 1);
                case TextureFormat.RG16: return new Color(U8(bytes[index * 2]), U8(bytes[index * 2 + 1]), 0, 1);
                case TextureFormat.RGB24: return new Color(U8(bytes[index * 3]), U8(bytes[index * 3 + 1]), U8(bytes[index * 3 + 2]), 1);
                case TextureFormat.RGBA32: return Bytes4(bytes.Slice(index * 4), 0, 1, 2, 3);
                case TextureFormat.BGRA32: return Bytes4(bytes.Slice(index * 4), 2, 1, 0, 3);
                case TextureFormat.ARGB32: return Bytes4(bytes.Slice(index * 4), 1, 2, 3, 0);
                case TextureFormat.R16: return new Color(MemoryMarshal.Cast<byte, ushort>(bytes)[index] / 65535f, 0, 0, 1);
                case TextureFormat.RHalf: return new Color(Half(bytes, index), 0, 0, 1);
                case TextureFormat.RGHalf: return new Color(Half(bytes, index * 2), Half(bytes, index * 2 + 1), 0, 1);
                case TextureFormat.RGBAHalf: return new Color(Half(bytes, index * 4), Half(bytes, index * 4 + 1),
                    Half(bytes, index * 4 + 2), Half(bytes, index * 4 + 3));
                case TextureFormat.RFloat: return new Color(Float(bytes, index), 0, 0, 1);
                case TextureFormat.RGFloat: return new Color(Float(bytes, index * 2), Float(bytes, index * 2 + 1), 0, 1);
                case TextureFormat.RGBAFloat: return new Color(Float(bytes, index * 4), Float(bytes, index * 4 + 1),
                    Float(bytes, index * 4 + 2), Float(bytes, index * 4 + 3));
                default: throw Unsupported(format);
            }
        }

        public static void Encode(Span<byte> bytes, int index, TextureFormat format, Color c)
        {
            switch (format)
            {
                case TextureFormat.Alpha8: bytes[index] = U8(c.a); break;
                case TextureFormat.R8: bytes[index] = U8(c.r); break;
                case TextureFormat.RG16: bytes[index * 2] = U8(c.r); bytes[index * 2 + 1] = U8(c.g); break;
                case TextureFormat.RGB24: bytes[index * 3] = U8(c.r); bytes[index * 3 + 1] = U8(c.g); bytes[index * 3 + 2] = U8(c.b); break;
                case TextureFormat.RGBA32: Bytes4(bytes.Slice(index * 4), c.r, c.g, c.b, c.a); break;
                case TextureFormat.BGRA32: Bytes4(bytes.Slice(index * 4), c.b, c.g, c.r, c.a); break;
                case TextureFormat.ARGB32: Bytes4(bytes.Slice(index * 4), c.a, c.r, c.g, c.b); break;
                case TextureFormat.R16: MemoryMarshal.Cast<byte, ushort>(bytes)[index] = (ushort)(Mathf.Clamp01(c.r) * 65535f + 0.5f); break;
                case TextureFormat.RHalf: Halves(bytes, index, c, 1); break;
                case TextureFormat.RGHalf: Halves(bytes, index, c, 2); break;
                case TextureFormat.RGBAHalf: Halves(bytes, index, c, 4); break;
                case TextureFormat.RFloat: Floats(bytes, index, c, 1); break;
                case TextureFormat.RGFloat: Floats(bytes, index, c, 2); break;
                case TextureFormat.RGBAFloat: Floats(bytes, index, c, 4); break;
                default: throw Unsupported(format);
            }
        }

        /// <summary>The bytes in the layout of the device's format, where that is another than the script's.</summary>
        public static ReadOnlySpan<byte> ForDevice(byte[] bytes, TextureFormat format)
        {
            int size = Formats.TexelBytes(format);
            if (format != TextureFormat.RGB24 && format != TextureFormat.Alpha8 && format != TextureFormat.ARGB32)
                return bytes;
            var wide = new byte[bytes.Length / size * 4];
            for (int i = 0; i < wide.Length / 4; i++)
            {
                if (format == TextureFormat.Alpha8)
                    wide[i * 4 + 3] = bytes[i];
                else
                    Encode(wide, i, TextureFormat.RGBA32, Decode(bytes, i, format));
            }
            return wide;
        }

        static NotSupportedException Unsupported(TextureFormat format)
            => new NotSupportedException($"Pixels of TextureFormat.{format} are not supported by the headless host.");
        static float U8(byte value) => value / 255f;
        static byte U8(float value) => (byte)(Mathf.Clamp01(value) * 255f + 0.5f);
        static float Float(ReadOnlySpan<byte> bytes, int index) => MemoryMarshal.Cast<byte, float>(bytes)[index];
        static float Half(ReadOnlySpan<byte> bytes, int index) => Mathf.HalfToFloat(MemoryMarshal.Cast<byte, ushort>(bytes)[index]);
        static Color Bytes4(ReadOnlySpan<byte> texel, int r, int g, int b, int a)
            => new Color(U8(texel[r]), U8(texel[g]), U8(texel[b]), U8(texel[a]));

        static void Bytes4(Span<byte> texel, float x, float y, float z, float w)
        {
            texel[0] = U8(x);
            texel[1] = U8(y);
            texel[2] = U8(z);
            texel[3] = U8(w);
        }

        static void Halves(Span<byte> bytes, int index, Color c, int count)
        {
            Span<ushort> halves = MemoryMarshal.Cast<byte, ushort>(bytes);
            for (int k = 0; k < count; k++)
                halves[index * count + k] = Mathf.FloatToHalf(c[k]);
        }

        static void Floats(Span<byte> bytes, int index, Color c, int count)
        {
            Span<float> floats = MemoryMarshal.Cast<byte, float>(bytes);
            for (int k = 0; k < count; k++)
                floats[index * count + k] = c[k];
        }
    }
}
