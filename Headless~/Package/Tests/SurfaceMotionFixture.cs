using System;
using System.Linq;
using NUnit.Framework;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>The motion vectors of water that a pipeline's stand-in draws, against where the water was the frame before.</summary>
    public abstract class SurfaceMotionFixture : PipelineSurfaceFixture
    {
        private protected const int Wide = 384, High = 256;
        private protected const float FrameTime = 1f / 30f;
        private protected const float Bar = 0.25f;        // pixels

        RenderTexture picture;

        [TearDown]
        public void ReleasePicture()
        {
            Player.Stereo = false;
            if (picture != null)
                picture.Release();
            picture = null;
        }

        /// <summary>The texture of the water's displacements.</summary>
        private protected const string Chords = "Rill.Water.Chords";

        /// <summary>The pipeline's, a global.</summary>
        private protected abstract string MotionTexture { get; }

        /// <summary>Reversed, of the water at least; 0 where there is none.</summary>
        private protected abstract float[] Depth(int eye);

        private protected void MakePicture() => camera.targetTexture = picture = new RenderTexture(Wide, High,
            GraphicsFormat.R16G16B16A16_SFloat, GraphicsFormat.D32_SFloat);

        private protected void PutOnHeadset()
        {
            (Player.ScreenWidth, Player.ScreenHeight, Player.Stereo) = (2 * Wide, High, true);
            camera.targetTexture = null;
        }

        private protected static void PlayMore(int frames, float time = FrameTime)
        {
            for (int i = 0; i < frames; i++)
                PlayerLoop.Frame(time);
        }

        /// <summary>In pixels, x to the right and y up; row by row from the bottom.</summary>
        private protected Vector2[] Motion(int eye = 0)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(Shader.GetGlobalTexture(MotionTexture), 0, 0, Wide, 0, High, eye, 1);
            request.WaitForCompletion();
            ushort[] halves = request.GetData<ushort>().ToArray();
            return Enumerable.Range(0, Wide * High)
                .Select(i => new Vector2(Mathf.HalfToFloat(halves[2 * i]) * Wide, Mathf.HalfToFloat(halves[2 * i + 1]) * High)).ToArray();
        }

        private protected static float[] Floats(Texture texture, int eye, int width = Wide, int height = High)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture, 0, 0, width, 0, height, eye, 1);
            request.WaitForCompletion();
            return request.GetData<float>().ToArray();
        }

        private protected Matrix4x4 WorldToClip => camera.projectionMatrix * camera.worldToCameraMatrix;

        /// <summary>Without jitter, of this frame; to be asked before the headset is put down.</summary>
        private protected static Matrix4x4 WorldToClipOf(int eye) => StereoView.Projections[eye] * StereoView.Views[eye];

        // Reversed depth at the center of a pixel, without the jitter of the frame.
        static Vector3 WorldAt(in Matrix4x4 clipToWorld, int pixel, float depth)
        {
            Vector4 world = clipToWorld * new Vector4((pixel % Wide + 0.5f) / Wide * 2 - 1, (pixel / Wide + 0.5f) / High * 2 - 1, 1 - 2 * depth, 1);
            return (Vector3)world / world.w;
        }

        static Vector2 ToPixels(Matrix4x4 worldToClip, Vector3 world)
        {
            Vector4 clip = worldToClip * new Vector4(world.x, world.y, world.z, 1);
            return new Vector2((clip.x / clip.w * 0.5f + 0.5f) * Wide, (clip.y / clip.w * 0.5f + 0.5f) * High);
        }

        // Tells where the water alone stands: nothing else is as near as its box.
        static bool IsWater(Vector3 world) => Mathf.Abs(world.x) < 0.85f && world.y > -0.79f && Mathf.Abs(world.z) < 0.85f;

        private protected (float worst, float largest, int pixels) Compare(in Matrix4x4 lastWorldToClip, Func<Vector3, Vector3> before)
            => Compare(WorldToClip, lastWorldToClip, before);

        /// <summary>How far off the drawn motion is, at worst; each pixel of the water came from where "before" says.</summary>
        private protected (float worst, float largest, int pixels) Compare(in Matrix4x4 worldToClip, in Matrix4x4 lastWorldToClip,
            Func<Vector3, Vector3> before, int eye = 0)
        {
            Vector2[] motion = Motion(eye);
            float[] depth = Depth(eye);
            Matrix4x4 clipToWorld = worldToClip.inverse;
            float worst = 0, largest = 0;
            int pixels = 0;
            for (int i = 0; i < motion.Length; i++)
            {
                Vector3 world = WorldAt(clipToWorld, i, depth[i]);
                if (depth[i] == 0 || !IsWater(world))
                    continue;
                pixels++;
                Vector2 expected = ToPixels(worldToClip, world) - ToPixels(lastWorldToClip, before(world));
                worst = Mathf.Max(worst, (motion[i] - expected).magnitude);
                largest = Mathf.Max(largest, expected.magnitude);
            }
            TestContext.Out.WriteLine($"{pixels} pixels of water, motion up to {largest:F2} pixels, at worst {worst:F3} off");
            return (worst, largest, pixels);
        }

        /// <summary>Mean position of all particles as they are drawn, world.</summary>
        private protected Vector3 MeanPosition()
        {
            PbfSolver solver = simulation.Solver;
            var counters = new uint[solver.Counters.count];
            solver.Counters.GetData(counters);
            var now = new float4[counters[(int)ParticleCounter.Alive]];
            var start = new float4[now.Length];
            solver.Positions.GetData(now, 0, 0, now.Length);
            solver.StartPositions.GetData(start, 0, 0, now.Length);
            float lag = simulation.Clock.FrameLag.x;
            float3 sum = 0;
            for (int i = 0; i < now.Length; i++)
                sum += now[i].xyz + (now[i].xyz - start[i].xyz) * lag;
            return simulation.DomainToWorld.MultiplyPoint3x4(sum / now.Length);
        }

        /// <summary>How far off the motion of water is that has fallen so far and falls on; well above the floor, which slows the lowest
        /// first.</summary>
        private protected (float worst, float largest, int pixels) Fall(int rate)
        {
            PlayMore((int)(rate * 0.15f), 1f / rate);
            Vector3 before = MeanPosition();
            PlayMore(1, 1f / rate);
            Vector3 fallen = MeanPosition() - before;
            return Compare(WorldToClip, world => world - fallen);
        }

        /// <summary>Tests water that turns with its domain, before a camera that moves too: each eye sees another motion.</summary>
        private protected void AssertEachEyeHasTheMotionThatItSees()
        {
            PlayMore(4);
            simulation.Paused = true;
            PlayMore(1);
            Matrix4x4[] last = { WorldToClipOf(0), WorldToClipOf(1) };
            Matrix4x4 domain = simulation.DomainToWorld;
            MoveCamera();
            simulation.transform.rotation = Quaternion.Euler(0, 0, 8);
            PlayMore(1);
            Matrix4x4 back = domain * simulation.DomainToWorld.inverse;
            for (int eye = 0; eye < 2; eye++)
            {
                (float worst, float largest, int pixels) = Compare(WorldToClipOf(eye), last[eye], back.MultiplyPoint3x4, eye);
                Assert.That(pixels, Is.GreaterThan(5000));
                Assert.That(largest, Is.GreaterThan(3f), "it moves");
                Assert.That(worst, Is.LessThan(Bar));
                Assert.That(Compare(WorldToClipOf(eye), last[eye], back.MultiplyPoint3x4, 1 - eye).worst, Is.GreaterThan(2 * Bar),
                    "the other eye's slice is another");
                Assert.That(Compare(WorldToClipOf(eye), last[1 - eye], back.MultiplyPoint3x4, eye).worst, Is.GreaterThan(2 * Bar),
                    "the other eye was elsewhere");
            }
        }

        /// <summary>A camera that turns and goes on while the water is paused.</summary>
        private protected void MoveCamera()
        {
            camera.transform.rotation *= Quaternion.Euler(0.5f, 1.5f, 0);
            camera.transform.position += new Vector3(0.03f, 0.01f, 0.02f);
        }
    }
}
