using System.Collections;
using System.Linq;
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
        const float Kept = 0.9596f;     // of light at the two faces that it goes through

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

        [UnityTest, Category("LongRun")]
        public IEnumerator Each_phase_absorbs_as_its_look_says_and_one_beyond_as_the_last([Values(2, 3, 200)] int phase)
        {
            surface.PhaseLooks = new[] { Clear(First), Clear(Second) };
            yield return scene.Settle();
            float3 alike = scene.At(0.25f);
            scene.SetPhases((p, i) => p.x > 0.5f ? phase : 0);
            yield return WaterScene.Frames(2);
            float3 left = scene.At(-0.25f), right = scene.At(0.25f);
            float thickness = math.log(alike.z / Kept) / math.log(Base.z) * 0.5f;
            TestContext.Out.WriteLine($"all alike {alike}, left {left}, right {right}, thickness {thickness} m");
            Assert.That(thickness, Is.EqualTo(Depth).Within(0.06f));
            IsNear(left, Left(Base, thickness));
            IsNear(right, Left(Second, thickness));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Phases_that_are_stirred_absorb_by_how_much_there_is_of_each([Values(2, 4)] int one)
        {
            surface.PhaseLooks = new[] { Clear(First) };
            yield return scene.Settle();
            float thickness = math.log(scene.At(0f).z / Kept) / math.log(Base.z) * 0.5f;
            scene.SetPhases((p, i) => i % one == 0 ? 1 : 0);
            yield return WaterScene.Frames(2);
            float3 sum = 0f;
            int samples = 0;
            for (float right = -0.3f; right < 0.3f; right += 0.05f, samples++)
                sum += math.log(scene.At(right) / Kept);
            float3 seen = math.exp(sum / samples) * Kept, expected = Left(Base, (1f - 1f / one) * thickness) * Left(First, thickness / one) / Kept;
            TestContext.Out.WriteLine($"seen {seen}, by the mean of the rates {expected}");
            IsNear(seen, expected, 0.03f);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_phase_scatters_as_its_look_says()
        {
            surface.PhaseLooks = new[] { SurfaceLook.Of(SurfacePreset.Milk) };
            yield return scene.Settle();
            scene.SetPhases((p, i) => 1);
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
            Assert.That(Work(), Has.None.Contains("Phase"));
        }

        [UnityTest]
        public IEnumerator Looks_of_phases_come_and_go_and_leave_the_picture_as_it_was_without()
        {
            yield return scene.Settle();
            float4[] before = scene.Pixels();
            Assert.That(Work(), Has.None.Contains("Phase"));
            surface.PhaseLooks = new[] { Clear(First) };
            scene.SetPhases((p, i) => 1);
            yield return WaterScene.Frames(2);
            Assert.That(Work(), Has.Some.Contains("TracePhases"));
            Assert.That(math.cmax(math.abs(scene.At(0f) - before[before.Length / 2 + scene.Target.width / 2].xyz)), Is.GreaterThan(0.1f));
            surface.PhaseLooks = null;
            yield return WaterScene.Frames(2);
            Assert.That(Work(), Has.None.Contains("Phase"));
            Assert.That(scene.Pixels(), Is.EqualTo(before));
        }

        [UnityTest]
        public IEnumerator The_same_water_has_the_same_picture_bit_for_bit()
        {
            surface.PhaseLooks = new[] { Clear(First), Clear(Second) };
            yield return scene.Settle();
            scene.SetPhases((p, i) => i % 3);
            yield return WaterScene.Frames(2);
            float4[] first = scene.Pixels();
            for (int i = 0; i < 4; i++)
            {
                yield return WaterScene.Frames(1);
                Assert.That(scene.Pixels(), Is.EqualTo(first));
            }
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

        float3 Left(float3 after, float thickness) => Kept * math.pow(after, thickness / 0.5f);

        static void IsNear(float3 seen, float3 expected, float within = 0.04f)
            => Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(within), $"{seen} for {expected}");

        // Kernels and textures of the surface.
        string[] Work()
        {
            StageDescription stage = scene.Fluid.Results.Describe().Single(one => one.Name == "FluidSurface");
            return stage.Kernels.Select(kernel => kernel.kernel).Concat(stage.Buffers.Select(texture => texture.name)).ToArray();
        }
    }
}
