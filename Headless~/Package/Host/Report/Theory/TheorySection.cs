namespace Host.Report
{
    /// <summary><c>experiment</c>: the solver against what was measured on water and what can be worked out on paper.</summary>
    sealed class TheorySection : ReportSection
    {
        public override string Name => "experiment";
        public override string Title => "Against experiment and theory";

        public override void Measure(ReportRun run)
        {
            FrontReport.Measure(run);
            ColumnReport.Measure(run);
            SloshingReport.Measure(run);
            FallReport.Measure(run);
        }

        public override void Write(ReportPage page)
        {
            FrontReport.Write(page);
            ColumnReport.Write(page);
            SloshingReport.Write(page);
            FallReport.Write(page);
        }
    }
}
