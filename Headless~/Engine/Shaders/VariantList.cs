using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>Collects the variants of one program, those of the same text once.</summary>
    sealed class VariantList
    {
        readonly ShaderCompiler compiler;
        readonly string file, program;
        readonly HashSet<string> seen = new HashSet<string>();
        public readonly List<ShaderVariant> Variants = new List<ShaderVariant>();

        public VariantList(ShaderCompiler compiler, string file, string program)
        {
            this.compiler = compiler;
            this.file = file;
            this.program = program;
        }

        public void Add(CompileRequest request, IEnumerable<string> keywords, Func<CompiledProgram> compile, string defines = "")
        {
            var variant = new ShaderVariant { File = file, Program = program, Keywords = string.Join(" ", keywords), Defines = defines,
                Request = request, Compile = compile };
            try
            {
                variant.Fxc = compiler.ForFxc(request);
            }
            catch (ShaderCompileException e)
            {
                variant.Fault = e;
            }
            if (seen.Add(variant.Fxc?.Source.Text ?? variant.Fault.Message))
                Variants.Add(variant);
        }
    }
}
