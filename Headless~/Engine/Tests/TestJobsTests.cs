using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Threading;
using Host.Testing;
using NUnit.Framework;
using NUnit.Framework.Internal;

namespace Host.Tests
{
    /// <summary>Test runs of several processes, over planted fixtures of a few lines.</summary>
    public class TestJobsTests
    {
        const string Planted = @"
using System;
using System.Diagnostics;
using System.IO;
using System.Threading;
using NUnit.Framework;

[SetUpFixture] public class Around
{
    public static int Entered;
    [OneTimeSetUp] public void Enter() => Entered++;
    [OneTimeTearDown] public void Leave() { if (Entered != 1) throw new InvalidOperationException(""entered "" + Entered); }
}

namespace Planted
{
    static class Notes
    {
        public static void Write(string what, string of = null)
            => File.WriteAllText(Path.Combine(Path.GetDirectoryName(typeof(Notes).Assembly.Location),
            ""note-"" + what + ""-"" + Guid.NewGuid().ToString(""N"")), (of ?? Environment.GetEnvironmentVariable(""LP_NUM_THREADS"")) + "" ""
            + Process.GetCurrentProcess().Id);
    }

    public class Plain { [Test] public void One() { Assert.That(Around.Entered, Is.EqualTo(1));
        Notes.Write(""plain""); } [Test] public void Two() { } [Test, Ignore(""planted"")] public void Three() { } }
    public class Other { [Test] public void One() { Assert.That(Around.Entered, Is.EqualTo(1)); } [TestCase(1),
        TestCase(2)] public void Two(int n) { Console.Error.WriteLine(""noise""); } }
    [TestFixture(1), TestFixture(2)] public class Twice { public Twice(int n) { } [Test] public void One() { } }
    public class Third { [Test] public void One() { } }
    [Category(""RunsAlone"")] public class Last { [Test] public void One() { Notes.Write(""alone""); } }
}
namespace Faulty
{
    public class Failing { [Test] public void One() { Assert.Fail(""planted failure""); } [Test] public void Two() { } }
}
namespace Dying
{
    public class Exits { [Test] public void One() { Environment.Exit(7); } }
    public class Killed { [Test] public void One() { Process.GetCurrentProcess().Kill(); Thread.Sleep(10000); } }
}
namespace Slow
{
    public class Mixed { [Test] public void One() { } [Test, Category(""Long"")] public void Two() { } }
    [Category(""Long"")] public class Whole { [Test] public void One() { } }
    public class Brief { [TestCase(1), TestCase(2, Category = ""Long"")] public void One(int n) { } }
}
namespace Cultures
{
    using System.Globalization;
    public class First { [Test] public void One() => Planted.Notes.Write(""culture"", CultureInfo.CurrentCulture.Name + 1.5f); }
    public class Second { [Test] public void One() { string text = null; var thread = new Thread(() => text = ""I"".ToLower() + 1.5f); thread.Start();
        thread.Join(); Planted.Notes.Write(""culture"", CultureInfo.CurrentUICulture.Name + text); } }
}
namespace Waiting
{
    public class Waits { [Test] public void One() { Planted.Notes.Write(""waits""); Thread.Sleep(60000); } }
    public class AlsoWaits { [Test] public void One() { Planted.Notes.Write(""waits""); Thread.Sleep(60000); } }
}";

        PlantedAssemblies planted;

        [SetUp]
        public void Plant()
        {
            planted = new PlantedAssemblies();
            planted.Bring("nunit.framework");
            planted.Compile("Planted.Tests", Planted);
        }

        [TearDown]
        public void Remove() => planted.Dispose();

        Process Start(params string[] more)
        {
            string host = Assembly.GetEntryAssembly().Location;
            var start = new ProcessStartInfo("dotnet",
                new[] { host, "test", "--no-validation", "--assembly",
                Path.Combine(planted.Assemblies, "Planted.Tests.dll") }.Concat(more)) { RedirectStandardOutput = true,
                RedirectStandardError = true };
            start.Environment.Remove("LP_NUM_THREADS");     // this may be a worker itself
            start.Environment.Remove("DOTNET_SYSTEM_GLOBALIZATION_INVARIANT");
            start.Environment["LANG"] = start.Environment["LC_ALL"] = "de_DE.UTF-8";
            start.Environment["RILL_CACHE"] = planted.Root;
            return Process.Start(start);
        }

