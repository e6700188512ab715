using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Offsets at which a graphics API puts the members of a constant buffer, from their declared types alone.</summary>
    sealed class ConstantPacking
    {
        const int Register = 16;

        /// <summary>For messages.</summary>
        public readonly string Name;

        readonly bool vectorsAlign;         // to 2 or 4 words
        readonly bool arraysInRegisters;    // each element begins at 16 bytes

        /// <summary>Direct3D: members follow each other by words, and none crosses 16 bytes; elements of arrays begin at 16.</summary>
        public static readonly ConstantPacking Direct3D = new("Direct3D", vectorsAlign: false, arraysInRegisters: true);

        /// <summary>OpenGL specification 4.6, 7.6.2.2 "Standard Uniform Block Layout": vectors are aligned to 2 or 4 words, what follows an
        /// array or matrix to 16 bytes.</summary>
        public static readonly ConstantPacking Std140 = new("std140", vectorsAlign: true, arraysInRegisters: true);

        /// <summary>
        /// Metal Shading Language specification, 2.2 "Vector Data Types", which is how Unity's translator declares the members:
        /// a vector of three has 16 bytes. Arrays are packed as in C++.
        /// </summary>
        public static readonly ConstantPacking Metal = new("Metal", vectorsAlign: true, arraysInRegisters: false);

        ConstantPacking(string name, bool vectorsAlign, bool arraysInRegisters)
        {
            Name = name;
            this.vectorsAlign = vectorsAlign;
            this.arraysInRegisters = arraysInRegisters;
        }

        /// <summary>The first byte of each member, and the end of the last.</summary>
        public int[] Offsets(IReadOnlyList<ConstantField> members)
        {
            var offsets = new int[members.Count + 1];
            int at = 0;
            for (int i = 0; i < members.Count; i++)
            {
                offsets[i] = Add(members[i], ref at);
                offsets[i + 1] = at;
            }
            return offsets;
        }

        int Add(in ConstantField member, ref int at)
        {
            bool isMatrix = member.Rows > 1;
            // Columns of a matrix lie as the elements of an array do.
            int words = isMatrix && !member.RowMajor ? member.Rows : member.Columns;
            int vectors = (isMatrix ? member.RowMajor ? member.Rows : member.Columns : 1) * System.Math.Max(member.ArrayLength, 1);
            bool isArray = isMatrix || member.ArrayLength > 0;
            int bytes = 4 * words, alignment = vectorsAlign ? 4 * (words == 3 ? 4 : words) : 4;
            if (isArray && arraysInRegisters)
                alignment = Register;
            int stride = Up(bytes, alignment), start = Up(at, alignment);
            bool mayNotCross = arraysInRegisters && !vectorsAlign && !isArray;
            if (mayNotCross && start / Register != (start + bytes - 1) / Register)
                start = Up(start, Register);
            // Direct3D lets what follows begin in the last element's free words, and std140 in those of a single vector.
            bool isPadded = vectorsAlign && (isArray || !arraysInRegisters);
            at = start + (vectors - 1) * stride + (isPadded ? stride : bytes);
            return start;
        }

        static int Up(int at, int alignment) => (at + alignment - 1) / alignment * alignment;
    }
}
