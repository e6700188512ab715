using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report.Methods
{
    /// <summary>C+ against milliseconds, a panel a scene: what holds by method, what does not as crosses, and the default.</summary>
    static class MethodsPlot
    {
        // %: of the axis. What leaves more or less lies on its edge.
        const double Low = 0.001, High = 100;
        const double Left = 0.05, Right = 0.16, Gap = 0.045;

        public const int Width = 1400, Height = 480;

        public static string Script(List<MethodRun> runs, Func<MethodRun, bool> isDefault)
        {
            List<IGrouping<string, MethodRun>> scenes = runs.GroupBy(run => run.Scene).ToList();
            List<double> held = runs.Where(run => run.Holds).Select(run => run.Milliseconds).ToList();
            double width = (1 - Left - Right) / scenes.Count, slowest = held.DefaultIfEmpty(1).Max() * 1.7;
            string script = "set multiplot\nset format '%g'\n", x = LogAxis.Script("x", held);
            for (int i = 0; i < scenes.Count; i++)
            {
                double left = Left + i * width;
                string margins = FormattableString.Invariant($"set lmargin at screen {left:0.####}\nset rmargin at screen ") +
                    FormattableString.Invariant($"{left + width - Gap:0.####}\n");
                script += Panel(scenes[i].ToList(), isDefault, slowest, i == 0, x + margins +
                    $"set title \"{MethodsSection.SceneTitle(scenes[i].Key, runs)}\" noenhanced\n" +
                    (i == 0 ? "set ylabel 'C+ (%)'\nset key at screen 0.995,0.93 right top vertical noenhanced\n" : "set ylabel ''\nset key off\n"));
            }
            return script + "unset multiplot\n";
        }

        static string Panel(List<MethodRun> runs, Func<MethodRun, bool> isDefault, double slowest, bool hasKey, string before)
        {
            IEnumerable<object[]> Points(IEnumerable<MethodRun> of) => from run in of
                                                                       where !double.IsNaN(run.Milliseconds)
                                                                       select new object[] { Math.Min(run.Milliseconds, slowest),
                                                                           double.IsNaN(run.Error) ? High : Math.Clamp(run.Error * 100, Low, High) };
            var data = new PlotData().Add("using 1:2 with points pt 2 ps 0.7 lc rgb '#b0b0b0' title 'does not hold'", Points(runs
                .Where(run => !run.Holds)));
            string[] methods = MethodRun.Methods.ToArray();
            for (int i = 0; i < methods.Length; i++)
                foreach (bool grid in new[] { false, true })
                    data.Add($"using 1:2 with points ls {i + 1} pt {(grid ? 7 : 6)} ps 1 lw 1.6 notitle",
                        Points(runs.Where(run => run.Holds && run.Method == methods[i] && run.HasGrid == grid)));
            data.Add("using 1:2 with points pt 3 ps 2.2 lw 2 lc rgb '#101010' title 'the default'", Points(runs.Where(isDefault)));
            // Methods in the key whether or not one holds the first scene.
            string key = !hasKey ? "" : ", NaN with points pt 7 lc rgb '#606060' title 'filled: two coarse solves'" +
                ", NaN with points pt 6 lc rgb '#606060' title 'open: without'" +
                string.Concat(methods.Select((method, i) => $", NaN with points ls {i + 1} pt 7 title \"{method}\""));
            return data.Script(FormattableString.Invariant($"set logscale y\nset yrange [{Low}:{High}]\nset ytics ({Low}, 0.01, 0.1, ") +
                FormattableString.Invariant($"1, 10, {High})\n") +
                FormattableString.Invariant($"set xlabel 'ms a step'\nset object 1 rectangle from {MethodsSection.MinTime},graph 0 to ") +
                    FormattableString.Invariant($"{MethodsSection.MaxTime},graph 1 ") +
                "fc rgb '#f3ecd8' fs solid noborder behind\nset label 1 '2 to 3 ms' at 2.45,graph 0.03 rotate by 90 left font ',8' tc " +
                    "rgb '#907840'\n" +
                before).TrimEnd('\n') + key + "\n";
        }
    }
}
