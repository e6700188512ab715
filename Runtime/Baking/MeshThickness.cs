using System;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>
    /// How thick a mesh is at each of its triangles: from the triangle's center against its normal to where the mesh ends again. By a tree
    /// of boxes over the triangles along a curve.
    /// </summary>
    sealed class MeshThickness
    {
        // Fraction of the mesh's size: surfaces so near are those of parts that touch.
        const double Touching = 1e-7;
        const int TrianglesBetweenLooks = 1 << 16;
        const int MaxStack = 64;        // three of each of 16 levels, and one
        const double Slight = 1e-30;

        struct Box
        {
            public float3 low, high;
        }

        readonly MeshEdges edges;
        readonly TriangleMesh mesh;
        readonly uint[] order;
        readonly uint2[] levels;
        readonly Box[] boxes;
        readonly double touching;
        readonly bool isInsideOut;

        MeshThickness(MeshEdges edges)
        {
            this.edges = edges;
            mesh = edges.Triangles.Mesh;
            isInsideOut = edges.SignedVolume < 0;
            touching = Touching * math.cmax((float3)edges.Triangles.Bounds.size);
            order = TriangleOrder.Of(edges.Triangles);
            levels = ClusterLevels.Of(order.Length);
            boxes = new Box[levels[levels.Length - 1].x + 1];
            for (int level = 0; level < levels.Length; level++)
                for (int i = 0; i < levels[level].y; i++)
                    boxes[levels[level].x + i] = BoxOf(level, i);
        }

        /// <summary>Returns the thickness at each triangle of the mesh, m: infinite where nothing is beyond it, as at an open surface; 0 for those
        /// that take no part.</summary>
        /// <param name="goOn">Told the fraction that is done, and asked whether to go on.</param>
        /// <returns>Null if it was canceled.</returns>
        public static float[] Of(MeshEdges edges, Func<float, bool> goOn)
        {
            var thickness = new float[edges.Triangles.Mesh.TriangleCount];
            if (edges.Triangles.Count == 0)
                return thickness;
            var tree = new MeshThickness(edges);
            for (int from = 0; from < tree.order.Length; from += TrianglesBetweenLooks)
            {
                if (!goOn((float)from / tree.order.Length))
                    return null;
                int start = from;
                Chunks.Run(math.min(TrianglesBetweenLooks, tree.order.Length - start), (chunk, first, end) =>
                {
                    for (int i = start + first; i < start + end; i++)
                        thickness[tree.order[i]] = tree.ThicknessAt((int)tree.order[i]);
                });
            }
            return thickness;
        }

        Box BoxOf(int level, int index)
        {
            var box = new Box { low = float.PositiveInfinity, high = float.NegativeInfinity };
            int first = index * ClusterLevels.Fan, end = math.min(first + ClusterLevels.Fan, level == 0 ? order.Length : (int)levels[level - 1].y);
            for (int i = first; i < end; i++)
                if (level == 0)
                    for (int k = 0; k < 3; k++)
                    {
                        float3 corner = mesh.Corner((int)order[i], k);
                        box.low = math.min(box.low, corner);
                        box.high = math.max(box.high, corner);
                    }
                else
                {
                    box.low = math.min(box.low, boxes[levels[level - 1].x + i].low);
                    box.high = math.max(box.high, boxes[levels[level - 1].x + i].high);
                }
            return box;
        }

        double3 Outward(int t) => isInsideOut ? -edges.OutwardArea(t) : edges.OutwardArea(t);

        float ThicknessAt(int triangle)
        {
            double3 from = ((double3)(float3)mesh.Corner(triangle, 0) + (float3)mesh.Corner(triangle, 1) + (float3)mesh.Corner(triangle, 2)) / 3;
            double3 along = -math.normalize(Outward(triangle));
            // Finite, so that a ray in a face of a box, 0 times this, needs no special case.
            double3 perMeter = 1 / math.select(along, Slight, math.abs(along) < Slight);
            double nearest = double.PositiveInfinity;
            Span<int2> stack = stackalloc int2[MaxStack];       // level and index
            Span<double> enters = stackalloc double[MaxStack];
            int depth = 1;
            stack[0] = new int2(levels.Length - 1, 0);
            enters[0] = 0;
            while (depth > 0)
            {
                int2 node = stack[--depth];
                if (enters[depth] > nearest)
                    continue;
                int first = node.y * ClusterLevels.Fan, bottom = depth;
                int end = math.min(first + ClusterLevels.Fan, node.x == 0 ? order.Length : (int)levels[node.x - 1].y);
                for (int i = first; i < end; i++)
                {
                    if (node.x == 0)
                    {
                        if (order[i] != triangle)
                            nearest = math.min(nearest, DistanceTo((int)order[i], from, along));
                        continue;
                    }
                    double enter = EntryOf(boxes[levels[node.x - 1].x + i], from, perMeter, nearest);
                    if (double.IsPositiveInfinity(enter))
                        continue;
                    // The nearest of them on top, so that it is the first.
                    int at = depth++;
                    for (; at > bottom && enters[at - 1] < enter; at--)
                        (stack[at], enters[at]) = (stack[at - 1], enters[at - 1]);
                    (stack[at], enters[at]) = (new int2(node.x - 1, i), enter);
                }
            }
            return (float)nearest;
        }

        /// <summary>Returns the distance at which a ray enters a box, m; infinite if it misses.</summary>
        static double EntryOf(in Box box, double3 from, double3 perMeter, double limit)
        {
            double3 a = (box.low - from) * perMeter, b = (box.high - from) * perMeter;
            double enters = math.max(math.cmax(math.min(a, b)), 0), leaves = math.min(math.cmin(math.max(a, b)), limit);
            return enters <= leaves * (1 + 1e-9) ? enters : double.PositiveInfinity;
        }

        // Möller and Trumbore 1997; only where the ray goes out.
        double DistanceTo(int triangle, double3 from, double3 along)
        {
            double3 a = (float3)mesh.Corner(triangle, 0), ab = (float3)mesh.Corner(triangle, 1) - a, ac = (float3)mesh.Corner(triangle, 2) - a;
            if (math.dot(Outward(triangle), along) <= 0)
                return double.PositiveInfinity;
            double3 across = math.cross(along, ac), to = from - a;
            double area = math.dot(ab, across), u = math.dot(to, across) / area;
            double3 other = math.cross(to, ab);
            double v = math.dot(along, other) / area, distance = math.dot(ac, other) / area;
            return u >= -1e-9 && v >= -1e-9 && u + v <= 1 + 2e-9 && distance > touching ? distance : double.PositiveInfinity;
        }
    }
}
