using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>One entry point of one variant, to be compiled.</summary>
    sealed class CompileRequest
    {
        /// <summary>For messages: "Shaders/PrefixSum.compute (SumTiles)".</summary>
        public string Name;
        public ShaderStage Stage;
        /// <summary>As in #pragma target: 50 for shader model 5.0.</summary>
        public int Target;
        public string EntryPoint;
        /// <summary>Where the entry point is named, for faults that have no line of their own.</summary>
        public SourceLine EntryLine;
        public List<SourceSegment> Segments;
        public List<KeyValuePair<string, string>> Defines = new List<KeyValuePair<string, string>>();
        /// <summary>Fragment programs: what the vertex program of the same pass writes.</summary>
        public Varying[] VertexOutputs = Array.Empty<Varying>();
    }

    /// <summary>From source to program: preprocess, look into the cache, compile, rewrite.</summary>
    sealed class ShaderCompiler
    {
        // What FXC knows and glslang (12.0) does not, or gets wrong.
        static readonly SourceSegment Dialect = new SourceSegment
        {
            DisplayPath = "(dialect)",
            Text = "#define ldexp(x, e) ((x) * exp2(e))\n" +
                "#define InterlockedCompareStore(d, c, v) do { uint rill_before; InterlockedCompareExchange(d, c, v, rill_before); } while (false)\n",
        };

        readonly IncludeResolver resolver;
        readonly ShaderCache cache;

        public ShaderCompiler(IncludeResolver resolver, ShaderCache cache)
        {
            this.resolver = resolver;
            this.cache = cache;
        }

        /// <summary>What Unity's compiler for Direct3D 11 defines.</summary>
        /// <param name="target">SHADER_TARGET: 50 for shader model 5.0.</param>
        public static List<KeyValuePair<string, string>> PlatformDefines(ShaderStage stage, int target)
        {
            List<KeyValuePair<string, string>> defines = Direct3D11(stage, target);
            if (!Player.LinearColorSpace)
                defines.Add(KeyValuePair.Create("UNITY_COLORSPACE_GAMMA", "1"));
            return defines;
        }

        static List<KeyValuePair<string, string>> Direct3D11(ShaderStage stage, int target) => new List<KeyValuePair<string, string>>
        {
            KeyValuePair.Create("SHADER_API_D3D11", "1"),
            KeyValuePair.Create("SHADER_API_DESKTOP", "1"),
            KeyValuePair.Create("UNITY_COMPILER_HLSL", "1"),
            KeyValuePair.Create("UNITY_VERSION", "202230"),
            KeyValuePair.Create("UNITY_REVERSED_Z", "1"),
            KeyValuePair.Create("UNITY_UV_STARTS_AT_TOP", "1"),
            KeyValuePair.Create("SHADER_TARGET", target.ToString()),
            KeyValuePair.Create(stage == ShaderStage.Compute ? "SHADER_STAGE_COMPUTE" : stage == ShaderStage.Vertex ? "SHADER_STAGE_VERTEX" : "SHADER_STAGE_FRAGMENT", "1"),
        };

        public List<PragmaLine> ReadPragmas(List<SourceSegment> segments, ShaderStage stage, int target)
            => Preprocessor.ReadPragmas(segments, PlatformDefines(stage, target), resolver);

        /// <exception cref="ShaderCompileException"/>
        public string Preprocess(List<SourceSegment> segments, List<KeyValuePair<string, string>> defines) => Preprocessor.Run(segments, defines, resolver).Text;

        /// <exception cref="ShaderCompileException"/>
        public CompiledProgram Compile(CompileRequest request)
        {
            PreprocessedSource source = Preprocessor.Run(request.Segments.Prepend(Dialect), request.Defines, resolver);
            string outputs = string.Join(" ", request.VertexOutputs.Select(o => $"{o.Semantic}:{o.Location}:{o.Components}"));
            string key = ShaderCache.Key(ProgramBuilder.Version, Glslang.Identity, request.Stage.ToString(), request.EntryPoint, outputs, source.Text);

            CompiledProgram compiled = cache.Find(key);
            if (compiled == null)
            {
                compiled = Build(source, request);
                cache.Store(key, compiled);
            }
            compiled.Program.Name = request.Name;   // the same content may lie in another file
            return compiled;
        }

        /// <summary>The same for FXC. Fast: only preprocesses.</summary>
        /// <exception cref="ShaderCompileException"/>
        public FxcRequest ForFxc(CompileRequest request)
        {
            PreprocessedSource source = Preprocessor.Run(request.Segments, request.Defines, resolver, SourceReader.Fxc);
            return new FxcRequest
            {
                Name = request.Name,
                Source = source,
                EntryPoint = request.EntryPoint,
                EntryLine = request.EntryLine,
                Profile = FxcDialect.Profile(request.Stage, request.Target),
                Flags = FxcDialect.Flags(source, request.Stage),
            };
        }

        static CompiledProgram Build(PreprocessedSource source, CompileRequest request)
        {
            try
            {
                source.Text = LegacySyntax.Rewrite(source.Text);
            }
            catch (LegacySyntaxException e)
            {
                SourceLine where = e.Line < source.Lines.Count ? source.Lines[e.Line] : request.EntryLine;
                throw new ShaderCompileException(where.File, where.Line, e.Message);
            }
            var declarations = new SourceDeclarations(source.Text);
            // glslang would make an empty program of an entry point that it does not find, and one thread of no [numthreads].
            if (!declarations.HasFunction(request.EntryPoint))
                throw new ShaderCompileException(request.EntryLine.File, request.EntryLine.Line, request.Stage == ShaderStage.Compute
                    ? $"kernel '{request.EntryPoint}' not found" : $"entry point '{request.EntryPoint}' not found");
            byte[] spirv = Glslang.Compile(source, request.Stage, request.EntryPoint, request.EntryLine);
            try
            {
                if (request.Stage == ShaderStage.Compute && !declarations.HasNumThreads(request.EntryPoint))
                    throw new ProgramException("a kernel needs [numthreads(x,y,z)]");
                return ProgramBuilder.Build(spirv, request.Name, request.Stage, declarations, request.VertexOutputs);
            }
            catch (ProgramException e)
            {
                throw new ShaderCompileException(request.EntryLine.File, request.EntryLine.Line, $"in '{request.EntryPoint}': {e.Message}");
            }
        }
    }
}
