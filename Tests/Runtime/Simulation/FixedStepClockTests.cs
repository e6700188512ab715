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
        public void A_very_long_frame_neither_overflows_nor_wraps()
        {
            var clock = new FixedStepClock();
            Assert.That(clock.Advance(1e12, Step, 4), Is.EqualTo(4));
            Assert.That(clock.Dropped, Is.EqualTo(1e12).Within(1.0));
        }
    }
}
