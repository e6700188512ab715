using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Something that comes back from the GPU.</summary>
    interface IPendingReadback
    {
        /// <summary>Waits until it has come.</summary>
        void Complete();
    }

    /// <summary>Readbacks whose owners are gone while a request was pending. They go when it comes back, or all at once where none will: as
    /// play ends and before scripts are loaded again. Snapshots that are pending, and readbacks whose words a snapshot brought.</summary>
    static class PendingReadbacks
    {
        static List<IPendingReadback> items = new List<IPendingReadback>();
        static List<Readback> resumed = new List<Readback>();       // in the order of their requests
        static bool ending;

        // Buffers of snapshots that are pending, once for each, and those of them that their owners have given up: whether Unity brings back a
        // buffer that is gone it does not say, so they are released with the last snapshot.
        static List<GraphicsBuffer> held = new List<GraphicsBuffer>();
        static List<GraphicsBuffer> released = new List<GraphicsBuffer>();

        /// <summary>How many there are.</summary>
        public static int Count => items.Count;

        public static void Add(IPendingReadback readback)
        {
            items.Add(readback);
            if (ending)
                readback.Complete();
        }

        public static void Remove(IPendingReadback readback) => items.Remove(readback);

        /// <summary>Takes one whose words a snapshot brought, with the frame in which they come.</summary>
        public static void AddResumed(Readback readback) => resumed.Add(readback);

        public static void RemoveResumed(Readback readback) => resumed.Remove(readback);

        /// <summary>Hands over what was resumed and whose frame has come: called before results are read in a frame.</summary>
        public static void FinishResumed()
        {
            for (int i = 0; i < resumed.Count; i++)
                if (resumed[i].TryFinishResumed())
                    i = -1;         // listeners may have changed the list
        }

        /// <summary>Keeps a buffer until <see cref="LetGo"/>, whatever its owner does.</summary>
        public static void Hold(GraphicsBuffer buffer) => held.Add(buffer);

        /// <summary>Takes one <see cref="Hold"/> back.</summary>
        public static void LetGo(GraphicsBuffer buffer)
        {
            held.Remove(buffer);
            if (!held.Contains(buffer) && released.Remove(buffer))
                buffer.Release();
        }

        /// <summary>Called by the owner of a buffer, which gives it up.</summary>
        /// <returns>Whether it is held, so that it is released later.</returns>
        public static bool Takes(GraphicsBuffer buffer)
        {
            if (!held.Contains(buffer))
                return false;
            released.Add(buffer);
            return true;
        }

        /// <summary>Waits for all of these, and from now on for each that is added.</summary>
        public static void End()
        {
            ending = true;
            for (int i = items.Count - 1; i >= 0; i--)
                items[i].Complete();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void Begin()
        {
            End();
            items = new List<IPendingReadback>();
            resumed = new List<Readback>();
            held = new List<GraphicsBuffer>();
            released = new List<GraphicsBuffer>();
            ending = false;
            Application.quitting -= End;
            Application.quitting += End;
        }
    }
}
