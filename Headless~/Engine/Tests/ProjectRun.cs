using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Reflection;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>`rill test --project` in a process of its own: scripts that were loaded once stay.</summary>
    sealed class ProjectRun
    {
        public readonly int ExitCode;
        /// <summary>Lines of both streams, in the order of each.</summary>
        public readonly string[] Output, Errors;

        public ProjectRun(string project, params string[] more)
        {
            var arguments = new List<string> { Assembly.GetEntryAssembly().Location, "test", "--no-validation", "--project", project };
            arguments.AddRange(more);
            using var process = Process.Start(new ProcessStartInfo("dotnet", arguments) { RedirectStandardOutput = true,
                RedirectStandardError = true });
            var errors = process.StandardError.ReadToEndAsync();
            Output = Lines(process.StandardOutput.ReadToEnd());
            Errors = Lines(errors.Result);
            process.WaitForExit();
            ExitCode = process.ExitCode;
        }

        static string[] Lines(string text) => text.Split('\n', StringSplitOptions.RemoveEmptyEntries);

        public string Everything => string.Join("\n", Output) + "\n" + string.Join("\n", Errors);

        /// <summary>It ended so, and one line, error or not, has all of these words.</summary>
        public void MustHaveEnded(int exitCode, params string[] words)
        {
            Assert.That(ExitCode, Is.EqualTo(exitCode), Everything);
            foreach (string word in words)
                Assert.That(Everything, Does.Contain(word));
        }
    }
}
