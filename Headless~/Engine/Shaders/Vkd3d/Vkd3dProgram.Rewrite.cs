using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;

namespace Host.Shaders
{
    /// <summary>Fixes for differences of vkd3d (1.2) from what this host binds, or from Direct3D.</summary>
    sealed partial class Vkd3dProgram
    {
        const uint DeviceScope = 1, WorkgroupScope = 2;
        const uint AcquireRelease = 0x8, UniformMemory = 0x40, WorkgroupMemory = 0x100, ImageMemory = 0x800;

        sealed class StorageBuffer
        {
            /// <summary>The struct around the array of words.</summary>
            public uint Pointer, WordPointer;
        }

        readonly Dictionary<uint, StorageBuffer> storageBuffers = new Dictionary<uint, StorageBuffer>();     // by variable
        StorageBuffer readOnlyType, writableType;

        // A texel buffer of words, whose length drivers limit, becomes a storage buffer of words.
        void MakeStorageBuffer(Instruction variable, bool readOnly)
        {
            ref StorageBuffer type = ref readOnly ? ref readOnlyType : ref writableType;
            if (type == null)
            {
                uint word = editor.Type(Op.TypeInt, 32, 0);
                uint array = editor.Add(new Instruction(Op.TypeRuntimeArray, editor.NewId(), word))[0];
                uint block = editor.Add(new Instruction(Op.TypeStruct, editor.NewId(), array))[0];
                editor.Decorate(array, Decoration.ArrayStride, 4);
                editor.Decorate(block, Decoration.BufferBlock);
                editor.DecorateMember(block, 0, Decoration.Offset, 0);
                if (readOnly)
                    editor.DecorateMember(block, 0, Decoration.NonWritable);
                type = new StorageBuffer
                {
                    Pointer = editor.Add(new Instruction(Op.TypePointer, editor.NewId(), (uint)StorageClass.Uniform, block))[0],
                    WordPointer = editor.Add(new Instruction(Op.TypePointer, editor.NewId(), (uint)StorageClass.Uniform, word))[0],
                };
            }
            storageBuffers.Add(variable[1], type);
            variable.Words[0] = type.Pointer;
            variable.Words[2] = (uint)StorageClass.Uniform;
        }

        void Rewrite()
        {
            var order = new DxbcBarriers(container);
            var barriers = new Queue<SyncFlags>(order.Barriers);
            if (order.HaveCommonUavs)
                MakeCoherent();
            var loaded = new Dictionary<uint, uint>();      // from what would be an image to its variable
            foreach (Instruction i in Reachable(module.Instructions))
                switch (i.Op)
                {
                    // Bound again.
                    case Op.Decorate when (Decoration)i[1] is Decoration.DescriptorSet or Decoration.Binding:
                    // Defined among the added types.
                    case Op.Variable when storageBuffers.ContainsKey(i[1]):
                        break;
                    case Op.Load when storageBuffers.ContainsKey(i[2]):
                        loaded.Add(i[1], i[2]);
                        break;
                    case Op.ImageFetch when loaded.TryGetValue(i[2], out uint buffer):
                    case Op.ImageRead when loaded.TryGetValue(i[2], out buffer):
                        ReadWord(i, buffer);
                        break;
                    case Op.ImageWrite when loaded.TryGetValue(i[0], out uint buffer):
                        WriteWord(i, buffer);
                        break;
                    case Op.ImageTexelPointer when storageBuffers.TryGetValue(i[2], out StorageBuffer type):
                        output.Add(new Instruction(Op.AccessChain, type.WordPointer, i[1], i[2], Zero, i[3]));
                        break;
                    case Op.ImageQuerySize when loaded.TryGetValue(i[2], out uint buffer):
                        output.Add(new Instruction(Op.ArrayLength, i[0], i[1], buffer, 0));
                        break;
                    case Op.ControlBarrier:
                    case Op.MemoryBarrier:
                        output.Add(Barrier(i, barriers));
                        break;
                    default:
                        KeepUnfused(i);
                        output.Add(i);
                        break;
                }
            if (barriers.Count > 0)
                throw new ProgramException($"vkd3d left out {barriers.Count} barriers.");
            foreach (Instruction variable in module.Instructions.Where(i => i.Op == Op.Variable && storageBuffers.ContainsKey(i[1])))
                editor.Add(variable);
            editor.Commit(output);
        }

