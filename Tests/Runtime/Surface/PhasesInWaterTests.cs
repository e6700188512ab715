using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Phases with looks of their own in water that is drawn as a mesh: for an eye in it, on what stands in it, and in its layers.</summary>
    public class PhasesInWaterTests
    {
        const float Tinted = 0.5f;      // m
        const float Face = 0.9796f;     // of light goes through a face
        static readonly float3 First = new float3(0.7f, 0.3f, 0.4f);

        WaterScene scene;
        FluidSurface surface;

        [SetUp]
        public void Make()
        {
            scene = new WaterScene(48);
            scene.Camera.orthographicSize = 0.4f;
            surface = scene.Surface;
            FluidEmitter emitter = scene.NewChild<FluidEmitter>("Emitter");
            emitter.Rate = 1e-7f;       // less than a particle in a test
            emitter.Phase = 1;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        [UnityTest]
        public IEnumerator Water_of_one_phase_is_drawn_as_with_that_look([Values] bool refraction, [Values] bool eyeInWater)
        {
            AddPlate(-0.3f);
            AddSun();
            surface.Refraction = refraction;
            if (eyeInWater)
                PutEyeInWater();
            yield return scene.Settle();
            SurfaceLook look = SurfaceLook.Of(SurfacePreset.MurkyWater);
            look.roughness = surface.Look.roughness;
            look.refractionIndex = surface.Look.refractionIndex;
            float4[] plain = scene.Pixels();
            surface.PhaseLooks = new[] { look };
            scene.SetPhases((p, i) => 1);
            yield return WaterScene.Frames(2);
            float4[] phases = scene.Pixels();
            surface.PhaseLooks = null;
            surface.Look = look;
            yield return WaterScene.Frames(2);
            float4[] alone = scene.Pixels();
            TestContext.Out.WriteLine($"from the look alone {Difference(phases, alone)}, from the water {Difference(phases, plain)}");
            Assert.That(Difference(phases, alone), Is.LessThan(0.001f));
            Assert.That(Difference(phases, plain), Is.GreaterThan(0.015f), "unlike the water");
        }

        [UnityTest]
        public IEnumerator An_eye_in_the_water_sees_each_phase_through_its_own_path()
        {
            PutEyeInWater();
            surface.PhaseLooks = new[] { WaterScene.Absorbing(First, Tinted) };
            yield return scene.Settle();
            scene.SetPhases((p, i) => p.x > 0.5f ? 1 : 0);
            yield return WaterScene.Frames(2);
            float path = scene.Camera.transform.position.y - scene.Camera.nearClipPlane + 0.5f;
            IsNear(scene.At(-0.25f), Face * math.pow(WaterScene.Left, path / 0.5f));
            IsNear(scene.At(0.25f), Face * math.pow(First, path / Tinted));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_layer_absorbs_along_its_part_of_the_path([Values(0.2f, 0.4f)] float upper)
        {
            surface.PhaseLooks = new[] { WaterScene.Absorbing(First, Tinted) };
            yield return scene.Settle();
            scene.SetPhases((p, i) => p.y > WaterScene.Depth - upper ? 1 : 0);
            yield return WaterScene.Frames(2);
            IsNear(scene.At(0f), Face * Face * math.pow(First, upper / Tinted) * math.pow(WaterScene.Left, (WaterScene.Depth - upper) / 0.5f));
        }

        // Nodes are two spacings apart: what lies nearer to a border than that is blurred, if nothing says that the liquids do not mix.
        [UnityTest, Category("LongRun")]
        public IEnumerator Liquids_of_two_materials_have_a_sharp_border_and_phases_of_one_are_stirred([Values] bool areTwo)
        {
            FluidMaterialAsset oil = FluidMaterialAsset.Create("Oil", 999f);
            if (areTwo)
                scene.Fluid.PhaseMaterials = new[] { oil };
            surface.PhaseLooks = new[] { WaterScene.Absorbing(First, Tinted) };
            yield return scene.Settle();
            scene.SetPhases((p, i) => p.x > 0.5f ? 1 : 0);
            yield return WaterScene.Frames(2);
            const float Near = 0.8f * WaterScene.Spacing;
            float3 water = Face * Face * math.pow(WaterScene.Left, WaterScene.Depth / 0.5f);
            float3 tinted = Face * Face * math.pow(First, WaterScene.Depth / Tinted);
            if (areTwo)
            {
                IsNear(scene.At(-Near), water);
                IsNear(scene.At(Near), tinted);
            }
            else
            {
                Assert.That(math.cmax(math.abs(scene.At(-Near) / water - 1f)), Is.GreaterThan(0.1f));
            }
            UnityEngine.Object.Destroy(oil);
        }

        // Liquids that mix are drawn stirred, by the fraction of each. The border to a third one is as sharp as without them.
        [UnityTest]
        public IEnumerator Materials_that_mix_are_drawn_stirred_beside_a_sharp_border_to_others()
        {
            FluidMaterialAsset oil = FluidMaterialAsset.Create("Oil", 999f), dye = FluidMaterialAsset.Create("Dye", 998f);
            scene.Fluid.PhaseMaterials = new[] { oil, dye };
            scene.Fluid.MaterialPairs = new[] { FluidMaterialPair.Mixing(null, dye, 1e-9f) };
            var second = new float3(0.3f, 0.8f, 0.5f);
            surface.PhaseLooks = new[] { WaterScene.Absorbing(First, Tinted), WaterScene.Absorbing(second, Tinted) };
            yield return scene.Settle();
            scene.SetPhases((p, i) => p.x > 0.5f ? 1 : i % 3 == 0 ? 2 : 0);
            yield return WaterScene.Frames(2);
            const float Near = 0.8f * WaterScene.Spacing;
            float depth = WaterScene.Depth / 0.5f;
            float3 stirred = Face * Face * math.pow(second, depth / 3f) * math.pow(WaterScene.Left, depth * 2f / 3f);
            float3 found = scene.At(-0.2f), ratio = found / stirred;
            TestContext.Out.WriteLine($"stirred {found}, expected {stirred}; at the border {scene.At(-Near)} and {scene.At(Near)}");
            Assert.That(math.cmax(math.abs(ratio - 1f)), Is.LessThan(0.06f));
            IsNear(scene.At(Near), Face * Face * math.pow(First, WaterScene.Depth / Tinted));
            Assert.That(math.cmax(math.abs(scene.At(-Near) / stirred - 1f)), Is.LessThan(0.12f), "up to the border");
            UnityEngine.Object.Destroy(oil);
            UnityEngine.Object.Destroy(dye);
        }

        // Grains that scatter all light within a millimeter are seen by the part that gets through the water above: exp(-2).
        [UnityTest, Category("LongRun")]
        public IEnumerator Opaque_grains_under_murky_water_are_seen_through_it()
        {
            const float Upper = 0.3f;
            FluidMaterialAsset sand = FluidMaterialAsset.Create("Sand", 1001f);
            scene.Fluid.PhaseMaterials = new[] { sand };
            surface.Look = Scattering(Color.green, 0.5f * Upper);
            surface.PhaseLooks = new[] { Scattering(Color.red, 0.001f) };
            AddSun();
            yield return scene.Settle();
            scene.SetPhases((p, i) => p.y < WaterScene.Depth - Upper ? 1 : 0);
            yield return WaterScene.Frames(2);
            float3 seen = scene.At(0f);
            TestContext.Out.WriteLine($"the water's green and the sand's red: {seen}");
            Assert.That(seen.x / (seen.x + seen.y), Is.EqualTo(math.exp(-2f)).Within(0.06f));
            UnityEngine.Object.Destroy(sand);
        }

        static SurfaceLook Scattering(Color color, float depth)
        {
            SurfaceLook look = SurfaceLook.Water;
            (look.colorAtDepth, look.scattering, look.scatteringDepth) = (Color.white, color, depth);
            return look;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator The_suns_light_on_what_stands_in_the_water_is_absorbed_by_what_is_above()
        {
            AddPlate(-0.15f);
            AddSun();
            yield return scene.Settle();
            surface.PhaseLooks = new[] { WaterScene.Absorbing(First, 0.1f) };
            scene.SetPhases((p, i) => 1);
            yield return WaterScene.Frames(2);
            float3 all = scene.At(0f);
            scene.SetPhases((p, i) => p.y > 0.2f ? 1 : 0);
            yield return WaterScene.Frames(2);
            float3 upper = scene.At(0f);
            surface.Caustics = false;
            yield return WaterScene.Frames(2);
            float3 without = scene.At(0f);
            TestContext.Out.WriteLine($"all of the phase {all}, the water above {upper}, without caustics {without}");
            Assert.That(math.cmax(math.abs(without / all - 1f)), Is.GreaterThan(0.3f), "the sun's light is absorbed on its path");
            IsNear(upper, all);
        }

        [UnityTest]
        public IEnumerator The_order_of_particles_does_not_change_a_bit_of_the_picture()
        {
            surface.PhaseLooks = new[] { WaterScene.Absorbing(First, Tinted) };
            yield return scene.Settle();
            scene.SetPhases((p, i) => math.hash(p) % 2 == 0 ? 1 : 0);
            yield return WaterScene.Frames(2);
            float4[] before = scene.Pixels();
            PbfSolver solver = scene.Fluid.Solver;
            var counters = new uint[solver.Counters.count];
            solver.Counters.GetData(counters);
            int count = (int)counters[(int)ParticleCounter.Alive];
            Reverse<float4>(solver.Positions, count);
            Reverse<uint>(solver.Tags, count);
            yield return WaterScene.Frames(2);
            Assert.That(scene.Pixels(), Is.EqualTo(before));
        }

        [TestCase(10f, 10f, 10f, 2048, ExpectedResult = 2f)]
        [TestCase(8000f, 10f, 10f, 2048, ExpectedResult = 4.8828125f)]
        [TestCase(400f, 400f, 400f, 2048, ExpectedResult = 3.90625f)]
        public float Nodes_are_two_spacings_apart_and_wider_where_there_would_be_too_many(float x, float y, float z, int across)
            => PhaseGrid.CellFor(new float3(x, y, z), across);

        static void IsNear(float3 seen, float3 expected, float within = 0.02f)
        {
            TestContext.Out.WriteLine($"seen {seen}, expected {expected}");
            Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(within), $"{seen} for {expected}");
        }

        static float Difference(float4[] a, float4[] b)
        {
            float difference = 0f;
            for (int i = 0; i < a.Length; i++)
                difference = math.max(difference, math.cmax(math.abs(a[i].xyz - b[i].xyz)));
            return difference;
        }

        static void Reverse<T>(GraphicsBuffer buffer, int count) where T : struct
        {
            var values = new T[count];
            buffer.GetData(values, 0, 0, count);
            Array.Reverse(values);
            buffer.SetData(values, 0, 0, count);
        }

        void AddPlate(float height)
        {
            GameObject plate = scene.Keep(GameObject.CreatePrimitive(PrimitiveType.Quad));
            plate.transform.position = new Vector3(0f, height, 0f);
            plate.transform.rotation = Quaternion.LookRotation(Vector3.down);
        }

        void AddSun()
        {
            Light sun = scene.AddSun();
            sun.type = LightType.Directional;
            sun.enabled = true;
        }

        void PutEyeInWater()
        {
            scene.Camera.nearClipPlane = 0.01f;
            scene.Camera.transform.position = new Vector3(0f, 0.04f, 0f);
        }
    }
}
