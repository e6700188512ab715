using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Phases of a fluid whose surface shows each with a look of its own: seen from above, over white.</summary>
    public class PhaseLookTests
    {
        const float Spacing = 0.05f, Depth = 0.6f;
        const int Pixels = 48;

        static readonly float3 Base = new float3(0.2f, 0.5f, 0.8f), First = new float3(0.7f, 0.3f, 0.4f), Second = new float3(0.9f, 0.8f, 0.2f);     // left after 0.5 m

        GameObject root;
        FluidSimulation fluid;
        FluidSurface surface;
        FluidEmitter emitter;
        Camera camera;
        RenderTexture target;

        [SetUp]
        public void Make()
        {
            target = new RenderTexture(Pixels, Pixels, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.orthographic = true;
            camera.orthographicSize = 0.4f;
            camera.farClipPlane = 10f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.white;
            camera.allowHDR = true;
            camera.targetTexture = target;
            camera.transform.position = new Vector3(0f, 3f, 0f);
            camera.transform.LookAt(Vector3.zero, Vector3.forward);

            root = new GameObject("Fluid");
            root.SetActive(false);
            fluid = root.AddComponent<FluidSimulation>();
            fluid.Configure(Vector3.one, Spacing, 8000);
            fluid.StatisticsInterval = 0;
            var volume = new GameObject("Water").AddComponent<FluidVolume>();
            volume.transform.SetParent(root.transform, false);
            volume.transform.localPosition = new Vector3(0f, 0.5f * (Depth - 1f), 0f);
            volume.Size = new Vector3(1f, Depth, 1f);
            emitter = new GameObject("Emitter").AddComponent<FluidEmitter>();
            emitter.transform.SetParent(root.transform, false);
            emitter.Rate = 1e-7f;       // less than a particle in a test
            emitter.Phase = 1;
            surface = root.AddComponent<FluidSurface>();
            surface.ReflectionStrength = 0f;
            surface.Look = Clear(Base);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Time.captureDeltaTime = 0f;
            Object.Destroy(root);
            Object.Destroy(camera.gameObject);
            yield return null;
            target.Release();
        }

        [UnityTest]
        public IEnumerator Each_phase_absorbs_as_its_look_says_and_one_beyond_as_the_last([Values(2, 3, 200)] int phase)
        {
            surface.PhaseLooks = new[] { Clear(First), Clear(Second) };
            yield return Begin();
            float3 alike = At(0.25f);
            SetPhases((x, i) => x > 0.5f ? phase : 0);
            yield return Frames(2);
            float3 left = At(-0.25f), right = At(0.25f);
            float thickness = math.log(alike.z / 0.98f) / math.log(Base.z) * 0.5f;
            TestContext.Out.WriteLine($"all alike {alike}, left {left}, right {right}, thickness {thickness} m");
            Assert.That(thickness, Is.EqualTo(Depth).Within(0.06f));
            IsNear(left, Left(Base, thickness));
            IsNear(right, Left(Second, thickness));
        }

        [UnityTest]
        public IEnumerator Phases_that_are_stirred_absorb_by_how_much_there_is_of_each()
        {
            surface.PhaseLooks = new[] { Clear(First) };
            yield return Begin();
            float thickness = math.log(At(0f).z / 0.98f) / math.log(Base.z) * 0.5f;
            SetPhases((x, i) => i % 4 == 0 ? 1 : 0);
            yield return Frames(2);
            float3 sum = 0f;
            int samples = 0;
            for (float right = -0.3f; right < 0.3f; right += 0.05f, samples++)
                sum += math.log(At(right) / 0.98f);
            IsNear(math.exp(sum / samples) * 0.98f, Left(Base, 0.75f * thickness) * Left(First, 0.25f * thickness) / 0.98f);
        }

        [UnityTest]
        public IEnumerator A_phase_scatters_as_its_look_says()
        {
            surface.PhaseLooks = new[] { SurfaceLook.Of(SurfacePreset.Milk) };
            yield return Begin();
            SetPhases((x, i) => 1);
            yield return Frames(2);
            float3 milk = At(0f);
            surface.PhaseLooks = null;
            SurfaceLook look = SurfaceLook.Of(SurfacePreset.Milk);
            look.refractionIndex = surface.Look.refractionIndex;
            look.roughness = surface.Look.roughness;
            surface.Look = look;
            yield return Frames(2);
            Assert.That(math.cmax(math.abs(At(0f) - milk)), Is.LessThan(0.002f));
            Assert.That(math.cmax(math.abs(milk - Left(Base, Depth))), Is.GreaterThan(0.1f), "unlike the water");
        }

        [UnityTest]
        public IEnumerator Where_no_emitter_gives_a_phase_nothing_more_is_kept()
        {
            emitter.Phase = 0;
            surface.PhaseLooks = new[] { Clear(First) };
            yield return Begin();
            Assert.That(fluid.Solver.Tags, Is.Null);
            IsNear(At(0f), Left(Base, Depth), 0.15f);
        }

        [Test]
        public void More_looks_than_can_be_told_apart_are_removed_with_a_warning()
        {
            LogAssert.Expect(LogType.Warning, new Regex("of 5 phase looks only the first 3 can be told apart"));
            surface.PhaseLooks = new[] { Clear(First), Clear(Second), Clear(First), Clear(First), Clear(First) };
            Assert.That(surface.PhaseLooks.Length, Is.EqualTo(3));
        }

        [Test]
        public void A_look_that_was_just_added_is_that_of_water()
        {
            surface.PhaseLooks = new[] { default(SurfaceLook) };
            Assert.That(surface.PhaseLooks[0], Is.EqualTo(SurfaceLook.Water));
        }

        static SurfaceLook Clear(float3 left)
        {
            SurfaceLook look = SurfaceLook.Water;
            var color = new Color(left.x, left.y, left.z);
            look.scatteringDepth = 0f;
            look.colorAtDepth = QualitySettings.activeColorSpace == ColorSpace.Linear ? color.gamma : color;
            look.colorDepth = 0.5f;
            return look;
        }

        static float3 Left(float3 after, float thickness) => 0.98f * math.pow(after, thickness / 0.5f);

        static void IsNear(float3 seen, float3 expected, float within = 0.04f) => Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(within), $"{seen} for {expected}");

        IEnumerator Begin()
        {
            Time.captureDeltaTime = 1f / 60f;
            root.SetActive(true);
            yield return Frames(20);
            fluid.Paused = true;
            yield return Frames(2);
        }

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }

        // x: 0 to 1 across the domain.
        void SetPhases(System.Func<float, int, int> phaseOf)
        {
            PbfSolver solver = fluid.Solver;
            var positions = new float4[solver.Positions.count];
            solver.Positions.GetData(positions);
            var tags = new uint[solver.Tags.count];
            for (int i = 0; i < tags.Length; i++)
                tags[i] = (uint)phaseOf(positions[i].x * Spacing, i) << 24;
            solver.Tags.SetData(tags);
        }

        // Right of the picture's middle, m.
        float3 At(float right)
        {
            var picture = new Texture2D(Pixels, Pixels, TextureFormat.RGBAFloat, false, true);
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0, 0, Pixels, Pixels), 0, 0);
            RenderTexture.active = null;
            Color seen = picture.GetPixel((int)((right / camera.orthographicSize * 0.5f + 0.5f) * Pixels), Pixels / 2);
            Object.DestroyImmediate(picture);
            return new float3(seen.r, seen.g, seen.b);
        }
    }
}
