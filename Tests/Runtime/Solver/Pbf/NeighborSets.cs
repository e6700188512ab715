using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Compares neighbor lists with the reference as sets.</summary>
    static class NeighborSets
    {
        // Pairs this close to the radius, as a fraction of it, may fall on either side in single precision.
        const double Edge = 2e-6;

        public static void AssertSame(int[][] lists, double3[] points, double radius)
        {
            int[][] sure = Neighbors.ByCells(points, radius * (1.0 - Edge));
            for (int i = 0; i < lists.Length; i++)
            {
                var listed = new HashSet<int>(lists[i]);
                if (listed.Count != lists[i].Length)
                    Assert.Fail($"particle {i} lists a neighbor twice: {string.Join(", ", lists[i].OrderBy(j => j))}");
                int missing = sure[i].FirstOrDefault(j => !listed.Contains(j));
                if (sure[i].Any(j => !listed.Contains(j)))
                    Assert.Fail($"particle {i} at {points[i]} does not list particle {missing} at {points[missing]}, " +
                        $"{math.distance(points[i], points[missing])} away");
                foreach (int j in listed)
                    if (j == i || math.distance(points[i], points[j]) > radius * (1.0 + Edge))
                        Assert.Fail($"particle {i} at {points[i]} lists particle {j} at {points[j]}, {math.distance(points[i], points[j])} away");
            }
        }
    }
}
