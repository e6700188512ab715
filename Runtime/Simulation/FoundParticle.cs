using Unity.Mathematics;

namespace Rill
{
    /// <summary>A particle that a message names.</summary>
    struct FoundParticle
    {
        public uint id;
        /// <summary>In the box's frame, m and m/s.</summary>
        public float3 position, velocity;
        /// <summary>World space, m.</summary>
        public float3 world;
        /// <summary>How far it is beyond walls or inside colliders, m.</summary>
        public float outside;
        /// <summary>Measure by which it was found.</summary>
        public float measure;
    }
}
