using System;
using System.Collections.Generic;
using System.IO;
using Unity.Collections;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Undo and redo of a bake into a field that is there.</summary>
    /// <remarks>
    /// The editor's own undo brings back what the field serializes: settings, bounds, source. Of textures it promises nothing,
    /// and what is large it leaves out without a word. So the distances that a bake replaces are kept in a file of the project's
    /// Temp folder, which the editor empties as it closes, and come back from there when an undo or redo has left a field with
    /// the description of others than its texture holds. What is known of them lies in the session's state, which outlives
    /// a reload of scripts as the undo stack does.
    /// </remarks>
    static class FieldUndo
    {
        const string Name = "Bake Signed Distance Field";
        // Keys of the session's state: GUIDs of fields, one a line; what a field's texture holds; the file with what it once held.
        const string Watched = "Rill.FieldUndo.Watched", Held = "Rill.FieldUndo.Held ", Kept = "Rill.FieldUndo.Kept ";

        /// <summary>Before a bake into a field: lets undo bring it back as it is now.</summary>
        /// <returns>False, and said, where its distances could not be kept: then this bake cannot be undone.</returns>
        public static bool Record(SignedDistanceField field)
        {
            string path = AssetDatabase.GetAssetPath(field);
            if (path == "" || field.Texture == null || !field.Texture.isReadable)
                return false;
            Watch(field);
            if (!TryKeep(AssetDatabase.AssetPathToGUID(path), DescriptionOf(field), field.Texture, out string problem))
            {
                Debug.LogWarning($"Rill: this bake of '{field.name}' cannot be undone: {problem}", field);
                return false;
            }
            Undo.RegisterCompleteObjectUndo(field, Name);
            return true;
        }

        /// <summary>The field's texture holds now what the field says.</summary>
        public static void Watch(SignedDistanceField field)
        {
            string guid = AssetDatabase.AssetPathToGUID(AssetDatabase.GetAssetPath(field));
            if (guid == "")
                return;
            SessionState.SetString(Held + guid, DescriptionOf(field));
            string watched = SessionState.GetString(Watched, "");
            if (Array.IndexOf(watched.Split('\n'), guid) < 0)
                SessionState.SetString(Watched, watched == "" ? guid : watched + "\n" + guid);
        }

        /// <summary>The file with the distances that belong to what a field says now; "" where they were never replaced.</summary>
        internal static string FileOf(SignedDistanceField field)
            => FileOf(AssetDatabase.AssetPathToGUID(AssetDatabase.GetAssetPath(field)), DescriptionOf(field));

        static string FileOf(string guid, string description) => SessionState.GetString(Kept + guid + description, "");

        [InitializeOnLoadMethod]
        static void Begin() => Undo.undoRedoPerformed += Restore;

        static void Restore()
        {
            string watched = SessionState.GetString(Watched, "");
            if (watched == "")
                return;
            foreach (string guid in watched.Split('\n'))
            {
                string path = AssetDatabase.GUIDToAssetPath(guid), held = SessionState.GetString(Held + guid, "");
                SignedDistanceField field = path == "" ? null : AssetDatabase.LoadAssetAtPath<SignedDistanceField>(path);
                if (field != null && DescriptionOf(field) != held)
                    Restore(field, guid, path, held);
            }
        }

        static void Restore(SignedDistanceField field, string guid, string path, string held)
        {
            string file = FileOf(field);
            if (file == "")
            {
                Watch(field);       // changed by another hand, as by version control
                return;
            }
            Texture3D now = FieldAssets.TextureIn(path);
            if (now != null && !TryKeep(guid, held, now, out string problem))
                Debug.LogWarning($"Rill: undo of the bake of '{field.name}' cannot be redone: {problem}", field);
            try
            {
                Read(file, field);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                field.Empty();
                Debug.LogError(
                    $"Rill: '{field.name}' has its settings of before back, but not its distances: bake it again with them. {e.Message}",
                    field);
            }
            FieldAssets.KeepTextureOf(field);
            Watch(field);
        }

        // All that the distances follow from, and what was found of them.
        static string DescriptionOf(SignedDistanceField field) =>
            FormattableString.Invariant(
                $"{field.SourceMesh} {field.SourceMeshId} {field.SourceHash} {field.Bounds.center:R} {field.Bounds.size:R} {field.VoxelSize:R} ") +
            FormattableString.Invariant($"{field.Sign} {field.ShellThickness:R} {field.StorageError:R} {JsonUtility.ToJson(field.Settings)}");

        static bool TryKeep(string guid, string description, Texture3D texture, out string problem)
        {
            problem = null;
            if (FileOf(guid, description) != "")
                return true;
            string file = FileUtil.GetUniqueTempPathInProject();
            try
            {
                using (var writer = new BinaryWriter(File.Create(file)))
                {
                    writer.Write(texture.name);
                    writer.Write(texture.width);
                    writer.Write(texture.height);
                    writer.Write(texture.depth);
                    writer.Write((int)texture.format);
                    NativeArray<byte> voxels = texture.GetPixelData<byte>(0);
                    writer.Write(voxels.Length);
                    writer.Write(voxels.ToArray());
                }
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                problem = $"its distances could not be kept in '{file}'. {e.Message}";
                return false;
            }
            SessionState.SetString(Kept + guid + description, file);
            return true;
        }

        static void Read(string file, SignedDistanceField field)
        {
            using (var reader = new BinaryReader(File.OpenRead(file)))
            {
                string name = reader.ReadString();
                var resolution = new Vector3Int(reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32());
                var format = (TextureFormat)reader.ReadInt32();
                byte[] voxels = reader.ReadBytes(reader.ReadInt32());
                field.Fill(name, resolution, format, voxels);
            }
        }
    }
}
