using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Meshes of known shapes, closed and facing outwards unless their name says otherwise.</summary>
    static class TestMeshes
    {
        public static TriangleMesh Make(string name, Func<double, double, double3> surface, int across, int along, bool wrapsAlong, bool turn = false)
        {
            var vertices = new List<Vector3>();
            var triangles = new List<int>();
            for (int j = 0; j <= along; j++)
                for (int i = 0; i <= across; i++)
                {
                    // The seam is the same number on both sides, so that it welds.
                    double3 p = surface((double)(i % across) / across, (double)(wrapsAlong ? j % along : j) / along);
                    vertices.Add(new Vector3((float)p.x, (float)p.y, (float)p.z));
                }
            for (int j = 0; j < along; j++)
                for (int i = 0; i < across; i++)
                {
                    int a = j * (across + 1) + i, b = a + 1, c = a + across + 1, d = c + 1;
                    triangles.AddRange(turn ? new[] { a, c, b, b, c, d } : new[] { a, b, c, b, d, c });
                }
            return new TriangleMesh(name, vertices.ToArray(), triangles.ToArray());
        }

        public static TriangleMesh Sphere(float radius, int rings, Vector3 center = default)
        {
            return Make("Sphere", (u, v) => (float3)center + radius * OnSphere(u, v), 2 * rings, rings, wrapsAlong: false);
        }

        /// <summary>About the y axis.</summary>
        public static TriangleMesh Torus(float large, float small, int rings)
        {
            return Make("Torus", (u, v) =>
            {
                double r = large + small * Math.Cos(2 * Math.PI * v);
                return new double3(r * Math.Cos(2 * Math.PI * u), small * Math.Sin(2 * Math.PI * v), r * Math.Sin(2 * Math.PI * u));
            }, 2 * rings, rings, wrapsAlong: true, turn: true);
        }

        static double3 OnSphere(double u, double v)
        {
            // Each pole is one point.
            double ring = v == 0 || v == 1 ? 0 : Math.Sin(Math.PI * v);
            return new double3(ring * Math.Cos(2 * Math.PI * u), Math.Cos(Math.PI * v), ring * Math.Sin(2 * Math.PI * u));
        }

        /// <summary>12 triangles.</summary>
        public static TriangleMesh Box(Vector3 size, Vector3 center = default)
        {
            var vertices = new Vector3[8];
            for (int i = 0; i < 8; i++)
                vertices[i] = center + Vector3.Scale(size, new Vector3((i & 1) - 0.5f, (i >> 1 & 1) - 0.5f, (i >> 2) - 0.5f));
            return new TriangleMesh("Box", vertices, new[]
            {
                0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
            });
        }

        /// <summary>One face of a box, in the plane y = 0.</summary>
        public static TriangleMesh Sheet(float size)
        {
            float h = size / 2;
            return new TriangleMesh("Sheet", new[] { new Vector3(-h, 0, -h), new Vector3(h, 0, -h), new Vector3(-h, 0, h),
                new Vector3(h, 0, h) }, new[] { 0, 2, 1, 1, 2, 3 });
        }

        /// <summary>A tube about the y axis, closed at neither end.</summary>
        public static TriangleMesh Tube(float radius, float height, int sides, int rings)
        {
            return Make("Tube", (u, v) => new double3(radius * Math.Cos(2 * Math.PI * u), height * (0.5 - v),
                radius * Math.Sin(2 * Math.PI * u)), sides, rings, wrapsAlong: false);
        }

        /// <summary>The mesh without the triangles that a rule picks.</summary>
        public static TriangleMesh Without(this TriangleMesh mesh, Func<int, bool> isGone)
        {
            var kept = new List<int>();
            for (int t = 0; t < mesh.TriangleCount; t++)
                if (!isGone(t))
                    kept.AddRange(new[] { mesh.Triangles[3 * t], mesh.Triangles[3 * t + 1], mesh.Triangles[3 * t + 2] });
            return new TriangleMesh(mesh.Name + " with holes", mesh.Vertices, kept.ToArray());
        }

        /// <summary>The mesh with the triangles that a rule picks facing the other side.</summary>
        public static TriangleMesh Turned(this TriangleMesh mesh, Func<int, bool> isTurned)
        {
            var triangles = (int[])mesh.Triangles.Clone();
            for (int t = 0; t < mesh.TriangleCount; t++)
                if (isTurned(t))
                    (triangles[3 * t], triangles[3 * t + 1]) = (triangles[3 * t + 1], triangles[3 * t]);
            return new TriangleMesh(mesh.Name + " turned", mesh.Vertices, triangles);
        }

        /// <summary>Every triangle with corners of its own, each moved along the axes by at most half a distance, m.</summary>
        public static TriangleMesh Apart(this TriangleMesh mesh, float distance)
        {
            var random = new Unity.Mathematics.Random(11);
            var corners = new Vector3[mesh.Triangles.Length];
            for (int i = 0; i < corners.Length; i++)
                corners[i] = mesh.Vertices[mesh.Triangles[i]] + (Vector3)random.NextFloat3(-0.5f * distance, 0.5f * distance);
            return new TriangleMesh(mesh.Name + " apart", corners, Enumerable.Range(0, corners.Length).ToArray());
        }

        /// <summary>Every triangle drawn together towards the origin.</summary>
        public static TriangleMesh Shrunk(this TriangleMesh mesh, float scale) => mesh.Transformed(Matrix4x4.Scale(scale * Vector3.one));

        public static Vector3 CenterOf(this TriangleMesh mesh, int t) =>
            (mesh.Vertices[mesh.Triangles[3 * t]] + mesh.Vertices[mesh.Triangles[3 * t + 1]] + mesh.Vertices[mesh.Triangles[3 * t + 2]]) / 3f;
    }
}
