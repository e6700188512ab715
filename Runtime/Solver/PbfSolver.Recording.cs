using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Frames of a recording, out of the solver and into it.
    partial class PbfSolver
    {
        FramePacking packing;

        FramePacking Packing => packing ??= new FramePacking();

        /// <summary>Records the packing of the particles as the commands so far leave them.</summary>
        /// <param name="frame">uint, see <see cref="FramePacking.RecordPack"/>.</param>
        public void RecordFrame(CommandBuffer cmd, in FrameLayout layout, GraphicsBuffer frame)
            => Packing.RecordPack(cmd, particles, tags?.Current, Layout.DomainSize, layout, frame);

        /// <summary>
        /// Uploads a frame and records it instead of the present state, with its cells and neighbor lists, so that all that looks at the
        /// particles finds them as after a step: it is one in which nothing acts, from before the frame along the velocities.
        /// </summary>
        /// <param name="still">An input without anything that acts, with one substep and no iteration.</param>
        /// <param name="follows">Whether it goes on from the state that is there: with the same ids, and not after a jump.</param>
        public void ShowFrame(CommandBuffer cmd, in StepInput still, in FrameLayout layout, RecordedFrame frame, bool follows)
        {
            if (!follows)
                InvalidateSurface();
            if (layout.Has(RecordingFields.Phases))
                tags ??= new ParticleTags(Layout.Capacity);
            else
                ReleaseTags();
            hasLifetimes = false;
            markedAfter = 0;
            maxParticles = frame.particles;
            minAdded = 0f;      // where they are is not known here
            maxAdded = Layout.DomainSize;
            Packing.RecordUnpack(cmd, particles, tags?.Current, Layout.DomainSize, layout, frame, still.timeStep);
            Step(cmd, still);
        }

        /// <summary>Gives back what frames need, where none are recorded or shown any more.</summary>
        public void ReleasePacking()
        {
            packing?.Dispose();
            packing = null;
        }
    }
}
