using Unity.Mathematics;

namespace Rill
{
    /// <summary>Signed distance from a collider where it is at the end of the steps, on the CPU, as Colliders.hlsl computes it.
    /// Outside of a mesh's field it is a little less.</summary>
    readonly struct ColliderDistance
    {
        readonly ColliderMotion motion;
        readonly quaternion toLocal;
        readonly FieldSampler mesh;
        readonly FieldVoxels heights;

        ColliderDistance(in ColliderMotion motion)
        {
            this.motion = motion;
            toLocal = math.conjugate(motion.end.rotation);
            mesh = default;
            heights = default;
            if (motion.shape == ColliderShape.Mesh)
            {
                var bounds = new UnityEngine.Bounds(UnityEngine.Vector3.zero, motion.size * 2f / motion.fieldUnit);
                mesh = new FieldSampler(motion.field, bounds, motion.voxel / motion.fieldUnit);
            }
            else if (motion.shape == ColliderShape.HeightField)
            {
                heights = new FieldVoxels(motion.field);
            }
        }

        /// <returns>False for a mesh that deforms, whose distances only the GPU knows, and for a texture that cannot be read.</returns>
        public static bool TryMake(in ColliderMotion motion, out ColliderDistance distance)
        {
            bool hasField = motion.shape == ColliderShape.Mesh || motion.shape == ColliderShape.HeightField;
            bool isKnown = !hasField || motion.deforming == null && motion.field != null && motion.field.isReadable;
            distance = isKnown ? new ColliderDistance(motion) : default;
            return isKnown;
        }

        /// <summary>From the surface at the end of the motion, signed; infinite where it is not known.</summary>
        public static float At(in ColliderMotion motion, float3 p)
            => TryMake(motion, out ColliderDistance distance) ? distance.At(p) : float.PositiveInfinity;

        /// <param name="p">In the frame and the unit of the motion.</param>
        public float At(float3 p)
        {
            float distance = Local(math.mul(toLocal, p - motion.end.position));
            return motion.insideOut ? -distance : distance;
        }

        float Local(float3 p)
        {
            float3 size = motion.size;
            switch (motion.shape)
            {
                case ColliderShape.Sphere: return math.length(p) - size.x;
                case ColliderShape.Capsule: return math.length(p - new float3(0f, math.clamp(p.y, -size.y, size.y), 0f)) - size.x;
                case ColliderShape.Plane: return p.y;
                case ColliderShape.Box:
                    float3 beyond = math.abs(p) - size;
                    return math.length(math.max(beyond, 0f)) + math.min(math.cmax(beyond), 0f);
                case ColliderShape.HeightField: return OverGround(p);
                default:
                    mesh.TrySample(math.select(p, -p, motion.mirrored) / motion.fieldUnit, out float distance);
                    return distance * motion.fieldUnit;
            }
        }

        // Returns the distance as if the ground below were a plane; beyond its sides there is none.
        float OverGround(float3 p)
        {
            float2 inside = math.clamp(p.xz, -motion.size.xz, motion.size.xz), beyond = p.xz - inside;
            float height = Height(inside, out float2 slope);
            float distance = (p.y - height) * math.rsqrt(1f + math.dot(slope, slope));
            return math.all(beyond == 0f) ? distance : math.sqrt(math.lengthsq(beyond) + math.max(distance, 0f) * math.max(distance, 0f));
        }

        float Height(float2 position, out float2 slope)
        {
            var last = new int2(motion.field.width, motion.field.depth) - 1;
            float2 scale = last / (2f * motion.size.xz), at = (position + motion.size.xz) * scale;
            int2 a = math.clamp((int2)math.floor(at), 0, last - 1);
            float2 weight = at - a;
            float low = heights[a.x, 0, a.y], right = heights[a.x + 1, 0, a.y];
            float far = heights[a.x, 0, a.y + 1], both = heights[a.x + 1, 0, a.y + 1];
            slope = motion.fieldUnit * scale
                * new float2(math.lerp(right - low, both - far, weight.y), math.lerp(far - low, both - right, weight.x));
            return motion.fieldUnit * math.lerp(math.lerp(low, right, weight.x), math.lerp(far, both, weight.x), weight.y);
        }
    }
}
