using System;
using System.Runtime.InteropServices;

namespace Rill
{
    /// <summary>Structs as the bytes that they take in memory, so that a field that is added to one counts by itself.</summary>
    static class StructBytes
    {
        public static ReadOnlySpan<byte> Of<T>(ref T value) where T : struct
            => MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref value, 1));

        /// <summary>Whether all bits are the same.</summary>
        public static bool AreSame<T>(T first, T second) where T : struct => Of(ref first).SequenceEqual(Of(ref second));
    }
}
