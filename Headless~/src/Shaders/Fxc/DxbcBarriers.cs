using System;
using System.Collections.Generic;

namespace Host.Shaders
{
    /// <summary>What a sync instruction of shader model 5 does.</summary>
    [Flags]
    enum SyncFlags
    {
        /// <summary>Threads wait for one another.</summary>
        ThreadsInGroup = 1,
        Groupshared = 2, UavOfGroup = 4, UavGlobal = 8,
    }

    static class DxbcBarriers
    {
        const uint Sync = 190, CustomData = 53;
        const int FlagsShift = 11;

        /// <summary>The program's sync instructions in their order.</summary>
        /// <exception cref="FormatException">The program is cut off.</exception>
        public static List<SyncFlags> Read(DxbcContainer container)
        {
            byte[] program = container.Program;
            uint Word(int at) => DxbcContainer.UInt(program, at * 4);
            var barriers = new List<SyncFlags>();
            int words = (int)Math.Min(Word(1), program.Length / 4);
            for (int at = 2, length; at < words; at += length)
            {
                uint token = Word(at), opcode = token & 0x7FF;
                length = (int)(opcode == CustomData ? Word(at + 1) : token >> 24 & 0x7F);
                if (length == 0 || at + length > words)
                    throw new FormatException($"The program in the DXBC container is cut off at word {at}.");
                if (opcode == Sync)
                    barriers.Add((SyncFlags)(token >> FlagsShift & 0xF));
            }
            return barriers;
        }
    }
}
