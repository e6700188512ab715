using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Host.Vulkan
{
    /// <summary>
    /// Makes a kernel's constant buffers storage buffers. Lavapipe (Mesa 22.3) writes constants that decide how often a loop runs
    /// into the code, at every dispatch again, and keeps each such program until the pipeline goes: that takes most of the time of
    /// a dispatch and megabytes a frame. It does so with uniform buffers alone.
    /// </summary>
    internal static class ConstantsPatch
    {
        const int OpTypePointer = 32, OpFunction = 54, OpDecorate = 71;
        const uint Block = 2, BufferBlock = 3, Uniform = 2;

        public static byte[] Apply(byte[] spirv)
        {
            var result = (byte[])spirv.Clone();
            var words = MemoryMarshal.Cast<byte, uint>(result.AsSpan());
            // Decorations come before the types that they are of.
            var uniform = new HashSet<uint>();
            for (int at = 5; at < words.Length && (words[at] & 0xffff) != OpFunction; at += (int)(words[at] >> 16))
                if ((words[at] & 0xffff) == OpTypePointer && words[at + 2] == Uniform) uniform.Add(words[at + 3]);
            for (int at = 5; at < words.Length && (words[at] & 0xffff) != OpFunction; at += (int)(words[at] >> 16))
                if ((words[at] & 0xffff) == OpDecorate && words[at + 2] == Block && uniform.Contains(words[at + 1])) words[at + 2] = BufferBlock;
            return result;
        }
    }
}
