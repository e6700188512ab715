using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report.ErrorTime
{
    /// <summary>The page's part on error against GPU time.</summary>
    static class ErrorTimePage
    {
        // C+ that a setting may be asked for.
        static readonly double[] Targets = { SweepResult.MaxError, 0.01, 0.005, 0.003 };

        public static void Write(ReportPage page, List<SweepResult> results, ReportTable table)
        {
            Introduce(page, table);
            List<List<SweepResult>> scenes = results.GroupBy(r => r.SceneId).Select(group => group.ToList()).ToList();
            Summarize(page, scenes);
            foreach (List<SweepResult> scene in scenes)
                WriteScene(page, scene, table.InSoftware);
        }

        static void Introduce(ReportPage page, ReportTable table)
        {
            page.Line("What a setting costs and what it leaves of error, over method (plain iterations, or with Deep Water on), " +
                "iterations, relaxation ω and substeps. " +
                $"C+ is the mean of max(0, ρ/ρ0 − 1) over 0.2 to 2 s (*moving*) and over the last 2 s (*settled*); time is the median " +
                $"of steps 20 to 60 (*moving*) and of the last 100 (*settled*). Plots and fronts take the worse window of both. " +
                "Noise is the rms speed of water that should stand still; where it still sloshes, jitter stands for it: the rms of " +
                "velocity minus the neighbors' mean.");
            page.Line();
            page.Line(FormattableString.Invariant(
                $"A setting *holds* if no particle is lost or escapes, the mean height never falls below {SweepResult.MinVolume} of that of ") +
                FormattableString.Invariant($"water at rest (*collapses*), energy never rises above {SweepResult.MaxEnergy} of the start's (*gains energy*), in runs of ") +
                FormattableString.Invariant($"{SweepResult.SettledAfter} s or more the volume ends below {SweepResult.MaxVolume} (*boils*), and C+ is at most ") +
                FormattableString.Invariant($"{SweepResult.MaxError * 100:0} % (*is too dense*). The front is of those that hold: none is both cheaper and nearer to rest ") +
                "density. Its settings are in front.csv.");
            page.Line();
            if (table.InSoftware)
            {
                page.Line("**Times are of a CPU: they show that the sweep works and say nothing about a GPU, so who wins at which time " +
                    "is not concluded here.**");
                page.Line();
            }
        }

        static void Summarize(ReportPage page, List<List<SweepResult>> scenes)
        {
            page.Line("The cheapest setting of each method that holds, by the C+ (worse window) that it may leave; ms a step, substeps " +
                "x iterations, ω where it is not " + FormattableString.Invariant($"{SweepSetting.UsualRelaxation}") + ":");
            page.Line();
            page.Table(new[] { "scene", "method" }.Concat(Targets.Select(target => FormattableString.Invariant($"C+ ≤ {target * 100:0.#} %"))),
                from scene in scenes
                from deep in new[] { false, true }
                select new[] { Title(scene[0]),
                    SweepSetting.Method(deep) }.Concat(Targets.Select(target => Cheapest(scene, deep, target) is { } best
                    ? FormattableString.Invariant($"{best.Milliseconds:0.000} ({Short(best.Setting)})") : "–")));
        }

        static void WriteScene(ReportPage page, List<SweepResult> scene, bool inSoftware)
        {
            SweepResult first = scene[0];
            List<SweepResult> front = SweepResult.FrontOf(scene);
            page.Heading(Title(first));
            page.Plot("error-time-" + first.SceneId,
                $"{Title(first)}: C+ and {UnrestName(first)} against milliseconds, plain and deep water, with the Pareto front",
                ErrorTimePlot.Script(scene, front, UnrestName(first)), 1200, 440);
            page.Line(Held(scene));
            page.Line();
            if (front.Count == 0)
                return;
            if (!inSoftware)
            {
                page.Line(Winner(scene, front));
                page.Line();
            }
        }

        // "24 settings of 34 hold; of the plain ones 8 collapse (...)."
        static string Held(List<SweepResult> scene)
        {
            string text = $"{scene.Count(r => r.Holds)} of {scene.Count} settings hold: " +
                $"{string.Join(" and ", new[] { false, true }.Select(deep => $"{scene.Count(r => r.Holds && r.Setting.Deep == deep)} of {scene.Count(r => r.Setting.Deep == deep)} {SweepSetting.Method(deep)}"))}.";
            foreach (IGrouping<string, SweepResult> fault in scene.Where(r => !r.Holds).GroupBy(r => r.Fault))
            {
                IEnumerable<string> methods = from method in fault.GroupBy(r => r.Setting.Deep)
                                              select $"{SweepSetting.Method(method.Key)} {string.Join(", ", method.Select(r => Short(r.Setting)))}";
                text += $" What {fault.Key}: {string.Join("; ", methods)}.";
            }
            SweepResult cut = scene.Find(r => r.Seconds < scene.Max(other => other.Seconds) - 0.1);
            if (cut != null)
                text += FormattableString.Invariant(
                    $" ({cut.Setting} was run for {cut.Seconds:0.#} s only: its steps take {cut.Milliseconds:0.0} ms.)");
            List<SweepResult> overflowed = scene.Where(r => r.Overflow > 0).ToList();
            if (overflowed.Count > 0)
                text += FormattableString.Invariant(
                    $" Neighbor lists overflowed in {overflowed.Count} runs, for up to {overflowed.Max(r => r.Overflow):N0} particles ") +
                    FormattableString.Invariant($"({overflowed.MaxBy(r => r.Overflow).Setting}).");
            return text
                + $" Memory: {string.Join(" and ", scene.GroupBy(r => r.Setting.Deep).Select(method => FormattableString.Invariant($"{method.Max(r => r.Bytes):0} bytes a particle {SweepSetting.Method(method.Key)}")))}.";
        }

        static string Winner(List<SweepResult> scene, List<SweepResult> front)
        {
            int deep = front.Count(r => r.Setting.Deep);
            string text = deep == front.Count ? "Deep water wins at every time" : deep == 0 ? "Plain wins at every time"
                : $"{deep} of the front's {front.Count} settings have deep water on";
            SweepResult best = front[^1];
            text += FormattableString.Invariant(
                $": from {front[0].Error * 100:0.00} % at {front[0].Milliseconds:0.000} ms ({front[0].Setting}) to {best.Error * 100:0.00} % ") +
                FormattableString.Invariant($"at {best.Milliseconds:0.000} ms ({best.Setting}).");
            if (deep > 0 && deep < front.Count)
                text += string.Concat(new[] { false, true }.Select(method => CheaperAt(scene, method)));
            SweepResult other = Pareto.Front(scene.Where(r => r.Holds && r.Setting.Deep != best.Setting.Deep), r => r.Milliseconds,
                r => r.Error).LastOrDefault();
            string name = SweepSetting.Method(!best.Setting.Deep);
            return text + (other == null ? $" No {name} setting holds this scene."
                : FormattableString.Invariant(
                $" The least that {name} reaches is {other.Error * 100:0.00} % at {other.Milliseconds:0.000} ms ({other.Setting})."));
        }

        // " Plain is the cheaper one for C+ ≤ 3, 1 %."
        static string CheaperAt(List<SweepResult> scene, bool deep)
        {
            double Cost(bool method, double target) => Cheapest(scene, method, target)?.Milliseconds ?? double.PositiveInfinity;
            string[] targets = Targets.Where(target => Cost(deep, target) < Cost(!deep, target))
                .Select(target => FormattableString.Invariant($"{target * 100:0.#}")).ToArray();
            return targets.Length == 0 ? "" : $" For C+ ≤ {string.Join(", ", targets)} % {SweepSetting.Method(deep)} is cheaper.";
        }

        static SweepResult Cheapest(List<SweepResult> scene, bool deep, double target)
            => scene.Where(r => r.Holds && r.Setting.Deep == deep && r.Error <= target).MinBy(r => r.Milliseconds);

        public static string Title(SweepResult r)
            => FormattableString.Invariant(
            $"{char.ToUpperInvariant(r.Scene[0])}{r.Scene[1..]}, {r.Particles:N0} ") +
            FormattableString.Invariant($"particles{(r.Scene == "drop" ? " onto a pool of" : "")}{(r.Scene == "drop" ? "" : ",")} {r.Layers} layers");

        static string UnrestName(SweepResult r) => r.IsStill ? "noise" : "jitter";

        // "1 x 4 ω 1.2"; without ω where it is the usual one.
        static string Short(SweepSetting setting) => $"{setting.Substeps} x {setting.Iterations}" +
            (setting.Relaxation == SweepSetting.UsualRelaxation ? "" : FormattableString.Invariant($" ω {setting.Relaxation}"));
    }
}
