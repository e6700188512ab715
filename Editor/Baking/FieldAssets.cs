using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Distance fields as assets: which mesh one was baked from, which one a mesh has, and how one is written.</summary>
    static class FieldAssets
    {
        public const string Extension = ".asset";

        /// <summary>GUID and local file identifier of a mesh; "" and 0 for one that is not an asset.</summary>
        public static (string guid, long id) SourceOf(Mesh mesh) =>
            mesh != null && AssetDatabase.TryGetGUIDAndLocalFileIdentifier(mesh, out string guid, out long id) ? (guid, id) : ("", 0);

        /// <summary>The mesh that a field was baked from.</summary>
        /// <param name="problem">Why there is none, and what to do; null where there is one.</param>
        public static Mesh MeshOf(SignedDistanceField field, out string problem)
        {
            problem = null;
            if (string.IsNullOrEmpty(field.SourceMesh))
            {
                problem = $"'{field.name}' does not know the mesh that it was baked from: choose one to bake it again.";
                return null;
            }
            string path = AssetDatabase.GUIDToAssetPath(field.SourceMesh);
            var meshes = new List<Mesh>();
            foreach (Object part in AssetDatabase.LoadAllAssetsAtPath(path))
                if (part is Mesh mesh)
                    meshes.Add(mesh);
            foreach (Mesh mesh in meshes)
                if (SourceOf(mesh).id == field.SourceMeshId)
                    return mesh;
            // Before a field knew the mesh's identifier, and for models whose meshes were given new ones.
            if (meshes.Count == 1)
                return meshes[0];
            problem = meshes.Count == 0
                ? $"The mesh of '{field.name}' is gone (GUID {field.SourceMesh}): choose one to bake it again."
                : Invariant($"'{path}' has {meshes.Count} meshes, and none is the one that '{field.name}' was baked from: choose one to ") +
                "bake it again.";
            return null;
        }

        /// <summary>The first path that is free, or holds a field that was baked from this very mesh: it is baked in place.</summary>
        /// <param name="taken">By others of the same plan.</param>
        /// <param name="existing">The field that is there; null for a free path.</param>
        public static string PathFor(string folder, Mesh mesh, ICollection<string> taken, out SignedDistanceField existing)
        {
            (string guid, long id) source = SourceOf(mesh);
            for (int i = 1; ; i++)
            {
                string path = $"{folder}/{FileName(mesh.name)} Distances{(i > 1 ? Invariant($" {i}") : "")}{Extension}";
                existing = null;
                if (taken.Contains(path))
                    continue;
                Object there = AssetDatabase.LoadMainAssetAtPath(path);
                existing = there as SignedDistanceField;
                if (there == null || existing != null && source.guid != "" && (existing.SourceMesh, existing.SourceMeshId) == source)
                    return path;
            }
        }

        /// <summary>The name without what no file system takes.</summary>
        public static string FileName(string name)
        {
            const string forbidden = "/\\:*?\"<>|";
            var safe = new System.Text.StringBuilder();
            foreach (char c in name)
                safe.Append(c < ' ' || forbidden.IndexOf(c) >= 0 ? '_' : c);
            string trimmed = safe.ToString().Trim(' ', '.');
            return trimmed == "" ? "Mesh" : trimmed;
        }

        /// <summary>Makes the folders of a path that are missing.</summary>
        /// <returns>False where that cannot be: outside of Assets.</returns>
        public static bool TryMakeFolder(string folder)
        {
            if (AssetDatabase.IsValidFolder(folder))
                return true;
            int slash = folder.LastIndexOf('/');
            return slash > 0 && TryMakeFolder(folder.Substring(0, slash))
                && AssetDatabase.CreateFolder(folder.Substring(0, slash), folder.Substring(slash + 1)) != "";
        }

        /// <summary>Writes a bake as a new asset.</summary>
        public static SignedDistanceField Create(SdfBake bake, Mesh source, string path)
        {
            (string guid, long id) = SourceOf(source);
            SignedDistanceField field = SignedDistanceField.Create(bake, guid, id);
            AssetDatabase.CreateAsset(field, path);
            AssetDatabase.AddObjectToAsset(field.Texture, field);
            Save(field);
            return field;
        }

        /// <summary>Puts a bake into an asset that is there: its GUID stays, and so do references to it.</summary>
        public static void Replace(SignedDistanceField field, SdfBake bake, Mesh source)
        {
            (string guid, long id) = SourceOf(source);
            FieldUndo.Record(field);
            Texture3D replaced = field.Apply(bake, guid, id);
            KeepTextureOf(field);
            if (replaced != null)
                Object.DestroyImmediate(replaced, true);        // the field is not an asset
            FieldUndo.Watch(field);
        }

        /// <summary>The texture of distances in a field's file; null for none. Not always the field's: undo knows no file.</summary>
        public static Texture3D TextureIn(string path)
        {
            foreach (Object part in AssetDatabase.LoadAllAssetsAtPath(path))
                if (part is Texture3D texture)
                    return texture;
            return null;
        }

        /// <summary>Writes a field that is an asset, with its texture and no other.</summary>
        public static void KeepTextureOf(SignedDistanceField field)
        {
            if (!AssetDatabase.Contains(field))
                return;
            foreach (Object part in AssetDatabase.LoadAllAssetsAtPath(AssetDatabase.GetAssetPath(field)))
                if (part is Texture3D && part != field.Texture)
                {
                    AssetDatabase.RemoveObjectFromAsset(part);
                    Object.DestroyImmediate(part, true);
                }
            if (field.Texture != null && !AssetDatabase.Contains(field.Texture))
                AssetDatabase.AddObjectToAsset(field.Texture, field);
            Save(field);
        }

        static void Save(SignedDistanceField field)
        {
            if (field.Texture != null)
                EditorUtility.SetDirty(field.Texture);
            EditorUtility.SetDirty(field);
            AssetDatabase.SaveAssetIfDirty(field);
        }
    }
}
