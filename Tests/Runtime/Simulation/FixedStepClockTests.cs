using System.Linq;
using NUnit.Framework;

namespace Rill.Tests
{
    public class FixedStepClockTests
    {
        const double Step = 1.0 / 60.0;

        [Test]
        public void A_frame_as_long_as_a_step_takes_one_step_every_time()
        {
            var clock = new FixedStepClock();
            for (int frame = 0; frame < 100000; frame++)
                Assert.That(clock.Advance(1f / 60f, 1f / 60f, 4), Is.EqualTo(1), $"frame {frame}");
        }

        [TestCase(0.001)]
        [TestCase(1.0 / 144.0)]
        [TestCase(1.0 / 59.94)]
        [TestCase(1.0 / 30.0)]
        [TestCase(0.0501)]
        public void Steps_add_up_to_the_time_that_has_passed(double frameTime)
        {
            var clock = new FixedStepClock();
            const int frames = 10000;
            long steps = Enumerable.Range(0, frames).Sum(_ => (long)clock.Advance(frameTime, Step, 16));
            Assert.That(steps * Step, Is.EqualTo(frames * frameTime).Within(Step * 1.01));
            Assert.That(clock.Dropped, Is.Zero);
        }

        [Test]
        public void Frames_of_half_a_step_step_every_other_time()
        {
            var clock = new FixedStepClock();
            int[] steps = Enumerable.Range(0, 6).Select(_ => clock.Advance(Step / 2.0, Step, 4)).ToArray();
            Assert.That(steps, Is.EqualTo(new[] { 0, 1, 0, 1, 0, 1 }));
        }

        [Test]
        public void A_hitch_is_capped_and_the_rest_is_dropped_and_counted()
        {
            var clock = new FixedStepClock();
            Assert.That(clock.Advance(1.0, Step, 4), Is.EqualTo(4));
            Assert.That(clock.Dropped, Is.EqualTo(56.0 / 60.0).Within(1e-9));
            Assert.That(clock.Advance(Step, Step, 4), Is.EqualTo(1), "nothing of the hitch is caught up with");
        }

        [Test]
        public void A_frame_without_time_takes_no_step()
        {
            var clock = new FixedStepClock();
            Assert.That(clock.Advance(0.0, Step, 4), Is.Zero);
        }

        [Test]
        public void A_change_of_the_step_length_keeps_the_time_left_over()
        {
            var clock = new FixedStepClock();
            Assert.That(clock.Advance(1.5 * Step, Step, 4), Is.EqualTo(1));
            Assert.That(clock.Advance(0.0, Step / 2.0, 4), Is.EqualTo(1));
            Assert.That(clock.FrameInterval, Is.EqualTo(Step / 2.0), "never 0: speeds are by this time");
        }

        [TestCase(0.3, 1.2)]
        [TestCase(1.0, 1.0)]
        [TestCase(40.0, 40.0)]
        public void The_time_between_frames_that_step_is_that_of_all_frames_since(double frameSteps, double passedSteps)
        {
            var clock = new FixedStepClock();
            Assert.That(clock.FrameInterval, Is.Zero);
            for (int frame = 0; clock.Advance(frameSteps * Step, Step, 4) == 0; frame++)
                Assert.That(clock.FrameInterval, Is.Zero, "no frame has stepped");
            Assert.That(clock.FrameInterval, Is.EqualTo(passedSteps * Step).Within(1e-9), "what the cap drops has passed too");
            double before = clock.FrameInterval;
            while (clock.Advance(frameSteps * Step, Step, 4) == 0)
                Assert.That(clock.FrameInterval, Is.EqualTo(before), "of the last frame that stepped");
            Assert.That(clock.FrameInterval, Is.EqualTo(frameSteps < 1.0 ? 0.9 * Step : before).Within(1e-9));
        }

        [TestCase(0.4, 3, 0.2, 0.0)]
        [TestCase(0.4, 5, 0.0, 0.2)]
        [TestCase(1.25, 2, 0.5, 0.25)]
        [TestCase(1.0, 2, 0.0, 0.0)]
        [TestCase(40.5, 1, 0.5, 0.0)]
        public void The_steps_stay_behind_the_frame_by_less_than_one(double frameSteps, int frames, double behindSteps, double lastSteps)
        {
            var clock = new FixedStepClock();
            for (int frame = 0; frame < frames; frame++)
                clock.Advance(frameSteps * Step, Step, 4);
            Assert.That(clock.FrameLag, Is.EqualTo(behindSteps * Step).Within(1e-9), "after the last frame that stepped");
            Assert.That(clock.LastFrameLag, Is.EqualTo(lastSteps * Step).Within(1e-9), "after the one before");
        }

