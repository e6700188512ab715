using System;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The settings that a budget chose, the reason, and their cost.</summary>
    public struct BudgetState
    {
        /// <summary>Why it chose that.</summary>
        public BudgetReason reason;
        /// <summary>Source of the time.</summary>
        public GpuTimeKind source;
        /// <summary>Time that the steps of a frame may take, ms.</summary>
        public float targetMilliseconds;
        /// <summary>Time that they take, ms, as a running mean; 0 while unknown.</summary>
        public float milliseconds;
        /// <summary>Time that they would take with the next better settings, ms; 0 if there are none or nothing is known.</summary>
        public float nextMilliseconds;
        /// <summary>Substeps of a step that it chose.</summary>
        public int substeps;
        /// <summary>Iterations of a substep that it chose.</summary>
        public int iterations;
        /// <summary>Relaxation that it chose.</summary>
        public float relaxation;
        /// <summary>C+ of the newest statistics: the error that the choice costs. NaN where none was measured.</summary>
        public float densityError;
        /// <summary>Time of a step on this GPU over that of the cost model's; 0 while unknown.</summary>
        public float deviceFactor;
        /// <summary>How often the choice changed since the start.</summary>
        public int changes;

        /// <summary>Choice, time and error, in a line.</summary>
        public override string ToString()
        {
            if (reason == BudgetReason.Off)
                return "off";
            string time = milliseconds > 0f ? Invariant($"{milliseconds:0.###} of {targetMilliseconds:0.###} ms ({Source(source)})")
                : Invariant($"{targetMilliseconds:0.###} ms ({Source(source)})");
            string error = float.IsNaN(densityError) ? "density error not measured" : Invariant($"density error {densityError * 100f:0.###} %");
            return Invariant($"{substeps} x {iterations}, relaxation {relaxation}, {time}, {error}: {Why()}");
        }

        /// <summary>The reason in words.</summary>
        public string Why()
        {
            switch (reason)
            {
                case BudgetReason.Off: return "the budget is off";
                case BudgetReason.TimeUnknown: return "this player tells no GPU time, so the settings stay as they are";
                case BudgetReason.TimeIsSpent:
                    return nextMilliseconds > 0f
                    ? Invariant($"the next better settings are expected to take {nextMilliseconds:0.###} ms") : "no better settings fit";
                case BudgetReason.ErrorIsReached: return "the density error is within its target";
                case BudgetReason.BestFits: return "the best settings within the bounds fit";
                case BudgetReason.MinStable: return "the cheapest settings that are stable and within the bounds take longer than the budget";
                case BudgetReason.OverBudget: return "the settings take longer than the budget, so that cheaper ones follow";
                default: throw Limit.OutOfRange(nameof(reason), reason, "No such reason.");
            }
        }

        static string Source(GpuTimeKind kind)
        {
            switch (kind)
            {
                case GpuTimeKind.Measured: return "measured";
                case GpuTimeKind.Modeled: return "modeled";
                default: return "time unknown";
            }
        }
    }
}
