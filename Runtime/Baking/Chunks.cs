using System;

namespace Rill
{
    /// <summary>Loops over many items on all cores. The chunks are the same on every machine, and with them sums of their sums.</summary>
    static class Chunks
    {
        public const int Size = 1 << 14;

        public static int Of(int items) => (items + Size - 1) / Size;

        /// <param name="work">The chunk, its first item and the one behind its last.</param>
        public static void Run(int items, Action<int, int, int> work)
        {
            int chunks = Of(items);
            Parallel(chunks, chunk => work(chunk, chunk * Size, Math.Min(items, (chunk + 1) * Size)));
        }

        static void Parallel(int count, Action<int> work)
        {
#if UNITY_WEBGL && !UNITY_EDITOR
            for (int i = 0; i < count; i++)
                work(i);
#else
            if (count == 1)
                work(0);
            else
                System.Threading.Tasks.Parallel.For(0, count, work);
#endif
        }

        /// <summary>Side by side where there are threads.</summary>
        public static void Together(params Action[] works)
        {
#if UNITY_WEBGL && !UNITY_EDITOR
            foreach (Action work in works)
                work();
#else
            System.Threading.Tasks.Parallel.Invoke(works);
#endif
        }
    }
}
