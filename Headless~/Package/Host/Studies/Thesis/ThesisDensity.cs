using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Host.Report;
using Host.Report.ErrorTime;

namespace Host.Studies.Thesis
{
    /// <summary>Figures 5.3, 5.5 and 5.6: density against iterations and relaxation.</summary>
    sealed class ThesisDensity : ThesisFigure
    {
        const string TableName = "thesis-density";
        // Rates that differ by less count as the same.
        const double SameRate = 0.15;
        const int MinPointsToFit = 3;

        public override string Title => "Density against iterations and relaxation (figures 5.3, 5.5, 5.6)";

        public override void Measure(ReportRun run)
        {
            int[] iterations = run.Quick ? new[] { 1, 3, 8, 20 } : new[] { 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20 };
            float[] relaxations = run.Quick ? new[] { 1f, 1.5f } : new[] { 1f, 1.1f, 1.2f, 1.3f, 1.4f, 1.5f };
            ExperimentScene scene = run.Quick ? ExperimentScene.Dam(1_000) : Dam(run);
            var table = new ReportTable(ExperimentFigures.Columns);
            foreach (int k in iterations)
            {
                foreach (float relaxation in relaxations)
                    table.Add(ExperimentFigures.Of(Experiment.Run(scene,
                        ExperimentFigures.Input(new SweepSetting(false, Substeps, k, relaxation).Settings), run.Quick ? 1.5 : 6, 10)));
                run.Log($"{k} iterations");
            }
            run.Save(TableName, table, "plain iterations, relaxation not clamped to what is stable");
        }

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(TableName);
            ReportTable.Row first = table.Rows.First();
            var series = table.Rows.GroupBy(row => row.Number("relaxation")).OrderBy(group => group.Key)
                .Select(group => (Relaxation: group.Key, Rows: group.OrderBy(row => row.Number("iterations")).ToArray())).ToList();

            page.Plot("thesis-density", "C+ while the water moves and jitter, against iterations, a line for each relaxation; runs " +
                "that gained energy are crosses",
                "set multiplot layout 1,2\n" + Panel(series, "C+, 0.2 to 2 s (%)", row => row.Number("error_moving") * 100, "set key off")
                    + Panel(series, "jitter (m/s)", row => row.Number("jitter"), "set key inside bottom right") + "unset multiplot\n", 1200, 440);

            string substeps = first["substeps"] + (first["substeps"] == "1" ? " substep" : " substeps");
            page.Line(FormattableString.Invariant($"{first.Number("particles"):N0} particles, {first.Number("layers")} layers, {substeps}, ") +
                FormattableString.Invariant($"{first.Number("seconds"):0.#} s. C+ (mean of max(0, ρ/ρ0 − 1): how far the water is denser ") +
                $"than at rest) over 0.2 to 2 s, and jitter over the last 2 s, m/s. A run whose energy rises above {Text(MaxEnergy)} of the " +
                $"start's is *{Verdict.NotComparable}* (crosses in the plot):");
            page.Line();
            double[] shown = { series[0].Relaxation, series[^1].Relaxation };
            var columns = series.Where(s => shown.Contains(s.Relaxation)).ToList();
            page.Table(new[] { "iterations" }.Concat(columns.Select(s => $"C+ at ω {Text(s.Relaxation)}"))
                .Concat(columns.Select(s => $"jitter at ω {Text(s.Relaxation)}")),
                columns[0].Rows.Select((row, i) => new[] { row["iterations"] }
                    .Concat(columns.Select(s => $"{Figures.Three(s.Rows[i].Number("error_moving") * 100)} %" +
                        (IsComparable(s.Rows[i]) ? "" : $", {Verdict.NotComparable}")))
                    .Concat(columns.Select(s => Figures.Three(s.Rows[i].Number("jitter"))))));
            Judge(page, series);
        }

        static string Text(double value) => value.ToString(System.Globalization.CultureInfo.InvariantCulture);

