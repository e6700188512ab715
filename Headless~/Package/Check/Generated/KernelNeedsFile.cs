using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>
    /// The package's table of what each of its programs takes of a device, by reflection: a row for each variant of a kernel,
    /// and one for each stage of a draw shader with the most of all its passes.
    /// </summary>
    sealed class KernelNeedsFile : GeneratedFile
    {
        const string Folder = "Shaders/";

        readonly string cacheFolder;

        public KernelNeedsFile() : this(null) { }

        public KernelNeedsFile(string cacheFolder) => this.cacheFolder = cacheFolder;

        public override string Path => "Runtime/Gpu/Device/KernelNeeds.Generated.cs";

        public override string Text(PackageTree package, Findings findings)
        {
            var faults = new Findings();
            List<ShaderVariant> variants = PackageShaders.Variants(package, cacheFolder, faults,
                out _).Where(v => v.File.StartsWith(Folder, StringComparison.Ordinal)).ToList();
            if (variants.Count == 0)
                return null;
            var programs = variants.AsParallel().AsOrdered().Select(Compile).ToList();
            foreach ((ShaderVariant variant, ShaderProgram _, string fault) in programs.Where(p => p.fault != null))
                faults.Fault($"{variant}: {fault}");
            foreach (string fault in faults.Faults)
                findings.Fault(fault);
            if (faults.Faults.Count > 0)
                return null;

            var text = new StringBuilder();
            text.Append("// Generated from the reflection of Shaders/ by `Headless~/rill generate`; `rill check` compares it. Do not edit.\n");
            text.Append("namespace Rill\n{\n    static partial class KernelNeeds\n    {\n");
            text.Append("        // file, kernel, defines of its #pragma line and keywords; threads, groupshared bytes; storage buffers, " +
                "writable resources, textures\n");
            Append(text, "Kernels", programs.Where(p => p.variant.Stage == ShaderStage.Compute).Select(p => Row(p.variant, p.program)));
            text.Append("\n        // file, stage; the most of all passes and keywords\n");
            Append(text, "Draws", programs.Where(p => p.variant.Stage != ShaderStage.Compute).GroupBy(p => (p.variant.File,
                p.variant.Stage)).Select(stage => DrawRow(stage.Key.File, stage.Key.Stage, stage.Select(p => p.program))));
            text.Append("    }\n}\n");
            return text.ToString();
        }

        static (ShaderVariant variant, ShaderProgram program, string fault) Compile(ShaderVariant variant)
        {
            try
            {
                return (variant, variant.Compile().Program, null);
            }
            catch (ShaderCompileException e)
            {
                return (variant, null, e.Message);
            }
        }

        static void Append(StringBuilder text, string name, IEnumerable<string> rows)
        {
            text.Append($"        static readonly KernelNeed[] {name} =\n        {{\n");
            foreach (string row in rows)
                text.Append($"            {row},\n");
            text.Append("        };\n");
        }

        static string Row(ShaderVariant variant, ShaderProgram program)
        {
            var needs = new ProgramNeeds(program);
            string defines = string.Join(" ", new[] { variant.Defines, variant.Keywords }.Where(words => words.Length > 0));
            return Row(variant.File, variant.Program, defines, needs.Threads, needs.GroupsharedBytes, needs.StorageBuffers, program.UavCount,
                needs.Textures + needs.StorageTextures + needs.TypedBuffers);
        }

        static string DrawRow(string file, ShaderStage stage, IEnumerable<ShaderProgram> programs)
        {
            List<(ProgramNeeds needs, int writable)> all = programs.Select(program => (new ProgramNeeds(program), program.UavCount)).ToList();
            return Row(file, stage.ToString(), "", 0, 0, all.Max(p => p.needs.StorageBuffers), all.Max(p => p.writable),
                all.Max(p => p.needs.Textures + p.needs.StorageTextures + p.needs.TypedBuffers));
        }

        static string Row(string file, string program, string defines, int threads, int shared, int storage, int writable, int textures) =>
            $"new KernelNeed(\"{System.IO.Path.GetFileNameWithoutExtension(file)}\", \"{program}\", \"{defines}\", {threads}, {shared}, " +
            $"{storage}, {writable}, {textures})";
    }
}
