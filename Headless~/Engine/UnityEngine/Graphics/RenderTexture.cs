using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>
    /// Row 0 is the bottom of the picture, as Unity on Direct3D 11 has it by flipping y in the projection.
    /// Multisampling is accepted and drawn with one sample.
    /// </summary>
    public class RenderTexture : Texture
    {
        RenderTextureDescriptor description;
        DeviceTexture color, depthTexture;
        /// <summary>The engine's own: its memory on the device is not a leak.</summary>
        internal bool IsBuiltIn;
        /// <summary>Row 0 is the top of the picture, as of Direct3D's back buffer.</summary>
        internal bool IsUpright;

        protected RenderTexture() => wrapMode = TextureWrapMode.Clamp;
        public RenderTexture(RenderTextureDescriptor desc) : this() => description = Checked(desc);
        public RenderTexture(RenderTexture textureToCopy)
            : this(textureToCopy == null ? throw new ArgumentNullException(nameof(textureToCopy)) : textureToCopy.description)
            => CopySettings(textureToCopy);
        public RenderTexture(int width, int height, int depth) : this(width, height, depth, RenderTextureFormat.Default) { }
        public RenderTexture(int width, int height, int depth, RenderTextureFormat format)
            : this(width, height, depth, format, RenderTextureReadWrite.Default) { }
        public RenderTexture(int width, int height, int depth, RenderTextureFormat format, RenderTextureReadWrite readWrite)
            : this(Describe(width, height, depth, format, readWrite)) { }
        public RenderTexture(int width, int height, int depth, RenderTextureFormat format, int mipCount)
            : this(Describe(width, height, depth, format, RenderTextureReadWrite.Default, mipCount)) { }
        public RenderTexture(int width, int height, int depth, DefaultFormat format) : this(width, height, depth, Formats.Of(format)) { }
        public RenderTexture(int width, int height, int depth, GraphicsFormat format) : this(width, height, depth, format, 1) { }
        public RenderTexture(int width, int height, int depth, GraphicsFormat format, int mipCount)
            : this(new RenderTextureDescriptor(width, height, format, depth, mipCount)) { }
        public RenderTexture(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat)
            : this(new RenderTextureDescriptor(width, height, colorFormat, depthStencilFormat)) { }
        public RenderTexture(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat, int mipCount)
            : this(new RenderTextureDescriptor(width, height, colorFormat, depthStencilFormat, mipCount)) { }

        static RenderTextureDescriptor Describe(int width, int height, int depth, RenderTextureFormat format,
            RenderTextureReadWrite readWrite, int mips = 1)
        {
            // Default is sRGB in a linear project, for formats that have such a variant.
            if (readWrite == RenderTextureReadWrite.Default && Player.LinearColorSpace)
                readWrite = RenderTextureReadWrite.sRGB;
            bool depthOnly = format == RenderTextureFormat.Depth || format == RenderTextureFormat.Shadowmap;
            return new RenderTextureDescriptor(width, height, format, depthOnly && depth == 0 ? 16 : depth, mips, readWrite);
        }

        static RenderTextureDescriptor Checked(RenderTextureDescriptor desc)
        {
            if (desc.width <= 0 || desc.height <= 0)
                throw new ArgumentException($"RenderTexture of {desc.width} x {desc.height}: width and height must be at least 1.");
            if (desc.volumeDepth <= 0)
                throw new ArgumentException($"RenderTexture with volumeDepth {desc.volumeDepth}: it must be at least 1.");
            if (desc.graphicsFormat == GraphicsFormat.None && desc.depthStencilFormat == GraphicsFormat.None)
                throw new ArgumentException("RenderTexture with neither a color nor a depth format.");
            return desc;
        }

        // ---- life

        public bool Create()
        {
            if (color != null || depthTexture != null)
                return true;
            Gpu.RequireDevice($"RenderTexture.Create of '{name}'");
            string label = name.Length > 0 ? name : $"RenderTexture {width} x {height}";
            if (description.enableRandomWrite && !SystemInfo.SupportsRandomWriteOnRenderTextureFormat(description.colorFormat))
            {
                string unsupported = $"RenderTexture '{label}': {Player.Limits.Title} has no random writes to {description.graphicsFormat}; ask " +
                    $"SystemInfo.SupportsRandomWriteOnRenderTextureFormat first.";
                GpuError.Report(unsupported, unsupported);
                return false;
            }
            if (description.graphicsFormat != GraphicsFormat.None)
                color = CreateDevice(label, description.graphicsFormat, description.enableRandomWrite);
            if (description.depthStencilFormat != GraphicsFormat.None && dimension != TextureDimension.Tex3D)
                depthTexture = CreateDevice(label + " depth", description.depthStencilFormat, false);
            if (!IsBuiltIn)
                LiveObjects.Add(this, "RenderTexture", label);
            return true;
        }

        DeviceTexture CreateDevice(string label, GraphicsFormat format, bool randomWrite)
        {
            bool volume = dimension == TextureDimension.Tex3D;
            bool array = dimension == TextureDimension.Tex2DArray || dimension == TextureDimension.CubeArray;      // of cubes: six slices each
            DeviceTexture texture = Gpu.Device.CreateTexture(new DeviceTextureDescription
            {
                Name = label, Format = Formats.Device(format),
                Dimension = volume ? DeviceTextureDimension.Tex3D : dimension == TextureDimension.Tex2DArray
                    ? DeviceTextureDimension.Tex2DArray : dimension == TextureDimension.Cube ? DeviceTextureDimension.Cube
                    : array ? DeviceTextureDimension.CubeArray : DeviceTextureDimension.Tex2D,
                Width = width, Height = height, Depth = volume ? volumeDepth : 1, Slices = array ? volumeDepth
                    : dimension == TextureDimension.Cube ? 6 : 1,
                Mips = MipCount, Samples = 1, RandomWrite = randomWrite, Target = !volume,
            });
            Gpu.Device.ClearTexture(texture, default);
            return texture;
        }

        public bool IsCreated() => color != null || depthTexture != null;

        public void Release()
        {
            if (!IsCreated())
                return;
            color?.Dispose();
            depthTexture?.Dispose();
            color = depthTexture = null;
            if (ReferenceEquals(RenderState.ActiveTexture, this))
                RenderState.SetTarget(null);
            LiveObjects.Remove(this);
        }

        internal override void ReleaseNative() => Release();

        internal override Object CloneNative()
        {
            var copy = new RenderTexture(description);
            copy.CopySettings(this);
            return copy;
        }

        internal override DeviceTexture GetDevice(RenderTextureSubElement element) =>
            element == RenderTextureSubElement.Depth || color == null ? depthTexture : color;

        internal DeviceTexture DepthTexture => depthTexture;

        // ---- description

        void Change(string property)
        {
            if (IsCreated())
                GpuError.Report($"Setting {property} of the already created RenderTexture '{name}' is not supported; Release it first.",
                    $"Setting {property} of already created render texture is not supported!");
        }

        public RenderTextureDescriptor descriptor { get => description; set { Change("descriptor"); description = Checked(value); } }
        public override int width { get => description.width; set { Change("width"); description.width = value; } }
        public override int height { get => description.height; set { Change("height"); description.height = value; } }
        public override TextureDimension dimension { get => description.dimension; set { Change("dimension"); description.dimension = value; } }
        public int volumeDepth { get => description.volumeDepth; set { Change("volumeDepth"); description.volumeDepth = value; } }
        public int depth { get => description.depthBufferBits; set { Change("depth"); description.depthBufferBits = value; } }
        public int antiAliasing { get => description.msaaSamples; set { Change("antiAliasing"); description.msaaSamples = value; } }
        public bool enableRandomWrite { get => description.enableRandomWrite;
            set { Change("enableRandomWrite"); description.enableRandomWrite = value; } }
        public bool useMipMap { get => description.useMipMap; set { Change("useMipMap"); description.useMipMap = value; } }
        public bool autoGenerateMips { get => description.autoGenerateMips; set => description.autoGenerateMips = value; }
        public bool bindTextureMS { get => description.bindMS; set => description.bindMS = value; }
        public bool useDynamicScale { get => description.useDynamicScale; set => description.useDynamicScale = value; }
        public RenderTextureMemoryless memorylessMode { get => description.memoryless; set => description.memoryless = value; }
        public VRTextureUsage vrUsage { get => description.vrUsage; set => description.vrUsage = value; }
        public RenderTextureFormat format { get => description.colorFormat; set { Change("format"); description.colorFormat = value; } }
        internal override GraphicsFormat FormatOf => description.graphicsFormat;
        public new GraphicsFormat graphicsFormat { get => description.graphicsFormat;
            set { Change("graphicsFormat"); description.graphicsFormat = value; } }
        public GraphicsFormat depthStencilFormat { get => description.depthStencilFormat;
            set { Change("depthStencilFormat"); description.depthStencilFormat = value; } }
        public GraphicsFormat stencilFormat { get => description.stencilFormat; set => description.stencilFormat = value; }
        public bool sRGB => description.sRGB;
        public bool isPowerOfTwo { get => Mathf.IsPowerOfTwo(width) && Mathf.IsPowerOfTwo(height); set { } }
        public RenderBuffer colorBuffer => new RenderBuffer(this, RenderTextureSubElement.Color);
        public RenderBuffer depthBuffer => new RenderBuffer(this, RenderTextureSubElement.Depth);
        public static bool SupportsStencil(RenderTexture rt) =>
            rt != null && rt.depthStencilFormat != GraphicsFormat.None && Formats.Device(rt.depthStencilFormat) == DeviceFormat.D32_S8;

        internal override int MipCount => !description.useMipMap ? 1
            : description.mipCount > 1 ? description.mipCount : 1 + (int)Math.Floor(Math.Log(Math.Max(width, height), 2));

        public void DiscardContents() { }
        public void DiscardContents(bool discardColor, bool discardDepth) { }
        public void ResolveAntiAliasedSurface() { }
        public void ResolveAntiAliasedSurface(RenderTexture target) => Graphics.CopyTexture(this, target);
        public void SetGlobalShaderProperty(string propertyName) => Shader.SetGlobalTexture(propertyName, this);

        // ---- the active target

        public static RenderTexture active { get => RenderState.ActiveTexture; set => RenderState.SetTarget(value); }

        // ---- temporaries: freed ones wait for a request of the same description

        static readonly List<RenderTexture> freeTemporaries = new List<RenderTexture>();
        static readonly HashSet<RenderTexture> usedTemporaries = new HashSet<RenderTexture>();

        public static RenderTexture GetTemporary(RenderTextureDescriptor desc)
        {
            for (int i = 0; i < freeTemporaries.Count; i++)
            {
                RenderTexture free = freeTemporaries[i];
                if (!Equals(free.description, desc))
                    continue;
                freeTemporaries.RemoveAt(i);
                usedTemporaries.Add(free);
                return free;
            }
            var texture = new RenderTexture(desc) { name = "TempBuffer", hideFlags = HideFlags.HideAndDontSave };
            texture.Create();
            usedTemporaries.Add(texture);
            return texture;
        }

        public static void ReleaseTemporary(RenderTexture temp)
        {
            if (temp == null)
                return;
            if (!usedTemporaries.Remove(temp))
            {
                GpuError.Report($"ReleaseTemporary of '{temp.name}', which is not a temporary in use.",
                    "Trying to release render texture that was not allocated by RenderTexture.GetTemporary");
                return;
            }
            freeTemporaries.Add(temp);
        }

        /// <summary>Frees the pool; temporaries still in use stay and are somebody's leak.</summary>
        internal static void ForgetTemporaries()
        {
            foreach (RenderTexture texture in freeTemporaries)
                DestroyImmediate(texture);
            freeTemporaries.Clear();
        }

        public static RenderTexture GetTemporary(int width, int height) => GetTemporary(width, height, 0);
        public static RenderTexture GetTemporary(int width, int height, int depthBuffer)
            => GetTemporary(width, height, depthBuffer, RenderTextureFormat.Default);
        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format)
            => GetTemporary(width, height, depthBuffer, format, RenderTextureReadWrite.Default);
        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format,
            RenderTextureReadWrite readWrite) => GetTemporary(Describe(width, height, depthBuffer, format, readWrite));
        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format,
            RenderTextureReadWrite readWrite, int antiAliasing) => GetTemporary(width, height, depthBuffer, format, readWrite);
        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, GraphicsFormat format)
            => GetTemporary(new RenderTextureDescriptor(width, height, format, depthBuffer));
        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, GraphicsFormat format, int antiAliasing)
            => GetTemporary(width, height, depthBuffer, format);
    }

    public struct RenderBuffer
    {
        internal readonly RenderTexture Texture;
        internal readonly RenderTextureSubElement Element;
        internal RenderBuffer(RenderTexture texture, RenderTextureSubElement element)
        {
            Texture = texture;
            Element = element;
        }

        public IntPtr GetNativeRenderBufferPtr()
            => throw new NotSupportedException(
            "RenderBuffer.GetNativeRenderBufferPtr: the headless host has no native graphics objects to hand out.");
    }
}
