using System;
using System.Collections;
using NUnit.Framework;
using Rill.Testing;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using static System.FormattableString;

namespace Rill.Tests
{
    /// <summary>Assertions for users' own tests: each passes where it should, fails where it should, and says why.</summary>
    public class FluidAssertTests : PlayedFluidFixture
    {
        const float Spacing = 0.05f;

        [UnityTest]
        public IEnumerator A_whole_fluid_has_lost_nothing_and_nothing_has_escaped()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(5);
            FluidAssert.NothingLost(fluid);
            FluidAssert.NothingEscaped(fluid);
            Assert.That(FluidAssert.Measure(fluid).step, Is.EqualTo(5), "the newest state was measured");
        }

        [UnityTest]
        public IEnumerator Particles_that_the_capacity_refused_are_lost_and_the_message_names_it()
        {
            FluidSimulation fluid = Pool(capacity: 300);
            yield return Frames(2);
            string problem = Failure(() => FluidAssert.NothingLost(fluid));
            Assert.That(problem, Does.Contain("'Pool'").And.Contain("100 were refused").And.Contain("capacity is 300"));
        }

        // The pool of 400 particles lies in the lower part of the box; the detector's box holds all of it.
        [UnityTest]
        public IEnumerator The_volume_in_a_detector_is_asked_for_from_least_to_most()
        {
            FluidSimulation fluid = Pool();
            FluidDetector detector = Detector(fluid);
            yield return Frames(3);
            float volume = 400 * Spacing * Spacing * Spacing;
            FluidAssert.VolumeIn(detector, 0.99f * volume, 1.01f * volume);
            FluidAssert.VolumeIn(detector, 0f);
            string message = Failure(() => FluidAssert.VolumeIn(detector, 1.1f * volume, 2f * volume));
            Assert.That(message, Does.Contain("FluidSimulation 'Pool', step 3").And.Contain("detector 'Detector' has 0.05 m³ of water")
                .And.Contain("0.055 to 0.1 m³ asked for"));
            Assert.That(Failure(() => FluidAssert.VolumeIn(detector, 0f, 0.5f * volume)), Does.Contain("0 to 0.025 m³ asked for"));
            Assert.That(Failure(() => FluidAssert.VolumeIn(detector, 1f)), Does.Contain("at least 1 m³ asked for"));
        }

