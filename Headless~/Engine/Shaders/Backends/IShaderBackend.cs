namespace Host.Shaders
{
    /// <summary>One way from HLSL to a program of this host. Thread-safe.</summary>
    interface IShaderBackend
    {
        /// <summary>Name on the command line.</summary>
        string Name { get; }

        /// <exception cref="ShaderCompileException"/>
        PreprocessedSource Preprocess(CompileRequest request, IncludeResolver resolver);

        /// <summary>Key of what a program depends on beside its text, stage and entry point; changes when the tools do. Starts nothing.</summary>
        string KeyOf(PreprocessedSource source, CompileRequest request);

        /// <exception cref="ShaderCompileException"/>
        CompiledProgram Build(PreprocessedSource source, CompileRequest request, SourceDeclarations declarations);
    }
}
