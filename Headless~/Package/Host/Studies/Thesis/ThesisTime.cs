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
                    ExperimentFigures.Input(new SweepSetting(false, 1, Iterations, relaxation).Settings), run.Quick ? 3 : 10, 6);
                double start = experiment.Samples[0].Energy;
                foreach (FluidStatistics sample in experiment.Samples)
                    table.Add(experiment.Scene.Particles, Iterations, relaxation, experiment.Time(sample), sample.densityError,
                        sample.volumeRatio, sample.Energy / start);
            }
            run.Save(TableName, table, "plain iterations, relaxation not clamped to what is stable");
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
                plot.Add(FormattableString.Invariant($"using 1:2 with lines ls {i + 1} title 'ω {series[i].Relaxation}'"),
                    series[i].Rows.Select(row => new object[] { row.Number("time_s"), row.Number("error") * 100 }));
            page.Plot("thesis-time", "C+ over time, a line for each relaxation",
                plot.Script("set xlabel 'time (s)'\nset ylabel 'C+ (%)'\nset yrange [0:*]\n"));

            page.Line(FormattableString.Invariant($"{first.Number("particles"):N0} particles, {Iterations} iterations, {end:0.#} s:"));
            page.Line();
            page.Table(new[] { "ω", "C+, second half", "its spread", "highest C+", "highest energy / start's" }, series.Select(s =>
            {
                double[] late = s.Rows.Where(row => row.Number("time_s") > end / 2).Select(row => row.Number("error")).ToArray();
                double mean = late.Average();
                return new[] { FormattableString.Invariant($"{s.Relaxation}"), FormattableString.Invariant($"{mean * 100:0.00} %"),
                    FormattableString.Invariant($"± {Math.Sqrt(late.Average(e => (e - mean) * (e - mean))) * 100:0.00} %"),
                    FormattableString.Invariant($"{s.Rows.Max(row => row.Number("error")) * 100:0.00} %"),
                    FormattableString.Invariant($"{s.Rows.Max(row => row.Number("energy")):0.000}") };
            }));
            double[] means = series.Select(s => s.Rows.Where(row => row.Number("time_s") > end / 2).Average(row => row.Number("error"))).ToArray();
            bool falls = means.Zip(means.Skip(1), (before, next) => next < before).All(fell => fell);
            page.Line("That density falls towards that at rest with ω, the thesis's finding, is held against the second half of each run. "
                + (falls ? "It agrees: each larger ω leaves less."
                : FormattableString.Invariant(
                $"It does not agree throughout: the least is left by ω {series[Array.IndexOf(means, means.Min())].Relaxation}.")));
            page.Line();
        }
    }
}
