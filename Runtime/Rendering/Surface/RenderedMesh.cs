using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The surface of a fluid in the buffers of a UnityEngine.Mesh, for renderers with any material.</summary>
    /// <remarks>
    /// Kernels write it again in each frame, since it goes on between steps and a stock material knows nothing of that. How many triangles there are
    /// is known on the GPU alone: all that there is room for are drawn, and those behind the last have no area. The mesh has no copy on the CPU.
    /// </remarks>
    sealed class RenderedMesh : IDisposable
    {
        /// <summary>bytes of a vertex: float3 position, float3 normal, float2 uv</summary>
        [GenerateHlsl("RenderedMesh")] public const int RenderedVertexBytes = 32;

        [GenerateHlsl("RenderedMesh")] const int CopyGroup = 64;

        const int IndicesOfQuad = 6;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.RenderedMesh");

        readonly ComputeShader shader = StageShader.LoadCompute("RenderedMesh");
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.RenderedMesh" };
        readonly Kernel copyVertices, copyIndices;
        Mesh mesh;
        GraphicsBuffer vertices, indices;
        int vertexCapacity, quadCapacity;

        public RenderedMesh()
        {
            copyVertices = new Kernel(shader, "CopyVertices");
            copyIndices = new Kernel(shader, "CopyIndices");
        }

        /// <summary>The mesh that renderers draw; null before the first <see cref="Write"/>, and another once the surface has outgrown it.</summary>
        public Mesh Mesh => mesh;

        /// <summary>Writes the surface as it is in this frame, for a renderer whose transform is given.</summary>
        /// <param name="frame">Its vertices, indices, pose and size.</param>
        /// <exception cref="InvalidOperationException">The device cannot hold the mesh, or lets no kernel write it. It is released.</exception>
        public void Write(SurfaceMesh surface, in MeshFrame frame, Transform renderer)
        {
            MakeRoom(surface.VertexCapacity, surface.QuadCapacity);
            Matrix4x4 toRenderer = renderer.worldToLocalMatrix, fromRenderer = renderer.localToWorldMatrix;
            Matrix4x4 domainToRenderer = toRenderer * frame.domainToWorld;
            mesh.bounds = BoundsOf(domainToRenderer, frame.domainSize);

            commands.Clear();
            commands.BeginSample(Marker);
            commands.SetComputeVectorParam(shader, DrawnIds.FrameLag, frame.lag);
            commands.SetComputeVectorParam(shader, DrawnIds.DrawnDomainSize, frame.domainSize);
            commands.SetComputeMatrixParam(shader, Ids.DomainToRenderer, domainToRenderer);
            // A renderer turns normals to the world by the inverse of its transform, transposed.
            commands.SetComputeMatrixParam(shader, Ids.NormalToRenderer, fromRenderer.transpose * frame.domainToWorld);
            commands.SetComputeMatrixParam(shader, DrawnIds.DomainToWorld, frame.domainToWorld);
            commands.SetComputeBufferParam(shader, copyVertices, DrawnIds.MeshCounters, surface.Counters);
            commands.SetComputeBufferParam(shader, copyVertices, DrawnIds.MeshVertices, frame.vertices);
            commands.SetComputeBufferParam(shader, copyVertices, Ids.RenderedVertices, vertices);
            Dispatch(copyVertices, vertexCapacity);

            commands.SetComputeIntParam(shader, Ids.QuadCapacity, quadCapacity);
            commands.SetComputeIntParam(shader, Ids.IsMirrored, fromRenderer.determinant < 0f ? 1 : 0);
            commands.SetComputeBufferParam(shader, copyIndices, DrawnIds.MeshCounters, surface.Counters);
            commands.SetComputeBufferParam(shader, copyIndices, Ids.MeshIndices, frame.indices);
            commands.SetComputeBufferParam(shader, copyIndices, Ids.RenderedIndices, indices);
            Dispatch(copyIndices, quadCapacity);
            commands.EndSample(Marker);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Gives the mesh back, until the next <see cref="Write"/>.</summary>
        public void Release()
        {
            // Before the mesh, with which they end.
            vertices?.Release();
            indices?.Release();
            vertices = indices = null;
            EngineObject.Release(ref mesh);
            vertexCapacity = quadCapacity = 0;
        }

        public void Dispose()
        {
            Release();
            commands.Release();
        }

        public void Describe(StageDescription stage)
        {
            if (mesh == null)
                return;
            stage.Kernel(copyVertices, 0);
            stage.Kernel(copyIndices, 0);
            stage.Buffer("Rill.RenderedMesh.Vertices", vertices);
            stage.Buffer("Rill.RenderedMesh.Indices", indices);
        }

        void MakeRoom(int newVertices, int newQuads)
        {
            if (newVertices == vertexCapacity && newQuads == quadCapacity)
                return;
            Release();
            if (RoomProblem(newVertices) is string problem)
                throw new InvalidOperationException(problem);
            mesh = new Mesh { name = "Rill.RenderedMesh", hideFlags = HideFlags.HideAndDontSave };
            mesh.vertexBufferTarget |= GraphicsBuffer.Target.Raw;
            mesh.indexBufferTarget |= GraphicsBuffer.Target.Raw;
            mesh.SetVertexBufferParams(newVertices,
                new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3),
                new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float32, 3),
                new VertexAttributeDescriptor(VertexAttribute.TexCoord0, VertexAttributeFormat.Float32, 2));
            mesh.SetIndexBufferParams(IndicesOfQuad * newQuads, IndexFormat.UInt32);
            mesh.SetSubMesh(0, new SubMeshDescriptor(0, IndicesOfQuad * newQuads),
                MeshUpdateFlags.DontValidateIndices | MeshUpdateFlags.DontRecalculateBounds);
            mesh.UploadMeshData(true);      // gives back the copy on the CPU, which no one fills
            vertices = mesh.GetVertexBuffer(0);
            indices = mesh.GetIndexBuffer();
            if (!IsWritable(vertices) || !IsWritable(indices))
            {
                Release();
                throw new InvalidOperationException(Invariant($"this device ({SystemInfo.graphicsDeviceType}) lets no kernel write the vertices ") +
                    "of a mesh (GraphicsBuffer.Target.Raw). Draw the fluid with a Fluid Surface there.");
            }
            vertices.name = "Rill.RenderedMesh.Vertices";
            indices.name = "Rill.RenderedMesh.Indices";
            (vertexCapacity, quadCapacity) = (newVertices, newQuads);
        }

        /// <summary>Why the device cannot hold so many vertices; null where it can.</summary>
        internal static string RoomProblem(int vertices)
        {
            long bytes = (long)RenderedVertexBytes * vertices;
            return bytes <= GpuBuffer.MaxBinding ? null
                : Invariant($"room for {vertices:N0} vertices of the mesh takes {bytes:N0} bytes, and this device binds ") +
                    Invariant($"{GpuBuffer.MaxBinding:N0} at once. Lower its Quality, or the fluid's capacity.");
        }

        static bool IsWritable(GraphicsBuffer buffer) => buffer != null && buffer.IsValid() && (buffer.target & GraphicsBuffer.Target.Raw) != 0;

        void Dispatch(Kernel kernel, int elements)
            => ThreadGroups.Dispatch(commands, shader, kernel, ((long)elements + CopyGroup - 1) / CopyGroup);

        // Bounds of a box from the origin to size, transformed.
        static Bounds BoundsOf(Matrix4x4 transform, Vector3 size)
        {
            Vector3 half = 0.5f * size, extents = Vector3.zero;
            for (int row = 0; row < 3; row++)
                extents[row] = math.abs(transform[row, 0]) * half.x + math.abs(transform[row, 1]) * half.y + math.abs(transform[row, 2]) * half.z;
            return new Bounds(transform.MultiplyPoint3x4(half), 2f * extents);
        }

        static class Ids
        {
            public static readonly int DomainToRenderer = Shader.PropertyToID("_DomainToRenderer");
            public static readonly int NormalToRenderer = Shader.PropertyToID("_NormalToRenderer");
            public static readonly int MeshIndices = Shader.PropertyToID("_MeshIndices");
            public static readonly int QuadCapacity = Shader.PropertyToID("_QuadCapacity");
            public static readonly int IsMirrored = Shader.PropertyToID("_IsMirrored");
            public static readonly int RenderedVertices = Shader.PropertyToID("_RenderedVertices");
            public static readonly int RenderedIndices = Shader.PropertyToID("_RenderedIndices");
        }
    }
}
