using System.Collections.Generic;
using Unity.Mathematics;

namespace Host.Report.Extremes
{
    /// <summary>Pairs of particles that lie nearer to each other than a fluid at rest would let them.</summary>
    static class ClosePairs
    {
        /// <param name="places">d.</param>
        /// <param name="distance">d.</param>
        public static int Count(float3[] positions, float distance)
        {
            var first = new Dictionary<int3, int>(positions.Length);
            var next = new int[positions.Length];
            int pairs = 0;
            for (int i = 0; i < positions.Length; i++)
            {
                int3 cell = (int3)math.floor(positions[i] / distance);
                for (int neighbor = 0; neighbor < 27; neighbor++)
                {
                    if (!first.TryGetValue(cell + new int3(neighbor % 3, neighbor / 3 % 3, neighbor / 9) - 1, out int other))
                        continue;
                    for (; other >= 0; other = next[other])
                        pairs += math.distancesq(positions[i], positions[other]) < distance * distance ? 1 : 0;
                }
                next[i] = first.TryGetValue(cell, out int head) ? head : -1;
                first[cell] = i;
            }
            return pairs;
        }
    }
}
