using System;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;
using NativeMemory = System.Runtime.InteropServices.NativeMemory;

namespace Host.Vulkan
{
    /// <summary>From <see cref="DeviceBinding"/>s to descriptors: pushed into the command buffer, so that no set is ever allocated.</summary>
    sealed unsafe partial class VulkanDevice
    {
        HostMemoryRing constants, uploads;

        // One write and one info for each descriptor of a program, reused by every dispatch and draw.
        VkWriteDescriptorSet* writes;
        VkDescriptorBufferInfo* bufferInfos;
        VkDescriptorImageInfo* imageInfos;
        VkBufferView* texelViews;

        void CreateScratch()
        {
            writes = (VkWriteDescriptorSet*)NativeMemory.AllocZeroed((nuint)maxPushDescriptors, (nuint)sizeof(VkWriteDescriptorSet));
            bufferInfos = (VkDescriptorBufferInfo*)NativeMemory.AllocZeroed((nuint)maxPushDescriptors, (nuint)sizeof(VkDescriptorBufferInfo));
            imageInfos = (VkDescriptorImageInfo*)NativeMemory.AllocZeroed((nuint)maxPushDescriptors, (nuint)sizeof(VkDescriptorImageInfo));
            texelViews = (VkBufferView*)NativeMemory.AllocZeroed((nuint)maxPushDescriptors, (nuint)sizeof(VkBufferView));
        }

        void DestroyScratch()
        {
            NativeMemory.Free(writes);
            NativeMemory.Free(bufferInfos);
            NativeMemory.Free(imageInfos);
            NativeMemory.Free(texelViews);
        }

        VkDescriptorSetLayout CreateSetLayout(Slot[] slots, string program)
        {
            if (slots.Length > maxPushDescriptors)
                throw new NotSupportedException($"{program} uses {slots.Length} resources; {Info.Name} binds at most " +
                    $"{maxPushDescriptors}. Use fewer buffers, textures and samplers.");
            var bindings = stackalloc VkDescriptorSetLayoutBinding[Math.Max(1, slots.Length)];
            for (int i = 0; i < slots.Length; i++)
                bindings[i] = new VkDescriptorSetLayoutBinding
                {
                    binding = (uint)slots[i].Resource.Binding, descriptorType = slots[i].Type, descriptorCount = 1, stageFlags = slots[i].Stages,
                };
            var info = new VkDescriptorSetLayoutCreateInfo
            {
                flags = VkDescriptorSetLayoutCreateFlags.PUSH_DESCRIPTOR_KHR, bindingCount = (uint)slots.Length, pBindings = bindings,
            };
            VkDescriptorSetLayout made;
            Check(vk.CreateDescriptorSetLayout(device, &info, null, &made), $"vkCreateDescriptorSetLayout of {program}");
            return made;
        }

        VkPipelineLayout CreatePipelineLayout(VkDescriptorSetLayout set, string program)
        {
            var info = new VkPipelineLayoutCreateInfo { setLayoutCount = 1, pSetLayouts = &set };
            VkPipelineLayout made;
            Check(vk.CreatePipelineLayout(device, &info, null, &made), $"vkCreatePipelineLayout of {program}");
            return made;
        }

        VkShaderModule CreateModule(ShaderProgram program) => CreateModule(program.Spirv, program.Name);

        VkShaderModule CreateModule(byte[] spirv, string program)
        {
            fixed (byte* code = spirv)
            {
                var info = new VkShaderModuleCreateInfo { codeSize = (nuint)spirv.Length, pCode = (uint*)code };
                VkShaderModule made;
                Check(vk.CreateShaderModule(device, &info, null, &made), $"vkCreateShaderModule of {program}");
                return made;
            }
        }

        internal void Free(VkDescriptorSetLayout set, VkPipelineLayout layout)
        {
            vk.DestroyPipelineLayout(device, layout, null);
            vk.DestroyDescriptorSetLayout(device, set, null);
        }

        internal void Free(VkPipeline pipeline) => vk.DestroyPipeline(device, pipeline, null);
        internal void Free(VkShaderModule module) => vk.DestroyShaderModule(device, module, null);

        /// <summary>Writes the descriptors and touches their resources; to be followed by <see cref="Order"/> and <see cref="Push"/>.</summary>
        void Resolve(Slot[] slots, ReadOnlySpan<DeviceBinding> bindings, Scope scope, string program)
        {
            if (bindings.Length != slots.Length)
                throw new ArgumentException($"{program} has {slots.Length} resources and {bindings.Length} bindings were given.");
            for (int i = 0; i < slots.Length; i++)
            {
                ref readonly var slot = ref slots[i];
                ref readonly var binding = ref bindings[i];
                ref var write = ref writes[i];
                write.sType = VkStructureType.WRITE_DESCRIPTOR_SET;
                write.dstBinding = (uint)slot.Resource.Binding;
                write.descriptorCount = 1;
                write.descriptorType = slot.Type;
                switch (slot.Type)
                {
                    case var _ when slot.Resource.Kind == ShaderResourceKind.ConstantBuffer:
                        write.pBufferInfo = bufferInfos + i;
                        if (binding.Constants != null) ResolveConstants(slot, binding, out bufferInfos[i]);
                        else ResolveBuffer(slot, binding, scope, limits.minUniformBufferOffsetAlignment, limits.maxUniformBufferRange,
                            out bufferInfos[i]);
                        break;
                    case VkDescriptorType.STORAGE_BUFFER:
                        write.pBufferInfo = bufferInfos + i;
                        ResolveBuffer(slot, binding, scope, limits.minStorageBufferOffsetAlignment, limits.maxStorageBufferRange, out bufferInfos[i]);
                        break;
                    case VkDescriptorType.UNIFORM_TEXEL_BUFFER or VkDescriptorType.STORAGE_TEXEL_BUFFER:
                        write.pTexelBufferView = texelViews + i;
                        texelViews[i] = ResolveTexels(slot, binding, scope);
                        break;
                    case VkDescriptorType.SAMPLER:
                        write.pImageInfo = imageInfos + i;
                        imageInfos[i] = new VkDescriptorImageInfo { sampler = SamplerFor(binding.Sampler) };
                        break;
                    default:
                        write.pImageInfo = imageInfos + i;
                        imageInfos[i] = new VkDescriptorImageInfo { imageView = ResolveTexture(slot, binding, scope),
                            imageLayout = VkImageLayout.GENERAL };
                        break;
                }
            }
        }

