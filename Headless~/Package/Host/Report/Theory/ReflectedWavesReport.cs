using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report
{
    /// <summary>The report's reflected waves: when the wave of a dam break is back, for substeps and spacings, against the finest run.</summary>
    static class ReflectedWavesReport
    {
        const string Times = "damping-reflected", Curves = "damping-reflected-curves";
        static readonly string[] Columns = Enumerable.Range(1, ReflectedWaves.Turns).Select(turn => $"turn{turn}_s").ToArray();

        // The finest last: what the others are held against.
        static readonly (int Across, float Damping, int Substeps)[] Quick = { (12, 1f, 1), (12, 1f, 2) };

        public static void Measure(ReportRun run)
        {
            var times = new ReportTable(new[] { "across", "damping", "substeps", "seed" }.Concat(Columns).ToArray());
            var curves = new ReportTable("across", "damping", "substeps", "time_s", "x_m");
            int seeds = run.Quick ? 1 : 5;
            foreach ((int across, float damping, int substeps) in run.Quick ? Quick : Full())
                for (uint seed = 1; seed <= seeds; seed++)
                {
                    StepInput input = FluidRun.Water(substeps, 2);
                    input.settings.numericalDamping = damping;
                    List<(double Time, double Value)> samples = ReflectedWaves.Run(across, seed, input);
                    double[] arrivals = ReflectedWaves.Arrivals(samples);
                    times.Add(new object[] { across, damping, substeps, seed }.Concat(arrivals.Cast<object>()).ToArray());
                    if (seed == 1)
                        foreach ((double time, double x) in samples)
                            curves.Add(across, damping, substeps, time, x);
                    run.Log($"  reflected waves a/d {across}, damping {damping}, {substeps} x 2, seed {seed}: " +
                        $"{string.Join(", ", arrivals.Select(time => $"{time:0.000}"))} s");
                }
            string settled = System.FormattableString.Invariant(
                $"water {ReflectedWaves.Width} m wide, twice as high and 8 d thick, tank of four widths, lid at three; 60 steps a second, 2 ") +
                System.FormattableString.Invariant($"iterations, deep water on; {seeds} starts each, whose offsets differ");
            run.Save(Times, times, settled);
            run.Save(Curves, curves, settled);
        }

        static IEnumerable<(int, float, int)> Full()
        {
            foreach (int across in new[] { 20, 40 })
            {
                yield return (across, 0.33f, 1);
                foreach (int substeps in new[] { 1, 2, 4 })
                    yield return (across, 1f, substeps);
            }
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Times);
            var groups = table.Rows.GroupBy(row => (Across: row["across"], Damping: row["damping"], Substeps: row["substeps"])).ToArray();
            page.Heading("Reflected waves");
            page.Line("A dam breaks in a closed tank, and its wave runs to and fro. A wave has arrived at a wall when the center of " +
                "mass along the tank turns back there, as then no more water comes than goes. Spray does not move that. First: " +
                "at the far wall; second: at the near one; third: at the far one again. Mean ± standard deviation over starts whose " +
                "offsets differ. The bar is the larger of 3 % and two standard deviations of the finest run, the last row.");
            page.Line();
            double[][] finest = Columns.Select(column => groups[^1].Select(row => row.Number(column)).ToArray()).ToArray();
            page.Table(new[] { "a/d", "numerical damping",
                "substeps" }.Concat(new[] { "first", "second",
                "third" }.SelectMany(turn => new[] { turn + ", s", turn + " against the finest", "in the bar" })), groups.Select(group =>
                new[] { group.Key.Across, group.Key.Damping, group.Key.Substeps }.Concat(Columns.SelectMany((column, turn) =>
                {
                    double[] seen = group.Select(row => row.Number(column)).ToArray();
                    double error = seen.Average() / finest[turn].Average() - 1;
                    return new[] { $"{Figures.Fixed(seen.Average(), 3)} ± {Figures.Fixed(ReflectedWaves.Deviation(seen), 3)}",
                        Figures.Percent(error), Verdict.Of(System.Math.Abs(error) <= ReflectedWaves.Allowed(finest[turn])) };
                }))));
            page.Line($"({table.Settings}.)");
            page.Line();
            string file = page.DataFile(Curves);
            IEnumerable<string> lines = groups.Select((group, i) => $"'{file}' using ($1=={group.Key.Across} && " +
                $"$2=={group.Key.Damping} && $3=={group.Key.Substeps} ? $4 : NaN):5 with lines ls {i + 1} title 'a/d = " +
                $"{group.Key.Across}, {group.Key.Substeps} substeps, damping {group.Key.Damping}'");
            page.Plot("damping-reflected", "The center of mass of water along a closed tank after a dam break, for substeps and spacings",
                "set xlabel 't, s'\nset ylabel 'center of mass, m'\nplot " + string.Join(", \\\n", lines));
        }
    }
}
