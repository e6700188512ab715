using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Host.Report
{
    /// <summary>A logarithmic axis that ends near its data, with labels at 1, 2 and 5 of each decade: gnuplot's own labels whole decades
    /// only.</summary>
    static class LogAxis
    {
        /// <param name="axis">x or y.</param>
        public static string Script(string axis, IEnumerable<double> values)
        {
            double[] positive = values.Where(value => value > 0).ToArray();
            if (positive.Length == 0)
                return "";
            // Room for labels beside the last point.
            double low = positive.Min() / 1.4, high = positive.Max() * 1.8;
            // Between far ends the decades do.
            int[] digits = high / low > 2_000 ? new[] { 1 } : new[] { 1, 2, 5 };
            var tics = from decade in Enumerable.Range((int)Math.Floor(Math.Log10(low)), (int)Math.Ceiling(Math.Log10(high / low)) + 2)
                       from digit in digits
                       let tic = digit * Math.Pow(10, decade)
                       where tic >= low && tic <= high
                       select tic.ToString("G6", CultureInfo.InvariantCulture);
            return string.Create(CultureInfo.InvariantCulture,
                $"set logscale {axis}\nset {axis}range [{low:G4}:{high:G4}]\nset {axis}tics ({string.Join(", ", tics)})\n");
        }
    }
}
