using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>_CameraDepthTexture of an orthographic camera with near plane 1 and far plane 11: a quad over the center of 64 x 32 pixels.</summary>
    public class CameraDepthTests : ShaderTextFixture
    {
        const float AtFive = 0.6f, AtSeven = 0.4f;      // (far - distance) / (far - near)

        Camera camera;

        [SetUp]
        public void Look()
        {
            camera = NewCamera();
            (camera.nearClipPlane, camera.farClipPlane) = (1, 11);
            camera.depthTextureMode = DepthTextureMode.Depth;
        }

        [TearDown]
        public void LookWithOneEye() => Player.Stereo = false;

        static GameObject Quad(Shader shader, float z = 0)
        {
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.transform.position = new Vector3(0, 0, z);
            quad.transform.localScale = Vector3.one * 4;
            quad.GetComponent<MeshRenderer>().sharedMaterial = new Material(shader);
            return quad;
        }

        static float[] Depth(int slice = 0)
        {
            var texture = (RenderTexture)Shader.GetGlobalTexture("_CameraDepthTexture");
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture, 0, 0, texture.width, 0, texture.height, slice, 1);
            request.WaitForCompletion();
            return request.GetData<float>().ToArray();
        }

        static float Center => Depth()[16 * 64 + 32];

        // Without a ShadowCaster pass of its own.
        static Shader Plain(string fallback, string tags = "") => ShaderOf($@"Shader ""Test/Plain {fallback.Replace("\"", "")}{tags.Length}"" {{
SubShader {{ Tags {{ {tags} }} Pass {{
CGPROGRAM
#pragma vertex vert
#pragma fragment frag
#include ""UnityCG.cginc""
float4 vert(float4 v : POSITION) : SV_POSITION {{ return UnityObjectToClipPos(v); }}
fixed4 frag() : SV_Target {{ return fixed4(1, 0, 0, 1); }}
ENDCG
}} }} Fallback {fallback} }}");

        static Shader Surface(string options, string body = "", string tags = "", string properties = "") => ShaderOf($@"Shader ""Test/Surface"" {{
Properties {{ _Cutoff (""Cutoff"", Float) = 0.5 {properties} }}
SubShader {{ Tags {{ ""RenderType"" = ""Opaque"" {tags} }}
CGPROGRAM
#pragma surface surf Lambert {options}
struct Input {{ float3 worldPos; }};
void vert(inout appdata_full v) {{ v.vertex.z += 2; }}
void surf (Input IN, inout SurfaceOutput o) {{ o.Albedo = 1; {body} }}
ENDCG
}} Fallback ""Diffuse"" }}");

        static IEnumerable<string> WithShadowCaster()
            => new[] { "Standard", "Standard (Specular setup)", "Diffuse", "VertexLit", "Mobile/Diffuse", "Mobile/VertexLit" };

        [TestCaseSource(nameof(WithShadowCaster))]
        public void It_holds_what_has_a_ShadowCaster_pass(string shader)
        {
            Quad(Shader.Find(shader));
            Frame();
            Assert.That(Center, Is.EqualTo(AtFive).Within(1e-5f));
            Assert.That(Depth()[0], Is.Zero, "the far plane is 0");
        }

        [TestCase("Unlit/Color")]
        [TestCase("Unlit/Texture")]
        [TestCase("Unlit/Transparent Cutout")]
        public void What_has_no_ShadowCaster_pass_is_not_in_it(string shader)
        {
            Quad(Shader.Find(shader));
            Quad(Shader.Find("Standard"), 2);
            Frame();
            Assert.That(Center, Is.EqualTo(AtSeven).Within(1e-5f), "the quad behind it");
            Assert.That(Pixel(32, 16).r, Is.GreaterThan(200), "though it is drawn in front");
        }

        [TestCase("\"Diffuse\"", true)]         // whose own is its fallback's
        [TestCase("\"VertexLit\"", true)]
        [TestCase("\"Unlit/Color\"", false)]
        [TestCase("Off", false)]
        public void The_pass_of_a_fallback_stands_in(string fallback, bool expected)
        {
            Quad(Plain(fallback));
            Frame();
            Assert.That(Center, Is.EqualTo(expected ? AtFive : 0).Within(1e-5f));
            Assert.That(new Material(Plain(fallback)).passCount, Is.EqualTo(1), "it is not a pass of the material");
        }

        [Test]
        public void A_fallback_that_is_not_there_is_named_once()
        {
            Quad(Plain("\"Nobody/Has This\""));
            Frame();
            Frame();
            Assert.That(Logged.Count(line => line.Contains(
                "Shader 'Test/Plain Nobody/Has This0': fallback shader 'Nobody/Has This' not found")), Is.EqualTo(1),
                string.Join("\n", Logged));
            Assert.That(Center, Is.Zero);
        }

        [Test]
        public void A_material_may_have_the_pass_off()
        {
            Quad(Shader.Find("Standard")).GetComponent<MeshRenderer>().sharedMaterial.SetShaderPassEnabled("ShadowCaster", false);
            Frame();
            Assert.That(Center, Is.Zero);
        }

        [TestCase(2500, AtFive)]
        [TestCase(2501, 0)]
        public void Only_opaque_queues_are_in_it(int queue, float expected)
        {
            Quad(Shader.Find("Standard")).GetComponent<MeshRenderer>().sharedMaterial.renderQueue = queue;
            Frame();
            Assert.That(Center, Is.EqualTo(expected).Within(1e-5f));
        }

        [Test]
        public void What_casts_no_shadow_is_in_it_and_what_only_casts_is_not([Values] bool only)
        {
            Quad(Shader.Find("Standard")).GetComponent<MeshRenderer>().shadowCastingMode = only ? ShadowCastingMode.ShadowsOnly
                : ShadowCastingMode.Off;
            Frame();
            Assert.That(Center, Is.EqualTo(only ? 0 : AtFive).Within(1e-5f));
        }

        [TestCase("vertex:vert", AtFive)]
        [TestCase("vertex:vert addshadow", 0.4f)]
        public void A_surface_shader_moves_its_depth_only_with_addshadow(string options, float expected)
        {
            // The vertex function moves by two units before the object's scale of one.
            Quad(Surface(options)).transform.localScale = new Vector3(4, 4, 1);
            Frame();
            Assert.That(Center, Is.EqualTo(expected).Within(1e-5f));
        }

        [Test]
        public void A_surface_shader_with_addshadow_cuts_its_depth_by_alpha()
        {
            Quad(Surface("alphatest:_Cutoff addshadow", "o.Alpha = IN.worldPos.x > 0;"));
            Frame();
            float[] depth = Depth();
            Assert.That(depth[16 * 64 + 34], Is.EqualTo(AtFive).Within(1e-5f));
            Assert.That(depth[16 * 64 + 30], Is.Zero);
        }

        [Test]
        public void It_is_there_at_the_event_after_it_and_before_anything_else_is_drawn()
        {
            // Looks at the texture while the camera's own target is not even cleared.
            Material look = new Material(ShaderOf(Effect("UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture); float4 frag(v2f_img i) : " +
                "SV_Target { return SAMPLE_DEPTH_TEXTURE(_CameraDepthTexture, i.uv); }")));
            Quad(Shader.Find("Standard"));
            foreach (CameraEvent moment in new[] { CameraEvent.AfterDepthTexture, CameraEvent.BeforeForwardOpaque })
            {
                var target = new RenderTexture(64, 32, 0, RenderTextureFormat.ARGBFloat);
                using var commands = new CommandBuffer();
                commands.Blit(null, target, look);
                camera.AddCommandBuffer(moment, commands);
                Frame();
                camera.RemoveAllCommandBuffers();
                Assert.That(Read(target)[16 * 64 + 32].x, Is.EqualTo(AtFive).Within(1e-5f), moment.ToString());
                Object.DestroyImmediate(target);
            }
        }

        [TestCase(DepthTextureMode.None, 0)]
        [TestCase(DepthTextureMode.Depth, 1)]
        public void Its_events_come_only_where_it_is_drawn(DepthTextureMode mode, int times)
        {
            camera.depthTextureMode = mode;
            var before = new RenderTexture(1, 1, 0, RenderTextureFormat.ARGBFloat);
            before.Create();
            foreach (CameraEvent moment in new[] { CameraEvent.BeforeDepthTexture, CameraEvent.AfterDepthTexture })
            {
                RenderTexture.active = before;
                GL.Clear(false, true, Color.clear);
                RenderTexture.active = null;
                using var commands = new CommandBuffer();
                commands.SetRenderTarget(before);
                commands.ClearRenderTarget(false, true, Color.white);
                camera.AddCommandBuffer(moment, commands);
                Frame();
                camera.RemoveAllCommandBuffers();
                Assert.That(Read(before)[0].x, Is.EqualTo(times), moment.ToString());
            }
            Object.DestroyImmediate(before);
        }

        [Test]
        public void It_has_the_cameras_size_in_pixels()
        {
            camera.targetTexture = new RenderTexture(40, 24, 24);
            camera.rect = new Rect(0, 0, 0.5f, 1);
            Frame();
            Texture depth = Shader.GetGlobalTexture("_CameraDepthTexture");
            Assert.That((depth.width, depth.height), Is.EqualTo((20, 24)));
            Object.DestroyImmediate(camera.targetTexture);
            camera.targetTexture = null;
        }

        [Test]
        public void Two_eyes_in_one_pass_have_a_slice_each()
        {
            Player.Stereo = true;
            GameObject quad = Quad(DrawShader("Stereo"));
            quad.transform.localScale = new Vector3(0.064f * 4, 10, 1);     // four times the distance of the eyes
            camera.orthographicSize = 0.256f;                               // a pixel is 16 mm
            Frame();
            var texture = (RenderTexture)Shader.GetGlobalTexture("_CameraDepthTexture");
            Assert.That((texture.dimension, texture.volumeDepth, texture.width, texture.height),
                Is.EqualTo((TextureDimension.Tex2DArray, 2, 32, 32)));
            int[][] rows = { Row(0), Row(1) };
            Assert.That(rows[0].Length, Is.GreaterThan(4), "the left eye sees it");
            Assert.That(rows[1].Length, Is.EqualTo(rows[0].Length), "so does the right eye");
            Assert.That(rows[0][0], Is.GreaterThan(rows[1][0]), "the left eye sees it farther to the right");

            int[] Row(int eye) => Enumerable.Range(0, 32).Where(x => Depth(eye)[16 * 32 + x] > 0.5f).ToArray();
        }

        [Test]
        public void A_shadow_falls_on_surface_shaders_and_on_what_asks_for_fwdbase([Values("Standard", "Diffuse", "fwdbase")] string shader)
        {
            var sun = new GameObject("Sun").AddComponent<Light>();
            (sun.type, sun.shadows) = (LightType.Directional, LightShadows.Hard);
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientLight = Color.black;
            Quad(shader == "fwdbase" ? ForwardBase() : Shader.Find(shader), 2).transform.localScale = Vector3.one * 12;
            Quad(Shader.Find("Standard")).GetComponent<MeshRenderer>().shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            Frame();
            Assert.That(Pixel(32, 16).r, Is.LessThan(5), "below the quad that only casts");
            Assert.That(Pixel(25, 16).r, Is.GreaterThan(150), "beside it");
        }

        static Shader ForwardBase() => ShaderOf(@"Shader ""Test/ForwardBase"" {
SubShader { Pass { Tags { ""LightMode"" = ""ForwardBase"" }
CGPROGRAM
#pragma vertex vert
#pragma fragment frag
#pragma multi_compile_fwdbase
#include ""UnityCG.cginc""
#include ""Lighting.cginc""
#include ""AutoLight.cginc""
struct v2f { float4 pos : SV_POSITION; float3 world : TEXCOORD0; SHADOW_COORDS(1) };
v2f vert(appdata_base v) { v2f o; o.pos = UnityObjectToClipPos(v.vertex); o.world = mul(unity_ObjectToWorld, v.vertex).xyz;
    TRANSFER_SHADOW(o) return o; }
fixed4 frag(v2f i) : SV_Target { UNITY_LIGHT_ATTENUATION(atten, i, i.world); return atten * _LightColor0; }
ENDCG
} } Fallback ""VertexLit"" }");
    }
}
