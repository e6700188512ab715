namespace Rill
{
    /// <summary>Shape of a <see cref="FluidCollider"/>.</summary>
    [GenerateHlsl("Colliders")]
    public enum ColliderShape
    {
        /// <summary>A ball.</summary>
        Sphere,
        /// <summary>A box with any three sides.</summary>
        Box,
        /// <summary>A cylinder along y with half a ball at both ends.</summary>
        Capsule,
        /// <summary>All below an endless plane; y points out of it.</summary>
        Plane,
        /// <summary>A mesh, described by a signed distance field.</summary>
        Mesh,
        /// <summary>All below the heights of a <see cref="Rill.HeightField"/>: the ground.</summary>
        HeightField,
    }
}
