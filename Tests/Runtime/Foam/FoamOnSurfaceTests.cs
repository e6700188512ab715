using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Foam where the water is drawn as a surface: under it, on it and beside it.</summary>
    public class FoamOnSurfaceTests
    {
        const float Depth = WaterScene.Depth, Half = 0.5f;
        const float Lit = 0.35f + 0.45f * 0.6f;     // of white foam in a white light, whose height is 0.6
        const int Pixels = 64;
        const string Layer = "Rill.Water.Bubbles";

        WaterScene scene;
        FluidSurface surface;
        FluidFoam foam;

        [SetUp]
        public void Make()
        {
            scene = new WaterScene(Pixels);
            scene.Camera.backgroundColor = Color.black;
            scene.AddSun();
            surface = scene.Surface;
            surface.CastShadows = ShadowCastingMode.Off;
            foam = scene.Root.AddComponent<FluidFoam>();
            foam.Radius = 0.06f;
            FoamSettings settings = foam.Settings;
            settings.amount = 0f;
            foam.Settings = settings;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        [UnityTest, Category("LongRun")]
        public IEnumerator Bubbles_are_seen_through_the_water_in_front_of_them([Values(0.15f, 0.35f)] float below)
        {
            yield return scene.Settle();
            Plant(FoamKinds.Bubbles, new float3(0f, Depth - below - Half, 0f), 20);
            yield return WaterScene.Frames(2);
            float3 seen = scene.At(0f, 0f), expected = 0.98f * Lit * math.pow(WaterScene.Left, below / 0.5f);
            TestContext.Out.WriteLine($"seen {seen}, Beer and Lambert {expected}");
            Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(0.1f));
            Assert.That(math.cmax(scene.At(0.2f, 0.2f)), Is.LessThan(0.05f), "beside them there is black behind the water");
        }

        [UnityTest]
        public IEnumerator Bubbles_behind_what_stands_in_the_water_are_not_seen()
        {
            GameObject plate = scene.Keep(GameObject.CreatePrimitive(PrimitiveType.Quad));
            plate.transform.position = new Vector3(0f, Depth - 0.15f - Half, 0f);
            plate.transform.rotation = Quaternion.LookRotation(Vector3.down);
            yield return scene.Settle();
            float3 before = scene.At(0f, 0f);
            Plant(FoamKinds.Bubbles, new float3(0f, Depth - 0.35f - Half, 0f), 20);
            yield return WaterScene.Frames(2);
            float3 seen = scene.At(0f, 0f);
            Assert.That(math.cmax(before), Is.GreaterThan(0.03f), "the plate is seen through the water");
            Assert.That(math.cmax(math.abs(seen - before)), Is.LessThan(0.01f));
        }

        [UnityTest]
        public IEnumerator Foam_on_the_water_covers_it()
        {
            yield return scene.Settle();
            Plant(FoamKinds.Foam, new float3(0f, Depth - Half, 0f), 20);
            yield return WaterScene.Frames(2);
            Assert.That(math.cmax(math.abs(scene.At(0f, 0f) - Lit)), Is.LessThan(0.05f * Lit));
            Assert.That(math.cmax(scene.At(0.2f, 0.2f)), Is.LessThan(0.05f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_particle_covers_as_much_as_its_opacity([Values(0.3f, 0.6f)] float opacity)
        {
            const int across = 20;
            foam.Opacity = opacity;
            foam.Radius = 0.003f;
            yield return scene.Settle();
            float before = Sum();
            FoamStage.Plant(scene.Fluid.Solver.Foam, Enumerable.Range(0, across * across).Select(i =>
            {
                float3 world = new float3(0.028f * (i % across - 9.4f), Depth - Half, 0.028f * (i / across - 9.4f));
                return FoamStage.Particle((world + Half) / WaterScene.Spacing, 0f, FoamKinds.Foam, 20f, 100f);
            }).ToArray());
            yield return WaterScene.Frames(2);
            float covered = (Sum() - before) / Lit, area = across * across * Mathf.PI * foam.Radius * foam.Radius * Mathf.Pow(Pixels / 0.6f, 2f);
            TestContext.Out.WriteLine($"covers {covered / area}");
            Assert.That(covered / area, Is.EqualTo(opacity).Within(0.05f * opacity), "of its disc");

            float Sum() => scene.Pixels().Sum(pixel => pixel.y);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Spray_beside_the_water_is_seen_where_nothing_stands_in_front([Values(false, true)] bool hidden)
        {
            WaterScene.Look(scene.Camera, new Vector3(0f, 0f, -3f));
            scene.Camera.orthographicSize = 0.5f;
            if (hidden)
            {
                GameObject screen = scene.Keep(GameObject.CreatePrimitive(PrimitiveType.Quad));
                screen.transform.position = new Vector3(0f, 0f, -2f);
                screen.transform.localScale = new Vector3(4f, 4f, 1f);
            }
            yield return scene.Settle();
            float3 before = scene.At(0f, 0.35f);
            Plant(FoamKinds.Spray, new float3(0f, 0.35f, 0f), 20);
            yield return WaterScene.Frames(2);
            float3 seen = scene.At(0f, 0.35f);
            if (hidden)
                Assert.That(math.cmax(math.abs(seen - before)), Is.LessThan(0.01f));
            else
                Assert.That(math.cmax(math.abs(seen - Lit)), Is.LessThan(0.05f * Lit));
        }

        [UnityTest]
        public IEnumerator The_surface_draws_foam_where_there_is_one_and_costs_nothing_without()
        {
            yield return scene.Settle();
            Assert.That(Stage("FluidFoam").Kernels, Is.Empty, "draws nothing of its own");
            Assert.That(Textures(), Does.Contain(Layer));
            surface.enabled = false;
            yield return WaterScene.Frames(2);
            Assert.That(Stage("FluidFoam").Kernels.Single().kernel, Does.StartWith("FoamParticles.shader"));
            surface.enabled = true;
            foam.enabled = false;
            yield return WaterScene.Frames(3);
            Assert.That(Textures(), Does.Not.Contain(Layer));
            Assert.That(Stage("FluidSurface").Kernels.Select(kernel => kernel.kernel), Has.None.Contains("Foam"));

            StageDescription Stage(string name) => scene.Fluid.Results.Describe().Single(stage => stage.Name == name);
            IEnumerable<string> Textures() => Stage("FluidSurface").Buffers.Select(texture => texture.name);
        }

        // Particles of the largest size at one position of the world, halfway through their lives.
        void Plant(FoamKinds kind, float3 world, int count)
        {
            FoamParticle particle = FoamStage.Particle((world + Half) / WaterScene.Spacing, 0f, kind, 20f, 100f);
            FoamStage.Plant(scene.Fluid.Solver.Foam, Enumerable.Repeat(particle, count).ToArray());
        }
    }
}
