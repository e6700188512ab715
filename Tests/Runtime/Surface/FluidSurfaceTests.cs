using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using static Rill.Tests.WaterScene;

namespace Rill.Tests
{
    /// <summary>The surface as cameras show it.</summary>
    public class FluidSurfaceTests
    {
        const float Depth = WaterScene.Depth;
        const int Pixels = 64;

        WaterScene scene;
        FluidSimulation fluid;
        FluidSurface surface;
        Camera camera;

        [SetUp]
        public void Make()
        {
            scene = new WaterScene(Pixels);
            (fluid, surface, camera) = (scene.Fluid, scene.Surface, scene.Camera);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        [UnityTest, Category("LongRun")]
        public IEnumerator Light_is_absorbed_on_its_way_through([Values(true, false)] bool refracts)
        {
            surface.Refraction = refracts;
            fluid.gameObject.SetActive(true);
            yield return Frames(20);
            Color color = scene.Mean();
            const float transmitted = 0.9596f;      // Fresnel's equations at normal incidence on water, at both of its faces
            float3 seen = new float3(color.r, color.g, color.b), expected = transmitted * math.pow(Left, Depth / 0.5f);
            TestContext.Out.WriteLine($"seen {seen}, Beer and Lambert {expected}");
            if (refracts)
                Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(0.03f));
            else
                Assert.That(math.csum(seen) / 3f, Is.EqualTo(math.csum(expected) / 3f).Within(0.03f * math.csum(expected) / 3f),
                "one coverage for all colors");
        }

