using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The components: their settings, what they say and what is drawn.</summary>
    public class FluidSmokeTests
    {
        GameObject fluid;
        FluidSimulation simulation;
        FluidSmoke smoke;
        FluidSmokeSource source;
        Camera camera;
        RenderTexture target;
        Texture2D picture;

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Time.captureDeltaTime = 0f;
            Object.Destroy(fluid);
            if (camera != null)
                Object.Destroy(camera.gameObject);
            if (picture != null)
                Object.Destroy(picture);
            yield return null;
            if (target != null)
                target.Release();
        }

        [Test]
        public void Settings_out_of_range_are_clamped_and_named()
        {
            SmokeSettings settings = SmokeSettings.Default;
            settings.cellSize = -1f;
            settings.lifetime = float.NaN;
            settings.cooling = 2000f;
            settings.vorticity = 3f;
            settings.airTemperature = -300f;
            settings.steam = -1f;
            settings.steamTemperature = 4000f;
            Assert.That(settings.Validate(out string problem), Is.False);
            Assert.That(problem, Is.EqualTo("cell size -1 is outside 0 to 10; using 0. lifetime NaN is outside 0 to 1000; using 4. " +
                "cooling 2000 is outside 0 to 1000; using 1000. vorticity 3 is outside 0 to 2; using 2. " +
                "air temperature -300 is outside -100 to 1000; using -100. steam -1 is outside 0 to 1000; using 0. " +
                "steam temperature 4000 is outside -100 to 3000; using 3000."));
            settings = SmokeSettings.Default;
            Assert.That(settings.Validate(out _), Is.True, "the defaults");
        }

        [Test]
        public void A_source_says_what_it_clamped_and_that_it_needs_a_FluidSmoke()
        {
            Make();
            LogAssert.Expect(LogType.Warning, "Rill: FluidSmokeSource 'Fire': temperature 5000 is outside -100 to 3000; using 3000.");
            source.Temperature = 5000f;
            LogAssert.Expect(LogType.Warning, "Rill: FluidSmokeSource 'Fire': radius 0 is outside 0.0001 to 10000; using 0.0001.");
            source.Radius = 0f;
            LogAssert.Expect(LogType.Warning, "Rill: FluidSmoke 'Fluid': glow -1 is outside 0 to 100; using 0.");
            smoke.Glow = -1f;
            source.Temperature = 300f;
            smoke.Glow = 1f;
            Assert.That(Problems(source), Is.Empty);
            Assert.That(Problems(smoke), Is.Empty);
            simulation.Gravity = Vector3.zero;
            Assert.That(Problems(smoke).Single(), Does.StartWith("hot air does not rise: the simulation has no gravity."));
            Object.DestroyImmediate(smoke);
            Assert.That(Problems(source).Single(), Does.Match("^FluidSimulation 'Fluid' has no FluidSmoke.* Add that component to it"));
        }

        [UnityTest]
        public IEnumerator Smoke_hides_what_is_behind_it_and_not_what_stands_before_it()
        {
            Make();
            smoke.Color = Color.black;
            smoke.Glow = 0f;
            smoke.Ambient = Color.black;
            source.Density = 100f;
            source.Temperature = 20f;
            fluid.SetActive(true);
            View();
            Time.captureDeltaTime = 1f / 60f;
            for (int frame = 0; frame < 20; frame++)
                yield return null;
            Color center = Pixel(32, 32), beside = Pixel(4, 60);
            Assert.That(center.r, Is.LessThan(0.1f), "through the smoke");
            Assert.That(beside.r, Is.GreaterThan(0.9f), "beside it");
            Assert.That(center.a, Is.GreaterThan(0.99f), "alpha of the picture");

            List<StageDescription> stages = simulation.Results.Describe();
            Assert.That(stages.Single(stage => stage.Name == "Smoke").Kernels.Count, Is.GreaterThan(6));
            Assert.That(stages.Single(stage => stage.Name == "FluidSmoke").Kernels.Single().kernel,
                Is.EqualTo("SmokeVolume.shader, a draw in each pass of each camera"));

            var wall = GameObject.CreatePrimitive(PrimitiveType.Cube);
            wall.transform.parent = fluid.transform;
            wall.transform.position = new Vector3(0f, 0f, -0.8f);
            yield return null;
            yield return null;
            Assert.That(Pixel(32, 32).r, Is.GreaterThan(0.15f), "what stands before it");

            smoke.enabled = false;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Smoke, Is.Null);
            Assert.That(simulation.Results.Describe().Single(stage => stage.Name == "Smoke").Kernels, Is.Empty);
        }

        [UnityTest]
        public IEnumerator Hot_smoke_glows_by_its_temperature()
        {
            Make();
            smoke.Color = Color.black;
            smoke.Ambient = Color.black;
            source.Density = 100f;
            source.Temperature = 1200f;
            fluid.SetActive(true);
            View();
            camera.backgroundColor = Color.black;
            Time.captureDeltaTime = 1f / 60f;
            for (int frame = 0; frame < 12; frame++)
                yield return null;
            Color hot = Pixel(32, 30);
            Assert.That(hot.r, Is.GreaterThan(0.3f));
            Assert.That(hot.r, Is.GreaterThan(1.4f * hot.b));
            smoke.Glow = 0f;
            yield return null;
            yield return null;
            Assert.That(Pixel(32, 30).r, Is.LessThan(0.02f), "without its glow");
        }

        [UnityTest]
        public IEnumerator Smoke_shades_what_is_below_it()
        {
            Make();
            smoke.Color = Color.white;
            smoke.Ambient = Color.black;
            source.Density = 30f;
            source.Temperature = 20f;
            var sun = new GameObject("Sun").AddComponent<Light>();
            sun.transform.parent = fluid.transform;
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.Euler(90f, 0f, 0f);
            smoke.Sun = sun;
            fluid.SetActive(true);
            View();
            camera.backgroundColor = Color.black;
            Time.captureDeltaTime = 1f / 60f;
            for (int frame = 0; frame < 20; frame++)
                yield return null;
            Assert.That(Pixel(32, 37).g, Is.GreaterThan(1.3f * Pixel(32, 27).g), "the upper part of the ball");
        }

        [UnityTest]
        public IEnumerator Another_cell_size_makes_another_grid()
        {
            Make();
            fluid.SetActive(true);
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Smoke.Counts.x, Is.EqualTo(20));
            SmokeSettings settings = smoke.Settings;
            settings.cellSize = 0.1f;
            smoke.Settings = settings;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Smoke.Counts.x, Is.EqualTo(10));
        }

        void Make()
        {
            fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(Vector3.one, 0.05f, 1000);
            smoke = fluid.AddComponent<FluidSmoke>();
            source = new GameObject("Fire").AddComponent<FluidSmokeSource>();
            source.transform.parent = fluid.transform;
            source.Radius = 0.3f;
        }

        void View()
        {
            target = new RenderTexture(64, 64, 24, RenderTextureFormat.ARGB32);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 0f, -3f);
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.white;
            camera.fieldOfView = 40f;
            camera.targetTexture = target;
        }

        Color Pixel(int x, int y)
        {
            if (picture == null)
                picture = new Texture2D(64, 64, TextureFormat.RGBA32, false);
            RenderTexture before = RenderTexture.active;
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0f, 0f, 64f, 64f), 0, 0);
            RenderTexture.active = before;
            return picture.GetPixel(x, y);
        }

        static List<string> Problems(IHasProblems of)
        {
            var problems = new List<string>();
            of.ListProblems(problems);
            return problems;
        }
    }
}
