using System;
using System.Collections.Generic;
using System.Linq;
using Host.Studies.Methods;
using NUnit.Framework;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Random = Unity.Mathematics.Random;

namespace Host.Tests
{
    /// <summary>The methods that the report compares: each against what it has to be where it can do nothing else, or against a slow twin.</summary>
    public class MethodStudyTests : GraphicsFixture
    {
        const float Spacing = 0.0625f;
        static readonly float3 Box = 12f;       // d

        [TestCase(false)]
        [TestCase(true)]
        public void Every_point_of_every_curve_has_a_place_of_its_own_and_words_that_a_table_takes(bool quick)
        {
            MethodStudy[] studies = MethodStudies.All(quick).ToArray();
            Assert.That(studies.Select(study => study.Name), Is.Unique);
            foreach (MethodStudy study in studies)
            {
                Assert.That(study.Variants.Select(variant => (variant.Series, variant.Value)), Is.Unique, study.Name);
                foreach (MethodVariant variant in study.Variants)
                {
                    Assert.That((study.Name + variant.Label).Contains(','), Is.False, variant.ToString());
                    Assert.That(variant.Iterations * variant.Substeps, Is.InRange(1, 16), variant.ToString());
                    Assert.That(variant.Value, Is.GreaterThan(0).Or.EqualTo(study.Logarithmic ? 1 : 0), variant.ToString());
                }
            }
        }

        [TestCase(DeepWater.Off, 1, 3)]
        [TestCase(DeepWater.Off, 2, 1)]
        [TestCase(DeepWater.On, 1, 2)]
        [TestCase(DeepWater.On, 2, 2)]
        public void With_the_package_s_passes_the_study_s_solver_is_the_package_s_bit_for_bit(DeepWater deep, int substeps, int iterations)
        {
            StepInput input = Input(deep, substeps, iterations);
            float4[] positions = Block();
            float4[] studied = Play(input, new Jacobi(), positions, steps: 4);
            Assert.That(Different(studied, PlayPackage(input, positions, steps: 4)), Is.Zero);
            Assert.That(Different(studied, positions), Is.GreaterThan(500));
        }

        [TestCase(DeepWater.Off)]
        [TestCase(DeepWater.On)]
        public void Passes_one_by_one_are_the_package_s_passes(DeepWater deep)
        {
            StepInput input = Input(deep, 1, 4);
            AssertSame(input, new ScheduledJacobi(input.settings.relaxation), new Jacobi());
        }

        [Test]
        public void A_schedule_of_other_relaxations_is_another_method()
        {
            StepInput input = Input(DeepWater.Off, 1, 4);
            AssertOther(input, new ScheduledJacobi(ScheduledJacobi.Optimal(4, 0.1, 1.6)), new Jacobi());
        }

        [Test]
        public void Schedules_have_the_relaxation_of_each_eigenvalue_between_the_bounds_and_big_ones_do_not_follow_each_other()
        {
            float[] schedule = ScheduledJacobi.Optimal(8, 0.1, 1.6);
            Assert.That(schedule.Min(), Is.InRange(1 / 1.6, 1 / 1.5));
            Assert.That(schedule.Max(), Is.InRange(1 / 0.15, 1 / 0.1));
            for (int i = 1; i < schedule.Length; i++)
                Assert.That(Math.Min(schedule[i], schedule[i - 1]), Is.LessThan(2 / 1.7), $"passes {i - 1} and {i}");
            Assert.That(ScheduledJacobi.Optimal(1, 0.5, 1.5)[0], Is.EqualTo(1f).Within(1e-6));
        }

        [TestCase(1)]
        [TestCase(2)]
        public void Chebyshev_of_radius_0_is_Jacobi(int start)
        {
            AssertSame(Input(DeepWater.Off, 1, 5), new ChebyshevJacobi(0, start), new Jacobi());
        }

