using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Host.Report;
using Host.Report.ErrorTime;

namespace Host.Studies.Thesis
{
    /// <summary>Figure 5.1: the fraction of each kernel in a step.</summary>
    sealed class ThesisKernels : ThesisFigure
    {
        const string TableName = "thesis-kernels";
        const int Iterations = 5;

        // Per cent, at 100,000 particles and 5 iterations.
        static readonly (string Kernel, double Percent)[] Thesis = { ("λ", 44.7), ("neighbor search", 24.1), ("Δp", 17.2), ("velocity", 11.0),
            ("rest", 3.0) };

        public override string Title => "Fraction of each kernel (figure 5.1)";

        public override void Measure(ReportRun run)
        {
            var table = new ReportTable("window", "particles", "iterations", "stage", "ms");
            Experiment experiment = Experiment.Run(Dam(run), ExperimentFigures.Input(new SweepSetting(false, 1, Iterations).Settings), 1, 1000);
            foreach (string window in new[] { "initial", "moving" })
                foreach ((string stage, List<double> steps) in experiment.Times[window])
                    // medians of parts would not add up to the whole's
                    table.Add(window, experiment.Scene.Particles, Iterations, stage, steps.Average());
            run.Save(TableName, table, "plain iterations, relaxation 0.8, means of the windows' steps: initial 3-10, moving 20-60");
        }

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(TableName);
            ReportTable.Row first = table.Rows.First();
            string[] windows = table.Rows.Select(row => row["window"]).Distinct().ToArray();
            Dictionary<string, double[]> fractions = windows.ToDictionary(window => window,
                window => Fractions(table.Rows.Where(row => row["window"] == window)));

            var plot = new PlotData().Add("using 2:xtic(1) title 'thesis' ls 5",
                Thesis.Select(kernel => new object[] { kernel.Kernel, kernel.Percent }));
            for (int i = 0; i < windows.Length; i++)
                plot.Add($"using 2:xtic(1) title 'here, {windows[i]}' ls {i + 1}",
                    Thesis.Select((kernel, k) => new object[] { kernel.Kernel, fractions[windows[i]][k] }));
            page.Plot("thesis-kernels", "Fraction of each kernel in a step: the thesis's and this solver's",
                plot.Script("set style data histograms\nset style fill solid 0.85\nset boxwidth 0.9\nset ylabel 'fraction of the step " +
                "(%)'\nset yrange [0:*]\n"));

            page.Line(FormattableString.Invariant(
                $"{first.Number("particles"):N0} particles, {Iterations} iterations, per cent of a ") +
                FormattableString.Invariant($"step{(table.InSoftware ? " (of a CPU: no kernel's fraction on a GPU follows)" : "")}:"));
            page.Line();
            page.Table(new[] { "" }.Concat(Thesis.Select(kernel => kernel.Kernel)).Append("step, ms"),
                windows.Select(window => fractions[window].Select(fraction => FormattableString.Invariant($"{fraction:0.0}"))
                    .Prepend("here, " + window).Append(FormattableString.Invariant($"{Milliseconds(table, window):0.000}")))
                    .Prepend(Thesis.Select(kernel => FormattableString.Invariant($"{kernel.Percent:0.0}")).Prepend("thesis").Append("")));
            page.Line("The first λ is solved in the pass that builds the neighbor list; here it is taken to cost what each later λ " +
                "costs and counted there, the rest of that pass as neighbor search. XSPH is part of velocity.");
            page.Line();
            string slowest = Thesis[Array.IndexOf(fractions["initial"], fractions["initial"].Max())].Kernel;
            page.Line(FormattableString.Invariant(
                $"In the thesis {Thesis[0].Kernel} is the most expensive part, at {Thesis[0].Percent} %. Here it is {slowest}, at ") +
                FormattableString.Invariant($"{fractions["initial"].Max():0.0} % of the initial block's ") +
                FormattableString.Invariant($"step{(slowest == Thesis[0].Kernel ? ": the same." : $": not the same; λ takes {fractions["initial"][0]:0.0} %.")}"));
            page.Line();
        }

        static double Milliseconds(ReportTable table, string window)
            => table.Rows.Single(row => row["window"] == window && row["stage"] == "step").Number("ms");

        static double[] Fractions(IEnumerable<ReportTable.Row> stages)
        {
            Dictionary<string, double> ms = stages.ToDictionary(row => row["stage"], row => row.Number("ms"));
            double lambda = ms["Rill.Lambda"] / (Iterations - 1);
            double[] parts = { lambda * Iterations, ms["Rill.Sort"] + ms["Rill.List"] - lambda, ms["Rill.ApplyDeltaP"], ms["Rill.Velocity"] };
            return parts.Append(ms["step"] - parts.Sum()).Select(part => part / ms["step"] * 100).ToArray();
        }
    }
}
