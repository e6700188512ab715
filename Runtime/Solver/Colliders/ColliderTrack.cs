using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Follows an obstacle through the steps in which the force on it is summed. A fluid answers a change of velocity in the step in
    /// which it comes, so the mean acceleration that belongs to a mean force is that from the last steps before to the last within.
    /// </summary>
    struct ColliderTrack
    {
        RigidPose pose;
        float3 velocity, angularVelocity;           // in the newest steps
        float3 firstVelocity, firstAngularVelocity; // in the last steps before the window
        float3 positions;                           // sums over the window, times time
        float4 rotations;
        float time;

        /// <summary>At a place from which nothing is known of its motion.</summary>
        public static ColliderTrack At(in RigidPose pose) => new ColliderTrack { pose = pose };

        /// <param name="next">Pose at the end of the steps, world space, m.</param>
        /// <param name="duration">Their fluid time, s.</param>
        public void Follow(in RigidPose next, float duration)
        {
            velocity = (next.position - pose.position) / duration;
            angularVelocity = RotationVector(pose.rotation, next.rotation) / duration;
            RigidPose middle = RigidPose.Between(pose, next, 0.5f);
            float4 rotation = middle.rotation.value;
            positions += middle.position * duration;
            rotations += (math.dot(rotations, rotation) < 0f ? -rotation : rotation) * duration;
            time += duration;
            pose = next;
        }

        /// <summary>Ends the window and begins the next.</summary>
        public ObstacleMotion Take()
        {
            bool moved = time > 0f;
            float3 position = moved ? positions / time : pose.position;
            float4 rotation = moved ? math.normalize(rotations) : pose.rotation.value;
            float3 acceleration = moved ? (velocity - firstVelocity) / time : 0f;
            float3 angularAcceleration = moved ? (angularVelocity - firstAngularVelocity) / time : 0f;
            firstVelocity = velocity;
            firstAngularVelocity = angularVelocity;
            positions = 0f;
            rotations = 0f;
            time = 0f;
            return new ObstacleMotion(position, new quaternion(rotation), acceleration, angularAcceleration);
        }

        /// <summary>The way from one orientation to another by the shorter side: its axis times its angle, rad.</summary>
        public static float3 RotationVector(quaternion from, quaternion to)
        {
            float4 turn = math.mul(to, math.conjugate(from)).value;
            turn = turn.w < 0f ? -turn : turn;
            float sine = math.length(turn.xyz);
            return sine > 1e-7f ? turn.xyz * (2f * math.atan2(sine, turn.w) / sine) : 2f * turn.xyz;
        }
    }
}
