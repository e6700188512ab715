using System;
using Rill;

namespace Host.Studies.Methods
{
    /// <summary>How the passes of a substep correct the predicted positions: what the study varies.</summary>
    abstract class ConstraintMethod : IDisposable
    {
        /// <summary>Whether the last kernel to write the positions is the package's own.</summary>
        public virtual bool EndsInPackagePass => false;

        /// <summary>Records the neighbor list and all passes: Predicted ends corrected.</summary>
        public abstract void Record(in StepContext step, StudySolver solver);

        public virtual void Dispose() { }
    }

    /// <summary>The package's own passes.</summary>
    sealed class Jacobi : ConstraintMethod
    {
        public override bool EndsInPackagePass => true;

        public override void Record(in StepContext step, StudySolver solver) =>
            solver.RecordPackagePasses(step, step.Input.settings.relaxation, step.Input.settings.iterations);
    }
}
