using System;

namespace UnityEngine.Playables
{
    public interface IPlayable
    {
        PlayableHandle GetHandle();
    }

    public struct PlayableHandle : IEquatable<PlayableHandle>
    {
        internal readonly PlayableNode Node;

        internal PlayableHandle(PlayableNode node) => Node = node;

        public static PlayableHandle Null => default;

        public bool Equals(PlayableHandle other) => Node == other.Node;
        public override bool Equals(object p) => p is PlayableHandle other && Equals(other);
        public override int GetHashCode() => Node?.GetHashCode() ?? 0;
        public static bool operator ==(PlayableHandle x, PlayableHandle y) => x.Equals(y);
        public static bool operator !=(PlayableHandle x, PlayableHandle y) => !x.Equals(y);

        internal static PlayableNode Valid<U>(U playable) where U : struct, IPlayable
        {
            PlayableNode node = playable.GetHandle().Node;
            return node != null && !node.IsDestroyed ? node : throw new NullReferenceException("The PlayableHandle is null or destroyed.");
        }
    }

    public struct Playable : IPlayable, IEquatable<Playable>
    {
        readonly PlayableHandle handle;

        internal Playable(PlayableNode node) => handle = new PlayableHandle(node);

        public static Playable Null => default;

        public static Playable Create(PlayableGraph graph, int inputCount = 0)
            => new Playable(new PlayableNode(graph.Valid, null, inputCount));

        public PlayableHandle GetHandle() => handle;
        public bool Equals(Playable other) => handle == other.handle;
    }

    public struct ScriptPlayable<T> : IPlayable, IEquatable<ScriptPlayable<T>> where T : class, IPlayableBehaviour, new()
    {
        readonly PlayableHandle handle;

        ScriptPlayable(PlayableHandle handle) => this.handle = handle;

        public static ScriptPlayable<T> Null => default;

        public static ScriptPlayable<T> Create(PlayableGraph graph, int inputCount = 0)
        {
            var node = new PlayableNode(graph.Valid, new T(), inputCount);
            node.Behaviour.OnPlayableCreate(new Playable(node));
            return new ScriptPlayable<T>(new PlayableHandle(node));
        }

        public PlayableHandle GetHandle() => handle;
        public T GetBehaviour() => (T)PlayableHandle.Valid(this).Behaviour;
        public bool Equals(ScriptPlayable<T> other) => handle == other.handle;

        public static implicit operator Playable(ScriptPlayable<T> playable) => new Playable(playable.handle.Node);

        public static explicit operator ScriptPlayable<T>(Playable playable)
        {
            PlayableNode node = playable.GetHandle().Node;
            if (node != null && !(node.Behaviour is T))
                throw new InvalidCastException($"Incompatible handle: Trying to assign a playable data of type " +
                    $"`{node.Behaviour?.GetType()}` that is not compatible with the PlayableBehaviour of type `{typeof(T)}`.");
            return new ScriptPlayable<T>(playable.GetHandle());
        }
    }

    public static class PlayableExtensions
    {
        public static bool IsNull<U>(this U playable) where U : struct, IPlayable => playable.GetHandle().Node == null;

        public static bool IsValid<U>(this U playable) where U : struct, IPlayable
            => playable.GetHandle().Node is PlayableNode node && !node.IsDestroyed;

        public static PlayableGraph GetGraph<U>(this U playable) where U : struct, IPlayable
            => new PlayableGraph(PlayableHandle.Valid(playable).Graph);

        public static PlayState GetPlayState<U>(this U playable) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).IsPlaying ? PlayState.Playing : PlayState.Paused;

        public static void Play<U>(this U playable) where U : struct, IPlayable => PlayableHandle.Valid(playable).IsPlaying = true;
        public static void Pause<U>(this U playable) where U : struct, IPlayable => PlayableHandle.Valid(playable).IsPlaying = false;

        public static double GetTime<U>(this U playable) where U : struct, IPlayable => PlayableHandle.Valid(playable).Time;
        public static void SetTime<U>(this U playable, double value) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).SetTime(value);
        public static double GetDuration<U>(this U playable) where U : struct, IPlayable => PlayableHandle.Valid(playable).Duration;
        public static void SetDuration<U>(this U playable, double value) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).Duration = value;
        public static double GetSpeed<U>(this U playable) where U : struct, IPlayable => PlayableHandle.Valid(playable).Speed;
        public static void SetSpeed<U>(this U playable, double value) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).Speed = value;

        public static void SetPropagateSetTime<U>(this U playable, bool value) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).PropagatesSetTime = value;

        public static void SetTraversalMode<U>(this U playable, PlayableTraversalMode mode) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).IsPassthrough = mode == PlayableTraversalMode.Passthrough;

        public static int GetInputCount<U>(this U playable) where U : struct, IPlayable => PlayableHandle.Valid(playable).Inputs.Count;
        public static void SetInputCount<U>(this U playable, int value) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).SetInputCount(value);

        public static Playable GetInput<U>(this U playable, int inputPort) where U : struct, IPlayable
            => new Playable(PlayableHandle.Valid(playable).Inputs[inputPort].playable);

        public static float GetInputWeight<U>(this U playable, int inputIndex) where U : struct, IPlayable
            => PlayableHandle.Valid(playable).Inputs[inputIndex].weight;

        public static void SetInputWeight<U>(this U playable, int inputIndex, float weight) where U : struct, IPlayable
        {
            PlayableNode node = PlayableHandle.Valid(playable);
            node.Inputs[inputIndex] = (node.Inputs[inputIndex].playable, weight);
        }
    }

    public enum PlayState
    {
        Paused = 0,
        Playing = 1,
    }

    public enum PlayableTraversalMode
    {
        Mix = 0,
        Passthrough = 1,
    }
}
