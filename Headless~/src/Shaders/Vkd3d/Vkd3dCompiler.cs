using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;

namespace Host.Shaders
{
    /// <summary>Runs vkd3d-compiler, which translates Direct3D's bytecode to SPIR-V.</summary>
    static class Vkd3dCompiler
    {
        const string Tool = "vkd3d-compiler";

        static readonly Lazy<string> identity = new Lazy<string>(() =>
        {
            string path = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Where(f => f.Length > 0).Select(f => Path.Combine(f, Tool)).FirstOrDefault(File.Exists);
            if (path == null)
                throw new InvalidOperationException($"{Tool} is not on the PATH; it translates what FXC emits (Debian: apt-get install {Tool}).");
            var file = new FileInfo(path);
            return $"{path} {file.Length} {file.LastWriteTimeUtc.Ticks}";
        });

        /// <summary>Changes when the tool does; starts nothing.</summary>
        public static string Identity => identity.Value;

        /// <exception cref="ProgramException">It cannot translate the program; the message says why in its words.</exception>
        public static byte[] Translate(byte[] dxbc)
        {
            _ = Identity;   // says what to install when there is none
            string folder = Directory.CreateTempSubdirectory("rill-shader-").FullName;
            try
            {
                string input = Path.Combine(folder, "in.dxbc"), output = Path.Combine(folder, "out.spv");
                File.WriteAllBytes(input, dxbc);
                string log = Run(new[] { "-x", "dxbc-tpf", "-b", "spirv-binary", "-o", output, input }, out int exitCode);
                if (exitCode == 0 && File.Exists(output))
                    return File.ReadAllBytes(output);
                IEnumerable<string> reasons = log.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0 && !IsHarmless(line)).Distinct();
                throw new ProgramException($"{Tool} cannot translate it: {string.Join("; ", reasons)}");
            }
            finally
            {
                Directory.Delete(folder, recursive: true);
            }
        }

        // It remarks on the type that shader model 5 repeats in each load, and goes on without it.
        static bool IsHarmless(string line) => line.StartsWith("fixme:shader_sm4_read_instruction_modifier");

        static string Run(IEnumerable<string> arguments, out int exitCode)
        {
            var start = new ProcessStartInfo(Tool) { RedirectStandardOutput = true, RedirectStandardError = true };
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
