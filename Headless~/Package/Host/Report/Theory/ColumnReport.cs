using System.Collections.Generic;
using System.Linq;

namespace Host.Report
{
    /// <summary>The report's still columns: pressure by height, and rest height.</summary>
    static class ColumnReport
    {
        const string Summary = "experiment-column", Profiles = "experiment-column-pressure";
        const double Bar = 0.02;        // of the pressure on the floor, and of the height

        public static void Measure(ReportRun run)
        {
            var summary = new ReportTable("layers", "substeps", "iterations", "bottom_error", "largest_error", "height_ratio");
            var profiles = new ReportTable("layers", "substeps", "iterations", "height_m", "pressure_Pa", "theory_Pa");
            const float spacing = 0.05f;
            int width = run.Quick ? 8 : 24;
            double settle = run.Quick ? 2 : 6;
            (int layers, int substeps, int iterations)[] settings = run.Quick ? new[] { (24, 1, 2), (40, 1, 2) }
                : new[] { (40, 1, 1), (40, 1, 2), (40, 1, 4), (40, 4, 2), (120, 1, 1), (120, 1, 2), (120, 1, 4), (120, 4, 2) };
            foreach ((int layers, int substeps, int iterations) in settings)
            {
                StillColumn column = StillColumn.Run(layers, width, spacing, FluidRun.Water(substeps, iterations), settle);
                summary.Add(layers, substeps, iterations, column.BottomError, column.MaxError, column.HeightRatio);
                foreach ((double height, double pressure, double theory) in column.Layers)
                    profiles.Add(layers, substeps, iterations, height, pressure, theory);
                run.Log($"  column of {layers} layers, {substeps} x {iterations}: bottom {100 * column.BottomError:0.0} %, height " +
                    $"{column.HeightRatio:0.000}");
            }
            string settled = $"{width} x {width} particles across, d = {spacing * 100:0} cm, 60 steps a second, mean of 1 s after {settle} s";
            run.Save(Summary, summary, settled);
            run.Save(Profiles, profiles, settled);
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Summary);
            page.Heading("Pressure and height of still water");
            page.Line("The coarse grid's two potentials are a pressure, p = ρ (φ_v + φ) / Δt² with Δt the substep and φ in " +
                "m². Water at rest has p = ρ g (H − y); what the Jacobi " +
                "iterations carry is missing from the potentials. Errors are fractions of the pressure on the floor, of the lowest layer " +
                "of coarse cells and the largest of all layers; height is twice that of the center of mass over the initial one.");
            page.Line();
            page.Table(new[] { "layers", "substeps x iterations", "lowest cells", Verdict.Column(Bar), "largest", Verdict.Column(Bar), "height",
                Verdict.Column(Bar) },
                table.Rows.Select(row => new[] { row["layers"], $"{row["substeps"]} x {row["iterations"]}",
                    Figures.Percent(row.Number("bottom_error")), Verdict.Within(row.Number("bottom_error"), Bar),
                    Figures.Percent(row.Number("largest_error")), Verdict.Within(row.Number("largest_error"), Bar),
                    Figures.Fixed(row.Number("height_ratio"), 4), Verdict.Within(row.Number("height_ratio") - 1, Bar) }));
            page.Line($"({table.Settings}.)");
            page.Line();
            string file = page.DataFile(Profiles);
            string[] layers = table.Rows.Where(row => row["substeps"] == "1" && row["iterations"] == "2").Select(row => row["layers"]).ToArray();
            IEnumerable<string> lines = layers.SelectMany((count, i) => new[]
            {
                $"'{file}' using ($1=={count} && $2==1 && $3==2 ? $5/1000 : NaN):4 with points ls {i + 1} title '{count} layers'",
                $"'{file}' using ($1=={count} && $2==1 && $3==2 ? $6/1000 : NaN):4 with lines ls {i + 1} title '{count} layers, theory'",
            });
            page.Plot("experiment-pressure",
                "Pressure of the coarse grid over height in still columns, beside rest density times g times depth",
                "set xlabel 'pressure, kPa'\nset ylabel 'height, m'\nplot " + string.Join(", \\\n", lines));
        }
    }
}
