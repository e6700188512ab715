using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    public class VelocityUpdateTests
    {
        const double TimeStep = 1.0 / 60.0;

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Velocity_is_the_way_over_the_time_step(int count)
        {
            using (var stages = Updated(ParticleState.Random(count, seed: count, speed: 20f), smoothing: 0f, iterations: 1))
            {
                float4[] start = stages.Start, corrected = stages.Predicted, velocities = stages.Velocities;
                Compare.Vectors("velocities", count, i => velocities[i].xyz, i => ((double3)corrected[i].xyz - start[i].xyz) / TimeStep,
                    i => 1e-5 * (1.0 + math.length(velocities[i].xyz)));
                Assert.That(velocities.All(v => v.w == 1f), "density where none is summed");
            }
        }

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Viscosity_evens_velocities_out_as_the_reference_does(int count)
        {
            using (var stages = Updated(ParticleState.Random(count, seed: count + 1, speed: 20f), smoothing: 0.3f, iterations: 1, relaxation: 0f))
            {
                float4[] velocities = stages.Velocities;
                ListedAt(stages, out double3[] points, out int[][] neighbors);
                float4[] start = stages.Start;
                // Values that neighbors read are packed; a particle's own are not.
                double3[] seen = stages.Predicted.Select(p => Unpacked(p.w) / TimeStep).ToArray();
                var reference = new Velocities(points, seen, neighbors);
                Compare.Vectors("velocities", count, i => velocities[i].xyz,
                    i => (points[i] - start[i].xyz) / TimeStep + (reference.Smoothed(i, 0.3f) - seen[i]), i => 2e-4);
            }
        }

        [TestCase(1e-5f, 1e-4f)]
        [TestCase(1e-4f, 1e-2f)]
        [TestCase(0.1f, 1f)]
        [TestCase(1f, 100f)]
        public void Every_component_of_a_packed_way_is_off_by_a_256th_of_the_largest_one(float shortest, float longest)
        {
            var random = new Unity.Mathematics.Random(11u);
            ParticleState state = ParticleState.Lattice(300f, 120f, 12, jitter: 0.2f)
                .With(p => random.NextFloat3Direction() * math.exp(random.NextFloat(math.log(shortest), math.log(longest))) * 60f);
            using (var stages = Updated(state, smoothing: 0.01f, iterations: 1, relaxation: 0f))
            {
                float4[] start = stages.Start, corrected = stages.Predicted;
                double3[] displacements = corrected.Select((to, i) => (double3)(to.xyz - start[i].xyz)).ToArray();
                Compare.Vectors("packed displacements", displacements.Length, i => (float3)Unpacked(corrected[i].w), i => displacements[i],
                    i => math.sqrt(3.0) / 256.0 * math.cmax(math.abs(displacements[i])) + 1e-8);
                Assert.That(displacements.Count(path => math.length(path) > 0.0), Is.GreaterThan(100));
            }
        }

        [TestCase(1)]
        [TestCase(997)]
        [TestCase(100003)]
        public void The_density_comes_with_the_velocities(int count)
        {
            using (var stages = Updated(ParticleState.Random(count, seed: count + 2), smoothing: 0.01f, iterations: 1, relaxation: 0f))
            {
                ListedAt(stages, out double3[] points, out int[][] neighbors);
                var reference = new Constraint(stages.Layout.DomainSize, points, neighbors);
                float4[] velocities = stages.Velocities;
                Compare.Scalars("densities", count, i => velocities[i].w, reference.Density, i => 1e-5 * (1.0 + velocities[i].w));
            }
        }

        [Test]
        public void The_density_of_a_lone_particle_is_its_own_and_the_walls()
        {
            // Far apart, at all distances from faces, edges and corners.
            var random = new Unity.Mathematics.Random(5u);
            float3[] points = Enumerable.Range(0, 200)
                .Select(i => new float3(i % 2 == 0 ? 0.5f + 2f * random.NextFloat() : 5f, 3f + 5f * (i / 2), i % 3 == 0
                ? 0.5f + 2f * random.NextFloat() : 5f)).ToArray();
            using (var stages = Updated(new ParticleState(new float3(12f, 510f, 12f), points), smoothing: 0.01f, iterations: 1, relaxation: 0f))
            {
                float4[] velocities = stages.Velocities, positions = stages.Predicted;
                double own = Kernels.Poly6(0.0) / Kernels.RestDensity;
                Compare.Scalars("densities", points.Length, i => velocities[i].w,
                    i => own + Walls.Density(positions[i].xyz, stages.Layout.DomainSize) + Pair(positions, i), i => 2e-5);
            }

            double Pair(float4[] positions, int i)
            {
                return positions.Where((other, j) => j != i).Sum(other => Kernels.Poly6(math.distance(other.xyz, positions[i].xyz)))
                    / Kernels.RestDensity;
            }
        }

        [Test]
        public void Viscosity_conserves_momentum()
        {
            ParticleState state = ParticleState.Lattice(40f, 10f, 16, jitter: 0.2f).With(p => 10f * math.sin(p.zxy));
            using (var smooth = Updated(state, smoothing: 0.5f, iterations: 1, relaxation: 0f))
            using (var plain = Updated(state, smoothing: 0f, iterations: 1, relaxation: 0f))
            {
                double3 expected = plain.Velocities.Aggregate(new double3(0.0), (sum, v) => sum + (double3)v.xyz);
                double3 actual = smooth.Velocities.Aggregate(new double3(0.0), (sum, v) => sum + (double3)v.xyz);
                double size = plain.Velocities.Sum(v => (double)math.length(v.xyz));
                Assert.That(math.length(actual - expected), Is.LessThan(1e-6 * size));
            }
        }

        [Test]
        public void Fluid_that_moves_as_one_is_not_smoothed()
        {
            ParticleState state = ParticleState.Lattice(40f, 10f, 10, jitter: 0.2f).With(p => new float3(3f, -5f, 7f));
            using (var smooth = Updated(state, smoothing: 1f, iterations: 1, relaxation: 0f))
            using (var plain = Updated(state, smoothing: 0f, iterations: 1, relaxation: 0f))
            {
                float4[] expected = plain.Velocities, actual = smooth.Velocities;
                Compare.Vectors("velocities", state.Count, i => actual[i].xyz, i => expected[i].xyz, i => 2e-4);
            }
        }

        [Test]
        public void The_particles_of_the_step_become_those_alive()
        {
            ParticleState state = ParticleState.Random(300, seed: 6);
            state.positions[17].x = float.NaN;
            using (var stages = Updated(state, smoothing: 0.01f, iterations: 1))
            {
                Assert.That(stages.Counter(ParticleCounter.Alive), Is.EqualTo(299));
                Assert.That(GpuTest.Read<uint>(stages.Particles.AliveArguments, ParticleState.ArgumentCount),
                    Is.EqualTo(ParticleState.ArgumentsFor(299)));
            }
        }

        [TestCase(0f)]
        [TestCase(0.5f)]
        public void Without_particles_only_the_counters_are_written(float smoothing)
        {
            using (var stages = Updated(ParticleState.Random(0, seed: 7), smoothing, iterations: 1))
            {
                Assert.That(stages.Counter(ParticleCounter.Alive), Is.Zero);
                Assert.That(GpuTest.Read<uint>(stages.Particles.AliveArguments, ParticleState.ArgumentCount),
                    Is.EqualTo(ParticleState.ArgumentsFor(0)));
                Assert.That(GpuTest.Read<float4>(stages.Particles.Velocities, stages.Layout.Capacity).All(GpuTest.IsGarbage));
            }
        }

        [Test]
        public void A_whole_substep_does_not_depend_on_the_order_of_the_input()
        {
            ParticleState state = ParticleState.Random(997, seed: 9, speed: 10f);
            using (var stages = Updated(state, smoothing: 0.1f, iterations: 3))
            using (var shuffled = Updated(state.Shuffled(seed: 10), smoothing: 0.1f, iterations: 3))
            {
                Compare.Same("ids", shuffled.SortedIds, stages.SortedIds);
                Compare.Same("positions", shuffled.Predicted, stages.Predicted);
                Compare.Same("velocities", shuffled.Velocities, stages.Velocities);
            }
        }

        [Test]
        public void Two_lists_give_the_result_of_one_bit_for_bit()
        {
            ParticleState state = ParticleState.Random(997, seed: 8, speed: 10f);
            FluidMaterial material = FluidMaterial.Water;
            material.velocitySmoothing = 0.5f;
            StepInput input = SolverStages.Still(SolverStages.Roomy, material);
            using (var one = new SolverStages(state, input).Sort().Constrain(2).UpdateVelocities())
            using (var two = new SolverStages(state, input, maxBinding: 96 * 4 * 512).Sort().Constrain(2).UpdateVelocities())
            {
                Assert.That(two.Layout.TwoLists);
                Compare.Same("velocities", two.Velocities, one.Velocities);
            }
        }

        static SolverStages Updated(ParticleState state, float smoothing, int iterations, float relaxation = 0.8f)
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.relaxation = relaxation;
            FluidMaterial material = FluidMaterial.Water;
            material.velocitySmoothing = smoothing;
            return new SolverStages(state, SolverStages.Still(settings, material)).Sort().Constrain(iterations).UpdateVelocities();
        }

        // Unpacks like PackedVector.hlsl: 5 bits of exponent, three mantissas of 9.
        static double3 Unpacked(float packed)
        {
            uint bits = math.asuint(packed);
            int3 mantissas = new int3((int)(bits << 5), (int)(bits << 14), (int)(bits << 23)) >> 23;
            return (double3)mantissas * System.Math.Pow(2.0, (int)(bits >> 27) - 24 - 8);
        }

        // Positions that no correction moved, so that the lists are theirs.
        static void ListedAt(SolverStages stages, out double3[] points, out int[][] neighbors)
        {
            points = Compare.Points(stages.Predicted);
            neighbors = Neighbors.ByCells(points, Kernels.H);
        }
    }
}
