using System;
using System.Linq;
using System.Text.RegularExpressions;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>URP's motion vectors hold the water's own motion and the camera's where something asks for them, and cost nothing
    /// elsewhere.</summary>
    public class UniversalMotionTests : SurfaceMotionFixture
    {
        private protected override string MotionTexture => "_MotionVectorTexture";

        // The device's depth of scene and water together.
        private protected override float[] Depth(int eye) => Floats(Shader.GetGlobalTexture("_MotionVectorDepthTexture"), eye);

        void BuildFor(string version, bool asks = true)
        {
            Build(PipelineKind.Universal, version);
            MakePicture();
            if (asks)
                RequestMotion();
        }

        // Requests motion like temporal antialiasing, with its jitter.
        void RequestMotion()
        {
            Type type = pipeline.Asset.GetType().Assembly.GetType("UnityEngine.Rendering.Universal.UniversalAdditionalCameraData");
            Component data = camera.GetComponent(type) ?? camera.gameObject.AddComponent(type);
            Set(data, "renderPostProcessing", true);
            Set(data, "antialiasing", Enum.ToObject(data.GetType().GetProperty("antialiasing").PropertyType, 3));
        }

        // At 30 frames a second there are two steps in a frame, of which the second alone is known: what falls has come g (1/60 s)^2, 2.7
        // mm, less far.
        [TestCase("17", 60, Bar)]
        [TestCase("17.3", 60, Bar)]
        [TestCase("17 by Execute", 60, Bar)]
        [TestCase("14", 60, Bar)]
        [TestCase("17", 45, Bar)]
        [TestCase("17", 144, Bar)]
        [TestCase("17", 30, Bar + 0.15f)]
        public void Falling_water_moves_by_what_it_fell(string version, int rate, float bar)
        {
            BuildFor(version);
            (float worst, float largest, int pixels) = Fall(rate);
            Assert.That(Errors, Is.Empty);
            Assert.That(pixels, Is.GreaterThan(5000));
            Assert.That(largest, Is.GreaterThan(100f / rate), "it falls");
            Assert.That(worst, Is.LessThan(bar));
        }

        [Test]
        public void Water_that_is_paused_moves_with_a_turning_camera_alone([Values("14", "17", "17 by Execute")] string version)
        {
            BuildFor(version);
            PlayMore(4);
            simulation.Paused = true;
            PlayMore(1);
            Matrix4x4 last = WorldToClip;
            camera.transform.rotation *= Quaternion.Euler(0.5f, 1.5f, 0);
            PlayMore(1);
            (float worst, float largest, int pixels) = Compare(last, world => world);
            Assert.That(pixels, Is.GreaterThan(5000));
            Assert.That(largest, Is.GreaterThan(3f), "it turns");
            Assert.That(worst, Is.LessThan(Bar));
        }

        [Test]
        public void A_domain_carries_its_water_and_a_camera_that_goes_along_sees_no_motion([Values("14", "17")] string version)
        {
            BuildFor(version);
            PlayMore(4);
            simulation.Paused = true;
            PlayMore(1);
            var step = new Vector3(0.05f, 0.02f, 0);
            simulation.transform.position += step;
            PlayMore(1);
            (float worst, float largest, int pixels) = Compare(WorldToClip, world => world - step);
            Assert.That(largest, Is.GreaterThan(3f), "the domain moves");
            Assert.That(worst, Is.LessThan(Bar));

            Matrix4x4 last = WorldToClip;
            simulation.transform.position += step;
            camera.transform.position += step;
            PlayMore(1);
            (worst, _, pixels) = Compare(last, world => world - step);
            Assert.That(worst, Is.LessThan(0.02f), "camera and domain together");
            Assert.That(pixels, Is.GreaterThan(5000));
        }

        [Test]
        public void Each_eye_has_the_motion_that_it_sees([Values("14", "17", "17 by Execute", "17.3")] string version)
        {
            BuildFor(version);
            PutOnHeadset();
            AssertEachEyeHasTheMotionThatItSees();
            Assert.That(Errors, Is.Empty);
        }

        [Test]
        public void What_stands_in_front_of_the_water_keeps_its_own_motion([Values("14", "17")] string version)
        {
            BuildFor(version);
            GameObject post = GameObject.CreatePrimitive(PrimitiveType.Cube);
            post.transform.position = new Vector3(0, 0.3f, -1.5f);
            post.transform.localScale = new Vector3(0.2f, 2f, 0.2f);
            post.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            // The host knows no object's matrix of the frame before.
            Shader.SetGlobalMatrix("unity_MatrixPreviousM", post.transform.localToWorldMatrix);
            PlayMore(7);
            Vector2[] motion = Motion();
            int row = High / 2 * Wide;
            Assert.That(motion[row + Wide / 2].magnitude, Is.LessThan(0.01f), "the post stands still");
            Assert.That(motion[row + Wide / 2 - 25].magnitude, Is.GreaterThan(2f), "the water beside it falls");
        }

        [Test]
        public void Where_no_one_asks_there_is_no_pass_and_no_texture([Values("14", "17", "17 by Execute", "17.3")] string version)
        {
            BuildFor(version, asks: false);
            PlayMore(3);
            StageDescription description = simulation.GetComponent<FluidSurface>().Describe();
            Assert.That(description.Buffers.Select(buffer => buffer.name), Has.None.EqualTo(Chords));
            Assert.That(description.Kernels.Select(kernel => kernel.kernel), Has.None.Contains("SurfaceMotion"));
            Assert.That(camera.depthTextureMode & DepthTextureMode.MotionVectors, Is.EqualTo(DepthTextureMode.None));
            Assert.That(Shader.GetGlobalTexture("_MotionVectorTexture"), Is.Null, "URP draws none");
        }

        [Test]
        public void What_is_asked_for_later_is_drawn_then([Values("14", "17", "17 by Execute")] string version)
        {
            BuildFor(version, asks: false);
            PlayMore(3);
            RequestMotion();
            PlayMore(2);
            StageDescription description = simulation.GetComponent<FluidSurface>().Describe();
            Assert.That(description.Buffers.Select(buffer => buffer.name), Has.Some.EqualTo(Chords));
            Assert.That(Motion().Max(motion => motion.magnitude), Is.GreaterThan(1f));
        }

        [TestCase("builder.UseTexture(motion, AccessFlags.Write);", "builder.AllowPassCulling(false);",
            "(_MotionVectorTexture) that the pass 'Rill.Surface.Motion' has not declared")]
        [TestCase("builder.UseTexture(motionDepth, AccessFlags.Write);", "",
            "(_MotionVectorDepthTexture) that the pass 'Rill.Surface.Motion' has not declared")]
        public void A_pass_that_draws_on_what_it_has_not_declared_is_caught(string line, string instead, string words)
        {
            BuildWithFault(PipelineKind.Universal, "17", "SurfacePass.cs", line, instead);
            RequestMotion();
            PlayMore(1);
            LogAssert.Expect(LogType.Exception, new Regex(Regex.Escape(words)));
            PlayMore(1);
        }
    }
}
