using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;

namespace UnityEngine.Headless
{
    /// <summary>Objects that hold GPU or native memory and were not released: the proof that nothing leaks.</summary>
    internal static class LiveObjects
    {
        struct Entry { public object Object; public string Kind, Name; public long Order; }

        sealed class ByIdentity : IEqualityComparer<object>
        {
            bool IEqualityComparer<object>.Equals(object a, object b) => ReferenceEquals(a, b);
            int IEqualityComparer<object>.GetHashCode(object o) => RuntimeHelpers.GetHashCode(o);
        }

        static readonly Dictionary<object, Entry> alive = new Dictionary<object, Entry>(new ByIdentity());
        static long added;

        /// <summary>Again with another name renames it.</summary>
        public static void Add(object o, string kind, string name)
        {
            lock (alive)
            {
                long order = alive.TryGetValue(o, out Entry known) ? known.Order : ++added;
                alive[o] = new Entry { Object = o, Kind = kind, Name = name, Order = order };
            }
        }

        /// <summary>Twice is harmless.</summary>
        public static void Remove(object o)
        {
            lock (alive)
                alive.Remove(o);
        }

        public static int Count
        {
            get { lock (alive) return alive.Count; }
        }

        /// <summary>"kind 'name'" of each, oldest first; compare two reports to see what stayed in between.</summary>
        public static List<string> Report()
        {
            lock (alive)
                return alive.Values.OrderBy(e => e.Order).Select(e => $"{e.Kind} '{e.Name}'").ToList();
        }
    }
}
