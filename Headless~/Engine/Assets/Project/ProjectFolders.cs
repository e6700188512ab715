using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;

namespace Host.Assets
{
    /// <summary>A folder on disk and the path under which Unity shows its contents.</summary>
    internal readonly struct MountedFolder
    {
        public readonly string AssetPath, Folder;
        public MountedFolder(string assetPath, string folder) { AssetPath = assetPath; Folder = folder; }
    }

    /// <summary>Which folders make up a project: Assets and packages, or a package alone.</summary>
    internal static class ProjectFolders
    {
        static readonly JsonDocumentOptions Lenient = new JsonDocumentOptions { AllowTrailingCommas = true,
            CommentHandling = JsonCommentHandling.Skip };

        /// <summary>Folders of packages that this program has at hand: taken for projects that ask for them and have no copy, such as for
        /// one by a git address.</summary>
        public static IReadOnlyList<string> AtHand { get; set; } = Array.Empty<string>();

        public static bool IsAtHand(string folder) => AtHand.Any(known => Path.GetFullPath(known) == Path.GetFullPath(folder));

        public static bool IsProject(string folder) => Directory.Exists(Path.Combine(folder, "Assets"))
            && (Directory.Exists(Path.Combine(folder, "ProjectSettings"))
            || File.Exists(Path.Combine(folder, "Packages", "manifest.json")));
        public static bool IsPackage(string folder) => File.Exists(Path.Combine(folder, "package.json"));

        /// <summary>The nearest folder at or above path that is a project or a package; null when there is none.</summary>
        public static string RootOf(string path)
        {
            for (var at = Path.GetFullPath(path); at != null; at = Path.GetDirectoryName(at))
                if (Directory.Exists(at) && (IsProject(at) || IsPackage(at))) return at;
            return null;
        }

        /// <exception cref="AssetException">The folder is neither.</exception>
        public static List<MountedFolder> Of(string root)
        {
            root = Path.GetFullPath(root);
            var mounts = new List<MountedFolder>();
            if (IsProject(root))
            {
                mounts.Add(new MountedFolder("Assets", Path.Combine(root, "Assets")));
                AddPackages(root, mounts);
            }
            else if (IsPackage(root)) mounts.Add(Package(root));
            else if (Directory.Exists(Path.Combine(root, "Assets"))) mounts.Add(new MountedFolder("Assets", Path.Combine(root, "Assets")));
            else throw new AssetException($"{root} is no Unity project (a folder with Assets and ProjectSettings) and no package (a " +
                $"folder with package.json): name one");
            return mounts;
        }

        static void AddPackages(string project, List<MountedFolder> mounts)
        {
            var packages = Path.Combine(project, "Packages");
            var seen = new HashSet<string>();
            void Mount(string folder)
            {
                var package = Package(folder);
                if (seen.Add(package.AssetPath)) mounts.Add(package);
            }

            // A package that lies in Packages wins over the manifest's, as in Unity; what Unity once downloaded comes last.
            if (Directory.Exists(packages))
                foreach (var folder in Sorted(Directory.GetDirectories(packages)))
                    if (IsPackage(folder)) Mount(folder);

            var wanted = new HashSet<string>();
            var manifest = Path.Combine(packages, "manifest.json");
            if (File.Exists(manifest))
            {
                using var json = Json(manifest);
                if (json.RootElement.TryGetProperty("dependencies", out var dependencies))
                    foreach (var dependency in dependencies.EnumerateObject())
                    {
                        wanted.Add("Packages/" + dependency.Name);
                        var source = dependency.Value.GetString() ?? "";
                        if (!source.StartsWith("file:", StringComparison.Ordinal) || source.EndsWith(".tgz", StringComparison.Ordinal)) continue;
                        var folder = Path.GetFullPath(Path.Combine(packages, source.Substring(5)));
                        if (!IsPackage(folder)) throw new AssetException($"{manifest}: {dependency.Name} is at '{source}', but " +
                            $"{folder} has no package.json: correct the path (it starts at the Packages folder)");
                        Mount(folder);
                    }
            }

            var cache = Path.Combine(project, "Library", "PackageCache");
            if (Directory.Exists(cache))
                foreach (var folder in Sorted(Directory.GetDirectories(cache)))
                    if (IsPackage(folder)) Mount(folder);

            foreach (var folder in AtHand)
                if (IsPackage(folder) && wanted.Contains(Package(folder).AssetPath)) Mount(folder);
        }

        static MountedFolder Package(string folder)
        {
            var file = Path.Combine(folder, "package.json");
            using var json = Json(file);
            if (!json.RootElement.TryGetProperty("name", out var name) || string.IsNullOrEmpty(name.GetString()))
                throw new AssetException($"{file}: the package has no \"name\"");
            return new MountedFolder("Packages/" + name.GetString(), folder);
        }

        static JsonDocument Json(string file)
        {
            try
            {
                return JsonDocument.Parse(File.ReadAllText(file), Lenient);
            }
            catch (JsonException e)
            {
                throw new AssetException($"{file}({e.LineNumber + 1}): {e.Message}", e);
            }
        }

        static string[] Sorted(string[] names)
        {
            Array.Sort(names, StringComparer.Ordinal);
            return names;
        }
    }
}
