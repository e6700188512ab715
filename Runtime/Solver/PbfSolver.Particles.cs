using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // The particles for a project's own passes, draws and readbacks.
    partial class PbfSolver
    {
        ParticleAccess access;
        GraphicsBuffer noTags;

        /// <summary>Differs once the buffers of the particles have changed roles.</summary>
        public int StateVersion { get; private set; }

        /// <summary>Differs after a <see cref="Clear"/>: the particles are others.</summary>
        public int Generation { get; private set; }

        /// <summary>uint [cells + 1], see <see cref="RecordOrder"/>.</summary>
        public GraphicsBuffer CellStarts => neighborSearch.CellStartsAtRest;

        /// <summary>uint [capacity], indices of particles by cell after <see cref="RecordOrder"/>.</summary>
        public GraphicsBuffer Order => particles.SortedIds;

        /// <summary>The tags, or a buffer of one word that stands for them.</summary>
        public GraphicsBuffer TagsToBind
        {
            get
            {
                if (tags != null)
                    return tags.Current;
                if (noTags == null)
                {
                    noTags = GpuBuffer.Structured<uint>("Rill.NoTags", 1);
                    BufferClear.Now(noTags);
                }
                return noTags;
            }
        }

        ParticleAccess Access => access ??= new ParticleAccess();

        /// <summary>Records a kernel in groups of <see cref="ParticleBuffers.Group"/> threads for the particles alive.</summary>
        public void DispatchAlive(CommandBuffer cmd, ComputeShader shader, int kernel) => particles.DispatchAlive(cmd, shader, kernel);

        /// <summary>Records the listing of the particles by cell, at their current positions; it holds until a step or until some are
        /// added.</summary>
        public void RecordOrder(CommandBuffer cmd)
        {
            // After a step its constants are there; of these, the listing reads the layout alone.
            if (lastSubsteps == 0)
                UploadConstants(cmd, new StepInput { timeStep = 1f, settings = SolverSettings.Default, material = FluidMaterial.Water });
            Access.RecordOrder(BetweenSteps(cmd));
        }

        /// <summary>Before the passes of a step, which then find the phases that its input asks for.</summary>
        public void PreparePhases(in StepInput input)
        {
            if (input.tracksPhases)
                tags ??= new ParticleTags(Layout.Capacity);
        }

        /// <summary>Records a copy of the particles in world space, see <see cref="ParticleAccess"/>.</summary>
        public void RecordCopy(CommandBuffer cmd, Matrix4x4 domainToWorld, in ParticleCopyLayout layout, GraphicsBuffer copy)
            => Access.RecordCopy(cmd, particles, TagsToBind, tags != null, domainToWorld, layout, copy);

        void RecordKills(in StepContext step)
        {
            if (step.Input.removesKilled)
                Access.RecordKills(step);
        }

        // What was taken of the particles before is of another state.
        void InvalidateParticles(bool areOthers)
        {
            StateVersion++;
            Generation += areOthers ? 1 : 0;
        }
    }
}
