using System;
using System.Linq;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>HDRP's motion vectors hold the water's own motion and the camera's where HDRP draws some, and cost nothing elsewhere.</summary>
    public class HighDefinitionMotionTests : SurfaceMotionFixture
    {
        const string Space = "UnityEngine.Rendering.HighDefinition.";

        private protected override string MotionTexture => "_CameraMotionVectorsTexture";

        private protected override float[] Depth(int eye)
        {
            var water = ((MeshDraw)Get(Surface, "meshDraw")).Find(camera);
            RenderTexture faces = water.Faces;
            float[] channels = Floats(faces, eye, faces.width, faces.height);
            return water.Window.Whole(channels.Where((_, i) => i % 4 == 0).ToArray(), faces.width);
        }

        FluidSurface Surface => simulation.GetComponent<FluidSurface>();

        Type TypeOf(string name) => pipeline[PipelineKind.HighDefinition.Assembly].GetType(Space + name, true);

        void BuildFor(string version, bool isJittered = true)
        {
            Build(PipelineKind.HighDefinition, version);
            MakePicture();
            if (isJittered)
                Jitter();
        }

        // Temporal antialiasing.
        void Jitter()
        {
            object data = camera.gameObject.AddComponent(TypeOf("HDAdditionalCameraData"));
            Set(data, "antialiasing", Enum.ToObject(TypeOf("HDAdditionalCameraData+AntialiasingMode"), 2));
        }

        [TestCase("14", 60)]
        [TestCase("17", 60)]
        [TestCase("17.4", 60)]
        [TestCase("17", 144)]
        public void Falling_water_moves_by_what_it_fell(string version, int rate)
        {
            BuildFor(version);
            (float worst, float largest, int pixels) = Fall(rate);
            Assert.That(Errors, Is.Empty);
            Assert.That(pixels, Is.GreaterThan(5000));
            Assert.That(largest, Is.GreaterThan(100f / rate), "it falls");
            Assert.That(worst, Is.LessThan(Bar));
        }

        (float worst, float largest, int pixels) LookElsewhere()
        {
            PlayMore(4);
            simulation.Paused = true;
            PlayMore(1);
            Matrix4x4 last = WorldToClip;
            MoveCamera();
            PlayMore(1);
            return Compare(last, world => world);
        }

        [Test]
        public void Water_that_is_paused_moves_with_a_camera_that_turns_and_goes_on_alone([Values("14", "17")] string version)
        {
            BuildFor(version);
            (float worst, float largest, int pixels) = LookElsewhere();
            Assert.That(pixels, Is.GreaterThan(5000));
            Assert.That(largest, Is.GreaterThan(3f), "it moves");
            Assert.That(worst, Is.LessThan(Bar));
        }

        [Test]
        public void The_motion_is_where_the_water_is_and_nowhere_else([Values("14", "17")] string version)
        {
            BuildFor(version, isJittered: false);
            Fall(60);
            float[] depth = Depth(0);
            Vector2[] motion = Motion();
            Assert.That(Enumerable.Range(0, motion.Length).Count(i => (depth[i] > 0) != (motion[i] != Vector2.zero)),
                Is.LessThan(motion.Length / 500));
        }

        [Test]
        public void What_stands_in_front_of_the_water_keeps_its_own_motion([Values("14", "17")] string version)
        {
            BuildFor(version);
            GameObject post = GameObject.CreatePrimitive(PrimitiveType.Cube);
            post.transform.position = new Vector3(0, 0.3f, -1.5f);
            post.transform.localScale = new Vector3(0.2f, 2f, 0.2f);
            post.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            PlayMore(7);
            Assert.That(Errors, Is.Empty);
            Vector2[] motion = Motion();
            int row = High / 2 * Wide;
            Assert.That(motion[row + Wide / 2].magnitude, Is.LessThan(0.01f), "the post stands still");
            Assert.That(motion[row + Wide / 2 - 25].magnitude, Is.GreaterThan(2f), "the water beside it falls");
        }

        [Test]
        public void Where_HDRP_draws_none_there_is_no_pass_and_no_texture([Values("14", "17")] string version,
            [Values("the camera", "the asset")] string by)
        {
            BuildFor(version, isJittered: false);
            if (by == "the camera")
            {
                object data = camera.gameObject.AddComponent(TypeOf("HDAdditionalCameraData")), settings = Get(data, "own");
                settings.GetType().GetMethod("SetEnabled").Invoke(settings, new[] { Enum.ToObject(TypeOf("FrameSettingsField"), 10), false });
                Set(data, "own", settings);
                Set(data, "customRenderingSettings", true);
            }
            else
            {
                object settings = Get(pipeline.Asset, "currentPlatformRenderPipelineSettings");
                settings.GetType().GetField("supportMotionVectors").SetValue(settings, false);
                Set(pipeline.Asset, "currentPlatformRenderPipelineSettings", settings);
            }
            PlayMore(4);
            Assert.That(Errors, Is.Empty);
            StageDescription description = Surface.Describe();
            Assert.That(description.Buffers.Select(buffer => buffer.name), Has.None.EqualTo(Chords));
            Assert.That(description.Kernels.Select(kernel => kernel.kernel), Has.None.Contains("SurfaceMotion"));
            Assert.That(description.Buffers.Select(buffer => buffer.name), Has.Some.EqualTo("Rill.Water.RayFaces"), "there is water");
            Assert.That(Shader.GetGlobalTexture(MotionTexture).name, Is.EqualTo("_BlackTexture"));
        }

        [TestCase("SurfacePass.cs", "if (views.needsMotion)", "if (views.eyes == 0)", TestName = "In_HDRP_motion_that_is_not_drawn_is_seen")]
        [TestCase("SurfacePass.cs", "ctx.cmd.SetViewport(new Rect(0f, 0f, views.width, views.height));", "",
            TestName = "In_HDRP_motion_all_over_the_texture_is_seen")]
        [TestCase("SurfaceVolume.cs", "CustomPassInjectionPoint.BeforePreRefraction", "CustomPassInjectionPoint.BeforeRendering",
            TestName = "In_HDRP_motion_before_HDRPs_own_is_seen")]
        public void A_fault_in_the_adapter_is_seen(string file, string line, string instead)
        {
            BuildWithFault(PipelineKind.HighDefinition, "17", file, line, instead);
            MakePicture();
            Assert.That(LookElsewhere().worst, Is.GreaterThan(2 * Bar));
        }

        [Test]
        public void Each_eye_has_the_motion_that_it_sees([Values("14", "17")] string version)
        {
            BuildFor(version, isJittered: false);
            PutOnHeadset();
            AssertEachEyeHasTheMotionThatItSees();
            Assert.That(Errors, Is.Empty);
        }
    }
}
