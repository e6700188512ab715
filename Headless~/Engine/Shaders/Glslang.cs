using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>Runs glslangValidator, whose HLSL front end also inlines and drops dead code (it carries SPIRV-Tools' optimizer).</summary>
    static class Glslang
    {
        const string Tool = "glslangValidator";
        static readonly Regex Located = new Regex(@"^(?:ERROR: .*?:(\d+): (.*)|.*?\((\d+)\): (error .*))$");

        static readonly ShaderTool Program = new ShaderTool(Tool, "it compiles the shaders", "glslang-tools");

        /// <summary>Changes when the tool does; starts nothing.</summary>
        public static string Identity => Program.Identity;

        /// <exception cref="ShaderCompileException">Names the source line behind the first error.</exception>
        public static byte[] Compile(PreprocessedSource source, ShaderStage stage, string entryPoint, SourceLine entryLine)
        {
            string folder = Directory.CreateTempSubdirectory("rill-shader-").FullName;
            try
            {
                string input = Path.Combine(folder, "source.hlsl"), output = Path.Combine(folder, "out.spv");
                File.WriteAllText(input, source.Text);
                string stageName = stage == ShaderStage.Compute ? "comp" : stage == ShaderStage.Vertex ? "vert" : "frag";
                string log = Program.Run(new[]
                {
                    "-D", "-V", "--target-env", "vulkan1.1", "-S", stageName, "-e", entryPoint,
                    "--hlsl-dx-position-w",         // SV_Position.w as in Direct3D
                    "-fhlsl_functionality1",        // keeps the semantics' names
                    "-o", output, input,
                }, out int exitCode);
                // It leaves out what it cannot translate, reports it, and calls that a success.
                if (log.Contains("Missing functionality"))
                    throw new ShaderCompileException(entryLine.File, entryLine.Line, $"{entryPoint} uses something that glslang does " +
                        $"not translate: {log.Substring(log.IndexOf("Missing functionality", StringComparison.Ordinal)).Split('\n')[0]}");
                if (exitCode == 0 && File.Exists(output))
                    return File.ReadAllBytes(output);
                throw Error(log, exitCode, source, entryPoint, entryLine);
            }
            finally
            {
                Directory.Delete(folder, recursive: true);
            }
        }

        static ShaderCompileException Error(string log, int exitCode, PreprocessedSource source, string entryPoint, SourceLine entryLine)
        {
            foreach (string line in log.Split('\n'))
            {
                Match match = Located.Match(line.TrimEnd());
                if (!match.Success)
                    continue;
                string number = match.Groups[1].Success ? match.Groups[1].Value : match.Groups[3].Value;
                string message = match.Groups[2].Success ? match.Groups[2].Value : match.Groups[4].Value;
                int index = int.Parse(number) - 1;
                SourceLine where = index >= 0 && index < source.Lines.Count ? source.Lines[index] : entryLine;
                return new ShaderCompileException(where.File, where.Line, message.Trim());
            }
            return new ShaderCompileException(entryLine.File, entryLine.Line,
                $"{Tool} {(exitCode > 128 ? "crashed" : "failed")} with code {exitCode} on '{entryPoint}': {log.Trim()}");
        }
    }
}
