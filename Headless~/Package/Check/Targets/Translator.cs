using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Runs spirv-cross and glslangValidator; what they said is kept by content. Thread-safe.</summary>
    sealed class Translator
    {
        const string Version = "4";     // of how the tools are run: another makes what was kept worthless

        readonly string cache, cross, glslang;

        /// <param name="toolFolders">Null: those of the PATH.</param>
        /// <exception cref="FileNotFoundException">A tool is missing; says how to install it.</exception>
        public Translator(string cacheFolder, IReadOnlyList<string> toolFolders)
        {
            cache = Directory.CreateDirectory(Path.Combine(cacheFolder ?? ShaderCache.DefaultFolder(), "targets")).FullName;
            toolFolders ??= FxcInstallation.ToolFolders;
            cross = Find(toolFolders, "spirv-cross", "spirv-cross");
            glslang = Find(toolFolders, "glslangValidator", "glslang-tools");
        }

        static string Find(IReadOnlyList<string> folders, string tool, string package)
            => folders.Select(folder => Path.Combine(folder, tool)).FirstOrDefault(File.Exists)
                ?? throw new FileNotFoundException(
                    $"{tool} is not there; it shows what other graphics APIs make of the shaders (Debian: apt-get install {package}).");

        /// <summary>Null when the program becomes a text that its language's compiler takes; otherwise what is wrong, in a line.</summary>
        public string Try(ShaderProgram program, Translation translation)
        {
            string key = ShaderCache.Key(Version, Identity(cross), Identity(glslang), string.Join(" ", translation.Options),
                string.Join(" ", translation.ReadBack ?? new[] { "not" }), Convert.ToHexString(program.Spirv));
            string kept = Path.Combine(cache, key);
            if (!File.Exists(kept))
            {
                // Whoever looks meanwhile sees the whole file or none.
                string partial = kept + "." + Guid.NewGuid().ToString("N");
                File.WriteAllText(partial, Run(program, translation));
                File.Move(partial, kept, overwrite: true);
            }
            string problem = File.ReadAllText(kept);
            return problem.Length == 0 ? null : problem;
        }

        // A tool that changes, changes its file.
        static string Identity(string tool) => $"{tool} {new FileInfo(tool).Length} {File.GetLastWriteTimeUtc(tool).Ticks}";

        string Run(ShaderProgram program, Translation translation)
        {
            string folder = Directory.CreateTempSubdirectory("rill-target-").FullName;
            try
            {
                string input = Path.Combine(folder, "program.spv"), output = Path.Combine(folder, "program." + Translation.Suffix(program.Stage));
                File.WriteAllBytes(input, program.Spirv);
                string problem = Run(cross, folder, translation.Options.Concat(new[] { "--output", output, input }));
                if (problem == null && translation.ReadBack != null)
                    problem = Run(glslang, folder, translation.ReadBack.Append(output));
                return problem ?? "";
            }
            finally
            {
                Directory.Delete(folder, recursive: true);
            }
        }

        // The line with the reason, when it fails.
        static string Run(string tool, string folder, IEnumerable<string> arguments)
        {
            var start = new ProcessStartInfo(tool, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true,
                RedirectStandardError = true };
            using Process process = Process.Start(start);
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string[] lines = (process.StandardOutput.ReadToEnd() + "\n" + errors.Result)
                .Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
            process.WaitForExit();
            if (process.ExitCode == 0)
                return null;
            return $"{Path.GetFileName(tool)}: " +
                $"{lines.FirstOrDefault(l => l.Contains("ERROR:") || l.Contains("exception:")) ?? lines.FirstOrDefault() ?? "failed with code " + process.ExitCode}";
        }
    }
}
