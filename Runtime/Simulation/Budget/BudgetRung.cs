namespace Rill
{
    /// <summary>Solver settings that a budget may choose.</summary>
    readonly struct BudgetRung
    {
        public readonly int Substeps, Iterations;
        public readonly float Relaxation;
        /// <summary>C+ that was measured with them on the ladder's own scene: what they give beside the other rungs.</summary>
        public readonly float Error;

        public BudgetRung(int substeps, int iterations, float relaxation, float error)
        {
            Substeps = substeps;
            Iterations = iterations;
            Relaxation = relaxation;
            Error = error;
        }

        public BudgetRung WithSubsteps(int substeps) => new BudgetRung(substeps, Iterations, Relaxation, Error);

        /// <summary>These settings instead of those that were asked for.</summary>
        public SolverSettings Apply(SolverSettings settings)
        {
            settings.substeps = Substeps;
            settings.iterations = Iterations;
            settings.relaxation = Relaxation;
            return settings;
        }
    }
}
