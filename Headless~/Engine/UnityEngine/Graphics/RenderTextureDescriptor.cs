using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public struct RenderTextureDescriptor
    {
        RenderTextureCreationFlags creation;

        public RenderTextureDescriptor(int width, int height) : this(width, height, RenderTextureFormat.Default, 0) { }
        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat) : this(width, height, colorFormat, 0) { }
        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits)
            : this(width, height, colorFormat, depthBufferBits, 1) { }
        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits, int mipCount)
            : this(width, height, colorFormat, depthBufferBits, mipCount, RenderTextureReadWrite.Linear) { }
        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits, int mipCount,
            RenderTextureReadWrite readWrite)
            : this(width, height, Formats.Of(colorFormat, readWrite), Formats.OfDepthBits(depthBufferBits), mipCount) { }
        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits)
            : this(width, height, colorFormat, depthBufferBits, 1) { }
        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits, int mipCount)
            : this(width, height, colorFormat, Formats.OfDepthBits(depthBufferBits), mipCount) { }
        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat)
            : this(width, height, colorFormat, depthStencilFormat, 1) { }

        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat, int mipCount)
        {
            this = default;
            this.width = width;
            this.height = height;
            graphicsFormat = colorFormat;
            this.depthStencilFormat = depthStencilFormat;
            this.mipCount = mipCount;
            volumeDepth = 1;
            msaaSamples = 1;
            dimension = TextureDimension.Tex2D;
            shadowSamplingMode = ShadowSamplingMode.None;
            creation = RenderTextureCreationFlags.AutoGenerateMips | RenderTextureCreationFlags.AllowVerticalFlip;
        }

        public int width { get; set; }
        public int height { get; set; }
        public int volumeDepth { get; set; }
        public int msaaSamples { get; set; }
        public int mipCount { get; set; }
        public GraphicsFormat graphicsFormat { get; set; }
        public GraphicsFormat depthStencilFormat { get; set; }
        public GraphicsFormat stencilFormat { get; set; }
        public TextureDimension dimension { get; set; }
        public ShadowSamplingMode shadowSamplingMode { get; set; }
        public VRTextureUsage vrUsage { get; set; }
        public RenderTextureMemoryless memoryless { get; set; }
        public RenderTextureCreationFlags flags => creation;

        public RenderTextureFormat colorFormat
        {
            get => Formats.ToRenderTextureFormat(graphicsFormat);
            set => graphicsFormat = Formats.Of(value, sRGB ? RenderTextureReadWrite.sRGB : RenderTextureReadWrite.Linear);
        }

        public bool sRGB
        {
            get => Formats.IsSrgb(graphicsFormat);
            set => graphicsFormat = graphicsFormat == GraphicsFormat.None ? graphicsFormat
                : Formats.Of(colorFormat, value ? RenderTextureReadWrite.sRGB : RenderTextureReadWrite.Linear);
        }

        public int depthBufferBits { get => Formats.DepthBits(depthStencilFormat); set => depthStencilFormat = Formats.OfDepthBits(value); }
        public bool useMipMap { get => Has(RenderTextureCreationFlags.MipMap); set => Set(RenderTextureCreationFlags.MipMap, value); }
        public bool autoGenerateMips { get => Has(RenderTextureCreationFlags.AutoGenerateMips);
            set => Set(RenderTextureCreationFlags.AutoGenerateMips, value); }
        public bool enableRandomWrite { get => Has(RenderTextureCreationFlags.EnableRandomWrite);
            set => Set(RenderTextureCreationFlags.EnableRandomWrite, value); }
        public bool bindMS { get => Has(RenderTextureCreationFlags.BindMS); set => Set(RenderTextureCreationFlags.BindMS, value); }
        public bool useDynamicScale { get => Has(RenderTextureCreationFlags.DynamicallyScalable);
            set => Set(RenderTextureCreationFlags.DynamicallyScalable, value); }

        bool Has(RenderTextureCreationFlags flag) => (creation & flag) != 0;
        void Set(RenderTextureCreationFlags flag, bool value) => creation = value ? creation | flag : creation & ~flag;
    }
}
