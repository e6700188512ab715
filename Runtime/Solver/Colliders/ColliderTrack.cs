using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Follows a collider through the steps in which the force on it is summed.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]      // as it stands in snapshots
    struct ColliderTrack
    {
        // substeps in which pushed water comes to move along: measured, see Research~/floating-study.md
        const float MemorySteps = 4f;

        RigidPose pose;
        SlipVelocity slip, angularSlip;
        float3 positions, slips, angularSlips;      // sums over the window, times time
        float4 rotations;
        float time, memory;

        /// <summary>At a place from which nothing is known of its motion.</summary>
        public static ColliderTrack At(in RigidPose pose) => new ColliderTrack { pose = pose };

        /// <summary>At the end of the last steps, world space, m.</summary>
        public RigidPose Pose => pose;

        /// <summary>Goes along with a box that was put elsewhere, m.</summary>
        public void Shift(float3 by) => GoTo(new RigidPose(pose.position + by, pose.rotation));

        /// <summary>Goes along with the box of a fluid that was teleported.</summary>
        /// <param name="now">Where it is since, world space, m.</param>
        public void GoTo(in RigidPose now)
        {
            positions += (now.position - pose.position) * time;
            pose = now;
        }

        /// <summary>Continues from another pose: time that the fluid dropped does not count as motion.</summary>
        public void SkipTo(in RigidPose start) => pose = start;

        /// <param name="next">Pose at the end of the steps, world space, m.</param>
        /// <param name="duration">Their fluid time, s.</param>
        /// <param name="substep">s.</param>
        public void Follow(in RigidPose next, float duration, float substep)
        {
            memory = MemorySteps * substep;
            slips += slip.Follow((next.position - pose.position) / duration, duration, memory) * duration;
            angularSlips += angularSlip.Follow(RigidPose.RotationVector(pose.rotation, next.rotation) / duration, duration, memory) * duration;
            RigidPose halfway = RigidPose.Between(pose, next, 0.5f);
            float4 rotation = halfway.rotation.value;
            positions += halfway.position * duration;
            rotations += (math.dot(rotations, rotation) < 0f ? -rotation : rotation) * duration;
            time += duration;
            pose = next;
        }

        /// <summary>Ends the window and begins the next.</summary>
        public RelativeMotion Take()
        {
            float fraction = time > 0f ? 1f / time : 0f;
            float3 position = time > 0f ? positions * fraction : pose.position;
            float4 rotation = time > 0f ? math.normalize(rotations) : pose.rotation.value;
            var motion = new RelativeMotion(position, new quaternion(rotation), slips * fraction, angularSlips * fraction, memory);
            positions = slips = angularSlips = 0f;
            rotations = 0f;
            time = 0f;
            return motion;
        }

    }
}
