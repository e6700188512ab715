using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>From world space into the frame of a domain: lowest corner at 0, lengths in particle spacings.</summary>
    readonly struct DomainFrame
    {
        readonly Vector3 position;
        readonly Quaternion toDomain, toWorld;
        readonly float3 half;
        readonly float spacing, inverseSpacing;

        /// <param name="position">Position of the domain's center, world space, m.</param>
        /// <param name="size">m.</param>
        /// <param name="spacing">m.</param>
        public DomainFrame(Vector3 position, Quaternion rotation, float3 size, float spacing)
        {
            this.position = position;
            toWorld = rotation;
            toDomain = Quaternion.Inverse(rotation);
            half = size * 0.5f;
            this.spacing = spacing;
            inverseSpacing = 1f / spacing;
        }

        /// <summary>m.</summary>
        public float Spacing => spacing;

        /// <summary>Center and rotation of the domain, world space, m.</summary>
        public RigidPose Box => new RigidPose(position, toWorld);

        public float3 Point(Vector3 world) => ((float3)(toDomain * (world - position)) + half) * inverseSpacing;

        /// <summary>Converts a direction, a velocity or an acceleration from m to d.</summary>
        public float3 Vector(Vector3 world) => (float3)(toDomain * world) * inverseSpacing;

        public Quaternion Rotation(Quaternion world) => toDomain * world;

        public RigidPose Pose(Vector3 worldPosition, Quaternion worldRotation) => new RigidPose(Point(worldPosition), Rotation(worldRotation));

        /// <summary>Converts a point in the domain, d, to world space, m.</summary>
        public Vector3 WorldPoint(float3 point) => position + toWorld * (point * spacing - half);

        /// <summary>A pose of the domain's frame in world space, m.</summary>
        public RigidPose World(in RigidPose pose)
            => new RigidPose((float3)(position + toWorld * (pose.position * spacing - half)), toWorld * pose.rotation);

        public PoseInDomain ToDomain(Vector3 worldPosition, Quaternion worldRotation)
        {
            Quaternion rotation = Rotation(worldRotation);
            return new PoseInDomain
            {
                position = Point(worldPosition),
                axisX = rotation * Vector3.right,
                axisY = rotation * Vector3.up,
                axisZ = rotation * Vector3.forward,
            };
        }
    }

    /// <summary>Position of an object in a domain, d, and the directions of its axes there.</summary>
    struct PoseInDomain
    {
        public float3 position, axisX, axisY, axisZ;
    }
}
