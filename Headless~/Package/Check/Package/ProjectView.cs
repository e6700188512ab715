using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;

namespace Host.Check
{
    /// <summary>The package as a project has it that imports all samples: one set of GUIDs.</summary>
    static class ProjectView
    {
        public static List<MountedFolder> Mounts(PackageTree package)
        {
            var mounts = new List<MountedFolder> { new("Packages/" + Path.GetFileName(package.Root), package.Root) };
            string samples = package.FullPath("Samples~");
            if (Directory.Exists(samples))
                mounts.AddRange(Directory.GetDirectories(samples).OrderBy(folder => folder, System.StringComparer.Ordinal)
                    .Select(folder => new MountedFolder("Samples~/" + Path.GetFileName(folder), folder)));
            string project = package.FullPath("TestProject~/Assets");
            if (Directory.Exists(project))
                mounts.Add(new MountedFolder("TestProject~/Assets", project));
            return mounts;
        }

        public static ProjectIndex Index(PackageTree package)
        {
            var index = new ProjectIndex(ignoreCase: false);
            foreach (MountedFolder mount in Mounts(package))
                index.Mount(mount);
            return index;
        }

        /// <summary>Scenes, prefabs, materials and other assets in Unity's YAML.</summary>
        public static IEnumerable<AssetEntry> Documents(ProjectIndex index)
            => index.Entries.Where(entry => !entry.IsFolder && IsYaml(entry.Extension));

        static bool IsYaml(string extension) => extension is ".unity" or ".prefab" or ".asset" or ".mat" or ".mesh" or ".rendertexture";
    }
}
