using System;
using System.Collections.Generic;
using System.Globalization;

namespace Host.Report.Extremes
{
    /// <summary>Limit and measurement of a case: one call gives both, so that a page cannot show another bar than was
    /// applied.</summary>
    sealed class ExtremeCheck
    {
        readonly List<string> bars = new(), seen = new(), broken = new();

        public string Bar => string.Join("; ", bars);
        public string Seen => string.Join("; ", seen);
        /// <summary>Checks that did not hold; empty if all did.</summary>
        public string Broken => string.Join("; ", broken);
        public bool Holds => broken.Count == 0;

        /// <param name="unit">"%" shows a fraction as percent.</param>
        public void AtMost(string what, double value, double limit, string unit = "")
            => Judge(what, value, value <= limit, $"at most {Text(limit, unit)}", unit);
        public void AtLeast(string what, double value, double limit, string unit = "")
            => Judge(what, value, value >= limit, $"at least {Text(limit, unit)}", unit);
        public void Between(string what, double value, double low, double high, string unit = "")
            => Judge(what, value, value >= low && value <= high, $"{Text(low, unit)} to {Text(high, unit)}", unit);
        public void Exactly(string what, double value, double wanted) => Judge(what, value, value == wanted, Text(wanted, ""), "");

        /// <param name="otherwise">What was seen when it does not hold.</param>
        public void That(string what, bool holds, string otherwise)
        {
            bars.Add(what);
            seen.Add(holds ? "yes" : otherwise);
            if (!holds)
                broken.Add($"{what}: {otherwise}");
        }

        /// <summary>A figure that no bar is set for.</summary>
        public void Note(string what, double value, string unit = "") => seen.Add($"{what} {Text(value, unit)}");

        void Judge(string what, double value, bool holds, string bar, string unit)
        {
            bars.Add($"{what} {bar}");
            seen.Add($"{what} {Text(value, unit)}");
            if (!holds)
                broken.Add(what);
        }

        // Tables of the report hold no commas.
        static string Text(double value, string unit)
        {
            double shown = unit == "%" ? 100.0 * value : value;
            string number = Math.Abs(shown) is >= 100_000 or > 0 and < 1e-3 ? shown.ToString("0.##e+0", CultureInfo.InvariantCulture)
                : shown.ToString(Math.Abs(shown) >= 100 ? "0" : Math.Abs(shown) >= 10 ? "0.#" : "0.####", CultureInfo.InvariantCulture);
            return unit.Length > 0 ? $"{number} {unit}" : number;
        }
    }
}
