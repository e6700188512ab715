using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>By glslang's HLSL front end.</summary>
    sealed class GlslangBackend : IShaderBackend
    {
        // Features of FXC that glslang (12.0) lacks, or gets wrong.
        static readonly SourceSegment Dialect = new SourceSegment
        {
            DisplayPath = "(dialect)",
            Text = "#define ldexp(x, e) ((x) * exp2(e))\n" +
                "#define InterlockedCompareStore(d, c, v) do { uint rill_before; InterlockedCompareExchange(d, c, v, rill_before); } while (false)\n",
        };

        public string Name => "glslang";

        public PreprocessedSource Preprocess(CompileRequest request, IncludeResolver resolver)
            => Preprocessor.Run(request.Segments.Prepend(Dialect), request.Defines, resolver);

        public string KeyOf(PreprocessedSource source, CompileRequest request) => Glslang.Identity;

        public CompiledProgram Build(PreprocessedSource source, CompileRequest request, SourceDeclarations declarations)
        {
            byte[] spirv = Glslang.Compile(source, request.Stage, request.EntryPoint, request.EntryLine);
            try
            {
                // glslang would make one thread of no [numthreads].
                if (request.Stage == ShaderStage.Compute && !declarations.HasNumThreads(request.EntryPoint))
                    throw new ProgramException("a kernel needs [numthreads(x,y,z)]");
                return ProgramBuilder.Build(spirv, request.Name, request.Stage, declarations, request.VertexOutputs);
            }
            catch (ProgramException e)
            {
                throw request.Fault(e);
            }
        }
    }
}
