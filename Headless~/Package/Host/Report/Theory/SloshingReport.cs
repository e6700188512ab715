using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report
{
    /// <summary>The report's sloshing: periods at three depths against linear theory, and the curves they come from.</summary>
    static class SloshingReport
    {
        const string Periods = "experiment-sloshing", Curves = "experiment-sloshing-curves";
        const double Bar = 0.03;        // of the period
        const double MaxPeriod = 4;     // of the theory's: as long as is played
        // Linear theory is for low waves; at a lean of 0.03 and a depth of 0.15 m the next order shortens the period by 0.4 %, elsewhere
        // and at the others by less.
        static readonly (int Along, double Depth, double Lean, int Substeps, int Iterations)[] Quick =
        {
            (32, 0.15, 0.03, 1, 2), (32, 0.35, 0.03, 1, 2), (32, 0.35, 0.1, 1, 2), (32, 0.7, 0.1, 1, 2),
        };

        public static void Measure(ReportRun run)
        {
            var periods = new ReportTable("along", "depth_m", "layers", "lean_rad", "substeps", "iterations", "period_s", "theory_s",
                "error", "offset_ratio", "damping_per_period", "misfit");
            var curves = new ReportTable("along", "depth_m", "lean_rad", "substeps", "iterations", "time_s", "x_m", "fit_m");
            double swings = run.Quick ? 1.6 : MaxPeriod;
            foreach ((int along, double wanted, double lean, int substeps, int iterations) in run.Quick ? Quick : Full())
            {
                double depth = Sloshing.NearestDepth(along, wanted), theory = Sloshing.Period(depth);
                List<(double Time, double Value)> samples = Sloshing.Run(along, depth, lean, FluidRun.Water(substeps, iterations), swings * theory);
                DampedCosine fit = DampedCosine.Fit(samples);
                periods.Add(along, depth, depth * along, lean, substeps, iterations, fit.Period, theory, fit.Period / theory - 1,
                    (fit.Offset - Sloshing.Center) / Sloshing.Offset(depth, lean), fit.Damping * fit.Period, fit.Misfit);
                foreach ((double time, double value) in samples)
                    curves.Add(along, depth, lean, substeps, iterations, time, value, fit.At(time));
                run.Log($"  sloshing {depth:0.000} m, L/d {along}, lean {lean}, {substeps} x {iterations}: {fit.Period:0.000} s, " +
                    $"theory {theory:0.000}");
            }
            string settled = $"box 1 m long and 8 d thick, 60 steps a second, {swings} periods";
            run.Save(Periods, periods, settled);
            run.Save(Curves, curves, settled);
        }

        static IEnumerable<(int, double, double, int, int)> Full()
        {
            foreach (double depth in new[] { 0.15, 0.35, 0.7 })
                foreach (int along in new[] { 40, 80, 160 })
                    yield return (along, depth, 0.03, 1, 2);
            foreach (double lean in new[] { 0.015, 0.1 })
                yield return (80, 0.35, lean, 1, 2);
            foreach ((int substeps, int iterations) in new[] { (1, 4), (2, 2), (4, 2) })
                yield return (80, 0.35, 0.03, substeps, iterations);
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Periods);
            page.Heading("Sloshing");
            page.Line("Level water in a box is let go under gravity that leans a little: it swings in its first mode about the surface " +
                "that is level to that gravity. The period is that of a damped cosine fitted to the center of mass along the box; " +
                "theory: ω² = g k tanh(k H), k = π/L. Wave: amplitude at the wall in particle spacings. Offset: where the fitted " +
                "cosine swings about, over where the center of mass lies under a level surface (1 where the pressure answers to the " +
                "surface as it should). Damping: of the amplitude a period, as −ln. Water that creeps to its level " +
                "has no period (–).");
            page.Line();
            List<ReportTable.Row> all = table.Rows.ToList();
            string lean = all[0]["lean_rad"];
            page.Table(new[] { "depth H, m", "L/d", "layers", "wave, d", "substeps x iterations", "period, s", "theory, s", "error",
                Verdict.Column(Bar), "offset", "damping a period", "misfit of the cosine" },
                table.Rows.Select(row => new[]
                {
                    Figures.Fixed(row.Number("depth_m"), 3), row["along"], row["layers"],
                        Figures.Fixed(Sloshing.Wave(row.Number("lean_rad")) * row.Number("along"), 1),
                        $"{row["substeps"]} x {row["iterations"]}",
                    IfSwings(row, Figures.Fixed(row.Number("period_s"), 3)), Figures.Fixed(row.Number("theory_s"), 3),
                        IfSwings(row, Figures.Percent(row.Number("error"))), IfSwings(row, Verdict.Within(row.Number("error"), Bar)),
                        Figures.Fixed(row.Number("offset_ratio"), 2),
                        IfSwings(row, Figures.Fixed(row.Number("damping_per_period"), 2)), Figures.Percent(row.Number("misfit")),
                }), i => all[i]["substeps"] == "1" && all[i]["iterations"] == "2" && all[i]["lean_rad"] == lean);
            page.Line($"({table.Settings}.)");
            page.Line();
            string file = page.DataFile(Curves);
            List<ReportTable.Row> drawn = Drawn(table).ToList();
            IEnumerable<string> lines = drawn.SelectMany((row, i) =>
            {
                string chosen = $"$1=={row["along"]} && $2=={row["depth_m"]} && $3=={row["lean_rad"]} && $4==1 && $5==2";
                return new[]
                {
                    $"'{file}' using ({chosen} ? $6 : NaN):(100*($7-0.5)) with points ls {i + 1} ps 0.5 title 'H = " +
                        $"{Figures.Fixed(row.Number("depth_m"), 2)} m, L/d = {row["along"]}'",
                    $"'{file}' using ({chosen} ? $6 : NaN):(100*($8-0.5)) with lines ls {i + 1} notitle",
                };
            }).Append("NaN with lines lc rgb '#606060' title 'lines: fits'")
                .Concat(drawn.GroupBy(row => row["depth_m"]).Select((depth, i) => Theory(depth.First(), i == 0)));
            page.Plot("experiment-sloshing", "The center of mass of sloshing water over time at three depths, coarsest and finest, " +
                "with fits and theory",
                "set samples 400\nset yrange [0:*]\nset xlabel 't, s'\nset ylabel 'center of mass from the center, cm'\nplot " +
                    string.Join(", \\\n", lines), 1100, 520);
        }

        // From rest about the level surface, for as long as is played.
        static string Theory(ReportTable.Row row, bool isNamed)
        {
            double period = row.Number("theory_s"), offset = 100 * Sloshing.Offset(row.Number("depth_m"), row.Number("lean_rad"));
            return System.FormattableString.Invariant($"[0:{MaxPeriod * period:0.###}] {offset:0.####}*(1-cos(2*pi*x/{period})) ") +
                "with lines lc rgb 'black' dt 2 lw 0.8 " + (isNamed ? "title 'theory, without damping'" : "notitle");
        }

        // A fitted period that is longer than the run is not a period.
        static string IfSwings(ReportTable.Row row, string text) => row.Number("period_s") < MaxPeriod * row.Number("theory_s") ? text : "–";

        // The finest and the coarsest of each depth: the coarsest misses the theory most.
        static IEnumerable<ReportTable.Row> Drawn(ReportTable table)
        {
            string lean = table.Rows.First()["lean_rad"];
            return table.Rows.Where(row => row["substeps"] == "1" && row["iterations"] == "2" && row["lean_rad"] == lean)
                .GroupBy(row => System.Math.Round(row.Number("depth_m"), 1)).Select(depth => depth.OrderBy(row => row.Number("along")).ToList())
                .SelectMany(depth => new[] { depth[^1], depth[0] }.Take(depth.Count));
        }
    }
}
