using System;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>How SPIRV-Cross writes a program for a target, and how glslang reads that back.</summary>
    sealed class Translation
    {
        /// <summary>Options of spirv-cross.</summary>
        public readonly string[] Options;
        /// <summary>Options of glslangValidator; null when no compiler of that language runs here.</summary>
        public readonly string[] ReadBack;

        public static readonly Translation Metal = new(new[] { "--msl", "--msl-version", "20100" }, null);
        public static readonly Translation OpenGlEs31 = new(new[] { "--version", "310", "--es" }, Array.Empty<string>());

        Translation(string[] options, string[] readBack)
        {
            Options = options;
            ReadBack = readBack;
        }

        public static string Suffix(ShaderStage stage) => stage == ShaderStage.Compute ? "comp" : stage == ShaderStage.Vertex ? "vert" : "frag";
    }
}
