using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using NUnit.Framework;
using Unity.Mathematics;

namespace Host.Tests
{
    public class SheetTests
    {
        [TestCase(1)]
        [TestCase(3)]
        public void A_lattice_on_the_floor_has_its_volume_and_is_even(int layers)
        {
            var sheet = new Sheet(Lattice(layers), new float2(17f, 26f));
            Assert.That(sheet.LocalVolume, Is.EqualTo(1.0).Within(0.03));       // columns are not whole numbers of spacings wide
            Assert.That(sheet.High, Is.Zero);
            Assert.That(new Sheet(Lattice(layers, new int2(16, 24)), new float2(16f, 24f)).Unevenness, Is.EqualTo(0.0).Within(1e-6));
        }

        [Test]
        public void Water_that_is_parted_by_a_tenth_has_a_tenth_more_volume()
        {
            var sheet = new Sheet(Lattice(3, new int2(16, 24)).Select(p => p * new float3(1f, 1.1f, 1f)), new float2(16f, 24f));
            Assert.That(sheet.LocalVolume, Is.EqualTo(1.1).Within(1e-5));
        }

        [Test]
        public void A_heap_is_uneven_and_no_more_in_volume()
        {
            var sheet = new Sheet(Lattice(4, new int2(8, 24)).Concat(Lattice(2, new int2(8, 24)).Select(p => p + new float3(8f, 0f, 0f))),
                new float2(16f, 24f));
            Assert.That(sheet.LocalVolume, Is.EqualTo(1.0).Within(1e-5));
            Assert.That(sheet.Unevenness, Is.EqualTo(1.0).Within(1e-5));
        }

        [Test]
        public void Particles_over_the_water_are_high()
        {
            float3[] water = Lattice(2, new int2(16, 24)).ToArray();
            var sheet = new Sheet(water.Select((p, i) => i % 100 == 0 ? p + new float3(0f, 4f, 0f) : p), new float2(16f, 24f));
            Assert.That(sheet.High, Is.EqualTo(0.01).Within(1e-3));
        }

        static IEnumerable<float3> Lattice(int layers) => Lattice(layers, new int2(17, 26));

        static IEnumerable<float3> Lattice(int layers, int2 counts) =>
            Enumerable.Range(0, counts.x * counts.y * layers)
            .Select(i => new float3(i % counts.x, i / (counts.x * counts.y), i / counts.x % counts.y) + 0.5f);
    }
}
