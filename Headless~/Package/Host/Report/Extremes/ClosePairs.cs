using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Host.Report.Extremes
{
    /// <summary>Pairs of particles that lie nearer to each other than a fluid at rest would let them.</summary>
    static class ClosePairs
    {
        /// <summary>Returns the number of pairs. Collapsed water has more than an int holds.</summary>
        /// <param name="positions">d.</param>
        /// <param name="distance">d.</param>
        public static long Count(float3[] positions, float distance)
        {
            // Particles at one position are pairs without a look at each of them.
            (float3 Position, long Particles)[] points = positions.GroupBy(p => p).Select(same => (same.Key, (long)same.Count())).ToArray();
            var first = new Dictionary<int3, int>(points.Length);
            var next = new int[points.Length];
            long pairs = 0;
            for (int i = 0; i < points.Length; i++)
            {
                (float3 position, long particles) = points[i];
                pairs += particles * (particles - 1) / 2;
                int3 cell = (int3)math.floor(position / distance);
                for (int neighbor = 0; neighbor < 27; neighbor++)
                {
                    if (!first.TryGetValue(cell + new int3(neighbor % 3, neighbor / 3 % 3, neighbor / 9) - 1, out int other))
                        continue;
                    for (; other >= 0; other = next[other])
                        if (math.distancesq(position, points[other].Position) < distance * distance)
                            pairs += particles * points[other].Particles;
                }
                next[i] = first.TryGetValue(cell, out int head) ? head : -1;
                first[cell] = i;
            }
            return pairs;
        }
    }
}
