using System.Globalization;

namespace Host.Report
{
    /// <summary>Numbers as the page shows them.</summary>
    static class Figures
    {
        public static string Fixed(double value, int digits) => double.IsNaN(value) ? "–"
            : value.ToString("F" + digits, CultureInfo.InvariantCulture);

        /// <summary>With its sign.</summary>
        public static string Percent(double fraction, int digits = 1) => double.IsNaN(fraction) ? "–"
            : (100 * fraction).ToString((fraction >= 0 ? "'+'" : "") + "0." + new string('0', digits), CultureInfo.InvariantCulture) + " %";
    }
}
