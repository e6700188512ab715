using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The constant buffer RillColliders of Colliders.hlsl, member by member; lengths in d.</summary>
    [StructLayout(LayoutKind.Sequential)]
    struct ColliderConstants
    {
        public uint3 cells;
        public uint words;
        public float cellSize;
        public float inverseCellSize;
        public uint count;
        public uint rests;
    }
}
