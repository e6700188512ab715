using System;
using UnityEngine.Rendering;

namespace Rill
{
    // What is drawn of the water: made when first needed, from the state that the last step left.
    partial class PbfSolver
    {
        SurfaceParticles surface;
        int substepsSinceSurface;
        bool hasNew;        // particles that the last step did not move

        /// <summary>What has to be drawn of the water's surface; null while nothing draws it.</summary>
        public SurfaceParticles Surface => surface;

        /// <summary>Whether <see cref="Surface"/> is that of the current state.</summary>
        public bool SurfaceIsCurrent { get; private set; }

        /// <summary>Differs once <see cref="Surface"/> is that of another state.</summary>
        public int SurfaceVersion { get; private set; } = 1;

        /// <summary>Records the surface of the current state; not after <see cref="RecordStatistics"/> of that state, which sorts again.</summary>
        /// <exception cref="ArgumentOutOfRangeException">Its buffers are more than the device can bind.</exception>
        public void RecordSurface(CommandBuffer cmd, in StepInput input)
        {
            surface ??= new SurfaceParticles(Layout);
            bool hasSteps = lastSubsteps > 0 && !isRestored && !HasMarked;       // the neighbor lists do not know which particles are gone
            StepInput last = input;
            last.settings.substeps = Math.Max(lastSubsteps, 1);
            SurfaceVersion++;
            surface.Record(Context(cmd, last, hasSteps), hasSteps, hasNew, SurfaceVersion, substepsSinceSurface, hasGhosts);
            SurfaceIsCurrent = true;
            substepsSinceSurface = 0;
        }

        // What comes next has nothing to do with what was drawn before.
        void InvalidateSurface()
        {
            SurfaceIsCurrent = false;
            SurfaceVersion++;
        }

        /// <summary>Gives back what the surface needs, where nothing draws it any more.</summary>
        public void ReleaseSurface()
        {
            surface?.Dispose();
            surface = null;
            SurfaceIsCurrent = false;
        }
    }
}
