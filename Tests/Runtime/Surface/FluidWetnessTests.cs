using System;
using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Surfaces that a fluid has wetted are darker until they have dried, seen from above: a block of weightless water that lies on the
    /// floor at the left of its box until it is taken away.</summary>
    public class FluidWetnessTests
    {
        const int Size = 64;
        const float Half = 0.6f;            // m, of the picture
        const float Darkening = 0.5f;

        WaterScene scene;
        FluidWetness wetness;
        GameObject floor;
        AmbientMode ambientMode;
        Color ambient;

        [SetUp]
        public void Make()
        {
            (ambientMode, ambient) = (RenderSettings.ambientMode, RenderSettings.ambientLight);
            (RenderSettings.ambientMode, RenderSettings.ambientLight) = (AmbientMode.Flat, Color.white);
            Time.captureDeltaTime = 1f / 60f;
            scene = new WaterScene(Size);
            scene.Camera.orthographicSize = Half;
            scene.Surface.enabled = false;
            scene.Fluid.Gravity = Vector3.zero;
            FluidVolume volume = scene.Root.GetComponentInChildren<FluidVolume>(true);
            volume.transform.localPosition = new Vector3(-0.3f, -0.4f, 0f);
            volume.Size = new Vector3(0.4f, 0.2f, 0.6f);
            floor = AddFloor(-0.5f);
            wetness = scene.Root.AddComponent<FluidWetness>();
            wetness.Darkening = Darkening;
            wetness.Smoothness = 0f;
            wetness.DryingTime = 10000f;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            (RenderSettings.ambientMode, RenderSettings.ambientLight) = (ambientMode, ambient);
            yield return scene.End();
        }

        GameObject AddFloor(float height)
        {
            GameObject plate = scene.Keep(GameObject.CreatePrimitive(PrimitiveType.Quad));
            plate.transform.position = new Vector3(0f, height, 0f);
            plate.transform.rotation = Quaternion.LookRotation(Vector3.down);
            plate.transform.localScale = 4f * Vector3.one;
            return plate;
        }

        // Wets the floor and takes the water away.
        IEnumerator Wet(int frames = 4)
        {
            scene.Root.SetActive(true);
            yield return WaterScene.Frames(frames);
            scene.Fluid.Clear();
            yield return WaterScene.Frames(3);
        }

        // Renders the picture without any wetness.
        IEnumerator Dry(Action<float4[]> got)
        {
            wetness.enabled = false;
            yield return WaterScene.Frames(2);
            got(scene.Pixels());
        }

        static int Pixel(float right, float up = 0f)
            => (int)((up / Half * 0.5f + 0.5f) * Size) * Size + (int)((right / Half * 0.5f + 0.5f) * Size);

        static float FractionOf(float4[] wet, float4[] dry, int pixel) => math.csum(wet[pixel].xyz) / math.csum(dry[pixel].xyz);

        static int Changed(float4[] a, float4[] b)
        {
            int count = 0;
            for (int i = 0; i < a.Length; i++)
                count += math.any(a[i].xyz != b[i].xyz) ? 1 : 0;
            return count;
        }

        [UnityTest]
        public IEnumerator Floor_that_was_covered_is_darker_by_what_is_set_and_the_rest_is_as_it_was_to_the_bit()
        {
            yield return Wet();
            float4[] wet = scene.Pixels(), dry = null;
            yield return Dry(pixels => dry = pixels);
            Assert.That(math.csum(dry[Pixel(-0.3f)].xyz), Is.GreaterThan(0.3f), "it is lit");
            // The block is 0.4 x 0.6 m at the left wall; its outermost particles lie half a spacing within, and wet up to one beyond.
            float worst = 0f;
            int changed = 0;
            for (int i = 0; i < wet.Length; i++)
            {
                float2 at = (new float2(i % Size, i / Size) + 0.5f) / Size * 2f * Half - Half;
                float2 within = 0.5f * new float2(0.4f, 0.6f) - math.abs(at - new float2(-0.3f, 0f));
                float inside = math.cmin(within);
                bool isInBox = math.cmax(math.abs(at)) < 0.5f;
                if (inside > WaterScene.Spacing && isInBox)
                    worst = math.max(worst, math.abs(FractionOf(wet, dry, i) - (1f - Darkening)));
                if (inside < -2f * WaterScene.Spacing)
                    changed += math.any(wet[i].xyz != dry[i].xyz) ? 1 : 0;
            }
            TestContext.Out.WriteLine($"fraction off by {worst:0.00000}, {changed} others changed");
            Assert.That(worst, Is.LessThan(0.001f));
            Assert.That(changed, Is.Zero);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator It_dries_with_its_time_and_not_while_the_fluid_is_paused()
        {
            const float time = 0.4f;
            wetness.DryingTime = time;
            yield return Wet();
            double begun = scene.Fluid.FrameTime;
            float4[] first = scene.Pixels();
            scene.Fluid.Paused = true;
            yield return WaterScene.Frames(5);
            Assert.That(Changed(scene.Pixels(), first), Is.Zero, "paused");
            scene.Fluid.Paused = false;
            yield return WaterScene.Frames(20);
            float4[] second = scene.Pixels(), dry = null;
            double passed = scene.Fluid.FrameTime - begun;
            yield return WaterScene.Frames(150);
            float4[] late = scene.Pixels();
            yield return Dry(pixels => dry = pixels);
            int at = Pixel(-0.3f);
            float before = 1f - FractionOf(first, dry, at), after = 1f - FractionOf(second, dry, at);
            TestContext.Out.WriteLine($"{before:0.0000} and {passed:0.000} s later {after:0.0000}");
            Assert.That(passed, Is.GreaterThan(0.25));
            Assert.That(after / before, Is.EqualTo(math.exp(-passed / time)).Within(0.005f));
            Assert.That(Changed(late, dry), Is.Zero, "after 6 times that it is dry");
        }

        [UnityTest]
        public IEnumerator A_wall_of_the_box_is_wet_on_its_inner_side_alone()
        {
            GameObject wall = scene.Keep(GameObject.CreatePrimitive(PrimitiveType.Cube));
            wall.transform.position = new Vector3(-0.51f, -0.4f, 0f);
            wall.transform.localScale = new Vector3(0.02f, 0.4f, 1f);
            scene.Camera.orthographicSize = 0.3f;
            yield return Wet();
            foreach (float side in new[] { 1f, -1f })
            {
                wetness.enabled = true;
                WaterScene.Look(scene.Camera, new Vector3(side * 2f, 0f, 0f));
                scene.Camera.transform.position += 0.4f * Vector3.down;
                scene.Camera.transform.rotation = Quaternion.LookRotation(-side * Vector3.right);
                yield return WaterScene.Frames(2);
                if (side > 0f)
                    Assert.That(IsWetAtCenter(), Is.True, "inner");
                else
                    Assert.That(IsWetAtCenter(), Is.False, "outer");
            }
        }

        // By turning its darkening off, which keeps where it was wet.
        bool IsWetAtCenter()
        {
            int at = Size / 2 * Size + Size / 2;
            float4 with = scene.Pixels()[at];
            wetness.Darkening = 0f;
            scene.Camera.Render();
            float4 without = scene.Pixels()[at];
            wetness.Darkening = Darkening;
            Assert.That(math.csum(without.xyz), Is.GreaterThan(0.1f));
            return math.csum(with.xyz) < 0.7f * math.csum(without.xyz);
        }

        [UnityTest]
        public IEnumerator Each_camera_sees_it_at_the_same_places_but_not_one_that_does_not_show_the_layer()
        {
            RenderTexture second = scene.NewTarget(Size, Size), third = scene.NewTarget(Size, Size);
            Camera aslant = scene.NewCamera(second, new Vector3(0f, 3f, 0f)), blind = scene.NewCamera(third, new Vector3(0f, 3f, 0f));
            aslant.orthographic = false;
            aslant.fieldOfView = 40f;
            aslant.transform.position = new Vector3(0.5f, 1.2f, -1.5f);
            aslant.transform.LookAt(new Vector3(-0.2f, -0.5f, 0f));
            blind.orthographicSize = Half;
            scene.Root.layer = 4;
            blind.cullingMask &= ~(1 << 4);
            yield return Wet();
            float4[] wet = WaterScene.Pixels(second), unseen = WaterScene.Pixels(third), dry = null, dryAslant, above = scene.Pixels();
            yield return Dry(pixels => dry = pixels);
            dryAslant = WaterScene.Pixels(second);
            Assert.That(Changed(unseen, dry), Is.Zero);
            Assert.That(Changed(above, dry), Is.GreaterThan(100));
            foreach (float right in new[] { -0.4f, -0.25f, 0.1f, 0.3f })
            {
                Vector3 at = aslant.WorldToViewportPoint(new Vector3(right, -0.5f, 0.1f));
                int pixel = (int)(at.y * Size) * Size + (int)(at.x * Size);
                Assert.That(FractionOf(wet, dryAslant, pixel), Is.EqualTo(right < 0f ? 1f - Darkening : 1f).Within(0.002f), $"{right}");
            }
        }

        [UnityTest]
        public IEnumerator A_box_that_is_turned_and_moved_wets_where_it_stands()
        {
            scene.Root.transform.position = new Vector3(0.1f, 0f, -0.05f);
            scene.Root.transform.rotation = Quaternion.Euler(0f, 35f, 0f);
            yield return Wet();
            float4[] wet = scene.Pixels(), dry = null;
            yield return Dry(pixels => dry = pixels);
            foreach (Vector3 inBox in new[] { new Vector3(-0.4f, -0.5f, 0f), new Vector3(-0.3f, -0.5f, 0.2f), new Vector3(0.1f, -0.5f, 0f),
                new Vector3(-0.3f, -0.5f, -0.42f) })
            {
                Vector3 world = scene.Root.transform.TransformPoint(inBox);
                bool isWet = inBox.x < 0f && math.abs(inBox.z) < 0.3f;
                Assert.That(FractionOf(wet, dry, Pixel(world.x, world.z)), Is.EqualTo(isWet ? 1f - Darkening : 1f).Within(0.001f), $"{inBox}");
            }
        }

        [UnityTest]
        public IEnumerator A_box_that_is_put_elsewhere_and_leaves_the_water_leaves_its_wetness_too([Values] bool enabledAgain)
        {
            scene.Root.SetActive(true);
            wetness.enabled = !enabledAgain;
            wetness.enabled = true;
            yield return Wet();
            float4[] before = scene.Pixels(), dry = null;
            var by = new Vector3(0.113f, 0f, -0.071f);      // neither whole spacings
            scene.Fluid.Recenter(scene.Root.transform.position + 0.6f * by);
            yield return null;
            scene.Fluid.Recenter(scene.Root.transform.position + 0.4f * by);
            yield return WaterScene.Frames(2);
            float4[] after = scene.Pixels();
            yield return Dry(pixels => dry = pixels);
            float worst = 0f;
            int wet = 0;
            for (int i = 0; i < before.Length; i++)
            {
                float2 at = (new float2(i % Size, i / Size) + 0.5f) / Size * 2f * Half - Half;
                if (math.any(at < new float2(-0.5f + by.x + 0.03f, -0.47f)) || math.any(at > new float2(0.47f, 0.5f + by.z - 0.03f)))
                    continue;       // in one of the boxes alone, or at its side
                worst = math.max(worst, math.abs(FractionOf(after, dry, i) - FractionOf(before, dry, i)));
                wet += FractionOf(before, dry, i) < 0.6f ? 1 : 0;
            }
            TestContext.Out.WriteLine($"{wet} pixels wet, worst {worst:0.00000}");
            Assert.That(wet, Is.GreaterThan(200));
            Assert.That(worst, Is.LessThan(0.002f));
        }

        [UnityTest]
        public IEnumerator A_fluid_that_restarts_is_dry_at_first()
        {
            scene.Root.GetComponentInChildren<FluidVolume>(true).gameObject.SetActive(false);
            scene.Root.SetActive(true);
            yield return null;
            scene.Fluid.Fill(FluidShape.Box(new Vector3(-0.3f, -0.4f, 0f), new Vector3(0.4f, 0.2f, 0.6f)));
            yield return WaterScene.Frames(20);
            scene.Fluid.Clear();
            yield return WaterScene.Frames(2);
            float4[] wet = scene.Pixels(), dry = null;
            scene.Fluid.Restart();
            yield return WaterScene.Frames(2);
            float4[] restarted = scene.Pixels();
            yield return Dry(pixels => dry = pixels);
            Assert.That(Changed(wet, dry), Is.GreaterThan(100));
            Assert.That(Changed(restarted, dry), Is.Zero);
        }

        [UnityTest]
        public IEnumerator Two_fluids_side_by_side_each_wet_their_own()
        {
            var other = scene.Keep(new GameObject("Other"));
            other.SetActive(false);
            other.transform.position = new Vector3(1f, 0f, 0f);
            var second = other.AddComponent<FluidSimulation>();
            second.Configure(Vector3.one, WaterScene.Spacing, 2000);
            second.Gravity = Vector3.zero;
            var water = new GameObject("Water").AddComponent<FluidVolume>();
            water.transform.SetParent(other.transform, false);
            water.transform.localPosition = new Vector3(-0.3f, -0.4f, 0f);
            water.Size = new Vector3(0.4f, 0.2f, 0.6f);
            var secondWetness = other.AddComponent<FluidWetness>();
            (secondWetness.Darkening, secondWetness.Smoothness, secondWetness.DryingTime) = (0.2f, 0f, 10000f);
            scene.Camera.transform.position += 0.2f * Vector3.right;
            other.SetActive(true);
            yield return Wet();
            second.Clear();
            yield return WaterScene.Frames(2);
            float4[] wet = scene.Pixels(), dry = null;
            secondWetness.enabled = false;
            yield return Dry(pixels => dry = pixels);
            Assert.That(FractionOf(wet, dry, Pixel(-0.3f - 0.2f)), Is.EqualTo(0.5f).Within(0.001f), "the first's");
            Assert.That(FractionOf(wet, dry, Pixel(0.7f - 0.2f)), Is.EqualTo(0.8f).Within(0.001f), "the second's");
            Assert.That(FractionOf(wet, dry, Pixel(0.2f - 0.2f)), Is.EqualTo(1f), "between");
        }

        [UnityTest]
        public IEnumerator Water_that_is_drawn_opaque_is_not_darkened_and_what_is_beside_it_is([Values] bool asMesh)
        {
            Behaviour drawn = asMesh ? AddMesh() : (Behaviour)scene.Root.AddComponent<ParticleRenderer>();
            scene.Root.SetActive(true);
            yield return WaterScene.Frames(4);
            scene.Fluid.RemoveInside(FluidShape.Box(new Vector3(-0.3f, -0.4f, 0.2f), new Vector3(0.6f, 0.4f, 0.4f)));
            scene.Fluid.Paused = true;
            yield return WaterScene.Frames(3);
            scene.Fluid.Paused = false;
            yield return WaterScene.Frames(2);
            scene.Fluid.Paused = true;
            yield return WaterScene.Frames(2);
            float4[] wet = scene.Pixels(), dry = null, floorAlone = null;
            yield return Dry(pixels => dry = pixels);
            drawn.enabled = false;
            yield return WaterScene.Frames(2);
            floorAlone = scene.Pixels();
            wetness.enabled = true;
            yield return WaterScene.Frames(2);
            Assert.That(FractionOf(scene.Pixels(), floorAlone, Pixel(-0.3f, -0.15f)), Is.EqualTo(1f - Darkening).Within(0.001f),
                "the floor under water that is not drawn");
            int particles = 0, darker = 0, wetFloor = 0;
            for (int i = 0; i < wet.Length; i++)
            {
                bool isParticle = math.any(dry[i].xyz != floorAlone[i].xyz), isDarker = math.any(wet[i].xyz != dry[i].xyz);
                particles += isParticle ? 1 : 0;
                darker += isParticle && isDarker ? 1 : 0;
                wetFloor += !isParticle && isDarker ? 1 : 0;
            }
            TestContext.Out.WriteLine($"{darker} of {particles} pixels of water are darker, and {wetFloor} of the floor");
            Assert.That(particles, Is.GreaterThan(200));
            Assert.That(darker, asMesh ? Is.LessThan(particles / 20) : (NUnit.Framework.Constraints.Constraint)Is.Zero, "at the mesh's outline");
            Assert.That(wetFloor, Is.GreaterThan(200));
        }

        [UnityTest]
        public IEnumerator The_film_mirrors_the_sky_by_Fresnel_and_not_under_water([Values(0f, 60f, 75f)] float angle,
            [Values(0f, 0.5f, 1f)] float smoothness)
        {
            var sky = new float3(4f, 2f, 0f);
            Cubemap cube = scene.Keep(new Cubemap(1, TextureFormat.RGBAHalf, false));
            for (int face = 0; face < 6; face++)
                cube.SetPixels(new[] { new Color(sky.x, sky.y, sky.z) }, (CubemapFace)face);
            cube.Apply(false);
            (DefaultReflectionMode mode, Texture custom) = (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture);
            (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture) = (DefaultReflectionMode.Custom, cube);
            wetness.Darkening = 0f;
            wetness.Smoothness = smoothness;
            var at = new Vector3(-0.25f, -0.5f, 0f);
            scene.Camera.transform.position = at + 3f * (Quaternion.AngleAxis(angle, Vector3.forward) * Vector3.up);
            scene.Camera.transform.LookAt(at, Vector3.forward);
            scene.Root.SetActive(true);
            yield return WaterScene.Frames(4);
            int center = Pixel(0f);
            float3 under = scene.Pixels()[center].xyz;
            scene.Fluid.Clear();
            yield return WaterScene.Frames(3);
            float3 wet = scene.Pixels()[center].xyz, dry = 0f;
            yield return Dry(pixels => dry = pixels[center].xyz);
            (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture) = (mode, custom);
            float grazing = math.pow(1f - math.cos(math.radians(angle)), 5f);
            float mirrored = smoothness * (0.02f + math.max(smoothness - 0.02f, 0f) * grazing);
            TestContext.Out.WriteLine($"dry {dry}, wet {wet}, under water {under}, mirrors {mirrored:0.0000}");
            Assert.That(math.cmax(math.abs(under - dry)), Is.LessThan(1e-5f), "under water");
            Assert.That(math.cmax(math.abs(wet - math.lerp(dry, sky, mirrored))), Is.LessThan(0.002f));
        }

        FluidSurfaceMesh AddMesh()
        {
            FluidSurfaceMesh mesh = scene.Root.AddComponent<FluidSurfaceMesh>();
            Material red = scene.Keep(new Material(Shader.Find("Unlit/Color")));
            red.color = Color.red;
            scene.Root.GetComponent<MeshRenderer>().sharedMaterial = red;
            return mesh;
        }

        // Its nodes lie at most a spacing above the floor.
        [UnityTest]
        public IEnumerator A_layer_of_single_particles_wets_the_floor_as_deep_water_does()
        {
            FluidVolume volume = scene.Root.GetComponentInChildren<FluidVolume>(true);
            volume.transform.localPosition = new Vector3(-0.3f, -0.475f, 0f);
            volume.Size = new Vector3(0.4f, 0.05f, 0.6f);
            yield return Wet();
            float4[] wet = scene.Pixels(), dry = null;
            yield return Dry(pixels => dry = pixels);
            Assert.That(FractionOf(wet, dry, Pixel(-0.3f)), Is.EqualTo(1f - Darkening).Within(0.001f));
            Assert.That(FractionOf(wet, dry, Pixel(-0.3f, 0.15f)), Is.EqualTo(1f - Darkening).Within(0.001f));
        }

        [UnityTest]
        public IEnumerator A_box_of_another_size_has_a_grid_of_its_own()
        {
            yield return Wet();
            scene.Root.GetComponentInChildren<FluidVolume>(true).transform.localPosition = new Vector3(0.45f, -0.4f, 0f);
            scene.Root.GetComponentInChildren<FluidVolume>(true).Size = new Vector3(0.1f, 0.2f, 0.6f);
            scene.Fluid.Configure(new Vector3(1.6f, 1f, 1f), WaterScene.Spacing, 3000);
            yield return Wet();
            float4[] wet = scene.Pixels(), dry = null;
            yield return Dry(pixels => dry = pixels);
            Assert.That(FractionOf(wet, dry, Pixel(0.45f)), Is.EqualTo(1f - Darkening).Within(0.001f));
            Assert.That(FractionOf(wet, dry, Pixel(0.58f)), Is.EqualTo(1f), "beyond the water, and the old box");
            Assert.That(FractionOf(wet, dry, Pixel(-0.3f)), Is.EqualTo(1f), "where the old water was");
        }

        [UnityTest]
        public IEnumerator A_camera_is_as_it_was_once_the_last_is_off()
        {
            yield return Wet();
            Assert.That(scene.Camera.commandBufferCount, Is.GreaterThan(0));
            wetness.enabled = false;
            Assert.That(scene.Camera.commandBufferCount, Is.Zero);
        }

        // A script may do so after the fluid's steps, before what they left is marked: what it removes is nowhere.
        [UnityTest]
        public IEnumerator Particles_that_a_script_has_removed_wet_nothing()
        {
            wetness.enabled = false;
            scene.Root.SetActive(true);
            yield return WaterScene.Frames(3);
            scene.Fluid.Advance(1f / 60f);
            scene.Fluid.RemoveInside(FluidShape.Box(Vector3.zero, 2f * Vector3.one));
            wetness.enabled = true;
            wetness.DrawFrame();
            yield return WaterScene.Frames(2);
            float4[] wet = scene.Pixels(), dry = null;
            yield return Dry(pixels => dry = pixels);
            Assert.That(Changed(wet, dry), Is.Zero);
        }

        // Red tells the mip of the side of the sky that it mirrors, and blue all other sides. The levels are Unity's: 6 r (1.7 - 0.7 r).
        [UnityTest]
        public IEnumerator The_film_mirrors_the_sky_in_its_direction_in_the_world_as_blurred_and_as_bright_as_the_scene_has_it(
            [Values(0f, 90f)] float turn, [Values(0.5f, 0.75f)] float smoothness)
        {
            const float angle = 75f, intensity = 0.5f;
            Cubemap cube = scene.Keep(new Cubemap(64, TextureFormat.RGBAHalf, true) { filterMode = FilterMode.Trilinear });
            for (int mip = 0; mip < 7; mip++)
                for (int face = 0; face < 6; face++)
                    cube.SetPixels(Enumerable.Repeat((CubemapFace)face == CubemapFace.PositiveX ? new Color(4f * (1 + mip), 8f, 0f)
                        : new Color(0f, 0f, 8f), 64 * 64 >> 2 * mip).ToArray(), (CubemapFace)face, mip);
            cube.Apply(false);
            (DefaultReflectionMode mode, Texture custom, float before) = (RenderSettings.defaultReflectionMode,
                RenderSettings.customReflectionTexture, RenderSettings.reflectionIntensity);
            (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture) = (DefaultReflectionMode.Custom, cube);
            RenderSettings.reflectionIntensity = intensity;
            wetness.Darkening = 0f;
            wetness.Smoothness = smoothness;
            scene.Root.transform.rotation = Quaternion.Euler(0f, turn, 0f);
            Vector3 at = scene.Root.transform.TransformPoint(new Vector3(-0.25f, -0.5f, 0f));
            scene.Camera.transform.position = at + 3f * (Quaternion.AngleAxis(angle, Vector3.forward) * Vector3.up);
            scene.Camera.transform.LookAt(at, Vector3.forward);
            yield return Wet();
            int center = Pixel(0f);
            float3 wet = scene.Pixels()[center].xyz, dry = 0f;
            yield return Dry(pixels => dry = pixels[center].xyz);
            (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture) = (mode, custom);
            RenderSettings.reflectionIntensity = before;
            float level = smoothness == 0.5f ? 4.05f : 2.2875f;
            float mirrored = smoothness * (0.02f + (smoothness - 0.02f) * math.pow(1f - math.cos(math.radians(angle)), 5f));
            float3 sky = (wet - (1f - mirrored) * dry) / (mirrored * intensity);
            TestContext.Out.WriteLine($"sky {sky}, mip {sky.x / 4f - 1f:0.00}");
            Assert.That(sky.x, Is.EqualTo(4f * (1f + level)).Within(0.3f));
            Assert.That(sky.y, Is.EqualTo(8f).Within(0.1f));
            Assert.That(sky.z, Is.EqualTo(0f).Within(0.1f));
        }

        [UnityTest]
        public IEnumerator It_is_seen_through_the_fog_in_front_of_it([Values] FogMode mode)
        {
            var fog = new float3(0.2f, 0.4f, 0.6f);
            yield return Wet();
            RenderSettings.fog = true;
            (RenderSettings.fogMode, RenderSettings.fogColor, RenderSettings.fogDensity) = (mode, WaterScene.Encoded(fog), 0.2f);
            (RenderSettings.fogStartDistance, RenderSettings.fogEndDistance) = (1f, 6f);
            yield return WaterScene.Frames(2);
            float4[] wetInFog = scene.Pixels(), dryInFog = null;
            yield return Dry(pixels => dryInFog = pixels);
            int at = Pixel(-0.3f);
            const float away = 3.5f;
            float seen = mode == FogMode.Linear ? (6f - away) / 5f : mode == FogMode.Exponential ? math.exp(-0.2f * away)
                : math.exp(-0.04f * away * away);
            TestContext.Out.WriteLine($"dry {dryInFog[at]}, wet {wetInFog[at]}");
            float3 expected = (1f - Darkening) * dryInFog[at].xyz + Darkening * (1f - seen) * fog;
            Assert.That(math.cmax(math.abs(wetInFog[at].xyz - expected)), Is.LessThan(0.002f));
        }

        [Test]
        public void Values_out_of_range_are_clamped_and_said([Values(0, 1, 2)] int setting)
        {
            LogAssert.Expect(LogType.Warning, new Regex("FluidWetness 'Fluid': (drying time|darkening|smoothness) -1 is outside"));
            Action<float> set = setting == 0 ? v => wetness.DryingTime = v : setting == 1 ? v => wetness.Darkening = v : v => wetness.Smoothness = v;
            Func<float> get = setting == 0 ? () => wetness.DryingTime : setting == 1 ? () => wetness.Darkening : () => wetness.Smoothness;
            set(-1f);
            Assert.That(get(), Is.EqualTo(setting == 0 ? 0.01f : 0f));
            LogAssert.Expect(LogType.Warning, new Regex("FluidWetness 'Fluid': .* NaN is outside"));
            set(float.NaN);
            Assert.That(get(), Is.EqualTo(setting == 0 ? 8f : setting == 1 ? 0.4f : 0.7f));
        }

        [TestCase(10f, 10f, 10f, ExpectedResult = 1f)]
        [TestCase(400f, 400f, 10f, ExpectedResult = 1f)]
        [TestCase(400f, 400f, 400f, ExpectedResult = 3.8146973f)]
        public float Nodes_are_a_spacing_apart_and_wider_where_there_would_be_too_many(float x, float y, float z)
            => WetGrid.CellFor(new float3(x, y, z));
    }
}
