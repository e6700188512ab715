using System;
using System.Collections.Generic;
using System.Linq;
using Host.Manual;
using Host.Report.ErrorTime;
using Rill;

namespace Host.Report.Methods
{
    /// <summary>The question of the thesis, answered from the study of methods: what each iteration leaves of error for its time.</summary>
    sealed class MethodsSection : ReportSection
    {
        const string TableName = "methods";
        /// <summary>The last commit with the code of the other methods.</summary>
        public const string LastCommit = "899e736f";
        // ms: of the question.
        public const double MinTime = 2, MaxTime = 3;

        public override string Name => TableName;
        public override string Title => "Can Jacobi be accelerated in 2 to 3 ms?";
        public override bool OnlyByName => true;
        public override bool OpensPage => true;

        public override void Measure(ReportRun run) => throw new HostException(
            $"the code of the other methods was deleted after commit {LastCommit}: check that commit out and run \"rill report methods\" there.");

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(TableName), sweep = page.Load(ErrorTimeSection.Sweep);
            List<MethodRun> runs = MethodRun.All(table);
            page.Line("Svensson's thesis (2016) left open whether its Jacobi iterations can be accelerated within 2 to 3 ms of GPU time " +
                "without losing accuracy.");
            page.Line();
            page.Line("C+ is the mean excess of density over rest: 0 is right. *The grid* stands for two pressure solves on a coarse grid " +
                "in each step, which is *Deep Water* in the component. 1 x 8 is one substep of 8 iterations. Three scenes: a breaking *dam* of 50 " +
                "layers while it moves, a still *column* of 120, a still *tank* of 12. A run *holds* if its volume stays within 0.9 and 1.1 of " +
                $"that at rest, and its energy below {Figures.Fixed(SweepResult.MaxEnergy, 2)} of the start's. Noise is the rms speed of water " +
                "that stands; in the dam, that of a particle against its neighbors.");
            page.Line();
            foreach (string line in Answer(runs).Concat(Larger(sweep)).Append(Measured(table)))
                page.Line("- " + line);
            page.Line();
            page.Plot("methods", "C+ against milliseconds for each method in three scenes; runs that do not hold are crosses, the default is a star",
                MethodsPlot.Script(runs, IsDefault), MethodsPlot.Width, MethodsPlot.Height);
            page.Line("Lower left is better. Filled circles have the two coarse solves. What leaves more than 100 % or less than 0.001 " +
                "%, or takes longer than the axis, lies on the edge.");
            page.Line();
            page.Line($"To repeat it: `git checkout {LastCommit}`, then `Headless~/rill report methods`. Later commits lack the other methods.");
            page.Line();
            WriteTable(page, runs);
        }

        /// <summary>The lines of the answer, the verdict first.</summary>
        public static List<string> Answer(List<MethodRun> runs)
        {
            string[] scenes = runs.Select(run => run.Scene).Distinct().ToArray();
            List<MethodRun> inTime = runs.Where(run => run.Milliseconds <= MaxTime).ToList();
            List<MethodRun> alone = runs.Where(run => !run.HasGrid && run.SubstepCount == 1).ToList(),
                withGrid = runs.Where(run => run.HasGrid && run.Method == MethodRun.Jacobi).ToList(),
                substeps = runs.Where(run => !run.HasGrid && run.SubstepCount > 1).ToList();
            string[] heldAlone = scenes.Where(scene => alone.Intersect(inTime).Any(run => run.Scene == scene && run.Holds)).ToArray();
            string[] heldByGrid = scenes.Where(scene => withGrid.Intersect(inTime).Any(run => run.Scene == scene && run.Holds)).ToArray();
            var lines = new List<string>
            {
                $"**{Conclude(scenes, heldAlone, heldByGrid)}{OnTop(runs)}{BySubsteps(substeps, withGrid, scenes)}**",
                $"One substep without the grid, by ω, the neighbors' mean, Chebyshev, scheduled relaxation, Nesterov or Gauss-Seidel: " +
                    $"{Held(alone, scenes)}.",
                $"Substeps without the grid: {Held(substeps, scenes)}.",
                $"Two coarse solves and Jacobi passes: {Held(withGrid, scenes)}.",
            };
            List<string> gains = scenes.Select(scene => Gains(runs, scene)).Where(text => text.Length > 0).ToList();
            if (gains.Count > 0)
                lines.Add("On top of the grid at equal passes, C+ and noise of Jacobi, then of the iteration that saves most: " +
                    string.Join("; ", gains) + ".");
            return lines;
        }

