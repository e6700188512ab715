using Rill;

namespace Host.Studies.Methods
{
    /// <summary>The two-level correction with other parameters than the package's.</summary>
    sealed record CoarseVariation
    {
        /// <summary>Side H of a coarse cell, d; 0: the package's choice.</summary>
        public float CellSize { get; init; }
        /// <summary>Length ℓ, d; infinite for no screening, null for the package's.</summary>
        public float? ScreeningLength { get; init; }
        /// <summary>Whether the free surface lies where the fill says (θ), or in the middle of the first cell that is not active.</summary>
        public bool SurfaceDistance { get; init; } = true;
        /// <summary>Whether a solve starts from the last one's potential.</summary>
        public bool WarmStart { get; init; } = true;
        /// <summary>V-cycles a solve.</summary>
        public int Cycles { get; init; } = 1;

        /// <summary>Gives a correction that was just made these parameters.</summary>
        public void Apply(CoarseCorrection coarse)
        {
            coarse.Solver.Cycles = Cycles;
            CoarseConstants constants = CoarseConstants.For(coarse.Grid);
            if (ScreeningLength is float length)
                constants.screening = 1f / (length * length);
            if (!SurfaceDistance)
                constants.minSurfaceDistance = constants.maxSurfaceDistance = 1f;
            coarse.Constants.SetData(new[] { constants });
        }

        /// <summary>Records what comes after the passes of a substep.</summary>
        public void RecordEnd(in StepContext step)
        {
            if (WarmStart)
                return;
            var none = new float[step.Coarse.Grid.Total];
            step.Commands.SetBufferData(step.Coarse.Cells.flowPotential, none);
            step.Commands.SetBufferData(step.Coarse.Cells.errorPotential, none);
        }
    }
}
