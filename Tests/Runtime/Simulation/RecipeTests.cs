using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>The recipes of Documentation~/recipes.md that no sample has do what the page says, with its values; the large ones at a
    /// coarser spacing, at which their outlets have room for the same rate.</summary>
    public class RecipeTests
    {
        // m³ that are in the river after 8 s, of 4.32 that came: the page's 22,000 particles.
        const float Filled = 2.75f;

        string logged;

        [SetUp]
        public void Listen()
        {
            logged = "";
            Application.logMessageReceived += Hear;
        }

        [TearDown]
        public void NothingIsLogged()
        {
            Application.logMessageReceived -= Hear;
            Assert.That(logged, Is.Empty);
        }

        void Hear(string message, string trace, LogType type) => logged += message + "\n";

        // The page: spacing 0.05, 27 times the particles.
        [Test, Category("LongRun")]
        public void A_river_fills_up_and_then_runs_in_a_circle()
        {
            const float Spacing = 0.15f, Rate = 0.54f, Seconds = 8f;
            using (var scene = new SourceScene(new Vector3(8f, 1f, 2f), Spacing, 60000 / 27, DeepWater.Automatic))
            {
                scene.Fluid.Iterations = 2;
                FluidEmitter spring = scene.Add<FluidEmitter>(new Vector3(-3.9f, -0.3f, 0f), Vector3.right, e =>
                {
                    e.Shape = EmitterShape.Box;
                    e.Size = new Vector3(1.8f, 0.3f, 0.1f);
                    e.Mode = EmitterMode.Jet;
                    e.Rate = Rate;
                    e.Speed = 1f;
                });
                FluidDrain mouth = scene.Add<FluidDrain>(new Vector3(3.85f, 0f, 0f), Vector3.forward, d => d.Size = new Vector3(0.3f, 1f, 2f));
                scene.Step((int)(60 * Seconds));
                FluidStatistics filled = scene.AssertConserved();
                TestContext.WriteLine($"{filled.particles} particles after 8 s, {filled.drained} drained, {filled.blocked} blocked");
                Assert.That(filled.emitted * scene.ParticleVolume, Is.EqualTo(Rate * Seconds).Within(0.01f * Rate * Seconds), "the rate, m³");
                Assert.That(filled.particles * scene.ParticleVolume, Is.EqualTo(Filled).Within(0.1f * Filled), "m³ in the river");
                Assert.That(filled.drained, Is.GreaterThan(0), "it has come to the mouth");

                mouth.RecycleTo = spring;
                spring.Rate = 0f;
                scene.Step(2 * 60);
                FluidStatistics later = scene.AssertConserved();
                TestContext.WriteLine($"{later.emitted - filled.emitted} came in again in 2 s, mean speed {later.speed:0.00} m/s");
                Assert.That(later.particles + later.recycling, Is.EqualTo(filled.particles).Within(1), "nothing comes or goes");
                Assert.That(later.emitted - filled.emitted, Is.GreaterThan(20), "what leaves comes in again");
            }
        }

        // The page: spacing 0.03, eight times the drops.
        [Test, Category("LongRun")]
        public void Rain_holds_as_many_drops_as_fall_in_their_lifetime()
        {
            const float Spacing = 0.06f, Rate = 0.005f, Lifetime = 10f, Volume = Spacing * Spacing * Spacing;
            using (var scene = new SourceScene(new Vector3(2f, 2f, 1f), Spacing, 20000 / 8, DeepWater.Automatic))
            {
                scene.Add<FluidEmitter>(new Vector3(0f, 0.9f, 0f), Vector3.down, e =>
                {
                    e.Shape = EmitterShape.Box;
                    e.Size = new Vector3(1.8f, 0.9f, 0.1f);
                    e.Mode = EmitterMode.Spray;
                    e.Rate = Rate;
                    e.Speed = 3f;
                    e.Spread = 5f;
                    e.Lifetime = Lifetime;
                });
                scene.Step(9 * 60);
                int before = scene.AssertConserved().particles;
                scene.Step(2 * 60);
                FluidStatistics later = scene.AssertConserved();
                TestContext.WriteLine($"{before} particles after 9 s, {later.particles} after 11 s, {later.blocked} blocked");
                Assert.That(before, Is.EqualTo(9f * Rate / Volume).Within(2), "9 s of rain, none removed yet");
                Assert.That(later.particles, Is.EqualTo(Lifetime * Rate / Volume).Within(2), "10 s of rain");
                Assert.That(later.blocked, Is.Zero);
            }
        }

        [Test, Category("LongRun")]
        public void Slime_falls_as_one_lump_that_three_substeps_hold_together()
        {
            const float Spacing = 0.02f, Radius = 0.15f;
            FluidMaterial slime = FluidMaterial.ViscoelasticSlime;
            Assert.That(slime.shearModulus, Is.EqualTo(300f));
            Assert.That(slime.MaxShearModulus(Spacing, 1f / 60f / 3f), Is.GreaterThanOrEqualTo(4f * 300f), "at twice the length");
            Assert.That(slime.MaxShearModulus(Spacing, 1f / 60f / 2f), Is.LessThan(4f * 300f), "two substeps do not");
            float lump = Extent(slime);
            float water = Extent(FluidMaterial.Water);
            TestContext.WriteLine($"Slime: {lump:0.00} m wide after 1 s, water {water:0.00} m");
            Assert.That(lump, Is.LessThan(0.8f), "it has not spread over the floor");
            Assert.That(water, Is.GreaterThan(0.9f), "the box is 1 m wide");

            float Extent(FluidMaterial material)
            {
                using (var scene = new SourceScene(Vector3.one, Spacing, 4000, DeepWater.Automatic))
                {
                    scene.Fluid.Material = material;
                    scene.Fluid.Substeps = 3;
                    scene.FillSphere(Radius);
                    Assert.That(scene.Measure().particles, Is.EqualTo(1400).Within(30));
                    scene.Step(60);
                    ParticleState state = scene.Read();
                    float4 least = float.MaxValue, most = float.MinValue;
                    foreach (float4 position in state.positions)
                        (least, most) = (math.min(least, position), math.max(most, position));
                    Assert.That(scene.AssertConserved().particles, Is.EqualTo(state.Count));
                    return Spacing * math.cmax((most - least).xz);
                }
            }
        }

        // The page: spacing 0.08, 40 s and 70,300 particles, which is 1.5 m of water. Here less time at twice the spacing.
        [Test, Category("LongRun")]
        public void A_room_is_flooded_at_the_rate_of_its_leak_and_empties_through_its_plug()
        {
            const float Spacing = 0.16f, Rate = 0.9f, Seconds = 7f, Floor = 6f * 4f;
            using (var scene = new SourceScene(new Vector3(6f, 3f, 4f), Spacing, 72000 / 8, DeepWater.Automatic))
            {
                scene.Add<FluidEmitter>(new Vector3(-2.9f, 0f, 0f), Vector3.right, e =>
                {
                    e.Shape = EmitterShape.Box;
                    e.Size = new Vector3(1f, 0.5f, 0.1f);
                    e.Mode = EmitterMode.Jet;
                    e.Rate = Rate;
                    e.Speed = 2f;
                    e.Duration = Seconds;
                });
                FluidDrain plug = scene.Add<FluidDrain>(new Vector3(0f, -1.4f, 0f), Vector3.forward, d =>
                {
                    d.Size = new Vector3(0.3f, 0.2f, 0.3f);
                    d.RateLimit = 0.2f;
                    d.enabled = false;
                });
                scene.Step((int)(60 * (Seconds + 3f)));
                FluidStatistics full = scene.AssertConserved();
                float level = Level(scene);
                TestContext.WriteLine($"{full.particles} particles, level {level:0.000} m of {Rate * Seconds / Floor:0.000}");
                Assert.That(full.particles * scene.ParticleVolume, Is.EqualTo(Rate * Seconds).Within(0.01f), "m³, and none after its duration");
                Assert.That(level, Is.EqualTo(Rate * Seconds / Floor).Within(0.5f * Spacing));

                plug.enabled = true;
                scene.Step(2 * 60);
                float gone = (full.particles - scene.AssertConserved().particles) * scene.ParticleVolume;
                TestContext.WriteLine($"{gone:0.000} m³ drained in 2 s");
                // So little water does not press more through so small a hole: 0.09 m² √(2 g 0.2 m) = 0.18 m³/s.
                Assert.That(gone, Is.InRange(2f * 0.12f, 2f * 0.2f + 2f * scene.ParticleVolume), "up to the drain's rate limit");
            }
        }

        // Their rates fit their outlets, their particles fit the capacity, and nothing is logged; what they look like is not tested.
        [TestCase("Waterfall", 3f, 3f, 2f, 0.04f, 40000), TestCase("Hose", 8f, 3f, 8f, 0.04f, 10000)]
        [TestCase("Lava", 3f, 1.5f, 2f, 0.04f, 50000), TestCase("Tank", 2f, 1f, 1f, 0.05f, 10000)]
        public void Starting_values_of_a_recipe_fit_together(string recipe, float x, float y, float z, float spacing, int capacity)
        {
            var lava = FluidMaterialAsset.Create("Lava", 2700f, 100f);
            using (var scene = new SourceScene(new Vector3(x, y, z), spacing, capacity, DeepWater.Automatic))
            {
                switch (recipe)
                {
                    case "Waterfall":
                        scene.Fill(0.4f);
                        scene.Add<FluidEmitter>(new Vector3(-0.5f, 1f, 0f), Vector3.right, e => Jet(e, new Vector3(1.2f, 0.16f, 0.1f), 0.19f, 1f));
                        break;
                    case "Hose":
                        scene.Add<FluidEmitter>(Vector3.zero, Vector3.right, e => Jet(e, 0.08f, 0.15f, 8f, 3f));
                        break;
                    case "Lava":
                        scene.Fluid.Substeps = 2;
                        scene.Fill(0.35f);
                        scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => Jet(e, 0.12f, 0.01f, 0.4f));
                        scene.Fluid.GetComponentInChildren<FluidEmitter>().Material = lava;
                        break;
                    case "Tank":
                        scene.Fill(0.5f);
                        scene.Fluid.transform.position = new Vector3(0.1f, 0f, 0f);
                        break;
                }
                scene.Step(4);
                FluidStatistics now = scene.AssertConserved();
                Assert.That(now.refused + now.blocked, Is.Zero);
                TestContext.WriteLine($"{now.particles} particles");
            }
            Object.DestroyImmediate(lava);
        }

        static void Jet(FluidEmitter emitter, Vector3 size, float rate, float speed)
        {
            emitter.Shape = EmitterShape.Box;
            emitter.Size = size;
            (emitter.Rate, emitter.Speed) = (rate, speed);
        }

        static void Jet(FluidEmitter emitter, float radius, float rate, float speed, float lifetime = 0f)
        {
            emitter.Radius = radius;
            (emitter.Rate, emitter.Speed, emitter.Lifetime) = (rate, speed, lifetime);
        }

        // Twice the height of the particles' center over the floor.
        static float Level(SourceScene scene)
        {
            float sum = 0f;
            ParticleState state = scene.Read();
            foreach (float4 position in state.positions)
                sum += position.y;
            return 2f * sum / state.Count * scene.Fluid.ParticleSpacing;
        }
    }
}
