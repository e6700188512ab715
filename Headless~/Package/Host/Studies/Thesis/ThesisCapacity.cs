using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Host.Report;
using Host.Report.ErrorTime;

namespace Host.Studies.Thesis
{
    /// <summary>Figure 5.2: particles at 60 frames a second against iterations.</summary>
    sealed class ThesisCapacity : ThesisFigure
    {
        const string TableName = "thesis-capacity";
        const double Frame = 1000.0 / 60;
        // Fractions of the frame; the rest is for drawing and the game.
        static readonly (string Name, double Value)[] Fractions = { ("an eighth", 1 / 8.0), ("a quarter", 1 / 4.0) };

        public override string Title => "Particles at 60 frames a second (figure 5.2)";

        public override void Measure(ReportRun run)
        {
            int[] sizes = run.Quick ? new[] { 500, 1_000, 2_000 } : new[] { 100_000, 300_000, 1_000_000, 3_000_000 };
            int[] iterations = run.Quick ? new[] { 1, 5 } : new[] { 1, 2, 5, 10, 20 };
            var table = new ReportTable("particles", "iterations", "ms");
            foreach (int size in sizes)
                foreach (int k in iterations)
                {
                    Experiment experiment = Experiment.Run(ExperimentScene.Dam(size),
                        ExperimentFigures.Input(new SweepSetting(false, 1, k).Settings), 10 / 60.0, 1000);
                    table.Add(experiment.Scene.Particles, k, experiment.Milliseconds("initial"));
                }
            run.Save(TableName, table, "plain iterations, relaxation 0.8, medians of steps 3-10 of a fresh block");
        }

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(TableName);
            var byIterations = table.Rows.GroupBy(row => (int)row.Number("iterations")).OrderBy(group => group.Key)
                .Select(group => (Iterations: group.Key,
                    Points: group.Select(row => (Particles: row.Number("particles"), Ms: row.Number("ms"))).OrderBy(p => p.Particles)
                    .ToArray())).ToList();
            double least = byIterations[0].Points[0].Particles, most = byIterations[0].Points[^1].Particles;

            var plot = new PlotData();
            for (int i = 0; i < Fractions.Length; i++)
                plot.Add($"using 1:2 with linespoints ls {i + 1} title '{Fractions[i].Name} of the frame'",
                    byIterations.Select(k => new object[] { k.Iterations, Particles(k.Points, Fractions[i].Value * Frame) })
                        .Where(point => !double.IsNaN((double)point[1])));
            page.Plot("thesis-capacity", "Particles that fit a fraction of a frame at 60 Hz against iterations",
                plot.Script("set xlabel 'iterations'\nset ylabel 'particles'\nset logscale y\nset format y '%.0s%c'\n"));

            page.Line(FormattableString.Invariant(
                $"Step times of the initial block, interpolated between the sizes measured; assumed is that the step may take ") +
                FormattableString.Invariant($"{string.Join(" or ", Fractions.Select(fraction => FormattableString.Invariant($"{fraction.Name} of the frame ({fraction.Value * Frame:0.00} ms)")))}:"));
            page.Line();
            page.Table(new[] { "iterations" }.Concat(Fractions.Select(fraction => $"particles in {fraction.Name}"))
                .Concat(byIterations[0].Points.Select(p => FormattableString.Invariant($"ms at {p.Particles:N0}"))),
                byIterations.Select(k => new[] {
                    k.Iterations.ToString() }.Concat(Fractions.Select(fraction => Count(k.Points, fraction.Value * Frame, least, most)))
                    .Concat(k.Points.Select(p => FormattableString.Invariant($"{p.Ms:0.000}")))));
            page.Line("The thesis draws the same curve for its hardware; its absolute counts belong to that and are not repeated here. "
                + Shape(byIterations));
            page.Line();
        }

        /// <summary>By straight lines between the logarithms; NaN beyond what was measured.</summary>
        /// <param name="points">By rising particles.</param>
        public static double Particles(IReadOnlyList<(double Particles, double Ms)> points, double milliseconds)
        {
            for (int i = 0; i + 1 < points.Count; i++)
            {
                (double lowCount, double low) = points[i];
                (double highCount, double high) = points[i + 1];
                if (low <= milliseconds && milliseconds <= high && low < high)
                    return Math.Exp(Math.Log(lowCount) + Math.Log(highCount / lowCount) * Math.Log(milliseconds / low) / Math.Log(high / low));
            }
            return double.NaN;
        }

        static string Count(IReadOnlyList<(double Particles, double Ms)> points, double milliseconds, double least, double most)
        {
            double particles = Particles(points, milliseconds);
            if (!double.IsNaN(particles))
                return FormattableString.Invariant($"{particles:N0}");
            return points[0].Ms > milliseconds ? FormattableString.Invariant($"fewer than {least:N0}")
                : FormattableString.Invariant($"more than {most:N0}");
        }

        // A step is a fixed part and a part for each iteration: so the hyperbola.
        static string Shape(List<(int Iterations, (double Particles, double Ms)[] Points)> byIterations)
        {
            (int fewIterations, var few) = byIterations[0];
            (int manyIterations, var many) = byIterations[^1];
            (double particles, double fast) = few[^1];
            double perIteration = (many[^1].Ms - fast) / (manyIterations - fewIterations);
            return FormattableString.Invariant(
                $"Its shape follows from a step that has a fixed part and a part for each iteration: at {particles:N0} particles ") +
                FormattableString.Invariant($"{perIteration:0.000} ms an iteration, {(fast - fewIterations * perIteration) / fast * 100:0} % of the step with ") +
                FormattableString.Invariant($"{fewIterations} being fixed.");
        }
    }
}
