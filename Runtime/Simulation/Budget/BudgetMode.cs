namespace Rill
{
    /// <summary>Unit in which a <see cref="SolverBudget"/> is given.</summary>
    public enum BudgetMode
    {
        /// <summary>There is none: the solver's settings hold as they stand.</summary>
        Off,
        /// <summary>Milliseconds of GPU time in a frame.</summary>
        Milliseconds,
        /// <summary>A fraction of the frame that the game aims for.</summary>
        FrameFraction,
    }
}
