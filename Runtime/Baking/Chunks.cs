using System;
using System.Threading.Tasks;

namespace Rill
{
    /// <summary>Loops over many items on all cores. The chunks are the same on every machine, and with them the sums of their sums.</summary>
    static class Chunks
    {
        const int Size = 1 << 14;

        public static int Of(int items) => (items + Size - 1) / Size;

        /// <param name="work">The chunk, its first item and the one after its last.</param>
        public static void Run(int items, Action<int, int, int> work)
        {
            void One(int chunk) => work(chunk, chunk * Size, Math.Min(items, (chunk + 1) * Size));
            int chunks = Of(items);
            if (chunks > 1 && HasThreads)
                Parallel.For(0, chunks, One);
            else
                for (int chunk = 0; chunk < chunks; chunk++)
                    One(chunk);
        }

        /// <summary>Side by side where there are threads.</summary>
        public static void Together(params Action[] works)
        {
            if (HasThreads)
                Parallel.Invoke(works);
            else
                foreach (Action work in works)
                    work();
        }

        // A browser tells one core, and waiting for a thread would hang there.
        static bool HasThreads => Environment.ProcessorCount > 1;
    }
}
