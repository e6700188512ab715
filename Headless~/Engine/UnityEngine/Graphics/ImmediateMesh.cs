using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>The vertices between GL.Begin and GL.End.</summary>
    internal sealed class ImmediateMesh
    {
        const int Units = 4;

        readonly List<Vector3> positions = new List<Vector3>();
        readonly List<Color> colors = new List<Color>();
        readonly List<Vector3>[] uvs = new List<Vector3>[Units];
        readonly Vector3[] uv = new Vector3[Units];
        int mode = -1;

        public Color Color = Color.white;

        public ImmediateMesh()
        {
            for (int i = 0; i < Units; i++)
                uvs[i] = new List<Vector3>();
        }

        public void Begin(int mode)
        {
            if (this.mode >= 0)
                throw new InvalidOperationException("GL.Begin inside of GL.Begin; call GL.End first.");
            this.mode = mode;
            positions.Clear();
            colors.Clear();
            Color = Color.white;
            foreach (List<Vector3> list in uvs)
                list.Clear();
        }

        public void SetTexCoord(int unit, Vector3 value)
        {
            if (unit < 0 || unit >= Units)
                throw new ArgumentOutOfRangeException(nameof(unit), unit, $"GL.MultiTexCoord: the headless host has units 0 to {Units - 1}.");
            uv[unit] = value;
        }

        public void Add(Vector3 position)
        {
            if (mode < 0)
                throw new InvalidOperationException("GL.Vertex outside of GL.Begin and GL.End.");
            positions.Add(position);
            colors.Add(Color);
            for (int i = 0; i < Units; i++)
                uvs[i].Add(uv[i]);
        }

        public void End(in Matrix4x4 matrix)
        {
            int drawn = mode;
            mode = -1;
            if (drawn < 0)
                throw new InvalidOperationException("GL.End without GL.Begin.");
            if (positions.Count == 0)
                return;
            var mesh = new Mesh { name = "GL", IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave };
            mesh.SetVertices(positions);
            mesh.SetColors(colors);
            for (int i = 0; i < Units; i++)
                mesh.SetUVs(i, uvs[i]);
            mesh.SetIndices(Indices(drawn, out MeshTopology topology), topology, 0);
            Graphics.DrawMeshNow(mesh, matrix);
            Object.DestroyImmediate(mesh);
        }

        int[] Indices(int mode, out MeshTopology topology)
        {
            var indices = new List<int>();
            int count = positions.Count;
            topology = mode == GL.LINES ? MeshTopology.Lines : mode == GL.LINE_STRIP ? MeshTopology.LineStrip : MeshTopology.Triangles;
            switch (mode)
            {
                case GL.TRIANGLES:
                case GL.LINES:
                case GL.LINE_STRIP:
                    int step = mode == GL.TRIANGLES ? 3 : mode == GL.LINES ? 2 : 1;
                    for (int i = 0; i < count / step * step; i++)
                        indices.Add(i);
                    break;
                case GL.TRIANGLE_STRIP:
                    for (int i = 2; i < count; i++)
                        indices.AddRange(i % 2 == 0 ? new[] { i - 2, i - 1, i } : new[] { i - 1, i - 2, i });
                    break;
                case GL.QUADS:
                    for (int i = 0; i + 3 < count; i += 4)
                        indices.AddRange(new[] { i, i + 1, i + 2, i, i + 2, i + 3 });
                    break;
                default:
                    throw new ArgumentException($"GL.Begin({mode}): no such kind of primitive.");
            }
            return indices.ToArray();
        }
    }
}
