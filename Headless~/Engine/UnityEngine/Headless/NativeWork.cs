using System;

namespace UnityEngine.Headless
{
    /// <summary>
    /// Managed memory that this host takes for what Unity does in native code. It is none of the script's garbage, and is
    /// left out where that is measured.
    /// </summary>
    internal static class NativeWork
    {
        [ThreadStatic] static int depth;
        [ThreadStatic] static long bytes, before;

        /// <summary>Bytes that scripts allocated on this thread since it began.</summary>
        public static long ScriptBytes => GC.GetAllocatedBytesForCurrentThread() - bytes;

        public static Scope Enter()
        {
            if (depth++ == 0)
                before = GC.GetAllocatedBytesForCurrentThread();
            return default;
        }

        public readonly struct Scope : IDisposable
        {
            public void Dispose()
            {
                if (--depth == 0)
                    bytes += GC.GetAllocatedBytesForCurrentThread() - before;
            }
        }
    }
}
