using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace Host.Output
{
    /// <summary>A table of numbers, a row for each step.</summary>
    sealed class Statistics
    {
        readonly List<double[]> rows = new();

        public Statistics(IEnumerable<string> columns)
        {
            Columns = columns.ToArray();
            string twice = Columns.GroupBy(name => name).FirstOrDefault(group => group.Count() > 1)?.Key;
            if (twice != null)
                throw new ArgumentException($"Two columns of the statistics are named \"{twice}\".");
        }

        public string[] Columns { get; }
        public IReadOnlyList<double[]> Rows => rows;

        public void Add(double[] row)
        {
            if (row.Length != Columns.Length)
                throw new ArgumentException($"The row has {row.Length} values for {Columns.Length} columns.");
            rows.Add(row);
        }

        public int IndexOf(string column)
        {
            int index = Array.IndexOf(Columns, column);
            return index >= 0 ? index : throw new ArgumentException($"No column \"{column}\" among {string.Join(", ", Columns)}.");
        }

        /// <summary>Values of a column that are numbers; NaN stands for "not known at that step".</summary>
        public double[] Known(string column)
        {
            int index = IndexOf(column);
            return rows.Select(row => row[index]).Where(value => !double.IsNaN(value)).ToArray();
        }

        public void WriteCsv(string path)
        {
            var text = new StringBuilder(string.Join(",", Columns)).Append('\n');
            foreach (double[] row in rows)
                text.Append(string.Join(",", row.Select(Number))).Append('\n');
            File.WriteAllText(path, text.ToString());
        }

        static string Number(double value) => double.IsNaN(value) ? "" : value.ToString("R", CultureInfo.InvariantCulture);
    }
}
