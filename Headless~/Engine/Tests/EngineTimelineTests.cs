using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace Host.Tests
{
    /// <summary>Who is called when a director plays a timeline: by Unity's documentation of playables and the source of
    /// com.unity.timeline.</summary>
    public class EngineTimelineTests : EngineFixture
    {
        static readonly List<string> calls = new List<string>();

        PlayableDirector director;
        TimelineAsset timeline;
        LoggedTrack track;
        GameObject bound;

        [SetUp]
        public void MakeTimeline()
        {
            calls.Clear();
            bound = new GameObject("Bound");
            director = new GameObject("Director").AddComponent<PlayableDirector>();
            timeline = ScriptableObject.CreateInstance<TimelineAsset>();
            track = timeline.CreateTrack<LoggedTrack>("Logged");
            director.playableAsset = timeline;
            director.SetGenericBinding(track, bound.transform);
        }

        [Test]
        public void Frames_are_prepared_from_the_mixer_down_and_processed_from_the_clips_up_with_what_is_bound()
        {
            Lay(1.0, 2.0);
            director.time = 1.5;
            director.Evaluate();
            Assert.That(calls, Is.EqualTo(new[] { "create mixer", "create clip", "prepare mixer", "prepare clip", "process clip 0.5 Bound",
                "process mixer Bound [1 at 0.5]" }));
            director.Stop();
            Assert.That(calls.Skip(6), Is.EquivalentTo(new[] { "destroy mixer", "destroy clip" }));
        }

        [Test]
        public void Clips_have_weight_within_their_time_and_a_local_time_by_clip_in_and_speed()
        {
            TimelineClip first = Lay(1.0, 2.0), second = Lay(4.0, 2.0);
            second.clipIn = 0.25;
            second.timeScale = 2.0;
            Assert.That(Mixed(0.5), Is.EqualTo("[0 at 0] [0 at 0]"));
            Assert.That(Mixed(1.0), Is.EqualTo("[1 at 0] [0 at 0]"));
            Assert.That(Mixed(3.5), Is.EqualTo("[0 at 2] [0 at 0]"), "after its end");
            Assert.That(Mixed(5.0), Is.EqualTo("[0 at 2] [1 at 2.25]"));
            Assert.That(Mixed(2.0), Is.EqualTo("[1 at 1] [0 at 2.25]"), "before its start a clip keeps its time");
            Assert.That(timeline.duration, Is.EqualTo(6.0).Within(1e-9).And.LessThan(6.0));
            Assert.That(first.end, Is.EqualTo(3.0));
        }

        [Test]
        public void A_director_that_plays_goes_on_with_the_frames_and_ends_or_holds()
        {
            Lay(0.0, 0.3);
            int stopped = 0;
            director.stopped += _ => stopped++;
            director.Play();
            for (int i = 0; i < 3; i++)
                PlayerLoop.Frame(0.1f);
            Assert.That(director.state, Is.EqualTo(PlayState.Playing));
            Assert.That(director.time, Is.EqualTo(0.2).Within(1e-6));
            PlayerLoop.Frame(0.2f);
            Assert.That((director.state, director.time, stopped, director.playableGraph.IsValid()),
                Is.EqualTo((PlayState.Paused, 0.0, 1, false)));
            director.extrapolationMode = DirectorWrapMode.Hold;
            director.Play();
            for (int i = 0; i < 9; i++)
                PlayerLoop.Frame(0.1f);
            Assert.That(director.state, Is.EqualTo(PlayState.Playing));
            Assert.That(director.time, Is.EqualTo(0.3).Within(1e-6));
        }

        [Test]
        public void A_muted_track_is_no_part_of_the_graph()
        {
            Lay(0.0, 1.0);
            track.muted = true;
            director.Evaluate();
            Assert.That(calls, Is.Empty);
        }

        TimelineClip Lay(double start, double duration)
        {
            TimelineClip clip = track.CreateClip<LoggedClip>();
            clip.start = start;
            clip.duration = duration;
            return clip;
        }

        string Mixed(double time)
        {
            director.time = time;
            director.Evaluate();
            return calls.Last().Substring("process mixer Bound ".Length);
        }

        static string Text(double value) => System.Math.Round(value, 6).ToString(CultureInfo.InvariantCulture);

        [TrackClipType(typeof(LoggedClip))]
        sealed class LoggedTrack : TrackAsset
        {
            public override Playable CreateTrackMixer(PlayableGraph graph, GameObject go, int inputCount)
                => ScriptPlayable<LoggedMixer>.Create(graph, inputCount);
        }

        sealed class LoggedClip : PlayableAsset, ITimelineClipAsset
        {
            public ClipCaps clipCaps => ClipCaps.ClipIn | ClipCaps.SpeedMultiplier;

            public override Playable CreatePlayable(PlayableGraph graph, GameObject owner) => ScriptPlayable<LoggedBehaviour>.Create(graph);
        }

        sealed class LoggedMixer : PlayableBehaviour
        {
            public override void OnPlayableCreate(Playable playable) => calls.Add("create mixer");
            public override void OnPlayableDestroy(Playable playable) => calls.Add("destroy mixer");
            public override void PrepareFrame(Playable playable, FrameData info) => calls.Add("prepare mixer");

            public override void ProcessFrame(Playable playable, FrameData info, object playerData)
                => calls.Add($"process mixer {((Transform)playerData).name} " + string.Join(" ",
                    Enumerable.Range(0, playable.GetInputCount())
                    .Select(i => $"[{Text(playable.GetInputWeight(i))} at {Text(playable.GetInput(i).GetTime())}]")));
        }

        sealed class LoggedBehaviour : PlayableBehaviour
        {
            public override void OnPlayableCreate(Playable playable) => calls.Add("create clip");
            public override void OnPlayableDestroy(Playable playable) => calls.Add("destroy clip");
            public override void PrepareFrame(Playable playable, FrameData info) => calls.Add("prepare clip");

            public override void ProcessFrame(Playable playable, FrameData info, object playerData)
                => calls.Add($"process clip {Text(playable.GetTime())} {((Transform)playerData).name}");
        }
    }
}
