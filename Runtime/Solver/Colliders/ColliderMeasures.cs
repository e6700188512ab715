using Unity.Mathematics;

namespace Rill
{
    /// <summary>Sizes of a collider, in the unit of its lengths.</summary>
    static class ColliderMeasures
    {
        /// <summary>Returns the volume of a sphere, box or capsule, m³; 0 for the other kinds.</summary>
        public static float Volume(in ColliderMotion motion)
        {
            float3 size = motion.size;
            switch (motion.shape)
            {
                case ColliderShape.Sphere: return 4f / 3f * math.PI * size.x * size.x * size.x;
                case ColliderShape.Capsule: return math.PI * size.x * size.x * (4f / 3f * size.x + 2f * size.y);
                case ColliderShape.Box: return 8f * size.x * size.y * size.z;
                default: return 0f;
            }
        }

        /// <summary>From one end to the other along a direction of length 1; of a mesh that of its field's volume.</summary>
        public static float Width(in ColliderMotion motion, float3 direction)
        {
            switch (motion.shape)
            {
                case ColliderShape.Sphere: return 2f * motion.size.x;
                case ColliderShape.Capsule:
                    return 2f
                    * (motion.size.x + motion.size.y
                    * math.abs(math.dot(direction, math.mul(motion.end.rotation, new float3(0f, 1f, 0f)))));
                default: return 2f * math.dot(motion.size, math.abs(math.mul(math.conjugate(motion.end.rotation), direction)));
            }
        }
    }
}
