using System;
using UnityEngine;

namespace Rill
{
    // The water's surface for what draws it: found once a frame in which something asks for it and the water has changed.
    public sealed partial class FluidSimulation
    {
        const int FramesToKeepSurface = 30;     // that nothing asks for: a camera may look away for a moment

        [NonSerialized] int framesWithoutSurface;
        PbfSolver tooLarge;         // whose surface this device cannot hold

        /// <summary>Before the steps of a frame: what draws the surface sets <see cref="NeedsSurface"/> where it does in this frame.</summary>
        internal event Action AskForSurface;

        /// <summary>Whether this frame ends with the surface of its state: <see cref="PbfSolver.Surface"/>. False again after the frame.</summary>
        [field: NonSerialized] internal bool NeedsSurface { get; set; }

        /// <summary>Records the surface where it is asked for and not that of the current state.</summary>
        /// <returns>Whether anything was recorded.</returns>
        bool RecordSurface()
        {
            if (!NeedsSurface || pbf.SurfaceIsCurrent || pbf == tooLarge)
                return false;
            if ((wanted & DeviceFeature.Surface) == 0)      // no step has asked yet
            {
                wanted |= DeviceFeature.Surface;
                if (gate.Decide(wanted))
                    LogRefusals();
            }
            if (IsRefused(DeviceFeature.Surface) || !HasStages(StageSet.Surface))
                return false;
            try
            {
                pbf.RecordSurface(commands, input);
                return true;
            }
            catch (ArgumentException problem)
            {
                tooLarge = pbf;
                Debug.LogError($"Rill: FluidSimulation '{name}' goes on without the water's surface: {problem.Message} Lower the " +
                    $"capacity, or draw it with a ParticleRenderer.", this);
                return false;
            }
        }

        /// <summary>Ends a frame: the surface of one without steps, for what was added, restarted or is drawn for the first time.</summary>
        void FinishSurface()
        {
            if (pbf == null)
                return;
            framesWithoutSurface = NeedsSurface ? 0 : Math.Min(framesWithoutSurface + 1, FramesToKeepSurface);
            if (NeedsSurface && !pbf.SurfaceIsCurrent)
            {
                commands.Clear();
                if (RecordSurface())
                    Graphics.ExecuteCommandBuffer(commands);
            }
            else if (framesWithoutSurface == FramesToKeepSurface)
            {
                pbf.ReleaseSurface();
            }
            NeedsSurface = false;
        }
    }
}
