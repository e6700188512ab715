using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Host.Shaders
{
    /// <summary>
    /// Writes the vertex and fragment programs around a surface function: a ForwardBase pass, lit by the main directional
    /// light with its shadow and by the ambient light, or the ShadowCaster pass of addshadow. Left out: further lights, lightmaps, fog, tessellation.
    /// </summary>
    sealed class SurfaceShader
    {
        public const string VertexEntry = "rill_surface_vertex", FragmentEntry = "rill_surface_fragment";

        /// <summary>Before the shader's own code.</summary>
        public static string Prologue(bool caster) =>
            (caster ? "#define UNITY_PASS_SHADOWCASTER\n#define SHADOWS_DEPTH 1\n" : "#define UNITY_PASS_FORWARDBASE\n") +
            "#define UNITY_SHOULD_SAMPLE_SH 1\n" +
            "#include \"UnityCG.cginc\"\n#include \"Lighting.cginc\"\n#include \"UnityPBSLighting.cginc\"\n#include \"AutoLight.cginc\"\n" +
            "#define INTERNAL_DATA half3 rill_toWorld0; half3 rill_toWorld1; half3 rill_toWorld2;\n" +
            "#define WorldNormalVector(data, normal) fixed3(dot(data.rill_toWorld0, normal), dot(data.rill_toWorld1, normal), " +
            "dot(data.rill_toWorld2, normal))\n" +
            "#define WorldReflectionVector(data, normal) reflect(data.worldRefl, WorldNormalVector(data, normal))\n";

        static readonly string[] BuiltInModels = { "Lambert", "BlinnPhong", "Standard", "StandardSpecular" };
        static readonly string[] TexCoords = { "texcoord", "texcoord1", "texcoord2", "texcoord3" };

        readonly SurfaceOptions options;
        readonly SurfaceSource source;
        readonly List<SourceField> input, surface;
        readonly bool caster;
        readonly bool tangents;         // the normal, or a vector to it, is in tangent space
        readonly StringBuilder code = new StringBuilder(), varyings = new StringBuilder(), toFragment = new StringBuilder(),
        toSurface = new StringBuilder();
        readonly HashSet<string> declared = new HashSet<string>();
        int nextTexCoord;

        SurfaceShader(SurfaceOptions options, string preprocessed, bool caster)
        {
            this.caster = caster;
            this.options = options;
            source = new SurfaceSource(preprocessed);
            surface = source.Function(options.Function)
                ?? throw new ProgramException($"function '{options.Function}', which #pragma surface names, does not exist");
            if (surface.Count != 2)
                throw new ProgramException($"the surface function '{options.Function}' takes {surface.Count} parameters; it takes an " +
                    $"Input and an inout SurfaceOutput");
            input = source.Struct(surface[0].Type)
                ?? throw new ProgramException(
                $"struct '{surface[0].Type}', which the surface function '{options.Function}' takes, does not exist");
            tangents = source.Writes(options.Function, "Normal") || input.Any(f => f.Name == "rill_toWorld0");
        }

        /// <summary>The code that follows the shader's own.</summary>
        /// <param name="preprocessed">The prologue and the shader's code, for one variant.</param>
        /// <exception cref="ProgramException"/>
        public static string Generate(SurfaceOptions options, string preprocessed, bool caster = false)
            => new SurfaceShader(options, preprocessed, caster).Write();

        string Write()
        {
            string data = "appdata_full";
            List<SourceField> vertex = null;
            if (options.Vertex != null)
            {
                vertex = source.Function(options.Vertex)
                    ?? throw new ProgramException($"function '{options.Vertex}', which the option vertex: names, does not exist");
                if (vertex.Count < 1 || vertex.Count > 2)
                    throw new ProgramException($"the vertex function '{options.Vertex}' takes {vertex.Count} parameters; it takes an " +
                        $"inout of vertex data and, if wanted, an out {surface[0].Type}");
                data = vertex[0].Type;
            }
            bool instances = (source.Struct(data)
                ?? throw new ProgramException($"struct '{data}', which '{options.Vertex}' takes, does not exist")).Any(f
                => f.Name == "instanceID");

            foreach (SourceField field in input)
                Pass(field);
            if (options.AlphaTest != null && !source.Mentions(options.AlphaTest))
                code.AppendLine($"fixed {options.AlphaTest};");

            code.AppendLine("struct rill_surface_v2f {");
            code.AppendLine($"float4 pos : SV_POSITION; float3 worldPos : {Next()}; float3 worldNormal : {Next()};");
            if (tangents)
                code.AppendLine($"float4 worldTangent : {Next()};");
            code.Append(varyings);
            if (ReceivesShadows)
                code.AppendLine($"UNITY_SHADOW_COORDS({nextTexCoord++})");
            code.AppendLine(instances ? "UNITY_VERTEX_INPUT_INSTANCE_ID };" : "};");

            code.AppendLine($"rill_surface_v2f {VertexEntry}({data} v) {{");
            code.AppendLine("rill_surface_v2f o; UNITY_INITIALIZE_OUTPUT(rill_surface_v2f, o);");
            if (instances)
                code.AppendLine("UNITY_SETUP_INSTANCE_ID(v); UNITY_TRANSFER_INSTANCE_ID(v, o);");
            code.AppendLine($"{surface[0].Type} own; UNITY_INITIALIZE_OUTPUT({surface[0].Type}, own);");
            if (vertex != null)
                code.AppendLine(vertex.Count == 2 ? $"{options.Vertex}(v, own);" : $"{options.Vertex}(v);");
            code.AppendLine(caster ? "o.pos = UnityApplyLinearShadowBias(UnityClipSpaceShadowCasterPos(v.vertex, v.normal));"
                : "o.pos = UnityObjectToClipPos(v.vertex);");
            code.AppendLine("o.worldPos = mul(unity_ObjectToWorld, float4(v.vertex.xyz, 1.0)).xyz;");
            code.AppendLine("o.worldNormal = UnityObjectToWorldNormal(v.normal);");
            if (tangents)
                code.AppendLine("o.worldTangent = float4(UnityObjectToWorldDir(v.tangent.xyz), v.tangent.w * unity_WorldTransformParams.w);");
            code.Append(toFragment);
            if (ReceivesShadows)
                code.AppendLine("UNITY_TRANSFER_SHADOW(o, v.texcoord1.xy)");
            code.AppendLine("return o; }");

            WriteFragment(instances);
            return code.ToString();
        }

        bool ReceivesShadows => options.ReceivesShadows && !caster;

        string Next() => "TEXCOORD" + nextTexCoord++;

        // How a member of the Input comes from the vertex program to the surface function.
        void Pass(SourceField field)
        {
            string name = field.Name;
            if (field.Semantic.StartsWith("COLOR", StringComparison.OrdinalIgnoreCase))
            {
                varyings.AppendLine($"float4 {name} : COLOR0;");
                toFragment.AppendLine($"o.{name} = v.color;");
                toSurface.AppendLine($"IN.{name} = i.{name};");
                return;
            }
            if (field.Semantic.Equals("VFACE", StringComparison.OrdinalIgnoreCase))
            {
                toSurface.AppendLine($"IN.{name} = front ? 1 : -1;");
                return;
            }
            if (name.StartsWith("uv", StringComparison.Ordinal) && name.IndexOf('_') is int underline
                && (underline == 2 || underline == 3 && name[2] >= '2' && name[2] <= '4'))
            {
                string texture = name.Substring(underline);
                string coordinate = TexCoords[underline == 2 ? 0 : name[2] - '1'];
                string scale = texture + "_ST";
                if (!source.Mentions(scale) && declared.Add(scale))
                    code.AppendLine($"float4 {scale};");
                varyings.AppendLine($"float2 {name} : {Next()};");
                toFragment.AppendLine($"o.{name} = v.{coordinate}.xy * {scale}.xy + {scale}.zw;");
                toSurface.AppendLine($"IN.{name} = i.{name};");
                return;
            }
            switch (name)
            {
                case "worldPos": toSurface.AppendLine("IN.worldPos = i.worldPos;"); break;
                case "worldNormal": toSurface.AppendLine("IN.worldNormal = normal;"); break;
                case "viewDir": toSurface.AppendLine(tangents ? "IN.viewDir = normalize(mul(toWorld, toViewer));" : "IN.viewDir = toViewer;"); break;
                case "worldRefl": toSurface.AppendLine(input.Any(f => f.Name == "rill_toWorld0") ? "IN.worldRefl = -toViewer;"
                    : "IN.worldRefl = reflect(-toViewer, normal);"); break;
                case "screenPos":
                    varyings.AppendLine($"float4 screenPos : {Next()};");
                    toFragment.AppendLine("o.screenPos = ComputeScreenPos(o.pos);");
                    toSurface.AppendLine("IN.screenPos = i.screenPos;");
                    break;
                case "rill_toWorld0": toSurface.AppendLine("IN.rill_toWorld0 = half3(tangent.x, binormal.x, normal.x);"); break;
                case "rill_toWorld1": toSurface.AppendLine("IN.rill_toWorld1 = half3(tangent.y, binormal.y, normal.y);"); break;
                case "rill_toWorld2": toSurface.AppendLine("IN.rill_toWorld2 = half3(tangent.z, binormal.z, normal.z);"); break;
                default:
                    varyings.AppendLine($"{field.Type} {name} : {Next()};");
                    toFragment.AppendLine($"o.{name} = own.{name};");
                    toSurface.AppendLine($"IN.{name} = i.{name};");
                    break;
            }
        }

        void WriteFragment(bool instances)
        {
            bool standard = surface[1].Type.StartsWith("SurfaceOutputStandard", StringComparison.Ordinal);
            bool facing = input.Any(f => f.Semantic.Equals("VFACE", StringComparison.OrdinalIgnoreCase));
            code.AppendLine($"half4 {FragmentEntry}(rill_surface_v2f i{(facing ? ", bool front : SV_IsFrontFace" : "")}) : SV_Target {{");
            if (instances)
                code.AppendLine("UNITY_SETUP_INSTANCE_ID(i);");
            code.AppendLine("float3 normal = normalize(i.worldNormal);");
            code.AppendLine("float3 toViewer = normalize(UnityWorldSpaceViewDir(i.worldPos));");
            code.AppendLine("float3 toLight = normalize(UnityWorldSpaceLightDir(i.worldPos));");
            if (tangents)
            {
                code.AppendLine("float3 tangent = i.worldTangent.xyz; float3 binormal = cross(normal, tangent) * i.worldTangent.w;");
                code.AppendLine("float3x3 toWorld = float3x3(tangent, binormal, normal);");
            }
            code.AppendLine($"{surface[0].Type} IN; UNITY_INITIALIZE_OUTPUT({surface[0].Type}, IN);");
            code.Append(toSurface);
            code.AppendLine($"{surface[1].Type} s; UNITY_INITIALIZE_OUTPUT({surface[1].Type}, s);");
            code.AppendLine(source.Writes(options.Function, "Normal") ? "s.Normal = float3(0, 0, 1);" : "s.Normal = normal;");
            if (standard)
                code.AppendLine("s.Occlusion = 1.0;");
            code.AppendLine($"{options.Function}(IN, s);");
            if (options.AlphaTest != null)
                code.AppendLine($"clip(s.Alpha - {options.AlphaTest});");
            if (caster)
            {
                code.AppendLine("return 0; }");
                return;
            }
            if (source.Writes(options.Function, "Normal"))
                code.AppendLine("s.Normal = normalize(mul(s.Normal, toWorld));");
            code.AppendLine("half4 c = 0;");
            code.AppendLine(ReceivesShadows ? "UNITY_LIGHT_ATTENUATION(atten, i, i.worldPos)" : "fixed atten = 1;");
            WriteLight();
            code.AppendLine("c.rgb += s.Emission;");
            if (options.FinalColor != null)
                code.AppendLine($"{options.FinalColor}(IN, s, c);");
            if (options.Blend == SurfaceBlend.Opaque && !options.KeepAlpha)
                code.AppendLine("UNITY_OPAQUE_ALPHA(c.a);");
            code.AppendLine("return c; }");
        }

        void WriteLight()
        {
            string function = "Lighting" + options.Model;
            List<SourceField> parameters = source.Function(function)
                ?? throw new ProgramException($"the file has no function '{function}' for the lighting model " +
                    $"'{options.Model}'{(BuiltInModels.Contains(options.Model) ? "" : "; built in are " + string.Join(", ", BuiltInModels))}");
            if (parameters.Count < 2 || parameters.Count > 4 || parameters[0].Type != surface[1].Type)
                throw new ProgramException($"'{function}' takes ({string.Join(", ", parameters.Select(p => p.Type))}); a forward " +
                    $"lighting function takes ({surface[1].Type}, half3 lightDir, half atten), (..., half3 lightDir, half3 viewDir, " +
                    $"half atten), (..., UnityGI) or (..., half3 viewDir, UnityGI)");

            if (parameters[parameters.Count - 1].Type != "UnityGI")
            {
                code.AppendLine(parameters.Count == 4 ? $"c = {function}(s, toLight, toViewer, atten);" : $"c = {function}(s, toLight, atten);");
                if (!options.NoAmbient)
                    code.AppendLine("c.rgb += s.Albedo * max(0, ShadeSH9(half4(s.Normal, 1.0)));");
                return;
            }
            code.AppendLine("UnityGI gi; UNITY_INITIALIZE_OUTPUT(UnityGI, gi);");
            code.AppendLine("gi.light.color = _LightColor0.rgb; gi.light.dir = toLight;");
            if (source.Function(function + "_GI") != null)
            {
                code.AppendLine("UnityGIInput about; UNITY_INITIALIZE_OUTPUT(UnityGIInput, about);");
                code.AppendLine("about.light = gi.light; about.worldPos = i.worldPos; about.worldViewDir = toViewer; about.atten = atten;");
                code.AppendLine($"{function}_GI(s, about, gi);");
            }
            else
                code.AppendLine("gi.light.color *= atten;");
            if (options.NoAmbient)
                code.AppendLine("gi.indirect.diffuse = 0;");
            code.AppendLine(parameters.Count == 3 ? $"c = {function}(s, toViewer, gi);" : $"c = {function}(s, gi);");
        }
    }
}
