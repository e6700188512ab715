using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Light of the sky in draws: its reflection, and its light on surfaces.</summary>
    public class EnvironmentLightingTests : ShaderTextFixture
    {
        RenderTexture target;

        [SetUp]
        public void Look()
        {
            target = new RenderTexture(16, 16, 24, RenderTextureFormat.ARGBFloat);
            Camera camera = NewCamera();
            camera.targetTexture = target;
            camera.orthographicSize = 0.5f;
            camera.backgroundColor = Color.black;
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientLight = Color.black;
        }

        [TearDown]
        public void Restore() => Object.DestroyImmediate(target);

        /// <param name="color">Of the direction d.</param>
        static Material SkyOf(string color) => new Material(ShaderOf($@"Shader ""Test/Sky"" {{
Properties {{ _Tint (""Tint"", Vector) = (1, 1, 1, 1) }}
SubShader {{ Tags {{ ""Queue"" = ""Background"" }} Pass {{
CGPROGRAM
#pragma vertex vert
#pragma fragment frag
#include ""UnityCG.cginc""
struct v2f {{ float4 position : SV_POSITION; float3 d : TEXCOORD0; }};
float4 _Tint;
v2f vert(appdata_base v) {{ v2f o; o.position = UnityObjectToClipPos(v.vertex); o.d = v.texcoord.xyz; return o; }}
float4 frag(v2f i) : SV_Target {{ float3 d = normalize(i.d), color = {color}; return float4(color, 1) * _Tint; }}
ENDCG
}} }} }}"));

        // The quad over the whole picture shows what an expression of unity_SpecCube0 gives.
        Vector4 Seen(string expression)
        {
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.GetComponent<MeshRenderer>().sharedMaterial = new Material(ShaderOf($@"Shader ""Test/Reflect"" {{ SubShader {{ Pass {{
CGPROGRAM
#pragma vertex vert
#pragma fragment frag
#include ""UnityCG.cginc""
float4 vert(float4 v : POSITION) : SV_POSITION {{ return UnityObjectToClipPos(v); }}
float4 frag() : SV_Target {{ return {expression}; }}
ENDCG
}} }} }}"));
            Frame();
            Vector4 seen = Read(target)[8 * 16 + 8];
            Object.DestroyImmediate(quad);
            return seen;
        }

        static string Sample(Vector3 d, float mip = 0)
            => FormattableString.Invariant($"UNITY_SAMPLE_TEXCUBE_LOD(unity_SpecCube0, float3({d.x}, {d.y}, {d.z}), {mip})");

        static readonly Vector3[] Directions =
        {
            Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward, Vector3.back,
            new Vector3(1, 0.3f, -0.6f), new Vector3(-1, -0.7f, 0.2f), new Vector3(0.4f, 1, 0.5f), new Vector3(0.4f, -1, -0.5f),
                new Vector3(0.6f, 0.3f, 1), new Vector3(-0.6f, 0.3f, -1),
        };

        [TestCaseSource(nameof(Directions))]
        public void The_reflection_holds_the_sky_in_its_direction(Vector3 direction)
        {
            RenderSettings.skybox = SkyOf("d * 0.5 + 0.5");
            Vector3 seen = Seen(Sample(direction));
            Assert.That(Vector3.Distance(seen, direction.normalized * 0.5f + Vector3.one * 0.5f), Is.LessThan(0.01f), $"{seen} towards {direction}");
        }

        [Test]
        public void It_keeps_what_is_brighter_than_white()
        {
            RenderSettings.skybox = SkyOf("float3(40, 0.5, 0)");
            Assert.That(Vector4.Distance(Seen(Sample(Vector3.up)), new Vector4(40, 0.5f, 0, 1)), Is.LessThan(0.05f));
        }

        [Test]
        public void Its_mips_are_the_rougher_the_smaller()
        {
            RenderSettings.skybox = SkyOf("d.y > 0 ? 1 : 0");
            Vector3 above = new Vector3(0.3f, 0.15f, 1);
            float last = 1.001f;
            for (int mip = 0; mip <= 6; mip++)
            {
                float seen = Seen(Sample(above, mip)).x;
                Assert.That(seen, Is.LessThanOrEqualTo(last + 0.01f), $"mip {mip}");
                last = seen;
            }
            Assert.That(last, Is.InRange(0.5f, 0.8f), "nearly half of the sky is dark");
            Assert.That(Seen(Sample(above, 4)).x, Is.InRange(0.6f, 0.95f), "more than texels alone would do");
            Assert.That(Seen(Sample(Vector3.up, 6)).x, Is.GreaterThan(0.8f));
            Assert.That(Seen(Sample(Vector3.forward, 4)).x, Is.EqualTo(0.5f).Within(0.06f), "on the edge");
        }

        [Test]
        public void Without_a_sky_nothing_is_reflected() => Assert.That(Seen(Sample(Vector3.up)).x, Is.Zero);

        [Test]
        public void The_intensity_comes_with_the_decoding()
        {
            RenderSettings.skybox = SkyOf("0.25");
            RenderSettings.reflectionIntensity = 2;
            Assert.That(Seen($"float4(DecodeHDR({Sample(Vector3.up)}, unity_SpecCube0_HDR), 1)").x, Is.EqualTo(0.5f).Within(1e-3f));
        }

        [Test]
        public void A_texture_of_the_scenes_own_takes_its_place()
        {
            var cube = new Cubemap(2, TextureFormat.RGBAFloat, false) { filterMode = FilterMode.Point };
            for (int face = 0; face < 6; face++)
                cube.SetPixels(new[] { Color.red, Color.red, Color.green, Color.green }, (CubemapFace)face);
            cube.Apply();
            RenderSettings.skybox = SkyOf("0.25");
            (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture) = (DefaultReflectionMode.Custom, cube);
            Vector4 top = Seen(Sample(new Vector3(0, 0.7f, 1))), bottom = Seen(Sample(new Vector3(0, -0.7f, 1)));
            Assert.That((top.x, top.y), Is.EqualTo((1f, 0f)), "the first row of a face is its top");
            Assert.That((bottom.x, bottom.y), Is.EqualTo((0f, 1f)));
            Object.DestroyImmediate(cube);
        }

        [Test]
        public void It_stays_as_it_was_until_the_environment_is_updated()
        {
            Material sky = RenderSettings.skybox = SkyOf("0.25");
            Assert.That(Seen(Sample(Vector3.up)).x, Is.EqualTo(0.25f).Within(1e-3f));
            sky.SetVector("_Tint", Vector4.one * 2);
            Assert.That(Seen(Sample(Vector3.up)).x, Is.EqualTo(0.25f).Within(1e-3f));
            DynamicGI.UpdateEnvironment();
            Assert.That(Seen(Sample(Vector3.up)).x, Is.EqualTo(0.5f).Within(1e-3f));
        }

        [Test]
        public void A_command_buffer_does_not_get_it_for_free()
        {
            RenderSettings.skybox = SkyOf("40");
            using var commands = new CommandBuffer();
            commands.Blit(null, target, new Material(ShaderOf(Effect($"float4 frag(v2f_img i) : SV_Target {{ return {Sample(Vector3.up)}; }}"))));
            Camera.allCameras[0].AddCommandBuffer(CameraEvent.AfterForwardAlpha, commands);
            Frame();
            Assert.That(Read(target)[0].x, Is.LessThan(1));
        }

        [Test]
        public void A_smooth_metal_mirrors_the_sky()
        {
            RenderSettings.skybox = SkyOf("d.z < 0 ? float3(0.5, 0, 0) : float3(0, 0.5, 0)");
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            var metal = new Material(Shader.Find("Standard"));
            metal.SetFloat("_Metallic", 1);
            metal.SetFloat("_Glossiness", 1);
            quad.GetComponent<MeshRenderer>().sharedMaterial = metal;
            Frame();
            Vector4 seen = Read(target)[8 * 16 + 8];
            Assert.That(seen.x, Is.EqualTo(0.5f).Within(0.02f), "what is behind the camera");
            Assert.That(seen.y, Is.LessThan(0.02f));
        }

        // The quad looks towards -z; tilted by 90 degrees, up.
        [TestCase(0, 0.5f)]
        [TestCase(90, 0.83333f)]
        [TestCase(-90, 0.16667f)]
        public void Surfaces_are_lit_by_the_half_of_the_sky_that_they_see(float tilt, float expected)
        {
            RenderSettings.ambientMode = AmbientMode.Skybox;
            RenderSettings.skybox = SkyOf("float3(0.5 + 0.5 * d.y, 0, 0)");
            // A white Lambert surface reflects 0.5 + 0.5 y as 0.5 + 0.5 y 2 / 3.
            Vector4 harmonics = Seen(FormattableString.Invariant(
                $"float4(ShadeSH9(float4(0, {Mathf.Sin(tilt * Mathf.Deg2Rad)}, {-Mathf.Cos(tilt * Mathf.Deg2Rad)}, 1)), 1)"));
            Assert.That(harmonics.x, Is.EqualTo(expected).Within(2e-3f));
            Assert.That(harmonics.y, Is.Zero.Within(1e-4f));
        }

        [TestCase("0.3 + 0.5 * d.x * d.y", 0.6f, 0.8f, 0)]
        [TestCase("0.3 + 0.5 * d.y * d.z", 0, 0.6f, 0.8f)]
        [TestCase("0.3 + 0.5 * d.z * d.x", 0.6f, 0, 0.8f)]
        [TestCase("0.3 + 0.25 * (3 * d.z * d.z - 1)", 0.6f, 0, 0.8f)]
        [TestCase("0.3 + 0.25 * (d.x * d.x - d.y * d.y)", 0.6f, 0.8f, 0)]
        public void The_second_band_is_there_too(string sky, float x, float y, float z)
        {
            RenderSettings.ambientMode = AmbientMode.Skybox;
            RenderSettings.ambientIntensity = 2;
            RenderSettings.skybox = SkyOf(sky);
            string towards = FormattableString.Invariant($"float3({x}, {y}, {z})");
            Vector4 both = Seen($"float4(ShadeSH9(float4({towards}, 1)), 1)");
            // A quarter of the band is left of it.
            float band = sky.Contains("3 *") ? 0.25f * (3 * z * z - 1) : sky.Contains("d.x * d.x") ? 0.25f * (x * x - y * y)
                : 0.5f * (x * y + y * z + z * x);
            Assert.That(both.x, Is.EqualTo(2 * (0.3f + band / 4)).Within(4e-3f));
        }

        [Test]
        public void Without_a_sky_its_color_is_the_light()
        {
            RenderSettings.ambientMode = AmbientMode.Skybox;
            RenderSettings.ambientSkyColor = Color.red;
            Assert.That((Vector3)Seen("float4(ShadeSH9(float4(0, 1, 0, 1)), 1)"), Is.EqualTo(new Vector3(1, 0, 0)));
        }
    }
}
