using System;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>How Unity asks FXC for a program.</summary>
    static class FxcDialect
    {
        /// <summary>
        /// Direct3D 11 begins at shader model 4.0 (Unity dropped feature level 9), and #pragma target 4.5 is its model 5.0
        /// without tessellation ("Targeting shader models and GPU features in HLSL").
        /// </summary>
        /// <param name="target">SHADER_TARGET: 50 for #pragma target 5.0.</param>
        public static string Profile(ShaderStage stage, int target)
        {
            string model = target >= 45 ? "5_0" : target > 40 ? "4_1" : "4_0";
            return (stage == ShaderStage.Compute ? "cs_" : stage == ShaderStage.Vertex ? "vs_" : "ps_") + model;
        }

        /// <summary>
        /// Unity does not publish its flags. It ships optimized programs, and the highest level makes FXC look hardest (it unrolls
        /// and follows more than others); two pragmas are documented to turn that off. Shaders with tex2D or an output of
        /// semantic COLOR, as the manual's examples have them, compile in Unity, and FXC takes those in its compatible mode
        /// alone; kernels have neither, and get no more than they need.
        /// </summary>
        public static FxcFlags Flags(PreprocessedSource source, ShaderStage stage)
        {
            bool Has(string pragma) => source.Pragmas.Any(p => Words(p.Text) is string[] words && words[0] == pragma
                && (words.Length == 1 || words.Contains("d3d11")));
            FxcFlags optimization = Has("enable_d3d11_debug_symbols") ? FxcFlags.Debug | FxcFlags.SkipOptimization
                : Has("skip_optimizations") ? FxcFlags.SkipOptimization : FxcFlags.OptimizationLevel3;
            return stage == ShaderStage.Compute ? optimization : optimization | FxcFlags.BackwardsCompatibility;
        }

        /// <summary>Whether Unity would ask DXC instead: FXC knows neither wave operations nor the types of shader model 6.</summary>
        public static bool NeedsDxc(PreprocessedSource source, out PragmaLine asking)
        {
            asking = source.Pragmas.FirstOrDefault(p => Words(p.Text) is string[] words
                && (words[0] == "use_dxc" && (words.Length == 1 || words.Contains("d3d11") || words.Contains("d3d12"))
                    || words[0] == "require" && words.Any(word => word.StartsWith("Wave", StringComparison.OrdinalIgnoreCase)
                        || word == "Native16Bit" || word == "Int64")));
            return asking.Text != null;
        }

        static string[] Words(string pragma) => pragma.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
    }
}
