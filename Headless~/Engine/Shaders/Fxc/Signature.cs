using System;
using System.Collections.Generic;
using System.Text;

namespace Host.Shaders
{
    /// <summary>A value that a stage takes or gives, D3D11_SIGNATURE_PARAMETER_DESC.</summary>
    sealed class SignatureElement
    {
        public Semantic Semantic;
        /// <summary>D3D_NAME: 0 for values that the source hands on, else a system value.</summary>
        public int SystemValue;
        /// <summary>v or o register; -1 for those outside the registers (oDepth).</summary>
        public int Register;
        /// <summary>x 1, y 2, z 4, w 8.</summary>
        public int Mask;
        /// <summary>Components of inputs that the program reads.</summary>
        public int ReadMask;
    }

    /// <summary>The ISGN, OSGN and OSG5 chunks of what FXC emits.</summary>
    static class Signature
    {
        /// <exception cref="FormatException">The chunk is missing or cut off.</exception>
        public static List<SignatureElement> Inputs(DxbcContainer container) => Read(container.Chunk("ISGN"), withStream: false);

        /// <exception cref="FormatException">The chunk is missing or cut off.</exception>
        public static List<SignatureElement> Outputs(DxbcContainer container)
            => container.Find("OSGN") != null ? Read(container.Chunk("OSGN"), withStream: false) : Read(container.Chunk("OSG5"), withStream: true);

        static List<SignatureElement> Read(byte[] chunk, bool withStream)
        {
            const int headerBytes = 8, elementBytes = 24;
            int stream = withStream ? 4 : 0;
            var elements = new List<SignatureElement>();
            long count = DxbcContainer.UInt(chunk, 0);
            if (headerBytes + count * (elementBytes + stream) > chunk.Length)
                throw new FormatException($"A signature of {count} elements does not fit into its {chunk.Length} bytes.");
            for (int i = 0; i < count; i++)
            {
                int at = headerBytes + i * (elementBytes + stream) + stream, name = (int)DxbcContainer.UInt(chunk, at);
                int end = Array.IndexOf(chunk, (byte)0, name);
                if (end < 0)
                    throw new FormatException($"The name of element {i} of a signature has no end.");
                elements.Add(new SignatureElement
                {
                    Semantic = new Semantic(Encoding.ASCII.GetString(chunk, name, end - name).ToUpperInvariant(),
                        (int)DxbcContainer.UInt(chunk, at + 4)),
                    SystemValue = (int)DxbcContainer.UInt(chunk, at + 8),
                    Register = (int)DxbcContainer.UInt(chunk, at + 16),
                    Mask = chunk[at + 20],
                    ReadMask = chunk[at + 21],
                });
            }
            return elements;
        }
    }
}