        static string Conclude(string[] scenes, string[] heldAlone, string[] heldByGrid)
        {
            string alone = heldAlone.Length == scenes.Length ? "Yes: an accelerated iteration alone holds every scene"
                : heldAlone.Length == 0 ? "Not by another iteration: none holds any of the scenes alone"
                : $"Not by another iteration alone: of the {List(scenes)} it holds the {List(heldAlone)} only";
            string grid = heldByGrid.Length == scenes.Length ? "two coarse solves a step hold all"
                : heldByGrid.Length == 0 ? "two coarse solves a step hold none" : $"two coarse solves a step hold the {List(heldByGrid)}";
            return $"{alone}; {grid}, in less than {MaxTime:0} ms.";
        }

        // Substeps cost time, but the iteration is the same.
        static string BySubsteps(List<MethodRun> substeps, List<MethodRun> withGrid, string[] scenes)
        {
            var held = (from scene in scenes
                        let best = Best(substeps.Where(run => run.Scene == scene))
                        let grid = Best(withGrid.Where(run => run.Scene == scene))
                        where best != null && grid != null
                        select (Scene: scene, Times: best.Error / grid.Error)).ToList();
            return held.Count == 0 ? "" : $" Substeps without coarse solves hold the {List(held.Select(one => one.Scene))} too, with " +
                $"{Range(held.Select(one => one.Times))} times the C+.";
        }

        // "5 to 16".
        static string Range(IEnumerable<double> values)
        {
            string low = Figures.Fixed(values.Min(), 0), high = Figures.Fixed(values.Max(), 0);
            return low == high ? low : $"{low} to {high}";
        }

        static string OnTop(List<MethodRun> runs)
        {
            double[] gains = OnGrid(runs).Select(pair => pair.Jacobi.Error - pair.Other.Error).ToArray();
            return gains.Length == 0 ? "" : $" On top of them another iteration saves at most {Figures.Fixed(gains.Max() * 100, 2)} " +
                $"percentage points of C+.";
        }

        // "dam, column and tank".
        static string List(IEnumerable<string> names) => string.Join(", ", names.SkipLast(1)) + (names.Skip(1).Any() ? " and " : "") +
            names.LastOrDefault();

        // "dam 0 of 62; tank 20 of 62, best 0.03 % at 0.385 ms, noise 0.07 m/s".
        static string Held(List<MethodRun> runs, string[] scenes) => string.Join("; ", scenes.Select(scene =>
        {
            List<MethodRun> here = runs.Where(run => run.Scene == scene).ToList();
            return $"{here.Count(run => run.Holds)} of {here.Count} hold the {scene}" + (Best(here) is { } best
                ? $", best {Text(best)} ({best.Setting})" : "");
        }));

        static string Text(MethodRun run) => $"{Figures.Fixed(run.Error * 100, 2)} % with {Figures.Three(run.Noise)} m/s at " +
            $"{Figures.Three(run.Milliseconds)} ms";

        static MethodRun Best(IEnumerable<MethodRun> runs) => runs.Where(run => run.Holds && run.Milliseconds <= MaxTime).MinBy(run => run.Error);

        // "dam 0.25 % and 0.225 m/s, 0.12 % and 0.392 (Chebyshev, 1 x 4, ρ 0.9)", at the passes where it saves most.
        static string Gains(List<MethodRun> runs, string scene)
        {
            var pairs = OnGrid(runs).Where(pair => pair.Jacobi.Scene == scene).ToList();
            if (pairs.Count == 0)
                return "";
            (MethodRun jacobi, MethodRun other) = pairs.MaxBy(pair => pair.Jacobi.Error - pair.Other.Error);
            return $"{scene} {Figures.Fixed(jacobi.Error * 100, 2)} % and {Figures.Three(jacobi.Noise)} m/s, " +
                $"{Figures.Fixed(other.Error * 100, 2)} % and {Figures.Three(other.Noise)} ({other.Method}, {other.Setting})";
        }

