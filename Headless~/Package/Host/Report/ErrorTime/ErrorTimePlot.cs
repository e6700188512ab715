using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Host.Report.ErrorTime
{
    /// <summary>Two panels over milliseconds: C+ with its front, and unrest with its own.</summary>
    static class ErrorTimePlot
    {
        // One for both panels, right of them.
        const string Key = "set key at screen 0.99,0.9 right top vertical noenhanced";

        public static string Script(List<SweepResult> scene, List<SweepResult> front, string unrest) =>
            "set multiplot\n" +
            Panel(scene, front, "C+, worse window (%)", r => r.Error * 100, 0.06, Key) +
            Panel(scene, Pareto.Front(scene.Where(r => r.Holds), r => r.Milliseconds, r => r.Unrest), unrest + ", last 2 s (m/s)",
            r => r.Unrest, 0.47, "set key off") +
            "unset multiplot\n";

        static string Panel(List<SweepResult> all, List<SweepResult> front, string label, Func<SweepResult, double> value, double left, string key)
        {
            List<SweepResult> scene = Within(Within(all, r => r.Milliseconds), value);
            string off = scene.Count < all.Count ? $"; {all.Count - scene.Count} far worse off the plot" : "";
            object[] Point(SweepResult r) => new object[] { r.Milliseconds, value(r) };
            // A logarithmic axis has no place for zero.
            IEnumerable<object[]> Points(Func<SweepResult, bool> which) => scene.Where(r => which(r) && value(r) > 0).Select(Point);
            return new PlotData()
                .Add("using 1:2 with lines lc rgb '#303030' dt 2 lw 1.2 title 'Pareto front'", front.Where(r => value(r) > 0).Select(Point))
                .Add("using 1:2 with points ls 2 title 'plain'", Points(r => r.Holds && !r.Setting.Deep))
                .Add("using 1:2 with points ls 1 title 'deep water'", Points(r => r.Holds && r.Setting.Deep))
                .Add("using 1:2 with points pt 5 ps 0.6 lc rgb '#e6b8a0' title 'plain, does not hold'", Points(r => !r.Holds && !r.Setting.Deep))
                .Add("using 1:2 with points pt 7 ps 0.6 lc rgb '#a9c9e2' title 'deep water, does not hold'", Points(r => !r.Holds && r.Setting.Deep))
                .Add("using 1:2:3 with labels font ',8' left offset 0.6,0.5 notitle",
                    front.Where(r => value(r) > 0)
                    .Select(r => new object[] { r.Milliseconds, value(r), $"{r.Setting.Substeps}x{r.Setting.Iterations}" }))
                .Script(LogAxis.Script("x", scene.Select(r => r.Milliseconds)) + LogAxis.Script("y", scene.Select(value)) +
                    $"set xlabel 'ms a step, more expensive window{off}'\nset ylabel '{label}'\nset format '%g'\nset lmargin at screen " +
                    $"{left.ToString(CultureInfo.InvariantCulture)}\nset rmargin at screen " +
                    $"{(left + 0.33).ToString(CultureInfo.InvariantCulture)}\n{key}\n");
        }

        // Without those that hold nothing and are so far beyond the rest that it would shrink to a dot.
        static List<SweepResult> Within(List<SweepResult> scene, Func<SweepResult, double> value)
        {
            const double farBeyond = 20;
            double limit = scene.Where(r => r.Holds).Select(value).DefaultIfEmpty(double.PositiveInfinity).Max() * farBeyond;
            return scene.Where(r => r.Holds || value(r) <= limit).ToList();
        }
    }
}
