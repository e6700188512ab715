using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.Report
{
    /// <summary>A front's position Z over time T, as points with straight lines between them; both without units.</summary>
    sealed class FrontSeries
    {
        readonly double[] times, positions;

        public FrontSeries(string name, IEnumerable<(double T, double Z)> points)
        {
            Name = name;
            (double T, double Z)[] sorted = points.OrderBy(point => point.T).ToArray();
            times = sorted.Select(point => point.T).ToArray();
            positions = sorted.Select(point => point.Z).ToArray();
        }

        public string Name { get; }
        public IEnumerable<(double T, double Z)> Points => times.Zip(positions);
        public double First => times[0];
        public double Last => times[^1];

        /// <summary>NaN outside of the points.</summary>
        public double At(double time)
        {
            if (!(time >= First && time <= Last))
                return double.NaN;
            int next = Math.Max(1, Array.FindIndex(times, t => t >= time));
            double fraction = (time - times[next - 1]) / (times[next] - times[next - 1]);
            return positions[next - 1] + fraction * (positions[next] - positions[next - 1]);
        }

        /// <summary>The experiments: Headless~/Package/data/dam-break-front.csv of the package.</summary>
        public static List<FrontSeries> Experiments(string root)
            => Of(ReportTable.Load(Path.Combine(root, "Headless~", "Package", "data", "dam-break-front.csv")));

        /// <summary>One for each name in a table's column "series".</summary>
        public static List<FrontSeries> Of(ReportTable table)
        {
            return table.Rows.GroupBy(row => row["series"])
                .Select(series => new FrontSeries(series.Key, series.Select(row => (row.Number("T"), row.Number("Z"))))).ToList();
        }
    }
}
