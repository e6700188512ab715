using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Rows of a face run from its top, seen from within.</summary>
    public sealed class Cubemap : Texture
    {
        readonly TexelStore store;
        bool readable = true;

        public Cubemap(int width, TextureFormat textureFormat, bool mipChain) : this(width, textureFormat, mipChain ? -1 : 1) { }
        public Cubemap(int width, TextureFormat format, int mipCount) =>
            store = new TexelStore($"Cubemap {width} x {width} {format}", DeviceTextureDimension.Cube, width, width, 1, 6, format, mipCount, false);
        public Cubemap(int width, GraphicsFormat format, TextureCreationFlags flags)
        {
            int mips = (flags & TextureCreationFlags.MipChain) != 0 ? -1 : 1;
            store = new TexelStore($"Cubemap {width} x {width} {format}", DeviceTextureDimension.Cube, width, width, 1, 6,
                Formats.ToTextureFormat(format), mips, !Formats.IsSrgb(format));
        }

        internal TexelStore Store => store;
        internal override DeviceTexture GetDevice(RenderTextureSubElement element) => store.Device;
        internal override int MipCount => store.Mips;
        internal override void ReleaseNative() => store.Release();
        internal override int WidthOf => store.Width;
        internal override int HeightOf => store.Height;
        internal override TextureDimension DimensionOf => TextureDimension.Cube;
        internal override GraphicsFormat FormatOf => store.GraphicsFormat;
        public override bool isReadable => readable;
        public TextureFormat format => store.Format;

        public Color[] GetPixels(CubemapFace face) => GetPixels(face, 0);
        public Color[] GetPixels(CubemapFace face, int miplevel) => store.GetAll(miplevel, (int)face);
        public void SetPixels(Color[] colors, CubemapFace face) => SetPixels(colors, face, 0);
        public void SetPixels(Color[] colors, CubemapFace face, int miplevel) => store.SetAll(colors, miplevel, (int)face);

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
