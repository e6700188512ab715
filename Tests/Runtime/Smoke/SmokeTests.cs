using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The air over a fluid: its flow, what lifts it, and where its smoke goes.</summary>
    public class SmokeTests
    {
        const float StillAir = 0.02f;       // d/s, 1 mm/s: what the solve leaves
        const BoxWalls AllButFloor = BoxWalls.All & ~BoxWalls.Bottom;

        [Test]
        public void Hot_air_rises_and_flows_without_divergence([Values(BoxWalls.None, BoxWalls.Top, AllButFloor)] BoxWalls open)
        {
            using (var stage = new SmokeStage(new int3(24, 32, 20), SmokeStage.Lasting(open)))
            {
                stage.AddSource(new float3(12f, 4f, 10f), 3f, 100f).Step(60);
                Assert.That(stage.Rise(12, 10, 10), Is.GreaterThan(5f), "d/s");
                double worst = 0, sum = 0;
                float fastest = stage.Flow.Max(math.abs);
                stage.ForEachCell((x, y, z) =>
                {
                    worst = Math.Max(worst, Math.Abs(stage.Divergence(x, y, z)));
                    sum += Math.Abs(stage.Divergence(x, y, z));
                });
                TestContext.WriteLine($"{open}: fastest {fastest:0.0} d/s, divergence at most {worst:0.000}, mean {sum / stage.Cells:0.0000} 1/s");
                Assert.That(worst, Is.LessThan(0.01 * fastest));
                Assert.That(sum / stage.Cells, Is.LessThan(0.001 * fastest));
            }
        }

        [Test]
        public void Cold_air_sinks_and_air_without_heat_stays_where_it_is()
        {
            using (var stage = new SmokeStage(new int3(16, 24, 16), SmokeStage.Lasting(AllButFloor)))
            {
                stage.AddSource(new float3(8f, 16f, 8f), 3f, -40f).Step(30);
                Assert.That(stage.Rise(8, 11, 8), Is.LessThan(-2f), "d/s");
            }
            using (var stage = new SmokeStage(new int3(16, 24, 16), SmokeStage.Lasting(AllButFloor)))
            {
                stage.AddSource(new float3(8f, 12f, 8f), 2f, 0f, density: 5f).Step(30);
                Assert.That(stage.Flow.Max(math.abs), Is.LessThan(StillAir), "d/s");
                Assert.That(stage.Density(8, 12, 8), Is.EqualTo(5f).Within(0.1f));
                Assert.That(stage.Density(8, 20, 8), Is.LessThan(1e-6f));
            }
        }

        // A ball of T above the air T0 weighs 1 / (1 + T / T0) of it: it begins to rise with g T / (T0 + T), halved by the air that it moves.
        [Test]
        public void A_hot_ball_begins_to_rise_as_its_weight_and_added_mass_say()
        {
            using (var stage = new SmokeStage(new int3(32, 32, 32), SmokeStage.Lasting(BoxWalls.All)))
            {
                const float Heat = 60f;
                stage.AddSource(16f, 5f, Heat).Step(1);
                const int Steps = 2;
                stage.Fluid.Input.sources.Clear();
                float before = stage.Rise(16, 16, 16);
                double heat = 0;        // of all of it: a source flickers
                stage.ForEachCell((x, y, z) => heat += stage.Heat(x, y, z) / (4.0 / 3.0 * Math.PI * 125.0));
                stage.Step(Steps);
                double lift = 9.81 / SmokeStage.Spacing * heat / (293.15 + heat);
                double measured = (stage.Rise(16, 16, 16) - before) / (Steps * stage.StepTime);
                TestContext.WriteLine($"{measured:0.00} d/s², {measured / lift:0.000} of its lift without added mass");
                Assert.That(measured / lift, Is.EqualTo(2.0 / 3.0).Within(0.07));
            }
        }

        [Test]
        public void Smoke_thins_and_cools_in_the_time_that_it_is_given()
        {
            SmokeSettings settings = SmokeStage.Lasting(BoxWalls.None);
            settings.lifetime = 0.5f;
            settings.cooling = 0.25f;
            using (var stage = new SmokeStage(new int3(12, 12, 12), settings))
            {
                stage.Fluid.Input.gravity = 0f;
                stage.AddSource(6f, 3f, 100f, density: 8f).Step(20);
                stage.Fluid.Input.sources.Clear();
                float heat = stage.Heat(6, 6, 6), density = stage.Density(6, 6, 6);
                stage.Step(15);
                Assert.That(stage.Heat(6, 6, 6) / heat, Is.EqualTo(math.exp(-1f)).Within(0.01f));
                Assert.That(stage.Density(6, 6, 6) / density, Is.EqualTo(math.exp(-0.5f)).Within(0.01f));
            }
        }

        [Test]
        public void Smoke_goes_around_a_collider_and_not_through_it()
        {
            using (var stage = new SmokeStage(new int3(20, 32, 20), SmokeStage.Lasting(BoxWalls.Top)))
            {
                ColliderTests.Use(stage.Fluid,
                    ColliderTests.Still(ColliderShape.Box, new float3(4f, 2f, 4f), new float3(10f, 14f, 10f), quaternion.identity));
                stage.AddSource(new float3(10f, 4f, 10f), 3f, 150f, density: 10f).Step(140);
                Assert.That(Math.Abs(stage.Rise(10, 13, 10)) + Math.Abs(stage.Rise(10, 14, 10)), Is.LessThan(1e-3f), "inside, d/s");
                Assert.That(stage.Density(10, 13, 10), Is.LessThan(0.01f), "inside");
                float beside = 0f;
                for (int z = 0; z < 20; z++)
                    for (int x = 0; x < 20; x++)
                        beside = math.max(beside, stage.Density(x, 18, z));
                TestContext.WriteLine($"beside and above it {beside:0.00} 1/m");
                Assert.That(beside, Is.GreaterThan(0.5f));
            }
        }

        [Test]
        public void A_moving_collider_pushes_the_air_before_it()
        {
            using (var stage = new SmokeStage(new int3(24, 16, 16), SmokeStage.Lasting(AllButFloor)))
            {
                const float Speed = 12f;
                for (int step = 0; step < 20; step++)
                {
                    float x = 6f + Speed * step * stage.StepTime;
                    var center = new float3(x, 8f, 8f);
                    ColliderMotion motion = ColliderTests.Still(ColliderShape.Box, new float3(2f, 4f, 4f), center, quaternion.identity);
                    motion.end.position.x += Speed * stage.StepTime;
                    ColliderTests.Use(stage.Fluid, motion);
                    stage.Fluid.Input.colliders.Version = step + 1;
                    stage.Fluid.Step();
                }
                stage.Read();
                float ahead = stage.Flow[stage.Face(0, 13, 8, 8)];
                TestContext.WriteLine($"a cell ahead of it {ahead:0.0} d/s of {Speed}");
                Assert.That(stage.Flow[stage.Face(0, 11, 8, 8)], Is.EqualTo(Speed).Within(0.1f), "at its face, d/s");
                Assert.That(ahead, Is.EqualTo(Speed).Within(0.35f * Speed));
            }
        }

        [Test]
        public void Moving_water_pushes_the_air_before_it()
        {
            using (var stage = new SmokeStage(new int3(24, 16, 16), SmokeStage.Lasting(AllButFloor)))
            {
                const float Speed = 20f;
                stage.Fluid.Input.gravity = 0f;
                var velocity = new float3(Speed * SmokeStage.Spacing, 0f, 0f);
                stage.Fluid.AddBlock(new float3(2f, 4f, 4f) * SmokeStage.Spacing, 8f * SmokeStage.Spacing, velocity);
                stage.Step(4);
                float ahead = stage.Flow[stage.Face(0, 13, 8, 8)];
                TestContext.WriteLine($"ahead of it {ahead:0.0} d/s of {Speed}");
                Assert.That(ahead, Is.InRange(0.25f * Speed, 1.1f * Speed));
            }
        }

        [Test]
        public void A_source_blows_along_its_velocity()
        {
            using (var stage = new SmokeStage(new int3(16, 16, 16), SmokeStage.Lasting(AllButFloor)))
            {
                stage.Fluid.Input.gravity = 0f;
                stage.AddSource(8f, 2f, 0f, velocity: new float3(0f, 12f, 0f)).Step(30);
                Assert.That(stage.Rise(8, 8, 8), Is.EqualTo(12f).Within(3f), "d/s");
                Assert.That(stage.Rise(8, 12, 8), Is.GreaterThan(2f), "before it, d/s");
            }
        }

        [Test]
        public void Steam_comes_from_the_water_and_nowhere_else()
        {
            SmokeSettings settings = SmokeStage.Lasting(AllButFloor);
            settings.steam = 6f;
            settings.steamTemperature = 60f;
            using (var stage = new SmokeStage(new int3(20, 24, 12), settings))
            {
                stage.Fluid.AddBlock(0f, new float3(10f, 5f, 12f) * SmokeStage.Spacing);
                stage.Step(3);
                Assert.That(stage.Density(4, 6, 6), Is.GreaterThan(0.5f), "over the water");
                Assert.That(stage.Density(4, 1, 6), Is.LessThan(0.05f), "in it");
                Assert.That(stage.Density(17, 6, 6), Is.Zero, "beside it");
                Assert.That(stage.Density(4, 20, 6), Is.Zero, "far above");
            }
        }

        [Test]
        public void Two_runs_are_the_same_to_the_bit_and_a_restart_begins_with_fresh_air()
        {
            float[][] flows = new float[2][];
            for (int run = 0; run < 2; run++)
                using (var stage = new SmokeStage(new int3(16, 24, 16), SmokeStage.Lasting(AllButFloor)))
                {
                    stage.Fluid.Input.smoke.vorticity = 3f;
                    stage.AddSource(new float3(8f, 4f, 8f), 2f, 200f, velocity: new float3(0f, 10f, 0f)).Step(20);
                    flows[run] = stage.Flow;
                    stage.Fluid.Solver.Clear();
                    stage.Fluid.Input.sources.Clear();
                    stage.Step(1);
                    Assert.That(stage.Flow.Max(math.abs), Is.LessThan(StillAir));
                    Assert.That(stage.Air.Max(), Is.Zero);
                }
            Assert.That(flows[1], Is.EqualTo(flows[0]));
        }
    }
}
