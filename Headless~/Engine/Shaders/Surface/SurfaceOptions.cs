using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>How a surface shader mixes with the background.</summary>
    enum SurfaceBlend { Opaque, Fade, Premultiplied, DecalAdd, DecalBlend }

    /// <summary>"#pragma surface function model options" (manual, "Writing Surface Shaders").</summary>
    sealed class SurfaceOptions
    {
        // Without meaning here: no further lights, no lightmaps, no fog, no deferred path.
        static readonly HashSet<string> WithoutMeaning = new HashSet<string>
        {
            "fullforwardshadows", "nolightmap", "nodynlightmap", "nodirlightmap", "nofog", "nometa", "noforwardadd", "nolppv", "noshadowmask",
            "approxview", "halfasview", "interpolateview", "exclude_path:deferred", "exclude_path:forward", "exclude_path:prepass",
                "softvegetation", "dualforward", "novertexlights",
        };

        public readonly string Function, Model;
        public readonly string Vertex, FinalColor, AlphaTest;
        public readonly SurfaceBlend Blend;
        public readonly bool NoAmbient, KeepAlpha, NoInstancing, AddShadow, NoShadow;

        /// <summary>Whether it receives shadows of the main light; transparent surfaces do not.</summary>
        public bool ReceivesShadows => !NoShadow && Blend == SurfaceBlend.Opaque;

        /// <exception cref="ShaderCompileException"/>
        public SurfaceOptions(PragmaLine pragma)
        {
            string[] words = pragma.Text.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length < 3)
                throw Fault(pragma, "#pragma surface needs a function and a lighting model");
            (Function, Model) = (words[1], words[2]);
            foreach (string option in words.Skip(3))
            {
                int colon = option.IndexOf(':');
                string value = colon < 0 ? "" : option.Substring(colon + 1);
                switch (colon < 0 ? option : option.Substring(0, colon))
                {
                    case "vertex": Vertex = value; break;
                    case "finalcolor": FinalColor = value; break;
                    case "alphatest": AlphaTest = value; break;
                    case "noambient": NoAmbient = true; break;
                    case "keepalpha": KeepAlpha = true; break;
                    case "noinstancing": NoInstancing = true; break;
                    case "addshadow": AddShadow = true; break;
                    case "noshadow": NoShadow = true; break;
                    case "alpha":
                        bool auto = value == "" || value == "auto";
                        if (!auto && value != "blend" && value != "fade" && value != "premul")
                            throw Fault(pragma, $"'{option}' is not an option of a surface shader");
                        Blend = value == "premul" || auto && Model.StartsWith("Standard", StringComparison.Ordinal)
                            ? SurfaceBlend.Premultiplied : SurfaceBlend.Fade;
                        break;
                    case "decal": Blend = value == "add" ? SurfaceBlend.DecalAdd : SurfaceBlend.DecalBlend; break;
                    default:
                        if (!WithoutMeaning.Contains(option))
                            throw Fault(pragma, $"the option '{option}' of a surface shader is not supported by this host");
                        break;
                }
            }
        }

        static ShaderCompileException Fault(PragmaLine pragma, string what) => new ShaderCompileException(pragma.Where.File, pragma.Where.Line, what);
    }
}
