using Rill;
using Unity.Mathematics;

namespace Host.Report.Obstacles
{
    /// <summary>Colliders in a solver's own terms. Lengths in d.</summary>
    static class Solids
    {
        public static ColliderMotion Still(ColliderShape shape, float3 size, float3 position) => Still(shape, size, position, quaternion.identity);

        /// <param name="size">See <see cref="ColliderMotion.size"/>.</param>
        public static ColliderMotion Still(ColliderShape shape, float3 size, float3 position, quaternion rotation)
        {
            var pose = new RigidPose(position, rotation);
            return new ColliderMotion { shape = shape, size = size, start = pose, end = pose, contributesDensity = true };
        }

        /// <summary>The inside of an upright round tank, whose floor is the domain's.</summary>
        /// <param name="center">Of the domain, d.</param>
        public static ColliderMotion RoundTank(float radius, float height, float3 center)
        {
            ColliderMotion wall = Still(ColliderShape.Capsule, new float3(radius, 2f * height + radius, 0f), center);
            wall.insideOut = true;
            return wall;
        }

        /// <summary>A box from corner to corner.</summary>
        public static ColliderMotion Box(float3 low, float3 high) => Still(ColliderShape.Box, (high - low) / 2f, (high + low) / 2f);
    }
}
