using System.Linq;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>A user's project with water, whose manifest asks for the package by a git address, and with tests that use its assertions.</summary>
    public class PoolProjectTests
    {
        [Test]
        public void Its_tests_run_over_the_package_at_hand()
        {
            var run = new ProjectRun(ForeignRun.ProjectFolder("Pool"));
            run.MustHaveEnded(1, "FAILED A_pool_too_small_for_its_water_loses_some", "were refused, since the capacity is 100: raise it or add less.", "2 passed, 1 failed");
            Assert.That(run.Output.First(line => line.StartsWith("Rill: ")), Does.Match(@"^Rill: (\d+) of \1 scripts compiled$"));
            Assert.That(run.Errors, Has.Some.StartsWith("warning: the package com.rill.fluids is taken from ").And.Some.Contains("packages that are not here: com.unity.ide.rider 3.0.24"));
            Assert.That(run.Errors.Where(line => line.Contains("left out")), Is.Empty);
            Assert.That(run.Everything, Does.Contain("PoolTests.cs:line"));
        }
    }
}
