using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>The ShadowCaster passes of materials, by which Unity draws both shadow maps and a camera's depth texture.</summary>
    internal static class ShadowCasters
    {
        public const string Mode = "ShadowCaster";

        /// <summary>The pass of that LightMode, or the fallback's; -1 where there is none or the material has it off.</summary>
        public static int PassOf(Material material)
        {
            if (!material.GetShaderPassEnabled(Mode))
                return -1;
            IReadOnlyList<ShaderPassSource> passes = material.shader.Source.Passes;
            for (int pass = 0; pass < passes.Count; pass++)
                if (passes[pass].Tags.TryGetValue("LightMode", out string own) && string.Equals(own, Mode, StringComparison.OrdinalIgnoreCase))
                    return pass;
            return material.shader.FallbackCaster != null ? passes.Count : -1;
        }

        public static void Draw(in QueuedDraw draw)
        {
            int pass = PassOf(draw.Call.Material);
            if (pass >= 0)
                Drawing.DrawShaderPass(draw.Call, pass);
        }
    }
}
