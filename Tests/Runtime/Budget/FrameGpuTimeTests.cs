using System;
using NUnit.Framework;
using UnityEngine.Rendering;
using Random = Unity.Mathematics.Random;

namespace Rill.Tests
{
    /// <summary>The fluid's part found in the whole frame's GPU time.</summary>
    public class FrameGpuTimeTests
    {
        const float Seconds = 1f / 60f;
        const int FramesLate = 4;
        const double Factor = 3.0;      // true time over the model's

        [Test]
        public void Without_frame_times_and_factor_there_is_no_source()
        {
            var source = new FrameGpuTime();
            StepTime last = Play(source, 120, frame => 1f, (frame, fluid) => 0.0);
            Assert.That(source.Kind, Is.EqualTo(GpuTimeKind.None));
            Assert.That(last.Milliseconds, Is.Zero);
        }

        [Test]
        public void A_factor_that_is_known_models_without_any_frame_time()
        {
            var source = new FrameGpuTime { DeviceFactor = 3f };
            StepTime last = Play(source, 30, frame => 1.5f, (frame, fluid) => 0.0);
            Assert.That(source.Kind, Is.EqualTo(GpuTimeKind.Modeled));
            Assert.That(last.Milliseconds, Is.EqualTo(4.5f).Within(1e-4f));
            Assert.That(last.Modeled, Is.EqualTo(1.5f));
        }

        [Test]
        public void Work_that_never_changes_is_given_the_whole_frame()
        {
            var source = new FrameGpuTime();
            StepTime last = Play(source, 120, frame => 1f, (frame, fluid) => fluid + 5.0);
            Assert.That(last.Milliseconds, Is.EqualTo(8f).Within(1e-3f), "the most that it can be");
        }

        [TestCase(0.0)]
        [TestCase(5.0)]
        [TestCase(20.0)]
        public void Work_that_changes_shows_what_it_costs_beside_other_work(double other)
        {
            var source = new FrameGpuTime();
            StepTime last = Play(source, 240, frame => frame / 30 % 2 == 0 ? 1f : 2f, (frame, fluid) => fluid + other);
            Assert.That(last.Milliseconds / last.Modeled, Is.EqualTo(Factor).Within(0.15 * Factor + 0.1 * other));
            Assert.That(last.Milliseconds / last.Modeled, Is.LessThanOrEqualTo((Factor * 1.5 + 0.8 * other) / 1.5 + 1e-6),
                "less than the whole frame");
        }

        [Test]
        public void A_factor_that_is_wrong_is_mended_by_what_frames_show()
        {
            var source = new FrameGpuTime { DeviceFactor = 6f };
            var random = new Random(9);
            StepTime last = Play(source, 600, frame => frame / 30 % 2 == 0 ? 1f : 2f, (frame, fluid) => (fluid + 2.0) * random.NextDouble(0.9, 1.1));
            Assert.That(last.Milliseconds / last.Modeled, Is.EqualTo(Factor).Within(25).Percent);
        }

        [Test]
        public void Other_work_that_comes_and_goes_hardly_moves_a_known_factor()
        {
            var source = new FrameGpuTime { DeviceFactor = 3f };
            StepTime last = Play(source, 600, frame => 1.5f, (frame, fluid) => fluid + (frame / 60 % 2 == 0 ? 1.0 : 9.0));
            Assert.That(last.Milliseconds / last.Modeled, Is.EqualTo(Factor).Within(5).Percent);
        }

        // Two seconds of the same work are within the memory of three: what the frame spends besides is not taken for the fluid's.
        [Test]
        public void What_changed_two_seconds_ago_still_tells_the_fluid_from_other_work()
        {
            var source = new FrameGpuTime();
            StepTime last = Play(source, 1200, frame => frame / 120 % 2 == 0 ? 1f : 2f, (frame, fluid) => fluid + 5.0);
            Assert.That(last.Milliseconds / last.Modeled, Is.EqualTo(Factor).Within(15).Percent);
        }

        // Speed of a laptop that is unplugged: after four times the memory nothing is left of the speed before.
        [Test]
        public void A_device_that_becomes_half_as_fast_is_known_after_twelve_seconds()
        {
            var source = new FrameGpuTime();
            StepTime last = Play(source, 1800 + 720, frame => frame / 30 % 2 == 0 ? 1f : 2f,
                (frame, fluid) => (frame < 1800 ? 1.0 : 2.0) * fluid + 2.0);
            Assert.That(last.Milliseconds / last.Modeled, Is.EqualTo(2.0 * Factor).Within(10).Percent);
        }

