namespace Rill
{
    /// <summary>Numbers in sets that are joined: each number knows one above it in its set, and the least is the set's root.</summary>
    static class DisjointSets
    {
        public static int[] Of(int count)
        {
            var above = new int[count];
            for (int i = 0; i < count; i++)
                above[i] = i;
            return above;
        }

        public static int Root(int[] above, int i)
        {
            while (above[i] != i)
                i = above[i] = above[above[i]];
            return i;
        }

        /// <returns>Whether they were apart.</returns>
        public static bool Join(int[] above, int a, int b)
        {
            a = Root(above, a);
            b = Root(above, b);
            if (a < b)
                above[b] = a;
            else
                above[a] = b;
            return a != b;
        }
    }
}
