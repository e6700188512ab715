using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.Shaders;
using Host.Testing;
using Host.Vulkan;
using NUnit.Framework.Internal;
using UnityEngine.Headless;

namespace Host.Commands
{
    /// <summary><c>test</c>: the host's and the package's tests with the validation layer on, in this process on one device, or shared
    /// among several.</summary>
    static class TestCommand
    {
        const string GpuOnly = "GpuOnly";

        sealed class Choice
        {
            public string[] Texts, LeftOut;
            public bool PackageOnly, HostOnly, Validation, ShowsAll, Alone, Strict;
            public string Assembly, Worker, Project, Culture;
            public int Limit;
            public bool IsSoftware;     // the device is a CPU
            public int ForGpu;          // tests that are left out there

            public bool IsWhole => Texts.Length == 0 && LeftOut.Length == 0 && !PackageOnly && !HostOnly && Assembly == null && Project == null;
            public TestFilter Filter => Texts.Length == 0 && AllLeftOut.Length == 0 ? TestFilter.Empty : new TextFilter(Texts, AllLeftOut);

            /// <summary>Whether tests that ask for a GPU are left out: without a GPU, and where no filter asks for them by name.</summary>
            public bool LeavesOutGpuOnly => IsSoftware && Texts.Length == 0;

            public string[] AllLeftOut => LeavesOutGpuOnly ? LeftOut.Append(GpuOnly).ToArray() : LeftOut;
        }

