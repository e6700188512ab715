using System;
using System.Collections.Generic;
using System.Numerics;
using UnityEngine.Headless;

namespace Host.Vulkan
{
    sealed unsafe partial class VulkanDevice
    {
        /// <summary>Read-back memory by power of two of its size, reused since Unity's side asks for the same every frame.</summary>
        readonly Stack<VulkanBuffer>[] readbackBuffers = new Stack<VulkanBuffer>[64];
        const int KeptReadbackBytes = 64 << 20;

        public DeviceReadback BeginReadback(DeviceBuffer source, long offset, long bytes)
        {
            var buffer = (VulkanBuffer)source;
            CheckRange(buffer, offset, bytes, "read");
            BeginTransfer();
            var target = RentReadbackBuffer(bytes);
            Touch(buffer.Usage, Scope.Transfer, writes: false);
            Order();
            if (bytes > 0) CopyBytes(buffer.Handle, (ulong)offset, target.Handle, 0, (ulong)bytes);
            return FinishReadback(buffer.Name, target, bytes);
        }

        public DeviceReadback BeginReadback(DeviceTexture source, int mip, int slice)
        {
            var texture = (VulkanTexture)source;
            CheckLevel(texture, mip, slice);
            BeginTransfer();
            var target = RentReadbackBuffer(texture.SliceBytes(mip));
            Touch(texture.Usage, Scope.Transfer, writes: false);
            Order();
            var region = Region(texture, mip, slice, 0);
            vk.CmdCopyImageToBuffer(commands, texture.Handle, VkImageLayout.GENERAL, target.Handle, 1, &region);
            return FinishReadback(texture.Name, target, texture.SliceBytes(mip));
        }

        VulkanReadback FinishReadback(string name, VulkanBuffer target, long bytes)
        {
            hostWillRead = true;
            target.Usage.LastSubmission = nextSubmission;
            var readback = new VulkanReadback(this, name, target, bytes, nextSubmission);
            Register(readback);
            return readback;
        }

        public void Read(DeviceBuffer source, long offset, Span<byte> target)
        {
            CheckRange((VulkanBuffer)source, offset, target.Length, "read");
            DeviceReadback current = null;
            for (int begun = 0, read = 0; read < target.Length;)
            {
                DeviceReadback next = null;
                if (begun < target.Length)
                {
                    int bytes = Math.Min(PieceBytes, target.Length - begun);
                    next = BeginReadback(source, offset + begun, bytes);
                    begun += bytes;
                    Flush();
                }
                if (current != null)
                {
                    current.Data.CopyTo(target.Slice(read));
                    read += current.Data.Length;
                    current.Dispose();
                }
                current = next;
            }
        }

        public byte[] ReadTexture(DeviceTexture source, int mip, int slice)
        {
            using var all = BeginReadback(source, mip, slice);
            return all.Data.ToArray();
        }

        VulkanBuffer RentReadbackBuffer(long bytes)
        {
            int size = SizeClass(bytes);
            return readbackBuffers[size] != null && readbackBuffers[size].TryPop(out var spare) ? spare
                : CreateHostBuffer("readback", 1UL << size, MemoryUse.Readback);
        }

        internal void GiveBack(VulkanBuffer buffer)
        {
            // A read-back of hundreds of megabytes is unlikely to be repeated. Below that, getting such memory again
            // takes longer than the read-back.
            if (buffer.Bytes > KeptReadbackBytes) buffer.Dispose();
            else (readbackBuffers[SizeClass(buffer.Bytes)] ??= new Stack<VulkanBuffer>()).Push(buffer);
        }

        static int SizeClass(long bytes) => bytes <= 256 ? 8 : BitOperations.Log2((ulong)bytes - 1) + 1;
    }

    internal sealed unsafe class VulkanReadback : DeviceReadback, IRetirable
    {
        readonly VulkanDevice device;
        readonly VulkanBuffer memory;
        readonly long bytes;
        public ulong LastSubmission { get; }
        bool disposed;

        public VulkanReadback(VulkanDevice device, string name, VulkanBuffer memory, long bytes, ulong submission)
            => (this.device, Name, this.memory, this.bytes, LastSubmission) = (device, name, memory, bytes, submission);

        public override bool IsDone => disposed || device.HasCompleted(LastSubmission);
        public override void Wait() => device.WaitFor(LastSubmission);

        public override ReadOnlySpan<byte> Data
        {
            get
            {
                if (disposed) throw new ObjectDisposedException(Name, $"The read-back of '{Name}' was disposed.");
                Wait();
                return new ReadOnlySpan<byte>(memory.Memory.Mapped, checked((int)bytes));
            }
        }

        public override void Dispose()
        {
            if (disposed) return;
            disposed = true;
            device.Retire(this);
        }

        void IRetirable.Free()
        {
            disposed = true;
            device.GiveBack(memory);
        }
    }
}
