using Host.Experiments;
using Host.Report;

namespace Host.Studies.Thesis
{
    /// <summary>One of the thesis's figures, or several that show the same data.</summary>
    abstract class ThesisFigure
    {
        public abstract string Title { get; }
        public abstract void Measure(ReportRun run);
        public abstract void Write(ReportPage page);

        /// <summary>The thesis's breaking dam, or what of it a CPU can do.</summary>
        protected static ExperimentScene Dam(ReportRun run) => ExperimentScene.Dam(run.Quick ? 2_000 : 100_000);
    }
}
