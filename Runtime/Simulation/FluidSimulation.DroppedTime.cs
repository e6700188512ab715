using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // Frames that are longer than the steps that they may take.
    public sealed partial class FluidSimulation
    {
        const int DroppingFrames = 5;       // in a row: one hitch is no news

        [NonSerialized] bool dropIsKnown;

        /// <summary>Whether one of the last frames was so long that the fluid dropped time.</summary>
        internal bool DropsTime => clock.DropsTime;

        /// <summary>How fast its time goes by in the game's: 1 but where it drops some.</summary>
        internal float RateOfTime => (float)clock.FrameRate;

        void LogDroppedTime(float frameTime)
        {
            if (dropIsKnown || clock.DroppingFrames < DroppingFrames || IsInEditMode)
                return;
            dropIsKnown = true;
            Debug.LogWarning(Invariant($"Rill: FluidSimulation '{name}' drops time, and runs slower than the game: frames of ") +
                Invariant($"{frameTime:0.###} s need {Math.Ceiling(frameTime * stepRate - 1e-3f):0} fixed steps, and Max Steps Per Frame is ") +
                Invariant($"{maxStepsPerFrame}. Raise Max Steps Per Frame, to 16 at most, or lower Step Rate."), this);
        }
    }
}
