using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Experiments;
using Host.Report;
using Host.Report.ErrorTime;
using Host.Studies.Thesis;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Verdicts of the report's sweeps, and the values derived from them.</summary>
    public class SweepResultTests
    {
        static readonly Dictionary<string, object> Good = new Dictionary<string, object>
        {
            ["scene"] = "dam", ["deep"] = "on", ["seconds"] = 8, ["volume"] = 1.01, ["volume_lowest"] = 0.99, ["energy"] = 1.0002,
            ["ms_moving"] = 1.5, ["ms_settled"] = 1.2, ["error_moving"] = 0.004, ["error_settled"] = 0.006,
        };

        static SweepResult Result(params (string column, object value)[] changes)
        {
            var table = new ReportTable(ExperimentFigures.Columns);
            table.Add(ExperimentFigures.Columns.Select(column => changes.Where(change => change.column == column)
                .Select(change => change.value).FirstOrDefault() ?? (Good.TryGetValue(column, out object value) ? value : 0)).ToArray());
            return SweepResult.All(table).Single();
        }

        [Test]
        public void A_run_within_all_limits_holds() => Assert.That(Result().Fault, Is.Null);

        [TestCase("escaped", 1, "loses particles")]
        [TestCase("non_finite", 3, "loses particles")]
        [TestCase("volume_lowest", 0.94, "collapses")]
        [TestCase("volume_lowest", double.NaN, "collapses")]
        [TestCase("energy", 1.02, "gains energy")]
        [TestCase("energy", double.NaN, "gains energy")]
        [TestCase("volume", 1.06, "boils")]
        [TestCase("error_moving", 0.031, "is too dense")]
        [TestCase("error_settled", double.NaN, "is too dense")]
        public void A_run_beyond_a_limit_does_not_hold(string column, double value, string fault)
            => Assert.That(Result((column, value)).Fault, Is.EqualTo(fault));

        [Test]
        public void The_volume_of_water_that_still_moves_is_not_judged() => Assert.That(Result(("seconds", 2), ("volume", 1.3)).Fault, Is.Null);

        [Test]
        public void Time_and_error_are_those_of_the_worse_window()
        {
            Assert.That(Result().Milliseconds, Is.EqualTo(1.5));
            Assert.That(Result().Error, Is.EqualTo(0.006));
        }

        [Test]
        public void Particles_for_a_time_lie_between_the_sizes_measured()
        {
            var points = new[] { (100_000d, 0.2), (1_000_000d, 2.0), (4_000_000d, 8.0) };
            Assert.That(ThesisCapacity.Particles(points, 1.0), Is.EqualTo(500_000).Within(1));
            Assert.That(ThesisCapacity.Particles(points, 2.0), Is.EqualTo(1_000_000).Within(1));
            Assert.That(ThesisCapacity.Particles(points, 0.1), Is.NaN, "below the smallest");
            Assert.That(ThesisCapacity.Particles(points, 9.0), Is.NaN, "above the largest");
        }

        static readonly int[] Counts = { 1, 4, 16 };

        // C+ that falls with iterations and with ω, as in the thesis.
        static string DensityPage(Func<int, float, double> energy)
        {
            var table = new ReportTable(ExperimentFigures.Columns);
            foreach (int iterations in Counts)
                foreach (float relaxation in new[] { 1f, 1.2f, 1.5f })
                {
                    double error = 0.1 / (iterations * relaxation);
                    table.Add(ExperimentFigures.Columns.Select(column => column switch {
                        "iterations" => iterations, "relaxation" => relaxation, "error_moving" => error, "volume_lowest" => 1.0,
                        "energy" => energy(iterations, relaxation), "jitter" => 0.1, "substeps" => 4, _ => (object)0 }).ToArray());
                }
            string folder = Path.Combine(Path.GetTempPath(), "rill-thesis-" + Guid.NewGuid().ToString("N"));
            try
            {
                table.Save(Path.Combine(folder, "thesis-density.csv"));
                var page = new ReportPage(folder, folder, ".");
                new ThesisDensity().Write(page);
                return page.ToString();
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        [Test]
        public void A_thesis_figure_agrees_where_no_run_gained_energy()
        {
            string page = DensityPage((_, _) => 1.01);
            Assert.That(page, Does.Contain("Agrees.").And.Not.Contain("%, " + Verdict.NotComparable));
        }

        [Test]
        public void A_thesis_figure_of_runs_that_gained_energy_is_not_comparable_and_never_agrees()
        {
            string page = DensityPage((_, _) => 1.02);
            Assert.That(page, Does.Contain(Verdict.NotComparable).And.Not.Contain("grees"));
            Assert.That(page, Does.Contain("9 of 9 runs gained energy"));
        }

        [Test]
        public void A_thesis_run_that_gained_energy_is_left_out_of_its_verdict()
        {
            string page = DensityPage((iterations, relaxation) => iterations == 1 && relaxation == 1.5f ? 1.02 : 1.0);
            Assert.That(page, Does.Contain("C+ falls in 5 of 5 steps from one count to the next"));
            Assert.That(page, Does.Contain("1 of 9 runs gained energy"));
            string row = page.Split('\n').Single(line => line.StartsWith("| 1 |", StringComparison.Ordinal));
            Assert.That(row, Does.Contain(Verdict.NotComparable));
        }
    }
}
