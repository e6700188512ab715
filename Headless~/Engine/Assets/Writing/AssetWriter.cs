using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>
    /// Writes a ScriptableObject as Unity's own text serializer would, with the volume textures that it holds as parts of the
    /// same file. A file that is there is replaced and keeps its GUID; the parts keep their file ids.
    /// </summary>
    internal static class AssetWriter
    {
        /// <summary>Ids of the script's object in the file, and of the first texture: Unity's class number times 100,000.</summary>
        const long MainId = 11400000, TextureId = 11700000;

        const string Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
        const string Origin = "  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {fileID: 0}\n  m_PrefabInstance: {fileID: 0}\n  " +
            "m_PrefabAsset: {fileID: 0}\n";

        /// <param name="file">Path of the .asset file; its folder is made if need be.</param>
        /// <param name="scriptGuid">From the .meta file of the script that the asset's class is in.</param>
        /// <param name="guidOf">GUID of an asset of its own that a field refers to; null where there is none such.</param>
        /// <returns>The GUID of the file.</returns>
        public static string Write(string file, ScriptableObject asset, string scriptGuid, Func<Object, string> guidOf = null)
        {
            if (!MetaFile.IsGuid(scriptGuid)) throw new ArgumentException($"'{scriptGuid}' is no GUID of a script.", nameof(scriptGuid));
            var parts = new List<Texture3D>();
            string ReferenceTo(Object target)
            {
                if (target == null) return "fileID: 0";
                if (guidOf?.Invoke(target) is string guid) return $"fileID: {MainId}, guid: {guid}, type: 2";
                if (target is not Texture3D texture)
                    throw new NotSupportedException(
                    $"'{asset.name}' refers to the {target.GetType().Name} '{target.name}', which is in no file.");
                if (!parts.Contains(texture)) parts.Add(texture);
                return $"fileID: {TextureId + parts.IndexOf(texture)}";
            }

            var text = new StringBuilder(Header);
            text.Append($"--- !u!114 &{MainId}\nMonoBehaviour:\n{Origin}  m_GameObject: {{fileID: 0}}\n  m_Enabled: 1\n  m_EditorHideFlags: 0\n");
            text.Append($"  m_Script: {{fileID: 11500000, guid: {scriptGuid}, type: 3}}\n  m_Name: {FieldWriter.Quoted(asset.name)}\n  " +
                $"m_EditorClassIdentifier: \n");
            new FieldWriter(text, ReferenceTo).Write(asset, "  ");
            for (var i = 0; i < parts.Count; i++) Volume(text, TextureId + i, parts[i]);

            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(file)));
            File.WriteAllText(file, text.ToString());
            return KeepOrMakeMeta(file + ".meta");
        }

        static void Volume(StringBuilder text, long id, Texture3D texture)
        {
            var data = texture.GetPixelData<byte>(0).ToArray();
            text.Append($"--- !u!117 &{id}\nTexture3D:\n{Origin}  m_Name: {FieldWriter.Quoted(texture.name)}\n");
            text.Append("  m_ImageContentsHash:\n    serializedVersion: 2\n    Hash: 00000000000000000000000000000000\n  " +
                "m_IsAlphaChannelOptional: 0\n  serializedVersion: 4\n");
            text.Append($"  m_ColorSpace: 0\n  m_Format: {(int)texture.graphicsFormat}\n  m_Width: {texture.width}\n  m_Height: " +
                $"{texture.height}\n  m_Depth: {texture.depth}\n  m_MipCount: 1\n  m_DataSize: {data.Length}\n");
            text.Append($"  m_TextureSettings:\n    serializedVersion: 2\n    m_FilterMode: {(int)texture.filterMode}\n    m_Aniso: " +
                $"{texture.anisoLevel}\n    m_MipBias: 0\n");
            text.Append($"    m_WrapU: {(int)texture.wrapModeU}\n    m_WrapV: {(int)texture.wrapModeV}\n    m_WrapW: " +
                $"{(int)texture.wrapModeW}\n  m_UsageMode: 0\n  m_IsReadable: 1\n");
            text.Append($"  image data: {data.Length}\n  _typelessdata: {Convert.ToHexString(data).ToLowerInvariant()}\n");
            text.Append("  m_StreamData:\n    serializedVersion: 2\n    offset: 0\n    size: 0\n    path: \n");
        }

        static string KeepOrMakeMeta(string meta)
        {
            if (File.Exists(meta))
            {
                if (!MetaFile.TryRead(meta, meta, out var kept, out var problem)) throw new AssetException(problem);
                return kept.Guid;
            }
            var guid = Guid.NewGuid().ToString("N");
            File.WriteAllText(meta, $"fileFormatVersion: 2\nguid: {guid}\nNativeFormatImporter:\n  externalObjects: {{}}\n  " +
                $"mainObjectFileID: {MainId}\n  userData: \n  assetBundleName: \n  assetBundleVariant: \n");
            return guid;
        }
    }
}
