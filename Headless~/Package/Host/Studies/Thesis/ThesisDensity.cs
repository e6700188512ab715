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
                        ExperimentFigures.Input(new SweepSetting(false, 1, k, relaxation).Settings), run.Quick ? 1.5 : 6, 10)));
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

            page.Plot("thesis-density", "C+ while the water moves and jitter, against iterations, a line for each relaxation",
                "set multiplot layout 1,2\n" + Panel(series, "C+, 0.2 to 2 s (%)", row => row.Number("error_moving") * 100, "set key off")
                    + Panel(series, "jitter (m/s)", row => row.Number("jitter"), "set key inside bottom right") + "unset multiplot\n", 1200,
                    440);

            page.Line(FormattableString.Invariant(
                $"{first.Number("particles"):N0} particles, {first.Number("seconds"):0.#} s. C+ ({"mean of max(0, ρ/ρ0 − 1)"}: how far the ") +
                "water is denser than at rest) over 0.2 to 2 s, and jitter over the last 2 s, m/s:");
            page.Line();
            double[] shown = { series[0].Relaxation, series[series.Count / 2].Relaxation, series[^1].Relaxation };
            var columns = series.Where(s => shown.Contains(s.Relaxation)).ToList();
            page.Table(new[] { "iterations" }.Concat(columns.Select(s => FormattableString.Invariant($"C+ at ω {s.Relaxation}")))
                .Concat(columns.Select(s => FormattableString.Invariant($"jitter at ω {s.Relaxation}"))),
                columns[0].Rows.Select((row, i) =>
                    new[] { row["iterations"] }.Concat(
                    columns.Select(s => FormattableString.Invariant($"{s.Rows[i].Number("error_moving") * 100:0.00} %")))
                    .Concat(columns.Select(s => FormattableString.Invariant($"{s.Rows[i].Number("jitter"):0.000}")))));
            Judge(page, series);
        }

        static void Judge(ReportPage page, List<(double Relaxation, ReportTable.Row[] Rows)> series)
        {
            double[][] errors = series.Select(s => s.Rows.Select(row => row.Number("error_moving")).ToArray()).ToArray();
            (int falls, int pairs) byIterations = Falls(errors);
            (int falls, int pairs) byRelaxation =
                Falls(Enumerable.Range(0, errors[0].Length).Select(k => errors.Select(line => line[k]).ToArray()).ToArray());
            double slow = Rate(series[0].Rows), fast = Rate(series[^1].Rows);
            bool same = Math.Abs(fast / slow - 1) <= SameRate;
            page.Line("The thesis found that density falls towards that at rest both with iterations and with ω, and that ω makes it " +
                "converge no faster.");
            page.Line();
            page.Line(FormattableString.Invariant(
                $"- With iterations: C+ falls in {byIterations.falls} of {byIterations.pairs} steps from one count to the next. ") +
                FormattableString.Invariant($"{Agreement(byIterations)}"));
            page.Line(FormattableString.Invariant(
                $"- With ω: C+ falls in {byRelaxation.falls} of {byRelaxation.pairs} steps from one ω to the next. {Agreement(byRelaxation)}"));
            page.Line(FormattableString.Invariant(
                $"- Convergence: C+ falls as the iterations to the power {slow:0.00} at ω {series[0].Relaxation} and {fast:0.00} at ω ") +
                FormattableString.Invariant($"{series[^1].Relaxation} (fit over all counts). ") +
                FormattableString.Invariant($"{(same ? "Agrees: ω lowers the curve and does not make it steeper." : fast < slow ? "Does not agree: here the curve of the larger ω is steeper." : "Agrees, and more: the curve of the larger ω is flatter.")}"));
            page.Line(FormattableString.Invariant(
                $"- What the thesis did not show: at {series[0].Rows[^1]["iterations"]} iterations jitter is ") +
                FormattableString.Invariant($"{series[0].Rows[^1].Number("jitter"):0.000} m/s at ω {series[0].Relaxation} and ") +
                FormattableString.Invariant($"{series[^1].Rows[^1].Number("jitter"):0.000} at ω {series[^1].Relaxation}; ") +
                FormattableString.Invariant($"{series.Sum(s => s.Rows.Count(row => row.Number("energy") > SweepResult.MaxEnergy))} of {series.Sum(s => s.Rows.Length)} ") +
                FormattableString.Invariant($"runs gained energy (above {SweepResult.MaxEnergy} of the start's), and ") +
                FormattableString.Invariant($"{series.Sum(s => s.Rows.Count(row => row.Number("volume_lowest") < SweepResult.MinVolume))} were compressed below ") +
                FormattableString.Invariant($"{SweepResult.MinVolume} of their volume at some time."));
            page.Line();
        }

        static string Agreement((int falls, int pairs) count) => count.falls == count.pairs ? "Agrees." : count.falls >= 0.9 * count.pairs
            ? "Agrees but for those." : count.falls > 0.5 * count.pairs ? "Agrees in part." : "Does not agree.";

        static (int falls, int pairs) Falls(double[][] lines)
            => (lines.Sum(line => line.Skip(1).Zip(line, (next, before) => next < before ? 1 : 0).Sum()),
            lines.Sum(line => line.Length - 1));

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
            var plot = new PlotData();
            for (int i = 0; i < series.Count; i++)
                plot.Add(FormattableString.Invariant($"using 1:2 with linespoints ls {i + 1} title 'ω {series[i].Relaxation}'"),
                    series[i].Rows.Select(row => new object[] { row.Number("iterations"), value(row) }));
            return plot.Script(LogAxis.Script("x", series.SelectMany(s => s.Rows).Select(row => row.Number("iterations")))
                + LogAxis.Script("y", series.SelectMany(s => s.Rows).Select(value))
                + $"set xlabel 'iterations'\nset ylabel '{label}'\nset format '%g'\n{key}\n");
        }
    }
}
