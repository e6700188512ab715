using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Translation of every program for graphics APIs beside Direct3D 11; it has to succeed for those stated as supported.</summary>
    sealed class TargetsRule : Rule
    {
        readonly string cacheFolder;
        readonly IReadOnlyList<string> toolFolders;
        readonly IReadOnlyList<Target> targets;

        public TargetsRule() : this(null, null, Target.All) { }

        public TargetsRule(string cacheFolder, IReadOnlyList<string> toolFolders, IReadOnlyList<Target> targets)
        {
            this.cacheFolder = cacheFolder;
            this.toolFolders = toolFolders;
            this.targets = targets;
        }

        public override string Name
            => $"other targets: every kernel and stage fits {string.Join(" and ", targets.Where(t => t.Supported).Select(t => t.Name))}";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            IReadOnlyList<ShaderVariant> variants = PackageShaders.Variants(package, cacheFolder, findings, out _);
            Translator translator;
            try
            {
                translator = new Translator(cacheFolder, toolFolders);
            }
            catch (FileNotFoundException e)
            {
                findings.Fault(e.Message);
                return findings;
            }

            var verdicts = new Verdict[variants.Count];
            Parallel.For(0, variants.Count, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
                i => verdicts[i] = Examine(variants[i], translator));
            Report(verdicts, findings);
            findings.Looked = $"{variants.Count} programs on {string.Join(", ", targets.Select(t => t.Name))}";
            return findings;
        }

        sealed class Verdict
        {
            public ShaderVariant Variant;
            /// <summary>Reason why it is not a program at all here; null when it is.</summary>
            public string Fault;
            public ProgramNeeds Needs;
            /// <summary>A target each: empty when the program runs there.</summary>
            public string[] Reasons;
        }

        Verdict Examine(ShaderVariant variant, Translator translator)
        {
            try
            {
                ShaderProgram program = variant.Compile().Program;
                var needs = new ProgramNeeds(program);
                string Reason(Target target)
                {
                    string[] excesses = target.Limits.Excesses(needs).ToArray();
                    // To translate takes long: what does not run on a target that is not stated as supported need not be translated to know it.
                    if (target.Translation != null && (target.Supported || excesses.Length == 0))
                        excesses = excesses.Append(translator.Try(program, target.Translation)).Where(reason => reason != null).ToArray();
                    return string.Join("; ", excesses);
                }

                return new Verdict { Variant = variant, Needs = needs, Reasons = targets.Select(Reason).ToArray() };
            }
            catch (ShaderCompileException e)
            {
                return new Verdict { Variant = variant, Fault = e.Message };
            }
        }

        void Report(Verdict[] verdicts, Findings findings)
        {
            var table = new ResultTable
            {
                Title = "Other targets",
                About = "What each program needs, and whether it fits: Metal as MSL 2.1 and OpenGL ES 3.1 as GLSL, both as " +
                    "SPIRV-Cross writes them (Unity has a translator of its own), the latter read back by glslang; "
                    + "Vulkan, on which the tests run these programs, mobile devices and WebGPU by their limits alone; OpenGL ES 3.1 " +
                    "by the least that the specification grants. The host's own programs are judged: they are what Direct3D's " +
                    "defines select, and subtract the base vertex as Direct3D does, which OpenGL ES lacks.",
                Columns = new[] { "file", "kernel or stage", "keywords", "storage buffers", "textures", "threads",
                    "shared B" }.Concat(targets.Select(t => t.Name)).ToArray(),
            };
            foreach (Verdict verdict in verdicts)
            {
                ShaderVariant variant = verdict.Variant;
                if (verdict.Fault != null)
                {
                    findings.Fault($"{verdict.Fault}; in {variant}");
                    continue;
                }
                ProgramNeeds needs = verdict.Needs;
                table.Rows.Add(new[]
                {
                    variant.File, variant.Program, variant.Keywords.Length > 0 ? variant.Keywords : "-", needs.StorageBuffers.ToString(),
                        (needs.Textures + needs.StorageTextures + needs.TypedBuffers).ToString(),
                    needs.Threads > 0 ? needs.Threads.ToString() : "-", needs.GroupsharedBytes.ToString(),
                }.Concat(verdict.Reasons.Select(reason => reason.Length == 0 ? "yes" : "no: " + reason)).ToArray());
                foreach ((Target target, string reason) in targets.Zip(verdict.Reasons).Where(pair => pair.First.Supported && pair.Second.Length > 0))
                    findings.Fault($"{variant} does not run on {target.Name}: {reason}");
            }
            findings.Tables.Add(table);
        }
    }
}
