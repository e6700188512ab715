using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Assets
{
    /// <summary>A Mesh document's vertex streams and index buffer into a Mesh.</summary>
    internal static class MeshReader
    {
        // Channels in file order; those behind the texture coordinates are bone weights, which the host has no use for.
        const int Position = 0, Normal = 1, Tangent = 2, Color = 3, Uv0 = 4, UvCount = 8;

        /// <exception cref="AssetException">The mesh is compressed, or its data is shorter than it says.</exception>
        public static Mesh Make(YamlMapping fields)
        {
            if (fields.Int("m_MeshCompression") != 0)
                throw fields.Location.Error("the mesh is compressed, which the host does not read: set its mesh compression to Off");
            var format = fields.Int("m_IndexFormat");
            if (format is < 0 or > 1) throw fields.Location.Error($"the mesh has the index format {format}, which does not exist");
            var mesh = new Mesh { indexFormat = (IndexFormat)format };
            var vertices = new VertexData(fields["m_VertexData"] ?? throw fields.Location.Error("the mesh has no vertex data"));

            mesh.vertices = vertices.Read(Position, v => (Vector3)v);
            if (vertices.Has(Normal)) mesh.normals = vertices.Read(Normal, v => (Vector3)v);
            if (vertices.Has(Tangent)) mesh.tangents = vertices.Read(Tangent, v => v);
            if (vertices.Has(Color)) mesh.colors = vertices.Read(Color, v => (UnityEngine.Color)v);
            for (var i = 0; i < UvCount; i++)
                if (vertices.Has(Uv0 + i)) SetUv(mesh, i, vertices);

            var indices = Indices(fields);
            var parts = fields.Items("m_SubMeshes").ToList();
            mesh.subMeshCount = parts.Count;
            for (var i = 0; i < parts.Count; i++)
            {
                var size = mesh.indexFormat == IndexFormat.UInt16 ? 2 : 4;
                int start = parts[i].Int("firstByte"), first = start / size, count = parts[i].Int("indexCount");
                var topology = (MeshTopology)parts[i].Int("topology");
                if (start < 0 || start % size != 0 || count < 0 || !Enum.IsDefined(topology))
                    throw parts[i].Location.Error($"sub-mesh {i} has {count} indices of topology {topology} from byte {start} on, which cannot be");
                if ((long)first + count > indices.Length)
                    throw parts[i].Location.Error($"sub-mesh {i} ends at index {(long)first + count}, but the buffer has {indices.Length}");
                mesh.SetIndices(indices.AsSpan(first, count).ToArray(), topology, i, false, parts[i].Int("baseVertex"));
            }
            mesh.bounds = new Bounds(BuiltInValues.Vector3(fields["m_LocalAABB"]?["m_Center"]),
                2 * BuiltInValues.Vector3(fields["m_LocalAABB"]?["m_Extent"]));
            if (!fields.Bool("m_IsReadable", true)) mesh.UploadMeshData(true);
            return mesh;
        }

        static void SetUv(Mesh mesh, int channel, VertexData vertices)
        {
            switch (vertices.Dimension(Uv0 + channel))
            {
                case 2: mesh.SetUVs(channel, vertices.Read(Uv0 + channel, v => (Vector2)v)); break;
                case 3: mesh.SetUVs(channel, vertices.Read(Uv0 + channel, v => (Vector3)v)); break;
                default: mesh.SetUVs(channel, vertices.Read(Uv0 + channel, v => v)); break;
            }
        }

        static int[] Indices(YamlMapping fields)
        {
            var numbers = new List<object>();
            var type = fields.Int("m_IndexFormat") == 0 ? typeof(ushort) : typeof(int);
            if (!PackedNumbers.TryRead(type, fields.Text("m_IndexBuffer"), numbers))
                throw fields.Location.Error("the mesh's index buffer is damaged");
            return numbers.Select(Convert.ToInt32).ToArray();
        }

        sealed class VertexData
        {
            struct Channel { public int Stream, Offset, Format, Dimension; }

            const int MaxStreams = 4, MaxDimension = 4;     // of Unity

            readonly Channel[] channels;
            readonly int count;
            readonly byte[] data;
            readonly int[] starts, strides;

            public VertexData(YamlNode node)
            {
                count = node.Int("m_VertexCount");
                channels = node.Items("m_Channels")
                    .Select(c => new Channel { Stream = c.Int("stream"), Offset = c.Int("offset"), Format = c.Int("format"),
                        Dimension = c.Int("dimension") & 15 }).ToArray();
                if (count < 0) throw node.Location.Error($"the mesh is damaged: it has {count} vertices");
                if (!PackedNumbers.TryBytes(node.Text("_typelessdata"), out data)) throw node.Location.Error("the mesh's vertex data is damaged");

                // One stream after the other, each starting at a multiple of 16 bytes.
                for (var i = 0; i < channels.Length; i++)
                    if (channels[i].Dimension > MaxDimension || channels[i].Stream is < 0 or >= MaxStreams || channels[i].Format < 0)
                        throw node.Location.Error($"channel {i} of the mesh's vertices cannot be");
                var streams = channels.Where(c => c.Dimension > 0).Select(c => c.Stream).DefaultIfEmpty(0).Max() + 1;
                starts = new int[streams];
                strides = new int[streams];
                long at = 0;
                for (var s = 0; s < streams; s++)
                {
                    strides[s] = channels.Where(c => c.Dimension > 0 && c.Stream == s).Sum(c => (c.Dimension * Size(c.Format) + 3) / 4 * 4);
                    if (at + (long)strides[s] * count > data.Length)
                        throw node.Location.Error($"the mesh has {data.Length} bytes of vertex data, but its {count} vertices need more");
                    starts[s] = (int)at;
                    at = (at + (long)strides[s] * count + 15) / 16 * 16;
                }
                for (var i = 0; i < channels.Length; i++)
                    if (channels[i] is var c && c.Dimension > 0 && (c.Offset < 0 || c.Offset + c.Dimension * Size(c.Format) > strides[c.Stream]))
                        throw node.Location.Error($"channel {i} of the mesh's vertices lies beyond the vertex");
            }

            public bool Has(int channel) => channel < channels.Length && channels[channel].Dimension > 0;
            public int Dimension(int channel) => channels[channel].Dimension;

            public T[] Read<T>(int channel, Func<Vector4, T> convert)
            {
                if (!Has(channel)) return Array.Empty<T>();
                var values = new T[count];
                var c = channels[channel];
                for (var i = 0; i < count; i++)
                {
                    var at = starts[c.Stream] + i * strides[c.Stream] + c.Offset;
                    var value = new Vector4();
                    for (var k = 0; k < c.Dimension; k++) value[k] = Number(c.Format, data.AsSpan(at + k * Size(c.Format)));
                    values[i] = convert(value);
                }
                return values;
            }

            // VertexAttributeFormat's numbering.
            static int Size(int format) => format switch { 0 => 4, 1 => 2, 2 => 1, 3 => 1, 4 => 2, 5 => 2, 6 => 1, 7 => 1, 8 => 2, 9 => 2, _ => 4 };

            static float Number(int format, ReadOnlySpan<byte> bytes) => format switch
            {
                0 => BitConverter.ToSingle(bytes),
                1 => (float)BitConverter.ToHalf(bytes),
                2 => bytes[0] / 255f,
                3 => Math.Max((sbyte)bytes[0] / 127f, -1),
                4 => BitConverter.ToUInt16(bytes) / 65535f,
                5 => Math.Max(BitConverter.ToInt16(bytes) / 32767f, -1),
                _ => throw new AssetException($"vertex attributes of format {(VertexAttributeFormat)format} are not read by the host"),
            };
        }
    }
}
