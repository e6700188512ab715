using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;

namespace Host.Output
{
    /// <summary>A program on the PATH that makes pictures or films. Without it they are left out: what was computed is written all the
    /// same.</summary>
    sealed class Tool
    {
        public static readonly Tool Gnuplot = new("gnuplot", "gnuplot-nox"), Ffmpeg = new("ffmpeg", "ffmpeg");

        readonly string program, package;

        /// <param name="package">Debian's.</param>
        public Tool(string program, string package)
        {
            this.program = program;
            this.package = package;
        }

        public bool IsInstalled => (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator)
            .Any(folder => folder.Length > 0 && File.Exists(Path.Combine(folder, program)));

        /// <summary>That it is not installed, and the package to install.</summary>
        public string NotInstalled => $"{program} is not installed (Debian package {package})";

        /// <summary>Says in one warning what cannot be made here. To be called before the work that it would show.</summary>
        /// <param name="wanted">A tool with what a command makes by it: "plots"; null for nothing.</param>
        public static void WarnOfMissing(params (Tool Tool, string Products)[] wanted)
        {
            string[] missing = wanted.Where(want => want.Products != null && !want.Tool.IsInstalled)
                .Select(want => $"{want.Tool.NotInstalled}: no {want.Products}").ToArray();
            if (missing.Length > 0)
                Console.Error.WriteLine("warning: " + string.Join("; ", missing));
        }

        /// <exception cref="HostException">It is not installed, or it failed; with what it wrote last.</exception>
        public void Run(IEnumerable<string> arguments, string input = null)
        {
            var start = new ProcessStartInfo(program, arguments) { RedirectStandardError = true, RedirectStandardOutput = true,
                RedirectStandardInput = true };
            Process process;
            try
            {
                process = Process.Start(start);
            }
            catch (Win32Exception)
            {
                throw new HostException(NotInstalled + ".");
            }
            using (process)
            {
                var output = process.StandardOutput.ReadToEndAsync();
                var errors = process.StandardError.ReadToEndAsync();
                try
                {
                    process.StandardInput.Write(input);
                    process.StandardInput.Close();
                }
                catch (IOException)
                {
                    // It ended before it had read all; its exit code says whether that is a fault.
                }
                process.WaitForExit();
                if (process.ExitCode != 0)
                    throw new HostException($"{program} failed with exit code {process.ExitCode}: {LastLines(errors.Result + output.Result)}");
            }
        }

        static string LastLines(string text) => string.Join(" | ",
            text.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0).TakeLast(4));
    }
}
