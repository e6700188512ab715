using System;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Reads meshes in the editor, where Read/Write of their import settings does not matter.</summary>
    static class EditorMesh
    {
        /// <exception cref="ArgumentNullException">The mesh is null.</exception>
        public static TriangleMesh Read(Mesh mesh)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh), "No mesh to bake: assign one.");
            using (Mesh.MeshDataArray data = MeshUtility.AcquireReadOnlyMeshData(mesh))
                return TriangleMesh.Of(mesh.name, data[0]);
        }
    }
}
