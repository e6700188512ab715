using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Buffers that a pending request reads. Their owners may give them up meanwhile: they are released with the last request.</summary>
    /// <remarks>Whether Unity brings back a buffer that is gone it does not say.</remarks>
    static class HeldBuffers
    {
        static List<GraphicsBuffer> held = new List<GraphicsBuffer>();      // once for each request
        static List<GraphicsBuffer> released = new List<GraphicsBuffer>();

        public static void Hold(GraphicsBuffer buffer) => held.Add(buffer);

        /// <summary>Takes one <see cref="Hold"/> back.</summary>
        public static void LetGo(GraphicsBuffer buffer)
        {
            held.Remove(buffer);
            if (!held.Contains(buffer) && released.Remove(buffer))
                buffer.Release();
        }

        /// <summary>Called by the owner, which gives the buffer up.</summary>
        /// <returns>Whether it is held, so that it is released later.</returns>
        public static bool Keep(GraphicsBuffer buffer)
        {
            if (!held.Contains(buffer))
                return false;
            released.Add(buffer);
            return true;
        }

        // After those of PendingReadbacks have ended.
        internal static void Begin()
        {
            held = new List<GraphicsBuffer>();
            released = new List<GraphicsBuffer>();
        }
    }
}
