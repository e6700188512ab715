using System;
using System.Collections.Generic;

namespace UnityEngine.Playables
{
    /// <summary>State behind the handle of a playable.</summary>
    internal sealed class PlayableNode
    {
        public readonly GraphState Graph;
        public readonly IPlayableBehaviour Behaviour;       // null for one without a script
        public readonly List<(PlayableNode playable, float weight)> Inputs = new List<(PlayableNode, float)>();
        public PlayableNode Output;     // null for a root
        public double Time, Duration = double.MaxValue, Speed = 1.0;
        public bool IsPlaying = true, PropagatesSetTime, IsPassthrough, IsDestroyed;

        public PlayableNode(GraphState graph, IPlayableBehaviour behavior, int inputs)
        {
            Graph = graph;
            Behaviour = behavior;
            SetInputCount(inputs);
            graph.Playables.Add(this);
        }

        public void SetInputCount(int count)
        {
            while (Inputs.Count < count)
                Inputs.Add((null, 0f));
            Inputs.RemoveRange(count, Inputs.Count - count);
        }

        public void SetTime(double time)
        {
            Time = time;
            if (!PropagatesSetTime)
                return;
            foreach ((PlayableNode input, _) in Inputs)
                input?.SetTime(time);
        }

        /// <summary>Time goes on and PrepareFrame is called from the root down, where it plays.</summary>
        public void Prepare(float deltaTime)
        {
            if (!IsPlaying)
                return;
            Time += deltaTime * Speed;
            Behaviour?.PrepareFrame(new Playable(this), new FrameData(deltaTime));
            foreach ((PlayableNode input, _) in Inputs)
                input?.Prepare(deltaTime);
        }

        /// <summary>ProcessFrame is called for an output from its inputs up to its source.</summary>
        public void Process(float deltaTime, object playerData)
        {
            if (!IsPlaying)
                return;
            foreach ((PlayableNode input, float weight) in Inputs)
                if (weight > 0f)
                    input?.Process(deltaTime, playerData);
            Behaviour?.ProcessFrame(new Playable(this), new FrameData(deltaTime), playerData);
        }
    }

    /// <summary>State behind the handle of a graph.</summary>
    internal sealed class GraphState
    {
        public readonly List<PlayableNode> Playables = new List<PlayableNode>();
        public readonly List<ScriptOutput> Outputs = new List<ScriptOutput>();
        public bool IsDestroyed;

        public IEnumerable<PlayableNode> Roots => Playables.FindAll(playable => playable.Output == null);

        public void Destroy()
        {
            if (IsDestroyed)
                return;
            IsDestroyed = true;
            foreach (PlayableNode playable in Playables.ToArray())
            {
                playable.IsDestroyed = true;
                try
                {
                    playable.Behaviour?.OnPlayableDestroy(new Playable(playable));
                }
                catch (Exception e)
                {
                    Debug.LogException(e);
                }
            }
        }
    }

    /// <summary>State behind the handle of an output of a script's playables.</summary>
    internal sealed class ScriptOutput
    {
        public Object ReferenceObject, UserData;
        public PlayableNode Source;
        public int Port;
    }
}
