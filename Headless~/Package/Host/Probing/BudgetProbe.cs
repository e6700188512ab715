using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Host.Output;
using Rill;
using Object = UnityEngine.Object;

namespace Host.Probing
{
    /// <summary>Records the choices of a simulation's budget in a run, and the time of the steps.</summary>
    sealed class BudgetProbe : IRunProbe
    {
        readonly FluidSimulation simulation;
        readonly string prefix;

        BudgetProbe(FluidSimulation simulation, string prefix)
        {
            this.simulation = simulation;
            this.prefix = prefix;
        }

        /// <summary>One probe for each simulation with a budget; columns carry its name where there are several.</summary>
        public static IEnumerable<IRunProbe> OfScene()
        {
            FluidSimulation[] simulations = Object.FindObjectsOfType<FluidSimulation>();
            return simulations.Where(simulation => simulation.Budget.mode != BudgetMode.Off)
                .Select(simulation => new BudgetProbe(simulation, simulations.Length > 1 ? simulation.name + "_" : ""));
        }

        public string[] Columns => new[] { prefix + "budget_ms", prefix + "budget_target_ms", prefix + "budget_substeps",
            prefix + "budget_iterations", prefix + "budget_changes" };

        public void Sample(double time, double[] values)
        {
            BudgetState state = simulation.BudgetState;
            values[0] = state.milliseconds > 0f ? state.milliseconds : double.NaN;
            values[1] = state.targetMilliseconds;
            values[2] = state.substeps;
            values[3] = state.iterations;
            values[4] = state.changes;
        }

        public Plot[] Plots => new[]
        {
            new Plot(prefix + "budget", "Budget", "ms of a frame's steps", prefix + "budget_ms", prefix + "budget_target_ms"),
            new Plot(prefix + "budget-choice", "Budget's choice", "count", prefix + "budget_iterations", prefix + "budget_substeps"),
        };

        public IEnumerable<(string Name, string Value)> Settings
        {
            get { yield return (prefix + "budget", simulation.BudgetState.ToString()); }
        }

        public IEnumerable<string> Summary
        {
            get { yield return string.Create(CultureInfo.InvariantCulture,
                $"budget of '{simulation.name}': {simulation.BudgetState}; {simulation.BudgetState.changes} changes"); }
        }
    }
}
