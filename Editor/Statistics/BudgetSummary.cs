using System.Collections.Generic;
using UnityEditor;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Inspector texts of a budget: rows while it plays, and its problems.</summary>
    static class BudgetSummary
    {
        /// <summary>Effect of an active budget on the solver's own settings.</summary>
        public const string SolverNote = "The budget chooses iterations, relaxation and substeps once the GPU time is known; until then these hold.";

        public static IEnumerable<(string label, string text)> Rows(BudgetState state)
        {
            if (state.reason == BudgetReason.Off)
                yield break;
            yield return ("Budget chose", Invariant($"{state.substeps} substeps x {state.iterations} iterations, relaxation ") +
                Invariant($"{state.relaxation}"));
            yield return ("because", state.Why());
            string spent = state.milliseconds > 0f ? Invariant($"{state.milliseconds:0.###} of {state.targetMilliseconds:0.###} ms")
                : Invariant($"{state.targetMilliseconds:0.###} ms to spend");
            yield return ("GPU time", $"{spent}, {Of(state.source)}");
            yield return ("Error it costs", float.IsNaN(state.densityError) ? "not measured" : Invariant($"mean {state.densityError:P2}"));
            if (state.deviceFactor > 0f)
                yield return ("Device factor", Invariant($"{state.deviceFactor:0.##} x the cost model"));
        }

        public static IEnumerable<(MessageType type, string text)> Messages(SolverBudget budget, BudgetState state, int statisticsInterval)
        {
            if (!budget.Validate(out string problem))
                yield return (MessageType.Warning, problem);
            if (budget.mode == BudgetMode.Off)
                yield break;
            if (budget.targetError > 0f && statisticsInterval == 0)
                yield return (MessageType.Warning, "The statistics interval is 0, so the budget never hears of the density error and " +
                    "spends all of its time. Set an interval, or the target error to 0.");
            if (state.reason == BudgetReason.MinStable)
                yield return (MessageType.Warning, $"The budget cannot be held: {state.Why()}. Raise it, or have fewer particles.");
            if (state.reason == BudgetReason.TimeUnknown)
                yield return (MessageType.Info, "This player tells no GPU time yet. In release players turn on Frame Timing Stats " +
                    "(Project Settings, Player) or set the device factor.");
        }

        static string Of(GpuTimeKind source)
        {
            switch (source)
            {
                case GpuTimeKind.Measured: return "measured around the steps";
                case GpuTimeKind.Modeled: return "modeled from particles and passes";
                default: return "unknown";
            }
        }
    }
}
