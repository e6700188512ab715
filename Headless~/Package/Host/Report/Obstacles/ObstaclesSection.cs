using System;
using Rill;

namespace Host.Report.Obstacles
{
    /// <summary><c>obstacles</c>: what colliders and water do to each other, against what can be worked out on paper.</summary>
    sealed class ObstaclesSection : ReportSection
    {
        const double Bar = 0.05;

        public override string Name => "obstacles";
        public override string Title => "Obstacles against theory";

        public override void Measure(ReportRun run)
        {
            OrificeReport.Measure(run);
            FloatingReport.Measure(run);
            BucketReport.Measure(run);
        }

        public override void Write(ReportPage page)
        {
            page.Line("The bar is 5 % of the theory. What is outside stands here as it was measured.");
            page.Line();
            OrificeReport.Write(page);
            FloatingReport.Write(page);
            BucketReport.Write(page);
        }

        internal static string Within(double error) => Verdict.Within(error, Bar);

        internal static string Text(DeepWater deepWater) => deepWater == DeepWater.Off ? "off" : "on";
    }
}
