using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.Assets
{
    /// <summary>A scene file, and what has to be mounted to open it.</summary>
    internal sealed class LocatedScene
    {
        public string File;
        /// <summary>The project or package that it belongs to.</summary>
        public string Root;
        /// <summary>Root's folders and, for a package's sample, the sample as if it had been imported.</summary>
        public List<MountedFolder> Mounts;
        /// <summary>"Assets/Samples/Dam Break/Dam Break.unity".</summary>
        public string AssetPath;
    }

    /// <summary>From what a user types ("Dam Break", "Samples~/Dam Break", a .unity file) to a scene.</summary>
    internal static class SceneLocator
    {
        /// <exception cref="AssetException">None or several fit; the message lists what there is.</exception>
        public static LocatedScene Find(string what) => Find(what, Directory.GetCurrentDirectory());

        /// <param name="from">Where relative paths start; names are searched in the project or package around it.</param>
        public static LocatedScene Find(string what, string from)
        {
            var path = Path.GetFullPath(Path.Combine(from, what));
            if (File.Exists(path))
                return path.EndsWith(".unity", StringComparison.OrdinalIgnoreCase) ? Locate(path)
                    : throw new AssetException($"{what} is not a scene: a scene's file ends in .unity");

            var root = ProjectFolders.RootOf(Directory.Exists(path) ? path : from);
            if (Directory.Exists(path)) return Single(ScenesBelow(path), what, root);
            var all = root == null ? new List<string>() : ScenesBelow(root);
            var named = all.Where(s => Fits(s, what, root)).ToList();
            return Single(named, what, root);
        }

        static bool Fits(string scene, string what, string root)
        {
            var below = Path.GetRelativePath(root, scene).Replace('\\', '/');
            what = what.Replace('\\', '/').TrimEnd('/');
            return Path.GetFileNameWithoutExtension(scene).Equals(what, StringComparison.OrdinalIgnoreCase)
                || Path.GetFileName(Path.GetDirectoryName(scene)).Equals(what, StringComparison.OrdinalIgnoreCase)
                || below.Equals(what, StringComparison.OrdinalIgnoreCase)
                || below.StartsWith(what + "/", StringComparison.OrdinalIgnoreCase);
        }

        static LocatedScene Single(List<string> scenes, string what, string root)
        {
            if (scenes.Count == 1) return Locate(scenes[0]);
            if (scenes.Count > 1) throw new AssetException($"'{what}' has {scenes.Count} scenes: name one of them\n{Listed(scenes, root)}");
            var others = root == null ? new List<string>() : ScenesBelow(root);
            throw new AssetException(others.Count > 0
                ? $"scene '{what}' does not exist; {root} has\n{Listed(others, root)}"
                : $"scene '{what}' does not exist, and " +
                $"{(root == null ? "this folder belongs to no Unity project or package" : root + " has no other either")}");
        }

        static string Listed(List<string> scenes, string root)
            => string.Join("\n", scenes.Select(s => "  " + (root == null ? s : Path.GetRelativePath(root, s))));

        /// <summary>Every scene that Unity could show: those of samples too, though their folder is hidden.</summary>
        static List<string> ScenesBelow(string folder)
        {
            var found = Directory.GetFiles(folder, "*.unity").ToList();
            // In a project, the rest (Library, Temp) is the editor's.
            var children = ProjectFolders.IsProject(folder)
                ? new[] { Path.Combine(folder, "Assets"), Path.Combine(folder, "Packages") }.Where(Directory.Exists)
                : Directory.GetDirectories(folder);
            foreach (var child in children)
            {
                var name = Path.GetFileName(child);
                if (!ProjectIndex.IsHidden(name) || name == "Samples~" || ProjectFolders.IsProject(child)) found.AddRange(ScenesBelow(child));
            }
            found.Sort(StringComparer.Ordinal);
            return found;
        }

        static LocatedScene Locate(string file)
        {
            var root = ProjectFolders.RootOf(Path.GetDirectoryName(file))
                ?? throw new AssetException(
                $"{file} lies in no Unity project (a folder with Assets and ProjectSettings) and no package (a folder with package.json)");
            var mounts = ProjectFolders.Of(root);
            var below = Path.GetRelativePath(root, file).Split(Path.DirectorySeparatorChar);
            var hidden = Array.FindIndex(below, 0, below.Length - 1, ProjectIndex.IsHidden);
            if (hidden >= 0 && hidden + 1 < below.Length - 1)
                mounts.Add(new MountedFolder("Assets/Samples/" + below[hidden + 1], Path.Combine(root, below[hidden], below[hidden + 1])));

            var within = mounts.Where(m => file.StartsWith(m.Folder + Path.DirectorySeparatorChar, StringComparison.Ordinal))
                .OrderByDescending(m => m.Folder.Length).ToList();
            if (within.Count == 0)
                throw new AssetException(
                $"{file} lies outside of what Unity would import of {root}: move it below Assets, or to Samples~/<name>/ of a package");
            return new LocatedScene
            {
                File = file, Root = root, Mounts = mounts,
                AssetPath = within[0].AssetPath + "/" + Path.GetRelativePath(within[0].Folder, file).Replace(Path.DirectorySeparatorChar, '/'),
            };
        }
    }
}