        [UnityTest]
        public IEnumerator What_stands_behind_is_seen_where_it_stands()
        {
            SurfaceLook clear = surface.Look;
            clear.colorAtDepth = Color.white;
            surface.Look = clear;
            camera.transform.rotation = Quaternion.identity;
            camera.orthographicSize = 2.6f;
            camera.transform.position = new Vector3(0f, 0f, -3f);
            GameObject dark = scene.NewUnlit(PrimitiveType.Quad, 0f);
            dark.transform.position = new Vector3(-1.5f, 0f, 2f);
            dark.transform.localScale = new Vector3(3f, 10f, 1f);
            fluid.gameObject.SetActive(true);
            yield return Frames(4);
            // The water is a meter wide in a picture of 5.2 m and reaches from half a meter below its center to 0.1 m above.
            float left = scene.Mean(28, 30, 27, 31).g, right = scene.Mean(34, 36, 27, 31).g;
            Assert.That(left, Is.LessThan(0.1f));
            Assert.That(right, Is.GreaterThan(0.9f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator The_floor_is_seen_as_far_aside_as_Snell_bends_it()
        {
            SurfaceLook clear = surface.Look;
            clear.colorAtDepth = Color.white;
            surface.Look = clear;
            // From 45 degrees. The edge of a black floor, which is looked for around a point of the water where straight and bent rays
            // reach the floor.
            const float entry = -0.25f;
            float slope = Mathf.Tan(Mathf.Asin(Mathf.Sqrt(0.5f) / clear.refractionIndex)), edge = entry + Depth * slope;
            camera.transform.position = new Vector3(0f, Depth - 0.5f + 2f, entry - 2f);
            camera.transform.LookAt(new Vector3(0f, Depth - 0.5f, entry));
            GameObject floor = scene.NewUnlit(PrimitiveType.Quad, 0f);
            floor.transform.rotation = Quaternion.LookRotation(Vector3.down);
            floor.transform.position = new Vector3(0f, -0.5f, edge + 2f);
            floor.transform.localScale = new Vector3(4f, 4f, 1f);
            fluid.gameObject.SetActive(true);
            yield return Frames(20);
            const int rows = 7;
            int center = Pixels / 2;
            float white = scene.Mean(24, 40, center - rows - 2, center - rows).g, black = scene.Mean(24, 40, center + rows, center + rows + 2).g;
            float found = (scene.Mean(24, 40, center - rows, center + rows).g - black) / (white - black);
            float pixel = 2f * camera.orthographicSize / Pixels, along = (found - 0.5f) * 2f * rows * pixel * Mathf.Sqrt(2f);       // on the water, m
            TestContext.Out.WriteLine($"{along / (Depth * (1f - slope)):0.000} of the offset too far");
            Assert.That(white - black, Is.GreaterThan(0.8f));
            Assert.That(along, Is.EqualTo(0f).Within(0.03f * Depth * (1f - slope)));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator It_mirrors_as_much_as_Fresnels_equations_say([Values(0f, 50f, 65f)] float degrees)
        {
            surface.Look = Opaque(0f);
            var white = new Cubemap(2, TextureFormat.RGBAHalf, false);
            foreach (CubemapFace face in new[] { CubemapFace.PositiveX, CubemapFace.NegativeX, CubemapFace.PositiveY, CubemapFace.NegativeY,
                CubemapFace.PositiveZ, CubemapFace.NegativeZ })
                white.SetPixels(new[] { Color.white, Color.white, Color.white, Color.white }, face);
            white.Apply();
            surface.Reflection = white;
            surface.ReflectionStrength = 1f;
            camera.backgroundColor = Color.black;
            var surfaceMiddle = new Vector3(0f, Depth - 0.5f, 0f);
            camera.transform.position = surfaceMiddle + Quaternion.Euler(-degrees, 0f, 0f) * (3f * Vector3.up);
            camera.transform.LookAt(surfaceMiddle, Vector3.forward);
            camera.orthographicSize = 0.1f;
            fluid.gameObject.SetActive(true);
            yield return Frames(20);
            float seen = scene.Mean().g, expected = Fresnel(degrees);
            surface.Reflection = null;
            Object.DestroyImmediate(white);
            TestContext.Out.WriteLine($"seen {seen:0.00000}, Fresnel {expected:0.00000}");
            Assert.That(seen, Is.EqualTo(expected).Within(0.03f * expected));
        }

        // Red tells the mip, an eighth for each, and green how much is mirrored. The levels are Unity's: 6 r (1.7 - 0.7 r).
        [UnityTest, Category("LongRun")]
        public IEnumerator It_mirrors_the_mip_of_its_roughness()
        {
            var cube = new Cubemap(64, TextureFormat.RGBAHalf, true) { filterMode = FilterMode.Trilinear };
            for (int mip = 0; mip < 7; mip++)
                for (int face = 0; face < 6; face++)
                    cube.SetPixels(Enumerable.Repeat(new Color(mip / 8f, 1f, 0f), 64 * 64 >> 2 * mip).ToArray(), (CubemapFace)face, mip);
            cube.Apply(false);
            surface.Reflection = cube;
            surface.ReflectionStrength = 1f;
            camera.backgroundColor = Color.black;
            camera.orthographicSize = 0.1f;
            fluid.gameObject.SetActive(true);
            yield return Frames(20);
            fluid.Paused = true;
            foreach ((float roughness, float level) in new[] { (0f, 0f), (0.25f, 2.2875f), (0.5f, 4.05f), (0.75f, 5.28750f), (1f, 6f) })
            {
                surface.Look = Opaque(roughness);
                yield return Frames(2);
                Color seen = scene.Mean();
                TestContext.Out.WriteLine($"roughness {roughness}: mip {8f * seen.r / seen.g:0.000}, {seen.g:0.0000} mirrored");
                Assert.That(8f * seen.r / seen.g, Is.EqualTo(level).Within(roughness == 0f ? 1f : 0.1f));
            }
            // Normals that differ within a pixel are as a roughness.
            surface.Look = Opaque(0f);
            yield return Frames(2);
            Color still = scene.Mean();
            fluid.Paused = false;
            fluid.Fill(FluidShape.Sphere(new Vector3(0f, Depth - 0.5f + 0.1f, 0f), 0.08f), 3f * Vector3.down);
            yield return Frames(8);
            Color rippled = scene.Mean();
            TestContext.Out.WriteLine($"mip {8f * still.r / still.g:0.000} of still water, {8f * rippled.r / rippled.g:0.000} of rippled");
            Assert.That(8f * rippled.r / rippled.g, Is.GreaterThan(8f * still.r / still.g + 0.3f));
            surface.Reflection = null;
            Object.DestroyImmediate(cube);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Edges_seen_through_still_water_keep_still()
        {
            surface.Look = SurfaceLook.Water;
            surface.ReflectionStrength = 1f;
            surface.Sun = null;
            camera.transform.position = new Vector3(0f, Depth + 0.5f, -1.2f);
            camera.transform.LookAt(new Vector3(0f, Depth - 0.5f, -0.2f));
            scene.AddFloor(1f);
            // A black plate before white: edges of the highest contrast, which no picture without antialiasing moves by less than a pixel.
            GameObject floor = scene.NewSolid(PrimitiveType.Quad, 0f);
            floor.transform.rotation = Quaternion.LookRotation(Vector3.down) * Quaternion.Euler(0f, 0f, 30f);
            floor.transform.position = new Vector3(0f, -0.5f, 0.175f);
            floor.transform.localScale = new Vector3(0.3f, 0.3f, 1f);
            fluid.gameObject.SetActive(true);
            yield return Frames(350);       // its waves have died by then
            float4[] last = scene.Pixels();
            int version = fluid.Solver.SurfaceVersion;
            var differences = new List<float>();
            for (int frame = 0; frame < 8; frame++)
            {
                yield return Frames(1);
                float4[] next = scene.Pixels();
                for (int i = 0; i < next.Length; i++)
                    differences.Add(255f * math.cmax(math.abs(math.saturate(next[i].xyz) - math.saturate(last[i].xyz))));
                last = next;
            }
            (float rms, float high) = RmsAndHigh(differences);
            TestContext.Out.WriteLine($"{rms:0.000} of 255 rms, {high:0.00} at the 99.9th percentile");
            Assert.That(fluid.Solver.SurfaceVersion, Is.EqualTo(version + 8), "awake");
            Assert.That(last[Pixels * Pixels / 2 + Pixels / 2].y, Is.LessThan(0.3f), "the floor is seen in the center");
            Assert.That(last[Pixels * 3 + 3].y, Is.GreaterThan(0.4f), "and the white beside it in the corner");
            Assert.That(rms, Is.LessThanOrEqualTo(3f), "single pixels at an edge change between black and white");
            Assert.That(high, Is.LessThanOrEqualTo(6.5f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Still_water_keeps_its_look_while_the_camera_moves()
        {
            surface.Look = SurfaceLook.Water;
            surface.Sun = null;
            fluid.gameObject.SetActive(true);
            scene.AddFloor(1f);
            // Straight down on a plain white ground, so that the picture is a matter of depth and slope alone. By a pixel a frame: the
            // last picture is the next one, shifted.
            yield return Frames(150);
            float4[] last = scene.Pixels();
            var differences = new List<float>();
            for (int frame = 0; frame < 8; frame++)
            {
                camera.transform.position += 2f * camera.orthographicSize / Pixels * Vector3.right;
                yield return Frames(1);
                float4[] next = scene.Pixels();
                for (int y = 0; y < Pixels; y++)
                    for (int x = 1; x < Pixels; x++)
                        differences.Add(255f * math.cmax(math.abs(math.saturate(next[y * Pixels + x - 1].xyz)
                            - math.saturate(last[y * Pixels + x].xyz))));
                last = next;
            }
            (float rms, float high) = RmsAndHigh(differences);
            TestContext.Out.WriteLine($"{rms:0.000} of 255 rms, {high:0.00} at the 99.9th percentile");
            Assert.That(last[0].x, Is.LessThan(0.9f), "water everywhere");
            Assert.That(rms, Is.LessThan(0.05f));
            Assert.That(high, Is.LessThan(0.25f));
        }

        [UnityTest]
        public IEnumerator Glass_before_the_water_tints_it_and_glass_behind_it_vanishes_where_it_refracts([Values(3000, 2900)] int queue,
            [Values(true, false)] bool refracts)
        {
            surface.Refraction = refracts;
            fluid.gameObject.SetActive(true);
            yield return Frames(10);
            fluid.Paused = true;
            GameObject pane = GameObject.CreatePrimitive(PrimitiveType.Quad);
            pane.transform.rotation = Quaternion.LookRotation(Vector3.down);
            pane.transform.localScale = new Vector3(4f, 4f, 1f);
            var glass = new Material(Shader.Find("Sprites/Default")) { color = new Color(1f, 0f, 0f, 0.5f), renderQueue = queue };
            pane.GetComponent<MeshRenderer>().sharedMaterial = glass;
            pane.SetActive(false);
            yield return Frames(2);
            float without = scene.Mean().g;
            pane.SetActive(true);
            pane.transform.position = new Vector3(0f, 1f, 0f);
            yield return Frames(2);
            float before = scene.Mean().g;
            pane.transform.position = new Vector3(0f, -0.7f, 0f);
            yield return Frames(2);
            float behind = scene.Mean().g;
            // Steep, through the surface at the picture's center: its upper half is on the right.
            pane.transform.position = new Vector3(0f, Depth - 0.5f, 0f);
            pane.transform.rotation = Quaternion.Euler(0f, 0f, 30f) * Quaternion.LookRotation(Vector3.down);
            yield return Frames(2);
            float left = scene.Mean(8, 24, 16, 48).g, right = scene.Mean(40, 56, 16, 48).g;
            Object.DestroyImmediate(pane);
            Object.DestroyImmediate(glass);
            TestContext.Out.WriteLine(
                $"{without:0.000} without, {before:0.000} before, {behind:0.000} behind, {left:0.000} and {right:0.000} through");
            float tinted = 0.5f * without;
            bool isDrawnAfter = queue > 2950;
            // The water blends over objects that are drawn before it, or refracts them away; wherever they stand.
            Assert.That(before, isDrawnAfter ? Is.EqualTo(tinted).Within(0.02f) : refracts ? Is.EqualTo(without).Within(0.02f)
                : Is.LessThan(0.8f * without));
            Assert.That(behind, isDrawnAfter || refracts ? Is.EqualTo(without).Within(0.02f) : Is.LessThan(0.8f * without));
            if (!isDrawnAfter)
                yield break;
            Assert.That(right, Is.EqualTo(tinted).Within(0.03f), "above the water");
            Assert.That(left, Is.EqualTo(without).Within(0.03f), "below");
        }

        [UnityTest]
        public IEnumerator The_scene_is_copied_only_where_water_refracts([Values(true, false)] bool refracts)
        {
            surface.Refraction = refracts;
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            // not those of other tests that wait to be collected
            RenderTexture[] there = System.Array.FindAll(Resources.FindObjectsOfTypeAll<RenderTexture>(), texture => texture.IsCreated());
            Assert.That(there, refracts ? Has.Some.Property("name").EqualTo("Rill.Surface.SceneColor")
                : Has.None.Property("name").EqualTo("Rill.Surface.SceneColor"));
        }

        [UnityTest]
        public IEnumerator Out_of_sight_its_surface_is_not_found_and_comes_back_at_once([Values(false, true)] bool castsShadows)
        {
            surface.CastShadows = castsShadows ? ShadowCastingMode.On : ShadowCastingMode.Off;
            Light sun = Sun(new Vector3(-0.5f, -1f, 0f));
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            Vector3 above = camera.transform.position;
            camera.transform.position = above + 20f * Vector3.right;
            yield return Frames(2);
            int version = fluid.Solver.SurfaceVersion;
            yield return Frames(3);
            Assert.That(fluid.Solver.SurfaceVersion, Is.EqualTo(version), "though the water moves");
            camera.transform.position = above;
            yield return Frames(1);
            Assert.That(fluid.Solver.SurfaceVersion, Is.EqualTo(version + 1));
            Assert.That(scene.Mean().g, Is.LessThan(0.6f), "in the first frame that shows it");
            Object.Destroy(sun.gameObject);
        }

        [UnityTest]
        public IEnumerator A_shadow_that_is_seen_keeps_the_surface_of_water_that_is_not()
        {
            surface.CastShadows = ShadowCastingMode.On;
            Light sun = Sun(Vector3.right);
            camera.transform.position += 5f * Vector3.right;
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            int version = fluid.Solver.SurfaceVersion;
            yield return Frames(3);
            Assert.That(fluid.Solver.SurfaceVersion, Is.EqualTo(version + 3));
            sun.transform.rotation = Quaternion.LookRotation(Vector3.left);
            yield return Frames(1);
            version = fluid.Solver.SurfaceVersion;
            yield return Frames(3);
            Assert.That(fluid.Solver.SurfaceVersion, Is.EqualTo(version), "it falls away from the camera");
            Object.Destroy(sun.gameObject);
        }

        // That a surface knows: another light's shadow may fall anywhere.
        Light Sun(Vector3 direction)
        {
            var sun = new GameObject("Sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.LookRotation(direction);
            surface.Sun = sun;
            return sun;
        }

        // Half of it under a roof, whose light comes from straight above. The floor under it is what Unity draws shadows for.
        [UnityTest]
        public IEnumerator The_shadow_of_the_main_light_falls_on_it()
        {
            Light sun = new GameObject("Sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            sun.shadows = LightShadows.Hard;
            sun.shadowStrength = 0.75f;
            Light before = RenderSettings.sun;
            RenderSettings.sun = sun;
            AmbientMode mode = RenderSettings.ambientMode;
            Color sky = RenderSettings.ambientSkyColor;
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (AmbientMode.Flat, Color.black);
            GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Plane), roof = GameObject.CreatePrimitive(PrimitiveType.Cube);
            floor.transform.position = new Vector3(0f, -0.6f, 0f);
            roof.transform.position = new Vector3(-1f, 3.5f, 0f);      // behind the camera
            roof.transform.localScale = new Vector3(2f, 0.1f, 4f);
            SurfaceLook milk = SurfaceLook.Of(SurfacePreset.Milk);
            milk.roughness = 1f;
            surface.Look = milk;
            ShadowResolution resolution = QualitySettings.shadowResolution;
            QualitySettings.shadowResolution = ShadowResolution.Low;
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            float shaded = scene.Mean(8, 24, 8, 56).g, lit = scene.Mean(40, 56, 8, 56).g;
            // If nothing casts, the pipeline draws no map: the last one must not be taken for it.
            roof.SetActive(false);
            floor.GetComponent<MeshRenderer>().shadowCastingMode = surface.CastShadows = ShadowCastingMode.Off;
            yield return Frames(2);
            float nothingCasts = scene.Mean(8, 24, 8, 56).g;
            roof.SetActive(true);
            surface.ReceiveShadows = false;
            yield return Frames(2);
            float receivesNone = scene.Mean(8, 24, 8, 56).g;
            surface.ReceiveShadows = true;
            // Its shadow is no longer drawn.
            sun.shadows = LightShadows.None;
            yield return Frames(2);
            float castsNone = scene.Mean(8, 24, 8, 56).g;
            int buffers = sun.commandBufferCount;
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor, RenderSettings.sun) = (mode, sky, before);
            QualitySettings.shadowResolution = resolution;
            foreach (Object one in new Object[] { floor, roof, sun.gameObject })
                Object.Destroy(one);
            TestContext.Out.WriteLine(
                $"in the light {lit:F3}, in the shade {shaded:F3}, receiving none {receivesNone:F3}, without shadows {castsNone:F3}");
            Assert.That(shaded / lit, Is.EqualTo(0.25f).Within(0.02f), "three quarters of the light are gone");
            Assert.That(nothingCasts, Is.EqualTo(lit).Within(0.02f * lit));
            Assert.That(receivesNone, Is.EqualTo(lit).Within(0.02f * lit));
            Assert.That(castsNone, Is.EqualTo(lit).Within(0.02f * lit));
            Assert.That(buffers, Is.Zero, "the light is as it was");
        }

        [UnityTest]
        public IEnumerator Off_it_leaves_nothing_behind()
        {
            fluid.gameObject.SetActive(true);
            yield return Frames(4);
            Assert.That(Textures(), Is.GreaterThan(0));
            surface.enabled = false;
            yield return Frames(40);
            Assert.That(Textures(), Is.Zero);
            Assert.That(camera.commandBufferCount, Is.Zero);
            Assert.That(fluid.Solver.Surface, Is.Null, "nor does the solver look for it");
            Assert.That(scene.Mean(), Is.EqualTo(Color.white));
        }

        [UnityTest]
        public IEnumerator Its_shadow_falls_on_nothing_that_only_looks()
        {
            surface.CastShadows = ShadowCastingMode.On;
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            camera.depthTextureMode |= DepthTextureMode.Depth;
            yield return Frames(2);
            Assert.That(scene.Mean().g, Is.LessThan(0.6f), "the water in the scene's depth would have no thickness");
        }

        [Test]
        public void A_look_that_cannot_be_is_brought_back_with_a_warning()
        {
            SurfaceLook look = SurfaceLook.Water;
            look.refractionIndex = 5f;
            look.colorDepth = float.NaN;
            LogAssert.Expect(LogType.Warning, new Regex("FluidSurface 'Fluid'.*color depth.*refraction index"));
            surface.Look = look;
            Assert.That(surface.Look.refractionIndex, Is.EqualTo(2f));
            Assert.That(surface.Look.colorDepth, Is.EqualTo(1f));
            Assert.That(surface.Preset, Is.EqualTo(SurfacePreset.Custom));
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Every_preset_is_a_look_that_can_be([Values] SurfacePreset preset)
        {
            SurfaceLook look = SurfaceLook.Of(preset);
            look.Validate(out string problem);
            Assert.That(problem, Is.Null);
            Assert.That(look.Reflectance, Is.InRange(0.02f, 0.05f));
        }

        // Look of which nothing is seen but what its surface mirrors.
        static SurfaceLook Opaque(float roughness)
        {
            SurfaceLook look = Absorbing(1e-4f, 0.02f);
            look.roughness = roughness;
            return look;
        }

        // Reflectance of water, without polarization.
        static float Fresnel(float degrees)
        {
            float cosine = Mathf.Cos(degrees * Mathf.Deg2Rad), within = Mathf.Sqrt(1f - (1f - cosine * cosine) / (1.333f * 1.333f));
            float across = (cosine - 1.333f * within) / (cosine + 1.333f * within), along = (1.333f * cosine - within) / (1.333f * cosine + within);
            return 0.5f * (across * across + along * along);
        }

        // high: the 99.9th percentile.
        static (float rms, float high) RmsAndHigh(List<float> differences)
        {
            differences.Sort();
            double squares = 0.0;
            foreach (float difference in differences)
                squares += difference * difference;
            return ((float)System.Math.Sqrt(squares / differences.Count), differences[(int)(0.999f * differences.Count)]);
        }

        static int Textures()
        {
            int count = 0;
            foreach (RenderTexture texture in Resources.FindObjectsOfTypeAll<RenderTexture>())
                count += texture.name.StartsWith("Rill.") && texture.IsCreated() ? 1 : 0;
            return count;
        }
    }
}
