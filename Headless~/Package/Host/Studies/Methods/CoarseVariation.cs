using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

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

        public CoarseCorrection Create(SolverLayout layout, in StepInput input)
        {
            float substep = input.timeStep / input.settings.substeps;
            float size = CellSize > 0 ? CellSize
                : CoarseGrid.CellSizeFor(layout.DomainSize, math.length(input.gravity) / layout.Spacing * substep * substep, 0f);
            var coarse = new CoarseCorrection(layout, size);
            coarse.Solver.Cycles = Cycles;
            CoarseConstants constants = CoarseConstants.For(coarse.Grid);
            if (ScreeningLength is float length)
                constants.screening = 1f / (length * length);
            if (!SurfaceDistance)
                constants.minSurfaceDistance = constants.maxSurfaceDistance = 1f;
            coarse.Constants.SetData(new[] { constants });
            return coarse;
        }

        /// <summary>Records what comes before a substep.</summary>
        public void RecordStart(CommandBuffer cmd, CoarseCorrection coarse)
        {
            if (WarmStart)
                return;
            var none = new float[coarse.Grid.Total];
            cmd.SetBufferData(coarse.Cells.flowPotential, none);
            cmd.SetBufferData(coarse.Cells.errorPotential, none);
        }
    }
}
