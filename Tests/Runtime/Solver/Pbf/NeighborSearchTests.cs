using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    public class NeighborSearchTests
    {
        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Cell_starts_count_the_particles_of_all_cells_before(int count)
        {
            ParticleState state = ParticleState.Random(count, seed: count);
            using (var stages = new SolverStages(state, SolverStages.Still()).Sort())
            {
                uint[] expected = CountingSort.Starts(Cells(state, stages.Layout), stages.Layout.CellTotal);
                Compare.Same("cell starts", CellStarts(stages), expected);
            }
        }

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Particles_are_sorted_by_cell_and_by_id_within_it(int count)
        {
            ParticleState state = ParticleState.Random(count, seed: count + 1).Shuffled(seed: 2);
            using (var stages = new SolverStages(state, SolverStages.Still()).Sort())
            {
                int[] order = CountingSort.Order(Cells(state, stages.Layout), state.ids);
                Compare.Same("ids", stages.SortedIds, order.Select(i => state.ids[i]).ToArray());
                Compare.Same("positions", stages.Start, order.Select(i => state.positions[i]).ToArray());
                Assert.That(stages.Sorted, Is.EqualTo(count));
            }
        }

        [Test]
        public void The_order_of_the_input_does_not_matter()
        {
            ParticleState state = ParticleState.Random(5003, seed: 3, speed: 20f);
            using (var stages = new SolverStages(state, SolverStages.Still()).Sort())
            using (var shuffled = new SolverStages(state.Shuffled(seed: 4), SolverStages.Still()).Sort())
            {
                Compare.Same("ids", shuffled.SortedIds, stages.SortedIds);
                Compare.Same("start", shuffled.Start, stages.Start);
                Compare.Same("predicted", shuffled.Predicted, stages.Predicted);
            }
        }

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Predicted_positions_follow_velocity_and_gravity(int count)
        {
            ParticleState state = ParticleState.Random(count, seed: count + 3, speed: 30f);
            StepInput input = SolverStages.Still();
            input.gravity = new float3(1f, -9.81f, 3f);
            double dt = 1.0 / 60.0;
            using (var stages = new SolverStages(state, input).Sort())
            {
                uint[] ids = stages.SortedIds;
                float4[] predicted = stages.Predicted;
                double3 fall = new double3(1.0, -9.81, 3.0) / SolverStages.Spacing * dt * dt;
                double3 contactOffset = new double3(0.5), far = (double3)state.box - 0.5;
                Compare.Vectors("predicted", count, slot => predicted[slot].xyz,
                    slot => math.clamp((double3)state.positions[ids[slot]].xyz + (double3)state.velocities[ids[slot]].xyz * dt + fall,
                        contactOffset, far), slot => 1e-5);
            }
        }

        [Test]
        public void A_sorted_particle_lies_in_its_cell()
        {
            ParticleState state = ParticleState.Random(5003, seed: 5, speed: 30f);
            using (var stages = new SolverStages(state, SolverStages.Still()).Sort())
            {
                uint[] starts = CellStarts(stages);
                float4[] predicted = stages.Predicted;
                int3 counts = stages.Layout.CellCounts;
                float3 size = stages.Layout.CellSize;
                for (int cell = 0; cell < stages.Layout.CellTotal; cell++)
                {
                    float3 low = new float3(cell % counts.x, cell / counts.x % counts.y, cell / (counts.x * counts.y)) * size;
                    for (uint slot = starts[cell]; slot < starts[cell + 1]; slot++)
                    {
                        float3 p = predicted[slot].xyz;
                        if (math.any(p < low - 1e-4f) || math.any(p > low + size + 1e-4f))
                            Assert.Fail($"particle {slot} at {p} is in cell {cell}, which begins at {low}");
                    }
                }
            }
        }

        [Test]
        public void Particles_outside_are_brought_into_the_box()
        {
            var box = new float3(8f, 6f, 7f);
            var positions = new[] { new float3(-100f, 3f, 3f), new float3(4f, 1e30f, 3f), new float3(4f, 3f, 7.2f),
                new float3(0.1f, 5.9f, 0.49f), new float3(4f, 3f, 3f) };
            using (var stages = new SolverStages(new ParticleState(box, positions), SolverStages.Still()).Sort())
            {
                uint[] ids = stages.SortedIds;
                float4[] predicted = stages.Predicted;
                Assert.That(ids.OrderBy(id => id), Is.EqualTo(new uint[] { 0, 1, 2, 3, 4 }));
                for (int slot = 0; slot < positions.Length; slot++)
                    Assert.That(predicted[slot].xyz, Is.EqualTo(math.clamp(positions[ids[slot]], 0.5f, box - 0.5f)), $"particle {ids[slot]}");
                Assert.That(stages.Counter(ParticleCounter.NonFinite), Is.Zero);
            }
        }

        static readonly float[] NotFinite = { float.NaN, float.PositiveInfinity, float.NegativeInfinity };

        [Test]
        public void A_particle_that_is_not_finite_is_culled_and_counted([ValueSource(nameof(NotFinite))] float bad,
            [Values(0, 1, 2)] int axis, [Values(false, true)] bool inVelocity)
        {
            ParticleState state = ParticleState.Random(300, seed: 6);
            (inVelocity ? state.velocities : state.positions)[7][axis] = bad;
            (inVelocity ? state.velocities : state.positions)[256][axis] = bad;
            using (var stages = new SolverStages(state, SolverStages.Still()).Sort())
            {
                Assert.That(stages.Sorted, Is.EqualTo(298));
                Assert.That(stages.Counter(ParticleCounter.NonFinite), Is.EqualTo(2));
                Compare.Same("ids that are left", stages.SortedIds.OrderBy(id => id).ToArray(),
                    state.ids.Where(id => id != 7 && id != 256).ToArray());
                Assert.That(stages.Predicted.All(p => math.all(math.isfinite(p))));
            }
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(128)]
        [TestCase(129)]
        [TestCase(100003)]
        public void Arguments_for_the_sorted_particles_are_written(int count)
        {
            using (var stages = new SolverStages(ParticleState.Random(count, seed: 7), SolverStages.Still()).Sort())
                Assert.That(GpuTest.Read<uint>(stages.Particles.SortedArguments, ParticleState.ArgumentCount),
                    Is.EqualTo(ParticleState.ArgumentsFor(count)));
        }

        [Test]
        public void Without_particles_every_cell_is_empty_and_nothing_is_written()
        {
            using (var stages = new SolverStages(ParticleState.Random(0, seed: 8), SolverStages.Still()).Sort())
            {
                Assert.That(stages.Sorted, Is.Zero);
                Assert.That(CellStarts(stages), Is.All.Zero);
                Assert.That(GpuTest.Read<float4>(stages.Particles.Predicted, stages.Layout.Capacity).All(GpuTest.IsGarbage));
            }
        }

        [Test]
        public void Places_past_the_sorted_particles_are_left_alone()
        {
            using (var stages = new SolverStages(ParticleState.Random(200, seed: 9), SolverStages.Still(), capacity: 300).Sort())
            {
                Assert.That(GpuTest.Read<float4>(stages.Particles.Predicted, 300).Skip(200).All(GpuTest.IsGarbage));
                Assert.That(GpuTest.Read<uint>(stages.Particles.SortedIds, 300).Skip(200).All(GpuTest.IsGarbage));
            }
        }

        [Test]
        public void A_very_full_cell_keeps_all_its_particles_in_order()
        {
            var random = new Unity.Mathematics.Random(10u);
            float3[] positions = Enumerable.Range(0, 1500).Select(_ => random.NextFloat3(2.05f, 2.6f)).ToArray();
            using (var stages = new SolverStages(new ParticleState(8f, positions), SolverStages.Still()).Sort())
            {
                Assert.That(Cells(new ParticleState(8f, positions), stages.Layout).Distinct().Count(), Is.EqualTo(1));
                Compare.Same("ids", stages.SortedIds, Enumerable.Range(0, 1500).Select(i => (uint)i).ToArray());
            }
        }

        [Test]
        public void Sorting_twice_gives_the_same_cells()
        {
            ParticleState state = ParticleState.Random(997, seed: 11);
            using (var stages = new SolverStages(state, SolverStages.Still()).Sort())
            {
                uint[] once = CellStarts(stages);
                stages.Sort();
                Compare.Same("cell starts", CellStarts(stages), once);
            }
        }

        [Test]
        public void Order_at_rest_lists_every_particle_by_cell_and_moves_none()
        {
            ParticleState state = ParticleState.Random(997, seed: 12, speed: 50f);
            using (var stages = new SolverStages(state, SolverStages.Still()))
            {
                GpuTest.Run(cmd => stages.Search.RecordOrderAtRest(stages.Context(cmd)));

                int[] cells = Cells(state, stages.Layout);
                uint2[] order = GpuTest.Read<uint2>(stages.Search.CellOrder, 997);
                Compare.Same("cells in order", order.Select(o => (uint)cells[o.x]).ToArray(),
                    cells.OrderBy(cell => cell).Select(cell => (uint)cell).ToArray());
                Compare.Same("every particle once", order.Select(o => o.x).OrderBy(i => i).ToArray(), state.ids);
                Compare.Same("positions", GpuTest.Read<float4>(stages.Particles.Positions, 997), state.positions);
                Assert.That(GpuTest.Read<float4>(stages.Particles.Predicted, 997).All(GpuTest.IsGarbage));
            }
        }

        [Test]
        public void Order_at_rest_counts_no_particle_as_culled_again()
        {
            ParticleState state = ParticleState.Random(300, seed: 13);
            state.positions[5].y = float.NaN;
            using (var stages = new SolverStages(state, SolverStages.Still()))
            {
                GpuTest.Run(cmd => stages.Search.RecordOrderAtRest(stages.Context(cmd)));
                Assert.That(stages.Sorted, Is.EqualTo(299));
                Assert.That(stages.Counter(ParticleCounter.NonFinite), Is.Zero);
            }
        }

        static uint[] CellStarts(SolverStages stages) => GpuTest.Read<uint>(stages.Search.CellStarts, stages.Layout.CellTotal + 1);

        // Cells of particles that do not move.
        static int[] Cells(ParticleState state, SolverLayout layout)
        {
            return state.positions.Select(p => CountingSort.Cell(p.xyz, 1f / layout.CellSize, layout.CellCounts)).ToArray();
        }
    }
}
