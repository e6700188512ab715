using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill.Tests
{
    public class PrefixSumTests
    {
        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(PrefixSum.Tile - 1)]
        [TestCase(PrefixSum.Tile)]
        [TestCase(PrefixSum.Tile + 1)]
        [TestCase(100003)]
        [TestCase(PrefixSum.Tile * PrefixSum.Tile)]         // the most tiles whose sums every group adds up
        [TestCase(PrefixSum.Tile * PrefixSum.Tile + 1)]    // the scan of the tile sums takes a second turn
        public void Every_element_gets_the_sum_of_those_before_it(int count)
        {
            uint[] counts = RandomCounts(count, seed: count);
            uint[] expected = new uint[count];
            for (int i = 1; i < count; i++)
                expected[i] = expected[i - 1] + counts[i - 1];

            Compare.Same($"sums of {count}", Scan(counts, count).sums, expected);
        }

        [TestCase(1)]
        [TestCase(PrefixSum.Tile + 1)]
        [TestCase(100003)]
        public void Counts_are_cleared_for_the_next_histogram(int count)
        {
            uint[] left = Scan(RandomCounts(count, seed: count), count).counts;
            Compare.Same($"counts of {count}", left, new uint[count]);
        }

        [Test]
        public void Elements_past_the_count_are_left_alone()
        {
            uint[] counts = RandomCounts(3000, seed: 1);
            (uint[] sums, uint[] left) = Scan(counts, count: 1500);
            Compare.Same("sums", sums.Skip(1500).ToArray(), Enumerable.Repeat(GpuTest.Garbage, 1500).ToArray());
            Compare.Same("counts", left.Skip(1500).ToArray(), counts.Skip(1500).ToArray());
        }

        [Test]
        public void No_elements_record_nothing()
        {
            uint[] counts = RandomCounts(10, seed: 2);
            (uint[] sums, uint[] left) = Scan(counts, count: 0);
            Assert.That(sums, Is.All.EqualTo(GpuTest.Garbage));
            Assert.That(left, Is.EqualTo(counts));
        }

        [Test]
        public void Sums_wrap_at_two_to_the_32()
        {
            uint[] sums = Scan(new[] { 0xFFFFFFFFu, 2u, 0u }, count: 3).sums;
            Assert.That(sums, Is.EqualTo(new[] { 0u, 0xFFFFFFFFu, 1u }));
        }

        [Test]
        public void A_smaller_scan_after_a_larger_one_sees_nothing_of_it()
        {
            using (var scan = new PrefixSum(TestShaders.Load("PrefixSum"), 5000))
            using (GraphicsBuffer large = GpuTest.Upload("Large", RandomCounts(5000, seed: 3)))
            using (GraphicsBuffer small = GpuTest.Upload("Small", new uint[] { 5, 6, 7 }))
            using (GraphicsBuffer sums = GpuBuffer.Structured<uint>("Sums", 5000))
            {
                GpuTest.Run(cmd =>
                {
                    scan.Record(cmd, large, sums, 5000);
                    scan.Record(cmd, small, sums, 3);
                });
                Assert.That(GpuTest.Read<uint>(sums, 3), Is.EqualTo(new uint[] { 0, 5, 11 }));
            }
        }

        [Test]
        public void A_count_above_the_capacity_is_refused_by_name()
        {
            using (var scan = new PrefixSum(TestShaders.Load("PrefixSum"), capacity: 100))
            using (var cmd = new CommandBuffer())
            {
                var error = Assert.Throws<ArgumentOutOfRangeException>(() => scan.Record(cmd, null, null, 101));
                Assert.That(error.Message, Does.Contain("100 elements"));
            }
        }

        [TestCase(0)]
        [TestCase(-1)]
        [TestCase(PrefixSum.MaxCapacity + 1)]
        public void A_capacity_that_no_dispatch_can_scan_is_refused(int capacity)
        {
            var error = Assert.Throws<ArgumentOutOfRangeException>(() => new PrefixSum(TestShaders.Load("PrefixSum"), capacity));
            Assert.That(error.Message, Does.Contain(Invariant($"{PrefixSum.MaxCapacity:N0} elements")));
        }

        static uint[] RandomCounts(int count, int seed)
        {
            var random = new System.Random(seed);
            return Enumerable.Range(0, count).Select(_ => (uint)random.Next(0, 40)).ToArray();
        }

        // Scans the first 'count' elements, into a buffer that was filled with garbage.
        static (uint[] sums, uint[] counts) Scan(uint[] counts, int count)
        {
            using (var scan = new PrefixSum(TestShaders.Load("PrefixSum"), counts.Length))
            using (GraphicsBuffer input = GpuTest.Upload("Counts", counts))
            using (GraphicsBuffer output = GpuBuffer.Structured<uint>("Sums", counts.Length))
            {
                GpuTest.FillWithGarbage(output);
                GpuTest.Run(cmd => scan.Record(cmd, input, output, count));
                return (GpuTest.Read<uint>(output, counts.Length), GpuTest.Read<uint>(input, counts.Length));
            }
        }
    }
}
