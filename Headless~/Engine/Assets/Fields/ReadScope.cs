using System;
using System.Collections.Generic;
using System.Text;

namespace Host.Assets
{
    /// <summary>Says whose field is being read, for messages; kept as parts because most reads need no message.</summary>
    internal sealed class ReadScope
    {
        readonly Func<string> owner;
        readonly List<object> path = new List<object>();

        /// <param name="owner">For example "FluidEmitter on 'Tank/Emitter'".</param>
        public ReadScope(Func<string> owner) => this.owner = owner;

        public int Depth => path.Count;
        public void Enter(string field) => path.Add(field);
        public void Enter(int index) => path.Add(index);
        public void Leave() => path.RemoveAt(path.Count - 1);

        public override string ToString()
        {
            if (path.Count == 0) return owner();
            var text = new StringBuilder(owner()).Append(", field ");
            for (var i = 0; i < path.Count; i++)
                if (path[i] is int index) text.Append('[').Append(index).Append(']');
                else text.Append(i > 0 ? "." : "").Append(path[i]);
            return text.ToString();
        }
    }
}
