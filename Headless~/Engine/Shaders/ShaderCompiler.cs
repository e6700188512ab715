using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>One entry point of one variant, to be compiled.</summary>
    sealed class CompileRequest
    {
        /// <summary>For messages: "Shaders/Gpu/PrefixSum.compute (SumTiles)".</summary>
        public string Name;
        public ShaderStage Stage;
        /// <summary>Value of #pragma target: 50 for shader model 5.0.</summary>
        public int Target;
        public string EntryPoint;
        /// <summary>Line that names the entry point, for faults without a line of their own.</summary>
        public SourceLine EntryLine;
        public List<SourceSegment> Segments;
        public List<KeyValuePair<string, string>> Defines = new List<KeyValuePair<string, string>>();
        /// <summary>Fragment programs: what the vertex program of the same pass writes.</summary>
        public Varying[] VertexOutputs = Array.Empty<Varying>();
        /// <summary>Finds its includes; set by the compiler.</summary>
        public IncludeResolver Resolver;

        /// <summary>A fault of the whole program.</summary>
        public ShaderCompileException Fault(ProgramException e)
            => new ShaderCompileException(EntryLine.File, EntryLine.Line, $"in '{EntryPoint}': {e.Message}");
    }

    /// <summary>From source to program: preprocess, look into the cache, compile, rewrite.</summary>
    sealed class ShaderCompiler
    {
        readonly IncludeResolver resolver;
        readonly ShaderCache cache;
        readonly IShaderBackend backend;

        /// <param name="backend">Null: the one in use.</param>
        public ShaderCompiler(IncludeResolver resolver, ShaderCache cache, IShaderBackend backend = null)
        {
            this.resolver = resolver;
            this.cache = cache;
            this.backend = backend ?? ShaderBackend.Current;
        }

        /// <summary>Symbols that Unity's compiler for Direct3D 11 defines.</summary>
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
            KeyValuePair.Create(stage == ShaderStage.Compute ? "SHADER_STAGE_COMPUTE" : stage == ShaderStage.Vertex ? "SHADER_STAGE_VERTEX"
                : "SHADER_STAGE_FRAGMENT", "1"),
        };

        public List<PragmaLine> ReadPragmas(List<SourceSegment> segments, ShaderStage stage, int target)
            => Preprocessor.ReadPragmas(segments, PlatformDefines(stage, target), resolver);

        /// <exception cref="ShaderCompileException"/>
        public string Preprocess(List<SourceSegment> segments, List<KeyValuePair<string, string>> defines)
            => Preprocessor.Run(segments, defines, resolver).Text;

        /// <exception cref="ShaderCompileException"/>
        public CompiledProgram Compile(CompileRequest request)
        {
            request.Resolver = resolver;
            PreprocessedSource source = backend.Preprocess(request, resolver);
            string outputs = string.Join(" ", request.VertexOutputs.Select(o => $"{o.Semantic}:{o.Location}:{o.First}:{o.Components}"));
            string key = ShaderCache.Key(ProgramBuilder.Version, backend.Name, backend.KeyOf(source, request), request.Stage.ToString(),
                request.EntryPoint, outputs, source.Text);

            CompiledProgram compiled = cache.Find(key);
            if (compiled == null)
            {
                compiled = Build(source, request);
                cache.Store(key, compiled);
            }
            compiled.Program.Name = request.Name;   // the same content may lie in another file
            ShaderBackend.Tally(backend, compiled);
            return compiled;
        }

        /// <summary>Creates the request for FXC. Fast: only preprocesses.</summary>
        /// <exception cref="ShaderCompileException"/>
        public FxcRequest ForFxc(CompileRequest request) => FxcRequest.Of(request, resolver);

        CompiledProgram Build(PreprocessedSource source, CompileRequest request)
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
            // glslang would make an empty program of an entry point that it does not find.
            if (!declarations.HasFunction(request.EntryPoint))
                throw new ShaderCompileException(request.EntryLine.File, request.EntryLine.Line, request.Stage == ShaderStage.Compute
                    ? $"kernel '{request.EntryPoint}' not found" : $"entry point '{request.EntryPoint}' not found");
            return backend.Build(source, request, declarations);
        }
    }
}
