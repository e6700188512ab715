using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>
    /// By Microsoft's FXC, whose bytecode is what Unity runs on Direct3D 11, and vkd3d, which makes it a program for Vulkan.
    /// Programs that vkd3d cannot translate must be in a list; those alone are compiled by glslang.
    /// </summary>
    sealed class FxcBackend : IShaderBackend
    {
        readonly Lazy<FxcCompiler> fxc = new Lazy<FxcCompiler>(() => new FxcCompiler());
        readonly IReadOnlyList<Untranslatable> untranslatable;

        public FxcBackend(IReadOnlyList<Untranslatable> untranslatable) { this.untranslatable = untranslatable; }

        public string Name => "fxc";

        public PreprocessedSource Preprocess(CompileRequest request, IncludeResolver resolver) => FxcRequest.Of(request, resolver).Source;

        public string KeyOf(PreprocessedSource source, CompileRequest request)
        {
            FxcRequest asked = FxcRequest.Of(request, source);
            return $"{FxcDownload.Sha256} {asked.Profile} {asked.Flags} {Vkd3dCompiler.Identity} {SpirvValidator.Identity} {Listed(request)?.Reason}";
        }

        public CompiledProgram Build(PreprocessedSource source, CompileRequest request, SourceDeclarations declarations)
        {
            if (FxcDialect.NeedsDxc(source, out PragmaLine asking))
                throw new ShaderCompileException(asking.Where.File, asking.Where.Line,
                    $"#pragma {asking.Text} asks for DXC, whose programs this backend does not run");
            FxcResult result = Compile(FxcRequest.Of(request, source));
            Untranslatable listed = Listed(request);
            CompiledProgram compiled;
            try
            {
                byte[] spirv = Vkd3dCompiler.Translate(result.Dxbc);
                compiled = Vkd3dProgram.Build(result.Dxbc, spirv, request.Name, request.Stage, declarations, request.VertexOutputs);
                SpirvValidator.Check(compiled.Program.Spirv);
            }
            catch (ProgramException e) when (listed != null && e.Message == listed.Reason)
            {
                return ByGlslang(request, listed);
            }
            catch (ProgramException e)
            {
                throw request.Fault(e);
            }
            if (listed != null)
                throw request.Fault(new ProgramException(
                    $"listed as untranslatable ({listed.Reason}), but it translates now: strike it from the list"));
            return compiled;
        }

        FxcResult Compile(FxcRequest request)
        {
            FxcResult result = fxc.Value.Compile(request);
            FxcMessage error = result.Errors.FirstOrDefault();
            if (error != null)
                throw new ShaderCompileException(error.Where.File, error.Where.Line, error.Number.Length > 0
                    ? $"{error.Number}: {error.Text}" : error.Text);
            return result;
        }

        static CompiledProgram ByGlslang(CompileRequest request, Untranslatable listed)
        {
            PreprocessedSource source = ShaderBackend.Glslang.Preprocess(request, request.Resolver);
            CompiledProgram compiled = ShaderBackend.Glslang.Build(source, request, new SourceDeclarations(source.Text));
            compiled.WhyGlslang = listed.Reason;
            return compiled;
        }

        Untranslatable Listed(CompileRequest request)
            => untranslatable.FirstOrDefault(u => u.File == request.EntryLine.File && u.EntryPoint == request.EntryPoint);
    }
}
