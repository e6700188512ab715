using System;
using UnityEngine;

namespace Rill
{
    // Simulated in the Editor without Play: its time comes from there, and nothing that the scene stores is changed.
    public sealed partial class FluidSimulation : IRunsInEditMode
    {
        float? editorTime;      // for the next frame, s; null where none has come since the last

        /// <summary>Whether the Editor simulates this fluid without Play. Set before it is enabled there, and taken back when it is
        /// disabled.</summary>
        [field: NonSerialized] internal bool IsInEditMode { get; set; }

        /// <summary>Gives it the time of the next frame, s; 0 stands for a pause.</summary>
        internal void GiveTime(float seconds) => editorTime = seconds;

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => ReferenceEquals(fluid, this);

        // The Editor calls LateUpdate also between two of its times, where something of the scene changed.
        void AdvanceInEditMode()
        {
            if (!(editorTime is float seconds))
                return;
            editorTime = null;
            Advance(seconds);
        }

        // Neither the stored pause counts there nor which camera sees it.
        static float RateInEditMode(float frameTime) => frameTime > 0f ? 1f : 0f;
    }
}
