using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Report;
using Host.Report.Methods;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The answer of the report's first section follows from its runs.</summary>
    public class MethodsTests
    {
        const string Grid = "1", Alone = "0";

        static readonly string[] Columns = { "study", "series", "scene", "particles", "value", "label", "two_level", "substeps", "iterations",
            "relaxation", "error_moving", "error_settled", "speed", "jitter", "energy", "ms_moving", "ms_settled", "state" };

        static object[] Run(string study, string grid, string scene, double error, double ms, string state = "stands", double energy = 1.0,
            int substeps = 1, int iterations = 4)
            => new object[] { study, study, scene, 1000, 0.5, "", grid, substeps, iterations, 0.8, error, error, 0.1, 0.1, energy, ms, ms, state };

        static List<MethodRun> Runs(params object[][] rows)
        {
            var table = new ReportTable(Columns);
            foreach (object[] row in rows)
                table.Add(row);
            return MethodRun.All(table);
        }

        static readonly object[][] Usual =
        {
            Run("omega", Grid, "dam", 0.004, 0.3), Run("omega", Grid, "tank", 0.002, 0.3),
            Run("chebyshev", Alone, "dam", 0.5, 0.3, "diverged", 1.5), Run("chebyshev", Alone, "tank", 0.02, 0.3),
            Run("substeps", Alone, "dam", 0.02, 0.9, substeps: 4),
        };

        static string First(params object[][] more) => MethodsSection.Answer(Runs(Usual.Concat(more).ToArray()))[0];

        [Test]
        public void What_holds_no_deep_scene_alone_is_no_answer()
            => Assert.That(First(), Does.Contain("Not by another iteration alone").And.Contain("holds the tank only").And.Contain("two " +
                "coarse solves a step hold all"));

        [Test]
        public void An_iteration_that_holds_every_scene_in_time_is_the_answer()
            => Assert.That(First(Run("nesterov", Alone, "dam", 0.01, 2.9)), Does.Contain("Yes: an accelerated iteration alone holds every scene"));

        [TestCase(3.1, 1.0, "stands")]
        [TestCase(0.3, 1.02, "stands")]
        [TestCase(0.3, 1.0, "collapsed")]
        public void One_that_takes_longer_or_gains_energy_or_does_not_stand_is_not(double ms, double energy, string state)
            => Assert.That(First(Run("nesterov", Alone, "dam", 0.01, ms, state, energy)), Does.Contain("Not by another iteration alone"));

        [Test]
        public void Substeps_that_hold_a_scene_too_are_named_with_their_error()
            => Assert.That(First(), Does.Contain("Substeps without coarse solves hold the dam too, with 5 times the C+"));

        [Test]
        public void What_another_iteration_saves_on_top_is_said_at_equal_passes()
        {
            string answer = First(Run("nesterov", Grid, "dam", 0.0025, 0.3), Run("nesterov", Grid, "dam", 0.0001, 0.5, iterations: 16));
            Assert.That(answer, Does.Contain("saves at most 0.15 percentage points"));
        }

        [Test]
        public void Jacobi_is_the_relaxation_of_the_default_and_single_substeps()
        {
            List<MethodRun> runs = Runs(Run("omega", Grid, "dam", 0.1, 1), Run("substeps", Grid, "dam", 0.1, 1), Run("substeps", Grid,
                "dam", 0.1, 1, substeps: 2),
                Run("iterations", Grid, "dam", 0.1, 1), Run("cell-size", Grid, "dam", 0.1, 1));
            Assert.That(runs.Select(run => run.Method), Is.EqualTo(new[] { MethodRun.Jacobi, MethodRun.Jacobi, MethodRun.Substeps }));
        }

        [Test]
        public void To_measure_it_says_which_commit_can()
        {
            var run = new ReportRun(Path.GetTempPath(), true, "a device", TextWriter.Null);
            Assert.That(Assert.Throws<HostException>(() => new MethodsSection().Measure(run)).Message, Does.Contain("899e736f"));
        }
    }
}
