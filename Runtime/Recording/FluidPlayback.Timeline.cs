using System;
using UnityEngine;

namespace Rill
{
    // Interface for a track of a Timeline; the track is in an assembly of its own, which needs the package com.unity.timeline.
    public sealed partial class FluidPlayback
    {
        const double MaxFollowing = 0.1;    // s: steps up to which the surface goes on from that of the frame before

        /// <summary>Whether a track of a Timeline says which time is shown. Time does not pass by itself meanwhile, also while it
        /// plays.</summary>
        [field: NonSerialized] public bool IsDriven { get; private set; }

        /// <summary>Shows a time, and lets none pass by itself until <see cref="LetGo"/>. Short steps in a row count as playing, others as
        /// jumps. Does nothing where no recording is open.</summary>
        /// <param name="to">Since the first frame, s.</param>
        internal void Drive(double to)
        {
            if (!IsOpen)
                return;
            IsDriven = true;
            bool jumps = hasJumped || Math.Abs(Clamped(to) - time) > MaxFollowing;
            Time = to;
            hasJumped = jumps;
        }

        /// <summary>Ends <see cref="Drive"/>: goes on from the time that is shown, and plays where it played before.</summary>
        internal void LetGo() => IsDriven = false;

        /// <summary>Finds out how long the recording is: of the open one, or without Play of the file.</summary>
        /// <returns>False where that is not known. Why a file cannot be read is logged when it is opened.</returns>
        internal bool TryFindDuration(out double seconds)
        {
            seconds = Duration;
            if (IsOpen || string.IsNullOrEmpty(recording) || Application.isPlaying)
                return IsOpen;
            try
            {
                using (var file = new RecordingReader(OpenFile(PathOf(recording))))
                    seconds = file.FrameCount > 0 ? file.TimeOf(file.FrameCount - 1) - file.TimeOf(0) : 0.0;
                return true;
            }
            catch (Exception refusal) when (IsOfFile(refusal))
            {
                return false;
            }
        }
    }
}
