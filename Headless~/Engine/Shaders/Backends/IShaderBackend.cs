namespace Host.Shaders
{
    /// <summary>One way from HLSL to a program of this host. Thread-safe.</summary>
    interface IShaderBackend
    {
        /// <summary>As the command line has it.</summary>
        string Name { get; }

        /// <exception cref="ShaderCompileException"/>
        PreprocessedSource Preprocess(CompileRequest request, IncludeResolver resolver);

        /// <summary>What a program depends on beside its text, stage and entry point; changes when the tools do. Starts nothing.</summary>
        string KeyOf(PreprocessedSource source, CompileRequest request);

        /// <exception cref="ShaderCompileException"/>
        CompiledProgram Build(PreprocessedSource source, CompileRequest request, SourceDeclarations declarations);
    }
}
