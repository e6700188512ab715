using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class Texture3D : Texture
    {
        readonly TexelStore store;
        bool readable = true;

        public Texture3D(int width, int height, int depth, TextureFormat textureFormat, bool mipChain)
            : this(width, height, depth, textureFormat, mipChain ? -1 : 1) { }
        public Texture3D(int width, int height, int depth, TextureFormat textureFormat, bool mipChain, bool createUninitialized)
            : this(width, height, depth, textureFormat, mipChain ? -1 : 1) { }
        public Texture3D(int width, int height, int depth, DefaultFormat format, TextureCreationFlags flags)
            : this(width, height, depth, Formats.Of(format), flags) { }
        public Texture3D(int width, int height, int depth, DefaultFormat format, TextureCreationFlags flags, int mipCount)
            : this(width, height, depth, Formats.Of(format), flags, mipCount) { }
        public Texture3D(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags)
            : this(width, height, depth, format, flags, (flags & TextureCreationFlags.MipChain) != 0 ? -1 : 1) { }

        public Texture3D(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags, int mipCount)
        {
            store = NewStore(width, height, depth, Formats.ToTextureFormat(format), mipCount, !Formats.IsSrgb(format));
        }

        public Texture3D(int width, int height, int depth, TextureFormat textureFormat, int mipCount)
        {
            store = NewStore(width, height, depth, textureFormat, mipCount, true);
        }

        static TexelStore NewStore(int width, int height, int depth, TextureFormat format, int mips, bool linear) =>
            new TexelStore($"Texture3D {width} x {height} x {depth} {format}", DeviceTextureDimension.Tex3D, width, height, depth, 1,
            format, mips, linear);

        internal TexelStore Store => store;
        internal override DeviceTexture GetDevice(RenderTextureSubElement element) => store.Device;
        internal override int MipCount => store.Mips;
        internal override void ReleaseNative() => store.Release();

        internal override int WidthOf => store.Width;
        internal override int HeightOf => store.Height;
        public int depth => store.Depth;
        internal override TextureDimension DimensionOf => TextureDimension.Tex3D;
        internal override GraphicsFormat FormatOf => store.GraphicsFormat;
        public override bool isReadable => readable;
        public TextureFormat format => store.Format;

        TexelStore Readable(string call) => readable ? store
            : throw new ArgumentException($"Texture3D.{call}: '{name}' is not readable (Apply made it no longer readable).");

        int Index(int x, int y, int z, int mip)
        {
            int w = store.MipWidth(mip), h = store.MipHeight(mip), d = store.MipDepth(mip);
            return (Mathf.Clamp(z, 0, d - 1) * h + Mathf.Clamp(y, 0, h - 1)) * w + Mathf.Clamp(x, 0, w - 1);
        }

        public Color GetPixel(int x, int y, int z) => GetPixel(x, y, z, 0);
        public Color GetPixel(int x, int y, int z, int mipLevel) => Readable("GetPixel").Get(mipLevel, 0, Index(x, y, z, mipLevel));
        public void SetPixel(int x, int y, int z, Color color) => SetPixel(x, y, z, color, 0);
        public void SetPixel(int x, int y, int z, Color color, int mipLevel)
            => Readable("SetPixel").Set(mipLevel, 0, Index(x, y, z, mipLevel), color);
        public Color GetPixelBilinear(float u, float v, float w) => GetPixelBilinear(u, v, w, 0);

        public Color GetPixelBilinear(float u, float v, float w, int mipLevel)
        {
            float x = u * store.MipWidth(mipLevel) - 0.5f, y = v * store.MipHeight(mipLevel) - 0.5f, z = w * store.MipDepth(mipLevel) - 0.5f;
            int x0 = Mathf.FloorToInt(x), y0 = Mathf.FloorToInt(y), z0 = Mathf.FloorToInt(z);
            Color sum = default;
            for (int k = 0; k < 8; k++)
            {
                int dx = k & 1, dy = k >> 1 & 1, dz = k >> 2;
                float weight = (dx == 1 ? x - x0 : 1 - (x - x0)) * (dy == 1 ? y - y0 : 1 - (y - y0)) * (dz == 1 ? z - z0 : 1 - (z - z0));
                sum += GetPixel(x0 + dx, y0 + dy, z0 + dz, mipLevel) * weight;
            }
            return sum;
        }

        public Color[] GetPixels() => GetPixels(0);
        public Color[] GetPixels(int miplevel) => Readable("GetPixels").GetAll(miplevel);
        public Color32[] GetPixels32() => GetPixels32(0);
        public Color32[] GetPixels32(int miplevel) => Readable("GetPixels32").GetAll32(miplevel);
        public void SetPixels(Color[] colors) => SetPixels(colors, 0);
        public void SetPixels(Color[] colors, int miplevel) => Readable("SetPixels").SetAll(colors, miplevel);
        public void SetPixels32(Color32[] colors) => SetPixels32(colors, 0);
        public void SetPixels32(Color32[] colors, int miplevel) => Readable("SetPixels32").SetAll32(colors, miplevel);

        public NativeArray<T> GetPixelData<T>(int mipLevel) where T : struct => Readable("GetPixelData").View<T>(mipLevel);
        public void SetPixelData<T>(T[] data, int mipLevel, int sourceDataStartIndex = 0) where T : struct =>
            Readable("SetPixelData").Assign(MemoryMarshal.AsBytes(data.AsSpan(sourceDataStartIndex)), mipLevel, 0);
        public void SetPixelData<T>(NativeArray<T> data, int mipLevel, int sourceDataStartIndex = 0) where T : struct =>
            Readable("SetPixelData").Assign(Transfer.Bytes(data).Slice(sourceDataStartIndex * ElementSize<T>.Bytes), mipLevel, 0);

        public void Apply() => Apply(true, false);
        public void Apply(bool updateMipmaps) => Apply(updateMipmaps, false);

        public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
        {
            Readable("Apply").Apply(updateMipmaps);
            IncrementUpdateCount();
            if (makeNoLongerReadable)
                readable = false;
        }
    }
}