        // Jacobi with the grid, and the other method with the least C+ at the same scene, substeps and passes.
        static IEnumerable<(MethodRun Jacobi, MethodRun Other)> OnGrid(List<MethodRun> runs)
            => from usual in runs
               where usual.HasGrid && usual.Method == MethodRun.Jacobi && usual.Holds && usual.Iterations >= SolverSettings.Default.iterations
               let other = Best(runs.Where(run => run.HasGrid && run.Method != MethodRun.Jacobi && run.Scene == usual.Scene
                   && run.SubstepCount == usual.SubstepCount && run.Iterations == usual.Iterations))
               where other != null
               orderby usual.Iterations
               select (usual, other);

        static bool IsDefault(MethodRun run) => run.HasGrid && run.Method == MethodRun.Jacobi
            && run.SubstepCount == SolverSettings.Default.substeps && run.Iterations == SolverSettings.Default.iterations;

        // The largest scene of the sweep of settings.
        static IEnumerable<string> Larger(ReportTable sweep)
        {
            List<SweepResult> all = SweepResult.All(sweep).ToList();
            if (all.Count == 0)
                yield break;
            string largest = all.MaxBy(result => result.Particles).SceneId;
            List<SweepResult> scene = all.Where(result => result.SceneId == largest).ToList(), plain = scene.Where(result
                => !result.Setting.Deep).ToList();
            string held = string.Join("; ", new[] { 2, SolverSettings.Default.iterations }
                .Select(k => scene.Find(r => r.Holds && r.Setting.Equals(new SweepSetting(true, 1, k)))).Where(r => r != null)
                .Select(r => $"{r.Setting.Substeps} x {r.Setting.Iterations} leave {Figures.Fixed(r.ErrorMoving * 100, 2)} % moving and " +
                $"{Figures.Fixed(r.ErrorSettled * 100, 2)} % settled in {Figures.Fixed(r.MillisecondsMoving, 2)} and " +
                    $"{Figures.Fixed(r.MillisecondsSettled, 2)} ms"));
            yield return $"{ErrorTimePage.Title(scene[0])}: with the grid {(held.Length > 0 ? held : "no such run holds")}; without it " +
                $"{plain.Count(r => r.Holds)} of {plain.Count} runs hold ({Device(sweep)}; [its " +
                    $"table](#{Anchor.Of(ErrorTimePage.Title(scene[0]))})).";
        }

        static string Device(ReportTable table) => table.MeasuredOn.Split(';')[0];

        static string Measured(ReportTable table) => $"The other figures: {Device(table)}, commit {LastCommit}; " +
            "[Methods](methods.md) has every study. Both cards are of data centers: [other cards](../Documentation~/cost.md) take longer.";

        static void WriteTable(ReportPage page, List<MethodRun> runs)
        {
            string[] scenes = runs.Select(run => run.Scene).Distinct().ToArray();
            page.Line($"The best of each method within {MaxTime:0} ms, by C+: C+, noise, ms a step (substeps x iterations, setting), " +
                "and how many of its runs hold. Settings: ρ is the spectral radius that Chebyshev assumes, *from* the first ω of a " +
                "schedule, *fraction* that of the neighbors' mean. Compare at equal passes: Jacobi with the grid was measured with 2, 4 and 8.");
            page.Line();
            page.Table(new[] { "method", "grid" }.Concat(scenes.Select(scene => SceneTitle(scene, runs))),
                from grid in new[] { false, true }
                from method in MethodRun.Methods
                where runs.Any(run => run.Method == method && run.HasGrid == grid)
                select new[] { method, grid ? "yes" : "no" }.Concat(scenes.Select(scene =>
                    Cell(runs.Where(run => run.Method == method && run.HasGrid == grid && run.Scene == scene).ToList()))));
        }

        static string Cell(List<MethodRun> runs)
        {
            string held = $"{runs.Count(run => run.Holds)} of {runs.Count}";
            return Best(runs) is { } best ? $"{Figures.Fixed(best.Error * 100, 2)} %, {Figures.Three(best.Noise)} m/s, " +
                $"{Figures.Three(best.Milliseconds)} ms ({best.Setting}); {held}"
                : runs.Any(run => run.Holds) ? $"over {MaxTime:0} ms; {held}" : $"**none**; {held}";
        }

        public static string SceneTitle(string scene, List<MethodRun> runs)
            => FormattableString.Invariant($"{scene}, {runs.First(run => run.Scene == scene).Particles:N0} particles");
    }
}
