using System;
using NUnit.Framework;

namespace Rill.Tests
{
    public class EmissionClockTests
    {
        const double Volume = 1e-6;
        const int NoLimit = int.MaxValue;

        [Test]
        public void After_any_time_the_rate_times_the_time_is_due_to_within_one_particle([Values(0.0, 1e-7, 3.3e-5, 0.001,
            0.7)] double rate, [Values(1.0 / 60, 1.0 / 7, 1e-3)] double step)
        {
            var clock = new EmissionClock();
            long due = 0;
            for (int i = 1; i <= 5000; i++)
            {
                due += clock.Advance(step, rate, 0.0, double.PositiveInfinity, Volume, NoLimit).due;
                Assert.That(due, Is.EqualTo(clock.Due));
                Assert.That(due * Volume, Is.InRange(rate * i * step - Volume * 1.001, rate * i * step + Volume * 1e-3));
            }
        }

        [Test]
        public void A_rate_that_changes_in_every_step_is_kept_too()
        {
            var clock = new EmissionClock();
            var random = new Random(5);
            double volume = 0.0;
            for (int i = 0; i < 3000; i++)
            {
                double rate = random.NextDouble() * 2e-4, step = 0.001 + 0.05 * random.NextDouble();
                clock.Advance(step, rate, 0.0, double.PositiveInfinity, Volume, NoLimit);
                volume += rate * step;
                Assert.That(clock.Due * Volume, Is.InRange(volume - Volume * 1.001, volume + Volume * 1e-3));
            }
        }

        // The instants of all particles, step by step, are a rate's: one after the other at the same distance.
        [Test]
        public void Each_particle_is_due_at_its_own_instant_whatever_the_steps([Values(1.0 / 60, 0.011, 0.2)] double step,
            [Values(0.0, 0.0137)] double delay)
        {
            const double rate = 3.7e-4;
            var clock = new EmissionClock();
            for (int i = 0; i < 200; i++)
            {
                EmissionClock.Fraction fraction = clock.Advance(step, rate, delay, double.PositiveInfinity, Volume, NoLimit);
                for (int k = 0; k < fraction.due; k++)
                {
                    double instant = clock.Time - fraction.firstAge + k * fraction.interval;
                    Assert.That(instant, Is.EqualTo(delay + (fraction.first + k + 1) * Volume / rate).Within(1e-6));
                    Assert.That(fraction.firstAge - k * fraction.interval, Is.InRange(-1e-6, step + 1e-6));
                }
            }
        }

        [TestCase(0.0, 0.5)]
        [TestCase(0.1, 0.5)]
        [TestCase(0.1234, 0.0567)]
        [TestCase(0.005, 0.001)]
        public void What_is_due_between_a_delay_and_the_end_is_the_rate_times_the_duration(double delay, double duration)
        {
            const double rate = 1e-3;
            var clock = new EmissionClock();
            for (int i = 0; i < 120; i++)
            {
                EmissionClock.Fraction fraction = clock.Advance(1.0 / 60, rate, delay, delay + duration, Volume, NoLimit);
                if (clock.Time < delay || clock.Time - 1.0 / 60 > delay + duration)
                    Assert.That(fraction.due, Is.Zero);
            }
            Assert.That(clock.Due * Volume, Is.InRange(rate * duration - Volume * 1.001, rate * duration + Volume * 1e-3));
        }

        [Test]
        public void What_is_more_than_a_step_takes_is_due_in_the_next_ones()
        {
            var clock = new EmissionClock();
            Assert.That(clock.Advance(1.0, 250 * Volume, 0.0, 1.0, Volume, 100).due, Is.EqualTo(100));
            Assert.That(clock.Advance(1.0, 250 * Volume, 0.0, 1.0, Volume, 100).due, Is.EqualTo(100));
            Assert.That(clock.Advance(1.0, 250 * Volume, 0.0, 1.0, Volume, 100).due, Is.EqualTo(50));
            Assert.That(clock.Advance(1.0, 250 * Volume, 0.0, 1.0, Volume, 100).due, Is.Zero);
        }
    }
}
