using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Playables;

namespace UnityEngine.Timeline
{
    public abstract class TrackAsset : PlayableAsset
    {
        readonly List<TimelineClip> clips = new List<TimelineClip>();

        public bool muted { get; set; }

        public sealed override double duration => clips.Count > 0 ? clips.Max(clip => clip.end) - clips.Min(clip => clip.start) : 0.0;

        public IEnumerable<TimelineClip> GetClips() => clips.ToArray();

        public sealed override Playable CreatePlayable(PlayableGraph graph, GameObject go) => Playable.Null;

        public virtual Playable CreateTrackMixer(PlayableGraph graph, GameObject go, int inputCount) => Playable.Create(graph, inputCount);

        /// <summary>A clip at 0, as long as its asset where that has an end, else 5 s.</summary>
        public TimelineClip CreateClip<T>() where T : ScriptableObject, IPlayableAsset
        {
            if (!GetType().GetCustomAttributes(typeof(TrackClipTypeAttribute), true).Cast<TrackClipTypeAttribute>()
                .Any(attribute => attribute.inspectedType.IsAssignableFrom(typeof(T))))
                throw new InvalidOperationException("Clips of type " + typeof(T) + " are not permitted on tracks of type " + GetType());
            T asset = CreateInstance<T>();
            asset.name = typeof(T).Name;
            var clip = new TimelineClip { asset = asset, displayName = asset.name };
            if (!double.IsInfinity(asset.duration) && asset.duration > 0.0)
                clip.duration = asset.duration;
            clips.Add(clip);
            return clip;
        }

        protected virtual Playable CreatePlayable(PlayableGraph graph, GameObject gameObject, TimelineClip clip)
        {
            if (!(clip.asset is IPlayableAsset asset))
                return Playable.Null;
            Playable playable = asset.CreatePlayable(graph, gameObject);
            if (playable.IsValid())
                playable.SetSpeed(clip.timeScale);
            return playable;
        }

        /// <summary>The mixer with the playables of all clips as its inputs, of weight 0.</summary>
        internal Playable Compile(PlayableGraph graph, GameObject go, List<RuntimeClip> all)
        {
            TimelineClip[] sorted = clips.OrderBy(clip => clip.start).ToArray();
            Playable mixer = CreateTrackMixer(graph, go, sorted.Length);
            for (int i = 0; i < sorted.Length; i++)
            {
                Playable source = CreatePlayable(graph, go, sorted[i]);
                if (!source.IsValid())
                    continue;
                source.SetDuration(sorted[i].duration);
                source.Pause();
                graph.Connect(source, 0, mixer, i);
                all.Add(new RuntimeClip { clip = sorted[i], playable = source, mixer = mixer, input = i });
            }
            return mixer;
        }
    }

    internal sealed class RuntimeClip
    {
        public TimelineClip clip;
        public Playable playable, mixer;
        public int input;
    }
}
