using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Surface shaders: a quad of 4 x 4 pixels at the center of 64 x 32, under a light from the viewer's side.</summary>
    public class GraphicsSurfaceTests : ShaderTextFixture
    {
        static readonly Color32 clear = new Color32(0, 0, 255, 255);
        static readonly Bounds everywhere = new Bounds(Vector3.zero, Vector3.one * 1000);

        static Shader Surface(string pragma, string body, string before = "", string input = "float2 uv_MainTex;",
            string output = "SurfaceOutput", string properties = "", string tags = "", string model = "") =>
            ShaderOf($@"Shader ""Test/Surface"" {{
Properties {{ _MainTex (""Texture"", 2D) = ""white"" {{}} _Color (""Color"", Color) = (1,1,1,1) {properties} }}
SubShader {{ Tags {{ ""RenderType"" = ""Opaque"" {tags} }} LOD 200
CGPROGRAM
#pragma surface surf {pragma}
#pragma target 4.5
{before}
sampler2D _MainTex; fixed4 _Color;
struct Input {{ {input} }};
{model}
void surf (Input IN, inout {output} o) {{ {body} }}
ENDCG
}} FallBack ""Diffuse"" }}");

        static Light NewLight(Vector3 towards, float intensity = 1)
        {
            var light = new GameObject("Light").AddComponent<Light>();
            light.type = LightType.Directional;
            light.intensity = intensity;
            light.transform.rotation = Quaternion.LookRotation(towards);
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientLight = Color.black;
            return light;
        }

        // The built-in quad looks along -z, to the camera; 2 x 2 units are 4 x 4 pixels.
        static Color32 Draw(Shader shader, System.Action<Material> set = null)
        {
            NewCamera();
            var material = new Material(shader);
            set?.Invoke(material);
            Graphics.DrawMesh(Resources.GetBuiltinResource<Mesh>("Quad.fbx"), Matrix4x4.Scale(Vector3.one * 2), material, 0);
            Frame();
            Assert.That(Pixel(0, 0), Is.EqualTo(clear), "beside the quad");
            return Pixel(32, 16);
        }

        static void AssertNear(Color32 actual, int r, int g, int b, int within = 2) =>
            Assert.That(Mathf.Max(Mathf.Abs(actual.r - r), Mathf.Abs(actual.g - g), Mathf.Abs(actual.b - b)), Is.LessThanOrEqualTo(within),
            $"{actual}, expected ({r}, {g}, {b})");

        [TestCase("Lambert", "SurfaceOutput")]
        [TestCase("Lambert fullforwardshadows addshadow nolightmap noforwardadd", "SurfaceOutput")]
        [TestCase("BlinnPhong", "SurfaceOutput")]
        public void Albedo_is_lit_by_the_directional_light(string pragma, string output)
        {
            NewLight(Vector3.forward);
            AssertNear(Draw(Surface(pragma, "o.Albedo = float3(1, 0.5, 0); o.Alpha = 1;", output: output)), 255, 188, 0);
        }

        [Test]
        public void Light_falls_off_with_the_cosine_and_does_not_pass_through()
        {
            Light light = NewLight(new Vector3(0, -1, 1));
            Shader shader = Surface("Lambert", "o.Albedo = 1;");
            byte expected = (byte)Mathf.RoundToInt(Mathf.LinearToGammaSpace(Mathf.Sqrt(0.5f)) * 255);
            AssertNear(Draw(shader), expected, expected, expected);
            light.transform.rotation = Quaternion.LookRotation(Vector3.back);
            AssertNear(Draw(shader), 0, 0, 0);
        }

        [Test]
        public void Ambient_light_and_emission_are_added_and_noambient_leaves_one_of_them_out()
        {
            NewLight(Vector3.back);     // from behind: no direct light
            RenderSettings.ambientLight = Color.white * 0.5f;
            AssertNear(Draw(Surface("Lambert", "o.Albedo = 1; o.Emission = float3(0, 0, 1);")), 128, 128, 255);
            AssertNear(Draw(Surface("Lambert noambient", "o.Albedo = 1; o.Emission = float3(0, 0, 1);")), 0, 0, 255);
        }

        [TestCase("Standard", "SurfaceOutputStandard", "o.Metallic = 0; o.Smoothness = 0;")]
        [TestCase("StandardSpecular", "SurfaceOutputStandardSpecular", "o.Specular = 0.04; o.Smoothness = 0;")]
        public void Standard_models_give_a_rough_surface_about_its_albedo(string model, string output, string set)
        {
            NewLight(Vector3.forward);
            Color32 pixel = Draw(Surface(model + " fullforwardshadows", "o.Albedo = _Color.rgb; " + set, output: output),
                m => m.color = new Color(0.5f, 0, 0));
            Assert.That(pixel.r, Is.InRange(118, 140));
            Assert.That(pixel.g, Is.LessThan(60), "a highlight of 4 %, spread wide");
        }

        [Test]
        public void A_smooth_metal_shines_where_it_mirrors_the_light()
        {
            NewLight(Vector3.forward);
            Shader metal = Surface("Standard", "o.Albedo = float3(1, 0, 0); o.Metallic = 1; o.Smoothness = 0.8;", output: "SurfaceOutputStandard");
            AssertNear(Draw(metal), 255, 0, 0);
            foreach (Light light in Object.FindObjectsOfType<Light>())
                light.transform.rotation = Quaternion.LookRotation(new Vector3(0, -1, 1));
            Assert.That(Draw(metal).r, Is.LessThan(60), "away from the mirror direction a metal has no diffuse light");
        }

        [Test]
        public void Textures_with_their_scale_and_the_tint_reach_the_surface()
        {
            NewLight(Vector3.forward);
            var texture = new Texture2D(2, 2, TextureFormat.RGBA32, false) { filterMode = FilterMode.Point };
            texture.SetPixels32(new[] { new Color32(255, 0, 0, 255), new Color32(255, 255, 0, 255), new Color32(0, 255, 0, 255),
                new Color32(255, 255, 255, 255) });
            texture.Apply();
            Shader shader = Surface("Lambert", "o.Albedo = tex2D(_MainTex, IN.uv_MainTex).rgb * _Color.rgb;");
            Draw(shader, m => m.mainTexture = texture);
            AssertNear(Pixel(30, 17), 255, 0, 0);
            AssertNear(Pixel(33, 17), 255, 255, 0);
            AssertNear(Pixel(30, 14), 0, 255, 0);
            AssertNear(Pixel(33, 14), 255, 255, 255);
            Draw(shader, m => { m.mainTexture = texture; m.mainTextureScale = Vector2.one * 0.25f;
                m.mainTextureOffset = new Vector2(0.5f, 0); m.color = Color.red; });
            AssertNear(Pixel(33, 14), 255, 0, 0);
            AssertNear(Pixel(30, 17), 255, 0, 0);
            Object.DestroyImmediate(texture);
        }

        [Test]
        public void A_normal_of_the_surface_is_in_tangent_space()
        {
            NewLight(new Vector3(-1, 0, 0));      // from the right
            Shader shader = Surface("Lambert", "o.Albedo = 1; o.Normal = UnpackNormal(float4(1, 0.5, 0.5, 1));");
            AssertNear(Draw(shader), 255, 255, 255);
            AssertNear(Draw(Surface("Lambert", "o.Albedo = 1; o.Normal = float3(-1, 0, 0);")), 0, 0, 0);
        }

        [Test]
        public void Everything_that_an_input_may_ask_for_is_there()
        {
            NewLight(Vector3.forward);
            const string input = "float2 uv_MainTex; float2 uv2_MainTex; float3 worldPos; float3 viewDir; float4 screenPos; float3 " +
                "worldNormal; float3 worldRefl; float4 color : COLOR; INTERNAL_DATA";
            const string body = "float2 screen = IN.screenPos.xy / IN.screenPos.w; float3 n = WorldNormalVector(IN, float3(0, 0, 1)); " +
                "float3 r = WorldReflectionVector(IN, float3(0, 0, 1));" +
                "bool ok = distance(IN.worldPos, float3(0, 0, 0)) < 0.8 && dot(IN.viewDir, float3(0, 0, 1)) > 0.9 && distance(screen, " +
                "0.5) < 0.05 && distance(n, float3(0, 0, -1)) < 1e-3 && r.z < -0.9 && IN.color.a == 1;" +
                "o.Emission = ok ? float3(0, 1, 0) : float3(1, 0, 0);";
            AssertNear(Draw(Surface("Lambert", body, input: input)), 0, 255, 0);
        }

        [Test]
        public void A_vertex_function_moves_and_hands_over()
        {
            NewLight(Vector3.forward);
            const string before = "";
            const string model = "void vert(inout appdata_full v, out Input o) { UNITY_INITIALIZE_OUTPUT(Input, o); v.vertex.x += 2; " +
                "o.shade = float3(0, v.texcoord.x * 0 + 1, 0); }";
            Draw(Surface("Lambert vertex:vert", "o.Emission = IN.shade;", before, "float2 uv_MainTex; float3 shade;", model: model));
            AssertNear(Pixel(32 + 8, 16), 0, 255, 0);
            Assert.That(Pixel(32, 16), Is.EqualTo(clear), "it went two of its own units, four of the world's, to the right");
        }

        [Test]
        public void A_lighting_function_of_the_shader_is_called([Values(0, 1, 2)] int form)
        {
            NewLight(Vector3.forward, 0.5f);
            string[] forms =
            {
                "half4 LightingMine(SurfaceOutput s, half3 lightDir, half atten) { return half4(s.Albedo * _LightColor0.rgb * " +
                    "(lightDir.z < -0.9 ? 1 : 0) * atten, s.Alpha); }",
                "half4 LightingMine(SurfaceOutput s, half3 lightDir, half3 viewDir, half atten) { return half4(s.Albedo * " +
                    "_LightColor0.rgb * (viewDir.z < -0.9 ? 1 : 0), s.Alpha); }",
                "half4 LightingMine(SurfaceOutput s, UnityGI gi) { return half4(s.Albedo * gi.light.color, s.Alpha); } void " +
                    "LightingMine_GI(SurfaceOutput s, UnityGIInput data, inout UnityGI gi) { gi = UnityGlobalIllumination(data, 1, " +
                    "s.Normal); }",
            };
            AssertNear(Draw(Surface("Mine", "o.Albedo = float3(1, 0, 0);", model: forms[form])), 188, 0, 0);
        }

        [Test]
        public void Alpha_blends_over_what_is_behind_and_alphatest_cuts()
        {
            NewLight(Vector3.forward);
            AssertNear(Draw(Surface("Lambert alpha:fade", "o.Albedo = float3(1, 0, 0); o.Alpha = 0.5;",
                tags: "\"Queue\" = \"Transparent\"")), 188, 0, 188);
            Assert.That(Draw(Surface("Lambert alphatest:_Cutoff", "o.Albedo = 1; o.Alpha = 0.4;",
                properties: "_Cutoff (\"Cutoff\", Range(0, 1)) = 0.5")), Is.EqualTo(clear));
            AssertNear(Draw(Surface("Lambert", "o.Albedo = 1; o.Alpha = 0.4;")), 255, 255, 255);
        }

        const string ProceduralCode = @"#pragma multi_compile_instancing
