using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class Texture2D : Texture
    {
        [Flags] public enum EXRFlags { None = 0, OutputAsFloat = 1, CompressZIP = 2, CompressRLE = 4, CompressPIZ = 8 }

        TexelStore store;
        bool readable = true;

        public Texture2D(int width, int height) : this(width, height, TextureFormat.RGBA32, -1, false) { }
        public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
            : this(width, height, textureFormat, mipChain ? -1 : 1, false) { }
        public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear)
            : this(width, height, textureFormat, mipChain ? -1 : 1, linear) { }
        public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear, bool createUninitialized)
            : this(width, height, textureFormat, mipChain ? -1 : 1, linear) { }
        public Texture2D(int width, int height, TextureFormat textureFormat, int mipCount, bool linear, bool createUninitialized)
            : this(width, height, textureFormat, mipCount, linear) { }
        public Texture2D(int width, int height, DefaultFormat format, TextureCreationFlags flags) : this(width, height, Formats.Of(format), flags) { }
        public Texture2D(int width, int height, DefaultFormat format, int mipCount, TextureCreationFlags flags)
            : this(width, height, Formats.Of(format), mipCount, flags) { }
        public Texture2D(int width, int height, GraphicsFormat format, TextureCreationFlags flags)
            : this(width, height, format, (flags & TextureCreationFlags.MipChain) != 0 ? -1 : 1, flags) { }
        public Texture2D(int width, int height, GraphicsFormat format, int mipCount, TextureCreationFlags flags)
            : this(width, height, Formats.ToTextureFormat(format), mipCount, !Formats.IsSrgb(format)) { }

        public Texture2D(int width, int height, TextureFormat textureFormat, int mipCount, bool linear)
        {
            store = new TexelStore($"Texture2D {width} x {height} {textureFormat}", DeviceTextureDimension.Tex2D, width, height, 1, 1,
                textureFormat, mipCount, linear);
        }

        internal TexelStore Store => store;
        internal override DeviceTexture GetDevice(RenderTextureSubElement element) => store.Device;
        internal override int MipCount => store.Mips;
        internal override void ReleaseNative() => store.Release();

        internal override Object CloneNative()
        {
            var copy = new Texture2D(width, height, format, store.Mips, !isDataSRGB);
            for (int mip = 0; mip < store.Mips; mip++)
                copy.store.Assign(store.Bytes(mip), mip, 0);
            copy.CopySettings(this);
            copy.Apply(false);
            return copy;
        }

        internal override int WidthOf => store.Width;
        internal override int HeightOf => store.Height;
        internal override GraphicsFormat FormatOf => store.GraphicsFormat;
        public override bool isReadable => readable;
        public TextureFormat format => store.Format;

        public static Texture2D whiteTexture => BuiltinTextures.White;
        public static Texture2D blackTexture => BuiltinTextures.Black;
        public static Texture2D redTexture => BuiltinTextures.Red;
        public static Texture2D grayTexture => BuiltinTextures.Gray;
        public static Texture2D linearGrayTexture => BuiltinTextures.LinearGray;
        public static Texture2D normalTexture => BuiltinTextures.Normal;

        TexelStore Readable(string call) =>
            readable ? store : throw new ArgumentException($"Texture2D.{call}: texture data of '{name}' is either not readable, " +
            $"corrupted or does not exist (Apply made it no longer readable).");

        int Index(int x, int y, int mip)
        {
            int w = store.MipWidth(mip), h = store.MipHeight(mip);
            return Wrap(y, h, wrapModeV) * w + Wrap(x, w, wrapModeU);
        }

        static int Wrap(int i, int n, TextureWrapMode mode) => mode == TextureWrapMode.Repeat ? (i % n + n) % n : Math.Max(0, Math.Min(i, n - 1));

        public Color GetPixel(int x, int y) => GetPixel(x, y, 0);
        public Color GetPixel(int x, int y, int mipLevel) => Readable("GetPixel").Get(mipLevel, 0, Index(x, y, mipLevel));
        public void SetPixel(int x, int y, Color color) => SetPixel(x, y, color, 0);
        public void SetPixel(int x, int y, Color color, int mipLevel) => Readable("SetPixel").Set(mipLevel, 0, Index(x, y, mipLevel), color);
        public Color GetPixelBilinear(float u, float v) => GetPixelBilinear(u, v, 0);

        public Color GetPixelBilinear(float u, float v, int mipLevel)
        {
            float x = u * store.MipWidth(mipLevel) - 0.5f, y = v * store.MipHeight(mipLevel) - 0.5f;
            int x0 = Mathf.FloorToInt(x), y0 = Mathf.FloorToInt(y);
            Color low = Color.LerpUnclamped(GetPixel(x0, y0, mipLevel), GetPixel(x0 + 1, y0, mipLevel), x - x0);
            Color high = Color.LerpUnclamped(GetPixel(x0, y0 + 1, mipLevel), GetPixel(x0 + 1, y0 + 1, mipLevel), x - x0);
            return Color.LerpUnclamped(low, high, y - y0);
        }

        public Color[] GetPixels() => GetPixels(0);
        public Color[] GetPixels(int miplevel) => Readable("GetPixels").GetAll(miplevel);
        public Color32[] GetPixels32() => GetPixels32(0);
        public Color32[] GetPixels32(int miplevel) => Readable("GetPixels32").GetAll32(miplevel);
        public Color[] GetPixels(int x, int y, int blockWidth, int blockHeight) => GetPixels(x, y, blockWidth, blockHeight, 0);

        public Color[] GetPixels(int x, int y, int blockWidth, int blockHeight, int miplevel)
        {
            Block(x, y, blockWidth, blockHeight, miplevel, "GetPixels");
            var colors = new Color[blockWidth * blockHeight];
            for (int i = 0; i < colors.Length; i++)
                colors[i] = store.Get(miplevel, 0, (y + i / blockWidth) * store.MipWidth(miplevel) + x + i % blockWidth);
            return colors;
        }

        public void SetPixels(Color[] colors) => SetPixels(colors, 0);
        public void SetPixels(Color[] colors, int miplevel) => Readable("SetPixels").SetAll(colors, miplevel);
        public void SetPixels32(Color32[] colors) => SetPixels32(colors, 0);
        public void SetPixels32(Color32[] colors, int miplevel) => Readable("SetPixels32").SetAll32(colors, miplevel);
        public void SetPixels(int x, int y, int blockWidth, int blockHeight, Color[] colors) => SetPixels(x, y, blockWidth, blockHeight, colors, 0);

        public void SetPixels(int x, int y, int blockWidth, int blockHeight, Color[] colors, int miplevel)
        {
            Block(x, y, blockWidth, blockHeight, miplevel, "SetPixels");
            for (int i = 0; i < blockWidth * blockHeight; i++)
                store.Set(miplevel, 0, (y + i / blockWidth) * store.MipWidth(miplevel) + x + i % blockWidth, colors[i]);
        }

        public void SetPixels32(int x, int y, int blockWidth, int blockHeight, Color32[] colors)
            => SetPixels32(x, y, blockWidth, blockHeight, colors, 0);
        public void SetPixels32(int x, int y, int blockWidth, int blockHeight, Color32[] colors, int miplevel) =>
            SetPixels(x, y, blockWidth, blockHeight, Array.ConvertAll(colors, c => (Color)c), miplevel);

        void Block(int x, int y, int w, int h, int mip, string call)
        {
            Readable(call);
            if (x < 0 || y < 0 || w < 0 || h < 0 || x + w > store.MipWidth(mip) || y + h > store.MipHeight(mip))
                throw new ArgumentException($"Texture2D.{call}: block {x}, {y}, {w} x {h} exceeds level {mip} of '{name}', which is " +
                    $"{store.MipWidth(mip)} x {store.MipHeight(mip)}.");
        }

        public NativeArray<T> GetPixelData<T>(int mipLevel) where T : struct => Readable("GetPixelData").View<T>(mipLevel);
        public void SetPixelData<T>(T[] data, int mipLevel, int sourceDataStartIndex = 0) where T : struct =>
            Readable("SetPixelData").Assign(MemoryMarshal.AsBytes(data.AsSpan(sourceDataStartIndex)), mipLevel, 0);
        public void SetPixelData<T>(NativeArray<T> data, int mipLevel, int sourceDataStartIndex = 0) where T : struct =>
            Readable("SetPixelData").Assign(Transfer.Bytes(data).Slice(sourceDataStartIndex * ElementSize<T>.Bytes), mipLevel, 0);

        /// <summary>All mip levels, one after the other.</summary>
        public byte[] GetRawTextureData()
        {
            Readable("GetRawTextureData");
            if (store.Mips == 1)
                return (byte[])store.Bytes(0).Clone();
            var all = new System.Collections.Generic.List<byte>();
            for (int mip = 0; mip < store.Mips; mip++)
                all.AddRange(store.Bytes(mip));
            return all.ToArray();
        }

        public NativeArray<T> GetRawTextureData<T>() where T : struct =>
            store.Mips == 1 ? Readable("GetRawTextureData").View<T>(0)
            : throw new NotSupportedException(
            "GetRawTextureData<T> of a texture with mip levels is not supported by the headless host; use GetPixelData<T>(mipLevel).");

        public void LoadRawTextureData(byte[] data) => LoadRaw(data);
        public void LoadRawTextureData<T>(NativeArray<T> data) where T : struct => LoadRaw(Transfer.Bytes(data));
        public unsafe void LoadRawTextureData(IntPtr data, int size) => LoadRaw(new ReadOnlySpan<byte>((void*)data, size));

        void LoadRaw(ReadOnlySpan<byte> data)
        {
            Readable("LoadRawTextureData");
            for (int mip = 0; mip < store.Mips; mip++)
            {
                store.Assign(data, mip, 0);
                data = data.Slice(store.Bytes(mip).Length);
            }
        }

        public void Apply() => Apply(true, false);
        public void Apply(bool updateMipmaps) => Apply(updateMipmaps, false);

        public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
        {
            Readable("Apply").Apply(updateMipmaps);
            IncrementUpdateCount();
            if (makeNoLongerReadable)
                readable = false;
        }

        public void ReadPixels(Rect source, int destX, int destY) => ReadPixels(source, destX, destY, true);

        /// <summary>From the active render texture, or the screen when none is; rows as stored, bottom first.</summary>
        public void ReadPixels(Rect source, int destX, int destY, bool recalculateMipMaps)
        {
            Readable("ReadPixels");
            RenderTexture from = RenderTexture.active != null ? RenderTexture.active : ScreenTarget.Texture;
            int x0 = (int)source.x, y0 = (int)source.y, w = (int)source.width, h = (int)source.height;
            if (x0 < 0 || y0 < 0 || x0 + w > from.width || y0 + h > from.height)
            {
                GpuError.Report($"ReadPixels of {source} reaches outside '{from.name}' of {from.width} x {from.height}.",
                    "[d3d11] attempting to ReadPixels outside of RenderTexture bounds! Reading (" + x0 + ", " + y0 + ", " + (x0 + w) + ", "
                    + (y0 + h) + $") from ({from.width}, {from.height})");
                return;
            }
            byte[] texels = Gpu.Device.ReadTexture(from.GetDevice(RenderTextureSubElement.Color), 0, 0);
            TextureFormat fromFormat = Formats.ToTextureFormat(from.graphicsFormat);
            for (int y = 0; y < h; y++)
                for (int x = 0; x < w; x++)
                    store.Set(0, 0, (destY + y) * width + destX + x, TexelCodec.Decode(texels, (y0 + y) * from.width + x0 + x, fromFormat));
            if (recalculateMipMaps && store.Mips > 1)
                Apply(true);
        }

        public bool Reinitialize(int width, int height) => Reinitialize(width, height, format, store.Mips > 1);
        public bool Reinitialize(int width, int height, GraphicsFormat format, bool hasMipMap)
            => Reinitialize(width, height, Formats.ToTextureFormat(format), hasMipMap);

        public bool Reinitialize(int width, int height, TextureFormat format, bool hasMipMap)
        {
            bool linear = !isDataSRGB;
            store.Release();
            store = new TexelStore($"Texture2D {width} x {height} {format}", DeviceTextureDimension.Tex2D, width, height, 1, 1, format,
                hasMipMap ? -1 : 1, linear);
            return true;
        }
    }
}
