using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The constant buffer RillColliders of Colliders.hlsl, member by member; lengths in d.</summary>
    [StructLayout(LayoutKind.Sequential)]
    struct ColliderConstants : IEquatable<ColliderConstants>
    {
        public uint3 cells;
        public uint words;
        public float cellSize;
        public float inverseCellSize;
        public uint count;
        public uint rests;
        public float reach;
        public float3 padding;

        public bool Equals(ColliderConstants other) => cells.Equals(other.cells) && words == other.words && cellSize == other.cellSize
            && inverseCellSize == other.inverseCellSize && count == other.count && rests == other.rests && reach == other.reach;
    }
}
