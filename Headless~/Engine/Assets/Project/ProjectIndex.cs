using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.Assets
{
    /// <summary>Every visible file of the mounted folders, by path and by GUID.</summary>
    internal sealed class ProjectIndex
    {
        readonly List<AssetEntry> entries = new List<AssetEntry>();
        readonly List<MountedFolder> mounts = new List<MountedFolder>();
        readonly Dictionary<string, AssetEntry> byPath;
        readonly Dictionary<string, AssetEntry> byGuid = new Dictionary<string, AssetEntry>();
        readonly Dictionary<string, string> doubled = new Dictionary<string, string>();
        ILookup<string, AssetEntry> resources;

        public ProjectIndex(bool ignoreCase) =>
            byPath = new Dictionary<string, AssetEntry>(ignoreCase ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);

        public IReadOnlyList<AssetEntry> Entries => entries;
        public IReadOnlyList<MountedFolder> Mounts => mounts;
        /// <summary>Missing and unusable .meta files, GUIDs given twice: what would break the project in Unity.</summary>
        public readonly List<string> Problems = new List<string>();

        /// <summary>Those among them without a .meta file.</summary>
        public readonly List<string> WithoutMeta = new List<string>();

        /// <summary>The problems with one line for all that have no .meta file.</summary>
        public IEnumerable<string> Summary()
        {
            const int Named = 3;
            if (WithoutMeta.Count > 0)
                yield return WithoutMeta.Count == 1 ? NoMeta(WithoutMeta[0] + " has")
                    : NoMeta($"{WithoutMeta.Count} files and folders ({string.Join(", ", WithoutMeta.Take(Named))}" +
                        $"{(WithoutMeta.Count > Named ? ", ..." : "")}) have");
            foreach (var problem in Problems.Except(WithoutMeta.Select(path => NoMeta(path + " has")))) yield return problem;
        }

        static string NoMeta(string who) => $"{who} no .meta file, so nothing can refer to " +
            $"{(who.EndsWith(" has", StringComparison.Ordinal) ? "it" : "them")}: open the project in Unity or run Headless~/Engine/tools/make-meta";

        /// <summary>Mounting the same folder again changes nothing.</summary>
        public void Mount(MountedFolder mount)
        {
            if (!Directory.Exists(mount.Folder))
                throw new AssetException($"{mount.Folder} does not exist, so nothing can be shown as {mount.AssetPath}");
            if (mounts.Any(m => m.AssetPath == mount.AssetPath && m.Folder == mount.Folder)) return;
            mounts.Add(mount);
            resources = null;
            Scan(mount.Folder, mount.AssetPath);
        }

        void Scan(string folder, string assetPath)
        {
            var children = new DirectoryInfo(folder).GetFileSystemInfos();
            Array.Sort(children, (a, b) => string.CompareOrdinal(a.Name, b.Name));
            var names = new HashSet<string>(children.Select(c => c.Name));
            foreach (var child in children)
            {
                if (IsHidden(child.Name)) continue;
                var path = assetPath + "/" + child.Name;
                if (child.Name.EndsWith(".meta", StringComparison.Ordinal))
                {
                    if (!names.Contains(child.Name.Substring(0, child.Name.Length - 5)))
                        Problems.Add($"{path}: the asset of this .meta file is gone: delete it or run Headless~/Engine/tools/make-meta --prune");
                    continue;
                }
                var isFolder = child is DirectoryInfo;
                Add(new AssetEntry { Path = path, File = child.FullName, IsFolder = isFolder }, names.Contains(child.Name + ".meta"));
                if (isFolder) Scan(child.FullName, path);
            }
        }

        /// <summary>Unity imports no such file or folder.</summary>
        public static bool IsHidden(string name) =>
            name[0] == '.' || name[name.Length - 1] == '~' || name.Equals("cvs", StringComparison.OrdinalIgnoreCase)
            || name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase);

        void Add(AssetEntry entry, bool hasMeta)
        {
            entries.Add(entry);
            byPath.TryAdd(entry.Path, entry);
            if (!hasMeta)
            {
                WithoutMeta.Add(entry.Path);
                Problems.Add(NoMeta(entry.Path + " has"));
                return;
            }
            if (!MetaFile.TryRead(entry.File + ".meta", entry.Path + ".meta", out var meta, out var problem)) Problems.Add(problem);
            if (!MetaFile.IsGuid(meta.Guid)) return;
            entry.Guid = meta.Guid;
            entry.Importer = meta.Importer;
            entry.ExecutionOrder = meta.ExecutionOrder;
            if (byGuid.TryAdd(meta.Guid, entry)) return;
            var message = $"{entry.Path} has the guid {meta.Guid} of {byGuid[meta.Guid].Path}: delete one of the two .meta files and " +
                $"let Unity or Headless~/Engine/tools/make-meta write a new one";
            doubled.TryAdd(meta.Guid, message);
            Problems.Add(message);
        }

        public AssetEntry ByPath(string assetPath) => byPath.TryGetValue(assetPath.Replace('\\', '/').TrimEnd('/'), out var entry) ? entry : null;
        public AssetEntry ByGuid(string guid) => byGuid.TryGetValue(guid, out var entry) ? entry : null;

        /// <summary>Why this GUID is ambiguous; null when it is not.</summary>
        public string Doubled(string guid) => doubled.TryGetValue(guid, out var message) ? message : null;

        public IEnumerable<AssetEntry> Resources(string path) =>
            (resources ??= entries.Where(e => e.ResourcePath != null).ToLookup(e => e.ResourcePath, StringComparer.OrdinalIgnoreCase))[path];

        /// <summary>Those at path or in the folder of that name below any Resources folder; the empty path is all.</summary>
        public IEnumerable<AssetEntry> ResourcesBelow(string path) =>
            entries.Where(e => e.ResourcePath is string at && (path.Length == 0 || at.Equals(path, StringComparison.OrdinalIgnoreCase)
                || at.StartsWith(path + "/", StringComparison.OrdinalIgnoreCase)));

        /// <summary>The asset path of a file on disk below a mounted folder; null outside.</summary>
        public string PathOf(string file)
        {
            file = Path.GetFullPath(file);
            // The innermost mount: a sample lies inside of its package's folder.
            foreach (var mount in mounts.OrderByDescending(m => m.Folder.Length))
                if (file.StartsWith(mount.Folder + Path.DirectorySeparatorChar, StringComparison.Ordinal))
                    return mount.AssetPath + "/" + file.Substring(mount.Folder.Length + 1).Replace(Path.DirectorySeparatorChar, '/');
            return null;
        }
    }
}
