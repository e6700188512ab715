using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report.Obstacles
{
    /// <summary>The report's floating bodies: draft, and period of heave.</summary>
    static class FloatingReport
    {
        const string Summary = "obstacles-floating", Heights = "obstacles-floating-heave";
        const double MaxDamping = 0.5;     // beyond, a period that is fitted says nothing

        public static void Measure(ReportRun run)
        {
            var summary = new ReportTable("shape", "across", "layers", "side", "deep", "draft_m", "theory_draft_m", "level_off_m",
                "period_s", "theory_period_s", "damping_ratio", "misfit");
            var heights = new ReportTable("shape", "across", "deep", "time_s", "height_m", "fit_m");
            foreach (int across in run.Quick ? new[] { 8 } : new[] { 8, 16, 32 })
                foreach (ColliderShape shape in run.Quick ? new[] { ColliderShape.Box } : new[] { ColliderShape.Sphere, ColliderShape.Box })
                    foreach (DeepWater deep in run.Quick ? new[] { DeepWater.On } : new[] { DeepWater.On, DeepWater.Off })
                    {
                        SolverSettings settings = SolverSettings.Default;
                        settings.deepWater = deep;
                        int layers = across * 3 / 2, side = across * (run.Quick ? 3 : FloatingBody.WidthsAcross);
                        FloatingBody body = FloatingBody.Run(shape, across, layers, side, settings);
                        string name = shape == ColliderShape.Sphere ? "ball" : "cube";
                        summary.Add(name, across, layers, side, ObstaclesSection.Text(deep), body.Draft, body.TheoryDraft, body.LevelError,
                            body.Period, body.TheoryPeriod, body.DampingRatio, body.Fit.Misfit);
                        foreach ((double time, double height) in body.Heights)
                            heights.Add(name, across, ObstaclesSection.Text(deep), time, height, body.Fit.At(time));
                        run.Log($"  {name} of {across} d, deep water {ObstaclesSection.Text(deep)}: draft {body.Draft:0.000} m of " +
                            $"{body.TheoryDraft:0.000}, period {body.Period:0.000} s of {body.TheoryPeriod:0.000}, damping " +
                            $"{body.DampingRatio:0.00}");
                    }
            string settled = $"d = {FloatingBody.Spacing * 100:0} cm, half the water's density, default settings but for deep water, " +
                $"FluidBuoyancy as a new component but with Damping 0 while it swings";
            run.Save(Summary, summary, settled);
            run.Save(Heights, heights, settled);
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Summary);
            page.Heading("Floating bodies");
            page.Line($"A ball and a cube of half the water's density, carried by FluidBuoyancy and a Rigidbody that only heaves, are " +
                $"let go {100 * FloatingBody.Lift:0} % of their height above rest, swing with *Damping* 0 and come to rest with the " +
                $"default. Draft: how deep the body lies under the level of the water around it in the last second, against " +
                $"Archimedes. Level: of that water, above or below that of water that keeps its volume. Period: of a damped cosine " +
                $"fitted to the first swings, without its damping, against T = 2π √((m + m_a) / (ρ g A)). A is the area that the body " +
                $"cuts out of the surface, m_a half of the water displaced for the ball (Lamb, §92) and 0.68 of it for the cube (DNV-RP-C205, " +
                $"appendix D): the added mass of fast heave. Waves shorten a ball's period by about 3 % (Havelock 1955); the floor lengthens it. " +
                $"In a tank three bodies wide the first even wave has 0.98 of the ball's period and 0.75 of the cube's; new measurements are " +
                $"made in tanks {FloatingBody.WidthsAcross} bodies wide. Damping: as a fraction of the critical, with *Damping* 0; negative where " +
                $"the late force drives the heave. Above {MaxDamping} no period is meaningful.");
            page.Line();
            page.Table(new[] { "body", "layers, width of the tank, d", "deep water", "draft, m", "theory, m", "draft's error", "within 5 %",
                "level, d", "period, s", "theory, s", "period's error", "within 5 %", "damping", "misfit of the cosine" },
                table.Rows.Select(row =>
                {
                    double draft = row.Number("draft_m") / row.Number("theory_draft_m") - 1;
                    double period = row.Number("damping_ratio") > MaxDamping ? double.NaN
                        : row.Number("period_s") / row.Number("theory_period_s") - 1;
                    return new[]
                    {
                        $"{row["shape"]} of {row["across"]} d", $"{row["layers"]}, {row["side"]}", row["deep"],
                            Figures.Fixed(row.Number("draft_m"), 3), Figures.Fixed(row.Number("theory_draft_m"), 3), Figures.Percent(draft),
                            ObstaclesSection.Within(draft),
                        Figures.Fixed(row.Number("level_off_m") / FloatingBody.Spacing, 2), double.IsNaN(period) ? "–"
                            : Figures.Fixed(row.Number("period_s"), 3), Figures.Fixed(row.Number("theory_period_s"), 3),
                            Figures.Percent(period), ObstaclesSection.Within(period),
                        Figures.Fixed(row.Number("damping_ratio"), 2), Figures.Percent(row.Number("misfit")),
                    };
                }));
            page.Line($"({table.Settings}.)");
            page.Line();
            page.Line("Where the periods come from was [looked into](floating-study.md#periods-of-heave).");
            page.Line();
            string file = page.DataFile(Heights), smallest = table.Rows.First()["across"];
            IEnumerable<string> lines = table.Rows.Where(row => row["across"] == smallest).SelectMany((row, i) =>
            {
                string chosen = $"strcol(1) eq \"{row["shape"]}\" && $2=={row["across"]} && strcol(3) eq \"{row["deep"]}\"";
                return new[]
                {
                    $"'{file}' using ({chosen} ? $4 : NaN):5 every ::1 with points ls {i + 1} ps 0.5 title '{row["shape"]}, deep water " +
                        $"{row["deep"]}'",
                    $"'{file}' using ({chosen} ? $4 : NaN):6 every ::1 with lines ls {i + 1} notitle",
                };
            });
            lines = lines.Append("NaN with lines lc rgb '#606060' title 'lines: fits'");
            page.Plot("obstacles-heave", "Height of floating bodies over time after they were let go, with fits",
                "set xlabel 't, s'\nset ylabel 'center of the body over the floor, m'\nplot " + string.Join(", \\\n", lines));
        }
    }
}
