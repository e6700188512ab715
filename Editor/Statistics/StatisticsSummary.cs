using System.Collections.Generic;

namespace Rill.Editor
{
    /// <summary>What the inspector says of a fluid's newest statistics.</summary>
    static class StatisticsSummary
    {
        /// <param name="capacity">Most particles.</param>
        public static IEnumerable<(string label, string text)> Rows(FluidStatistics statistics, int capacity)
        {
            yield return ("Time", $"{statistics.time:F2} s, step {statistics.step:N0}, dropped {statistics.droppedTime:0.##} s");
            yield return ("Particles", $"{statistics.particles:N0} of {capacity:N0}");
            yield return ("Came and went", $"added {statistics.added:N0}, emitted {statistics.emitted:N0}, drained " +
                $"{statistics.drained:N0}, not finite {statistics.nonFinite:N0}");
            yield return ("Left out", $"refused {statistics.refused:N0}, no room {statistics.blocked:N0}, waiting " +
                $"{statistics.waiting:N0}, recycling {statistics.recycling:N0}");
            yield return ("Density error C+",
                $"mean {statistics.densityError:P2}, 99.9 % below {statistics.densityError999:P1}, most {statistics.densityErrorMax:P0}");
            yield return ("Volume", $"{statistics.volumeRatio:F3} of rest");
            yield return ("Speed", $"rms {statistics.speed:F2}, jitter {statistics.jitter:F3}, most {statistics.speedMax:F2} m/s");
            yield return ("Energy", $"{statistics.Energy:G4} J");
            yield return ("Neighbors", $"mean {statistics.neighborsMean:F1}, over the list {statistics.neighborOverflow:N0}");
            if (statistics.viscosityChange > 0f)
                yield return ("Dynamic viscosity", $"last pass changed a velocity by {statistics.viscosityChange:G2} m/s at most");
            yield return ("Solver",
                $"substeps {statistics.substeps}, relaxation {statistics.relaxation}{(statistics.relaxationClamped ? " (clamped)" : "")}");
        }

        public static IEnumerable<string> Warnings(FluidStatistics statistics)
        {
            if (statistics.neighborOverflow > 0)
                yield return $"{statistics.neighborOverflow:N0} particles had more neighbors than their list holds (up to " +
                    $"{statistics.maxNeighbors}). Raise the neighbor capacity.";
            if (statistics.refused > 0)
                yield return $"{statistics.refused:N0} particles did not fit. Raise the capacity.";
            if (statistics.nonFinite > 0)
                yield return $"{statistics.nonFinite:N0} particles with a position that is no number were removed. Look at what added them.";
            if (statistics.escaped > 0)
                yield return $"{statistics.escaped:N0} particles are outside the walls.";
        }

        public static string WhyNone(int statisticsInterval)
        {
            return statisticsInterval == 0 ? "The statistics interval is 0: nothing is measured." : "No measurement has come back yet.";
        }
    }
}
