using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;

namespace Host.Check
{
    /// <summary>The files of a package, and what Unity sees of them.</summary>
    sealed class PackageTree
    {
        // Written by tools at the root of a checkout; no part of it.
        static readonly string[] Generated = { "Library", "Temp", "Logs", "UserSettings", "out~" };

        /// <summary>Full path of the package's root.</summary>
        public readonly string Root;
        /// <summary>Folder of the package's compiled assemblies: Rill.dll and the like.</summary>
        public readonly string Assemblies;
        /// <summary>Every file that is not hidden by a dot, relative to the root, with '/', in ordinal order; Samples~ and the like
        /// included.</summary>
        public readonly IReadOnlyList<string> Files;

        public PackageTree(string root, string assemblies = null)
        {
            Root = Path.GetFullPath(root);
            Assemblies = assemblies ?? AppContext.BaseDirectory;
            Files = List("").OrderBy(file => file, StringComparer.Ordinal).ToList();
        }

        /// <summary>Those in folders and under names that Unity imports.</summary>
        public IEnumerable<string> Visible => Files.Where(IsVisible);

        public string FullPath(string file) => Path.Combine(Root, file);
        public string Read(string file) => File.ReadAllText(FullPath(file));
        public bool Has(string file) => File.Exists(FullPath(file));
        public IEnumerable<string> WithExtension(params string[] extensions)
            => Files.Where(file => extensions.Contains(Path.GetExtension(file), StringComparer.OrdinalIgnoreCase));

        /// <summary>Whether a path below the root begins with a folder that tools write there.</summary>
        public static bool IsGenerated(string path)
            => Generated.Any(folder => path == folder || path.StartsWith(folder, StringComparison.Ordinal)
            && !char.IsLetterOrDigit(path[folder.Length]));

        static bool IsVisible(string file) => !file.Split('/').Any(ProjectIndex.IsHidden);

        IEnumerable<string> List(string folder)
        {
            foreach (FileSystemInfo child in new DirectoryInfo(Path.Combine(Root, folder)).EnumerateFileSystemInfos())
            {
                if (child.Name[0] == '.' || folder.Length == 0 && Generated.Contains(child.Name))
                    continue;
                string path = folder + child.Name;
                if (child is not DirectoryInfo)
                    yield return path;
                else if (child.LinkTarget == null)
                    foreach (string file in List(path + "/"))
                        yield return file;
            }
        }
    }
}
