using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed partial class Mesh : Object
    {
        struct Submesh
        {
            public int[] Indices;   // base vertex not yet added
            public MeshTopology Topology;
            public int BaseVertex;
            public Bounds Bounds;
        }

        Vector3[] positions = Array.Empty<Vector3>(), normalData = Array.Empty<Vector3>();
        Vector4[] tangentData = Array.Empty<Vector4>();
        Color[] colorData = Array.Empty<Color>();
        readonly Vector4[][] uvData = new Vector4[8][];
        readonly int[] uvSize = new int[8];
        readonly List<Submesh> submeshes = new List<Submesh> { new Submesh { Indices = Array.Empty<int>() } };
        MeshBuffers buffers;
        /// <summary>The engine's own: its memory on the device is not a leak.</summary>
        internal bool IsBuiltIn;

        public Mesh() { }

        // ---- attributes; the vertex count is the positions'

        public int vertexCount => positions.Length;
        public bool isReadable { get; private set; } = true;
        public IndexFormat indexFormat { get; set; }
        public Bounds bounds { get; set; }

        public Vector3[] vertices { get => MayAccess("vertices") ? (Vector3[])positions.Clone() : Array.Empty<Vector3>();
            set => SetPositions(value); }
        public Vector3[] normals { get => MayAccess("normals") ? (Vector3[])normalData.Clone() : Array.Empty<Vector3>();
            set => SetNormalsCore(value); }
        public Vector4[] tangents { get => MayAccess("tangents") ? (Vector4[])tangentData.Clone() : Array.Empty<Vector4>();
            set => SetTangentsCore(value); }
        public Color[] colors { get => MayAccess("colors") ? (Color[])colorData.Clone() : Array.Empty<Color>(); set => SetColorsCore(value); }
        public Color32[] colors32 { get => Array.ConvertAll(MayAccess("colors") ? colorData : Array.Empty<Color>(), c => (Color32)c);
            set => SetColorsCore(value == null ? null : Array.ConvertAll(value, c => (Color)c)); }
        public Vector2[] uv { get => Array.ConvertAll(ReadUv(0), v => (Vector2)v); set => SetUVs(0, value); }
        public Vector2[] uv2 { get => Array.ConvertAll(ReadUv(1), v => (Vector2)v); set => SetUVs(1, value); }
        public Vector2[] uv3 { get => Array.ConvertAll(ReadUv(2), v => (Vector2)v); set => SetUVs(2, value); }
        public Vector2[] uv4 { get => Array.ConvertAll(ReadUv(3), v => (Vector2)v); set => SetUVs(3, value); }
        public Vector2[] uv5 { get => Array.ConvertAll(ReadUv(4), v => (Vector2)v); set => SetUVs(4, value); }
        public Vector2[] uv6 { get => Array.ConvertAll(ReadUv(5), v => (Vector2)v); set => SetUVs(5, value); }
        public Vector2[] uv7 { get => Array.ConvertAll(ReadUv(6), v => (Vector2)v); set => SetUVs(6, value); }
        public Vector2[] uv8 { get => Array.ConvertAll(ReadUv(7), v => (Vector2)v); set => SetUVs(7, value); }

        /// <summary>Whether scripts can reach the data; otherwise it is told once a call.</summary>
        bool MayAccess(string what)
        {
            if (!isReadable)
                GpuError.Report($"Mesh '{name}': its {what} cannot be accessed; UploadMeshData made it no longer readable, or " +
                    $"Read/Write is off in its import settings.",
                    $"Not allowed to access {what} on mesh '{name}' (isReadable is false; Read/Write must be enabled in import settings)");
            return isReadable;
        }

        void SetPositions(Vector3[] value)
        {
            if (!MayAccess("vertices"))
                return;
            value ??= Array.Empty<Vector3>();
            if (value.Length < positions.Length && positions.Length > 0)
                foreach (Submesh submesh in submeshes)
                    foreach (int index in submesh.Indices)
                        if (index + submesh.BaseVertex >= value.Length)
                        {
                            GpuError.Report($"Mesh '{name}': {value.Length} vertices are too few, its triangles reference vertex " +
                                $"{index + submesh.BaseVertex}; Clear it first.",
                                $"Mesh.vertices is too small. The supplied vertex array has less vertices than are referenced by the " +
                                    $"triangles array.");
                            return;
                        }
            positions = (Vector3[])value.Clone();
            verticesAreSet = true;
            Changed();
        }

        void SetNormalsCore(Vector3[] value)
        {
            if (MayAccess("normals"))
                normalData = Checked(value, "normals");
        }

        void SetTangentsCore(Vector4[] value)
        {
            if (MayAccess("tangents"))
                tangentData = Checked(value, "tangents");
        }

        void SetColorsCore(Color[] value)
        {
            if (MayAccess("colors"))
                colorData = Checked(value, "colors");
        }


        void SetUv(int channel, int size, Vector4[] value)
        {
            if (channel < 0 || channel > 7)
                throw new ArgumentOutOfRangeException(nameof(channel), channel, $"Mesh '{name}' has UV channels 0 to 7.");
            if (!MayAccess("uv"))
                return;
            uvData[channel] = Checked(value, "uv");
            uvSize[channel] = size;
        }

        Vector4[] ReadUv(int channel) => MayAccess("uv") ? Uv(channel) : Array.Empty<Vector4>();
        Vector4[] Uv(int channel) => uvData[channel] ?? Array.Empty<Vector4>();

        T[] Checked<T>(T[] value, string what)
        {
            value ??= Array.Empty<T>();
            if (value.Length != 0 && value.Length != vertexCount)
            {
                GpuError.Report($"Mesh '{name}': {value.Length} {what} for {vertexCount} vertices; their number must be equal or 0.",
                    $"Mesh.{what} is out of bounds. The supplied array needs to be the same size as the Mesh.vertices array.");
                return Array.Empty<T>();
            }
            verticesAreSet = true;
            Changed();
            return (T[])value.Clone();
        }

        public void SetVertices(Vector3[] inVertices) => SetPositions(inVertices);
        public void SetVertices(List<Vector3> inVertices) => SetVertices(inVertices?.ToArray());
        public void SetVertices(Vector3[] inVertices, int start, int length) => SetVertices(Part(inVertices, start, length));
        public void SetVertices(Vector3[] inVertices, int start, int length, MeshUpdateFlags flags) => SetVertices(Part(inVertices, start, length));
        public void SetVertices(List<Vector3> inVertices, int start, int length) => SetVertices(Part(inVertices?.ToArray(), start, length));
        public void SetVertices(List<Vector3> inVertices, int start, int length, MeshUpdateFlags flags)
            => SetVertices(Part(inVertices?.ToArray(), start, length));
        public void SetVertices<T>(NativeArray<T> inVertices) where T : struct => SetVertices(Cast<T, Vector3>(inVertices));
        public void SetVertices<T>(NativeArray<T> inVertices, int start, int length) where T : struct
            => SetVertices(Cast<T, Vector3>(inVertices), start, length);
        public void SetNormals(Vector3[] inNormals) => SetNormalsCore(inNormals);
        public void SetNormals(List<Vector3> inNormals) => SetNormals(inNormals?.ToArray());
        public void SetNormals(Vector3[] inNormals, int start, int length) => SetNormals(Part(inNormals, start, length));
        public void SetNormals(Vector3[] inNormals, int start, int length, MeshUpdateFlags flags) => SetNormals(Part(inNormals, start, length));
        public void SetNormals(List<Vector3> inNormals, int start, int length) => SetNormals(Part(inNormals?.ToArray(), start, length));
        public void SetNormals(List<Vector3> inNormals, int start, int length, MeshUpdateFlags flags)
            => SetNormals(Part(inNormals?.ToArray(), start, length));
        public void SetNormals<T>(NativeArray<T> inNormals) where T : struct => SetNormals(Cast<T, Vector3>(inNormals));
        public void SetNormals<T>(NativeArray<T> inNormals, int start, int length) where T : struct
            => SetNormals(Cast<T, Vector3>(inNormals), start, length);
        public void SetTangents(Vector4[] inTangents) => SetTangentsCore(inTangents);
        public void SetTangents(List<Vector4> inTangents) => SetTangents(inTangents?.ToArray());
        public void SetTangents(Vector4[] inTangents, int start, int length) => SetTangents(Part(inTangents, start, length));
        public void SetTangents(Vector4[] inTangents, int start, int length, MeshUpdateFlags flags) => SetTangents(Part(inTangents, start, length));
        public void SetTangents(List<Vector4> inTangents, int start, int length) => SetTangents(Part(inTangents?.ToArray(), start, length));
        public void SetTangents(List<Vector4> inTangents, int start, int length, MeshUpdateFlags flags)
            => SetTangents(Part(inTangents?.ToArray(), start, length));
        public void SetTangents<T>(NativeArray<T> inTangents) where T : struct => SetTangents(Cast<T, Vector4>(inTangents));
        public void SetTangents<T>(NativeArray<T> inTangents, int start, int length) where T : struct
            => SetTangents(Cast<T, Vector4>(inTangents), start, length);
        public void SetColors(Color[] inColors) => SetColorsCore(inColors);
        public void SetColors(List<Color> inColors) => SetColors(inColors?.ToArray());
        public void SetColors(Color[] inColors, int start, int length) => SetColors(Part(inColors, start, length));
        public void SetColors(Color[] inColors, int start, int length, MeshUpdateFlags flags) => SetColors(Part(inColors, start, length));
        public void SetColors(List<Color> inColors, int start, int length) => SetColors(Part(inColors?.ToArray(), start, length));
        public void SetColors(List<Color> inColors, int start, int length, MeshUpdateFlags flags)
            => SetColors(Part(inColors?.ToArray(), start, length));
        public void SetColors(Color32[] inColors) => SetColorsCore(inColors == null ? null : Array.ConvertAll(inColors, c => (Color)c));
        public void SetColors(List<Color32> inColors) => SetColors(inColors?.ToArray());
        public void SetColors(Color32[] inColors, int start, int length) => SetColors(Part(inColors, start, length));
        public void SetColors(Color32[] inColors, int start, int length, MeshUpdateFlags flags) => SetColors(Part(inColors, start, length));
        public void SetColors(List<Color32> inColors, int start, int length) => SetColors(Part(inColors?.ToArray(), start, length));
        public void SetColors(List<Color32> inColors, int start, int length, MeshUpdateFlags flags)
            => SetColors(Part(inColors?.ToArray(), start, length));
        public void SetColors<T>(NativeArray<T> inColors) where T : struct => SetColors(Cast<T, Color>(inColors));
        public void SetColors<T>(NativeArray<T> inColors, int start, int length) where T : struct
            => SetColors(Cast<T, Color>(inColors), start, length);
        public void SetUVs(int channel, Vector2[] uvs) => SetUv(channel, 2, uvs == null ? null : Array.ConvertAll(uvs, v => (Vector4)v));
        public void SetUVs(int channel, List<Vector2> uvs) => SetUVs(channel, uvs?.ToArray());
        public void SetUVs(int channel, Vector2[] uvs, int start, int length) => SetUVs(channel, Part(uvs, start, length));
        public void SetUVs(int channel, List<Vector2> uvs, int start, int length) => SetUVs(channel, Part(uvs?.ToArray(), start, length));
        public void GetUVs(int channel, List<Vector2> uvs) => Fill(uvs, ReadUv(channel), v => (Vector2)v);
        public void SetUVs(int channel, Vector3[] uvs) => SetUv(channel, 3, uvs == null ? null : Array.ConvertAll(uvs, v => (Vector4)v));
        public void SetUVs(int channel, List<Vector3> uvs) => SetUVs(channel, uvs?.ToArray());
        public void SetUVs(int channel, Vector3[] uvs, int start, int length) => SetUVs(channel, Part(uvs, start, length));
        public void SetUVs(int channel, List<Vector3> uvs, int start, int length) => SetUVs(channel, Part(uvs?.ToArray(), start, length));
        public void GetUVs(int channel, List<Vector3> uvs) => Fill(uvs, ReadUv(channel), v => (Vector3)v);
        public void SetUVs(int channel, Vector4[] uvs) => SetUv(channel, 4, uvs == null ? null : Array.ConvertAll(uvs, v => v));
        public void SetUVs(int channel, List<Vector4> uvs) => SetUVs(channel, uvs?.ToArray());
        public void SetUVs(int channel, Vector4[] uvs, int start, int length) => SetUVs(channel, Part(uvs, start, length));
        public void SetUVs(int channel, List<Vector4> uvs, int start, int length) => SetUVs(channel, Part(uvs?.ToArray(), start, length));
        public void GetUVs(int channel, List<Vector4> uvs) => Fill(uvs, ReadUv(channel), v => v);

        public void GetVertices(List<Vector3> vertices) => Fill(vertices, MayAccess("vertices") ? positions : Array.Empty<Vector3>(), v => v);
        public void GetNormals(List<Vector3> normals) => Fill(normals, MayAccess("normals") ? normalData : Array.Empty<Vector3>(), v => v);
        public void GetTangents(List<Vector4> tangents) => Fill(tangents, MayAccess("tangents") ? tangentData : Array.Empty<Vector4>(), v => v);
        public void GetColors(List<Color> colors) => Fill(colors, MayAccess("colors") ? colorData : Array.Empty<Color>(), c => c);
        public void GetColors(List<Color32> colors) => Fill(colors, MayAccess("colors") ? colorData : Array.Empty<Color>(), c => (Color32)c);

        static void Fill<S, T>(List<T> target, S[] source, Converter<S, T> convert)
        {
            if (target == null)
                throw new ArgumentNullException(nameof(target));
            target.Clear();
            foreach (S value in source)
                target.Add(convert(value));
        }

        static T[] Part<T>(T[] all, int start, int length)
        {
            var part = new T[length];
            Array.Copy(all, start, part, 0, length);
            return part;
        }

        static U[] Cast<T, U>(NativeArray<T> array) where T : struct where U : struct => MemoryMarshal.Cast<byte, U>(Transfer.Bytes(array)).ToArray();

        // ---- submeshes

        public int subMeshCount
        {
            get => submeshes.Count;
            set
            {
                while (submeshes.Count > value)
                    submeshes.RemoveAt(submeshes.Count - 1);
                while (submeshes.Count < value)
                    submeshes.Add(new Submesh { Indices = Array.Empty<int>() });
                Changed();
            }
        }

        public int[] triangles
        {
            get => MayAccess("triangles") ? AllIndices() : Array.Empty<int>();
            set
            {
                subMeshCount = 1;
                SetIndices(value, MeshTopology.Triangles, 0);
            }
        }

        int[] AllIndices()
        {
            var all = new List<int>();
            for (int i = 0; i < submeshes.Count; i++)
                all.AddRange(Placed(At(i), true));
            return all.ToArray();
        }

        static int[] Placed(Submesh s, bool applyBaseVertex)
        {
            int add = applyBaseVertex ? s.BaseVertex : 0;
            return Array.ConvertAll(s.Indices, i => i + add);
        }

        Submesh At(int submesh) => submesh >= 0 && submesh < submeshes.Count ? submeshes[submesh]
            : throw new ArgumentException($"Mesh '{name}' has {submeshes.Count} submeshes; submesh {submesh} does not exist.");

        public int[] GetIndices(int submesh) => GetIndices(submesh, true);
        public int[] GetIndices(int submesh, bool applyBaseVertex) => MayAccess("indices") ? Placed(At(submesh), applyBaseVertex)
            : Array.Empty<int>();

        public int[] GetTriangles(int submesh) => GetIndices(submesh);
        public int[] GetTriangles(int submesh, bool applyBaseVertex) => GetIndices(submesh, applyBaseVertex);
        public void GetIndices(List<int> indices, int submesh) => Fill(indices, GetIndices(submesh), i => i);
        public void GetIndices(List<int> indices, int submesh, bool applyBaseVertex) => Fill(indices, GetIndices(submesh, applyBaseVertex), i => i);
        public void GetTriangles(List<int> triangles, int submesh) => GetIndices(triangles, submesh);
        public void GetTriangles(List<int> triangles, int submesh, bool applyBaseVertex) => GetIndices(triangles, submesh, applyBaseVertex);
        public MeshTopology GetTopology(int submesh) => At(submesh).Topology;
        public uint GetIndexCount(int submesh) => (uint)At(submesh).Indices.Length;
        public uint GetBaseVertex(int submesh) => (uint)At(submesh).BaseVertex;

        public uint GetIndexStart(int submesh)
        {
            At(submesh);
            uint start = 0;
            for (int i = 0; i < submesh; i++)
                start += (uint)submeshes[i].Indices.Length;
            return start;
        }

        public SubMeshDescriptor GetSubMesh(int index)
            => new SubMeshDescriptor((int)GetIndexStart(index), (int)GetIndexCount(index), GetTopology(index))
        {
            baseVertex = At(index).BaseVertex, vertexCount = vertexCount, bounds = At(index).Bounds,
        };

        public void SetTriangles(int[] triangles, int submesh) => SetIndices(triangles, MeshTopology.Triangles, submesh);
        public void SetTriangles(int[] triangles, int submesh, bool calculateBounds)
            => SetIndices(triangles, MeshTopology.Triangles, submesh, calculateBounds);
        public void SetTriangles(int[] triangles, int submesh, bool calculateBounds, int baseVertex)
            => SetIndices(triangles, MeshTopology.Triangles, submesh, calculateBounds, baseVertex);
        public void SetTriangles(int[] triangles, int trianglesStart, int trianglesLength, int submesh, bool calculateBounds = true,
            int baseVertex = 0) => SetIndices(Part(triangles, trianglesStart, trianglesLength), MeshTopology.Triangles, submesh,
            calculateBounds, baseVertex);
        public void SetTriangles(ushort[] triangles, int submesh, bool calculateBounds = true, int baseVertex = 0)
            => SetIndices(Array.ConvertAll(triangles, i => (int)i), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);
        public void SetTriangles(List<int> triangles, int submesh) => SetIndices(triangles.ToArray(), MeshTopology.Triangles, submesh);
        public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds)
            => SetIndices(triangles.ToArray(), MeshTopology.Triangles, submesh, calculateBounds);
        public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds, int baseVertex)
            => SetIndices(triangles.ToArray(), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);
        public void SetIndices(List<int> indices, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0)
            => SetIndices(indices.ToArray(), topology, submesh, calculateBounds, baseVertex);
        public void SetIndices(ushort[] indices, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0)
            => SetIndices(Array.ConvertAll(indices, i => (int)i), topology, submesh, calculateBounds, baseVertex);
        public void SetIndices(int[] indices, int indicesStart, int indicesLength, MeshTopology topology, int submesh,
            bool calculateBounds = true, int baseVertex = 0) => SetIndices(Part(indices, indicesStart, indicesLength), topology, submesh,
            calculateBounds, baseVertex);
        public void SetIndices(int[] indices, MeshTopology topology, int submesh) => SetIndices(indices, topology, submesh, true);
        public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds)
            => SetIndices(indices, topology, submesh, calculateBounds, 0);

        public void SetIndices<T>(NativeArray<T> indices, MeshTopology topology, int submesh, bool calculateBounds = true,
            int baseVertex = 0) where T : struct
        {
            if (ElementSize<T>.Bytes == 2)
                SetIndices(Cast<T, ushort>(indices), topology, submesh, calculateBounds, baseVertex);
            else
                SetIndices(Cast<T, int>(indices), topology, submesh, calculateBounds, baseVertex);
        }

        public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds, int baseVertex)
        {
            if (!MayAccess("indices"))
                return;
            indices ??= Array.Empty<int>();
            At(submesh);
            if (topology == MeshTopology.Triangles && indices.Length % 3 != 0)
            {
                GpuError.Report($"Mesh '{name}': {indices.Length} indices are not a whole number of triangles.",
                    "Failed setting triangles. The number of supplied triangle indices must be a multiple of 3.");
                return;
            }
            foreach (int index in indices)
                if (index + baseVertex < 0 || index + baseVertex >= vertexCount)
                {
                    GpuError.Report($"Mesh '{name}': index {index} (plus base vertex {baseVertex}) of submesh {submesh} is outside of " +
                        $"its {vertexCount} vertices.",
                        "Failed setting triangles. Some indices are referencing out of bounds vertices.");
                    return;
                }
            submeshes[submesh] = new Submesh { Indices = (int[])indices.Clone(), Topology = topology, BaseVertex = baseVertex,
                Bounds = calculateBounds ? BoundsOf(indices, baseVertex) : submeshes[submesh].Bounds };
            indexRoom = 0;
            if (calculateBounds)
                MergeBounds();
            Changed();
        }

        // ---- derived

        public void Clear() => Clear(true);
        public void Clear(bool keepVertexLayout)
        {
            positions = normalData = Array.Empty<Vector3>();
            tangentData = Array.Empty<Vector4>();
            colorData = Array.Empty<Color>();
            Array.Clear(uvData, 0, 8);
            weightData = Array.Empty<BoneWeight>();
            bindData = Array.Empty<Matrix4x4>();
            layout = keepVertexLayout ? layout : null;
            indexRoom = 0;
            submeshes.Clear();
            subMeshCount = 1;
            bounds = default;
        }

        public void RecalculateBounds() => RecalculateBounds(MeshUpdateFlags.Default);
        public void RecalculateBounds(MeshUpdateFlags flags)
        {
            for (int i = 0; i < submeshes.Count; i++)
            {
                Submesh s = submeshes[i];
                s.Bounds = BoundsOf(s.Indices, s.BaseVertex);
                submeshes[i] = s;
            }
            if (positions.Length == 0)
            {
                bounds = default;
                return;
            }
            Vector3 min = positions[0], max = positions[0];
            foreach (Vector3 p in positions)
            {
                min = Vector3.Min(min, p);
                max = Vector3.Max(max, p);
            }
            bounds = new Bounds((min + max) / 2, max - min);
        }

        Bounds BoundsOf(int[] indices, int baseVertex)
        {
            if (indices.Length == 0)
                return default;
            Vector3 min = positions[indices[0] + baseVertex], max = min;
            foreach (int index in indices)
            {
                min = Vector3.Min(min, positions[index + baseVertex]);
                max = Vector3.Max(max, positions[index + baseVertex]);
            }
            return new Bounds((min + max) / 2, max - min);
        }

        void MergeBounds()
        {
            bool any = false;
            Bounds all = default;
            foreach (Submesh s in submeshes)
            {
                if (s.Indices.Length == 0)
                    continue;
                if (any)
                    all.Encapsulate(s.Bounds);
                else
                    all = s.Bounds;
                any = true;
            }
            bounds = all;
        }

        public void RecalculateNormals() => RecalculateNormals(MeshUpdateFlags.Default);
        public void RecalculateNormals(MeshUpdateFlags flags)
        {
            var sums = new Vector3[positions.Length];
            foreach (Submesh s in submeshes)
                for (int i = 0; s.Topology == MeshTopology.Triangles && i + 2 < s.Indices.Length; i += 3)
                {
                    int a = s.Indices[i] + s.BaseVertex, b = s.Indices[i + 1] + s.BaseVertex, c = s.Indices[i + 2] + s.BaseVertex;
                    Vector3 area = Vector3.Cross(positions[b] - positions[a], positions[c] - positions[a]);
                    sums[a] += area;
                    sums[b] += area;
                    sums[c] += area;
                }
            SetNormalsCore(Array.ConvertAll(sums, n => n.normalized));
        }

        public void MarkDynamic() { }
        public void MarkModified() { }
        public void Optimize() { }
        public void UploadMeshData(bool markNoLongerReadable) => isReadable &= !markNoLongerReadable;

        public bool HasVertexAttribute(VertexAttribute attr)
        {
            switch (attr)
            {
                case VertexAttribute.Position: return positions.Length > 0;
                case VertexAttribute.Normal: return normalData.Length > 0;
                case VertexAttribute.Tangent: return tangentData.Length > 0;
                case VertexAttribute.Color: return colorData.Length > 0;
                default: return attr >= VertexAttribute.TexCoord0 && attr <= VertexAttribute.TexCoord7
                    && Uv(attr - VertexAttribute.TexCoord0).Length > 0;
            }
        }

        // ---- on the device

        void Changed()
        {
            buffers?.Dispose();
            buffers = null;
            memory?.Dispose();
            memory = null;
        }

        /// <summary>Fills in indices and vertex streams of a draw; false when the submesh has none.</summary>
        internal bool Bind(int submesh, ShaderProgram vertex, ref DeviceDraw draw)
        {
            int[] indices = At(submesh).Indices;
            if (indices.Length == 0 || positions.Length == 0)
                return false;
            if (At(submesh).Topology == MeshTopology.Quads)
                throw new NotSupportedException($"Mesh '{name}' has a submesh of quads, which Direct3D 11 does not draw; use triangles.");
            if (layout != null)
                return BindLayout(submesh, vertex, ref draw);
            if (buffers == null || buffers.Owner != Player.Device)
            {
                buffers = new MeshBuffers(name, Player.Device, positions, normalData, tangentData, colorData, uvData, AllIndices());
                if (!IsBuiltIn)
                    LiveObjects.Add(buffers, "Mesh", name);
            }
            draw.Indices = buffers.Indices;
            draw.Indices32 = true;
            draw.FirstVertex = (int)GetIndexStart(submesh);
            draw.VertexCount = indices.Length;
            draw.Streams = buffers.Streams(vertex);
            return true;
        }

        internal override void ReleaseNative() => Changed();

        internal override Object CloneNative()
        {
            var copy = new Mesh { positions = positions, normalData = normalData, tangentData = tangentData, colorData = colorData,
                bounds = bounds, indexFormat = indexFormat, isReadable = isReadable, weightData = weightData, bindData = bindData };
            Array.Copy(uvData, copy.uvData, 8);
            Array.Copy(uvSize, copy.uvSize, 8);
            copy.submeshes.Clear();
            copy.submeshes.AddRange(submeshes);
            copy.CopyLayout(this);
            return copy;
        }
    }
}

namespace UnityEngine.Rendering
{
    public struct SubMeshDescriptor
    {
        public SubMeshDescriptor(int indexStart, int indexCount, MeshTopology topology = MeshTopology.Triangles)
        {
            this = default;
            this.indexStart = indexStart;
            this.indexCount = indexCount;
            this.topology = topology;
        }

        public Bounds bounds { get; set; }
        public MeshTopology topology { get; set; }
        public int indexStart { get; set; }
        public int indexCount { get; set; }
        public int baseVertex { get; set; }
        public int firstVertex { get; set; }
        public int vertexCount { get; set; }
        public override string ToString()
            => $"(topo={topology} indices={indexStart},{indexCount} vertices={firstVertex},{vertexCount} basevtx={baseVertex} " +
            $"bounds={bounds})";
    }
}