        int Run(out string[] lines, params string[] more)
        {
            using Process process = Start(more);
            process.ErrorDataReceived += (_, _) => { };
            process.BeginErrorReadLine();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            TestContext.WriteLine(output);
            lines = output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
            return process.ExitCode;
        }

        string[] Notes(string what) => Directory.GetFiles(planted.Assemblies, $"note-{what}-*").Select(File.ReadAllText)
            .Where(text => text.Contains(' ')).ToArray();

        [Test]
        public void Two_processes_report_what_one_does()
        {
            Assert.That(Run(out string[] one, "--jobs", "1", "--filter", "Planted."), Is.EqualTo(0));
            foreach (string note in Directory.GetFiles(planted.Assemblies, "note-*"))
                File.Delete(note);
            Assert.That(Run(out string[] two, "--jobs", "2", "--filter", "Planted."), Is.EqualTo(0));
            // Fixtures end in another order, and take other times.
            IEnumerable<string> Fixtures(string[] lines)
                => lines.Where(line => line.StartsWith("  ", StringComparison.Ordinal))
                .Select(line => line.Substring(0, line.LastIndexOf("  ", StringComparison.Ordinal))).OrderBy(line => line);
            Assert.That(Fixtures(two), Is.EqualTo(Fixtures(one)));
            Assert.That(two[0], Is.EqualTo("Planted.Tests"));
            Assert.That(two.TakeLast(4), Is.EqualTo(one.TakeLast(4)));
            Assert.That(two[^1], Is.EqualTo("9 passed, 0 failed, 1 skipped"));
            Assert.That(two[^2], Is.EqualTo("7 test methods, 0 of them dispatched on the device"));

            // Workers divide the cores, and a fixture that runs alone has them all.
            string[] shared = Notes("plain").Single().Split(' '), alone = Notes("alone").Single().Split(' ');
            Assert.That(shared[0], Is.EqualTo(Math.Max(1, Environment.ProcessorCount / 2).ToString()));
            Assert.That(alone[0], Is.EqualTo(Environment.ProcessorCount.ToString()));
            Assert.That(alone[1], Is.Not.EqualTo(shared[1]), "a process of its own");
        }

        [Test]
        public void A_filter_that_matches_no_test_is_named_even_beside_one_that_does()
        {
            using Process process = Start("--jobs", "1", "--filter", "Planted.", "--filter", "Plnted.");
            string problem = process.StandardError.ReadToEnd();
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.Not.Zero);
            Assert.That(problem, Does.Contain("--filter Plnted.: no test has a full name that contains it"));
        }

        [TestCase("1"), TestCase("2")]
        public void Tests_of_a_category_are_left_out_with_their_fixtures(string jobs)
        {
            Assert.That(Run(out string[] lines, "--jobs", jobs, "--filter", "Slow.", "--leave-out", "Long"), Is.EqualTo(0));
            Assert.That(lines.Last(), Is.EqualTo("2 passed, 0 failed"));
        }

