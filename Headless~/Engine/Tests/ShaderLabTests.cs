using System;
using System.Linq;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    public class ShaderLabTests
    {
        const string Program = @"HLSLPROGRAM
#pragma vertex vert
#pragma fragment frag
float4 vert() : SV_Position { return 0; }
float4 frag() : SV_Target { return 1; }
ENDHLSL";

        static ShaderSource Import(string text)
        {
            using (var files = new ShaderFolder().Add("Test.shader", text))
                return files.Shader("Test.shader");
        }

        static DeviceRasterState State(string commands, Func<string, float> property = null)
            => Import($"Shader \"T\" {{ SubShader {{ Pass {{ {commands}\n{Program} }} }} }}").Passes[0]
                .ResolveState(property ?? (n => throw new Exception(n)));

        [Test]
        public void Properties_have_kinds_and_defaults()
        {
            ShaderSource shader = Import(@"// a comment { with a brace
Shader ""Water/Test"" /* and ""another"" */
{
    Properties
    {
        [HDR] _Color (""Color"", Color) = (1, 0.5, .25, 1)
        [Header(Surface, ""again"")] [NoScaleOffset] _MainTex (""Texture"", 2D) = ""white"" {}
        _Range (""Range"", Range(0, 10.5)) = 5
        [Enum(UnityEngine.Rendering.CullMode)] _Cull (""Cull"", Int) = 2
        _Vector (""Vector"", Vector) = (1, 2, 3, -4e-1)
        _Volume (""Volume"", 3D) = """" {}
        _Sky (""Sky"", Cube) = ""black"" { TexGen CubeReflect }
        _Slices (""Slices"", 2DArray) = """" {}
        _Float (""Float"", Float) = -1.5
    }
    SubShader { Pass { " + Program + @" } }
    Fallback ""Diffuse""
    CustomEditor ""My.Editor""
}");
            Assert.That(shader.Name, Is.EqualTo("Water/Test"));
            Assert.That(shader.Properties.Select(p => p.Name + " " + p.Kind), Is.EqualTo(new[]
            {
                "_Color Color", "_MainTex Texture2D", "_Range Range", "_Cull Int", "_Vector Vector", "_Volume Texture3D",
                    "_Sky TextureCube", "_Slices Texture2DArray", "_Float Float",
            }));
            Assert.That(shader.Properties[0].Default, Is.EqualTo(new[] { 1, 0.5f, 0.25f, 1 }));
            Assert.That(shader.Properties[1].DefaultTexture, Is.EqualTo("white"));
            Assert.That(shader.Properties[4].Default, Is.EqualTo(new[] { 1, 2, 3, -0.4f }));
            Assert.That(shader.Properties[8].Default, Is.EqualTo(new[] { -1.5f }));
        }

        [Test]
        public void A_pass_without_state_culls_the_back_and_tests_a_reversed_depth()
        {
            DeviceRasterState state = State("");
            Assert.That(state.Cull, Is.EqualTo(DeviceCull.Back));
            Assert.That(state.DepthWrite, Is.True);
            Assert.That(state.DepthTest, Is.EqualTo(DeviceCompare.GreaterEqual), "LEqual, reversed");
            Assert.That(state.Blend, Is.False);
            Assert.That(state.ColorMask, Is.EqualTo(15));
        }

        [Test]
        public void State_is_read_as_written()
        {
            DeviceRasterState state = State("Cull Off ZWrite Off ZTest Less Blend SrcAlpha OneMinusSrcAlpha, One Zero BlendOp RevSub, " +
                "Max ColorMask RG Offset -1, 2 AlphaToMask Off");
            Assert.That(state.Cull, Is.EqualTo(DeviceCull.Off));
            Assert.That(state.DepthWrite, Is.False);
            Assert.That(state.DepthTest, Is.EqualTo(DeviceCompare.Greater));
            Assert.That(state.Blend, Is.True);
            Assert.That(new[] { state.SrcColor, state.DstColor, state.SrcAlpha, state.DstAlpha },
                Is.EqualTo(new[] { DeviceBlend.SrcAlpha, DeviceBlend.OneMinusSrcAlpha, DeviceBlend.One, DeviceBlend.Zero }));
            Assert.That(new[] { state.ColorOp, state.AlphaOp }, Is.EqualTo(new[] { DeviceBlendOp.RevSub, DeviceBlendOp.Max }));
            Assert.That(state.ColorMask, Is.EqualTo(8 + 4));
            Assert.That(new[] { state.DepthBiasFactor, state.DepthBiasUnits }, Is.EqualTo(new[] { 1f, -2f }), "towards the viewer is up");
        }

        [Test]
        public void State_may_come_from_properties_as_Unitys_enumerations()
        {
            DeviceRasterState state = State("Cull [_Cull] ZTest [_ZTest] ZWrite [_ZWrite] Blend [_Src] [_Dst]",
                name => name == "_Cull" ? 1 : name == "_ZTest" ? 8 : name == "_ZWrite" ? 0 : name == "_Src" ? 5 : 10);
            Assert.That(state.Cull, Is.EqualTo(DeviceCull.Front));
            Assert.That(state.DepthTest, Is.EqualTo(DeviceCompare.Always));
            Assert.That(state.DepthWrite, Is.False);
            Assert.That(new[] { state.SrcColor, state.DstColor }, Is.EqualTo(new[] { DeviceBlend.SrcAlpha, DeviceBlend.OneMinusSrcAlpha }));
        }

        [Test]
        public void State_and_tags_of_a_SubShader_hold_for_its_passes()
        {
            ShaderSource shader = Import($@"Shader ""T"" {{ SubShader {{
Tags {{ ""Queue"" = ""Transparent-10"" ""RenderType"" = ""Transparent"" }} LOD 200 Cull Front
Pass {{ Name ""A"" Tags {{ ""LightMode"" = ""Always"" }} {Program} }}
Pass {{ Name ""B"" Cull Back {Program} }}
}} }}");
            Assert.That(shader.RenderQueue, Is.EqualTo(2990));
            Assert.That(shader.Passes.Select(p => p.Name), Is.EqualTo(new[] { "A", "B" }));
            Assert.That(shader.Passes.Select(p => p.ResolveState(null).Cull), Is.EqualTo(new[] { DeviceCull.Front, DeviceCull.Back }));
            Assert.That(shader.Passes[0].Tags["LightMode"], Is.EqualTo("Always"));
            Assert.That(shader.Passes[1].Tags["RenderType"], Is.EqualTo("Transparent"));
        }

        [Test]
        public void SubShaders_and_passes_for_absent_pipelines_and_packages_are_passed_over()
        {
            string text = $@"Shader ""T"" {{
SubShader {{ Tags {{ ""RenderPipeline"" = ""UniversalPipeline"" }} Pass {{ Name ""Urp"" {Program} }} }}
SubShader {{ PackageRequirements {{ ""com.unity.render-pipelines.high-definition"": ""12.0"" }} Pass {{ Name ""Hdrp"" {Program} }} }}
SubShader {{
    PackageRequirements {{ ""com.here"" }}
    Pass {{ PackageRequirements {{ ""com.absent"": ""1.0"" }} Name ""Not"" {Program} }}
    Pass {{ Name ""Here"" {Program} }}
    UsePass ""Other/FORWARD""
}} }}";
            using (var files = new ShaderFolder().Add("T.shader", text).Add("Packages/com.here/package.json", "{}"))
            {
                ShaderSource shader = files.Shader("T.shader");
                Assert.That(shader.Passes.Select(p => p.Name), Is.EqualTo(new[] { "Here" }));
                Assert.That(shader.Notes.Single(), Does.Contain("UsePass \"Other/FORWARD\""));
            }
        }

        const string Linked = @"Shader ""T"" {
