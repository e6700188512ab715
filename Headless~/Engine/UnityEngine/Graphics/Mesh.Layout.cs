using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    // Meshes whose vertices lie as a script wants them, and their buffers for its kernels.
    public sealed partial class Mesh
    {
        const GraphicsBuffer.Target MayBeRequested = GraphicsBuffer.Target.Vertex | GraphicsBuffer.Target.Index
            | GraphicsBuffer.Target.CopySource | GraphicsBuffer.Target.CopyDestination | GraphicsBuffer.Target.Raw;

        VertexAttributeDescriptor[] layout;         // null: the engine's own
        GraphicsBuffer.Target vertexTarget = GraphicsBuffer.Target.Vertex, indexTarget = GraphicsBuffer.Target.Index;
        int indexRoom;                              // of SetIndexBufferParams; 0: as many as the submeshes have
        bool verticesAreSet;                        // by a script: what SetVertexBufferParams has made has no content
        MeshMemory memory;

        public GraphicsBuffer.Target vertexBufferTarget
        {
            get => vertexTarget;
            set => SetTarget(ref vertexTarget, value | GraphicsBuffer.Target.Vertex, nameof(vertexBufferTarget));
        }

        public GraphicsBuffer.Target indexBufferTarget
        {
            get => indexTarget;
            set => SetTarget(ref indexTarget, value | GraphicsBuffer.Target.Index, nameof(indexBufferTarget));
        }

        void SetTarget(ref GraphicsBuffer.Target target, GraphicsBuffer.Target value, string what)
        {
            if (value == target)
                return;
            if ((value & ~MayBeRequested) != 0)
                throw new ArgumentException($"Mesh '{name}': {what} {value & ~MayBeRequested}: Direct3D 11 has no vertex or index buffers of " +
                    $"that kind; for kernels use Raw.");
            if (!isReadable)
                throw new InvalidOperationException($"Mesh '{name}': {what} has to be set while the mesh is readable, since its buffers are " +
                    $"made again from the data on the CPU; UploadMeshData gave that back.");
            target = value;
            Changed();
        }

        public void SetVertexBufferParams(int vertexCount, params VertexAttributeDescriptor[] attributes)
        {
            if (vertexCount < 0)
                throw new ArgumentOutOfRangeException(nameof(vertexCount), vertexCount, $"Mesh '{name}' cannot have {vertexCount} vertices.");
            if (!MayAccess("vertices"))
                return;
            CheckLayout(attributes);
            layout = (VertexAttributeDescriptor[])attributes.Clone();
            verticesAreSet = false;
            positions = new Vector3[vertexCount];
            normalData = Has(VertexAttribute.Normal) ? new Vector3[vertexCount] : Array.Empty<Vector3>();
            tangentData = Has(VertexAttribute.Tangent) ? new Vector4[vertexCount] : Array.Empty<Vector4>();
            colorData = Has(VertexAttribute.Color) ? new Color[vertexCount] : Array.Empty<Color>();
            for (int channel = 0; channel < 8; channel++)
                uvData[channel] = Has(VertexAttribute.TexCoord0 + channel) ? new Vector4[vertexCount] : null;
            Changed();
        }

        bool Has(VertexAttribute attribute) => Array.Exists(layout, one => one.attribute == attribute);

        void CheckLayout(VertexAttributeDescriptor[] attributes)
        {
            if (attributes == null || attributes.Length == 0 || attributes[0].attribute != VertexAttribute.Position)
                throw new NotSupportedException($"Mesh '{name}': SetVertexBufferParams without a position; the headless host draws no such mesh.");
            for (int i = 0; i < attributes.Length; i++)
            {
                VertexAttributeDescriptor one = attributes[i];
                if (i > 0 && one.attribute <= attributes[i - 1].attribute)
                    throw new ArgumentException($"Mesh '{name}': {one.attribute} after {attributes[i - 1].attribute}; vertex attributes " +
                        $"stand in the order of VertexAttribute, each once.");
                if (one.dimension < 1 || one.dimension > 4)
                    throw new ArgumentException($"Mesh '{name}': {one.attribute} of {one.dimension} components; it can have 1 to 4.");
                if (one.format != VertexAttributeFormat.Float32 || one.dimension < 2 || one.stream != 0
                    || one.attribute >= VertexAttribute.BlendWeight)
                    throw new NotSupportedException($"Mesh '{name}': {one.attribute} as {one.format} x {one.dimension} in stream {one.stream}; " +
                        $"the headless host lays out 2 to 4 floats in one stream.");
            }
        }

        public void SetIndexBufferParams(int indexCount, IndexFormat format)
        {
            if (indexCount < 0)
                throw new ArgumentOutOfRangeException(nameof(indexCount), indexCount, $"Mesh '{name}' cannot have {indexCount} indices.");
            if (!MayAccess("indices"))
                return;
            indexFormat = format;
            indexRoom = indexCount;
            submeshes.Clear();
            subMeshCount = 1;
        }

        public void SetSubMesh(int index, SubMeshDescriptor desc, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        {
            if (index < 0 || index >= submeshes.Count)
                throw new IndexOutOfRangeException($"Mesh '{name}' has {submeshes.Count} submeshes; submesh {index} does not exist.");
            if (!MayAccess("indices"))
                return;
            if (indexRoom == 0 || desc.indexStart != (int)GetIndexStart(index) || desc.baseVertex != 0)
                throw new NotSupportedException($"Mesh '{name}': SetSubMesh {desc}; the headless host has it for the room that " +
                    $"SetIndexBufferParams makes, one submesh after the other from index 0 on, without a base vertex.");
            if (desc.indexCount < 0 || (long)desc.indexStart + desc.indexCount > indexRoom)
                throw new ArgumentException($"Mesh '{name}': SetSubMesh with indices {desc.indexStart} to " +
                    $"{(long)desc.indexStart + desc.indexCount}; there is room for {indexRoom}.");
            if (desc.topology == MeshTopology.Triangles && desc.indexCount % 3 != 0)
                throw new ArgumentException($"Mesh '{name}': {desc.indexCount} indices are not a whole number of triangles.");
            // The data on the CPU is what counts for both, and there is none.
            if ((flags & MeshUpdateFlags.DontValidateIndices) == 0)
                GpuError.Strictly($"Mesh '{name}': SetSubMesh compares indices with the vertices, but nothing has set them on the CPU; pass " +
                    $"MeshUpdateFlags.DontValidateIndices where a kernel will.");
            if ((flags & MeshUpdateFlags.DontRecalculateBounds) == 0 && !verticesAreSet)
                GpuError.Strictly($"Mesh '{name}': SetSubMesh finds bounds of vertices that nothing has set on the CPU; pass " +
                    $"MeshUpdateFlags.DontRecalculateBounds where a kernel will, and set bounds.");
            submeshes[index] = new Submesh { Indices = new int[desc.indexCount], Topology = desc.topology, Bounds = desc.bounds };
        }

        public GraphicsBuffer GetVertexBuffer(int index)
        {
            if (index != 0)
                throw new IndexOutOfRangeException($"Mesh '{name}' has one stream of vertices; stream {index} does not exist.");
            return HandOut(Memory("GetVertexBuffer")?.Vertices, $"Mesh {name} vertices");
        }

        public GraphicsBuffer GetIndexBuffer() => HandOut(Memory("GetIndexBuffer")?.Indices, $"Mesh {name} indices");

        static GraphicsBuffer HandOut(MeshMemory.Part part, string name) => part == null ? null : new GraphicsBuffer(part) { name = name };

        MeshMemory Memory(string call)
        {
            if (layout == null)
                throw new NotSupportedException($"Mesh '{name}': {call}; the headless host hands out the buffers of meshes whose layout " +
                    $"SetVertexBufferParams has set.");
            if (vertexCount == 0)
                return null;
            if (memory == null || memory.Owner != Player.Device)
            {
                memory?.Dispose();
                memory = new MeshMemory(name, Player.Device, layout, vertexTarget, indexTarget, vertexCount,
                    verticesAreSet ? Interleaved() : null, indexRoom > 0 ? indexRoom : AllIndices().Length,
                    indexRoom > 0 ? null : AllIndices(), indexRoom > 0 && indexFormat == IndexFormat.UInt16);
                if (!IsBuiltIn)
                    LiveObjects.Add(memory, "Mesh", name);
            }
            return memory;
        }

        float[] Interleaved()
        {
            var all = new List<float>();
            for (int i = 0; i < vertexCount; i++)
                foreach (VertexAttributeDescriptor one in layout)
                    for (int component = 0; component < one.dimension; component++)
                        all.Add(ComponentOf(one.attribute, i)[component]);
            return all.ToArray();
        }

        Vector4 ComponentOf(VertexAttribute attribute, int i)
        {
            switch (attribute)
            {
                case VertexAttribute.Position: return new Vector4(positions[i].x, positions[i].y, positions[i].z, 1f);
                case VertexAttribute.Normal: return i < normalData.Length ? (Vector4)normalData[i] : default;
                case VertexAttribute.Tangent: return i < tangentData.Length ? tangentData[i] : default;
                case VertexAttribute.Color: return i < colorData.Length ? (Vector4)colorData[i] : Vector4.one;
                default:
                    Vector4[] uv = Uv(attribute - VertexAttribute.TexCoord0);
                    return i < uv.Length ? uv[i] : default;
            }
        }

        bool BindLayout(int submesh, ShaderProgram vertex, ref DeviceDraw draw)
        {
            MeshMemory bound = Memory("a draw");
            if (bound?.Indices == null)
                return false;
            if (!bound.Vertices.Written || !bound.Indices.Written)
                GpuError.Strictly($"Mesh '{name}' is drawn, but nothing has written its {(bound.Vertices.Written ? "indices" : "vertices")} yet, " +
                    $"on the CPU or by a kernel; their content is undefined.");
            draw.Indices = bound.Indices.Buffer;
            draw.Indices32 = bound.Indices.Stride == sizeof(int);
            draw.FirstVertex = (int)GetIndexStart(submesh);
            draw.VertexCount = At(submesh).Indices.Length;
            draw.Streams = bound.Streams(vertex);
            return true;
        }

        void CopyLayout(Mesh from)
        {
            (layout, vertexTarget, indexTarget, indexRoom, verticesAreSet) =
                (from.layout, from.vertexTarget, from.indexTarget, from.indexRoom, from.verticesAreSet);
        }
    }
}

namespace UnityEngine.Rendering
{
    public struct VertexAttributeDescriptor : IEquatable<VertexAttributeDescriptor>
    {
        public VertexAttributeDescriptor(VertexAttribute attribute = VertexAttribute.Position,
            VertexAttributeFormat format = VertexAttributeFormat.Float32, int dimension = 3, int stream = 0)
        {
            this.attribute = attribute;
            this.format = format;
            this.dimension = dimension;
            this.stream = stream;
        }

        public VertexAttribute attribute { get; set; }
        public VertexAttributeFormat format { get; set; }
        public int dimension { get; set; }
        public int stream { get; set; }

        public bool Equals(VertexAttributeDescriptor other) => (attribute, format, dimension, stream)
            == (other.attribute, other.format, other.dimension, other.stream);
        public override bool Equals(object other) => other is VertexAttributeDescriptor descriptor && Equals(descriptor);
        public override int GetHashCode() => HashCode.Combine(attribute, format, dimension, stream);
        public static bool operator ==(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => lhs.Equals(rhs);
        public static bool operator !=(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => !lhs.Equals(rhs);
        public override string ToString() => $"(attr={attribute} fmt={format} dim={dimension} stream={stream})";
    }
}
