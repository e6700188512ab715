using System;

namespace Rill
{
    /// <summary>The delegates of an event, to be called one by one. Those that come and go while they are called count from the next time
    /// on.</summary>
    struct Delegates<T> where T : Delegate
    {
        [NonSerialized] T[] all;        // another array after each change

        /// <summary>In the order in which they were added.</summary>
        public T[] All => all ?? Array.Empty<T>();

        public bool IsEmpty => All.Length == 0;

        /// <param name="added">Null adds none.</param>
        public void Add(T added)
        {
            if (added == null)
                return;
            var more = new T[All.Length + 1];
            All.CopyTo(more, 0);
            more[All.Length] = added;
            all = more;
        }

        /// <summary>Removes the one that was added last of those that are equal; none where there is none.</summary>
        public void Remove(T removed)
        {
            int index = Array.LastIndexOf(All, removed);
            if (index < 0)
                return;
            var fewer = new T[all.Length - 1];
            Array.Copy(all, 0, fewer, 0, index);
            Array.Copy(all, index + 1, fewer, index, fewer.Length - index);
            all = fewer;
        }
    }
}
