using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>The main light's shadow as URP hands it to shaders: a map with its matrices and keywords, of one sphere over a floor.</summary>
    public class UrpShadowTests : RenderPassFixture
    {
        static readonly Vector3 Below = Vector3.zero, Beside = new Vector3(0.6f, 0, 0);

        RenderTexture map;
        Matrix4x4 view, projection, toShadow;
        Material material;

        [SetUp]
        public void DrawMap()
        {
            // From above, 8 m across, 10 m deep; the pass draws as from any view.
            view = Matrix4x4.Scale(new Vector3(1, 1, -1)) * Matrix4x4.TRS(new Vector3(0, 5, 0), Quaternion.Euler(90, 0, 0), Vector3.one).inverse;
            projection = Matrix4x4.Ortho(-4, 4, -4, 4, 0, 10);
            map = new RenderTexture(256, 256, GraphicsFormat.None, GraphicsFormat.D32_SFloat);
            DrawSphere(new Vector4(-0.02f, -0.02f, 0, 0));
            toShadow = Matrix4x4.Translate(new Vector3(0.5f, 0.5f, 0)) * Matrix4x4.Scale(new Vector3(0.5f, 0.5f, 1))
                * GL.GetGPUProjectionMatrix(projection, false) * view;

            Shader.SetGlobalTexture("_MainLightShadowmapTexture", map, RenderTextureSubElement.Depth);
            Shader.SetGlobalVector("_MainLightPosition", new Vector4(0, 1, 0, 0));
            Shader.SetGlobalVector("_MainLightColor", Vector4.one);
            SetCascades(0, at => at == 0 ? toShadow : Matrix4x4.zero);
            SetShadow(strength: 1, soft: false, fade: 0);
            SetOffsets(new Vector2[4]);
            material = MaterialOf("Solid.shader", "UniversalPipeline");
        }

        void DrawSphere(Vector4 bias)
        {
            Material spheres = MaterialOf("Particles.shader", "UniversalPipeline");
            Shader.SetGlobalVector("_ShadowBias", bias);
            using var cmd = new CommandBuffer();
            cmd.SetRenderTarget(map);
            cmd.ClearRenderTarget(true, false, Color.clear);
            cmd.SetViewProjectionMatrices(view, projection);
            cmd.DrawProcedural(Matrix4x4.identity, spheres, spheres.FindPass("ShadowCaster"), MeshTopology.Triangles, 6, 2, block);
            Graphics.ExecuteCommandBuffer(cmd);
        }

        [TearDown]
        public void ReleaseMap() => map.Release();

        [Test]
        public void Urps_shadow_map_holds_the_sphere_moved_away_from_the_light_by_the_bias()
        {
            const float alongLight = 0.1f, alongNormal = 0.2f;      // m
            DrawSphere(new Vector4(-alongLight, -alongNormal, 0, 0));
            var request = AsyncGPUReadback.Request(map);
            request.WaitForCompletion();
            float[] depth = request.GetData<float>().ToArray();
            int hits = 0;
            for (int y = 0; y < 256; y++)
                for (int x = 0; x < 256; x++)
                {
                    // squared, m
                    float across = ((x + 0.5f) * (x + 0.5f) - 256 * (x + 0.5f) + (y + 0.5f) * (y + 0.5f) - 256 * (y + 0.5f) + 2 * 128 * 128)
                        / (32 * 32);
                    if (across > 0.9f * Radius * Radius)
                        continue;
                    hits++;
                    float facing = Mathf.Sqrt(1 - across / (Radius * Radius));
                    float height = Center.y + Radius * facing - alongLight - alongNormal * (1 - facing) * facing;
                    Assert.That(depth[y * 256 + x], Is.EqualTo(1 - (5 - height) / 10).Within(1e-4f), $"pixel {x}, {y}");
                }
            Assert.That(hits, Is.GreaterThan(500));
        }

        [Test]
        public void Urps_shadow_map_shades_the_floor_by_either_keyword([Values("_MAIN_LIGHT_SHADOWS", "_MAIN_LIGHT_SHADOWS_CASCADE")] string keyword)
        {
            Vector4[] shaded = DrawFloor(keyword), lit = DrawFloor();
            Assert.That(shaded[Index(Below)].x, Is.LessThan(0.8f * lit[Index(Below)].x), "below");
            Assert.That(shaded[Index(Beside)].x, Is.EqualTo(lit[Index(Beside)].x).Within(1e-3f), "beside");
        }

        [Test]
        public void Each_cascade_has_its_own_matrix_within_its_sphere([Values(0, 1, 2, 3)] int cascade)
        {
            float lit = DrawFloor()[Index(Below)].x;
            SetCascades(cascade, at => at == cascade ? toShadow : Matrix4x4.zero);
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS_CASCADE")[Index(Below)].x, Is.LessThan(0.8f * lit));
            SetCascades(cascade, at => at != cascade ? toShadow : Matrix4x4.zero);
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS_CASCADE")[Index(Below)].x, Is.EqualTo(lit).Within(1e-3f), "no other cascade's");
        }

        [Test]
        public void Beyond_the_last_cascade_the_floor_is_lit()
        {
            SetCascades(4, at => at < 4 ? toShadow : Matrix4x4.zero);
            float lit = DrawFloor()[Index(Below)].x;
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS_CASCADE")[Index(Below)].x, Is.EqualTo(lit).Within(1e-3f));
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS")[Index(Below)].x, Is.LessThan(0.8f * lit), "without cascades the spheres are not asked");
        }

        [Test]
        public void A_soft_shadow_is_the_mean_of_four_places([Values(0, 1, 2, 3)] int aside)
        {
            float lit = DrawFloor()[Index(Below)].x, dark = DrawFloor("_MAIN_LIGHT_SHADOWS")[Index(Below)].x;
            var offsets = new Vector2[4];
            offsets[aside] = new Vector2(0.125f, 0);        // 1 m: in the light
            SetOffsets(offsets);
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS")[Index(Below)].x, Is.EqualTo(dark).Within(1e-3f), "a hard shadow has no offsets");
            SetShadow(strength: 1, soft: true, fade: 0);
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS")[Index(Below)].x, Is.EqualTo(dark + 0.25f * (lit - dark)).Within(1e-3f));
        }

        [Test]
        public void A_shadow_is_as_strong_as_its_light_says_and_fades_with_distance()
        {
            float lit = DrawFloor()[Index(Below)].x, dark = DrawFloor("_MAIN_LIGHT_SHADOWS")[Index(Below)].x;
            SetShadow(strength: 0.5f, soft: false, fade: 0);
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS")[Index(Below)].x, Is.EqualTo((lit + dark) / 2).Within(1e-3f));
            // Three quarters gone at this distance, and nothing at the eye.
            Shader.SetGlobalVector("_MainLightShadowParams", new Vector4(1, 0, 0.75f / (Below - camera.transform.position).sqrMagnitude, 0));
            Assert.That(DrawFloor("_MAIN_LIGHT_SHADOWS")[Index(Below)].x,
                Is.EqualTo(dark + 0.75f * (lit - dark)).Within(0.03f * (lit - dark)), "within the pixel");
        }

        [Test]
        public void A_shadow_on_the_screen_is_read_at_its_own_pixel()
        {
            camera.nearClipPlane = 4;
            camera.farClipPlane = 16;
            Mesh mesh = floor.GetComponent<MeshFilter>().sharedMesh;
            Vector4[] mask = DrawPass(material, "DepthOnly", mesh);      // a picture that differs from row to row
            var screen = new RenderTexture(target.descriptor);
            Graphics.CopyTexture(target, screen);
            Shader.SetGlobalTexture("_ScreenSpaceShadowmapTexture", Texture2D.blackTexture);
            Vector4[] dark = DrawFloor("_MAIN_LIGHT_SHADOWS_SCREEN");
            Shader.SetGlobalTexture("_ScreenSpaceShadowmapTexture", screen);
            Vector4[] shaded = DrawFloor("_MAIN_LIGHT_SHADOWS_SCREEN"), lit = DrawFloor();
            screen.Release();

            int drawn = 0;
            for (int i = 0; i < lit.Length; i++)
                if (mask[i].x > 0)
                {
                    drawn++;
                    Assert.That(shaded[i].x, Is.EqualTo(dark[i].x + mask[i].x * (lit[i].x - dark[i].x)).Within(1e-4f),
                        $"pixel {i % Width}, {i / Width}");
                }
            Assert.That(drawn, Is.GreaterThan(Width * Height / 2));
            Assert.That(lit[Index(Below)].x, Is.GreaterThan(1.2f * dark[Index(Below)].x), "the mask matters");
        }

        Vector4[] DrawFloor(string keyword = null)
        {
            if (keyword != null)
                Shader.EnableKeyword(keyword);
            try
            {
                return DrawPass(material, "Forward", floor.GetComponent<MeshFilter>().sharedMesh);
            }
            finally
            {
                if (keyword != null)
                    Shader.DisableKeyword(keyword);
            }
        }

        // The floor is in the spheres from this one on: the first that holds a point is the one that counts.
        static void SetCascades(int first, System.Func<int, Matrix4x4> matrixOf)
        {
            var matrices = new Matrix4x4[5];
            for (int i = 0; i < matrices.Length; i++)
                matrices[i] = matrixOf(i);
            Shader.SetGlobalMatrixArray("_MainLightWorldToShadow", matrices);
            for (int i = 0; i < 4; i++)
                Shader.SetGlobalVector("_CascadeShadowSplitSpheres" + i, i < first ? new Vector4(0, 100, 0, 1) : new Vector4(0, 0, 0, 10));
            Shader.SetGlobalVector("_CascadeShadowSplitSphereRadii",
                new Vector4(first > 0 ? 1 : 100, first > 1 ? 1 : 100, first > 2 ? 1 : 100, first > 3 ? 1 : 100));
        }

        static void SetShadow(float strength, bool soft, float fade) =>
            Shader.SetGlobalVector("_MainLightShadowParams", new Vector4(strength, soft ? 1 : 0, 0, fade));

        static void SetOffsets(Vector2[] offsets)
        {
            Shader.SetGlobalVector("_MainLightShadowOffset0", new Vector4(offsets[0].x, offsets[0].y, offsets[1].x, offsets[1].y));
            Shader.SetGlobalVector("_MainLightShadowOffset1", new Vector4(offsets[2].x, offsets[2].y, offsets[3].x, offsets[3].y));
        }
    }
}
