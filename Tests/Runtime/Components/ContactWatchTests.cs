using NUnit.Framework;

namespace Rill.Tests
{
    /// <summary>Contacts derived from readings of the force on a collider.</summary>
    public class ContactWatchTests
    {
        const float Frame = 0.05f, Threshold = 10f;

        ContactWatch watch;

        [SetUp]
        public void Begin() => watch = default;

        [Test]
        public void The_first_touch_is_told_once_and_the_end_after_a_while_without_water()
        {
            Assert.That(Follow(0f), Is.EqualTo(ContactChange.None));
            Assert.That(Follow(1f), Is.EqualTo(ContactChange.Enter));
            Assert.That(watch.Touches);
            foreach (float impulse in new[] { 1f, 0f, 0f, 0.1f, 0f, 0f, 0f })
                Assert.That(Follow(impulse), Is.EqualTo(ContactChange.None), "drops that bounce are one contact");
            Assert.That(Follow(0f), Is.EqualTo(ContactChange.Exit), "four readings of 0.05 s");
            Assert.That(watch.Touches, Is.False);
            Assert.That(Follow(0f), Is.EqualTo(ContactChange.None));
            Assert.That(Follow(1f), Is.EqualTo(ContactChange.Enter));
        }

        [Test]
        public void A_hit_is_told_once_until_the_impulse_fell_below_half_of_the_threshold()
        {
            Assert.That(Follow(10f), Is.EqualTo(ContactChange.Enter | ContactChange.Hit));
            foreach (float impulse in new[] { 9f, 11f, 5f, 12f, 4.9f, 9.9f })
                Assert.That(Follow(impulse), Is.EqualTo(ContactChange.None), impulse.ToString());
            Assert.That(Follow(10f), Is.EqualTo(ContactChange.Hit));
        }

        ContactChange Follow(float impulse) => watch.Follow(impulse, Frame, Threshold);
    }
}
