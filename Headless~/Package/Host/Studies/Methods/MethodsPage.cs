using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Host.Report;

namespace Host.Studies.Methods
{
    /// <summary>The page of the method study, from its table alone.</summary>
    sealed partial class MethodsPage
    {
        readonly ReportPage page;
        readonly ReportTable table;
        readonly List<ReportTable.Row> rows;
        readonly string[] scenes;
        readonly bool timed;

        public MethodsPage(ReportPage page, ReportTable table)
        {
            this.page = page;
            this.table = table;
            rows = table.Rows.ToList();
            scenes = rows.Select(row => row["scene"]).Distinct().ToArray();
            timed = !table.MeasuredOn.Contains(MethodsSection.Quick);
        }

        public void Write()
        {
            page.Line("Each method runs in the same scenes with the same settings but for what is varied. *C+* is the mean of max(0, " +
                "ρ/ρ0 − 1): over 0.2 to 2 s of");
            page.Line("the dam, over the last 2 s elsewhere. *Noise* is the rms speed of water that should stand still; in the dam it " +
                "is the jitter. A run has");
            page.Line("*diverged* where the energy of the closed scene rose by more than 5 % above its start, *collapsed* below 0.9 of " +
                "its volume, *boiled* (still");
            page.Line($"water) above 1.1; broken-off runs are marked by crosses. Cost is " +
                $"{(timed ? "the median GPU time of a step" : "the number of passes over the neighbors: these are small scenes on a CPU whose times say nothing")}.");
            page.Line("Relaxation is not clamped here.");
            page.Line();
            page.Line("Measured on " + table.MeasuredOn + ".");
            page.Line();
            foreach (MethodStudy study in MethodStudies.All(!timed))
                WriteStudy(study);
            WriteVerdicts();
        }

        void WriteStudy(MethodStudy study)
        {
            List<ReportTable.Row> here = rows.Where(row => row["study"] == study.Name).ToList();
            if (here.Count == 0)
                return;
            page.Heading(study.Title);
            page.Plot("methods-" + study.Name, $"{study.Title}: density error, noise and cost against {study.Axis}", Script(study, here),
                1300, 250 * scenes.Length + 40);
        }

        // A row of panels for each scene: error, noise, cost; a curve for each series, a cross for what did not stand.
        string Script(MethodStudy study, List<ReportTable.Row> here)
        {
            string[] series = here.Select(row => row["series"]).Distinct().ToArray();
            var script = new StringBuilder();
            for (int scene = 0; scene < scenes.Length; scene++)
                for (int s = 0; s < series.Length; s++)
                {
                    script.AppendLine($"$d{scene}_{s} << EOD");
                    foreach (ReportTable.Row row in here.Where(row => row["scene"] == scenes[scene] && row["series"] == series[s])
                        .OrderBy(row => row.Number("value")))
                        script.AppendLine(string.Join(",", new[] { row.Number("value"), 100 * Error(row), Noise(row), Cost(row), Stands(row)
                            ? 1 : 0 }.Select(Plain)));
                    script.AppendLine("EOD");
                }
            script.AppendLine($"set multiplot layout {scenes.Length},4");
            script.AppendLine("unset key");
            script.AppendLine("set offsets graph 0.05, graph 0.05, 0, 0");
            for (int scene = 0; scene < scenes.Length; scene++)
            {
                for (int panel = 0; panel < 3; panel++)
                {
                    script.AppendLine(
                        $"set title {Quote($"{scenes[scene]}: {new[] { "C+ (%)", "noise (m/s)", timed ? "ms a step" : "passes" }[panel]}")} noenhanced");
                    script.AppendLine($"set xlabel {Quote(study.Axis)}");
                    if (study.Logarithmic)
                        script.AppendLine("set logscale x");
                    script.AppendLine(study.Alike ? "set yrange [0:*]" : "set logscale y");
                    int column = 2 + panel;
                    script.AppendLine("plot " + string.Join(", ", series.SelectMany((_, s) => new[]
                    {
                        $"$d{scene}_{s} using 1:($5>0?${column}:NaN) with linespoints ls {s % 8 + 1}",
                        $"$d{scene}_{s} using 1:($5>0?NaN:${column}) with points ls {s % 8 + 1} pt 2",
                    })));
                }
                script.AppendLine(scene < scenes.Length - 1 ? "set multiplot next" : Names(series));
            }
            script.AppendLine("unset multiplot");
            return script.ToString();
        }

        // A panel of its own for the names of the curves: they are long, and anywhere else they lie on the curves.
        static string Names(string[] series) => string.Join('\n', "unset logscale; unset border; unset tics; unset title; unset xlabel; unset grid",
            "set key at graph -0.1,1 left top Left reverse samplen 1 font ',9' noenhanced",
            "plot [0:1] [0:1] " + string.Join(", ", series.Select((name, s) => $"NaN with linespoints ls {s % 8 + 1} title {Quote(name)}")
                .Append("NaN with points pt 2 lc rgb '#606060' title 'does not stand'")));

        static string Quote(string text) => "'" + text.Replace("'", "''") + "'";

        static bool IsFlowing(ReportTable.Row row) => row["scene"] == "dam";

        static double Error(ReportTable.Row row)
        {
            double moving = row.Number("error_moving");
            return IsFlowing(row) && !double.IsNaN(moving) ? moving : row.Number("error_settled");
        }

        static double Noise(ReportTable.Row row) => row.Number(IsFlowing(row) ? "jitter" : "speed");

        double Cost(ReportTable.Row row)
        {
            if (!timed)
                return row.Number("passes");
            double first = row.Number(IsFlowing(row) ? "ms_moving" : "ms_settled");
            return double.IsNaN(first) ? row.Number(IsFlowing(row) ? "ms_settled" : "ms_moving") : first;
        }

        static bool Stands(ReportTable.Row row) => row["state"] == "stands";

        // A logarithmic axis has no place for the others; gnuplot leaves out what is not there.
        static string Plain(double value) => double.IsFinite(value) && value >= 0 ? value.ToString("G6", CultureInfo.InvariantCulture) : "";
    }
}
