using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Whole steps, judged by what must hold whatever the particles do.</summary>
    public class PbfSolverTests
    {
        [Test]
        public void A_dam_break_stays_finite_inside_and_whole()
        {
            using (var fluid = Dam())
            {
                for (int part = 0; part < 6; part++)
                {
                    ParticleState state = fluid.Step(20).Read();
                    Assert.That(state.Count, Is.EqualTo(800));
                    Assert.That(state.ids.OrderBy(id => id), Is.EqualTo(Enumerable.Range(0, 800).Select(i => (uint)i)));
                    AssertInside(state);
                }
                FluidStatistics statistics = fluid.Measure();
                Assert.That(statistics.escaped + statistics.nonFinite + statistics.refused, Is.Zero);
                Assert.That(statistics.furthest.x, Is.EqualTo(0.975f).Within(1e-3), "the front has not reached the far wall");
            }
        }

        [TestCase(1, 4)]
        [TestCase(4, 2)]
        public void Free_fall_follows_the_parabola_and_gains_momentum_as_gravity_says(int substeps, int iterations)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = substeps;
            settings.iterations = iterations;
            // Pairs of particles push each other alike; what the coarse grid adds in deep water balances only on the whole.
            settings.deepWater = DeepWater.Off;
            using (var fluid = new TestFluid(new float3(2f, 4f, 2f), 0.05f, 1000, settings).AddBlock(new float3(0.7f, 2.5f, 0.7f), 0.5f,
                new float3(0.2f, 0f, 0.1f), jitter: 0.2f))
            {
                FluidStatistics before = fluid.Measure();
                const int steps = 30;
                FluidStatistics after = fluid.Step(steps).Measure();

                double dt = 1.0 / 60.0 / substeps, n = steps * substeps;
                double mass = 1000.0 * 1000 * 0.05 * 0.05 * 0.05;
                var expectedMomentum = mass * new double3(0.2, -9.81 * n * dt, 0.1);
                Assert.That(math.length(after.momentum - expectedMomentum), Is.LessThan(1e-4 * math.length(expectedMomentum)));

                double3 expectedCenter = (double3)before.centerOfMass + new double3(0.2 * n * dt, -9.81 * dt * dt * n * (n + 1) / 2.0, 0.1 * n * dt);
                Assert.That(math.length(after.centerOfMass - expectedCenter), Is.LessThan(1e-4));
            }
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(8)]
        [TestCase(16, Category = "LongRun")]
        public void Substeps_take_the_time_of_one_step(int substeps)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = substeps;
            const float spacing = 0.05f;
            using (var fluid = new TestFluid(new float3(0.4f, 4f, 0.4f), spacing, 1, settings).Add(new[] { new float3(0.2f, 3.9f, 0.2f) }))
            {
                double velocity = fluid.Step(30).Measure().momentum.y / (1000.0 * spacing * spacing * spacing);
                // Velocities are differences of positions: what a substep adds is rounded to the floats near 78 d, the
                // same result every time.
                double dt = 1.0 / 60.0 / substeps, fall = 9.81 / spacing * dt * dt, rounding = Math.Pow(2.0, -18);
                Assert.That(velocity, Is.EqualTo(-9.81 * 0.5).Within(9.81 * 0.5 * rounding / fall));
            }
        }

        [Test]
        public void Two_runs_give_the_same_state_bit_for_bit()
        {
            using (TestFluid first = Dam(), second = Dam())
                TestFluid.AssertSame(second.Step(60).Read(), first.Step(60).Read());
        }

        [Test]
        public void Two_runs_with_every_stage_give_the_same_state_bit_for_bit()
        {
            using (TestFluid first = Splash(), second = Splash())
                TestFluid.AssertSame(second.Step(30).Read(), first.Step(30).Read());

            TestFluid Splash()
            {
                TestFluid fluid = Dam();
                fluid.Input.material.vorticity = 0.2f;
                fluid.Input.material.shearModulus = 300f;
                fluid.Input.material.artificialPressure = 0.1f;
                fluid.Input.settings.substeps = 2;
                return fluid;
            }
        }

        [Test]
        public void Two_runs_of_particles_crowded_into_one_cell_give_the_same_state_bit_for_bit()
        {
            using (TestFluid first = Crowd(), second = Crowd())
                TestFluid.AssertSame(second.Step(20).Read(), first.Step(20).Read());

            TestFluid Crowd()
            {
                float3[] positions = Enumerable.Range(0, 800)
                    .Select(i => new float3(0.51f) + 0.03f * new float3(i % 10, i / 10 % 10, i / 100) / 10f).ToArray();
                return new TestFluid(1f, 0.05f, 800).Add(positions);
            }
        }

        [Test]
        public void A_cleared_solver_repeats_its_first_run()
        {
            using (var fluid = Dam())
            {
                ParticleState first = fluid.Step(20).Read();
                fluid.Solver.Clear();
                AddDam(fluid);
                TestFluid.AssertSame(fluid.Step(20).Read(), first);
            }
        }

        [Test]
        public void Steps_in_one_command_buffer_are_the_steps_of_many()
        {
            using (TestFluid together = Dam(), apart = Dam())
            {
                GpuTest.Run(cmd =>
                {
                    for (int i = 0; i < 5; i++)
                        together.Solver.Step(cmd, together.Input);
                });
                TestFluid.AssertSame(together.Read(), apart.Step(5).Read());
            }
        }

        [Test]
        public void Solvers_that_fraction_the_shaders_do_not_disturb_each_other()
        {
            using (TestFluid one = OneList(), two = TwoLists(), oneAlone = OneList(), twoAlone = TwoLists())
            {
                Assert.That(two.Solver.Layout.TwoLists);
                for (int i = 0; i < 20; i++)
                    GpuTest.Run(cmd =>
                    {
                        one.Solver.Step(cmd, one.Input);
                        two.Solver.Step(cmd, two.Input);
                    });
                TestFluid.AssertSame(one.Read(), oneAlone.Step(20).Read());
                TestFluid.AssertSame(two.Read(), twoAlone.Step(20).Read());
            }

            TestFluid OneList() => Dam();

            TestFluid TwoLists()
            {
                SolverSettings settings = SolverSettings.Default;
                settings.iterations = 2;
                settings.relaxation = 0.8f;
                var fluid = new TestFluid(new float3(0.8f, 0.8f, 0.8f), 0.04f, 1000, settings, maxBinding: 640 * 64 * 4);
                fluid.Input.material.vorticity = 0.3f;
                fluid.Input.material.shearModulus = 300f;
                return fluid.AddBlock(0.1f, new float3(0.4f, 0.36f, 0.4f));
            }
        }

        [Test]
        public void Two_list_buffers_change_no_bit()
        {
            using (TestFluid one = Box(0), two = Box(640 * 64 * 4))
            {
                Assert.That(one.Solver.Layout.TwoLists, Is.False);
                Assert.That(two.Solver.Layout.TwoLists);
                TestFluid.AssertSame(two.Step(20).Read(), one.Step(20).Read());
            }

            TestFluid Box(long maxBinding)
            {
                var fluid = new TestFluid(new float3(1f, 0.6f, 0.5f), 0.05f, 1000, SolverSettings.Default, maxBinding);
                fluid.Input.material.vorticity = 0.3f;
                fluid.Input.material.shearModulus = 300f;
                AddDam(fluid);
                return fluid;
            }
        }

        [Test]
        public void No_particles_step_without_harm_and_can_be_joined()
        {
            using (var fluid = new TestFluid(1f, 0.05f, 100).Step(3))
            {
                Assert.That(fluid.Alive, Is.Zero);
                fluid.Add(new[] { new float3(0.5f) }).Step(1);
                Assert.That(fluid.Alive, Is.EqualTo(1));
            }
        }

        [TestCase(1)]
        [TestCase(100)]
        public void One_particle_too_many_is_refused_and_the_others_go_on(int capacity)
        {
            float3[] positions = Enumerable.Range(0, capacity + 1)
                .Select(i => new float3(0.05f + 0.08f * (i % 11), 0.1f + 0.08f * (i / 11), 0.5f)).ToArray();
            using (var fluid = new TestFluid(1f, 0.05f, capacity).Add(positions).Step(2))
            {
                Assert.That(fluid.Alive, Is.EqualTo(capacity));
                Assert.That(fluid.Counter(ParticleCounter.Refused), Is.EqualTo(1));
                AssertInside(fluid.Read());
            }
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(float.NegativeInfinity)]
        public void A_particle_that_is_not_finite_is_culled_and_not_put_at_a_wall(float bad)
        {
            using (var fluid = Dam().Add(new[] { new float3(bad, 0.3f, 0.3f), new float3(0.3f, 0.3f, bad) }))
            {
                ParticleState state = fluid.Step(2).Read();
                Assert.That(state.Count, Is.EqualTo(800));
                Assert.That(state.ids.All(id => id < 800));
                Assert.That(fluid.Counter(ParticleCounter.NonFinite), Is.EqualTo(2));
                AssertInside(state);
            }
        }

        [Test, Category("LongRun")]
        public void Eight_layers_of_still_water_keep_their_volume_with_substeps()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = 4;
            FluidStatistics statistics = StillWater(settings);
            Assert.That(statistics.volumeRatio, Is.EqualTo(1f).Within(0.03f));
            Assert.That(statistics.densityError, Is.LessThan(0.005f));
        }

        [Test]
        public void Eight_layers_of_still_water_calm_down()
        {
            FluidStatistics statistics = StillWater(SolverSettings.Default);
            Assert.That(statistics.speed, Is.LessThan(0.1f));
            Assert.That(statistics.volumeRatio, Is.EqualTo(1f).Within(0.1f), "what four passes of one step can hold");
        }

        [Test, Category("LongRun")]
        public void Energy_of_a_closed_box_does_not_rise()
        {
            using (var fluid = Dam())
            {
                float last = fluid.Measure().Energy, first = last;
                for (int part = 0; part < 15; part++)
                {
                    float energy = fluid.Step(10).Measure().Energy;
                    Assert.That(energy, Is.LessThan(last + 0.01f * first), $"after {10 * part + 10} steps");
                    last = energy;
                }
                Assert.That(last, Is.LessThan(0.8f * first));
            }
        }

        [Test]
        public void Without_gravity_a_block_at_rest_stays_where_it_is()
        {
            using (var fluid = new TestFluid(2f, 0.05f, 1000).AddBlock(0.7f, 0.5f, jitter: 0f))
            {
                fluid.Input.gravity = 0f;
                FluidStatistics before = fluid.Measure(), after = fluid.Step(30).Measure();
                Assert.That(math.distance(after.centerOfMass, before.centerOfMass), Is.LessThan(1e-5f));
                Assert.That(after.speed, Is.LessThan(1e-3f));
            }
        }

        [Test]
        public void A_thousand_particles_at_one_point_come_apart_without_an_explosion()
        {
            using (var fluid = new TestFluid(2f, 0.05f, 1000).Add(Enumerable.Repeat(new float3(1f), 1000).ToArray()))
            {
                fluid.Input.gravity = 0f;
                AssertInside(fluid.Step(1).Read());
                FluidStatistics statistics = fluid.Step(60).Measure();
                AssertInside(fluid.Read());
                Assert.That(statistics.particles, Is.EqualTo(1000));
                // Each of a step's passes moves a particle half a spacing at most.
                Assert.That(statistics.speedMax, Is.LessThan(SolverSettings.Default.iterations * 0.5f * 0.05f * 60f));
                Assert.That(statistics.densityError999, Is.LessThan(3f));
            }
        }

        [TestCase(100f)]
        [TestCase(1e6f)]
        [TestCase(1e30f)]
        public void Speed_without_bounds_ends_at_a_wall(float speed)
        {
            using (var fluid = new TestFluid(1f, 0.05f, 200).AddBlock(0.4f, 0.25f, new float3(speed, -speed, 0.5f * speed)))
            {
                ParticleState state = fluid.Step(5).Read();
                Assert.That(state.Count, Is.EqualTo(125));
                AssertInside(state);
            }
        }

        [Test]
        public void Vorticity_takes_buffers_only_while_it_is_on()
        {
            using (var fluid = Dam())
            {
                Assert.That(Buffers(fluid), Has.No.Member("Rill.Curl"));

                fluid.Input.material.vorticity = 0.5f;
                fluid.Step();
                Assert.That(Buffers(fluid), Has.Member("Rill.Curl").And.Member("Rill.Unconfined"));

                fluid.Input.material.vorticity = 0f;
                fluid.Step();
                Assert.That(Buffers(fluid), Has.No.Member("Rill.Curl").And.No.Member("Rill.Unconfined"));
                AssertInside(fluid.Step(5).Read());
            }
        }

        [Test]
        public void Statistics_take_buffers_only_once_they_are_asked_for()
        {
            using (var fluid = Dam().Step())
            {
                Assert.That(Buffers(fluid), Has.No.Member("Rill.Statistics.Results"));
                fluid.Measure();
                Assert.That(Buffers(fluid), Has.Member("Rill.Statistics.Results"));
                fluid.Solver.ReleaseStatistics();
                Assert.That(Buffers(fluid), Has.No.Member("Rill.Statistics.Results"));
            }
        }

        [Test]
        public void A_description_names_the_kernels_of_the_settings()
        {
            using (var fluid = Dam())
            {
                fluid.Input.settings.iterations = 3;
                fluid.Input.settings.substeps = 2;
                fluid.Input.material.velocitySmoothing = 0f;
                var kernels = fluid.Solver.Describe(fluid.Input, 0).SelectMany(stage => stage.Kernels).ToDictionary(kernel => kernel.kernel,
                    kernel => kernel.perStep);
                Assert.That(kernels["DensityConstraint.compute: BuildList"], Is.EqualTo(2));
                Assert.That(kernels["DensityConstraint.compute: SolveLambda"], Is.EqualTo(4));
                Assert.That(kernels["DensityConstraint.compute: ApplyDeltaP"], Is.EqualTo(6));
                Assert.That(kernels["NeighborSearch.compute: Gather"], Is.EqualTo(2));
                Assert.That(kernels["VelocityUpdate.compute: UpdateVelocity"], Is.EqualTo(2));
                Assert.That(kernels.Keys.Any(kernel => kernel.Contains("Vorticity")), Is.False);
            }
        }

        [Test]
        public void Positions_without_velocities_are_refused_by_number()
        {
            using (var fluid = new TestFluid(1f, 0.05f, 10))
            using (var three = new NativeArray<float4>(3, Allocator.Persistent))
            using (var two = new NativeArray<float4>(2, Allocator.Persistent))
                Assert.That(Assert.Throws<ArgumentException>(() => fluid.Solver.Add(three, two)).Message,
                    Does.Contain("3 positions with 2 velocities"));
        }

        static TestFluid Dam()
        {
            var fluid = new TestFluid(new float3(1f, 0.6f, 0.5f), 0.05f, 1000);
            AddDam(fluid);
            return fluid;
        }

        // A box filled 0.4 m deep, after two seconds.
        static FluidStatistics StillWater(SolverSettings settings)
        {
            using (var fluid = new TestFluid(new float3(0.5f, 0.6f, 0.5f), 0.05f, 1000, settings).AddBlock(0f, new float3(0.5f, 0.4f, 0.5f)))
                return fluid.Step(120).Measure();
        }

        static void AddDam(TestFluid fluid) => fluid.AddBlock(0f, new float3(0.5f, 0.4f, 0.5f));

        static IEnumerable<string> Buffers(TestFluid fluid)
        {
            return fluid.Solver.Describe(fluid.Input, 0).SelectMany(stage => stage.Buffers).Select(buffer => buffer.name).ToArray();
        }

        static void AssertInside(ParticleState state)
        {
            for (int i = 0; i < state.Count; i++)
            {
                float3 p = state.positions[i].xyz;
                if (!math.all(p >= 0.5f) || !math.all(p <= state.box - 0.5f) || !math.all(math.isfinite(state.velocities[i])))
                    Assert.Fail($"particle {state.ids[i]} is at {p} with velocity {state.velocities[i].xyz} in a box of {state.box}");
            }
        }
    }
}