HLSLINCLUDE
#define SCALE 2
float4x4 _VP;
ENDHLSL
CGINCLUDE
this is not for HLSLPROGRAM
ENDCG
SubShader { Pass {
    HLSLPROGRAM
    #pragma vertex vert
    #pragma fragment frag
    #pragma multi_compile _ EXTRA
    #pragma multi_compile_fragment _ RED
    struct Mesh { float3 position : POSITION; float4 tangent : TANGENT; float2 uv : TEXCOORD0; };
    struct ToFragment { float4 clip : SV_Position; float2 uv : TEXCOORD0; float3 normal : NORMAL; nointerpolation uint id : PARTICLE;
    #ifdef EXTRA
        float extra : TEXCOORD7;
    #endif
        float4 color : COLOR; };
    // Other members, in another order.
    struct FromVertex { float4 color : COLOR0; uint id : PARTICLE; float2 uv : TEXCOORD; float4 clip : SV_Position; };
    StructuredBuffer<float3> _Positions; Texture2D _MainTex; SamplerState sampler_MainTex;
    ToFragment vert(Mesh mesh, uint vertex : SV_VertexID, uint instance : SV_InstanceID)
    {
        ToFragment o = (ToFragment)0;
        o.clip = mul(_VP, float4(mesh.position + _Positions[instance], 1)) * SCALE;
        o.uv = mesh.uv; o.normal = mesh.tangent.xyz; o.id = vertex; o.color = 1;
        return o;
    }
    struct Targets { float4 a : SV_Target0; float4 b : SV_Target1; float depth : SV_Depth; };
    Targets frag(FromVertex i, bool front : SV_IsFrontFace)
    {
        clip(i.uv.x - 0.5);
        Targets t; t.a = i.color * _MainTex.Sample(sampler_MainTex, i.uv); t.b = i.id * i.clip.w + front; t.depth = i.clip.z;
    #ifdef RED
        t.a.gb = 0;
    #endif
        return t;
    }
    ENDHLSL
} } }";

        [Test]
        [ByGlslang("the stages list their values in different orders, which Direct3D refuses")]
        public void Stages_are_joined_by_semantics()
        {
            using (var files = new ShaderFolder().Add("T.shader", Linked))
            {
                ShaderSource shader = files.Shader("T.shader");
                foreach (string[] keywords in new[] { new string[0], new[] { "EXTRA" } })
                {
                    ShaderProgram vertex = ShaderFolder.Checked(shader.Passes[0].Compile(ShaderStage.Vertex, keywords));
                    ShaderProgram fragment = ShaderFolder.Checked(shader.Passes[0].Compile(ShaderStage.Fragment, keywords));
                    foreach ((string output, string input) in new[] { ("uv", "uv"), ("id", "id"), ("color", "color") })
                        Assert.That(Location(fragment, "i." + input), Is.EqualTo(Location(vertex, "@entryPointOutput." + output)), input);
                    Assert.That(Location(vertex, "@entryPointOutput.color"), Is.EqualTo(keywords.Length == 0 ? 3 : 4));
                    Assert.That(vertex.Inputs.Select(i => i.Semantic), Is.EqualTo(new[] { "POSITION", "TANGENT", "TEXCOORD0" }));
                    Assert.That(vertex.Resources.Select(r => r.Binding), Is.EqualTo(new[] { 0, 1 }));
                    Assert.That(fragment.Resources.Select(r => r.Binding), Is.EqualTo(new[] { 32, 33 }));
                    Assert.That(vertex.Resources.Single(r => r.Name == "_Positions").Stride, Is.EqualTo(12));
                }
            }
        }

        static uint Location(ShaderProgram program, string name)
        {
            SpirvModule module = SpirvModule.Read(program.Spirv);
            var types = new SpirvTypes(module);
            return types.Decorated(module.Instructions.Single(i => i.Op == Op.Variable && types.Name(i[1]) == name)[1], Decoration.Location)[2];
        }

        [Test]
        [ByGlslang("the stages list their values in different orders, which Direct3D refuses")]
        public void A_keyword_for_one_stage_leaves_the_other_alone()
        {
            using (var files = new ShaderFolder().Add("T.shader", Linked))
            {
                ShaderSource shader = files.Shader("T.shader");
                Assert.That(shader.Keywords, Is.EqualTo(new[] { "EXTRA", "RED" }));
                ShaderPassSource pass = shader.Passes[0];
                Assert.That(pass.Compile(ShaderStage.Vertex, new[] { "RED" }), Is.SameAs(pass.Compile(ShaderStage.Vertex, new string[0])));
                Assert.That(pass.Compile(ShaderStage.Fragment, new[] { "RED" }), Is.Not.SameAs(pass.Compile(ShaderStage.Fragment, new string[0])));
            }
        }

        [Test]
        [ByGlslang("vkd3d makes no use of a promise about depth")]
        public void Depth_modes_of_another_entry_point_do_not_stick()
        {
            const string text = @"Shader ""T"" { SubShader {
HLSLINCLUDE
float4 vert() : SV_Position { return 0; }
void deep(out float4 color : SV_Target, out float depth : SV_DepthGreaterEqual) { color = 1; depth = 0.5; }
float4 flat() : SV_Target { return 1; }
ENDHLSL
Pass { HLSLPROGRAM
#pragma vertex vert
#pragma fragment deep
#pragma target 5.0
ENDHLSL }
Pass { HLSLPROGRAM
#pragma vertex vert
#pragma fragment flat
ENDHLSL } } }";
            using (var files = new ShaderFolder().Add("T.shader", text))
            {
                ShaderSource shader = files.Shader("T.shader");
                const uint depthReplacing = 12, depthGreater = 14;
                uint[] Modes(int pass) => SpirvModule.Read(ShaderFolder.Checked(shader.Passes[pass].Compile(ShaderStage.Fragment,
                    null)).Spirv).Instructions.Where(i => i.Op == Op.ExecutionMode).Select(i => i[1]).ToArray();
                Assert.That(Modes(0), Has.Member(depthReplacing).And.Member(depthGreater));
                Assert.That(Modes(1), Has.No.Member(depthReplacing).And.No.Member(depthGreater));
            }
        }

        [Test]
        public void An_error_in_a_program_names_the_line_of_the_shader_file()
        {
            using (var files = new ShaderFolder().Add("Test.shader", "Shader \"T\"\n{\n SubShader { Pass {\n HLSLPROGRAM\n#pragma " +
                "vertex vert\n#pragma fragment frag\nfloat4 vert() : SV_Position { return oops; }\nENDHLSL\n} } }"))
            {
                var error = Assert.Throws<ShaderCompileException>(() => files.Shader("Test.shader").Passes[0].Compile(ShaderStage.Vertex, null));
                Assert.That(error.Message, Does.StartWith("Test.shader(7): error:").And.Contain("oops"));
            }
        }

        [Test]
        public void A_missing_entry_point_is_named_with_its_pragma()
        {
            using (var files = new ShaderFolder().Add("Test.shader", "Shader \"T\" { SubShader { Pass {\nHLSLPROGRAM\n#pragma vertex " +
                "vert\n#pragma fragment frag\nfloat4 vert() : SV_Position { return 1; }\nENDHLSL\n} } }"))
            {
                var error = Assert.Throws<ShaderCompileException>(() => files.Shader("Test.shader").Passes[0].Compile(ShaderStage.Fragment, null));
                Assert.That(error.Message, Is.EqualTo("Test.shader(4): error: entry point 'frag' not found"));
            }
        }

        [TestCase("Shader \"T\" { SubShader { Pass {", 1, "the end of the file")]
        [TestCase("Shader \"T\" {\n Properties { _A (\"A\", Flaot) = 1 } }", 2, "'Flaot' is not a type of a property")]
        [TestCase("Shader \"T\" {\n SubShader {\n Pass {\n Cull Sideways } } }", 4, "Off, Front, Back")]
        [TestCase("Shader \"T\" {\n SubShader {\n Pass {\n } } }", 3, "no HLSLPROGRAM")]
        [TestCase("Shader \"T\" {\n SubShader {\n Pass {\n HLSLPROGRAM\n } } }", 4, "ENDHLSL")]
        [TestCase("Shader \"T {\n", 1, "no closing quote")]
        [TestCase("Shader \"T\" {\n\n Gibberish }", 3, "'Gibberish'")]
        [TestCase("Shader \"T\" { SubShader {\n CGPROGRAM\n#pragma vertex vert\nENDCG } }", 2, "#pragma surface")]
        public void Syntax_errors_are_named_with_file_and_line(string text, int line, string what)
        {
            var error = Assert.Throws<ShaderCompileException>(() => Import(text));
            Assert.That(error.Message, Does.StartWith($"Test.shader({line}): error: ").And.Contain(what));
        }

        [TestCase("float4 vert() : SV_Position { return 0; } float4 frag(float2 uv : TEXCOORD3) : SV_Target { return uv.xyxy; }",
            "reads TEXCOORD3, which the vertex program does not write")]
        [TestCase("float4 vert(out float2 uv : TEXCOORD0) : SV_Position { uv = 1; return 0; } float4 frag(float4 uv : TEXCOORD0) : " +
            "SV_Target { return uv; }", "reads 4 components of TEXCOORD0, the vertex program writes 2")]
        public void Stages_that_do_not_fit_are_refused(string code, string what)
        {
            using (var files = new ShaderFolder()
                .Add("Test.shader",
                $"Shader \"T\" {{ SubShader {{ Pass {{ HLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n{code}\nENDHLSL }} }} }}"))
            {
                var error = Assert.Throws<ShaderCompileException>(() => files.Shader("Test.shader").Passes[0].Compile(ShaderStage.Fragment, null));
                Assert.That(error.Message, Does.Contain(what));
            }
        }
    }
}
