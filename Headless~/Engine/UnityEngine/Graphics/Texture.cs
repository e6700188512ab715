using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public abstract class Texture : Object
    {
        public static readonly int GenerateAllMips = -1;
        public static AnisotropicFiltering anisotropicFiltering { get; set; } = AnisotropicFiltering.Enable;

        TextureWrapMode wrapU, wrapV, wrapW;
        uint updates;

        protected Texture() { }

        /// <summary>The device's texture; null when not created or destroyed.</summary>
        internal abstract DeviceTexture GetDevice(RenderTextureSubElement element);

        // Answers of subclasses: Unity's subclasses do not override the public members.
        internal virtual int WidthOf => 0;
        internal virtual int HeightOf => 0;
        internal virtual TextureDimension DimensionOf => TextureDimension.Tex2D;
        internal virtual GraphicsFormat FormatOf => GraphicsFormat.None;

        public virtual int width { get => WidthOf; set => throw new NotSupportedException("The width of this texture is fixed."); }
        public virtual int height { get => HeightOf; set => throw new NotSupportedException("The height of this texture is fixed."); }
        public virtual TextureDimension dimension { get => DimensionOf;
            set => throw new NotSupportedException("The dimension of this texture is fixed."); }
        public virtual GraphicsFormat graphicsFormat => FormatOf;
        public virtual bool isReadable => true;
        public int mipmapCount => MipCount;
        internal virtual int MipCount => 1;

        public bool isDataSRGB => Formats.IsSrgb(graphicsFormat);
        public FilterMode filterMode { get; set; } = FilterMode.Bilinear;
        public int anisoLevel { get; set; } = 1;
        public float mipMapBias { get; set; }
        public Vector2 texelSize => new Vector2(1f / width, 1f / height);
        public uint updateCount => updates;
        public void IncrementUpdateCount() => updates++;
        public IntPtr GetNativeTexturePtr() => throw new NotSupportedException(
            "Texture.GetNativeTexturePtr: the headless host has no native graphics objects to hand out.");

        public TextureWrapMode wrapMode { get => wrapU; set => wrapU = wrapV = wrapW = value; }
        public TextureWrapMode wrapModeU { get => wrapU; set => wrapU = value; }
        public TextureWrapMode wrapModeV { get => wrapV; set => wrapV = value; }
        public TextureWrapMode wrapModeW { get => wrapW; set => wrapW = value; }

        internal DeviceSampler Sampler => new DeviceSampler
        {
            Linear = filterMode != FilterMode.Point, LinearMip = filterMode == FilterMode.Trilinear,
            U = (DeviceWrap)wrapU, V = (DeviceWrap)wrapV, W = (DeviceWrap)wrapW, Anisotropy = anisoLevel > 1 ? anisoLevel : 0,
        };

        internal void CopySettings(Texture other)
        {
            filterMode = other.filterMode;
            anisoLevel = other.anisoLevel;
            mipMapBias = other.mipMapBias;
            wrapU = other.wrapU;
            wrapV = other.wrapV;
            wrapW = other.wrapW;
        }
    }
}
