using UnityEngine;

namespace Rill
{
    /// <summary>A collider as a fluid sees it: a <see cref="FluidCollider"/>, or one that a source of this fluid gathered.</summary>
    interface IFluidCollider
    {
        /// <summary>Name of its object, for messages.</summary>
        string Name { get; }

        /// <summary>Whether it can be taken now: enabled, and not destroyed.</summary>
        bool IsAlive { get; }

        /// <summary>Grows each time that it went somewhere else without moving there.</summary>
        int Teleports { get; }

        /// <summary>Whether what the fluid does to it is brought back.</summary>
        bool MeasuresForce { get; }

        /// <summary>Whether the fluid carries its body.</summary>
        bool IsCarried { get; }

        /// <summary>Shape and pose now, in world space and meters; its poses are both the present one.</summary>
        /// <returns>Why it is not a collider; null where it is one.</returns>
        string Describe(out ColliderMotion motion);

        /// <summary>Describes it as <see cref="Describe"/> does; a problem is logged once, by name.</summary>
        /// <returns>Whether it is a collider.</returns>
        bool TryDescribe(out ColliderMotion motion);

        /// <summary>A fluid has begun to sum what it does to it.</summary>
        void AwaitForce(FluidSimulation fluid);

        /// <summary>Takes a new result of a fluid instead of its last.</summary>
        void SetForce(in FluidForce force);

        /// <summary>Calls the listeners to what the newest result of a fluid has changed. They may do anything to the scene.</summary>
        void RaiseContacts(FluidSimulation fluid);

        /// <summary>Drops the result of a fluid that it has left.</summary>
        /// <returns>Whether listeners have to be told, by <see cref="RaiseExit"/>.</returns>
        bool Leave(FluidSimulation fluid);

        /// <summary>Puts what is known of a fluid's force into a snapshot.</summary>
        void SaveForce(FluidSimulation fluid, ref ForceRecord record);

        /// <summary>Takes it out of one.</summary>
        /// <param name="moved">How far the fluid is from where it was in the snapshot, m.</param>
        void LoadForce(FluidSimulation fluid, in ForceRecord record, Vector3 moved);

        /// <summary>Calls the listeners to its leaving a fluid.</summary>
        void RaiseExit(FluidSimulation fluid);
    }
}
