using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.Testing;
using NUnit.Framework.Internal;
using UnityEngine.Headless;

namespace Host.Commands
{
    /// <summary><c>test</c>: the host's and the package's tests, in this process, on one device with the validation layer on.</summary>
    static class TestCommand
    {
        // A suite that shrinks, or that no longer reaches the device, must not look well.
        const int MinMethods = 800, MinDispatchingMethods = 250;

        public static Command Create()
        {
            var filter = new Option<string[]>("--filter") { Description = "Only tests whose full name contains this text; may come several times.", DefaultValueFactory = _ => Array.Empty<string>() };
            var list = new Option<bool>("--list") { Description = "Name the tests, run none." };
            var package = new Option<bool>("--package-only") { Description = "Only the package's tests." };
            var host = new Option<bool>("--host-only") { Description = "Only the host's own tests." };
            var noValidation = new Option<bool>("--no-validation") { Description = "Without Vulkan's validation layer, where it is not installed." };
            var written = new Option<bool>("--output") { Description = "Also print what tests wrote that passed: their figures." };
            Option<string> shaders = ShadersOption.Create();
            Option<string> limits = LimitsOption.Create();
            var command = new Command("test", "Runs the tests.") { filter, list, package, host, noValidation, written, shaders, limits };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                LimitsOption.Use(parsed.GetValue(limits));
                return Execute(parsed.GetValue(filter), parsed.GetValue(list), parsed.GetValue(package), parsed.GetValue(host), !parsed.GetValue(noValidation), parsed.GetValue(written));
            });
            return command;
        }

        static int Execute(string[] texts, bool list, bool packageOnly, bool hostOnly, bool validation, bool showsAll)
        {
            if (packageOnly && hostOnly)
                throw new HostException("--package-only and --host-only leave nothing to run; name one of them.");
            List<Assembly> assemblies = TestAssemblies.Load(host: !packageOnly, package: !hostOnly);
            TestFilter filter = texts.Length == 0 ? TestFilter.Empty : new TextFilter(texts);

            TextWriter output = Console.Out;
            if (list)
            {
                foreach (string name in assemblies.SelectMany(assembly => TestRun.List(assembly, filter)))
                    output.WriteLine(name);
                return 0;
            }

            using var session = new Session(Session.Root(), scripts: assemblies, validation: validation);
            var run = new TestRun(output, showsAll);
            foreach (Assembly assembly in assemblies)
                run.Run(assembly, filter);

            var complaints = new List<string>();
            complaints.AddRange(run.NameLeft(session.End()));
            complaints.AddRange(session.ValidationMessages.Select(message => "validation: " + message));
            bool whole = texts.Length == 0 && !packageOnly && !hostOnly;
            if (whole && run.Methods < MinMethods)
                complaints.Add($"only {run.Methods} test methods ran; the floor is {MinMethods}");
            if (whole && run.DispatchingMethods < MinDispatchingMethods)
                complaints.Add($"only {run.DispatchingMethods} test methods dispatched on the device; the floor is {MinDispatchingMethods}");
            if (run.Passed + run.Failed == 0)
                complaints.Add("no test ran");

            output.WriteLine();
            output.WriteLine($"device: {session.DescribeDevice()}, with the limits of {Player.Limits.Title}");
            output.WriteLine(validation ? $"validation layer: {session.ValidationMessages.Count} messages" : "validation layer: off (--no-validation)");
            output.WriteLine($"{run.Methods} test methods, {run.DispatchingMethods} of them dispatched on the device");
            ShadersOption.Report(output);
            foreach (string complaint in complaints)
                output.WriteLine("FAILED " + complaint);
            int failed = run.Failed + complaints.Count;
            output.WriteLine($"{run.Passed} passed, {failed} failed" + (run.Skipped > 0 ? $", {run.Skipped} skipped" : ""));
            return failed == 0 ? 0 : 1;
        }
    }
}
