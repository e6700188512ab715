using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>
    /// Passes between particles and the potential of the coarse grid, pass by pass: each is judged from what the device
    /// made of the pass before.
    /// </summary>
    public class CoarseCorrectionTests
    {
        const float Inactive = CoarseConstants.Inactive;
        const double FlowRounding = 2e-4;           // d: binned in steps of 1/4096, and single precision of 100
        const double ErrorRounding = 1e-5;          // binned in steps of 1/65536

        static readonly float3 Gravity = new float3(0f, -9.81f, 0f);

        // Particles; the box, d. From one cell to counts that no thread group or tile divides.
        static readonly (int count, float3 box)[] Scenes =
        {
            (1, new float3(2f, 2f, 2f)),
            (40, new float3(4f, 4f, 4f)),
            (127, new float3(9f, 5f, 6f)),
            (997, new float3(11f, 17f, 13f)),
            (10007, new float3(28f, 43f, 22f)),
            (20011, new float3(49f, 35f, 29f)),
        };

        static IEnumerable<int> SceneNumbers => Enumerable.Range(0, Scenes.Length);

        [TestCaseSource(nameof(SceneNumbers))]
        public void Fill_activity_and_mean_flow_are_those_of_the_particles_in_a_cell(int scene)
        {
            ParticleState state = Cloud(scene);
            using (var stages = new CoarseStages(state, Gravity).Project())
            {
                CoarseCells cells = stages.FlowCells;
                AssertFill(stages.Fill, cells);
                double3 gravityStep = (double3)Gravity / SolverStages.Spacing * CoarseStages.TimeStep * CoarseStages.TimeStep;
                double3[] mean = cells.Mean(stages.AlongFlow, i => (double3)state.velocities[i].xyz * CoarseStages.TimeStep);
                float4[] flow = stages.Flow;
                int[] active = Active(cells);
                if (scene >= 3)
                    Assert.That(active.Length, Is.InRange(1, cells.Total - 1), "the scene has cells of one kind only");
                Compare.Vectors("flow", active.Length, k => flow[active[k]].xyz, k => mean[active[k]] + gravityStep, k => 2.0 * FlowRounding);
                Assert.That(stages.Bins.All(word => word == 0u), "bins are left empty");
            }
        }

        [TestCaseSource(nameof(SceneNumbers))]
        public void The_projections_equation_has_the_divergence_and_the_free_surface_in_it(int scene)
        {
            using (var stages = new CoarseStages(Cloud(scene), Gravity).Project())
            {
                CoarseCells cells = stages.FlowCells;
                double3[] flow = Compare.Points(stages.Flow);
                float[] source = stages.Source;
                AssertInactive(stages, cells, stages.FlowPotential);
                int[] active = Active(cells);
                Compare.Scalars("source", active.Length, k => source[active[k]], k => -cells.Divergence(active[k], flow), k => 1e-5);
                AssertDiagonal(stages, cells);
            }
        }

        [TestCase(3)]
        [TestCase(4)]
        [TestCase(5)]
        public void At_the_surface_particles_are_weighted_from_the_second_substep_on(int scene)
        {
            ParticleState state = Cloud(scene).With(_ => 0f);
            using (CoarseStages stages = new CoarseStages(state).Project())
            {
                CoarseCells cells = stages.FlowCells;
                AssertSurfaceFill(stages, cells);
                stages.CorrectDensity(new float[state.Count]).Project();
                Assert.That(() => AssertSurfaceFill(stages, cells), Throws.InstanceOf<AssertionException>(), "not weighted");
                cells.Weigh(stages.AlongFlow);
                AssertSurfaceFill(stages, cells);
                AssertDiagonal(stages, cells, 1e-4);        // weights are whole steps
                Assert.That(stages.Fill.Select(fill => fill > 0f), Is.EqualTo(cells.active), "active cells");
                Assert.That(cells.active, Is.Not.EqualTo(stages.FlowCells.active), "weights decide as counts do");
            }
        }

        static void AssertSurfaceFill(CoarseStages stages, CoarseCells cells)
        {
            float[] actual = stages.SurfaceFill;
            Compare.Scalars("fill at the surface", cells.Total, i => actual[i], i => cells.water[i], i => 1e-3 * Math.Max(cells.fill[i], 0.1));
        }

        [TestCaseSource(nameof(SceneNumbers))]
        public void Displacements_of_the_projection_follow_from_its_potential(int scene)
        {
            using (var stages = new CoarseStages(Cloud(scene), Gravity).Project())
                AssertDisplacements(stages, stages.FlowCells, stages.FlowPotential, Compare.Points(stages.Flow));
        }

        [TestCaseSource(nameof(SceneNumbers))]
        public void Velocities_take_the_displacement_at_their_particles_place(int scene)
        {
            ParticleState state = Cloud(scene);
            using (var stages = new CoarseStages(state, Gravity).Project())
                AssertVelocities(stages, state);
        }

        [Test]
        public void A_displacement_of_the_projection_is_at_most_40_spacings()
        {
            ParticleState state = Block(24).With(p => new float3(p.x < 16f ? 5000f : -5000f, 0f, 0f));
            using (var stages = new CoarseStages(state).Project())
            {
                AssertVelocities(stages, state);
                float longest = stages.Velocities.Zip(state.velocities, (after, before) => math.length(after.xyz - before.xyz))
                    .Max() * CoarseStages.TimeStep;
                Assert.That(longest, Is.EqualTo(40f).Within(0.01f), "nothing was so fast that it had to be clamped");
            }
        }

        [Test]
        public void Particles_beyond_the_outermost_centers_take_those_cells_displacement()
        {
            ParticleState state = Block(24, box: 24f).With(p => 60f * math.sin(p.yzx));
            using (var stages = new CoarseStages(state, Gravity).Project())
            {
                Assert.That(state.positions.Count(p => math.all(p.xyz < 2f) || math.all(p.xyz > 22f)), Is.GreaterThan(4),
                    "no particle is in a corner");
                AssertVelocities(stages, state);
            }
        }

        [Test]
        public void Displacements_longer_than_100_spacings_are_binned_as_100()
        {
            ParticleState state = Block(8, box: 8f).With(p => new float3(1e5f, -1e5f, 1e30f));
            using (var stages = new CoarseStages(state).Project())
            {
                float4[] flow = stages.Flow;
                int[] active = Active(stages.FlowCells);
                Compare.Vectors("flow", active.Length, k => flow[active[k]].xyz, i => new double3(100.0, -100.0, 100.0), i => FlowRounding);
                Assert.That(active, Has.Length.EqualTo(1), "all are pressed into one corner");
            }
        }

        [Test]
        public void Ten_thousand_particles_in_one_cell_overflow_no_sum()
        {
            var random = new Unity.Mathematics.Random(31);
            ParticleState state = new ParticleState(12f, Enumerable.Range(0, 10000).Select(_ => random.NextFloat3(4.1f, 7.9f)).ToArray())
                .With(p => new float3(5900f, -5900f, 60f * p.x));
            using (var stages = new CoarseStages(state).Project())
            {
                const int crowded = 13, ahead = 20;     // of 3 x 3 x 3 the center, and the corner where all flow to
                Assert.That(stages.Fill[ahead], Is.EqualTo(10000f / 64f).Within(1e-3f));
                double3 mean = default;
                foreach (float4 velocity in state.velocities)
                    mean += (double3)velocity.xyz * CoarseStages.TimeStep / 10000.0;
                Assert.That(math.length(stages.Flow[ahead].xyz - mean), Is.LessThan(FlowRounding));

                float[] errors = Enumerable.Range(0, 10000).Select(i => i % 50 == 0 ? 8f : -0.1f).ToArray();
                stages.CorrectDensity(errors);
                Assert.That(stages.Source[crowded], Is.EqualTo(errors.Average(e => (double)e)).Within(ErrorRounding));
            }
        }

        [TestCase(2)]
        [TestCase(3)]
        public void Sums_do_not_depend_on_the_order_of_the_particles(int seed)
        {
            ParticleState state = Cloud(4);
            float[] errors = Errors(state);
            ParticleState shuffled = state.Shuffled(seed);
            using (CoarseStages one = new CoarseStages(state, Gravity).Project(), other = new CoarseStages(shuffled, Gravity).Project())
            {
                Compare.Same("displacements of the projection", other.Displacements, one.Displacements);
                one.CorrectDensity(errors);
                other.CorrectDensity(shuffled.ids.Select(id => errors[id]).ToArray());
                Compare.Same("displacements of the density correction", other.Displacements, one.Displacements);
                Compare.Same("errors", other.LastErrors.Select(math.asuint).ToArray(), one.LastErrors.Select(math.asuint).ToArray());
            }
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(float.NegativeInfinity)]
        public void Particles_that_are_not_finite_are_in_no_cell_and_get_nothing(float bad)
        {
            ParticleState state = Cloud(3);
            for (int i = 0; i < state.Count; i += 7)
            {
                if (i % 2 == 0)
                    state.positions[i].y = bad;
                else
                    state.velocities[i].z = bad;
            }
            using (var stages = new CoarseStages(state, Gravity).Project())
            {
                AssertFill(stages.Fill, stages.FlowCells);
                Assert.That(stages.Displacements.All(d => math.all(math.isfinite(d.xyz))));
                float4[] after = stages.Velocities;
                for (int i = 0; i < state.Count; i++)
                    Assert.That(math.all(math.isfinite(after[i].xyz)), Is.EqualTo(math.all(math.isfinite(state.velocities[i].xyz))), $"particle {i}");
                for (int i = 0; i < state.Count; i += 14)
                    Assert.That(after[i].xyz, Is.EqualTo(state.velocities[i].xyz), $"particle {i} is nowhere");
            }
        }

        [TestCaseSource(nameof(SceneNumbers))]
        public void The_density_corrections_equation_has_the_mean_error_in_it(int scene)
        {
            ParticleState state = Cloud(scene);
            float[] errors = Errors(state);
            using (var stages = new CoarseStages(state, Gravity))
            {
                GpuTest.FillWithGarbage(stages.Correction.Cells.lastErrors);
                stages.CorrectDensity(errors);
                CoarseCells cells = stages.Cells;
                AssertFill(stages.Fill, cells);
                AssertInactive(stages, cells, stages.ErrorPotential);
                double[] mean = cells.Mean(Compare.Points(state.positions), i => Math.Min(Math.Max(errors[i], -0.1), 8.0))
                    .Select(m => Math.Min(m.x, 1.0)).ToArray();
                int[] active = Active(cells);
                float[] source = stages.Source, kept = stages.LastErrors;
                if (scene == 5)
                {
                    Assert.That(active.Any(cell => mean[cell] == 1.0), "no cell was clamped");
                    Assert.That(active.Any(cell => mean[cell] < 0.0), "no cell is too dilute");
                }
                Compare.Scalars("source", active.Length, k => source[active[k]], k => mean[active[k]], k => ErrorRounding);
                Compare.Scalars("errors kept for the next projection", cells.Total, i => kept[i], i => cells.active[i]
                    ? Kept(mean[i], cells, i) : 0.0, i => ErrorRounding);
                AssertDiagonal(stages, cells);
                AssertDisplacements(stages, cells, stages.ErrorPotential, null);
                Assert.That(stages.Bins.All(word => word == 0u), "bins are left empty");
            }
        }

        // Less what each particle of the outermost layer, one a d², is counted too dilute by at most.
        static double Kept(double mean, CoarseCells cells, int cell)
            => mean < 0.0 ? Math.Min(mean + 0.1 * cells.SurfaceLayer(cell) / (cells.fill[cell] * cells.Volume), 0.0) : mean;

        [TestCase(0)]
        [TestCase(1)]
        public void The_outermost_layer_of_still_water_is_not_taken_for_dilution(int extraLayers)
        {
            // Four layers fill a cell, more reach into the next: the outermost is there.
            ParticleState state = ParticleState.Lattice(8f, 0.5f, new int3(8, 4 + extraLayers, 8), 0f);
            float[] errors = state.positions.Select(p => p.y > 3f && p.y < 4f ? -0.4f : 0f).ToArray();
            using (CoarseStages stages = new CoarseStages(state, Gravity).CorrectDensity(errors))
            {
                int[] active = Active(stages.Cells);
                Assert.That(active.Length, Is.EqualTo(4));
                foreach (int cell in active)
                {
                    Assert.That(stages.Source[cell], Is.EqualTo(-0.025f).Within(1e-5f), "of the correction itself");
                    Assert.That(stages.LastErrors[cell], Is.EqualTo(extraLayers == 0 ? 0f : -0.025f).Within(1e-5f));
                }
            }
        }

        [Test]
        public void Spray_counts_as_a_tenth_too_dilute_and_a_crowd_as_eight_times_too_dense()
        {
            ParticleState state = Block(4, box: 4f);
            using (var spray = new CoarseStages(state).CorrectDensity(Enumerable.Repeat(-0.9f, 64).ToArray()))
                Assert.That(spray.Source[0], Is.EqualTo(-0.1f).Within(1e-5f));
            // 1 of 64 far too dense, the others a little too dilute: the mean shows the upper clamp.
            using (var crowd = new CoarseStages(state).CorrectDensity(Enumerable.Range(0, 64).Select(i => i == 5 ? 1000f : -0.05f).ToArray()))
                Assert.That(crowd.Source[0], Is.EqualTo((8f - 63 * 0.05f) / 64f).Within(1e-5f));
        }

        [TestCase(1)]
        [TestCase(3)]
        public void The_projection_takes_up_a_growing_share_of_the_last_errors_below_zero_and_none_above(int substeps)
        {
            ParticleState state = Cloud(4);
            float[] errors = state.positions.Select(p => p.x < 6f ? -0.007f : p.x < 14f ? -0.08f : 0.2f).ToArray();
            using (CoarseStages plain = new CoarseStages(state, Gravity, substeps: substeps).Project(),
                after = new CoarseStages(state, Gravity, substeps: substeps).CorrectDensity(errors).Project())
            {
                float[] without = plain.Source, with = after.Source, last = after.LastErrors;
                int[] active = Enumerable.Range(0, with.Length).Where(cell => with[cell] != Inactive && without[cell] != Inactive).ToArray();
                if (substeps == 1)
                    Assert.That(active, Is.EqualTo(Active(plain.FlowCells)), "active cells");
                Assert.That(active.Count(cell => last[cell] < -0.05f), Is.GreaterThan(5));
                Assert.That(active.Count(cell => last[cell] < 0f && last[cell] > -0.008f), Is.GreaterThan(5));
                Assert.That(active.Count(cell => last[cell] > 0.05f), Is.GreaterThan(5));
                Compare.Scalars("source", active.Length, k => with[active[k]] - without[active[k]], k => Taken(last[active[k]], substeps), k => 1e-6);
            }
        }

        static double Taken(double error, int substeps)
            => 0.3 / substeps * (1.0 - 40.0 * error) * Math.Min(error + 0.0133 * (1.0 - 1.0 / substeps), 0.0);

        // A box of 12 x 20 x 9 d, 3.79 cells high along gravity, whose room is 0.36 and 0.34 of such a layer, exactly full, with one particle too
        // many, and with a ninth too many. See Research~/solver-study.md, "Full boxes".
        [TestCase(1955, 0.0)]
        [TestCase(1967, 1e-3)]
        [TestCase(2160, 1e-3)]
        [TestCase(2161, 5000.0 * 1.5 / 2160.0)]
        [TestCase(2400, double.PositiveInfinity)]
        public void A_box_that_is_nearly_full_or_holds_too_much_is_lifted_screened_more_and_takes_up_no_dilution(int count, double wanted)
        {
            float3 box = new float3(12f, 20f, 9f), gravity = new float3(3f, -9.81f, -5f);
            var random = new Unity.Mathematics.Random(77u);
            ParticleState state = new ParticleState(box, Enumerable.Range(0, count).Select(_ => random.NextFloat3(0.6f, box - 0.6f)).ToArray())
                .With(p => 8f * math.sin(p.yzx));
            double weight = math.dot(math.abs((double3)gravity), box) / SolverStages.Spacing * CoarseStages.TimeStep * CoarseStages.TimeStep;
            double lift = Math.Min(wanted, 5.0 + 2.0 * weight);
            using (var stages = new CoarseStages(state, gravity))
            {
                stages.CorrectDensity(Enumerable.Repeat(-0.06f, count).ToArray());
                AssertScreened(stages.Cells, lift > 0.0 ? 30.0 : 1.0);
                Assert.That(stages.Source, Is.All.EqualTo(-0.06f).Within(ErrorRounding));
                float[] last = stages.LastErrors;
                Assert.That(last, Is.All.EqualTo(-0.06f).Within(ErrorRounding), "no surface exists");

                stages.Project();
                CoarseCells cells = stages.FlowCells;
                AssertScreened(cells, lift > 0.0 ? 3.0 : 1.0);
                double3[] flow = Compare.Points(stages.Flow);
                float[] source = stages.Source;
                Compare.Scalars("source", cells.Total, i => source[i],
                    i => (lift > 0.0 ? 3.0 * lift * CoarseCells.Screening : Taken(last[i], 1)) - cells.Divergence(i, flow), i => 3e-6);

                void AssertScreened(CoarseCells of, double times)
                {
                    Assert.That(of.active, Is.All.True);
                    float[] diagonal = stages.Diagonal;
                    Compare.Scalars("diagonal", of.Total, i => diagonal[i], i => of.Diagonal(i) + (times - 1.0) * CoarseCells.Screening, i => 3e-6);
                }
            }
        }

        // A neighbor that has a coarse grid too is coupled to 100 times as strongly; see Research~/solver-study.md, "Connected boxes".
        [Test]
        public void At_an_open_end_flow_goes_out_and_the_potential_is_held_to_what_is_known_beyond([Values(0, 1, 2, 3, 4, 5)] int end,
            [Values] bool isTied)
        {
            float3 box = new float3(12f, 20f, 9f);
            var random = new Unity.Mathematics.Random(78u);
            ParticleState state = new ParticleState(box, Enumerable.Range(0, 1900).Select(_ => random.NextFloat3(0.6f, box - 0.6f)).ToArray())
                .With(p => 8f * math.sin(p.yzx));
            int axis = end / 2, toNext = end % 2;
            using (var stages = new CoarseStages(state, Gravity, openFaces: 1u << end | (isTied ? 1u << 6 + end : 0u)))
            {
                float[] known = Enumerable.Range(0, stages.Grid.Total).Select(_ => random.NextFloat(0.5f, 2f)).ToArray();
                stages.Correction.Cells.flowPotential.SetData(known);
                stages.Project();
                CoarseCells cells = stages.FlowCells;
                Assert.That(cells.active, Is.All.True);
                float[] diagonal = stages.Diagonal, source = stages.Source;
                double3[] flow = Compare.Points(stages.Flow);
                Compare.Scalars("diagonal", cells.Total, i => diagonal[i], i => cells.Diagonal(i) + Coupling(i), i => 1e-5 * (1.0 + Coupling(i)));
                Compare.Scalars("source", cells.Total, i => source[i], i => Coupling(i) * known[i] - cells.Divergence(i, flow)
                    - (IsAtEnd(i) ? (2 * toNext - 1) * flow[i][axis] / cells.size[axis] : 0.0), i => 1e-5 * (1.0 + Coupling(i)));

                // A neighbor's pressure on its side of the end is its own.
                stages.CorrectDensity(Errors(state));
                diagonal = stages.Diagonal;
                Compare.Scalars("diagonal", cells.Total, i => diagonal[i], i => stages.Cells.Diagonal(i) + Coupling(i),
                    i => 1e-5 * (1.0 + Coupling(i)));

                bool IsAtEnd(int cell) => cells.Coordinates(cell)[axis] == toNext * (cells.counts[axis] - 1);
                double Coupling(int cell) => IsAtEnd(cell) ? (isTied ? 100.0 : 1.0) / (cells.size[axis] * cells.size[axis]) : 0.0;
            }
        }

        [Test]
        public void Flow_of_a_whole_full_box_is_stopped()
        {
            // It would move by (-0.5, 0.25, 0) d; as it cannot, the displacement is the opposite.
            ParticleState state = Block(32, box: 32f).With(p => new float3(-30f, 15f, 0f));
            using (var stages = new CoarseStages(state))
            {
                for (int i = 0; i < 12; i++)
                    stages.Project();       // from the velocities of the last: what is left shrinks
                float rest = stages.Velocities.Average(v => math.length(v.xyz)) * CoarseStages.TimeStep;
                TestContext.Out.WriteLine($"{rest:0.000} d are left of 0.559");
                Assert.That(rest, Is.LessThan(0.05f));
            }
        }

        [Test]
        public void No_particles_leave_every_cell_without_a_displacement()
        {
            using (var stages = new CoarseStages(new ParticleState(20f, new float3[0]), Gravity).Project())
            {
                Assert.That(stages.Displacements.All(d => math.all(d == 0f)));
                Assert.That(stages.Source.All(source => source == Inactive));
                stages.CorrectDensity(new float[0]);
                Assert.That(stages.Displacements.All(d => math.all(d == 0f)));
            }
        }

        [TestCase(1)]
        [TestCase(127)]
        [TestCase(129)]
        [TestCase(10007)]
        public void Errors_handed_to_the_grid_are_those_of_the_constraint(int count)
        {
            // With a crowd at one point, spray around and a cell's worth of particles that are too dense.
            ParticleState state = ParticleState.Random(count, seed: 5);
            for (int i = 0; i < count / 5; i++)
                state.positions[i] = new float4(5.5f + 0.05f * math.sin(new float3(i, 2f * i, 3f * i)), 0f);
            using (var stages = new SolverStages(state, SolverStages.Still()).Sort())
            using (var coarse = new CoarseCorrection(stages.Layout, 4f))
            {
                GpuTest.Run(cmd => stages.Constraint.RecordList(stages.Context(cmd, stages.Input, coarse)));
                float4[] sorted = stages.Multipliers;
                double3[] points = Compare.Points(sorted);
                var reference = new Constraint(state.box, points, Neighbors.ByCells(points, Kernels.H));
                float[] errors = Enumerable.Range(0, count).Select(i => (float)(reference.Density(i) - 1.0)).ToArray();
                if (count > 1000)
                {
                    Assert.That(errors.Count(e => e < -0.1f), Is.GreaterThan(50), "no spray");
                    Assert.That(errors.Count(e => e > 8f), Is.GreaterThan(50), "no crowd");
                    Assert.That(errors.Count(e => e > -0.1f && e < 8f), Is.GreaterThan(50), "nothing between the limits");
                }
                uint[] expected = CoarseStages.ErrorBins(coarse.Grid, state.box, sorted, errors),
                    bins = GpuTest.Read<uint>(coarse.Bins, coarse.Bins.count);
                for (int bin = 0; bin < expected.Length; bin += 8)
                {
                    Assert.That(bins[bin], Is.EqualTo(expected[bin]), $"particles of cell {bin / 8}");
                    double sum = bins[bin + 2] * 4294967296.0 + bins[bin + 1], exact = expected[bin + 2] * 4294967296.0 + expected[bin + 1];
                    Assert.That(sum, Is.EqualTo(exact).Within(expected[bin] * (1.0 + 1e-4 * 65536.0)), $"errors of cell {bin / 8}");
                }
            }
        }

        [TestCase(0f)]
        [TestCase(0.1f)]
        public void The_first_pass_adds_the_grids_displacement_to_its_own(float artificialPressure)
        {
            // A beam between four walls, a fifth too close: its ends are pushed out by more than the 2 d of the limit.
            ParticleState state = ParticleState.Lattice(new float3(48f, 8f, 8f), 0f, new int3(32, 10, 10), jitter: 0.02f);
            for (int i = 0; i < state.Count; i++)
                state.positions[i] = new float4(new float3(8f, 0.4f, 0.4f) + 0.8f * math.max(state.positions[i].xyz, 0f), 0f);
            FluidMaterial material = FluidMaterial.Water;
            material.artificialPressure = artificialPressure;
            material.artificialPressureDistance = 0.25f;
            SolverSettings settings = SolverSettings.Default;
            settings.neighborCapacity = 256;
            settings.relaxation = 0.8f;
            using (var stages = new SolverStages(state, SolverStages.Still(settings, material)).Sort())
            using (var coarse = new CoarseCorrection(stages.Layout, 4f))
            {
                for (int i = 0; i < 4; i++)         // the same particles again: the potential converges
                    stages.Constrain(0, coarse);
                stages.Sort().Constrain(1, coarse);
                float4[] before = stages.Multipliers, after = stages.Predicted;
                double3[] points = Compare.Points(before);
                double[] multipliers = before.Select(p => (double)p.w).ToArray();
                var reference = new Constraint(state.box, points, Neighbors.ByCells(points, Kernels.H))
                {
                    relaxation = 0.8f,
                    artificialPressure = artificialPressure,
                    artificialPressureDistance = 0.25f,
                };
                CoarseCells cells = new CoarseCells(state.box, coarse.Grid.Counts).Fill(points);
                double3[] displacements = Compare.Points(GpuTest.Read<float4>(coarse.Displacements, coarse.Grid.Total));
                Assert.That(displacements.Max(d => math.length(d)), Is.GreaterThan(0.6), "nothing had to be clamped");
                Compare.Vectors("corrected positions", state.Count, i => after[i].xyz, i =>
                {
                    double3 own = reference.Correction(i, multipliers, out double size);
                    double3 moved = points[i] + own + cells.LookUp(displacements, points[i], 0.5);
                    return math.clamp(moved, new double3(0.5), (double3)state.box - 0.5);
                }, i => 1e-4);
            }
        }

        [Test]
        public void A_wrong_weight_of_the_free_surface_is_noticed()
        {
            using (var stages = new CoarseStages(Cloud(4), Gravity).Project())
            {
                CoarseCells cells = stages.FlowCells;
                AssertDiagonal(stages, cells);
                cells.water[Active(cells).First(cell => HasSurface(cells, cell))] -= 0.05;
                Assert.That(() => AssertDiagonal(stages, cells), Throws.InstanceOf<AssertionException>());
            }

            bool HasSurface(CoarseCells cells, int cell)
            {
                int above = cells.Beside(cell, 1, true);
                return above >= 0 && !cells.active[above] && cells.fill[cell] + cells.fill[above] < 1.9
                    && cells.fill[cell] + cells.fill[above] > 0.9 && cells.fill[cell] < 1.0;
            }
        }

        static int[] Active(CoarseCells cells) => Enumerable.Range(0, cells.Total).Where(cell => cells.active[cell]).ToArray();

        static void AssertFill(float[] fill, CoarseCells cells)
        {
            Compare.Scalars("fill", cells.Total, i => fill[i], i => cells.active[i] ? cells.fill[i] : -cells.fill[i],
                i => 1e-6 * Math.Max(cells.fill[i], 1e-3));
        }

        static void AssertInactive(CoarseStages stages, CoarseCells cells, float[] potential)
        {
            float[] source = stages.Source, diagonal = stages.Diagonal;
            for (int cell = 0; cell < cells.Total; cell++)
            {
                if (cells.active[cell])
                    Assert.That(potential[cell], Is.GreaterThanOrEqualTo(0f), $"cell {cell}");
                else
                    Assert.That(new[] { potential[cell], source[cell], diagonal[cell] }, Is.EqualTo(new[] { 0f, Inactive, 1f }), $"cell {cell}");
            }
        }

        static void AssertDiagonal(CoarseStages stages, CoarseCells cells, double tolerance = 1e-5)
        {
            float[] diagonal = stages.Diagonal;
            int[] active = Active(cells);
            Compare.Scalars("diagonal", active.Length, k => diagonal[active[k]], k => cells.Diagonal(active[k]),
                k => tolerance * cells.Diagonal(active[k]));
        }

        static void AssertDisplacements(CoarseStages stages, CoarseCells cells, float[] potential, double3[] flow)
        {
            cells.gravityStep = (double3)Gravity / SolverStages.Spacing * CoarseStages.TimeStep * CoarseStages.TimeStep;
            double3[] expected = cells.Displacements(potential.Select(p => (double)p).ToArray(), flow);
            float4[] actual = stages.Displacements;
            double largest = potential.Max() / math.cmin(cells.size);
            Compare.Vectors("displacements", cells.Total, i => actual[i].xyz, i => expected[i], i => 1e-5 + 1e-5 * largest);
        }

        static void AssertVelocities(CoarseStages stages, ParticleState state)
        {
            CoarseCells cells = stages.FlowCells;
            double3[] displacements = Compare.Points(stages.Displacements), positions = stages.AlongFlow;
            double3 gravityStep = (double3)stages.Gravity / SolverStages.Spacing * CoarseStages.TimeStep * CoarseStages.TimeStep;
            double3[] flow = Compare.Points(stages.Flow).Select(f => f - gravityStep).ToArray();
            double3[] sharp = Enumerable.Range(0, cells.Total).Select(i => cells.active[i] ? cells.SharpFlow(i, flow) : default).ToArray();
            double3[] deep = Enumerable.Range(0, cells.Total).Select(i => new double3(cells.IsDeep(i) ? 1.0 : 0.0)).ToArray();
            float4[] after = stages.Velocities;
            Compare.Vectors("velocities", state.Count, i => after[i].xyz,
                i => state.velocities[i].xyz + Pressed(state.velocities[i].w) *
                    cells.LookUp(displacements, positions[i], 40.0) / CoarseStages.TimeStep
                    - TakenOfDeparture * cells.Departure(sharp, deep, positions[i], (double3)state.velocities[i].xyz * CoarseStages.TimeStep)
                        / CoarseStages.TimeStep,
                i => 1e-3 + 1e-5 * math.length(state.velocities[i].xyz));
        }

        // 6.3 / s in a step of 1/60 s; see Research~/solver-study.md, "Blend to the coarse flow".
        const double TakenOfDeparture = 0.09968;

        // Fraction of the projection that a particle of this density takes: spray none, the edge of still water all of it.
        static double Pressed(double density) => Math.Min(Math.Max((density - 0.3) / 0.25, 0.0), 1.0);

        // Errors on both sides of all limits, dense in one corner.
        static float[] Errors(ParticleState state)
        {
            return state.positions.Select((p, i) => i % 97 == 3 ? 30f : i % 31 == 4 ? -0.7f
                : 1.5f * (1f - 2f * p.x / state.box.x) + 0.02f * (i % 5)).ToArray();
        }

        // Water about half the box deep, in heaps, with empty places within, spray above and a velocity that varies.
        static ParticleState Cloud(int scene)
        {
            (int count, float3 box) = Scenes[scene];
            var random = new Unity.Mathematics.Random((uint)(count * 31 + 7));
            float3 cell = box / (float3)new CoarseGrid(box, 4f).Counts;
            var positions = new List<float3>();
            while (positions.Count < count)
            {
                float3 p = random.NextFloat3(0.5f, box - 0.5f);
                bool spray = positions.Count % 50 == 0;
                float surface = box.y * (0.55f + 0.2f * math.sin(0.3f * p.x) * math.cos(0.2f * p.z));
                if ((spray || p.y < surface || scene < 2) && IsClear(p) && IsClear((float3)CoarseStages.AlongFlowOf(p, Velocity(p), box, Gravity)))
                    positions.Add(p);
            }
            ParticleState state = new ParticleState(box, positions.ToArray()).With(Velocity);
            for (int i = 0; i < count; i++)
                state.velocities[i].w = 0.2f + 0.05f * (i % 12);        // densities: spray and water
            return state;

            float3 Velocity(float3 p) => 40f * new float3(math.sin(0.4f * p.y), math.cos(0.3f * p.x) - 0.5f, math.sin(0.5f * p.x + 0.2f * p.z));

            // Not so near to a cell's side that rounding decides which it is in.
            bool IsClear(float3 p)
            {
                float3 inCell = math.frac(p / cell);
                return math.all(inCell > 1e-4f) && math.all(inCell < 1f - 1e-4f);
            }
        }

        // Somewhat off a lattice, in the center of a cube.
        static ParticleState Block(int side, float box = 32f)
        {
            return ParticleState.Lattice(box, 0.5f * (box - side) + 0.5f, side, jitter: 0.02f);
        }
    }
}
