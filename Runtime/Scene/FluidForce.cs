using UnityEngine;

namespace Rill
{
    /// <summary>What one simulation did to an obstacle, as a mean over some steps.</summary>
    readonly struct FluidForce
    {
        public readonly FluidSimulation From;
        /// <summary>N, world space.</summary>
        public readonly Vector3 Force;
        /// <summary>About the middle of the obstacle, N m, world space.</summary>
        public readonly Vector3 Torque;

        public FluidForce(FluidSimulation from, Vector3 force, Vector3 torque)
        {
            From = from;
            Force = force;
            Torque = torque;
        }
    }
}
