using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
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
                bool made = exitCode == 0 && File.Exists(output);
                List<string> remarks = log.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0 && !Harmless.Any(known => known.IsMatch(line))).Distinct().ToList();
                // It leaves out what it does not know, says so, and calls that a success.
                if (!made || remarks.Count > 0)
                    throw new ProgramException($"{Tool} cannot translate it: {string.Join("; ", remarks)}");
                return File.ReadAllBytes(output);
            }
            finally
            {
                Directory.Delete(folder, recursive: true);
            }
        }

        // What it remarks on (in version 1.2) where nothing is wrong.
        static readonly Regex[] Harmless =
        {
            // The type that shader model 5 repeats in each load.
            new Regex("^fixme:shader_sm4_read_instruction_modifier: "),
            // Which barrier it should be is read from the bytecode (Vkd3dProgram.Rewrite).
            new Regex("^fixme:vkd3d_dxbc_compiler_emit_sync: Unhandled sync flags"),
            // 0x2 globallycoherent, read from the bytecode too; 0x100 a counter.
            new Regex("^fixme:vkd3d_dxbc_compiler_emit_dcl_resource_(structured|raw|typed): Unhandled UAV flags 0x(2|100|102)\\.$"),
            // Least precisions (min16float): more is allowed. With more bits set it would also drop a sign.
            new Regex("^fixme:shader_sm4_read_param: Skipping modifier 0x000(04|08|10|14)001\\.$"),
            // Bits for refactoring allowed, raw buffers, no optimization, least precisions.
            new Regex("^fixme:vkd3d_dxbc_compiler_emit_dcl_global_flags: Unhandled global flags 0x[0123]?[0189]\\.$"),
        };

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
