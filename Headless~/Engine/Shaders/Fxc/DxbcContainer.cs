using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Host.Shaders
{
    /// <summary>Output of FXC: named chunks after a header of "DXBC", a checksum of 16 bytes, version 1, the total size and the chunks'
    /// offsets. Little-endian.</summary>
    sealed class DxbcContainer
    {
        const int HeaderBytes = 32, ChunkHeaderBytes = 8;

        readonly List<(string name, byte[] bytes)> chunks = new List<(string, byte[])>();

        /// <exception cref="FormatException">This is no DXBC, or it is cut off.</exception>
        public DxbcContainer(byte[] container)
        {
            if (container.Length < HeaderBytes || Encoding.ASCII.GetString(container, 0, 4) != "DXBC")
                throw new FormatException("This is no DXBC container.");
            uint size = UInt(container, 24), count = UInt(container, 28);
            if (size != container.Length || count > (container.Length - HeaderBytes) / 4)
                throw new FormatException(
                    $"The DXBC container says that it has {size} bytes and {count} chunks, but {container.Length} bytes are here.");
            for (int i = 0; i < count; i++)
            {
                long at = UInt(container, HeaderBytes + 4 * i);
                if (at + ChunkHeaderBytes > container.Length || at + ChunkHeaderBytes + UInt(container, (int)at + 4) > container.Length)
                    throw new FormatException($"Chunk {i} of the DXBC container, at byte {at}, is cut off.");
                int start = (int)at + ChunkHeaderBytes;
                chunks.Add((Encoding.ASCII.GetString(container, (int)at, 4), container[start..(start + (int)UInt(container, (int)at + 4))]));
            }
        }

        /// <summary>RDEF (resources), ISGN and OSGN (what goes in and out), SHEX or SHDR (the program), STAT (counts).</summary>
        public IEnumerable<string> Names => chunks.Select(chunk => chunk.name);

        /// <summary>Without the chunk's own header; null when it is not there.</summary>
        public byte[] Find(string name) => chunks.FirstOrDefault(chunk => chunk.name == name).bytes;

        /// <exception cref="FormatException">It is not there.</exception>
        public byte[] Chunk(string name) => Find(name)
            ?? throw new FormatException($"The DXBC container has no {name} chunk; it has {string.Join(", ", Names)}.");

        /// <summary>SHEX (shader model 5) or SHDR (4).</summary>
        /// <exception cref="FormatException">There is none.</exception>
        public byte[] Program => Find("SHEX") ?? Chunk("SHDR");

        public static uint UInt(byte[] bytes, int at) => BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(at, 4));
    }
}
