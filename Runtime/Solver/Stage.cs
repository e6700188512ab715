using System;
using System.Collections.Generic;

namespace Rill
{
    /// <summary>How all particles changed at once, between steps.</summary>
    enum ParticleChange
    {
        /// <summary>The fluid starts again, at step 0.</summary>
        Restarted,
        /// <summary>All particles were removed; steps and counters go on.</summary>
        Removed,
        /// <summary>The box was moved under them.</summary>
        Shifted,
    }

    /// <summary>Part of the solver that is made when first needed and owns GPU work: its kernels and its buffers.</summary>
    abstract class Stage : IDisposable
    {
        /// <summary>Buffers that live as long as the stage.</summary>
        protected BufferSet Buffers { get; } = new BufferSet();

        /// <summary>Lists the buffers that the next step depends on.</summary>
        public virtual void ListState(List<StateBuffer> state) { }

        /// <summary>Forgets what a change of all particles makes void.</summary>
        /// <returns>Whether the stage can go on; else it is released, and made again when needed.</returns>
        public virtual bool Survives(ParticleChange change) => true;

        /// <summary>Returns whether the stage can serve a step with this input; else it is made again.</summary>
        public virtual bool Fits(PbfSolver solver, in StepInput step) => true;

        public virtual void Dispose() => Buffers.Dispose();
    }
}
