using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Drains and lifetimes, judged by counts and by who is left.</summary>
    public class DrainTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void All_that_is_inside_a_drain_goes_and_nothing_else([Values(DrainShape.Box, DrainShape.Sphere)] DrainShape shape)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 5000).Fill(0.5f))
            {
                ParticleState before = scene.Read();
                FluidDrain drain = scene.Add<FluidDrain>(new Vector3(0.1f, -0.2f, 0f), new Vector3(1f, 0.3f, 0.5f), d =>
                {
                    d.Shape = shape;
                    d.Size = new Vector3(0.6f, 0.2f, 0.4f);
                    d.Radius = 0.27f;
                });
                uint[] expected = Enumerable.Range(0, before.Count).Where(i => !IsInside(drain, before.positions[i].xyz * Spacing - 0.5f))
                    .Select(i => before.ids[i]).OrderBy(id => id).ToArray();
                scene.Step();
                uint[] left = scene.Read().ids.OrderBy(id => id).ToArray();
                Assert.That(before.Count - expected.Length, Is.GreaterThan(100));
                Compare.Same("ids", left, expected);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.drained, Is.EqualTo(before.Count - expected.Length));
                Assert.That(statistics.nonFinite, Is.Zero);
                scene.ReadBack();
                Assert.That(drain.Drained, Is.EqualTo(statistics.drained));
            }
        }

        // Slow and obvious, by the component's own numbers.
        static bool IsInside(FluidDrain drain, float3 world)
        {
            float3 local = Quaternion.Inverse(drain.transform.rotation) * ((Vector3)world - drain.transform.position);
            return drain.Shape == DrainShape.Sphere ? math.length(local) <= drain.Radius : math.all(math.abs(local) <= (float3)drain.Size * 0.5f);
        }

        // Particles that do not meet: each goes straight. A drain that moves takes what it moves over too.
        [Test]
        public void What_comes_through_a_drain_within_a_step_goes_and_nothing_else(
            [Values(DrainShape.Box, DrainShape.Sphere)] DrainShape shape, [Values] bool moves, [Values(1, 3)] int substeps)
        {
            using (var scene = new SourceScene(new Vector3(2f, 2f, 2f), Spacing, 1000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                SolverSettings settings = scene.Fluid.Settings;
                settings.substeps = substeps;
                scene.Fluid.Settings = settings;
                var random = new Unity.Mathematics.Random(9u);
                float3[] points = Enumerable.Range(0, 512).Select(i => (new float3(i % 8, i / 8 % 8, i / 64) - 3.5f) * 0.22f).ToArray();
                using (var positions = new Unity.Collections.NativeArray<float3>(points, Unity.Collections.Allocator.Persistent))
                using (var velocities = new Unity.Collections.NativeArray<float3>(points.Select(_ => 20f * random.NextFloat3Direction())
                    .ToArray(), Unity.Collections.Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, velocities);
                FluidDrain drain = scene.Add<FluidDrain>(new Vector3(0f, 5f, 0f), new Vector3(1f, 0.3f, 0.5f), d =>
                {
                    d.Shape = shape;
                    d.Size = new Vector3(1.4f, 1.2f, 0.01f);
                    d.Radius = 0.15f;
                });
                Move(drain, moves, new Vector3(0.1f, -0.3f, 0.2f), 0f);
                ParticleState before = scene.Read();
                ParticleState after = scene.Step().Read();
                Assert.That(after.Count, Is.GreaterThan(300));
                var from = Enumerable.Range(0, before.Count).ToDictionary(i => before.ids[i], i => before.positions[i].xyz * Spacing - 1f);
                (Vector3 position, Quaternion rotation) last = (drain.transform.position, drain.transform.rotation);
                Move(drain, moves, new Vector3(0.25f, 0.1f, -0.1f), 20f);
                var left = new System.Collections.Generic.HashSet<uint>(scene.Step().Read().ids);
                int gone = 0, crossed = 0;
                for (int i = 0; i < after.Count; i++)
                {
                    float3 a = Local(drain, last, from[after.ids[i]]),
                        b = Local(drain, (drain.transform.position, drain.transform.rotation), after.positions[i].xyz * Spacing - 1f);
                    if (Crosses(shape, a, b, 0.97f))
                        Assert.That(left.Contains(after.ids[i]), Is.False, $"{a} to {b} leads through");
                    if (!Crosses(shape, a, b, 1.03f))
                        Assert.That(left.Contains(after.ids[i]), $"{a} to {b} does not lead through");
                    gone += left.Contains(after.ids[i]) ? 0 : 1;
                    crossed += left.Contains(after.ids[i]) || Crosses(shape, b, b, 1f) ? 0 : 1;
                }
                TestContext.Out.WriteLine($"{gone} gone, {crossed} of them past it already");
                Assert.That(crossed, Is.GreaterThan(shape == DrainShape.Box ? 15 : 1));
                scene.AssertConserved();
            }
        }

        // Bounced particles count as coming from beyond the surface, no deeper than their path of a step: 0.17 m.
        [Test]
        public void A_drain_behind_a_plate_takes_what_bounced_no_further_behind_it_than_the_way_of_a_step(
            [Values(0f, 0.8f)] float bounciness, [Values(0.03f, 0.2f)] float depth)
        {
            using (var scene = new SourceScene(new Vector3(2f, 2f, 2f), Spacing, 100))
            {
                scene.Fluid.Gravity = Vector3.zero;
                var plate = new GameObject("Plate");
                plate.transform.SetParent(scene.Fluid.transform, false);
                FluidCollider collider = plate.AddComponent<FluidCollider>();
                collider.Shape = ColliderShape.Box;
                collider.Size = new Vector3(2f, 0.02f, 2f);
                collider.Bounciness = bounciness;
                scene.Add<FluidDrain>(new Vector3(0f, -0.01f - depth, 0f), Vector3.forward, d => d.Size = new Vector3(2f, 0.01f, 2f));
                using (var positions = new Unity.Collections.NativeArray<float3>(Enumerable.Range(0, 64)
                    .Select(i => new float3(i % 8 * 0.2f - 0.7f, 0.3f + i * 0.003f, i / 8 * 0.2f - 0.7f)).ToArray(),
                    Unity.Collections.Allocator.Persistent))
                using (var velocities = new Unity.Collections.NativeArray<float3>(Enumerable.Repeat(new float3(0f, -10f, 0f), 64).ToArray(),
                    Unity.Collections.Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, velocities);
                scene.Step(6);
                int drained = scene.AssertConserved().drained;
                TestContext.Out.WriteLine($"{drained} of 64 taken");
                Assert.That(drained, bounciness > 0f && depth < 0.1f ? Is.InRange(16, 63) : Is.Zero);
            }
        }

        [Test]
        public void A_drain_that_stops_taking_keeps_its_number()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 5000).Fill(0.2f))
            {
                FluidDrain drain = scene.Add<FluidDrain>(new Vector3(0f, -0.45f, 0f), Vector3.forward, d => d.Size = Vector3.one * 0.2f);
                Pass(scene, 20);
                int before = scene.Count(ParticleCounter.Drained);
                Assert.That(before, Is.GreaterThan(50));
                LogAssert.Expect(LogType.Warning, new Regex("has no size"));
                drain.Size = Vector3.zero;
                Pass(scene, 20);
                Assert.That(drain.Drained, Is.EqualTo(before).And.EqualTo(scene.Count(ParticleCounter.Drained)));
                drain.Size = Vector3.one * 0.2f;
                Pass(scene, 20);
                Assert.That(scene.Count(ParticleCounter.Drained), Is.GreaterThan(before));
                scene.ReadBack();
                Assert.That(drain.Drained, Is.EqualTo(scene.Count(ParticleCounter.Drained)));
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_drain_has_nothing_of_the_one_that_had_its_number([Values] bool takes)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 5000).Fill(0.2f))
            {
                FluidDrain first = scene.Add<FluidDrain>(new Vector3(0f, -0.45f, 0f), Vector3.forward, d => d.Size = Vector3.one * 0.2f);
                Pass(scene, 20);
                Assert.That(first.Drained, Is.GreaterThan(50));
                Object.DestroyImmediate(first.gameObject);
                if (!takes)
                    LogAssert.Expect(LogType.Warning, new Regex("has no size"));
                FluidDrain second = scene.Add<FluidDrain>(new Vector3(0f, 0.4f, 0f), Vector3.forward,
                    d => d.Size = Vector3.one * (takes ? 0.1f : 0f));
                Pass(scene, 1);
                Assert.That(second.Drained, Is.Zero);
                Pass(scene, 20);
                scene.ReadBack();
                Assert.That(second.Drained, Is.Zero);
            }
            LogAssert.NoUnexpectedReceived();
        }

        // Frames as they come: each brings back what was asked for before it.
        static void Pass(SourceScene scene, int steps)
        {
            for (int i = 0; i < steps; i++)
            {
                scene.Step();
                AsyncGPUReadback.WaitAllRequests();
            }
        }

        static void Move(FluidDrain drain, bool moves, Vector3 to, float angle)
        {
            if (!moves && angle != 0f)
                return;
            drain.transform.SetPositionAndRotation(to, Quaternion.Euler(angle, 0f, 0f) * drain.transform.rotation);
            if (!moves)
                drain.Teleport();
        }

        // In units of half its size.
        static float3 Local(FluidDrain drain, (Vector3 position, Quaternion rotation) pose, float3 world)
        {
            float3 local = Quaternion.Inverse(pose.rotation) * ((Vector3)world - pose.position);
            return drain.Shape == DrainShape.Sphere ? local / drain.Radius : local / (0.5f * (float3)drain.Size);
        }

        // Slow and obvious, by positions along the path.
        static bool Crosses(DrainShape shape, float3 a, float3 b, float size)
        {
            for (int i = 0; i <= 5000; i++)
            {
                float3 p = math.lerp(a, b, i / 5000f);
                if (shape == DrainShape.Sphere ? math.length(p) <= size : math.all(math.abs(p) <= size))
                    return true;
            }
            return false;
        }

        [Test, Category("LongRun")]
        public void Nobody_in_a_fast_jet_gets_past_a_thin_drain([Values(1, 3)] int substeps, [Values(10f, 40f)] float speed,
            [Values(0f, 0.005f)] float limit)
        {
            using (var scene = new SourceScene(new Vector3(2f, 2f, 2f), Spacing, 5000))
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.substeps = substeps;
                scene.Fluid.Settings = settings;
                scene.Add<FluidEmitter>(new Vector3(-0.95f, 0f, 0f), Vector3.right, emitter =>
                {
                    emitter.Rate = 0.02f;
                    emitter.Speed = speed;
                });
                FluidDrain drain = scene.Add<FluidDrain>(new Vector3(0f, 0f, 0f), Vector3.right, d =>
                {
                    d.Size = new Vector3(2f, 2f, 0.01f);
                    d.RateLimit = limit;
                });
                int past = 0;
                for (int i = 1; i <= 40; i++)
                {
                    scene.Step();
                    // Particles that passed it in this step are removed at the start of the next.
                    past = scene.Read().positions.Count(p => p.x * Spacing - 1f > speed / 60f + 0.05f);
                    if (limit == 0f)
                        Assert.That(past, Is.Zero, $"step {i}");
                }
                FluidStatistics statistics = scene.AssertConserved();
                if (limit == 0f)
                    Assert.That(statistics.drained, Is.GreaterThan(0.7f * statistics.emitted));
                else
                    Assert.That(statistics.drained, Is.InRange(5, (int)(limit * 40 / 60 / scene.ParticleVolume) + 1));
            }
        }

        // The path that counts is that of the step before, in as many substeps as that had: others would look back too far, or not far enough.
        [Test]
        public void Nobody_gets_past_a_thin_drain_when_the_substeps_change([Values(1, 4)] int substeps)
        {
            using (var scene = new SourceScene(new Vector3(4f, 2f, 2f), Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.Add<FluidDrain>(Vector3.zero, Vector3.right, d => d.Size = new Vector3(2f, 2f, 0.01f));
                // One crosses the drain in the second step, one begins a step and a half beyond it and one will be as far before it.
                using (var positions = new Unity.Collections.NativeArray<float3>(new[] { new float3(-0.75f, 0.5f, 0f),
                    new float3(0.75f, 0f, 0.5f), new float3(-1.75f, -0.5f, 0f) }, Unity.Collections.Allocator.Persistent))
                using (var velocities = new Unity.Collections.NativeArray<float3>(new[] { new float3(30f, 0f, 0f), new float3(30f, 0f, 0f),
                    new float3(30f, 0f, 0f) }, Unity.Collections.Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, velocities);
                for (int i = 0; i < 3; i++)
                {
                    SolverSettings settings = scene.Fluid.Settings;
                    settings.substeps = i < 2 ? substeps : 5 - substeps;
                    scene.Fluid.Settings = settings;
                    scene.Step();
                }
                Assert.That(scene.AssertConserved().drained, Is.EqualTo(1));
            }
        }

        // Neither came through it: what code adds beyond it, and what an emitter beside it lets in the other direction.
        [Test]
        public void What_begins_beyond_a_drain_has_not_come_through_it()
        {
            using (var scene = new SourceScene(new Vector3(2f, 2f, 2f), Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.Add<FluidDrain>(new Vector3(-0.93f, 0f, 0f), Vector3.right, d => d.Size = new Vector3(2f, 2f, 0.01f));
                scene.Add<FluidEmitter>(new Vector3(-0.9f, 0f, 0f), Vector3.right, emitter =>
                {
                    emitter.Rate = 0.02f;
                    emitter.Speed = 6f;
                });
                for (int i = 0; i < 5; i++)
                    scene.Step().Measure();     // which orders the particles again, those just let in too
                using (var positions = new Unity.Collections.NativeArray<float3>(new[] { new float3(-0.85f, 0.5f, 0.5f),
                new float3(-0.85f, -0.5f, 0.5f) }, Unity.Collections.Allocator.Persistent))
                using (var velocities = new Unity.Collections.NativeArray<float3>(new[] { new float3(10f, 0f, 0f),
                    new float3(10f, 0f, 0f) }, Unity.Collections.Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, velocities);
                scene.Measure();
                scene.Step(5);
                Assert.That(scene.AssertConserved().drained, Is.Zero);
            }
        }

        [Test]
        public void A_drain_with_a_limit_takes_out_the_limit_times_the_time([Values(0.0007f, 0.01f, 0.06f)] float limit)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 5000).Fill(0.5f))
            {
                scene.Add<FluidDrain>(new Vector3(0f, -0.3f, 0f), Vector3.forward, drain =>
                {
                    drain.Size = new Vector3(1f, 0.4f, 1f);
                    drain.RateLimit = limit;
                });
                for (int i = 1; i <= 30; i++)
                {
                    scene.Step();
                    double most = limit * i / 60.0 / scene.ParticleVolume;
                    Assert.That(scene.Count(ParticleCounter.Drained), Is.LessThanOrEqualTo((int)(most + 1e-3)));
                }
                double all = limit * 0.5 / scene.ParticleVolume;
                Assert.That(scene.Count(ParticleCounter.Drained), Is.InRange((int)all - 5, (int)(all + 1e-3)),
                    "of a few thousand, up to five have the next lot");
                scene.AssertConserved();
            }
        }

        [Test]
        public void A_drain_with_a_limit_takes_from_everywhere_inside()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 8000).Fill(1f))
            {
                ParticleState before = scene.Read();
                scene.Add<FluidDrain>(Vector3.zero, Vector3.forward, drain =>
                {
                    drain.Size = Vector3.one * 1.1f;
                    drain.RateLimit = 30f;      // half of all in the first step
                });
                scene.Step();
                var left = scene.Read().ids.ToLookup(id => id);
                float3[] gone = Enumerable.Range(0, before.Count).Where(i => !left.Contains(before.ids[i]))
                    .Select(i => before.positions[i].xyz).ToArray();
                Assert.That(gone.Length, Is.InRange(3900, 4000));
                for (int octant = 0; octant < 8; octant++)
                {
                    var corner = new float3(octant & 1, octant >> 1 & 1, octant >> 2);
                    Assert.That(gone.Count(p => math.all((p > 10f) == (corner > 0.5f))), Is.InRange(430, 560));
                }
            }
        }

        [Test, Category("LongRun")]
        public void What_a_drain_recycles_comes_back_and_the_count_stays([Values(0, 400)] int room)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 1600 + room).Fill(0.2f))
            {
                FluidEmitter fountain = scene.Add<FluidEmitter>(new Vector3(0f, 0.3f, 0f), Vector3.up, emitter =>
                {
                    emitter.Rate = 0f;
                    emitter.Speed = 1.5f;
                    emitter.Radius = 0.12f;
                });
                scene.Add<FluidDrain>(new Vector3(0.3f, -0.45f, 0f), Vector3.up, drain =>
                {
                    drain.Size = new Vector3(0.3f, 0.3f, 0.1f);
                    drain.RateLimit = 0.02f;
                    drain.RecycleTo = fountain;
                });
                for (int i = 0; i < 30; i++)
                {
                    scene.Step(5);
                    FluidStatistics now = scene.AssertConserved();
                    Assert.That(now.particles + now.recycling, Is.EqualTo(1600));
                    Assert.That(now.particles, Is.InRange(1570, 1600), "no more come back than went");
                }
                FluidStatistics statistics = scene.Measure();
                TestContext.Out.WriteLine($"drained {statistics.drained}, pending {statistics.recycling}");
                Assert.That(statistics.drained, Is.GreaterThan(300));
                Assert.That(statistics.refused + statistics.blocked + statistics.waiting, Is.Zero);
            }
        }

        [Test]
        public void A_drain_inside_an_emitter_takes_all_and_the_counts_agree()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 300))
            {
                scene.Add<FluidEmitter>(Vector3.zero, Vector3.down, emitter => emitter.Rate = 0.03f);
                scene.Add<FluidDrain>(Vector3.zero, Vector3.down, drain => drain.Size = Vector3.one * 0.5f);
                for (int i = 0; i < 20; i++)
                {
                    scene.Step(3);
                    Assert.That(scene.AssertConserved().particles, Is.LessThan(10));
                }
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(240).Within(1));
            }
        }

        [Test]
        public void A_particle_lives_as_long_as_its_emitter_says_and_others_for_ever()
        {
            using (var scene = new SourceScene(new Vector3(1f, 2f, 1f), Spacing, 3000).Fill(0.1f))
            {
                scene.Add<FluidEmitter>(new Vector3(0.3f, 0.9f, 0f), Vector3.down, emitter =>
                {
                    emitter.Rate = 0.015f;      // 2 a step
                    emitter.Lifetime = 10f / 60f;
                });
                scene.Add<FluidEmitter>(new Vector3(-0.3f, 0.9f, 0f), Vector3.down, emitter => emitter.Rate = 0.0075f);
                for (int steps = 1; steps <= 40; steps++)
                {
                    scene.Step();
                    int mortal = scene.Count(ParticleCounter.Alive) - 800 - (int)(steps * 0.0075 / 60.0 / scene.ParticleVolume + 1e-3);
                    Assert.That(mortal, Is.EqualTo(2 * math.min(steps, 11)).Within(2), "let in at the end of a step, they take part in ten more");
                    Assert.That(scene.Count(ParticleCounter.Drained), Is.EqualTo(2 * math.max(steps - 11, 0)).Within(2));
                }
                scene.AssertConserved();
            }
        }

        [Test]
        public void Particles_added_by_code_have_neither_phase_nor_end_where_others_have()
        {
            using (var scene = new SourceScene(new Vector3(1f, 2f, 1f), Spacing, 3000))
            {
                scene.Add<FluidEmitter>(new Vector3(0.3f, 0.9f, 0f), Vector3.down, emitter =>
                {
                    emitter.Rate = 0.03f;
                    emitter.Phase = 5;
                    emitter.Lifetime = 0.1f;
                });
                scene.Step(30);
                using (var positions = new Unity.Collections.NativeArray<float3>(new[] { new float3(0f, -0.8f, 0f),
                    new float3(0.2f, -0.8f, 0f) }, Unity.Collections.Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, positions);
                scene.Step(20);
                ParticleState state = scene.Read();
                uint[] tags = GpuTest.Read<uint>(scene.Fluid.Solver.Tags, state.Count);
                Assert.That(tags.Count(tag => tag == 0), Is.EqualTo(2));
                Assert.That(tags.Where(tag => tag != 0).Select(tag => tag >> 24), Is.All.EqualTo(5));
                Assert.That(state.positions.Zip(tags, (p, tag) => (p, tag)).Where(pair => pair.tag == 0).Select(pair => pair.p.y * Spacing),
                    Is.All.LessThan(0.5f), "tags go with their particles");
                scene.AssertConserved();
            }
        }

        [Test]
        public void A_tag_stays_with_its_particle_through_every_sort()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 3000))
            {
                foreach (int phase in new[] { 1, 2, 3 })
                    scene.Add<FluidEmitter>(new Vector3(0.25f * (phase - 2), 0.4f, 0f), Vector3.down, emitter =>
                    {
                        emitter.Rate = 0.01f;
                        emitter.Phase = phase;
                    });
                var phases = new System.Collections.Generic.Dictionary<uint, uint>();
                for (int i = 0; i < 60; i++)
                {
                    scene.Step();
                    uint[] ids = scene.Read().ids;
                    uint[] tags = GpuTest.Read<uint>(scene.Fluid.Solver.Tags, ids.Length);
                    for (int p = 0; p < ids.Length; p++)
                    {
                        if (!phases.ContainsKey(ids[p]))
                            phases[ids[p]] = tags[p] >> 24;
                        Assert.That(tags[p] >> 24, Is.EqualTo(phases[ids[p]]));
                    }
                }
                Assert.That(phases.Values.GroupBy(phase => phase).Select(group => group.Count()), Is.EqualTo(new[] { 80, 80, 80 }).Within(1));
            }
        }

        [Test, Category("LongRun")]
        public void An_overfull_box_seeks_its_rest_density_again_once_it_has_drained([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (var scene = new SourceScene(new Vector3(0.5f, 0.5f, 0.5f), Spacing, 1500, deepWater))
            {
                float3[] points = Enumerable.Range(0, 1250)
                    .Select(i => (new float3(i % 10, i / 10 % 10, i / 100 * 0.8f) + 0.5f) * Spacing - 0.25f).ToArray();
                using (var positions = new Unity.Collections.NativeArray<float3>(points, Unity.Collections.Allocator.Persistent))
                using (var velocities = new Unity.Collections.NativeArray<float3>(points.Length, Unity.Collections.Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, velocities);
                FluidStatistics full = scene.Step(60).AssertConserved();
                Assert.That(full.densityError, Is.InRange(0.2f, 0.32f));
                Assert.That(full.jitter, Is.LessThan(0.15f));

                FluidDrain drain = scene.Add<FluidDrain>(Vector3.zero, Vector3.up, d =>
                {
                    d.Size = Vector3.one;
                    d.RateLimit = 0.2f;
                });
                scene.Step(20);         // 0.0667 m³ of 0.156
                Object.DestroyImmediate(drain.gameObject);
                FluidStatistics drained = scene.Step(100).AssertConserved();
                TestContext.Out.WriteLine($"{full.densityError:0.000} with {full.particles}, {drained.densityError:0.000} with " +
                    $"{drained.particles}, p99.9 {drained.densityError999:0.000}");
                Assert.That(drained.particles, Is.InRange(715, 725));
                Assert.That(drained.densityError, Is.LessThan(0.03f));
                Assert.That(drained.centerOfMass.y, Is.InRange(0.17f, 0.2f));
            }
        }

        [Test]
        public void Sleeping_water_wakes_above_a_drain()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 3000).Fill(0.3f))
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.sleepSpeed = 0.5f;
                scene.Fluid.Settings = settings;
                scene.Step(60);
                ParticleState asleep = scene.Read();
                scene.Step(5);
                TestFluid.AssertSame(scene.Read(), asleep);

                scene.Add<FluidDrain>(new Vector3(0f, -0.5f, 0f), Vector3.up, drain => drain.Size = Vector3.one * 0.3f);
                scene.Step(30);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.drained, Is.GreaterThan(700), "more than lay in it");
                Assert.That(statistics.centerOfMass.y, Is.LessThan(0.12f));
            }
        }

        [Test]
        public void Particles_let_into_a_sleeping_box_fall()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 3000).Fill(0.1f))
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.sleepSpeed = 0.5f;
                scene.Fluid.Settings = settings;
                scene.Step(60);
                scene.Add<FluidEmitter>(new Vector3(0f, 0.3f, 0f), Vector3.up, emitter =>
                {
                    emitter.Shape = EmitterShape.Box;
                    emitter.Mode = EmitterMode.Fill;
                    emitter.Speed = 0f;
                    emitter.Rate = 0.1f;
                    emitter.Duration = 0.05f;
                });
                scene.Step(5);
                float top = scene.AssertConserved().furthest.y;
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.GreaterThan(20));
                scene.Step(15);
                Assert.That(scene.Measure().furthest.y, Is.LessThan(top - 0.2f));
            }
        }
    }
}
