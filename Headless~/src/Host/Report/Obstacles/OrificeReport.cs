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

        // Experiments of their own on lavapipe, 2026-11-24, that "rill report" does not repeat.
        static readonly string[][] Parts =
        {
            new[] { "off, 1 x 2", "0.858, 0.890, 0.913, 0.927", "0.907", "0.81" },
            new[] { "off, 1 x 2, no XSPH", "0.923, 0.934, 0.939, 0.951", "0.951", "0.81" },
            new[] { "off, 1 x 8", "0.769, 0.820, 0.869, 0.894", "0.837", "0.95" },
            new[] { "off, 1 x 8, no XSPH", "0.772, 0.823, 0.872, 0.898", "0.840", "0.95" },
            new[] { "off, 4 x 2", "0.849, 0.890, 0.921, 0.938", "0.894", "0.98" },
            new[] { "off, 4 x 2, no XSPH", "0.847, 0.892, 0.926, 0.941", "0.896", "0.98" },
            new[] { "off, 4 x 8, no XSPH", "0.849, 0.894, 0.923, 0.941", "0.898", "0.99" },
            new[] { "on, 1 x 2", "0.841, 1.058, 1.204, 1.168", "1.075", "0.96" },
        };

        public static void Measure(ReportRun run)
        {
            var summary = new ReportTable("across", "particles", "deep", "substeps", "iterations", "speed_ratio", "discharge", "misfit", "leaked");
            var levels = new ReportTable("across", "deep", "substeps", "iterations", "time_s", "level_m", "fit_m");
            double seconds = run.Quick ? 1.5 : 4;
            foreach ((int across, DeepWater deep, int substeps, int iterations) in run.Quick ? new[] { (6, DeepWater.On, 1, 2), (6, DeepWater.Off, 1, 2) } : Full())
            {
                OrificeFlow flow = OrificeFlow.Run(across, FluidRun.Water(substeps, iterations, deep), seconds);
                summary.Add(across, flow.Particles, ObstaclesSection.Text(deep), substeps, iterations, flow.SpeedRatio, flow.Discharge, flow.Misfit, flow.Leaked);
                foreach ((double time, double level) in flow.Levels)
                    levels.Add(across, ObstaclesSection.Text(deep), substeps, iterations, time, level, flow.LevelAt(time));
                run.Log($"  orifice {across} d, deep water {ObstaclesSection.Text(deep)}, {substeps} x {iterations}: speed {flow.SpeedRatio:0.000} of Torricelli's, coefficient {flow.Discharge:0.000}");
            }
            string settled = FormattableString.Invariant($"hole {OrificeFlow.Hole} m, floor {OrificeFlow.Side:0.0} x {OrificeFlow.Side:0.0} m and {OrificeFlow.Plate:0.00} m thick, level {OrificeFlow.Level} m, 60 steps a second, {seconds} s");
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
            page.Line("### Outflow through a hole");
            page.Line();
            page.Line($"A tank runs out through a square hole with sharp edges in its floor, into air. Torricelli: at z below the level the jet is as fast as what has fallen by z, v = √(2 g z). Speed: of every particle of the jet from half to one width below the hole, where it has drawn together, over that; no coefficient is in it. Rate: from the level, which falls as √h = √h0 − c (a/A) √(g/2) t with a the hole and A the floor; the coefficient c is fitted, for theory gives only that of a slot, π/(π + 2) = {OrificeFlow.SlotCoefficient:0.000} (Lamb, §75), and experiments with sharp edges 0.60 to 0.62. Misfit: largest distance of the level from that parabola over the first level.");
            page.Line();
            page.Table(new[] { "hole, d", "particles", "deep water", "substeps x iterations", "speed over √(2 g z)", "error", "within 5 %", "coefficient c", "over the slot's", "misfit of the level", "through the floor" },
                table.Rows.Select(row => new[]
                {
                    row["across"], row["particles"], row["deep"], $"{row["substeps"]} x {row["iterations"]}", Figures.Fixed(row.Number("speed_ratio"), 3), Figures.Percent(row.Number("speed_ratio") - 1), ObstaclesSection.Within(row.Number("speed_ratio") - 1),
                    Figures.Fixed(row.Number("discharge"), 3), Figures.Percent(row.Number("discharge") / OrificeFlow.SlotCoefficient - 1), Figures.Percent(row.Number("misfit")), row["leaked"],
                }));
            page.Line($"({table.MeasuredOn}.)");
            page.Line();
            page.Line("Where the jet's speed is lost, with a hole of 6 d: speed over √(2 g z) at four depths below the hole; the second is that of the table above. *Later*: there, with gravity's half substep added, since a particle's velocity is the chord of its last path. Height: of the water at rest over that of its volume, before the hole is opened.");
            page.Line();
            page.Table(new[] { "deep water, substeps x iterations", "0 to ½, ½ to 1, 1½ to 2, 2½ to 3 widths below", "later, ½ to 1", "height" }, Parts);
            page.Line("(lavapipe, solver of 2026-11-24; 11,520 particles, mean from 0.4 s after the hole was opened to 0.9 s, with XSPH and deep water off 1 x 2 and 4 x 2 to 1.2 s.)");
            page.Line();
            page.Line("- The clock takes 1.7 % with one substep and 0.4 % with four.");
            page.Line("- XSPH takes 4.4 % with 1 x 2, where the water is noisy, and 0.2 to 0.3 % with 4 x 2 and 1 x 8.");
            page.Line("- The level is not too low: z is taken from the water as it lies, compressed. Compression itself cannot be the main reason: height 0.98 loses as much as 0.81.");
            page.Line("- What is left, without clock and XSPH, is 5 % with 1 x 2, 16 % with 1 x 8, 10 % with 4 x 2 and with 4 x 8. It is lost before the jet leaves: below the hole z (1 − v²/(2 g z)) stays 0.18 m (1 x 2). More passes do not help: 1 x 2 is faster because it is not solved and is noisy.");
            page.Line("- Of solved water, 16 % with one substep and 10 % with four, so by a line in the substep 8 % with none. The slope is the step: pressure at a path's end takes ½ a² Δt² of the energy in a substep, about 8 % of the speed with one. The other 8 % do not depend on step or passes; 12 d lose less (table above), so they are probably the spacing's. Hole edges were not varied.");
            page.Line("- Deep water on is no better founded. At the hole the jet is as slow as without, and between half a width and two it gains more than gravity gives: 20 % too fast at 1½ to 2. The coarse grid's cells, 4 d, are two thirds of this hole, and its displacements go on for two cells around the water. So what is seen at ½ to 1 width is where two errors cross, and not a hit. The 24 d hole, where half a width is three cells, lost 8.5 % before faces had [open areas](solver.md#round-walls) and loses 4.3 % since.");
            page.Line();
            string file = page.DataFile(Levels);
            IEnumerable<string> lines = table.Rows.SelectMany((row, i) =>
            {
                string chosen = $"$1=={row["across"]} && strcol(2) eq \"{row["deep"]}\" && $3=={row["substeps"]} && $4=={row["iterations"]}";
                return new[]
                {
                    $"'{file}' using ({chosen} ? $5 : NaN):6 every ::1 with points ls {i + 1} ps 0.5 title 'hole {row["across"]} d, deep water {row["deep"]}, {row["substeps"]} x {row["iterations"]}'",
                    $"'{file}' using ({chosen} ? $5 : NaN):7 every ::1 with lines ls {i + 1} notitle",
                };
            });
            page.Plot("obstacles-orifice", "Level over time of tanks that run out through a hole, with the fitted parabolas", "set xlabel 't, s'\nset ylabel 'level, m'\nplot " + string.Join(", \\\n", lines));
        }
    }
}
