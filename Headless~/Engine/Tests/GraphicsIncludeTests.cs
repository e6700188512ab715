using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>The include files that come with the editor in Unity: their names, and the values behind them.</summary>
    public class GraphicsIncludeTests : ShaderTextFixture
    {
        static IEnumerable<string> Files() => Directory.GetFiles(BuiltInFiles.Includes, "*.cginc").Select(Path.GetFileName).OrderBy(n => n);

        [TestCaseSource(nameof(Files))]
        public void Every_include_file_compiles_alone_in_a_kernel_and_in_both_kinds_of_program(string file)
        {
            using (var files = new ShaderFolder()
                .Add("Test.compute", $"#pragma kernel Main\n#include \"{file}\"\nRWStructuredBuffer<float> Out;\n[numthreads(1,1,1)] " +
                    $"void Main() {{ Out[0] = 1; }}")
                .Add("Test.shader", $"Shader \"T\" {{ SubShader {{ Pass {{\nHLSLPROGRAM\n#pragma vertex vert\n#pragma fragment " +
                    $"frag\n#include \"{file}\"\nfloat4 vert() : SV_Position {{ return 0; }}\nfloat4 frag() : SV_Target {{ return 1; " +
                    $"}}\nENDHLSL }} }} }}"))
            {
                ShaderFolder.Checked(files.Compute("Test.compute").Compile(0, new string[0]));
                ShaderPassSource pass = files.Shader("Test.shader").Passes[0];
                ShaderFolder.Checked(pass.Compile(ShaderStage.Vertex, new string[0]));
                ShaderFolder.Checked(pass.Compile(ShaderStage.Fragment, new string[0]));
            }
        }

        [Test]
        public void A_projects_own_file_comes_before_the_built_in_one()
        {
            using (var files = new ShaderFolder()
                .Add("UnityCG.cginc", "float mine() { return 1; }")
                .Add("Test.compute", "#pragma kernel Main\n#include \"UnityCG.cginc\"\nRWStructuredBuffer<float> " +
                    "Out;\n[numthreads(1,1,1)] void Main() { Out[0] = mine(); }"))
                files.Compute("Test.compute").Compile(0, new string[0]);
        }

        [Test]
        public void An_unknown_include_is_named_with_file_and_line()
        {
            using (var files = new ShaderFolder()
                .Add("Test.compute", "#pragma kernel Main\n#include \"UnityNope.cginc\"\n[numthreads(1,1,1)] void Main() { }"))
                Assert.That(Assert.Throws<ShaderCompileException>(() => files.Compute("Test.compute").Compile(0, new string[0])).Message,
                    Does.StartWith("Test.compute(2): error: Couldn't open include file 'UnityNope.cginc'"));
        }

        new static Camera NewCamera()
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(1, 2, 3);
            camera.nearClipPlane = 0.5f;
            camera.farClipPlane = 100;
            camera.Render();
            return camera;
        }

        static void AssertNear(Vector4 actual, Vector4 expected, float within = 1e-5f)
        {
            for (int i = 0; i < 4; i++)
                Assert.That(actual[i], Is.EqualTo(expected[i]).Within(within * Mathf.Max(1, Mathf.Abs(expected[i]))),
                    $"component {i} of {actual}, expected {expected}");
        }

        [Test]
        public void Variables_of_the_camera_have_their_documented_values()
        {
            NewCamera();
            AssertNear(Value("float4(_WorldSpaceCameraPos, 1)"), new Vector4(1, 2, 3, 1));
            AssertNear(Value("_ProjectionParams"), new Vector4(-1, 0.5f, 100, 0.01f));
            AssertNear(Value("_ScreenParams"), new Vector4(64, 32, 1 + 1 / 64f, 1 + 1 / 32f));
            AssertNear(Value("unity_CameraToWorld[2]"), new Vector4(0, 0, 1, 3));
        }

        [Test]
        public void Depth_is_reversed_and_comes_back_as_a_distance()
        {
            NewCamera();
            AssertNear(Value("float4(LinearEyeDepth(1), LinearEyeDepth(0), Linear01Depth(1), Linear01Depth(0))"),
                new Vector4(0.5f, 100, 0.005f, 1), 1e-3f);
        }

        [Test]
        public void Colors_go_through_the_srgb_curve()
        {
            AssertNear(Value("float4(GammaToLinearSpace(0.5), 1)"), new Vector4(0.214f, 0.214f, 0.214f, 1), 2e-3f);
            AssertNear(Value("float4(LinearToGammaSpace(0.214), 1)"), new Vector4(0.5f, 0.5f, 0.5f, 1), 2e-3f);
            AssertNear(Value("float4(GammaToLinearSpaceExact(0.5), LinearToGammaSpaceExact(0.2140411), 0, 0)"),
                new Vector4(0.2140411f, 0.5f, 0, 0), 1e-4f);
        }

        [Test]
        public void Numbers_survive_being_encoded_in_colors()
        {
            AssertNear(Value("float4(DecodeFloatRGBA(EncodeFloatRGBA(0.3)), DecodeFloatRG(EncodeFloatRG(0.7)), 0, 0)"),
                new Vector4(0.3f, 0.7f, 0, 0), 1e-4f);
            AssertNear(Value("float4(DecodeViewNormalStereo(float4(EncodeViewNormalStereo(normalize(float3(1, 2, 3))), 0, 0)), 0)"),
                new Vector3(1, 2, 3).normalized, 1e-4f);
            AssertNear(Value("float4(UnpackNormal(float4(1, 0.5, 0.5, 1)), 0)"), new Vector4(1, 0, 0, 0), 1e-4f);
        }

        [Test]
        public void Old_texture_calls_read_what_the_new_ones_read()
        {
            var texture = new Texture2D(2, 1, TextureFormat.RGBAFloat, false, true) { filterMode = FilterMode.Point,
                wrapMode = TextureWrapMode.Clamp };
            texture.SetPixels(new[] { new Color(1, 2, 3, 4), new Color(5, 6, 7, 8) });
            texture.Apply();
            const string declare =
                "sampler2D _MainTex; float4 _MainTex_TexelSize; float4 Through(sampler2D tex, float2 uv) { return tex2D(tex, uv); }";
            var right = new Vector4(5, 6, 7, 8);
            AssertNear(Value("tex2D(_MainTex, float2(0.75, 0.5))", declare, texture), right);
            AssertNear(Value("tex2D(_MainTex, float4(0.75, 0.5, 9, 9))", declare, texture), right);
            AssertNear(Value("tex2Dlod(_MainTex,\n float4(0.75, 0.5, 0, 0))", declare, texture), right);
            AssertNear(Value("tex2Dproj(_MainTex, float4(1.5, 1, 0, 2))", declare, texture), right);
            AssertNear(Value("tex2Dgrad(_MainTex, float2(0.75, 0.5), 0, 0)", declare, texture), right);
            AssertNear(Value("Through(_MainTex, tex2D(_MainTex, float2(0.75, 0.5)).xy)", declare, texture), right);
            AssertNear(Value("SAMPLE_DEPTH_TEXTURE(_MainTex, float2(0.75, 0.5)).xxxx", declare, texture), Vector4.one * 5);
            AssertNear(Value("_MainTex_TexelSize", declare, texture), new Vector4(0.5f, 1, 2, 1));
            AssertNear(Value("UNITY_SAMPLE_TEX2D(_MainTex, float2(0.75, 0.5))", "UNITY_DECLARE_TEX2D(_MainTex);", texture), right);
            Object.DestroyImmediate(texture);
        }

        [Test]
        public void An_error_behind_old_texture_calls_is_at_its_own_line()
        {
            const string code =
                "sampler2D _MainTex;\nfloat4 frag(v2f_img i) : SV_Target {\n float4 c = tex2D(_MainTex,\n i.uv);\n return nonsense; }";
            var error = Assert.Throws<ShaderCompileException>(() => ShaderOf(Effect(code)).Source.Passes[0].Compile(ShaderStage.Fragment,
                new string[0]));
            Assert.That(error.Message, Does.StartWith("Test.shader(10): error: ").And.Contain("nonsense"));
        }

        [Test]
        public void Elements_of_a_matrix_can_be_assigned_several_at_once()
        {
            AssertNear(Value("Moved()[1]", "float4 Moved_(float4x4 m) { return 0; } float4x4 Moved() { float4x4 m = 0;\n " +
                "m._11_21_31_41 = float4(1, 2, 3, 4);\n if (m._11 > 0) m._14_24 =\n float2(5, 6); return m; }"), new Vector4(2, 0, 0, 6));
        }

        [Test]
        public void Semantics_of_old_still_mean_the_position()
        {
            const string code = "struct v2f { float4 pos : POSITION; float2 uv : TEXCOORD0; };\n" +
                "v2f vert(appdata_img v) { v2f o; o.pos = UnityObjectToClipPos(v.vertex); o.uv = v.texcoord; return o; }\n" +
                "float4 frag(float2 uv : TEXCOORD0, UNITY_VPOS_TYPE at : VPOS) : COLOR { return float4(at.xy, uv); }";
            var target = new RenderTexture(2, 2, 0, RenderTextureFormat.ARGBFloat);
            Graphics.Blit(null, target, new Material(ShaderOf(Effect(code).Replace("vert_img", "vert"))));
            AssertNear(Read(target)[1], new Vector4(1.5f, 0.5f, 0.75f, 0.25f));
            Object.DestroyImmediate(target);
        }

        [Test]
        public void A_screen_position_points_at_its_own_texel()
        {
            // ComputeScreenPos of the clip position that a Blit draws at must be the uv that it is drawn with.
            const string code = "struct v2f { float4 pos : SV_POSITION; float4 screen : TEXCOORD0; float2 uv : TEXCOORD1; };\n" +
                "v2f vert(appdata_img v) { v2f o; o.pos = UnityObjectToClipPos(v.vertex); o.screen = ComputeScreenPos(o.pos); o.uv = " +
                "v.texcoord; return o; }\n" +
                "float4 frag(v2f i) : SV_Target { return float4(i.screen.xy / i.screen.w, i.uv); }";
            NewCamera();
            var target = new RenderTexture(2, 2, 0, RenderTextureFormat.ARGBFloat);
            Graphics.Blit(null, target, new Material(ShaderOf(Effect(code).Replace("vert_img", "vert"))));
            Vector4[] texels = Read(target);
            AssertNear(texels[0], new Vector4(0.25f, 0.25f, 0.25f, 0.25f));
            AssertNear(texels[3], new Vector4(0.75f, 0.75f, 0.75f, 0.75f));
            Object.DestroyImmediate(target);
        }
    }
}
