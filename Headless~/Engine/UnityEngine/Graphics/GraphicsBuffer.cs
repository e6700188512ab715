using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine.Headless;

namespace UnityEngine
{
    public sealed class GraphicsBuffer : IDisposable
    {
        [Flags] public enum Target
        {
            Vertex = 1, Index = 2, CopySource = 4, CopyDestination = 8, Structured = 16, Raw = 32, Append = 64, Counter = 128,
            IndirectArguments = 256, Constant = 512,
        }

        [Flags] public enum UsageFlags { None = 0, LockBufferForWrite = 1 }

        public struct IndirectDrawArgs
        {
            public const int size = 16;
            public uint vertexCountPerInstance { get; set; }
            public uint instanceCount { get; set; }
            public uint startVertex { get; set; }
            public uint startInstance { get; set; }
        }

        public struct IndirectDrawIndexedArgs
        {
            public const int size = 20;
            public uint indexCountPerInstance { get; set; }
            public uint instanceCount { get; set; }
            public uint startIndex { get; set; }
            public uint baseVertexIndex { get; set; }
            public uint startInstance { get; set; }
        }

        internal readonly BufferStorage Storage;
        readonly LockedWrite locked = new LockedWrite();

        public GraphicsBuffer(Target target, int count, int stride) : this(target, UsageFlags.None, count, stride) { }

        public GraphicsBuffer(Target target, UsageFlags usageFlags, int count, int stride)
        {
            Storage = new BufferStorage(nameof(GraphicsBuffer), target, count, stride);
            this.usageFlags = usageFlags;
        }

        /// <summary>A handle to a buffer that a mesh owns.</summary>
        internal GraphicsBuffer(MeshMemory.Part part) => Storage = new BufferStorage(part);

        ~GraphicsBuffer()
        {
            if (Storage != null && !Storage.IsReleased)
                Storage.Leak();
        }

        public void Dispose()
        {
            Storage.Release();
            GC.SuppressFinalize(this);
        }

        public void Release() => Dispose();
        public bool IsValid() => !Storage.IsReleased;
        public int count => Storage.Count;
        public int stride => Storage.Stride;
        public string name { set => Storage.Rename(value); }
        public Target target => Storage.Target;
        public UsageFlags usageFlags { get; }
        public GraphicsBufferHandle bufferHandle => new GraphicsBufferHandle(Storage.Handle);

        public void SetData(Array data)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Set(Storage, data, 0, 0, data.Length);
        }

        public void SetData<T>(List<T> data) where T : struct
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Set(Storage, data, 0, 0, data.Count);
        }

        public void SetData<T>(NativeArray<T> data) where T : struct => Transfer.Set(Storage, data, 0, 0, data.Length);

        public void SetData(Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Set(Storage, data, managedBufferStartIndex, graphicsBufferStartIndex, count);
        }

        public void SetData<T>(List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count) where T : struct
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Set(Storage, data, managedBufferStartIndex, graphicsBufferStartIndex, count);
        }

        public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count) where T : struct =>
            Transfer.Set(Storage, data, nativeBufferStartIndex, graphicsBufferStartIndex, count);

        public void GetData(Array data)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Get(Storage, data, 0, 0, data.Length);
        }

        public void GetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Get(Storage, data, managedBufferStartIndex, computeBufferStartIndex, count);
        }

        public void SetCounterValue(uint counterValue) => Storage.SetCounter(counterValue);

        public IntPtr GetNativeBufferPtr() => throw new NotSupportedException(
            "GraphicsBuffer.GetNativeBufferPtr: the headless host has no native graphics objects to hand out.");

        public NativeArray<T> LockBufferForWrite<T>(int bufferStartIndex, int count) where T : struct
        {
            if ((usageFlags & UsageFlags.LockBufferForWrite) == 0)
                throw new InvalidOperationException($"LockBufferForWrite: {Storage} was not created with UsageFlags.LockBufferForWrite.");
            return locked.Begin<T>(Storage, "LockBufferForWrite", bufferStartIndex, count);
        }

        public void UnlockBufferAfterWrite<T>(int countWritten) where T : struct => locked.End<T>(Storage, "UnlockBufferAfterWrite", countWritten);

        public static void CopyCount(GraphicsBuffer src, GraphicsBuffer dst, int dstOffsetBytes)
            => Transfer.CopyCount(src?.Storage, dst?.Storage, dstOffsetBytes);
        public static void CopyCount(GraphicsBuffer src, ComputeBuffer dst, int dstOffsetBytes)
            => Transfer.CopyCount(src?.Storage, dst?.Storage, dstOffsetBytes);
        public static void CopyCount(ComputeBuffer src, GraphicsBuffer dst, int dstOffsetBytes)
            => Transfer.CopyCount(src?.Storage, dst?.Storage, dstOffsetBytes);
        public static void CopyCount(ComputeBuffer src, ComputeBuffer dst, int dstOffsetBytes)
            => Transfer.CopyCount(src?.Storage, dst?.Storage, dstOffsetBytes);
    }
}
