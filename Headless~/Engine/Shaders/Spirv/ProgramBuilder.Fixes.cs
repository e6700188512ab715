using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>Fixes for differences of glslang's HLSL front end (12.0), or of Vulkan, from Direct3D.</summary>
    sealed partial class ProgramBuilder
    {
        // ByteAddressBuffer.GetDimensions gives bytes; glslang gives the length of its array of uints.
        void FixRawBufferSizes()
        {
            var raw = new HashSet<uint>(variables.Where(v => declarations.IsRaw(types.Name(v[1]))).Select(v => v[1]));
            uint four = 0;
            for (int i = 0; i < module.Instructions.Count; i++)
            {
                Instruction length = module.Instructions[i];
                if (length.Op != Op.ArrayLength || !raw.Contains(length[2]))
                    continue;
                if (four == 0)
                {
                    four = module.NewId();
                    addedGlobals.Add(new Instruction(Op.Constant, length[0], four, 4));
                }
                uint words = module.NewId(), bytes = length[1];
                length.Words[1] = words;
                module.Instructions.Insert(i + 1, new Instruction(Op.IMul, length[0], bytes, words, four));
            }
        }

        Dictionary<uint, uint> localTypes;

        // Type of a value or pointer.
        uint TypeOf(uint id)
        {
            if (types.Has(id))
                return types[id][0];
            if (localTypes == null)
            {
                localTypes = new Dictionary<uint, uint>();
                // Instructions with a result are defined before any use, so the operands of those without come too late.
                foreach (Instruction i in code.Where(i => i.Words.Length > 1))
                    localTypes.TryAdd(i[1], i[0]);
            }
            return localTypes[id];
        }

        // glslang does not look back on what it wrote; a driver may do anything with a module that is wrong.
        void CheckStores()
        {
            foreach (Instruction store in code.Where(i => i.Op == Op.Store))
                if (types[TypeOf(store[0])][2] != TypeOf(store[1]))
                    throw new ProgramException("glslang translated an assignment wrongly: simplify what is assigned in this program (a " +
                        "swizzle of several matrix elements?)");
        }

        // glslang gives atomics the signedness of their arguments (1 is an int, and so is a hidden counter's step), where
        // SPIR-V wants that of the memory.
        void FixAtomicTypes()
        {
            var constants = new Dictionary<(uint, uint), uint>();

            foreach (Instruction atomic in code.Where(i => i.Op >= Op.AtomicExchange && i.Op <= Op.AtomicXor && i.Words.Length > 5))
            {
                uint type = types[TypeOf(atomic[2])][2];
                for (int w = atomic.Op == Op.AtomicCompareExchange ? 6 : 5; w < atomic.Words.Length; w++)
                    atomic.Words[w] = Converted(atomic, atomic[w], type, constants);
                if (atomic[0] == type)
                    continue;
                uint wanted = atomic[0], result = atomic[1];
                atomic.Words[0] = type;
                atomic.Words[1] = module.NewId();
                module.Instructions.Insert(module.Instructions.IndexOf(atomic) + 1, new Instruction(Op.Bitcast, wanted, result, atomic[1]));
            }
        }

        uint Converted(Instruction user, uint value, uint type, Dictionary<(uint, uint), uint> constants)
        {
            if (types.Has(value) && types[value].Op == Op.Constant)
            {
                Instruction constant = types[value];
                if (constant[0] == type)
                    return value;
                if (!constants.TryGetValue((type, constant[2]), out uint same))
                {
                    constants[(type, constant[2])] = same = module.NewId();
                    addedGlobals.Add(new Instruction(Op.Constant, type, same, constant[2]));
                }
                return same;
            }
            if (TypeOf(value) == type)
                return value;
            uint converted = module.NewId();
            module.Instructions.Insert(module.Instructions.IndexOf(user), new Instruction(Op.Bitcast, type, converted, value));
            return converted;
        }

        // A remainder has the sign of the dividend, of fmod and of integers too; glslang gives it that of the divisor.
        void FixRemainders()
        {
            foreach (Instruction i in code)
                i.Op = i.Op == Op.SMod ? Op.SRem : i.Op == Op.FMod ? Op.FRem : i.Op;
        }

        // Direct3D counts SV_VertexID and SV_InstanceID from 0, Vulkan from the draw's first vertex and instance.
        void CountFromZero()
        {
            const uint vertexIndex = 42, instanceIndex = 43, baseVertex = 4424, baseInstance = 4425, drawParameters = 4427;
            bool any = false;
            foreach (Instruction variable in module.Instructions.Where(i => i.Op == Op.Variable && ClassOf(i) == StorageClass.Input).ToList())
            {
                uint builtIn = types.Decorated(variable[1], Decoration.BuiltIn)?[2] ?? 0;
                if (builtIn != vertexIndex && builtIn != instanceIndex)
                    continue;
                any = true;
                uint first = module.NewId();
                addedGlobals.Add(new Instruction(Op.Variable, variable[0], first, (uint)StorageClass.Input));
                added.Add(new Instruction(Op.Decorate, first, (uint)Decoration.BuiltIn, builtIn == vertexIndex ? baseVertex : baseInstance));
                entry.Words = entry.Words.Append(first).ToArray();
                for (int i = 0; i < module.Instructions.Count; i++)
                {
                    Instruction load = module.Instructions[i];
                    if (load.Op != Op.Load || load[2] != variable[1])
                        continue;
                    uint index = module.NewId(), start = module.NewId(), difference = load[1];
                    load.Words[1] = index;
                    module.Instructions.Insert(i + 1, new Instruction(Op.Load, load[0], start, first));
                    module.Instructions.Insert(i + 2, new Instruction(Op.ISub, load[0], difference, index, start));
                }
            }
            if (any)
                module.Instructions.Insert(0, new Instruction(Op.Capability, drawParameters));
        }

        // glslang sets the depth modes for a semantic anywhere in the file, whether or not this entry point writes depth.
        void FixDepthModes()
        {
            const uint fragDepth = 22, depthReplacing = 12, depthGreater = 14, depthUnchanged = 16;
            if (module.Instructions.Any(i => i.Op == Op.Decorate && (Decoration)i[1] == Decoration.BuiltIn && i[2] == fragDepth))
                return;
            module.Instructions.RemoveAll(i => i.Op == Op.ExecutionMode
                && (i[1] == depthReplacing || i[1] >= depthGreater && i[1] <= depthUnchanged));
        }

        // Direct3D converts what is written to the bound texture's own format, while Vulkan takes the format that the
        // shader names. So a texture that is only written names none. Reads keep it: reading without one is an optional
        // feature, and Direct3D 11 reads only R32 formats anyway. Buffers have no format but the shader's.
        void FreeImageFormats()
        {
            const uint unknown = 0, dimBuffer = 5, storageImageWriteWithoutFormat = 56;
            HashSet<uint> read = ReadImages();
            bool any = false;
            foreach (Instruction variable in variables.Where(v => ClassOf(v) == StorageClass.UniformConstant))
            {
                Instruction image = types.Pointee(variable);
                if (image.Op != Op.TypeImage || image[2] == dimBuffer || image[6] != 2 || image[7] == unknown || read.Contains(variable[1]))
                    continue;
                any = true;
                uint free = ImageWithoutFormat(image);
                uint pointer = module.NewId();
                addedGlobals.Add(new Instruction(Op.TypePointer, pointer, (uint)StorageClass.UniformConstant, free));
                variable.Words[0] = pointer;
                module.Instructions.Remove(variable);
                addedGlobals.Add(variable);
                foreach (Instruction load in code.Where(i => i.Op == Op.Load && i[2] == variable[1]))
                    load.Words[0] = free;
            }
            if (any)
                module.Instructions.Insert(0, new Instruction(Op.Capability, storageImageWriteWithoutFormat));
        }

        readonly Dictionary<uint, uint> imagesWithoutFormat = new Dictionary<uint, uint>();

        uint ImageWithoutFormat(Instruction image)
        {
            if (imagesWithoutFormat.TryGetValue(image[0], out uint id))
                return id;
            uint[] words = (uint[])image.Words.Clone();
            words[7] = 0;
            // Types other than aggregates may be declared once only.
            Instruction same = module.Instructions.Concat(addedGlobals).FirstOrDefault(i => i.Op == Op.TypeImage
                && i.Words.Skip(1).SequenceEqual(words.Skip(1)));
            if (same != null)
                id = same[0];
            else
            {
                id = words[0] = module.NewId();
                addedGlobals.Add(new Instruction(Op.TypeImage, words));
            }
            imagesWithoutFormat[image[0]] = id;
            return id;
        }

        HashSet<uint> ReadImages()
        {
            var loaded = new Dictionary<uint, uint>();  // value to variable
            var read = new HashSet<uint>();
            foreach (Instruction i in code)
                switch (i.Op)
                {
                    case Op.Load:
                        loaded[i[1]] = i[2];
                        break;
                    case Op.ImageRead:
                        if (loaded.TryGetValue(i[2], out uint variable))
                            read.Add(variable);
                        break;
                    case Op.ImageTexelPointer:
                        read.Add(i[2]);
                        break;
                    case Op.FunctionCall:   // what becomes of it there is unknown
                        foreach (uint argument in i.Words.Skip(3))
                        {
                            read.Add(argument);
                            if (loaded.TryGetValue(argument, out variable))
                                read.Add(variable);
                        }
                        break;
                }
            return read;
        }
    }
}
