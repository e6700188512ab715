using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class Texture2DArray : Texture
    {
        readonly TexelStore store;
        bool readable = true;

        public Texture2DArray(int width, int height, int depth, TextureFormat textureFormat, bool mipChain)
            : this(width, height, depth, textureFormat, mipChain ? -1 : 1, false) { }
        public Texture2DArray(int width, int height, int depth, TextureFormat textureFormat, bool mipChain, bool linear)
            : this(width, height, depth, textureFormat, mipChain ? -1 : 1, linear) { }
        public Texture2DArray(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags)
            : this(width, height, depth, format, flags, (flags & TextureCreationFlags.MipChain) != 0 ? -1 : 1) { }
        public Texture2DArray(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags, int mipCount)
            : this(width, height, depth, Formats.ToTextureFormat(format), mipCount, !Formats.IsSrgb(format)) { }

        public Texture2DArray(int width, int height, int depth, TextureFormat textureFormat, int mipCount, bool linear)
        {
            store = new TexelStore($"Texture2DArray {width} x {height} x {depth} {textureFormat}", DeviceTextureDimension.Tex2DArray, width,
                height, 1, depth, textureFormat, mipCount, linear);
        }

        internal override DeviceTexture GetDevice(RenderTextureSubElement element) => store.Device;
        internal override int MipCount => store.Mips;
        internal override void ReleaseNative() => store.Release();

        public static int allSlices => -1;
        internal override int WidthOf => store.Width;
        internal override int HeightOf => store.Height;
        public int depth => store.Slices;
        internal override TextureDimension DimensionOf => TextureDimension.Tex2DArray;
        internal override GraphicsFormat FormatOf => store.GraphicsFormat;
        public override bool isReadable => readable;
        public TextureFormat format => store.Format;

        public Color[] GetPixels(int arrayElement) => GetPixels(arrayElement, 0);
        public Color[] GetPixels(int arrayElement, int miplevel) => store.GetAll(miplevel, arrayElement);
        public Color32[] GetPixels32(int arrayElement) => GetPixels32(arrayElement, 0);
        public Color32[] GetPixels32(int arrayElement, int miplevel) => store.GetAll32(miplevel, arrayElement);
        public void SetPixels(Color[] colors, int arrayElement) => SetPixels(colors, arrayElement, 0);
        public void SetPixels(Color[] colors, int arrayElement, int miplevel) => store.SetAll(colors, miplevel, arrayElement);
        public void SetPixels32(Color32[] colors, int arrayElement) => SetPixels32(colors, arrayElement, 0);
        public void SetPixels32(Color32[] colors, int arrayElement, int miplevel) => store.SetAll32(colors, miplevel, arrayElement);

        public NativeArray<T> GetPixelData<T>(int mipLevel, int element) where T : struct => store.View<T>(mipLevel, element);
        public void SetPixelData<T>(T[] data, int mipLevel, int element, int sourceDataStartIndex = 0) where T : struct =>
            store.Assign(MemoryMarshal.AsBytes(data.AsSpan(sourceDataStartIndex)), mipLevel, element);
        public void SetPixelData<T>(NativeArray<T> data, int mipLevel, int element, int sourceDataStartIndex = 0) where T : struct =>
            store.Assign(Transfer.Bytes(data).Slice(sourceDataStartIndex * ElementSize<T>.Bytes), mipLevel, element);

        public void Apply() => Apply(true, false);
        public void Apply(bool updateMipmaps) => Apply(updateMipmaps, false);

        public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
        {
            store.Apply(updateMipmaps);
            IncrementUpdateCount();
            if (makeNoLongerReadable)
                readable = false;
        }
    }
}
