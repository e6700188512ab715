using System;
using System.Linq;
using Host.Experiments;
using Host.Report;
using Host.Report.ErrorTime;
using Rill;

namespace Host.Studies.Thesis
{
    /// <summary>Figure 5.4: density over ten seconds.</summary>
    sealed class ThesisTime : ThesisFigure
    {
        const string TableName = "thesis-time";
        const int Iterations = 3;

        public override string Title => "Density over time (figure 5.4)";

        public override void Measure(ReportRun run)
        {
            var table = new ReportTable("particles", "iterations", "relaxation", "time_s", "error", "volume", "energy");
            foreach (float relaxation in run.Quick ? new[] { 1f, 1.5f } : new[] { 1f, 1.1f, 1.2f, 1.3f, 1.4f, 1.5f })
            {
                Experiment experiment = Experiment.Run(Dam(run),
                    ExperimentFigures.Input(new SweepSetting(false, Substeps, Iterations, relaxation).Settings), run.Quick ? 3 : 10, 6);
                double start = experiment.Samples[0].Energy;
                foreach (FluidStatistics sample in experiment.Samples)
                    table.Add(experiment.Scene.Particles, Iterations, relaxation, experiment.Time(sample), sample.densityError,
                        sample.volumeRatio, sample.Energy / start);
            }
            run.Save(TableName, table, $"plain iterations, {Substeps} substeps, relaxation not clamped to what is stable");
        }

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(TableName);
            ReportTable.Row first = table.Rows.First();
            var series = table.Rows.GroupBy(row => row.Number("relaxation")).OrderBy(group => group.Key)
                .Select(group => (Relaxation: group.Key, Rows: group.ToArray())).ToList();
            double end = series[0].Rows[^1].Number("time_s");

            var plot = new PlotData();
            for (int i = 0; i < series.Count; i++)
                plot.Add(FormattableString.Invariant($"using 1:2 with lines ls {i + 1}{(KeptEnergy(series[i].Rows) ? "" : " lw 0.8")} title ") +
                    FormattableString.Invariant($"'ω {series[i].Relaxation}{(KeptEnergy(series[i].Rows) ? "" : ", " + Verdict.NotComparable)}'"),
                    series[i].Rows.Where(row => row.Number("error") > 0).Select(row => new object[] { row.Number("time_s"),
                        row.Number("error") * 100 }));
            page.Plot("thesis-time", "C+ over time on a logarithmic axis, a line for each relaxation",
                plot.Script(LogAxis.Script("y", table.Rows.Select(row => row.Number("error") * 100)) +
                    "set xlabel 'time (s)'\nset ylabel 'C+ (%)'\nset format y '%g'\n"));

            page.Line(FormattableString.Invariant($"{first.Number("particles"):N0} particles, {Iterations} iterations, {end:0.#} s ") +
                FormattableString.Invariant($"({table.Settings}):"));
            page.Line();
            page.Table(new[] { "ω", "C+, second half", "its spread", "highest C+", "highest energy / start's", "the thesis's water" },
                series.Select(s =>
            {
                double[] late = s.Rows.Where(row => row.Number("time_s") > end / 2).Select(row => row.Number("error")).ToArray();
                double mean = late.Average();
                return new[] { FormattableString.Invariant($"{s.Relaxation}"), $"{Figures.Three(mean * 100)} %",
                    $"± {Figures.Three(Math.Sqrt(late.Average(e => (e - mean) * (e - mean))) * 100)} %",
                    $"{Figures.Three(s.Rows.Max(row => row.Number("error")) * 100)} %",
                    FormattableString.Invariant($"{s.Rows.Max(row => row.Number("energy")):0.000}"), KeptEnergy(s.Rows) ? "comparable"
                        : Verdict.NotComparable };
            }));
            ListFailures(page, series.Select(s => KeptEnergy(s.Rows)));
            var kept = series.Where(s => KeptEnergy(s.Rows)).ToList();
            page.Line("That density falls towards that at rest with ω, the thesis's finding, is held against the second half of each run. "
                + Agreement(kept.Select(s => (s.Relaxation, s.Rows.Where(row => row.Number("time_s") > end / 2).Average(row => row.Number("error"))))
                .ToArray()));
            page.Line();
        }

        static bool KeptEnergy(ReportTable.Row[] run) => run.All(IsComparable);

        static string Agreement((double Relaxation, double Error)[] runs)
        {
            if (runs.Length < 2)
                return FormattableString.Invariant($"It is {Verdict.NotComparable}: {runs.Length} of the runs kept their energy within ") +
                    FormattableString.Invariant($"{MaxEnergy} of the start's.");
            return runs.Zip(runs.Skip(1), (before, next) => next.Error < before.Error).All(fell => fell) ? "It agrees: each larger ω leaves less."
                : FormattableString.Invariant($"It does not agree throughout: the least is left by ω {runs.MinBy(run => run.Error).Relaxation}.");
        }
    }
}
