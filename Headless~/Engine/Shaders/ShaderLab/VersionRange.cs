using System;
using System.Globalization;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>Ranges of versions of packages, as version defines of scripts and PackageRequirements of shaders write them.</summary>
    internal static class VersionRange
    {
        /// <summary>Whether a version lies in the range: "" any, "1.2" at least, "[1.2,2.0)", "[1.2]", "(,2.0]".</summary>
        /// <exception cref="FormatException">The expression is none of these.</exception>
        public static bool Contains(string expression, string version)
        {
            expression = expression.Replace(" ", "");
            if (expression.Length == 0) return true;
            if (char.IsDigit(expression[0])) return Compare(version, expression) >= 0;
            char first = expression[0], last = expression[expression.Length - 1];
            if (first != '[' && first != '(' || last != ']' && last != ')' || expression.Length < 3)
                throw new FormatException($"'{expression}' is not a range of versions, as 1.2.0 or [1.2.0,2.0.0) are");
            var ends = expression.Substring(1, expression.Length - 2).Split(',');
            if (ends.Length == 1) return Compare(version, ends[0]) == 0;
            if (ends[0].Length > 0 && Compare(version, ends[0]) is var low && (low < 0 || low == 0 && first == '(')) return false;
            return ends[1].Length == 0 || Compare(version, ends[1]) is var high && (high < 0 || high == 0 && last == ']');
        }

        static int Compare(string a, string b)
        {
            int[] left = Numbers(a), right = Numbers(b);
            for (var i = 0; i < 3; i++)
                if (left[i] != right[i]) return left[i].CompareTo(right[i]);
            // "1.0.0-preview.3" comes before "1.0.0".
            var leftPreview = a.Contains('-');
            return leftPreview == b.Contains('-') ? leftPreview
                ? string.CompareOrdinal(a.Substring(a.IndexOf('-')), b.Substring(b.IndexOf('-'))) : 0 : leftPreview ? -1 : 1;
        }

        static int[] Numbers(string version)
        {
            var numbers = new int[3];
            var parts = version.Split('-')[0].Split('.');
            for (var i = 0; i < Math.Min(3, parts.Length); i++)
            {
                // "0f1" of a Unity version counts by its leading number.
                var digits = new string(parts[i].TakeWhile(char.IsDigit).ToArray());
                if (!int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out numbers[i]))
                    throw new FormatException($"'{version}' is not a version");
            }
            return numbers;
        }
    }
}
