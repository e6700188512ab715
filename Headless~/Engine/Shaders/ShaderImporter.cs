using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>Unity's shader files to what the engine and the device use. Thread-safe.</summary>
    internal static class ShaderImporter
    {
        /// <param name="filePath">On disk.</param>
        /// <param name="displayPath">For messages, relative to the project.</param>
        /// <param name="resolver">Finds includes that do not lie beside the including file; null = there are none.</param>
        /// <exception cref="ShaderCompileException">A pragma is wrong; kernels are compiled, and judged, later.</exception>
        public static ComputeShaderSource ImportCompute(string filePath, string displayPath, IncludeResolver resolver, ShaderCache cache)
            => new ComputeFile(filePath, displayPath, new ShaderCompiler(resolver, cache));

        /// <param name="resolver">As above; a package is in the project when "Packages/name/package.json" resolves.</param>
        /// <exception cref="ShaderCompileException">The ShaderLab part or a pragma is wrong; programs are compiled, and judged, later.</exception>
        public static ShaderSource ImportShader(string filePath, string displayPath, IncludeResolver resolver, ShaderCache cache)
            => ImportShader(filePath, displayPath, resolver, cache, "");

        /// <summary>Imports for a scriptable render pipeline of that RenderPipeline tag.</summary>
        public static ShaderSource ImportShader(string filePath, string displayPath, IncludeResolver resolver, ShaderCache cache, string pipeline)
            => new ShaderFile(filePath, displayPath, resolver, new ShaderCompiler(resolver, cache), pipeline);

        /// <summary>Everything that Unity compiles from a .compute or .shader file.</summary>
        /// <param name="backend">Compiles the variants when asked; null = glslang.</param>
        /// <exception cref="ShaderCompileException">The file cannot be read. Faults of one variant are reported by that variant.</exception>
        public static IReadOnlyList<ShaderVariant> AllVariants(string filePath, string displayPath, IncludeResolver resolver,
            ShaderCache cache, IShaderBackend backend = null)
        {
            var compiler = new ShaderCompiler(resolver, cache, backend ?? ShaderBackend.Glslang);
            return filePath.EndsWith(".compute", StringComparison.OrdinalIgnoreCase)
                ? new ComputeFile(filePath, displayPath, compiler).AllVariants()
                : new ShaderFile(filePath, displayPath, resolver, compiler).AllVariants();
        }
    }
}
