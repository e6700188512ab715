using System;
using System.Linq;

namespace UnityEngine.Playables
{
    public struct PlayableGraph
    {
        readonly GraphState state;

        internal PlayableGraph(GraphState state) => this.state = state;

        internal GraphState Valid => IsValid() ? state : throw new NullReferenceException("The PlayableGraph is null or destroyed.");

        public static PlayableGraph Create() => new PlayableGraph(new GraphState());

        public bool IsValid() => state != null && !state.IsDestroyed;

        public void Destroy() => Valid.Destroy();

        public int GetPlayableCount() => Valid.Playables.Count;

        public int GetRootPlayableCount() => Valid.Roots.Count();

        public Playable GetRootPlayable(int index) => new Playable(Valid.Roots.ElementAtOrDefault(index));

        public bool Connect<U, V>(U source, int sourceOutputPort, V destination, int destinationInputPort)
            where U : struct, IPlayable where V : struct, IPlayable
        {
            PlayableNode from = PlayableHandle.Valid(source), to = PlayableHandle.Valid(destination);
            if (destinationInputPort >= to.Inputs.Count || to.Inputs[destinationInputPort].playable != null || from.Output != null)
                return false;
            to.Inputs[destinationInputPort] = (from, to.Inputs[destinationInputPort].weight);
            from.Output = to;
            return true;
        }
    }

    public interface IPlayableOutput
    {
        PlayableOutputHandle GetHandle();
    }

    public struct PlayableOutputHandle
    {
        internal readonly ScriptOutput Output;

        internal PlayableOutputHandle(ScriptOutput output) => Output = output;
    }

    public struct ScriptPlayableOutput : IPlayableOutput
    {
        readonly PlayableOutputHandle handle;

        ScriptPlayableOutput(ScriptOutput output) => handle = new PlayableOutputHandle(output);

        public static ScriptPlayableOutput Create(PlayableGraph graph, string name)
        {
            var output = new ScriptOutput();
            graph.Valid.Outputs.Add(output);
            return new ScriptPlayableOutput(output);
        }

        public PlayableOutputHandle GetHandle() => handle;
    }

    public static class PlayableOutputExtensions
    {
        public static void SetReferenceObject<U>(this U output, Object value) where U : struct, IPlayableOutput
            => output.GetHandle().Output.ReferenceObject = value;

        /// <summary>Sets the argument of ProcessFrame; a director sets it to what is bound.</summary>
        public static void SetUserData<U>(this U output, Object value) where U : struct, IPlayableOutput
            => output.GetHandle().Output.UserData = value;

        public static void SetSourcePlayable<U, V>(this U output, V value, int port)
            where U : struct, IPlayableOutput where V : struct, IPlayable
        {
            output.GetHandle().Output.Source = PlayableHandle.Valid(value);
            output.GetHandle().Output.Port = port;
        }
    }
}
