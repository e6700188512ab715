using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rill;

namespace Host.Report
{
    /// <summary>The report's dam break: fronts against experiments and against inviscid flow, for spacings, steps and settings.</summary>
    static class FrontReport
    {
        const string Summary = "experiment-front", Curves = "experiment-front-curves", Points = "experiment-front-points",
            Inviscid = "experiment-front-inviscid";

        static readonly (string Change, int Across, int Substeps, int Iterations)[] Quick = { ("", 10, 1, 2), ("", 20, 1, 2), ("", 20, 2, 2) };

        public static void Measure(ReportRun run)
        {
            List<FrontSeries> experiments = FrontSeries.Experiments(Session.Root());
            FrontSeries inviscid = InviscidDamBreak.Run(run.Quick ? 10 : 20);
            run.Log($"  inviscid flow: ahead by {100 * new FrontDeviation(inviscid, experiments).Mean:0.0} %");
            var summary = new ReportTable("change", "across", "substeps", "iterations", "least", "most", "mean", "within_bar",
                "mean_of_middle", "mean_to_inviscid", "energy_ratio");
            var curves = new ReportTable("across", "substeps", "iterations", "T", "Z");
            foreach ((string change, int across, int substeps, int iterations) in run.Quick ? Quick : Full())
            {
                StepInput input = FluidRun.Water(substeps, iterations);
                if (change == "no viscosity")
                    input.material.velocitySmoothing = 0;
                if (change == "plain")
                    input.settings.deepWater = DeepWater.Off;
                DamBreakFront dam = DamBreakFront.Run(across, input, change == "twice as thick" ? 16 : 8);
                var deviation = new FrontDeviation(dam.Front, experiments);
                summary.Add(change, across, substeps, iterations, deviation.Min, deviation.Max, deviation.Mean, deviation.WithinBar ? 1 : 0,
                    new FrontDeviation(dam.FrontHalfStepLater, experiments).Mean, new FrontDeviation(dam.FrontHalfStepLater, new[] { inviscid }).Mean,
                        dam.EnergyRatio);
                if (change == "")
                    foreach ((double time, double position) in dam.Front.Points)
                        curves.Add(across, substeps, iterations, time, position);
                run.Log($"  front a/d {across}, {substeps} x {iterations} {change}: {100 * deviation.Min:0.0} to {100 * deviation.Max:0.0} %");
            }
            const string settings = "a = 1 m, 8 d thick, 60 steps a second, deep water on, water";
            run.Save(Summary, summary, settings);
            run.Save(Curves, curves, settings);
            Save(run, Inviscid, new[] { inviscid });
            Save(run, Points, experiments);
        }

        static IEnumerable<(string, int, int, int)> Full()
        {
            foreach (int across in new[] { 10, 20, 40, 80, 160 })
                foreach ((int substeps, int iterations) in new[] { (1, 2), (1, 4), (2, 2), (4, 2) })
                    yield return ("", across, substeps, iterations);
            foreach (int across in new[] { 20, 40 })
            {
                yield return ("no viscosity", across, 1, 2);
                yield return ("twice as thick", across, 1, 2);
                yield return ("", across, 1, 8);
                yield return ("plain", across, 4, 8);
            }
        }

        static void Save(ReportRun run, string name, IEnumerable<FrontSeries> fronts)
        {
            var table = new ReportTable("series", "T", "Z");
            foreach (FrontSeries front in fronts)
                foreach ((double time, double position) in front.Points)
                    table.Add(front.Name, time, position);
            run.Save(name, table, "see Headless~/Package/data/dam-break-front.csv");
        }

        public static void Write(ReportPage page)
        {
            ReportTable table = page.Load(Summary);
            List<FrontSeries> experiments = FrontSeries.Of(page.Load(Points));
            var inviscid = new FrontDeviation(FrontSeries.Of(page.Load(Inviscid))[0], experiments);
            page.Heading("Dam break");
            page.Line("A column of water as wide as a and twice as high falls onto a dry floor, as in the experiments of Martin and " +
                "Moyce (1952) and of Koshizuka and Oka (1996). Front: the 99.5th percentile of the particles' x; T = t √(2 g/a), Z = " +
                "front/a. Ahead: (Z − mean of the three series) / mean at equal T, for the T where all three have points, up to Z = 3. " +
                "The bar is −5 to +10 %.");
            page.Line();
            page.Line(string.Create(CultureInfo.InvariantCulture, $"Inviscid flow (particles in cells with an exact projection, " +
                $"two-dimensional, small steps) is itself ahead of the experiments by {100 * inviscid.Min:0.0} to {100 * inviscid.Max:0.0} %, " +
                $"on average {100 * inviscid.Mean:0.0} %. A laboratory has a gate that takes time to open and a boundary layer at the floor. " +
                $"So the solver should converge to that, not to 0. Each state is also half a substep later than the clock says (see free " +
                $"fall)."));
            page.Line();
            List<ReportTable.Row> all = table.Rows.ToList();
            page.Table(new[] { "a/d", "substeps x iterations", "", "ahead, least", "most", "mean ahead", "in the bar",
                "mean, half a substep later", "mean against inviscid flow", "energy left" },
                table.Rows.Select(row => new[]
                {
                    row["across"], $"{row["substeps"]} x {row["iterations"]}", row["change"] == "plain" ? "deep water off" : row["change"],
                    Figures.Percent(row.Number("least")), Figures.Percent(row.Number("most")), Figures.Percent(row.Number("mean")),
                        Verdict.Of(row["within_bar"] == "1"),
                    Figures.Percent(row.Number("mean_of_middle")), Figures.Percent(row.Number("mean_to_inviscid")),
                        Figures.Fixed(row.Number("energy_ratio"), 3),
                }), i => all[i]["change"] == "plain" || all[i]["change"] == "" && all[i]["substeps"] == "1"
                    && (all[i]["iterations"] == "2" || all[i].Number("iterations") == SolverSettings.Default.iterations));
            page.Line($"({table.Settings}; energy at T = {DamBreakFront.End} over that at the start.)");
            page.Line();
            WriteParts(page, table, experiments);
            page.Plot("experiment-front",
                "The front of a dam break over time, less that of inviscid flow: experiments, and the solver at several spacings",
                Script(page, table, experiments));
        }

