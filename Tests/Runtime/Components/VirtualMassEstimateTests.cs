using NUnit.Framework;
using UnityEngine;

namespace Rill.Tests
{
    public class VirtualMassEstimateTests
    {
        const float Gravity = 9.81f, Guess = 2.5f, Step = 0.02f;

        [Test]
        public void It_is_the_guess_until_a_body_in_the_water_has_moved()
        {
            var estimate = new VirtualMassEstimate();
            Assert.That(estimate.Or(Guess), Is.EqualTo(Guess));
            Learn(ref estimate, 0.5f, Vector3.up, 0f);
            Assert.That(estimate.Or(Guess), Is.EqualTo(Guess), "out of the water");
            Learn(ref estimate, 0.5f, Vector3.zero, 1f);
            Assert.That(estimate.Or(Guess), Is.EqualTo(Guess).Within(1e-4f), "at rest");
        }

        [Test]
        public void It_is_the_water_s_own_once_a_body_has_moved_and_the_guess_again_after_a_rest(
            [Values(0.15f, 0.5f, 2.5f, 4.7f)] float mass, [Values(0.1f, 1f)] float fraction)
        {
            var estimate = new VirtualMassEstimate();
            Learn(ref estimate, mass, new Vector3(3f, -4f, 0f), fraction);
            Assert.That(estimate.Or(Guess), Is.EqualTo(mass).Within(0.02f * Guess));
            for (int i = 0; i < 14; i++)
                Learn(ref estimate, mass, Vector3.zero, fraction);
            Assert.That(estimate.Or(Guess), Is.EqualTo(Guess).Within(0.02f * Guess));
        }

        [Test]
        public void It_stays_within_its_limits_whatever_the_forces([Values(-5f, 100f)] float mass)
        {
            var estimate = new VirtualMassEstimate();
            Learn(ref estimate, mass, 5f * Vector3.up, 1f);
            Assert.That(estimate.Or(Guess), Is.EqualTo(mass < 0f ? 0.1f : 10f));
            Assert.That(estimate.Or(16f), Is.EqualTo(mass < 0f ? 0.1f : 16f));
        }

        // Half a second of a water that resists by a virtual mass, with the slip as the acceleration by which that would resist.
        static void Learn(ref VirtualMassEstimate estimate, float mass, Vector3 slip, float fraction)
        {
            for (int i = 0; i < 25; i++)
            {
                estimate.Age(Step);
                estimate.Add(-mass * fraction * slip, slip, fraction, Gravity, Guess, Step);
            }
        }
    }
}
