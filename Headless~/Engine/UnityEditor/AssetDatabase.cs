using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>
    /// The project's files, and over them what scripts make: that lies in memory and is never written, but is found, named
    /// and destroyed as if it were a file.
    /// </summary>
    public sealed class AssetDatabase
    {
        sealed class Made
        {
            public readonly string Guid = System.Guid.NewGuid().ToString("N");
            /// <summary>The asset itself first. Local file identifiers count up from the first one's.</summary>
            public readonly List<Object> Parts = new List<Object>();
            public readonly List<long> Ids = new List<long>();
            public long NextId = 11400000;
        }

        static readonly Dictionary<string, Made> made = new Dictionary<string, Made>();
        static readonly HashSet<string> folders = new HashSet<string>();

        public static T LoadAssetAtPath<T>(string assetPath) where T : Object => (T)LoadAssetAtPath(assetPath, typeof(T));

        public static Object LoadAssetAtPath(string assetPath, Type type) =>
            made.TryGetValue(assetPath ?? "", out Made asset)
            ? asset.Parts.Find(part => Object.IsAlive(part) && type.IsInstanceOfType(part)) : Player.Assets?.LoadAtPath(assetPath, type);

        public static Object LoadMainAssetAtPath(string assetPath) => LoadAssetAtPath(assetPath, typeof(Object));

        public static Object[] LoadAllAssetsAtPath(string assetPath) =>
            made.TryGetValue(assetPath ?? "", out Made asset) ? asset.Parts.Where(Object.IsAlive).ToArray()
            : Player.Assets?.LoadAllAtPath(assetPath).ToArray() ?? Array.Empty<Object>();

        public static string AssetPathToGUID(string path) => made.TryGetValue(path ?? "", out Made asset) ? asset.Guid
            : Player.Assets?.GuidOfPath(path) ?? "";
        public static string GUIDToAssetPath(string guid) => made.FirstOrDefault(pair => pair.Value.Guid == guid).Key
            ?? Player.Assets?.PathOfGuid(guid) ?? "";
        public static string GetAssetPath(Object assetObject) => TryFind(assetObject, out string path, out _, out _) ? path : "";
        /// <summary>Nothing is imported again here: the same for as long as the asset is there.</summary>
        public static Hash128 GetAssetDependencyHash(string path) => Hash128.Parse(AssetPathToGUID(path));
        public static bool TryGetGUIDAndLocalFileIdentifier(Object obj, out string guid, out long localId)
            => TryFind(obj, out _, out guid, out localId);
        public static bool Contains(Object obj) => Object.IsAlive(obj) && obj.IsAsset;
        public static bool IsMainAsset(Object obj) => made.Values.Any(asset => ReferenceEquals(asset.Parts[0], obj));
        public static bool IsSubAsset(Object obj) => made.Values.Any(asset => asset.Parts.IndexOf(obj) > 0);

        static bool TryFind(Object asset, out string path, out string guid, out long localId)
        {
            (path, guid, localId) = ("", "", 0);
            if (!Object.IsAlive(asset))
                return false;
            foreach (KeyValuePair<string, Made> pair in made)
                if (pair.Value.Parts.IndexOf(asset) is int at && at >= 0)
                {
                    (path, guid, localId) = (pair.Key, pair.Value.Guid, pair.Value.Ids[at]);
                    return true;
                }
            return Player.Assets != null && Player.Assets.TryIdentify(asset, out path, out guid, out localId);
        }

        public static void CreateAsset(Object asset, string path)
        {
            if (!Object.IsAlive(asset))
                throw new ArgumentNullException(nameof(asset));
            if (asset.IsAsset)
                throw new UnityException($"Couldn't add object to asset file because the {asset.GetType().Name} '{asset.name}' is " +
                    $"already an asset at '{GetAssetPath(asset)}'!");
            string folder = path.Contains('/') ? path.Substring(0, path.LastIndexOf('/')) : "";
            if (!IsValidFolder(folder))
                throw new UnityException($"Creating asset at path {path} failed: parent folder not found.");
            DeleteAsset(path);
            asset.name = path.Substring(folder.Length + 1, path.LastIndexOf('.') - folder.Length - 1);
            Add(asset, made[path] = new Made());
        }

        public static void AddObjectToAsset(Object objectToAdd, Object assetObject) => AddObjectToAsset(objectToAdd, GetAssetPath(assetObject));

        public static void AddObjectToAsset(Object objectToAdd, string path)
        {
            if (!made.TryGetValue(path, out Made asset))
                throw new UnityException($"AddObjectToAsset: a script has made no asset at '{path}'.");
            if (objectToAdd.IsAsset)
                throw new UnityException($"AddObjectToAssetFile failed because the {objectToAdd.GetType().Name} '{objectToAdd.name}' " +
                    $"is already an asset at '{GetAssetPath(objectToAdd)}'!");
            Add(objectToAdd, asset);
        }

        static void Add(Object part, Made asset)
        {
            part.IsAsset = true;
            asset.Parts.Add(part);
            asset.Ids.Add(asset.NextId++);
        }

        public static void RemoveObjectFromAsset(Object objectToRemove)
        {
            foreach (Made asset in made.Values)
                if (asset.Parts.IndexOf(objectToRemove) is int at && at > 0)
                {
                    asset.Parts.RemoveAt(at);
                    asset.Ids.RemoveAt(at);
                    objectToRemove.IsAsset = false;
                }
        }

        /// <summary>Deletes an asset that a script made; the project's own files stay.</summary>
        public static bool DeleteAsset(string path)
        {
            bool found = folders.RemoveWhere(folder => folder == path || folder.StartsWith(path + "/", StringComparison.Ordinal)) > 0;
            foreach (string at in made.Keys.Where(at => at == path || at.StartsWith(path + "/", StringComparison.Ordinal)).ToList())
            {
                foreach (Object part in made[at].Parts)
                    if (Object.IsAlive(part))
                        Object.DestroyImmediate(part, true);
                found = made.Remove(at);
            }
            return found;
        }

        public static bool IsValidFolder(string path) => path == "Assets" || folders.Contains(path)
            || Player.Assets?.ResolvePath(path) is string file && System.IO.Directory.Exists(file);

        public static string CreateFolder(string parentFolder, string newFolderName)
        {
            if (!IsValidFolder(parentFolder))
                return "";
            folders.Add(parentFolder + "/" + newFolderName);
            return System.Guid.NewGuid().ToString("N");
        }

        public static string GenerateUniqueAssetPath(string path)
        {
            if (!IsValidFolder(path.Contains('/') ? path.Substring(0, path.LastIndexOf('/')) : ""))
                return "";
            int dot = path.LastIndexOf('.');
            string free = path;
            for (int i = 1; LoadMainAssetAtPath(free) != null; i++)
                free = $"{path.Substring(0, dot)} {i}{path.Substring(dot)}";
            return free;
        }

        /// <summary>The GUIDs of the project's files of one type, of which the host knows prefabs and scriptable objects: those whose file
        /// refers to a script of that name.</summary>
        public static string[] FindAssets(string filter)
        {
            if (!filter.StartsWith("t:", StringComparison.Ordinal) || filter.Contains(' '))
                throw new NotSupportedException($"AssetDatabase.FindAssets(\"{filter}\"): the host finds \"t:\" and one type alone.");
            string type = filter.Substring(2);
            string extension = type == "Prefab" ? ".prefab" : ".asset";
            return (Player.Assets?.AllPaths() ?? Enumerable.Empty<string>())
                .Where(path => path.EndsWith(extension, StringComparison.OrdinalIgnoreCase) && (type == "Prefab"
                    || Player.Assets.ReferencesIn(path).Any(script => script.EndsWith($"/{type}.cs", StringComparison.Ordinal))))
                .Select(AssetPathToGUID)
                .Concat(made.Values.Where(asset => type != "Prefab" && Object.IsAlive(asset.Parts[0]) && asset.Parts[0].GetType().Name == type)
                    .Select(asset => asset.Guid)).ToArray();
        }

        /// <summary>Files that a file refers to as it is stored, scripts too; with all that those refer to and itself where recursive.</summary>
        public static string[] GetDependencies(string pathName, bool recursive)
        {
            var found = new List<string>();
            if (recursive)
                found.Add(pathName);
            foreach (string path in Player.Assets?.ReferencesIn(pathName) ?? Enumerable.Empty<string>())
                if (!found.Contains(path))
                    found.Add(path);
            for (int i = 1; recursive && i < found.Count; i++)
                found.AddRange(Player.Assets.ReferencesIn(found[i]).Where(path => !found.Contains(path)).Distinct().ToList());
            return found.ToArray();
        }

        /// <summary>Paths that version control does not give to write: for tests.</summary>
        internal static readonly HashSet<string> Locked = new HashSet<string>();

        public static bool MakeEditable(string path) => !Locked.Contains(path);

        public static void Refresh() { }
        public static void SaveAssets() { }
        public static void SaveAssetIfDirty(Object obj) => EditorUtility.ClearDirty(obj);
        public static void StartAssetEditing() { }
        public static void StopAssetEditing() { }
    }
}
