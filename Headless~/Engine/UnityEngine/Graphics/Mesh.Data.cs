using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    // Read-only snapshots of meshes.
    public sealed partial class Mesh
    {
        public static MeshDataArray AcquireReadOnlyMeshData(Mesh mesh) => Snapshot(new[] { mesh }, 1, nameof(mesh), true);
        public static MeshDataArray AcquireReadOnlyMeshData(Mesh[] meshes) => Snapshot(meshes, meshes?.Length ?? 0, nameof(meshes), true);
        public static MeshDataArray AcquireReadOnlyMeshData(List<Mesh> meshes)
            => Snapshot(meshes?.ToArray(), meshes?.Count ?? 0, nameof(meshes), true);

        /// <param name="mustBeReadable">Not so in the editor's own method.</param>
        internal static MeshDataArray Snapshot(Mesh[] meshes, int count, string parameter, bool mustBeReadable)
        {
            if (meshes == null)
                throw new ArgumentNullException(parameter, "Mesh array is null");
            var all = new Frozen[count];
            for (int i = 0; i < count; i++)
            {
                if (!meshes[i])
                    throw new ArgumentNullException(parameter, "Mesh is null");
                if (mustBeReadable && !meshes[i].isReadable)
                    throw new InvalidOperationException($"Not allowed to access vertex data on mesh '{meshes[i].name}' (isReadable is " +
                        $"false; Read/Write must be enabled in import settings)");
                all[i] = new Frozen(meshes[i]);
            }
            return new MeshDataArray(all);
        }

        /// <summary>Current content of a mesh. Its arrays are replaced when it changes, never written to.</summary>
        internal sealed class Frozen
        {
            public readonly string Name;
            public readonly Vector3[] Positions, Normals;
            public readonly IndexFormat Format;
            readonly Submesh[] submeshes;
            public bool IsDisposed;

            public Frozen(Mesh mesh)
            {
                (Name, Positions, Normals, Format) = (mesh.name, mesh.positions, mesh.normalData, mesh.indexFormat);
                submeshes = mesh.submeshes.ToArray();
            }

            public int Count => submeshes.Length;

            public SubMeshDescriptor Submesh(int index)
            {
                int start = 0;
                for (int i = 0; i < index; i++)
                    start += submeshes[i].Indices.Length;
                Submesh found = submeshes[index];
                return new SubMeshDescriptor(start, found.Indices.Length, found.Topology) { baseVertex = found.BaseVertex,
                    vertexCount = Positions.Length, bounds = found.Bounds };
            }

            public int[] Indices(int submesh, bool applyBaseVertex) => Placed(submeshes[submesh], applyBaseVertex);
        }

        public struct MeshDataArray : IDisposable
        {
            Frozen[] meshes;

            internal MeshDataArray(Frozen[] meshes)
            {
                this.meshes = meshes;
                LiveObjects.Add(meshes, "MeshDataArray", meshes.Length > 0 ? meshes[0].Name : "");
            }

            public int Length => meshes?.Length ?? 0;

            public MeshData this[int index] => meshes == null
                ? throw new ObjectDisposedException(nameof(MeshDataArray),
                "The MeshDataArray has been deallocated, it is not allowed to access it")
                : index >= 0 && index < meshes.Length ? new MeshData(meshes[index])
                    : throw new IndexOutOfRangeException($"Index {index} is out of range of '{meshes.Length}' Length.");

            public void Dispose()
            {
                if (meshes == null)
                    return;
                LiveObjects.Remove(meshes);
                foreach (Frozen mesh in meshes)
                    mesh.IsDisposed = true;
                meshes = null;
            }
        }

        public struct MeshData
        {
            readonly Frozen mesh;

            internal MeshData(Frozen mesh) => this.mesh = mesh;

            Frozen Read => mesh != null && !mesh.IsDisposed ? mesh
                : throw new ObjectDisposedException(nameof(MeshData),
                "The MeshDataArray has been deallocated, it is not allowed to access it");

            public int vertexCount => Read.Positions.Length;
            public int subMeshCount => Read.Count;
            public IndexFormat indexFormat => Read.Format;
            public bool HasVertexAttribute(VertexAttribute attr) => attr == VertexAttribute.Position ? Read.Positions.Length > 0
                : attr == VertexAttribute.Normal && Read.Normals.Length > 0;
            public SubMeshDescriptor GetSubMesh(int index) => Read.Submesh(Checked(index));
            public void GetVertices(NativeArray<Vector3> outVertices) => Copy(Read.Positions, VertexAttribute.Position, outVertices);
            public void GetNormals(NativeArray<Vector3> outNormals) => Copy(Read.Normals, VertexAttribute.Normal, outNormals);

            public void GetIndices(NativeArray<int> outIndices, int submesh, bool applyBaseVertex = true)
            {
                int[] indices = Read.Indices(Checked(submesh), applyBaseVertex);
                Fits(outIndices.Length, indices.Length);
                indices.CopyTo(MemoryMarshal.Cast<byte, int>(Transfer.Bytes(outIndices)));
            }

            void Copy(Vector3[] from, VertexAttribute attribute, NativeArray<Vector3> to)
            {
                if (!HasVertexAttribute(attribute))
                    throw new InvalidOperationException($"Mesh data does not have {attribute} vertex component");
                Fits(to.Length, from.Length);
                from.CopyTo(MemoryMarshal.Cast<byte, Vector3>(Transfer.Bytes(to)));
            }

            int Checked(int submesh) => submesh >= 0 && submesh < Read.Count ? submesh
                : throw new IndexOutOfRangeException(
                $"Specified submesh ({submesh}) is out of range. Must be greater or equal to 0 and less than subMeshCount ({Read.Count}).");

            static void Fits(int has, int needs)
            {
                if (has < needs)
                    throw new InvalidOperationException($"Not enough space in output buffer (need {needs}, has {has})");
            }
        }
    }
}
