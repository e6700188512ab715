using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill.Tests
{
    public class SolverLayoutTests
    {
        static readonly float3 Box = new float3(2f, 1f, 1f);

        [TestCase(0f)]
        [TestCase(-0.05f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void A_spacing_that_is_no_distance_is_refused(float spacing)
        {
            AssertRefused(() => Layout(Box, spacing, 1000), "Particle spacing", "above 0");
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(float.NegativeInfinity)]
        public void A_domain_that_is_not_finite_is_refused(float side)
        {
            AssertRefused(() => Layout(new float3(1f, side, 1f), 0.05f, 1000), "Domain size", "not finite");
        }

        [TestCase(0.09f)]
        [TestCase(0f)]
        [TestCase(-1f)]
        public void A_domain_thinner_than_the_support_radius_is_refused(float side)
        {
            AssertRefused(() => Layout(new float3(1f, 1f, side), 0.05f, 1000), "Domain size", "support radius, 0.1 m");
        }

        [TestCase(50000, 64)]
        [TestCase(4000, 96)]
        public void The_memory_of_a_solver_is_estimated(int capacity, int neighbors)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.neighborCapacity = neighbors;
            settings.deepWater = DeepWater.Off;
            using (var fluid = new TestFluid(new float3(2f, 2f, 1f), 0.05f, capacity, settings).AddBlock(0f, new float3(0.5f, 0.5f, 0.5f)).Step())
            {
                long taken = fluid.Solver.Describe(fluid.Input, 0).Sum(stage => stage.Bytes);
                TestContext.Out.WriteLine($"taken {taken:N0}, estimated {fluid.Solver.Layout.EstimatedBytes:N0} bytes");
                Assert.That(fluid.Solver.Layout.EstimatedBytes, Is.EqualTo(taken).Within(2).Percent);
            }
        }

        [Test]
        public void A_domain_as_thin_as_the_support_radius_is_laid_out()
        {
            Assert.That(Layout(new float3(1f, 1f, 0.125f), 0.0625f, 1000).CellCounts.z, Is.EqualTo(2));
        }

        [TestCase(1000f, 0.05f)]
        [TestCase(1f, 1e-5f)]
        [TestCase(1f, 1e-44f)]
        public void A_domain_beyond_single_precision_is_refused(float side, float spacing)
        {
            AssertRefused(() => Layout(new float3(side, 1f, 1f), spacing, 1000), "8,192 particle spacings");
        }

        [TestCase(0)]
        [TestCase(-1)]
        [TestCase(int.MinValue)]
        [TestCase(SolverLayout.MaxCapacity + 1)]
        public void A_capacity_out_of_range_is_refused(int capacity)
        {
            AssertRefused(() => Layout(Box, 0.05f, capacity), Invariant($"Capacity {capacity:N0}"), "1 to 16,777,216 particles");
        }

        [Test]
        public void More_than_two_list_buffers_are_refused_with_what_would_fit()
        {
            // A buffer of 3,584 bytes holds the lists of 32 particles with 25 entries in whole blocks: 28.
            AssertRefused(() => new SolverLayout(Box, 0.05f, 65, 25, 1f, maxBinding: 3584), "Capacity 65", "3,584 bytes", "Lower the capacity to 64");
        }

        [TestCase(1, 32, false)]
        [TestCase(32, 32, false)]
        [TestCase(33, 32, true)]
        [TestCase(64, 32, true)]
        public void Particles_beyond_one_list_buffer_go_to_a_second(int capacity, int maxInFirst, bool twoLists)
        {
            var layout = new SolverLayout(Box, 0.05f, capacity, 25, 1f, maxBinding: 3584);
            Assert.That(layout.TwoLists, Is.EqualTo(twoLists));
            Assert.That(layout.FirstListParticles, Is.EqualTo(Math.Min(capacity, maxInFirst)));
            Assert.That(layout.FirstListEntries * sizeof(uint), Is.LessThanOrEqualTo(3584));
            Assert.That(layout.SecondListEntries * sizeof(uint), Is.LessThanOrEqualTo(3584));
            Assert.That(layout.SecondListEntries > 0, Is.EqualTo(twoLists));
        }

        [Test]
        public void Cells_cover_the_domain_and_no_more()
        {
            SolverLayout layout = Layout(new float3(2.03f, 1f, 0.77f), 0.05f, 1000);
            float3 covered = (float3)layout.CellCounts * layout.CellSize;
            Assert.That(math.all(covered >= layout.DomainSize - 1e-4f));
            Assert.That(math.all(covered - layout.CellSize < layout.DomainSize));
            Assert.That(layout.CellTotal, Is.EqualTo(layout.CellCounts.x * layout.CellCounts.y * layout.CellCounts.z));
        }

        [Test]
        public void A_domain_with_too_many_fine_cells_gets_coarser_ones()
        {
            SolverLayout layout = Layout(new float3(450f, 450f, 450f), 1f, 1000);
            Assert.That(layout.CellSize, Is.EqualTo(new float3(2f)));
            Assert.That(layout.CellTotal, Is.EqualTo(225 * 225 * 225));
        }

        [Test]
        public void A_domain_with_too_many_cells_is_refused()
        {
            AssertRefused(() => Layout(new float3(8000f, 8000f, 8000f), 1f, 1000), "Domain size", "grid cells of 2 m", "raise the particle spacing");
        }

        static SolverLayout Layout(float3 box, float spacing, int capacity)
            => new SolverLayout(box, spacing, capacity, neighborCapacity: 96, listMargin: 1f);

        static void AssertRefused(TestDelegate make, params string[] texts)
        {
            string message = Assert.Throws<ArgumentException>(make).Message;
            foreach (string text in texts)
                Assert.That(message, Does.Contain(text));
        }
    }
}
