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
        const float Depth = WaterScene.Depth;

        // left after 0.5 m
        static readonly float3 Base = WaterScene.Left, First = new float3(0.7f, 0.3f, 0.4f), Second = new float3(0.9f, 0.8f, 0.2f);

        WaterScene scene;
        FluidSurface surface;
        FluidEmitter emitter;

        [SetUp]
        public void Make()
        {
            scene = new WaterScene(48);
            scene.Camera.orthographicSize = 0.4f;
            surface = scene.Surface;
            emitter = scene.NewChild<FluidEmitter>("Emitter");
            emitter.Rate = 1e-7f;       // less than a particle in a test
            emitter.Phase = 1;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        [UnityTest]
        public IEnumerator Each_phase_absorbs_as_its_look_says_and_one_beyond_as_the_last([Values(2, 3, 200)] int phase)
        {
            surface.PhaseLooks = new[] { Clear(First), Clear(Second) };
            yield return scene.Settle();
            float3 alike = scene.At(0.25f);
            SetPhases((x, i) => x > 0.5f ? phase : 0);
            yield return WaterScene.Frames(2);
            float3 left = scene.At(-0.25f), right = scene.At(0.25f);
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
            yield return scene.Settle();
            float thickness = math.log(scene.At(0f).z / 0.98f) / math.log(Base.z) * 0.5f;
            SetPhases((x, i) => i % 4 == 0 ? 1 : 0);
            yield return WaterScene.Frames(2);
            float3 sum = 0f;
            int samples = 0;
            for (float right = -0.3f; right < 0.3f; right += 0.05f, samples++)
                sum += math.log(scene.At(right) / 0.98f);
            IsNear(math.exp(sum / samples) * 0.98f, Left(Base, 0.75f * thickness) * Left(First, 0.25f * thickness) / 0.98f);
        }

        [UnityTest]
        public IEnumerator A_phase_scatters_as_its_look_says()
        {
            surface.PhaseLooks = new[] { SurfaceLook.Of(SurfacePreset.Milk) };
            yield return scene.Settle();
            SetPhases((x, i) => 1);
            yield return WaterScene.Frames(2);
            float3 milk = scene.At(0f);
            surface.PhaseLooks = null;
            SurfaceLook look = SurfaceLook.Of(SurfacePreset.Milk);
            look.refractionIndex = surface.Look.refractionIndex;
            look.roughness = surface.Look.roughness;
            surface.Look = look;
            yield return WaterScene.Frames(2);
            Assert.That(math.cmax(math.abs(scene.At(0f) - milk)), Is.LessThan(0.002f));
            Assert.That(math.cmax(math.abs(milk - Left(Base, Depth))), Is.GreaterThan(0.1f), "unlike the water");
        }

        [UnityTest]
        public IEnumerator Where_no_emitter_gives_a_phase_nothing_more_is_kept()
        {
            emitter.Phase = 0;
            surface.PhaseLooks = new[] { Clear(First) };
            yield return scene.Settle();
            Assert.That(scene.Fluid.Solver.Tags, Is.Null);
            IsNear(scene.At(0f), Left(Base, Depth), 0.15f);
        }

        [Test]
        public void More_looks_than_can_be_told_apart_are_removed_with_a_warning()
        {
            LogAssert.Expect(LogType.Warning, new Regex("of 5 phase looks only the first 3 can be told apart"));
            surface.PhaseLooks = new[] { Clear(First), Clear(Second), Clear(First), Clear(First), Clear(First) };
            Assert.That(surface.PhaseLooks.Length, Is.EqualTo(3));
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_look_that_was_just_added_is_that_of_water()
        {
            surface.PhaseLooks = new[] { default(SurfaceLook) };
            Assert.That(surface.PhaseLooks[0], Is.EqualTo(SurfaceLook.Water));
        }

        static SurfaceLook Clear(float3 left) => WaterScene.Absorbing(left, 0.5f);

        static float3 Left(float3 after, float thickness) => 0.98f * math.pow(after, thickness / 0.5f);

        static void IsNear(float3 seen, float3 expected, float within = 0.04f)
            => Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(within), $"{seen} for {expected}");

        // x: 0 to 1 across the domain.
        void SetPhases(System.Func<float, int, int> phaseOf)
        {
            PbfSolver solver = scene.Fluid.Solver;
            var positions = new float4[solver.Positions.count];
            solver.Positions.GetData(positions);
            var tags = new uint[solver.Tags.count];
            for (int i = 0; i < tags.Length; i++)
                tags[i] = (uint)phaseOf(positions[i].x * WaterScene.Spacing, i) << 24;
            solver.Tags.SetData(tags);
        }
    }
}
