namespace Host.Report
{
    /// <summary>Verdict of a table's cell on the figure before it. The report's first table lists all that fail.</summary>
    static class Verdict
    {
        public const string Yes = "yes", No = "**no**", None = "–";
        /// <summary>Verdict on a run that gained energy: nothing about water follows from it.</summary>
        public const string NotComparable = "not comparable";
        const string Broken = "**FAILS**: ";

        /// <param name="holds">Null without a figure.</param>
        public static string Of(bool? holds) => holds == null ? None : holds.Value ? Yes : No;

        /// <param name="error">Of a figure, as a fraction; not a number without one.</param>
        public static string Within(double error, double bar) => Of(double.IsNaN(error) ? null : System.Math.Abs(error) <= bar);

        /// <summary>Name of a column of such verdicts.</summary>
        public static string Column(double bar) => System.FormattableString.Invariant($"within {100 * bar:0.#} %");

        /// <param name="broken">What fails of several bars; empty if all hold.</param>
        public static string Of(string broken) => broken.Length == 0 ? "holds" : Broken + broken;

        public static bool IsFailure(string cell) => cell == No || cell.StartsWith(Broken, System.StringComparison.Ordinal);

        public static bool IsVerdict(string cell) => cell is Yes or "holds" || IsFailure(cell);

        /// <summary>Reason of the failure among several bars.</summary>
        public static string Reason(string cell) => cell.StartsWith(Broken, System.StringComparison.Ordinal) ? cell[Broken.Length..] : "";
    }
}
