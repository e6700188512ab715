using System;
using UnityEngine;

namespace Rill
{
    /// <summary>What the depth of a surface on the screen depends on. The same state: the textures of the last frame still hold.</summary>
    readonly struct SurfaceState : IEquatable<SurfaceState>
    {
        readonly int version, filterPasses;
        readonly float lag, filterRadius;
        readonly Matrix4x4 domainToWorld, left, right;
        readonly Vector4 grid, window;

        /// <param name="filterPasses">How often the filter runs.</param>
        /// <param name="window">What the textures hold of the picture.</param>
        public SurfaceState(in SurfaceFrame fluid, int filterPasses, in FluidViews camera, in PictureWindow window)
        {
            version = fluid.version;
            lag = fluid.lag.x;
            filterRadius = fluid.filterRadius;
            this.filterPasses = filterPasses;
            domainToWorld = fluid.domainToWorld;
            left = camera.WorldToClipOf(0);
            right = camera.WorldToClipOf(1);
            grid = window.Grid;
            this.window = window.Rect;
        }

        public bool Equals(SurfaceState other)
        {
            return version == other.version && lag == other.lag && filterRadius == other.filterRadius && filterPasses == other.filterPasses
                && grid == other.grid && window == other.window
                && domainToWorld.Equals(other.domainToWorld) && left.Equals(other.left) && right.Equals(other.right);
        }

        public override bool Equals(object other) => other is SurfaceState state && Equals(state);

        public override int GetHashCode() => HashCode.Combine(version, lag, domainToWorld, left);
    }
}
