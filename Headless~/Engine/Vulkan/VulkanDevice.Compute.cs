using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    sealed unsafe partial class VulkanDevice
    {
        public DeviceKernel CreateKernel(ShaderProgram program)
        {
            var list = new List<Slot>();
            Slot.Append(list, program, new SpirvFacts(program.Spirv, program.Name), VkShaderStageFlags.COMPUTE, storesConstants: Info.IsSoftware);
            var slots = list.ToArray();
            var set = CreateSetLayout(slots, program.Name);
            var layout = CreatePipelineLayout(set, program.Name);
            var module = Info.IsSoftware ? CreateModule(ConstantsPatch.Apply(program.Spirv), program.Name) : CreateModule(program);
            VkPipeline pipeline;
            fixed (byte* entry = System.Text.Encoding.UTF8.GetBytes(program.EntryPoint + "\0"))
            {
                var info = new VkComputePipelineCreateInfo
                {
                    stage = new VkPipelineShaderStageCreateInfo { stage = VkShaderStageFlags.COMPUTE, module = module, pName = entry },
                    layout = layout,
                };
                Check(vk.CreateComputePipelines(device, pipelineCache, 1, &info, null, &pipeline), $"vkCreateComputePipelines of {program.Name}");
            }
            Free(module);
            SetName(VkObjectType.PIPELINE, (ulong)pipeline, program.Name);
            var kernel = new VulkanKernel(this, program, slots, set, layout, pipeline);
            Register(kernel);
            return kernel;
        }

        public void Dispatch(DeviceKernel kernel, ReadOnlySpan<DeviceBinding> bindings, int x, int y, int z)
        {
            var k = PrepareDispatch(kernel, bindings);
            BindForDispatch(k);
            vk.CmdDispatch(commands, (uint)x, (uint)y, (uint)z);
        }

        public void DispatchIndirect(DeviceKernel kernel, ReadOnlySpan<DeviceBinding> bindings, DeviceBuffer arguments, long offset)
        {
            var k = PrepareDispatch(kernel, bindings);
            var buffer = (VulkanBuffer)arguments;
            Touch(buffer.Usage, Scope.Indirect, writes: false);
            BindForDispatch(k);
            vk.CmdDispatchIndirect(commands, buffer.Handle, (ulong)offset);
        }

        VulkanKernel PrepareDispatch(DeviceKernel kernel, ReadOnlySpan<DeviceBinding> bindings)
        {
            var k = (VulkanKernel)kernel;
            if (k.IsDisposed) throw new ObjectDisposedException(k.Name, $"Kernel {k.Name} was released.");
            GpuWork.Dispatched(k.Name);
            BeginOperation();
            SuspendPass();
            Resolve(k.Slots, bindings, Scope.Compute, k.Name);
            return k;
        }

        void BindForDispatch(VulkanKernel k)
        {
            Order();
            k.LastSubmission = nextSubmission;
            lastProgram = k.Name;
            if (boundCompute != k.Pipeline)
            {
                vk.CmdBindPipeline(commands, VkPipelineBindPoint.COMPUTE, k.Pipeline);
                boundCompute = k.Pipeline;
            }
            Push(VkPipelineBindPoint.COMPUTE, k.Layout, k.Slots.Length);
        }
    }
}
