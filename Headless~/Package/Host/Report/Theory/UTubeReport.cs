using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report
{
    /// <summary>The report's U-tube: period and decay of water that swings in it, for numerical dampings, substeps and spacings.</summary>
    static class UTubeReport
    {
        const string Periods = "damping-utube", Curves = "damping-utube-curves";
        const double Bar = 0.03;        // of the period
        const double Width = 0.3, Gap = 0.6, Depth = 1.2, Height = 0.1;      // m

        static readonly (int Across, float Damping, int Substeps)[] Quick = { (8, 1f, 1), (8, 0f, 1) };

        public static void Measure(ReportRun run)
        {
            var periods = new ReportTable("across", "damping", "substeps", "period_s", "theory_s", "middle_line_s", "damping_per_s",
                "first_order_per_s", "offset_d", "misfit");
            var curves = new ReportTable("across", "damping", "substeps", "time_s", "level_m", "fit_m");
            double swings = run.Quick ? 1.6 : 3;
            foreach ((int across, float damping, int substeps) in run.Quick ? Quick : Full())
            {
                float spacing = (float)(Width / across);
                int gap = Whole(Gap, spacing), depth = Whole(Depth, spacing), height = Whole(Height, spacing);
                double theory = UTube.Period(UTube.StraightLength(across, gap, depth) * spacing),
                    middleLine = UTube.Period(UTube.MiddleLine(across, gap, depth) * spacing);
                StepInput input = FluidRun.Water(substeps, 2);
                input.settings.numericalDamping = damping;
                List<(double Time, double Value)> samples = UTube.Run(across, gap, depth, height, spacing, input, swings * theory);
                DampedCosine fit = DampedCosine.Fit(samples);
                double firstOrder = FluidRun.FirstOrderDamping(theory, input);
                periods.Add(across, damping, substeps, fit.Period, theory, middleLine, fit.Damping, firstOrder, fit.Offset, fit.Misfit);
                foreach ((double time, double level) in samples)
                    curves.Add(across, damping, substeps, time, level * spacing, fit.At(time) * spacing);
                run.Log($"  U-tube {across} d wide, damping {damping}, {substeps} x 2: {fit.Period:0.000} s, theory {theory:0.000}, " +
                    $"damping {fit.Damping:0.000}/s");
            }
            string settled = System.FormattableString.Invariant(
                $"legs and passage {Width} m wide and {UTube.Thickness} d thick, {Gap} m between the legs, {Depth} m of water in each, let go ") +
                System.FormattableString.Invariant($"{Height} m above and below that; 60 steps a second, 2 iterations, deep water on, {swings} periods");
            run.Save(Periods, periods, settled);
            run.Save(Curves, curves, settled);
        }

        static int Whole(double length, double spacing) => (int)System.Math.Round(length / spacing);

        static IEnumerable<(int, float, int)> Full()
        {
            foreach (int across in new[] { 12, 24 })
                foreach (int substeps in new[] { 1, 2 })
                    foreach (float damping in new[] { 1f, 0.33f, 0f })
                        yield return (across, damping, substeps);
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Periods);
            page.Heading("U-tube");
            page.Line("Two legs and a passage below, all of one width w, around a box that stands off the floor. The water is let go " +
                "with its levels apart and swings. Level: from the center of mass, which moves as water changes legs. Period and " +
                "damping: of a damped cosine fitted to it. Theory: T = 2π √(L / 2g), L the length along the center line less 0.44 w a " +
                "bend. A bend's square counts 1 − 2 ln 2 / π = 0.559 " +
                "squares (a potential flow; the same number is the resistance of a bent conducting sheet, Hall 1967). First order: " +
                "what a first-order step alone takes, ω² Δt / 2. Water loses more, as a flow around a sharp edge comes off it.");
            page.Line();
            List<ReportTable.Row> all = table.Rows.ToList();
            page.Table(new[] { "width, d", "numerical damping", "substeps", "period, s", "theory, s", "error", Verdict.Column(Bar),
                "center line alone",
                "damping, 1/s", "first order, 1/s", "swings about, d", "misfit of the cosine" }, table.Rows.Select(row => new[]
            {
                row["across"], row["damping"], row["substeps"], Figures.Fixed(row.Number("period_s"), 3),
                    Figures.Fixed(row.Number("theory_s"), 3), Figures.Percent(row.Number("period_s") / row.Number("theory_s") - 1),
                    Verdict.Within(row.Number("period_s") / row.Number("theory_s") - 1, Bar),
                    Figures.Percent(row.Number("period_s") / row.Number("middle_line_s") - 1),
                Figures.Fixed(row.Number("damping_per_s"), 3), Figures.Fixed(row.Number("first_order_per_s"), 3),
                    Figures.Fixed(row.Number("offset_d"), 2), Figures.Percent(row.Number("misfit")),
            }), i => all[i]["substeps"] == "1");
            page.Line($"({table.Settings}.)");
            page.Line();
            string file = page.DataFile(Curves), finest = table.Rows.Last()["across"];
            IEnumerable<string> lines = table.Rows.Where(row => row["across"] == finest && row["substeps"] == "1").SelectMany((row, i) =>
            {
                string chosen = $"$1=={finest} && $2=={row["damping"]} && $3==1";
                return new[]
                {
                    $"'{file}' using ({chosen} ? $4 : NaN):(100*$5) with points ls {i + 1} ps 0.5 title 'numerical damping " +
                        $"{row["damping"]}{(row.Number("damping") == SolverSettings.Default.numericalDamping ? ", the default" : "")}'",
                    $"'{file}' using ({chosen} ? $4 : NaN):(100*$6) with lines ls {i + 1} notitle",
                };
            });
            ReportTable.Row theory = table.Rows.Last();
            string swing = System.FormattableString.Invariant($"{-100 * Height:0.##}*cos(2*pi*x/{theory.Number("theory_s")})");
            lines = lines.Append("NaN with lines lc rgb '#606060' title 'lines: fits'")
                .Append(swing + " with lines lc rgb 'black' dt 2 lw 1.2 title 'theory, without damping'");
            page.Plot("damping-utube", "The level in a leg of a U-tube over time for three numerical dampings, with fits and theory",
                "set samples 400\nset xlabel 't, s'\nset ylabel 'level above rest, cm'\nplot " + string.Join(", \\\n", lines));
        }
    }
}
