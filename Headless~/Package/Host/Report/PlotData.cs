using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Host.Report
{
    /// <summary>Series of a plot, as blocks of data within gnuplot's script.</summary>
    sealed class PlotData
    {
        readonly StringBuilder blocks = new();
        readonly List<string> parts = new();
        int count;

        /// <summary>A series; one without points is left out, because gnuplot takes it for a mistake.</summary>
        /// <param name="style">What follows the data in gnuplot's plot command: "using 1:2 with lines title 'x'".</param>
        public PlotData Add(string style, IEnumerable<object[]> points)
        {
            List<object[]> rows = points.ToList();
            if (rows.Count == 0)
                return this;
            string name = "$d" + count++;
            blocks.AppendLine(name + " << EOD");
            foreach (object[] row in rows)
                blocks.AppendLine(string.Join(",", row.Select(value => string.Create(CultureInfo.InvariantCulture, $"{value}"))));
            blocks.AppendLine("EOD");
            parts.Add(name + " " + style);
            return this;
        }

        /// <summary>The blocks, and after <paramref name="before"/> the plot command; an axis without any point is labeled as such.</summary>
        public string Script(string before) => blocks + before.TrimEnd('\n') + "\n" +
            (parts.Count > 0 ? "plot " + string.Join(", ", parts) : "unset logscale\nset label 1 'no values' at graph 0.5,0.5 " +
            "center\nset xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\nunset label 1") + "\n";
    }
}
