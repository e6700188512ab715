using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary>Making and freeing of buffers, textures, their views, and samplers.</summary>
    sealed unsafe partial class VulkanDevice
    {
        readonly Dictionary<DeviceSampler, VkSampler> samplers = new();
        int ownBuffers;

        // ---- buffers

        public DeviceBuffer CreateBuffer(string name, long bytes)
        {
            if (bytes <= 0) throw new ArgumentOutOfRangeException(nameof(bytes), bytes, $"Buffer '{name}' must have at least one byte.");
            bytes = (bytes + 3) & ~3L;
            if ((ulong)bytes > maxBufferBytes)
                throw new OutOfGpuMemoryException($"Buffer '{name}' of {bytes:N0} bytes is larger than any that {Info.Name} can make: " +
                    $"{maxBufferBytes:N0} bytes. Split it.");
            // Every use, since Unity's side decides late; drivers in question do not charge for it.
            const VkBufferUsageFlags any = VkBufferUsageFlags.TRANSFER_SRC | VkBufferUsageFlags.TRANSFER_DST | VkBufferUsageFlags.STORAGE_BUFFER
                | VkBufferUsageFlags.UNIFORM_BUFFER | VkBufferUsageFlags.UNIFORM_TEXEL_BUFFER | VkBufferUsageFlags.STORAGE_TEXEL_BUFFER
                | VkBufferUsageFlags.INDEX_BUFFER | VkBufferUsageFlags.VERTEX_BUFFER | VkBufferUsageFlags.INDIRECT_BUFFER;
            return CreateBuffer(name, bytes, any, MemoryUse.Device);
        }

        internal VulkanBuffer CreateHostBuffer(string name, ulong bytes, MemoryUse use)
            => CreateBuffer(name, (long)bytes, use switch
            {
                MemoryUse.Constants => VkBufferUsageFlags.UNIFORM_BUFFER | VkBufferUsageFlags.STORAGE_BUFFER,
                MemoryUse.Readback => VkBufferUsageFlags.TRANSFER_DST,
                _ => VkBufferUsageFlags.TRANSFER_SRC,
            }, use);

        VulkanBuffer CreateBuffer(string name, long bytes, VkBufferUsageFlags usage, MemoryUse use)
        {
            var info = new VkBufferCreateInfo { size = (ulong)bytes, usage = usage, sharingMode = VkSharingMode.EXCLUSIVE };
            VkBuffer handle;
            Check(vk.CreateBuffer(device, &info, null, &handle), $"vkCreateBuffer of {bytes:N0} bytes for '{name}'");
            VkMemoryRequirements need;
            vk.GetBufferMemoryRequirements(device, handle, &need);
            GpuAllocation allocation;
            try { allocation = Allocate(need, use, image: false, $"Buffer '{name}'"); }
            catch (OutOfGpuMemoryException) { vk.DestroyBuffer(device, handle, null); throw; }
            Check(vk.BindBufferMemory(device, handle, allocation.Block.Memory, allocation.Offset), "vkBindBufferMemory");
            SetName(VkObjectType.BUFFER, (ulong)handle, name);
            var buffer = new VulkanBuffer(this, name, bytes, handle, allocation, isOwn: use != MemoryUse.Device);
            Register(buffer);
            if (buffer.IsOwn) ownBuffers++;
            return buffer;
        }

        /// <summary>When memory is short, what the stream still holds is waited for before giving up.</summary>
        GpuAllocation Allocate(in VkMemoryRequirements need, MemoryUse use, bool image, string what)
        {
            try { return memory.Allocate(need, use, image, what); }
            catch (OutOfGpuMemoryException) when (use == MemoryUse.Device && retired.Count > 0)
            {
                WaitIdle();
                return memory.Allocate(need, use, image, what);
            }
        }

        internal VkBufferView CreateTexelView(VulkanBuffer buffer, VkFormat format)
        {
            var info = new VkBufferViewCreateInfo { buffer = buffer.Handle, format = format, range = Vk.VK_WHOLE_SIZE };
            VkBufferView view;
            Check(vk.CreateBufferView(device, &info, null, &view), $"vkCreateBufferView of '{buffer.Name}' as {format}");
            return view;
        }

        internal void Free(VulkanBuffer buffer, Dictionary<VkFormat, VkBufferView> views)
        {
            if (views != null)
                foreach (var view in views.Values) vk.DestroyBufferView(device, view, null);
            vk.DestroyBuffer(device, buffer.Handle, null);
            memory.Free(buffer.Memory);
            if (buffer.IsOwn) ownBuffers--;
        }

        // ---- textures

        public DeviceTexture CreateTexture(in DeviceTextureDescription wanted)
        {
            var d = wanted;
            d.Depth = Math.Max(1, d.Depth);
            d.Slices = Math.Max(1, d.Slices);
            d.Mips = Math.Max(1, d.Mips);
            d.Samples = Math.Max(1, d.Samples);
            if (d.Samples > 1) throw new NotSupportedException($"Texture '{d.Name}': multisampling is not supported; ask for 1 sample.");
            bool is3D = d.Dimension == DeviceTextureDimension.Tex3D;
            uint limit = is3D ? limits.maxImageDimension3D : limits.maxImageDimension2D;
            if (d.Width < 1 || d.Height < 1 || Math.Max(d.Width, Math.Max(d.Height, is3D ? d.Depth : 1)) > limit)
                throw new ArgumentException($"Texture '{d.Name}' of {d.Width} x {d.Height} x {d.Depth}: sides are 1 to {limit} on {Info.Name}.");
            int layers = is3D ? 1 : d.Dimension == DeviceTextureDimension.Cube ? 6 : d.Slices;
            var format = GpuFormat.Of(d.Format);
            if (format.Vulkan == VkFormat.UNDEFINED) throw new ArgumentException($"Texture '{d.Name}' has no format.");
            RequireFormat(d, format);

            var usage = VkImageUsageFlags.TRANSFER_SRC | VkImageUsageFlags.TRANSFER_DST | VkImageUsageFlags.SAMPLED;
            if (d.RandomWrite) usage |= VkImageUsageFlags.STORAGE;
            if (d.Target) usage |= format.IsDepth ? VkImageUsageFlags.DEPTH_STENCIL_ATTACHMENT : VkImageUsageFlags.COLOR_ATTACHMENT;
            VkImageCreateFlags flags = 0;
            if (d.Dimension == DeviceTextureDimension.Cube || d.Dimension == DeviceTextureDimension.CubeArray)
                flags |= VkImageCreateFlags.CUBE_COMPATIBLE;
            if (is3D && d.Target) flags |= VkImageCreateFlags._2D_ARRAY_COMPATIBLE;
            var info = new VkImageCreateInfo
            {
                flags = flags, imageType = is3D ? VkImageType._3D : VkImageType._2D, format = format.Vulkan,
                extent = new VkExtent3D { width = (uint)d.Width, height = (uint)d.Height, depth = is3D ? (uint)d.Depth : 1 },
                mipLevels = (uint)d.Mips, arrayLayers = (uint)layers, samples = VkSampleCountFlags._1, tiling = VkImageTiling.OPTIMAL,
                usage = usage, sharingMode = VkSharingMode.EXCLUSIVE, initialLayout = VkImageLayout.UNDEFINED,
            };
            VkImage image;
            Check(vk.CreateImage(device, &info, null, &image), $"vkCreateImage '{d.Name}', {d.Format} {d.Width} x {d.Height} x {d.Depth}");
            VkMemoryRequirements need;
            vk.GetImageMemoryRequirements(device, image, &need);
            GpuAllocation allocation;
            try { allocation = Allocate(need, MemoryUse.Device, image: true, $"Texture '{d.Name}'"); }
            catch (OutOfGpuMemoryException) { vk.DestroyImage(device, image, null); throw; }
            Check(vk.BindImageMemory(device, image, allocation.Block.Memory, allocation.Offset), "vkBindImageMemory");
            SetName(VkObjectType.IMAGE, (ulong)image, d.Name);

            var texture = new VulkanTexture(this, d, layers, image, allocation);
            Register(texture);
            BeginOperation();
            SuspendPass();
            BarrierForBirth(image, format.Aspects);
            texture.Usage.LastSubmission = nextSubmission;
            return texture;
        }

        void RequireFormat(in DeviceTextureDescription d, in GpuFormat format)
        {
            VkFormatProperties p;
            instance.Commands.GetPhysicalDeviceFormatProperties(physical, format.Vulkan, &p);
            var need = VkFormatFeatureFlags.SAMPLED_IMAGE;
            if (d.RandomWrite) need |= VkFormatFeatureFlags.STORAGE_IMAGE;
            if (d.Target) need |= format.IsDepth ? VkFormatFeatureFlags.DEPTH_STENCIL_ATTACHMENT : VkFormatFeatureFlags.COLOR_ATTACHMENT;
            var lacking = need & ~p.optimalTilingFeatures;
            if (lacking != 0)
                throw new NotSupportedException(
                $"Texture '{d.Name}': {Info.Name} cannot use {d.Format} as {lacking}. Choose another format.");
        }

        internal VkImageView CreateView(VulkanTexture texture, VkImageViewType type, int mip, int mips, int layer, int layers)
        {
            var info = new VkImageViewCreateInfo
            {
                image = texture.Handle, viewType = type, format = texture.Format.Vulkan,
                subresourceRange = new VkImageSubresourceRange
                {
                    aspectMask = texture.Format.ViewAspect, baseMipLevel = (uint)mip, levelCount = (uint)mips, baseArrayLayer = (uint)layer,
                        layerCount = (uint)layers,
                },
            };
            VkImageView view;
            Check(vk.CreateImageView(device, &info, null, &view), $"vkCreateImageView of '{texture.Name}' as {type}");
            return view;
        }

        internal void Free(VulkanTexture texture, IEnumerable<VkImageView> views)
        {
            foreach (var view in views) vk.DestroyImageView(device, view, null);
            vk.DestroyImage(device, texture.Handle, null);
            memory.Free(texture.Memory);
        }

        /// <summary>The texture as the shader declares it: Unity lets one image serve as a slice, an array or a cube.</summary>
        VkImageView ViewFor(VulkanTexture t, DeviceTextureDimension wanted, int mip, int mips, bool storage, string program, string resource)
        {
            var have = t.Description.Dimension;
            if (wanted == DeviceTextureDimension.Tex3D == t.Is3D
                && (wanted != DeviceTextureDimension.Cube && wanted != DeviceTextureDimension.CubeArray || have == wanted))
                return wanted switch
                {
                    DeviceTextureDimension.Tex2D => t.View(VkImageViewType._2D, mip, mips, 0, 1),
                    DeviceTextureDimension.Tex3D => t.View(VkImageViewType._3D, mip, mips, 0, 1),
                    DeviceTextureDimension.Cube when !storage => t.View(VkImageViewType.CUBE, mip, mips, 0, 6),
                    DeviceTextureDimension.CubeArray when !storage => t.View(VkImageViewType.CUBE_ARRAY, mip, mips, 0, t.Layers),
                    _ => t.View(VkImageViewType._2D_ARRAY, mip, mips, 0, t.Layers),
                };
            throw new ArgumentException($"{program}: '{resource}' is declared as {wanted} and the texture bound to it, '{t.Name}', is {have}.");
        }

        // ---- samplers

        VkSampler SamplerFor(in DeviceSampler s)
        {
            if (samplers.TryGetValue(s, out var sampler)) return sampler;
            var filter = s.Linear ? VkFilter.LINEAR : VkFilter.NEAREST;
            bool anisotropic = s.Anisotropy > 1 && hasAnisotropy;
            var info = new VkSamplerCreateInfo
            {
                magFilter = filter, minFilter = filter, mipmapMode = s.LinearMip ? VkSamplerMipmapMode.LINEAR : VkSamplerMipmapMode.NEAREST,
                addressModeU = Address(s.U), addressModeV = Address(s.V), addressModeW = Address(s.W), maxLod = Vk.VK_LOD_CLAMP_NONE,
                anisotropyEnable = anisotropic ? VkBool32.True : VkBool32.False, maxAnisotropy = anisotropic
                    ? Math.Min(s.Anisotropy, limits.maxSamplerAnisotropy) : 1,
                // With reversed depth what is nearer is greater.
                compareEnable = s.Comparison ? VkBool32.True : VkBool32.False, compareOp = VkCompareOp.GREATER_OR_EQUAL,
            };
            VkSampler made;
            Check(vk.CreateSampler(device, &info, null, &made), "vkCreateSampler");
            return samplers[s] = made;
        }

        VkSamplerAddressMode Address(DeviceWrap wrap) => wrap switch
        {
            DeviceWrap.Repeat => VkSamplerAddressMode.REPEAT,
            DeviceWrap.Clamp => VkSamplerAddressMode.CLAMP_TO_EDGE,
            DeviceWrap.Mirror => VkSamplerAddressMode.MIRRORED_REPEAT,
            _ => hasMirrorOnce ? VkSamplerAddressMode.MIRROR_CLAMP_TO_EDGE
                : throw new NotSupportedException($"{Info.Name} has no mirror-once wrap mode."),
        };

        void DestroySamplers()
        {
            foreach (var sampler in samplers.Values) vk.DestroySampler(device, sampler, null);
        }
    }
}
