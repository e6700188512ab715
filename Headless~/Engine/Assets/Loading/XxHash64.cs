using System;
using System.Buffers.Binary;
using System.Numerics;

namespace Host.Assets
{
    /// <summary>The 64-bit hash from which Unity makes file ids of a model's parts.</summary>
    /// <remarks>Yann Collet, xxHash fast digest algorithm, version 0.1.1, with seed 0.</remarks>
    internal static class XxHash64
    {
        const ulong P1 = 11400714785074694791, P2 = 14029467366897019727, P3 = 1609587929392839161, P4 = 9650029242287828579,
            P5 = 2870177450012600261;

        public static ulong Of(ReadOnlySpan<byte> data)
        {
            var length = (ulong)data.Length;
            ulong hash = P5;
            if (data.Length >= 32)
            {
                Span<ulong> lanes = stackalloc ulong[] { unchecked(P1 + P2), P2, 0, unchecked(0 - P1) };
                for (; data.Length >= 32; data = data.Slice(32))
                    for (var i = 0; i < 4; i++) lanes[i] = Round(lanes[i], BinaryPrimitives.ReadUInt64LittleEndian(data.Slice(8 * i)));
                hash = BitOperations.RotateLeft(lanes[0], 1) + BitOperations.RotateLeft(lanes[1], 7) + BitOperations.RotateLeft(lanes[2],
                    12) + BitOperations.RotateLeft(lanes[3], 18);
                foreach (var lane in lanes) hash = (hash ^ Round(0, lane)) * P1 + P4;
            }
            hash += length;
            for (; data.Length >= 8; data = data.Slice(8))
                hash = BitOperations.RotateLeft(hash ^ Round(0, BinaryPrimitives.ReadUInt64LittleEndian(data)), 27) * P1 + P4;
            for (; data.Length >= 4; data = data.Slice(4))
                hash = BitOperations.RotateLeft(hash ^ BinaryPrimitives.ReadUInt32LittleEndian(data) * P1, 23) * P2 + P3;
            foreach (var last in data) hash = BitOperations.RotateLeft(hash ^ last * P5, 11) * P1;
            hash = (hash ^ hash >> 33) * P2;
            hash = (hash ^ hash >> 29) * P3;
            return hash ^ hash >> 32;
        }

        static ulong Round(ulong lane, ulong word) => BitOperations.RotateLeft(lane + word * P2, 31) * P1;
    }
}
