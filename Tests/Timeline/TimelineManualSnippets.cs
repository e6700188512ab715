using NUnit.Framework;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace Rill.Tests
{
    /// <summary>The snippets of the manual that need Timeline, as in ManualSnippets.</summary>
    public class TimelineManualSnippets
    {
        static void PlayOnATimeline(PlayableDirector director, FluidPlayback playback)
        {
            #region Play a recording on a Timeline
            var timeline = ScriptableObject.CreateInstance<TimelineAsset>();
            var track = timeline.CreateTrack<FluidPlaybackTrack>("Water");
            TimelineClip clip = track.CreateClip<FluidPlaybackClip>();
            clip.start = 1.0;                               // s of the timeline
            clip.duration = 2.0;
            ((FluidPlaybackClip)clip.asset).Begin = 0.1;    // s of the recording
            director.playableAsset = timeline;
            director.SetGenericBinding(track, playback);    // a Fluid Playback that has a file open
            director.Play();
            #endregion
        }

        [Test]
        public void The_snippet_of_the_manual_shows_the_recording_at_the_times_of_its_clip()
        {
            var stage = new GameObject("Stage");
            try
            {
                using (RecordedWater water = new RecordedWater().Run(16))
                using (SourceScene scene = RecordedWater.MakeScene())
                {
                    FluidPlayback playback = RecordedWater.Play(scene, water.End());
                    var director = stage.AddComponent<PlayableDirector>();
                    PlayOnATimeline(director, playback);
                    director.time = 1.05;
                    director.Evaluate();
                    Assert.That(playback.Time, Is.EqualTo(0.15).Within(1e-9));
                    Object.DestroyImmediate(director.playableAsset);
                }
            }
            finally
            {
                Object.DestroyImmediate(stage);
            }
        }
    }
}
