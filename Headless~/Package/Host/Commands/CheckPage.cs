using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Host.Check;

namespace Host.Commands
{
    /// <summary>The outcome of <c>check</c> as a page: its rules, and the figures and tables that they make.</summary>
    static class CheckPage
    {
        public static void Write(string file, IReadOnlyList<(Rule rule, Findings findings)> examined)
        {
            var text = new StringBuilder("# What `rill check` found\n\nWritten by `Headless~/rill check --page`; " +
                "Documentation~/verification.md says what it proves.\n\n");
            var rules = new ResultTable { Columns = new[] { "rule", "looked at", "verdict" } };
            foreach ((Rule rule, Findings findings) in examined)
                rules.Rows.Add(new[] { rule.Name, findings.Looked, findings.Faults.Count == 0 ? "holds" : findings.Faults.Count + " faults" });
            Append(text, rules);
            foreach (ResultTable table in examined.SelectMany(e => e.findings.Tables))
            {
                text.Append($"\n## {table.Title}\n\n");
                if (table.About.Length > 0)
                    text.Append(table.About + "\n\n");
                Append(text, table);
            }
            string full = Path.GetFullPath(file);
            Directory.CreateDirectory(Path.GetDirectoryName(full));
            File.WriteAllText(full, text.ToString());
        }

        static void Append(StringBuilder text, ResultTable table)
        {
            text.Append($"| {string.Join(" | ", table.Columns)} |\n|{string.Concat(table.Columns.Select(_ => " --- |"))}\n");
            foreach (string[] row in table.Rows)
                text.Append($"| {string.Join(" | ", row.Select(cell => cell.Replace("|", "\\|")))} |\n");
        }
    }
}
