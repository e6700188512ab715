using System;
using UnityEngine.Headless;

namespace Host.Vulkan
{
    internal enum NumericKind { Float, UInt, SInt }

    /// <summary>Vulkan's name of a <see cref="DeviceFormat"/>, and its size.</summary>
    internal readonly struct GpuFormat
    {
        public readonly VkFormat Vulkan;
        public readonly int TexelBytes;
        public readonly NumericKind Numeric;
        public readonly VkImageAspectFlags Aspects;

        GpuFormat(VkFormat vulkan, int texelBytes, NumericKind numeric = NumericKind.Float, VkImageAspectFlags aspects = VkImageAspectFlags.COLOR)
            => (Vulkan, TexelBytes, Numeric, Aspects) = (vulkan, texelBytes, numeric, aspects);

        public bool IsDepth => (Aspects & VkImageAspectFlags.DEPTH) != 0;

        /// <summary>Copies and views see the depth of a depth-stencil format alone.</summary>
        public VkImageAspectFlags ViewAspect => IsDepth ? VkImageAspectFlags.DEPTH : VkImageAspectFlags.COLOR;

        public static GpuFormat Of(DeviceFormat format) => Table[(int)format];

        static readonly GpuFormat[] Table = Build();

        static GpuFormat[] Build()
        {
            var table = new GpuFormat[Enum.GetValues<DeviceFormat>().Length];
            foreach (var format in Enum.GetValues<DeviceFormat>())
            {
                table[(int)format] = format switch
                {
                    DeviceFormat.None => default,
                    DeviceFormat.R8_UNorm => new GpuFormat(VkFormat.R8_UNORM, 1),
                    DeviceFormat.RG8_UNorm => new GpuFormat(VkFormat.R8G8_UNORM, 2),
                    DeviceFormat.RGBA8_UNorm => new GpuFormat(VkFormat.R8G8B8A8_UNORM, 4),
                    DeviceFormat.RGBA8_SRGB => new GpuFormat(VkFormat.R8G8B8A8_SRGB, 4),
                    DeviceFormat.BGRA8_UNorm => new GpuFormat(VkFormat.B8G8R8A8_UNORM, 4),
                    DeviceFormat.BGRA8_SRGB => new GpuFormat(VkFormat.B8G8R8A8_SRGB, 4),
                    DeviceFormat.R16_UNorm => new GpuFormat(VkFormat.R16_UNORM, 2),
                    DeviceFormat.R16_Float => new GpuFormat(VkFormat.R16_SFLOAT, 2),
                    DeviceFormat.RG16_Float => new GpuFormat(VkFormat.R16G16_SFLOAT, 4),
                    DeviceFormat.RGBA16_Float => new GpuFormat(VkFormat.R16G16B16A16_SFLOAT, 8),
                    DeviceFormat.R32_Float => new GpuFormat(VkFormat.R32_SFLOAT, 4),
                    DeviceFormat.RG32_Float => new GpuFormat(VkFormat.R32G32_SFLOAT, 8),
                    DeviceFormat.RGBA32_Float => new GpuFormat(VkFormat.R32G32B32A32_SFLOAT, 16),
                    DeviceFormat.R32_UInt => new GpuFormat(VkFormat.R32_UINT, 4, NumericKind.UInt),
                    DeviceFormat.RG32_UInt => new GpuFormat(VkFormat.R32G32_UINT, 8, NumericKind.UInt),
                    DeviceFormat.RGBA32_UInt => new GpuFormat(VkFormat.R32G32B32A32_UINT, 16, NumericKind.UInt),
                    DeviceFormat.R32_SInt => new GpuFormat(VkFormat.R32_SINT, 4, NumericKind.SInt),
                    DeviceFormat.RG32_SInt => new GpuFormat(VkFormat.R32G32_SINT, 8, NumericKind.SInt),
                    DeviceFormat.RGBA32_SInt => new GpuFormat(VkFormat.R32G32B32A32_SINT, 16, NumericKind.SInt),
                    DeviceFormat.RGB32_Float => new GpuFormat(VkFormat.R32G32B32_SFLOAT, 12),
                    DeviceFormat.R11G11B10_Float => new GpuFormat(VkFormat.B10G11R11_UFLOAT_PACK32, 4),
                    DeviceFormat.D16_UNorm => new GpuFormat(VkFormat.D16_UNORM, 2, NumericKind.Float, VkImageAspectFlags.DEPTH),
                    DeviceFormat.D32_Float => new GpuFormat(VkFormat.D32_SFLOAT, 4, NumericKind.Float, VkImageAspectFlags.DEPTH),
                    // Depth is read back as 32-bit floats on every device, which Vulkan's own D24 would not give.
                    DeviceFormat.D24_S8 => new GpuFormat(VkFormat.D32_SFLOAT_S8_UINT, 4, NumericKind.Float,
                        VkImageAspectFlags.DEPTH | VkImageAspectFlags.STENCIL),
                    DeviceFormat.D32_S8 => new GpuFormat(VkFormat.D32_SFLOAT_S8_UINT, 4, NumericKind.Float,
                        VkImageAspectFlags.DEPTH | VkImageAspectFlags.STENCIL),
                    _ => throw new NotSupportedException($"Format {format} has no Vulkan format in {nameof(GpuFormat)}."),
                };
            }
            return table;
        }
    }
}
