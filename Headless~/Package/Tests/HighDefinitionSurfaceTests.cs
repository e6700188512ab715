using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>The package's adapter for HDRP draws fluid surfaces in every version without a step by hand, as the Built-in pipeline shows
    /// them.</summary>
    public class HighDefinitionSurfaceTests : PipelineSurfaceFixture
    {
        const string Space = "UnityEngine.Rendering.HighDefinition.";

        void Build(string version, bool editor = false) => Build(PipelineKind.HighDefinition, version, editor);

        [TearDown]
        public void ResetExposure()
        {
            if (pipeline != null)
                Expose(1);
        }

        System.Type TypeOf(string name) => pipeline[PipelineKind.HighDefinition.Assembly].GetType(Space + name, true);

        void Expose(float exposure) => TypeOf("HDRenderPipeline").GetField("Exposure", BindingFlags.Static | BindingFlags.NonPublic)
            .SetValue(null, exposure);

        static Light Sun => Object.FindObjectOfType<Light>();

        int Volumes() => Resources.FindObjectsOfTypeAll(TypeOf("CustomPassVolume")).Length;

        FluidSurface Surface => simulation.GetComponent<FluidSurface>();

        // Amount of milk, in the center of the picture.
        float MilkAfter(int frames)
        {
            Play(frames);
            return Pixels()[Width * (Height / 2 - 2) + Width / 2].y;
        }

        [Test]
        public void The_water_is_there_without_a_step_by_hand([Values("14", "17", "17.3", "17.4")] string version)
        {
            Build(version);
            Play(2);
            Assert.That(Errors, Is.Empty);
            Assert.That(Covered(Pixels()), Is.GreaterThan(Width * Height / 60));
        }

        // With something that hides the rear of the water.
        void Arrange(bool refraction)
        {
            Surface.Refraction = refraction;
            GameObject post = GameObject.CreatePrimitive(PrimitiveType.Cube);
            post.transform.localScale = new Vector3(0.3f, 2, 0.3f);
            post.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
        }

        int OtherThanInTheBuiltInPipeline(bool refraction, System.Action build)
        {
            Vector4[] builtIn = InTheBuiltInPipeline(3, () => Arrange(refraction));
            build();
            Arrange(refraction);
            Play(3);
            return Pixels().Where((pixel, i) => (pixel - builtIn[i]).magnitude > 0.02f).Count();
        }

        [Test]
        public void It_looks_as_in_the_Built_in_pipeline([Values("14", "17")] string version, [Values] bool refraction)
            => Assert.That(OtherThanInTheBuiltInPipeline(refraction, () => Build(version)), Is.LessThan(Width * Height / 500));

        [TestCase("HighDefinitionSurfaces.cs", "views.sceneSize = new Vector2(views.width, views.height);",
            "views.sceneSize = new Vector2(views.width, views.height) / 0.7f;",
            TestName = "The_size_of_the_textures_for_that_of_the_picture_is_seen")]
        [TestCase("SurfacePass.cs", "views.light = surface.Sun != null ? LightOf(surface.Sun) : main;",
            "views.light = null;", TestName = "Another_light_is_seen")]
        [TestCase("SurfaceVolume.cs", "CustomPassInjectionPoint.BeforePreRefraction", "CustomPassInjectionPoint.BeforeRendering",
            TestName = "A_pass_before_the_depth_is_drawn_is_seen")]
        public void A_fault_in_the_adapter_is_seen(string file, string line, string instead) =>
            Assert.That(OtherThanInTheBuiltInPipeline(!instead.Contains("BeforeRendering"),
            () => BuildWithFault(PipelineKind.HighDefinition, "17", file, line, instead)), Is.GreaterThan(Width * Height / 500));

        [Test]
        public void A_pass_after_the_transparent_draws_is_caught()
        {
            BuildWithFault(PipelineKind.HighDefinition, "17", "SurfaceVolume.cs", "CustomPassInjectionPoint.BeforePreRefraction",
                "CustomPassInjectionPoint.BeforePostProcess");
            LogAssert.Expect(LogType.Exception, new Regex("'Rill.Water.Tiles'.*nothing has written it yet"));
            Play(1);
        }

        [Test]
        public void What_the_water_adds_is_exposed_and_what_it_shows_is_not_exposed_again([Values("14", "17")] string version)
        {
            Build(version);
            Sun.intensity = 3;
            Surface.Preset = SurfacePreset.Milk;
            float milk = MilkAfter(3);
            simulation.Paused = true;
            Expose(0.5f);
            Assert.That(MilkAfter(1), Is.EqualTo(0.5f * milk).Within(0.01f * milk));
            SurfaceLook clear = SurfaceLook.Water;
            clear.scattering = Color.black;
            clear.refractionIndex = 1f;     // straight through to the floor
            Surface.Look = clear;
            Surface.ReflectionStrength = 0;
            Sun.intensity = 0;
            float halved = MilkAfter(3);
            Expose(1);
            Assert.That(halved, Is.GreaterThan(0.05f), "the floor");
            Assert.That(MilkAfter(1), Is.EqualTo(halved).Within(0.001f));
        }

        // Without a sun: by the light of the sky, and by that of a cube of the user's own.
        [Test]
        public void The_light_of_the_sky_in_the_water_is_exposed([Values("14", "17")] string version, [Values] bool own)
        {
            Build(version);
            Sun.intensity = 0;
            Surface.Preset = SurfacePreset.Milk;
            Surface.ReflectionStrength = 0;
            float dark = MilkAfter(3);
            simulation.Paused = true;
            var cube = new Cubemap(1, TextureFormat.RGBAHalf, false);
            for (int face = 0; face < 6; face++)
                cube.SetPixels(new[] { Color.gray }, (CubemapFace)face);
            cube.Apply(false);
            if (own)
                Surface.Reflection = cube;
            else
                (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture) = (DefaultReflectionMode.Custom, cube);
            Surface.ReflectionStrength = 1;
            float lit = MilkAfter(2) - dark;
            Expose(0.5f);
            float halved = MilkAfter(1) - dark;
            Surface.Reflection = null;
            (RenderSettings.defaultReflectionMode, RenderSettings.customReflectionTexture) = (DefaultReflectionMode.Skybox, null);
            Object.DestroyImmediate(cube);
            Assert.That(lit, Is.GreaterThan(0.1f));
            Assert.That(halved, Is.EqualTo(0.5f * lit).Within(0.01f * lit));
        }

        [Test]
        public void A_light_of_one_in_Built_in_units_is_one_of_pi_lux([Values("14", "17")] string version, [Values] bool chosen)
        {
            Build(version);
            Surface.Preset = SurfacePreset.Milk;
            Surface.Sun = chosen ? Sun : null;
            MilkAfter(2);
            simulation.Paused = true;
            float builtIn = MilkAfter(1);
            Sun.gameObject.AddComponent(TypeOf("HDAdditionalLightData"));
            float lux = MilkAfter(2);
            Sun.intensity = Mathf.PI;
            Assert.That(MilkAfter(2), Is.EqualTo(builtIn).Within(1e-3f * builtIn));
            Assert.That(lux, Is.LessThan(0.8f * builtIn));
        }

        [Test]
        public void The_light_is_the_brightest_directional_one_of_this_frame()
        {
            Build("17");
            Surface.Preset = SurfacePreset.Milk;
            Sun.intensity = 1;
            Play(2);
            simulation.Paused = true;
            float dim = MilkAfter(1);
            var bright = new GameObject("Brighter").AddComponent<Light>();
            bright.type = LightType.Directional;
            bright.transform.rotation = Quaternion.Euler(60, 30, 0);
            bright.intensity = 4;
            Assert.That(MilkAfter(1), Is.GreaterThan(1.5f * dim));
            Object.DestroyImmediate(bright.gameObject);
            Assert.That(MilkAfter(1), Is.EqualTo(dim).Within(1e-3f));

            // The camera is new to the adapter: no frame of it has been drawn.
            Surface.enabled = false;
            Surface.enabled = true;
            Assert.That(MilkAfter(1), Is.EqualTo(dim).Within(1e-3f), "the first");
        }

        [Test]
        public void Each_of_two_cameras_shows_what_it_shows_alone([Values("14", "17")] string version)
        {
            Build(version);
            var otherTarget = new RenderTexture(Height, Width, UnityEngine.Experimental.Rendering.GraphicsFormat.R32G32B32A32_SFloat,
                UnityEngine.Experimental.Rendering.GraphicsFormat.D32_SFloat);
            Camera other = new GameObject("Other").AddComponent<Camera>();
            other.targetTexture = otherTarget;
            other.depth = 1;
            other.transform.position = new Vector3(3, 1, 0);
            other.transform.LookAt(Vector3.zero);
            Play(2);
            simulation.Paused = true;
            Play(1);
            camera.transform.position += new Vector3(0.3f, 0, 0.5f);    // what was drawn of it before is of no use
            Play(1);
            Vector4[] beside = Pixels();
            Assert.That(Volumes(), Is.EqualTo(2));
            Object.DestroyImmediate(other.gameObject);
            otherTarget.Release();
            Object.DestroyImmediate(otherTarget);
            Play(2);
            Assert.That(Volumes(), Is.EqualTo(1), "that of the camera that is gone is gone");
            camera.transform.position += new Vector3(0, 1, 0);
            Play(1);
            camera.transform.position -= new Vector3(0, 1, 0);
            Play(1);
            Vector4[] alone = Pixels();
            Assert.That(beside.Where((pixel, i) => (pixel - alone[i]).magnitude > 0.001f).Count(), Is.EqualTo(0));
            Assert.That(Errors, Is.Empty);
        }

        [Test]
        public void Nothing_hidden_is_left([Values("the surface is off", "the pipeline is another", "the camera sees no water")] string when)
        {
            Build("17");
            if (when == "the camera sees no water")
                camera.transform.rotation = Quaternion.Euler(0, 180, 0);
            Play(2);
            Assert.That(Volumes(), Is.EqualTo(when == "the camera sees no water" ? 0 : 1));
            if (when == "the surface is off")
                Surface.enabled = false;
            if (when == "the pipeline is another")
            {
                camera.enabled = false;     // the floor's shader was imported for HDRP
                UnityEngine.Rendering.GraphicsSettings.defaultRenderPipeline = null;
            }
            Play(2);
            Assert.That(Volumes(), Is.EqualTo(0));
        }

        [Test]
        public void The_water_is_there_after_a_reload_of_scripts_in_play_mode([Values("14", "17")] string version)
        {
            UnityEditor.EditorInitializers.Run();
            Build(version, editor: true);
            Play(3);
            List<string> before = Alive();
            for (int time = 0; time < 2; time++)
            {
                UnityEditor.EditorReload.Run();
                Play(3);
                Assert.That(Errors, Is.Empty);
                Assert.That(Alive(), Is.EqualTo(before));
            }
            Assert.That(Covered(Pixels()), Is.GreaterThan(Width * Height / 20));
        }

        [Test]
        public void What_the_project_lacks_is_listed_and_one_click_puts_it_right()
        {
            Build("17", editor: true);
            IRenderSetup setup = RenderSetups.All.Last();
            Assert.That(setup.Problems, Is.Empty);
            pipeline.Asset.name = "Low";
            object none = System.Activator.CreateInstance(TypeOf("RenderPipelineSettings"));
            Set(pipeline.Asset, "currentPlatformRenderPipelineSettings", none);
            Play(2);
            Assert.That(Errors, Is.Empty);
            Assert.That(Volumes(), Is.EqualTo(0), "no camera runs custom passes");
            SetupProblem problem = setup.Problems.Single();
            Assert.That(problem.Text, Does.Contain("'Low'").And.Contain("Custom Pass is off"));
            problem.Fix();
            Assert.That(setup.Problems, Is.Empty);
            Play(2);
            Assert.That(Volumes(), Is.EqualTo(1));

            object data = camera.gameObject.AddComponent(TypeOf("HDAdditionalCameraData"));
            Set(data, "own", System.Activator.CreateInstance(TypeOf("FrameSettings")));
            Assert.That(setup.Problems, Is.Empty, "they do not count");
            Set(data, "customRenderingSettings", true);
            System.Collections.Generic.List<SetupProblem> problems = setup.Problems.ToList();
            Assert.That(problems.ConvertAll(found => found.Text),
                Has.Count.EqualTo(2).And.All.Contains("'Camera'").And.Some.Contains("Custom Pass is off").And.Some.Contains(
                "Refraction is off"));
            foreach (SetupProblem found in problems)
                found.Fix();
            Assert.That(setup.Problems, Is.Empty);
        }
    }
}