        // vkd3d writes SV_RenderTargetArrayIndex, and does not say what a vertex program needs for it.
        void AllowLayers()
        {
            const uint layer = 9, shaderViewportIndexLayer = 5254;
            if (!module.Instructions.Any(i => i.Op == Op.Decorate && (Decoration)i[1] == Decoration.BuiltIn && i[2] == layer))
                return;
            byte[] text = Encoding.ASCII.GetBytes("SPV_EXT_shader_viewport_index_layer\0");
            module.Instructions.Insert(module.Instructions.FindLastIndex(i => i.Op == Op.Capability) + 1,
                new Instruction(Op.Extension, MemoryMarshal.Cast<byte, uint>(text).ToArray()));
            module.Instructions.Insert(0, new Instruction(Op.Capability, shaderViewportIndexLayer));
        }

        // vkd3d goes on behind the end of a block where a loop's last instruction leaves it.
        static IEnumerable<Instruction> Reachable(IEnumerable<Instruction> instructions)
        {
            bool ended = false;
            foreach (Instruction i in instructions)
            {
                ended &= i.Op != Op.Label && i.Op != Op.FunctionEnd;
                if (!ended)
                    yield return i;
                ended |= i.Op >= Op.Branch && i.Op <= Op.Unreachable;
            }
        }

        uint Zero => editor.Constant(editor.Definition(editor.Type(Op.TypeInt, 32, 0)), 0);

        uint Emit(Op op, uint type, params uint[] operands)
        {
            uint id = editor.NewId();
            output.Add(new Instruction(op, operands.Prepend(id).Prepend(type).ToArray()));
            return id;
        }

        uint WordAt(uint buffer, uint index) => Emit(Op.AccessChain, storageBuffers[buffer].WordPointer, buffer, Zero, index);

        // The value of a fetch is a vector of four, of which vkd3d takes the first.
        void ReadWord(Instruction fetch, uint buffer)
        {
            Instruction vector = editor.Definition(fetch[0]);
            uint word = Emit(Op.Load, vector[1], WordAt(buffer, fetch[3]));
            output.Add(new Instruction(Op.CompositeConstruct, Enumerable.Repeat(word, (int)vector[2]).Prepend(fetch[1]).Prepend(vector[0])
                .ToArray()));
        }

        void WriteWord(Instruction write, uint buffer)
        {
            uint word = Emit(Op.CompositeExtract, editor.Scalar(editor.TypeOf(write[2]))[0], write[2], 0);
            output.Add(new Instruction(Op.Store, WordAt(buffer, write[1]), word));
        }

        // vkd3d lets threads wait at a barrier that only orders memory, which hangs under a branch.
        Instruction Barrier(Instruction barrier, Queue<SyncFlags> flags)
        {
            if (flags.Count == 0)
                throw new ProgramException("vkd3d makes more barriers than the bytecode has.");
            SyncFlags sync = flags.Dequeue();
            Instruction word = editor.Definition(editor.Type(Op.TypeInt, 32, 0));
            bool uavs = (sync & (SyncFlags.UavOfGroup | SyncFlags.UavGlobal)) != 0;
            uint memory = AcquireRelease | ((sync & SyncFlags.Groupshared) != 0 ? WorkgroupMemory : 0) | (uavs ? UniformMemory | ImageMemory : 0);
            uint scope = editor.Constant(word, (sync & SyncFlags.UavGlobal) != 0 ? DeviceScope : WorkgroupScope),
                semantics = editor.Constant(word, memory);
            return (sync & SyncFlags.ThreadsInGroup) != 0
                ? new Instruction(Op.ControlBarrier, editor.Constant(word, WorkgroupScope), scope, semantics)
                : new Instruction(Op.MemoryBarrier, scope, semantics);
        }

        // Accesses that a barrier orders must be visible to the others, which Vulkan promises for coherent memory alone.
        void MakeCoherent()
        {
            foreach (BoundResource bound in definitions.Resources.Where(r => RegisterOf(r).StartsWith('u')))
                foreach (Instruction variable in module.Instructions.Where(i => i.Op == Op.Variable && IsResource(i)
                    && RegisterOf(types.Name(i[1])) == RegisterOf(bound)))
                    editor.Decorate(variable[1], Decoration.Coherent);
        }

        // FXC has fused what it may; under precise it has fused nothing.
        void KeepUnfused(Instruction i)
        {
            if (i.Op is Op.FAdd or Op.FSub or Op.FMul)
                editor.Decorate(i[1], Decoration.NoContraction);
        }
    }
}
