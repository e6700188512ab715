using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>The indices of all other points within a radius of each point.</summary>
    static class Neighbors
    {
        /// <summary>Every pair, for some thousand points.</summary>
        public static int[][] BruteForce(double3[] points, double radius)
        {
            var neighbors = new int[points.Length][];
            for (int i = 0; i < points.Length; i++)
            {
                var near = new List<int>();
                for (int j = 0; j < points.Length; j++)
                    if (j != i && math.distance(points[i], points[j]) < radius)
                        near.Add(j);
                neighbors[i] = near.ToArray();
            }
            return neighbors;
        }

        /// <summary>Finds these sets through cells as wide as the radius, for many points.</summary>
        public static int[][] ByCells(double3[] points, double radius)
        {
            var cells = new Dictionary<int3, List<int>>();
            for (int i = 0; i < points.Length; i++)
            {
                int3 cell = Cell(points[i], radius);
                if (!cells.TryGetValue(cell, out List<int> inCell))
                    cells[cell] = inCell = new List<int>();
                inCell.Add(i);
            }

            var neighbors = new int[points.Length][];
            var near = new List<int>();
            for (int i = 0; i < points.Length; i++)
            {
                near.Clear();
                int3 center = Cell(points[i], radius);
                for (int z = -1; z <= 1; z++)
                    for (int y = -1; y <= 1; y++)
                        for (int x = -1; x <= 1; x++)
                            if (cells.TryGetValue(center + new int3(x, y, z), out List<int> inCell))
                                foreach (int j in inCell)
                                    if (j != i && math.distance(points[i], points[j]) < radius)
                                        near.Add(j);
                neighbors[i] = near.ToArray();
            }
            return neighbors;
        }

        static int3 Cell(double3 point, double radius)
        {
            return new int3((int)Math.Floor(point.x / radius), (int)Math.Floor(point.y / radius), (int)Math.Floor(point.z / radius));
        }
    }
}
