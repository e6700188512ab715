using System.Collections.Generic;

namespace Host.Vulkan
{
    /// <summary>Memory that the CPU fills for one submission: constants and uploads. Handed out from chunks that come back once the stream
    /// has passed them.</summary>
    internal sealed unsafe class HostMemoryRing
    {
        readonly VulkanDevice device;
        readonly MemoryUse use;
        readonly ulong chunkBytes;
        readonly Queue<(ulong Submission, VulkanBuffer Chunk)> used = new();
        readonly Stack<VulkanBuffer> spare = new();
        VulkanBuffer current;
        ulong at;

        public HostMemoryRing(VulkanDevice device, MemoryUse use, ulong chunkBytes)
            => (this.device, this.use, this.chunkBytes) = (device, use, chunkBytes);

        /// <summary>Room for bytes, valid for operations recorded into the current submission.</summary>
        public byte* Take(ulong bytes, ulong alignment, out VkBuffer buffer, out ulong offset)
        {
            offset = (at + alignment - 1) / alignment * alignment;
            if (current == null || offset + bytes > (ulong)current.Bytes)
            {
                if (current != null) used.Enqueue((device.CurrentSubmission, current));
                current = Next(bytes);
                offset = 0;
            }
            at = offset + bytes;
            current.Usage.LastSubmission = device.CurrentSubmission;
            buffer = current.Handle;
            return current.Memory.Mapped + offset;
        }

        VulkanBuffer Next(ulong bytes)
        {
            while (used.TryPeek(out var oldest) && device.HasCompleted(oldest.Submission))
            {
                used.Dequeue();
                if ((ulong)oldest.Chunk.Bytes == chunkBytes) spare.Push(oldest.Chunk);
                else oldest.Chunk.Dispose();
            }
            if (bytes > chunkBytes) return device.CreateHostBuffer("upload", bytes, use);
            return spare.TryPop(out var chunk) ? chunk
                : device.CreateHostBuffer(use == MemoryUse.Constants ? "constants" : "upload", chunkBytes, use);
        }
    }
}
