using System;
using System.Linq;
using NUnit.Framework;
using Rill.Tests;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Editor.Tests
{
    /// <summary>Compares what a project's shaders read of the particles with what the solver holds.</summary>
    public class ParticleContractTests
    {
        const float Spacing = 0.05f;

        static SourceScene Splash(bool turned = false)
        {
            var scene = new SourceScene(new Vector3(1.2f, 1f, 0.8f), Spacing, 5000).Fill(0.4f);
            if (turned)
            {
                scene.Fluid.transform.SetPositionAndRotation(new Vector3(3f, -2f, 7f), Quaternion.Euler(20f, 130f, -10f));
                scene.Fluid.Restart();
            }
            return scene;
        }

        [Test]
        public void A_shader_of_a_project_sees_positions_velocities_ids_and_phases_in_world_space([Values] bool turned)
        {
            using (SourceScene scene = Splash(turned))
            using (var pass = new ParticlePass(scene))
            {
                scene.Fluid.TrackPhases = true;
                FluidEmitter emitter = scene.Add<FluidEmitter>(scene.Fluid.transform.position + 0.3f * Vector3.up, Vector3.down,
                    e => { e.Phase = 3; e.Rate = 0.02f; e.Size = 0.2f * Vector3.one; });
                scene.Step(12);
                ParticleState state = scene.Read();
                ParticlePass.Particle[] seen = pass.See();
                uint[] tags = GpuTest.Read<uint>(pass.Particles.Phases, state.Count);
                FluidStatistics statistics = scene.AssertConserved();

                Assert.That(seen.Length, Is.EqualTo(statistics.particles).And.EqualTo(state.Count));
                Assert.That(statistics.emitted, Is.GreaterThan(20));
                Assert.That(seen.Count(p => p.phase == 3), Is.EqualTo(statistics.emitted));
                Assert.That(seen.Select(p => p.id).Distinct().Count(), Is.EqualTo(seen.Length), "ids");
                Matrix4x4 toWorld = scene.Fluid.DomainToWorld;
                for (int i = 0; i < seen.Length; i++)
                {
                    Assert.That(seen[i].id, Is.EqualTo(state.ids[i]));
                    Assert.That(seen[i].phase, Is.EqualTo(tags[i] >> 24));
                    Assert.That(math.distance(seen[i].position, toWorld.MultiplyPoint3x4(state.positions[i].xyz)), Is.LessThan(1e-5f));
                    Assert.That(math.distance(seen[i].velocity, toWorld.MultiplyVector(state.velocities[i].xyz)), Is.LessThan(1e-5f));
                }
            }
        }

        [Test]
        public void An_id_stays_with_its_particle_while_its_index_changes()
        {
            using (SourceScene scene = Splash())
            using (var pass = new ParticlePass(scene))
            {
                scene.Step(5);
                ParticlePass.Particle[] before = pass.See();
                scene.Step();
                ParticlePass.Particle[] after = pass.See();
                var at = after.Select((p, i) => (p.id, i)).ToDictionary(p => p.id, p => p.i);
                Assert.That(at.Count, Is.EqualTo(before.Length));
                float furthest = before.Max(p => math.distance(p.position, after[at[p.id]].position));
                Assert.That(furthest, Is.LessThan(0.5f * Spacing));
                int moved = Enumerable.Range(0, before.Length).Count(i => at[before[i].id] != i);
                TestContext.Out.WriteLine($"{moved} of {before.Length} particles have another index after one step");
                Assert.That(moved, Is.GreaterThan(0));
            }
        }

        [Test]
        public void A_particle_is_drawn_where_the_packages_own_renderers_draw_it()
        {
            using (SourceScene scene = Splash())
            using (var pass = new ParticlePass(scene))
            {
                scene.Step(10);
                scene.Fluid.Advance(SourceScene.Step60 * 0.5f);        // half a step after the state
                ParticleState state = scene.Read();
                float4[] starts = GpuTest.Read<float4>(scene.Fluid.Solver.StartPositions, state.Count);
                float lag = scene.Fluid.Clock.FrameLag.x;
                Assert.That(lag, Is.EqualTo(0.5f).Within(1e-3f));
                ParticlePass.Particle[] seen = pass.See();
                float longest = 0f;
                for (int i = 0; i < seen.Length; i++)
                {
                    float3 p = state.positions[i].xyz, path = lag * (p - starts[i].xyz);
                    float3 expected = scene.Fluid.DomainToWorld.MultiplyPoint3x4(math.clamp(p + path, math.min(p, 0.5f),
                        math.max(p, state.box - 0.5f)));
                    Assert.That(math.distance(seen[i].drawn, expected), Is.LessThan(1e-5f));
                    longest = math.max(longest, math.distance(seen[i].drawn, seen[i].position));
                }
                Assert.That(longest, Is.GreaterThan(0.01f * Spacing));
            }
        }

        public enum Around { Water, Colliders, Sleep, Emitter, Added, Statistics }

        // Every particle within the radius: after a step, beside what has just come, and after statistics have sorted in between.
        [Test]
        public void The_look_up_finds_every_neighbor_within_any_radius([Values] Around around, [Values(0.7f, 2f, 4.5f)] float radius)
        {
            using (SourceScene scene = Splash(true))
            using (var pass = new ParticlePass(scene))
            {
                Vector3 center = scene.Fluid.transform.position;
                if (around == Around.Colliders)
                {
                    var ball = new GameObject("Ball");
                    ball.transform.SetParent(scene.Fluid.transform, false);
                    FluidCollider collider = ball.AddComponent<FluidCollider>();
                    collider.Shape = ColliderShape.Sphere;
                    collider.Radius = 0.2f;
                }
                if (around == Around.Sleep)
                {
                    SolverSettings settings = scene.Fluid.Settings;
                    settings.sleepSpeed = 1f;
                    scene.Fluid.Settings = settings;
                }
                if (around == Around.Emitter)
                    scene.Add<FluidEmitter>(center + 0.3f * Vector3.up, Vector3.down, e => { e.Rate = 0.02f; e.Size = 0.2f * Vector3.one; });
                scene.Step(around == Around.Sleep ? 60 : 10);
                if (around == Around.Sleep)
                    Assert.That(GpuTest.Read<uint>(scene.Fluid.Solver.Resting.States, 1)[0], Is.Zero, "the water sleeps");
                if (around == Around.Added)
                    Add(scene.Fluid, center);
                if (around == Around.Statistics)
                    scene.Measure();

                uint2[] found = pass.Neighbors(radius * Spacing);
                ParticleState state = scene.Read();
                int most = 0;
                for (int i = 0; i < state.Count; i++)
                {
                    uint2 expected = 0;
                    bool isClose = false;
                    for (int j = 0; j < state.Count; j++)
                    {
                        float distance = math.distance(state.positions[i].xyz, state.positions[j].xyz);
                        isClose |= math.abs(distance - radius) < 1e-4f;        // either is right
                        if (j != i && distance < radius)
                            expected += new uint2(1, state.ids[j]);
                    }
                    if (!isClose)
                        Assert.That(found[i], Is.EqualTo(expected), $"particle {state.ids[i]}");
                    most = math.max(most, (int)expected.x);
                }
                TestContext.Out.WriteLine($"{state.Count} particles, up to {most} neighbors");
                Assert.That(most, Is.GreaterThan(radius < 1f ? 0 : 20));
            }
        }

        static void Add(FluidSimulation fluid, Vector3 center)
        {
            var random = new Unity.Mathematics.Random(5u);
            float3[] points = Enumerable.Range(0, 300)
                .Select(_ => (float3)(center + fluid.transform.rotation * (Vector3)random.NextFloat3(-0.35f, 0.35f))).ToArray();
            using (var positions = new Unity.Collections.NativeArray<float3>(points, Unity.Collections.Allocator.Persistent))
            using (var velocities = new Unity.Collections.NativeArray<float3>(points.Length, Unity.Collections.Allocator.Persistent))
                fluid.AddParticles(positions, velocities);
        }

        [Test]
        public void Particles_of_an_earlier_step_or_of_a_fluid_that_is_off_are_refused_by_name()
        {
            using (SourceScene scene = Splash())
            using (var pass = new ParticlePass(scene))
            {
                FluidParticles taken = pass.Particles;
                Assert.That(taken.IsCurrent);
                Assert.That(taken.Capacity, Is.EqualTo(5000));
                Assert.That(taken.Phases, Is.Null);
                scene.Step();
                AssertStale(taken);
                taken = pass.Particles;
                scene.Fluid.Restart();
                AssertStale(taken);
                taken = pass.Particles;
                scene.Fluid.enabled = false;
                AssertStale(taken);
                Assert.That(scene.Fluid.TryGetParticles(out FluidParticles none), Is.False);
                AssertStale(none);
            }
        }

        static void AssertStale(FluidParticles particles)
        {
            Assert.That(particles.IsCurrent, Is.False);
            Assert.That(() => particles.Positions, Throws.InvalidOperationException.With.Message.Contains("Call TryGetParticles again"));
            Assert.That(() => GpuTest.Run(cmd => particles.SortNeighbors(cmd)), Throws.InvalidOperationException);
        }

        [Test]
        public void A_kernel_with_other_groups_is_refused_with_what_to_write()
        {
            using (SourceScene scene = Splash())
            using (var pass = new ParticlePass(scene))
            {
                ArgumentException problem = Assert.Throws<ArgumentException>(() =>
                    GpuTest.Run(cmd => pass.Particles.Dispatch(cmd, pass.Shader, pass.Shader.FindKernel("Small"))));
                Assert.That(problem.Message, Does.Contain("groups of 64 x 1 x 1 threads").And.Contain("[numthreads(kRillThreads, 1, 1)]"));
                Assert.That(() => pass.Particles.Dispatch(null, pass.Shader, 0), Throws.ArgumentNullException);
                Assert.That(() => GpuTest.Run(cmd => pass.Particles.Bind(cmd, null, 0)), Throws.ArgumentNullException);
                Assert.That(() => pass.Particles.Bind(null), Throws.ArgumentNullException);
            }
        }
    }
}
