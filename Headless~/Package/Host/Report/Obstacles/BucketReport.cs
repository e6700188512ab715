using System;
using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report.Obstacles
{
    /// <summary>The report's rotating bucket: its surface against the parabola.</summary>
    static class BucketReport
    {
        const string Summary = "obstacles-bucket", Profiles = "obstacles-bucket-surface";
        public const double Speed = 3;      // rad/s

        public static void Measure(ReportRun run)
        {
            var summary = new ReportTable("across", "particles", "deep", "start", "friction", "substeps", "iterations", "steepness",
                "own_steepness", "largest_error", "turning", "expected_turning");
            var profiles = new ReportTable("across", "deep", "start", "friction", "substeps", "iterations", "radius_m", "height_m",
                "turning_per_s", "theory_m", "own_theory_m");
            double settle = run.Quick ? 0.8 : 3, seconds = run.Quick ? 0.8 : 1.6;     // one and two periods of the first round wave
            foreach ((int across, DeepWater deep, bool flat, float friction, int substeps) in run.Quick ? Quick : Full())
            {
                const int iterations = 2;
                RotatingBucket bucket = RotatingBucket.Run(across, Speed, flat, FluidRun.Water(substeps, iterations, deep), settle, seconds,
                    friction, runs: run.Quick ? 1 : RotatingBucket.PositionsFor(across));
                string start = flat ? "level" : "parabola";
                summary.Add(across, bucket.Particles, ObstaclesSection.Text(deep), start, friction, substeps, iterations, bucket.Steepness,
                    bucket.OwnSteepness, bucket.MaxError, bucket.Turning,
                    RotatingBucket.TurningLeft(Speed, 1.0 / 60 / substeps, settle + seconds / 2));
                foreach (var ring in bucket.Profile)
                    profiles.Add(across, ObstaclesSection.Text(deep), start, friction, substeps, iterations, ring.Radius, ring.Height,
                        ring.Turning, ring.Theory, ring.OwnTheory);
                run.Log($"  bucket of {across} d, deep water {ObstaclesSection.Text(deep)}, from {start}, friction {friction}, " +
                    $"{substeps} x {iterations}: steepness {bucket.Steepness:0.000}, for its own turning {bucket.OwnSteepness:0.000}, " +
                    $"turning {bucket.Turning:0.000}");
            }
            string settled = FormattableString.Invariant(
                $"radius {RotatingBucket.Radius} m, {RotatingBucket.Depth} m of water, {Speed} rad/s, 60 steps a second, mean from {settle} ") +
                FormattableString.Invariant($"to {settle + seconds} s");
            run.Save(Summary, summary, settled);
            run.Save(Profiles, profiles, settled);
        }

        static readonly (int, DeepWater, bool, float, int)[] Quick = { (12, DeepWater.On, false, 0f, 2), (12, DeepWater.Off, false, 1f, 1) };

        static IEnumerable<(int, DeepWater, bool, float, int)> Full()
        {
            foreach (int across in new[] { 12, 24, 48 })
                foreach (float friction in new[] { 0f, 1f })
                    foreach (int substeps in new[] { 1, 2, 4 })
                        yield return (across, DeepWater.On, false, friction, substeps);
            yield return (48, DeepWater.On, true, 1f, 4);
            foreach (int substeps in new[] { 1, 2, 4, 8 })
                yield return (12, DeepWater.Off, false, 1f, substeps);
            yield return (12, DeepWater.Off, false, 0f, 4);
            yield return (12, DeepWater.Off, true, 1f, 8);
            yield return (24, DeepWater.Off, false, 1f, 8);
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Summary);
            page.Heading("Rotating bucket");
            page.Line("Water in a cylinder turns with it. The cylinder is an inside-out capsule; the floor is the domain's, which slips. The water " +
                "begins level or as the parabola, turning as fast as the wall, which alone would take minutes. Theory: z = z0 + Ω² r² / 2 g " +
                "(Lamb, §26). Steepness: slope of the surface (twice the mean height in rings) over r², over the theory's. Largest: distance " +
                "of a ring from the theory's surface over the rise from the center to the wall.");
            page.Line();
            page.Line("A particle's velocity is the chord of its path, and pressure pushes along the radius at the path's end. So water held " +
                "on a circle loses Ω² Δt of its turning in a second (Δt the substep). That alone leaves 1 / √(1 + 2 Ω0² Δt t) after a time t. " +
                "A wall with friction 1 drives the water, so up to 1 may be left. The surface is also " +
                "compared with that of the turning that the water has, ring by ring: dz/dr = Ω(r)² r / g.");
            page.Line();
            page.Line("All are means over 8, 4 and 2 positions of the cylinder in the cells of the coarse grid, at 12, 24 and 48 d.");
            page.Line();
            page.Table(new[] { "radius, d", "rise, d", "deep water", "starts", "wall's friction", "substeps x iterations", "steepness",
                "within 5 %", "for its own turning", "within 5 %", "largest", "turning left", "by the step alone" },
                table.Rows.Select(row => new[]
                {
                    row["across"], Figures.Fixed(RotatingBucket.Rise(Speed) / RotatingBucket.Radius * row.Number("across"), 1), row["deep"],
                        row["start"], row["friction"], $"{row["substeps"]} x {row["iterations"]}",
                    Figures.Percent(row.Number("steepness") - 1), ObstaclesSection.Within(row.Number("steepness") - 1),
                        Figures.Percent(row.Number("own_steepness") - 1), ObstaclesSection.Within(row.Number("own_steepness") - 1),
                    Figures.Percent(row.Number("largest_error")), Figures.Fixed(row.Number("turning"), 3),
                        Figures.Fixed(row.Number("expected_turning"), 3),
                }));
            page.Line($"({table.Settings}.)");
            page.Line();
            string file = page.DataFile(Profiles);
            // The best of each method, and the finest with as many substeps as a scene has when nothing is set.
            string usual = $"{SolverSettings.Default.substeps}";
            ReportTable.Row[] drawn = table.Rows.GroupBy(row => row["deep"]).Select(method => method.OrderBy(row => row.Number("across"))
                .ThenBy(row => row.Number("friction")).ThenBy(row => row.Number("substeps")).ToList())
                .SelectMany(method => new[] { method.Last(), method.LastOrDefault(row => row["substeps"] == usual, method[0]) }).ToArray();
            IEnumerable<string> lines = drawn.SelectMany((row, i) =>
            {
                string chosen = $"$1=={row["across"]} && strcol(2) eq \"{row["deep"]}\" && strcol(3) eq \"{row["start"]}\" && " +
                    $"$4=={row["friction"]} && $5=={row["substeps"]} && $6=={row["iterations"]}";
                string Line(int column, string style) => $"'{file}' using ({chosen} ? $7 : NaN):{column} every ::1 {style}";
                return new[]
                {
                    Line(8, $"with points ls {i + 1} title 'radius {row["across"]} d, deep water {row["deep"]}, {row["substeps"]} x " +
                        $"{row["iterations"]}{(row["substeps"] == usual ? ", default substeps" : "")}'"),
                    Line(10, $"with lines ls {i + 1} dt 2 notitle"),
                    Line(11, $"with lines ls {i + 1} lw 1.4 dt 3 notitle"),
                };
            }).Append("NaN with lines lc rgb '#606060' lw 1.6 dt 2 title 'dashed: theory'")
                .Append("NaN with lines lc rgb '#606060' lw 1.4 dt 3 title 'dotted: theory for its own turning'");
            page.Plot("obstacles-bucket", "Surface of the water in rotating buckets over the radius, with the theory's: the best and " +
                "the default's substeps",
                "set xlabel 'r, m'\nset ylabel 'height, m'\nplot " + string.Join(", \\\n", lines), 1100, 480);
        }
    }
}
