using System.Linq;
using Rill;

namespace Host.Report
{
    /// <summary>The report's table of free fall.</summary>
    static class FallReport
    {
        const string Table = "experiment-fall";
        const double Bar = 0.02;        // of the path

        public static void Measure(ReportRun run)
        {
            var table = new ReportTable("deep_water", "substeps", "time_s", "fallen_m", "theory_m", "error", "discrete_error", "radius_ratio");
            foreach (DeepWater deep in new[] { DeepWater.On, DeepWater.Off })
                foreach (int substeps in new[] { 1, 4 })
                {
                    FreeFall fall = FreeFall.Run(FluidRun.Water(substeps, 2, deep), 0.05f);
                    table.Add(deep, substeps, fall.Time, fall.Fallen, fall.Theory, fall.Error, fall.DiscreteError, fall.RadiusRatio);
                }
            run.Save(Table, table, "12 x 12 x 12 particles, d = 5 cm, 60 steps a second, 2 iterations");
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Table);
            page.Heading("Free fall");
            page.Line("A cube of water falls by g t²/2. The integrator first speeds up and then moves, which from rest gives g t (t + " +
                "Δt)/2 after any number of substeps Δt. So it is half a substep ahead, and that is all of its error. Radius: rms distance " +
                "from the center of mass over that at the start, whose lattice is a little too dense in places.");
            page.Line();
            page.Table(new[] { "deep water", "substeps", "t, s", "fallen, m", "g t²/2, m", "error", Verdict.Column(Bar),
                "error to g t (t + Δt)/2", "radius" },
                table.Rows.Select(row => new[] { row["deep_water"], row["substeps"], Figures.Fixed(row.Number("time_s"), 3),
                    Figures.Fixed(row.Number("fallen_m"), 4), Figures.Fixed(row.Number("theory_m"), 4),
                    Figures.Percent(row.Number("error"), 2), Verdict.Within(row.Number("error"), Bar),
                    Figures.Percent(row.Number("discrete_error"), 4),
                    Figures.Fixed(row.Number("radius_ratio"), 5) }));
            page.Line($"({table.Settings}.)");
            page.Line();
        }
    }
}
