using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>A collider in a substep; lengths in d, in the domain's frame.</summary>
    [GenerateHlsl("Colliders", Name = "Collider")]
    [StructLayout(LayoutKind.Sequential)]
    struct ColliderState
    {
        /// <summary>from its own frame to the domain's, quaternion</summary>
        public float4 rotation;
        /// <summary>the same at the start of the substep</summary>
        public float4 lastRotation;
        /// <summary>of its own frame's origin, d</summary>
        public float3 position;
        /// <summary>a <see cref="ColliderShape"/></summary>
        public uint shape;
        /// <summary>at the start of the substep, d</summary>
        public float3 lastPosition;
        public uint flags;
        /// <summary>sphere: x radius; box: half sides; capsule: x radius, y half its straight part; mesh: half the volume in which its
        /// field is looked up; height field: x, z half its sides</summary>
        public float3 size;
        /// <summary>furthest that a point of it moves in the substep, d</summary>
        public float sweep;
        /// <summary>from its own frame, d, to a fraction of the atlas of its shape; negative along the axes of a mirrored mesh</summary>
        public float3 fieldScale;
        /// <summary>d, of one stored unit of distance</summary>
        public float fieldUnit;
        /// <summary>fraction of the atlas at its own frame's origin</summary>
        public float3 fieldCenter;
        /// <summary>side of a voxel, d</summary>
        public float voxel;
        /// <summary>fraction of the velocity along the surface that a substep takes from what touches; with kHoldsByViscosity of no slip</summary>
        public float friction;
        /// <summary>fraction of the velocity into the surface that is given back</summary>
        public float bounciness;
        /// <summary>by which moments about position are divided where they are summed, d</summary>
        public float momentArm;
        /// <summary>of the height over a height field that is surely free on all sides</summary>
        public float minFraction;
        /// <summary>of a mesh that deforms, from its field to that of where the frame's steps start: fraction of the atlas along z</summary>
        public float fieldBefore;
        /// <summary>how far it has come from that field to this at the end of the substep, 0 to 1</summary>
        public float blend;
        /// <summary>and at its start</summary>
        public float lastBlend;
        public float padding;

        /// <summary>the fluid is in it</summary>
        [GenerateHlsl("Colliders")] const uint InsideOut = 1;
        [GenerateHlsl("Colliders")] const uint ContributesDensity = 2;
        /// <summary>what the fluid does to it is summed</summary>
        [GenerateHlsl("Colliders")] const uint Reacts = 4;
        /// <summary>friction is by ViscosityWalls.hlsl</summary>
        [GenerateHlsl("Colliders")] const uint HoldsByViscosity = 8;
        /// <summary>its field changes in the substep</summary>
        [GenerateHlsl("Colliders")] const uint Deforms = 16;

        /// <summary>how much of it is wet is measured</summary>
        [GenerateHlsl("Colliders")] const uint TellsWettedArea = 32;

        /// <summary>Whether its field changes in the substep.</summary>
        public bool IsDeforming => (flags & Deforms) != 0;

        const float FrictionRate = 60f;                     // 1/s, at which friction is quoted

        /// <param name="motion">Over a frame.</param>
        /// <param name="from">Fraction of the frame at which the substep starts.</param>
        /// <param name="to">Fraction of the frame at which it ends.</param>
        /// <param name="timeStep">Length of the substep, s.</param>
        /// <param name="accelerationFraction">What acts at once of an acceleration that lasts, see <see cref="VelocityExtrapolation"/>:
        /// friction does.</param>
        /// <param name="viscous">Whether its friction is by the fluid's viscosity, see ViscosityWalls.hlsl.</param>
        /// <param name="brick">Position of the field of a mesh in the atlas.</param>
        public static ColliderState For(in ColliderMotion motion, float from, float to, float timeStep, float accelerationFraction,
            bool viscous, in FieldBrick brick)
        {
            RigidPose last = RigidPose.Between(motion.start, motion.end, from);
            RigidPose pose = RigidPose.Between(motion.start, motion.end, to);
            var state = new ColliderState
            {
                rotation = pose.rotation.value,
                lastRotation = last.rotation.value,
                position = pose.position,
                shape = (uint)motion.shape,
                lastPosition = last.position,
                flags = (motion.insideOut ? InsideOut : 0u) | (motion.contributesDensity ? ContributesDensity : 0u)
                    | (motion.reacts ? Reacts : 0u) | (motion.tellsWettedArea ? TellsWettedArea : 0u) | (viscous ? HoldsByViscosity : 0u),
                size = motion.size,
                sweep = math.distance(pose.position, last.position) + 2f * math.length(pose.rotation.value - last.rotation.value)
                    * math.max(motion.Radius, 1f),
                friction = viscous ? motion.friction
                    : 1f - math.pow(math.max(1f - motion.friction, 0f), FrictionRate * timeStep * accelerationFraction),
                bounciness = motion.bounciness,
                momentArm = motion.MomentArm,
                blend = 1f,
                lastBlend = 1f,
            };
            if (motion.shape == ColliderShape.Mesh && brick.Before != 0f)
            {
                state.flags |= Deforms;
                state.fieldBefore = brick.Before;
                state.blend = to;
                state.lastBlend = from;
            }
            if (motion.shape == ColliderShape.Mesh)
            {
                state.size = motion.size - 0.5f * motion.voxel;       // to the centers of the outermost voxels
                state.voxel = motion.voxel;
                state.fieldUnit = motion.fieldUnit;
                state.fieldScale = math.select(brick.VoxelFraction, -brick.VoxelFraction, motion.mirrored) / motion.voxel;
                state.fieldCenter = brick.Center;
            }
            if (motion.shape == ColliderShape.HeightField)
            {
                float3 spacing = 2f * motion.size / math.max(new float3(motion.field.width, 2f, motion.field.depth) - 1f, 1f);
                state.voxel = 0.5f * math.min(spacing.x, spacing.z);
                state.fieldUnit = motion.fieldUnit;
                state.fieldScale = brick.VoxelFraction / spacing;
                state.fieldCenter = brick.Center;
                state.minFraction = motion.minFraction;
            }
            return state;
        }
    }
}
