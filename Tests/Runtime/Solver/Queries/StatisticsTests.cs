using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    public class StatisticsTests
    {
        [TestCase(1)]
        [TestCase(127)]
        [TestCase(128)]
        [TestCase(129)]
        [TestCase(997)]
        [TestCase(100003)]
        public void Every_measure_is_that_of_the_reference(int count)
        {
            ParticleState state = ParticleState.Random(count, seed: count, speed: 10f);
            FluidStatistics actual = Measure(state);
            var expected = new Measures(state.box, Compare.Points(state.positions), Compare.Points(state.velocities));

            const double d = SolverStages.Spacing;
            double mass = 1000.0 * d * d * d;
            Assert.That(actual.particles, Is.EqualTo(count));
            AssertNear("density error", actual.densityError, expected.DensityError, 1e-5);
            AssertNear("largest density error", actual.densityErrorMax, expected.DensityErrorMax, 1e-5);
            AssertNear("interior error", actual.interiorError, expected.InteriorError, 1e-3);
            AssertNear("jitter", actual.jitter, expected.Jitter * d, 1e-4);
            AssertNear("speed", actual.speed, expected.Speed * d, 1e-5);
            AssertNear("largest speed", actual.speedMax, expected.SpeedMax * d, 1e-5);
            AssertNear("neighbors", actual.neighborsMean, expected.NeighborsMean, 1e-4);
            Assert.That(actual.neighborsMax, Is.EqualTo(expected.NeighborsMax));
            Assert.That(actual.densityError999, Is.LessThanOrEqualTo(actual.densityErrorMax));
            AssertNear("volume ratio", actual.volumeRatio, expected.VolumeRatio, 1e-5);
            AssertNear("kinetic energy", actual.kineticEnergy, 0.5 * mass * count * Math.Pow(expected.Speed * d, 2), 1e-5);
            AssertNear("potential energy", actual.potentialEnergy, 9.81 * mass * count * expected.CenterOfMass.y * d, 1e-5);
            AssertNear("energy", actual.Energy, actual.kineticEnergy + (double)actual.potentialEnergy, 1e-6);
            Assert.That(math.length(actual.centerOfMass - expected.CenterOfMass * d),
                Is.LessThan(1e-5 * math.length(expected.CenterOfMass)), "center of mass");
            Assert.That(math.length(actual.momentum - expected.Momentum * d * mass), Is.LessThan(1e-5 * mass * count * expected.Speed * d),
                "momentum");
            Assert.That(math.length(actual.furthest - expected.Furthest * d), Is.LessThan(1e-5), "furthest");
            Assert.That(actual.coincident, Is.EqualTo(expected.Coincident));
            Assert.That(actual.escaped, Is.Zero);
            Assert.That(actual.nonFinite, Is.Zero);
        }

        // Densities of eight phases; the largest case has more groups than threads that sum them.
        [TestCase(1)]
        [TestCase(127)]
        [TestCase(129)]
        [TestCase(100003)]
        public void Each_phase_is_summed_by_itself(int count)
        {
            const double d = SolverStages.Spacing;
            ParticleState state = ParticleState.Random(count, seed: count + 3, speed: 10f);
            uint[] phases = Enumerable.Range(0, count).Select(i => (uint)(i * 7 % 13 % 8)).ToArray();
            FluidStatistics actual = Measure(state, phases);
            double mass = 0.0, energy = 0.0;
            double3 momentum = 0.0, center = 0.0;
            for (int i = 0; i < count; i++)
            {
                double own = (phases[i] == 0 ? 1000.0 : 300.0 * phases[i]) * d * d * d;
                double3 v = (double3)state.velocities[i].xyz * d;
                (mass, energy) = (mass + own, energy + 0.5 * own * math.dot(v, v));
                momentum += own * v;
                center += own * d * (double3)state.positions[i].xyz;
            }
            for (int phase = 0; phase < 8; phase++)
                AssertNear($"volume of phase {phase}", actual.VolumeOf(phase), phases.Count(p => p == phase) * d * d * d, 1e-6);
            AssertNear("mass", actual.mass, mass, 1e-5);
            AssertNear("kinetic energy", actual.kineticEnergy, energy, 1e-5);
            Assert.That(math.length(actual.momentum - momentum), Is.LessThan(1e-5 * math.sqrt(2.0 * mass * energy)), "momentum");
            Assert.That(math.length(actual.centerOfMass - center / mass), Is.LessThan(1e-5 * math.length(center) / mass), "center of mass");
        }

        [TestCase(1)]
        [TestCase(999)]
        [TestCase(1000)]
        [TestCase(5003)]
        [TestCase(100003)]
        public void One_particle_in_a_thousand_exceeds_the_999th_thousandth(int count)
        {
            ParticleState state = ParticleState.Random(count, seed: count + 1);
            double expected = new Measures(state.box, Compare.Points(state.positions), Compare.Points(state.velocities)).DensityError999;
            // 4096 bins by the root of the error up to 4.
            Assert.That(Math.Sqrt(Measure(state).densityError999 / 4.0), Is.EqualTo(Math.Sqrt(expected / 4.0)).Within(1.0 / 4096.0));
        }

        [Test]
        public void Fluid_without_compression_has_no_density_error()
        {
            FluidStatistics statistics = Measure(new ParticleState(20f,
                new[] { new float3(3f, 3f, 3f), new float3(10f, 10f, 10f), new float3(15f, 15f, 10f) }));
            Assert.That(statistics.densityError, Is.Zero);
            Assert.That(statistics.densityError999, Is.Zero);
            Assert.That(statistics.densityErrorMax, Is.Zero);
        }

        [Test]
        public void A_filled_box_has_volume_ratio_one_and_only_interior_particles()
        {
            FluidStatistics statistics = Measure(ParticleState.Lattice(new float3(10f, 12f, 10f), 0.5f, new int3(10, 6, 10)));
            Assert.That(statistics.volumeRatio, Is.EqualTo(1f).Within(1e-5));
            Assert.That(statistics.interiorError, Is.LessThan(0.05f));
        }

        [Test]
        public void A_box_without_particles_measures_nothing_and_nothing_odd()
        {
            FluidStatistics statistics = Measure(ParticleState.Random(0, seed: 1));
            Assert.That(statistics.particles, Is.Zero);
            foreach (float value in new[] { statistics.densityError, statistics.densityError999, statistics.densityErrorMax,
                statistics.interiorError, statistics.volumeRatio, statistics.jitter, statistics.speed, statistics.speedMax,
                statistics.neighborsMean, statistics.kineticEnergy, statistics.potentialEnergy })
                Assert.That(value, Is.Zero);
        }

        [Test]
        public void Particles_beyond_the_walls_inset_have_escaped()
        {
            var box = new float3(10f, 8f, 6f);
            var positions = new[] { new float3(0.41f, 4f, 3f), new float3(0.39f, 4f, 3f), new float3(5f, 7.59f, 3f), new float3(5f, 7.61f, 3f),
                new float3(5f, 4f, 9f), new float3(-3f, -3f, -3f), new float3(5f, 4f, 3f) };
            Assert.That(Measure(new ParticleState(box, positions)).escaped, Is.EqualTo(4));
        }

        [Test]
        public void Particles_in_one_place_are_coincident()
        {
            var positions = new[] { new float3(3f), new float3(3f), new float3(3.04f, 3f, 3f), new float3(5f, 5f, 5f),
                new float3(5f, 5.06f, 5f), new float3(7f) };
            Assert.That(Measure(new ParticleState(10f, positions)).coincident, Is.EqualTo(3));
        }

        [Test]
        public void Measuring_leaves_the_particles_as_they_are()
        {
            using (var fluid = Dam())
            {
                ParticleState before = fluid.Step(5).Read();
                FluidStatistics first = fluid.Measure(), second = fluid.Measure();
                TestFluid.AssertSame(fluid.Read(), before);
                Assert.That(second.densityErrorMax, Is.EqualTo(first.densityErrorMax), "what the first measurement left behind");
                Assert.That(second.densityError999, Is.EqualTo(first.densityError999));
            }
        }

        [Test]
        public void A_step_after_a_measurement_is_the_step_without_it()
        {
            using (TestFluid measured = Dam(), plain = Dam())
            {
                measured.Step(3).Measure();
                measured.Step(3);
                TestFluid.AssertSame(measured.Read(), plain.Step(6).Read());
            }
        }

        [Test]
        public void Neighbors_past_the_lists_are_reported()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.neighborCapacity = 16;
            using (var fluid = new TestFluid(1f, 0.05f, 4000, settings).AddBlock(0.2f, 0.5f).Step())
            {
                uint overflow = fluid.Counter(ParticleCounter.Overflow), most = fluid.Counter(ParticleCounter.MaxNeighbors);
                Assert.That(overflow, Is.GreaterThan(100u));
                FluidStatistics statistics = fluid.Measure();
                Assert.That(statistics.neighborOverflow, Is.EqualTo(overflow));
                Assert.That(statistics.neighborOverflowMax, Is.EqualTo(most).And.GreaterThan(16));
            }
        }

        [Test]
        public void Refused_and_culled_particles_are_reported()
        {
            using (var fluid = new TestFluid(1f, 0.05f, 10).Add(new[] { new float3(0.5f), new float3(float.NaN), new float3(0.7f) }))
            {
                fluid.Add(Enumerable.Range(0, 9).Select(i => new float3(0.1f * i + 0.1f, 0.3f, 0.3f)).ToArray());
                FluidStatistics statistics = fluid.Step().Measure();
                Assert.That(statistics.refused, Is.EqualTo(2));
                Assert.That(statistics.nonFinite, Is.EqualTo(1));
                Assert.That(statistics.particles, Is.EqualTo(9));
            }
        }

        [Test]
        public void Statistics_name_the_step_that_they_are_of()
        {
            using (var fluid = Dam())
            {
                FluidStatistics statistics = fluid.Step(7).Measure();
                Assert.That(statistics.step, Is.EqualTo(7));
                Assert.That(statistics.time, Is.EqualTo(7.0 / 60.0).Within(1e-6));
            }
        }

        [Test]
        public void Time_that_a_long_frame_dropped_is_told()
        {
            using (SourceScene scene = new SourceScene(Vector3.one, 0.1f, 1000).Fill(0.2f))
            {
                scene.Step();
                scene.Fluid.Advance(1f);
                Assert.That(scene.Fluid.StepCount, Is.InRange(2, 30));
                Assert.That(scene.Measure().droppedTime, Is.EqualTo(1.0 - (scene.Fluid.StepCount - 1) / 60.0).Within(1.0 / 60.0));
            }
        }

        [Test]
        public void A_result_does_not_come_at_once()
        {
            using (var fluid = Dam())
            {
                Request(fluid);
                Assert.That(fluid.Solver.TryGetStatistics(fluid.Input, out _), Is.False);
                Assert.That(fluid.Solver.StatisticsPending);
            }
        }

        [UnityTest]
        public IEnumerator A_result_comes_within_a_few_frames_unasked()
        {
            using (var fluid = Dam())
            {
                Request(fluid);
                for (int frame = 0; frame < 10 && fluid.Solver.StatisticsPending; frame++)
                    yield return null;
                Assert.That(fluid.Solver.TryGetStatistics(fluid.Input, out FluidStatistics statistics));
                Assert.That(statistics.particles, Is.EqualTo(fluid.Alive));
            }
        }

        [Test]
        public void A_result_from_before_a_clear_is_dropped()
        {
            using (var fluid = Dam())
            {
                Request(fluid);
                fluid.Solver.Clear();
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(fluid.Solver.TryGetStatistics(fluid.Input, out _), Is.False);
                Assert.That(fluid.Measure().particles, Is.Zero, "and the next one comes");
            }
        }

        [Test]
        public void The_last_result_stands_while_the_next_is_under_way()
        {
            using (var fluid = Dam())
            {
                FluidStatistics before = fluid.Step(2).Measure();
                fluid.Step(30);
                Request(fluid);
                Assert.That(fluid.Solver.TryGetStatistics(fluid.Input, out FluidStatistics meanwhile));
                Assert.That(meanwhile.step, Is.EqualTo(2));
                Assert.That(meanwhile.speed, Is.EqualTo(before.speed));
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(fluid.Solver.TryGetStatistics(fluid.Input, out FluidStatistics after));
                Assert.That(after.step, Is.EqualTo(32));
            }
        }

        [Test]
        public void A_solver_can_go_while_a_result_is_under_way()
        {
            TestFluid fluid = Dam();
            Request(fluid);
            fluid.Dispose();
            AsyncGPUReadback.WaitAllRequests();
        }

        static TestFluid Dam() => new TestFluid(new float3(1f, 0.6f, 0.5f), 0.05f, 2000).AddBlock(0f, new float3(0.5f, 0.4f, 0.5f));

        static void Request(TestFluid fluid)
        {
            GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
            fluid.Solver.RequestStatistics();
        }

        // Measures particles where they stand, through the stage alone.
        static FluidStatistics Measure(ParticleState state, uint[] phases = null)
        {
            StepInput input = SolverStages.Still();
            for (int phase = 1; phases != null && phase < 8; phase++)
                input.phases.Set(phase, 300f * phase, 0f);
            using (var stages = new SolverStages(state, input))
            using (var pass = new StatisticsPass(stages.Layout.Capacity))
            using (var tags = new ParticleTags(stages.Layout.Capacity))
            {
                if (phases != null)
                    tags.Current.SetData(phases.Select(phase => phase << ParticleTags.PhaseShift).ToArray());
                // Counters that only a step writes, as after one that overflowed nothing.
                uint[] counters = GpuTest.Read<uint>(stages.Particles.Counters, ParticleBuffers.CounterCount);
                counters[(int)ParticleCounter.Overflow] = counters[(int)ParticleCounter.MaxNeighbors] = 0;
                stages.Particles.Counters.SetData(counters);
                GpuTest.Run(cmd => pass.Record(new StepContext(cmd, stages.Constants, stages.Particles, stages.Search, stages.Constraint.Lists,
                    stages.Layout, input, tags: tags)));
                pass.Request();
                AsyncGPUReadback.WaitAllRequests();
                input.gravity = new float3(0f, -9.81f, 0f);
                return FluidStatistics.From(pass.Latest, stages.Layout, input);
            }
        }

        static void AssertNear(string what, double actual, double expected, double fraction)
        {
            Assert.That(actual, Is.EqualTo(expected).Within(fraction * Math.Abs(expected) + 1e-7), what);
        }
    }
}