        // Parts of the lead over the experiments: the clock, the lead of inviscid flow itself, and what is left for the solver.
        static void WriteParts(ReportPage page, ReportTable table, List<FrontSeries> experiments)
        {
            ReportTable curves = page.Load(Curves);
            FrontSeries inviscid = FrontSeries.Of(page.Load(Inviscid))[0];
            double flow = new FrontDeviation(inviscid, experiments).Mean;
            page.Line("Where the mean comes from, over the same T. *Clock*: the half substep. *Inviscid flow*: its own lead. " +
                "*Solver*: the rest, by which it is slower.");
            page.Line();
            page.Table(new[] { "a/d", "substeps x iterations", "ahead of the experiments", "clock", "inviscid flow", "solver" },
                table.Rows.Where(row => row["change"] == "" && row["iterations"] == "2" && row["substeps"] != "2"
                    && row.Number("across") >= 20).Select(row =>
                {
                    var points = curves.Rows.Where(point => point["across"] == row["across"] && point["substeps"] == row["substeps"]
                        && point["iterations"] == "2").Select(point => (T: point.Number("T"), Z: point.Number("Z"))).ToList();
                    double half = 0.5 / 60 / row.Number("substeps") * DamBreakFront.TimeScale;
                    double ahead = new FrontDeviation(new FrontSeries("front", points), experiments).Mean;
                    double later = new FrontDeviation(new FrontSeries("front",
                        points.Select(point => (point.T + half, point.Z)).Prepend(points[0])), experiments).Mean;
                    return new[] { row["across"], $"{row["substeps"]} x 2", Figures.Percent(ahead), Figures.Percent(ahead - later),
                        Figures.Percent(flow), Figures.Percent(later - flow) };
                }));
            page.Line("Where the lead over the experiments comes from was [looked into](solver-study.md#fronts).");
            page.Line();
        }

        static string Script(ReportPage page, ReportTable table, List<FrontSeries> experiments)
        {
            FrontSeries inviscid = FrontSeries.Of(page.Load(Inviscid))[0];
            ReportTable curves = page.Load(Curves);
            IEnumerable<object[]> Ahead(IEnumerable<(double T, double Z)> points)
                => points.Where(point => !double.IsNaN(inviscid.At(point.T))).Select(point => new object[] { point.T,
                    point.Z - inviscid.At(point.T) });
            var data = new PlotData().Add("using 1:2 with lines lc rgb 'black' dt 2 lw 1.6 title 'theory: inviscid flow'",
                Ahead(inviscid.Points));
            for (int i = 0; i < experiments.Count; i++)
                data.Add($"using 1:2 with points ls {i + 1} title '{ExperimentNames.GetValueOrDefault(experiments[i].Name, experiments[i].Name)}'",
                    Ahead(experiments[i].Points));
            string typical = table.Rows.Where(row => row.Number("across") <= 40).MaxBy(row => row.Number("across"))["across"];
            string usual = $"{SolverSettings.Default.iterations}";
            List<ReportTable.Row> drawn = table.Rows.Where(row => row["change"] == "" && row["substeps"] == "1"
                && (row["iterations"] == "2" || row["iterations"] == usual && row["across"] == typical)).ToList();
            for (int i = 0; i < drawn.Count; i++)
            {
                ReportTable.Row row = drawn[i];
                bool isDefault = row["iterations"] == usual;
                data.Add($"using 1:2 with lines {(isDefault ? "lc rgb '#101010' lw 3" : $"ls {(i + 3) % 8 + 1}")} " +
                    $"title 'a/d = {row["across"]}, 1 x {row["iterations"]}{(isDefault ? ", the default" : "")}'",
                    Ahead(curves.Rows.Where(point => point["across"] == row["across"] && point["substeps"] == "1"
                        && point["iterations"] == row["iterations"]).Select(point => (point.Number("T"), point.Number("Z")))));
            }
            return data.Script("set xlabel 'T'\nset ylabel 'Z less that of inviscid flow'\nset xrange [0:2.8]\nset key outside right top\n");
        }

        static readonly Dictionary<string, string> ExperimentNames = new()
        {
            ["MM1125"] = "Martin, Moyce 1952, 1.125 in", ["MM225"] = "Martin, Moyce 1952, 2.25 in", ["KO"] = "Koshizuka, Oka 1996",
        };
    }
}
