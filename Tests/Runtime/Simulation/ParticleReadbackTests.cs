using System;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Copies of the particles on the CPU: those of the step that was asked for, or a clear answer.</summary>
    public class ParticleReadbackTests
    {
        const float Spacing = 0.05f;

        static SourceScene Pool() => new SourceScene(new Vector3(1f, 0.8f, 0.6f), Spacing, 3000).Fill(0.3f);

        [Test]
        public void What_comes_back_are_the_particles_of_the_step_that_was_asked_for([Values] bool turned)
        {
            using (SourceScene scene = Pool())
            using (var readback = new ParticleReadback())
            {
                if (turned)
                    scene.Fluid.transform.SetPositionAndRotation(new Vector3(5f, 1f, -2f), Quaternion.Euler(10f, 200f, 30f));
                scene.Add<FluidEmitter>(scene.Fluid.transform.position + 0.2f * Vector3.up, Vector3.down, e => { e.Phase = 2; e.Rate = 0.01f; });
                scene.Step(10);
                Assert.That(scene.Fluid.RequestParticles(readback));
                Assert.That(readback.IsPending);
                Assert.That(readback.HasData, Is.False);
                Assert.That(readback.Outcome, Is.EqualTo(ReadbackOutcome.None));
                Assert.That(scene.Fluid.RequestParticles(readback), Is.False, "one is pending");
                Matrix4x4 toWorld = scene.Fluid.DomainToWorld;
                ParticleState state = scene.Read();
                uint[] tags = GpuTest.Read<uint>(scene.Fluid.Solver.Tags, state.Count);
                double time = scene.Fluid.FluidTime;

                scene.Step(3);
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(readback.IsPending, Is.False);
                Assert.That(readback.Outcome, Is.EqualTo(ReadbackOutcome.Arrived));
                Assert.That(readback.HasData);
                Assert.That(readback.Step, Is.EqualTo(10));
                Assert.That(readback.Time, Is.EqualTo(time));
                Assert.That(readback.Count, Is.EqualTo(state.Count));
                Compare.Same("ids", readback.Ids.ToArray(), state.ids);
                Compare.Same("phases", readback.Phases.ToArray(), tags.Select(tag => tag >> 24).ToArray());
                Assert.That(readback.Phases.ToArray().Count(phase => phase == 2), Is.GreaterThan(10));
                for (int i = 0; i < state.Count; i++)
                {
                    Assert.That(math.distance(readback.Positions[i], toWorld.MultiplyPoint3x4(state.positions[i].xyz)), Is.LessThan(1e-5f));
                    Assert.That(math.distance(readback.Velocities[i], toWorld.MultiplyVector(state.velocities[i].xyz)), Is.LessThan(1e-5f));
                }
            }
        }

        [Test]
        public void They_are_copied_into_arrays_of_the_caller_which_are_long_enough_or_refused_by_name()
        {
            using (SourceScene scene = Pool())
            using (var readback = new ParticleReadback())
            using (var positions = new NativeArray<float3>(3000, Allocator.Persistent))
            using (var ids = new NativeArray<uint>(3000, Allocator.Persistent))
            using (var few = new NativeArray<float3>(7, Allocator.Persistent))
            {
                scene.Step(2);
                scene.Fluid.RequestParticles(readback, ParticleFields.Positions | ParticleFields.Ids);
                Assert.That(() => readback.CopyTo(positions), Throws.InvalidOperationException.With.Message.Contains("have not come back yet"));
                AsyncGPUReadback.WaitAllRequests();
                int count = readback.CopyTo(positions, default, ids);
                ParticleState state = scene.Read();
                Assert.That(count, Is.EqualTo(state.Count));
                Compare.Same("ids", ids.ToArray().Take(count).ToArray(), state.ids);
                for (int i = 0; i < count; i++)
                    Assert.That(positions[i], Is.EqualTo(readback.Positions[i]));

                Assert.That(() => readback.CopyTo(few),
                    Throws.ArgumentException.With.Message.Contains("'positions' holds 7 elements").And.Message.Contains(
                    "FluidSimulation.Capacity, 3,000"));
                Assert.That(() => readback.CopyTo(positions, positions),
                    Throws.InvalidOperationException.With.Message.Contains("not for Velocities"));
                Assert.That(() => readback.Phases, Throws.InvalidOperationException.With.Message.Contains("not for Phases"));
            }
        }

        [Test]
        public void Several_requests_at_once_each_bring_their_own_step()
        {
            using (SourceScene scene = Pool())
            {
                ParticleReadback[] readbacks = Enumerable.Range(0, 4).Select(_ => new ParticleReadback()).ToArray();
                float[] heights = readbacks.Select(readback =>
                {
                    scene.Step();
                    Assert.That(scene.Fluid.RequestParticles(readback, ParticleFields.Positions));
                    return scene.Read().positions.Average(p => p.y) * Spacing - 0.4f;
                }).ToArray();
                AsyncGPUReadback.WaitAllRequests();
                for (int i = 0; i < readbacks.Length; i++)
                {
                    Assert.That(readbacks[i].Step, Is.EqualTo(i + 1));
                    Assert.That(readbacks[i].Positions.ToArray().Average(p => p.y), Is.EqualTo(heights[i]).Within(1e-4f));
                    readbacks[i].Dispose();
                }
                Assert.That(heights.Distinct().Count(), Is.EqualTo(4));
            }
        }

        public enum Interruption { Restart, Disable, DisableAndEnable, Destroy }

        [Test]
        public void A_request_that_the_fluid_does_not_outlast_ends_as_dropped([Values] Interruption interruption)
        {
            using (SourceScene scene = Pool())
            using (var readback = new ParticleReadback())
            {
                scene.Step(2);
                scene.Fluid.KeepStateOnDisable = false;
                scene.Fluid.RequestParticles(readback);
                FluidSimulation fluid = scene.Fluid;
                switch (interruption)
                {
                    case Interruption.Restart: fluid.Restart(); break;
                    case Interruption.Disable: fluid.enabled = false; break;
                    case Interruption.DisableAndEnable: fluid.enabled = false; fluid.enabled = true; break;
                    case Interruption.Destroy: Object.DestroyImmediate(fluid.gameObject); break;
                }
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(readback.IsPending, Is.False);
                Assert.That(readback.Outcome, Is.EqualTo(ReadbackOutcome.Dropped));
                Assert.That(readback.HasData, Is.False);
                Assert.That(readback.Count, Is.Zero);
                Assert.That(() => readback.Positions, Throws.InvalidOperationException.With.Message.Contains("ended as Dropped"));
                if (interruption == Interruption.Destroy)
                    return;
                if (interruption == Interruption.Disable)
                    Assert.That(() => fluid.RequestParticles(readback), Throws.InvalidOperationException.With.Message.Contains("is not running"));
                fluid.enabled = true;
                scene.Step();
                Assert.That(fluid.RequestParticles(readback));
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(readback.Outcome, Is.EqualTo(ReadbackOutcome.Arrived));
                Assert.That(readback.Step, Is.EqualTo(1));
                Assert.That(readback.Count, Is.EqualTo(scene.Read().Count));
            }
        }

        [Test]
        public void What_came_back_stays_readable_while_the_next_is_under_way()
        {
            using (SourceScene scene = Pool())
            using (var readback = new ParticleReadback())
            {
                scene.Step();
                scene.Fluid.RequestParticles(readback);
                AsyncGPUReadback.WaitAllRequests();
                float3 first = readback.Positions[0];
                scene.Step();
                Assert.That(scene.Fluid.RequestParticles(readback));
                Assert.That(readback.IsPending && readback.HasData);
                Assert.That(readback.Step, Is.EqualTo(1));
                Assert.That(readback.Positions[0], Is.EqualTo(first));
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(readback.Step, Is.EqualTo(2));
            }
        }

        [Test]
        public void A_readback_may_be_disposed_of_while_its_request_is_under_way()
        {
            using (SourceScene scene = Pool())
            {
                int before = PendingReadbacks.Count;
                var readback = new ParticleReadback();
                scene.Step();
                scene.Fluid.RequestParticles(readback);
                readback.Dispose();
                readback.Dispose();
                Assert.That(PendingReadbacks.Count, Is.EqualTo(before + 1));
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(PendingReadbacks.Count, Is.EqualTo(before));
                Assert.That(() => readback.HasData, Throws.InstanceOf<ObjectDisposedException>());
                Assert.That(() => scene.Fluid.RequestParticles(readback), Throws.InstanceOf<ObjectDisposedException>());
            }
        }

        [Test]
        public void A_fluid_without_particles_brings_none()
        {
            using (var scene = new SourceScene(Vector3.one, Spacing, 100))
            using (var readback = new ParticleReadback())
            {
                scene.Fluid.RequestParticles(readback);
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(readback.HasData);
                Assert.That(readback.Count, Is.Zero);
                Assert.That(readback.Positions.Length, Is.Zero);
                Assert.That(() => scene.Fluid.RequestParticles(null), Throws.ArgumentNullException);
                Assert.That(() => scene.Fluid.RequestParticles(readback, 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
            }
        }

        [Test]
        public void More_particles_than_one_readback_held_fit_after_the_box_was_configured_again()
        {
            using (SourceScene scene = Pool())
            using (var readback = new ParticleReadback())
            {
                scene.Step();
                scene.Fluid.RequestParticles(readback);
                AsyncGPUReadback.WaitAllRequests();
                int before = readback.Count;
                scene.Fluid.Configure(scene.Fluid.DomainSize, 0.035f, 9000);
                scene.Step();
                scene.Fluid.RequestParticles(readback);
                Assert.That(readback.HasData, Is.False, "the copy is another");
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(readback.Count, Is.EqualTo(scene.Read().Count).And.GreaterThan(2 * before));
            }
        }
    }
}
