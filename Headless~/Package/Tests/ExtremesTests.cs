using System.Linq;
using Host.Report.Extremes;
using NUnit.Framework;
using Unity.Mathematics;

namespace Host.Tests
{
    /// <summary>Judgement of the report's extreme cases: it must notice faults.</summary>
    public class ExtremesTests
    {
        [TestCase(0.9, true)]
        [TestCase(1.0, true)]
        [TestCase(1.01, false)]
        [TestCase(double.NaN, false)]
        [TestCase(double.PositiveInfinity, false)]
        public void A_value_over_its_bar_or_none_at_all_is_named(double value, bool holds)
        {
            var check = new ExtremeCheck();
            check.AtMost("speed", value, 1.0, "m/s");
            check.Note("volume", 3);
            Assert.That(check.Holds, Is.EqualTo(holds));
            Assert.That(check.Broken, Is.EqualTo(holds ? "" : "speed"));
            Assert.That(check.Bar, Is.EqualTo("speed at most 1 m/s"));
            Assert.That(check.Seen, Does.EndWith("m/s; volume 3"));
        }

        [TestCase(-1.0)]
        [TestCase(2.0)]
        [TestCase(double.NaN)]
        public void A_value_beside_its_range_is_named(double value)
        {
            var check = new ExtremeCheck();
            check.Between("volume", value, 0.0, 1.0);
            check.Exactly("pairs", value, 0.0);
            check.AtLeast("overflow", value, 5.0);
            Assert.That(check.Broken, Is.EqualTo("volume; pairs; overflow"));
        }

        [Test]
        public void A_particle_that_is_missing_or_outside_or_has_no_speed_is_named()
        {
            var whole = new ExtremeCounts(Added: 100, Alive: 90, Refused: 7, NonFinite: 3, Escaped: 0, Coincident: 5, Overflow: 50, SpeedMax: 1f);
            Assert.That(whole.Broken(), Is.Empty);
            Assert.That((whole with { Alive = 88 }).Broken(), Is.EqualTo(new[] { "2 particles lost uncounted" }));
            Assert.That((whole with { Escaped = 1 }).Broken(), Is.EqualTo(new[] { "1 particles outside" }));
            Assert.That((whole with { SpeedMax = float.NaN }).Broken(), Is.EqualTo(new[] { "a speed is not finite" }));
        }

        [TestCase(0.05f)]
        [TestCase(0.25f)]
        [TestCase(1f)]
        public void Close_pairs_are_those_of_comparing_all_with_all(float distance)
        {
            var random = new Random(5);
            float3[] positions = Enumerable.Range(0, 600).Select(_ => random.NextFloat3(-1f, 1f)).ToArray();
            int expected = 0;
            for (int i = 0; i < positions.Length; i++)
                for (int j = 0; j < i; j++)
                    expected += math.distance(positions[i], positions[j]) < distance ? 1 : 0;
            Assert.That(expected, Is.GreaterThan(0));
            Assert.That(ClosePairs.Count(positions, distance), Is.EqualTo(expected));
        }

        [Test]
        public void More_close_pairs_than_an_int_holds_are_counted()
        {
            const long crowd = 70_000;      // crowd (crowd - 1) / 2 is above 2^31
            var positions = Enumerable.Repeat(new float3(0.3f), (int)crowd).Append(new float3(0.35f, 0.3f, 0.3f)).Append(new float3(5f)).ToArray();
            Assert.That(ClosePairs.Count(positions, 0.25f), Is.EqualTo(crowd * (crowd - 1) / 2 + crowd));
        }

        [Test]
        public void A_failure_is_named_with_what_was_seen_and_its_bar()
        {
            var check = new ExtremeCheck();
            check.AtMost("speed", 2, 1, "m/s");
            check.Note("speed of sound", 7);
            check.Exactly("closer than 0.05 d", 0, 0);
            check.Between("volume", 2, 0.5, 1);
            Assert.That(ExtremesSection.Failure("2 particles outside; " + check.Broken, check.Bar, check.Seen),
                Is.EqualTo("2 particles outside; speed 2 m/s (at most 1 m/s); volume 2 (0.5 to 1)"));
        }
    }
}
