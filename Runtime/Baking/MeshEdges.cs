using System;
using System.Collections.Generic;
using System.Threading;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// How the triangles of a mesh hang together: vertices at the same place are one, so are those that lie almost at one place where
    /// edges would be open, and every edge knows its triangles. Only triangles that take part in the bake count.
    /// </summary>
    sealed class MeshEdges
    {
        const int None = -1;
        // Few enough that sorting them by insertion is quickest. A vertex of a closed mesh has six triangles on average.
        const int Few = 24;

        // Distance at which corners of open edges are joined: a fraction of the mesh's size, which six digits of a text file need and a tenth of the
        // smallest detail that a field can show has not; never more than a fraction of the edges there, so that a small model beside a large one
        // keeps its gaps. And the rounding of the coordinates, which is all that is left far from the origin.
        const double JoinOfSize = 1e-5, JoinOfEdge = 1e-2, JoinOfPosition = 1.0 / (1 << 22);

        // Fraction of the square of the length around a hole: less area is rounding.
        const double FlatHole = 1e-5;

        readonly TriangleMesh mesh;
        /// <summary>By vertex of the mesh: its place's number.</summary>
        readonly int[] welded;
        /// <summary>By place: a vertex of the mesh that lies there.</summary>
        readonly List<int> vertexAt = new List<int>();

        // Sides of triangles, bundled by the lower of their two places: first in sides of each place's bundle, and one more.
        // A side is its higher index, number (3 t + k) and whether it runs downwards, from the highest bits on, so that in a
        // sorted bundle the sides of one edge are neighbors, in the order of their triangles.
        int[] bundles;
        ulong[] sides;
        readonly List<int> boundary = new List<int>();
        MeshParts parts;

        public MeshEdges(BakedTriangles triangles)
        {
            Triangles = triangles;
            mesh = triangles.Mesh;
            welded = Weld();
            FindEdges();
            if (!IsClosed && JoinNearby())
                FindEdges();
            Turned = new bool[mesh.TriangleCount];
            if (InconsistentEdges > 0)
                Orient();
            FindHoles();
            SignedVolume = MeasureVolume();
            TurnInvertedParts();
        }

        void FindEdges()
        {
            sides = Sides(out bundles);
            Count();
        }

        /// <summary>Triangles that take part.</summary>
        public BakedTriangles Triangles { get; }

        /// <summary>Triangles that are to be turned over to agree with their neighbors.</summary>
        public bool[] Turned { get; }

        /// <summary>Positions that vertices have.</summary>
        public int Vertices => vertexAt.Count;

        /// <summary>Number of those vertices that lie so near to another that they count as one with it.</summary>
        public int JoinedVertices { get; private set; }

        /// <summary>Most that such vertices lie apart along an axis, m, where the coordinates are fine enough.</summary>
        public double JoinDistance => JoinOfSize * math.min(math.cmax((float3)Triangles.Bounds.size), math.sqrt(Triangles.Area));

        /// <summary>Edges of one triangle only, and of more than two.</summary>
        public int BoundaryEdges => boundary.Count;
        public int NonManifoldEdges { get; private set; }

        /// <summary>Edges whose two triangles see different sides.</summary>
        public int InconsistentEdges { get; private set; }
        public int TurnedTriangles { get; private set; }

        /// <summary>Whether every edge has two triangles that face the same side, so that the winding number is whole wherever no triangle
        /// is.</summary>
        public bool IsClosed => BoundaryEdges == 0 && NonManifoldEdges == 0 && InconsistentEdges == 0;

        /// <summary>Boundary edges that hang together, counted once; those that touch in a vertex are one.</summary>
        public int Holes => HoleAreas.Count;

        /// <summary>By hole: a vertex of it, as a number of <see cref="Corner"/>, and the area of a flat cover, m².</summary>
        public List<(int corner, double area)> HoleAreas { get; } = new List<(int, double)>();

        /// <summary>Number of holes that bound no area: slits, as where a corner lies on another triangle's edge.</summary>
        public int FlatHoles { get; private set; }

        /// <summary>Sum of the area vectors of the flattest surfaces that would close the holes, m².</summary>
        public double HoleArea { get; private set; }

        /// <summary>With turned triangles turned, m³; negative for a mesh that is inside out.</summary>
        public double SignedVolume { get; private set; }

        /// <summary>Closed parts that faced the other side than the mesh, though they lie in no other part. Their triangles are turned.</summary>
        public int InvertedParts { get; private set; }

        public MeshParts Parts => parts ??= new MeshParts(this);

        /// <summary>A corner of a triangle, as a number that is one for all vertices at one position.</summary>
        public int Corner(int triangle, int k) => welded[mesh.Triangles[3 * triangle + k]];

        // Open addressing: a dictionary takes several times as long.
        int[] Weld()
        {
            Vector3[] vertices = mesh.Vertices;
            var numbers = new int[vertices.Length];
            int mask = math.ceilpow2(math.max(2 * numbers.Length, 16)) - 1;
            var table = new int[mask + 1];      // a place's number + 1; 0: free
            for (int i = 0; i < numbers.Length; i++)
            {
                uint3 bits = Bits(vertices[i]);
                int slot = (int)math.hash(bits) & mask;
                while (table[slot] != 0 && math.any(Bits(vertices[vertexAt[table[slot] - 1]]) != bits))
                    slot = (slot + 1) & mask;
                if (table[slot] == 0)
                {
                    vertexAt.Add(i);
                    table[slot] = vertexAt.Count;
                }
                numbers[i] = table[slot] - 1;
            }
            return numbers;
        }

        // But for the sign of 0.
        static uint3 Bits(float3 vertex) => math.asuint(vertex + 0f);

        /// <summary>
        /// Takes places as one that lie almost at one place and are ends of edges that are not those of two triangles facing one side.
        /// Others are left alone, however near to each other they lie.
        /// </summary>
        /// <returns>Whether there were any.</returns>
        bool JoinNearby()
        {
            int[] ends = EndsOfFaultyEdges();
            double[] tolerances = TolerancesAt(ends);
            // Along an axis that no grid and no plane of a mesh is likely to lie across, so that few others are near in this order.
            double3 axis = new double3(1, math.sqrt(2.0), math.sqrt(3.0));
            var along = new double[ends.Length];
            var order = new int[ends.Length];
            for (int i = 0; i < order.Length; i++)
            {
                along[i] = math.dot(axis, PositionOf(ends[i]));
                order[i] = i;
            }
            Array.Sort(along, order);

            int[] root = DisjointSets.Of(Vertices);
            for (int i = 0; i < order.Length; i++)
            {
                int a = order[i];
                double3 at = PositionOf(ends[a]);
                double reach = along[i] + math.csum(axis) * tolerances[a] * (1 + 1e-9);
                for (int j = i + 1; j < order.Length && along[j] <= reach; j++)
                {
                    int b = order[j];
                    if (math.cmax(math.abs(PositionOf(ends[b]) - at)) <= math.min(tolerances[a], tolerances[b]))
                        JoinedVertices += DisjointSets.Join(root, ends[a], ends[b]) ? 1 : 0;
                }
            }
            for (int i = 0; i < welded.Length && JoinedVertices > 0; i++)
                welded[i] = DisjointSets.Root(root, welded[i]);
            return JoinedVertices > 0;
        }

        int[] EndsOfFaultyEdges()
        {
            var isEnd = new bool[Vertices];
            for (int v = 0; v < Vertices; v++)
                for (int first = bundles[v], end; first < bundles[v + 1]; first = end)
                {
                    end = EndOfEdge(first, bundles[v + 1]);
                    if (end - first != 2 || RunsDown(sides[first]) == RunsDown(sides[first + 1]))
                        isEnd[v] = isEnd[IndexOf(sides[first])] = true;
                }
            var ends = new List<int>();
            for (int v = 0; v < Vertices; v++)
                if (isEnd[v])
                    ends.Add(v);
            return ends.ToArray();
        }

        // By the place's number in the list, m.
        double[] TolerancesAt(int[] indices)
        {
            var longest = new double[Vertices];
            for (int t = 0; t < mesh.TriangleCount; t++)
                for (int k = 0; k < 3 && Triangles.TakesPart(t); k++)
                {
                    int from = Corner(t, k), to = Corner(t, (k + 1) % 3);
                    double length = math.distance(PositionOf(from), PositionOf(to));
                    longest[from] = math.max(longest[from], length);
                    longest[to] = math.max(longest[to], length);
                }
            double most = JoinDistance;
            return Array.ConvertAll(indices, index => math.max(math.min(most, JoinOfEdge * longest[index]),
                JoinOfPosition * math.cmax(math.abs(PositionOf(index)))));
        }

        // Each core counts and files its own triangles. In which order they come does not matter: the bundles are sorted.
        ulong[] Sides(out int[] bundles)
        {
            var firsts = new int[Vertices + 1];
            Chunks.Run(mesh.TriangleCount, (chunk, first, end) => CountSides(firsts, first, end));
            // To the end of each bundle; filling them backwards then leaves their beginnings.
            for (int v = 1; v <= Vertices; v++)
                firsts[v] += firsts[v - 1];
            var all = new ulong[firsts[Vertices]];
            Chunks.Run(mesh.TriangleCount, (chunk, first, end) => FileSides(firsts, all, first, end));
            Chunks.Run(Vertices, (chunk, first, end) =>
            {
                for (int v = first; v < end; v++)
                    Sort(all, firsts[v], firsts[v + 1] - firsts[v]);
            });
            bundles = firsts;
            return all;
        }

        // A triangle with two joined corners is a seam between its neighbors: its two sides left are one edge, there and back.
        bool HasEdges(int t)
        {
            int a = Corner(t, 0), b = Corner(t, 1), c = Corner(t, 2);
            return Triangles.TakesPart(t) && a != b && b != c && c != a;
        }

        void CountSides(int[] counts, int first, int end)
        {
            int[] corners = mesh.Triangles;
            for (int t = first; t < end; t++)
            {
                if (!HasEdges(t))
                    continue;
                int a = welded[corners[3 * t]], b = welded[corners[3 * t + 1]], c = welded[corners[3 * t + 2]];
                Interlocked.Increment(ref counts[math.min(a, b)]);
                Interlocked.Increment(ref counts[math.min(b, c)]);
                Interlocked.Increment(ref counts[math.min(c, a)]);
            }
        }

        void FileSides(int[] ends, ulong[] all, int first, int end)
        {
            int[] corners = mesh.Triangles;
            for (int t = first; t < end; t++)
                for (int k = 0; k < 3 && HasEdges(t); k++)
                {
                    int from = welded[corners[3 * t + k]], to = welded[corners[k == 2 ? 3 * t : 3 * t + k + 1]];
                    ulong side = (ulong)math.max(from, to) << 33 | (ulong)(3 * t + k) << 1 | (from > to ? 1ul : 0ul);
                    all[Interlocked.Decrement(ref ends[math.min(from, to)])] = side;
                }
        }

        static void Sort(ulong[] all, int first, int count)
        {
            if (count > Few)
            {
                Array.Sort(all, first, count);
                return;
            }
            for (int i = first + 1; i < first + count; i++)
            {
                ulong side = all[i];
                int at = i;
                for (; at > first && all[at - 1] > side; at--)
                    all[at] = all[at - 1];
                all[at] = side;
            }
        }

        static int IndexOf(ulong side) => (int)(side >> 33);
        static int TriangleOf(ulong side) => (int)((uint)(side >> 1) / 3);
        static bool RunsDown(ulong side) => (side & 1) != 0;

        /// <summary>After the last side of the edge that begins at one.</summary>
        int EndOfEdge(int first, int endOfBundle)
        {
            int end = first + 1;
            while (end < endOfBundle && IndexOf(sides[end]) == IndexOf(sides[first]))
                end++;
            return end;
        }

        void Count()
        {
            boundary.Clear();
            NonManifoldEdges = InconsistentEdges = 0;
            var open = new List<int>[Chunks.Of(Vertices)];
            var counts = new int2[open.Length];
            Chunks.Run(Vertices, (chunk, firstVertex, endVertex) =>
            {
                var found = new List<int>();
                int2 count = 0;
                for (int v = firstVertex; v < endVertex; v++)
                    for (int first = bundles[v], end; first < bundles[v + 1]; first = end)
                    {
                        end = EndOfEdge(first, bundles[v + 1]);
                        if (end - first == 1)
                            found.Add(first);
                        else if (end - first > 2)
                            count.x++;
                        else if (RunsDown(sides[first]) == RunsDown(sides[first + 1]))
                            count.y++;
                    }
                open[chunk] = found;
                counts[chunk] = count;
            });
            for (int chunk = 0; chunk < open.Length; chunk++)
            {
                boundary.AddRange(open[chunk]);
                NonManifoldEdges += counts[chunk].x;
                InconsistentEdges += counts[chunk].y;
            }
        }

        // Walks over edges of two triangles; in each part that hangs together the larger area is right.
        void Orient()
        {
            var neighbors = new int3[Turned.Length];
            var opposed = new bool3[Turned.Length];
            for (int t = 0; t < neighbors.Length; t++)
                neighbors[t] = None;
            for (int v = 0; v < Vertices; v++)
                for (int first = bundles[v], end; first < bundles[v + 1]; first = end)
                {
                    end = EndOfEdge(first, bundles[v + 1]);
                    if (end - first != 2)
                        continue;
                    bool against = RunsDown(sides[first]) == RunsDown(sides[first + 1]);
                    Link(neighbors, opposed, TriangleOf(sides[first]), TriangleOf(sides[first + 1]), against);
                    Link(neighbors, opposed, TriangleOf(sides[first + 1]), TriangleOf(sides[first]), against);
                }

            var seen = new bool[Turned.Length];
            var part = new List<int>();
            for (int start = 0; start < seen.Length; start++)
            {
                if (seen[start] || !Triangles.TakesPart(start))
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

        // One within another part is a cavity, and stays.
        void TurnInvertedParts()
        {
            bool[] isInverted = Parts.Count < 2 || SignedVolume == 0 ? null : Parts.FindInverted(SignedVolume < 0);
            if (isInverted == null)
                return;
            for (int t = 0; t < Turned.Length; t++)
                if (Triangles.TakesPart(t) && isInverted[Parts.Of(t)])
                    Turned[t] = !Turned[t];
            for (int part = 0; part < isInverted.Length; part++)
                if (isInverted[part])
                {
                    SignedVolume -= 2 * Parts[part].volume;
                    InvertedParts++;
                }
            parts = null;       // their volumes were those of before
        }

        /// <summary>Half the cross product of two sides, m²: outwards where the triangle faces the right side.</summary>
        public double3 OutwardArea(int t) => Turned[t] ? -AreaVector(t) : AreaVector(t);

        double3 AreaVector(int t)
        {
            double3 a = (float3)mesh.Corner(t, 0);
            return 0.5 * math.cross((float3)mesh.Corner(t, 1) - a, (float3)mesh.Corner(t, 2) - a);
        }

        void FindHoles()
        {
            if (boundary.Count == 0)
                return;
            var sums = new Dictionary<int, double4>();      // area vector and length around
            int[] root = DisjointSets.Of(Vertices);
            foreach (int side in boundary)
                DisjointSets.Join(root, From(sides[side]), To(sides[side]));
            foreach (int side in boundary)
            {
                int from = From(sides[side]), to = To(sides[side]), hole = DisjointSets.Root(root, from);
                // About a vertex of the hole, so that far from the origin nothing is lost.
                double3 center = PositionOf(hole), area = 0.5 * math.cross(PositionOf(from) - center, PositionOf(to) - center);
                sums.TryGetValue(hole, out double4 sum);
                sums[hole] = sum + new double4(Turned[TriangleOf(sides[side])] ? -area : area, math.distance(PositionOf(from), PositionOf(to)));
            }
            foreach (KeyValuePair<int, double4> sum in sums)
            {
                double area = math.length(sum.Value.xyz);
                HoleAreas.Add((sum.Key, area));
                HoleArea += area;
                FlatHoles += area < FlatHole * sum.Value.w * sum.Value.w ? 1 : 0;
            }
        }

        // The places where a side begins and ends, as its triangle has it.
        int From(ulong side) => welded[mesh.Triangles[(int)(uint)(side >> 1)]];

        int To(ulong side)
        {
            int corner = (int)(uint)(side >> 1);
            return welded[mesh.Triangles[corner % 3 == 2 ? corner - 2 : corner + 1]];
        }

        double3 PositionOf(int index) => (float3)mesh.Vertices[vertexAt[index]];

        double MeasureVolume()
        {
            double3 center = (float3)Triangles.Bounds.center;
            var sums = new double[Chunks.Of(Turned.Length)];
            Chunks.Run(Turned.Length, (chunk, first, end) =>
            {
                double part = 0;
                for (int t = first; t < end; t++)
                {
                    if (!Triangles.TakesPart(t))
                        continue;
                    // Unity's triangles are clockwise from outside, so their area vectors, left-handed, point outwards.
                    double volume = math.dot((float3)mesh.Corner(t, 0) - center, AreaVector(t)) / 3;
                    part += Turned[t] ? -volume : volume;
                }
                sums[chunk] = part;
            });
            double all = 0;
            foreach (double sum in sums)
                all += sum;
            return all;
        }
    }
}
