using System;
using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.TestTools;
using UnityEngine.Timeline;

namespace Rill.Tests
{
    /// <summary>A track of a Timeline shows the frames of a recording by time, clip, clip-in and speed, however the time was
    /// reached.</summary>
    public class FluidPlaybackTrackTests
    {
        const int Frames = 16;
        const double Frame = 1.0 / 60.0;

        RecordedWater water;
        byte[] recording;
        SourceScene scene;
        FluidPlayback playback;
        GameObject stage;
        PlayableDirector director;
        TimelineAsset timeline;
        FluidPlaybackTrack track;

        [OneTimeSetUp]
        public void RecordOne()
        {
            water = new RecordedWater().Run(Frames);
            recording = water.End();
        }

        [OneTimeTearDown]
        public void DisposeWater() => water.Dispose();

        [SetUp]
        public void MakeStage()
        {
            scene = RecordedWater.MakeScene();
            playback = RecordedWater.Play(scene, recording);
            stage = new GameObject("Stage");
            director = stage.AddComponent<PlayableDirector>();
            timeline = ScriptableObject.CreateInstance<TimelineAsset>();
            track = timeline.CreateTrack<FluidPlaybackTrack>("Water");
            director.playableAsset = timeline;
            director.SetGenericBinding(track, playback);
        }

        [TearDown]
        public void DestroyStage()
        {
            UnityEngine.Object.DestroyImmediate(stage);
            UnityEngine.Object.DestroyImmediate(timeline);
            scene.Dispose();
        }

        [Test]
        public void Scrubbing_there_and_back_shows_what_setting_the_time_by_hand_shows()
        {
            Lay(0, Frames);
            using (SourceScene other = RecordedWater.MakeScene())
            {
                FluidPlayback byHand = RecordedWater.Play(other, recording);
                foreach (double frame in new[] { 0.0, 1.0, 2.0, 9.0, 8.0, 7.5, 3.0, 14.25, 15.0, 0.0 })
                {
                    Scrub(frame);
                    byHand.Time = frame * Frame;
                    other.Step();
                    Assert.That((playback.ShownFrame, playback.Lag), Is.EqualTo((byHand.ShownFrame, byHand.Lag)), $"frame {frame}");
                    RecordedWater.AssertNear(scene.Read(), water.States[(int)frame]);
                    TestFluid.AssertSame(scene.Read(), other.Read());
                }
            }
        }

        [Test]
        public void Clips_in_a_row_show_the_parts_that_they_begin_with()
        {
            Lay(0, 4, begin: 8);
            Lay(4, 4, begin: 2);
            foreach ((int at, int shown) in new[] { (0, 8), (3, 11), (4, 2), (6, 4), (1, 9) })
                AssertShows(at, shown);
        }

        [Test]
        public void A_clip_is_trimmed_and_played_faster_as_the_timeline_says()
        {
            TimelineClip clip = Lay(1, 10, begin: 1);
            clip.clipIn = 2 * Frame;
            clip.timeScale = 2.0;
            foreach ((int at, int shown) in new[] { (1, 3), (3, 7), (6, 13), (2, 5) })
                AssertShows(at, shown);
        }

        [Test]
        public void After_a_clip_its_last_frame_stays_from_whichever_side_it_is_reached()
        {
            Lay(2, 3);
            Lay(10, 2, begin: 9);
            foreach ((int at, int shown) in new[] { (0, 0), (3, 1), (7, 3), (11, 10), (7, 3), (20, 11), (5, 3), (1, 0) })
                AssertShows(at, shown);
        }

        [Test]
        public void A_clip_that_is_longer_than_the_recording_holds_the_end_of_it()
        {
            Lay(0, 30);
            AssertShows(25, Frames - 1);
            Assert.That(playback.Time, Is.EqualTo(playback.Duration));
        }

        [Test]
        public void Of_clips_that_overlap_the_one_that_starts_later_is_shown()
        {
            Lay(4, 4, begin: 0);
            Lay(0, 10, begin: 6);
            foreach ((int at, int shown) in new[] { (3, 9), (5, 1), (9, 4) })
                AssertShows(at, shown);
        }

        [Test]
        public void A_clip_that_is_moved_while_the_graph_lives_is_shown_at_its_new_time()
        {
            TimelineClip clip = Lay(0, 10);
            AssertShows(5, 5);
            clip.start = 3 * Frame;
            ((FluidPlaybackClip)clip.asset).Begin = Frame;
            AssertShows(5, 3);
        }

        [TestCase(true)]
        [TestCase(false)]
        public void When_the_timeline_lets_go_the_playback_plays_or_stands_as_before(bool plays)
        {
            Lay(0, Frames);
            if (plays)
                playback.Play();
            Scrub(4);
            scene.Step(3);
            Assert.That((playback.ShownFrame, playback.IsDriven, playback.IsPlaying), Is.EqualTo((4, true, plays)), "time stands still");
            director.Stop();
            Assert.That(playback.IsDriven, Is.False);
            scene.Step(2);
            Assert.That((playback.ShownFrame, playback.IsPlaying), Is.EqualTo((plays ? 6 : 4, plays)));
        }

