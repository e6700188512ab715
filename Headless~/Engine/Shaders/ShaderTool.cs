using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;

namespace Host.Shaders
{
    /// <summary>A program of others on the PATH.</summary>
    sealed class ShaderTool
    {
        readonly string name;
        readonly Lazy<string> identity;

        /// <param name="purpose">For the message when it is not there: "it compiles the shaders".</param>
        /// <param name="package">Debian's.</param>
        public ShaderTool(string name, string purpose, string package)
        {
            this.name = name;
            identity = new Lazy<string>(() =>
            {
                string path = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Where(f => f.Length > 0)
                    .Select(f => Path.Combine(f, name)).FirstOrDefault(File.Exists);
                if (path == null)
                    throw new InvalidOperationException($"{name} is not on the PATH; {purpose} (Debian: apt-get install {package}).");
                var file = new FileInfo(path);
                return $"{path} {file.Length} {file.LastWriteTimeUtc.Ticks}";
            });
        }

        /// <summary>Changes when the tool does; starts nothing.</summary>
        /// <exception cref="InvalidOperationException">It is not there; says what to install.</exception>
        public string Identity => identity.Value;

        /// <returns>What it wrote, errors behind the rest.</returns>
        public string Run(IEnumerable<string> arguments, out int exitCode)
        {
            _ = Identity;   // says what to install when there is none
            var start = new ProcessStartInfo(name) { RedirectStandardOutput = true, RedirectStandardError = true };
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            using Process process = Process.Start(start);
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string log = process.StandardOutput.ReadToEnd() + errors.Result;
            process.WaitForExit();
            exitCode = process.ExitCode;
            return log;
        }
    }
}
