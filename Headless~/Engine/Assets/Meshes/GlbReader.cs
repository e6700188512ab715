using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using UnityEngine;

namespace Host.Assets
{
    /// <summary>Binary glTF: the triangles of the meshes in its scene, each where its node puts it.</summary>
    /// <remarks>Khronos, glTF 2.0 specification, sections 3.5 to 3.7 and 4.4; of its extensions KHR_mesh_quantization.</remarks>
    internal sealed class GlbReader
    {
        const uint Magic = 0x46546C67, JsonChunk = 0x4E4F534A, BinaryChunk = 0x004E4942;
        const int Byte = 5120, UnsignedByte = 5121, Short = 5122, UnsignedShort = 5123, UnsignedInt = 5125, Float = 5126;
        const string Instancing = "EXT_mesh_gpu_instancing";
        const int PointList = 0, TriangleList = 4, TriangleStrip = 5, TriangleFan = 6;

        static readonly string[] KnownExtensions = { "KHR_mesh_quantization", "KHR_texture_transform", "KHR_texture_basisu",
            "EXT_texture_webp", "KHR_lights_punctual" };

        readonly string shownAs;
        readonly byte[] file;
        readonly JsonElement root;
        readonly int binaryStart, binaryLength;
        readonly List<Vector3> vertices = new();
        readonly List<int> triangles = new();
        readonly HashSet<int> visited = new();
        int parts, withoutTriangles, skinned, morphed, unfinished, otherScenes;

        GlbReader(string shownAs, byte[] file, JsonElement root, int binaryStart, int binaryLength)
        {
            this.shownAs = shownAs;
            this.file = file;
            this.root = root;
            this.binaryStart = binaryStart;
            this.binaryLength = binaryLength;
        }

        public static MeshFile Read(string name, byte[] file, string shownAs)
        {
            AssetException Damaged(string what) => new($"{shownAs} is damaged: {what}: export it again");
            if (file.Length < 20 || BinaryPrimitives.ReadUInt32LittleEndian(file) != Magic)
                throw new AssetException($"{shownAs} is no GLB file: it does not start with \"glTF\"");
            var version = BinaryPrimitives.ReadUInt32LittleEndian(file.AsSpan(4));
            if (version != 2) throw new AssetException($"{shownAs} is of glTF {version}: export it as glTF 2.0");

            (int Start, int Length) json = default, binary = default;
            for (var at = 12; at + 8 <= file.Length;)
            {
                var length = BinaryPrimitives.ReadUInt32LittleEndian(file.AsSpan(at));
                var kind = BinaryPrimitives.ReadUInt32LittleEndian(file.AsSpan(at + 4));
                if (at + 8 + (long)length > file.Length) throw Damaged("it is cut off");
                if (kind == JsonChunk && json.Length == 0) json = (at + 8, (int)length);
                else if (kind == BinaryChunk && binary.Length == 0) binary = (at + 8, (int)length);
                at += 8 + (int)length;
            }
            try
            {
                using var document = JsonDocument.Parse(file.AsMemory(json.Start, json.Length));
                var reader = new GlbReader(shownAs, file, document.RootElement, binary.Start, binary.Length);
                reader.ReadScene();
                return new MeshFile(name, reader.vertices.ToArray(), reader.triangles.ToArray(), reader.parts, reader.Notes());
            }
            catch (Exception e) when (
                e is JsonException or KeyNotFoundException or InvalidOperationException or FormatException or IndexOutOfRangeException)
            {
                throw Damaged(e.Message.TrimEnd('.'));
            }
        }

        List<string> Notes()
        {
            var notes = new List<string>();
            if (withoutTriangles > 0) notes.Add($"{withoutTriangles} primitives of points or lines are left out.");
            if (unfinished > 0) notes.Add($"{unfinished} primitives end within a triangle: the rest of their indices is left out.");
            if (otherScenes > 0) notes.Add($"{otherScenes} further scenes are left out: only the one that the file shows first is read.");
            if (skinned > 0) notes.Add($"{skinned} skinned meshes are taken in the pose that they are stored in.");
            if (morphed > 0) notes.Add($"{morphed} primitives have morph targets: taken without them.");
            return notes;
        }

