using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>The command buffers that a camera or a light runs at events of the Built-in pipeline, in the order in which they were
    /// added.</summary>
    sealed class EventCommands<TEvent>
    {
        readonly Dictionary<TEvent, List<CommandBuffer>> lists = new Dictionary<TEvent, List<CommandBuffer>>();

        public int Count
        {
            get
            {
                int count = 0;
                foreach (List<CommandBuffer> list in lists.Values)
                    count += list.Count;
                return count;
            }
        }

        public void Add(TEvent evt, CommandBuffer buffer)
        {
            if (buffer == null)
                throw new ArgumentNullException(nameof(buffer));
            if (!lists.TryGetValue(evt, out List<CommandBuffer> list))
                lists.Add(evt, list = new List<CommandBuffer>());
            list.Add(buffer);
        }

        public void Remove(TEvent evt, CommandBuffer buffer)
        {
            if (lists.TryGetValue(evt, out List<CommandBuffer> list))
                list.RemoveAll(b => b == buffer);
        }

        public void RemoveAll(TEvent evt) => lists.Remove(evt);
        public void Clear() => lists.Clear();
        public CommandBuffer[] Of(TEvent evt) => lists.TryGetValue(evt, out List<CommandBuffer> list) ? list.ToArray() : Array.Empty<CommandBuffer>();

        public void Execute(TEvent evt)
        {
            if (!lists.TryGetValue(evt, out List<CommandBuffer> list))
                return;
            for (int i = 0; i < list.Count; i++)
                list[i].Execute();
        }
    }
}
