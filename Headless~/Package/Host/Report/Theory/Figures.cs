using System;
using System.Globalization;

namespace Host.Report
{
    /// <summary>Numbers as the page shows them.</summary>
    static class Figures
    {
        public static string Fixed(double value, int digits) => double.IsNaN(value) ? "–"
            : value.ToString("F" + digits, CultureInfo.InvariantCulture);

        /// <summary>Three figures, and whole numbers above a thousand with a comma.</summary>
        public static string Three(double value) => double.IsNaN(value) ? "–" : Math.Abs(value) >= 1000
            ? RoundedToThree(value).ToString("N0", CultureInfo.InvariantCulture) : RoundedToThree(value).ToString("G3", CultureInfo.InvariantCulture);

        static double RoundedToThree(double value)
        {
            double unit = value == 0 ? 1 : Math.Pow(10, Math.Floor(Math.Log10(Math.Abs(value))) - 2);
            return unit < 1e-6 ? value : Math.Round(value / unit) * unit;
        }

        /// <summary>With its sign.</summary>
        public static string Percent(double fraction, int digits = 1) => double.IsNaN(fraction) ? "–"
            : (100 * fraction).ToString((fraction >= 0 ? "'+'" : "") + "0." + new string('0', digits), CultureInfo.InvariantCulture) + " %";
    }
}
