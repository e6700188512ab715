using System;
using System.Collections.Generic;

namespace UnityEngine.Playables
{
    public interface IPlayableAsset
    {
        Playable CreatePlayable(PlayableGraph graph, GameObject owner);
        double duration { get; }
    }

    public abstract class PlayableAsset : ScriptableObject, IPlayableAsset
    {
        public abstract Playable CreatePlayable(PlayableGraph graph, GameObject owner);
        public virtual double duration => PlayableBinding.DefaultDuration;
    }

    public struct PlayableBinding
    {
        public static readonly double DefaultDuration = double.PositiveInfinity;
    }

    public interface IPlayableBehaviour
    {
        void OnPlayableCreate(Playable playable);
        void OnPlayableDestroy(Playable playable);
        void PrepareFrame(Playable playable, FrameData info);
        void ProcessFrame(Playable playable, FrameData info, object playerData);
    }

    /// <summary>Members that the host calls: it does not tell that a graph or a playable starts or stops.</summary>
    public abstract class PlayableBehaviour : IPlayableBehaviour, ICloneable
    {
        public PlayableBehaviour() { }

        public virtual void OnPlayableCreate(Playable playable) { }
        public virtual void OnPlayableDestroy(Playable playable) { }
        public virtual void PrepareFrame(Playable playable, FrameData info) { }
        public virtual void ProcessFrame(Playable playable, FrameData info, object playerData) { }
        public virtual object Clone() => MemberwiseClone();
    }

    public struct FrameData
    {
        internal FrameData(float deltaTime) => this.deltaTime = deltaTime;

        public float deltaTime { get; }
    }
}