        [Test]
        public void Frames_that_drop_time_in_a_row_are_counted_until_one_that_steps_does_not()
        {
            var clock = new FixedStepClock();
            for (int frame = 1; frame <= 3; frame++)
            {
                clock.Advance(6.0 * Step, Step, 4);
                Assert.That(clock.DroppingFrames, Is.EqualTo(frame));
                Assert.That(clock.FrameDropped, Is.EqualTo(2.0 * Step).Within(1e-9));
            }
            clock.Advance(0.3 * Step, Step, 4);
            Assert.That(clock.DroppingFrames, Is.EqualTo(3), "it took no steps");
            Assert.That(clock.FrameDropped, Is.EqualTo(2.0 * Step).Within(1e-9));
            clock.Advance(4.0 * Step, Step, 4);
            Assert.That((clock.DroppingFrames, clock.FrameDropped), Is.EqualTo((0, 0.0)));
            clock.Advance(5.0 * Step, Step, 4);
            Assert.That(clock.DroppingFrames, Is.EqualTo(1));
            Assert.That(clock.Dropped, Is.EqualTo(7.0 * Step).Within(1e-9), "in all");
        }

        [Test]
        public void Time_is_known_as_dropped_for_ten_frames_that_step()
        {
            var clock = new FixedStepClock();
            clock.Advance(4.0 * Step, Step, 4);
            Assert.That(clock.DropsTime, Is.False);
            for (int again = 0; again < 2; again++)
            {
                clock.Advance(5.0 * Step, Step, 4);
                for (int frame = 0; frame < 9; frame++)
                {
                    Assert.That(clock.DropsTime, $"frame {frame}");
                    clock.Advance(0.0, Step, 4);
                    clock.Advance(Step, Step, 4);
                }
            }
            Assert.That(clock.DropsTime);
            clock.Advance(Step, Step, 4);
            Assert.That(clock.DropsTime, Is.False);
        }

        // A frame of half a step and one of nine and a half, four of which are taken in the time of ten.
        [Test]
        public void The_rate_of_fluid_time_is_of_the_time_since_the_last_frame_that_stepped()
        {
            var clock = new FixedStepClock();
            Assert.That(clock.FrameRate, Is.EqualTo(1.0));
            clock.Advance(0.5 * Step, Step, 4);
            clock.Advance(9.5 * Step, Step, 4);
            Assert.That(clock.FrameRate, Is.EqualTo(0.4).Within(1e-9));
            clock.Advance(3.0 * Step, Step, 4);
            Assert.That(clock.FrameRate, Is.EqualTo(1.0));
        }

        [Test]
        public void A_clock_goes_on_from_its_records_as_if_it_had_not_stopped()
        {
            var clock = new FixedStepClock();
            for (int frame = 0; frame < 7; frame++)
                clock.Advance((0.3 + 1.1 * frame) * Step, Step, 4);
            var calls = new CallsRecord();
            clock.SaveDrops(ref calls);
            var other = new FixedStepClock { Record = clock.Record };
            other.LoadDrops(calls);
            Assert.That(clock.DroppingFrames, Is.GreaterThan(1));
            for (int frame = 0; frame < 30; frame++)
            {
                Assert.That(State(other), Is.EqualTo(State(clock)), $"frame {frame}");
                clock.Advance(0.7 * Step, Step, 4);
                other.Advance(0.7 * Step, Step, 4);
            }
        }

        static (ClockRecord, double, int, bool, double) State(in FixedStepClock clock)
            => (clock.Record, clock.FrameDropped, clock.DroppingFrames, clock.DropsTime, clock.FrameRate);

        [Test]
        public void A_very_long_frame_neither_overflows_nor_wraps()
        {
            var clock = new FixedStepClock();
            Assert.That(clock.Advance(1e12, Step, 4), Is.EqualTo(4));
            Assert.That(clock.Dropped, Is.EqualTo(1e12).Within(1.0));
        }
    }
}
