using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Host.Output;

namespace Host.Report
{
    /// <summary>A page of Markdown with plots beside it, written from the report's tables.</summary>
    sealed class ReportPage
    {
        readonly string dataFolder, imageFolder, imageLink;
        readonly StringBuilder text = new();
        readonly List<string> tables = new();
        string section = "", heading = "";

        /// <param name="imageLink">From the page to the folder of images.</param>
        public ReportPage(string dataFolder, string imageFolder, string imageLink)
        {
            this.dataFolder = dataFolder;
            this.imageFolder = imageFolder;
            this.imageLink = imageLink;
            Directory.CreateDirectory(imageFolder);
        }

        public override string ToString() => text.ToString();

        /// <summary>Failures in the tables so far.</summary>
        public ReportFailures Failures { get; } = new();

        /// <summary>Names of all tables that were asked for.</summary>
        public IReadOnlyList<string> Tables => tables.Distinct().ToList();

        public ReportTable Load(string name) => ReportTable.Load(DataFile(name));

        /// <summary>Path of a table's CSV file, for plots.</summary>
        public string DataFile(string name)
        {
            tables.Add(name);
            return Path.GetFullPath(Path.Combine(dataFolder, name + ".csv"));
        }

        /// <summary>A section under its heading, with links to its tables.</summary>
        public void Section(ReportSection section)
        {
            Line();
            this.section = heading = section.Title;
            Line("## " + section.Title);
            Line();
            int before = tables.Count;
            section.Write(this);
            string[] used = tables.Skip(before).Distinct().ToArray();
            if (used.Length > 0)
                Line("Tables: " + string.Join(", ", used.Select(name => $"[{name}.csv]({ReportFolders.DataLink}/{name}.csv)")) + ".");
        }

        public void Line(string line = "") => text.Append(line).Append('\n');

        /// <summary>A heading within a section.</summary>
        public void Heading(string title)
        {
            heading = title;
            Line("### " + title);
            Line();
        }

        public void Table(IEnumerable<string> columns, IEnumerable<IEnumerable<string>> rows) => Table(columns, rows, _ => true);

        /// <summary>A table of what is to be seen first. Rows that fail are shown as well; the others are in the CSV alone, and counted.</summary>
        /// <param name="isShown">By the row's index.</param>
        public void Table(IEnumerable<string> columns, IEnumerable<IEnumerable<string>> rows, Func<int, bool> isShown)
        {
            string[] names = columns.ToArray();
            List<string[]> cells = rows.Select(row => row.ToArray()).ToList(),
                shown = cells.Where((row, i) => isShown(i) || row.Any(Verdict.IsFailure)).ToList();
            Line("| " + string.Join(" | ", names) + " |");
            Line("|" + string.Concat(names.Select(_ => " --- |")));
            foreach (string[] row in shown)
                Line("| " + string.Join(" | ", row) + " |");
            Line();
            if (shown.Count < cells.Count)
            {
                Line($"{cells.Count - shown.Count} of {cells.Count} rows are in the table below only; none of them misses a bar.");
                Line();
            }
            Failures.Add(section, heading, names, cells);
        }

        /// <summary>Rows that are listed among what fails, and nowhere else on the page.</summary>
        public void ListFailures(string[] columns, IEnumerable<string[]> rows) => Failures.Add(section, heading, columns, rows.ToList());

        /// <summary>Draws by gnuplot and shows the picture.</summary>
        /// <param name="name">Of the file.</param>
        /// <param name="alt">What can be seen.</param>
        /// <param name="script">After terminal, output, separator, grid and colors (line styles 1 to 8) are set.</param>
        public void Plot(string name, string alt, string script, int width = 900, int height = 420)
        {
            string file = name + ".png";
            var all = new StringBuilder();
            all.AppendLine($"set terminal pngcairo size {width},{height} font 'DejaVu Sans,10'");
            all.AppendLine($"set output '{Path.Combine(imageFolder, file)}'");
            all.AppendLine("set datafile separator ','\nset datafile commentschars '#'\nset datafile missing ''\nset encoding utf8");
            all.AppendLine("set grid lt 1 lc rgb '#e4e4e4'\nset border 3 lc rgb '#606060'\nset tics nomirror\nset key outside right top noenhanced");
            string[] colors = { "#1f6fb4", "#d1602b", "#3a9a4b", "#8a55a3", "#5c5c5c", "#c2a52a", "#2aa9a9", "#b23a5b" };
            for (int i = 0; i < colors.Length; i++)
                all.AppendLine($"set style line {i + 1} lc rgb '{colors[i]}' lw 1.6 pt {new[] { 7, 5, 9, 11, 13, 4, 6, 8 }[i]} ps 0.9");
            all.Append(script);
            Tool.Gnuplot.Run(Enumerable.Empty<string>(), all.ToString());
            Line($"![{alt}]({imageLink}/{file})");
            Line();
        }
    }
}
