using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Fate of foam: how it moves, ages and finds room.</summary>
    public class FoamMotionTests
    {
        const float Step = 1f / 60f;
        static readonly float3 Gravity = new float3(0f, -150f, 0f);      // d/s²

        // A pool 12 d deep in a box of 24 x 32 x 24 d.
        static ParticleState Pool(Func<float3, float3> velocityAt = null)
        {
            ParticleState pool = ParticleState.Lattice(new float3(24f, 32f, 24f), 0.5f, new int3(24, 12, 24), jitter: 0.02f);
            return velocityAt != null ? pool.With(velocityAt) : pool;
        }

        static ParticleState Air => ParticleState.Lattice(new float3(40f, 40f, 40f), 0.5f, new int3(2, 1, 2));

        [Test]
        public void Spray_flies_a_parabola()
        {
            float3 start = new float3(5f, 10f, 20f), velocity = new float3(20f, 60f, -10f);
            using (var stage = new FoamStage(Air, FoamStage.Settings(0f), Gravity))
            {
                stage.Plant((start, velocity, FoamKinds.Spray, 100f)).Step(45);
                float time = 45 * Step;
                FoamParticle drop = stage.Read().Single();
                Assert.That(math.distance(FoamStage.Position(drop), start + velocity * time + 0.5f * Gravity * time * time), Is.LessThan(1e-2f));
                Assert.That(math.distance(FoamStage.Velocity(drop), velocity + Gravity * time), Is.LessThan(1e-2f));
            }
        }

        [Test]
        public void Spray_stays_in_the_box_and_bounces_off_its_walls()
        {
            using (var stage = new FoamStage(Air, FoamStage.Settings(0f)))
            {
                stage.Plant((new float3(35f, 20f, 20f), new float3(120f, 30f, 0f), FoamKinds.Spray, 100f)).Step(4);
                FoamParticle drop = stage.Read().Single();
                Assert.That(FoamStage.Velocity(drop).x, Is.EqualTo(-24f).Within(0.1f), "a fifth of the velocity comes back");
                Assert.That(FoamStage.Velocity(drop).y, Is.EqualTo(24f).Within(0.1f), "and it slides on more slowly");
                Assert.That(FoamStage.Position(drop).x, Is.InRange(35f, 40f));
            }
        }

        [Test]
        public void Spray_bounces_off_a_collider_however_fast_and_passes_beside_it()
        {
            ColliderMotion plate = ColliderTests.Still(ColliderShape.Box, new float3(0.5f, 10f, 10f), 20f, quaternion.identity);
            FoamParticle[] drops = Fly(2, plate, (new float3(8f, 20f, 20f), new float3(600f, 60f, 0f)),
                (new float3(8f, 35f, 20f), new float3(600f, 0f, 0f)));
            Assert.That(FoamStage.Velocity(drops[0]),
                Is.EqualTo(new float3(-120f, 48f, 0f)).Using<float3>((a, b) => math.distance(a, b) < 0.1f ? 0 : 1),
                "10 d in a step, and the plate is 1 d thick");
            Assert.That(FoamStage.Position(drops[0]).x, Is.LessThan(19.5f));
            Assert.That(FoamStage.Position(drops[1]).x, Is.EqualTo(28f).Within(0.1f));
        }

        [Test]
        public void A_collider_that_moves_takes_spray_along()
        {
            ColliderMotion plate = ColliderTests.Still(ColliderShape.Box, new float3(1f, 10f, 10f), new float3(12f, 20f, 20f), quaternion.identity);
            plate.end.position.x += 2f;
            FoamParticle drop = Fly(1, plate, (new float3(14.2f, 20f, 20f), float3.zero)).Single();
            Assert.That(FoamStage.Velocity(drop).x, Is.EqualTo(1.2f * 120f).Within(0.5f));
            Assert.That(FoamStage.Position(drop).x, Is.EqualTo(15f).Within(0.2f));
        }

        [Test]
        public void Spray_in_a_ball_that_is_hollow_stays_in_it()
        {
            ColliderMotion ball = ColliderTests.Still(ColliderShape.Sphere, new float3(8f, 0f, 0f), 20f, quaternion.identity);
            ball.insideOut = true;
            var random = new Unity.Mathematics.Random(6u);
            float[] distances = Fly(30, ball, Enumerable.Range(0, 100).Select(_ => (new float3(20f), 300f * random.NextFloat3Direction())).ToArray())
                .Where(drop => FoamStage.Kind(drop) == FoamKinds.Spray).Select(drop => math.distance(FoamStage.Position(drop), 20f)).ToArray();
            Assert.That(distances.Length, Is.GreaterThan(80), "the others met what water there is");
            Assert.That(distances.Max(), Is.InRange(5f, 8f));
        }

        // Spray in a box of 40 d with a collider and hardly any water, after so many steps of the whole solver.
        static FoamParticle[] Fly(int steps, ColliderMotion collider, params (float3 position, float3 velocity)[] spray)
        {
            const float spacing = 0.05f;
            using (var fluid = new TestFluid(40f * spacing, spacing, 8))
            {
                fluid.Input.gravity = 0f;
                fluid.Input.foam = FoamStage.Settings(0f);
                fluid.AddBlock((collider.insideOut ? new float3(19f, 13f, 19f) : 0f) * spacing, 2f * spacing).Step();
                ColliderTests.Use(fluid, collider);
                FoamStage.Plant(fluid.Solver.Foam, spray.Select(drop => (drop.position, drop.velocity, FoamKinds.Spray, 100f)).ToArray());
                fluid.Step(steps);
                return GpuTest.Read<FoamParticle>(fluid.Solver.Foam.Particles,
                    (int)GpuTest.Read<uint>(fluid.Solver.Foam.Counters, Foam.CounterCount)[(int)FoamCounter.Alive]);
            }
        }

        [Test]
        public void Spray_that_falls_into_water_becomes_foam()
        {
            using (var stage = new FoamStage(Pool(), FoamStage.Settings(0f), Gravity))
            {
                stage.Plant((new float3(12f, 18f, 12f), float3.zero, FoamKinds.Spray, 100f)).Step(10);
                Assert.That(FoamStage.Kind(stage.Read().Single()), Is.EqualTo(FoamKinds.Spray), "as it falls");
                stage.Step(30);
                FoamParticle foam = stage.Read().Single();
                Assert.That(FoamStage.Kind(foam), Is.EqualTo(FoamKinds.Foam));
                Assert.That(FoamStage.Position(foam).y, Is.EqualTo(12f).Within(1f), "at the surface");
            }
        }

        // Sides of 4 cells of two spacings and a last, narrower one: half of it, a tenth, and none.
        [Test]
        public void What_flows_and_how_full_it_is_are_those_of_each_cell_the_last_and_narrower_ones_too()
        {
            var box = new float3(9f, 8.2f, 8f);
            var random = new Unity.Mathematics.Random(17u);
            float3[] positions = Enumerable.Range(0, 400).Select(_ => random.NextFloat3(0.1f, box - 0.1f)).ToArray();
            var state = new ParticleState(box, positions);
            for (int i = 0; i < state.Count; i++)
                state.velocities[i] = new float4(random.NextFloat3(-5f, 5f), 1f);
            using (var stage = new FoamStage(state, FoamStage.Settings(0f), fluidStep: 1e-4f))
            {
                stage.Step();
                var counts = new int3(5, 5, 4);
                float4[] cells = GpuTest.Read<float4>(stage.Foam.Cells, 100);
                Assert.That(stage.Foam.Cells.count, Is.EqualTo(100));
                int narrow = 0;
                for (int cell = 0; cell < 100; cell++)
                {
                    var at = new int3(cell % counts.x, cell / counts.x % counts.y, cell / (counts.x * counts.y));
                    double3 low = 2.0 * (double3)at, high = math.min(low + 2.0, (double3)box), sum = 0.0;
                    int inside = 0, near = 0;
                    for (int i = 0; i < stage.Points.Length; i++)
                    {
                        double3 p = stage.Points[i];
                        near += math.cmin(math.abs(p - low)) < 1e-3 || math.cmin(math.abs(p - high)) < 1e-3 ? 1 : 0;
                        if (!math.all(p >= low) || !math.all(p < high))
                            continue;
                        inside++;
                        sum += stage.Velocities[i];
                    }
                    if (near > 0)
                        continue;
                    double volume = (high.x - low.x) * (high.y - low.y) * (high.z - low.z);
                    Assert.That(cells[cell].w, Is.EqualTo(math.min(inside / volume, 1.0)).Within(1e-4), $"fill of cell {at}");
                    Assert.That(math.distance(cells[cell].xyz, (float3)(sum / math.max(inside, 1))), Is.LessThan(1e-3f), $"flow of cell {at}");
                    narrow += math.any(high - low < 1.9) && inside > 0 && inside < volume ? 1 : 0;
                }
                Assert.That(narrow, Is.GreaterThan(3), "narrower cells that are neither empty nor full");
            }
        }

        [Test]
        public void A_bubble_rises_at_its_speed_and_becomes_foam_at_the_surface()
        {
            using (var stage = new FoamStage(Pool(), FoamStage.Settings(0f), Gravity))
            {
                stage.Plant((new float3(12f, 3f, 12f), float3.zero, FoamKinds.Bubbles, 100f)).Step(60);
                FoamParticle bubble = stage.Read().Single();
                const float rise = 0.1f * 20f;       // a tenth of the reference speed, d/s
                Assert.That(FoamStage.Kind(bubble), Is.EqualTo(FoamKinds.Bubbles));
                Assert.That(FoamStage.Velocity(bubble).y, Is.EqualTo(rise).Within(0.01f * rise));
                Assert.That(FoamStage.Position(bubble).y, Is.EqualTo(3f + rise).Within(0.3f), "less what it lost while it began to move");
                stage.Step(360);
                FoamParticle foam = stage.Read().Single();
                Assert.That(FoamStage.Kind(foam), Is.EqualTo(FoamKinds.Foam));
                Assert.That(FoamStage.Position(foam).y, Is.EqualTo(12f).Within(1f));
            }
        }

        [Test]
        public void Foam_moves_with_the_water_and_stays_at_its_surface()
        {
            using (var stage = new FoamStage(Pool(p => new float3(3f, 0f, -2f)), FoamStage.Settings(0f), Gravity))
            {
                stage.Plant(Enumerable.Range(0, 100)
                    .Select(i => (new float3(8f + 0.08f * i, 10.5f + 0.02f * i, 16f), float3.zero, FoamKinds.Foam, 100f)).ToArray())
                    .Step(120);
                FoamParticle[] foam = stage.Read();
                Assert.That(foam.Length, Is.EqualTo(100));
                for (int i = 0; i < foam.Length; i++)
                {
                    float3 position = FoamStage.Position(foam[i]);
                    Assert.That(FoamStage.Kind(foam[i]), Is.EqualTo(FoamKinds.Foam));
                    Assert.That(math.distance(position.xz, new float2(8f + 0.08f * i + 6f, 12f)), Is.LessThan(0.4f), $"path of {i}");
                    Assert.That(position.y, Is.EqualTo(12f).Within(1f), $"height of {i}");
                }
            }
        }

        [Test]
        public void Foam_above_and_below_the_surface_of_still_water_comes_to_it()
        {
            using (var stage = new FoamStage(Pool(), FoamStage.Settings(0f)))
            {
                stage.Plant((new float3(12f, 11.4f, 12f), float3.zero, FoamKinds.Foam, 100f),
                    (new float3(8f, 12.5f, 8f), float3.zero, FoamKinds.Foam, 100f));
                Assert.That(stage.Step(2).Read().Select(f => math.abs(FoamStage.Position(f).y - 12f)), Is.All.GreaterThan(0.2f), "not at once");
                Assert.That(stage.Step(40).Read().Select(f => math.abs(FoamStage.Position(f).y - 12f)), Is.All.LessThan(0.1f));
            }
        }

        [Test]
        public void Foam_that_is_not_finite_goes()
        {
            using (var stage = new FoamStage(Pool(), FoamStage.Settings(0f), Gravity))
            {
                float3 air = new float3(12f, 25f, 12f), water = new float3(12f, 5f, 12f);
                stage.Plant((air, new float3(float.NaN, 0f, 0f), FoamKinds.Spray, 9f),
                    (air, new float3(0f, float.PositiveInfinity, 0f), FoamKinds.Spray, 9f),
                    (water, new float3(0f, 0f, float.NaN), FoamKinds.Bubbles, 9f), (air, float3.zero, FoamKinds.Spray, 9f));
                FoamParticle left = stage.Step().Read().Single();
                Assert.That(FoamStage.Velocity(left).y, Is.EqualTo(Gravity.y * Step).Within(1e-4f), "the one that is finite");
            }
        }

        [Test, Category("LongRun")]
        public void Foam_rides_on_water_that_rises_and_falls()
        {
            using (var fluid = new TestFluid(new float3(0.8f, 1f, 0.8f), 0.05f, 5000))
            {
                fluid.Input.foam = FoamSettings.Default;
                fluid.Input.foam.amount = 0f;
                fluid.AddBlock(new float3(0f, 0f, 0f), new float3(0.8f, 0.4f, 0.8f)).Step(30);
                Foam foam = fluid.Solver.Foam;
                foam.Particles.SetData(new[] { new FoamParticle { a = new uint4(math.asuint(new float3(8f, 8f, 8f)), 0u),
                    b = new uint4(0u, 0u, 0u, 2u | 6400u << 2) } }, 0, 0, 1);
                foam.Counters.SetData(new[] { 1u, 0u, 0u, 0u, 0u, 0u, 0u, 0u });
                foam.Arguments.SetData(ParticleState.ArgumentsFor(1));
                float lowest = float.MaxValue, highest = 0f;
                for (int step = 0; step < 90; step++)
                {
                    // The box is tilted to and fro.
                    fluid.Input.gravity = 9.81f * math.normalize(new float3(0.3f * math.sin(step * 0.1f), -1f, 0f));
                    fluid.Step();
                    FoamParticle particle = GpuTest.Read<FoamParticle>(foam.Particles, 1)[0];
                    Assert.That(FoamStage.Kind(particle), Is.EqualTo(FoamKinds.Foam), $"step {step}");
                    float3 position = FoamStage.Position(particle);
                    ParticleState state = fluid.Read();
                    // of a column of full water
                    float surface = state.positions.Count(p => math.distance(p.xz, position.xz) < 2f) / (4f * math.PI);
                    Assert.That(position.y, Is.EqualTo(surface).Within(1.5f), $"height above the floor in step {step}");
                    lowest = math.min(lowest, surface);
                    highest = math.max(highest, surface);
                }
                Assert.That(highest - lowest, Is.GreaterThan(1f), "or nothing was followed");
            }
        }

        [Test]
        public void Foam_goes_when_its_time_is_over_and_spray_and_bubbles_live_four_times_as_long()
        {
            using (var stage = new FoamStage(Pool(), FoamStage.Settings(0f), Gravity * 0f))
            {
                stage.Plant((new float3(4f, 12f, 4f), float3.zero, FoamKinds.Foam, 0.5f),
                    (new float3(12f, 25f, 12f), float3.zero, FoamKinds.Spray, 0.5f),
                    (new float3(20f, 5f, 20f), float3.zero, FoamKinds.Bubbles, 0.5f));
                Assert.That(Kinds(stage.Step(29)), Is.EqualTo(new[] { FoamKinds.Foam, FoamKinds.Spray, FoamKinds.Bubbles }));
                Assert.That(Kinds(stage.Step(2)), Is.EqualTo(new[] { FoamKinds.Spray, FoamKinds.Bubbles }));
                Assert.That(Kinds(stage.Step(88)), Is.EqualTo(new[] { FoamKinds.Spray, FoamKinds.Bubbles }));
                Assert.That(Kinds(stage.Step(3)), Is.Empty);
            }

            FoamKinds[] Kinds(FoamStage stage) => stage.Read().Select(FoamStage.Kind).ToArray();
        }

        [Test]
        public void New_foam_lives_for_half_of_the_lifetime_to_all_of_it()
        {
            FoamSettings settings = FoamStage.Settings(4f);
            settings.lifetime = 8f;
            using (var stage = new FoamStage(ParticleState.Random(2000, seed: 3, speed: 12f), settings))
            {
                float[] lifetimes = stage.Step().Read().Select(FoamStage.Lifetime).ToArray();
                Assert.That(lifetimes.Length, Is.GreaterThan(200));
                Assert.That(lifetimes.Min(), Is.InRange(4f - 0.02f, 4.2f));
                Assert.That(lifetimes.Max(), Is.InRange(7.8f, 8f + 0.02f));
            }
        }

        [Test]
        public void Only_kinds_that_are_wanted_are_there([Values(FoamKinds.Spray, FoamKinds.Foam, FoamKinds.Bubbles)] FoamKinds kind)
        {
            FoamSettings settings = FoamStage.Settings(0f);
            settings.kinds = kind;
            using (var stage = new FoamStage(Pool(), settings))
            {
                stage.Plant((new float3(4f, 12f, 4f), float3.zero, FoamKinds.Foam, 9f),
                    (new float3(12f, 25f, 12f), float3.zero, FoamKinds.Spray, 9f),
                    (new float3(20f, 5f, 20f), float3.zero, FoamKinds.Bubbles, 9f));
                Assert.That(stage.Step().Read().Select(FoamStage.Kind), Is.EqualTo(new[] { kind }));
            }
        }

        [Test]
        public void Counts_are_those_of_the_particles([Values(1, 127, 128, 129, 997)] int count)
        {
            var random = new Unity.Mathematics.Random(7u);
            using (var stage = new FoamStage(Pool(), FoamStage.Settings(0f, count)))
            {
                stage.Plant(Enumerable.Range(0, count)
                    .Select(i => (random.NextFloat3(1f, 23f), float3.zero, (FoamKinds)(1 << i % 3), 0.2f + 0.01f * (i % 50))).ToArray());
                FoamParticle[] before = stage.Step().Read();
                for (int step = 0; step < 10; step++)
                {
                    FoamParticle[] foam = stage.Step().Read();
                    Assert.That(stage.Counter(FoamCounter.Spray), Is.EqualTo(foam.Count(f => FoamStage.Kind(f) == FoamKinds.Spray)));
                    Assert.That(stage.Counter(FoamCounter.Foam), Is.EqualTo(foam.Count(f => FoamStage.Kind(f) == FoamKinds.Foam)));
                    Assert.That(stage.Counter(FoamCounter.Bubbles), Is.EqualTo(foam.Count(f => FoamStage.Kind(f) == FoamKinds.Bubbles)));
                    Assert.That(foam.All(f => FoamStage.Kind(f) != 0));
                    int at = 0;
                    foreach (FoamParticle particle in before)
                        if (at < foam.Length && particle.b.w >> 2 == foam[at].b.w >> 2)
                            at++;
                    Assert.That(at, Is.EqualTo(foam.Length), "what is left keeps its order");
                    before = foam;
                }
            }
        }

        [Test]
        public void What_has_no_room_is_refused_and_counted_and_takes_nothing_away([Values(1, 128, 300)] int budget)
        {
            using (var stage = new FoamStage(ParticleState.Random(3000, seed: 6, speed: 12f), FoamStage.Settings(8f, budget)))
            {
                stage.Step();
                FoamParticle[] full = stage.Read();
                Assert.That(full.Length, Is.InRange((budget + 1) / 2, budget), "at least half of the room is taken at once");
                for (int step = 0; step < 9; step++)
                    stage.Step();
                Assert.That(stage.Counter(FoamCounter.Alive), Is.EqualTo(budget), "all of it in the end");
                Assert.That(stage.Counter(FoamCounter.Spawned) + stage.Counter(FoamCounter.Refused), Is.EqualTo(10 * Wanted(stage)));
                Assert.That(stage.Counter(FoamCounter.Spawned), Is.EqualTo(budget));
                Assert.That(stage.Read().Take(full.Length).Select(f => f.b.w >> 2), Is.EqualTo(full.Select(f => f.b.w >> 2)),
                    "those that were there first");
            }

            // All steps have the same number here, and so the same random numbers.
            uint Wanted(FoamStage stage) => (uint)GpuTest.Read<uint>(stage.Foam.SpawnCounts, 3000).Sum(c => c >> 16);
        }

        [Test]
        public void Refusals_are_spread_over_the_water()
        {
            using (var stage = new FoamStage(ParticleState.Random(20000, seed: 6, speed: 12f), FoamStage.Settings(8f, 500)))
            {
                FoamParticle[] foam = stage.Step().Read();
                float far = stage.Stages.Layout.DomainSize.z;
                int nearer = foam.Count(f => FoamStage.Position(f).z < 0.5f * far);
                Assert.That(nearer / (float)foam.Length, Is.EqualTo(0.5f).Within(0.1f), "in the nearer half, which memory has first");
            }
        }
    }
}
