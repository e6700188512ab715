using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Vulkan
{
    internal sealed class VulkanTexture : DeviceTexture, IRetirable
    {
        readonly VulkanDevice device;
        public readonly VkImage Handle;
        public readonly GpuAllocation Memory;
        public readonly GpuFormat Format;
        /// <summary>Array slices as Vulkan counts them: a cube has six.</summary>
        public readonly int Layers;
        public readonly Usage Usage = new();
        public bool IsDisposed { get; private set; }
        readonly Dictionary<(VkImageViewType Type, int Mip, int Mips, int Layer, int Layers), VkImageView> views = new();

        public VulkanTexture(VulkanDevice device, in DeviceTextureDescription description, int layers, VkImage handle, in GpuAllocation memory)
        {
            (this.device, Name, Description, Layers, Handle, Memory) = (device, description.Name, description, layers, handle, memory);
            Format = GpuFormat.Of(description.Format);
        }

        public bool Is3D => Description.Dimension == DeviceTextureDimension.Tex3D;
        public int Width(int mip) => System.Math.Max(1, Description.Width >> mip);
        public int Height(int mip) => System.Math.Max(1, Description.Height >> mip);
        public int Depth(int mip) => Is3D ? System.Math.Max(1, Description.Depth >> mip) : 1;
        public long SliceBytes(int mip) => (long)Width(mip) * Height(mip) * Depth(mip) * Format.TexelBytes;

        public VkImageView View(VkImageViewType type, int mip, int mips, int layer, int layers)
        {
            var key = (type, mip, mips, layer, layers);
            if (!views.TryGetValue(key, out var view)) views[key] = view = device.CreateView(this, type, mip, mips, layer, layers);
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
            device.Free(this, views.Values);
        }
    }
}
