using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Playables;

namespace UnityEngine.Timeline
{
    /// <summary>Tracks side by side, as long as their clips: no groups, no sub-tracks, no markers.</summary>
    public class TimelineAsset : PlayableAsset
    {
        const double Tick = 1e-12;      // s: a timeline ends one before its last clip, so that a clip is there at its end

        readonly List<TrackAsset> tracks = new List<TrackAsset>();

        public override double duration
        {
            get
            {
                double end = tracks.Where(track => !track.muted).SelectMany(track => track.GetClips()).Select(clip => clip.end)
                    .DefaultIfEmpty(0.0).Max();
                return Math.Max(end - Tick, 0.0);
            }
        }

        public IEnumerable<TrackAsset> GetOutputTracks() => tracks.ToArray();

        public T CreateTrack<T>(string trackName) where T : TrackAsset, new()
        {
            T track = CreateInstance<T>();
            track.name = trackName;
            tracks.Add(track);
            return track;
        }

        public override Playable CreatePlayable(PlayableGraph graph, GameObject go)
        {
            var root = ScriptPlayable<TimelinePlayable>.Create(graph);
            root.SetTraversalMode(PlayableTraversalMode.Passthrough);
            foreach (TrackAsset track in tracks.Where(track => !track.muted && track.GetClips().Any()))
            {
                Playable mixer = track.Compile(graph, go, root.GetBehaviour().Clips);
                int port = root.GetInputCount();
                root.SetInputCount(port + 1);
                graph.Connect(mixer, 0, root, port);
                root.SetInputWeight(port, 1f);
                ScriptPlayableOutput output = ScriptPlayableOutput.Create(graph, track.name);
                output.SetReferenceObject(track);
                output.SetSourcePlayable(root, port);
            }
            root.SetPropagateSetTime(true);
            return root;
        }
    }

    /// <summary>Gives each clip its weight and its local time.</summary>
    internal sealed class TimelinePlayable : PlayableBehaviour
    {
        public readonly List<RuntimeClip> Clips = new List<RuntimeClip>();

        readonly HashSet<RuntimeClip> active = new HashSet<RuntimeClip>();

        public override void PrepareFrame(Playable playable, FrameData info)
        {
            double time = playable.GetTime();
            foreach (RuntimeClip one in Clips)
                if (!IsWithin(one.clip, time) && active.Remove(one))
                    Hide(one, time);
            foreach (RuntimeClip one in Clips)
                if (IsWithin(one.clip, time))
                    Show(one, time);
        }

        static bool IsWithin(TimelineClip clip, double time) => clip.start <= time && time < clip.end;

        void Show(RuntimeClip one, double time)
        {
            active.Add(one);
            one.playable.Play();
            one.mixer.SetInputWeight(one.input, 1f);
            one.playable.SetTime(one.clip.ToLocalTime(time));
        }

        static void Hide(RuntimeClip one, double time)
        {
            double local = one.clip.ToLocalTime(Math.Min(time, one.clip.end));
            if (local >= 0.0)
                one.playable.SetTime(local);
            one.playable.Pause();
            one.mixer.SetInputWeight(one.input, 0f);
        }
    }
}
