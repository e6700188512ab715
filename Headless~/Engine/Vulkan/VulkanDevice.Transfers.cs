using System;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    sealed unsafe partial class VulkanDevice
    {
        /// <summary>Large transfers go in pieces, so that staging memory stays small and the GPU copies one while the CPU copies the next.</summary>
        const int PieceBytes = 16 << 20;
        const long UploadsPerSubmission = 64 << 20;

        long uploadBytesRecorded;

        public void Upload(DeviceBuffer target, long offset, ReadOnlySpan<byte> data)
        {
            var buffer = (VulkanBuffer)target;
            CheckRange(buffer, offset, data.Length, "upload to");
            while (data.Length > 0)
            {
                var piece = data.Slice(0, Math.Min(PieceBytes, data.Length));
                BeginTransfer();
                Touch(buffer.Usage, Scope.Transfer, writes: true);
                Order();
                piece.CopyTo(new Span<byte>(uploads.Take((ulong)piece.Length, 16, out var source, out ulong sourceOffset), piece.Length));
                CopyBytes(source, sourceOffset, buffer.Handle, (ulong)offset, (ulong)piece.Length);
                uploadBytesRecorded += piece.Length;
                data = data.Slice(piece.Length);
                offset += piece.Length;
            }
        }

        public void Fill(DeviceBuffer target, long offset, long bytes, uint word)
        {
            var buffer = (VulkanBuffer)target;
            CheckRange(buffer, offset, bytes, "fill");
            if (((offset | bytes) & 3) != 0)
                throw new ArgumentException($"Buffer '{buffer.Name}': fills whole 32-bit words, not {bytes} bytes at {offset}.");
            if (bytes == 0) return;
            BeginTransfer();
            Touch(buffer.Usage, Scope.Transfer, writes: true);
            Order();
            vk.CmdFillBuffer(commands, buffer.Handle, (ulong)offset, (ulong)bytes, word);
        }

        public void Copy(DeviceBuffer source, long sourceOffset, DeviceBuffer target, long targetOffset, long bytes)
        {
            var (from, to) = ((VulkanBuffer)source, (VulkanBuffer)target);
            CheckRange(from, sourceOffset, bytes, "copy from");
            CheckRange(to, targetOffset, bytes, "copy to");
            if (bytes == 0) return;
            if (from == to && sourceOffset < targetOffset + bytes && targetOffset < sourceOffset + bytes)
                throw new ArgumentException($"Buffer '{from.Name}': the {bytes} bytes copied from {sourceOffset} to {targetOffset} overlap.");
            BeginTransfer();
            Touch(from.Usage, Scope.Transfer, writes: false);
            Touch(to.Usage, Scope.Transfer, writes: true);
            Order();
            CopyBytes(from.Handle, (ulong)sourceOffset, to.Handle, (ulong)targetOffset, (ulong)bytes);
        }

        public void UploadTexture(DeviceTexture target, int mip, int slice, ReadOnlySpan<byte> texels)
        {
            var texture = (VulkanTexture)target;
            CheckLevel(texture, mip, slice);
            if (texels.Length != texture.SliceBytes(mip))
                throw new ArgumentException(
                    $"Texture '{texture.Name}': level {mip} has {texture.SliceBytes(mip):N0} bytes and {texels.Length:N0} were given.");
            BeginTransfer();
            Touch(texture.Usage, Scope.Transfer, writes: true);
            Order();
            texels.CopyTo(new Span<byte>(uploads.Take((ulong)texels.Length, 16, out var source, out ulong offset), texels.Length));
            var region = Region(texture, mip, slice, offset);
            vk.CmdCopyBufferToImage(commands, source, texture.Handle, VkImageLayout.GENERAL, 1, &region);
            uploadBytesRecorded += texels.Length;
        }

        public void ClearTexture(DeviceTexture target, in DeviceColor color)
        {
            var texture = (VulkanTexture)target;
            BeginTransfer();
            Touch(texture.Usage, Scope.Transfer, writes: true);
            Order();
            var range = new VkImageSubresourceRange
            {
                aspectMask = texture.Format.Aspects, levelCount = Vk.VK_REMAINING_MIP_LEVELS, layerCount = Vk.VK_REMAINING_ARRAY_LAYERS,
            };
            if (texture.Format.IsDepth)
            {
                var depth = new VkClearDepthStencilValue { depth = color.R };
                vk.CmdClearDepthStencilImage(commands, texture.Handle, VkImageLayout.GENERAL, &depth, 1, &range);
                return;
            }
            var value = ClearValue(texture.Format, color);
            vk.CmdClearColorImage(commands, texture.Handle, VkImageLayout.GENERAL, &value, 1, &range);
        }

        public void CopyTexture(DeviceTexture source, DeviceTexture target)
        {
            var (from, to) = ((VulkanTexture)source, (VulkanTexture)target);
            var (a, b) = (from.Description, to.Description);
            if (a.Format != b.Format || a.Width != b.Width || a.Height != b.Height || a.Depth != b.Depth || from.Layers != to.Layers)
                throw new ArgumentException($"Textures '{from.Name}' ({a.Format} {a.Width} x {a.Height} x {a.Depth}) and '{to.Name}' " +
                    $"({b.Format} {b.Width} x {b.Height} x {b.Depth}) differ, so one cannot be copied to the other.");
            BeginTransfer();
            Touch(from.Usage, Scope.Transfer, writes: false);
            Touch(to.Usage, Scope.Transfer, writes: true);
            Order();
            var layers = new VkImageSubresourceLayers { aspectMask = from.Format.Aspects, layerCount = (uint)from.Layers };
            var region = new VkImageCopy { srcSubresource = layers, dstSubresource = layers, extent = Extent(from, 0) };
            vk.CmdCopyImage(commands, from.Handle, VkImageLayout.GENERAL, to.Handle, VkImageLayout.GENERAL, 1, &region);
        }

        void BeginTransfer()
        {
            BeginOperation();
            SuspendPass();
        }

        void CopyBytes(VkBuffer source, ulong sourceOffset, VkBuffer target, ulong targetOffset, ulong bytes)
        {
            var region = new VkBufferCopy { srcOffset = sourceOffset, dstOffset = targetOffset, size = bytes };
            vk.CmdCopyBuffer(commands, source, target, 1, &region);
        }

        static VkBufferImageCopy Region(VulkanTexture texture, int mip, int slice, ulong offset) => new()
        {
            bufferOffset = offset,
            imageSubresource = new VkImageSubresourceLayers { aspectMask = texture.Format.ViewAspect, mipLevel = (uint)mip,
                baseArrayLayer = (uint)slice, layerCount = 1 },
            imageExtent = Extent(texture, mip),
        };

        static VkExtent3D Extent(VulkanTexture texture, int mip)
            => new() { width = (uint)texture.Width(mip), height = (uint)texture.Height(mip), depth = (uint)texture.Depth(mip) };

        /// <summary>Integer formats take the color as numbers, not as fractions.</summary>
        static VkClearColorValue ClearValue(in GpuFormat format, in DeviceColor c)
        {
            var value = new VkClearColorValue();
            ReadOnlySpan<float> channels = stackalloc float[] { c.R, c.G, c.B, c.A };
            for (int i = 0; i < 4; i++)
                switch (format.Numeric)
                {
                    case NumericKind.UInt: value.uint32[i] = (uint)channels[i]; break;
                    case NumericKind.SInt: value.int32[i] = (int)channels[i]; break;
                    default: value.float32[i] = channels[i]; break;
                }
            return value;
        }

        static void CheckRange(VulkanBuffer buffer, long offset, long bytes, string what)
        {
            if (buffer.IsDisposed) throw new ObjectDisposedException(buffer.Name, $"Cannot {what} buffer '{buffer.Name}': it was released.");
            if (offset < 0 || bytes < 0 || offset + bytes > buffer.Bytes)
                throw new ArgumentOutOfRangeException(null,
                    $"Cannot {what} bytes {offset} to {offset + bytes} of buffer '{buffer.Name}', which has {buffer.Bytes}.");
        }

        static void CheckLevel(VulkanTexture texture, int mip, int slice)
        {
            if (texture.IsDisposed) throw new ObjectDisposedException(texture.Name, $"Texture '{texture.Name}' was released.");
            if (mip < 0 || mip >= texture.Description.Mips || slice < 0 || slice >= texture.Layers)
                throw new ArgumentOutOfRangeException(null, $"Texture '{texture.Name}' has {texture.Description.Mips} levels and " +
                    $"{texture.Layers} slices; level {mip}, slice {slice} was asked for.");
        }
    }
}
