using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill.Tests;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Editor.Tests
{
    /// <summary>Changes by a pass before a step act in that step and are accounted for.</summary>
    public class ParticleChangeTests
    {
        const float Spacing = 0.05f;

        // Far apart, so that none meets another.
        static SourceScene Apart(out float3[] points)
        {
            var scene = new SourceScene(new Vector3(2f, 2f, 2f), Spacing, 1000);
            scene.Fluid.Gravity = Vector3.zero;
            points = Enumerable.Range(0, 64).Select(i => (new float3(i % 4, i / 4 % 4, i / 16) - 1.5f) * 0.25f).ToArray();
            using (var positions = new NativeArray<float3>(points, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(points.Length, Allocator.Persistent))
                scene.Fluid.AddParticles(positions, velocities);
            return scene;
        }

        [Test]
        public void A_velocity_that_a_pass_sets_acts_in_that_step_and_on_no_other_particle([Values] bool turned)
        {
            using (SourceScene scene = Apart(out _))
            using (var pass = new ParticlePass(scene))
            {
                if (turned)
                    scene.Fluid.transform.rotation = Quaternion.Euler(30f, 80f, -50f);
                var before = pass.See().ToDictionary(p => p.id);
                var center = new Vector3(0.1f, 0f, 0.05f);
                var velocity = new Vector3(1f, 2f, -0.5f);
                pass.Before("Push", center, 0.35f, velocity);
                scene.Step();
                int pushed = 0;
                foreach (ParticlePass.Particle p in pass.See())
                {
                    bool isIn = math.distance(before[p.id].position, center) < 0.35f;
                    float3 expected = isIn ? (float3)velocity : 0f;
                    Assert.That(math.distance(p.velocity, expected), Is.LessThan(1e-4f), $"velocity of {p.id}");
                    Assert.That(math.distance(p.position, before[p.id].position + expected * SourceScene.Step60), Is.LessThan(1e-5f),
                        $"position of {p.id}");
                    pushed += isIn ? 1 : 0;
                }
                Assert.That(pushed, Is.InRange(5, 60));
            }
        }

        // Acts like gravity, whatever the numerical damping takes of a change at once.
        [Test]
        public void An_acceleration_that_lasts_adds_up_as_it_should([Values(1f, 0f)] float numericalDamping, [Values(1, 3)] int substeps)
        {
            using (SourceScene scene = Apart(out _))
            using (var pass = new ParticlePass(scene))
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.numericalDamping = numericalDamping;
                settings.substeps = substeps;
                scene.Fluid.Settings = settings;
                const int Steps = 20;
                pass.Before("Accelerate", Vector3.zero, 10f, new Vector3(2f, 0f, 1f));
                scene.Step(Steps);      // an acceleration that is new is not taken to last at once
                var before = pass.See().ToDictionary(p => p.id, p => p.velocity);
                scene.Step(Steps);
                float3 expected = new float3(2f, 0f, 1f) * Steps * SourceScene.Step60;
                float[] gained = pass.See().Select(p => math.dot(p.velocity - before[p.id], expected) / math.lengthsq(expected)).ToArray();
                TestContext.Out.WriteLine($"{gained.Min():0.000} to {gained.Max():0.000} of a t");
                Assert.That(gained.Min(), Is.GreaterThan(0.99f));
                Assert.That(gained.Max(), Is.LessThan(1.01f));
            }
        }

        [Test]
        public void Particles_that_a_pass_kills_are_gone_in_that_step_and_counted_and_no_others([Values] bool sleeps, [Values] bool withOthers)
        {
            using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 6000).Fill(0.5f))
            using (var pass = new ParticlePass(scene))
            {
                if (sleeps)
                    LetSleep(scene);
                if (withOthers)
                {
                    scene.Add<FluidEmitter>(new Vector3(0f, 0.3f, 0f), Vector3.down, e => { e.Rate = 0.02f; e.Size = 0.2f * Vector3.one; });
                    scene.Add<FluidDrain>(new Vector3(0.4f, -0.4f, 0f), Vector3.forward, d => d.Size = 0.1f * Vector3.one);
                    scene.Step(8);
                }
                ParticlePass.Particle[] before = pass.See();
                int drained = scene.Count(ParticleCounter.Drained);
                var center = new Vector3(-0.1f, -0.3f, 0.05f);
                var marked = new HashSet<uint>(before.Where(p => math.distance(p.position, center) < 0.2f).Select(p => p.id));
                Assert.That(marked.Count, Is.GreaterThan(100));
                pass.Before("Kill", center, 0.2f);
                scene.Step();
                pass.End();
                var left = new HashSet<uint>(pass.See().Select(p => p.id));
                Assert.That(marked.Any(left.Contains), Is.False, "a marked particle is left");
                if (!withOthers)
                    Assert.That(left.Count, Is.EqualTo(before.Length - marked.Count));
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.drained - drained, withOthers ? Is.GreaterThanOrEqualTo(marked.Count) : Is.EqualTo(marked.Count));
                Assert.That(statistics.nonFinite, Is.Zero);
                scene.Step(3);
                scene.AssertConserved();
            }
        }

        [Test]
        public void A_pass_can_kill_every_particle_and_more_can_come()
        {
            using (SourceScene scene = Apart(out float3[] positions))
            using (var pass = new ParticlePass(scene))
            {
                pass.Before("Kill", Vector3.zero, 10f);
                scene.Step(2);
                Assert.That(scene.AssertConserved().drained, Is.EqualTo(positions.Length));
                Assert.That(pass.See(), Is.Empty);
                pass.End();
                scene.Add<FluidEmitter>(Vector3.zero, Vector3.down, e => e.Rate = 0.01f);
                scene.Step(10);
                Assert.That(scene.AssertConserved().particles, Is.GreaterThan(10));
            }
        }

        static void LetSleep(SourceScene scene)
        {
            SolverSettings settings = scene.Fluid.Settings;
            settings.sleepSpeed = 0.5f;
            scene.Fluid.Settings = settings;
            scene.Step(60);
            Assert.That(GpuTest.Read<uint>(scene.Fluid.Solver.Resting.States, 1)[0], Is.Zero, "asleep");
        }

        // Mean speeds of a region count: slower than the sleep speed is not a motion.
        [TestCase(1f, true)]
        [TestCase(0.1f, false)]
        public void Water_that_sleeps_wakes_in_the_step_that_pushes_it_faster_than_the_sleep_speed(float speed, bool wakes)
        {
            using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 6000).Fill(0.5f))
            using (var pass = new ParticlePass(scene))
            {
                LetSleep(scene);
                var before = pass.See().ToDictionary(p => p.id, p => p.position);
                pass.Before("Push", Vector3.zero, 10f, speed * Vector3.up);
                scene.Step();
                float[] risen = pass.See().Select(p => (p.position - before[p.id]).y).ToArray();
                TestContext.Out.WriteLine($"risen by {risen.Average() / Spacing:0.000} d");
                if (wakes)
                    Assert.That(risen.Average(), Is.GreaterThan(0.5f * speed * SourceScene.Step60));
                else
                    Assert.That(risen.Max(), Is.Zero);
            }
        }

        [Test]
        public void Water_that_sleeps_falls_into_a_hole_that_a_pass_kills()
        {
            using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 6000).Fill(0.5f))
            using (var pass = new ParticlePass(scene))
            {
                LetSleep(scene);
                pass.Before("Kill", new Vector3(0f, -0.4f, 0f), 0.2f);
                scene.Step();
                pass.End();
                scene.Step(30);
                int inHole = pass.See().Count(p => math.distance(p.position, new float3(0f, -0.4f, 0f)) < 0.15f);
                Assert.That(inHole, Is.GreaterThan(20));
            }
        }

        [Test]
        public void A_phase_that_a_pass_sets_stays_with_its_particles_and_leaves_their_lifetime([Values] bool withLifetimes)
        {
            using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 6000).Fill(0.4f))
            using (var pass = new ParticlePass(scene))
            {
                if (withLifetimes)
                {
                    scene.Add<FluidEmitter>(new Vector3(0f, 0.3f, 0f), Vector3.down, e => { e.Rate = 0.01f; e.Lifetime = 0.2f; e.Phase = 1; });
                    scene.Step(6);
                    Assert.That(scene.Count(ParticleCounter.Emitted), Is.GreaterThan(5));
                }
                scene.Fluid.TrackPhases = true;
                var before = pass.See().ToDictionary(p => p.id);
                var center = new Vector3(0f, 0f, 0.05f);
                pass.Before("Tag", center, 0.35f, default, 5);
                scene.Step();
                pass.End();
                int tagged = 0;
                for (int step = 0; step < 20; step++)
                {
                    foreach (ParticlePass.Particle p in pass.See())
                    {
                        if (!before.TryGetValue(p.id, out ParticlePass.Particle was))
                            continue;
                        bool isIn = math.distance(was.position, center) < 0.35f;
                        Assert.That(p.phase, Is.EqualTo(isIn ? 5u : was.phase), $"particle {p.id} after {step + 1} steps");
                        tagged += isIn ? 1 : 0;
                    }
                    scene.Step();
                }
                Assert.That(tagged, Is.GreaterThan(1000));
                if (withLifetimes)
                {
                    Assert.That(before.Values.Count(p => p.phase == 1 && math.distance(p.position, center) < 0.35f), Is.GreaterThan(5),
                        "with a lifetime and tagged");
                    Assert.That(pass.See().Any(p => before.TryGetValue(p.id, out ParticlePass.Particle was) && was.phase == 1), Is.False,
                        "their time is over");
                    scene.AssertConserved();
                }
                scene.Fluid.TrackPhases = false;
                scene.Fluid.Restart();
                Assert.That(pass.See().All(p => p.phase == 0));
            }
        }

        [Test]
        public void A_velocity_that_is_not_finite_removes_its_particle_and_counts_it_as_such()
        {
            using (SourceScene scene = Apart(out float3[] positions))
            using (var pass = new ParticlePass(scene))
            {
                pass.Before("Poison", Vector3.zero, 0.3f);
                scene.Step();
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.nonFinite, Is.EqualTo(positions.Count(p => math.length(p) < 0.3f)).And.GreaterThan(0));
                Assert.That(statistics.drained, Is.Zero);
            }
        }

        [Test]
        public void A_pass_is_called_once_for_each_step_of_a_frame_and_not_while_time_stands_still()
        {
            using (SourceScene scene = Apart(out _))
            {
                int calls = 0;
                Action<CommandBuffer, FluidParticles> count = (commands, particles) => calls++;
                scene.Fluid.BeforeStep += count;
                scene.Fluid.Advance(3f * SourceScene.Step60);
                Assert.That(calls, Is.EqualTo(3).And.EqualTo(scene.Fluid.StepCount));
                scene.Fluid.Paused = true;
                scene.Step(2);
                Assert.That(calls, Is.EqualTo(3));
                scene.Fluid.Paused = false;
                scene.Fluid.BeforeStep -= count;
                scene.Step();
                Assert.That(calls, Is.EqualTo(3));
            }
        }

        [Test]
        public void A_pass_that_throws_is_logged_and_the_others_go_on()
        {
            using (SourceScene scene = Apart(out float3[] positions))
            using (var pass = new ParticlePass(scene))
            {
                scene.Fluid.BeforeStep += (commands, particles) => throw new ArgumentException("planted");
                pass.Before("Kill", Vector3.zero, 10f);
                LogAssert.Expect(LogType.Exception, new Regex("ArgumentException: planted"));
                scene.Step();
                Assert.That(scene.Fluid.IsRunning);
                Assert.That(scene.Count(ParticleCounter.Drained), Is.EqualTo(positions.Length));
            }
        }

        [Test]
        public void A_pass_may_disable_its_fluid_and_may_not_start_it_again()
        {
            using (SourceScene scene = Apart(out _))
            {
                Action<CommandBuffer, FluidParticles> restart = (commands, particles) => scene.Fluid.Restart();
                scene.Fluid.BeforeStep += restart;
                LogAssert.Expect(LogType.Exception, new Regex("cannot start again in a pass of BeforeStep.*call Restart or Restore in Update"));
                scene.Step();
                scene.Fluid.BeforeStep -= restart;
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(1));

                scene.Fluid.BeforeStep += (commands, particles) => scene.Fluid.enabled = false;
                scene.Step();
                Assert.That(scene.Fluid.IsRunning, Is.False);
                scene.Fluid.enabled = true;
                Assert.That(scene.Fluid.IsRunning);
            }
        }

        [Test]
        public void The_snippet_of_the_manual_turns_and_removes_particles()
        {
            using (SourceScene scene = Apart(out float3[] positions))
            {
                ManualSnippets.ChangeParticles(scene.Fluid, LayoutProbes.Load("Turn"),
                    new Vector4(positions[0].x, positions[0].y, positions[0].z, 0f));
                scene.Step(3);
                Assert.That(scene.AssertConserved().drained, Is.EqualTo(1));
                int turned = scene.Read().velocities.Count(v => math.length(v.xyz) > 0f);
                Assert.That(turned, Is.EqualTo(2), "a neighbor on its side of each horizontal axis; none above, on the axis");
            }
        }

        [Test]
        public void A_pass_that_does_nothing_leaves_the_fluid_bit_by_bit_as_it_is()
        {
            ParticleState[] states = new[] { false, true }.Select(with =>
            {
                using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 6000).Fill(0.5f))
                {
                    if (with)
                        scene.Fluid.BeforeStep += (commands, particles) => particles.SortNeighbors(commands);
                    scene.Add<FluidEmitter>(new Vector3(0f, 0.3f, 0f), Vector3.down, e => e.Rate = 0.01f);
                    return scene.Step(15).Read();
                }
            }).ToArray();
            TestFluid.AssertSame(states[1], states[0]);
        }
    }
}
