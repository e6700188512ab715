using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    /// <summary>The GPU memory behind a GraphicsBuffer or a ComputeBuffer, and what is known of its state.</summary>
    internal sealed class BufferStorage
    {
        /// <summary>Content of new buffers in strict mode: a NaN as a float, far out of range as an index.</summary>
        public const uint Garbage = 0xFFC0DEAD;

        const GraphicsBuffer.Target HasCounter = GraphicsBuffer.Target.Append | GraphicsBuffer.Target.Counter;

        static readonly List<BufferStorage> live = new List<BufferStorage>();
        static readonly ConcurrentQueue<BufferStorage> leaked = new ConcurrentQueue<BufferStorage>();
        static uint lastHandle;

        /// <summary>"GraphicsBuffer" or "ComputeBuffer", for messages.</summary>
        public readonly string Api;
        public readonly int Count, Stride;
        public readonly GraphicsBuffer.Target Target;
        public readonly uint Handle;
        public string Name = "";
        /// <summary>Whether anything ever wrote here: SetData, a copy, an unordered access view.</summary>
        public bool Written { get => part != null ? part.Written : written; private set => written = value; }
        /// <summary>Grows with every write, so that a check can tell whether it has seen this content.</summary>
        public int Version;

        readonly MeshMemory.Part part;      // null: the memory is its own
        DeviceBuffer device;
        bool written;

        /// <summary>A handle to memory of a mesh, with which it goes.</summary>
        public BufferStorage(MeshMemory.Part part)
        {
            Api = nameof(GraphicsBuffer);
            this.part = part;
            (Target, Count, Stride, device) = (part.Target, part.Count, part.Stride, part.Buffer);
            Handle = ++lastHandle;
            part.Add(this);
            live.Add(this);
            LiveObjects.Add(this, Api, ToString());
        }

        public BufferStorage(string api, GraphicsBuffer.Target target, int count, int stride)
        {
            Api = api;
            BufferChecks.Creation(api, target, count, stride);
            Gpu.RequireCompute($"new {api}({count}, {stride})");
            Target = target;
            Count = count;
            Stride = stride;
            Handle = ++lastHandle;
            device = Gpu.Device.CreateBuffer(api, Bytes);
            Gpu.Device.Fill(device, 0, (Bytes + 3) / 4 * 4, Player.Strict ? Garbage : 0u);
            if ((target & HasCounter) != 0)
            {
                Counter = Gpu.Device.CreateBuffer(api + " counter", 4);
                Gpu.Device.Fill(Counter, 0, 4, 0);
            }
            live.Add(this);
            LiveObjects.Add(this, api, ToString());
        }

        /// <summary>Buffers not yet released, in order of creation.</summary>
        public static IReadOnlyList<BufferStorage> Live => live;

        public static BufferStorage OfHandle(GraphicsBufferHandle handle) => live.Find(b => b.Handle == handle.value);

        public long Bytes => (long)Count * Stride;
        public DeviceBuffer Device => device;
        /// <summary>The hidden counter of append, consume and counter buffers; null for others.</summary>
        public DeviceBuffer Counter { get; private set; }
        public bool IsReleased => device == null;
        public bool IsStructured => Target == 0 || (Target & (GraphicsBuffer.Target.Structured | HasCounter)) != 0;
        public bool Is(GraphicsBuffer.Target target) => (Target & target) != 0;

        public override string ToString() => Name.Length > 0 ? $"{Api} '{Name}'" : $"unnamed {Api} ({Count:N0} x {Stride} bytes)";

        public void Rename(string name)
        {
            Name = name ?? "";
            if (device == null)
                return;
            if (part == null)
                device.Name = Name;
            LiveObjects.Add(this, Api, Name);
        }

        public void MarkWritten()
        {
            Written = true;
            if (part != null)
                part.Written = true;
            Version++;
        }

        public void Upload(long offset, ReadOnlySpan<byte> data)
        {
            if (data.IsEmpty)
                return;
            Gpu.Device.Upload(device, offset, data);
            MarkWritten();
        }

        public void SetCounter(uint value)
        {
            if (BufferChecks.Counter(this, "SetCounterValue"))
                Gpu.Device.Fill(Counter, 0, 4, value);
        }

        /// <summary>Raw bytes as they are, written or not; for dumps.</summary>
        public byte[] ReadAll()
        {
            var bytes = new byte[Bytes];
            Gpu.Device.Read(device, 0, bytes);
            return bytes;
        }

        public void Release()
        {
            if (device == null)
                return;
            if (ReadbackQueue.IsPending(this))
                GpuError.Strictly($"{this} was released while a read-back of it was pending. Whether that still arrives Unity does not " +
                    $"say: release it when the request has come back.");
            if (part != null)
                part.Remove(this);
            else
                device.Dispose();
            device = null;
            Counter?.Dispose();
            Counter = null;
            live.Remove(this);
            LiveObjects.Remove(this);
        }

        /// <summary>From a finalizer's thread: the buffer was dropped without Release.</summary>
        public void Leak() => leaked.Enqueue(this);

        /// <summary>Releases what finalizers found, with Unity's warning.</summary>
        public static void CollectLeaks()
        {
            while (leaked.TryDequeue(out BufferStorage storage))
            {
                if (storage.IsReleased)
                    continue;
                Debug.LogWarning($"GarbageCollector disposing of {storage.Api}. Please use {storage.Api}.Release() or .Dispose() to " +
                    $"manually release the buffer. ({storage})");
                storage.Release();
            }
        }

        public static void CopyCount(BufferStorage source, BufferStorage target, long targetOffset)
        {
            if (!BufferChecks.CopyCount(source, target, targetOffset))
                return;
            Gpu.Device.Copy(source.Counter, 0, target.Device, targetOffset, 4);
            target.MarkWritten();
        }
    }

    /// <summary>Managed arrays as the bytes that a buffer takes.</summary>
    internal static class BufferBytes
    {
        /// <summary>Bytes of an element; refuses types that have references in them, as Unity does.</summary>
        public static int ElementSize(Array data, string call)
        {
            Type type = data.GetType().GetElementType();
            if (type.IsPrimitive)
                return Buffer.ByteLength(data) / Math.Max(1, data.Length) is var size && size > 0 ? size : Marshal.SizeOf(type);
            if (type.IsEnum)
                return Marshal.SizeOf(Enum.GetUnderlyingType(type));
            if (!type.IsValueType)
                throw new ArgumentException($"Array passed to {call} must be blittable.\n{type} is not a value type.");
            return Marshal.SizeOf(type);
        }

        public delegate void Reader(Span<byte> bytes);

        /// <summary>Pins an array of any element type and hands out a range of it as bytes.</summary>
        public static unsafe void With(Array data, long byteOffset, long bytes, Reader use)
        {
            GCHandle pin = GCHandle.Alloc(data, GCHandleType.Pinned);
            try
            {
                use(new Span<byte>((byte*)Marshal.UnsafeAddrOfPinnedArrayElement(data, 0) + byteOffset, checked((int)bytes)));
            }
            finally
            {
                pin.Free();
            }
        }
    }

    internal static class ElementSize<T> where T : struct
    {
        public static readonly int Bytes = MemoryMarshal.AsBytes(new T[1].AsSpan()).Length;
    }
}
