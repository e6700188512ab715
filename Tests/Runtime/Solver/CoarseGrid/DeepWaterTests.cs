using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Whole steps with the pressure of deep water solved for on the coarse grid.</summary>
    public class DeepWaterTests
    {
        const float Spacing = 0.05f;
        const int Layers = 40;

        [TestCase(40, 24, 0.02f)]      // wide: with one V-cycle it begins with a fall
        [TestCase(200, 8, 0.01f)]      // a tower: with a coarsest level as long as that it swings
        [Category("LongRun")]
        public void Deep_water_neither_falls_when_it_begins_nor_swings(int layers, int side, float d)
        {
            using (var fluid = new TestFluid(new float3(side, 2f * layers, side) * d, d, side * layers * side, TwoIterations(DeepWater.On))
                .AddBlock(0f, new float3(side, layers, side) * d))
            {
                float energy = fluid.Measure().Energy, lowest = 1f, highest = 0f;
                FluidStatistics statistics = default;
                for (int step = 0; step < 24; step++)
                {
                    statistics = fluid.Step(1).Measure();
                    lowest = math.min(lowest, statistics.volumeRatio);
                    highest = math.max(highest, statistics.Energy);
                }
                TestContext.Out.WriteLine($"volume at least {lowest:0.0000}, energy at most {highest / energy:0.0000} of the start's, " +
                    $"speed {statistics.speed:0.000} m/s");
                Assert.That(lowest, Is.GreaterThan(0.999f));
                Assert.That(highest, Is.LessThan(1.006f * energy));
                Assert.That(statistics.speed, Is.LessThan(0.03f));
            }
        }

        [Test, Category("LongRun")]
        public void A_column_of_forty_layers_holds_with_two_iterations_a_step()
        {
            using (TestFluid fluid = Column(DeepWater.On))
            {
                FluidStatistics start = fluid.Measure(), statistics = start;
                float highest = 0f;
                for (int part = 0; part < 6; part++)
                {
                    statistics = fluid.Step(30).Measure();
                    highest = math.max(highest, statistics.Energy);
                }
                TestContext.Out.WriteLine($"C+ {100f * statistics.densityError:0.000} %, p99.9 {statistics.densityError999:0.000}, " +
                    $"volume {statistics.volumeRatio:0.000}, jitter {statistics.jitter:0.0000} m/s, energy at most " +
                    $"{highest / start.Energy:0.0000} of the start's");
                AssertWhole(fluid, 12 * Layers * 12, statistics);
                Assert.That(statistics.densityError, Is.LessThanOrEqualTo(0.005f));
                Assert.That(statistics.volumeRatio, Is.InRange(0.97f, 1.03f));
                Assert.That(statistics.jitter, Is.LessThanOrEqualTo(0.05f));
                Assert.That(highest, Is.LessThanOrEqualTo(1.005f * start.Energy));
            }
        }

        [Test]
        public void The_same_column_is_compressed_without()
        {
            using (TestFluid fluid = Column(DeepWater.Off))
            {
                FluidStatistics statistics = fluid.Step(60).Measure();
                TestContext.Out.WriteLine($"C+ {100f * statistics.densityError:0.0} %, volume {statistics.volumeRatio:0.000}");
                Assert.That(statistics.densityError, Is.GreaterThan(0.05f));
            }
        }

        // Cells below the lid empty for a moment while the water turns. See Research~/solver-study.md, "Full boxes".
        [TestCase(0f, 3f, 1)]
        [TestCase(0.5f, 5f, 1)]
        [TestCase(0.5f, 5f, 2)]
        [TestCase(2f, 5f, 1)]
        [Category("LongRun")]
        public void Water_that_turns_in_a_box_with_next_to_no_room_gains_no_energy(float room, float speed, int iterations)
        {
            const int side = 20, layers = 12;
            SolverSettings settings = TwoIterations(DeepWater.On);
            settings.iterations = iterations;
            using (var fluid = new TestFluid(new float3(side, layers + room, side) * Spacing, Spacing, side * side * layers, settings))
            {
                ParticleState lattice = ParticleState.Lattice(side, 0.5f, new int3(side, layers, side), 0.02f);
                fluid.Add(lattice.positions.Select(p => p.xyz * Spacing).ToArray(), p => speed * TaylorGreen(math.PI / (side * Spacing) * p));
                float start = fluid.Measure().Energy, highest = 0f;
                for (int part = 0; part < 20; part++)
                    highest = math.max(highest, fluid.Step(2).Measure().Energy);
                TestContext.Out.WriteLine($"energy at most {highest / start:0.0000} of the start's");
                Assert.That(highest, Is.LessThan(1.02f * start));
            }
        }

        static float3 TaylorGreen(float3 phase)
            => new float3(math.sin(phase.x) * math.cos(phase.z), 0f, -math.cos(phase.x) * math.sin(phase.z));

        // The contraction of dilute water must not feed on the grain of still water, which short steps meet the more often.
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(4)]
        [Category("LongRun")]
        public void Still_water_is_still_with_any_number_of_substeps(int substeps)
        {
            SolverSettings settings = TwoIterations(DeepWater.On);
            settings.substeps = substeps;
            using (var fluid = new TestFluid(new float3(12, 20, 12) * Spacing, Spacing, 12 * 12 * 12, settings).AddBlock(0f, 12f * Spacing))
                AssertStill(fluid.Step(120).Measure(), 0.03f);
        }

        static void AssertStill(in FluidStatistics statistics, float maxJitter)
        {
            TestContext.Out.WriteLine($"jitter {statistics.jitter:0.0000} m/s, C+ {100f * statistics.densityError:0.000} %, " +
                $"volume {statistics.volumeRatio:0.000}");
            Assert.That(statistics.jitter, Is.LessThan(maxJitter));
            Assert.That(statistics.volumeRatio, Is.InRange(0.98f, 1.02f));
        }

        // With a shorter screening length its own weight is not held up by the potential in full, and what is left of it keeps it moving.
        [TestCase(2)]
        [TestCase(4)]
        [Category("LongRun")]
        public void A_column_of_40_layers_is_still_with_substeps(int substeps)
        {
            SolverSettings settings = TwoIterations(DeepWater.On);
            settings.substeps = substeps;
            using (var fluid = new TestFluid(new float3(8, 48, 8) * Spacing, Spacing, 8 * 40 * 8, settings)
                .AddBlock(0f, new float3(8, 40, 8) * Spacing))
                AssertStill(fluid.Step(180).Measure(), 0.015f);
        }

        [Test, Category("LongRun")]
        public void A_dam_of_eight_thousand_particles_breaks_without_compression_and_gains_no_energy()
        {
            using (var fluid = new TestFluid(new float3(2f, 1.5f, 1f), Spacing, 8000, TwoIterations(DeepWater.Automatic))
                .AddBlock(0f, new float3(1f, 1f, 1f)))
            {
                float last = fluid.Measure().Energy, first = last;
                var errors = new List<float>();
                FluidStatistics statistics = default;
                for (int part = 0; part < 9; part++)
                {
                    statistics = fluid.Step(10).Measure();
                    errors.Add(statistics.densityError);
                    Assert.That(statistics.Energy, Is.LessThan(last + 0.005f * first), $"after {10 * part + 10} steps");
                    last = statistics.Energy;
                }
                TestContext.Out.WriteLine(
                    $"C+ mean {100f * errors.Average():0.00} %, largest {100f * errors.Max():0.00} %; energy {last / first:0.000}");
                AssertWhole(fluid, 8000, statistics);
                Assert.That(statistics.furthest.x, Is.EqualTo(1.975f).Within(1e-3), "the front has not reached the far wall");
                Assert.That(errors.Average(), Is.LessThan(0.01f));
            }
        }

        [TestCase(1)]
        [TestCase(4)]
        [Category("LongRun")]
        public void A_block_in_free_fall_falls_as_gravity_says(int substeps)
        {
            SolverSettings settings = TwoIterations(DeepWater.On);
            settings.substeps = substeps;
            using (var fluid = new TestFluid(new float3(2f, 4f, 2f), Spacing, 1728, settings).AddBlock(new float3(0.7f, 2.5f, 0.7f), 0.6f,
                new float3(0.2f, 0f, 0.1f)))
            {
                const int steps = 30;
                FluidStatistics after = fluid.Step(steps).Measure();
                double mass = 1000.0 * 1728 * Spacing * Spacing * Spacing;
                var expected = mass * new double3(0.2, -9.81 * steps / 60.0, 0.1);
                double off = math.length(after.momentum - expected) / math.length(expected);
                TestContext.Out.WriteLine($"momentum is off by {100.0 * off:0.000} %");
                AssertWhole(fluid, 1728, after);
                // A coarse cell does not give its particles a pair of forces: their imbalance shows here.
                Assert.That(off, Is.LessThan(0.02));
            }
        }

        [Test]
        public void Without_gravity_a_block_at_rest_stays_where_it_is()
        {
            using (var fluid = new TestFluid(2f, Spacing, 1000, TwoIterations(DeepWater.On)).AddBlock(0.7f, 0.5f, jitter: 0f))
            {
                fluid.Input.gravity = 0f;
                FluidStatistics before = fluid.Measure(), after = fluid.Step(30).Measure();
                TestContext.Out.WriteLine(
                    $"moved {math.distance(after.centerOfMass, before.centerOfMass) / Spacing:g3} d, speed {after.speed:g3} m/s");
                Assert.That(math.distance(after.centerOfMass, before.centerOfMass), Is.LessThan(1e-2f * Spacing));
                Assert.That(after.speed, Is.LessThan(1e-2f));
            }
        }

        [Test]
        public void Two_runs_give_the_same_state_bit_for_bit()
        {
            using (TestFluid first = Splash(), second = Splash())
                TestFluid.AssertSame(second.Step(20).Read(), first.Step(20).Read());

            TestFluid Splash()
            {
                TestFluid fluid = Dam(DeepWater.On);
                fluid.Input.material.vorticity = 0.2f;
                fluid.Input.material.shearModulus = 300f;
                fluid.Input.material.artificialPressure = 0.1f;
                fluid.Input.settings.substeps = 2;
                return fluid;
            }
        }

        [Test]
        public void A_cleared_solver_repeats_its_first_run()
        {
            using (TestFluid fluid = Dam(DeepWater.On))
            {
                ParticleState first = fluid.Step(15).Read();
                fluid.Solver.Clear();
                AddDam(fluid);
                TestFluid.AssertSame(fluid.Step(15).Read(), first);
            }
        }

        [Test]
        public void Steps_in_one_command_buffer_are_the_steps_of_many()
        {
            using (TestFluid together = Dam(DeepWater.On), apart = Dam(DeepWater.On))
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
        public void Deep_and_shallow_solvers_that_fraction_the_shaders_do_not_disturb_each_other()
        {
            using (TestFluid deep = Dam(DeepWater.On), shallow = Shallow(), deepAlone = Dam(DeepWater.On), shallowAlone = Shallow())
            {
                AssertUndisturbed(deep, deepAlone, shallow, shallowAlone);
            }

            TestFluid Shallow() => new TestFluid(new float3(0.8f, 0.8f, 0.8f), 0.04f, 1000).AddBlock(0.1f, new float3(0.4f, 0.36f, 0.4f));
        }

        [Test]
        public void Two_deep_solvers_of_different_size_do_not_disturb_each_other()
        {
            using (TestFluid dam = Dam(DeepWater.On), tall = Tall(), damAlone = Dam(DeepWater.On), tallAlone = Tall())
            {
                AssertUndisturbed(dam, damAlone, tall, tallAlone);
            }

            TestFluid Tall() => new TestFluid(new float3(0.3f, 3f, 0.3f), Spacing, 1000, TwoIterations(DeepWater.On))
                .AddBlock(0f, new float3(0.3f, 1f, 0.3f));
        }

        // Two fluids with common command buffers end as they do alone.
        static void AssertUndisturbed(TestFluid first, TestFluid firstAlone, TestFluid second, TestFluid secondAlone)
        {
            for (int i = 0; i < 12; i++)
                GpuTest.Run(cmd =>
                {
                    first.Solver.Step(cmd, first.Input);
                    second.Solver.Step(cmd, second.Input);
                });
            TestFluid.AssertSame(first.Read(), firstAlone.Step(12).Read());
            TestFluid.AssertSame(second.Read(), secondAlone.Step(12).Read());
        }

        [Test]
        public void Off_leaves_no_kernel_and_no_buffer()
        {
            using (TestFluid fluid = Dam(DeepWater.Off).Step(2))
            {
                StageDescription stage = Coarse(fluid);
                Assert.That(stage.IsUsed, Is.False);
                Assert.That(stage.Kernels, Is.Empty);
                Assert.That(stage.Buffers, Is.Empty);
                Assert.That(stage.Reason, Does.Contain("set to Off"));
                Assert.That(Kernels(fluid), Has.None.Contains("Deep").And.None.Contains("Coarse"));
            }
        }

        [Test]
        public void Artificial_pressure_in_deep_water_has_a_pass_of_its_own()
        {
            using (TestFluid fluid = Dam(DeepWater.On))
            {
                fluid.Input.material.artificialPressure = 0.1f;
                fluid.Step();
                Assert.That(Kernels(fluid), Has.Some.Contains(": ApplyDeltaPDeepWithPressure").And.Some.Contains(
                    ": ApplyDeltaPWithPressure").And.None.EndsWith(": ApplyDeltaPDeep"));
                ParticleState with = fluid.Read();
                using (TestFluid plain = Dam(DeepWater.On).Step())
                    Assert.That(with.positions.Zip(plain.Read().positions, (a, b) => math.distance(a.xyz, b.xyz)).Max(),
                        Is.GreaterThan(1e-4f), "the pressure changes nothing");
            }
        }

        // The block's layers along x, y, z; gravity; whether it is deep.
        static readonly object[] Depths =
        {
            new object[] { new int3(6, 4, 6), new float3(0f, -9.81f, 0f), false },
            new object[] { new int3(6, 5, 6), new float3(0f, -9.81f, 0f), true },
            new object[] { new int3(6, 5, 6), new float3(0f, 3f, 0f), true },
            new object[] { new int3(12, 4, 6), new float3(0f, -9.81f, 0f), false },
            new object[] { new int3(12, 4, 6), new float3(-9.81f, 0f, 0f), true },
            new object[] { new int3(6, 6, 12), new float3(0f, 0f, 2f), true },
            new object[] { new int3(4, 4, 4), new float3(-5f, -5f, 0f), true },        // across a corner
            new object[] { new int3(12, 12, 12), new float3(0f, 0f, 0f), false },
        };

        [TestCaseSource(nameof(Depths))]
        public void Automatic_takes_the_correction_for_more_than_four_layers_along_gravity(int3 layers, float3 gravity, bool deep)
        {
            using (var fluid = new TestFluid(1f, Spacing, 2000).AddBlock(0.1f, (float3)layers * Spacing, jitter: 0f))
            {
                fluid.Input.gravity = gravity;
                Assert.That(IsDeep(fluid.Step()), Is.EqualTo(deep), Coarse(fluid).Reason);
            }
        }

        [Test]
        public void Automatic_follows_gravity_and_what_is_added()
        {
            using (var fluid = new TestFluid(1f, Spacing, 2000).AddBlock(0f, new float3(0.8f, 0.15f, 0.15f)))
            {
                Assert.That(IsDeep(fluid.Step()), Is.False, "3 layers");
                fluid.Input.gravity = new float3(9.81f, 0f, 0f);
                Assert.That(IsDeep(fluid.Step()), Is.True, "16 layers");
                fluid.Input.gravity = math.normalize(new float3(0.06f, -1f, 0f)) * 9.81f;
                Assert.That(IsDeep(fluid.Step()), Is.True, "4 layers, and it runs already");
                fluid.Input.gravity = new float3(0f, -9.81f, 0f);
                Assert.That(IsDeep(fluid.Step()), Is.False, "3 layers again");
                fluid.AddBlock(new float3(0f, 0.7f, 0f), 0.2f);
                Assert.That(IsDeep(fluid.Step()), Is.True, "from 0 to 18 layers");

                fluid.Solver.Clear();
                fluid.AddBlock(0f, new float3(0.8f, 0.15f, 0.15f));
                Assert.That(IsDeep(fluid.Step()), Is.False, "cleared");
            }
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(float.NegativeInfinity)]
        [TestCase(1e30f)]
        public void Automatic_measures_depth_by_the_particles_that_stay(float bad)
        {
            using (var deep = new TestFluid(1f, Spacing, 1000).AddBlock(0f, new float3(0.3f, 0.8f, 0.3f)).Add(new[] { new float3(bad, 0.1f, 0.1f) }))
                Assert.That(IsDeep(deep.Step()), Is.True, Coarse(deep).Reason);
            using (var shallow = new TestFluid(new float3(1f, 0.175f, 1f), Spacing, 1000).AddBlock(0f, new float3(0.3f, 0.15f, 0.3f))
                .Add(new[] { new float3(0.1f, bad, 0.1f) }))
                Assert.That(IsDeep(shallow.Step()), Is.False, Coarse(shallow).Reason);
        }

        [Test]
        public void Switched_on_and_off_while_it_runs_it_goes_on_and_keeps_no_buffer()
        {
            using (TestFluid fluid = Dam(DeepWater.On))
            {
                FluidStatistics statistics = default;
                for (int i = 0; i < 6; i++)
                {
                    fluid.Input.settings.deepWater = i % 2 == 0 ? DeepWater.On : DeepWater.Off;
                    statistics = fluid.Step(3).Measure();
                    Assert.That(Coarse(fluid).Buffers.Count > 0, Is.EqualTo(i % 2 == 0));
                }
                AssertWhole(fluid, 800, statistics);
            }
        }

        [Test]
        public void Gravity_that_needs_larger_cells_gets_them_and_gives_them_back()
        {
            const float d = 0.0125f;
            using (var fluid = new TestFluid(new float3(16f, 30f, 16f) * d, d, 4096, TwoIterations(DeepWater.On))
                .AddBlock(0f, new float3(16f, 16f, 16f) * d))
            {
                long Cells() => Coarse(fluid).Buffers.Single(buffer => buffer.name == "Rill.Coarse.Fill").bytes / sizeof(float);
                float energy = fluid.Measure().Energy;
                fluid.Step(10);
                Assert.That(Cells(), Is.EqualTo(4 * 8 * 4));
                fluid.Input.gravity.y = -80f;
                fluid.Step(10);
                Assert.That(Cells(), Is.EqualTo(2 * 4 * 2));
                fluid.Input.gravity.y = -8.5f;     // well below: a grid changes late
                FluidStatistics statistics = fluid.Step(60).Measure();
                Assert.That(Cells(), Is.EqualTo(4 * 8 * 4));
                TestContext.Out.WriteLine(
                    $"C+ {100f * statistics.densityError:0.00} %, volume {statistics.volumeRatio:0.000}, speed {statistics.speed:0.000} m/s");
                AssertWhole(fluid, 4096, statistics);
                Assert.That(statistics.densityError, Is.LessThan(0.01f));
                Assert.That(statistics.volumeRatio, Is.InRange(0.95f, 1.05f));
                Assert.That(statistics.Energy, Is.LessThan(1.05f * energy));
            }
        }

        [TestCase(0)]
        [TestCase(1)]
        public void Next_to_no_particles_step_without_harm(int count)
        {
            using (var fluid = new TestFluid(1f, Spacing, 10, TwoIterations(DeepWater.On))
                .Add(Enumerable.Repeat(new float3(0.5f), count).ToArray()).Step(5))
            {
                Assert.That(IsDeep(fluid));
                AssertWhole(fluid, count, fluid.Measure());
                // A lone particle's cell is not active: it falls freely.
                if (count == 1)
                    Assert.That(fluid.Read().velocities[0].y * Spacing, Is.EqualTo(-9.81f * 5f / 60f).Within(1e-3f));
            }
        }

        [Test]
        public void The_smallest_box_holds_its_water()
        {
            using (var fluid = new TestFluid(2f * Spacing, Spacing, 8, TwoIterations(DeepWater.On)).AddBlock(0f, 2f * Spacing).Step(30))
                AssertWhole(fluid, 8, fluid.Measure());
        }

        [Test]
        public void A_thousand_particles_at_one_point_come_apart_and_none_is_lost()
        {
            using (var fluid = new TestFluid(1.5f, Spacing, 1000, TwoIterations(DeepWater.On))
                .Add(Enumerable.Repeat(new float3(0.75f), 1000).ToArray()))
            {
                fluid.Input.gravity = 0f;
                FluidStatistics statistics = fluid.Step(90).Measure();
                TestContext.Out.WriteLine($"p99.9 {statistics.densityError999:0.00}, largest {statistics.densityErrorMax:0.00}, speed " +
                    $"at most {statistics.speedMax:0.0} m/s, coincident {statistics.coincident}");
                AssertWhole(fluid, 1000, statistics);
                Assert.That(statistics.densityError999, Is.LessThan(3f));
                // Limits of the motion by passes and grid in a step: 2 x 0.5 d, 2 d and 40 d at most.
                Assert.That(statistics.speedMax, Is.LessThan(43f * Spacing * 60f));
            }
        }

        [TestCase(1e4f)]
        [TestCase(1e30f)]
        public void Speed_without_bounds_stays_finite_and_inside(float speed)
        {
            using (var fluid = new TestFluid(1f, Spacing, 200, TwoIterations(DeepWater.On))
                .AddBlock(0.4f, 0.25f, new float3(speed, -speed, 0.5f * speed)))
                AssertWhole(fluid, 125, fluid.Step(5).Measure());
        }

        static SolverSettings TwoIterations(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            settings.iterations = 2;
            return settings;
        }

        // 12 x 40 x 12 particles that fill their box.
        static TestFluid Column(DeepWater deepWater)
        {
            return new TestFluid(new float3(12f, Layers + 12f, 12f) * Spacing, Spacing, 12 * Layers * 12, TwoIterations(deepWater))
                .AddBlock(0f, new float3(12f, Layers, 12f) * Spacing);
        }

        static TestFluid Dam(DeepWater deepWater)
        {
            var fluid = new TestFluid(new float3(1f, 0.6f, 0.5f), Spacing, 1000, TwoIterations(deepWater));
            AddDam(fluid);
            return fluid;
        }

        static void AddDam(TestFluid fluid) => fluid.AddBlock(0f, new float3(0.5f, 0.4f, 0.5f));

        static StageDescription Coarse(TestFluid fluid) => fluid.Solver.Describe(fluid.Input, 0).Single(stage => stage.Name == "Coarse correction");

        // Both of what is reported and of what exists.
        static bool IsDeep(TestFluid fluid)
        {
            StageDescription stage = Coarse(fluid);
            Assert.That(stage.Buffers.Count > 0, Is.EqualTo(stage.IsUsed));
            Assert.That(Kernels(fluid).Any(kernel => kernel.EndsWith(": BuildListDeep")), Is.EqualTo(stage.IsUsed));
            return stage.IsUsed;
        }

        static string[] Kernels(TestFluid fluid)
            => fluid.Solver.Describe(fluid.Input, 0).SelectMany(stage => stage.Kernels).Select(kernel => kernel.kernel).ToArray();

        static void AssertWhole(TestFluid fluid, int particles, FluidStatistics statistics)
        {
            ParticleState state = fluid.Read();
            Assert.That(state.Count, Is.EqualTo(particles));
            Assert.That(state.ids.Distinct().Count(), Is.EqualTo(particles));
            Assert.That(statistics.refused + statistics.nonFinite + statistics.escaped, Is.Zero);
            for (int i = 0; i < state.Count; i++)
                if (!math.all(state.positions[i].xyz >= 0.5f) || !math.all(state.positions[i].xyz <= state.box - 0.5f)
                    || !math.all(math.isfinite(state.velocities[i])))
                    Assert.Fail($"particle {state.ids[i]} is at {state.positions[i].xyz} with velocity {state.velocities[i].xyz} in a " +
                        $"box of {state.box}");
        }
    }
}
