using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Host.Report.ErrorTime
{
    /// <summary>The report's first picture: for each scene what the settings of both methods that hold cost and leave of error, and where
    /// the default is.</summary>
    static class ErrorTimeOverview
    {
        const int Across = 3;
        // Margins of the whole picture, between the panels' borders.
        const double Left = 0.065, Bottom = 0.05, Gap = 0.05, Top = 0.06;

        public const int Width = 1200, Height = 640;

        /// <summary>Gnuplot's script; all panels have the same axes.</summary>
        /// <param name="usual">What a scene runs with when nothing is set; null where that is not known.</param>
        public static string Script(IReadOnlyList<SweepResult> results, Func<SweepResult, SweepSetting?> usual)
        {
            List<SweepResult> held = results.Where(result => result.Holds && result.Error > 0).ToList();
            List<IGrouping<string, SweepResult>> scenes = results.GroupBy(result => result.SceneId).ToList();
            string axes = LogAxis.Script("x", held.Select(result => result.Milliseconds))
                + LogAxis.Script("y", held.Select(result => result.Error * 100));
            var script = new StringBuilder("set multiplot\nset format '%g'\n");
            for (int i = 0; i < scenes.Count; i++)
                script.Append(Panel(scenes[i].ToList(), usual(scenes[i].First()), axes, i, scenes.Count));
            return script.Append("unset multiplot\n").ToString();
        }

        static string Panel(List<SweepResult> scene, SweepSetting? usual, string axes, int index, int count)
        {
            int rows = (count + Across - 1) / Across, column = index % Across, row = index / Across;
            double width = (1 - Left) / Across, height = (1 - Bottom) / rows;
            double left = Left + column * width, top = 1 - row * height;
            string position = FormattableString.Invariant(
                $"set lmargin at screen {left:0.####}\nset rmargin at screen {left + width - Gap:0.####}\nset tmargin at screen ") +
                FormattableString.Invariant($"{top - Top:0.####}\nset bmargin at screen {top - height + Gap:0.####}\n");
            bool isLast = index + Across >= count;
            var data = new PlotData();
            foreach (bool deep in new[] { false, true })
            {
                List<SweepResult> settings = scene.Where(result => result.Holds && result.Error > 0 && result.Setting.Deep == deep).ToList();
                int style = deep ? 1 : 2;
                string name = SweepSetting.Method(deep);
                data.Add($"using 1:2 with lines ls {style} title '{name}: best for its time'",
                    Points(Pareto.Front(settings, r => r.Milliseconds, r => r.Error)));
                data.Add($"using 1:2 with points ls {style} ps 0.7 title '{name}: a setting'", Points(settings));
            }
            data.Add("using 1:2 with points pt 3 ps 2.2 lw 2 lc rgb '#101010' title 'the default'",
                Points(scene.Where(result => result.Holds && result.Setting == usual)));
            string key = index == count - 1 && count % Across != 0
                ? FormattableString.Invariant(
                $"set key at screen {left + width + 0.02:0.###},{top - Top - 0.05:0.###} left top vertical noenhanced reverse Left\n")
                : "set key off\n";
            return data.Script(axes + position + key + $"set title \"{ErrorTimePage.Title(scene[0])}\" noenhanced\nset xlabel " +
                $"'{(isLast ? "ms a step" : "")}'\nset ylabel '{(column == 0 ? "C+, %" : "")}'\n");
        }

        static IEnumerable<object[]> Points(IEnumerable<SweepResult> results)
            => results.Select(result => new object[] { result.Milliseconds, result.Error * 100 });
    }
}
