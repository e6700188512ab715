namespace Host.Report
{
    /// <summary><c>damping</c>: what time step and spacing take of motion that ideal water keeps.</summary>
    sealed class DampingSection : ReportSection
    {
        public override string Name => "damping";
        public override string Title => "Numerical damping";

        public override void Measure(ReportRun run)
        {
            NumericalDampingReport.Measure(run);
            UTubeReport.Measure(run);
            ReflectedWavesReport.Measure(run);
            WavemakerReport.Measure(run);
        }

        public override void Write(ReportPage page)
        {
            NumericalDampingReport.Write(page);
            UTubeReport.Write(page);
            ReflectedWavesReport.Write(page);
            WavemakerReport.Write(page);
        }
    }
}
