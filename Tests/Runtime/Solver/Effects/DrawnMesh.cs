using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The mesh that a solver has made of its surface, read back. Lengths in d, in the domain's frame.</summary>
    sealed class DrawnMesh
    {
        public readonly double3[] positions, normals, displacements;
        public readonly bool[] areFlat;
        /// <summary>Three for each triangle, clockwise seen from the air.</summary>
        public readonly uint[] indices;
        public readonly uint[] counters;

        /// <summary>Records the surface of the fluid's state as a mesh with nodes this far apart, d, which has room for it.</summary>
        public static DrawnMesh Of(TestFluid fluid, float cell)
        {
            DrawnMesh mesh = Recorded(fluid, cell);
            while (fluid.Solver.Mesh.Enlarge(mesh.counters))
                mesh = Recorded(fluid, cell);
            return mesh;
        }

        /// <summary>Records the mesh in the available room.</summary>
        public static DrawnMesh Recorded(TestFluid fluid, float cell)
        {
            fluid.Solver.MeshCell = cell;
            GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
            return new DrawnMesh(fluid.Solver.Mesh);
        }

        public DrawnMesh(SurfaceMesh mesh)
        {
            counters = GpuTest.Read<uint>(mesh.Counters, Enum.GetValues(typeof(SurfaceMesh.Counter)).Length);
            int count = (int)this[SurfaceMesh.Counter.Vertices], words = SurfaceMesh.VertexBytes / sizeof(uint);
            uint[] bits = count > 0 ? GpuTest.Read<uint>(mesh.Vertices, count * words) : new uint[0];
            int quads = (int)this[SurfaceMesh.Counter.Quads];
            indices = quads > 0 ? GpuTest.Read<uint>(mesh.Indices, 6 * quads) : new uint[0];
            positions = new double3[count];
            normals = new double3[count];
            displacements = new double3[count];
            areFlat = new bool[count];
            for (int i = 0; i < count; i++)
            {
                int at = i * words;
                positions[i] = new double3(math.asfloat(bits[at]), math.asfloat(bits[at + 1]), math.asfloat(bits[at + 2]));
                normals[i] = new double3(Snorm(bits[at + 3]), Snorm(bits[at + 3] >> 16), Snorm(bits[at + 4]));
                displacements[i] = new double3(Half(bits[at + 5]), Half(bits[at + 5] >> 16), Half(bits[at + 6]));
                areFlat[i] = Half(bits[at + 6] >> 16) > 0.5;
            }
        }

        public uint this[SurfaceMesh.Counter counter] => counters[(int)counter];

        /// <summary>Number of edges that more triangles have in one direction than in the other: 0 of a closed mesh.</summary>
        public int OpenEdges
        {
            get
            {
                int open = 0;
                foreach (int balance in Edges().Values)
                    open += balance != 0 ? 1 : 0;
                return open;
            }
        }

        /// <summary>Volume that the mesh encloses, d³; negative where it is inside out.</summary>
        public double Volume
        {
            get
            {
                double sum = 0.0;
                for (int i = 0; i < indices.Length; i += 3)
                    sum += math.dot(positions[indices[i]], math.cross(positions[indices[i + 1]], positions[indices[i + 2]]));
                return sum / 6.0;
            }
        }

        /// <summary>Area of the triangles, d².</summary>
        public double Area
        {
            get
            {
                double sum = 0.0;
                for (int i = 0; i < indices.Length; i += 3)
                    sum += 0.5 * math.length(math.cross(positions[indices[i + 1]] - positions[indices[i]],
                        positions[indices[i + 2]] - positions[indices[i]]));
                return sum;
            }
        }

        /// <summary>Edges of more than two triangles over all edges: where two sheets meet in a cell.</summary>
        public double CrowdedEdges
        {
            get
            {
                var triangles = new Dictionary<ulong, int>();
                for (int i = 0; i < indices.Length; i++)
                {
                    ulong key = EdgeOf(indices[i], indices[i % 3 == 2 ? i - 2 : i + 1]);
                    triangles.TryGetValue(key, out int count);
                    triangles[key] = count + 1;
                }
                int crowded = 0;
                foreach (int count in triangles.Values)
                    crowded += count > 2 ? 1 : 0;
                return (double)crowded / Math.Max(triangles.Count, 1);
            }
        }

        /// <summary>Returns where a ray from within the water leaves it, d; <paramref name="most"/> if it does not before.</summary>
        public double Exit(double3 from, double3 along, double most)
        {
            double first = most;
            for (int i = 0; i < indices.Length; i += 3)
            {
                double3 a = positions[indices[i]] - from, b = positions[indices[i + 1]] - from, c = positions[indices[i + 2]] - from;
                double3 normal = math.cross(b - a, c - a);
                double slope = math.dot(normal, along);
                double t = math.dot(normal, a) / slope;
                if (!(slope > 0.0) || t < 0.0 || t >= first)
                    continue;
                double3 p = along * t;
                if (math.dot(normal, math.cross(b - a, p - a)) >= 0.0 && math.dot(normal, math.cross(c - b, p - b)) >= 0.0
                    && math.dot(normal, math.cross(a - c, p - c)) >= 0.0)
                    first = t;
            }
            return first;
        }

        static ulong EdgeOf(uint a, uint b) => (ulong)Math.Min(a, b) << 32 | Math.Max(a, b);

        Dictionary<ulong, int> Edges()
        {
            var edges = new Dictionary<ulong, int>();
            for (int i = 0; i < indices.Length; i += 3)
                for (int k = 0; k < 3; k++)
                {
                    uint a = indices[i + k], b = indices[i + (k + 1) % 3];
                    Assert.That(Math.Max(a, b), Is.LessThan(positions.Length));
                    ulong key = EdgeOf(a, b);
                    edges.TryGetValue(key, out int balance);
                    edges[key] = balance + (a < b ? 1 : -1);
                }
            return edges;
        }

        static double Snorm(uint bits) => (short)(bits & 0xFFFF) / 32767.0;
        static double Half(uint bits) => UnityEngine.Mathf.HalfToFloat((ushort)(bits & 0xFFFF));
    }
}
