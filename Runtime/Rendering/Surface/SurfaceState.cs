using System;
using UnityEngine;

namespace Rill
{
    /// <summary>What the depth of a surface on the screen depends on. The same state: the textures of the last frame still hold.</summary>
    readonly struct SurfaceState : IEquatable<SurfaceState>
    {
        readonly int version;
        readonly float lag, filterRadius;
        readonly Matrix4x4 domainToWorld, left, right;

        /// <param name="version">Of the surface's particles.</param>
        /// <param name="lag">Of the frame since the newest step, substeps.</param>
        /// <param name="filterRadius">World, m.</param>
        public SurfaceState(int version, float lag, float filterRadius, Matrix4x4 domainToWorld, in FluidViews camera)
        {
            this.version = version;
            this.lag = lag;
            this.filterRadius = filterRadius;
            this.domainToWorld = domainToWorld;
            left = camera.WorldToClipOf(0);
            right = camera.WorldToClipOf(1);
        }

        public bool Equals(SurfaceState other)
        {
            return version == other.version && lag == other.lag && filterRadius == other.filterRadius
                && domainToWorld.Equals(other.domainToWorld) && left.Equals(other.left) && right.Equals(other.right);
        }

        public override bool Equals(object other) => other is SurfaceState state && Equals(state);

        public override int GetHashCode() => HashCode.Combine(version, lag, domainToWorld, left);
    }
}