        void ReadScene()
        {
            if (root.TryGetProperty("extensionsRequired", out var required))
                foreach (var extension in required.EnumerateArray().Select(e => e.GetString()))
                    if (Array.IndexOf(KnownExtensions, extension) < 0)
                        throw new AssetException(
                            $"{shownAs} needs the glTF extension {extension}, which is not read here: export it without (no compression)");
            if (!root.TryGetProperty("nodes", out var nodes)) return;
            if (root.TryGetProperty("scenes", out var scenes))
            {
                otherScenes = scenes.GetArrayLength() - 1;
                var scene = scenes[root.TryGetProperty("scene", out var index) ? index.GetInt32() : 0];
                if (scene.TryGetProperty("nodes", out var roots))
                    foreach (var node in roots.EnumerateArray()) Node(nodes, node.GetInt32(), Matrix4x4.identity);
                return;
            }
            // A library without a scene: all nodes without a parent.
            var children = nodes.EnumerateArray().SelectMany(n => n.TryGetProperty("children", out var list)
                ? list.EnumerateArray().Select(c => c.GetInt32()).ToArray() : Array.Empty<int>()).ToHashSet();
            for (var i = 0; i < nodes.GetArrayLength(); i++)
                if (!children.Contains(i)) Node(nodes, i, Matrix4x4.identity);
        }

        void Node(JsonElement nodes, int index, Matrix4x4 parent)
        {
            if (!visited.Add(index)) throw new FormatException($"node {index} has two parents");
            var node = nodes[index];
            var world = parent * Local(node);
            if (node.TryGetProperty("extensions", out var extensions) && extensions.TryGetProperty(Instancing, out _))
                throw new AssetException($"{shownAs} repeats node {index} by the glTF extension {Instancing}, which is not read here: export every " +
                    $"instance as a node of its own");
            if (node.TryGetProperty("mesh", out var mesh))
            {
                var isSkinned = node.TryGetProperty("skin", out _);
                skinned += isSkinned ? 1 : 0;
                // A skin's joints place its mesh, not the node.
                foreach (var primitive in root.GetProperty("meshes")[mesh.GetInt32()].GetProperty("primitives").EnumerateArray())
                    Primitive(primitive, isSkinned ? Matrix4x4.identity : world);
            }
            if (node.TryGetProperty("children", out var children))
                foreach (var child in children.EnumerateArray()) Node(nodes, child.GetInt32(), world);
        }

        static Matrix4x4 Local(JsonElement node)
        {
            if (node.TryGetProperty("matrix", out var matrix))
            {
                var columns = default(Matrix4x4);
                for (var i = 0; i < 16; i++) columns[i] = matrix[i].GetSingle();
                return columns;
            }
            var position = node.TryGetProperty("translation", out var t) ? new Vector3(t[0].GetSingle(), t[1].GetSingle(), t[2].GetSingle())
                : Vector3.zero;
            var rotation = node.TryGetProperty("rotation", out var r)
                ? new Quaternion(r[0].GetSingle(), r[1].GetSingle(), r[2].GetSingle(), r[3].GetSingle()) : Quaternion.identity;
            var scale = node.TryGetProperty("scale", out var s) ? new Vector3(s[0].GetSingle(), s[1].GetSingle(), s[2].GetSingle()) : Vector3.one;
            return Matrix4x4.TRS(position, rotation, scale);
        }

        void Primitive(JsonElement primitive, Matrix4x4 world)
        {
            var mode = primitive.TryGetProperty("mode", out var m) ? m.GetInt32() : TriangleList;
            if (mode < PointList || mode > TriangleFan) throw new FormatException($"mode {mode} of a primitive does not exist");
            if (mode < TriangleList)
            {
                withoutTriangles++;
                return;
            }
            morphed += primitive.TryGetProperty("targets", out _) ? 1 : 0;

            var first = vertices.Count;
            foreach (var p in Positions(primitive.GetProperty("attributes").GetProperty("POSITION").GetInt32()))
            {
                var at = world.MultiplyPoint3x4(p);
                vertices.Add(new Vector3(-at.x, at.y, at.z));
            }
            var count = vertices.Count - first;
            var indices = primitive.TryGetProperty("indices", out var accessor) ? Indices(accessor.GetInt32()) : Enumerable.Range(0, count).ToArray();
            if (indices.Any(i => (uint)i >= (uint)count)) throw new FormatException($"an index is not below the {count} vertices of its primitive");

            if (mode == TriangleList ? indices.Length % 3 != 0 : indices.Length is 1 or 2) unfinished++;

            // x is mirrored, and a node that mirrors turns its triangles over once more.
            var turn = world.determinant >= 0f;
            void Add(int a, int b, int c)
            {
                triangles.Add(first + a);
                triangles.Add(first + (turn ? c : b));
                triangles.Add(first + (turn ? b : c));
            }
            for (var i = 0; i + 2 < indices.Length; i += mode == TriangleList ? 3 : 1)
                if (mode == TriangleFan) Add(indices[0], indices[i + 1], indices[i + 2]);
                else if (mode == TriangleStrip && i % 2 == 1) Add(indices[i + 1], indices[i], indices[i + 2]);
                else Add(indices[i], indices[i + 1], indices[i + 2]);
            parts++;
        }

