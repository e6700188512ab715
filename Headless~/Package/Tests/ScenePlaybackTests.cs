using System.IO;
using System.Linq;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Playables;
using UnityEngine.Rendering;
using UnityEngine.Timeline;

namespace Host.Tests
{
    /// <summary>A recording without Play: Simulate shows it, and a Timeline scrubs it.</summary>
    public sealed class ScenePlaybackTests : GraphicsFixture
    {
        const double Frame = 1.0 / 60.0;

        string file;

        [SetUp]
        public void NameFile() => file = Path.Combine(Path.GetTempPath(), $"rill-scene-playback-{System.Guid.NewGuid():N}.rillrec");

        [TearDown]
        public void StopSimulation()
        {
            SceneSimulation.Stop();
            File.Delete(file);
        }

        [Test]
        public void Simulate_shows_the_recording_and_a_timeline_scrubs_it_without_Play()
        {
            RecordInPlayMode();
            var scene = new EditModeScene();
            FluidPlayback playback = Add(scene);
            PlayableDirector director = Stage(playback);
            director.time = 3 * Frame;
            director.Evaluate();
            Assert.That((playback.IsOpen, playback.IsDriven), Is.EqualTo((false, false)), "nothing runs yet");
            var clip = (FluidPlaybackClip)((TimelineAsset)director.playableAsset).GetOutputTracks().Single().GetClips().Single().asset;
            Assert.That(clip.duration, Is.EqualTo(5 * Frame).Within(1e-4), "found in the file");

            scene.Simulate();
            EditModeScene.Step(2);
            Assert.That((playback.ShownFrame, scene.Fluid.IsPlayedBack), Is.EqualTo((2, true)), "it plays");
            foreach (int frame in new[] { 4, 1, 5 })
            {
                director.time = frame * Frame;
                director.Evaluate();
                EditModeScene.Step(1);
                Assert.That((playback.ShownFrame, playback.IsDriven), Is.EqualTo((frame, true)));
            }
            director.time = 0.0;
            director.Evaluate();
            director.Stop();
            EditModeScene.Step(2);
            Assert.That((playback.ShownFrame, playback.IsDriven), Is.EqualTo((2, false)), "it plays on");
            SceneSimulation.Stop();
            Assert.That((playback.IsOpen, playback.enabled), Is.EqualTo((false, true)));
            Assert.That(Logged, Is.Empty);
        }

        [Test]
        public void A_clip_without_a_file_to_look_into_has_no_length_and_nothing_is_said()
        {
            var scene = new EditModeScene();
            FluidPlayback playback = Add(scene);
            PlayableDirector director = Stage(playback);
            director.Evaluate();
            var clip = (FluidPlaybackClip)((TimelineAsset)director.playableAsset).GetOutputTracks().Single().GetClips().Single().asset;
            Assert.That(clip.duration, Is.EqualTo(double.PositiveInfinity));
            Assert.That(Logged, Is.Empty);
        }

        void RecordInPlayMode()
        {
            var scene = new EditModeScene(plays: true);
            FluidRecorder recorder = scene.Fluid.gameObject.AddComponent<FluidRecorder>();
            recorder.Record(file);
            for (int i = 0; i < 6; i++)
            {
                EditModeScene.Play(1);
                AsyncGPUReadback.WaitAllRequests();
            }
            recorder.enabled = false;
            Assert.That(recorder.Problem, Is.Null);
            PlayerLoop.Reset();
        }

        FluidPlayback Add(EditModeScene scene)
        {
            var playback = scene.Fluid.gameObject.AddComponent<FluidPlayback>();
            playback.Recording = file;
            playback.WaitForFrames = true;
            return playback;
        }

        static PlayableDirector Stage(FluidPlayback playback)
        {
            var timeline = ScriptableObject.CreateInstance<TimelineAsset>();
            FluidPlaybackTrack track = timeline.CreateTrack<FluidPlaybackTrack>("Water");
            track.CreateClip<FluidPlaybackClip>().duration = 1.0;
            PlayableDirector director = new GameObject("Stage").AddComponent<PlayableDirector>();
            director.playableAsset = timeline;
            director.SetGenericBinding(track, playback);
            return director;
        }
    }
}
