using Unity.Mathematics;

namespace Rill
{
    /// <summary>All points no further than a radius from the inside of a box: a box, sphere or capsule.</summary>
    struct RoundedBox : IVolume
    {
        public float3 center, half;
        public float radius;
        public quaternion rotation;

        /// <summary>Half sides of the box around it, in its own frame.</summary>
        public float3 Extent => half + radius;

        /// <param name="position">In its own frame, from its center.</param>
        public bool Contains(float3 position)
        {
            float3 beyond = math.max(math.abs(position) - half, 0f);
            return math.dot(beyond, beyond) <= radius * radius * 1.0001f;
        }
    }
}
