using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace Host.Output
{
    /// <summary>Columns of the statistics over time in one picture, drawn by gnuplot.</summary>
    sealed record Plot(string File, string Title, string Label, params string[] Columns)
    {
        public bool Logarithmic { get; init; }

        /// <summary>Draws to File.png in a folder that holds statistics.csv.</summary>
        public void Draw(string folder, Statistics statistics, string timeColumn)
        {
            int time = statistics.IndexOf(timeColumn) + 1;
            string csv = Path.Combine(folder, "statistics.csv");
            // A logarithmic axis has no zero; gnuplot leaves such points out but refuses an axis without any.
            string[] drawn = Columns.Where(column => statistics.Known(column).Any(value => !Logarithmic || value > 0)).ToArray();

            var script = new StringBuilder();
            script.AppendLine("set terminal pngcairo size 960,420 font 'DejaVu Sans,10'");
            script.AppendLine($"set output {Quote(Path.Combine(folder, File + ".png"))}");
            script.AppendLine("set datafile separator ','");
            script.AppendLine("set datafile missing ''");
            script.AppendLine("set grid lc rgb '#d8d8d8'");
            script.AppendLine("set border 3 lc rgb '#606060'");
            script.AppendLine("set tics nomirror");
            script.AppendLine($"set title {Quote(Title)} noenhanced");
            script.AppendLine("set xlabel 'time (s)'");
            script.AppendLine($"set ylabel {Quote(Label)} noenhanced");
            script.AppendLine("set key outside right top noenhanced");
            if (Logarithmic && drawn.Length > 0)
                script.AppendLine("set logscale y");
            if (drawn.Length == 0)
                script.AppendLine("set label 'no values' at graph 0.5,0.5 center\nset xrange [0:1]\nset yrange [0:1]\nplot NaN notitle");
            else
                script.AppendLine("plot " + string.Join(", ", drawn.Select((column, i) =>
                    $"{Quote(csv)} using {time}:{statistics.IndexOf(column) + 1} every ::1 with lines lw 1.5 lc rgb " +
                    $"'{Colors[i % Colors.Length]}' title {Quote(column)}")));
            Tool.Gnuplot.Run(Array.Empty<string>(), script.ToString());
        }

        static readonly string[] Colors = { "#1f6fb4", "#d1602b", "#3a9a4b", "#8a55a3", "#5c5c5c", "#c2a52a" };

        static string Quote(string text) => "'" + text.Replace("'", "''") + "'";
    }
}
