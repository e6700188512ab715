using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>The component: its settings, what it says and what it draws.</summary>
    public class FluidFoamTests
    {
        GameObject fluid;
        FluidSimulation simulation;
        Camera camera;
        RenderTexture target;

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Time.captureDeltaTime = 0f;
            Object.Destroy(fluid);
            if (camera != null)
                Object.Destroy(camera.gameObject);
            yield return null;
            if (target != null)
                target.Release();
        }

        [Test]
        public void Settings_out_of_range_are_clamped_and_named()
        {
            FoamSettings settings = FoamSettings.Default;
            settings.amount = -1f;
            settings.budget = 0;
            settings.lifetime = float.NaN;
            settings.referenceSpeed = -2f;
            settings.referenceDepth = float.PositiveInfinity;
            settings.kinds = (FoamKinds)8;
            Assert.That(settings.Validate(out string problem), Is.False);
            Assert.That(problem, Is.EqualTo("amount -1 is outside 0 to 10; using 0. budget 0 is outside 1 to 4194304; using 1. " +
                "lifetime NaN is outside 0.1 to 200; using 4. "
                + "reference speed -2 is outside 0 to 1000; using 0. reference depth Infinity is outside 0 to 10000; using 0. "
                + "kinds 8 names none or others than spray (1), foam (2) and bubbles (4); using 7."));
            Assert.That(settings.Validate(out problem), Is.True);
            Assert.That(problem, Is.Null);
            settings = FoamSettings.Default;
            Assert.That(settings.Validate(out _), Is.True, "the defaults");
        }

        [Test]
        public void A_component_says_what_it_clamped_and_that_it_needs_gravity()
        {
            FluidFoam foam = Make();
            LogAssert.Expect(LogType.Warning, "Rill: FluidFoam 'Fluid': radius -1 is outside 0 to 10; using 0.");
            foam.Radius = -1f;
            Assert.That(foam.Radius, Is.Zero);
            LogAssert.Expect(LogType.Warning, "Rill: FluidFoam 'Fluid': opacity 2 is outside 0 to 1; using 1.");
            foam.Opacity = 2f;
            foam.Opacity = 1f;
            Assert.That(Problems(foam), Is.Empty);
            simulation.Gravity = Vector3.zero;
            Assert.That(Problems(foam).Single(), Does.Match("^makes no foam: without gravity .* Set Reference Speed .* and Reference Depth"));
            FoamSettings settings = foam.Settings;
            settings.referenceSpeed = 2f;
            foam.Settings = settings;
            Assert.That(Problems(foam), Is.Empty);
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Foam_of_a_scene_is_made_counted_and_goes_with_its_component()
        {
            FluidFoam foam = Make();
            fluid.SetActive(true);
            Time.captureDeltaTime = 1f / 60f;
            Assert.That(foam.TryGetStatistics(out _), Is.False, "before the first step");
            for (int frame = 0; frame < 110; frame++)
                yield return null;
            Assert.That(foam.TryGetStatistics(out FoamStatistics statistics));
            Assert.That(statistics.Particles, Is.GreaterThan(100));
            Assert.That(statistics.spawned, Is.GreaterThanOrEqualTo(statistics.Particles));
            Assert.That(statistics.refused, Is.Zero);
            List<StageDescription> stages = simulation.Results.Describe();
            Assert.That(stages.Single(stage => stage.Name == "Foam").Kernels.Count, Is.EqualTo(9));
            Assert.That(stages.Single(stage => stage.Name == "FluidFoam").Kernels.Single().kernel,
                Is.EqualTo("FoamParticles.shader, a draw in each pass of each camera"));

            foam.enabled = false;
            yield return null;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Foam, Is.Null);
            Assert.That(foam.TryGetStatistics(out _), Is.False);
            Assert.That(simulation.Results.Describe().Single(stage => stage.Name == "Foam").Buffers, Is.Empty);
        }

        [UnityTest]
        public IEnumerator A_camera_sees_foam_where_it_is_and_nothing_where_something_is_in_front([Values(false, true)] bool covered)
        {
            FluidFoam foam = Make();
            FoamSettings settings = foam.Settings;
            settings.amount = 0f;
            foam.Settings = settings;
            foam.Radius = 0.1f;
            foam.Opacity = 1f;
            fluid.SetActive(true);
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            yield return null;
            // One of them in the center of the box, which is to be drawn for the first time in the next frame.
            simulation.Paused = true;
            FoamStage.Plant(simulation.Solver.Foam,
                FoamStage.Particle(new Unity.Mathematics.float3(12f, 8f, 4f), 0f, FoamKinds.Foam, 20f, 100f));
            MakeCamera();
            GameObject screen = null;
            if (covered)
            {
                screen = GameObject.CreatePrimitive(PrimitiveType.Quad);
                screen.transform.position = new Vector3(0f, 0f, -2f);
            }
            yield return null;
            yield return null;
            if (screen != null)
                Object.Destroy(screen);
            Color[] pixels = Read();
            int lit = pixels.Count(pixel => pixel.g > 0.2f);
            if (covered)
                Assert.That(pixels[32 * 64 + 32].g - pixels[32 * 64 + 20].g, Is.EqualTo(0f).Within(0.02f),
                    "the screen in front is the same beside it");
            else
                Assert.That(lit, Is.InRange(30, 330), "pixels of a disc of 0.1 m, of which a pixel is 1/96 m");
        }

        FluidFoam Make()
        {
            fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(1.2f, 0.8f, 0.4f), 0.05f, 3000);
            simulation.StatisticsInterval = 3;
            var volume = new GameObject("Volume").AddComponent<FluidVolume>();
            volume.transform.SetParent(fluid.transform, false);
            volume.transform.localPosition = new Vector3(-0.3f, 0f, 0f);
            volume.Size = new Vector3(0.6f, 0.8f, 0.4f);
            return fluid.AddComponent<FluidFoam>();
        }

        void MakeCamera()
        {
            target = new RenderTexture(64, 64, 24);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 0f, -5f);
            camera.orthographic = true;
            camera.orthographicSize = 1f / 3f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.targetTexture = target;
        }

        Color[] Read()
        {
            var picture = new Texture2D(64, 64);
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0, 0, 64, 64), 0, 0);
            RenderTexture.active = null;
            Color[] pixels = picture.GetPixels();
            Object.Destroy(picture);
            return pixels;
        }

        static List<string> Problems(IHasProblems foam)
        {
            var problems = new List<string>();
            foam.ListProblems(problems);
            return problems;
        }
    }
}
