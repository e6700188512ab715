using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Host.Vulkan
{
    /// <summary>
    /// The few facts of a SPIR-V module that reflection does not carry: which bindings are never written (they need no
    /// barrier after them), what a typed buffer holds, and whether a vertex input is a float or an integer.
    /// </summary>
    internal sealed class SpirvFacts
    {
        public readonly HashSet<int> NonWritableBindings = new();
        /// <summary>By binding: what the texels of an image or typed buffer are.</summary>
        public readonly Dictionary<int, NumericKind> ImageKinds = new();
        /// <summary>By location, stage inputs only.</summary>
        public readonly Dictionary<int, NumericKind> Inputs = new();

        const uint Magic = 0x07230203;
        const int OpTypeInt = 21, OpTypeFloat = 22, OpTypeVector = 23, OpTypeImage = 25, OpTypeStruct = 30, OpTypePointer = 32,
            OpVariable = 59, OpDecorate = 71, OpMemberDecorate = 72;
        const uint NonWritable = 24, Location = 30, Binding = 33, InputStorage = 1;

        public SpirvFacts(byte[] spirv, string name)
        {
            var words = MemoryMarshal.Cast<byte, uint>(spirv);
            if (words.Length < 5 || words[0] != Magic) throw new ArgumentException($"{name}: not a SPIR-V module of this machine's byte order.");

            var binding = new Dictionary<uint, int>();
            var location = new Dictionary<uint, int>();
            var nonWritable = new HashSet<uint>();
            var nonWritableMembers = new Dictionary<uint, int>();
            var members = new Dictionary<uint, int>();
            var pointee = new Dictionary<uint, uint>();
            var numeric = new Dictionary<uint, NumericKind>();
            var images = new Dictionary<uint, NumericKind>();
            var variables = new List<(uint Id, uint Type, uint Storage)>();

            for (int at = 5; at < words.Length;)
            {
                int count = (int)(words[at] >> 16), op = (int)(words[at] & 0xffff);
                if (count == 0 || at + count > words.Length) throw new ArgumentException($"{name}: the SPIR-V module is cut off.");
                var w = words.Slice(at, count);
                switch (op)
                {
                    case OpDecorate when w[2] == Binding: binding[w[1]] = (int)w[3]; break;
                    case OpDecorate when w[2] == Location: location[w[1]] = (int)w[3]; break;
                    case OpDecorate when w[2] == NonWritable: nonWritable.Add(w[1]); break;
                    case OpMemberDecorate when w[3] == NonWritable: nonWritableMembers[w[1]] = nonWritableMembers.GetValueOrDefault(w[1]) + 1; break;
                    case OpTypeInt: numeric[w[1]] = w[3] == 0 ? NumericKind.UInt : NumericKind.SInt; break;
                    case OpTypeFloat: numeric[w[1]] = NumericKind.Float; break;
                    case OpTypeVector when numeric.TryGetValue(w[2], out var component): numeric[w[1]] = component; break;  // not of bools
                    case OpTypeImage: images[w[1]] = numeric[w[2]]; break;
                    case OpTypeStruct: members[w[1]] = count - 2; break;
                    case OpTypePointer: pointee[w[1]] = w[3]; break;
                    case OpVariable: variables.Add((w[2], w[1], w[3])); break;
                }
                at += count;
            }

            foreach (var v in variables)
            {
                uint type = pointee[v.Type];
                if (v.Storage == InputStorage && location.TryGetValue(v.Id, out int slot) && numeric.TryGetValue(type, out var kind))
                    Inputs[slot] = kind;
                if (!binding.TryGetValue(v.Id, out int b)) continue;
                if (nonWritable.Contains(v.Id) || members.TryGetValue(type, out int n) && n > 0
                    && nonWritableMembers.GetValueOrDefault(type) == n) NonWritableBindings.Add(b);
                if (images.TryGetValue(type, out var image)) ImageKinds[b] = image;
            }
        }
    }
}
