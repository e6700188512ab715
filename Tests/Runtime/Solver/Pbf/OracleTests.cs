using System;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The references that the device is judged by, and that the comparisons notice a fault.</summary>
    public class OracleTests
    {
        [Test]
        public void Both_kernels_integrate_to_one()
        {
            Assert.That(IntegrateOverBall(Kernels.Poly6), Is.EqualTo(1.0).Within(1e-6));
            Assert.That(IntegrateOverBall(Kernels.Spiky), Is.EqualTo(1.0).Within(1e-6));
        }

        [Test]
        public void The_spiky_gradient_is_the_slope_of_the_spiky_kernel()
        {
            var p = new double3(0.3, -0.7, 0.9);
            const double step = 1e-5;
            double3 slope = default;
            for (int axis = 0; axis < 3; axis++)
            {
                double3 shift = default;
                shift[axis] = step;
                slope[axis] = (Kernels.Spiky(math.length(p + shift)) - Kernels.Spiky(math.length(p - shift))) / (2.0 * step);
            }
            Assert.That(math.length(slope - Kernels.SpikyGradient(p)), Is.LessThan(1e-8));
        }

        [Test]
        public void The_package_takes_rest_density_and_scales_from_the_same_lattice()
        {
            Assert.That(LatticeKernels.RestDensity, Is.EqualTo(Kernels.RestDensity).Within(1e-12));
            Assert.That(LatticeKernels.ReferenceSquares, Is.EqualTo(Kernels.RestSquares).Within(1e-12));
            Assert.That(LatticeKernels.Poly6(0.7), Is.EqualTo(Kernels.Poly6(0.7)).Within(1e-12));
            Assert.That(LatticeKernels.SpikySlope(0.7), Is.EqualTo(Kernels.SpikyDerivative(0.7)).Within(1e-12));
        }

        [TestCase(0.0)]
        [TestCase(0.31)]
        [TestCase(0.5)]
        [TestCase(1.37)]
        [TestCase(2.0)]
        [TestCase(5.0)]
        public void The_closed_form_of_a_walls_density_is_what_the_quadrature_gives(double s)
        {
            Assert.That(LatticeKernels.WallScale * LatticeKernels.HalfSpaceDensity(s), Is.EqualTo(Walls.PlaneDensity(s)).Within(1e-5));
        }

        [Test]
        public void Neighbors_by_cells_are_those_of_brute_force()
        {
            double3[] points = Compare.Points(ParticleState.Random(997, seed: 1).positions);
            int[][] expected = Neighbors.BruteForce(points, 2.0), actual = Neighbors.ByCells(points, 2.0);
            for (int i = 0; i < points.Length; i++)
                Assert.That(actual[i].OrderBy(j => j), Is.EqualTo(expected[i].OrderBy(j => j)), $"point {i}");
        }

        [Test]
        public void Corrections_of_the_reference_conserve_momentum()
        {
            ParticleState state = ParticleState.Lattice(30f, 10f, 6, jitter: 0.3f);
            double3[] points = Compare.Points(state.positions);
            var reference = new Constraint(30.0, points, Neighbors.BruteForce(points, Kernels.H)) { maxCorrection = 1e9 };
            double[] multipliers = Enumerable.Range(0, points.Length).Select(reference.Multiplier).ToArray();
            double3 sum = Enumerable.Range(0, points.Length).Aggregate(new double3(0.0),
                (total, i) => total + reference.Correction(i, multipliers, out _));
            Assert.That(math.length(sum), Is.LessThan(1e-12 * points.Length));
        }

        [Test]
        public void A_missing_a_foreign_and_a_repeated_neighbor_are_noticed()
        {
            double3[] points = Compare.Points(ParticleState.Random(300, seed: 2).positions);
            Func<int[][]> lists = () => Neighbors.BruteForce(points, Kernels.H);
            Assert.DoesNotThrow(() => NeighborSets.AssertSame(lists(), points, Kernels.H));

            int busy = Array.FindIndex(lists(), near => near.Length > 5);
            AssertNoticed(() => NeighborSets.AssertSame(With(lists(), busy, near => near.Skip(1)), points, Kernels.H));
            int far = Enumerable.Range(0, 300).First(j => math.distance(points[j], points[busy]) > 3.0);
            AssertNoticed(() => NeighborSets.AssertSame(With(lists(), busy, near => near.Append(far)), points, Kernels.H));
            AssertNoticed(() => NeighborSets.AssertSame(With(lists(), busy, near => near.Append(near.First())), points, Kernels.H));
        }

        [Test]
        public void A_value_off_by_a_thousandth_or_not_a_number_is_noticed()
        {
            double[] expected = { 1.0, 2.0, 3.0 };
            Action<double> compare = last => Compare.Scalars("values", 3, i => i == 2 ? last : expected[i], i => expected[i], i => 1e-5);
            Assert.DoesNotThrow(() => compare(3.000001));
            AssertNoticed(() => compare(3.003));
            AssertNoticed(() => compare(double.NaN));
        }

        [Test]
        public void One_flipped_bit_is_noticed()
        {
            float4[] expected = ParticleState.Random(10, seed: 3).positions;
            var actual = (float4[])expected.Clone();
            actual[9].z = math.asfloat(math.asuint(actual[9].z) ^ 1u);
            AssertNoticed(() => Compare.Same("positions", actual, expected));
        }

        static void AssertNoticed(TestDelegate comparison) => Assert.That(comparison, Throws.InstanceOf<AssertionException>());

        static int[][] With(int[][] lists, int i, Func<int[], System.Collections.Generic.IEnumerable<int>> change)
        {
            lists[i] = change(lists[i]).ToArray();
            return lists;
        }

        static double IntegrateOverBall(Func<double, double> kernel)
        {
            const int shells = 20000;
            double width = Kernels.H / shells;
            return Enumerable.Range(0, shells).Select(i => (i + 0.5) * width).Sum(r => kernel(r) * 4.0 * Math.PI * r * r * width);
        }
    }
}
