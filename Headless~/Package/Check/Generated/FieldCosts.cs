using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Check
{
    /// <summary>Costs of components and their fields, by a table of the research: component, field, cost, with tabs between. A
    /// row without a field is of the component. Names are those of the inspector.</summary>
    sealed class FieldCosts
    {
        public const string File = "Research~/data/costs.tsv";

        readonly Dictionary<(string Component, string Field), string> costs = new Dictionary<(string, string), string>();
        readonly HashSet<(string, string)> asked = new HashSet<(string, string)>();

        /// <param name="text">The table; a malformed row is a fault.</param>
        public static FieldCosts Of(string text, Findings findings)
        {
            var read = new FieldCosts();
            string[] lines = text.Replace("\r\n", "\n").Split('\n');
            for (int i = 0; i < lines.Length; i++)
            {
                if (lines[i].Length == 0 || lines[i][0] == '#')
                    continue;
                string[] cells = lines[i].Split('\t');
                if (cells.Length != 3 || cells[0].Length == 0 || cells[2].Length == 0 || !read.costs.TryAdd((cells[0], cells[1]), cells[2]))
                    findings.Fault($"{File}({i + 1}) is not a new row: write component, field and cost, with a tab between, each once.");
            }
            return read;
        }

        /// <summary>Empty where nothing is known to cost.</summary>
        public string For(string component, string field)
        {
            asked.Add((component, field));
            return costs.TryGetValue((component, field), out string cost) ? cost : "";
        }

        /// <summary>Rows that no field asked for: a field that has another name now, or is gone.</summary>
        public void FindUnused(Findings findings)
        {
            foreach ((string component, string field) in costs.Keys.Where(key => !asked.Contains(key)))
                findings.Fault($"{File}: no component '{component}' has a field '{field}'. Write its name as the inspector shows it.");
        }
    }
}
