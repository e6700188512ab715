using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// How the triangles of a mesh hang together: vertices at the same place are one, and every edge knows its triangles.
    /// Triangles without area, and those of vertices that are no numbers, take no part.
    /// </summary>
    sealed class MeshEdges
    {
        /// <summary>A triangle without area: thinner than this share of its longest edge.</summary>
        const double Thinnest = 1e-10;

        const int None = -1;

        /// <summary>First three: a triangle's corners as welded vertices; <see cref="None"/> for one that takes no part.</summary>
        readonly int[] corners;
        // An edge's lower and higher vertex, the triangles along it and against it, and the first two of them.
        readonly List<ulong> edges = new List<ulong>();
        readonly List<int2> uses = new List<int2>();
        readonly List<int2> triangles = new List<int2>();
        readonly double3[] places;

        /// <summary>Triangles that are to be turned over to agree with their neighbors.</summary>
        public readonly bool[] Turned;

        public MeshEdges(TriangleMesh mesh)
        {
            int[] welded = Weld(mesh.Vertices, out int count);
            places = new double3[count];
            for (int i = 0; i < welded.Length; i++)
                places[welded[i]] = new double3(mesh.Vertices[i].x, mesh.Vertices[i].y, mesh.Vertices[i].z);
            Vertices = count;

            corners = new int[mesh.Triangles.Length];
            Turned = new bool[mesh.TriangleCount];
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                int a = welded[mesh.Triangles[3 * t]], b = welded[mesh.Triangles[3 * t + 1]], c = welded[mesh.Triangles[3 * t + 2]];
                bool finite = math.all(math.isfinite(places[a])) && math.all(math.isfinite(places[b])) && math.all(math.isfinite(places[c]));
                bool hasArea = finite && HasArea(places[a], places[b], places[c]);
                NonFiniteTriangles += finite ? 0 : 1;
                ZeroAreaTriangles += finite && !hasArea ? 1 : 0;
                corners[3 * t] = hasArea ? a : None;
                corners[3 * t + 1] = hasArea ? b : None;
                corners[3 * t + 2] = hasArea ? c : None;
            }
            FindEdges();
            Orient();
            FindHoles();
            Measure();
        }

        /// <summary>Places that vertices have.</summary>
        public int Vertices { get; }
        public int NonFiniteTriangles { get; }
        public int ZeroAreaTriangles { get; }

        /// <summary>Edges of one triangle only, and of more than two.</summary>
        public int BoundaryEdges { get; private set; }
        public int NonManifoldEdges { get; private set; }

        /// <summary>Edges whose two triangles see different sides.</summary>
        public int InconsistentEdges { get; private set; }
        public int TurnedTriangles { get; private set; }

        /// <summary>Boundary edges that hang together, counted once; those that touch in a vertex are one.</summary>
        public int Holes { get; private set; }

        /// <summary>Of the triangles, m².</summary>
        public double Area { get; private set; }

        /// <summary>Of the flattest surfaces that would close the holes, as vectors, m².</summary>
        public double HoleArea { get; private set; }

        /// <summary>With turned triangles turned, m³; negative for a mesh that is inside out.</summary>
        public double SignedVolume { get; private set; }

        /// <summary>Whether a triangle has area and finite vertices.</summary>
        public bool TakesPart(int triangle) => corners[3 * triangle] != None;

        /// <summary>A corner of a triangle that takes part, as a number that vertices of one place share.</summary>
        public int Corner(int triangle, int k) => corners[3 * triangle + k];

        static bool HasArea(double3 a, double3 b, double3 c)
        {
            double longest = math.max(math.lengthsq(b - a), math.max(math.lengthsq(c - b), math.lengthsq(a - c)));
            return math.length(math.cross(b - a, c - a)) > Thinnest * longest;
        }

        static int[] Weld(Vector3[] vertices, out int count)
        {
            var numbers = new int[vertices.Length];
            var table = new Dictionary<Vector3, int>(vertices.Length, new SamePlace());
            for (int i = 0; i < vertices.Length; i++)
                if (!table.TryGetValue(vertices[i], out numbers[i]))
                    table.Add(vertices[i], numbers[i] = table.Count);
            count = table.Count;
            return numbers;
        }

        /// <summary>The bits, but for the sign of 0.</summary>
        sealed class SamePlace : IEqualityComparer<Vector3>
        {
            public bool Equals(Vector3 a, Vector3 b) => math.all(Bits(a) == Bits(b));
            public int GetHashCode(Vector3 v) => (int)math.hash(Bits(v));
            static uint3 Bits(Vector3 v) => math.asuint((float3)v + 0f);
        }

        /// <summary>Mixes both vertices: the framework's hash of a ulong is their exclusive or, and neighbors' are all small.</summary>
        sealed class SameEdge : IEqualityComparer<ulong>
        {
            public bool Equals(ulong a, ulong b) => a == b;
            public int GetHashCode(ulong edge) => (int)math.hash(new uint2((uint)edge, (uint)(edge >> 32)));
        }

        void FindEdges()
        {
            var table = new Dictionary<ulong, int>(corners.Length / 2 + 1, new SameEdge());
            for (int t = 0; t < Turned.Length; t++)
                for (int k = 0; k < 3 && TakesPart(t); k++)
                {
                    int from = corners[3 * t + k], to = corners[3 * t + (k + 1) % 3];
                    ulong key = ((ulong)(uint)math.min(from, to) << 32) | (uint)math.max(from, to);
                    if (!table.TryGetValue(key, out int edge))
                    {
                        table.Add(key, edge = edges.Count);
                        edges.Add(key);
                        uses.Add(0);
                        triangles.Add(None);
                    }
                    uses[edge] += from < to ? new int2(1, 0) : new int2(0, 1);
                    int2 pair = triangles[edge];
                    triangles[edge] = pair.x == None ? new int2(t, None) : pair.y == None ? new int2(pair.x, t) : pair;
                }
            foreach (int2 use in uses)
            {
                int all = use.x + use.y;
                BoundaryEdges += all == 1 ? 1 : 0;
                NonManifoldEdges += all > 2 ? 1 : 0;
                InconsistentEdges += all == 2 && use.x != 1 ? 1 : 0;
            }
        }

        // Walks over edges of two triangles; in each part that hangs together the larger area is right.
        void Orient()
        {
            if (InconsistentEdges == 0)
                return;

            var neighbors = new int3[Turned.Length];
            var opposed = new bool3[Turned.Length];
            for (int t = 0; t < neighbors.Length; t++)
                neighbors[t] = None;
            for (int e = 0; e < edges.Count; e++)
                if (uses[e].x + uses[e].y == 2)
                {
                    Link(neighbors, opposed, triangles[e].x, triangles[e].y, uses[e].x != 1);
                    Link(neighbors, opposed, triangles[e].y, triangles[e].x, uses[e].x != 1);
                }

            var seen = new bool[Turned.Length];
            var part = new List<int>();
            for (int start = 0; start < seen.Length; start++)
            {
                if (seen[start] || !TakesPart(start))
                    continue;
                part.Clear();
                part.Add(start);
                seen[start] = true;
                double kept = 0, turned = 0;
                for (int i = 0; i < part.Count; i++)
                {
                    int t = part[i];
                    double area = math.length(AreaVector(t));
                    if (Turned[t])
                        turned += area;
                    else
                        kept += area;
                    for (int k = 0; k < 3; k++)
                    {
                        int next = neighbors[t][k];
                        if (next == None || seen[next])
                            continue;
                        seen[next] = true;
                        Turned[next] = Turned[t] != opposed[t][k];
                        part.Add(next);
                    }
                }
                foreach (int t in part)
                {
                    Turned[t] = Turned[t] != turned > kept;
                    TurnedTriangles += Turned[t] ? 1 : 0;
                }
            }
        }

        static void Link(int3[] neighbors, bool3[] opposed, int from, int to, bool against)
        {
            int3 n = neighbors[from];
            int k = n.x == None ? 0 : n.y == None ? 1 : 2;
            neighbors[from][k] = to;
            opposed[from][k] = against;
        }

        double3 AreaVector(int t)
        {
            double3 a = places[corners[3 * t]];
            return 0.5 * math.cross(places[corners[3 * t + 1]] - a, places[corners[3 * t + 2]] - a);
        }

        void FindHoles()
        {
            var root = new Dictionary<int, int>();
            var sums = new Dictionary<int, double3>();
            for (int e = 0; e < edges.Count; e++)
                if (uses[e].x + uses[e].y == 1)
                    Join(root, (int)(edges[e] >> 32), (int)(uint)edges[e]);
            for (int e = 0; e < edges.Count; e++)
            {
                if (uses[e].x + uses[e].y != 1)
                    continue;
                int low = (int)(edges[e] >> 32), high = (int)(uint)edges[e];
                int hole = Root(root, low);
                // About a vertex of the hole, so that far from the origin nothing is lost.
                double3 area = 0.5 * math.cross(places[low] - places[hole], places[high] - places[hole]);
                bool along = uses[e].x == 1 != Turned[triangles[e].x];
                sums.TryGetValue(hole, out double3 sum);
                sums[hole] = sum + (along ? area : -area);
            }
            Holes = sums.Count;
            foreach (double3 sum in sums.Values)
                HoleArea += math.length(sum);
        }

        static int Root(Dictionary<int, int> root, int vertex)
        {
            while (root.TryGetValue(vertex, out int above) && above != vertex)
            {
                if (root.TryGetValue(above, out int higher))
                    root[vertex] = higher;
                vertex = above;
            }
            return vertex;
        }

        static void Join(Dictionary<int, int> root, int a, int b)
        {
            a = Root(root, a);
            b = Root(root, b);
            root[math.max(a, b)] = math.min(a, b);
            if (!root.ContainsKey(math.min(a, b)))
                root[math.min(a, b)] = math.min(a, b);
        }

        void Measure()
        {
            double3 middle = 0;
            int count = 0;
            for (int i = 0; i < places.Length; i++)
                if (math.all(math.isfinite(places[i])))
                {
                    middle += places[i];
                    count++;
                }
            middle /= math.max(count, 1);
            for (int t = 0; t < Turned.Length; t++)
            {
                if (!TakesPart(t))
                    continue;
                double3 area = AreaVector(t);
                Area += math.length(area);
                // Unity's triangles are clockwise from outside, so their area vectors, left-handed, point outwards.
                double volume = math.dot(places[corners[3 * t]] - middle, area) / 3;
                SignedVolume += Turned[t] ? -volume : volume;
            }
        }
    }
}
