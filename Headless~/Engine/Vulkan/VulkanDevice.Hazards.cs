using System;
using System.Numerics;

namespace Host.Vulkan
{
    /// <summary>Stages of the pipeline in which an operation touches a resource.</summary>
    internal enum Scope { Compute, Transfer, Raster, Attachment, Indirect, Input }

    /// <summary>When and where the stream last wrote and read a resource, by number of operation (0 = never).</summary>
    internal sealed unsafe class Usage
    {
        public const int Scopes = 6;
        public ulong LastSubmission;
        public long Write;
        public Scope WriteScope;
        public ReadTimes Reads;

        [System.Runtime.CompilerServices.InlineArray(Scopes)]
        public struct ReadTimes { long first; }
    }

    /// <summary>Barriers, put where an operation touches what an earlier one wrote, or writes what an earlier one read.</summary>
    /// <remarks>
    /// A barrier is global memory between two scopes, e.g. compute to compute: it orders everything before it in the one
    /// scope against everything after it in the other. So the stream need only remember, for each pair of scopes, the
    /// operation that the last such barrier preceded; a use older than that is safe. Operations that fraction nothing run
    /// without a barrier between them. Images live in the GENERAL layout from birth, so they do not differ from buffers.
    /// </remarks>
    sealed unsafe partial class VulkanDevice
    {
        struct Touched { public Usage Usage; public Scope Scope; public bool Writes; }

        long operation;
        readonly long[] ordered = new long[Usage.Scopes * Usage.Scopes];
        ulong missing;                              // pairs of scopes, a bit each, that the current operation must order
        Touched[] touched = new Touched[128];
        int touchedCount;

        /// <summary>Barriers that hazards have cost since the device was made.</summary>
        public long BarrierCount { get; private set; }

        /// <summary>Notes that the current operation will use the resource; nothing is marked before <see cref="Order"/>.</summary>
        void Touch(Usage usage, Scope scope, bool writes)
        {
            if (usage.Write != 0) Need(usage.WriteScope, usage.Write, scope);
            if (writes)
                for (int from = 0; from < Usage.Scopes; from++)
                    if (usage.Reads[from] != 0) Need((Scope)from, usage.Reads[from], scope);
            if (touchedCount == touched.Length) Array.Resize(ref touched, touchedCount * 2);
            touched[touchedCount++] = new Touched { Usage = usage, Scope = scope, Writes = writes };
        }

        /// <summary>An operation that threw between its touches and its order leaves none of them to the next.</summary>
        void ForgetTouched()
        {
            touchedCount = 0;
            missing = 0;
        }

        void Need(Scope from, long since, Scope to)
        {
            int pair = (int)from * Usage.Scopes + (int)to;
            if (ordered[pair] <= since) missing |= 1UL << pair;
        }

        /// <summary>Emits the barriers that the touched resources need and marks them as used by the current operation.</summary>
        void Order()
        {
            if (missing != 0) EmitBarriers();
            for (int i = 0; i < touchedCount; i++)
            {
                ref var t = ref touched[i];
                t.Usage.LastSubmission = nextSubmission;
                if (t.Writes)
                {
                    (t.Usage.Write, t.Usage.WriteScope) = (operation, t.Scope);
                    t.Usage.Reads = default;        // whoever is ordered after this write is ordered after those reads
                }
                else t.Usage.Reads[(int)t.Scope] = operation;
                t.Usage = null;
            }
            touchedCount = 0;
        }

        void EmitBarriers()
        {
            const int pairs = Usage.Scopes * Usage.Scopes;
            var barriers = stackalloc VkMemoryBarrier2[pairs];
            uint count = 0;
            for (; missing != 0; missing &= missing - 1)
            {
                int pair = BitOperations.TrailingZeroCount(missing);
                Scope from = (Scope)(pair / Usage.Scopes), to = (Scope)(pair % Usage.Scopes);
                barriers[count++] = new VkMemoryBarrier2
                {
                    srcStageMask = StageOf(from), srcAccessMask = WritesOf(from), dstStageMask = StageOf(to),
                        dstAccessMask = ReadsOf(to) | WritesOf(to),
                };
                ordered[pair] = operation;
            }
            var dependency = new VkDependencyInfo { memoryBarrierCount = count, pMemoryBarriers = barriers };
            vk.CmdPipelineBarrier2(commands, &dependency);
            BarrierCount++;
        }

