using System.Linq;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>A fluid drawn for two eyes in one pass, held against the same fluid drawn by a camera at each eye.</summary>
    public class StereoTests : GraphicsFixture
    {
        const float FrameTime = 1f / 60f;
        const int Width = 96, Height = 80;      // of an eye

        FluidSimulation fluid;
        Camera camera;
        Light sun;

        [SetUp]
        public void Make()
        {
            Player.ScreenWidth = 2 * Width;
            Player.ScreenHeight = Height;
            Player.Stereo = true;
            fluid = FluidSceneTests.Build("particles and domain drawn");
            camera = Camera.allCameras.Single();
            camera.transform.position = new Vector3(0.3f, 0.8f, -3f);
            camera.transform.LookAt(Vector3.zero);

            sun = new GameObject("Sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.Euler(60, 30, 0);
            GameObject ground = GameObject.CreatePrimitive(PrimitiveType.Plane);
            ground.transform.position = new Vector3(0, -0.9f, 0);
            ground.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader");
        }

        [TearDown]
        public void LookWithOneEye() => Player.Stereo = false;

        [Test]
        public void Each_eye_sees_what_a_camera_there_sees([Values(LightShadows.None, LightShadows.Hard)] LightShadows shadows)
        {
            sun.shadows = shadows;
            DrawFrozenFrame();
            Color32[][] eyes = { Slice(0), Slice(1) };
            Assert.That(Unlike(eyes[0], eyes[1]), Is.GreaterThan(100), "two eyes see two pictures");

            (Matrix4x4[] views, Matrix4x4[] projections) = ((Matrix4x4[])StereoView.Views.Clone(), (Matrix4x4[])StereoView.Projections.Clone());
            for (int eye = 0; eye < 2; eye++)
            {
                // Shadow maps are fitted to what a camera sees: their edges may differ by a texel.
                int allowed = shadows == LightShadows.None ? 0 : Width * Height / 50;
                Assert.That(Unlike(eyes[eye], DrawAlone(views[eye], projections[eye])), Is.LessThanOrEqualTo(allowed), $"pixels of eye {eye}");
            }
        }

        [Test]
        public void Both_eyes_see_the_scene_through_the_water()
        {
            fluid.GetComponent<ParticleRenderer>().enabled = false;
            fluid.gameObject.AddComponent<FluidSurface>();
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.white;
            PlayerLoop.Frame(FrameTime);
            DrawFrozenFrame();
            Color32[][] eyes = { Slice(0), Slice(1) };
            Assert.That(Unlike(eyes[0], eyes[1]), Is.GreaterThan(100), "two eyes see two pictures");
            double[] mean = eyes.Select(eye => eye.Average(pixel => (pixel.r + pixel.g + pixel.b) / 3.0)).ToArray();
            Assert.That(mean[1], Is.EqualTo(mean[0]).Within(0.03 * mean[0]));
        }

        [Test]
        public void Each_eye_sees_water_and_foam_as_a_camera_there_does([Values] bool foam)
        {
            fluid.GetComponent<ParticleRenderer>().enabled = false;
            fluid.gameObject.AddComponent<FluidSurface>();
            if (foam)
                PlantedFoam.Add(fluid.gameObject);
            DrawFrozenFrame();
            Color32[] without = Slice(0);
            if (foam)
                PlantedFoam.Plant(fluid, Vector3.zero);
            PlayerLoop.Frame(FrameTime);
            Color32[][] eyes = { Slice(0), Slice(1) };
            Assert.That(Unlike(eyes[0], eyes[1]), Is.GreaterThan(100), "two eyes see two pictures");
            if (foam)
                Assert.That(Unlike(eyes[0], without), Is.GreaterThan(100), "foam");
            (Matrix4x4[] views, Matrix4x4[] projections) = ((Matrix4x4[])StereoView.Views.Clone(), (Matrix4x4[])StereoView.Projections.Clone());
            int[] unlike = Enumerable.Range(0, 2).Select(eye => Unlike(eyes[eye], DrawAlone(views[eye], projections[eye]))).ToArray();
            TestContext.WriteLine($"{unlike[0]} and {unlike[1]} pixels differ");
            Assert.That(unlike, Has.All.LessThanOrEqualTo(Width * Height / 100));
        }

        [Test]
        public void Each_eye_sees_smoke_as_a_camera_there_does()
        {
            DrawFrozenFrame();
            Color32[] without = Slice(0);
            fluid.Paused = false;
            fluid.gameObject.AddComponent<FluidSmoke>().Ambient = Color.white;
            var source = new GameObject("Fire").AddComponent<FluidSmokeSource>();
            source.transform.parent = fluid.transform;
            source.Radius = 0.3f;
            source.Density = 10f;
            for (int i = 0; i < 6; i++)
                PlayerLoop.Frame(FrameTime);
            DrawFrozenFrame();
            Color32[][] eyes = { Slice(0), Slice(1) };
            Assert.That(Unlike(eyes[0], without), Is.GreaterThan(200), "smoke");
            Assert.That(Unlike(eyes[0], eyes[1]), Is.GreaterThan(100), "two eyes see two pictures");
            (Matrix4x4[] views, Matrix4x4[] projections) = ((Matrix4x4[])StereoView.Views.Clone(), (Matrix4x4[])StereoView.Projections.Clone());
            int[] unlike = Enumerable.Range(0, 2).Select(eye => Unlike(eyes[eye], DrawAlone(views[eye], projections[eye]))).ToArray();
            TestContext.WriteLine($"{unlike[0]} and {unlike[1]} pixels differ");
            Assert.That(unlike, Is.All.EqualTo(0));
        }

        [Test]
        public void The_screen_shows_the_left_eye_on_the_left()
        {
            DrawFrozenFrame();
            var request = UnityEngine.Rendering.AsyncGPUReadback.Request(ScreenTarget.Texture);
            request.WaitForCompletion();
            Color32[] screen = request.GetData<Color32>().ToArray();
            for (int eye = 0; eye < 2; eye++)
                Assert.That(Unlike(Half(screen, eye), Slice(eye)), Is.Zero, $"pixels of eye {eye}");
        }

        [Test]
        public void Two_instances_are_drawn_only_in_frames_in_which_a_camera_draws_two_eyes()
        {
            PlayerLoop.Frame(FrameTime);
            Assert.That(StereoInstancing.IsActive, "two eyes");
            Player.Stereo = false;
            Assert.That(StereoInstancing.IsActive, "one answer for the whole frame");
            PlayerLoop.Frame(FrameTime);
            Assert.That(StereoInstancing.IsActive, Is.False, "no headset");
            Player.Stereo = true;
            PlayerLoop.Frame(FrameTime);
            Assert.That(StereoInstancing.IsActive, "two eyes again");
            camera.enabled = false;
            PlayerLoop.Frame(FrameTime);
            Assert.That(StereoInstancing.IsActive, Is.False, "no camera");
        }

        [Test]
        public void A_camera_with_one_eye_beside_one_with_two_sees_what_it_sees_alone()
        {
            var other = new GameObject("Other").AddComponent<Camera>();
            other.transform.SetPositionAndRotation(camera.transform.position, camera.transform.rotation);
            other.targetTexture = new RenderTexture(Width, Height, GraphicsFormat.R8G8B8A8_SRGB, GraphicsFormat.D32_SFloat);
            DrawFrozenFrame();
            Assert.That(StereoInstancing.IsActive);
            Color32[] beside = Read(other.targetTexture, 0);
            camera.enabled = false;
            PlayerLoop.Frame(FrameTime);
            Assert.That(StereoInstancing.IsActive, Is.False);
            Color32[] alone = Read(other.targetTexture, 0);
            other.targetTexture.Release();

            Assert.That(alone.Distinct().Count(), Is.GreaterThan(100), "a picture");
            Assert.That(Unlike(beside, alone), Is.Zero);
        }

        [Test]
        public void The_draw_of_two_eyes_has_the_particles_of_the_draw_of_one()
        {
            PlayerLoop.Frame(FrameTime);
            var arguments = new uint[12];
            fluid.Solver.DrawArguments.GetData(arguments);
            uint vertices = 512 * GpuBuffer.VerticesPerParticle;
            Assert.That(arguments.Skip(4 * StereoInstancing.MonoCommand).Take(4), Is.EqualTo(new[] { vertices, 1u, 0u, 0u }));
            Assert.That(arguments.Skip(4 * StereoInstancing.StereoCommand).Take(4), Is.EqualTo(new[] { vertices, 2u, 0u, 0u }));
        }

        // The fluid stands still from here on, so that it can be drawn again.
        void DrawFrozenFrame()
        {
            PlayerLoop.Frame(FrameTime);
            PlayerLoop.Frame(FrameTime);
            fluid.Paused = true;
            PlayerLoop.Frame(FrameTime);
            PlayerLoop.Frame(FrameTime);
        }

        Color32[] DrawAlone(Matrix4x4 view, Matrix4x4 projection)
        {
            camera.targetTexture = new RenderTexture(Width, Height, StereoView.Eyes.graphicsFormat, StereoView.Eyes.depthStencilFormat);
            camera.transform.position = view.inverse.MultiplyPoint3x4(Vector3.zero);
            camera.worldToCameraMatrix = view;
            camera.projectionMatrix = projection;
            PlayerLoop.Frame(FrameTime);
            Assert.That(StereoInstancing.IsActive, Is.False);
            Color32[] seen = Read(camera.targetTexture, 0);
            camera.targetTexture.Release();
            camera.targetTexture = null;
            return seen;
        }

        static Color32[] Slice(int eye) => Read(StereoView.Eyes, eye);

        static Color32[] Read(RenderTexture texture, int slice)
        {
            var request = UnityEngine.Rendering.AsyncGPUReadback.Request(texture, 0, 0, Width, 0, Height, slice, 1);
            request.WaitForCompletion();
            return request.GetData<Color32>().ToArray();
        }

        static Color32[] Half(Color32[] screen, int eye)
            => Enumerable.Range(0, Width * Height).Select(i => screen[i / Width * 2 * Width + eye * Width + i % Width]).ToArray();

        static int Unlike(Color32[] a, Color32[] b)
            => a.Zip(b, (x, y) => System.Math.Abs(x.r - y.r) > 2 || System.Math.Abs(x.g - y.g) > 2 || System.Math.Abs(x.b - y.b) > 2)
            .Count(unlike => unlike);
    }
}