#pragma instancing_options procedural:setup
#ifdef UNITY_PROCEDURAL_INSTANCING_ENABLED
StructuredBuffer<float4> _Positions;
#endif
void setup()
{
#ifdef UNITY_PROCEDURAL_INSTANCING_ENABLED
    float4 p = _Positions[unity_InstanceID];
    unity_ObjectToWorld._11_21_31_41 = float4(p.w, 0, 0, 0);
    unity_ObjectToWorld._12_22_32_42 = float4(0, p.w, 0, 0);
    unity_ObjectToWorld._13_23_33_43 = float4(0, 0, p.w, 0);
    unity_ObjectToWorld._14_24_34_44 = float4(p.xyz, 1);
    unity_WorldToObject = unity_ObjectToWorld;
    unity_WorldToObject._14_24_34 *= -1;
    unity_WorldToObject._11_22_33 = 1.0f / unity_WorldToObject._11_22_33;
#endif
}";
        const string ProceduralBody = "float4 c = float4(1, 1, 1, 1);\n#ifdef UNITY_PROCEDURAL_INSTANCING_ENABLED\nc = " +
            "unity_InstanceID == 1 ? float4(1, 0, 0, 1) : float4(0, 1, 0, 1);\n#endif\no.Albedo = c.rgb;";

        [Test]
        public void Procedural_instances_are_placed_by_the_shaders_own_function([Values("indirect", "procedural", "command")] string call)
        {
            NewLight(Vector3.forward);
            Camera camera = NewCamera();
            var material = new Material(Surface("Standard", ProceduralBody, ProceduralCode, output: "SurfaceOutputStandard"));
            Mesh quad = Resources.GetBuiltinResource<Mesh>("Quad.fbx");
            using (var positions = new ComputeBuffer(2, 16))
            using (var arguments = new ComputeBuffer(1, 5 * sizeof(uint), ComputeBufferType.IndirectArguments))
            using (var commands = new CommandBuffer())
            {
                positions.SetData(new[] { new Vector4(-4, 0, 0, 2), new Vector4(4, 2, 0, 2) });
                arguments.SetData(new uint[] { quad.GetIndexCount(0), 2, 0, 0, 0 });
                material.SetBuffer("_Positions", positions);
                if (call == "indirect")
                    Graphics.DrawMeshInstancedIndirect(quad, 0, material, everywhere, arguments);
                else if (call == "procedural")
                    Graphics.DrawMeshInstancedProcedural(quad, 0, material, everywhere, 2);
                else
                {
                    commands.DrawMeshInstancedIndirect(quad, 0, material, 0, arguments);
                    camera.AddCommandBuffer(CameraEvent.AfterForwardOpaque, commands);
                }
                Frame();
            }
            Assert.That(Pixel(24, 16).g, Is.GreaterThan(200), "instance 0");
            Assert.That(Pixel(24, 16).r, Is.LessThan(80));
            Assert.That(Pixel(40, 12).r, Is.GreaterThan(200), "instance 1, up and to the right");
            Assert.That(Pixel(40, 12).g, Is.LessThan(80));
            Assert.That(Pixel(32, 16), Is.EqualTo(clear), "nothing at the origin");
        }

        [Test]
        public void Without_instancing_the_same_shader_draws_one_object_at_its_own_place()
        {
            NewLight(Vector3.forward);
            AssertNear(Draw(Surface("Lambert", ProceduralBody, ProceduralCode)), 255, 255, 255);
        }

        [Test]
        public void Matrices_and_properties_of_instances_come_from_arrays()
        {
            NewLight(Vector3.forward);
            NewCamera();
            var material = new Material(Surface("Lambert", "o.Albedo = UNITY_ACCESS_INSTANCED_PROP(Props, _Shade).rgb;",
                "UNITY_INSTANCING_BUFFER_START(Props)\nUNITY_DEFINE_INSTANCED_PROP(fixed4, _Shade)\nUNITY_INSTANCING_BUFFER_END(Props)",
                    properties: "_Shade (\"Shade\", Color) = (1,1,1,1)")) { enableInstancing = true };
            Mesh quad = Resources.GetBuiltinResource<Mesh>("Quad.fbx");
            // More than one batch of 500: the last two are the ones looked at.
            var matrices = new Matrix4x4[602];
            var shades = new Vector4[602];
            for (int i = 0; i < 600; i++)
                matrices[i] = Matrix4x4.Translate(new Vector3(0, 100, 0));
            matrices[600] = Matrix4x4.TRS(new Vector3(-4, 0, 0), Quaternion.identity, Vector3.one * 2);
            matrices[601] = Matrix4x4.TRS(new Vector3(4, 2, 0), Quaternion.identity, Vector3.one * 2);
            shades[600] = new Vector4(0, 1, 0, 1);
            shades[601] = new Vector4(1, 0, 0, 1);
            var block = new MaterialPropertyBlock();
            block.SetVectorArray("_Shade", shades);
            Graphics.DrawMeshInstanced(quad, 0, material, matrices, 602, block);
            Frame();
            AssertNear(Pixel(24, 16), 0, 255, 0);
            AssertNear(Pixel(40, 12), 255, 0, 0);
            Graphics.DrawMeshInstanced(quad, 0, material, matrices);
            Frame();
            AssertNear(Pixel(24, 16), 255, 255, 255);
        }

        [TestCase("#pragma surface surf Lambert tessellate:tess", 8, "'tessellate:tess' of a surface shader is not supported")]
        [TestCase("#pragma surface surf Cloth", 8, "no function 'LightingCloth'")]
        [TestCase("#pragma surface nope Lambert", 8, "function 'nope'")]
        [TestCase("#pragma surface surf", 8, "needs a function and a lighting model")]
        public void What_a_surface_shader_lacks_is_named_with_file_and_line(string pragma, int line, string what)
        {
            string text = $"Shader \"T\"\n{{\nSubShader\n{{\nTags {{ \"Queue\" = \"Geometry\" }}\n\nCGPROGRAM\n{pragma}\nstruct Input " +
                $"{{ float3 worldPos; }};\nvoid surf(Input IN, inout SurfaceOutput o) {{ o.Albedo = 1; }}\nENDCG\n}}\n}}";
            var error = Assert.Throws<ShaderCompileException>(() => ShaderOf(text).Source.Passes.Single().Compile(ShaderStage.Fragment,
                new string[0]));
            Assert.That(error.Message, Does.StartWith($"Test.shader({line}): error: ").And.Contain(what));
        }
    }
}
