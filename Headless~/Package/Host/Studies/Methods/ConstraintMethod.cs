using System;
using Rill;
using UnityEngine.Rendering;

namespace Host.Studies.Methods
{
    /// <summary>How the passes of a substep correct the predicted positions: what the study varies.</summary>
    abstract class ConstraintMethod : IDisposable
    {
        /// <summary>Whether the last kernel to write the positions is the package's own.</summary>
        public virtual bool EndsInPackagePass => false;

        /// <summary>Records the neighbor list and all passes: Predicted ends corrected, Current is used up.</summary>
        public abstract void Record(CommandBuffer cmd, StudySolver solver, in StepInput input);

        public virtual void Dispose() { }
    }

    /// <summary>The package's own passes.</summary>
    sealed class Jacobi : ConstraintMethod
    {
        public override bool EndsInPackagePass => true;

        public override void Record(CommandBuffer cmd, StudySolver solver, in StepInput input) =>
            solver.RecordPackagePasses(cmd, input.settings.relaxation, input.settings.iterations);
    }
}
