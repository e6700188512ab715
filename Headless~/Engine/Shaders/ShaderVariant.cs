using System;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>
    /// A kernel, or a vertex or fragment program of a pass, under one choice of keywords: what a shader compiler gets at a
    /// time. Choices that make no difference to the text are one variant.
    /// </summary>
    sealed class ShaderVariant
    {
        /// <summary>"Shaders/Gpu/PrefixSum.compute".</summary>
        public string File;
        /// <summary>The kernel; for a pass its name and the entry point: "Particles/ParticleVertex".</summary>
        public string Program;
        /// <summary>Enabled keywords with blanks between; empty for none.</summary>
        public string Keywords;
        /// <summary>Names that its #pragma kernel line defines, with blanks between, without the one that renames the kernel; empty for
        /// none.</summary>
        public string Defines = "";
        public CompileRequest Request;
        /// <summary>Null when there is a <see cref="Fault"/>.</summary>
        public FxcRequest Fxc;
        /// <summary>Why the text could not be preprocessed (#error, an include that is not there); null when it could.</summary>
        public ShaderCompileException Fault;
        /// <summary>By the importer's backend, to SPIR-V as this host runs it. Throws ShaderCompileException.</summary>
        public Func<CompiledProgram> Compile;

        public ShaderStage Stage => Request.Stage;
        public override string ToString() => $"{File} ({Program}{(Keywords.Length > 0 ? ", " + Keywords : "")})";
    }
}
