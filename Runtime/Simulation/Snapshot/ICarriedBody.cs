using UnityEngine;

namespace Rill
{
    /// <summary>A free body that fluids carry: a snapshot of a fluid puts it back where it was.</summary>
    interface ICarriedBody
    {
        /// <summary>The body that moves; null where it was destroyed.</summary>
        Component Body { get; }

        /// <summary>Whether a fluid carries it where it is now.</summary>
        bool IsCarriedBy(FluidSimulation fluid);

        /// <summary>Puts pose, motion, and what is known of the water into a snapshot of one fluid.</summary>
        void Save(FluidSimulation fluid, SnapshotBody to, SnapshotCapture capture);

        /// <summary>Puts the body back.</summary>
        /// <returns>Whether all of it could be: a kinematic body takes no velocity.</returns>
        bool Restore(SnapshotBody from, in BoxMotion box);

        /// <summary>Goes on with what was known of the water, after the body was put back; forgets it where the box is turned otherwise.</summary>
        void Load(FluidSimulation fluid, SnapshotBody from, in BoxMotion box);
    }
}
