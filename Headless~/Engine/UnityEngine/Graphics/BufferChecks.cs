using System;

namespace UnityEngine.Headless
{
    /// <summary>Checks of operations on a buffer: its creation, and calls that read, write or copy it.</summary>
    internal static class BufferChecks
    {
        const int MaxStride = 2048;

        public static void Creation(string api, GraphicsBuffer.Target target, int count, int stride)
        {
            if (count <= 0)
                throw new ArgumentException($"Attempting to create a {api} of {count} elements; a buffer holds at least one.", nameof(count));
            if (stride <= 0)
                throw new ArgumentException($"Attempting to create a {api} with a stride of {stride} bytes; a stride is positive.", nameof(stride));

            bool vertexOrIndex = (target & (GraphicsBuffer.Target.Index | GraphicsBuffer.Target.Vertex)) != 0;
            if (stride % 4 != 0 && !(vertexOrIndex && stride == 2))
                throw new ArgumentException(
                    $"Attempting to create a {api} with a stride of {stride} bytes; a stride must be a multiple of 4.", nameof(stride));
            if (stride > MaxStride)
                throw new ArgumentException(
                    $"Attempting to create a {api} with a stride of {stride} bytes; Direct3D 11 allows at most {MaxStride}.",
                    nameof(stride));
            if ((target & GraphicsBuffer.Target.Raw) != 0 && stride != 4)
                throw new ArgumentException(
                    $"Attempting to create a raw {api} with a stride of {stride} bytes; a raw buffer's stride is 4.", nameof(stride));
            if ((target & GraphicsBuffer.Target.Index) != 0 && stride != 2 && stride != 4)
                throw new ArgumentException(
                    $"Attempting to create an index buffer with a stride of {stride} bytes; indices are 2 or 4 bytes.", nameof(stride));

            long bytes = (long)count * stride;
            if (bytes > Gpu.MaxResourceBytes)
                throw new ArgumentException($"The total size of the {api} ({bytes:N0} bytes: {count:N0} elements of {stride}) exceeds " +
                    $"the maximum buffer size of {Gpu.MaxResourceBytes:N0} bytes; split it.");
        }

        /// <exception cref="ObjectDisposedException">The buffer was released.</exception>
        public static void Alive(BufferStorage buffer, string call)
        {
            if (buffer.IsReleased)
                throw new ObjectDisposedException(buffer.ToString(), $"{call}: {buffer} was released before this use.");
        }

        public static void Range(BufferStorage buffer, string call, int managedLength, int elementBytes, int managedStart, int bufferStart, int count)
        {
            Alive(buffer, call);
            if (managedStart < 0 || bufferStart < 0 || count < 0 || (long)managedStart + count > managedLength)
                throw new ArgumentOutOfRangeException(null, $"{call} on {buffer}: bad indices/count arguments " +
                    $"(managedBufferStartIndex:{managedStart} bufferStartIndex:{bufferStart} count:{count}, array length:{managedLength}).");
            long end = ((long)bufferStart + count) * elementBytes;
            if (end > buffer.Bytes)
                throw new ArgumentException($"{call} on {buffer}: elements {bufferStart:N0} to {(long)bufferStart + count:N0} of " +
                    $"{elementBytes} bytes end at byte {end:N0}, but the buffer holds {buffer.Bytes:N0}.");
        }

        /// <summary>Reading what nothing wrote: undefined in Unity.</summary>
        public static void Readable(BufferStorage buffer, string call)
        {
            Alive(buffer, call);
            if (!buffer.Written)
                GpuError.Strictly(
                    $"{call} reads {buffer}, which nothing has written yet (no SetData, copy or RW binding); its content is undefined.");
        }

        public static bool Counter(BufferStorage buffer, string call)
        {
            Alive(buffer, call);
            if (buffer.Counter != null)
                return true;
            GpuError.Report($"{call} on {buffer}: it has no counter; create it with Append or Counter among its targets (it has {buffer.Target}).",
                $"{call}: the buffer is not of type Append, Consume or Counter.");
            return false;
        }

        public static bool CopyCount(BufferStorage source, BufferStorage target, long offset)
        {
            if (!Counter(source, "CopyCount"))
                return false;
            Alive(target, "CopyCount");
            if (offset < 0 || offset % 4 != 0 || offset + 4 > target.Bytes)
                throw new ArgumentException($"CopyCount from {source} to {target}: offset {offset} must be a multiple of 4 with 4 " +
                    $"bytes after it; the target holds {target.Bytes:N0} bytes.");
            return true;
        }

        public static void Copy(BufferStorage source, BufferStorage target)
        {
            Readable(source, "CopyBuffer");
            Alive(target, "CopyBuffer");
            if (!source.Is(GraphicsBuffer.Target.CopySource))
                throw new ArgumentException($"CopyBuffer: the source, {source}, was not created with Target.CopySource (it has {source.Target}).");
            if (!target.Is(GraphicsBuffer.Target.CopyDestination))
                throw new ArgumentException(
                    $"CopyBuffer: the destination, {target}, was not created with Target.CopyDestination (it has {target.Target}).");
            if (source.Bytes != target.Bytes)
                throw new ArgumentException(
                    $"CopyBuffer: {source} holds {source.Bytes:N0} bytes and {target} {target.Bytes:N0}; both must be equal.");
        }

        /// <summary>Arguments of an indirect dispatch or draw that runs now: their position, and that something wrote them.</summary>
        public static bool Arguments(BufferStorage buffer, string call, long offset, int bytes)
        {
            if (!ArgumentsPlace(buffer, call, offset, bytes))
                return false;
            Readable(buffer, call);
            return true;
        }

        /// <summary>The buffer's type and the place in it; what it holds may be written later in the frame.</summary>
        public static bool ArgumentsPlace(BufferStorage buffer, string call, long offset, int bytes)
        {
            if (buffer == null)
                throw new ArgumentNullException("argsBuffer", $"{call}: the argument buffer is null.");
            Alive(buffer, call);
            if (!buffer.Is(GraphicsBuffer.Target.IndirectArguments))
            {
                GpuError.Report($"{call}: {buffer} was not created with IndirectArguments among its targets (it has {buffer.Target}).",
                    $"{call}: the args buffer is not of type IndirectArguments.");
                return false;
            }
            if (offset < 0 || offset % 4 != 0 || offset + bytes > buffer.Bytes)
                throw new ArgumentException($"{call}: arguments at byte {offset:N0} of {buffer} need {bytes} bytes at a multiple of 4; " +
                    $"the buffer holds {buffer.Bytes:N0}.");
            return true;
        }
    }
}
