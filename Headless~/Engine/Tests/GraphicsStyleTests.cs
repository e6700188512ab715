using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>The ways in which users draw: OnRenderObject, GL, chains of blits, stacks of image effects, several targets.</summary>
    public class GraphicsStyleTests : ShaderTextFixture
    {
        static readonly Color32 clear = new Color32(0, 0, 255, 255);

        const string PointsShader = @"Shader ""Test/Points"" { SubShader { Pass {
CGPROGRAM
#pragma target 5.0
#pragma vertex vert
#pragma fragment frag
#include ""UnityCG.cginc""
StructuredBuffer<float3> _Points;
struct v2f { float4 pos : SV_POSITION; };
v2f vert(uint id : SV_VertexID, uint inst : SV_InstanceID) { v2f o; o.pos = UnityObjectToClipPos(float4(_Points[id + inst], 1)); return o; }
fixed4 frag(v2f i) : COLOR { return fixed4(1, 0, 0, 1); }
ENDCG } } }";

        sealed class PointDrawer : MonoBehaviour
        {
            public Material Material;
            public int Calls;

            void OnRenderObject()
            {
                Calls++;
                Material.SetPass(0);
                Graphics.DrawProceduralNow(MeshTopology.Points, 1, 2);
            }
        }

        [Test]
        public void OnRenderObject_draws_procedural_points_into_every_camera()
        {
            NewCamera();
            var drawer = new GameObject("Drawer").AddComponent<PointDrawer>();
            using (var points = new ComputeBuffer(2, 12))
            {
                points.SetData(new[] { new Vector3(-3.75f, 0.25f, 0), new Vector3(4.25f, 2.25f, 0) });
                drawer.Material = new Material(ShaderOf(PointsShader));
                drawer.Material.SetBuffer("_Points", points);
                Frame();
            }
            Assert.That(drawer.Calls, Is.EqualTo(1));
            Assert.That(Pixel(24, 15), Is.EqualTo(new Color32(255, 0, 0, 255)));
            Assert.That(Pixel(40, 11), Is.EqualTo(new Color32(255, 0, 0, 255)));
            Assert.That(Pixel(32, 16), Is.EqualTo(clear));
        }

        [Test]
        public void A_chain_of_blits_stays_upright_however_long()
        {
            var source = new Texture2D(2, 2, TextureFormat.RGBAFloat, false, true) { filterMode = FilterMode.Point };
            source.SetPixels(new[] { Color.red, Color.green, Color.blue, Color.white });
            source.Apply();
            var add =
                new Material(ShaderOf(Effect(
                "sampler2D _MainTex; float4 frag(v2f_img i) : SV_Target { return tex2D(_MainTex, i.uv) + 0.5; }")));
            for (int length = 1; length <= 4; length++)
            {
                RenderTexture from = RenderTexture.GetTemporary(2, 2, 0, RenderTextureFormat.ARGBHalf);
                Graphics.Blit(source, from);
                for (int i = 0; i < length; i++)
                {
                    RenderTexture to = RenderTexture.GetTemporary(2, 2, 0, RenderTextureFormat.ARGBHalf);
                    Graphics.Blit(from, to, add);
                    RenderTexture.ReleaseTemporary(from);
                    from = to;
                }
                Vector4[] texels = Read(from);
                float gained = length * 0.5f;
                Assert.That((Color)texels[0], Is.EqualTo(new Color(1 + gained, gained, gained, 1 + gained)), $"first texel after {length}");
                Assert.That((Color)texels[1], Is.EqualTo(new Color(gained, 1 + gained, gained, 1 + gained)));
                Assert.That((Color)texels[2], Is.EqualTo(new Color(gained, gained, 1 + gained, 1 + gained)));
                RenderTexture.ReleaseTemporary(from);
            }
            Object.DestroyImmediate(source);
        }

        [ImageEffectAllowedInSceneView]
        sealed class Halve : MonoBehaviour
        {
            public Material Material;
            [ImageEffectOpaque] void OnRenderImage(RenderTexture source, RenderTexture destination) => Graphics.Blit(source, destination, Material);
        }

        sealed class SwapChannels : MonoBehaviour
        {
            public Material Material;
            void OnRenderImage(RenderTexture source, RenderTexture destination)
            {
                RenderTexture half = RenderTexture.GetTemporary(source.width / 2, source.height / 2, 0, source.format);
                Graphics.Blit(source, half);
                Graphics.Blit(half, destination, Material, 1);
                RenderTexture.ReleaseTemporary(half);
            }
        }

        [Test]
        public void Image_effects_stack_in_the_order_of_the_components_and_choose_their_passes()
        {
            Camera camera = NewCamera();
            var halve = new Material(ShaderOf(
                Effect(
                "sampler2D _MainTex; float4 frag(v2f_img i) : SV_Target { float4 c = tex2D(_MainTex, i.uv); c.r = i.uv.y > 0.5; return c; }")));
            string pass = "Pass {\nCGPROGRAM\n#pragma vertex vert_img\n#pragma fragment frag\n#include \"UnityCG.cginc\"\nsampler2D " +
                "_MainTex; fixed4 frag(v2f_img i) : SV_Target { return tex2D(_MainTex, i.uv).CHANNELS; }\nENDCG\n}";
            var swap = new Material(ShaderOf(
                $"Shader \"T\" {{ SubShader {{ ZTest Always {pass.Replace("CHANNELS", "rrra")} {pass.Replace("CHANNELS", "brga")} }} }}"));
            camera.gameObject.AddComponent<Halve>().Material = halve;
            camera.gameObject.AddComponent<SwapChannels>().Material = swap;
            Frame();
            Assert.That(Pixel(10, 5), Is.EqualTo(new Color32(255, 255, 0, 255)), "blue is red now, and red of the upper half green");
            Assert.That(Pixel(10, 25), Is.EqualTo(new Color32(255, 0, 0, 255)));
        }

        [Test]
        public void Two_targets_are_written_by_one_pass()
        {
            string code = "struct Out { float4 a : SV_Target0; float4 b : SV_Target1; };\nOut frag(v2f_img i) { Out o; o.a = float4(1, " +
                "0, 0, 1); o.b = float4(0, i.uv.y, 0, 1); return o; }";
            var first = new RenderTexture(2, 2, 0, RenderTextureFormat.ARGBFloat);
            var second = new RenderTexture(2, 2, 0, RenderTextureFormat.ARGBFloat);
            first.Create();
            second.Create();
            Graphics.SetRenderTarget(new[] { first.colorBuffer, second.colorBuffer }, first.depthBuffer);
            var material = new Material(ShaderOf(Effect(code)));
            GL.PushMatrix();
            GL.LoadOrtho();
            material.SetPass(0);
            Graphics.DrawMeshNow(Resources.GetBuiltinResource<Mesh>("Quad.fbx"), Matrix4x4.Translate(new Vector3(0.5f, 0.5f, 0)));
            GL.PopMatrix();
            RenderTexture.active = null;
            Assert.That(Read(first)[3], Is.EqualTo(new Vector4(1, 0, 0, 1)));
            Assert.That(Read(second)[0], Is.EqualTo(new Vector4(0, 0.25f, 0, 1)));
            Assert.That(Read(second)[3], Is.EqualTo(new Vector4(0, 0.75f, 0, 1)));
            Object.DestroyImmediate(first);
            Object.DestroyImmediate(second);
        }

        [Test]
        public void A_mesh_drawn_now_takes_the_pass_that_was_set_and_its_matrix()
        {
            var target = new RenderTexture(64, 32, 16);
            Camera camera = NewCamera();
            camera.enabled = false;
            camera.targetTexture = target;
            camera.Render();
            RenderTexture.active = target;
            var material = new Material(Shader.Find("Unlit/Color")) { color = Color.red };
            Assert.That(material.SetPass(0), Is.True);
            GL.PushMatrix();
            GL.modelview = camera.worldToCameraMatrix;
            GL.LoadProjectionMatrix(camera.projectionMatrix);
            Graphics.DrawMeshNow(Resources.GetBuiltinResource<Mesh>("Quad.fbx"),
                Matrix4x4.TRS(new Vector3(-4, 0, 0), Quaternion.identity, Vector3.one * 2));
            GL.PopMatrix();
            RenderTexture.active = null;
            Assert.That(Pixel(24, 16, target), Is.EqualTo(new Color32(255, 0, 0, 255)));
            Assert.That(Pixel(32, 16, target), Is.EqualTo(clear));
            Object.DestroyImmediate(camera.gameObject);
            Object.DestroyImmediate(target);
        }

        [Test]
        public void The_depth_texture_of_a_camera_reaches_an_image_effect()
        {
            Camera camera = NewCamera();
            camera.orthographic = false;
            camera.nearClipPlane = 1;
            camera.farClipPlane = 21;
            camera.depthTextureMode = DepthTextureMode.Depth;
            camera.gameObject.AddComponent<Halve>().Material = new Material(ShaderOf(Effect(
                "UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture); float4 frag(v2f_img i) : SV_Target { float d = " +
                "LinearEyeDepth(SAMPLE_DEPTH_TEXTURE(_CameraDepthTexture, i.uv)); return float4(abs(d - 5) < 0.01, d > 20.9, 0, 1); }")));
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.transform.position = new Vector3(0, 1.5f, 0);
            Frame();
            Assert.That(Pixel(32, 8), Is.EqualTo(new Color32(255, 0, 0, 255)), "five units away, in the upper half");
            Assert.That(Pixel(32, 24), Is.EqualTo(new Color32(0, 255, 0, 255)), "nothing below it");
        }

        [Test]
        public void Gamma_projects_compute_with_the_numbers_of_the_colors()
        {
            Player.LinearColorSpace = false;
            NewCamera();
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.transform.localScale = Vector3.one * 4;
            quad.GetComponent<Renderer>().material = new Material(Shader.Find("Sprites/Default")) { color = new Color(1, 0, 0, 0.5f) };
            Frame();
            Color32 pixel = Pixel(32, 16);
            Assert.That(new[] { (int)pixel.r, pixel.g, pixel.b }, Is.EqualTo(new[] { 128, 0, 128 }).Within(1));
            Assert.That(Value("float4(IsGammaSpace(), unity_ColorSpaceGrey.r, 0, 0)"), Is.EqualTo(new Vector4(1, 0.5f, 0, 0)));
        }

        static Shader Masked(string state) => ShaderOf(
            "Shader \"T\" { Properties { _Color (\"C\", Color) = (1,1,1,1) _Ref (\"R\", Int) = 1 } SubShader { Pass { " + state +
            "\nCGPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n#include \"UnityCG.cginc\"\nfixed4 _Color; float4 vert(float4 v " +
            ": POSITION) : SV_POSITION { return UnityObjectToClipPos(v); } fixed4 frag() : SV_Target { return _Color; }\nENDCG } } }");

        [Test]
        public void A_stencil_lets_through_where_it_was_written([Values(false, true)] bool intoTexture)
        {
            Camera camera = NewCamera();
            RenderTexture target = intoTexture ? new RenderTexture(64, 32, 24) : null;
            camera.targetTexture = target;
            Mesh quad = Resources.GetBuiltinResource<Mesh>("Quad.fbx");
            var mask = new Material(Masked("ColorMask 0 ZWrite Off Stencil { Ref [_Ref] Comp Always Pass Replace }")) { renderQueue = 1999 };
            mask.SetInt("_Ref", 2);
            var inside = new Material(Masked("Stencil { Ref 2 Comp Equal }")) { color = Color.red };
            var outside = new Material(Masked("Stencil { Ref 3 ReadMask 2 Comp NotEqual }")) { color = Color.green };
            Graphics.DrawMesh(quad, Matrix4x4.Scale(Vector3.one * 4), mask, 0);
            Graphics.DrawMesh(quad, Matrix4x4.TRS(new Vector3(2, 0, 0), Quaternion.identity, Vector3.one * 4), inside, 0);
            Graphics.DrawMesh(quad, Matrix4x4.TRS(new Vector3(-2, 0, 0), Quaternion.identity, Vector3.one * 4), outside, 0);
            Frame();
            Assert.That(Pixel(33, 16, target), Is.EqualTo(new Color32(255, 0, 0, 255)), "inside of the mask");
            Assert.That(Pixel(38, 16, target), Is.EqualTo(clear), "outside of it");
            Assert.That(Pixel(26, 16, target), Is.EqualTo(new Color32(0, 255, 0, 255)), "where the masked bit is not set");
            Assert.That(Pixel(30, 16, target), Is.EqualTo(clear), "where it is");
            if (target != null)
                Object.DestroyImmediate(target);
        }

        [Test]
        public void A_broken_shader_draws_magenta_and_is_named_once()
        {
            Player.Strict = false;
            NewCamera();
            var broken = new Material(ShaderOf("Shader \"Broken\" { SubShader { Pass {\nCGPROGRAM\n#pragma vertex vert\n#pragma " +
                "fragment frag\nfloat4 vert(float4 v : POSITION) : SV_POSITION { return nonsense; }\nfloat4 frag() : SV_Target { " +
                "return 1; }\nENDCG } } }"));
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex(
                @"Shader error in 'Broken': Test\.shader\(5\): error: .*nonsense"));
            for (int i = 0; i < 2; i++)
            {
                Graphics.DrawMesh(Resources.GetBuiltinResource<Mesh>("Quad.fbx"), Matrix4x4.Scale(Vector3.one * 4), broken, 0);
                Frame();
            }
            Assert.That(Pixel(32, 16), Is.EqualTo(new Color32(255, 0, 255, 255)));
        }

        [Test]
        public void A_part_of_a_texture_is_blitted_by_scale_and_offset()
        {
            var source = new Texture2D(2, 2, TextureFormat.RGBAFloat, false, true) { filterMode = FilterMode.Point };
            source.SetPixels(new[] { Color.red, Color.green, Color.blue, Color.white });
            source.Apply();
            var target = new RenderTexture(1, 1, 0, RenderTextureFormat.ARGBFloat);
            Graphics.Blit(source, target, Vector2.one * 0.5f, new Vector2(0.5f, 0));
            Assert.That((Color)Read(target)[0], Is.EqualTo(Color.green));
            Object.DestroyImmediate(source);
            Object.DestroyImmediate(target);
        }

        [Test]
        public void The_corners_of_a_view_are_counted_clockwise_from_the_lower_left()
        {
            Camera camera = NewCamera();
            camera.orthographic = false;
            camera.fieldOfView = 90;
            var corners = new Vector3[4];
            camera.CalculateFrustumCorners(new Rect(0, 0, 1, 1), 10, Camera.MonoOrStereoscopicEye.Mono, corners);
            Assert.That(Vector3.Distance(corners[0], new Vector3(-20, -10, 10)), Is.LessThan(1e-3f), $"{corners[0]}");
            Assert.That(Vector3.Distance(corners[2], new Vector3(20, 10, 10)), Is.LessThan(1e-3f), $"{corners[2]}");
        }
    }
}
