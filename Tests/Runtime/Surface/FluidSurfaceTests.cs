using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The surface as cameras show it.</summary>
    public class FluidSurfaceTests
    {
        const float Spacing = 0.05f, Depth = 0.6f;
        const int Pixels = 64;
        static readonly Vector3 Box = new Vector3(1f, 1f, 1f);

        FluidSimulation fluid;
        FluidSurface surface;
        Camera camera;
        RenderTexture target;

        [SetUp]
        public void Make()
        {
            target = new RenderTexture(Pixels, Pixels, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            camera = Look(new Vector3(0f, 3f, 0f), target);

            var gameObject = new GameObject("Fluid");
            gameObject.SetActive(false);
            fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(Box, Spacing, 8000);
            fluid.StatisticsInterval = 0;
            var volume = new GameObject("Water").AddComponent<FluidVolume>();
            volume.transform.SetParent(gameObject.transform, false);
            volume.transform.localPosition = new Vector3(0f, 0.5f * (Depth - Box.y), 0f);
            volume.Size = new Vector3(Box.x, Depth, Box.z);
            surface = gameObject.AddComponent<FluidSurface>();
            surface.ReflectionStrength = 0f;
            SurfaceLook look = SurfaceLook.Water;
            look.scatteringDepth = 0f;
            look.colorAtDepth = Dark;
            look.colorDepth = 0.5f;
            surface.Look = look;
        }

        // The colour of a field is in sRGB; absorption is linear in what the project calculates in.
        static Color Dark => QualitySettings.activeColorSpace == ColorSpace.Linear ? new Color(0.2f, 0.5f, 0.8f).gamma : new Color(0.2f, 0.5f, 0.8f);

        static Camera Look(Vector3 from, RenderTexture target)
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = from;
            camera.transform.LookAt(Vector3.zero, from.y > 1f ? Vector3.forward : Vector3.up);
            camera.orthographic = true;
            camera.orthographicSize = 0.3f;
            camera.farClipPlane = 10f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.white;
            camera.allowHDR = true;
            camera.targetTexture = target;
            return camera;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Object.Destroy(fluid.gameObject);
            foreach (Camera one in Camera.allCameras)
                Object.Destroy(one.gameObject);
            yield return null;
            target.Release();
        }

        [UnityTest]
        public IEnumerator Light_is_absorbed_on_its_way_through([Values(true, false)] bool refracts)
        {
            surface.Refraction = refracts;
            fluid.gameObject.SetActive(true);
            yield return Frames(20);
            Color color = Mean(target);
            float transmitted = 1f - 0.0204f;       // Fresnel's equations at normal incidence on water
            float3 seen = new float3(color.r, color.g, color.b), expected = transmitted * math.pow(new float3(0.2f, 0.5f, 0.8f), Depth / 0.5f);
            TestContext.Out.WriteLine($"seen {seen}, Beer and Lambert {expected}");
            if (refracts)
                Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(0.03f));
            else
                Assert.That(math.csum(seen) / 3f, Is.EqualTo(math.csum(expected) / 3f).Within(0.03f * math.csum(expected) / 3f), "one coverage for all colours");
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
            GameObject dark = GameObject.CreatePrimitive(PrimitiveType.Quad);
            dark.transform.position = new Vector3(-1.5f, 0f, 2f);
            dark.transform.localScale = new Vector3(3f, 10f, 1f);
            var material = new Material(Shader.Find("Unlit/Color")) { color = Color.black };
            dark.GetComponent<MeshRenderer>().sharedMaterial = material;
            fluid.gameObject.SetActive(true);
            yield return Frames(4);
            // The water is a metre wide in a picture of 5.2 m and reaches from half a metre below its middle to 0.1 m above.
            float left = Mean(target, 28, 30, 27, 31).g, right = Mean(target, 34, 36, 27, 31).g;
            Object.DestroyImmediate(dark);
            Object.DestroyImmediate(material);
            Assert.That(left, Is.LessThan(0.1f));
            Assert.That(right, Is.GreaterThan(0.9f));
        }

        [UnityTest]
        public IEnumerator A_camera_that_leaves_out_its_layer_does_not_see_it()
        {
            fluid.gameObject.SetActive(true);
            camera.cullingMask = ~(1 << fluid.gameObject.layer);
            yield return Frames(4);
            Assert.That(Mean(target), Is.EqualTo(Color.white));
            Assert.That(Textures(), Is.Zero, "nothing is made for it");
            camera.cullingMask = ~0;
            yield return Frames(4);
            Assert.That(Mean(target).r, Is.LessThan(0.5f));
        }

        [UnityTest]
        public IEnumerator Two_cameras_see_it_each_from_its_own_side()
        {
            var other = new RenderTexture(Pixels, Pixels, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            Camera aside = Look(new Vector3(0f, -0.2f, -3f), other);
            fluid.gameObject.SetActive(true);
            yield return Frames(20);
            Color fromAbove = Mean(target), fromTheSide = Mean(other);
            Object.DestroyImmediate(aside.gameObject);
            other.Release();
            // 0.6 m from above; a metre from the side, where it reaches up to the middle of the picture and beyond.
            Assert.That(fromAbove.g, Is.EqualTo(0.98f * Mathf.Pow(0.5f, 1.2f)).Within(0.02f));
            Assert.That(fromTheSide.g, Is.LessThan(fromAbove.g));
        }

        [UnityTest]
        public IEnumerator What_has_not_changed_is_not_drawn_again()
        {
            fluid.gameObject.SetActive(true);
            yield return Frames(4);
            int whole = Recorded();
            fluid.Paused = true;
            yield return Frames(3);
            int still = Recorded();
            camera.transform.position += Vector3.right * 0.01f;
            yield return Frames(1);
            int moved = Recorded();
            yield return Frames(1);
            Assert.That(still, Is.LessThan(0.7f * whole), "thickness alone, since the scene may move");
            Assert.That(moved, Is.EqualTo(whole));
            Assert.That(Recorded(), Is.EqualTo(still));
        }

        [UnityTest]
        public IEnumerator The_scene_is_copied_only_where_water_refracts([Values(true, false)] bool refracts)
        {
            surface.Refraction = refracts;
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            RenderTexture[] there = System.Array.FindAll(Resources.FindObjectsOfTypeAll<RenderTexture>(), texture => texture.IsCreated());      // not those of other tests that wait to be collected
            Assert.That(there, refracts ? Has.Some.Property("name").EqualTo("Rill.Surface.SceneColor") : Has.None.Property("name").EqualTo("Rill.Surface.SceneColor"));
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
            Assert.That(Mean(target).g, Is.LessThan(0.6f), "in the first frame that shows it");
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
            Assert.That(fluid.Solver.SurfaceVersion, Is.EqualTo(version), "it falls the other way");
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
            Assert.That(Mean(target), Is.EqualTo(Color.white));
        }

        [UnityTest]
        public IEnumerator Its_shadow_falls_on_nothing_that_only_looks()
        {
            surface.CastShadows = ShadowCastingMode.On;
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            camera.depthTextureMode |= DepthTextureMode.Depth;
            yield return Frames(2);
            Assert.That(Mean(target).g, Is.LessThan(0.6f), "the water in the scene's depth would have no thickness");
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
        }

        [Test]
        public void Every_preset_is_a_look_that_can_be([Values] SurfacePreset preset)
        {
            SurfaceLook look = SurfaceLook.Of(preset);
            look.Validate(out string problem);
            Assert.That(problem, Is.Null);
            Assert.That(look.Reflectance, Is.InRange(0.02f, 0.05f));
        }

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }

        // Bytes of the camera's command buffer.
        int Recorded()
        {
            CommandBuffer[] buffers = camera.GetCommandBuffers(CameraEvent.BeforeForwardAlpha);
            return buffers.Length == 0 ? 0 : buffers[0].sizeInBytes;
        }

        static int Textures()
        {
            int count = 0;
            foreach (RenderTexture texture in Resources.FindObjectsOfTypeAll<RenderTexture>())
                count += texture.name.StartsWith("Rill.Surface") && texture.IsCreated() ? 1 : 0;
            return count;
        }

        // Of the middle of the picture.
        static Color Mean(RenderTexture texture) => Mean(texture, Pixels / 4, 3 * Pixels / 4, Pixels / 4, 3 * Pixels / 4);

        static Color Mean(RenderTexture texture, int left, int right, int bottom, int top)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture);
            request.WaitForCompletion();
            var pixels = request.GetData<float4>();
            float4 sum = 0f;
            for (int y = bottom; y < top; y++)
                for (int x = left; x < right; x++)
                    sum += pixels[y * Pixels + x];
            sum /= (right - left) * (top - bottom);
            return new Color(sum.x, sum.y, sum.z, 1f);
        }
    }
}
