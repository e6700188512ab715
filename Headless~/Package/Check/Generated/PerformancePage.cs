using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Host.Check
{
    /// <summary>The page about performance, with the table of what fields add to a step between its marks. `rill bench fields --page`
    /// measures its figures and stores them as a CSV file, whose first line says on what.</summary>
    sealed class PerformancePage : MarkedPage
    {
        public const string Figures = "Research~/data/field-costs.csv";
        /// <summary>Field of the rows that the others are compared with.</summary>
        public const string Defaults = "Defaults";

        public static readonly string[] Columns = { "particles", "field", "median_ms", "p10_ms", "p90_ms", "steps", "bytes" };

        public override string Path => "Research~/performance.md";

        protected override string Part => "fields";

        protected override bool HasSources(PackageTree package) => package.Has(Figures);

        protected override string TextOfPart(PackageTree package, Findings findings)
        {
            string[] lines = package.Read(Figures).Replace("\r\n", "\n").Split('\n', StringSplitOptions.RemoveEmptyEntries);
            string[] table = lines.Where(line => line[0] != '#').ToArray();
            List<string[]> rows = table.Skip(1).Select(line => line.Split(',')).ToList();
            bool isWhole = lines.Length > table.Length && table.FirstOrDefault() == string.Join(",", Columns)
                && rows.All(row => row.Length == Columns.Length);
            List<string> sizes = rows.Select(row => row[0]).Distinct().OrderBy(Number).ToList();
            if (!isWhole || rows.Count == 0 || !sizes.All(size => rows.Any(row => row[0] == size && row[1] == Defaults)))
            {
                findings.Fault($"{Figures} is not a line '# device; settings', a line '{string.Join(",", Columns)}' and rows, with a row " +
                    $"'{Defaults}' for each number of particles: measure it again by `Headless~/rill bench fields --page`.");
                return null;
            }
            var text = new StringBuilder($"{lines[0].TrimStart('#').Trim()}: median ms of a step (10th to 90th percentile), and how much " +
                "more that is than with the defaults. By `rill bench fields --page`, from [field-costs.csv](data/field-costs.csv).\n\n| |");
            foreach (string size in sizes)
                text.Append(CultureInfo.InvariantCulture, $" {Number(size):N0} particles | more |");
            text.Append(" bytes a particle |\n| --- |").Insert(text.Length, " --- | --- |", sizes.Count).Append(" --- |\n");
            foreach (IGrouping<string, string[]> field in rows.GroupBy(row => row[1]))
            {
                text.Append($"| {field.Key} |");
                foreach (string size in sizes)
                {
                    string[] row = field.FirstOrDefault(row => row[0] == size);
                    double defaults = Number(rows.First(other => other[0] == size && other[1] == Defaults)[2]);
                    text.Append(row == null ? " – | – |" : string.Create(CultureInfo.InvariantCulture,
                        $" {Number(row[2]):G3} ({Number(row[3]):G3} to {Number(row[4]):G3}) | {Number(row[2]) - defaults:+0.000;-0.000;0} |"));
                }
                text.Append($" {string.Join(", ", field.Select(row => row[6]).Distinct())} |\n");
            }
            return text.ToString();
        }

        static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
    }
}
