using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>The two buffers of a mesh whose layout a script has set. They go with the mesh's data; what was handed out of them is then
    /// as if released.</summary>
    internal sealed class MeshMemory : IDisposable
    {
        /// <summary>One of the buffers, and those who were given it.</summary>
        public sealed class Part : IDisposable
        {
            public readonly DeviceBuffer Buffer;
            public readonly int Count, Stride;
            public readonly GraphicsBuffer.Target Target;
            /// <summary>Whether it has content: from the CPU, or of a kernel.</summary>
            public bool Written;
            readonly List<BufferStorage> handedOut = new List<BufferStorage>();

            public Part(IGraphicsDevice device, string name, GraphicsBuffer.Target target, int count, int stride, ReadOnlySpan<byte> data)
            {
                (Count, Stride, Target) = (count, stride, target);
                long bytes = (long)count * stride;
                if (bytes > Gpu.MaxResourceBytes)
                    throw new ArgumentException($"{name}: {bytes:N0} bytes; a buffer holds at most {Gpu.MaxResourceBytes:N0}.");
                Buffer = device.CreateBuffer(name, bytes);
                device.Fill(Buffer, 0, (bytes + 3) / 4 * 4, Player.Strict ? BufferStorage.Garbage : 0u);
                if (data.IsEmpty)
                    return;
                device.Upload(Buffer, 0, data);
                Written = true;
            }

            public void Add(BufferStorage storage) => handedOut.Add(storage);
            public void Remove(BufferStorage storage) => handedOut.Remove(storage);

            public void Dispose()
            {
                foreach (BufferStorage storage in handedOut.ToArray())
                    storage.Release();
                Buffer.Dispose();
            }
        }

        public readonly IGraphicsDevice Owner;
        public readonly Part Vertices, Indices;     // no indices: null
        readonly VertexAttributeDescriptor[] layout;
        readonly DeviceBuffer defaults;             // 0, 0, 0, 0 and 1, 1, 1, 1
        readonly Dictionary<ShaderProgram, DeviceVertexStream[]> streams = new Dictionary<ShaderProgram, DeviceVertexStream[]>();

        /// <param name="data">All components of all vertices; null: nothing has set them.</param>
        /// <param name="indices">Null: nothing has set them.</param>
        public MeshMemory(string name, IGraphicsDevice owner, VertexAttributeDescriptor[] layout, GraphicsBuffer.Target vertexTarget,
            GraphicsBuffer.Target indexTarget, int vertexCount, float[] data, int indexCount, int[] indices, bool isShort)
        {
            Owner = owner;
            this.layout = layout;
            int stride = 0;
            foreach (VertexAttributeDescriptor one in layout)
                stride += one.dimension * sizeof(float);
            Vertices = new Part(owner, $"Mesh {name} vertices", vertexTarget, vertexCount, stride, MemoryMarshal.AsBytes<float>(data));
            if (indexCount > 0)
                Indices = new Part(owner, $"Mesh {name} indices", indexTarget, indexCount, isShort ? sizeof(ushort) : sizeof(int),
                    MemoryMarshal.AsBytes<int>(indices));
            defaults = owner.CreateBuffer($"Mesh {name} defaults", 32);
            owner.Upload(defaults, 0, MemoryMarshal.AsBytes<float>(new float[] { 0, 0, 0, 0, 1, 1, 1, 1 }));
        }

        public DeviceVertexStream[] Streams(ShaderProgram vertex)
        {
            if (streams.TryGetValue(vertex, out DeviceVertexStream[] found))
                return found;
            found = new DeviceVertexStream[vertex.Inputs.Length];
            for (int i = 0; i < found.Length; i++)
            {
                string semantic = MeshBuffers.Canonical(vertex.Inputs[i].Semantic);
                found[i].Location = vertex.Inputs[i].Location;
                (found[i].Buffer, found[i].Offset, found[i].Format) = (defaults, semantic == "COLOR" ? 16 : 0, DeviceFormat.RGBA32_Float);
                int offset = 0;
                foreach (VertexAttributeDescriptor one in layout)
                {
                    if (semantic == SemanticOf(one.attribute))
                        (found[i].Buffer, found[i].Offset, found[i].Stride, found[i].Format) =
                            (Vertices.Buffer, offset, Vertices.Stride, FormatOf(one.dimension));
                    offset += one.dimension * sizeof(float);
                }
            }
            streams.Add(vertex, found);
            return found;
        }

        static string SemanticOf(VertexAttribute attribute)
            => attribute >= VertexAttribute.TexCoord0 ? "TEXCOORD" + (attribute - VertexAttribute.TexCoord0)
                : attribute.ToString().ToUpperInvariant();

        // Missing components read as Vulkan has it, and Direct3D: 0, 0, 0, 1.
        static DeviceFormat FormatOf(int dimension)
            => dimension == 2 ? DeviceFormat.RG32_Float : dimension == 3 ? DeviceFormat.RGB32_Float : DeviceFormat.RGBA32_Float;

        public void Dispose()
        {
            Vertices.Dispose();
            Indices?.Dispose();
            defaults.Dispose();
            LiveObjects.Remove(this);
        }
    }
}
