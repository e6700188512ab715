using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>The package's adapter for URP draws fluid surfaces in every version without a step by hand, as the Built-in pipeline shows
    /// them.</summary>
    public class UniversalSurfaceTests : UniversalSurfaceFixture
    {
        [Test]
        public void The_water_is_there_without_a_step_by_hand([Values("14", "17", "17 by Execute", "17.3", "17.3-compatibility by Execute",
            "17.4")] string version)
        {
            Build(version);
            Play(2);
            Assert.That(Errors, Is.Empty);
            Assert.That(Logged, Has.None.Contains("RecordRenderGraph").And.None.Contains("Execute is not implemented"));
            Assert.That(Covered(Pixels()), Is.GreaterThan(Width * Height / 20));
        }

        [Test]
        public void It_looks_as_in_the_Built_in_pipeline([Values("14", "17", "17 by Execute")] string version)
        {
            Vector4[] builtIn = InTheBuiltInPipeline(2);
            Build(version);
            Play(2);
            Vector4[] universal = Pixels();
            // Beside the water the floor has the same light; in the water, the view through it has half the size.
            int other = universal.Where((pixel, i) => (pixel - builtIn[i]).magnitude > 0.1f).Count();
            Assert.That(other, Is.LessThan(Width * Height / 50));
        }

        // How far the foam changes the picture, and how many pixels it changes otherwise than in the Built-in pipeline.
        (int changed, int other) Foam(Action build)
        {
            Vector4[] without = null;
            void Plant()
            {
                PlantedFoam.Add(simulation.gameObject);
                Play(2);
                simulation.Paused = true;
                Play(1);
                without = Pixels();
                PlantedFoam.Plant(simulation, new Vector3(0, 0.4f, 0));
            }
            Vector4[] builtIn = InTheBuiltInPipeline(1, Plant);
            build();
            Plant();
            Play(1);
            Vector4[] universal = Pixels();
            return (universal.Where((pixel, i) => (pixel - without[i]).magnitude > 0.1f).Count(),
                universal.Where((pixel, i) => (pixel - builtIn[i]).magnitude > 0.1f).Count());
        }

        [Test]
        public void Foam_looks_as_in_the_Built_in_pipeline([Values("14", "17", "17 by Execute")] string version)
        {
            (int changed, int other) = Foam(() => Build(version));
            TestContext.WriteLine($"{changed} pixels of foam, {other} other than in the Built-in pipeline");
            Assert.That(changed, Is.GreaterThan(Width * Height / 50));
            Assert.That(other, Is.LessThan(changed / 10));
        }

        [Test]
        public void The_shadow_of_the_main_light_falls_on_the_water([Values("14", "17")] string version)
        {
            Build(version);
            simulation.GetComponent<FluidSurface>().Preset = SurfacePreset.Milk;
            UnityEngine.Object.FindObjectOfType<Light>().shadows = LightShadows.Hard;
            Play(2);
            simulation.Paused = true;
            Play(1);
            Vector4[] inTheSun = Pixels();
            GameObject roof = GameObject.CreatePrimitive(PrimitiveType.Cube);
            roof.transform.position = new Vector3(0, 4, 0);
            roof.transform.localScale = new Vector3(8, 0.1f, 8);
            roof.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            Play(1);
            Vector4[] inTheShade = Pixels();
            simulation.GetComponent<FluidSurface>().ReceiveShadows = false;
            Play(1);
            Vector4[] receivesNone = Pixels();
            int milk = Width * (Height / 2 - 2) + Width / 2;
            Assert.That(inTheShade[milk].y, Is.LessThan(0.8f * inTheSun[milk].y));
            Assert.That(receivesNone[milk].y, Is.EqualTo(inTheSun[milk].y).Within(0.02f));
        }

        [Test]
        public void A_camera_that_is_not_culled_disturbs_no_later_frame([Values("14", "17")] string version)
        {
            Build(version);
            Play(2);
            camera.rect = new Rect(0, 0, 0, 0);
            Play(1);
            camera.rect = new Rect(0, 0, 1, 1);
            Play(1);
            Vector4[] after = Pixels();
            Assert.That(Errors, Is.Empty);
            Assert.That(Covered(after), Is.GreaterThan(Width * Height / 20));
        }

        [Test]
        public void Nothing_is_enqueued_for_a_camera_that_does_not_see_the_water([Values("14", "17")] string version)
        {
            Build(version);
            camera.transform.rotation = Quaternion.Euler(0, 180, 0);
            Play(2);
            Assert.That(Shader.GetGlobalTexture("_CameraDepthTexture"), Is.SameAs(Texture2D.blackTexture), "no pass asked for depth");
            Assert.That(Errors, Is.Empty);
        }

        // Between the means of 4 x 4 pixels at this scale and at 1, rms; and the width of the surface's textures.
        (float difference, int[] widths) AtScale(float scale, Action build)
        {
            build();
            // Hides the rear of the water.
            GameObject post = GameObject.CreatePrimitive(PrimitiveType.Cube);
            post.transform.localScale = new Vector3(0.5f, 2, 0.3f);
            post.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            Play(2);
            simulation.Paused = true;
            Play(1);
            Vector4[] whole = Pixels();
            Set(pipeline.Asset, "renderScale", scale);
            Play(2);
            Vector4[] drawn = Pixels();
            Assert.That(Errors, Is.Empty);
            FluidSurface surface = simulation.GetComponent<FluidSurface>();
            int[] widths = { (int)((MeshDraw)Get(surface, "meshDraw")).Find(camera).Window.Grid.x };
            Assert.That(Covered(whole), Is.GreaterThan(Width * Height / 20));
            var sums = new Vector4[Width / 4 * (Height / 4)];
            for (int i = 0; i < drawn.Length; i++)
                sums[i / Width / 4 * (Width / 4) + i % Width / 4] += (drawn[i] - whole[i]) / 16;
            return (Mathf.Sqrt(sums.Average(sum => sum.sqrMagnitude)), widths);
        }

        [Test]
        public void It_follows_the_render_scale([Values("14", "17")] string version, [Values(0.5f, 0.97f)] float scale)
        {
            (float difference, int[] widths) = AtScale(scale, () => Build(version));
            TestContext.WriteLine($"{difference:0.0000} rms from a scale of 1");
            Assert.That(widths, Is.EqualTo(new[] { scale < 0.9f ? Width / 2 : Width }), "URP takes 0.97 for 1");
            Assert.That(difference, Is.LessThan(0.025f));
        }

        [Test]
        public void Textures_that_do_not_follow_the_render_scale_are_seen()
        {
            (_, int[] widths) = AtScale(0.5f, () => BuildWithFault("17", "UniversalSurfaces.cs", "? asset.renderScale : 1f;", "? 1f : 1f;"));
            Assert.That(widths, Is.EqualTo(new[] { Width }));
        }

        [Test]
        public void No_component_is_added_to_a_camera([Values("14", "17")] string version)
        {
            Build(version);
            int before = camera.GetComponents<Component>().Length;
            Play(2);
            Assert.That(camera.GetComponents<Component>().Length, Is.EqualTo(before));
        }

        [Test]
        public void A_feature_moves_the_pass_before_others([Values("14", "17")] string version)
        {
            Build(version);
            var feature = (ScriptableObject)ScriptableObject.CreateInstance(pipeline["Rill.Universal"].GetType("Rill.Universal.FluidSurfaceFeature"));
            Set(feature, "StepsBefore", 100);
            Assert.That(Get(feature, "StepsBefore"), Is.EqualTo(49), "clamped");
            object data = ((Array)Get(pipeline.Asset, "m_RendererDataList")).GetValue(0);
            ((System.Collections.IList)Get(data, "rendererFeatures")).Add(feature);
            data.GetType().GetMethod("SetDirty").Invoke(data, null);
            Play(2);
            Assert.That((int)Get(PassOf(camera), "renderPassEvent"), Is.EqualTo(401));
            Assert.That(Errors, Is.Empty);
            Assert.That(Covered(Pixels()), Is.GreaterThan(Width * Height / 20));
        }

        object PassOf(Camera of)
        {
            object parts = pipeline["Rill.Universal"].GetType("Rill.Universal.UniversalSurfaces")
                .GetField("passes", BindingFlags.Static | BindingFlags.NonPublic).GetValue(null);
            return parts.GetType().GetMethod("Find").Invoke(parts, new object[] { of });
        }

        [TestCase("builder.UseTexture(frameData.Get<UniversalResourceData>().cameraDepthTexture);", "",
            "'Rill.Surface' of the render graph has not declared")]
        [TestCase("ScriptableRenderPassInput.Depth | ScriptableRenderPassInput.Color", "ScriptableRenderPassInput.Color",
            "Trying to use an invalid resource (pass Rill.Surface)")]
        [TestCase("DefaultEvent = RenderPassEvent.BeforeRenderingTransparents", "DefaultEvent = RenderPassEvent.AfterRenderingShadows",
            "that nothing has written to yet")]
        public void A_pass_that_reads_what_it_must_not_is_caught(string line, string instead, string words)
        {
            BuildWithFault("17", "SurfacePass.cs", line, instead);
            if (words.Contains("written"))
                Set(pipeline.Asset, "supportsCameraDepthTexture", true);
            LogAssert.Expect(LogType.Exception, new Regex(Regex.Escape(words)));
            Play(1);
        }

        [TestCase("17", "builder.AllowPassCulling(false);", "")]
        [TestCase("17", "renderPassEvent = LastEvent;", "renderPassEvent = RenderPassEvent.AfterRenderingTransparents;")]
        [TestCase("14", "cmd.SetRenderTarget(color, depth == BuiltinRenderTextureType.CameraTarget ? color : depth, 0, " +
            "CubemapFace.Unknown,\n                RenderTargetIdentifier.AllDepthSlices);", "")]
        public void Without_the_line_the_water_is_not_there(string version, string line, string instead)
        {
            BuildWithFault(version, "SurfacePass.cs", line, instead);
            if (version == "17")        // drawn without what the pass would have written
                LogAssert.Expect(LogType.Exception, new Regex("'Rill.Water.Tiles'.*nothing has written it yet"));
            Play(1);        // in a later one, that of the frame before would be
            if (version == "17")
                return;
            Assert.That(Covered(Pixels()), Is.LessThan(Width * Height / 20));
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
            object data = ((Array)Get(pipeline.Asset, "m_RendererDataList")).GetValue(0);
            ((UnityEngine.Object)data).name = "Mobile";
            Set(data, "shadowTransparentReceive", false);
            var inspector = (Rill.Editor.FluidSurfaceEditor)UnityEditor.Editor.CreateEditor(simulation.GetComponent<FluidSurface>());
            UnityEditor.GuiTrace.Clear();
            GuiPasses.Draw(() => inspector.OnInspectorGUI());
            Assert.That(UnityEditor.GuiTrace.HelpBoxes.Select(box => box.text), Has.Some.Contains("'Mobile'"), "the inspector reports it");
            UnityEngine.Object.DestroyImmediate(inspector);
            UnityEditor.GuiTrace.Clear();
            SetupProblem problem = setup.Problems.Single();
            Assert.That(problem.Text, Does.Contain("'Mobile'").And.Contain("Transparent Receive Shadows is off"));
            Assert.That(problem.FixLabel, Is.Not.Null);
            problem.Fix();
            Assert.That(setup.Problems, Is.Empty);
        }
    }
}
