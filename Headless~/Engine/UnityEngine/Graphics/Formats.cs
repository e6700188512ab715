using System;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>Unity's three families of texture formats, and which of the device's formats holds each.</summary>
    internal static class Formats
    {
        public static GraphicsFormat Of(TextureFormat format, bool linear)
        {
            bool srgb = !linear && Player.LinearColorSpace;
            switch (format)
            {
                case TextureFormat.Alpha8: return GraphicsFormat.R8G8B8A8_UNorm;    // held as (0, 0, 0, a), what A8_UNORM reads as
                case TextureFormat.R8: return GraphicsFormat.R8_UNorm;
                case TextureFormat.RG16: return GraphicsFormat.R8G8_UNorm;
                case TextureFormat.RGB24:
                case TextureFormat.RGBA32:
                case TextureFormat.ARGB32: return srgb ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
                case TextureFormat.BGRA32: return srgb ? GraphicsFormat.B8G8R8A8_SRGB : GraphicsFormat.B8G8R8A8_UNorm;
                case TextureFormat.R16: return GraphicsFormat.R16_UNorm;
                case TextureFormat.RHalf: return GraphicsFormat.R16_SFloat;
                case TextureFormat.RGHalf: return GraphicsFormat.R16G16_SFloat;
                case TextureFormat.RGBAHalf: return GraphicsFormat.R16G16B16A16_SFloat;
                case TextureFormat.RFloat: return GraphicsFormat.R32_SFloat;
                case TextureFormat.RGFloat: return GraphicsFormat.R32G32_SFloat;
                case TextureFormat.RGBAFloat: return GraphicsFormat.R32G32B32A32_SFloat;
                default: throw new NotSupportedException($"TextureFormat.{format} is not supported by the headless host.");
            }
        }

        public static GraphicsFormat Of(RenderTextureFormat format, RenderTextureReadWrite readWrite)
        {
            bool srgb = readWrite == RenderTextureReadWrite.sRGB && Player.LinearColorSpace;
            switch (format)
            {
                case RenderTextureFormat.Default:
                case RenderTextureFormat.ARGB32: return srgb ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
                case RenderTextureFormat.BGRA32: return srgb ? GraphicsFormat.B8G8R8A8_SRGB : GraphicsFormat.B8G8R8A8_UNorm;
                case RenderTextureFormat.DefaultHDR:
                case RenderTextureFormat.ARGBHalf: return GraphicsFormat.R16G16B16A16_SFloat;
                case RenderTextureFormat.ARGBFloat: return GraphicsFormat.R32G32B32A32_SFloat;
                case RenderTextureFormat.RGFloat: return GraphicsFormat.R32G32_SFloat;
                case RenderTextureFormat.RGHalf: return GraphicsFormat.R16G16_SFloat;
                case RenderTextureFormat.RFloat: return GraphicsFormat.R32_SFloat;
                case RenderTextureFormat.RHalf: return GraphicsFormat.R16_SFloat;
                case RenderTextureFormat.R8: return GraphicsFormat.R8_UNorm;
                case RenderTextureFormat.R16: return GraphicsFormat.R16_UNorm;
                case RenderTextureFormat.RG16: return GraphicsFormat.R8G8_UNorm;
                case RenderTextureFormat.ARGBInt: return GraphicsFormat.R32G32B32A32_SInt;
                case RenderTextureFormat.RGInt: return GraphicsFormat.R32G32_SInt;
                case RenderTextureFormat.RInt: return GraphicsFormat.R32_SInt;
                case RenderTextureFormat.RGB111110Float: return GraphicsFormat.B10G11R11_UFloatPack32;
                case RenderTextureFormat.Depth:
                case RenderTextureFormat.Shadowmap: return GraphicsFormat.None;
                default: throw new NotSupportedException($"RenderTextureFormat.{format} is not supported by the headless host.");
            }
        }

        public static RenderTextureFormat ToRenderTextureFormat(GraphicsFormat format)
        {
            switch (format)
            {
                case GraphicsFormat.None: return RenderTextureFormat.Depth;
                case GraphicsFormat.B8G8R8A8_UNorm:
                case GraphicsFormat.B8G8R8A8_SRGB: return RenderTextureFormat.BGRA32;
                case GraphicsFormat.R16G16B16A16_SFloat: return RenderTextureFormat.ARGBHalf;
                case GraphicsFormat.R32G32B32A32_SFloat: return RenderTextureFormat.ARGBFloat;
                case GraphicsFormat.R32G32_SFloat: return RenderTextureFormat.RGFloat;
                case GraphicsFormat.R16G16_SFloat: return RenderTextureFormat.RGHalf;
                case GraphicsFormat.R32_SFloat: return RenderTextureFormat.RFloat;
                case GraphicsFormat.R16_SFloat: return RenderTextureFormat.RHalf;
                case GraphicsFormat.R8_UNorm: return RenderTextureFormat.R8;
                case GraphicsFormat.R8G8_UNorm: return RenderTextureFormat.RG16;
                case GraphicsFormat.R16_UNorm: return RenderTextureFormat.R16;
                case GraphicsFormat.R32G32B32A32_SInt: return RenderTextureFormat.ARGBInt;
                case GraphicsFormat.R32G32_SInt: return RenderTextureFormat.RGInt;
                case GraphicsFormat.R32_SInt: return RenderTextureFormat.RInt;
                case GraphicsFormat.B10G11R11_UFloatPack32: return RenderTextureFormat.RGB111110Float;
                default: return RenderTextureFormat.ARGB32;
            }
        }

        public static TextureFormat ToTextureFormat(GraphicsFormat format)
        {
            switch (format)
            {
                case GraphicsFormat.R8_UNorm: return TextureFormat.R8;
                case GraphicsFormat.R8G8_UNorm: return TextureFormat.RG16;
                case GraphicsFormat.R8G8B8A8_UNorm:
                case GraphicsFormat.R8G8B8A8_SRGB: return TextureFormat.RGBA32;
                case GraphicsFormat.B8G8R8A8_UNorm:
                case GraphicsFormat.B8G8R8A8_SRGB: return TextureFormat.BGRA32;
                case GraphicsFormat.R16_UNorm: return TextureFormat.R16;
                case GraphicsFormat.R16_SFloat: return TextureFormat.RHalf;
                case GraphicsFormat.R16G16_SFloat: return TextureFormat.RGHalf;
                case GraphicsFormat.R16G16B16A16_SFloat: return TextureFormat.RGBAHalf;
                case GraphicsFormat.R32_SFloat: return TextureFormat.RFloat;
                case GraphicsFormat.R32G32_SFloat: return TextureFormat.RGFloat;
                case GraphicsFormat.R32G32B32A32_SFloat: return TextureFormat.RGBAFloat;
                default: throw new NotSupportedException($"No TextureFormat stands for GraphicsFormat.{format}.");
            }
        }

        public static GraphicsFormat Of(DefaultFormat format)
        {
            switch (format)
            {
                case DefaultFormat.HDR: return GraphicsFormat.R16G16B16A16_SFloat;
                case DefaultFormat.DepthStencil: return GraphicsFormat.D32_SFloat_S8_UInt;
                case DefaultFormat.Shadow: return GraphicsFormat.D32_SFloat;
                default: return Player.LinearColorSpace ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
            }
        }

        public static GraphicsFormat OfDepthBits(int bits) =>
            bits <= 0 ? GraphicsFormat.None : bits <= 16 ? GraphicsFormat.D16_UNorm : bits <= 24 ? GraphicsFormat.D24_UNorm_S8_UInt
            : GraphicsFormat.D32_SFloat_S8_UInt;

        public static int DepthBits(GraphicsFormat format)
        {
            switch (format)
            {
                case GraphicsFormat.None: return 0;
                case GraphicsFormat.D16_UNorm:
                case GraphicsFormat.D16_UNorm_S8_UInt: return 16;
                case GraphicsFormat.D24_UNorm:
                case GraphicsFormat.D24_UNorm_S8_UInt: return 24;
                default: return 32;
            }
        }

        public static bool IsDepth(GraphicsFormat format) => format >= GraphicsFormat.D16_UNorm && format <= GraphicsFormat.S8_UInt
            || format == GraphicsFormat.D16_UNorm_S8_UInt;

        public static bool IsSrgb(GraphicsFormat format) =>
            format >= GraphicsFormat.R8_SRGB && format <= GraphicsFormat.R8G8B8A8_SRGB || format == GraphicsFormat.B8G8R8A8_SRGB;

        public static bool TryDevice(GraphicsFormat format, out DeviceFormat device)
        {
            switch (format)
            {
                case GraphicsFormat.R8_UNorm: device = DeviceFormat.R8_UNorm; return true;
                case GraphicsFormat.R8G8_UNorm: device = DeviceFormat.RG8_UNorm; return true;
                case GraphicsFormat.R8G8B8A8_UNorm: device = DeviceFormat.RGBA8_UNorm; return true;
                case GraphicsFormat.R8G8B8A8_SRGB: device = DeviceFormat.RGBA8_SRGB; return true;
                case GraphicsFormat.B8G8R8A8_UNorm: device = DeviceFormat.BGRA8_UNorm; return true;
                case GraphicsFormat.B8G8R8A8_SRGB: device = DeviceFormat.BGRA8_SRGB; return true;
                case GraphicsFormat.R16_UNorm: device = DeviceFormat.R16_UNorm; return true;
                case GraphicsFormat.R16_SFloat: device = DeviceFormat.R16_Float; return true;
                case GraphicsFormat.R16G16_SFloat: device = DeviceFormat.RG16_Float; return true;
                case GraphicsFormat.R16G16B16A16_SFloat: device = DeviceFormat.RGBA16_Float; return true;
                case GraphicsFormat.R32_SFloat: device = DeviceFormat.R32_Float; return true;
                case GraphicsFormat.R32G32_SFloat: device = DeviceFormat.RG32_Float; return true;
                case GraphicsFormat.R32G32B32A32_SFloat: device = DeviceFormat.RGBA32_Float; return true;
                case GraphicsFormat.R32_UInt: device = DeviceFormat.R32_UInt; return true;
                case GraphicsFormat.R32G32_UInt: device = DeviceFormat.RG32_UInt; return true;
                case GraphicsFormat.R32G32B32A32_UInt: device = DeviceFormat.RGBA32_UInt; return true;
                case GraphicsFormat.R32_SInt: device = DeviceFormat.R32_SInt; return true;
                case GraphicsFormat.R32G32_SInt: device = DeviceFormat.RG32_SInt; return true;
                case GraphicsFormat.R32G32B32A32_SInt: device = DeviceFormat.RGBA32_SInt; return true;
                case GraphicsFormat.B10G11R11_UFloatPack32: device = DeviceFormat.R11G11B10_Float; return true;
                // One depth format behind all: more precise than asked for never breaks a depth test.
                case GraphicsFormat.D16_UNorm:
                case GraphicsFormat.D24_UNorm:
                case GraphicsFormat.D32_SFloat: device = DeviceFormat.D32_Float; return true;
                case GraphicsFormat.D16_UNorm_S8_UInt:
                case GraphicsFormat.D24_UNorm_S8_UInt:
                case GraphicsFormat.D32_SFloat_S8_UInt: device = DeviceFormat.D32_S8; return true;
                default: device = DeviceFormat.None; return false;
            }
        }

        public static DeviceFormat Device(GraphicsFormat format) =>
            TryDevice(format, out DeviceFormat device) ? device
            : throw new NotSupportedException($"GraphicsFormat.{format} is not supported by the headless host.");

        /// <summary>Bytes of a texel in the device's memory.</summary>
        public static int TexelBytes(DeviceFormat format)
        {
            switch (format)
            {
                case DeviceFormat.R8_UNorm: return 1;
                case DeviceFormat.RG8_UNorm:
                case DeviceFormat.R16_UNorm:
                case DeviceFormat.R16_Float:
                case DeviceFormat.D16_UNorm: return 2;
                case DeviceFormat.RGBA16_Float:
                case DeviceFormat.RG32_Float:
                case DeviceFormat.RG32_UInt:
                case DeviceFormat.RG32_SInt: return 8;
                case DeviceFormat.RGBA32_Float:
                case DeviceFormat.RGBA32_UInt:
                case DeviceFormat.RGBA32_SInt: return 16;
                default: return 4;
            }
        }

        /// <summary>Bytes of a texel in the memory that scripts see.</summary>
        public static int TexelBytes(TextureFormat format)
        {
            switch (format)
            {
                case TextureFormat.Alpha8: return 1;
                case TextureFormat.RGB24: return 3;
                default: return TexelBytes(Device(Of(format, linear: true)));
            }
        }
    }
}
