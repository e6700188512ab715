using Unity.Mathematics;

namespace Rill
{
    /// <summary>Distances from a collider on the CPU.</summary>
    static class ColliderDistance
    {
        /// <summary>From the surface at the end of the motion, signed; infinite for meshes and height fields, which only the GPU knows.</summary>
        public static float At(in ColliderMotion motion, float3 p)
        {
            float3 local = math.mul(math.conjugate(motion.end.rotation), p - motion.end.position);
            float distance;
            switch (motion.shape)
            {
                case ColliderShape.Sphere:
                    distance = math.length(local) - motion.size.x;
                    break;
                case ColliderShape.Capsule:
                    local.y -= math.clamp(local.y, -motion.size.y, motion.size.y);
                    distance = math.length(local) - motion.size.x;
                    break;
                case ColliderShape.Box:
                    float3 beyond = math.abs(local) - motion.size;
                    distance = math.length(math.max(beyond, 0f)) + math.min(math.cmax(beyond), 0f);
                    break;
                case ColliderShape.Plane:
                    distance = local.y;
                    break;
                default:
                    return float.PositiveInfinity;
            }
            return motion.insideOut ? -distance : distance;
        }
    }
}
