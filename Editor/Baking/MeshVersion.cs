using System;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Fingerprint that detects, without reading a mesh, that it has changed: sizes, edits, and the import of the file that it is
    /// in.</summary>
    readonly struct MeshVersion : IEquatable<MeshVersion>
    {
        readonly int vertices, parts, edits;
        readonly ulong indices;
        readonly Bounds bounds;
        readonly Hash128 import;

        public MeshVersion(Mesh mesh)
        {
            vertices = mesh.vertexCount;
            parts = mesh.subMeshCount;
            indices = 0;
            for (int part = 0; part < parts; part++)
                indices += mesh.GetIndexCount(part);
            bounds = mesh.bounds;
            edits = EditorUtility.GetDirtyCount(mesh);
            string path = AssetDatabase.GetAssetPath(mesh);
            import = path == "" ? default : AssetDatabase.GetAssetDependencyHash(path);
        }

        public bool Equals(MeshVersion other) =>
            (vertices, parts, edits, indices) == (other.vertices, other.parts, other.edits, other.indices) && bounds.Equals(other.bounds)
            && import.Equals(other.import);

        public override bool Equals(object other) => other is MeshVersion version && Equals(version);

        public override int GetHashCode() => vertices ^ (int)indices;
    }
}
