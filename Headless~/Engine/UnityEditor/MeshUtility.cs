using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor
{
    public class MeshUtility
    {
        /// <summary>Reads any mesh: in the editor all can be read, whatever Read/Write says.</summary>
        public static Mesh.MeshDataArray AcquireReadOnlyMeshData(Mesh mesh) => Mesh.Snapshot(new[] { mesh }, 1, nameof(mesh), false);
        public static Mesh.MeshDataArray AcquireReadOnlyMeshData(Mesh[] meshes) => Mesh.Snapshot(meshes, meshes?.Length ?? 0, nameof(meshes), false);
        public static Mesh.MeshDataArray AcquireReadOnlyMeshData(List<Mesh> meshes)
            => Mesh.Snapshot(meshes?.ToArray(), meshes?.Count ?? 0, nameof(meshes), false);
    }
}
