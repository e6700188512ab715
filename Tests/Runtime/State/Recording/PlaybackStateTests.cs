using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>State of a playback from frame to frame, and that a second recording is independent of the first.</summary>
    public class PlaybackStateTests
    {
        const double Step = 1.0 / 60.0;
        const int Steps = 8;

        byte[] recording;
        SourceScene scene;
        FluidPlayback playback;

        [OneTimeSetUp]
        public void RecordOne() => recording = RecordedWater.Record(Steps);

        [SetUp]
        public void Make()
        {
            scene = RecordedWater.MakeScene();
            playback = RecordedWater.Play(scene, recording);
        }

        [TearDown]
        public void Dispose() => scene.Dispose();

        [Test]
        public void A_recording_that_is_closed_leaves_nothing_of_what_it_showed([Values] bool disables)
        {
            playback.Play();
            playback.Drive(3.25 * Step);
            scene.Step();
            Assert.That((playback.ShownFrame, playback.IsPlaying, playback.IsDriven), Is.EqualTo((3, true, true)));
            Assert.That(playback.Lag, Is.EqualTo(0.25 * Step).Within(1e-5));
            if (disables)
                playback.enabled = false;
            else
                playback.Close();
            Assert.That((playback.ShownFrame, playback.IsPlaying, playback.IsDriven, playback.IsOpen), Is.EqualTo((-1, false, false, false)));
            Assert.That((playback.Lag, playback.FrameCount, playback.Duration), Is.EqualTo((0.0, 0, 0.0)));
            Assert.That(scene.Fluid.FrameTime, Is.EqualTo(scene.Fluid.FluidTime), "nothing of the time since the shown frame");
            Assert.That(scene.Fluid.IsPlayedBack, Is.False);
            playback.Play();
            Assert.That(playback.IsPlaying, Is.False, "nothing is open");
            int step = scene.Fluid.StepCount;
            scene.Step();
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(step + 1), "a step of a whole frame");
        }

        [Test]
        public void A_second_recording_begins_at_its_first_frame([Values] bool plays)
        {
            var damaged = (byte[])recording.Clone();
            damaged[RecordingFormat.HeaderBytes + RecordingFormat.FrameHeaderBytes + 100] ^= 1;
            playback.PlayOnEnable = true;
            playback.OpenFile = _ => new MemoryStream(damaged);
            playback.Open("damaged");
            LogAssert.Expect(LogType.Error, new Regex("leaves out frame 0 of 'damaged'"));
            playback.Pause();
            scene.Step();
            Assert.That((playback.MissedFrames, playback.Problem != null), Is.EqualTo((1, true)));
            playback.Time = 4 * Step;
            scene.Step();
            Assert.That(playback.ShownFrame, Is.EqualTo(4));

            playback.PlayOnEnable = plays;
            playback.OpenFile = _ => new MemoryStream(recording);
            playback.Open("memory");
            Assert.That((playback.MissedFrames, playback.Problem, playback.Time, playback.ShownFrame), Is.EqualTo((0, (string)null, 0.0, -1)));
            Assert.That(playback.IsPlaying, Is.EqualTo(plays));
            scene.Step();
            Assert.That(playback.ShownFrame, Is.EqualTo(plays ? 1 : 0));
        }

        [Test]
        public void A_second_recording_that_does_not_fit_is_not_shown_though_the_first_did()
        {
            scene.Step();
            ParticleState shown = scene.Read();
            byte[] other;
            using (SourceScene fine = new SourceScene(RecordedWater.Box, 0.04f, 4000).Fill(0.1f).Step())
            {
                var file = new MemoryStream();
                FluidRecorder recorder = fine.Fluid.gameObject.AddComponent<FluidRecorder>();
                recorder.OpenFile = _ => file;
                recorder.Record("fine");
                fine.Step(2);
                recorder.enabled = false;
                other = file.ToArray();
            }
            for (int i = 0; i < 2; i++)
            {
                playback.OpenFile = _ => new MemoryStream(other);
                LogAssert.Expect(LogType.Error, new Regex("does not show 'fine': .*particle spacing of 0.04 m"));
                playback.Open("fine");
                scene.Step(2);
                TestFluid.AssertSame(scene.Read(), shown);
                playback.OpenFile = _ => new MemoryStream(recording);
                playback.Open("memory");
                playback.Pause();
                scene.Step();
                Assert.That(playback.ShownFrame, Is.Zero, "and the first is again");
                shown = scene.Read();
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void It_plays_from_where_it_was_put_and_from_the_other_end_only_where_it_stands_at_one()
        {
            foreach ((float speed, int from, bool loops, int shown) in new[] { (1f, 3, false, 5), (1f, 7, false, 2), (-1f, 3, false, 1),
                (-1f, 0, false, 5), (1f, 7, true, 2), (1f, 3, true, 5), (-1f, 0, true, 5) })
            {
                playback.Pause();
                (playback.Speed, playback.Loop, playback.Time) = (speed, loops, from == 7 ? playback.Duration : from * Step);
                scene.Step();
                Assert.That(playback.ShownFrame, Is.EqualTo(from));
                playback.Play();
                if (!loops)
                    Assert.That(playback.Time, Is.EqualTo((from == 7 ? 0 : from == 0 ? 7 : from) * Step).Within(1e-6));
                else
                    Assert.That(playback.Time, Is.EqualTo(from * Step).Within(1e-6), "what loops goes on from there");
                scene.Step(2);
                Assert.That(playback.ShownFrame, Is.EqualTo(shown), $"{speed} from {from}");
            }
        }

        [Test]
        public void After_a_pause_it_goes_on_from_where_it_stood()
        {
            playback.Play();
            scene.Step(3);
            playback.Pause();
            scene.Step(4);
            Assert.That((playback.ShownFrame, playback.IsPlaying), Is.EqualTo((3, false)));
            playback.Play();
            scene.Step();
            Assert.That(playback.ShownFrame, Is.EqualTo(4));
            scene.Fluid.enabled = false;
            scene.Fluid.enabled = true;
            scene.Step();
            Assert.That((playback.ShownFrame, scene.Fluid.IsPlayedBack), Is.EqualTo((5, true)), "of a fluid that was disabled");
            LogAssert.NoUnexpectedReceived();
        }

        // A frame that follows continues the surface of the frame before and has moved particles; a jump does not.
        [Test]
        public void Playing_follows_and_jumping_does_not()
        {
            PbfSolver solver = scene.Fluid.Solver;
            bool Follows(float seconds)
            {
                playback.Advance(seconds, solver, out _, out bool follows);
                return follows;
            }

            Assert.That(Follows(0f), Is.False, "the first frame");
            playback.Play();
            Assert.That(Follows((float)Step), "the next");
            playback.Time = 5 * Step;
            Assert.That(Follows(0f), Is.False, "another time");
            Assert.That(Follows(0f), "which is shown now");
            playback.Time = playback.Time;
            Assert.That(Follows(0f), "the same time");
            playback.Pause();
            playback.Play();
            Assert.That(Follows((float)Step), "after a pause");
            playback.Loop = true;
            playback.Time = 6.5 * Step;
            Follows(0f);
            Assert.That(Follows((float)Step), Is.False, "over the end");
            Assert.That(Follows((float)Step), "and on");
            playback.Pause();
            playback.Drive(playback.Time + 0.05);
            Assert.That(Follows(0f), "driven by a short step");
            playback.Drive(0.0);
            Assert.That(Follows(0f), "and back");
            playback.Drive(0.11);
            Assert.That(Follows(0f), Is.False, "by a long step");
            playback.Drive(0.0);
            playback.Drive(0.01);
            Assert.That(Follows(0f), Is.False, "by a long step and a short one before the next frame");
            playback.LetGo();
            playback.Play();
            Assert.That(Follows((float)Step), "and let go");
            Assert.That(playback.IsDriven, Is.False);
        }

        [Test]
        public void A_jump_to_a_frame_that_is_left_out_is_still_one_at_the_next()
        {
            var damaged = (byte[])recording.Clone();
            using (var reader = new RecordingReader(new MemoryStream(recording)))
            {
                var frame = new RecordedFrame();
                long at = RecordingFormat.HeaderBytes;
                for (int i = 0; i < 5; i++)
                {
                    reader.Read(i, frame);
                    at += i < 5 - 1 ? RecordingFormat.FrameHeaderBytes + 4 * reader.Header.Layout.Words(frame.particles) : 0;
                }
                damaged[at + RecordingFormat.FrameHeaderBytes + 100] ^= 1;
            }
            playback.OpenFile = _ => new MemoryStream(damaged);
            playback.Open("damaged");
            playback.Advance(0f, scene.Fluid.Solver, out _, out _);
            LogAssert.Expect(LogType.Error, new Regex("leaves out frame 4 of 'damaged'"));
            playback.Time = 4 * Step;
            playback.Advance(0f, scene.Fluid.Solver, out RecordedFrame shown, out bool follows);
            Assert.That((shown, playback.ShownFrame), Is.EqualTo(((RecordedFrame)null, 0)));
            playback.Drive(5 * Step);
            playback.Advance(0f, scene.Fluid.Solver, out shown, out follows);
            Assert.That((shown != null, playback.ShownFrame, follows), Is.EqualTo((true, 5, false)));
        }
    }
}
