using System.Collections.Generic;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Inspector texts of a fluid's newest statistics.</summary>
    static class StatisticsSummary
    {
        /// <param name="capacity">Most particles.</param>
        public static IEnumerable<(string label, string text)> Rows(FluidStatistics statistics, int capacity)
        {
            yield return ("Time", Invariant($"{statistics.time:F2} s, step {statistics.step:N0}, dropped {statistics.droppedTime:0.##} s"));
            yield return ("Particles", Invariant($"{statistics.particles:N0} of {capacity:N0}"));
            yield return ("Came and went", Invariant($"added {statistics.added:N0}, emitted {statistics.emitted:N0}, drained ") +
                Invariant($"{statistics.drained:N0}, not finite {statistics.nonFinite:N0}"));
            yield return ("Left out", Invariant($"refused {statistics.refused:N0}, no room {statistics.blocked:N0}, waiting ") +
                Invariant($"{statistics.waiting:N0}, recycling {statistics.recycling:N0}"));
            yield return ("Density error C+",
                Invariant($"mean {statistics.densityError:P2}, 99.9 % below {statistics.densityError999:P1}, most ") +
                Invariant($"{statistics.densityErrorMax:P0}"));
            yield return ("Volume", Invariant($"{statistics.volumeRatio:F3} of rest"));
            yield return ("Speed", Invariant($"rms {statistics.speed:F2}, jitter {statistics.jitter:F3}, most {statistics.speedMax:F2} ") +
                "m/s");
            yield return ("Energy", Invariant($"{statistics.Energy:G4} J"));
            yield return ("Neighbors", Invariant($"mean {statistics.neighborsMean:F1}, most {statistics.neighborsMax}, over the list ") +
                Invariant($"{statistics.neighborOverflow:N0}"));
            if (statistics.viscosityChange > 0f)
                yield return ("Dynamic viscosity", Invariant($"last pass changed a velocity by {statistics.viscosityChange:G2} m/s at ") +
                    "most");
            yield return ("Solver",
                Invariant($"substeps {statistics.substeps}, relaxation ") +
                Invariant($"{statistics.relaxation}{(statistics.relaxationClamped ? " (clamped)" : "")}"));
        }

        public static IEnumerable<string> Warnings(FluidStatistics statistics)
        {
            if (statistics.neighborOverflow > 0)
                yield return Invariant($"{statistics.neighborOverflow:N0} particles had more neighbors than their list holds (up to ") +
                    Invariant($"{statistics.neighborOverflowMax}). Raise the neighbor capacity.");
            if (statistics.refused > 0)
                yield return Invariant($"{statistics.refused:N0} particles did not fit. Raise the capacity.");
            if (statistics.nonFinite > 0)
                yield return Invariant($"{statistics.nonFinite:N0} particles with a position that is not a number were removed. Look at ") +
                    "what added them.";
            if (statistics.escaped > 0)
                yield return Invariant($"{statistics.escaped:N0} particles are outside the walls.");
        }

        public static string WhyNone(int statisticsInterval)
        {
            return statisticsInterval == 0 ? "The statistics interval is 0: nothing is measured." : "No measurement has come back yet.";
        }
    }
}
