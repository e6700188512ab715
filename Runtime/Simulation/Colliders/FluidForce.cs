using UnityEngine;

namespace Rill
{
    /// <summary>Force of one simulation on a collider, as a mean over some steps, and how the collider moved in them. World space.</summary>
    readonly struct FluidForce
    {
        public readonly FluidSimulation From;
        /// <summary>N.</summary>
        public readonly Vector3 Force;
        /// <summary>Torque about the center of the collider, N m.</summary>
        public readonly Vector3 Torque;
        /// <summary>How the collider moved meanwhile, as the simulation saw it.</summary>
        public readonly RelativeMotion Motion;

        /// <summary>Fluid time of the steps, s.</summary>
        public readonly float Duration;
        /// <summary>The last of them, as <see cref="FluidSimulation.StepCount"/> counts.</summary>
        public readonly int Step;

        /// <summary>After the last of them; only where contacts are listened to.</summary>
        public readonly WettedArea Wetted;

        readonly Vector3 shift;     // of the simulation, when Motion was followed

        /// <summary>N s.</summary>
        public Vector3 Impulse => Force * Duration;

        /// <summary>How far the simulation was teleported since, m.</summary>
        public Vector3 ShiftSince => ReferenceEquals(From, null) ? Vector3.zero : From.Box.WorldShift - shift;

        public FluidForce(FluidSimulation from, Vector3 force, Vector3 torque, in RelativeMotion motion, float duration = 0f, int step = 0,
            Vector3 shift = default, in WettedArea wetted = default)
        {
            From = from;
            Force = force;
            Torque = torque;
            Motion = motion;
            Duration = duration;
            Step = step;
            this.shift = shift;
            Wetted = wetted;
        }
    }
}
