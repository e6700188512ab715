using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine.Headless;

namespace UnityEngine
{
    public sealed class ComputeBuffer : IDisposable
    {
        internal readonly BufferStorage Storage;
        readonly ComputeBufferMode mode;
        readonly LockedWrite locked = new LockedWrite();

        public ComputeBuffer(int count, int stride) : this(count, stride, ComputeBufferType.Default, ComputeBufferMode.Immutable) { }
        public ComputeBuffer(int count, int stride, ComputeBufferType type) : this(count, stride, type, ComputeBufferMode.Immutable) { }

        public ComputeBuffer(int count, int stride, ComputeBufferType type, ComputeBufferMode usage)
        {
            Storage = new BufferStorage(nameof(ComputeBuffer), TargetOf(type), count, stride);
            mode = usage;
        }

        static GraphicsBuffer.Target TargetOf(ComputeBufferType type)
        {
            GraphicsBuffer.Target target = 0;
            if ((type & ComputeBufferType.Raw) != 0) target |= GraphicsBuffer.Target.Raw;
            if ((type & ComputeBufferType.Append) != 0) target |= GraphicsBuffer.Target.Append;
            if ((type & ComputeBufferType.Counter) != 0) target |= GraphicsBuffer.Target.Counter;
            if ((type & ComputeBufferType.Constant) != 0) target |= GraphicsBuffer.Target.Constant;
            if ((type & ComputeBufferType.Structured) != 0) target |= GraphicsBuffer.Target.Structured;
            if ((type & ComputeBufferType.IndirectArguments) != 0) target |= GraphicsBuffer.Target.IndirectArguments;
            return target == 0 ? GraphicsBuffer.Target.Structured : target;
        }

        ~ComputeBuffer()
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

        public void SetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Set(Storage, data, managedBufferStartIndex, computeBufferStartIndex, count);
        }

        public void SetData<T>(List<T> data, int managedBufferStartIndex, int computeBufferStartIndex, int count) where T : struct
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            Transfer.Set(Storage, data, managedBufferStartIndex, computeBufferStartIndex, count);
        }

        public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int computeBufferStartIndex, int count) where T : struct =>
            Transfer.Set(Storage, data, nativeBufferStartIndex, computeBufferStartIndex, count);

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
            "ComputeBuffer.GetNativeBufferPtr: the headless host has no native graphics objects to hand out.");

        public NativeArray<T> BeginWrite<T>(int computeBufferStartIndex, int count) where T : struct
        {
            if (mode != ComputeBufferMode.SubUpdates)
                throw new InvalidOperationException($"BeginWrite: {Storage} was not created with ComputeBufferMode.SubUpdates.");
            return locked.Begin<T>(Storage, "BeginWrite", computeBufferStartIndex, count);
        }

        public void EndWrite<T>(int countWritten) where T : struct => locked.End<T>(Storage, "EndWrite", countWritten);

        public static void CopyCount(ComputeBuffer src, ComputeBuffer dst, int dstOffsetBytes)
            => Transfer.CopyCount(src?.Storage, dst?.Storage, dstOffsetBytes);
    }
}