        // Three particles at rest without gravity: 1 cm inside of each shape, 3 cm and 10 cm outside.
        [UnityTest]
        public IEnumerator A_volume_that_is_another_names_the_particles_nearest_to_the_boundary(
            [Values(DetectorShape.Box, DetectorShape.Sphere, DetectorShape.Capsule, DetectorShape.Mesh)] DetectorShape shape)
        {
            FluidSimulation fluid = Fluid("Pool", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 100, Vector3.zero, f => f.Gravity = Vector3.zero);
            FluidDetector detector = Detector(fluid);
            detector.Shape = shape;
            detector.Size = 0.2f * Vector3.one;
            detector.Radius = 0.1f;
            detector.Height = 0.4f;
            if (shape == DetectorShape.Mesh)
            {
                MeshSdfSettings settings = MeshSdfSettings.Default;
                settings.resolution = 20;
                detector.Field = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Box(0.4f * Vector3.one, Vector3.zero), settings));
                detector.transform.localScale = 0.5f * Vector3.one;     // that of the box above
            }
            detector.transform.rotation = Quaternion.Euler(0f, 90f, 0f);
            yield return null;
            Add(fluid, new float3(0.2f, 0f, 0f), 0f);
            Add(fluid, new float3(0f, 0f, 0.13f), 0f);
            Add(fluid, new float3(-0.09f, 0f, 0f), 0f);
            yield return Frames(2);
            string message = Failure(() => FluidAssert.VolumeIn(detector, 1f));
            Assert.That(message, Does.Contain("Nearest to its boundary: Particle 2 is at 0.210, 0.300, 0.300 m in the box's frame, 0.010 m inside; " +
                "Particle 1 is at 0.300, 0.300, 0.430 m in the box's frame, 0.030 m outside; Particle 0 is at 0.500, 0.300, 0.300 m in the " +
                "box's frame, "));
            Assert.That(message, Does.EndWith(shape == DetectorShape.Mesh ? "0.093 m outside." : "0.100 m outside."), "a field ends before that");
            if (shape != DetectorShape.Mesh)
                yield break;
            UnityEngine.Object.DestroyImmediate(detector.Field.Texture);
            UnityEngine.Object.DestroyImmediate(detector.Field);
        }

        [UnityTest]
        public IEnumerator A_detector_that_measures_nothing_is_an_error_and_no_empty_shape()
        {
            FluidSimulation fluid = Pool();
            FluidDetector detector = Detector(fluid);
            yield return Frames(2);
            detector.enabled = false;
            Assert.That(() => FluidAssert.VolumeIn(detector, 0f),
                Throws.InvalidOperationException.With.Message.Contains("FluidDetector 'Detector' measures nothing"));
            Assert.That(() => FluidAssert.VolumeIn(null, 0f), Throws.ArgumentNullException);
            Assert.That(() => FluidAssert.VolumeIn(detector, -1f), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => FluidAssert.VolumeIn(detector, 2f, 1f), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => FluidAssert.VolumeIn(detector, float.NaN), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        // The box is full: for a second the particles wait, then they are given up.
        [UnityTest, Category("LongRun")]
        public IEnumerator Particles_that_an_emitter_gave_up_are_lost_and_the_message_names_it_and_what_is_in_its_way()
        {
            FluidSimulation fluid = Fluid("Full", 0.3f * Vector3.one, Spacing, 400, 0.3f * Vector3.one);
            yield return Frames(2);
            var tap = new GameObject("Tap");
            made.Add(tap);
            tap.transform.SetParent(fluid.transform, false);
            tap.SetActive(false);
            FluidEmitter emitter = tap.AddComponent<FluidEmitter>();
            emitter.Rate = 0.05f;
            tap.SetActive(true);
            yield return Frames(100);
            string problem = Failure(() => FluidAssert.NothingLost(fluid));
            Assert.That(problem, Does.Match(@"(\d+) were given up by emitters.* Emitter 'Tap' gave up \1; nearest to it: Particle \d+ is at 0\.\d+, 0\.\d+, 0\.\d+ m in the box's frame, 0\.0\d\d m away;"));
            Assert.That(problem.Split(new[] { " is at " }, StringSplitOptions.None), Has.Length.EqualTo(6), "five particles");
        }

        [UnityTest]
        public IEnumerator A_particle_that_is_not_finite_is_lost()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            Add(fluid, new float3(float.NaN, 0f, 0f), 0f);
            yield return Frames(2);
            Assert.That(Failure(() => FluidAssert.NothingLost(fluid)), Does.Contain("1 were removed, since their position was not finite"));
        }

        [UnityTest]
        public IEnumerator Particles_that_the_counters_do_not_account_for_are_lost()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            var counters = new uint[ParticleBuffers.CounterCount];
            fluid.Solver.Counters.GetData(counters);
            counters[(int)ParticleCounter.Added] += 7;
            fluid.Solver.Counters.SetData(counters);
            Assert.That(Failure(() => FluidAssert.NothingLost(fluid)), Does.Contain("7 are not accounted for: 407 added"));
        }

        // Each counter by itself: what came in and is gone, and what went out and is there.
        [UnityTest]
        public IEnumerator Each_counter_is_part_of_the_account()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            var counters = new uint[ParticleBuffers.CounterCount];
            fluid.Solver.Counters.GetData(counters);
            foreach ((ParticleCounter counter, int missing, string named) in new[]
            {
                (ParticleCounter.Added, 7, "407 added"), (ParticleCounter.Emitted, 7, "7 emitted"), (ParticleCounter.HandedIn, 7, "7 handed in"),
                (ParticleCounter.HandedOut, -7, "7 out"), (ParticleCounter.Drained, -7, "7 drained"), (ParticleCounter.NonFinite, -7, "7 not finite"),
            })
            {
                var changed = (uint[])counters.Clone();
                changed[(int)counter] += 7;
                fluid.Solver.Counters.SetData(changed);
                Assert.That(Failure(() => FluidAssert.NothingLost(fluid)), Does.Contain($" {missing} are not accounted for: ").And.Contain(named));
            }
            var drainedAndEmitted = (uint[])counters.Clone();
            foreach (ParticleCounter counter in new[] { ParticleCounter.Emitted, ParticleCounter.HandedIn, ParticleCounter.Drained,
                ParticleCounter.HandedOut })
                drainedAndEmitted[(int)counter] += 7;
            fluid.Solver.Counters.SetData(drainedAndEmitted);
            FluidAssert.NothingLost(fluid);
            fluid.Solver.Counters.SetData(counters);
            FluidAssert.NothingLost(fluid);
        }

        // The center of a particle at rest is half a spacing from the wall.
        [TestCase(0.41f, false)]
        [TestCase(0.39f, true)]
        public void A_tenth_of_a_spacing_is_not_yet_escaped(float fromTheWall, bool hasEscaped)
        {
            FluidSimulation fluid = Pool();
            fluid.Advance(1f / 60f);
            PutAt(fluid, 17, new float4(5f, 11f, fromTheWall, 0f));
            if (hasEscaped)
                Assert.That(Failure(() => FluidAssert.NothingEscaped(fluid)), Does.Contain("1 of 400").And.Contain("Particle 17 is at"));
            else
                FluidAssert.NothingEscaped(fluid);
        }

        [UnityTest]
        public IEnumerator A_particle_beyond_the_wall_has_escaped_and_the_message_says_where()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            PutAt(fluid, 17, new float4(-3f, 4f, 5f, 0f));
            string problem = Failure(() => FluidAssert.NothingEscaped(fluid));
            Assert.That(problem, Does.Contain("1 of 400 particles").And.Contain("Particle 17 is at -0.150, 0.200, 0.250 m").And.Contain(
                "0.175 m too far."));
        }

        [UnityTest]
        public IEnumerator A_particle_inside_a_collider_has_escaped()
        {
            FluidSimulation fluid = Pool();
            var ball = new GameObject("Ball");
            made.Add(ball);
            ball.transform.position = new Vector3(0f, 0.15f, 0f);       // above the water
            FluidCollider collider = ball.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Sphere;
            collider.Radius = 0.05f;
            yield return Frames(2);
            FluidAssert.NothingEscaped(fluid);
            PutAt(fluid, 3, new float4(new float3(0.25f, 0.45f, 0.25f) / Spacing, 0f));
            Assert.That(Failure(() => FluidAssert.NothingEscaped(fluid)),
                Does.Contain("1 of 400 particles").And.Contain("Particle 3 is at 0.250, 0.450, 0.250 m"));
        }

        [UnityTest]
        public IEnumerator Still_water_settles_and_the_test_goes_on_at_once()
        {
            FluidSimulation fluid = Pool();
            yield return FluidAssert.Settles(fluid, within: 4f, volume: 0.15f, noise: 0.1f);
            Assert.That(fluid.FluidTime, Is.LessThan(4.0));
            Assert.That(fluid.FluidTime, Is.GreaterThan(0.0));
        }

        // At first the water has no jitter: all of it falls alike. Nor has it speed yet.
        [UnityTest]
        public IEnumerator A_dam_that_begins_to_break_has_not_settled()
        {
            FluidSimulation fluid = Fluid("Dam", new Vector3(1f, 0.6f, 0.5f), 0.05f, 2000, new Vector3(0.4f, 0.4f, 0.5f));
            yield return FailToSettle(FluidAssert.Settles(fluid, within: 0.3f));
            Assert.That(unsettled, Does.Match(@"has not settled in 0\.3 s: jitter \d\.\d+ m/s and rms speed [1-9]?\d?\.?\d+ m/s of 0\.050"));
            Assert.That(fluid.Results.Measurements.MeasureNow().speed, Is.GreaterThan(0.2f));
        }

        [UnityTest]
        public IEnumerator Water_that_is_slow_for_a_moment_has_not_settled()
        {
            FluidSimulation fluid = Pool();
            yield return FluidAssert.Settles(fluid, within: 4f, noise: 0.1f);
            double calm = fluid.FluidTime;
            Assert.That(calm, Is.GreaterThan(0.25), "it is watched for a quarter of a second");
            yield return FluidAssert.Settles(fluid, within: 0.01f, noise: 0.2f);
            Assert.That(fluid.FluidTime - calm, Is.EqualTo(0.25).Within(0.05), "also where it is calm from the first");
        }

        [UnityTest]
        public IEnumerator Calm_water_of_another_volume_than_asked_for_fails_by_its_volume()
        {
            FluidSimulation fluid = Pool();
            yield return FluidAssert.Settles(fluid, within: 4f, noise: 0.1f);
            yield return FailToSettle(FluidAssert.Settles(fluid, within: 0.5f, volume: 1e-6f, noise: 0.1f));
            Assert.That(unsettled, Does.Match(@"volume \d\.\d+ of its rest volume, 1\.000 to 1\.000 asked for"));
        }

        [UnityTest]
        public IEnumerator Water_that_still_moves_has_not_settled_and_the_message_has_the_figures()
        {
            FluidSimulation fluid = Pool();
            yield return FailToSettle(FluidAssert.Settles(fluid, within: 0.1f, noise: 1e-6f));
            Assert.That(unsettled, Does.Contain("has not settled in 0.1 s: jitter 0.").And.Contain("of 0.000"));
        }

        [UnityTest]
        public IEnumerator Water_that_has_not_settled_names_the_fastest_particles()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            Add(fluid, new float3(0.1f, 0.1f, 0f), new float3(0f, 2f, 0f));     // id 400, above the water
            yield return FailToSettle(FluidAssert.Settles(fluid, within: 0.05f, noise: 1e-6f));
            Assert.That(unsettled, Does.Match(@"The fastest: Particle 400 is at 0\.35\d, 0\.[45]\d\d, 0\.25\d m in the box's frame, 1\.\d\d\d m/s by -?0\.0\d, 1\.\d\d, -?0\.0\d; Particle "));
            Assert.That(unsettled.Split(new[] { " is at " }, StringSplitOptions.None), Has.Length.EqualTo(6), "five particles");
        }

        [UnityTest]
        public IEnumerator Paused_water_fails_to_settle_instead_of_waiting_for_ever()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            fluid.Paused = true;
            IEnumerator settling = FluidAssert.Settles(fluid, within: 1f);
            settling.MoveNext();
            yield return null;
            Assert.That(Failure(() => settling.MoveNext()), Does.Contain("paused"));
        }

        [UnityTest]
        public IEnumerator Water_that_takes_no_steps_fails_to_settle_instead_of_waiting_for_ever()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            IEnumerator settling = FluidAssert.Settles(fluid, within: 1f);
            string problem = Failure(() =>
            {
                for (int i = 0; i < 1000; i++)      // no frame passes in between
                    settling.MoveNext();
            });
            Assert.That(problem, Does.Contain("time stands still").And.Contain("Time.timeScale"));
        }

        [UnityTest]
        public IEnumerator A_cost_that_was_not_measured_is_no_cost()
        {
            FluidSimulation fluid = Pool();
            yield return Frames(2);
            Assert.That(() => FluidAssert.CostBelow(fluid, 1f),
                Throws.InvalidOperationException.With.Message.Contains("was not measured").And.Message.Contains("Switch its budget on"));
            Assert.That(() => FluidAssert.CostBelow(fluid, 0f), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        [UnityTest]
        public IEnumerator A_measured_cost_is_held_to_its_bound()
        {
            FluidSimulation fluid = Pool(setUp: f =>
            {
                f.Steps.Budget.TimeSource = new TwoMilliseconds();
                SolverBudget budget = f.Budget;
                budget.mode = BudgetMode.Milliseconds;
                budget.milliseconds = 3f;
                f.Budget = budget;
            });
            yield return Frames(20);
            float cost = fluid.BudgetState.milliseconds;
            Assert.That(cost, Is.EqualTo(0.0695f).Within(1).Percent, "ms: as the model says, and a step a frame");
            FluidAssert.CostBelow(fluid, 1.01f * cost);
            string problem = Failure(() => FluidAssert.CostBelow(fluid, 0.99f * cost));
            Assert.That(problem, Does.Contain(Invariant($"its steps take {cost:0.000} ms a frame, more than {0.99f * cost:0.000} ms")));
        }

        [UnityTest]
        public IEnumerator A_cost_that_was_modeled_is_no_measured_cost()
        {
            FluidSimulation fluid = Pool(setUp: f =>
            {
                f.Steps.Budget.TimeSource = new TwoMilliseconds { Kind = GpuTimeKind.Modeled };
                SolverBudget budget = f.Budget;
                budget.mode = BudgetMode.Milliseconds;
                f.Budget = budget;
            });
            yield return Frames(20);
            Assert.That(fluid.BudgetState.milliseconds, Is.EqualTo(0.0695f).Within(1).Percent);
            Assert.That(() => FluidAssert.CostBelow(fluid, 1000f), Throws.InvalidOperationException.With.Message.Contains("was not measured"));
        }

        [UnityTest]
        public IEnumerator What_cannot_be_measured_says_why()
        {
            FluidSimulation fluid = Pool();
            Assert.That(() => FluidAssert.Measure(fluid), Throws.InvalidOperationException.With.Message.Contains("no step yet"));
            yield return Frames(1);
            fluid.enabled = false;
            Assert.That(() => FluidAssert.Measure(fluid), Throws.InvalidOperationException.With.Message.Contains("'Pool' does not run"));
            Assert.That(() => FluidAssert.Measure(null), Throws.ArgumentNullException);
            Assert.That(() => FluidAssert.Settles(fluid, 0f), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => FluidAssert.Settles(fluid, 1f, -1f), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => FluidAssert.Settles(fluid, 1f, 0.1f, 0f), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        [UnityTest]
        public IEnumerator Measuring_changes_nothing_of_the_fluid()
        {
            FluidSimulation measured = Pool(), left = Pool();
            for (int i = 0; i < 6; i++)
            {
                yield return null;
                FluidAssert.Measure(measured);
            }
            TestFluid.AssertSame(TestFluid.Read(measured.Solver), TestFluid.Read(left.Solver));
        }

        string unsettled;       // the message of the newest

        IEnumerator FailToSettle(IEnumerator settling)
        {
            unsettled = null;
            while (unsettled == null)
            {
                try
                {
                    Assert.That(settling.MoveNext(), "it settled");
                }
                catch (FluidAssertionException thrown)
                {
                    unsettled = thrown.Message;
                    TestContext.Out.WriteLine(unsettled);
                }
                yield return null;
            }
        }

        static string Failure(Action assertion)
        {
            try
            {
                assertion();
            }
            catch (FluidAssertionException failure)
            {
                TestContext.Out.WriteLine(failure.Message);
                return failure.Message;
            }
            Assert.Fail("nothing failed");
            return null;
        }

        // Moves a particle of the state, in d.
        static void PutAt(FluidSimulation fluid, uint id, float4 position)
        {
            ParticleState state = TestFluid.Read(fluid.Solver);
            state.positions[Array.IndexOf(state.ids, id)] = position;
            fluid.Solver.Positions.SetData(state.positions, 0, 0, state.Count);
        }

        // Four layers of 10 x 10 particles.
        FluidSimulation Pool(int capacity = 1000, Action<FluidSimulation> setUp = null)
            => Fluid("Pool", new Vector3(0.5f, 0.6f, 0.5f), Spacing, capacity, new Vector3(0.5f, 0.2f, 0.5f), setUp);

        // Larger than the fluid's box.
        FluidDetector Detector(FluidSimulation fluid)
        {
            var gameObject = new GameObject("Detector");
            made.Add(gameObject);
            gameObject.transform.SetParent(fluid.transform, false);
            var detector = gameObject.AddComponent<FluidDetector>();
            detector.Size = Vector3.one;
            return detector;
        }

        sealed class TwoMilliseconds : IGpuTimeSource
        {
            public GpuTimeKind Kind { get; set; } = GpuTimeKind.Measured;

            public void BeginStep(CommandBuffer commands) { }

            public void EndStep(CommandBuffer commands) { }

            public StepTime Read(float seconds, WorkHistory work) => new StepTime(2f, 2f);

            public void Dispose() { }
        }
    }
}
