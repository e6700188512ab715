using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report
{
    /// <summary>The report's sloshing: periods at three depths against linear theory, and the curves they come from.</summary>
    static class SloshingReport
    {
        const string Periods = "experiment-sloshing", Curves = "experiment-sloshing-curves";
        static readonly double[] Depths = { 0.15, 0.35, 0.7 };
        // Low waves: at a depth of 0.15 m theory's next order lengthens no period by more than half a percent.
        const double Lean = 0.03;

        public static void Measure(ReportRun run)
        {
            var periods = new ReportTable("depth_m", "layers", "substeps", "iterations", "period_s", "theory_s", "error", "damping_per_period", "misfit");
            var curves = new ReportTable("depth_m", "substeps", "iterations", "time_s", "x_m", "fit_m");
            int along = run.Quick ? 32 : 80;
            double swings = run.Quick ? 3 : 6;
            (int substeps, int iterations)[] settings = run.Quick ? new[] { (1, 2) } : new[] { (1, 2), (1, 4), (2, 2), (4, 2) };
            foreach (double wanted in Depths)
                foreach ((int substeps, int iterations) in settings)
                {
                    double depth = Sloshing.NearestDepth(along, wanted), theory = Sloshing.Period(depth);
                    List<(double Time, double Value)> samples = Sloshing.Run(along, depth, Lean, FluidRun.Water(substeps, iterations), swings * theory);
                    DampedCosine fit = DampedCosine.Fit(samples);
                    periods.Add(depth, depth * along, substeps, iterations, fit.Period, theory, fit.Period / theory - 1, fit.Damping * fit.Period, fit.Misfit);
                    foreach ((double time, double value) in samples)
                        curves.Add(depth, substeps, iterations, time, value, fit.At(time));
                    run.Log($"  sloshing {depth:0.000} m, {substeps} x {iterations}: {fit.Period:0.000} s, theory {theory:0.000}");
                }
            string settled = $"box 1 m long of {along} d, 8 d thick, 60 steps a second, gravity leaning by {Lean} rad, {swings} periods";
            run.Save(Periods, periods, settled);
            run.Save(Curves, curves, settled);
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Periods);
            page.Line("### Sloshing");
            page.Line();
            page.Line("Level water in a box is let go under gravity that leans a little: it swings in its first mode about the surface that is level to that gravity. The period is that of a damped cosine fitted to the centre of mass along the box; theory: ω² = g k tanh(k H), k = π/L. Damping: share of the amplitude that is lost a period, as −ln.");
            page.Line();
            page.Table(new[] { "depth H, m", "layers", "substeps x iterations", "period, s", "theory, s", "error", "damping a period", "misfit of the cosine" },
                table.Rows.Select(row => new[] { Figures.Fixed(row.Number("depth_m"), 3), row["layers"], $"{row["substeps"]} x {row["iterations"]}", Figures.Fixed(row.Number("period_s"), 3), Figures.Fixed(row.Number("theory_s"), 3), Figures.Percent(row.Number("error")), Figures.Fixed(row.Number("damping_per_period"), 3), Figures.Percent(row.Number("misfit")) }));
            page.Line($"({table.MeasuredOn}.)");
            page.Line();
            string file = page.DataFile(Curves);
            IEnumerable<string> lines = page.Load(Curves).Rows.Where(row => row["substeps"] == "1" && row["iterations"] == "2").Select(row => row["depth_m"]).Distinct()
                .SelectMany((depth, i) => new[]
                {
                    $"'{file}' using ($1=={depth} && $2==1 && $3==2 ? $4 : NaN):(100*($5-0.5)) with points ls {i + 1} ps 0.5 title 'H = {depth} m'",
                    $"'{file}' using ($1=={depth} && $2==1 && $3==2 ? $4 : NaN):(100*($6-0.5)) with lines ls {i + 1} notitle",
                });
            page.Plot("experiment-sloshing", "The centre of mass of sloshing water over time at three depths, with the fitted cosines", "set xlabel 't, s'\nset ylabel 'centre of mass from the middle, cm'\nplot " + string.Join(", \\\n", lines));
        }
    }
}
