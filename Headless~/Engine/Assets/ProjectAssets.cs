using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>
    /// A Unity project's files as live objects: the host's AssetDatabase and Resources. Assets load when first asked for
    /// and stay, so that everybody gets the same object.
    /// </summary>
    internal sealed partial class ProjectAssets : IAssetSource
    {
        readonly Dictionary<string, LoadedAsset> loaded = new Dictionary<string, LoadedAsset>();
        readonly Dictionary<string, LoadedAsset> scenes = new Dictionary<string, LoadedAsset>();
        readonly HashSet<string> notes = new HashSet<string>();
        Dictionary<string, AssetEntry> shaders;

        public readonly ProjectIndex Index;
        public readonly ScriptTypes Scripts;
        /// <summary>Broken references throw; otherwise they are null and logged as errors, as in Unity.</summary>
        public readonly bool Strict;
        /// <summary>Components that a file has and the loaded scene has not, for want of their script.</summary>
        public int MissingScripts { get; private set; }
        readonly IForeignTypes foreign;
        /// <summary>Faults that Unity ignores silently: keys without a field, overrides without a target, classes that the host lacks.</summary>
        public readonly List<string> Warnings = new List<string>();

        /// <param name="scripts">The assemblies in which the project's scripts were compiled.</param>
        /// <param name="foreign">Of a project that the host was not built with; null otherwise.</param>
        public ProjectAssets(IEnumerable<MountedFolder> mounts, IEnumerable<Assembly> scripts, bool strict, IForeignTypes foreign = null)
        {
            Strict = strict;
            this.foreign = foreign;
            Scripts = new ScriptTypes(scripts);
            engine = new EngineObjects(ResolvePath);
            Index = new ProjectIndex(ignoreCase: !strict);
            foreach (var mount in mounts) Index.Mount(mount);
        }

        /// <summary>Opens a Unity project (Assets and its packages) or a package alone.</summary>
        /// <exception cref="AssetException">The folder is neither.</exception>
        public static ProjectAssets Open(string root, IEnumerable<Assembly> scripts, bool strict = true) =>
            new ProjectAssets(ProjectFolders.Of(root), scripts, strict);

        /// <summary>Destroys every loaded asset and gives back its memory; the next request reads its file again.</summary>
        public void ReloadAll()
        {
            foreach (var asset in loaded.Values)
                if (asset != null)
                    foreach (var made in asset.Objects.Values)
                        // Components go with their GameObject.
                        if (!(made is Component)) Object.DestroyImmediate(made, true);
            loaded.Clear();
            prefabs.Clear();
            scenes.Clear();
            shaders = null;
        }

        /// <summary>Scripts whose .meta files give them another order than 0.</summary>
        public IEnumerable<KeyValuePair<Type, int>> ExecutionOrders() =>
            from entry in Index.Entries
            where entry.ExecutionOrder != 0 && entry.Extension == ".cs"
            let type = Scripts.Find(entry, out _)
            where type != null
            select new KeyValuePair<Type, int>(type, entry.ExecutionOrder);

        /// <summary>Whether a file was asked for, and so made into objects.</summary>
        public bool IsLoaded(string assetPath) => loaded.ContainsKey(assetPath);

        // ---- IAssetSource

        public Object LoadResource(string path, Type type) =>
            Index.Resources(path).Where(e => CouldBe(e, type)).Select(e => Load(e)?.Find(type)).FirstOrDefault(found => found != null);

        public IEnumerable<Object> LoadAllResources(string path, Type type) =>
            Index.ResourcesBelow(path).Where(e => CouldBe(e, type)).SelectMany(e => All(Load(e), type)).ToArray();

        public Object LoadAsset(string guid, long fileId, Type type)
        {
            if (BuiltInAssets.IsBuiltIn(guid)) return BuiltInAssets.Load(fileId, type);
            var asset = Index.ByGuid(guid) is AssetEntry entry ? Load(entry) : null;
            return asset != null && asset.Objects.TryGetValue(fileId, out var found) && type.IsInstanceOfType(found) ? found : null;
        }

        public string ResolvePath(string assetPath)
        {
            if (Index.ByPath(assetPath) is AssetEntry entry) return entry.File;
            // A mount's own root is not an entry of it.
            return Index.Mounts.Where(m => m.AssetPath == assetPath).Select(m => m.Folder).FirstOrDefault();
        }

        public string GuidOfPath(string assetPath) => Index.ByPath(assetPath)?.Guid;
        public string PathOfGuid(string guid) => Index.ByGuid(guid)?.Path;

        public IEnumerable<string> AllPaths() => Index.Entries.Where(entry => !entry.IsFolder).Select(entry => entry.Path);

        public IEnumerable<string> ReferencesIn(string assetPath)
        {
            if (Index.ByPath(assetPath) is not AssetEntry entry || !YamlExtensions.Contains(entry.Extension)) return Enumerable.Empty<string>();
            return Regex.Matches(File.ReadAllText(entry.File), "guid: ([0-9a-f]{32})").Select(match => PathOfGuid(match.Groups[1].Value))
                .Where(path => path != null).Distinct();
        }

        public IEnumerable<Object> LoadAllAtPath(string assetPath) =>
            Index.ByPath(assetPath) is AssetEntry entry && Load(entry) is LoadedAsset asset ? asset.Objects.Values : Enumerable.Empty<Object>();

        public bool TryIdentify(Object asset, out string assetPath, out string guid, out long fileId)
        {
            foreach (var file in loaded.Values)
                foreach (var part in file?.Objects ?? new Dictionary<long, Object>())
                    if (ReferenceEquals(part.Value, asset))
                    {
                        (assetPath, guid, fileId) = (file.Entry.Path, file.Entry.Guid, part.Key);
                        return true;
                    }
            return BuiltInAssets.TryIdentify(asset, out assetPath, out guid, out fileId);
        }

        /// <summary>File id of an object of a scene that was opened; 0 for what a script made since.</summary>
        public long FileIdIn(string scenePath, Object found) =>
            scenes.TryGetValue(scenePath, out var scene) ? scene.Objects.FirstOrDefault(part => ReferenceEquals(part.Value, found)).Key : 0;

        /// <summary>Which prefab instance of an opened scene brought an object; null for the scene's own.</summary>
        public PrefabOrigin OriginIn(string scenePath, Object found) =>
            scenes.TryGetValue(scenePath, out var scene) && scene.Origins.TryGetValue(FileIdIn(scenePath, found), out var origin) ? origin : null;

        public Shader FindShader(string name)
        {
            shaders ??= Index.Entries.Where(e => e.Extension == ".shader")
                .GroupBy(e => ShaderNames.Of(e.File)).Where(g => g.Key != null).ToDictionary(g => g.Key, g => g.First());
            return shaders.TryGetValue(name, out var entry) ? (Shader)Load(entry).Main : BuiltInAssets.Resource(typeof(Shader), name) as Shader;
        }

        /// <summary>Works like AssetDatabase.LoadAssetAtPath: null without the file or an object of that type in it.</summary>
        public Object LoadAtPath(string assetPath, Type type) => Index.ByPath(assetPath) is AssetEntry entry ? Load(entry)?.Find(type) : null;
        public T LoadAtPath<T>(string assetPath) where T : Object => (T)LoadAtPath(assetPath, typeof(T));

        static IEnumerable<Object> All(LoadedAsset asset, Type type)
        {
            if (asset == null) return Enumerable.Empty<Object>();
            return asset.Main is GameObject ? new[] { asset.Find(type) }.Where(o => o != null) : asset.Objects.Values.Where(type.IsInstanceOfType);
        }

        // ---- references from files

        /// <summary>The object that a reference in a file means. A broken one throws or is logged and null.</summary>
        public Object Resolve(FileReference reference, Type type, ReadScope scope)
        {
            if (reference.IsNone) return null;
            if (BuiltInAssets.IsBuiltIn(reference.Guid))
            {
                var builtIn = BuiltInAssets.Load(reference.FileId, type);
                if (builtIn == null) Note($"{reference.Location}: {scope} refers to Unity's built-in " +
                    $"{BuiltInAssets.NameOf(reference.FileId)}, which the host does not have: it stays none");
                return builtIn;
            }
            var asset = FindAsset(reference, scope);
            if (asset == null) return null;
            if (asset.Objects.TryGetValue(reference.FileId, out var found)) return Checked(found, reference, type, scope);
            if (!asset.LeftOut.Contains(reference.FileId))
                Fail($"{reference.Location}: {scope} refers to object {reference.FileId} of {asset.Entry.Path}, which has none with " +
                    $"that file id{Objects(asset)}: assign the field again");
            return null;
        }

        LoadedAsset FindAsset(FileReference reference, ReadScope scope)
        {
            var entry = Entry(reference, scope);
            if (entry == null) return null;
            var asset = Load(entry);
            if (asset == null)
                Note($"{reference.Location}: {scope} refers to {entry.Path}, a kind of asset that the host does not load: it stays none");
            return asset;
        }

        AssetEntry Entry(FileReference reference, ReadScope scope)
        {
            if (!MetaFile.IsGuid(reference.Guid))
            {
                Fail($"{reference.Location}: {scope} has the guid '{reference.Guid}', which is not 32 lower-case hexadecimal digits: " +
                    $"assign the field again");
                return null;
            }
            if (Index.Doubled(reference.Guid) is string doubled)
                Fail($"{reference.Location}: {scope} refers to a guid that two assets have. {doubled}");
            var entry = Index.ByGuid(reference.Guid);
            if (entry == null)
                Fail($"{reference.Location}: {scope} refers to an asset with guid {reference.Guid} (file id {reference.FileId}), but " +
                    $"no .meta file in {string.Join(", ", Index.Mounts.Select(m => m.AssetPath))} has that guid: "
                    + "restore the asset with its .meta file, add the package that holds it, or assign the field again");
            return entry;
        }

        public Object Checked(Object found, FileReference reference, Type type, ReadScope scope)
        {
            if (type.IsInstanceOfType(found)) return found;
            Fail($"{reference.Location}: {scope} is of type {type.Name}, but {reference} is the {found.GetType().Name} '{found.name}': " +
                $"assign an object of that type");
            return null;
        }

        static string Objects(LoadedAsset asset) =>
            asset.Objects.Count == 0 ? ""
            : $" (it has {string.Join(", ", asset.Objects.Take(5).Select(o => $"{o.Key} {o.Value.GetType().Name}"))}{(asset.Objects.Count > 5 ? ", ..." : "")})";

        /// <summary>A script's class; null after the reason was reported.</summary>
        public Type ScriptType(FileReference script, ReadScope scope)
        {
            if (script.IsNone)
            {
                Fail($"{script.Location}: {scope} is missing: restore it or remove the component");
                return null;
            }
            if (BuiltInAssets.IsBuiltIn(script.Guid))
            {
                Note($"{script.Location}: {scope}: left out, as the host has no script {script.FileId} of Unity's own modules");
                return null;
            }
            if (foreign?.PackageScript(script.Guid) is Type stand) return stand;
            if (Index.ByGuid(script.Guid) == null && ForeignScripts.NameOf(script.Guid) is string name)
            {
                Note($"{script.Location}: {scope}: left out, as the host has no {name}");
                return null;
            }
            var entry = Entry(script, scope);
            if (entry == null) return null;
            var type = Scripts.Find(entry, out var problem);
            if (type != null) return type;
            MissingScripts++;
            if (foreign?.WhyMissing(entry.Path) is string reason)
                Note($"{script.Location}: {scope}, {entry.Path}, cannot be loaded, so the component is missing: {reason}");
            else Fail($"{script.Location}: {scope}: {problem}");
            return null;
        }

        /// <summary>The engine's component that files call by that name, or a stub for it; null when there is neither.</summary>
        public Type ComponentType(string name) => EngineObjects.ComponentType(name) ?? foreign?.StubComponent(name);

        public bool IsStub(Type type) => foreign != null && foreign.IsStub(type);

        // ---- reports

        public void Fail(string message)
        {
            if (Strict) throw new AssetException(message);
            if (notes.Add(message)) Debug.LogError(message);
        }

        /// <param name="once">Of all notes with this key only the first is kept; without one, of equal notes.</param>
        public void Note(string message, string once = null)
        {
            if (notes.Add(once ?? message)) Warnings.Add(message);
        }
    }
}
