using Unity.Mathematics;

namespace Rill
{
    /// <summary>A small part of a body's surface.</summary>
    struct SurfaceSample
    {
        /// <summary>World space, m.</summary>
        public float3 position;
        /// <summary>Out of the body, times the area, m².</summary>
        public float3 area;
    }
}
