using System;
using System.Collections.Generic;

namespace Host.Shaders
{
    enum Packing
    {
        /// <summary>Structured buffers, group-shared memory: scalars one behind the other, each aligned to its own size.</summary>
        Structured,
        /// <summary>cbuffers: registers of 16 bytes.</summary>
        Constant,
    }

    /// <summary>
    /// Offsets and strides as Direct3D 11 has them, for types that glslang laid out as std430 or std140.
    /// </summary>
    /// <remarks>
    /// Structured: a float3 is 12 bytes and nothing is padded, except that a struct with doubles is aligned to 8.
    /// Constant ("Packing Rules for Constant Variables"): a vector does not straddle a register; arrays, structs and
    /// matrices of more than one register start a register, each array element too; what follows may fill up the last
    /// element's register.
    /// </remarks>
    sealed class DirectXLayout
    {
        const int Register = 16;

        readonly SpirvTypes types;
        readonly Dictionary<uint, Packing> assigned = new Dictionary<uint, Packing>();

        public DirectXLayout(SpirvTypes types) { this.types = types; }

        /// <summary>Rewrites the decorations of a block and of all that it contains.</summary>
        /// <param name="placed">Of a member of the block, the byte that the source puts it at, if any.</param>
        public void Apply(Instruction block, Packing packing, Func<int, int?> placed = null)
        {
            if (block.Op == Op.TypeArray || block.Op == Op.TypeRuntimeArray)
            {
                Claim(block, packing);
                Instruction element = types[block[1]];
                SetStride(block, packing, MatrixOf(element) == null ? ElementStride(element, false, packing) : -1);
                Apply(element, packing);
            }
            else if (block.Op == Op.TypeStruct)
            {
                Claim(block, packing);
                int end = 0;
                for (int m = 0; m < block.Words.Length - 1; m++)
                {
                    Instruction type = types[block[m + 1]];
                    bool rowMajor = IsRowMajor(block, m);
                    end = placed?.Invoke(m) ?? Align(end, type, rowMajor, packing);
                    Set(types.Decorated(block[0], m, Decoration.Offset), 3, end);
                    Instruction matrix = MatrixOf(type);
                    if (matrix != null)
                    {
                        Set(types.Decorated(block[0], m, Decoration.MatrixStride), 3, MatrixStride(matrix, rowMajor, packing));
                        SetMatrixArrays(type, rowMajor, packing);
                    }
                    else
                        Apply(type, packing);
                    end += Size(type, rowMajor, packing);
                }
            }
        }

        // Strides of arrays of matrices depend on the member's majorness, which only the struct knows.
        void SetMatrixArrays(Instruction type, bool rowMajor, Packing packing)
        {
            for (; type.Op == Op.TypeArray || type.Op == Op.TypeRuntimeArray; type = types[type[1]])
            {
                Claim(type, packing);
                SetStride(type, packing, ElementStride(types[type[1]], rowMajor, packing));
            }
        }

        // glslang makes a type again for each layout; one that both packings reach could not be decorated for both.
        void Claim(Instruction type, Packing packing)
        {
            if (assigned.TryGetValue(type[0], out Packing other) && other != packing)
                throw new ProgramException($"Type '{types.Name(type[0])}' is laid out as a cbuffer and as a structured buffer at once; " +
                    $"declare it twice under two names.");
            assigned[type[0]] = packing;
        }

        void SetStride(Instruction array, Packing packing, int stride)
        {
            if (stride >= 0)
                Set(types.Decorated(array[0], Decoration.ArrayStride), 2, stride);
        }

        static void Set(Instruction decoration, int word, int value)
        {
            if (decoration == null)
                throw new ProgramException("glslang left a member of a block without a layout.");
            decoration.Words[word] = (uint)value;
        }

        /// <summary>HLSL's row_major. glslang's matrices are transposed (an HLSL row is a SPIR-V column), and so is the decoration.</summary>
        public bool IsRowMajor(Instruction block, int member) => types.Decorated(block[0], member, Decoration.ColMajor) != null;

        /// <summary>The matrix type in a matrix or array of matrices; otherwise null.</summary>
        public Instruction MatrixOf(Instruction type)
        {
            while (type.Op == Op.TypeArray || type.Op == Op.TypeRuntimeArray)
                type = types[type[1]];
            return type.Op == Op.TypeMatrix ? type : null;
        }

        /// <summary>Bytes between HLSL columns (column-major) or rows (row_major).</summary>
        public int MatrixStride(Instruction matrix, bool rowMajor, Packing packing)
        {
            if (packing == Packing.Constant)
                return Register;
            Instruction row = types[matrix[1]];
            return types.ScalarBytes(types[row[1]]) * (rowMajor ? (int)row[2] : (int)matrix[2]);
        }

        public int ElementStride(Instruction element, bool rowMajor, Packing packing)
        {
            int size = Size(element, rowMajor, packing);
            return packing == Packing.Constant ? RoundUp(size, Register) : RoundUp(size, Alignment(element));
        }

        /// <summary>Bytes from the first to the last; trailing padding is not counted for cbuffers.</summary>
        public int Size(Instruction type, bool rowMajor, Packing packing)
        {
            switch (type.Op)
            {
                case Op.TypeVector:
                    return (int)type[2] * types.ScalarBytes(types[type[1]]);
                case Op.TypeMatrix:
                {
                    Instruction row = types[type[1]];
                    int rows = (int)type[2], columns = (int)row[2], scalar = types.ScalarBytes(types[row[1]]);
                    int vectors = rowMajor ? rows : columns, length = rowMajor ? columns : rows;
                    return (vectors - 1) * MatrixStride(type, rowMajor, packing) + length * scalar;
                }
                case Op.TypeArray:
                {
                    Instruction element = types[type[1]];
                    int count = types.Constant(type[2]);
                    return (count - 1) * ElementStride(element, rowMajor, packing) + Size(element, rowMajor, packing);
                }
                case Op.TypeRuntimeArray:
                    return 0;
                case Op.TypeStruct:
                {
                    int end = 0;
                    for (int m = 0; m < type.Words.Length - 1; m++)
                    {
                        Instruction member = types[type[m + 1]];
                        bool memberRowMajor = IsRowMajor(type, m);
                        end = Align(end, member, memberRowMajor, packing) + Size(member, memberRowMajor, packing);
                    }
                    return packing == Packing.Structured ? RoundUp(end, Alignment(type)) : end;
                }
                default:
                    return types.ScalarBytes(type);
            }
        }

        int Align(int offset, Instruction type, bool rowMajor, Packing packing)
        {
            offset = RoundUp(offset, Alignment(type));
            if (packing == Packing.Structured)
                return offset;
            bool startsRegister = type.Op == Op.TypeArray || type.Op == Op.TypeStruct || type.Op == Op.TypeMatrix;
            bool straddles = offset % Register + Size(type, rowMajor, packing) > Register;
            return startsRegister || straddles ? RoundUp(offset, Register) : offset;
        }

        // Alignment of the largest scalar inside.
        int Alignment(Instruction type)
        {
            switch (type.Op)
            {
                case Op.TypeVector:
                case Op.TypeMatrix:
                case Op.TypeArray:
                case Op.TypeRuntimeArray:
                    return Alignment(types[type[1]]);
                case Op.TypeStruct:
                {
                    int largest = 4;
                    for (int m = 1; m < type.Words.Length; m++)
                        largest = Math.Max(largest, Alignment(types[type[m]]));
                    return largest;
                }
                default:
                    return types.ScalarBytes(type);
            }
        }

        static int RoundUp(int value, int to) => (value + to - 1) / to * to;
    }
}
