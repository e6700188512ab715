namespace Rill
{
    /// <summary>Why a budget chose what it chose.</summary>
    public enum BudgetReason
    {
        /// <summary>The budget is off, or the fluid does not run.</summary>
        Off,
        /// <summary>No GPU time is known: settings stay as they are.</summary>
        TimeUnknown,
        /// <summary>The next better settings would take longer than the budget.</summary>
        TimeIsSpent,
        /// <summary>The density error is within its target, so no more is spent.</summary>
        ErrorIsReached,
        /// <summary>The best settings within the bounds fit.</summary>
        BestFits,
        /// <summary>The cheapest settings that keep the scene stable, within the bounds, take longer than the budget; they stand.</summary>
        MinStable,
        /// <summary>The settings take longer than the budget; cheaper ones follow, unless the next readings take it back.</summary>
        OverBudget,
    }
}