        void BarrierForHost()
        {
            var barrier = new VkMemoryBarrier2
            {
                srcStageMask = VkPipelineStageFlags2.ALL_TRANSFER, srcAccessMask = VkAccessFlags2.TRANSFER_WRITE,
                dstStageMask = VkPipelineStageFlags2.HOST, dstAccessMask = VkAccessFlags2.HOST_READ,
            };
            var dependency = new VkDependencyInfo { memoryBarrierCount = 1, pMemoryBarriers = &barrier };
            vk.CmdPipelineBarrier2(commands, &dependency);
            hostWillRead = false;
        }

        /// <summary>Takes a new image out of the undefined layout.</summary>
        void BarrierForBirth(VkImage image, VkImageAspectFlags aspects)
        {
            var barrier = new VkImageMemoryBarrier2
            {
                dstStageMask = VkPipelineStageFlags2.ALL_COMMANDS, dstAccessMask = VkAccessFlags2.MEMORY_READ | VkAccessFlags2.MEMORY_WRITE,
                oldLayout = VkImageLayout.UNDEFINED, newLayout = VkImageLayout.GENERAL, image = image,
                srcQueueFamilyIndex = Vk.VK_QUEUE_FAMILY_IGNORED, dstQueueFamilyIndex = Vk.VK_QUEUE_FAMILY_IGNORED,
                subresourceRange = new VkImageSubresourceRange { aspectMask = aspects, levelCount = Vk.VK_REMAINING_MIP_LEVELS,
                    layerCount = Vk.VK_REMAINING_ARRAY_LAYERS },
            };
            var dependency = new VkDependencyInfo { imageMemoryBarrierCount = 1, pImageMemoryBarriers = &barrier };
            vk.CmdPipelineBarrier2(commands, &dependency);
        }

        static VkPipelineStageFlags2 StageOf(Scope scope) => scope switch
        {
            Scope.Compute => VkPipelineStageFlags2.COMPUTE_SHADER,
            Scope.Transfer => VkPipelineStageFlags2.ALL_TRANSFER,
            Scope.Raster => VkPipelineStageFlags2.VERTEX_SHADER | VkPipelineStageFlags2.FRAGMENT_SHADER,
            Scope.Attachment => VkPipelineStageFlags2.COLOR_ATTACHMENT_OUTPUT | VkPipelineStageFlags2.EARLY_FRAGMENT_TESTS
                | VkPipelineStageFlags2.LATE_FRAGMENT_TESTS,
            Scope.Indirect => VkPipelineStageFlags2.DRAW_INDIRECT,
            _ => VkPipelineStageFlags2.VERTEX_INPUT,
        };

        static VkAccessFlags2 WritesOf(Scope scope) => scope switch
        {
            Scope.Compute or Scope.Raster => VkAccessFlags2.SHADER_WRITE,
            Scope.Transfer => VkAccessFlags2.TRANSFER_WRITE,
            Scope.Attachment => VkAccessFlags2.COLOR_ATTACHMENT_WRITE | VkAccessFlags2.DEPTH_STENCIL_ATTACHMENT_WRITE,
            _ => VkAccessFlags2.NONE,
        };

        static VkAccessFlags2 ReadsOf(Scope scope) => scope switch
        {
            Scope.Compute or Scope.Raster => VkAccessFlags2.SHADER_READ | VkAccessFlags2.UNIFORM_READ,
            Scope.Transfer => VkAccessFlags2.TRANSFER_READ,
            Scope.Attachment => VkAccessFlags2.COLOR_ATTACHMENT_READ | VkAccessFlags2.DEPTH_STENCIL_ATTACHMENT_READ,
            Scope.Indirect => VkAccessFlags2.INDIRECT_COMMAND_READ,
            _ => VkAccessFlags2.INDEX_READ | VkAccessFlags2.VERTEX_ATTRIBUTE_READ,
        };
    }
}
