using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Host.Report;

namespace Host.Studies.Methods
{
    // Who is on the front and who beats the package's passes, by rule.
    sealed partial class MethodsPage
    {
        void WriteVerdicts()
        {
            page.Heading("Verdicts");
            page.Line(FormattableString.Invariant(
                $"By rule, on cost, C+ and noise: a run *beats* another where it is better by {100 * ParetoFront.Better:0} % in one and worse in none (within {100 * ParetoFront.Same:0} %). On the *front*"));
            page.Line("of a scene is what stands and no other run of any method beats. Each run is also held against *the package's*: " +
                "Jacobi passes, with or without the");
            page.Line("two-level correction as the run has it, relaxation 0.8, one substep, the same number of iterations in all. " +
                "*Best* is the run with the least C+ that stands: value, C+, noise, " + CostName + ".");
            page.Line();
            foreach (string scene in scenes)
                WriteScene(scene, rows.Where(row => row["scene"] == scene).ToList());
            WriteDefaults();
        }

        void WriteScene(string scene, List<ReportTable.Row> here)
        {
            List<ReportTable.Row> front = ParetoFront.Of(here.Where(Stands).ToList(), Costs);
            page.Line($"**{scene}**");
            page.Line();
            page.Table(new[] { "study", "method", "stand", "on the front", "beat the package's", "beaten by it", "best" },
                here.GroupBy(row => (study: row["study"], series: row["series"])).Select(group => new[]
                {
                    group.Key.study, group.Key.series, Standing(group), Values(group.Where(row => front.Contains(row))),
                    Values(group.Where(row => AgainstPackage(row) > 0)), Values(group.Where(row => AgainstPackage(row) < 0)), Best(group),
                }));
            page.Line($"The front of the {scene}, from the cheapest to the most expensive:");
            page.Line();
            page.Table(new[] { "method", "study", "value", "substeps x iterations", "ω", "C+", "interior", "volume", "noise, m/s", CostName },
                front.OrderBy(Cost).Select(row => new[]
                {
                    row["series"], row["study"], ValueOf(row), $"{row["substeps"]} x {row["iterations"]}", row["relaxation"],
                    Percent(Error(row)), Percent(row.Number("interior")), Figure(row.Number("volume")), Figure(Noise(row)), Figure(Cost(row)),
                }));
        }

        // A default should change for what wins somewhere and loses nowhere.
        void WriteDefaults()
        {
            string[] better = rows.GroupBy(row => (study: row["study"], series: row["series"], value: ValueOf(row)))
                .Where(group => group.Any(row => AgainstPackage(row) > 0) && group.All(row => AgainstPackage(row) >= 0))
                .Select(group => $"- {group.Key.series}, {group.Key.value} ({group.Key.study}): beats the package's in " +
                    $"{string.Join(", ", group.Where(row => AgainstPackage(row) > 0).Select(row => row["scene"]))}").ToArray();
            page.Line("What follows for the defaults: a value should replace the package's where it beats it in a scene and is beaten, " +
                "or falls where the package's stands, in none.");
            page.Line(better.Length > 0 ? "By this rule:" : "By this rule nothing here should.");
            page.Line();
            foreach (string line in better)
                page.Line(line);
            page.Line();
        }

        /// <summary>1 where a run beats the package's of as many iterations, −1 where that beats it or stands alone, else 0.</summary>
        int AgainstPackage(ReportTable.Row row)
        {
            double iterations = row.Number("substeps") * row.Number("iterations");
            ReportTable.Row[] same = rows.Where(other => other["study"] == "iterations" && other["scene"] == row["scene"]
                && other["two_level"] == row["two_level"] && other.Number("iterations") == iterations).ToArray();
            if (same.Length == 0 || row["study"] == "iterations")
                return 0;
            if (!Stands(same[0]) || !Stands(row))
                return Stands(row).CompareTo(Stands(same[0]));
            return ParetoFront.Beats(Costs(row), Costs(same[0])) ? 1 : ParetoFront.Beats(Costs(same[0]), Costs(row)) ? -1 : 0;
        }

        double[] Costs(ReportTable.Row row) => new[] { Cost(row), Error(row), Noise(row) };

        static string Standing(IEnumerable<ReportTable.Row> runs)
        {
            List<ReportTable.Row> all = runs.ToList();
            IEnumerable<string> fallen = all.Where(run => !Stands(run)).GroupBy(run => run["state"]).Select(state => $"{state.Count()} {state.Key}");
            return string.Join(", ", fallen.Prepend($"{all.Count(Stands)} of {all.Count}"));
        }

        static string Values(IEnumerable<ReportTable.Row> found) => string.Join(", ", found.Select(ValueOf));

        string Best(IEnumerable<ReportTable.Row> runs)
        {
            List<ReportTable.Row> standing = runs.Where(Stands).OrderBy(Error).ToList();
            return standing.Count > 0
                ? $"{ValueOf(standing[0])}: {Percent(Error(standing[0]))}, {Figure(Noise(standing[0]))}, {Figure(Cost(standing[0]))}" : "";
        }

        string CostName => timed ? "ms" : "passes";

        static string ValueOf(ReportTable.Row row) => row["label"].Length > 0 ? row["label"] : row["value"];

        static string Percent(double fraction) => string.Create(CultureInfo.InvariantCulture, $"{100 * fraction:0.00} %");

        static string Figure(double value) => value.ToString("G3", CultureInfo.InvariantCulture);
    }
}
