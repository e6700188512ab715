using System;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    public class DensityConstraintTests
    {
        // Single precision over some 30 to 60 neighbors.
        const double Rounding = 1e-5;

        [Test]
        public void Lists_hold_exactly_the_neighbors_within_the_radius(
            [ValueSource(typeof(GpuTest), nameof(GpuTest.Sizes))] int count, [Values(1f, 1.25f)] float margin)
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.listMargin = margin;
            settings.neighborCapacity = 256;
            using (var stages = Listed(ParticleState.Random(count, seed: count), settings))
                NeighborSets.AssertSame(stages.ListedNeighbors(), Compare.Points(stages.Multipliers), Kernels.H * margin);
        }

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Multipliers_are_those_of_the_reference(int count)
        {
            using (var stages = Listed(ParticleState.Random(count, seed: count + 1), SolverStages.Roomy))
                AssertMultipliers(stages, stages.Multipliers, reference => { });
        }

        [Test]
        public void Allowed_tension_pulls_on_particles_below_the_rest_density()
        {
            FluidMaterial material = FluidMaterial.Water;
            material.allowedTension = 0.5f;
            using (var stages = Listed(ParticleState.Random(997, seed: 2), SolverStages.Roomy, material))
            {
                float4[] multipliers = stages.Multipliers;
                AssertMultipliers(stages, multipliers, reference => reference.allowedTension = 0.5);
                Assert.That(multipliers.Count(p => p.w > 0f), Is.GreaterThan(100));
            }
        }

        [Test]
        public void Softness_sets_the_denominator()
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.softness = 0.5f;
            using (var stages = Listed(ParticleState.Random(997, seed: 3), settings))
                AssertMultipliers(stages, stages.Multipliers, reference => reference.softness = 0.5);
        }

        [TestCase(129)]
        [TestCase(997)]
        [TestCase(100003)]
        public void Solving_from_the_list_gives_the_multipliers_of_building_it(int count)
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.relaxation = 0f;       // nothing moves between the passes
            ParticleState state = ParticleState.Random(count, seed: count + 2);
            using (var built = Listed(state, settings))
            using (var solved = Listed(state, settings).Constrain(iterations: 2))
            {
                float4[] expected = built.Multipliers, actual = solved.Multipliers;
                Compare.Scalars("multipliers", count, i => actual[i].w, i => expected[i].w, i => 1e-6 + 1e-6 * Math.Abs(expected[i].w));
                Compare.Vectors("positions", count, i => actual[i].xyz, i => expected[i].xyz, i => 1e-12);
            }
        }

        [Test]
        public void Later_passes_solve_at_the_corrected_positions_with_the_first_list()
        {
            ParticleState state = ParticleState.Random(997, seed: 4);
            using (var built = Listed(state, SolverStages.Roomy))
            using (var solved = Listed(state, SolverStages.Roomy).Constrain(iterations: 2))
            {
                float4[] actual = solved.Multipliers;
                Assert.That(math.distance(actual[0].xyz, built.Multipliers[0].xyz) + math.distance(actual[500].xyz,
                    built.Multipliers[500].xyz), Is.GreaterThan(0f), "the first pass moved nothing");
                int[][] lists = Neighbors.BruteForce(Compare.Points(built.Multipliers), Kernels.H);
                var reference = new Constraint(state.box, Compare.Points(actual), lists);
                Compare.Scalars("multipliers", 997, i => actual[i].w, reference.Multiplier, i => reference.MultiplierTolerance(i, Rounding));
            }
        }

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Displacements_are_those_of_the_reference(int count)
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.relaxation = 0.9f;
            using (var stages = Listed(ParticleState.Random(count, seed: count + 5), settings).Constrain(iterations: 1))
                AssertDisplaced(stages, reference => reference.relaxation = 0.9f);
        }

        [TestCase(129)]
        [TestCase(997)]
        public void Displacements_with_artificial_pressure_are_those_of_the_reference(int count)
        {
            FluidMaterial material = FluidMaterial.Water;
            material.artificialPressure = 0.1f;
            material.artificialPressureDistance = 0.25f;
            SolverSettings settings = SolverStages.Roomy;
            settings.relaxation = 1f;
            using (var stages = Listed(ParticleState.Random(count, seed: count + 6), settings, material).Constrain(iterations: 1))
                AssertDisplaced(stages, reference =>
                {
                    reference.artificialPressure = 0.1f;
                    reference.artificialPressureDistance = 0.25f;
                });
        }

        // At 0.0625 m, 1000 kg/m³ and 60 steps a second 1 of Σ is 878.90625 N/m. Two passes, no deep water: at most 0.02.
        [TestCase(129, 8.7890625f, 180f, 2.6 * 0.01 / 2, 0.0)]
        [TestCase(997, 8.7890625f, 120f, 2.6 * 0.01 / 2, 0.3535533906)]
        [TestCase(997, 1000f, 90f, 2.6 * 0.02 / 2, 0.5)]
        [TestCase(997, 8.7890625f, 60f, 2.6 * 0.01 / 2, 1.25)]
        [TestCase(997, 8.7890625f, 0f, 2.6 * 0.01 / 2, 2.0)]
        public void Displacements_with_surface_tension_are_those_of_the_reference(int count, float tension, float angle, double pair, double wall)
        {
            FluidMaterial material = FluidMaterial.Water;
            material.surfaceTension = tension;
            material.contactAngle = angle;
            material.artificialPressure = 0.1f;     // has no effect beside it, nor has the allowed tension
            material.allowedTension = 0.5f;
            SolverSettings settings = SolverStages.Roomy;
            settings.iterations = 2;
            settings.relaxation = 0.9f;
            using (var stages = Listed(ParticleState.Random(count, seed: count + 6), settings, material, iterations: 2))
            {
                // The second pass leaves the positions before and after it.
                float4[] before = stages.Multipliers, after = stages.Predicted;
                double3[] points = Compare.Points(before);
                double[] multipliers = before.Select(p => (double)p.w).ToArray();
                var reference = new Constraint(stages.Layout.DomainSize, points, stages.ListedNeighbors())
                {
                    relaxation = 0.9f,
                    pairAttraction = pair,
                    wallAttraction = pair * wall,
                };
                var sizes = new double[count];
                Compare.Vectors("corrected positions", count, i => after[i].xyz, i => reference.Corrected(i, multipliers, out sizes[i]),
                    i => 1e-5 + Rounding * sizes[i]);
            }
        }

        [Test]
        public void Particles_below_the_rest_density_stay_where_they_are()
        {
            ParticleState state = ParticleState.Lattice(20f, 4f, 6, jitter: 0f);
            for (int i = 0; i < state.Count; i++)
                state.positions[i] = new float4(4f + (state.positions[i].xyz - 4f) * 1.2f, 0f);
            using (var stages = Listed(state, SolverStages.Roomy).Constrain(iterations: 1))
            {
                float4[] before = stages.Multipliers, after = stages.Predicted;
                Assert.That(before.All(p => p.w == 0f), "multipliers");
                Compare.Vectors("positions", state.Count, i => after[i].xyz, i => before[i].xyz, i => 1e-12);
            }
        }

        [Test]
        public void Corrections_without_walls_move_the_center_of_mass_nowhere()
        {
            ParticleState state = ParticleState.Lattice(40f, 10f, 16, jitter: 0.3f);
            SolverSettings settings = SolverStages.Roomy;
            using (var stages = Listed(state, settings).Constrain(iterations: 1))
            {
                float4[] before = stages.Multipliers, after = stages.Predicted;
                double3 sum = 0.0;
                double size = 0.0;
                for (int i = 0; i < state.Count; i++)
                {
                    double3 moved = (double3)after[i].xyz - before[i].xyz;
                    sum += moved;
                    size += math.length(moved);
                }
                Assert.That(size, Is.GreaterThan(10.0));
                Assert.That(math.length(sum), Is.LessThan(1e-5 * size));
            }
        }

        [Test]
        public void A_correction_is_at_most_half_a_spacing_and_ends_inside_the_box()
        {
            ParticleState state = ParticleState.Random(4001, seed: 8);
            for (int i = 0; i < state.Count; i++)
                state.positions[i] = new float4(0.5f + (state.positions[i].xyz - 0.5f) * new float3(1f, 0.25f, 1f), 0f);
            SolverSettings settings = SolverStages.Roomy;
            settings.neighborCapacity = 256;
            settings.relaxation = 1f;
            using (var stages = Listed(state, settings).Constrain(iterations: 1))
            {
                float4[] before = stages.Multipliers, after = stages.Predicted;
                float[] moved = before.Zip(after, (a, b) => math.distance(a.xyz, b.xyz)).ToArray();
                Assert.That(moved.Max(), Is.LessThanOrEqualTo(0.5f + 1e-5f));
                Assert.That(moved.Count(length => length > 0.499f), Is.GreaterThan(100), "the cloud was not dense enough to clamp anything");
                Assert.That(after.All(p => math.all(p.xyz >= 0.5f) && math.all(p.xyz <= state.box - 0.5f)), "inside the box");
            }
        }

        [Test]
        public void A_coincident_pair_is_pushed_apart_in_opposite_directions()
        {
            ParticleState lattice = ParticleState.Lattice(16f, 4.25f, 8);
            int center = (4 * 8 + 4) * 8 + 4;
            var state = new ParticleState(16f, lattice.positions.Select(p => p.xyz).Append(lattice.positions[center].xyz).ToArray());
            using (var stages = Listed(state, SolverStages.Roomy).Constrain(iterations: 1))
            {
                uint[] ids = stages.SortedIds;
                int a = Array.IndexOf(ids, (uint)center), b = Array.IndexOf(ids, (uint)lattice.Count);
                float4[] before = stages.Multipliers, after = stages.Predicted;
                float3 first = after[a].xyz - before[a].xyz, second = after[b].xyz - before[b].xyz;
                Assert.That(before[a].w, Is.LessThan(0f), "the pair is not compressed");
                Assert.That(math.length(first), Is.GreaterThan(0.01f));
                Assert.That(math.length(first + second), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void Many_particles_in_one_point_come_apart_finite_and_inside()
        {
            ParticleState state = new ParticleState(12f, Enumerable.Repeat(new float3(6f, 6f, 6f), 1000).ToArray());
            using (var stages = Listed(state, SolverStages.Roomy).Constrain(iterations: 1))
            {
                float4[] after = stages.Predicted;
                Assert.That(after.All(p => math.all(math.isfinite(p)) && math.all(p.xyz >= 0.5f) && math.all(p.xyz <= 11.5f)));
                Assert.That(after.Select(p => p.xyz).Distinct().Count(), Is.GreaterThan(900));
            }
        }

        [Test]
        public void Neighbors_past_the_lists_capacity_are_counted_and_left_out()
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.neighborCapacity = 16;
            ParticleState state = ParticleState.Random(997, seed: 9);
            using (var stages = Listed(state, settings))
            {
                int[][] all = Neighbors.BruteForce(Compare.Points(stages.Multipliers), Kernels.H);
                int[][] lists = stages.ListedNeighbors();
                for (int i = 0; i < 997; i++)
                {
                    Assert.That(lists[i].Length, Is.EqualTo(Math.Min(all[i].Length, 16)), $"particle {i}");
                    Assert.That(lists[i].Except(all[i]), Is.Empty, $"particle {i}");
                    Assert.That(lists[i].Distinct().Count(), Is.EqualTo(lists[i].Length), $"particle {i}");
                }
                Assert.That(stages.Counter(ParticleCounter.Overflow), Is.EqualTo(all.Count(near => near.Length > 16)));
                Assert.That(stages.Counter(ParticleCounter.MaxNeighbors), Is.EqualTo(all.Max(near => near.Length)));
            }
        }

        [Test]
        public void Overflow_is_counted_again_every_step()
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.neighborCapacity = 16;
            using (var stages = Listed(ParticleState.Random(997, seed: 10), settings))
            {
                uint once = stages.Counter(ParticleCounter.Overflow);
                // The state is as after a step in which nothing moved.
                GpuTest.Run(cmd => stages.Search.RecordSort(stages.Context(cmd), takesProjection: false));
                stages.Constrain(iterations: 0);
                Assert.That(stages.Counter(ParticleCounter.Overflow), Is.EqualTo(once).And.GreaterThan(0u));
            }
        }

        [Test]
        public void A_lattice_particle_half_a_spacing_from_a_wall_sees_the_rest_density()
        {
            const int last = 11;
            FluidMaterial material = FluidMaterial.Water;
            material.allowedTension = 0.5f;         // so that negative errors show too
            using (var stages = Listed(ParticleState.Lattice(12f, 0.5f, 12), SolverStages.Roomy, material))
            {
                float4[] particles = stages.Multipliers;
                foreach (int3 cell in new[] { new int3(0, 5, 6), new int3(last, 5, 6), new int3(5, 0, 6), new int3(5, last, 6),
                    new int3(5, 6, 0), new int3(5, 6, last), new int3(5, 6, 5) })
                {
                    float4 particle = particles.Single(p => math.all(p.xyz == (float3)cell + 0.5f));
                    // The denominator is at most twice the lattice's.
                    double error = -particle.w * 2.0 * Kernels.RestSquares;
                    Assert.That(error, Is.EqualTo(0.0).Within(1e-4), $"C in cell {cell}");
                }
            }
        }

        [Test]
        public void Two_lists_give_the_result_of_one_bit_for_bit()
        {
            ParticleState state = ParticleState.Random(997, seed: 12);
            // 96 entries of 4 bytes each: two thirds of the particles fit the first buffer.
            using (var one = new SolverStages(state, SolverStages.Still()).Sort().Constrain(iterations: 3))
            using (var two = new SolverStages(state, SolverStages.Still(), maxBinding: 96 * 4 * 672).Sort().Constrain(iterations: 3))
            {
                Assert.That(one.Layout.TwoLists, Is.False);
                Assert.That(two.Layout.FirstListParticles, Is.EqualTo(672));
                Compare.Same("multipliers", two.Multipliers, one.Multipliers);
                Compare.Same("positions", two.Predicted, one.Predicted);
                Assert.That(two.ListedNeighbors(), Is.EqualTo(one.ListedNeighbors()));
            }
        }

        [Test]
        public void Without_particles_nothing_is_written()
        {
            using (var stages = new SolverStages(ParticleState.Random(0, seed: 13), SolverStages.Still()).Sort().Constrain(iterations: 2))
            {
                Assert.That(GpuTest.Read<float4>(stages.Particles.Predicted, stages.Layout.Capacity).All(GpuTest.IsGarbage));
                Assert.That(GpuTest.Read<float4>(stages.Particles.Positions, stages.Layout.Capacity).All(GpuTest.IsGarbage));
            }
        }

        [Test]
        public void Places_past_the_particles_are_left_alone()
        {
            using (var stages = new SolverStages(ParticleState.Random(200, seed: 14), SolverStages.Still(), capacity: 300).Sort()
                .Constrain(iterations: 2))
            {
                Assert.That(GpuTest.Read<float4>(stages.Particles.Predicted, 300).Skip(200).All(GpuTest.IsGarbage));
                Assert.That(GpuTest.Read<float4>(stages.Particles.Positions, 300).Skip(200).All(GpuTest.IsGarbage));
            }
        }

        static SolverStages Listed(ParticleState state, SolverSettings settings) => Listed(state, settings, FluidMaterial.Water);

        // Sorted, with lists and first multipliers.
        static SolverStages Listed(ParticleState state, SolverSettings settings, FluidMaterial material, int iterations = 0)
        {
            return new SolverStages(state, SolverStages.Still(settings, material)).Sort().Constrain(iterations);
        }

        static void AssertMultipliers(SolverStages stages, float4[] actual, Action<Constraint> adjust)
        {
            double3[] points = Compare.Points(actual);
            var reference = new Constraint(stages.Layout.DomainSize, points, Neighbors.ByCells(points, Kernels.H));
            adjust(reference);
            Compare.Scalars("multipliers", points.Length, i => actual[i].w, reference.Multiplier, i => reference.MultiplierTolerance(i, Rounding));
        }

        // From the multipliers that the device found.
        static void AssertDisplaced(SolverStages stages, Action<Constraint> adjust)
        {
            float4[] before = stages.Multipliers, after = stages.Predicted;
            double3[] points = Compare.Points(before);
            double[] multipliers = before.Select(p => (double)p.w).ToArray();
            var reference = new Constraint(stages.Layout.DomainSize, points, Neighbors.ByCells(points, Kernels.H));
            adjust(reference);
            var sizes = new double[points.Length];
            Compare.Vectors("corrected positions", points.Length, i => after[i].xyz, i => reference.Corrected(i, multipliers, out sizes[i]),
                i => 1e-5 + Rounding * sizes[i]);
        }
    }
}
