using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Host.Vulkan
{
    /// <summary>
    /// Direct3D's points are one pixel; Vulkan's have the size that the vertex shader writes, and HLSL has nothing to
    /// write it with. Adds "gl_PointSize = 1" to the front of a vertex program.
    /// </summary>
    internal static class PointSizePatch
    {
        const int OpEntryPoint = 15, OpTypeVoid = 19, OpTypeFloat = 22, OpTypePointer = 32, OpTypeForwardPointer = 39, OpConstant = 43,
            OpFunction = 54, OpVariable = 59, OpStore = 62, OpDecorate = 71, OpMemberDecorate = 72, OpLabel = 248;
        const uint BuiltIn = 11, PointSize = 1, Output = 3, One = 0x3f800000;

        /// <summary>The module as it is if it has a point size of its own.</summary>
        public static byte[] Apply(byte[] spirv)
        {
            var words = MemoryMarshal.Cast<byte, uint>(spirv);
            uint entry = 0, real = 0, pointer = 0;
            for (int at = 5; at < words.Length; at += (int)(words[at] >> 16))
            {
                switch ((int)(words[at] & 0xffff))
                {
                    case OpDecorate when words[at + 2] == BuiltIn && words[at + 3] == PointSize:
                    case OpMemberDecorate when words[at + 3] == BuiltIn && words[at + 4] == PointSize:
                        return spirv;
                    case OpEntryPoint: entry = words[at + 2]; break;
                    case OpTypeFloat when words[at + 2] == 32: real = words[at + 1]; break;
                    case OpTypePointer when words[at + 2] == Output && words[at + 3] == real: pointer = words[at + 1]; break;
                }
            }

            uint bound = words[3], size = bound++, one = bound++;
            bool hasPointer = pointer != 0;
            if (!hasPointer) pointer = bound++;
            var result = new List<uint>(words.Length + 24);
            bool decorated = false, declared = false, inEntry = false, inBlock = false;
            result.AddRange(words.Slice(0, 5));
            result[3] = bound;
            for (int at = 5; at < words.Length;)
            {
                int count = (int)(words[at] >> 16), op = (int)(words[at] & 0xffff);
                if (!decorated && op >= OpTypeVoid && op <= OpTypeForwardPointer)
                {
                    decorated = true;
                    Emit(result, OpDecorate, size, BuiltIn, PointSize);
                }
                if (!declared && op == OpFunction)
                {
                    declared = true;
                    if (!hasPointer) Emit(result, OpTypePointer, pointer, Output, real);
                    Emit(result, OpConstant, real, one, One);
                    Emit(result, OpVariable, pointer, size, Output);
                }
                // A function's own variables come first in its first block.
                if (inBlock && op != OpVariable)
                {
                    inEntry = inBlock = false;
                    Emit(result, OpStore, size, one);
                }
                if (op == OpFunction) inEntry = words[at + 2] == entry;
                if (op == OpLabel && inEntry) inBlock = true;

                int start = result.Count;
                result.AddRange(words.Slice(at, count));
                if (op == OpEntryPoint)
                {
                    result.Add(size);
                    result[start] = (uint)(count + 1) << 16 | OpEntryPoint;
                }
                at += count;
            }
            return MemoryMarshal.AsBytes(CollectionsMarshal.AsSpan(result)).ToArray();
        }

        static void Emit(List<uint> words, int op, params ReadOnlySpan<uint> operands)
        {
            words.Add((uint)(operands.Length + 1) << 16 | (uint)op);
            words.AddRange(operands);
        }
    }
}