        [Test]
        public void Chebyshev_is_Jacobi_up_to_its_start_and_not_after()
        {
            AssertSame(Input(DeepWater.Off, 1, 3), new ChebyshevJacobi(0.9, 3), new Jacobi());
            AssertOther(Input(DeepWater.Off, 1, 4), new ChebyshevJacobi(0.9, 3), new Jacobi());
        }

        [Test]
        public void Chebyshev_s_weights_rise_to_the_limit_of_their_radius()
        {
            var method = new ChebyshevJacobi(0.9, 2);
            Assert.That(method.Weight(1), Is.EqualTo(1));
            Assert.That(method.Weight(2), Is.EqualTo(2 / (2 - 0.81)).Within(1e-12));
            Assert.That(method.Weight(3), Is.EqualTo(4 / (4 - 0.81 * method.Weight(2))).Within(1e-12));
            Assert.That(method.Weight(60), Is.EqualTo(2 / (1 + Math.Sqrt(1 - 0.81))).Within(1e-9));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Nesterov_s_first_passes_are_Jacobi_s_and_the_third_is_not(bool restart)
        {
            AssertSame(Input(DeepWater.Off, 1, 1), new NesterovJacobi(restart), new Jacobi());
            AssertSame(Input(DeepWater.Off, 1, 2), new NesterovJacobi(restart), new Jacobi());
            AssertOther(Input(DeepWater.Off, 1, 3), new NesterovJacobi(restart), new Jacobi());
        }

        [Test]
        public void A_restart_takes_motion_from_particles_that_turn_around()
        {
            AssertOther(Input(DeepWater.Off, 1, 6), new NesterovJacobi(true), new NesterovJacobi(false));
        }

        [TestCase(0.4f)]
        [TestCase(1f)]
        public void The_neighbors_mean_is_approached_by_its_fraction(float fraction)
        {
            StepInput input = Still(relaxation: 0f);        // the passes themselves move nothing
            float4[] positions = Cloud(200);
            float4[] moved = Play(input, new NeighborMean(fraction), positions, steps: 1);
            for (int i = 0; i < positions.Length; i++)
            {
                float3[] neighbors = positions.Where((p, j) => j != i && math.distance(p.xyz, positions[i].xyz) < 2f).Select(p => p.xyz).ToArray();
                float3 mean = neighbors.Length > 0 ? neighbors.Aggregate((a, b) => a + b) / neighbors.Length : positions[i].xyz;
                float3 expected = positions[i].xyz + fraction * (mean - positions[i].xyz);
                Assert.That(math.distance(moved[i].xyz, expected), Is.LessThan(1e-4f), $"particle {i} of {neighbors.Length} neighbors");
            }
        }

        [TestCase(false, 2)]
        [TestCase(true, 3)]
        public void Gauss_Seidel_does_what_one_thread_would_do_color_by_color(bool byConstraint, int stride)
        {
            AssertCloud(new GaussSeidel(byConstraint), 1, (constraint, p) => constraint.Sweep(p, byConstraint, stride));
        }

        [Test]
        public void Chebyshev_follows_its_recurrence()
        {
            const double radius = 0.9;
            AssertCloud(new ChebyshevJacobi(radius, 2), 5, (constraint, start) =>
            {
                float3[] before = start, now = start;
                double weight = 1;
                for (int k = 0; k < 5; k++)
                {
                    weight = k < 2 ? 1 : k == 2 ? 2 / (2 - radius * radius) : 4 / (4 - radius * radius * weight);
                    float3[] last = before;
                    float3[] next = constraint.Jacobi(now).Select((hat, i) => (float)weight * (hat - last[i]) + last[i]).ToArray();
                    (before, now) = (now, next);
                }
                return now;
            });
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Nesterov_follows_its_recurrence(bool restart)
        {
            AssertCloud(new NesterovJacobi(restart), 5, (constraint, start) =>
            {
                float3[] x = start, y = start;
                double t = 1;
                for (int k = 0; k < 5; k++)
                {
                    double following = (1 + Math.Sqrt(1 + 4 * t * t)) / 2;
                    float3[] from = y, last = x, made = constraint.Jacobi(y);
                    y = made.Select((p, i) => restart && math.dot(from[i] - p, p - last[i]) > 0f ? p
                        : p + (float)((t - 1) / following) * (p - last[i])).ToArray();
                    (x, t) = (made, following);
                }
                return x;
            });
        }

        [TestCase(2, 1)]
        [TestCase(3, 2)]
        public void Particles_that_two_threads_of_a_dispatch_move_are_so_many_radii_apart(int stride, int radii)
        {
            float4[] positions = Cloud(600);
            SolverLayout layout = Layout(Still(1f));
            int pairs = 0;
            for (int i = 0; i < positions.Length; i++)
                for (int j = 0; j < i; j++)
                {
                    int3 a = SerialConstraint.Block(positions[i].xyz, layout), b = SerialConstraint.Block(positions[j].xyz, layout);
                    if (math.all(a == b) || !math.all(a % stride == b % stride))
                        continue;
                    pairs++;
                    Assert.That(math.distance(positions[i].xyz, positions[j].xyz), Is.GreaterThanOrEqualTo(radii * layout.ListRadius - 1e-4f));
                }
            Assert.That(pairs, Is.GreaterThan(500));
        }

        [Test]
        public void A_cold_start_other_cells_and_no_screening_are_other_solutions()
        {
            StepInput input = Input(DeepWater.On, 1, 2);
            float4[] positions = Pool(), package = Play(input, new Jacobi(), positions, 4);
            foreach (CoarseVariation variation in new[] { new CoarseVariation { WarmStart = false }, new CoarseVariation { CellSize = 3f },
                new CoarseVariation { ScreeningLength = 5f }, new CoarseVariation { SurfaceDistance = false },
                new CoarseVariation { Cycles = 3 } })
                Assert.That(Different(Play(input, new Jacobi(), positions, 4, variation), package), Is.GreaterThan(500), variation.ToString());
        }

        [Test]
        public void What_follows_the_passes_is_the_package_s_whatever_the_method()
        {
            StepInput input = Input(DeepWater.Off, 1, 3);
            input.settings.relaxation = 0f;         // no method moves anything, and the viscosity has what it needs
            input.material.velocitySmoothing = 0.5f;
            float4[] package = Play(input, new Jacobi(), Block(), 3);
            foreach (ConstraintMethod method in new ConstraintMethod[] { new ScheduledJacobi(0f), new ChebyshevJacobi(0.9, 1),
                new NesterovJacobi(true), new NeighborMean(0f), new GaussSeidel(false), new GaussSeidel(true) })
                Assert.That(Different(Play(input, method, Block(), 3), package), Is.Zero, method.GetType().Name);
        }

        static void AssertSame(in StepInput input, ConstraintMethod one, ConstraintMethod other)
            => Assert.That(Different(Play(input, one, Block(), 3), Play(input, other, Block(), 3)), Is.Zero);

        static void AssertOther(in StepInput input, ConstraintMethod one, ConstraintMethod other)
            => Assert.That(Different(Play(input, one, Block(), 3), Play(input, other, Block(), 3)), Is.GreaterThan(100));

        // Particles that are not bit for bit at the same place.
        static int Different(float4[] one, float4[] other)
            => one.Zip(other, (a, b) => math.any(math.asuint(a) != math.asuint(b))).Count(different => different);

        static StepInput Input(DeepWater deep, int substeps, int iterations) =>
            new MethodVariant { TwoLevel = deep == DeepWater.On, Substeps = substeps, Iterations = iterations }.Input();

        // A cloud after one step, against what a serial twin makes of it.
        static void AssertCloud(ConstraintMethod method, int iterations, Func<SerialConstraint, float3[], float3[]> twin)
        {
            StepInput input = Still(relaxation: 0.9f, iterations);
            float3[] start = Cloud(300).Select(p => p.xyz).ToArray();
            float4[] moved = Play(input, method, Cloud(300), steps: 1);
            float3[] expected = twin(new SerialConstraint(start, Layout(input), input), start);
            for (int i = 0; i < start.Length; i++)
                Assert.That(math.distance(moved[i].xyz, expected[i]), Is.LessThan(2e-3f), $"particle {i}");
            Assert.That(start.Zip(expected, (a, b) => math.distance(a, b)).Max(), Is.GreaterThan(0.1f), "nothing moved");
        }

        // Without gravity or viscosity: positions are what the passes made of them.
        static StepInput Still(float relaxation, int iterations = 1)
        {
            StepInput input = new MethodVariant { Iterations = iterations, Relaxation = relaxation, Smoothing = 0f, NeighborCapacity = 256 }.Input();
            input.gravity = 0f;
            return input;
        }

        // A block of water that is a little too dense, so that all passes have to move it.
        static float4[] Block()
        {
            var random = new Random(5);
            return Enumerable.Range(0, 512).Select(i => new float4(new float3(i % 8, i / 8 % 8, i / 64) * 0.95f + 0.5f
                + random.NextFloat3(-0.02f, 0.02f), 0f)).ToArray();
        }

        // Still water that fills the floor.
        static float4[] Pool()
        {
            var random = new Random(5);
            return Enumerable.Range(0, 1008).Select(i => new float4(new float3(i % 12, i / 144, i / 12 % 12) + 0.5f
                + random.NextFloat3(-0.02f, 0.02f), 0f)).ToArray();
        }

        // Away from the walls, dense in places, and none so near another that the package pushes it apart by other rules.
        static float4[] Cloud(int count)
        {
            var random = new Random(9);
            var cloud = new List<float4>();
            while (cloud.Count < count)
            {
                var place = new float4(random.NextFloat3(2.6f, 9.4f), 0f);
                if (cloud.All(other => math.distance(other.xyz, place.xyz) > 0.5f))
                    cloud.Add(place);
            }
            return cloud.ToArray();
        }

        static SolverLayout Layout(in StepInput input)
            => new SolverLayout(Box * Spacing, Spacing, 1024, input.settings.neighborCapacity, input.settings.listMargin);

        static float4[] Play(in StepInput input, ConstraintMethod method, float4[] positions, int steps, CoarseVariation variation = null)
            => Play(new StudySolver(Layout(input), method, variation), input, positions, steps);

        static float4[] PlayPackage(in StepInput input, float4[] positions, int steps) => Play(new PbfSolver(Layout(input)), input, positions, steps);

        /// <returns>By the particles' numbers, d.</returns>
        static float4[] Play(PbfSolver solver, in StepInput input, float4[] positions, int steps)
        {
            using (solver)
            {
                Fill(positions, input.gravity.y != 0f ? 3f : 0f, solver.Add);
                using var cmd = new CommandBuffer();
                for (int step = 0; step < steps; step++)
                {
                    cmd.Clear();
                    solver.Step(cmd, input);
                    Graphics.ExecuteCommandBuffer(cmd);
                }
                return ByNumber(solver.Positions, solver.ParticleIds, positions.Length);
            }
        }

        /// <param name="speed">d/s, of particles that move in all directions.</param>
        static void Fill(float4[] positions, float speed, Action<NativeArray<float4>, NativeArray<float4>> add)
        {
            using var meters = new NativeArray<float4>(positions.Select(p => p * Spacing).ToArray(), Allocator.Persistent);
            using var velocities = new NativeArray<float4>(positions.Select(p => speed * Spacing * math.sin(p.zxyw)).ToArray(), Allocator.Persistent);
            add(meters, velocities);
        }

        static float4[] ByNumber(GraphicsBuffer positions, GraphicsBuffer numbers, int count)
        {
            var places = new float4[count];
            var ids = new uint[count];
            positions.GetData(places, 0, 0, count);
            numbers.GetData(ids, 0, 0, count);
            return ids.Zip(places, (id, place) => (id, place)).OrderBy(pair => pair.id).Select(pair => new float4(pair.place.xyz, 0f)).ToArray();
        }
    }
}
