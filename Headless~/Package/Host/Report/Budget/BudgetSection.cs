using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Mathematics;

namespace Host.Report.Budget
{
    /// <summary>Basis of the budget: error and time of each setting it may choose, and of some that it leaves out; and how it holds a
    /// target.</summary>
    sealed class BudgetSection : ReportSection
    {
        const string LadderTable = "budget-ladder", LoopTable = "budget-loop";
        const float Relaxation = 0.8f;

        static readonly (int substeps, int iterations)[] LeftOut = { (1, 3), (2, 1), (2, 2), (2, 4), (4, 1), (4, 2) };

        public override string Name => "budget";
        public override string Title => "A budget of GPU time";

        public override void Measure(ReportRun run)
        {
            MeasureLadder(run);
            var loop = new ReportTable(BudgetLoop.Columns);
            foreach (object[] row in new BudgetLoop(run.Quick).Measure())
                loop.Add(row);
            run.Save(LoopTable, loop, $"{(run.Quick ? "dam of 512" : "dam of 1,000,000")} particles, coarse correction on, 60 frames a " +
                $"second, noise and lateness of this device");
        }

        static void MeasureLadder(ReportRun run)
        {
            var table = new ReportTable("scene", "particles", "substeps", "iterations", "relaxation", "on_ladder", "error_moving",
                "error_settled", "jitter_m_s", "ms", "model_ms");
            double seconds = run.Quick ? 2.5 : 8;
            var shallow = run.Quick ? ExperimentScene.Block("shallow", new int3(8, 8, 8), new int3(16, 16, 8), 1f / 8f)
                : ExperimentScene.Block("shallow", new int3(200, 8, 200), new int3(400, 16, 200), 0.05f);
            foreach ((ExperimentScene scene, bool deep) in new[] { (shallow, false), (ExperimentScene.Dam(run.Quick ? 512 : 1_000_000), true) })
            {
                var ladder = new BudgetLadder();
                ladder.Build(deep, 0.3f, SolverBudget.Default);
                List<(int substeps, int iterations)> onLadder = Enumerable.Range(0, ladder.Count)
                    .Select(i => (ladder[i].Substeps, ladder[i].Iterations)).ToList();
                foreach ((int substeps, int iterations) in onLadder.Concat(LeftOut.Except(onLadder).Where(pair => deep || pair.iterations > 1)))
                {
                    SolverSettings settings = SolverSettings.Default;
                    (settings.substeps, settings.iterations, settings.relaxation, settings.deepWater) = (substeps, iterations, Relaxation,
                        deep ? DeepWater.On : DeepWater.Off);
                    var input = ExperimentFigures.Input(settings);
                    Experiment experiment = Experiment.Run(scene, input, seconds, sampleEvery: 10);
                    table.Add(deep ? "deep" : "shallow", scene.Particles, substeps, iterations, Relaxation,
                        onLadder.Contains((substeps, iterations)) ? 1 : 0,
                        experiment.Moving(s => s.densityError), experiment.Settled(s => s.densityError), experiment.Settled(s => s.jitter),
                        experiment.Milliseconds("settled"), StepCost.Milliseconds(substeps, iterations, scene.Particles, deep, false));
                    run.Log($"{(deep ? "deep" : "shallow")} {substeps} x {iterations}");
                }
            }
            run.Save(LadderTable, table,
                $"60 steps a second; errors of 0.2 to 2 s and of the last 2 of {seconds} s; ms: median of the last 100 steps");
        }

        public override void Write(ReportPage page)
        {
            ReportTable ladder = page.Load(LadderTable);
            page.Line("The settings that a [budget](../Documentation~/budget.md) climbs, and some that it leaves out because another gives less error in less time.");
            page.Line();
            List<ReportTable.Row> steps = ladder.Rows.ToList();
            page.Table(new[] { "scene", "particles", "substeps x iterations", "chosen from", "C+ moving", "C+ settled", "jitter, m/s", "ms",
                "ms by the cost model" },
                ladder.Rows.Select(row => new[]
                {
                    row["scene"], row["particles"], $"{row["substeps"]} x {row["iterations"]}", row["on_ladder"] == "1" ? "yes" : "no",
                        Percent(row.Number("error_moving")),
                    Percent(row.Number("error_settled")), $"{row.Number("jitter_m_s"):0.000}", $"{row.Number("ms"):0.000}",
                        $"{row.Number("model_ms"):0.000}",
                }), i => steps[i]["on_ladder"] == "1");
            page.Line($"({ladder.Settings}.)");
            page.Line();

            ReportTable held = page.Load(LoopTable);
            page.Line("A budget that changes while the water moves: time of each frame's steps, and what the budget allows.");
            page.Line();
            page.Plot("budget-loop", "Milliseconds of each frame's steps and the budget, over time", $@"
set xlabel 's'
set ylabel 'ms'
set yrange [0:*]
set y2range [0:20]
set y2label 'iterations'
set y2tics
set border 11 lc rgb '#606060'
plot '{page.DataFile(LoopTable)}' using 1:3 skip 1 with lines ls 1 title 'steps', '' using 1:2 skip 1 with lines ls 2 lw 2 title 'budget', '' using 1:5 skip 1 axes x1y2 with steps ls 5 title 'iterations'
");
            page.Table(new[] { "from, s", "steps a frame", "budget, ms", "chosen", "ms, last second",
                "worst of 95 % after a second, of the budget", "changes after a second", "C+", "why" },
                held.Rows.GroupBy(row => row["phase"]).Select(phase => Phase(phase.ToList())));
            page.Line($"({held.Settings}.)");
        }

        static string[] Phase(List<ReportTable.Row> rows)
        {
            double start = rows[0].Number("time_s"), target = rows[0].Number("target_ms");
            List<ReportTable.Row> settled = rows.Where(row => row.Number("time_s") >= start + 1).ToList(), last = rows.Skip(rows.Count - 60).ToList();
            double[] times = settled.Select(row => row.Number("ms")).OrderBy(ms => ms).ToArray();
            int changes = Enumerable.Range(1, settled.Count - 1).Count(i => settled[i]["iterations"] != settled[i - 1]["iterations"]
                || settled[i]["substeps"] != settled[i - 1]["substeps"]);
            ReportTable.Row end = rows[^1];
            return new[]
            {
                $"{start:0.0}", end["steps"], $"{target:0.00}", $"{end["substeps"]} x {end["iterations"]}",
                    $"{last.Average(row => row.Number("ms")):0.00}",
                $"{times[(int)(0.95 * (times.Length - 1))] / target:0.00}", $"{changes}", Percent(end.Number("error")), end["why"],
            };
        }

        static string Percent(double fraction) => $"{fraction * 100:0.00} %";
    }
}
