using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>A collider in a substep, as Colliders.hlsl has it, member by member; lengths in d, in the domain's frame.</summary>
    [StructLayout(LayoutKind.Sequential)]
    struct ColliderState : IEquatable<ColliderState>
    {
        public float4 rotation;
        public float4 lastRotation;
        public float3 position;
        public uint shape;
        public float3 lastPosition;
        public uint flags;
        public float3 size;
        public float sweep;
        public float3 fieldScale;
        public float fieldUnit;
        public float3 fieldCenter;
        public float voxel;
        public float friction;
        public float bounciness;
        public float momentArm;
        public float minFraction;

        const uint InsideOut = 1, ContributesDensity = 2, Reacts = 4, HoldsByViscosity = 8;       // as in Colliders.hlsl
        const float FrictionRate = 60f;                     // 1/s, at which friction is quoted

        /// <summary>Whether all bits are the same.</summary>
        public bool Equals(ColliderState other) => MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref this, 1)).SequenceEqual(MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref other, 1)));

        /// <param name="motion">Over a frame.</param>
        /// <param name="from">Share of the frame at which the substep starts.</param>
        /// <param name="to">And ends.</param>
        /// <param name="timeStep">Length of the substep, s.</param>
        /// <param name="accelerationFraction">What acts at once of an acceleration that lasts, see <see cref="VelocityExtrapolation"/>: friction does.</param>
        /// <param name="viscous">Whether its friction is by the fluid's viscosity, see ViscosityWalls.hlsl.</param>
        /// <param name="brick">Where the atlas holds the field of a mesh.</param>
        public static ColliderState For(in ColliderMotion motion, float from, float to, float timeStep, float accelerationFraction, bool viscous, in FieldBrick brick)
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
                flags = (motion.insideOut ? InsideOut : 0u) | (motion.contributesDensity ? ContributesDensity : 0u) | (motion.reacts ? Reacts : 0u) | (viscous ? HoldsByViscosity : 0u),
                size = motion.size,
                sweep = math.distance(pose.position, last.position) + 2f * math.length(pose.rotation.value - last.rotation.value) * math.max(motion.Radius, 1f),
                friction = viscous ? motion.friction : 1f - math.pow(math.max(1f - motion.friction, 0f), FrictionRate * timeStep * accelerationFraction),
                bounciness = motion.bounciness,
                momentArm = motion.MomentArm,
            };
            if (motion.shape == ColliderShape.Mesh)
            {
                state.size = motion.size - 0.5f * motion.voxel;       // to the centres of the outermost voxels
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
