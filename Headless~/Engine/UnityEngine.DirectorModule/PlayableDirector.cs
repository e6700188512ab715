using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine.Playables
{
    /// <summary>
    /// Plays the graph of a playable asset. In an assembly of its own, for the package alone: scripts of other projects find the stub with
    /// all members of Unity's, which throws.
    /// </summary>
    /// <remarks>
    /// The graph is made with the first Play or Evaluate. In each frame of the game, between Update and LateUpdate as PreLateUpdate's
    /// DirectorUpdateAnimationBegin, time goes on: PrepareFrame from the root down, then for each output ProcessFrame with what is bound to
    /// its reference object. Stop destroys the graph and goes back to the initial time.
    /// </remarks>
    public class PlayableDirector : Behaviour
    {
        static readonly List<PlayableDirector> playing = new List<PlayableDirector>();

        static PlayableDirector() => PlayerLoop.PlayDirectors = AdvanceAll;

        readonly Dictionary<Object, Object> bindings = new Dictionary<Object, Object>();
        GraphState graph;
        PlayableAsset asset;
        double storedTime;
        bool isFirstFrame;

        public PlayableAsset playableAsset
        {
            get => asset;
            set
            {
                if (value == asset)
                    return;
                Stop();
                asset = value;
            }
        }

        public bool playOnAwake { get; set; } = true;

        public double initialTime { get; set; }

        public DirectorWrapMode extrapolationMode { get; set; } = DirectorWrapMode.None;

        public PlayState state { get; private set; }

        public PlayableGraph playableGraph => new PlayableGraph(graph);

        public double duration => asset != null ? asset.duration : 0.0;

        public double time
        {
            get => Root is PlayableNode root ? root.Time : storedTime;
            set
            {
                storedTime = value;
                Root?.SetTime(value);
            }
        }

        public event Action<PlayableDirector> stopped;

        public void SetGenericBinding(Object key, Object value)
        {
            if (key != null)
                bindings[key] = value;
        }

        public Object GetGenericBinding(Object key) => key != null && bindings.TryGetValue(key, out Object value) ? value : null;

        public void Play()
        {
            if (asset == null || !isActiveAndEnabled)
                return;
            if (graph == null)
                storedTime = initialTime;
            if (!HasGraph())
                return;
            isFirstFrame = state != PlayState.Playing;
            state = PlayState.Playing;
            if (!playing.Contains(this))
                playing.Add(this);
        }

        public void Pause()
        {
            state = PlayState.Paused;
            playing.Remove(this);
        }

        public void Stop()
        {
            Pause();
            if (graph == null)
                return;
            GraphState ended = graph;
            graph = null;
            storedTime = initialTime;
            ended.Destroy();
            stopped?.Invoke(this);
        }

        public void Evaluate()
        {
            if (asset != null && HasGraph())
                Evaluate(0f);
        }

        public void RebuildGraph()
        {
            double at = time;
            graph?.Destroy();
            graph = null;
            storedTime = at;
            if (asset != null)
                HasGraph();
        }

        internal override void OnActivated()
        {
            if (playOnAwake && !EditMode.IsOn)
                Play();
        }

        internal override void OnDeactivated() => Stop();

        PlayableNode Root => graph != null && graph.Playables.Count > 0 ? graph.Playables[0] : null;

        bool HasGraph()
        {
            if (graph != null)
                return true;
            var made = new GraphState();
            Playable root = asset.CreatePlayable(new PlayableGraph(made), gameObject);
            if (!root.IsValid())
                return false;
            graph = made;
            root.SetTime(storedTime);
            return true;
        }

        void Evaluate(float deltaTime)
        {
            GraphState evaluated = graph;
            foreach (PlayableNode root in evaluated.Roots)
                root.Prepare(deltaTime);
            foreach (ScriptOutput output in evaluated.Outputs)
            {
                PlayableNode source = output.Source.IsPassthrough ? output.Source.Inputs[output.Port].playable : output.Source;
                source?.Process(deltaTime, output.UserData != null ? output.UserData : GetGenericBinding(output.ReferenceObject));
            }
        }

        static void AdvanceAll()
        {
            foreach (PlayableDirector director in playing.ToArray())
                director.Advance(director.isFirstFrame ? 0f : Time.deltaTime);
        }

        void Advance(float deltaTime)
        {
            isFirstFrame = false;
            double end = duration;
            if (time + deltaTime < end)
            {
                Evaluate(deltaTime);
                return;
            }
            if (extrapolationMode == DirectorWrapMode.None)
            {
                Stop();
                return;
            }
            time = extrapolationMode == DirectorWrapMode.Loop && end > 0.0 ? (time + deltaTime) % end : end;
            Evaluate(0f);
        }
    }

    public enum DirectorWrapMode
    {
        Hold = 0,
        Loop = 1,
        None = 2,
    }
}
