using System;
using System.Buffers;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace UnityEngine.Headless
{
    /// <summary>SetData and GetData of both buffer classes: acts at once, in order with everything executed before.</summary>
    internal static class Transfer
    {
        public static void Set(BufferStorage buffer, Array data, int managedStart, int bufferStart, int count)
        {
            int size = BufferBytes.ElementSize(data, $"{buffer.Api}.SetData");
            BufferChecks.Range(buffer, "SetData", data.Length, size, managedStart, bufferStart, count);
            if (count > 0)
                BufferBytes.With(data, (long)managedStart * size, (long)count * size, bytes => buffer.Upload((long)bufferStart * size, bytes));
        }

        public static void Set<T>(BufferStorage buffer, List<T> data, int managedStart, int bufferStart, int count) where T : struct
        {
            int size = SizeOf<T>(buffer);
            BufferChecks.Range(buffer, "SetData", data.Count, size, managedStart, bufferStart, count);
            T[] copy = ArrayPool<T>.Shared.Rent(Math.Max(1, count));
            data.CopyTo(managedStart, copy, 0, count);
            buffer.Upload((long)bufferStart * size, MemoryMarshal.AsBytes(copy.AsSpan(0, count)));
            ArrayPool<T>.Shared.Return(copy);
        }

        public static void Set<T>(BufferStorage buffer, NativeArray<T> data, int nativeStart, int bufferStart, int count) where T : struct
        {
            int size = SizeOf<T>(buffer);
            BufferChecks.Range(buffer, "SetData", data.Length, size, nativeStart, bufferStart, count);
            buffer.Upload((long)bufferStart * size, Bytes(data).Slice(nativeStart * size, count * size));
        }

        public static void Get(BufferStorage buffer, Array data, int managedStart, int bufferStart, int count)
        {
            int size = BufferBytes.ElementSize(data, $"{buffer.Api}.GetData");
            BufferChecks.Range(buffer, "GetData", data.Length, size, managedStart, bufferStart, count);
            BufferChecks.Readable(buffer, "GetData");
            if (count > 0)
                BufferBytes.With(data, (long)managedStart * size, (long)count * size,
                    bytes => Gpu.Device.Read(buffer.Device, (long)bufferStart * size, bytes));
            GpuChecks.InspectArguments(wait: true);
        }

        public static void CopyCount(BufferStorage source, BufferStorage target, int offset)
        {
            if (source == null)
                throw new ArgumentNullException("src");
            if (target == null)
                throw new ArgumentNullException("dst");
            BufferStorage.CopyCount(source, target, offset);
        }

        public static unsafe Span<byte> Bytes<T>(NativeArray<T> array) where T : struct =>
            new Span<byte>(NativeArrayUnsafeUtility.GetUnsafePtr(array), checked(array.Length * ElementSize<T>.Bytes));

        static int SizeOf<T>(BufferStorage buffer) where T : struct
        {
            if (RuntimeHelpers.IsReferenceOrContainsReferences<T>())
                throw new ArgumentException($"Elements of type {typeof(T)} passed to {buffer.Api}.SetData must be blittable.");
            return ElementSize<T>.Bytes;
        }
    }

    /// <summary>LockBufferForWrite and BeginWrite: scratch memory now, an upload at the end.</summary>
    internal sealed class LockedWrite
    {
        byte[] scratch;
        GCHandle pin;
        long offset;
        int elements;

        public unsafe NativeArray<T> Begin<T>(BufferStorage buffer, string call, int start, int count) where T : struct
        {
            int size = ElementSize<T>.Bytes;
            BufferChecks.Range(buffer, call, count, size, 0, start, count);
            if (scratch != null)
                throw new InvalidOperationException($"{call}: {buffer} is already being written.");
            scratch = new byte[Math.Max(1, count * size)];
            pin = GCHandle.Alloc(scratch, GCHandleType.Pinned);
            offset = (long)start * size;
            elements = count;
            return NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>((void*)pin.AddrOfPinnedObject(), count, Allocator.None);
        }

        public void End<T>(BufferStorage buffer, string call, int countWritten) where T : struct
        {
            BufferChecks.Alive(buffer, call);
            if (scratch == null)
                throw new InvalidOperationException($"{call}: {buffer} is not being written.");
            if (countWritten < 0 || countWritten > elements)
                throw new ArgumentOutOfRangeException(nameof(countWritten), countWritten, $"{call} on {buffer}: {elements} elements were locked.");
            buffer.Upload(offset, scratch.AsSpan(0, countWritten * ElementSize<T>.Bytes));
            pin.Free();
            scratch = null;
        }
    }
}
