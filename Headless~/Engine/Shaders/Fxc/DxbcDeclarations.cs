using System;

namespace Host.Shaders
{
    /// <summary>Declarations of a shader model 4 or 5 program before its first instruction (d3d11TokenizedProgramFormat.hpp names the
    /// tokens).</summary>
    sealed class DxbcDeclarations
    {
        enum Opcode
        {
            CustomData = 53, Resource = 88, ConstantBuffer = 89, Sampler = 90,
            ThreadGroup = 155, TypedUav = 156, RawUav = 157, StructuredUav = 158, RawGroupshared = 159, StructuredGroupshared = 160,
                RawResource = 161, StructuredResource = 162,
        }

        public readonly (int x, int y, int z) GroupSize;
        public readonly int GroupsharedBytes;
        /// <summary>u registers, of which Direct3D 11.0 has 8.</summary>
        public readonly int Uavs;
        /// <summary>t registers that hold a texture or a Buffer&lt;T&gt;.</summary>
        public readonly int Textures;
        /// <summary>t registers that hold a StructuredBuffer or ByteAddressBuffer.</summary>
        public readonly int Buffers;
        public readonly int Samplers;
        public readonly int ConstantBuffers;

        /// <exception cref="FormatException">The program is cut off.</exception>
        public DxbcDeclarations(DxbcContainer container)
        {
            byte[] program = container.Program;
            uint Word(int at) => DxbcContainer.UInt(program, at * 4);
            int words = (int)Math.Min(Word(1), program.Length / 4);
            for (int at = 2, length; at < words; at += length)
            {
                uint token = Word(at);
                var opcode = (Opcode)(token & 0x7FF);
                length = (int)(opcode == Opcode.CustomData ? Word(at + 1) : token >> 24 & 0x7F);
                if (length == 0 || at + length > words)
                    throw new FormatException($"The program in the DXBC container is cut off at word {at}.");
                int last = at + length - 1;
                switch (opcode)
                {
                    case Opcode.ThreadGroup: GroupSize = ((int)Word(at + 1), (int)Word(at + 2), (int)Word(at + 3)); break;
                    case Opcode.RawGroupshared: GroupsharedBytes += (int)Word(last); break;
                    case Opcode.StructuredGroupshared: GroupsharedBytes += (int)(Word(last - 1) * Word(last)); break;     // stride, count
                    case Opcode.TypedUav:
                    case Opcode.RawUav:
                    case Opcode.StructuredUav: Uavs++; break;
                    case Opcode.Resource: Textures++; break;
                    case Opcode.RawResource:
                    case Opcode.StructuredResource: Buffers++; break;
                    case Opcode.Sampler: Samplers++; break;
                    case Opcode.ConstantBuffer: ConstantBuffers++; break;
                }
            }
        }
    }
}
