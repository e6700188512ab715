using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>The heights of whole terrains, once for all that use them.</summary>
    static class SharedTerrainHeights
    {
        struct Shared
        {
            public TerrainHeights heights;
            public int users;
        }

        static Dictionary<TerrainData, Shared> all = new Dictionary<TerrainData, Shared>();

        /// <summary>Terrains whose heights somebody uses.</summary>
        public static int Count => all.Count;

        /// <summary>Uses a terrain until <see cref="Release"/>. Its heights are read when they are asked for.</summary>
        public static void Use(TerrainData data)
        {
            all.TryGetValue(data, out Shared shared);
            shared.users++;
            all[data] = shared;
        }

        /// <summary>The heights as they are now, of a terrain that is in use; those from before an edit are gone.</summary>
        public static TerrainHeights Of(TerrainData data)
        {
            all.TryGetValue(data, out Shared shared);
            if (shared.heights != null && !shared.heights.IsStale)
                return shared.heights;
            shared.heights?.Dispose();
            shared.heights = new TerrainHeights(data, new Rect(0f, 0f, 1f, 1f));
            all[data] = shared;
            return shared.heights;
        }

        public static void Release(TerrainData data)
        {
            if (!all.TryGetValue(data, out Shared shared))
                return;
            if (--shared.users > 0)
            {
                all[data] = shared;
                return;
            }
            shared.heights?.Dispose();
            all.Remove(data);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset()
        {
            foreach (Shared shared in all.Values)
                shared.heights?.Dispose();
            all = new Dictionary<TerrainData, Shared>();
        }
    }
}