        public static Command Create()
        {
            var filter = new Option<string[]>("--filter") {
                Description = "Only tests whose full name contains this text; may come several times.", DefaultValueFactory = _
                => Array.Empty<string>() };
            var project = new Option<string>("--project") {
                Description = "A Unity project's folder: its own tests instead, compiled from source with its scripts." };
            var strict = new Option<bool>("--strict") { Description = "With --project: fail where Unity logs and goes on or is undefined." };
            var leaveOut = new Option<string[]>("--leave-out") { Description = "No tests of this category; may come several times.",
                DefaultValueFactory = _ => Array.Empty<string>() };
            var list = new Option<bool>("--list") { Description = "Name the tests, run none." };
            var package = new Option<bool>("--package-only") { Description = "Only the package's tests." };
            var host = new Option<bool>("--host-only") { Description = "Only the host's own tests." };
            var noValidation = new Option<bool>("--no-validation") { Description = "Without Vulkan's validation layer, where it is not installed." };
            var written = new Option<bool>("--output") { Description = "Also print what tests wrote that passed: their figures." };
            var jobs = new Option<int?>("--jobs")
            {
                Description = $"Processes that divide the fixtures, 1 to {TestJobs.Max}. By default one per core, at most " +
                    $"{TestJobs.MaxDefault}, where the device is lavapipe, which leaves cores idle; 1 on a real GPU. "
                    + "With 1 they run in this process.",
            };
            // For the runner's own tests, and between its processes.
            var assembly = new Option<string>("--assembly") { Description = "Only the tests of this file.", Hidden = true };
            var worker = new Option<string>("--worker") { Description = "The pipe to ask for fixtures.", Hidden = true };
            var alone = new Option<bool>("--alone") { Description = "As a worker: fixtures that run alone.", Hidden = true };
            var limit = new Option<int>("--fixture-limit") { Description = "Seconds after which a fixture of several processes counts as stuck.",
                DefaultValueFactory = _ => TestJobs.DefaultLimit, Hidden = true };
            Option<string> shaders = ShadersOption.Create();
            Option<string> limits = LimitsOption.Create();
            Option<string> culture = CultureOption.Create();
            var command = new Command("test", "Runs the tests.") { project, strict, filter, leaveOut, list, package, host, noValidation,
                written, jobs, shaders, limits, culture, assembly, worker, alone, limit };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                LimitsOption.Use(parsed.GetValue(limits));
                CultureOption.Use(parsed.GetValue(culture));
                var choice = new Choice
                {
                    Texts = parsed.GetValue(filter), LeftOut = parsed.GetValue(leaveOut), PackageOnly = parsed.GetValue(package),
                        HostOnly = parsed.GetValue(host), Validation = !parsed.GetValue(noValidation),
                    ShowsAll = parsed.GetValue(written), Project = parsed.GetValue(project), Strict = parsed.GetValue(strict),
                        Assembly = parsed.GetValue(assembly), Worker = parsed.GetValue(worker), Alone = parsed.GetValue(alone),
                    Limit = parsed.GetValue(limit), Culture = parsed.GetValue(culture),
                };
                return choice.Project != null ? ExecuteProject(choice, parsed.GetValue(list), parsed.GetValue(jobs))
                    : Execute(choice, parsed.GetValue(list), parsed.GetValue(jobs));
            });
            return command;
        }

        static int Execute(Choice choice, bool list, int? jobs)
        {
            if (choice.PackageOnly && choice.HostOnly)
                throw new HostException("--package-only and --host-only leave nothing to run; name one of them.");
            if (jobs is < 1 or > TestJobs.Max)
                throw new HostException($"--jobs {jobs}: the number of processes is 1 to {TestJobs.Max}; leave it out for what suits this machine.");
            if (choice.Strict)
                throw new HostException("--strict goes with --project; tests of the package are always run so.");
            List<Assembly> assemblies = TestAssemblies.Load(host: !choice.PackageOnly, package: !choice.HostOnly, choice.Assembly);
            if (choice.Worker == null)
            {
                if (choice.LeftOut.Length > 0)
                    CheckCategories(choice, assemblies);
                if (choice.Texts.Length > 0)
                    CheckFilters(choice, assemblies);
                using (var device = new VulkanDevice())
                    choice.IsSoftware = device.Info.IsSoftware;
            }
            TextWriter output = Console.Out;
            if (list)
            {
                foreach (string name in assemblies.SelectMany(assembly => TestRun.List(assembly, choice.Filter)))
                    output.WriteLine(name);
                return 0;
            }
            if (choice.Worker != null)
            {
                new TestWorker(choice.Worker).Run(assemblies, choice.Filter, choice.Alone, choice.Validation, choice.ShowsAll);
                return 0;
            }

            if (choice.LeavesOutGpuOnly)
            {
                var withThem = new TextFilter(choice.Texts, choice.LeftOut);
                choice.ForGpu = assemblies.Sum(assembly => TestRun.List(assembly, withThem).Count() - TestRun.List(assembly, choice.Filter).Count());
            }
            var complaints = new List<string>();
            var durations = new TestDurations();
            var tally = new TestTally(output, durations);
            List<TestFacts> facts = jobs == 1 ? RunHere(choice, assemblies, tally) : RunJobs(choice, assemblies, jobs, tally, complaints);
            durations.Save();

            List<string> validation = facts.SelectMany(process => process.ValidationMessages).ToList();
            complaints.AddRange(facts.SelectMany(process => process.Left));
            complaints.AddRange(validation.Select(message => "validation: " + message));
            (int all, int dispatching) = BuiltInPackage.Current.MinTestMethods;
            if (choice.IsWhole && tally.Methods < all)
                complaints.Add($"only {tally.Methods} test methods ran; the floor is {all}");
            if (choice.IsWhole && tally.DispatchingMethods < dispatching)
                complaints.Add($"only {tally.DispatchingMethods} test methods dispatched on the device; the floor is {dispatching}");
            return Summarize(choice, tally, facts, validation.Count, complaints, output);
        }

        static void CheckCategories(Choice choice, List<Assembly> assemblies)
        {
            List<string> there = assemblies.SelectMany(TestRun.Categories).Distinct().OrderBy(name => name, StringComparer.Ordinal).ToList();
            string unknown = choice.LeftOut.FirstOrDefault(name => !there.Contains(name));
            if (unknown != null)
                throw new HostException($"--leave-out {unknown}: no test has that category; there are {string.Join(", ", there)}.");
        }

        // A text that matches nothing is a mistake even beside others that do. One that matches tests of the other side is easily one.
        static void CheckFilters(Choice choice, List<Assembly> assemblies)
        {
            string option = choice.PackageOnly ? "--package-only" : "--host-only";
            List<Assembly> leftOut = choice.PackageOnly || choice.HostOnly ? TestAssemblies.LoadBuilt(choice.PackageOnly, choice.HostOnly)
                : new List<Assembly>();
            foreach (string text in choice.Texts)
            {
                var filter = new TextFilter(new[] { text }, choice.LeftOut);
                int others = Count(leftOut, filter);
                if (Count(assemblies, filter) == 0)
                    throw new HostException($"--filter {text}: no test has a full name that contains it" +
                        (others > 0 ? $"; {others} that {option} leaves out do." : ". --list names all."));
                if (others > 0)
                    Console.Error.WriteLine($"warning: --filter {text}: {option} leaves out {others} tests that match");
            }
        }

        static int Count(List<Assembly> assemblies, TestFilter filter) => assemblies.Sum(assembly => TestRun.List(assembly, filter).Count());

        static int ExecuteProject(Choice choice, bool list, int? jobs)
        {
            if (choice.PackageOnly || choice.HostOnly || choice.Assembly != null || choice.Worker != null)
                throw new HostException("--project runs the tests of that project alone; leave out what chooses among others.");
            if (jobs is not (null or 1))
                throw new HostException($"--jobs {jobs}: the tests of a project run in one process; leave it out.");
            TextWriter output = Console.Out;
            TestedProject project = TestedProject.Open(choice.Project, choice.Strict, output);
            if (list)
            {
                foreach (string name in project.Tests.SelectMany(assembly => TestRun.List(assembly, choice.Filter)))
                    output.WriteLine(name);
                return 0;
            }
            var tally = new TestTally(output, new TestDurations());
            using var session = new Session(project.Root, project.Mounts, project.Scripts.Assemblies, choice.Validation, choice.Strict,
                foreign: project.Scripts, editor: true);
            var run = new TestRun(tally.Add, choice.ShowsAll);
            foreach (Assembly assembly in project.Tests)
                run.Run(assembly, choice.Filter);
            session.PrintWarnings();
            TestFacts facts = TestFacts.Of(session, run);
            // Unity warns of such objects, and so does this.
            foreach (string left in facts.Left.Distinct())
                Console.Error.WriteLine("warning: " + left);
            foreach (KeyValuePair<string, int> call in project.Scripts.StubCalls)
                output.WriteLine($"not part of the host: {call.Key}, called {call.Value} times");
            return Summarize(choice, tally, new List<TestFacts> { facts }, facts.ValidationMessages.Count,
                facts.ValidationMessages.Select(message => "validation: " + message).ToList(), output);
        }

        static int Summarize(Choice choice, TestTally tally, List<TestFacts> facts, int validationMessages, List<string> complaints,
            TextWriter output)
        {
            if (tally.Passed + tally.Failed == 0)
                complaints.Add("no test ran");

            output.WriteLine();
            output.WriteLine($"device: {string.Join(" and ", facts.Select(process => process.Device).Distinct())}, with the limits of " +
                $"{Player.Limits.Title}");
            output.WriteLine(choice.Validation ? $"validation layer: {validationMessages} messages" : "validation layer: off (--no-validation)");
            output.WriteLine($"{tally.Methods} test methods, {tally.DispatchingMethods} of them dispatched on the device");
            ShadersOption.Report(output);
            if (choice.ForGpu > 0)
                output.WriteLine($"{choice.ForGpu} tests of the category {GpuOnly} left out, which run on a GPU or where a --filter names them");
            foreach (string complaint in complaints)
                output.WriteLine("FAILED " + complaint);
            int failed = tally.Failed + complaints.Count;
            output.WriteLine($"{tally.Passed} passed, {failed} failed" + (tally.Skipped > 0 ? $", {tally.Skipped} skipped" : ""));
            return failed == 0 ? 0 : 1;
        }

        static List<TestFacts> RunHere(Choice choice, List<Assembly> assemblies, TestTally tally)
        {
            using var session = new Session(Session.Root(), scripts: assemblies, validation: choice.Validation);
            var run = new TestRun(tally.Add, choice.ShowsAll, watchesStatics: true);
            foreach (Assembly assembly in assemblies)
                run.Run(assembly, choice.Filter);
            return new List<TestFacts> { TestFacts.Of(session, run) };
        }

        static List<TestFacts> RunJobs(Choice choice, List<Assembly> assemblies, int? jobs, TestTally tally, List<string> complaints)
        {
            ILookup<bool, string> fixtures = assemblies.SelectMany(assembly => TestRun.Fixtures(assembly, choice.Filter))
                .ToLookup(fixture => fixture.IsAlone, fixture => fixture.Name);
            // A process more costs seconds, and a fixture by itself is fastest with all cores.
            int processes = fixtures[false].Count() < 2 ? 1 : jobs ?? TestJobs.Default(choice.IsSoftware);
            if (processes == 1)
                return RunHere(choice, assemblies, tally);

            using var workers = new TestJobs(Arguments(choice), tally, choice.Limit);
            workers.Run(fixtures[false].ToList(), processes, alone: false);
            workers.Run(fixtures[true].ToList(), 1, alone: true);
            complaints.AddRange(workers.Complaints);
            foreach (TestFacts process in workers.Facts)
                ShaderBackend.Add(process.Programs, process.ExemptTests);
            return workers.Facts;
        }

        // Arguments with which a worker chooses and runs like this process.
        static List<string> Arguments(Choice choice)
        {
            var arguments = new List<string> { "--shaders", ShaderBackend.Current.Name, "--limits", Player.Limits.Name, "--culture",
                choice.Culture };
            arguments.AddRange(choice.Texts.SelectMany(text => new[] { "--filter", text }));
            arguments.AddRange(choice.AllLeftOut.SelectMany(category => new[] { "--leave-out", category }));
            if (choice.PackageOnly)
                arguments.Add("--package-only");
            if (choice.HostOnly)
                arguments.Add("--host-only");
            if (!choice.Validation)
                arguments.Add("--no-validation");
            if (choice.ShowsAll)
                arguments.Add("--output");
            if (choice.Assembly != null)
                arguments.AddRange(new[] { "--assembly", choice.Assembly });
            return arguments;
        }
    }
}
