using UnityEngine;

namespace Rill
{
    /// <summary>What one simulation did to an obstacle, as a mean over some steps, and how the obstacle moved in them. World space.</summary>
    readonly struct FluidForce
    {
        public readonly FluidSimulation From;
        /// <summary>N.</summary>
        public readonly Vector3 Force;
        /// <summary>About the middle of the obstacle, N m.</summary>
        public readonly Vector3 Torque;
        /// <summary>How the obstacle moved meanwhile, as the simulation saw it.</summary>
        public readonly ObstacleMotion Motion;

        public FluidForce(FluidSimulation from, Vector3 force, Vector3 torque, in ObstacleMotion motion)
        {
            From = from;
            Force = force;
            Torque = torque;
            Motion = motion;
        }
    }
}