        [TestCase("1"), TestCase("2")]
        public void What_is_explicit_does_not_run_where_only_a_category_is_left_out(string jobs)
        {
            planted.Compile("Planted.Tests", @"
using NUnit.Framework;
namespace Asked { public class First { [Test] public void One() { } [Test, Explicit(""planted"")] public void Two() { } }
    public class Second { [Test] public void One() { } [Test, Category(""Long"")] public void Two() { } } }");
            Assert.That(Run(out string[] lines, "--jobs", jobs, "--leave-out", "Long"), Is.EqualTo(0));
            Assert.That(lines.Last(), Does.StartWith("2 passed, 0 failed"));
            Assert.That(Run(out lines, "--jobs", jobs, "--leave-out", "Long", "--filter", "Asked."), Is.EqualTo(0));
            Assert.That(lines.Last(), Is.EqualTo("3 passed, 0 failed"), "a text names it");
        }

        [TestCase("1"), TestCase("2")]
        public void What_needs_a_GPU_is_left_out_on_a_CPU_but_where_a_filter_names_it(string jobs)
        {
            if (!HostSetup.Device.Info.IsSoftware)
                Assert.Ignore("the device is a GPU");
            planted.Compile("Planted.Tests", @"
using NUnit.Framework;
namespace Heavy { public class Sweep { [TestCase(1), TestCase(2, Category = ""GpuOnly"")] public void One(int n) { } [Test] public void Two() { } }
    public class More { [Test] public void One() { } [Test, Category(""GpuOnly"")] public void Two() { } } }");
            Assert.That(Run(out string[] lines, "--jobs", jobs), Is.EqualTo(0));
            Assert.That(lines[^1], Is.EqualTo("3 passed, 0 failed"));
            Assert.That(lines[^2], Is.EqualTo("2 tests of the category GpuOnly left out, which run on a GPU or where a --filter names them"));
            Assert.That(Run(out lines, "--jobs", jobs, "--filter", "Heavy."), Is.EqualTo(0));
            Assert.That(lines[^1], Is.EqualTo("5 passed, 0 failed"));
            Assert.That(lines[^2], Does.Not.Contain("left out"));
        }

        [Test]
        public void A_category_that_no_test_has_is_refused_by_name()
        {
            using Process run = Start("--leave-out", "Lang");
            string said = run.StandardError.ReadToEnd();
            run.WaitForExit();
            Assert.That(said, Does.Contain("--leave-out Lang: no test has that category; there are Long, RunsAlone."));
            Assert.That(run.ExitCode, Is.Not.Zero);
        }

        [TestCase("1"), TestCase("2")]
        public void A_fixture_that_leaves_a_setting_of_the_engine_changed_fails_by_name_and_changes_no_other(string jobs)
        {
            planted.Bring("UnityEngine");
            planted.Bring("UnityEngine.PhysicsModule");
            planted.Compile("Planted.Tests", @"
using NUnit.Framework;
using UnityEngine;
namespace Leaving
{
    public abstract class Base
    {
        [Test] public void One()
        {
            Assert.That(Time.timeScale, Is.EqualTo(1f));
            Assert.That(Physics.bounceThreshold, Is.EqualTo(2f));
            Assert.That(Screen.width, Is.EqualTo(1280));
            Time.timeScale = 0f;
            Physics.bounceThreshold = 3f;
            Screen.SetResolution(64, Screen.height, false);
        }
    }
    public class First : Base { }
    public class Second : Base { }
    public class Third : Base { [TearDown] public void PutBack()
        { Time.timeScale = 1f; Physics.bounceThreshold = 2f; Screen.SetResolution(1280, Screen.height, false); } }
}");
            Assert.That(Run(out string[] lines, "--jobs", jobs, "--filter", "Leaving."), Is.EqualTo(1));
            foreach (string fixture in new[] { "First", "Second" })
            {
                int at = Array.FindIndex(lines, line => line == $"    FAILED {fixture}");
                Assert.That(lines[at + 1], Does.StartWith("      it leaves ").And.Contain("Time.timeScale at 0 instead of 1")
                    .And.Contain("Physics.bounceThreshold at 3 instead of 2").And.Contain("Player.ScreenWidth at 64 instead of 1280"));
            }
            Assert.That(lines[^1], Is.EqualTo("3 passed, 2 failed"));
        }

        [Test]
        public void A_failing_test_in_a_worker_fails_the_run_with_its_message()
        {
            Assert.That(Run(out string[] lines, "--jobs", "2", "--filter", "Planted.Other", "--filter", "Planted.Third", "--filter",
                "Faulty."), Is.EqualTo(1));
            int at = Array.FindIndex(lines, line => line.Trim().StartsWith("Failing", StringComparison.Ordinal));
            Assert.That(lines[at], Does.Contain("1 passed, 1 FAILED"));
            Assert.That(lines[at + 1], Is.EqualTo("    FAILED One"));
            Assert.That(lines[at + 2], Is.EqualTo("      planted failure"));
            Assert.That(lines[^1], Is.EqualTo("5 passed, 1 failed"));
        }

        [Test]
        public void A_worker_that_dies_names_its_fixture_and_the_others_run()
        {
            Assert.That(Run(out string[] lines, "--jobs", "2", "--filter", "Planted.", "--filter", "Dying."), Is.EqualTo(1));
            Assert.That(lines.Where(line => line.Contains("FAILED"))
                .Select(line => line.Substring(line.IndexOf("FAILED", StringComparison.Ordinal))), Is.EquivalentTo(new[]
            {
                "FAILED: its worker process ended with exit code 7 while it ran Dying.Exits",
                "FAILED: its worker process was ended by signal 9 (SIGKILL) while it ran Dying.Killed",
            }));
            Assert.That(lines[^1], Is.EqualTo("9 passed, 2 failed, 1 skipped"));
        }

        // The limit leaves a loaded machine the time to start a worker.
        [Test]
        public void A_fixture_that_is_stuck_is_ended_by_name_and_the_others_run()
        {
            Assert.That(Run(out string[] lines, "--jobs", "2", "--filter", "Planted.", "--filter", "Waiting.Waits", "--fixture-limit", "25"),
                Is.EqualTo(1));
            Assert.That(lines.Single(line => line.Contains("FAILED")),
                Does.EndWith("FAILED: its worker process was ended after 25 s while it ran Waiting.Waits"));
            Assert.That(lines[^1], Is.EqualTo("9 passed, 1 failed, 1 skipped"));
        }

        [Test]
        public void Workers_end_with_the_run_that_is_stopped()
        {
            using Process run = Start("--jobs", "2", "--filter", "Waiting.");
            Assert.That(SpinWait.SpinUntil(() => Notes("waits").Length == 2, 60000), "both wait");
            int[] workers = Notes("waits").Select(note => int.Parse(note.Split(' ')[1])).ToArray();
            Assert.That(workers.All(Runs));
            Process.Start("kill", new[] { "-TERM", run.Id.ToString() }).WaitForExit();
            Assert.That(run.WaitForExit(30000), "it ends");
            Assert.That(run.ExitCode, Is.Not.EqualTo(0));
            Assert.That(SpinWait.SpinUntil(() => !workers.Any(Runs), 30000), "its workers end");
        }

        static bool Runs(int id)
        {
            string status = $"/proc/{id}/stat";
            try
            {
                return File.Exists(status) && !File.ReadAllText(status).Contains(") Z");
            }
            catch (IOException)
            {
                return false;
            }
        }

        [TestCase("1", "de-DE", "de-DE1,5", "de-DEi1,5")]
        [TestCase("2", "tr-TR", "tr-TR1,5", "tr-TRı1,5")]
        [TestCase("2", "", "1.5", "i1.5", TestName = "Tests_run_under_no_culture_but_one_that_was_asked_for")]
        public void Tests_run_under_the_culture_that_was_asked_for(string jobs, string culture, string first, string second)
        {
            string[] option = culture.Length == 0 ? Array.Empty<string>() : new[] { "--culture", culture };
            Assert.That(Run(out _, new[] { "--jobs", jobs, "--filter", "Cultures." }.Concat(option).ToArray()), Is.EqualTo(0));
            Assert.That(Notes("culture").Select(note => note.Split(' ')[0]), Is.EquivalentTo(new[] { first, second }));
        }

        [TestCase("de-XY")]
        [TestCase("german")]
        public void A_culture_that_is_none_is_refused(string culture)
        {
            using Process process = Start("--culture", culture);
            Assert.That(process.StandardError.ReadToEnd(), Does.StartWith($"{CommandLine.Name}: --culture {culture}: the culture does not exist"));
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.EqualTo(2));
        }

        [TestCase("0")]
        [TestCase("65")]
        public void A_number_of_processes_that_cannot_be_is_refused(string jobs)
        {
            string host = Assembly.GetEntryAssembly().Location;
            using Process process = Process.Start(new ProcessStartInfo("dotnet",
                new[] { host, "test", "--jobs", jobs }) { RedirectStandardError = true });
            Assert.That(process.StandardError.ReadToEnd(), Does.StartWith($"{CommandLine.Name}: --jobs {jobs}: the number of processes is 1 to 64"));
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.EqualTo(2));
        }

        [Test]
        public void The_longest_fixture_comes_first_and_before_it_what_never_ran()
        {
            var known = new TestDurations(planted.Root);
            known.Note("Tests Short", 1.0);
            known.Note("Tests Long", 9.0);
            known.Save();
            var read = new TestDurations(planted.Root);
            Assert.That(new[] { "Tests Short", "Tests New", "Tests Long" }.OrderByDescending(read.Of),
                Is.EqualTo(new[] { "Tests New", "Tests Long", "Tests Short" }));
            planted.Write("tests/durations.json", "{ \"Tests Lo");
            Assert.That(new TestDurations(planted.Root).Of("Tests Long"), Is.EqualTo(double.PositiveInfinity), "a file that was cut short");
        }
    }
}
