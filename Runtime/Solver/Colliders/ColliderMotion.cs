using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>A solid collider over the time of a frame's steps. Lengths in d, in the domain's frame.</summary>
    struct ColliderMotion
    {
        public ColliderShape shape;
        /// <summary>Sphere: x radius. Box: half sides. Capsule: x radius, y half its straight part. Mesh: half sides of its field's volume.
        /// Height field: half sides along x and z, along y half of what its heights span.</summary>
        public float3 size;
        /// <summary>At the start and at the end of the steps.</summary>
        public RigidPose start, end;
        /// <summary>At the frame itself, which the steps may stay behind.</summary>
        public RigidPose seen;
        /// <summary>Fraction of the velocity along the surface that what touches loses in 1/60 s.</summary>
        public float friction;
        /// <summary>Fraction of the velocity into the surface that is given back.</summary>
        public float bounciness;
        public bool insideOut, contributesDensity;
        /// <summary>Whether what the fluid does to it is summed.</summary>
        public bool reacts;
        /// <summary>Whether how much of it is wet is measured; only with <see cref="reacts"/>.</summary>
        public bool tellsWettedArea;
        /// <summary>Signed distances of a mesh, lowest corner first, or heights over the center of a height field, one voxel high; null for
        /// other kinds.</summary>
        public Texture3D field;
        /// <summary>Shape of a mesh that deforms, instead of <see cref="field"/>; null for others.</summary>
        public IDeformingShape deforming;
        /// <summary>How far it has come from the older to the newer of its fields at the end of the steps, 0 to 1, and which they are.</summary>
        public float blend;
        public int fieldVersion;
        /// <summary>Whether it deforms in the steps.</summary>
        public bool deforms;
        /// <summary>Axes of its own frame along which its field is looked up mirrored: those of a negative scale.</summary>
        public bool3 mirrored;
        /// <summary>Side of a voxel of the field, and one stored unit of distance; d.</summary>
        public float voxel, fieldUnit;
        /// <summary>Fraction of the height over a height field within which all sides are free, even beside its steepest slope.</summary>
        public float minFraction;

        /// <summary>Radius of a ball around its position that holds all of it; 1 for a plane, which has no end.</summary>
        public float Radius
        {
            get
            {
                switch (shape)
                {
                    case ColliderShape.Sphere: return size.x;
                    case ColliderShape.Capsule: return size.x + size.y;
                    case ColliderShape.Plane: return 1f;
                    default: return math.length(size);
                }
            }
        }

        /// <summary>By which moments are divided where they are summed, d: longer than the arm of any contact, but of a plane's.</summary>
        public float MomentArm => math.max(Radius, 1f) + 1f;

        public bool Moves => deforms || math.any(start.position != end.position) || math.any(start.rotation.value != end.rotation.value);
    }
}
