using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary>Who reads and writes the memory decides which of the device's memory types serves best.</summary>
    internal enum MemoryUse
    {
        /// <summary>The GPU alone.</summary>
        Device,
        /// <summary>Written by the CPU, copied from once.</summary>
        Upload,
        /// <summary>Written by the CPU, read by shaders: on the GPU's side of the bus where that is mappable.</summary>
        Constants,
        /// <summary>Written by the GPU, read by the CPU through its caches.</summary>
        Readback,
    }

    internal readonly unsafe struct GpuAllocation
    {
        public readonly GpuMemory.Block Block;
        public readonly ulong Offset, Bytes;
        public GpuAllocation(GpuMemory.Block block, ulong offset, ulong bytes) => (Block, Offset, Bytes) = (block, offset, bytes);
        public byte* Mapped => Block.Mapped + Offset;
    }

    /// <summary>
    /// Device memory in blocks, since a device grants only some thousands of allocations. First fit in blocks of 64 MB;
    /// what is larger than a quarter of that has an allocation of its own. Images and buffers are never in one block, so that
    /// bufferImageGranularity does not matter.
    /// </summary>
    internal sealed unsafe class GpuMemory : IDisposable
    {
        const ulong BlockBytes = 64 << 20, DedicatedBytes = BlockBytes / 4;

        internal sealed class Block
        {
            public VkDeviceMemory Memory;
            public ulong Bytes;
            public byte* Mapped;
            public bool Dedicated;
            public List<Block> Pool;
            /// <summary>Ascending by offset; neighbors are merged.</summary>
            public readonly List<(ulong Offset, ulong Bytes)> Free = new();
            public bool IsEmpty => Free.Count == 1 && Free[0].Bytes == Bytes;
        }

        readonly VkDeviceCommands vk;
        readonly VkDevice device;
        readonly VkPhysicalDeviceMemoryProperties properties;
        readonly Dictionary<(int Type, bool Image), List<Block>> pools = new();

        public GpuMemory(VkDeviceCommands vk, VkDevice device, in VkPhysicalDeviceMemoryProperties properties)
            => (this.vk, this.device, this.properties) = (vk, device, properties);

        /// <summary>Bytes taken from the driver, used or not.</summary>
        public long ReservedBytes { get; private set; }

        public long DeviceLocalBytes
        {
            get
            {
                ulong bytes = 0;
                for (int i = 0; i < properties.memoryHeapCount; i++)
                    if ((properties.memoryHeaps[i].flags & VkMemoryHeapFlags.DEVICE_LOCAL) != 0)
                        bytes = Math.Max(bytes, properties.memoryHeaps[i].size);
                return (long)bytes;
            }
        }

        /// <exception cref="OutOfGpuMemoryException">No memory type of the right kind has room.</exception>
        public GpuAllocation Allocate(in VkMemoryRequirements need, MemoryUse use, bool image, string what)
        {
            Span<int> types = stackalloc int[32];
            int count = RankTypes(need.memoryTypeBits, use, types);
            var result = VkResult.ERROR_OUT_OF_DEVICE_MEMORY;
            for (int i = 0; i < count; i++)
                if (TryAllocate(need, types[i], image, out var allocation, ref result)) return allocation;
            if (result is VkResult.ERROR_OUT_OF_DEVICE_MEMORY or VkResult.ERROR_OUT_OF_HOST_MEMORY or VkResult.ERROR_TOO_MANY_OBJECTS)
                throw new OutOfGpuMemoryException($"{what} needs {need.size:N0} bytes of GPU memory and the device has no room ({result}); " +
                    $"{ReservedBytes:N0} bytes are reserved already, of {DeviceLocalBytes:N0} that the device has. Make it smaller or " +
                    $"release other resources.");
            throw new VulkanException(result, $"vkAllocateMemory of {need.size:N0} bytes for {what}");
        }

        public void Free(in GpuAllocation allocation)
        {
            var block = allocation.Block;
            if (block.Dedicated) { Destroy(block); return; }
            var free = block.Free;
            int at = 0;
            while (at < free.Count && free[at].Offset < allocation.Offset) at++;
            var (offset, bytes) = (allocation.Offset, allocation.Bytes);
            if (at < free.Count && offset + bytes == free[at].Offset) { bytes += free[at].Bytes; free.RemoveAt(at); }
            if (at > 0 && free[at - 1].Offset + free[at - 1].Bytes == offset)
            {
                at--;
                (offset, bytes) = (free[at].Offset, bytes + free[at].Bytes);
                free.RemoveAt(at);
            }
            free.Insert(at, (offset, bytes));
            // One empty block stays, so that a resource made and released every frame does not go to the driver.
            if (block.IsEmpty && block.Pool.Exists(b => b != block && b.IsEmpty)) { block.Pool.Remove(block); Destroy(block); }
        }

        bool TryAllocate(in VkMemoryRequirements need, int type, bool image, out GpuAllocation allocation, ref VkResult result)
        {
            allocation = default;
            if (need.size > DedicatedBytes)
            {
                var own = NewBlock(need.size, type, ref result);
                if (own == null) return false;
                own.Dedicated = true;
                allocation = new GpuAllocation(own, 0, need.size);
                return true;
            }
            if (!pools.TryGetValue((type, image), out var pool)) pools[(type, image)] = pool = new List<Block>();
            foreach (var block in pool)
                if (TryPlace(block, need, out allocation)) return true;
            var fresh = NewBlock(BlockBytes, type, ref result);
            if (fresh == null) return false;
            fresh.Pool = pool;
            fresh.Free.Add((0, BlockBytes));
            pool.Add(fresh);
            return TryPlace(fresh, need, out allocation);
        }

        static bool TryPlace(Block block, in VkMemoryRequirements need, out GpuAllocation allocation)
        {
            var free = block.Free;
            for (int i = 0; i < free.Count; i++)
            {
                var (offset, bytes) = free[i];
                ulong start = (offset + need.alignment - 1) & ~(need.alignment - 1), end = start + need.size;
                if (end > offset + bytes) continue;
                free.RemoveAt(i);
                if (end < offset + bytes) free.Insert(i, (end, offset + bytes - end));
                if (start > offset) free.Insert(i, (offset, start - offset));
                allocation = new GpuAllocation(block, start, need.size);
                return true;
            }
            allocation = default;
            return false;
        }

        Block NewBlock(ulong bytes, int type, ref VkResult result)
        {
            var info = new VkMemoryAllocateInfo { allocationSize = bytes, memoryTypeIndex = (uint)type };
            VkDeviceMemory memory;
            var got = vk.AllocateMemory(device, &info, null, &memory);
            if (got != VkResult.SUCCESS) { result = got; return null; }
            var block = new Block { Memory = memory, Bytes = bytes };
            if ((properties.memoryTypes[type].propertyFlags & VkMemoryPropertyFlags.HOST_VISIBLE) != 0)
            {
                void* mapped;
                Check(vk.MapMemory(device, memory, 0, Vk.VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
                block.Mapped = (byte*)mapped;
            }
            ReservedBytes += (long)bytes;
            return block;
        }

        void Destroy(Block block)
        {
            vk.FreeMemory(device, block.Memory, null);
            ReservedBytes -= (long)block.Bytes;
        }

        /// <summary>Memory types that can serve, best first.</summary>
        int RankTypes(uint allowed, MemoryUse use, Span<int> types)
        {
            const VkMemoryPropertyFlags local = VkMemoryPropertyFlags.DEVICE_LOCAL, cached = VkMemoryPropertyFlags.HOST_CACHED,
                mappable = VkMemoryPropertyFlags.HOST_VISIBLE | VkMemoryPropertyFlags.HOST_COHERENT;
            // Never across the bus for the GPU's own: slow without a word is worse than a message that memory is full.
            var required = use == MemoryUse.Device ? local : mappable;
            var (wanted, unwanted) = use switch
            {
                MemoryUse.Device => (local, mappable),
                MemoryUse.Upload => (default(VkMemoryPropertyFlags), local | cached),
                MemoryUse.Constants => (local, cached),
                _ => (cached, local),
            };
            Span<int> scores = stackalloc int[32];
            int count = 0;
            for (int i = 0; i < properties.memoryTypeCount; i++)
            {
                var flags = properties.memoryTypes[i].propertyFlags;
                if ((allowed & 1u << i) == 0 || (flags & required) != required) continue;
                if ((flags & (VkMemoryPropertyFlags.PROTECTED | VkMemoryPropertyFlags.LAZILY_ALLOCATED)) != 0) continue;
                int score = ((flags & wanted) == wanted ? 0 : 100) + System.Numerics.BitOperations.PopCount((uint)(flags & unwanted));
                int at = count++;
                for (; at > 0 && scores[at - 1] > score; at--) (scores[at], types[at]) = (scores[at - 1], types[at - 1]);
                (scores[at], types[at]) = (score, i);
            }
            return count;
        }

        public void Dispose()
        {
            foreach (var pool in pools.Values)
                foreach (var block in pool) Destroy(block);
            pools.Clear();
        }
    }
}
