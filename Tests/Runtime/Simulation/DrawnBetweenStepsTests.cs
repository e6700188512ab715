using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>View of a single particle by a camera while frames and steps differ.</summary>
    public class DrawnBetweenStepsTests
    {
        const int Width = 512, Height = 256;
        const float PixelsPerMeter = 256f, Spacing = 0.05f;
        static readonly Vector3 Box = new Vector3(2f, 1f, 1f);

        FluidSimulation fluid;
        Camera camera;
        RenderTexture target;
        double addedTime;           // FluidTime when the particle was added, s
        double drawnTime;           // FrameTime when the camera had drawn, s
        int drawnFrames;
        readonly List<double> times = new List<double>();       // of the frames looked at, s
        readonly List<float> seen = new List<float>();          // the particle's x in them, m

        [SetUp]
        public void Make()
        {
            target = new RenderTexture(Width, Height, 24);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 0f, -5f);
            camera.orthographic = true;
            camera.orthographicSize = 0.5f * Height / PixelsPerMeter;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.targetTexture = target;
            Camera.onPostRender += Remember;

            var gameObject = new GameObject("Fluid");
            gameObject.SetActive(false);
            fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(Box, Spacing, 100);
            fluid.Gravity = Vector3.zero;
            fluid.StatisticsInterval = 0;
            gameObject.AddComponent<ParticleRenderer>();
            gameObject.SetActive(true);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Camera.onPostRender -= Remember;
            Time.captureDeltaTime = 0f;
            Object.Destroy(fluid.gameObject);
            Object.Destroy(camera.gameObject);
            times.Clear();
            seen.Clear();
            yield return null;
            target.Release();
        }

        void Remember(Camera drawn)
        {
            if (drawn != camera)
                return;
            drawnTime = fluid.FrameTime;
            drawnFrames++;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Water_is_drawn_at_the_time_of_each_frame([Values(50, 60, 75, 120, 144)] int rate, [Values(1, 3)] int substeps)
        {
            const float speed = 2f;
            SetSubsteps(substeps);
            AddParticle(new Vector3(-0.8f, 0f, 0f), new Vector3(speed, 0f, 0f));
            yield return Frames(20, rate);
            Assert.That(fluid.StepCount, Is.GreaterThan(5));
            for (int frame = 0; frame < seen.Count; frame++)
                Assert.That(seen[frame], Is.EqualTo(-0.8 + speed * (times[frame] - addedTime)).Within(0.3f / PixelsPerMeter),
                    $"frame {frame} at {times[frame]} s");
            Assert.That(times.Last() - times[2], Is.EqualTo((times.Count - 3.0) / rate).Within(1e-5), "the rate of the frames");
        }

        [UnityTest]
        public IEnumerator A_particle_goes_on_along_its_path_whatever_its_velocity_became()
        {
            AddParticle(new Vector3(-0.8f, 0f, 0f), new Vector3(2f, 0f, 0f));
            yield return Frames(3, 120);
            while (fluid.FrameTime <= fluid.FluidTime)
                yield return Frames(1, 120);
            fluid.Paused = true;        // between two steps
            fluid.Solver.Velocities.SetData(new[] { new float4(0f, 0f, 0f, 1f) });
            yield return Frames(2, 120);
            Assert.That(times.Last(), Is.GreaterThan(fluid.FluidTime));
            Assert.That(seen.Last(), Is.EqualTo(-0.8 + 2.0 * (times.Last() - addedTime)).Within(0.3f / PixelsPerMeter));
        }

        [UnityTest]
        public IEnumerator A_particle_that_came_since_the_last_step_goes_on_with_its_velocity()
        {
            Time.captureDeltaTime = 1f / 200f;
            yield return null;      // the frame in which a test begins is longer, and takes a step at its end
            AddParticle(new Vector3(-0.5f, 0f, 0f), new Vector3(6f, 0f, 0f));
            yield return Frames(1, 200);
            yield return Frames(1, 200);
            Assert.That(fluid.FluidTime, Is.EqualTo(addedTime), "no step");
            Assert.That(times.Last(), Is.GreaterThan(addedTime));
            Assert.That(seen.Last(), Is.EqualTo(-0.5 + 6.0 * (times.Last() - addedTime)).Within(0.3f / PixelsPerMeter));
        }

        [UnityTest]
        public IEnumerator Water_that_meets_a_wall_is_not_drawn_beyond_it()
        {
            AddParticle(new Vector3(0.5f, 0f, 0f), new Vector3(8f, 0f, 0f));
            yield return Frames(16, 130);
            float wall = 0.5f * Box.x - 0.5f * Spacing;
            Assert.That(seen.Max(), Is.EqualTo(wall).Within(0.3f / PixelsPerMeter));
        }

        [UnityTest]
        public IEnumerator Paused_water_stands_where_it_was_drawn_last()
        {
            AddParticle(new Vector3(-0.8f, 0f, 0f), new Vector3(2f, 0f, 0f));
            yield return Frames(5, 144);
            fluid.Paused = true;
            yield return Frames(2, 144);
            float before = seen.Last();
            yield return Frames(3, 144);
            Assert.That(seen.Last(), Is.EqualTo(before).Within(1e-6f));
            Vector4 lag = fluid.Clock.FrameLag;
            Assert.That(lag.x, Is.EqualTo(lag.z), "no motion between the two frames");
        }

        [UnityTest]
        public IEnumerator The_frame_before_lies_a_frame_back_on_the_same_path()
        {
            AddParticle(Vector3.zero, Vector3.zero);
            var lags = new List<float>();
            yield return Frames(2, 144);
            for (int frame = 0; frame < 12; frame++)
            {
                yield return Frames(1, 144);
                Vector4 lag = fluid.Clock.FrameLag;
                Assert.That(lag.y - lag.w, Is.EqualTo(1.0 / 144.0).Within(1e-6), $"frame {frame}");
                Assert.That(lag.y, Is.EqualTo(fluid.FrameTime - fluid.FluidTime).Within(1e-6));
                lags.Add(lag.y);
            }
            Assert.That(lags.Max() - lags.Min(), Is.GreaterThan(0.5f / 60f), "it varies");
        }

        IEnumerator Frames(int count, int rate)
        {
            Time.captureDeltaTime = 1f / rate;
            for (int frame = 0; frame < count; frame++)
            {
                int before = drawnFrames;
                while (drawnFrames == before)       // the frame in which a test begins may be drawn or not
                    yield return null;
                times.Add(drawnTime);
                seen.Add(CenterOfLight());
            }
        }

        void SetSubsteps(int substeps)
        {
            SolverSettings settings = fluid.Settings;
            settings.substeps = substeps;
            fluid.Settings = settings;
        }

        void AddParticle(Vector3 position, Vector3 velocity)
        {
            addedTime = fluid.FluidTime;
            using (var positions = new NativeArray<float3>(new float3[] { position }, Allocator.Temp))
            using (var velocities = new NativeArray<float3>(new float3[] { velocity }, Allocator.Temp))
                fluid.AddParticles(positions, velocities);
        }

        float CenterOfLight()
        {
            RenderTexture.active = target;
            var picture = new Texture2D(Width, Height, TextureFormat.RGBA32, false);
            picture.ReadPixels(new Rect(0, 0, Width, Height), 0, 0);
            RenderTexture.active = null;
            Color32[] pixels = picture.GetPixels32();
            Object.Destroy(picture);
            double sum = 0.0;
            int lit = 0;
            for (int i = 0; i < pixels.Length; i++)
                if (pixels[i].b > 0)
                {
                    sum += i % Width + 0.5;
                    lit++;
                }
            Assert.That(lit, Is.GreaterThan(50), "pixels of the particle");
            return (float)(sum / lit - 0.5 * Width) / PixelsPerMeter;
        }
    }
}
