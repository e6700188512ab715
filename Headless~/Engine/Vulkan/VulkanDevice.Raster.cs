using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary>Passes and draws, by dynamic rendering.</summary>
    /// <remarks>
    /// A barrier cannot stand inside a Vulkan pass, and Unity's side does not know of barriers. So a pass begins late, at
    /// its first draw; whatever must come between two draws suspends it, and the next draw resumes it without a clear.
    /// </remarks>
    sealed unsafe partial class VulkanDevice
    {
        DeviceTargets targets;
        bool inPass;            // between BeginPass and EndPass
        bool isRendering;       // between vkCmdBeginRendering and vkCmdEndRendering
        bool clearColorDue, clearDepthDue;
        uint renderWidth, renderHeight;
        ulong targetFormats;
        VulkanBuffer zeros;     // what a vertex input reads that the mesh lacks

        public DevicePass CreatePass(ShaderProgram vertex, ShaderProgram fragment)
        {
            var list = new List<Slot>();
            var vertexFacts = new SpirvFacts(vertex.Spirv, vertex.Name);
            Slot.Append(list, vertex, vertexFacts, VkShaderStageFlags.VERTEX);
            Slot.Append(list, fragment, new SpirvFacts(fragment.Spirv, fragment.Name), VkShaderStageFlags.FRAGMENT);
            var slots = list.ToArray();
            var set = CreateSetLayout(slots, vertex.Name);
            var pass = new VulkanPass(this, vertex, fragment, slots, vertexFacts.Inputs, set, CreatePipelineLayout(set, vertex.Name),
                CreateModule(vertex), CreateModule(fragment));
            Register(pass);
            return pass;
        }

        public void BeginPass(in DeviceTargets wanted)
        {
            if (inPass) throw new InvalidOperationException("A pass is begun before the last one was ended.");
            if (wanted.ColorCount == 0 && wanted.Depth == null) throw new ArgumentException("A pass needs a color or a depth target.");
            targets = wanted;
            inPass = true;
            clearColorDue = wanted.ClearColor && wanted.ColorCount > 0;
            clearDepthDue = wanted.ClearDepth && wanted.Depth != null;
            targetFormats = 0;
            renderWidth = renderHeight = uint.MaxValue;
            for (int i = 0; i < wanted.ColorCount; i++)
                if (Color(i) is { } color) IncludeTarget(color, wanted.Mip, i);
            if (wanted.Depth is VulkanTexture depth) IncludeTarget(depth, wanted.ColorCount == 0 ? wanted.Mip : 0, 4);
            if (targets.ViewportWidth <= 0 || targets.ViewportHeight <= 0)
                (targets.ViewportX, targets.ViewportY, targets.ViewportWidth, targets.ViewportHeight) = (0, 0, renderWidth, renderHeight);
        }

        void IncludeTarget(VulkanTexture t, int mip, int slot)
        {
            if (t.IsDisposed) throw new ObjectDisposedException(t.Name, $"Render target '{t.Name}' was released.");
            if (!t.Description.Target) throw new ArgumentException($"Texture '{t.Name}' was not made as a render target.");
            renderWidth = Math.Min(renderWidth, (uint)t.Width(mip));
            renderHeight = Math.Min(renderHeight, (uint)t.Height(mip));
            targetFormats |= (ulong)t.Description.Format << slot * 8;
        }

        public void EndPass()
        {
            if (!inPass) throw new InvalidOperationException("EndPass without BeginPass.");
            if (clearColorDue || clearDepthDue)
            {
                BeginOperation();
                ResumePass();
            }
            SuspendPass();
            inPass = false;
            targets = default;
        }

        public void Draw(DevicePass pass, in DeviceRasterState state, ReadOnlySpan<DeviceBinding> bindings, in DeviceDraw draw)
        {
            if (!inPass) throw new InvalidOperationException("Draw outside of a pass.");
            var p = (VulkanPass)pass;
            if (p.IsDisposed) throw new ObjectDisposedException(p.Name, $"Shader pass {p.Name} was released.");

            var key = new PipelineKey { State = state, Formats = targetFormats };
            var vertexBuffers = stackalloc VkBuffer[PipelineKey.MaxStreams];
            var vertexOffsets = stackalloc ulong[PipelineKey.MaxStreams];
            var zero = p.Vertex.Inputs.Length > 0 ? Zeros() : null;

            BeginOperation();
            Resolve(p.Slots, bindings, Scope.Raster, p.Name);
            ResolveStreams(p, draw.Streams, zero, ref key, vertexBuffers, vertexOffsets);
            if (draw.Indices != null) Touch(((VulkanBuffer)draw.Indices).Usage, Scope.Input, writes: false);
            if (draw.Arguments != null) Touch(((VulkanBuffer)draw.Arguments).Usage, Scope.Indirect, writes: false);
            var pipeline = PipelineFor(p, key);
            if (missing != 0) SuspendPass();
            ResumePass();

            p.LastSubmission = nextSubmission;
            lastProgram = p.Name;
            GpuWork.Drawn(p.Name);
            if (boundGraphics != pipeline)
            {
                vk.CmdBindPipeline(commands, VkPipelineBindPoint.GRAPHICS, pipeline);
                boundGraphics = pipeline;
            }
            Push(VkPipelineBindPoint.GRAPHICS, p.Layout, p.Slots.Length);
            if (key.StreamCount > 0) vk.CmdBindVertexBuffers(commands, 0, (uint)key.StreamCount, vertexBuffers, vertexOffsets);
            Issue(draw);
        }

        void Issue(in DeviceDraw draw)
        {
            var arguments = (VulkanBuffer)draw.Arguments;
            if (draw.Indices != null)
            {
                vk.CmdBindIndexBuffer(commands, ((VulkanBuffer)draw.Indices).Handle, 0, draw.Indices32 ? VkIndexType.UINT32 : VkIndexType.UINT16);
                if (arguments != null) vk.CmdDrawIndexedIndirect(commands, arguments.Handle, (ulong)draw.ArgumentsOffset, 1, 20);
                else vk.CmdDrawIndexed(commands, (uint)draw.VertexCount, (uint)draw.InstanceCount, (uint)draw.FirstVertex, 0,
                    (uint)draw.FirstInstance);
            }
            else if (arguments != null) vk.CmdDrawIndirect(commands, arguments.Handle, (ulong)draw.ArgumentsOffset, 1, 16);
            else vk.CmdDraw(commands, (uint)draw.VertexCount, (uint)draw.InstanceCount, (uint)draw.FirstVertex, (uint)draw.FirstInstance);
        }

        /// <summary>One binding for each input of the vertex program: the mesh's stream, or zeros.</summary>
        void ResolveStreams(VulkanPass p, DeviceVertexStream[] streams, VulkanBuffer zero, ref PipelineKey key, VkBuffer* buffers, ulong* offsets)
        {
            var inputs = p.Vertex.Inputs;
            if (inputs.Length > PipelineKey.MaxStreams)
                throw new NotSupportedException(
                $"{p.Name} has {inputs.Length} vertex inputs; at most {PipelineKey.MaxStreams} are supported.");
            for (int i = 0; i < inputs.Length; i++)
            {
                int location = inputs[i].Location;
                int found = streams == null ? -1 : Array.FindIndex(streams, s => s.Location == location);
                if (found >= 0)
                {
                    ref readonly var s = ref streams[found];
                    var buffer = (VulkanBuffer)s.Buffer;
                    Touch(buffer.Usage, Scope.Input, writes: false);
                    (buffers[i], offsets[i]) = (buffer.Handle, (ulong)s.Offset);
                    key.Streams[i] = PipelineKey.Pack(location, s.Format, s.Stride);
                    continue;
                }
                var format = p.InputKinds.GetValueOrDefault(location) switch
                {
                    NumericKind.UInt => DeviceFormat.RGBA32_UInt,
                    NumericKind.SInt => DeviceFormat.RGBA32_SInt,
                    _ => DeviceFormat.RGBA32_Float,
                };
                Touch(zero.Usage, Scope.Input, writes: false);
                (buffers[i], offsets[i]) = (zero.Handle, 0);
                key.Streams[i] = PipelineKey.Pack(location, format, 0);
            }
            key.StreamCount = inputs.Length;
        }

        VulkanBuffer Zeros()
        {
            if (zeros != null) return zeros;
            zeros = CreateBuffer("zeros", 64, VkBufferUsageFlags.VERTEX_BUFFER | VkBufferUsageFlags.TRANSFER_DST, MemoryUse.Constants);
            Fill(zeros, 0, 64, 0);
            return zeros;
        }

        // ---- beginning late, suspending, resuming

        VulkanTexture Color(int i) => (VulkanTexture)(i switch { 0 => targets.Color0, 1 => targets.Color1, 2 => targets.Color2,
            _ => targets.Color3 });

        bool IsTarget(DeviceTexture t)
            => t == targets.Depth || targets.ColorCount > 0 && t == targets.Color0 || targets.ColorCount > 1 && t == targets.Color1
            || targets.ColorCount > 2 && t == targets.Color2 || targets.ColorCount > 3 && t == targets.Color3;

        void SuspendPass()
        {
            if (!isRendering) return;
            vk.CmdEndRendering(commands);
            isRendering = false;
        }

        /// <summary>Orders what the operation touched and makes sure that rendering has begun.</summary>
        void ResumePass()
        {
            if (isRendering) { Order(); return; }
            var t = targets;
            for (int i = 0; i < t.ColorCount; i++)
                if (Color(i) is { } color) Touch(color.Usage, Scope.Attachment, writes: true);
            if (t.Depth is VulkanTexture depthTarget) Touch(depthTarget.Usage, Scope.Attachment, writes: true);
            Order();

            var colors = stackalloc VkRenderingAttachmentInfo[4];
            for (int i = 0; i < t.ColorCount; i++)
            {
                colors[i] = new VkRenderingAttachmentInfo();
                if (Color(i) is { } color)
                    colors[i] = Attachment(color, t.Mip, t.Slice, t.Slices, clearColorDue,
                        new VkClearValue { color = ClearValue(color.Format, t.ClearValue) });
            }
            var depth = new VkRenderingAttachmentInfo();
            bool hasStencil = false;
            if (t.Depth is VulkanTexture d)
            {
                depth = Attachment(d, t.ColorCount == 0 ? t.Mip : 0, t.Slice < d.Layers ? t.Slice : 0, t.Slices, clearDepthDue,
                    new VkClearValue { depthStencil = new VkClearDepthStencilValue { depth = t.ClearDepthValue } });
                hasStencil = (d.Format.Aspects & VkImageAspectFlags.STENCIL) != 0;
            }
            var area = new VkRect2D { extent = new VkExtent2D { width = renderWidth, height = renderHeight } };
            var info = new VkRenderingInfo
            {
                renderArea = area, layerCount = (uint)Math.Max(1, t.Slices), colorAttachmentCount = (uint)t.ColorCount, pColorAttachments = colors,
                pDepthAttachment = t.Depth != null ? &depth : null, pStencilAttachment = hasStencil ? &depth : null,
            };
            vk.CmdBeginRendering(commands, &info);
            isRendering = true;
            clearColorDue = clearDepthDue = false;

            // Direct3D's clip space has y up and its targets begin at the top: Vulkan's, turned over.
            var viewport = new VkViewport { x = t.ViewportX, y = t.ViewportY + t.ViewportHeight, width = t.ViewportWidth,
                height = -t.ViewportHeight, maxDepth = 1 };
            vk.CmdSetViewport(commands, 0, 1, &viewport);
            var scissor = Scissor(t);
            vk.CmdSetScissor(commands, 0, 1, &scissor);
        }

        static VkRenderingAttachmentInfo Attachment(VulkanTexture t, int mip, int slice, int slices, bool clear, in VkClearValue value) => new()
        {
            imageView = t.View(slices > 1 ? VkImageViewType._2D_ARRAY : VkImageViewType._2D, mip, 1, slice, Math.Max(1, slices)),
                imageLayout = VkImageLayout.GENERAL,
            loadOp = clear ? VkAttachmentLoadOp.CLEAR : VkAttachmentLoadOp.LOAD, storeOp = VkAttachmentStoreOp.STORE, clearValue = value,
        };

        VkRect2D Scissor(in DeviceTargets t)
        {
            int x0 = Math.Clamp((int)MathF.Floor(t.ViewportX), 0, (int)renderWidth),
                x1 = Math.Clamp((int)MathF.Ceiling(t.ViewportX + t.ViewportWidth), x0, (int)renderWidth);
            int y0 = Math.Clamp((int)MathF.Floor(t.ViewportY), 0, (int)renderHeight),
                y1 = Math.Clamp((int)MathF.Ceiling(t.ViewportY + t.ViewportHeight), y0, (int)renderHeight);
            return new VkRect2D { offset = new VkOffset2D { x = x0, y = y0 },
                extent = new VkExtent2D { width = (uint)(x1 - x0), height = (uint)(y1 - y0) } };
        }

        // ---- pipelines

        VkPipeline PipelineFor(VulkanPass pass, in PipelineKey key)
        {
            if (!pass.Pipelines.TryGetValue(key, out var pipeline)) pass.Pipelines[key] = pipeline = CreatePipeline(pass, key);
            return pipeline;
        }

        VkPipeline CreatePipeline(VulkanPass pass, in PipelineKey key)
        {
            DeviceObjects.Made++;
            var state = key.State;
            var vertexBindings = stackalloc VkVertexInputBindingDescription[PipelineKey.MaxStreams];
            var attributes = stackalloc VkVertexInputAttributeDescription[PipelineKey.MaxStreams];
            for (int i = 0; i < key.StreamCount; i++)
            {
                uint stream = key.Streams[i];
                vertexBindings[i] = new VkVertexInputBindingDescription { binding = (uint)i, stride = PipelineKey.StrideOf(stream),
                    inputRate = VkVertexInputRate.VERTEX };
                attributes[i] = new VkVertexInputAttributeDescription
                {
                    location = (uint)PipelineKey.LocationOf(stream), binding = (uint)i, format = GpuFormat.Of(PipelineKey.FormatOf(stream)).Vulkan,
                };
            }
            var vertexInput = new VkPipelineVertexInputStateCreateInfo
            {
                vertexBindingDescriptionCount = (uint)key.StreamCount, pVertexBindingDescriptions = vertexBindings,
                vertexAttributeDescriptionCount = (uint)key.StreamCount, pVertexAttributeDescriptions = attributes,
            };
            bool strip = state.Topology is DeviceTopology.TriangleStrip or DeviceTopology.LineStrip;
            var assembly = new VkPipelineInputAssemblyStateCreateInfo
            {
                topology = state.Topology switch
                {
                    DeviceTopology.Triangles => VkPrimitiveTopology.TRIANGLE_LIST,
                    DeviceTopology.TriangleStrip => VkPrimitiveTopology.TRIANGLE_STRIP,
                    DeviceTopology.Lines => VkPrimitiveTopology.LINE_LIST,
                    DeviceTopology.LineStrip => VkPrimitiveTopology.LINE_STRIP,
                    _ => VkPrimitiveTopology.POINT_LIST,
                },
                primitiveRestartEnable = strip ? VkBool32.True : VkBool32.False,   // Direct3D's strips always cut at the highest index
            };
            var viewport = new VkPipelineViewportStateCreateInfo { viewportCount = 1, scissorCount = 1 };
            bool biased = state.DepthBiasFactor != 0 || state.DepthBiasUnits != 0;
            var raster = new VkPipelineRasterizationStateCreateInfo
            {
                polygonMode = VkPolygonMode.FILL, frontFace = state.FrontIsCounterClockwise ? VkFrontFace.COUNTER_CLOCKWISE
                    : VkFrontFace.CLOCKWISE, lineWidth = 1,
                cullMode = state.Cull switch { DeviceCull.Off => VkCullModeFlags.NONE, DeviceCull.Front => VkCullModeFlags.FRONT,
                    _ => VkCullModeFlags.BACK },
                depthBiasEnable = biased ? VkBool32.True : VkBool32.False, depthBiasSlopeFactor = state.DepthBiasFactor,
                    depthBiasConstantFactor = state.DepthBiasUnits,
            };
            var samples = new VkPipelineMultisampleStateCreateInfo { rasterizationSamples = VkSampleCountFlags._1 };
            var depthFormat = (DeviceFormat)(key.Formats >> 32 & 255);
            bool hasDepth = depthFormat != DeviceFormat.None;
            var depth = new VkPipelineDepthStencilStateCreateInfo
            {
                depthTestEnable = hasDepth ? VkBool32.True : VkBool32.False, depthWriteEnable = hasDepth && state.DepthWrite ? VkBool32.True
                    : VkBool32.False,
                depthCompareOp = (VkCompareOp)(int)state.DepthTest,     // the same eight in the same order
            };
            bool hasStencil = (GpuFormat.Of(depthFormat).Aspects & VkImageAspectFlags.STENCIL) != 0;
            if (hasStencil && state.Stencil.Enabled)
            {
                depth.stencilTestEnable = VkBool32.True;
                depth.front = depth.back = new VkStencilOpState
                {
                    // Both enumerations in the same order too.
                    failOp = (VkStencilOp)(int)state.Stencil.Fail, passOp = (VkStencilOp)(int)state.Stencil.Pass,
                        depthFailOp = (VkStencilOp)(int)state.Stencil.DepthFail,
                    compareOp = (VkCompareOp)(int)state.Stencil.Compare, compareMask = state.Stencil.ReadMask,
                        writeMask = state.Stencil.WriteMask, reference = state.Stencil.Reference,
                };
            }
            var blends = stackalloc VkPipelineColorBlendAttachmentState[4];
            var formats = stackalloc VkFormat[4];
            int colors = 0;
            for (int i = 0; i < 4; i++)
            {
                var format = GpuFormat.Of((DeviceFormat)(key.Formats >> i * 8 & 255));
                formats[i] = format.Vulkan;
                if (format.Vulkan != VkFormat.UNDEFINED) colors = i + 1;
                blends[i] = BlendOf(state, format);
            }
            var blend = new VkPipelineColorBlendStateCreateInfo { attachmentCount = (uint)colors, pAttachments = blends };
            var dynamics = stackalloc VkDynamicState[] { VkDynamicState.VIEWPORT, VkDynamicState.SCISSOR };
            var dynamic = new VkPipelineDynamicStateCreateInfo { dynamicStateCount = 2, pDynamicStates = dynamics };
            var rendering = new VkPipelineRenderingCreateInfo
            {
                colorAttachmentCount = (uint)colors, pColorAttachmentFormats = formats, depthAttachmentFormat = GpuFormat.Of(depthFormat).Vulkan,
                stencilAttachmentFormat = hasStencil ? GpuFormat.Of(depthFormat).Vulkan : VkFormat.UNDEFINED,
            };
            if (state.Topology == DeviceTopology.Points && pass.PointModule == VkShaderModule.Null)
                pass.PointModule = CreateModule(PointSizePatch.Apply(pass.Vertex.Spirv), pass.Vertex.Name);
            fixed (byte* vertexEntry = System.Text.Encoding.UTF8.GetBytes(pass.Vertex.EntryPoint + "\0"),
                fragmentEntry = System.Text.Encoding.UTF8.GetBytes(pass.Fragment.EntryPoint + "\0"))
            {
                var stages = stackalloc VkPipelineShaderStageCreateInfo[2];
                stages[0] = new VkPipelineShaderStageCreateInfo { stage = VkShaderStageFlags.VERTEX,
                    module = state.Topology == DeviceTopology.Points ? pass.PointModule : pass.VertexModule, pName = vertexEntry };
                stages[1] = new VkPipelineShaderStageCreateInfo { stage = VkShaderStageFlags.FRAGMENT, module = pass.FragmentModule,
                    pName = fragmentEntry };
                var info = new VkGraphicsPipelineCreateInfo
                {
                    pNext = &rendering, stageCount = 2, pStages = stages, pVertexInputState = &vertexInput, pInputAssemblyState = &assembly,
                    pViewportState = &viewport, pRasterizationState = &raster, pMultisampleState = &samples, pDepthStencilState = &depth,
                    pColorBlendState = &blend, pDynamicState = &dynamic, layout = pass.Layout,
                };
                VkPipeline made;
                Check(vk.CreateGraphicsPipelines(device, pipelineCache, 1, &info, null, &made), $"vkCreateGraphicsPipelines of {pass.Name}");
                SetName(VkObjectType.PIPELINE, (ulong)made, pass.Name);
                return made;
            }
        }

        static VkPipelineColorBlendAttachmentState BlendOf(in DeviceRasterState s, in GpuFormat format)
        {
            var mask = (VkColorComponentFlags)0;
            if ((s.ColorMask & 8) != 0) mask |= VkColorComponentFlags.R;
            if ((s.ColorMask & 4) != 0) mask |= VkColorComponentFlags.G;
            if ((s.ColorMask & 2) != 0) mask |= VkColorComponentFlags.B;
            if ((s.ColorMask & 1) != 0) mask |= VkColorComponentFlags.A;
            // Integer targets cannot blend; Direct3D passes the color through.
            bool blends = s.Blend && format.Numeric == NumericKind.Float;
            return new VkPipelineColorBlendAttachmentState
            {
                blendEnable = blends ? VkBool32.True : VkBool32.False, colorWriteMask = mask,
                srcColorBlendFactor = Factor(s.SrcColor), dstColorBlendFactor = Factor(s.DstColor), colorBlendOp = Operation(s.ColorOp),
                srcAlphaBlendFactor = Factor(s.SrcAlpha), dstAlphaBlendFactor = Factor(s.DstAlpha), alphaBlendOp = Operation(s.AlphaOp),
            };
        }

        static VkBlendFactor Factor(DeviceBlend b) => b switch
        {
            DeviceBlend.Zero => VkBlendFactor.ZERO,
            DeviceBlend.One => VkBlendFactor.ONE,
            DeviceBlend.SrcColor => VkBlendFactor.SRC_COLOR,
            DeviceBlend.OneMinusSrcColor => VkBlendFactor.ONE_MINUS_SRC_COLOR,
            DeviceBlend.DstColor => VkBlendFactor.DST_COLOR,
            DeviceBlend.OneMinusDstColor => VkBlendFactor.ONE_MINUS_DST_COLOR,
            DeviceBlend.SrcAlpha => VkBlendFactor.SRC_ALPHA,
            DeviceBlend.OneMinusSrcAlpha => VkBlendFactor.ONE_MINUS_SRC_ALPHA,
            DeviceBlend.DstAlpha => VkBlendFactor.DST_ALPHA,
            DeviceBlend.OneMinusDstAlpha => VkBlendFactor.ONE_MINUS_DST_ALPHA,
            _ => VkBlendFactor.SRC_ALPHA_SATURATE,
        };

        static VkBlendOp Operation(DeviceBlendOp op) => op switch
        {
            DeviceBlendOp.Add => VkBlendOp.ADD,
            DeviceBlendOp.Sub => VkBlendOp.SUBTRACT,
            DeviceBlendOp.RevSub => VkBlendOp.REVERSE_SUBTRACT,
            DeviceBlendOp.Min => VkBlendOp.MIN,
            _ => VkBlendOp.MAX,
        };
    }
}
