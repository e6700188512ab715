using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>The active scripts that have one of the update messages, in execution order.</summary>
    internal sealed class ScriptList
    {
        readonly Message message;
        readonly List<MonoBehaviour> scripts = new List<MonoBehaviour>();
        readonly List<MonoBehaviour> running = new List<MonoBehaviour>();

        public ScriptList(Message message) { this.message = message; }

        public void Add(MonoBehaviour script)
        {
            if (!Messages.Has(script.GetType(), message) || scripts.Contains(script))
                return;
            int order = ExecutionOrder.Of(script.GetType());
            int at = scripts.Count;
            while (at > 0 && ExecutionOrder.Of(scripts[at - 1].GetType()) > order)
                at--;
            scripts.Insert(at, script);
        }

        public void Remove(MonoBehaviour script) => scripts.Remove(script);
        public void Clear() => scripts.Clear();

        /// <summary>Scripts that join meanwhile wait for the next time; those that leave are skipped. Start comes before the first update.</summary>
        public void Run()
        {
            running.Clear();
            running.AddRange(scripts);
            foreach (MonoBehaviour script in running)
            {
                if (!script.Activated || script.Destroyed || !EditMode.Runs(script))
                    continue;
                if (!script.Started)
                    PlayerLoop.Start(script);
                if (script.Activated && !script.Destroyed)
                    Messages.Send(script, message);
            }
        }

        /// <summary>By execution order, keeping the order of equals.</summary>
        public static void Sort(List<MonoBehaviour> list)
        {
            for (int i = 1; i < list.Count; i++)
            {
                MonoBehaviour script = list[i];
                int order = ExecutionOrder.Of(script.GetType());
                int at = i;
                for (; at > 0 && ExecutionOrder.Of(list[at - 1].GetType()) > order; at--)
                    list[at] = list[at - 1];
                list[at] = script;
            }
        }
    }
}
