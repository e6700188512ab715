using Rill;
using Unity.Mathematics;

namespace Host.Report.Obstacles
{
    /// <summary>Obstacles in a solver's own terms. Lengths in d.</summary>
    static class Solids
    {
        public static ColliderMotion Still(ColliderShape shape, float3 size, float3 position) => Still(shape, size, position, quaternion.identity);

        /// <param name="size">See <see cref="ColliderMotion.size"/>.</param>
        public static ColliderMotion Still(ColliderShape shape, float3 size, float3 position, quaternion rotation)
        {
            var pose = new RigidPose(position, rotation);
            return new ColliderMotion { shape = shape, size = size, start = pose, end = pose, carriesDensity = true };
        }

        /// <summary>A box from corner to corner.</summary>
        public static ColliderMotion Box(float3 low, float3 high) => Still(ColliderShape.Box, (high - low) / 2f, (high + low) / 2f);
    }
}