        Vector3[] Positions(int accessor)
        {
            var view = new Accessor(this, accessor, "VEC3", 3);
            var positions = new Vector3[view.Count];
            for (var i = 0; i < positions.Length; i++) positions[i] = new Vector3(view.Number(i, 0), view.Number(i, 1), view.Number(i, 2));
            return positions;
        }

        int[] Indices(int accessor)
        {
            var view = new Accessor(this, accessor, "SCALAR", 1);
            var indices = new int[view.Count];
            for (var i = 0; i < indices.Length; i++) indices[i] = view.Whole(i);
            return indices;
        }

        /// <summary>Numbers in the file's binary part.</summary>
        readonly struct Accessor
        {
            public readonly int Count;
            readonly byte[] file;
            readonly int start, stride, kind, size;
            readonly bool normalized;

            public Accessor(GlbReader glb, int index, string type, int components)
            {
                file = glb.file;
                var accessor = glb.root.GetProperty("accessors")[index];
                if (accessor.TryGetProperty("sparse", out _) || !accessor.TryGetProperty("bufferView", out var viewIndex))
                    throw new AssetException($"{glb.shownAs} has sparse accessors, which are not read here: export it without");
                if (accessor.GetProperty("type").GetString() != type) throw new FormatException($"accessor {index} is no {type}");
                Count = accessor.GetProperty("count").GetInt32();
                kind = accessor.GetProperty("componentType").GetInt32();
                size = kind switch { Byte or UnsignedByte => 1, Short or UnsignedShort => 2, UnsignedInt or Float => 4,
                    _ => throw new FormatException($"component type {kind} of accessor {index} does not exist") };
                normalized = accessor.TryGetProperty("normalized", out var flag) && flag.GetBoolean();

                var view = glb.root.GetProperty("bufferViews")[viewIndex.GetInt32()];
                var buffer = view.GetProperty("buffer").GetInt32();
                if (buffer != 0 || glb.root.GetProperty("buffers")[0].TryGetProperty("uri", out _))
                    throw new AssetException($"{glb.shownAs} keeps its vertices in another file: export it as one .glb with everything inside");
                stride = view.TryGetProperty("byteStride", out var step) ? step.GetInt32() : size * components;
                long viewStart = view.TryGetProperty("byteOffset", out var o) ? o.GetInt64() : 0,
                    viewLength = view.GetProperty("byteLength").GetInt64();
                long offset = accessor.TryGetProperty("byteOffset", out o) ? o.GetInt64() : 0;
                if (Count < 0 || viewStart < 0 || offset < 0 || stride < size * components || viewLength > glb.binaryLength
                    || viewStart > glb.binaryLength - viewLength || offset > viewLength - (Count - 1L) * stride - size * components)
                    throw new FormatException($"accessor {index} reaches beyond the end of the data");
                start = glb.binaryStart + (int)(viewStart + offset);
            }

            public float Number(int index, int component)
            {
                var at = file.AsSpan(start + index * stride + component * size);
                return kind switch
                {
                    Float => BinaryPrimitives.ReadSingleLittleEndian(at),
                    Byte => normalized ? Math.Max((sbyte)at[0] / 127f, -1f) : (sbyte)at[0],
                    UnsignedByte => at[0] / (normalized ? 255f : 1f),
                    Short => normalized ? Math.Max(BinaryPrimitives.ReadInt16LittleEndian(at) / 32767f, -1f)
                        : BinaryPrimitives.ReadInt16LittleEndian(at),
                    UnsignedShort => BinaryPrimitives.ReadUInt16LittleEndian(at) / (normalized ? 65535f : 1f),
                    _ => BinaryPrimitives.ReadUInt32LittleEndian(at),
                };
            }

            public int Whole(int index)
            {
                var at = file.AsSpan(start + index * stride);
                return kind switch
                {
                    UnsignedByte => at[0],
                    UnsignedShort => BinaryPrimitives.ReadUInt16LittleEndian(at),
                    UnsignedInt => (int)BinaryPrimitives.ReadUInt32LittleEndian(at),
                    _ => throw new FormatException($"indices of component type {kind} do not exist"),
                };
            }
        }
    }
}
