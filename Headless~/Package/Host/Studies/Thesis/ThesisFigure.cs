using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Host.Report;
using Host.Report.ErrorTime;

namespace Host.Studies.Thesis
{
    /// <summary>One of the thesis's figures, or several that show the same data.</summary>
    abstract class ThesisFigure
    {
        /// <summary>Substeps with which plain iterations hold the thesis's dam.</summary>
        protected const int Substeps = 4;
        /// <summary>Most energy over that of the start that water may show.</summary>
        protected const double MaxEnergy = SweepResult.MaxEnergy;

        public abstract string Title { get; }
        public abstract void Measure(ReportRun run);
        public abstract void Write(ReportPage page);

        /// <summary>The thesis's breaking dam, or what of it a CPU can do.</summary>
        protected static ExperimentScene Dam(ReportRun run) => ExperimentScene.Dam(run.Quick ? 2_000 : 100_000);

        /// <summary>Whether a run kept its energy. Otherwise it exploded, and is not comparable with the thesis's water.</summary>
        protected static bool IsComparable(ReportTable.Row row) => row.Number("energy") <= MaxEnergy;

        /// <summary>Puts the runs that gained energy among what fails.</summary>
        protected static void ListFailures(ReportPage page, IEnumerable<bool> kept) => page.ListFailures(
            new[] { "run", ReportFailures.DeepWater, "energy", FormattableString.Invariant($"at most {MaxEnergy} of the start's") },
            kept.Select((held, i) => new[] { $"{i}", "off", held ? "" : Verdict.NotComparable, Verdict.Of(held) }));
    }
}
