using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Vulkan
{
    /// <summary>One resource of a program as a descriptor, decided once so that binding it is a table walk.</summary>
    internal struct Slot
    {
        public ShaderResource Resource;
        public VkDescriptorType Type;
        public VkShaderStageFlags Stages;
        public bool Writes;
        /// <summary>Typed buffers: the format of their elements.</summary>
        public VkFormat TexelFormat;
        public string Program;

        /// <param name="storesConstants">Constant buffers are storage buffers, as <see cref="ConstantsPatch"/> makes them.</param>
        public static void Append(List<Slot> slots, ShaderProgram program, SpirvFacts facts, VkShaderStageFlags stage, bool storesConstants = false)
        {
            foreach (var r in program.Resources)
            {
                var slot = new Slot { Resource = r, Stages = stage, Program = program.Name };
                bool writable = !facts.NonWritableBindings.Contains(r.Binding);
                switch (r.Kind)
                {
                    case ShaderResourceKind.ConstantBuffer: slot.Type = storesConstants ? VkDescriptorType.STORAGE_BUFFER
                        : VkDescriptorType.UNIFORM_BUFFER; break;
                    case ShaderResourceKind.StructuredBuffer or ShaderResourceKind.RawBuffer: slot.Type = VkDescriptorType.STORAGE_BUFFER; break;
                    case ShaderResourceKind.RWStructuredBuffer or ShaderResourceKind.RWRawBuffer or ShaderResourceKind.Counter:
                        (slot.Type, slot.Writes) = (VkDescriptorType.STORAGE_BUFFER, writable);
                        break;
                    case ShaderResourceKind.TypedBuffer:
                        (slot.Type, slot.TexelFormat) = (VkDescriptorType.UNIFORM_TEXEL_BUFFER, TexelFormatOf(r, facts));
                        break;
                    case ShaderResourceKind.RWTypedBuffer:
                        (slot.Type, slot.TexelFormat, slot.Writes) = (VkDescriptorType.STORAGE_TEXEL_BUFFER, TexelFormatOf(r, facts), writable);
                        break;
                    case ShaderResourceKind.Texture: slot.Type = VkDescriptorType.SAMPLED_IMAGE; break;
                    case ShaderResourceKind.RWTexture: (slot.Type, slot.Writes) = (VkDescriptorType.STORAGE_IMAGE, writable); break;
                    case ShaderResourceKind.Sampler: slot.Type = VkDescriptorType.SAMPLER; break;
                    default: throw new NotSupportedException($"{program.Name}: '{r.Name}' is a {r.Kind}, which the Vulkan device does not bind.");
                }
                slots.Add(slot);
            }
        }

        /// <summary>Format that the importer read from the declaration; otherwise 32 bits of the kind that SPIR-V tells.</summary>
        static VkFormat TexelFormatOf(ShaderResource r, SpirvFacts facts)
        {
            if (r.ElementFormat != DeviceFormat.None) return GpuFormat.Of(r.ElementFormat).Vulkan;
            return facts.ImageKinds.GetValueOrDefault(r.Binding) switch
            {
                NumericKind.UInt => VkFormat.R32_UINT,
                NumericKind.SInt => VkFormat.R32_SINT,
                _ => VkFormat.R32_SFLOAT,
            };
        }
    }

    internal sealed class VulkanKernel : DeviceKernel, IRetirable
    {
        readonly VulkanDevice device;
        public readonly Slot[] Slots;
        public readonly VkDescriptorSetLayout SetLayout;
        public readonly VkPipelineLayout Layout;
        public readonly VkPipeline Pipeline;
        public ulong LastSubmission { get; set; }
        public bool IsDisposed { get; private set; }

        public VulkanKernel(VulkanDevice device, ShaderProgram program, Slot[] slots, VkDescriptorSetLayout setLayout,
            VkPipelineLayout layout, VkPipeline pipeline)
        {
            (this.device, Program, Name, Slots, SetLayout, Layout, Pipeline) = (device, program, program.Name, slots, setLayout, layout, pipeline);
        }

        public override void Dispose()
        {
            if (IsDisposed) return;
            IsDisposed = true;
            device.Retire(this);
        }

        void IRetirable.Free()
        {
            IsDisposed = true;
            device.Free(SetLayout, Layout);
            device.Free(Pipeline);
        }
    }

    internal sealed class VulkanPass : DevicePass, IRetirable
    {
        readonly VulkanDevice device;
        public readonly Slot[] Slots;
        public readonly VkDescriptorSetLayout SetLayout;
        public readonly VkPipelineLayout Layout;
        public readonly VkShaderModule VertexModule, FragmentModule;
        /// <summary>The vertex program that also writes a point size; made by the first draw of points.</summary>
        public VkShaderModule PointModule;
        /// <summary>By location, of the vertex program's inputs.</summary>
        public readonly Dictionary<int, NumericKind> InputKinds;
        public readonly Dictionary<PipelineKey, VkPipeline> Pipelines = new();
        public ulong LastSubmission { get; set; }
        public bool IsDisposed { get; private set; }

        public VulkanPass(VulkanDevice device, ShaderProgram vertex, ShaderProgram fragment, Slot[] slots, Dictionary<int, NumericKind> inputKinds,
            VkDescriptorSetLayout setLayout, VkPipelineLayout layout, VkShaderModule vertexModule, VkShaderModule fragmentModule)
        {
            (this.device, Vertex, Fragment, Name, Slots, InputKinds) = (device, vertex, fragment, vertex.Name, slots, inputKinds);
            (SetLayout, Layout, VertexModule, FragmentModule) = (setLayout, layout, vertexModule, fragmentModule);
        }

        public override void Dispose()
        {
            if (IsDisposed) return;
            IsDisposed = true;
            device.Retire(this);
        }

        void IRetirable.Free()
        {
            IsDisposed = true;
            foreach (var pipeline in Pipelines.Values) device.Free(pipeline);
            device.Free(SetLayout, Layout);
            device.Free(VertexModule);
            device.Free(PointModule);
            device.Free(FragmentModule);
        }
    }
}
