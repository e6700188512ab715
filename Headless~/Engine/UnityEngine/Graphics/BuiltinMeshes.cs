using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>The editor's own meshes, in its sizes: cube and quad of side 1, plane of 10, sphere of radius 0.5, capsule and cylinder of
    /// radius 0.5 and height 2.</summary>
    internal static class BuiltinMeshes
    {
        const int Segments = 32;

        static readonly Dictionary<string, Mesh> meshes = new Dictionary<string, Mesh>();

        public static Mesh Of(PrimitiveType type) => Find(type + ".fbx");

        /// <summary>Finds a mesh by the name that scene files know, e.g. "Cube.fbx"; null if it does not exist.</summary>
        public static Mesh Find(string file)
        {
            if (meshes.TryGetValue(file, out Mesh mesh) && mesh != null)
                return mesh;
            switch (file)
            {
                case "Cube.fbx": mesh = Cube(); break;
                case "Quad.fbx": mesh = Grid(1, 0.5f, p => new Vector3(p.x, p.y, 0), Vector3.back); break;
                case "Plane.fbx": mesh = Grid(10, 5, p => new Vector3(p.x, 0, p.y), Vector3.up); break;
                case "Sphere.fbx":
                case "New-Sphere.fbx": mesh = Turned(0); break;
                case "Capsule.fbx": mesh = Turned(0.5f); break;
                case "Cylinder.fbx": mesh = Cylinder(); break;
                default: return null;
            }
            mesh.RecalculateTangents();
            mesh.name = file.Substring(0, file.IndexOf('.'));
            mesh.hideFlags = HideFlags.HideAndDontSave;
            mesh.IsAsset = mesh.IsBuiltIn = true;
            return meshes[file] = mesh;
        }

        public static void Reset()
        {
            foreach (Mesh mesh in meshes.Values)
                Object.DestroyImmediate(mesh, true);
            meshes.Clear();
        }

        sealed class Builder
        {
            readonly List<Vector3> positions = new List<Vector3>(), normals = new List<Vector3>();
            readonly List<Vector2> uvs = new List<Vector2>();
            readonly List<int> triangles = new List<int>();

            public int Vertex(Vector3 position, Vector3 normal, Vector2 uv)
            {
                positions.Add(position);
                normals.Add(normal.normalized);
                uvs.Add(uv);
                return positions.Count - 1;
            }

            /// <summary>Turned so that it is clockwise for those who look against its normal.</summary>
            public void Triangle(int a, int b, int c)
            {
                Vector3 face = Vector3.Cross(positions[b] - positions[a], positions[c] - positions[a]);
                if (face.sqrMagnitude < 1e-12f)
                    return;
                if (Vector3.Dot(face, normals[a] + normals[b] + normals[c]) < 0)
                    (b, c) = (c, b);
                triangles.AddRange(new[] { a, b, c });
            }

            /// <summary>Between rows of width + 1 vertices each, the last of which was just added.</summary>
            public void Strips(int first, int rows, int width)
            {
                for (int r = 0; r < rows; r++)
                    for (int i = 0; i < width; i++)
                    {
                        int a = first + r * (width + 1) + i, b = a + width + 1;
                        Triangle(a, a + 1, b);
                        Triangle(a + 1, b + 1, b);
                    }
            }

            public Mesh ToMesh() => new Mesh { vertices = positions.ToArray(), normals = normals.ToArray(), uv = uvs.ToArray(),
                triangles = triangles.ToArray() };
        }

        static Mesh Grid(int cells, float half, Func<Vector2, Vector3> toPosition, Vector3 normal)
        {
            var builder = new Builder();
            for (int y = 0; y <= cells; y++)
                for (int x = 0; x <= cells; x++)
                {
                    var uv = new Vector2((float)x / cells, (float)y / cells);
                    builder.Vertex(toPosition((uv * 2 - Vector2.one) * half), normal, uv);
                }
            builder.Strips(0, cells, cells);
            return builder.ToMesh();
        }

        static Mesh Cube()
        {
            var builder = new Builder();
            for (int face = 0; face < 6; face++)
            {
                Vector3 normal = Vector3.zero, right = Vector3.zero, up = Vector3.zero;
                int axis = face / 2;
                normal[axis] = face % 2 == 0 ? 1 : -1;
                right[(axis + 1) % 3] = 1;
                up[(axis + 2) % 3] = 1;
                int first = builder.Vertex((normal - right - up) / 2, normal, new Vector2(0, 0));
                builder.Vertex((normal + right - up) / 2, normal, new Vector2(1, 0));
                builder.Vertex((normal - right + up) / 2, normal, new Vector2(0, 1));
                builder.Vertex((normal + right + up) / 2, normal, new Vector2(1, 1));
                builder.Strips(first, 1, 1);
            }
            return builder.ToMesh();
        }

        /// <summary>A sphere whose halves are pulled apart by twice the given length: a capsule, or a sphere for 0.</summary>
        static Mesh Turned(float halfBody)
        {
            var builder = new Builder();
            int rows = 0;
            for (int k = 0; k <= Segments / 2; k++)
            {
                float angle = Mathf.PI * (k / (Segments / 2f) - 0.5f);
                float y = Mathf.Sin(angle), r = Mathf.Cos(angle);
                Ring(builder, y, r, k * 2 <= Segments / 2 ? -halfBody : halfBody, (float)k / (Segments / 2));
                rows++;
                if (k == Segments / 4 && halfBody > 0)      // the equator twice, for the body between
                {
                    Ring(builder, y, r, halfBody, (float)k / (Segments / 2));
                    rows++;
                }
            }
            builder.Strips(0, rows - 1, Segments);
            return builder.ToMesh();
        }

        static void Ring(Builder builder, float y, float r, float lift, float v)
        {
            for (int i = 0; i <= Segments; i++)
            {
                float turn = 2 * Mathf.PI * i / Segments;
                var normal = new Vector3(r * Mathf.Cos(turn), y, r * Mathf.Sin(turn));
                builder.Vertex(normal * 0.5f + Vector3.up * lift, normal, new Vector2((float)i / Segments, v));
            }
        }

        static Mesh Cylinder()
        {
            var builder = new Builder();
            foreach (float y in new[] { -1f, 1f })
                for (int i = 0; i <= Segments; i++)
                {
                    float turn = 2 * Mathf.PI * i / Segments;
                    var side = new Vector3(Mathf.Cos(turn), 0, Mathf.Sin(turn));
                    builder.Vertex(side * 0.5f + Vector3.up * y, side, new Vector2((float)i / Segments, y * 0.5f + 0.5f));
                }
            builder.Strips(0, 1, Segments);
            foreach (float y in new[] { -1f, 1f })
            {
                Vector3 normal = Vector3.up * y;
                int center = builder.Vertex(normal, normal, new Vector2(0.5f, 0.5f));
                for (int i = 0; i <= Segments; i++)
                {
                    float turn = 2 * Mathf.PI * i / Segments;
                    var side = new Vector3(Mathf.Cos(turn), 0, Mathf.Sin(turn)) * 0.5f;
                    int at = builder.Vertex(side + normal, normal, new Vector2(side.x + 0.5f, side.z + 0.5f));
                    if (i > 0)
                        builder.Triangle(center, at - 1, at);
                }
            }
            return builder.ToMesh();
        }
    }
}
