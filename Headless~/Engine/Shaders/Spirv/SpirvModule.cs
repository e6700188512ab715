using System;
using System.Collections.Generic;
using System.Text;

namespace Host.Shaders
{
    /// <summary>The instructions of SPIR-V that the rewriter looks at; others pass through by number.</summary>
    enum Op : ushort
    {
        Undef = 1, Name = 5, MemberName = 6, Extension = 10, ExtInstImport = 11, ExtInst = 12, EntryPoint = 15, ExecutionMode = 16, Capability = 17,
        TypeVoid = 19, TypeBool = 20, TypeInt = 21, TypeFloat = 22, TypeVector = 23, TypeMatrix = 24, TypeImage = 25, TypeSampler = 26,
        TypeSampledImage = 27, TypeArray = 28, TypeRuntimeArray = 29, TypeStruct = 30, TypePointer = 32, TypeFunction = 33,
        ConstantTrue = 41, Constant = 43, ConstantComposite = 44, ConstantNull = 46, SpecConstantOp = 52, Function = 54,
            FunctionParameter = 55, FunctionEnd = 56,
            FunctionCall = 57, Variable = 59, ImageTexelPointer = 60, Load = 61, Store = 62,
        CopyMemory = 63, AccessChain = 65, InBoundsAccessChain = 66, ArrayLength = 68, Decorate = 71, MemberDecorate = 72,
            CompositeConstruct = 80, CompositeExtract = 81, CopyObject = 83, SampledImage = 86,
        ImageFetch = 95, ImageRead = 98, ImageWrite = 99, ImageQuerySize = 104, ConvertFToU = 109, ConvertFToS = 110, Bitcast = 124,
            SNegate = 126, FAdd = 129, ISub = 130, FSub = 131, IMul = 132, FMul = 133,
        UDiv = 134, SDiv = 135, UMod = 137, SRem = 138, SMod = 139, FRem = 140, FMod = 141, LogicalOr = 166, Select = 169, IEqual = 170,
            SLessThan = 177,
        FUnordNotEqual = 183, FOrdLessThan = 184, FOrdGreaterThanEqual = 190, ShiftRightLogical = 194, ShiftRightArithmetic = 195,
            ShiftLeftLogical = 196, BitwiseAnd = 199,
        ControlBarrier = 224, MemoryBarrier = 225, AtomicLoad = 227, AtomicStore = 228, AtomicExchange = 229, AtomicCompareExchange = 230,
            AtomicXor = 242, Label = 248, Branch = 249, Unreachable = 255, DecorateId = 332,
        DecorateString = 5632, MemberDecorateString = 5633,
    }

    enum Decoration : uint
    {
        Block = 2, BufferBlock = 3, RowMajor = 4, ColMajor = 5, ArrayStride = 6, MatrixStride = 7, BuiltIn = 11, Flat = 14, Coherent = 23,
            NonWritable = 24, NonReadable = 25,
        Location = 30, Component = 31, Binding = 33, DescriptorSet = 34, Offset = 35, NoContraction = 42, CounterBuffer = 5634, UserSemantic = 5635,
    }

    enum StorageClass : uint { UniformConstant = 0, Input = 1, Uniform = 2, Output = 3, Workgroup = 4, Private = 6, Function = 7, StorageBuffer = 12 }

    sealed class Instruction
    {
        public Op Op;
        public uint[] Words;    // operands, without the leading word

        public Instruction(Op op, params uint[] words)
        {
            Op = op;
            Words = words;
        }

        public uint this[int i] => Words[i];
        /// <summary>A string operand from that word on.</summary>
        public string Text(int word)
        {
            var bytes = new byte[(Words.Length - word) * 4];
            Buffer.BlockCopy(Words, word * 4, bytes, 0, bytes.Length);
            return Encoding.UTF8.GetString(bytes, 0, Array.IndexOf(bytes, (byte)0));
        }
    }

    /// <summary>A SPIR-V binary as a list of instructions (SPIR-V specification 2.3, little-endian).</summary>
    sealed class SpirvModule
    {
        const uint Magic = 0x07230203;
        const int HeaderWords = 5;

        uint version, generator;
        uint bound;
        public List<Instruction> Instructions = new List<Instruction>();

        public uint NewId() => bound++;

        public static SpirvModule Read(byte[] binary)
        {
            var words = new uint[binary.Length / 4];
            Buffer.BlockCopy(binary, 0, words, 0, words.Length * 4);
            if (words.Length < HeaderWords || words[0] != Magic)
                throw new FormatException("This is no SPIR-V module.");
            var module = new SpirvModule { version = words[1], generator = words[2], bound = words[3] };
            for (int at = HeaderWords; at < words.Length;)
            {
                int length = (int)(words[at] >> 16);
                if (length == 0 || at + length > words.Length)
                    throw new FormatException($"The SPIR-V module is cut off at word {at}.");
                module.Instructions.Add(new Instruction((Op)(words[at] & 0xFFFF), words[(at + 1)..(at + length)]));
                at += length;
            }
            return module;
        }

        public byte[] Write()
        {
            var words = new List<uint> { Magic, version, generator, bound, 0 };
            foreach (Instruction i in Instructions)
            {
                words.Add((uint)(i.Words.Length + 1) << 16 | (uint)i.Op);
                words.AddRange(i.Words);
            }
            var binary = new byte[words.Count * 4];
            Buffer.BlockCopy(words.ToArray(), 0, binary, 0, binary.Length);
            return binary;
        }
    }
}
