using System;
using System.Linq;
using Rill;

namespace Host.Report
{
    /// <summary>The report's wavemaker: how high waves are over the stroke of the piston that makes them.</summary>
    static class WavemakerReport
    {
        const string Heights = "experiment-wavemaker";
        public const float Spacing = 0.02f; // m
        const double Stroke = 4;            // d
        const double Bar = 0.05;            // of height and speed

        public static void Measure(ReportRun run)
        {
            var table = new ReportTable("layers", "kh", "damping", "substeps", "ratio", "theory", "speed");
            (int layers, double kh, float damping, int substeps)[] settings = run.Quick ? new[] { (8, 1.0, 1f, 1) }
                : new[] { (24, 0.5, 1f, 1), (24, 1.0, 1f, 1), (24, 2.0, 1f, 1), (24, 1.0, 0.33f, 1), (24, 1.0, 0f, 1), (24, 1.0, 1f, 4),
                    (48, 1.0, 1f, 1) };
            foreach ((int layers, double kh, float damping, int substeps) in settings)
            {
                StepInput input = FluidRun.Water(substeps, 2);
                input.settings.numericalDamping = damping;
                (double ratio, double speed) = Wavemaker.Run(layers, kh, Stroke, Spacing, input);
                double theory = Wavemaker.HeightOverStroke(kh);
                table.Add(layers, kh, damping, substeps, ratio, theory, speed);
                run.Log($"  wavemaker {layers} layers, kh {kh}, damping {damping}, {substeps} x 2: H/S {ratio:0.000}, theory {theory:0.000}, " +
                    $"speed {speed:0.000} of it");
            }
            run.Save(Heights, table, FormattableString.Invariant(
                $"tank 8 d thick, d = {100 * Spacing:0} cm, stroke {Stroke} d, 60 steps a second, 2 iterations, deep water on"));
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Heights);
            page.Heading("Wavemaker");
            page.Line("A piston at the end of a tank of 2.5 wave lengths moves to and fro. Height of the waves from trough to crest " +
                "over the piston's stroke, by their first harmonic, 1.5 depths from it and before the far wall's reflection arrives. " +
                "Speed: from there on over a quarter of the wave length. What the same tank shows while its piston rests is taken off. " +
                "Theory: H/S = 2 (cosh 2kh − 1) / (sinh 2kh + 2kh) (Havelock 1929; Dean and Dalrymple 1991, section 6.2).");
            page.Line();
            string[] columns = { "layers", "kh", "numerical damping", "substeps", "H/S", "theory", "error", Verdict.Column(Bar),
                "speed's error", Verdict.Column(Bar) };
            page.Table(columns, table.Rows.Select(row => new[]
            {
                row["layers"], row["kh"], row["damping"], row["substeps"], Figures.Fixed(row.Number("ratio"), 3),
                Figures.Fixed(row.Number("theory"), 3), Figures.Percent(row.Number("ratio") / row.Number("theory") - 1),
                Verdict.Within(row.Number("ratio") / row.Number("theory") - 1, Bar),
                Figures.Percent(row.Number("speed") - 1), Verdict.Within(row.Number("speed") - 1, Bar),
            }));
            page.Line($"({table.Settings}.)");
            page.Line();
        }
    }
}
