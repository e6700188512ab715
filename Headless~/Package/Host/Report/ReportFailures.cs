using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Host.Manual;

namespace Host.Report
{
    /// <summary>Failures in the report's tables, gathered from their cells, so that the page can begin with it.</summary>
    sealed class ReportFailures
    {
        /// <summary>The column that tells runs with deep water from those without.</summary>
        public const string DeepWater = "deep water";

        readonly List<string[]> found = new();

        public static readonly string[] Columns = { "section", "what", DeepWater, "fails", "worst figure, or what fails" };

        public IReadOnlyList<string[]> Rows => found;

        /// <summary>Takes what a table says. A column of verdicts judges the column before it; one without a name judges the whole row.</summary>
        public void Add(string section, string heading, string[] columns, IReadOnlyList<string[]> rows)
        {
            for (int column = 1; column < columns.Length; column++)
            {
                if (!rows.Any(row => Verdict.IsFailure(row[column])))
                    continue;
                string where = $"[{section}](#{Anchor.Of(section)})";
                if (columns[column].Length == 0)
                    AddRuns(where, rows.Where(row => Verdict.IsFailure(row[column])).ToList(), column);
                else
                    AddColumn(where, heading, columns, rows, column);
            }
        }

        // Cases that are judged as a whole: the case, its setting and what of it fails.
        void AddRuns(string where, List<string[]> rows, int column)
        {
            foreach (string[] row in rows)
                found.Add(new[] { where, row[0], row[1].Replace(DeepWater + " ", ""), "1 of 1", Verdict.Reason(row[column]) });
        }

        void AddColumn(string where, string heading, string[] columns, IReadOnlyList<string[]> rows, int column)
        {
            int deep = Array.IndexOf(columns, DeepWater);
            foreach (IGrouping<string, string[]> group in rows.GroupBy(row => deep < 0 ? "on" : row[deep]))
            {
                List<string[]> judged = group.Where(row => Verdict.IsVerdict(row[column])).ToList();
                List<string[]> failed = judged.Where(row => Verdict.IsFailure(row[column])).ToList();
                if (failed.Count > 0)
                    found.Add(new[] { where, $"{heading}: {columns[column - 1]}, {columns[column]}", group.Key,
                        $"{failed.Count} of {judged.Count}", failed.MaxBy(row => Size(row[column - 1]))[column - 1] });
            }
        }

        static double Size(string figure) =>
            double.TryParse(figure.TrimEnd('%', ' '), NumberStyles.Float, CultureInfo.InvariantCulture, out double value) ? Math.Abs(value) : 0;
    }
}
