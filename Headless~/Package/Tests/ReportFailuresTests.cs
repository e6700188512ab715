using System.Collections.Generic;
using System.Linq;
using Host.Report;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>All failures in the report's tables are gathered, and nothing else.</summary>
    public class ReportFailuresTests
    {
        static readonly string[] Columns = { "body", "deep water", "draft", "error", "within 5 %", "damping" };

        static string[] Row(string body, string deep, double error, bool? holds)
            => new[] { body, deep, "0.2", $"{error} %", Verdict.Of(holds), "0.1" };

        static string[][] Found(string[] columns, params string[][] rows)
        {
            var failures = new ReportFailures();
            failures.Add("Obstacles: all", "Floating", columns, rows);
            return failures.Rows.ToArray();
        }

        [Test]
        public void What_holds_everywhere_is_not_listed()
            => Assert.That(Found(Columns, Row("ball", "on", 1, true), Row("cube", "off", 0, null)), Is.Empty);

        [Test]
        public void Failures_are_counted_by_deep_water_with_the_worst_figure()
        {
            string[][] found = Found(Columns, Row("ball", "on", 1, true), Row("ball", "on", -7.5, false), Row("cube", "on", 6, false),
                Row("ball", "off", 12, false), Row("cube", "off", 0, null));
            Assert.That(found.Select(row => string.Join("; ", row.Skip(1))), Is.EqualTo(new[]
            {
                "Floating: error, within 5 %; on; 2 of 3; -7.5 %",
                "Floating: error, within 5 %; off; 1 of 1; 12 %",
            }));
            Assert.That(found.Select(row => row[0]), Is.All.EqualTo("[Obstacles: all](#obstacles-all)"));
        }

        [Test]
        public void A_case_that_is_judged_as_a_whole_is_listed_with_what_fails_of_it()
        {
            string[] columns = { "case", "setting", "bar", "seen", "" };
            string[][] found = Found(columns, new[] { "dam", "deep water off", "", "", Verdict.Of("volume; jitter") },
                new[] { "column", "default", "", "", Verdict.Of("") });
            Assert.That(found.Single().Skip(1), Is.EqualTo(new[] { "dam", "off", "1 of 1", "volume; jitter" }));
        }

        [Test]
        public void Every_failing_cell_of_the_page_is_in_the_count()
        {
            var failures = new ReportFailures();
            failures.Add("a", "b", new[] { "x", "figure", "bar", "figure 2", "bar 2" }, new List<string[]>
            {
                new[] { "1", "2 %", Verdict.No, "3 %", Verdict.No },
                new[] { "2", "2 %", Verdict.Yes, "9 %", Verdict.No },
            });
            Assert.That(failures.Rows.Select(row => row[3] + " " + row[4]), Is.EqualTo(new[] { "1 of 2 2 %", "2 of 2 9 %" }));
        }
    }
}
