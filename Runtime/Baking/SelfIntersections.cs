using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Counts pairs of triangles that cross each other: an edge of one goes through the other. Pairs with a common vertex and
    /// pairs in one plane are not looked at. Pairs to test are found by a grid, up to a limit; beyond it the rest is left.
    /// </summary>
    static class SelfIntersections
    {
        public readonly struct Count
        {
            public readonly int Pairs;
            /// <summary>Fraction of the grid's cells that were looked through before the limit, 0 to 1.</summary>
            public readonly float Checked;

            public Count(int pairs, float checkedFraction) => (Pairs, Checked) = (pairs, checkedFraction);
        }

        const int MaxCellsAcross = 128;
        const int CellsBetweenLooks = 1024;

        /// <param name="maxTests">Pairs of triangles that are tested at most, and entries of the grid.</param>
        /// <param name="goOn">Told the fraction that is done, and asked whether to go on.</param>
        /// <returns>Null if it was canceled.</returns>
        public static Count? Find(MeshEdges edges, long maxTests, Func<float, bool> goOn)
        {
            BakedTriangles triangles = edges.Triangles;
            TriangleMesh mesh = triangles.Mesh;
            int count = mesh.TriangleCount;
            var low = new float3[count];
            var high = new float3[count];
            float3 from = triangles.Bounds.min, to = triangles.Bounds.max;
            int taking = triangles.Count;
            if (taking == 0)
                return new Count(0, 1f);
            for (int t = 0; t < count; t++)
            {
                if (!triangles.TakesPart(t))
                    continue;
                float3 a = mesh.Corner(t, 0), b = mesh.Corner(t, 1), c = mesh.Corner(t, 2);
                low[t] = math.min(a, math.min(b, c));
                high[t] = math.max(a, math.max(b, c));
            }

            // Some triangles a cell of the surface.
            int across = math.clamp((int)math.sqrt(taking / 4f), 1, MaxCellsAcross);
            float cell = math.max(math.cmax(to - from) / across, float.Epsilon);
            int3 cells = math.clamp((int3)math.ceil((to - from) / cell), 1, across);

            var inCell = new List<int>[cells.x * cells.y * cells.z];
            long entries = 0;
            int entered = 0, last = 0;
            for (; last < count && entries < maxTests; last++)
            {
                if (!triangles.TakesPart(last))
                    continue;
                entered++;
                int3 first = Cell(low[last], from, cell, cells), end = Cell(high[last], from, cell, cells);
                for (int z = first.z; z <= end.z; z++)
                    for (int y = first.y; y <= end.y; y++)
                        for (int x = first.x; x <= end.x; x++, entries++)
                        {
                            int i = (z * cells.y + y) * cells.x + x;
                            (inCell[i] ?? (inCell[i] = new List<int>())).Add(last);
                        }
            }

            int crossing = 0, looked = 0;
            long tests = 0;
            for (; looked < inCell.Length && tests < maxTests; looked++)
            {
                if (looked % CellsBetweenLooks == 0 && !goOn(math.max((float)looked / inCell.Length, tests / (float)maxTests)))
                    return null;
                List<int> here = inCell[looked];
                for (int i = 0; here != null && i < here.Count; i++)
                    for (int j = i + 1; j < here.Count && tests < maxTests; j++, tests++)
                    {
                        int a = here[i], b = here[j];
                        if (math.any(low[a] > high[b]) || math.any(low[b] > high[a]) || HaveCommonVertex(edges, a, b))
                            continue;
                        // A pair that meets in several cells counts in the lowest of them.
                        int3 meeting = Cell(math.max(low[a], low[b]), from, cell, cells);
                        if ((meeting.z * cells.y + meeting.y) * cells.x + meeting.x == looked && Cross(mesh, a, b))
                            crossing++;
                    }
            }
            return new Count(crossing, (float)entered / taking * looked / inCell.Length);
        }

        static int3 Cell(float3 position, float3 from, float size, int3 cells) => math.clamp((int3)((position - from) / size), 0, cells - 1);

        static bool HaveCommonVertex(MeshEdges edges, int a, int b)
        {
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    if (edges.Corner(a, i) == edges.Corner(b, j))
                        return true;
            return false;
        }

        static bool Cross(TriangleMesh mesh, int a, int b)
        {
            for (int k = 0; k < 3; k++)
                if (Pierces(At(mesh, a, k), At(mesh, a, (k + 1) % 3), At(mesh, b, 0), At(mesh, b, 1), At(mesh, b, 2)) ||
                    Pierces(At(mesh, b, k), At(mesh, b, (k + 1) % 3), At(mesh, a, 0), At(mesh, a, 1), At(mesh, a, 2)))
                    return true;
            return false;
        }

        static double3 At(TriangleMesh mesh, int triangle, int k) => (float3)mesh.Corner(triangle, k);

        // Whether the segment pq goes through the triangle: its ends lie on different sides, and it passes the three edges on one.
        static bool Pierces(double3 p, double3 q, double3 a, double3 b, double3 c)
        {
            double3 normal = math.cross(b - a, c - a);
            if (math.dot(normal, p - a) * math.dot(normal, q - a) >= 0)
                return false;
            double3 along = q - p;
            double ab = math.dot(along, math.cross(a - p, b - p));
            double bc = math.dot(along, math.cross(b - p, c - p));
            double ca = math.dot(along, math.cross(c - p, a - p));
            return ab > 0 && bc > 0 && ca > 0 || ab < 0 && bc < 0 && ca < 0;
        }
    }
}
