using UnityEngine;

namespace Rill
{
    /// <summary>What one simulation did to a collider, as a mean over some steps, and how the collider moved in them. World space.</summary>
    readonly struct FluidForce
    {
        public readonly FluidSimulation From;
        /// <summary>N.</summary>
        public readonly Vector3 Force;
        /// <summary>About the middle of the collider, N m.</summary>
        public readonly Vector3 Torque;
        /// <summary>How the collider moved meanwhile, as the simulation saw it.</summary>
        public readonly RelativeMotion Motion;

        public FluidForce(FluidSimulation from, Vector3 force, Vector3 torque, in RelativeMotion motion)
        {
            From = from;
            Force = force;
            Torque = torque;
            Motion = motion;
        }
    }
}