        static void Judge(ReportPage page, List<(double Relaxation, ReportTable.Row[] Rows)> series)
        {
            ReportTable.Row[][] byIterations = series.Select(s => s.Rows).ToArray();
            ReportTable.Row[][] byRelaxation = Enumerable.Range(0, byIterations[0].Length)
                .Select(k => byIterations.Select(line => line[k]).ToArray()).ToArray();
            List<ReportTable.Row> all = byIterations.SelectMany(rows => rows).ToList();
            page.Line("The thesis found that density falls towards that at rest both with iterations and with ω, and that ω makes it " +
                "converge no faster.");
            page.Line();
            ListFailures(page, all.Select(IsComparable));
            page.Line($"- {all.Count(row => !IsComparable(row))} of {all.Count} runs gained energy and take no part in the verdicts.");
            page.Line($"- With iterations: {Agreement(Falls(byIterations), "count")}");
            page.Line($"- With ω: {Agreement(Falls(byRelaxation), "ω")}");
            page.Line($"- Convergence: {Convergence(series)}");
            page.Line($"- What the thesis did not show: at {series[0].Rows[^1]["iterations"]} iterations jitter is " +
                $"{Figures.Three(series[0].Rows[^1].Number("jitter"))} m/s at ω {Text(series[0].Relaxation)} and " +
                $"{Figures.Three(series[^1].Rows[^1].Number("jitter"))} at ω {Text(series[^1].Relaxation)}; " +
                $"{all.Count(row => row.Number("volume_lowest") < SweepResult.MinVolume)} runs were compressed below " +
                $"{Text(SweepResult.MinVolume)} of their volume at some time.");
            page.Line();
        }

        static string Agreement((int falls, int pairs) count, string what) => count.pairs == 0
            ? $"{Verdict.NotComparable}, as no two runs that follow each other kept their energy."
            : $"C+ falls in {count.falls} of {count.pairs} steps from one {what} to the next. " + (count.falls == count.pairs ? "Agrees."
                : count.falls >= 0.9 * count.pairs ? "Agrees but for those." : count.falls > 0.5 * count.pairs ? "Agrees in part."
                    : "Does not agree.");

        static string Convergence(List<(double Relaxation, ReportTable.Row[] Rows)> series)
        {
            var fitted = series.Select(s => (s.Relaxation, Rows: s.Rows.Where(IsComparable).ToArray())).Where(s
                => s.Rows.Length >= MinPointsToFit).ToList();
            if (fitted.Count < 2)
                return $"{Verdict.NotComparable}, as a rate needs {MinPointsToFit} runs of a ω that kept their energy, for two ω.";
            double slow = Rate(fitted[0].Rows), fast = Rate(fitted[^1].Rows);
            return FormattableString.Invariant($"C+ falls as the iterations to the power {slow:0.00} at ω {fitted[0].Relaxation} and ") +
                FormattableString.Invariant($"{fast:0.00} at ω ") +
                $"{Text(fitted[^1].Relaxation)} (fits). " + (Math.Abs(fast / slow - 1) <= SameRate
                    ? "Agrees: ω lowers the curve and does not make it steeper."
                : fast < slow ? "Does not agree: here the curve of the larger ω is steeper."
                    : "Agrees, and more: the curve of the larger ω is flatter.");
        }

        static (int falls, int pairs) Falls(ReportTable.Row[][] lines)
        {
            bool[] falls = lines.SelectMany(line => line.Skip(1).Zip(line, (next, before) => (next, before)))
                .Where(pair => IsComparable(pair.next) && IsComparable(pair.before))
                .Select(pair => pair.next.Number("error_moving") < pair.before.Number("error_moving")).ToArray();
            return (falls.Count(fell => fell), falls.Length);
        }

        // Slope of log C+ over log iterations, by least squares.
        static double Rate(ReportTable.Row[] rows)
        {
            double[] x = rows.Select(row => Math.Log(row.Number("iterations"))).ToArray(),
                y = rows.Select(row => Math.Log(row.Number("error_moving"))).ToArray();
            double meanX = x.Average(), meanY = y.Average();
            return x.Zip(y, (a, b) => (a - meanX) * (b - meanY)).Sum() / x.Sum(a => (a - meanX) * (a - meanX));
        }

        static string Panel(List<(double Relaxation, ReportTable.Row[] Rows)> series, string label, Func<ReportTable.Row, double> value, string key)
        {
            object[] Point(ReportTable.Row row) => new object[] { row.Number("iterations"), value(row) };
            var plot = new PlotData();
            for (int i = 0; i < series.Count; i++)
                plot.Add($"using 1:2 with lines ls {i + 1} title 'ω {Text(series[i].Relaxation)}'", series[i].Rows.Select(Point))
                    .Add($"using 1:2 with points ls {i + 1} notitle", series[i].Rows.Where(IsComparable).Select(Point));
            plot.Add($"using 1:2 with points pt 2 lc rgb '#808080' title '{Verdict.NotComparable}'",
                series.SelectMany(s => s.Rows).Where(row => !IsComparable(row)).Select(Point));
            return plot.Script(LogAxis.Script("x", series.SelectMany(s => s.Rows).Select(row => row.Number("iterations")))
                + LogAxis.Script("y", series.SelectMany(s => s.Rows).Select(value))
                + $"set xlabel 'iterations'\nset ylabel '{label}'\nset format '%g'\n{key}\n");
        }
    }
}
