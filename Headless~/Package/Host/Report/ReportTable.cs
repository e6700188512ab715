using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace Host.Report
{
    /// <summary>A table of measured figures that lives as a CSV file; its first line says what it was measured on.</summary>
    sealed class ReportTable
    {
        readonly List<string[]> rows = new();

        public ReportTable(params string[] columns)
        {
            Columns = columns;
        }

        public string[] Columns { get; }
        /// <summary>Device and settings that hold for all rows.</summary>
        public string MeasuredOn { get; set; } = "";
        /// <summary>The settings alone; the device of a section is in the page's table of what was measured on what.</summary>
        public string Settings => MeasuredOn.Contains("; ") ? MeasuredOn[(MeasuredOn.IndexOf("; ", StringComparison.Ordinal) + 2)..] : MeasuredOn;
        /// <summary>Whether the device was a CPU: then times say nothing.</summary>
        public bool InSoftware => MeasuredOn.Contains("in software");
        public IEnumerable<Row> Rows => rows.Select(row => new Row(this, row));

        /// <param name="values">One for each column; NaN is written as nothing.</param>
        public void Add(params object[] values)
        {
            if (values.Length != Columns.Length)
                throw new ArgumentException($"{values.Length} values for {Columns.Length} columns: {string.Join(", ", Columns)}.");
            rows.Add(values.Select(Text).ToArray());
        }

        public void Save(string path)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllLines(path, rows.Select(row => string.Join(",", row)).Prepend(string.Join(",", Columns)).Prepend("# " + MeasuredOn));
        }

        /// <exception cref="HostException">The file does not exist.</exception>
        public static ReportTable Load(string path)
        {
            if (!File.Exists(path))
                throw new HostException($"{path} is not there; \"rill report\" without --write-only measures it.");
            string[] lines = File.ReadAllLines(path);
            string[] said = lines.Where(line => line.StartsWith('#')).ToArray();
            string[] table = lines.Where(line => line.Length > 0 && !line.StartsWith('#')).ToArray();
            if (table.Length == 0)
                throw new HostException($"{path} holds no table; \"rill report\" without --write-only measures it again.");
            var loaded = new ReportTable(table[0].Split(',')) { MeasuredOn = string.Join(" ", said.Select(line => line[1..].Trim())) };
            foreach (string line in table.Skip(1))
            {
                string[] values = line.Split(',');
                if (values.Length != loaded.Columns.Length)
                    throw new HostException($"{path}: \"{line}\" has {values.Length} values for {loaded.Columns.Length} columns.");
                loaded.rows.Add(values);
            }
            return loaded;
        }

        static string Text(object value)
        {
            string text = value switch
            {
                double number => double.IsNaN(number) ? "" : number.ToString("G6", CultureInfo.InvariantCulture),
                float number => float.IsNaN(number) ? "" : number.ToString("G6", CultureInfo.InvariantCulture),
                IFormattable other => other.ToString(null, CultureInfo.InvariantCulture),
                _ => value?.ToString() ?? "",
            };
            return text.Contains(',') ? throw new ArgumentException($"\"{text}\" holds a comma.") : text;
        }

        public readonly struct Row
        {
            readonly ReportTable table;
            readonly string[] values;

            public Row(ReportTable table, string[] values)
            {
                this.table = table;
                this.values = values;
            }

            public string this[string column]
            {
                get
                {
                    int index = Array.IndexOf(table.Columns, column);
                    return index >= 0 ? values[index]
                        : throw new ArgumentException($"No column \"{column}\" among {string.Join(", ", table.Columns)}.");
                }
            }

            /// <summary>NaN where there is none.</summary>
            public double Number(string column) => this[column].Length == 0 ? double.NaN : double.Parse(this[column], CultureInfo.InvariantCulture);
        }
    }
}
