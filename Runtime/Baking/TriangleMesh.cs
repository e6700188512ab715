using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Triangles to check and to bake: of a <see cref="Mesh"/>, of a file that something else read, or of several meshes
    /// together. Lengths in meters, in the frame that the distance field will have.
    /// </summary>
    public sealed class TriangleMesh
    {
        /// <param name="name">For messages.</param>
        /// <param name="vertices">m.</param>
        /// <param name="triangles">Three indices of vertices a triangle, clockwise as seen from outside, as in Unity.</param>
        /// <exception cref="ArgumentException">The indices are not a whole number of triangles, or one is outside of the vertices.</exception>
        public TriangleMesh(string name, Vector3[] vertices, int[] triangles)
        {
            Name = string.IsNullOrEmpty(name) ? "unnamed mesh" : name;
            Vertices = vertices ?? throw new ArgumentNullException(nameof(vertices));
            Triangles = triangles ?? throw new ArgumentNullException(nameof(triangles));
            if (triangles.Length % 3 != 0)
                throw new ArgumentException(
                    Invariant($"'{Name}': {triangles.Length:N0} indices are not a whole number of triangles; give three for ") +
                    "each.", nameof(triangles));
            for (int i = 0; i < triangles.Length; i++)
                if ((uint)triangles[i] >= (uint)vertices.Length)
                    throw new ArgumentException(
                        Invariant($"'{Name}': triangle {i / 3:N0} refers to vertex {triangles[i]:N0} of ") +
                        Invariant($"{vertices.Length:N0}."), nameof(triangles));
        }

        /// <summary>Name by which messages call the mesh.</summary>
        public string Name { get; }

        /// <summary>m; not a copy.</summary>
        public Vector3[] Vertices { get; }

        /// <summary>Three indices of <see cref="Vertices"/> a triangle; not a copy.</summary>
        public int[] Triangles { get; }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => Triangles.Length / 3;

        internal Vector3 Corner(int triangle, int k) => Vertices[Triangles[3 * triangle + k]];

        /// <summary>Submeshes of the meshes that this was made of, with those of points and lines.</summary>
        public int SubMeshes { get; private set; } = 1;

        /// <summary>Number of submeshes of points and lines: they bound nothing and are left out.</summary>
        public int SubMeshesWithoutTriangles { get; private set; }

        /// <summary>
        /// Returns a hash of where all triangles lie and which side they face, whatever their order and common vertices. Never 0.
        /// Tells whether a mesh is still the one that was baked.
        /// </summary>
        public ulong Hash()
        {
            var sums = new ulong[Chunks.Of(TriangleCount)];
            Chunks.Run(TriangleCount, (chunk, first, end) =>
            {
                ulong part = 0;
                for (int t = first; t < end; t++)
                {
                    ulong a = HashOf(Corner(t, 0)), b = HashOf(Corner(t, 1)), c = HashOf(Corner(t, 2));
                    // Sums over the corners and over the triangles know no first one; the mixing between keeps who goes with whom.
                    part += Mix(Mix(3 * a + b) + Mix(3 * b + c) + Mix(3 * c + a));
                }
                sums[chunk] = part;
            });
            ulong sum = (ulong)TriangleCount;
            foreach (ulong part in sums)
                sum += part;
            return sum == 0 ? 1 : sum;
        }

        static ulong HashOf(float3 corner)
        {
            // But for the sign of 0.
            uint3 bits = math.asuint(corner + 0f);
            return Mix(Mix(bits.x | (ulong)bits.y << 32) + bits.z);
        }

        // The finalizer of splitmix64 (Steele, Lea and Flood 2014).
        static ulong Mix(ulong x)
        {
            x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9;
            x = (x ^ x >> 27) * 0x94D049BB133111EB;
            return x ^ x >> 31;
        }

        /// <summary>All submeshes of a mesh; quads become two triangles each.</summary>
        /// <exception cref="ArgumentNullException">The mesh is null.</exception>
        /// <exception cref="ArgumentException">The mesh cannot be read by scripts: in the editor, <see cref="Of(string, Mesh.MeshData)"/>
        /// takes it all the same.</exception>
        public static TriangleMesh Of(Mesh mesh)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh), "No mesh to bake: assign one.");
            if (!mesh.isReadable)
                throw new ArgumentException($"'{mesh.name}' cannot be read at run time: switch Read/Write on in its import settings, " +
                    $"or bake it in the editor, which reads every mesh.", nameof(mesh));
            using (Mesh.MeshDataArray data = Mesh.AcquireReadOnlyMeshData(mesh))
                return Of(mesh.name, data[0]);
        }

        /// <summary>All submeshes of a snapshot, as of UnityEditor.MeshUtility.AcquireReadOnlyMeshData; quads become two triangles each. On
        /// any thread.</summary>
        /// <param name="name">For messages.</param>
        /// <param name="data">Only read, and not kept.</param>
        public static TriangleMesh Of(string name, Mesh.MeshData data)
        {
            var triangles = new List<int>();
            int withoutTriangles = 0;
            for (int part = 0; part < data.subMeshCount; part++)
            {
                SubMeshDescriptor submesh = data.GetSubMesh(part);
                if (submesh.topology != MeshTopology.Triangles && submesh.topology != MeshTopology.Quads)
                {
                    withoutTriangles++;
                    continue;
                }
                using (var indices = new NativeArray<int>(submesh.indexCount, Allocator.Persistent, NativeArrayOptions.UninitializedMemory))
                {
                    data.GetIndices(indices, part);
                    if (submesh.topology == MeshTopology.Triangles)
                        triangles.AddRange(indices.ToArray());
                    else
                        AddQuads(indices, triangles);
                }
            }
            return new TriangleMesh(name, Positions(data), triangles.ToArray())
            {
                SubMeshes = data.subMeshCount,
                SubMeshesWithoutTriangles = withoutTriangles
            };
        }

        static void AddQuads(NativeArray<int> indices, List<int> triangles)
        {
            for (int i = 0; i + 3 < indices.Length; i += 4)
            {
                triangles.Add(indices[i]);
                triangles.Add(indices[i + 1]);
                triangles.Add(indices[i + 2]);
                triangles.Add(indices[i]);
                triangles.Add(indices[i + 2]);
                triangles.Add(indices[i + 3]);
            }
        }

        static Vector3[] Positions(Mesh.MeshData data)
        {
            // A mesh without vertices has no such attribute, and to ask for it throws.
            if (!data.HasVertexAttribute(VertexAttribute.Position))
                return Array.Empty<Vector3>();
            using (var positions = new NativeArray<Vector3>(data.vertexCount, Allocator.Persistent, NativeArrayOptions.UninitializedMemory))
            {
                data.GetVertices(positions);
                return positions.ToArray();
            }
        }

        /// <summary>The mesh in another frame. A mirroring matrix keeps outside outside.</summary>
        public TriangleMesh Transformed(Matrix4x4 matrix)
        {
            var vertices = new Vector3[Vertices.Length];
            for (int i = 0; i < vertices.Length; i++)
                vertices[i] = matrix.MultiplyPoint3x4(Vertices[i]);
            var triangles = (int[])Triangles.Clone();
            if (matrix.determinant < 0f)
                for (int i = 0; i < triangles.Length; i += 3)
                    (triangles[i + 1], triangles[i + 2]) = (triangles[i + 2], triangles[i + 1]);
            return new TriangleMesh(Name, vertices, triangles) { SubMeshes = SubMeshes, SubMeshesWithoutTriangles = SubMeshesWithoutTriangles };
        }

        /// <summary>The mesh without some of its triangles.</summary>
        internal TriangleMesh Without(bool[] isGone)
        {
            var kept = new List<int>();
            for (int t = 0; t < TriangleCount; t++)
                for (int k = 0; k < 3 && !isGone[t]; k++)
                    kept.Add(Triangles[3 * t + k]);
            return new TriangleMesh(Name, Vertices, kept.ToArray()) { SubMeshes = SubMeshes, SubMeshesWithoutTriangles = SubMeshesWithoutTriangles };
        }

        /// <summary>Several meshes as one: where closed ones overlap, inside is what is inside of any.</summary>
        public static TriangleMesh Combine(string name, IReadOnlyList<TriangleMesh> meshes)
        {
            if (meshes == null)
                throw new ArgumentNullException(nameof(meshes));
            var vertices = new List<Vector3>();
            var triangles = new List<int>();
            int parts = 0, withoutTriangles = 0;
            for (int m = 0; m < meshes.Count; m++)
            {
                int first = vertices.Count;
                vertices.AddRange(meshes[m].Vertices);
                foreach (int index in meshes[m].Triangles)
                    triangles.Add(first + index);
                parts += meshes[m].SubMeshes;
                withoutTriangles += meshes[m].SubMeshesWithoutTriangles;
            }
            return new TriangleMesh(name, vertices.ToArray(), triangles.ToArray())
            {
                SubMeshes = parts,
                SubMeshesWithoutTriangles = withoutTriangles
            };
        }
    }
}
