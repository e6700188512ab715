using System;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Creates, names and releases graphics buffers; count and stride come from the element type.</summary>
    static class GpuBuffer
    {
        /// <summary>Largest resource that Direct3D 11 guarantees, bytes.</summary>
        public const long MaxBytes = 2048L * 1024 * 1024;

        /// <summary>byte of the dispatch arguments in a buffer of <see cref="Arguments"/></summary>
        [GenerateHlsl("Arguments")] public const uint DispatchArgumentsAt = 16;

        /// <summary>two triangles of a quad</summary>
        [GenerateHlsl("Arguments")] public const int VerticesPerParticle = 6;

        /// <summary>Draw arguments at byte 0, dispatch arguments at <see cref="DispatchArgumentsAt"/>, draw arguments for two eyes at byte
        /// 32; see Arguments.hlsl.</summary>
        /// <param name="words">At least 12; further arguments from byte 48 on.</param>
        public static GraphicsBuffer Arguments(string name, int words = 12)
        {
            // Raw, because Direct3D has no structured buffer that also holds indirect arguments.
            return Named(name, new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw, words, sizeof(uint)));
        }

        /// <exception cref="ArgumentOutOfRangeException">No element, or more bytes than the device can bind.</exception>
        public static GraphicsBuffer Structured<T>(string name, long count) where T : struct
        {
            int stride = UnsafeUtility.SizeOf<T>();
            if (count < 1 || count * stride > MaxBinding)
                throw Limit.OutOfRange(nameof(count), count,
                    Invariant($"{name}: {count:N0} elements of {stride} bytes; this device binds 1 to {MaxBinding / stride:N0}."));
            return Named(name, new GraphicsBuffer(GraphicsBuffer.Target.Structured, (int)count, stride));
        }

        /// <summary>A raw buffer of words that may be vertices or indices too.</summary>
        /// <exception cref="ArgumentOutOfRangeException">No word, or more bytes than the device can bind.</exception>
        public static GraphicsBuffer Raw(string name, long words, GraphicsBuffer.Target target)
        {
            if (words < 1 || words * sizeof(uint) > MaxBinding)
                throw Limit.OutOfRange(nameof(words), words,
                    Invariant($"{name}: {words:N0} words of 4 bytes; this device binds 1 to {MaxBinding / sizeof(uint):N0}."));
            return Named(name, new GraphicsBuffer(target | GraphicsBuffer.Target.Raw, (int)words, sizeof(uint)));
        }

        /// <summary>One struct as a constant buffer; its size is a multiple of 16 bytes.</summary>
        public static GraphicsBuffer Constants<T>(string name) where T : struct
        {
            return Named(name, new GraphicsBuffer(GraphicsBuffer.Target.Constant, 1, UnsafeUtility.SizeOf<T>()));
        }

        /// <summary>Largest buffer that a kernel can be given here, bytes.</summary>
        public static long MaxBinding => Math.Min(MaxBytes, SystemInfo.maxGraphicsBufferSize);

        /// <summary>At once, or when the last request that reads it has ended.</summary>
        public static void Release(ref GraphicsBuffer buffer)
        {
            if (buffer != null && !PendingReadbacks.Takes(buffer))
                buffer.Release();
            buffer = null;
        }

        static GraphicsBuffer Named(string name, GraphicsBuffer buffer)
        {
            buffer.name = name;
            return buffer;
        }
    }
}
