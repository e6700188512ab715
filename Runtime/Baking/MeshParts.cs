using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>The parts of a mesh: triangles that hang together by their corners, numbered in the order of their first triangles.</summary>
    sealed class MeshParts
    {
        public struct Part
        {
            public int triangles;
            /// <summary>m²: of the triangles, and of flat covers over the holes</summary>
            public double area, holeArea;
            /// <summary>m³; negative where it is inside out</summary>
            public double volume;
            public bool isOpen;
            public float3 low, high;
            public Bounds Bounds => new Bounds(0.5f * (low + high), high - low);
        }

        const int None = -1;
        const int Samples = 8;
        // Solid angles that are summed in all to see which parts lie in others: a second on one core.
        const long MaxAngles = 20_000_000;

        readonly MeshEdges edges;
        readonly TriangleMesh mesh;
        readonly int[] partOf;
        readonly Part[] parts;
        int[] first, sorted;

        public MeshParts(MeshEdges edges)
        {
            this.edges = edges;
            mesh = edges.Triangles.Mesh;
            int[] set = DisjointSets.Of(edges.Vertices);
            for (int t = 0; t < mesh.TriangleCount; t++)
                if (edges.Triangles.TakesPart(t))
                {
                    int a = edges.Corner(t, 0);
                    DisjointSets.Join(set, a, edges.Corner(t, 1));
                    DisjointSets.Join(set, a, edges.Corner(t, 2));
                }

            partOf = new int[mesh.TriangleCount];
            var numbers = new int[set.Length];      // a part's number + 1, by the root of its set
            var found = new List<Part>();
            for (int t = 0; t < partOf.Length; t++)
            {
                partOf[t] = None;
                if (!edges.Triangles.TakesPart(t))
                    continue;
                int root = DisjointSets.Root(set, edges.Corner(t, 0));
                if (numbers[root] == 0)
                {
                    found.Add(new Part { low = float.PositiveInfinity, high = float.NegativeInfinity });
                    numbers[root] = found.Count;
                }
                partOf[t] = numbers[root] - 1;
            }
            parts = found.ToArray();
            if (parts.Length == 1)
                parts[0] = Whole();
            else
                Measure();
            foreach ((int corner, double area) in edges.HoleAreas)
            {
                ref Part part = ref parts[numbers[DisjointSets.Root(set, corner)] - 1];
                part.holeArea += area;
                part.isOpen = true;
            }
        }

        public int Count => parts.Length;

        public ref readonly Part this[int part] => ref parts[part];

        /// <summary>The part of a triangle that takes part.</summary>
        public int Of(int triangle) => partOf[triangle];

        Part Whole() => new Part
        {
            triangles = edges.Triangles.Count, area = edges.Triangles.Area, volume = edges.SignedVolume,
            low = edges.Triangles.Bounds.min, high = edges.Triangles.Bounds.max,
        };

        void Measure()
        {
            var origins = new float3[parts.Length];
            for (int t = 0; t < partOf.Length; t++)
            {
                if (partOf[t] == None)
                    continue;
                ref Part part = ref parts[partOf[t]];
                float3 a = mesh.Corner(t, 0), b = mesh.Corner(t, 1), c = mesh.Corner(t, 2);
                if (part.triangles++ == 0)
                    origins[partOf[t]] = a;
                double3 outward = edges.OutwardArea(t);
                part.area += math.length(outward);
                part.volume += math.dot((double3)a - origins[partOf[t]], outward) / 3;
                part.low = math.min(part.low, math.min(a, math.min(b, c)));
                part.high = math.max(part.high, math.max(a, math.max(b, c)));
            }
        }

        /// <summary>Closed parts that face the other side than the mesh and lie in no other part; null for none.</summary>
        /// <param name="isInsideOut">Whether the mesh faces inwards.</param>
        public bool[] FindInverted(bool isInsideOut)
        {
            bool[] found = null;
            long angles = MaxAngles;
            for (int part = 0; part < parts.Length; part++)
                if (!parts[part].isOpen && (isInsideOut ? -parts[part].volume : parts[part].volume) < 0 && !IsInside(part, isInsideOut, ref angles))
                    (found ??= new bool[parts.Length])[part] = true;
            return found;
        }

        // By the mean winding number of those around it, so that a part which only touches another is not in it.
        bool IsInside(int part, bool isInsideOut, ref long angles)
        {
            SortByPart();
            int step = math.max(parts[part].triangles / Samples, 1);
            double sum = 0;
            for (int other = 0; other < parts.Length; other++)
            {
                if (other == part || math.any(parts[other].low > parts[part].low) || math.any(parts[other].high < parts[part].high))
                    continue;
                if ((angles -= (long)Samples * parts[other].triangles) < 0)
                    return true;
                for (int i = first[part]; i < first[part + 1]; i += step)
                    sum += Winding(other, mesh.Corner(sorted[i], 0)) * step / parts[part].triangles;
            }
            return (isInsideOut ? -sum : sum) > 0.5;
        }

        // Van Oosterom and Strackee 1983.
        double Winding(int part, float3 at)
        {
            double sum = 0;
            for (int i = first[part]; i < first[part + 1]; i++)
            {
                int t = sorted[i];
                double3 a = (float3)mesh.Corner(t, 0), b = (float3)mesh.Corner(t, 1), c = (float3)mesh.Corner(t, 2);
                (a, b, c) = (a - at, b - at, c - at);
                double la = math.length(a), lb = math.length(b), lc = math.length(c);
                double angle = Math.Atan2(math.dot(a, math.cross(b, c)),
                    la * lb * lc + math.dot(a, b) * lc + math.dot(b, c) * la + math.dot(c, a) * lb);
                sum += edges.Turned[t] ? -angle : angle;
            }
            return sum / (2 * Math.PI);
        }

        void SortByPart()
        {
            if (sorted != null)
                return;
            first = new int[parts.Length + 1];
            for (int part = 0; part < parts.Length; part++)
                first[part + 1] = first[part] + parts[part].triangles;
            sorted = new int[first[parts.Length]];
            var next = (int[])first.Clone();
            for (int t = 0; t < partOf.Length; t++)
                if (partOf[t] != None)
                    sorted[next[partOf[t]]++] = t;
        }
    }
}
