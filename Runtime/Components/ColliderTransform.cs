using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Pose of a collider's object: its last finite position, rotation and scale.</summary>
    struct ColliderTransform
    {
        /// <summary>World space, m.</summary>
        public float3 position;
        public quaternion rotation;
        /// <summary>Above 0.</summary>
        public float3 scale;
        /// <summary>Axes of the object's frame along which its scale is negative.</summary>
        public bool3 mirrored;

        public static ColliderTransform Origin => new ColliderTransform { rotation = quaternion.identity, scale = 1f };

        /// <summary>Largest of the three scales.</summary>
        public float EvenScale => math.cmax(scale);

        /// <summary>Follows an object; stays at the last valid pose while the new one is invalid.</summary>
        /// <returns>Why the pose is invalid; null if it is valid.</returns>
        public string Follow(Transform transform)
        {
            Vector3 point = transform.position, lossyScale = transform.lossyScale;
            Quaternion turn = transform.rotation;
            if (!Limit.IsPose(point, turn) || !math.all(math.isfinite((float3)lossyScale)))
                return Invariant($"its transform is not finite (position {point}, rotation {turn}, scale {lossyScale}). Set them to ") +
                    "numbers.";
            position = point;
            rotation = turn;
            scale = math.abs((float3)lossyScale);
            mirrored = (float3)lossyScale < 0f;
            return null;
        }

        /// <summary>A point of the object's frame in world space, m.</summary>
        public float3 PointOf(float3 local) => position + math.mul(rotation, math.select(scale, -scale, mirrored) * local);

        /// <summary>Makes a motion that of a mesh with this field.</summary>
        /// <param name="field">Not null.</param>
        /// <returns>Why it is not a collider; null if it is one.</returns>
        public string DescribeField(SignedDistanceField field, ref ColliderMotion motion, ref RigidPose pose)
        {
            if (!field.Validate(out string problem))
                return problem;
            Bounds bounds = field.Bounds;
            float even = EvenScale;
            pose.position = PointOf(bounds.center);
            motion.shape = ColliderShape.Mesh;
            motion.mirrored = mirrored;
            motion.size = even * (float3)bounds.extents;
            motion.voxel = even * field.VoxelSize;
            motion.fieldUnit = even;
            motion.field = field.Texture;
            return even > 1.001f * math.cmin(scale) ? Invariant($"its scale {(Vector3)scale} is not the same along all axes, and ") +
                "distances cannot be stretched. Scale it evenly, or bake the mesh as it shall be." : null;
        }

        /// <summary>Makes a motion that of ground. As Unity's Terrain it follows the object's position alone.</summary>
        /// <param name="heights">Not null, nor disposed of.</param>
        public void DescribeHeights(HeightField heights, ref ColliderMotion motion, ref RigidPose pose)
        {
            pose = new RigidPose(position + heights.Center, quaternion.identity);
            motion.shape = ColliderShape.HeightField;
            motion.size = heights.Extents;
            motion.fieldUnit = 1f;
            motion.field = heights.Texture;
            motion.minFraction = heights.MinFraction;
            motion.insideOut = false;
        }
    }
}
