using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>A .compute file. Kernels compile when first asked for; any thread may ask.</summary>
    sealed class ComputeFile : ComputeShaderSource
    {
        const int Target = 50;

        sealed class Kernel
        {
            public string Name;
            public SourceLine Where;
            public List<KeyValuePair<string, string>> Defines = new List<KeyValuePair<string, string>>();
        }

        readonly ShaderCompiler compiler;
        readonly List<SourceSegment> segments;
        readonly List<Kernel> kernels;
        readonly Keywords keywords;
        readonly ConcurrentDictionary<string, Lazy<CompiledProgram>> programs = new ConcurrentDictionary<string, Lazy<CompiledProgram>>();

        public ComputeFile(string filePath, string displayPath, ShaderCompiler compiler)
        {
            this.compiler = compiler;
            Path = displayPath;
            segments = new List<SourceSegment> { new SourceSegment { Text = SourceText.Read(filePath),
                DiskPath = System.IO.Path.GetFullPath(filePath), DisplayPath = displayPath } };
            List<PragmaLine> pragmas = compiler.ReadPragmas(segments, ShaderStage.Compute, Target);
            keywords = new Keywords(pragmas);
            kernels = pragmas.Select(ParseKernel).Where(k => k != null).ToList();
        }

        public override string Path { get; }
        public override IReadOnlyList<string> Kernels => kernels.ConvertAll(k => k.Name);
        public override IReadOnlyList<string> Keywords => keywords.All;

        public override ShaderProgram Compile(int kernel, ICollection<string> enabledKeywords)
            => CompileKernel(kernels[kernel], enabledKeywords).Program;

        /// <summary>Every kernel under every choice of keywords that makes a difference to it.</summary>
        /// <exception cref="ShaderCompileException">The keywords make too many.</exception>
        public IReadOnlyList<ShaderVariant> AllVariants()
        {
            var variants = new List<ShaderVariant>();
            foreach (Kernel kernel in kernels)
            {
                var list = new VariantList(compiler, Path, kernel.Name);
                foreach (string[] enabled in keywords.Choices(Path))
                    list.Add(Request(kernel, enabled), enabled, () => CompileKernel(kernel, enabled),
                        string.Join(" ", kernel.Defines.Where(d => d.Value != kernel.Name).Select(d => d.Key)));
                variants.AddRange(list.Variants);
            }
            return variants;
        }

        CompiledProgram CompileKernel(Kernel kernel, ICollection<string> enabledKeywords)
        {
            string key = kernels.IndexOf(kernel) + " "
                + string.Join(" ", keywords.Select(ShaderStage.Compute, enabledKeywords).Select(d => d.Key + "=" + d.Value));
            return programs.GetOrAdd(key, _ => new Lazy<CompiledProgram>(() => compiler.Compile(Request(kernel, enabledKeywords)))).Value;
        }

        CompileRequest Request(Kernel kernel, ICollection<string> enabledKeywords) => new CompileRequest
        {
            Name = $"{Path} ({string.Join(", ", keywords.All.Where(name => enabledKeywords != null && enabledKeywords.Contains(name)).Prepend(kernel.Name))})",
            Stage = ShaderStage.Compute,
            Target = Target,
            EntryPoint = kernel.Name,
            EntryLine = kernel.Where,
            Segments = segments,
            Defines = ShaderCompiler.PlatformDefines(ShaderStage.Compute, Target)
                .Concat(keywords.Select(ShaderStage.Compute, enabledKeywords)).Concat(kernel.Defines).ToList(),
        };

        // "kernel Name DEF=1 OTHER"; null for other pragmas.
        static Kernel ParseKernel(PragmaLine pragma)
        {
            string[] words = pragma.Text.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
            if (words[0] != "kernel")
                return null;
            if (words.Length < 2)
                throw new ShaderCompileException(pragma.Where.File, pragma.Where.Line, "#pragma kernel needs a name");
            var kernel = new Kernel { Name = words[1], Where = pragma.Where };
            foreach (string define in words.Skip(2))
            {
                int equals = define.IndexOf('=');
                kernel.Defines.Add(equals < 0 ? KeyValuePair.Create(define, "1")
                    : KeyValuePair.Create(define.Substring(0, equals), define.Substring(equals + 1)));
            }
            return kernel;
        }
    }
}
