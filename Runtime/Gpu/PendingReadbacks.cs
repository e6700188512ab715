using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Readbacks whose owners are gone while a request was pending. They go when it comes back, or all at once where none will: as
    /// play ends and before scripts are loaded again.</summary>
    static class PendingReadbacks
    {
        static List<Readback> items = new List<Readback>();
        static bool ending;

        /// <summary>How many there are.</summary>
        public static int Count => items.Count;

        public static void Add(Readback readback)
        {
            items.Add(readback);
            if (ending)
                readback.Complete();
        }

        public static void Remove(Readback readback) => items.Remove(readback);

        /// <summary>Waits for all of these, and from now on for each that is added.</summary>
        public static void End()
        {
            ending = true;
            for (int i = items.Count - 1; i >= 0; i--)
                items[i].Complete();
            SnapshotCapture.End();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void Begin()
        {
            End();
            items = new List<Readback>();
            ending = false;
            Application.quitting -= End;
            Application.quitting += End;
        }
    }
}
