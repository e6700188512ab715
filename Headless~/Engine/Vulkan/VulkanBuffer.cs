using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Vulkan
{
    internal sealed unsafe class VulkanBuffer : DeviceBuffer, IRetirable
    {
        readonly VulkanDevice device;
        public readonly VkBuffer Handle;
        public readonly GpuAllocation Memory;
        public readonly Usage Usage = new();
        /// <summary>Staging and constants of the device itself.</summary>
        public readonly bool IsOwn;
        public bool IsDisposed { get; private set; }
        Dictionary<VkFormat, VkBufferView> views;

        public VulkanBuffer(VulkanDevice device, string name, long bytes, VkBuffer handle, in GpuAllocation memory, bool isOwn)
            => (this.device, Name, Bytes, Handle, Memory, IsOwn) = (device, name, bytes, handle, memory, isOwn);

        /// <summary>The buffer as texels, for Buffer and RWBuffer of HLSL.</summary>
        public VkBufferView TexelView(VkFormat format)
        {
            views ??= new Dictionary<VkFormat, VkBufferView>();
            if (!views.TryGetValue(format, out var view)) views[format] = view = device.CreateTexelView(this, format);
            return view;
        }

        ulong IRetirable.LastSubmission => Usage.LastSubmission;

        public override void Dispose()
        {
            if (IsDisposed) return;
            IsDisposed = true;
            device.Retire(this);
        }

        void IRetirable.Free()
        {
            IsDisposed = true;
            device.Free(this, views);
        }
    }
}
