using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace Host.Reference
{
    /// <summary>A mesh of polygons as <see cref="CyclesScene"/> hands it to Blender. Its faces have their outside as Unity's have.</summary>
    sealed class MeshData
    {
        public readonly List<Vector3> Vertices = new();
        public readonly List<int[]> Faces = new();

        /// <summary>Converts a mesh of Unity's; vertices at one position become one, so that its edges can be round again.</summary>
        public static MeshData Of(Mesh mesh, int subMesh)
        {
            var data = new MeshData();
            var known = new Dictionary<Vector3, int>();
            Vector3[] vertices = mesh.vertices;
            int[] triangles = mesh.GetTriangles(subMesh), welded = new int[triangles.Length];
            for (int i = 0; i < triangles.Length; i++)
            {
                Vector3 vertex = vertices[triangles[i]];
                if (!known.TryGetValue(vertex, out welded[i]))
                {
                    known[vertex] = welded[i] = data.Vertices.Count;
                    data.Vertices.Add(vertex);
                }
            }
            for (int i = 0; i < triangles.Length; i += 3)
                if (welded[i] != welded[i + 1] && welded[i + 1] != welded[i + 2] && welded[i] != welded[i + 2])
                    data.Faces.Add(new[] { welded[i], welded[i + 1], welded[i + 2] });
            return data;
        }

        /// <summary>In the world, and a little thicker: where faces of two solids lie in one plane, each would shade the other.</summary>
        /// <param name="grown">How far vertices go outwards, m.</param>
        public MeshData InWorld(Matrix4x4 toWorld, float grown)
        {
            var moved = new MeshData();
            foreach (Vector3 vertex in Vertices)
                moved.Vertices.Add(toWorld.MultiplyPoint3x4(vertex));
            var normals = new Vector3[Vertices.Count];
            foreach (int[] face in Faces)
            {
                int[] turned = (int[])face.Clone();
                if (toWorld.determinant < 0f)
                    System.Array.Reverse(turned);
                moved.Faces.Add(turned);
                Vector3 first = moved.Vertices[turned[0]];
                Vector3 normal = Vector3.Cross(moved.Vertices[turned[1]] - first, moved.Vertices[turned[2]] - first);
                foreach (int corner in turned)
                    normals[corner] += normal;
            }
            for (int i = 0; i < normals.Length; i++)
                moved.Vertices[i] += grown * normals[i].normalized;
            return moved;
        }

        /// <summary>Writes the format that read_mesh of cycles.py reads.</summary>
        public void Write(string file)
        {
            using var writer = new BinaryWriter(File.Create(file));
            int corners = 0;
            foreach (int[] face in Faces)
                corners += face.Length;
            foreach (int count in new[] { Vertices.Count, corners, Faces.Count })
                writer.Write(count);
            foreach (Vector3 vertex in Vertices)
            {
                writer.Write(vertex.x);
                writer.Write(vertex.y);
                writer.Write(vertex.z);
            }
            foreach (int[] face in Faces)
                foreach (int corner in face)
                    writer.Write(corner);
            foreach (int[] face in Faces)
                writer.Write(face.Length);
        }
    }
}
