using System;
using System.Collections.Generic;

namespace Host.Shaders
{
    /// <summary>Effects of a sync instruction of shader model 5.</summary>
    [Flags]
    enum SyncFlags
    {
        /// <summary>Threads wait for one another.</summary>
        ThreadsInGroup = 1,
        Groupshared = 2, UavOfGroup = 4, UavGlobal = 8,
    }

    /// <summary>How a program orders its memory.</summary>
    sealed class DxbcBarriers
    {
        const uint CustomData = 53, TypedUav = 156, StructuredUav = 158, Sync = 190, GloballyCoherent = 1 << 16;
        const int FlagsShift = 11;

        /// <summary>The sync instructions in their order.</summary>
        public readonly List<SyncFlags> Barriers = new List<SyncFlags>();
        /// <summary>Whether threads look at what others wrote to buffers or textures: behind such a barrier, or where one is declared
        /// globallycoherent.</summary>
        public readonly bool HaveCommonUavs;

        /// <exception cref="FormatException">The program is cut off.</exception>
        public DxbcBarriers(DxbcContainer container)
        {
            byte[] program = container.Program;
            uint Word(int at) => DxbcContainer.UInt(program, at * 4);
            int words = (int)Math.Min(Word(1), program.Length / 4);
            for (int at = 2, length; at < words; at += length)
            {
                uint token = Word(at), opcode = token & 0x7FF;
                length = (int)(opcode == CustomData ? Word(at + 1) : token >> 24 & 0x7F);
                if (length == 0 || at + length > words)
                    throw new FormatException($"The program in the DXBC container is cut off at word {at}.");
                if (opcode == Sync)
                    Barriers.Add((SyncFlags)(token >> FlagsShift & 0xF));
                else if (opcode >= TypedUav && opcode <= StructuredUav)
                    HaveCommonUavs |= (token & GloballyCoherent) != 0;
            }
            HaveCommonUavs |= Barriers.Exists(b => (b & (SyncFlags.UavOfGroup | SyncFlags.UavGlobal)) != 0);
        }
    }
}
