using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Limits are those of <see cref="Player.Limits"/> or the device's, whichever is less.</summary>
    public sealed class SystemInfo
    {
        public const string unsupportedIdentifier = "n/a";

        static DeviceInfo Info => Player.Device?.Info;
        static bool Compute => Gpu.Available;

        public static bool supportsComputeShaders => Compute;
        public static bool supportsAsyncGPUReadback => Compute;
        public static bool supportsIndirectArgumentsBuffer => Compute;
        public static bool supportsInstancing => Info != null;
        public static bool supportsSetConstantBuffer => Compute;
        public static bool supportsGpuRecorder => GpuSamples.Supported;
        public static bool supportsAsyncCompute => false;
        public static bool supportsGraphicsFence => false;
        public static bool supportsGeometryShaders => false;
        public static bool supportsTessellationShaders => false;
        public static bool supportsRayTracing => false;
        public static bool supportsConservativeRaster => false;
        public static bool supportsShadows => false;
        public static bool supportsMotionVectors => false;
        public static bool supportsMultiview => false;
        public static bool supportsSparseTextures => false;
        public static bool supportsHardwareQuadTopology => false;
        public static bool supportsRenderTargetArrayIndexFromVertexShader => false;
        public static int supportsMultisampledTextures => 0;
        public static bool supports3DTextures => Info != null;
        public static bool supports3DRenderTextures => Info != null;
        public static bool supports2DArrayTextures => Info != null;
        public static bool supports32bitsIndexBuffer => Info != null;
        public static bool supportsSeparatedRenderTargetsBlend => false;
        public static bool supportsAudio => false;
        public static bool usesReversedZBuffer => true;
        public static bool usesLoadStoreActions => false;
        public static bool graphicsUVStartsAtTop => true;
        public static bool graphicsMultiThreaded => false;
        public static CopyTextureSupport copyTextureSupport
            => CopyTextureSupport.Basic | CopyTextureSupport.Copy3D | CopyTextureSupport.TextureToRT | CopyTextureSupport.RTToTexture;
        public static RenderingThreadingMode renderingThreadingMode => RenderingThreadingMode.SingleThreaded;
        public static NPOTSupport npotSupport => NPOTSupport.Full;

        public static GraphicsDeviceType graphicsDeviceType => Info != null ? Player.Limits.Type : GraphicsDeviceType.Null;
        public static string graphicsDeviceName => Info?.Name ?? "Null Device";
        public static string graphicsDeviceVendor => Info?.Vendor ?? "";
        public static string graphicsDeviceVersion => Info == null ? "Null Device" : $"{Info.Api} {Info.Driver}";
        public static int graphicsDeviceID => 0;
        public static int graphicsDeviceVendorID => 0;
        public static int graphicsShaderLevel => Compute ? 50 : 35;
        public static int graphicsMemorySize => Info == null ? 0 : (int)Math.Min(int.MaxValue, Info.MemoryBytes >> 20);

        /// <summary>Bytes: what one binding can cover.</summary>
        public static long maxGraphicsBufferSize
            => Info == null ? 0 : Math.Min(Math.Min(Gpu.MaxResourceBytes, Player.Limits.BufferBytes), Info.MaxBufferBytes);
        public static int maxConstantBufferSize => Player.Limits.ConstantBytes;
        public static int constantBufferOffsetAlignment => 256;
        public static int maxComputeBufferInputsCompute => Compute ? Math.Min(Player.Limits.StorageBuffers, Player.Limits.Buffers) : 0;
        public static int maxComputeBufferInputsVertex => Compute ? Math.Min(Player.Limits.StorageBuffersInGraphics, Player.Limits.Buffers) : 0;
        public static int maxComputeBufferInputsFragment => Compute ? Math.Min(Player.Limits.StorageBuffersInGraphics, Player.Limits.Buffers) : 0;
        public static int maxComputeBufferInputsGeometry => 0;
        public static int maxComputeBufferInputsHull => 0;
        public static int maxComputeBufferInputsDomain => 0;
        public static int maxComputeWorkGroupSize => Compute ? Math.Min(Player.Limits.Threads, Info.MaxGroupInvocations) : 0;
        public static int maxComputeWorkGroupSizeX => Compute ? Math.Min(Player.Limits.Threads, Info.MaxGroupSizeX) : 0;
        public static int maxComputeWorkGroupSizeY => Compute ? Math.Min(Player.Limits.Threads, Info.MaxGroupSizeY) : 0;
        public static int maxComputeWorkGroupSizeZ => Compute ? Math.Min(Player.Limits.ThreadsZ, Info.MaxGroupSizeZ) : 0;
        public static int computeSubGroupSize => Compute ? Info.SubgroupSize : 0;
        public static int supportedRandomWriteTargetCount => Compute ? 8 : 0;
        public static int supportedRenderTargetCount => Info != null ? 4 : 0;
        public static int maxTextureSize => Info == null ? 0 : Math.Min(16384, Info.MaxTexture2D);
        public static int maxTexture3DSize => Info == null ? 0 : Math.Min(2048, Info.MaxTexture3D);
        public static int maxTextureArraySlices => 2048;
        public static int maxCubemapSize => maxTextureSize;
        public static int maxAnisotropyLevel => 16;

        public static string deviceName => Environment.MachineName;
        public static string deviceModel => "Headless";
        public static DeviceType deviceType => Player.Limits.IsHandheld ? DeviceType.Handheld : DeviceType.Desktop;
        public static string deviceUniqueIdentifier => unsupportedIdentifier;
        public static string operatingSystem => Environment.OSVersion.ToString();
        public static string processorType => unsupportedIdentifier;
        public static int processorCount => Environment.ProcessorCount;
        public static int processorFrequency => 0;
        public static int systemMemorySize => (int)Math.Min(int.MaxValue, GC.GetTotalMemory(false) >> 20);
        public static float batteryLevel => -1;

        public static bool SupportsRenderTextureFormat(RenderTextureFormat format)
        {
            if (format == RenderTextureFormat.Depth || format == RenderTextureFormat.Shadowmap)
                return Info != null;
            return Info != null && IsKnown(format);
        }

        public static bool SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat format) =>
            Compute && format != RenderTextureFormat.Depth && format != RenderTextureFormat.Shadowmap && IsKnown(format)
            && (Player.Limits.WritesSmallTexels || !IsSmall(format));

        // WebGPU, "Texture Format Capabilities", and OpenGL ES 3.1, table 8.27: what has no storage there.
        static bool IsSmall(RenderTextureFormat format) => format is RenderTextureFormat.R8 or RenderTextureFormat.RG16 or RenderTextureFormat.R16
            or RenderTextureFormat.RHalf or RenderTextureFormat.RGHalf or RenderTextureFormat.RGB111110Float;

        public static bool SupportsTextureFormat(TextureFormat format)
        {
            switch (format)
            {
                case TextureFormat.Alpha8: case TextureFormat.R8: case TextureFormat.RG16: case TextureFormat.RGB24: case TextureFormat.RGBA32:
                case TextureFormat.ARGB32: case TextureFormat.BGRA32: case TextureFormat.R16: case TextureFormat.RHalf: case TextureFormat.RGHalf:
                case TextureFormat.RGBAHalf: case TextureFormat.RFloat: case TextureFormat.RGFloat: case TextureFormat.RGBAFloat: return Info != null;
                default: return false;
            }
        }

        static bool IsKnown(RenderTextureFormat format)
        {
            switch (format)
            {
                case RenderTextureFormat.RGB565: case RenderTextureFormat.ARGB4444: case RenderTextureFormat.ARGB1555: case RenderTextureFormat.ARGB2101010:
                case RenderTextureFormat.ARGB64: case RenderTextureFormat.RG32: case RenderTextureFormat.RGBAUShort: case RenderTextureFormat.BGRA10101010_XR:
                case RenderTextureFormat.BGR101010_XR: return false;
                default: return true;
            }
        }

        public static GraphicsFormat GetGraphicsFormat(DefaultFormat format) => Formats.Of(format);
        public static int GetRenderTextureSupportedMSAASampleCount(RenderTextureDescriptor desc) => 1;
    }
}
