using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    /// <summary>A mesh's attributes on the device, a buffer each; what a shader asks for and the mesh lacks reads as Unity's default.</summary>
    internal sealed class MeshBuffers : IDisposable
    {
        struct Attribute { public DeviceBuffer Buffer; public int Stride; public DeviceFormat Format; }

        public readonly IGraphicsDevice Owner;
        public readonly DeviceBuffer Indices;
        readonly Dictionary<string, Attribute> attributes = new Dictionary<string, Attribute>();
        readonly Dictionary<ShaderProgram, DeviceVertexStream[]> streams = new Dictionary<ShaderProgram, DeviceVertexStream[]>();
        readonly DeviceBuffer defaults;     // 0, 0, 0, 0 and 1, 1, 1, 1
        readonly string name;

        public MeshBuffers(string name, IGraphicsDevice owner, Vector3[] positions, Vector3[] normals, Vector4[] tangents, Color[] colors,
            Vector4[][] uvs, int[] indices)
        {
            this.name = name;
            Owner = owner;
            Indices = Create<int>("indices", indices);
            defaults = Create<float>("defaults", new float[] { 0, 0, 0, 0, 1, 1, 1, 1 });
            // Three floats are widened to four: w is 1 for points, which shaders that declare float4 vertex rely on.
            Add("POSITION", Array.ConvertAll(positions, p => new Vector4(p.x, p.y, p.z, 1)));
            Add("NORMAL", Array.ConvertAll(normals, n => new Vector4(n.x, n.y, n.z, 0)));
            Add("TANGENT", tangents);
            Add("COLOR", Array.ConvertAll(colors, c => (Vector4)c));
            for (int i = 0; i < uvs.Length; i++)
                Add("TEXCOORD" + i, uvs[i] ?? Array.Empty<Vector4>());
        }

        void Add(string semantic, Vector4[] data)
        {
            if (data.Length > 0)
                attributes[semantic] = new Attribute { Buffer = Create<Vector4>(semantic, data), Stride = 16, Format = DeviceFormat.RGBA32_Float };
        }

        DeviceBuffer Create<T>(string what, T[] data) where T : struct
        {
            ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes<T>(data);
            DeviceBuffer buffer = Gpu.Device.CreateBuffer($"Mesh {name} {what}", Math.Max(4, bytes.Length));
            Gpu.Device.Upload(buffer, 0, bytes);
            return buffer;
        }

        public DeviceVertexStream[] Streams(ShaderProgram vertex)
        {
            if (streams.TryGetValue(vertex, out DeviceVertexStream[] found))
                return found;
            found = new DeviceVertexStream[vertex.Inputs.Length];
            for (int i = 0; i < found.Length; i++)
            {
                string semantic = Canonical(vertex.Inputs[i].Semantic);
                found[i].Location = vertex.Inputs[i].Location;
                if (attributes.TryGetValue(semantic, out Attribute attribute))
                    (found[i].Buffer, found[i].Stride, found[i].Format) = (attribute.Buffer, attribute.Stride, attribute.Format);
                else
                    (found[i].Buffer, found[i].Offset, found[i].Format) = (defaults, semantic == "COLOR" ? 16 : 0, DeviceFormat.RGBA32_Float);
            }
            streams.Add(vertex, found);
            return found;
        }

        public static string Canonical(string semantic)
        {
            semantic = semantic.ToUpperInvariant();
            if (semantic.StartsWith("TEXCOORD", StringComparison.Ordinal))
                return semantic == "TEXCOORD" ? "TEXCOORD0" : semantic;
            return semantic.TrimEnd('0');
        }

        public void Dispose()
        {
            Indices.Dispose();
            defaults.Dispose();
            foreach (Attribute attribute in attributes.Values)
                attribute.Buffer.Dispose();
            LiveObjects.Remove(this);
        }
    }
}
