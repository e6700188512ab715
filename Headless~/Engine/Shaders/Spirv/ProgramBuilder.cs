using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>A value that a vertex program hands to the fragment program.</summary>
    sealed class Varying
    {
        public string Semantic;     // with its index, upper case: TEXCOORD0
        public int Location, Components;
        /// <summary>The component of the location that it starts at: Direct3D packs several into one register.</summary>
        public int First;
    }

    /// <summary>A program with what its successor in the pipeline has to know.</summary>
    sealed class CompiledProgram
    {
        public ShaderProgram Program;
        /// <summary>Vertex programs only.</summary>
        public Varying[] Outputs = Array.Empty<Varying>();
        /// <summary>Reason why requested bytecode of FXC was not available; otherwise null.</summary>
        public string WhyGlslang;
    }

    /// <summary>A fault found in a compiled module; the compiler adds the file.</summary>
    sealed class ProgramException : Exception { public ProgramException(string message) : base(message) { } }

    /// <summary>
    /// Turns glslang's module into one that binds and lays out its resources as Direct3D 11 does, and says what has to be
    /// bound.
    /// </summary>
    sealed partial class ProgramBuilder
    {
        /// <summary>Part of the cache's keys: another build of this assembly may rewrite differently.</summary>
        public static string Version => typeof(ProgramBuilder).Module.ModuleVersionId.ToString();
        const int FirstFragmentBinding = 32;

        readonly SpirvModule module;
        readonly SpirvTypes types;
        readonly DirectXLayout layout;
        readonly SourceDeclarations declarations;
        readonly ShaderStage stage;
        readonly Instruction entry;
        readonly List<Instruction> code = new List<Instruction>();      // of the functions that the entry point reaches
        readonly HashSet<uint> used = new HashSet<uint>();              // global variables that they touch
        readonly List<Instruction> variables;                           // used, in order of declaration
        readonly List<Instruction> added = new List<Instruction>();     // decorations
        readonly List<Instruction> addedGlobals = new List<Instruction>(); // types, constants and variables

        ProgramBuilder(byte[] spirv, ShaderStage stage, SourceDeclarations declarations)
        {
            module = SpirvModule.Read(spirv);
            types = new SpirvTypes(module);
            layout = new DirectXLayout(types);
            this.declarations = declarations;
            this.stage = stage;
            entry = module.Instructions.First(i => i.Op == Op.EntryPoint);
            FollowCalls();
            variables = module.Instructions.Where(i => i.Op == Op.Variable && used.Contains(i[1])).ToList();
        }

        /// <param name="vertexOutputs">Fragment programs: what the vertex program of the same pass writes.</param>
        public static CompiledProgram Build(byte[] spirv, string name, ShaderStage stage, SourceDeclarations declarations, Varying[] vertexOutputs)
        {
            var builder = new ProgramBuilder(spirv, stage, declarations);
            var program = new ShaderProgram { Name = name, Stage = stage, EntryPoint = builder.entry.Text(2) };
            var result = new CompiledProgram { Program = program };

            builder.CheckStores();
            builder.FixRawBufferSizes();
            builder.FixAtomicTypes();
            builder.FixDepthModes();
            builder.FixRemainders();
            if (stage == ShaderStage.Vertex)
                builder.CountFromZero();
            program.Resources = builder.BindResources();
            program.UavCount = program.Resources.Count(r => r.IsUnorderedAccess());
            builder.FreeImageFormats();
            if (stage == ShaderStage.Compute)
                builder.DescribeGroup(program);
            else
                builder.AssignLocations(result, vertexOutputs);
            builder.Rebuild();
            DirectXArithmetic.Apply(builder.module);
            program.Spirv = builder.module.Write();
            return result;
        }

        // ---- what the entry point reaches

        void FollowCalls()
        {
            var functions = new Dictionary<uint, (int begin, int end)>();
            for (int i = 0, begin = 0; i < module.Instructions.Count; i++)
            {
                if (module.Instructions[i].Op == Op.Function)
                    begin = i;
                else if (module.Instructions[i].Op == Op.FunctionEnd)
                    functions[module.Instructions[begin][1]] = (begin, i);
            }

            var seen = new HashSet<uint> { entry[1] };
            var open = new Queue<uint>(seen);
            while (open.Count > 0)
            {
                (int begin, int end) = functions[open.Dequeue()];
                for (int i = begin; i <= end; i++)
                {
                    Instruction instruction = module.Instructions[i];
                    code.Add(instruction);
                    if (instruction.Op == Op.FunctionCall && seen.Add(instruction[2]))
                        open.Enqueue(instruction[2]);
                    foreach (uint pointer in PointersOf(instruction))
                        used.Add(pointer);
                }
            }
        }

        // The operands through which an instruction may reach a variable.
        static IEnumerable<uint> PointersOf(Instruction i)
        {
            switch (i.Op)
            {
                case Op.Store:
                case Op.AtomicStore:
                    return new[] { i[0] };
                case Op.CopyMemory:
                    return new[] { i[0], i[1] };
                case Op.Load:
                case Op.AccessChain:
                case Op.InBoundsAccessChain:
                case Op.ArrayLength:
                case Op.ImageTexelPointer:
                case Op.CopyObject:
                    return new[] { i[2] };
                case Op.FunctionCall:
                    return i.Words.Skip(3);
                default:
                    return i.Op >= Op.AtomicLoad && i.Op <= Op.AtomicXor ? new[] { i[2] } : Array.Empty<uint>();
            }
        }

        static StorageClass ClassOf(Instruction variable) => (StorageClass)variable[2];
        static bool IsResource(Instruction variable) => ClassOf(variable) == StorageClass.UniformConstant
            || ClassOf(variable) == StorageClass.Uniform || ClassOf(variable) == StorageClass.StorageBuffer;

        // ---- resources

        ShaderResource[] BindResources()
        {
            var resources = new List<ShaderResource>();
            int binding = stage == ShaderStage.Fragment ? FirstFragmentBinding : 0;
            foreach (Instruction variable in variables.Where(IsResource))
            {
                ShaderResource resource = Describe(variable);
                resource.Binding = binding++;
                added.Add(new Instruction(Op.Decorate, variable[1], (uint)Decoration.DescriptorSet, 0));
                added.Add(new Instruction(Op.Decorate, variable[1], (uint)Decoration.Binding, (uint)resource.Binding));
                resources.Add(resource);
            }
            var sampled = SampledTextures();
            foreach (ShaderResource sampler in resources.Where(r => r.Kind == ShaderResourceKind.Sampler))
                sampler.SampledTextures = sampled[sampler.Name].ToArray();
            return resources.ToArray();
        }

        ShaderResource Describe(Instruction variable)
        {
            Instruction type = types.Pointee(variable);
            string name = types.Name(variable[1]);
            switch (type.Op)
            {
                case Op.TypeStruct:
                    return types.Decorated(type[0], Decoration.BufferBlock) != null || ClassOf(variable) == StorageClass.StorageBuffer
                        ? DescribeBuffer(name, type)
                        : DescribeConstants(types.Name(type[0]), type);
                case Op.TypeSampler:
                    return InlineSampler.Describe(name, declarations);
                case Op.TypeImage:
                    return DescribeImage(name, type);
                case Op.TypeSampledImage:
                    throw new ProgramException($"'{name}' is a combined texture and sampler; declare a Texture and a SamplerState.");
                case Op.TypeArray:
                    throw new ProgramException($"'{name}' is an array of resources, which this host does not bind; declare them one by one.");
                default:
                    throw new ProgramException($"'{name}' is of a kind of resource that this host does not know (SPIR-V type {type.Op}).");
            }
        }

        ShaderResource DescribeBuffer(string name, Instruction block)
        {
            const string counterSuffix = "@count";
            uint glslangStride = StrideOf(block);
            layout.Apply(block, Packing.Structured);
            if (name.EndsWith(counterSuffix))
                return new ShaderResource { Name = name.Substring(0, name.Length - counterSuffix.Length), Kind = ShaderResourceKind.Counter,
                    Stride = 4 };

            string declared = declarations.TypeOf(name);
            bool readOnly = types.Decorated(block[0], 0, Decoration.NonWritable) != null;
            bool raw = declared == "ByteAddressBuffer" || declared == "RWByteAddressBuffer";
            Instruction element = types[block[1]];
            if (element.Op != Op.TypeRuntimeArray)
                throw new ProgramException($"'{name}' is a {declared ?? "buffer"} of a kind that this host does not bind (a tbuffer?).");
            if (!raw && StrideOf(block) != glslangStride && declarations.AsksDimensions(name))
                throw new ProgramException($"{name}.GetDimensions would give a stride of {glslangStride} here, Direct3D's is " +
                    $"{StrideOf(block)}; pass the count in as a parameter, or pad the element to 16 bytes.");
            return new ShaderResource
            {
                Name = name,
                Kind = raw ? (readOnly ? ShaderResourceKind.RawBuffer : ShaderResourceKind.RWRawBuffer)
                           : readOnly ? ShaderResourceKind.StructuredBuffer : ShaderResourceKind.RWStructuredBuffer,
                Stride = raw ? 4 : layout.ElementStride(types[element[1]], layout.IsRowMajor(block, 0), Packing.Structured),
                IsAppendConsume = declared == "AppendStructuredBuffer" || declared == "ConsumeStructuredBuffer",
            };
        }

        // Stride of the runtime array in a structured buffer's block; 0 for a hidden counter's.
        uint StrideOf(Instruction block) => types.Decorated(block[1], Decoration.ArrayStride)?[2] ?? 0;

        ShaderResource DescribeConstants(string name, Instruction block)
        {
            layout.Apply(block, Packing.Constant, m => declarations.PackOffset(types.MemberName(block[0], m)));
            int end = Enumerable.Range(0, block.Words.Length - 1)
                .Max(m => (int)types.Decorated(block[0], m, Decoration.Offset)[3] + layout.Size(types[block[m + 1]],
                layout.IsRowMajor(block, m), Packing.Constant));
            bool globals = name == "$Global";
            return new ShaderResource
            {
                Name = globals ? "$Globals" : name,
                Kind = ShaderResourceKind.ConstantBuffer,
                Constants = new ConstantLayout
                {
                    Bytes = (end + 15) / 16 * 16,
                    IsGlobals = globals,
                    Fields = Enumerable.Range(0, block.Words.Length - 1).Where(m => IsSettable(types[block[m + 1]]))
                        .Select(m => DescribeField(block, m)).ToArray(),
                },
            };
        }

        // Unity sets numbers and arrays of numbers by name; a struct inside a cbuffer is reached only through a whole constant buffer.
        bool IsSettable(Instruction type)
        {
            if (type.Op == Op.TypeArray)
                type = types[type[1]];
            return type.Op != Op.TypeStruct && type.Op != Op.TypeArray;
        }

        ConstantField DescribeField(Instruction block, int member)
        {
            Instruction type = types[block[member + 1]];
            bool rowMajor = layout.IsRowMajor(block, member);
            var field = new ConstantField
            {
                Name = types.MemberName(block[0], member),
                Offset = (int)types.Decorated(block[0], member, Decoration.Offset)[3],
                Bytes = layout.Size(type, rowMajor, Packing.Constant),
                RowMajor = rowMajor,
                Rows = 1,
                Columns = 1,
            };
            if (type.Op == Op.TypeArray)
            {
                field.ArrayLength = types.Constant(type[2]);
                type = types[type[1]];
                field.ArrayStride = layout.ElementStride(type, rowMajor, Packing.Constant);
            }
            if (type.Op == Op.TypeMatrix)
            {
                field.Rows = (int)type[2];
                field.MatrixStride = layout.MatrixStride(type, rowMajor, Packing.Constant);
                type = types[type[1]];
            }
            if (type.Op == Op.TypeVector)
            {
                field.Columns = (int)type[2];
                type = types[type[1]];
            }
            field.Type = type.Op == Op.TypeFloat ? ConstantType.Float : type.Op == Op.TypeInt && type[2] != 0 ? ConstantType.Int : ConstantType.UInt;
            if (types.ScalarBytes(type) != 4)
                throw new ProgramException($"'{field.Name}' is a double in a constant buffer, which Unity cannot set.");
            return field;
        }

        ShaderResource DescribeImage(string name, Instruction image)
        {
            const uint dim1D = 0, dim3D = 2, dimCube = 3, dimBuffer = 5;
            uint dim = image[2];
            bool arrayed = image[4] != 0, multisampled = image[5] != 0, storage = image[6] == 2;
            if (dim == dim1D || multisampled)
                throw new ProgramException($"'{name}' is a 1D or multisampled texture, which this host does not bind.");
            return new ShaderResource
            {
                Name = name,
                Kind = dim == dimBuffer ? (storage ? ShaderResourceKind.RWTypedBuffer : ShaderResourceKind.TypedBuffer)
                                        : storage ? ShaderResourceKind.RWTexture : ShaderResourceKind.Texture,
                Dimension = dim == dim3D ? DeviceTextureDimension.Tex3D : dim == dimCube ? arrayed ? DeviceTextureDimension.CubeArray
                    : DeviceTextureDimension.Cube
                          : arrayed ? DeviceTextureDimension.Tex2DArray : DeviceTextureDimension.Tex2D,
                ElementFormat = FormatOf(image[7]),
            };
        }

        // SPIR-V specification 3.11, Image Format.
        static DeviceFormat FormatOf(uint imageFormat)
        {
            switch (imageFormat)
            {
                case 1: return DeviceFormat.RGBA32_Float;
                case 2: return DeviceFormat.RGBA16_Float;
                case 3: return DeviceFormat.R32_Float;
                case 6: return DeviceFormat.RG32_Float;
                case 21: return DeviceFormat.RGBA32_SInt;
                case 24: return DeviceFormat.R32_SInt;
                case 25: return DeviceFormat.RG32_SInt;
                case 30: return DeviceFormat.RGBA32_UInt;
                case 33: return DeviceFormat.R32_UInt;
                case 35: return DeviceFormat.RG32_UInt;
                default: return DeviceFormat.None;
            }
        }

        // ---- compute

        void DescribeGroup(ShaderProgram program)
        {
            const uint localSize = 17;
            Instruction size = module.Instructions.First(i => i.Op == Op.ExecutionMode && i[1] == localSize);
            program.GroupX = (int)size[2];
            program.GroupY = (int)size[3];
            program.GroupZ = (int)size[4];
            program.GroupsharedBytes = variables.Where(v => ClassOf(v) == StorageClass.Workgroup)
                .Sum(v => layout.Size(types.Pointee(v), false, Packing.Structured));
        }

        // ---- putting it together

        void Rebuild()
        {
            var dropped = new HashSet<uint>(module.Instructions.Where(i => i.Op == Op.Variable && IsResource(i) && !used.Contains(i[1]))
                .Select(i => i[1]));
            var kept = new List<Instruction>();
            bool decorated = false, defined = false;
            foreach (Instruction i in module.Instructions)
            {
                if (!decorated && i.Op >= Op.TypeVoid && i.Op <= Op.TypePointer)
                {
                    kept.AddRange(added);
                    decorated = true;
                }
                if (!defined && i.Op == Op.Function)
                {
                    kept.AddRange(addedGlobals);
                    defined = true;
                }
                if (!IsObsolete(i, dropped))
                    kept.Add(i);
            }
            module.Instructions = kept;
        }

        static bool IsObsolete(Instruction i, HashSet<uint> dropped)
        {
            switch (i.Op)
            {
                // Names of semantics and counters have been read; no device needs the extension.
                case Op.Extension:
                    return i.Text(0).StartsWith("SPV_GOOGLE_");
                case Op.DecorateId:
                case Op.DecorateString:
                case Op.MemberDecorateString:
                    return true;
                case Op.Decorate:
                    return dropped.Contains(i[0]) || (Decoration)i[1] == Decoration.DescriptorSet || (Decoration)i[1] == Decoration.Binding;
                case Op.Name:
                    return dropped.Contains(i[0]);
                case Op.Variable:
                    return dropped.Contains(i[1]);
                default:
                    return false;
            }
        }
    }
}
