using System;
using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report.Obstacles
{
    /// <summary>The report's tank with a hole: the jet's speed, the rate, and the level over time.</summary>
    static class OrificeReport
    {
        const string Summary = "obstacles-orifice", Levels = "obstacles-orifice-level";

        public static void Measure(ReportRun run)
        {
            var summary = new ReportTable("across", "particles", "deep", "substeps", "iterations", "speed_ratio", "discharge", "misfit", "leaked");
            var levels = new ReportTable("across", "deep", "substeps", "iterations", "time_s", "level_m", "fit_m");
            double seconds = run.Quick ? 1.5 : 4;
            foreach ((int across, DeepWater deep, int substeps, int iterations) in run.Quick
                ? new[] { (6, DeepWater.On, 1, 2) } : Full())
            {
                OrificeFlow flow = OrificeFlow.Run(across, FluidRun.Water(substeps, iterations, deep), seconds);
                summary.Add(across, flow.Particles, ObstaclesSection.Text(deep), substeps, iterations, flow.SpeedRatio, flow.Discharge,
                    flow.Misfit, flow.Leaked);
                foreach ((double time, double level) in flow.Levels)
                    levels.Add(across, ObstaclesSection.Text(deep), substeps, iterations, time, level, flow.LevelAt(time));
                run.Log($"  orifice {across} d, deep water {ObstaclesSection.Text(deep)}, {substeps} x {iterations}: speed " +
                    $"{flow.SpeedRatio:0.000} of Torricelli's, coefficient {flow.Discharge:0.000}");
            }
            string settled = FormattableString.Invariant(
                $"hole {OrificeFlow.Hole} m, floor {OrificeFlow.Side:0.0} x {OrificeFlow.Side:0.0} m and {OrificeFlow.Plate:0.00} m thick, ") +
                FormattableString.Invariant($"level {OrificeFlow.Level} m, 60 steps a second, {seconds} s");
            run.Save(Summary, summary, settled);
            run.Save(Levels, levels, settled);
        }

        static IEnumerable<(int, DeepWater, int, int)> Full()
        {
            foreach (int across in new[] { 6, 12, 24 })
                yield return (across, DeepWater.On, 1, 2);
            yield return (12, DeepWater.On, 4, 2);
            foreach ((int across, int substeps) in new[] { (6, 1), (6, 4), (12, 4) })
                yield return (across, DeepWater.Off, substeps, 2);
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Summary);
            page.Heading("Outflow through a hole");
            page.Line($"A tank runs out through a square hole with sharp edges in its floor, into air. Torricelli: at z below the " +
                $"level the jet is as fast as what has fallen by z, v = √(2 g z). Speed: of every particle of the jet from half to one " +
                $"width below the hole, where it has drawn together, over that; no coefficient is in it. Rate: from the level, which " +
                $"falls as √h = √h0 − c (a/A) √(g/2) t with a the hole and A the floor. The coefficient c is fitted: theory gives " +
                $"only that of a slot, π/(π + 2) = {OrificeFlow.SlotCoefficient:0.000} (Lamb, §75), and experiments with sharp edges " +
                $"0.60 to 0.62. Misfit: largest distance of the level from that parabola over the first level.");
            page.Line();
            page.Table(new[] { "hole, d", "particles", "deep water", "substeps x iterations", "speed over √(2 g z)", "speed's error",
                "within 5 %", "coefficient c", "over the slot's", "misfit of the level", "through the floor" },
                table.Rows.Select(row => new[]
                {
                    row["across"], row["particles"], row["deep"], $"{row["substeps"]} x {row["iterations"]}",
                        Figures.Fixed(row.Number("speed_ratio"), 3), Figures.Percent(row.Number("speed_ratio") - 1),
                        ObstaclesSection.Within(row.Number("speed_ratio") - 1),
                    Figures.Fixed(row.Number("discharge"), 3), Figures.Percent(row.Number("discharge") / OrificeFlow.SlotCoefficient - 1),
                        Figures.Percent(row.Number("misfit")), row["leaked"],
                }));
            page.Line($"({table.Settings}.)");
            page.Line();
            page.Line("What becomes of the missing speed was [looked into](solver-study.md#jets).");
            page.Line();
            string file = page.DataFile(Levels);
            IEnumerable<string> lines = table.Rows.SelectMany((row, i) =>
            {
                string chosen = $"$1=={row["across"]} && strcol(2) eq \"{row["deep"]}\" && $3=={row["substeps"]} && $4=={row["iterations"]}";
                return new[]
                {
                    $"'{file}' using ({chosen} ? $5 : NaN):6 every ::1 with points ls {i + 1} ps 0.5 title 'hole {row["across"]} d, " +
                        $"deep water {row["deep"]}, {row["substeps"]} x {row["iterations"]}'",
                    $"'{file}' using ({chosen} ? $5 : NaN):7 every ::1 with lines ls {i + 1} notitle",
                };
            });
            lines = lines.Append("NaN with lines lc rgb '#606060' title 'lines: fits'");
            page.Plot("obstacles-orifice", "Level over time of tanks that run out through a hole, with fits",
                "set xlabel 't, s'\nset ylabel 'level, m'\nplot " + string.Join(", \\\n", lines));
        }
    }
}
