using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Foam where the water is drawn as a surface: under it, on it and beside it.</summary>
    public class FoamOnSurfaceTests
    {
        const float Spacing = 0.05f, Depth = 0.6f, Half = 0.5f, Radius = 0.06f;
        const float Lit = 0.35f + 0.45f * 0.6f;     // of white foam in a white light, whose height is 0.6
        const int Pixels = 64;

        GameObject root;
        FluidSimulation fluid;
        FluidSurface surface;
        FluidFoam foam;
        Camera camera;
        RenderTexture target;

        [SetUp]
        public void Make()
        {
            target = new RenderTexture(Pixels, Pixels, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.orthographic = true;
            camera.orthographicSize = 0.3f;
            camera.farClipPlane = 10f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.allowHDR = true;
            camera.targetTexture = target;
            Look(new Vector3(0f, 3f, 0f));

            root = new GameObject("Fluid");
            root.SetActive(false);
            fluid = root.AddComponent<FluidSimulation>();
            fluid.Configure(Vector3.one, Spacing, 8000);
            fluid.StatisticsInterval = 0;
            var volume = new GameObject("Water").AddComponent<FluidVolume>();
            volume.transform.SetParent(root.transform, false);
            volume.transform.localPosition = new Vector3(0f, 0.5f * (Depth - 1f), 0f);
            volume.Size = new Vector3(1f, Depth, 1f);
            var sun = new GameObject("Sun").AddComponent<Light>();
            sun.transform.SetParent(root.transform, false);
            sun.transform.rotation = Quaternion.LookRotation(new Vector3(-0.8f, -0.6f, 0f));
            sun.color = Color.white;
            sun.intensity = 1f;
            sun.enabled = false;
            surface = root.AddComponent<FluidSurface>();
            surface.ReflectionStrength = 0f;
            surface.Sun = sun;
            SurfaceLook look = SurfaceLook.Water;
            look.scatteringDepth = 0f;
            look.colorAtDepth = QualitySettings.activeColorSpace == ColorSpace.Linear ? new Color(0.2f, 0.5f, 0.8f).gamma : new Color(0.2f, 0.5f, 0.8f);
            look.colorDepth = 0.5f;
            surface.Look = look;
            foam = root.AddComponent<FluidFoam>();
            foam.Radius = Radius;
            FoamSettings settings = foam.Settings;
            settings.amount = 0f;
            foam.Settings = settings;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Time.captureDeltaTime = 0f;
            Object.Destroy(root);
            Object.Destroy(camera.gameObject);
            yield return null;
            target.Release();
        }

        [UnityTest]
        public IEnumerator Bubbles_are_seen_through_the_water_in_front_of_them([Values(0.15f, 0.35f)] float below)
        {
            yield return Begin();
            Plant(FoamKinds.Bubbles, new float3(0f, Depth - below - Half, 0f), 20);
            yield return Frames(2);
            float3 seen = At(0f, 0f), expected = 0.98f * Lit * math.pow(new float3(0.2f, 0.5f, 0.8f), below / 0.5f);
            TestContext.Out.WriteLine($"seen {seen}, Beer and Lambert {expected}");
            Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(0.1f));
            Assert.That(math.cmax(At(0.2f, 0.2f)), Is.LessThan(0.05f), "beside them there is black behind the water");
        }

        [UnityTest]
        public IEnumerator Bubbles_behind_what_stands_in_the_water_are_not_seen()
        {
            GameObject plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
            plate.transform.position = new Vector3(0f, Depth - 0.15f - Half, 0f);
            plate.transform.rotation = Quaternion.LookRotation(Vector3.down);
            yield return Begin();
            float3 before = At(0f, 0f);
            Plant(FoamKinds.Bubbles, new float3(0f, Depth - 0.35f - Half, 0f), 20);
            yield return Frames(2);
            float3 seen = At(0f, 0f);
            Object.DestroyImmediate(plate);
            Assert.That(math.cmax(before), Is.GreaterThan(0.03f), "the plate is seen through the water");
            Assert.That(math.cmax(math.abs(seen - before)), Is.LessThan(0.01f));
        }

        [UnityTest]
        public IEnumerator Foam_on_the_water_covers_it()
        {
            yield return Begin();
            Plant(FoamKinds.Foam, new float3(0f, Depth - Half, 0f), 20);
            yield return Frames(2);
            Assert.That(math.cmax(math.abs(At(0f, 0f) - Lit)), Is.LessThan(0.05f * Lit));
            Assert.That(math.cmax(At(0.2f, 0.2f)), Is.LessThan(0.05f));
        }

        [UnityTest]
        public IEnumerator One_particle_covers_as_much_as_its_opacity([Values(0.3f, 0.6f)] float opacity)
        {
            foam.Opacity = opacity;
            foam.Radius = 0.035f;       // not seen as a bubble with a rim
            yield return Begin();
            float before = Sum();
            Plant(FoamKinds.Foam, new float3(0.3f / Pixels, Depth - Half, 0.3f / Pixels), 1);
            yield return Frames(2);
            float covered = (Sum() - before) / Lit, area = Mathf.PI * foam.Radius * foam.Radius * Mathf.Pow(Pixels / 0.6f, 2f);
            Assert.That(covered / area, Is.EqualTo(opacity).Within(0.25f * opacity), "mean of its disc");

            float Sum() => Enumerable.Range(0, Pixels * Pixels).Sum(i => Pixel(i).y);
        }

        [UnityTest]
        public IEnumerator Spray_beside_the_water_is_seen_where_nothing_stands_in_front([Values(false, true)] bool hidden)
        {
            Look(new Vector3(0f, 0f, -3f));
            camera.orthographicSize = 0.5f;
            GameObject screen = null;
            if (hidden)
            {
                screen = GameObject.CreatePrimitive(PrimitiveType.Quad);
                screen.transform.position = new Vector3(0f, 0f, -2f);
                screen.transform.localScale = new Vector3(4f, 4f, 1f);
            }
            yield return Begin();
            float3 before = At(0f, 0.35f);
            Plant(FoamKinds.Spray, new float3(0f, 0.35f, 0f), 20);
            yield return Frames(2);
            float3 seen = At(0f, 0.35f);
            if (screen != null)
                Object.DestroyImmediate(screen);
            if (hidden)
                Assert.That(math.cmax(math.abs(seen - before)), Is.LessThan(0.01f));
            else
                Assert.That(math.cmax(math.abs(seen - Lit)), Is.LessThan(0.05f * Lit));
        }

        [UnityTest]
        public IEnumerator The_surface_draws_foam_where_there_is_one_and_costs_nothing_without()
        {
            yield return Begin();
            Assert.That(Stage("FluidFoam").Kernels, Is.Empty, "draws nothing of its own");
            Assert.That(Textures(), Does.Contain("Rill.Surface.Foam"));
            surface.enabled = false;
            yield return Frames(2);
            Assert.That(Stage("FluidFoam").Kernels.Single().kernel, Does.StartWith("FoamParticles.shader"));
            surface.enabled = true;
            foam.enabled = false;
            yield return Frames(3);
            Assert.That(Textures(), Does.Not.Contain("Rill.Surface.Foam"));
            Assert.That(Stage("FluidSurface").Kernels.Select(kernel => kernel.kernel), Has.None.Contains("Foam"));

            StageDescription Stage(string name) => fluid.Describe().Single(stage => stage.Name == name);
            IEnumerable<string> Textures() => Stage("FluidSurface").Buffers.Select(texture => texture.name);
        }

        IEnumerator Begin()
        {
            Time.captureDeltaTime = 1f / 60f;
            root.SetActive(true);
            yield return Frames(20);
            fluid.Paused = true;
            yield return Frames(2);
        }

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }

        void Look(Vector3 from)
        {
            camera.transform.position = from;
            camera.transform.LookAt(Vector3.zero, from.y > 1f ? Vector3.forward : Vector3.up);
        }

        // Particles of the largest size in one place of the world, in the middle of their lives.
        void Plant(FoamKinds kind, float3 world, int count)
        {
            Foam stage = fluid.Solver.Foam;
            uint number = kind == FoamKinds.Spray ? 1u : kind == FoamKinds.Foam ? 2u : 3u;
            var particle = new FoamParticle { a = new uint4(math.asuint((world + Half) / Spacing), math.asuint(20f)), b = new uint4(0u, 0u, 0u, number | 6400u << 2 | 255u << 16) };
            stage.Particles.SetData(Enumerable.Repeat(particle, count).ToArray(), 0, 0, count);
            stage.Counters.SetData(new[] { (uint)count, 0u, 0u, 0u, 0u, 0u, 0u, 0u });
            stage.Arguments.SetData(ParticleState.ArgumentsFor(count));
        }

        // Right and up of the picture's middle, m.
        float3 At(float right, float up)
        {
            int x = (int)((right / camera.orthographicSize * 0.5f + 0.5f) * Pixels), y = (int)((up / camera.orthographicSize * 0.5f + 0.5f) * Pixels);
            return Pixel(y * Pixels + x);
        }

        float3 Pixel(int index)
        {
            if (readFrame != Time.frameCount)
            {
                var picture = new Texture2D(Pixels, Pixels, TextureFormat.RGBAFloat, false, true);
                RenderTexture.active = target;
                picture.ReadPixels(new Rect(0, 0, Pixels, Pixels), 0, 0);
                RenderTexture.active = null;
                read = picture.GetPixels();
                readFrame = Time.frameCount;
                Object.Destroy(picture);
            }
            return new float3(read[index].r, read[index].g, read[index].b);
        }

        Color[] read;
        int readFrame = -1;
    }
}
