using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>The heights of whole terrains, once for all that use them.</summary>
    static class TerrainHeightsCache
    {
        struct Entry
        {
            public TerrainHeights heights;
            public int users;
        }

        static Dictionary<TerrainData, Entry> all = new Dictionary<TerrainData, Entry>();

        /// <summary>Terrains whose heights somebody uses.</summary>
        public static int Count => all.Count;

        /// <summary>Uses a terrain until <see cref="Release"/>. Its heights are read when they are asked for.</summary>
        public static void Use(TerrainData data)
        {
            all.TryGetValue(data, out Entry entry);
            entry.users++;
            all[data] = entry;
        }

        /// <summary>The heights as they are now, of a terrain that is in use; those from before an edit are gone.</summary>
        public static TerrainHeights Of(TerrainData data)
        {
            all.TryGetValue(data, out Entry entry);
            if (entry.heights != null && !entry.heights.IsStale)
                return entry.heights;
            entry.heights?.Dispose();
            entry.heights = new TerrainHeights(data, new Rect(0f, 0f, 1f, 1f));
            all[data] = entry;
            return entry.heights;
        }

        public static void Release(TerrainData data)
        {
            if (!all.TryGetValue(data, out Entry entry))
                return;
            if (--entry.users > 0)
            {
                all[data] = entry;
                return;
            }
            entry.heights?.Dispose();
            all.Remove(data);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset()
        {
            foreach (Entry entry in all.Values)
                entry.heights?.Dispose();
            all = new Dictionary<TerrainData, Entry>();
        }
    }
}
