using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.Linq;

namespace Host.Output
{
    /// <summary>Runs a program that the host depends on.</summary>
    static class Tool
    {
        /// <exception cref="HostException">It is not installed, or it failed; with what it wrote last.</exception>
        public static void Run(string program, string package, IEnumerable<string> arguments, string input = null)
        {
            var start = new ProcessStartInfo(program, arguments) { RedirectStandardError = true, RedirectStandardOutput = true, RedirectStandardInput = true };
            Process process;
            try
            {
                process = Process.Start(start);
            }
            catch (Win32Exception)
            {
                throw new HostException($"{program} is not installed; it comes with the Debian package {package}.");
            }
            using (process)
            {
                var output = process.StandardOutput.ReadToEndAsync();
                var errors = process.StandardError.ReadToEndAsync();
                if (input != null)
                    process.StandardInput.Write(input);
                process.StandardInput.Close();
                process.WaitForExit();
                if (process.ExitCode != 0)
                    throw new HostException($"{program} failed with exit code {process.ExitCode}: {LastLines(errors.Result + output.Result)}");
            }
        }

        static string LastLines(string text) => string.Join(" | ", text.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0).TakeLast(4));
    }
}
