using System;
using System.Linq;
using System.Text.RegularExpressions;
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
    /// <summary>URP's motion vectors hold the water's own motion and the camera's where something asks for them, and cost nothing elsewhere.</summary>
    public class UniversalMotionTests : UniversalSurfaceFixture
    {
        const int Wide = 384, High = 256;
        const float FrameTime = 1f / 30f;
        const float Bar = 0.25f;        // pixels
        const string Chords = "Rill.Surface.Chords";

        RenderTexture picture;

        [TearDown]
        public void ReleasePicture()
        {
            if (picture != null)
                picture.Release();
            picture = null;
        }

        void BuildFor(string version, bool asks = true)
        {
            Build(version);
            camera.targetTexture = picture = new RenderTexture(Wide, High, GraphicsFormat.R16G16B16A16_SFloat, GraphicsFormat.D32_SFloat);
            if (asks)
                AskForMotion();
        }

        // As temporal antialiasing does, with its jitter.
        void AskForMotion()
        {
            Type type = pipeline.Asset.GetType().Assembly.GetType("UnityEngine.Rendering.Universal.UniversalAdditionalCameraData");
            Component data = camera.GetComponent(type) ?? camera.gameObject.AddComponent(type);
            Set(data, "renderPostProcessing", true);
            Set(data, "antialiasing", Enum.ToObject(data.GetType().GetProperty("antialiasing").PropertyType, 3));
        }

        static void PlayMore(int frames, float time = FrameTime)
        {
            for (int i = 0; i < frames; i++)
                PlayerLoop.Frame(time);
        }

        // In pixels, x to the right and y up; row by row from the bottom.
        static Vector2[] Motion()
        {
            var request = AsyncGPUReadback.Request(Shader.GetGlobalTexture("_MotionVectorTexture"));
            request.WaitForCompletion();
            ushort[] halves = request.GetData<ushort>().ToArray();
            return Enumerable.Range(0, Wide * High).Select(i => new Vector2(Mathf.HalfToFloat(halves[2 * i]) * Wide, Mathf.HalfToFloat(halves[2 * i + 1]) * High)).ToArray();
        }

        // The device's depth of scene and water together.
        static float[] Depth()
        {
            var request = AsyncGPUReadback.Request(Shader.GetGlobalTexture("_MotionVectorDepthTexture"));
            request.WaitForCompletion();
            return request.GetData<float>().ToArray();
        }

        Matrix4x4 WorldToClip => camera.projectionMatrix * camera.worldToCameraMatrix;

        // Reversed depth at the middle of a pixel, without the jitter of the frame.
        Vector3 WorldAt(int pixel, float depth)
        {
            Vector4 world = WorldToClip.inverse * new Vector4((pixel % Wide + 0.5f) / Wide * 2 - 1, (pixel / Wide + 0.5f) / High * 2 - 1, 1 - 2 * depth, 1);
            return (Vector3)world / world.w;
        }

        static Vector2 ToPixels(Matrix4x4 worldToClip, Vector3 world)
        {
            Vector4 clip = worldToClip * new Vector4(world.x, world.y, world.z, 1);
            return new Vector2((clip.x / clip.w * 0.5f + 0.5f) * Wide, (clip.y / clip.w * 0.5f + 0.5f) * High);
        }

        // Where the water alone stands: nothing else is as near as its box.
        bool IsWater(Vector3 world) => Mathf.Abs(world.x) < 0.85f && world.y > -0.79f && Mathf.Abs(world.z) < 0.85f;

        // How far off the drawn motion is, at worst; each pixel of the water came from where "before" says.
        (float worst, float largest, int pixels) Compare(Matrix4x4 lastWorldToClip, Func<Vector3, Vector3> before)
        {
            Vector2[] motion = Motion();
            float[] depth = Depth();
            float worst = 0, largest = 0;
            int pixels = 0;
            for (int i = 0; i < motion.Length; i++)
            {
                Vector3 world = WorldAt(i, depth[i]);
                if (depth[i] == 0 || !IsWater(world))
                    continue;
                pixels++;
                Vector2 expected = ToPixels(WorldToClip, world) - ToPixels(lastWorldToClip, before(world));
                worst = Mathf.Max(worst, (motion[i] - expected).magnitude);
                largest = Mathf.Max(largest, expected.magnitude);
            }
            TestContext.Out.WriteLine($"{pixels} pixels of water, motion up to {largest:F2} pixels, at worst {worst:F3} off");
            return (worst, largest, pixels);
        }

        // Of all particles as they are drawn, world.
        Vector3 MeanPosition()
        {
            PbfSolver solver = simulation.Solver;
            var counters = new uint[solver.Counters.count];
            solver.Counters.GetData(counters);
            var now = new float4[counters[(int)ParticleCounter.Alive]];
            var start = new float4[now.Length];
            solver.Positions.GetData(now, 0, 0, now.Length);
            solver.StartPositions.GetData(start, 0, 0, now.Length);
            float lag = simulation.FrameLag.x;
            float3 sum = 0;
            for (int i = 0; i < now.Length; i++)
                sum += now[i].xyz + (now[i].xyz - start[i].xyz) * lag;
            return simulation.DomainToWorld.MultiplyPoint3x4(sum / now.Length);
        }

        // At 30 frames a second there are two steps in a frame, of which the second alone is known: what falls has come g (1/60 s)^2, 2.7 mm, less far.
        [TestCase("17", 60, Bar)]
        [TestCase("17.3", 60, Bar)]
        [TestCase("17 by Execute", 60, Bar)]
        [TestCase("14", 60, Bar)]
        [TestCase("17", 45, Bar)]
        [TestCase("17", 144, Bar)]
        [TestCase("17", 30, Bar + 0.1f)]
        public void Falling_water_moves_by_what_it_fell(string version, int rate, float bar)
        {
            BuildFor(version);
            // Well above the floor, which slows the lowest first.
            PlayMore((int)(rate * 0.15f), 1f / rate);
            Vector3 before = MeanPosition();
            PlayMore(1, 1f / rate);
            Vector3 fallen = MeanPosition() - before;
            (float worst, float largest, int pixels) = Compare(WorldToClip, world => world - fallen);
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
            Assert.That(motion[row + Wide / 2 - 50].magnitude, Is.GreaterThan(2f), "the water beside it falls");
        }

        [Test]
        public void Where_nobody_asks_there_is_no_pass_and_no_texture([Values("14", "17", "17 by Execute", "17.3")] string version)
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
            AskForMotion();
            PlayMore(2);
            StageDescription description = simulation.GetComponent<FluidSurface>().Describe();
            Assert.That(description.Buffers.Select(buffer => buffer.name), Has.Some.EqualTo(Chords));
            Assert.That(Motion().Max(motion => motion.magnitude), Is.GreaterThan(1f));
        }

        [TestCase("builder.UseTexture(motion, AccessFlags.Write);", "builder.AllowPassCulling(false);", "(_MotionVectorTexture) that the pass 'Rill.Surface.Motion' has not declared")]
        [TestCase("builder.UseTexture(motionDepth, AccessFlags.Write);", "", "(_MotionVectorDepthTexture) that the pass 'Rill.Surface.Motion' has not declared")]
        public void A_pass_that_draws_on_what_it_has_not_declared_is_caught(string line, string instead, string words)
        {
            BuildWithFault("17", "SurfacePass.cs", line, instead);
            AskForMotion();
            PlayMore(1);
            LogAssert.Expect(LogType.Exception, new Regex(Regex.Escape(words)));
            PlayMore(1);
        }
    }
}
