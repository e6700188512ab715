using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Triangles that make the box around a mesh much larger though they are next to nothing of it: small parts far from the others, and
    /// those at a single corner that strayed.
    /// </summary>
    sealed class FarTriangles
    {
        // Fraction of the surface that they hold at most; sizes of the rest that they lie off at least; and how much longer the box is.
        const double MaxArea = 0.01, MinDistance = 0.5, MinGrowth = 1.5;
        // Limits for a corner, which a spire may well have: growth, and the fraction of all triangles that meet there at most.
        const double MinCornerGrowth = 2, MaxCornerTriangles = 0.05;

        readonly bool[] isFar;

        FarTriangles(bool[] isFar, Bounds bounds, Vector3 position, bool isCorner)
        {
            this.isFar = isFar;
            Bounds = bounds;
            Position = position;
            IsCorner = isCorner;
            foreach (bool far in isFar)
                Count += far ? 1 : 0;
        }

        public int Count { get; }

        public bool Has(int triangle) => isFar[triangle];

        /// <summary>Bounds of the other triangles, m.</summary>
        public Bounds Bounds { get; }

        /// <summary>Position of the farthest triangle, m.</summary>
        public Vector3 Position { get; }

        /// <summary>Whether it is a corner that strayed, not a part.</summary>
        public bool IsCorner { get; }

        /// <summary>The mesh without them.</summary>
        public TriangleMesh LeaveOut(TriangleMesh mesh) => mesh.Without(isFar);

        /// <summary>A mesh without those that it has.</summary>
        public static TriangleMesh LeftOut(TriangleMesh mesh) => Of(new MeshEdges(new BakedTriangles(mesh)))?.LeaveOut(mesh) ?? mesh;

        /// <summary>Null where there are none.</summary>
        public static FarTriangles Of(MeshEdges edges)
        {
            Bounds all = edges.Triangles.Bounds;
            return edges.Triangles.Count == 0 ? null : Parts(edges, all) ?? Corner(edges, all);
        }

        static FarTriangles Parts(MeshEdges edges, Bounds all)
        {
            MeshParts parts = edges.Parts;
            var order = new int[parts.Count];
            var areas = new double[parts.Count];
            for (int part = 0; part < order.Length; part++)
                (order[part], areas[part]) = (part, -parts[part].area);
            Array.Sort(areas, order);

            // The largest, until they have all but a hundredth of the surface; then those that lie near to them, the larger first.
            Bounds near = parts[order[0]].Bounds;
            double held = parts[order[0]].area;
            int next = 1;
            for (; next < order.Length && held < (1 - MaxArea) * edges.Triangles.Area; next++)
            {
                near.Encapsulate(parts[order[next]].Bounds);
                held += parts[order[next]].area;
            }
            var isFarPart = new bool[parts.Count];
            bool any = false;
            for (; next < order.Length; next++)
            {
                ref readonly MeshParts.Part part = ref parts[order[next]];
                float3 gap = math.max(part.low - (float3)near.max, (float3)near.min - part.high);
                if (math.cmax(gap) > MinDistance * math.cmax((float3)near.size))
                    any = isFarPart[order[next]] = true;
                else
                    near.Encapsulate(part.Bounds);
            }
            if (!any || !Grows(near, all, MinGrowth))
                return null;
            var isFar = new bool[edges.Triangles.Mesh.TriangleCount];
            for (int t = 0; t < isFar.Length; t++)
                isFar[t] = edges.Triangles.TakesPart(t) && isFarPart[parts.Of(t)];
            return new FarTriangles(isFar, near, Farthest(edges, t => isFar[t], near), isCorner: false);
        }

        static FarTriangles Corner(MeshEdges edges, Bounds all)
        {
            TriangleMesh mesh = edges.Triangles.Mesh;
            var tried = new HashSet<int>();
            for (int axis = 0; axis < 3; axis++)
                for (int sign = -1; sign <= 1; sign += 2)
                {
                    int corner = -1;
                    float most = float.NegativeInfinity;
                    for (int t = 0; t < mesh.TriangleCount; t++)
                        for (int k = 0; k < 3 && edges.Triangles.TakesPart(t); k++)
                            if (sign * mesh.Corner(t, k)[axis] > most)
                                (most, corner) = (sign * mesh.Corner(t, k)[axis], edges.Corner(t, k));
                    if (!tried.Add(corner))
                        continue;
                    var low = new float3(float.PositiveInfinity);
                    var high = new float3(float.NegativeInfinity);
                    for (int t = 0; t < mesh.TriangleCount; t++)
                        for (int k = 0; k < 3 && edges.Triangles.TakesPart(t); k++)
                            if (edges.Corner(t, k) != corner)
                            {
                                low = math.min(low, mesh.Corner(t, k));
                                high = math.max(high, mesh.Corner(t, k));
                            }
                    var near = new Bounds(0.5f * (low + high), high - low);
                    if (!Grows(near, all, MinCornerGrowth))
                        continue;
                    var isFar = new bool[mesh.TriangleCount];
                    for (int t = 0; t < isFar.Length; t++)
                        for (int k = 0; k < 3 && edges.Triangles.TakesPart(t); k++)
                            isFar[t] |= edges.Corner(t, k) == corner;
                    var found = new FarTriangles(isFar, near, Farthest(edges, t => isFar[t], near), isCorner: true);
                    if (found.Count <= MaxCornerTriangles * edges.Triangles.Count)
                        return found;
                }
            return null;
        }

        static bool Grows(Bounds near, Bounds all, double times) => math.cmax((float3)all.size) >= times * math.cmax((float3)near.size)
            && math.cmax((float3)near.size) > 0f;

        static Vector3 Farthest(MeshEdges edges, Func<int, bool> isFar, Bounds near)
        {
            TriangleMesh mesh = edges.Triangles.Mesh;
            Vector3 found = near.center;
            for (int t = 0; t < mesh.TriangleCount; t++)
                for (int k = 0; k < 3 && isFar(t); k++)
                    if (near.SqrDistance(mesh.Corner(t, k)) >= near.SqrDistance(found))
                        found = mesh.Corner(t, k);
            return found;
        }
    }
}