        [Test]
        public void Frames_of_more_steps_are_of_more_work()
        {
            var source = new FrameGpuTime();
            StepTime last = Play(source, 240, frame => 1f, (frame, fluid) => fluid + 5.0, frame => 1 + frame / 30 % 2);
            Assert.That(last.Milliseconds / last.Modeled, Is.EqualTo(Factor).Within(25).Percent);
        }

        [Test]
        public void Frame_times_that_are_zero_are_unknown_and_change_nothing()
        {
            var source = new FrameGpuTime();
            StepTime with = Play(source, 240, frame => frame / 30 % 2 == 0 ? 1f : 2f, (frame, fluid) => frame % 3 == 0 ? fluid + 1.0 : 0.0);
            Assert.That(with.Milliseconds / with.Modeled, Is.EqualTo(Factor).Within(20).Percent);
            for (int i = 0; i < 56; i++)
                source.Read(Seconds, new WorkHistory(), 0.0);
            Assert.That(source.Kind, Is.EqualTo(GpuTimeKind.Modeled), "for less than a second");
            for (int i = 0; i < 5; i++)
                source.Read(Seconds, new WorkHistory(), 0.0);
            Assert.That(source.Kind, Is.EqualTo(GpuTimeKind.None), "for longer than a second");
        }

        [Test]
        public void Times_of_steps_that_stop_coming_give_way_to_the_model_after_a_second_and_come_back_at_once()
        {
            var measured = new Told { Milliseconds = 2f };
            using (var best = new BestGpuTime(measured, new FrameGpuTime { DeviceFactor = 3f }))
            {
                var history = new WorkHistory();
                history.Add(1, 1.5f);
                Assert.That(best.Read(Seconds, history).Milliseconds, Is.EqualTo(2f));
                Assert.That(best.Kind, Is.EqualTo(GpuTimeKind.Measured));
                measured.Milliseconds = 0f;
                for (int i = 0; i < 58; i++)
                    Assert.That(best.Read(Seconds, history).Milliseconds, Is.Zero, $"frame {i}");
                Assert.That(best.Kind, Is.EqualTo(GpuTimeKind.Measured));
                for (int i = 0; i < 3; i++)
                    best.Read(Seconds, history);
                Assert.That(best.Read(Seconds, history).Milliseconds, Is.EqualTo(4.5f).Within(1e-4f));
                Assert.That(best.Kind, Is.EqualTo(GpuTimeKind.Modeled));
                measured.Milliseconds = 2f;
                Assert.That(best.Read(Seconds, history).Milliseconds, Is.EqualTo(2f));
                Assert.That(best.Kind, Is.EqualTo(GpuTimeKind.Measured));
            }
            Assert.That(measured.IsDisposed);
        }

        [Test]
        public void A_device_that_tells_no_times_of_steps_has_the_model_at_once()
        {
            using (var best = new BestGpuTime(null, new FrameGpuTime { DeviceFactor = 3f }))
            {
                var history = new WorkHistory();
                history.Add(1, 1.5f);
                Assert.That(best.Read(Seconds, history).Milliseconds, Is.EqualTo(4.5f).Within(1e-4f));
                Assert.That(best.Kind, Is.EqualTo(GpuTimeKind.Modeled));
            }
        }

        sealed class Told : IGpuTimeSource
        {
            public float Milliseconds;
            public bool IsDisposed { get; private set; }

            public GpuTimeKind Kind => GpuTimeKind.Measured;

            public void BeginStep(CommandBuffer commands) { }
            public void EndStep(CommandBuffer commands) { }
            public StepTime Read(float seconds, WorkHistory work) => new StepTime(Milliseconds, Milliseconds);
            public void Dispose() => IsDisposed = true;
        }

        // Tells of each frame four frames later; returns the last reading.
        static StepTime Play(FrameGpuTime source, int frames, Func<int, float> cost, Func<int, double, double> frameTime,
            Func<int, int> steps = null)
        {
            int Steps(int frame) => steps != null ? steps(frame) : 1;

            var history = new WorkHistory();
            StepTime last = default;
            for (int frame = 0; frame < frames; frame++)
            {
                int of = frame - FramesLate;
                last = source.Read(Seconds, history, of >= 0 ? frameTime(of, Steps(of) * cost(of) * Factor) : 0.0);
                history.Add(Steps(frame), cost(frame));
            }
            return last;
        }
    }
}
