using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>All colliders of a substep and the bins that say where they are; lengths in d.</summary>
    [GenerateHlsl("Colliders", ConstantBuffer = "RillColliders")]
    [StructLayout(LayoutKind.Sequential)]
    struct ColliderConstants : IEquatable<ColliderConstants>
    {
        /// <summary>cells along x, y, z of the bins</summary>
        public uint3 colliderCells;
        /// <summary>words of a cell's mask: one bit for each collider</summary>
        public uint colliderWords;
        /// <summary>d</summary>
        public float colliderCellSize;
        /// <summary>1/d</summary>
        public float inverseColliderCellSize;
        public uint colliderCount;
        /// <summary>whether what rests sleeps: _RegionStates holds something</summary>
        public uint rests;
        /// <summary>d, as far as a collider can matter to a particle in a substep, once it is sorted; at least kSupport</summary>
        public float colliderReach;
        public float colliderPadding0, colliderPadding1, colliderPadding2;

        public bool Equals(ColliderConstants other) => colliderCells.Equals(other.colliderCells) && colliderWords == other.colliderWords
            && colliderCellSize == other.colliderCellSize
            && inverseColliderCellSize == other.inverseColliderCellSize && colliderCount == other.colliderCount && rests == other.rests
            && colliderReach == other.colliderReach;
    }
}
