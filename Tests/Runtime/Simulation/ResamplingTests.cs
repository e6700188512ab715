using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill.Testing;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A running fluid gets another particle spacing and keeps its water.</summary>
    public class ResamplingTests : PlayedFluidFixture
    {
        const float Spacing = 0.05f;

        public enum Pool { Plain, Turned, OnItsSide, TurnedOver, WithCollider }

        FluidSimulation fluid;

        static float Volume(FluidSimulation of) => FluidAssert.Measure(of).particles * Mathf.Pow(of.ParticleSpacing, 3f);

        // Momentum is in the box's frame; the mass is the volume's.
        static float3 Velocity(FluidSimulation of) => FluidAssert.Measure(of).momentum / (1000f * Volume(of));

        IEnumerator Change(float spacing)
        {
            fluid.ParticleSpacing = spacing;
            for (int i = 0; i < 8 && fluid.Resolution.IsPending; i++)
                yield return null;
            Assert.That(fluid.ParticleSpacing, Is.EqualTo(spacing));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_pool_keeps_its_volume_and_its_calm_when_it_gets_finer_or_coarser([Values(0.5f, 0.7f, 1.3f, 2f)] float factor,
            [Values] Pool pool)
        {
            // Water on what is the floor there: the lattice of the new particles lies on that side.
            var box = new Vector3(0.8f, 0.6f, 0.8f);
            Vector3 water = pool == Pool.OnItsSide ? new Vector3(0.3f, 0.6f, 0.8f) : new Vector3(0.8f, 0.3f, 0.8f);
            fluid = Fluid("Pool", box, Spacing, 30000, Vector3.zero, made =>
            {
                AddWater(made, water, 0.5f * (pool == Pool.TurnedOver ? box - water : water - box));
                if (pool == Pool.Turned)
                    made.transform.SetPositionAndRotation(new Vector3(3f, 1f, -2f), Quaternion.Euler(0f, 40f, 0f));
                else if (pool == Pool.OnItsSide || pool == Pool.TurnedOver)
                    made.transform.rotation = Quaternion.Euler(0f, 0f, pool == Pool.OnItsSide ? 90f : 180f);
            });
            if (pool == Pool.WithCollider)
            {
                var ball = new GameObject("Ball").AddComponent<FluidCollider>();
                made.Add(ball.gameObject);
                ball.Shape = ColliderShape.Sphere;
                ball.Radius = 0.12f;
                ball.transform.position = new Vector3(0.03f, -0.17f, 0.01f);
            }
            yield return Frames(60);
            FluidStatistics old = FluidAssert.Measure(fluid);
            float volume = Volume(fluid);
            yield return Change(factor * Spacing);
            Assert.That(Volume(fluid), Is.EqualTo(volume).Within(0.01f * volume));
            float fastest = 0f, rms = 0f;
            for (int i = 0; i < 20; i++)
            {
                yield return null;
                FluidStatistics now = FluidAssert.Measure(fluid);
                fastest = Mathf.Max(fastest, now.speedMax);
                rms = Mathf.Max(rms, now.speed);
            }
            TestContext.Out.WriteLine($"rms speed {old.speed:0.000} before, at most {rms:0.000} after; fastest {old.speedMax:0.000} and " +
                $"{fastest:0.000} m/s");
            // Around a ball of 1.2 to 4.8 new spacings the lattice leaves gaps, into which water falls by up to one.
            bool isOpen = pool != Pool.WithCollider;
            Assert.That(rms, Is.LessThan(old.speed + (isOpen ? 0.1f : 0.25f)));
            Assert.That(fastest, Is.LessThan(isOpen ? 1f : 2f), "no burst");
            Assert.That(Volume(fluid), Is.EqualTo(volume).Within(0.01f * volume));
        }

        [UnityTest]
        public IEnumerator Moving_water_keeps_its_momentum([Values(0.5f, 0.7f, 2f)] float factor)
        {
            fluid = Fluid("Stream", new Vector3(1.2f, 0.8f, 0.6f), Spacing, 30000, Vector3.zero, made =>
            {
                AddWater(made, new Vector3(0.6f, 0.4f, 0.5f), new Vector3(-0.2f, 0f, 0f));
                made.GetComponentInChildren<FluidVolume>(true).Velocity = new Vector3(1.5f, 0f, 0.5f);
            });
            yield return Frames(8);
            float3 before = Velocity(fluid);
            float volume = Volume(fluid), fastest = FluidAssert.Measure(fluid).speedMax;
            fluid.ParticleSpacing = factor * Spacing;
            int step = fluid.StepCount;
            for (int i = 0; i < 8 && fluid.Resolution.IsPending; i++)
            {
                Assert.That(fluid.StepCount, Is.EqualTo(step), "it stands until then: what it did meanwhile would be lost");
                yield return null;
            }
            // One step of the new water has passed: gravity, and what it hits, act on both alike.
            float3 now = Velocity(fluid);
            TestContext.Out.WriteLine($"{before} then {now} m/s; fastest {fastest} then {FluidAssert.Measure(fluid).speedMax}");
            Assert.That(Volume(fluid), Is.EqualTo(volume).Within(0.01f * volume));
            Assert.That(now.x, Is.EqualTo(before.x).Within(0.02f * before.x));
            Assert.That(FluidAssert.Measure(fluid).speedMax, Is.LessThan(fastest + 1f), "no burst");
        }

        // It is of the old particles; those of the new ones are yet to be summed.
        [UnityTest, Category("LongRun")]
        public IEnumerator A_force_on_a_collider_is_not_known_until_the_new_water_presses_on_it([Values(Spacing, 0.04f)] float spacing)
        {
            fluid = Fluid("Pool", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 10000, new Vector3(0.6f, 0.4f, 0.6f));
            var ball = new GameObject("Ball").AddComponent<FluidCollider>();
            made.Add(ball.gameObject);
            ball.Shape = ColliderShape.Sphere;
            ball.Radius = 0.12f;
            ball.transform.position = new Vector3(0f, -0.1f, 0f);
            ball.MeasuresForce = true;
            yield return Frames(20);
            Assert.That(ball.TryGetForce(out _, out _));
            fluid.Capacity = 12000;
            fluid.ParticleSpacing = spacing;
            while (fluid.Resolution.IsPending)
            {
                Assert.That(ball.TryGetForce(out _, out _), "the water stands");
                yield return null;
            }
            Assert.That((fluid.ParticleSpacing, fluid.Capacity), Is.EqualTo((spacing, 12000)), "one does not undo the other");
            Assert.That(ball.TryGetForce(out _, out _), Is.False);
            Vector3 sum = Vector3.zero;
            for (int i = 0; i < 40; i++)
            {
                yield return null;
                if (i < 10)
                    continue;
                Assert.That(ball.TryGetForce(out Vector3 force, out _), $"frame {i}");
                sum += force / 30f;
            }
            float weight = 1000f * 9.81f * 4f / 3f * Mathf.PI * 0.12f * 0.12f * 0.12f;
            Assert.That(sum.y, Is.InRange(0.6f * weight, 1.4f * weight), "N, of the water that it displaces");
        }

        [UnityTest]
        public IEnumerator A_restore_gives_up_another_resolution_that_is_on_its_way()
        {
            fluid = Fluid("Pool", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 10000, new Vector3(0.6f, 0.2f, 0.6f));
            yield return Frames(4);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            yield return Frames(2);
            fluid.ParticleSpacing = 0.04f;
            Assert.That(fluid.Resolution.IsPending);
            fluid.Restore(request.Snapshot);
            Assert.That(fluid.Resolution.IsPending, Is.False);
            int step = fluid.StepCount;
            yield return Frames(6);
            Assert.That((fluid.ParticleSpacing, fluid.StepCount), Is.EqualTo((Spacing, step + 6)));
        }

        [UnityTest]
        public IEnumerator Where_the_capacity_does_not_hold_it_nothing_changes_and_one_line_says_how_much_it_takes()
        {
            fluid = Fluid("Pool", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            yield return Frames(4);
            int step = fluid.StepCount;
            LogAssert.Expect(LogType.Error, new Regex("keeps its particle spacing of 0.05 m and its capacity of 1,000: its water is 6,912 " +
                "particles at " +
                "a spacing of 0.025 m, more than the capacity of 1,000"));
            fluid.ParticleSpacing = 0.025f;
            yield return Frames(10);
            Assert.That((fluid.ParticleSpacing, fluid.Resolution.IsPending), Is.EqualTo((Spacing, false)));
            Assert.That(FluidAssert.Measure(fluid).particles, Is.EqualTo(12 * 6 * 12));
            Assert.That(fluid.StepCount, Is.GreaterThan(step + 4), "it goes on");

            fluid.Capacity = 8000;
            yield return Frames(6);
            Assert.That((fluid.Capacity, FluidAssert.Measure(fluid).particles), Is.EqualTo((8000, 12 * 6 * 12)));
            fluid.ParticleSpacing = 0.025f;
            yield return Frames(6);
            Assert.That((fluid.ParticleSpacing, FluidAssert.Measure(fluid).particles), Is.EqualTo((0.025f, 6912)));
        }

        [UnityTest]
        public IEnumerator What_scripts_do_meanwhile_is_not_lost_and_phases_are_kept()
        {
            fluid = Fluid("Pool", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 10000, new Vector3(0.6f, 0.2f, 0.6f));
            yield return Frames(4);
            int step = fluid.StepCount;
            fluid.ParticleSpacing = 0.04f;
            fluid.Fill(FluidShape.Box(new Vector3(0f, 0.1f, 0f), 0.2f * Vector3.one), phase: 3);
            yield return Frames(10);
            Assert.That(fluid.ParticleSpacing, Is.EqualTo(0.04f));
            float volume = (12 * 4 * 12 + 64) * Mathf.Pow(Spacing, 3f);
            Assert.That(Volume(fluid), Is.EqualTo(volume).Within(0.01f * volume));
            Assert.That(fluid.StepCount, Is.GreaterThan(step), "steps are counted on");
            var detector = new GameObject("Detector").AddComponent<FluidDetector>();
            detector.Size = Vector3.one;
            detector.transform.SetParent(fluid.transform, false);
            Assert.That(detector.MeasureNow().VolumeOf(3), Is.EqualTo(64f * Mathf.Pow(Spacing, 3f)).Within(0.15f * 64f * Mathf.Pow(Spacing, 3f)));
        }

        [UnityTest]
        public IEnumerator A_tap_goes_on_with_its_rate()
        {
            FluidEmitter tap = null;
            fluid = Fluid("Pool", new Vector3(0.8f, 0.8f, 0.8f), Spacing, 20000, Vector3.zero, made =>
            {
                tap = new GameObject("Tap").AddComponent<FluidEmitter>();
                tap.transform.SetParent(made.transform, false);
                tap.transform.localPosition = new Vector3(0f, 0.3f, 0f);
                tap.transform.localRotation = Quaternion.LookRotation(Vector3.down);
                tap.Radius = 0.15f;
                tap.Speed = 1.5f;
                tap.Rate = 0.03f;
            });
            yield return Frames(30);
            float before = Volume(fluid);
            yield return Change(0.04f);
            float at = Volume(fluid);
            int step = fluid.StepCount;
            yield return Frames(30);
            Assert.That(at, Is.EqualTo(before).Within(0.01f * before + 0.001f));
            Assert.That(Volume(fluid) - at, Is.EqualTo(0.03f * (fluid.StepCount - step) / 60f).Within(0.002f));
        }

        // No emitter says to the new solver that particles end, nor when.
        [UnityTest]
        public IEnumerator Particles_end_when_they_would_have_ended_at_the_old_resolution([Values(Spacing, 0.04f)] float spacing)
        {
            fluid = Fluid("Pool", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 10000, new Vector3(0.6f, 0.2f, 0.6f));
            fluid.Fill(FluidShape.Box(new Vector3(0f, 0.1f, 0f), 0.2f * Vector3.one), lifetime: 0.5f);
            yield return Frames(10);
            Assert.That(Volume(fluid), Is.EqualTo(640f * Mathf.Pow(Spacing, 3f)).Within(1e-6f));
            fluid.Capacity = 12000;
            if (spacing != Spacing)
                fluid.ParticleSpacing = spacing;
            while (fluid.StepCount < 28)
                yield return null;
            Assert.That((fluid.ParticleSpacing, fluid.Capacity), Is.EqualTo((spacing, 12000)));
            Assert.That(Volume(fluid), Is.EqualTo(640f * Mathf.Pow(Spacing, 3f)).Within(0.01f * 0.08f));
            while (fluid.StepCount < 32)
                yield return null;
            Assert.That(Volume(fluid), Is.EqualTo(576f * Mathf.Pow(Spacing, 3f)).Within(0.01f * 0.072f));
        }

        [UnityTest]
        public IEnumerator A_restart_meanwhile_begins_again_at_the_new_spacing()
        {
            fluid = Fluid("Pool", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 10000, new Vector3(0.6f, 0.2f, 0.6f));
            yield return Frames(4);
            fluid.ParticleSpacing = 0.1f;
            fluid.Restart();
            Assert.That((fluid.ParticleSpacing, fluid.StepCount), Is.EqualTo((0.1f, 0)));
            yield return Frames(6);
            Assert.That(FluidAssert.Measure(fluid).particles, Is.EqualTo(6 * 2 * 6));
        }
    }
}
