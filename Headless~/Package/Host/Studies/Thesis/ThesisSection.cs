using System.Collections.Generic;
using Host.Report;

namespace Host.Studies.Thesis
{
    /// <summary>The figures of Svensson's thesis made again with plain iterations: a part for each measuring that they rest on.</summary>
    sealed class ThesisSection : ReportSection
    {
        readonly IReadOnlyList<ThesisFigure> figures = new ThesisFigure[] { new ThesisKernels(), new ThesisCapacity(), new ThesisDensity(),
            new ThesisTime() };

        public override string Name => "thesis";
        public override string Title => "The thesis's figures, made again";

        public override void Measure(ReportRun run)
        {
            foreach (ThesisFigure figure in figures)
            {
                run.Log(figure.Title);
                figure.Measure(run);
            }
        }

        public override void Write(ReportPage page)
        {
            page.Line("Svensson's *Parallel GPU-Based Fluid Animation* (2016) runs position based fluids by plain Jacobi iterations " +
                "with a relaxation ω. " +
                "Here its figures are measured on this solver with *Deep Water* off, on a breaking dam, and set beside what the thesis found. " +
                "Hardware, scene and code are others, so shapes are compared, not milliseconds. A run that gains more than 1 % of energy " +
                $"is *{Verdict.NotComparable}*.");
            page.Line();
            foreach (ThesisFigure figure in figures)
            {
                page.Heading(figure.Title);
                figure.Write(page);
            }
        }
    }
}