        void Push(VkPipelineBindPoint point, VkPipelineLayout layout, int count)
        {
            if (count > 0) vk.CmdPushDescriptorSetKHR(commands, point, layout, 0, (uint)count, writes);
        }

        void ResolveConstants(in Slot slot, in DeviceBinding binding, out VkDescriptorBufferInfo info)
        {
            int given = Math.Min(binding.ConstantsLength > 0 ? binding.ConstantsLength : binding.Constants.Length, binding.Constants.Length);
            int bytes = Math.Max(16, Math.Max(given, slot.Resource.Constants?.Bytes ?? 0) + 15 & ~15);
            byte* target = constants.Take((ulong)bytes,
                Math.Max(limits.minUniformBufferOffsetAlignment, limits.minStorageBufferOffsetAlignment), out var buffer, out ulong offset);
            var span = new Span<byte>(target, bytes);
            binding.Constants.AsSpan(0, given).CopyTo(span);
            span.Slice(given).Clear();
            info = new VkDescriptorBufferInfo { buffer = buffer, offset = offset, range = (ulong)bytes };
        }

        void ResolveBuffer(in Slot slot, in DeviceBinding binding, Scope scope, ulong alignment, uint maxRange, out VkDescriptorBufferInfo info)
        {
            if (binding.Buffer == null)
            {
                info = new VkDescriptorBufferInfo { range = Vk.VK_WHOLE_SIZE };
                return;
            }
            var buffer = Alive(binding.Buffer, slot);
            long bytes = binding.Bytes > 0 ? binding.Bytes : buffer.Bytes - binding.Offset;
            if (binding.Offset < 0 || bytes <= 0 || binding.Offset + bytes > buffer.Bytes)
                throw new ArgumentException($"{slot.Program}: '{slot.Resource.Name}' is bound to bytes {binding.Offset} to " +
                    $"{binding.Offset + bytes} of '{buffer.Name}', which has {buffer.Bytes}.");
            if ((ulong)binding.Offset % alignment != 0)
                throw new ArgumentException($"{slot.Program}: '{slot.Resource.Name}' is bound at byte {binding.Offset} of " +
                    $"'{buffer.Name}'; {Info.Name} binds at multiples of {alignment}.");
            if (bytes > maxRange)
            {
                // A cbuffer sees the front of a larger buffer; a structured buffer must be seen whole.
                if (slot.Resource.Kind != ShaderResourceKind.ConstantBuffer)
                    throw new ArgumentException($"{slot.Program}: '{slot.Resource.Name}' is bound to {bytes:N0} bytes of " +
                        $"'{buffer.Name}'; {Info.Name} binds at most {maxRange:N0}. Split the buffer.");
                bytes = maxRange;
            }
            Touch(buffer.Usage, scope, slot.Writes);
            info = new VkDescriptorBufferInfo { buffer = buffer.Handle, offset = (ulong)binding.Offset, range = (ulong)bytes };
        }

        VkBufferView ResolveTexels(in Slot slot, in DeviceBinding binding, Scope scope)
        {
            if (binding.Buffer == null) return VkBufferView.Null;
            var buffer = Alive(binding.Buffer, slot);
            if (binding.Offset != 0)
                throw new NotSupportedException(
                $"{slot.Program}: typed buffer '{slot.Resource.Name}' can be bound from byte 0 alone, not {binding.Offset}.");
            Touch(buffer.Usage, scope, slot.Writes);
            return buffer.TexelView(slot.TexelFormat);
        }

        VkImageView ResolveTexture(in Slot slot, in DeviceBinding binding, Scope scope)
        {
            // Direct3D takes a texture out of a draw's inputs while it is a target of it.
            if (binding.Texture == null || scope == Scope.Raster && IsTarget(binding.Texture)) return VkImageView.Null;
            var texture = (VulkanTexture)binding.Texture;
            if (texture.IsDisposed) throw Disposed(slot, texture.Name);
            bool storage = slot.Type == VkDescriptorType.STORAGE_IMAGE;
            if (storage && !texture.Description.RandomWrite)
                throw new ArgumentException(
                    $"{slot.Program}: RW texture '{slot.Resource.Name}' is bound to '{texture.Name}', which was made without random write.");
            Touch(texture.Usage, scope, slot.Writes);
            return storage ? ViewFor(texture, slot.Resource.Dimension, binding.Mip, 1, true, slot.Program, slot.Resource.Name)
                : ViewFor(texture, slot.Resource.Dimension, 0, texture.Description.Mips, false, slot.Program, slot.Resource.Name);
        }

        VulkanBuffer Alive(DeviceBuffer buffer, in Slot slot)
        {
            var b = (VulkanBuffer)buffer;
            return b.IsDisposed ? throw Disposed(slot, b.Name) : b;
        }

        static ObjectDisposedException Disposed(in Slot slot, string name)
            => new(name, $"{slot.Program}: '{slot.Resource.Name}' is bound to '{name}', which was released.");
    }
}