        [Test]
        public void A_track_without_a_binding_says_nothing_and_moves_nothing()
        {
            Lay(0, Frames);
            director.SetGenericBinding(track, null);
            playback.Play();
            director.time = 9 * Frame;
            director.Evaluate();
            scene.Step(2);
            Assert.That((playback.ShownFrame, playback.IsDriven), Is.EqualTo((2, false)));
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Another_binding_frees_the_one_before_and_one_that_was_destroyed_is_no_problem()
        {
            Lay(0, Frames);
            using (SourceScene other = RecordedWater.MakeScene())
            {
                FluidPlayback second = RecordedWater.Play(other, recording);
                Scrub(4);
                director.SetGenericBinding(track, second);
                Scrub(5);
                Assert.That((playback.IsDriven, playback.Time, second.IsDriven), Is.EqualTo((false, 4 * Frame, true)));
                Assert.That(second.Time, Is.EqualTo(5 * Frame).Within(1e-9));
            }
            Scrub(6);
            director.Stop();
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_playback_without_a_recording_is_left_alone_until_one_is_opened()
        {
            Lay(0, Frames);
            playback.Close();
            Scrub(4);
            Assert.That((playback.IsDriven, playback.Time), Is.EqualTo((false, 0.0)));
            playback.Open("memory");
            AssertShows(4, 4);
        }

        [Test]
        public void Short_steps_follow_each_other_and_long_ones_are_jumps()
        {
            Lay(0, Frames);
            Scrub(0);
            Scrub(1);
            Assert.That(scene.Fluid.Clock.FrameLag.w, Is.EqualTo(-Frame).Within(1e-5), "as when it plays");
            Scrub(9);
            Assert.That(scene.Fluid.Clock.FrameLag.w, Is.Zero, "nothing moves into a jump");
        }

        [Test]
        public void A_clip_is_as_long_as_the_rest_of_the_recording_once_that_is_known()
        {
            TimelineClip clip = Lay(0, 4, begin: 3);
            var asset = (FluidPlaybackClip)clip.asset;
            Assert.That(asset.duration, Is.EqualTo(double.PositiveInfinity));
            director.RebuildGraph();
            Assert.That(asset.duration, Is.EqualTo(playback.Duration - 3 * Frame).Within(1e-9));
            Assert.That(asset.clipCaps, Is.EqualTo(ClipCaps.ClipIn | ClipCaps.SpeedMultiplier));
        }

        [Test]
        public void A_beginning_before_the_recording_is_refused_in_words()
        {
            var asset = (FluidPlaybackClip)Lay(0, 4, begin: 3).asset;
            foreach (double begin in new[] { -1.0, double.NaN, double.PositiveInfinity })
            {
                LogAssert.Expect(LogType.Warning,
                    new Regex("FluidPlaybackClip 'FluidPlaybackClip': begin .* is not a time since the first frame"));
                asset.Begin = begin;
                Assert.That(asset.Begin, Is.Zero);
            }
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_timeline_that_plays_shows_its_time_in_each_frame_and_lets_go_at_its_end()
        {
            Lay(0, 8);
            director.Play();
            double last = -1.0;
            for (int i = 0; i < 100 && director.state == PlayState.Playing; i++)
            {
                yield return null;
                if (director.state != PlayState.Playing)
                    break;
                Assert.That(playback.Time, Is.EqualTo(Math.Min(director.time, playback.Duration)).Within(1e-9));
                Assert.That(playback.Time, Is.GreaterThanOrEqualTo(last));
                last = playback.Time;
            }
            Assert.That((director.state, playback.IsDriven), Is.EqualTo((PlayState.Paused, false)));
            Assert.That(last, Is.EqualTo(7.5 * Frame).Within(0.6 * Frame), "the last of its frames");
        }

        // In frames of the recording.
        TimelineClip Lay(int start, int frames, int begin = 0)
        {
            TimelineClip clip = track.CreateClip<FluidPlaybackClip>();
            clip.start = start * Frame;
            clip.duration = frames * Frame;
            ((FluidPlaybackClip)clip.asset).Begin = begin * Frame;
            return clip;
        }

        void Scrub(double frame)
        {
            director.time = frame * Frame;
            director.Evaluate();
            scene.Step();
        }

        void AssertShows(int at, int shown)
        {
            Scrub(at);
            Assert.That(playback.ShownFrame, Is.EqualTo(shown), $"at frame {at} of the timeline");
            RecordedWater.AssertNear(scene.Read(), water.States[shown]);
        }
    }
}
