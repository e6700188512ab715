using System;

namespace Host.Shaders
{
    /// <summary>D3DCOMPILE_* of d3dcompiler.h.</summary>
    [Flags]
    enum FxcFlags : uint
    {
        Debug = 1 << 0,
        SkipOptimization = 1 << 2,
        BackwardsCompatibility = 1 << 12,
        OptimizationLevel3 = 1 << 15,
    }

    /// <summary>One entry point of one variant for FXC.</summary>
    sealed class FxcRequest
    {
        /// <summary>For messages: "Shaders/Gpu/PrefixSum.compute (SumTiles)".</summary>
        public string Name;
        /// <summary>
        /// Preprocessed here: since 2022.1 Unity always runs its own preprocessor first (EditorSettings.cachingShaderPreprocessor
        /// reports it), so FXC sees no #include, macro or pragma of Unity's there either.
        /// </summary>
        public PreprocessedSource Source;
        public string EntryPoint;
        /// <summary>Line that names the entry point, for messages without a line.</summary>
        public SourceLine EntryLine;
        /// <summary>cs_5_0, vs_5_0, ps_4_0 ...</summary>
        public string Profile;
        public FxcFlags Flags;

        /// <summary>Creates the request that Unity would make. Fast: only preprocesses.</summary>
        /// <exception cref="ShaderCompileException"/>
        public static FxcRequest Of(CompileRequest request, IncludeResolver resolver)
            => Of(request, Preprocessor.Run(request.Segments, request.Defines, resolver, SourceReader.Fxc));

        public static FxcRequest Of(CompileRequest request, PreprocessedSource source) => new FxcRequest
        {
            Name = request.Name,
            Source = source,
            EntryPoint = request.EntryPoint,
            EntryLine = request.EntryLine,
            Profile = FxcDialect.Profile(request.Stage, request.Target),
            Flags = FxcDialect.Flags(source, request.Stage),
        };
    }
}
