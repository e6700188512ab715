using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;

namespace Host
{
    /// <summary>Finds a scene in a given project: among its own, then among the samples of its packages.</summary>
    static class ProjectScenes
    {
        public static LocatedScene Find(string project, string scene)
        {
            if (scene == null)
                return First(project);
            // A path as the user sees it from where they are, if it leads into the project.
            string typed = Path.GetFullPath(scene);
            if (File.Exists(typed) && typed.StartsWith(project + Path.DirectorySeparatorChar, StringComparison.Ordinal))
                return SceneLocator.Find(typed, project);
            try
            {
                return SceneLocator.Find(scene, project);
            }
            catch (AssetException) when (InSample(project, scene) is LocatedScene sample)
            {
                return sample;
            }
        }

        static LocatedScene First(string project)
        {
            List<string> build = ProjectSettings.BuildScenes(project).Where(path => File.Exists(Path.Combine(project, path))).ToList();
            if (build.Count > 0)
                return SceneLocator.Find(build[0], project);
            string assets = Path.Combine(project, "Assets");
            List<string> all = Directory.GetFiles(assets, "*.unity", SearchOption.AllDirectories)
                .Select(file => Path.GetRelativePath(project, file)).OrderBy(path => path, StringComparer.Ordinal).ToList();
            return all.Count switch
            {
                1 => SceneLocator.Find(all[0], project),
                0 => throw new HostException($"{project} has no scene; name one of a package's samples, if it has such."),
                _ => throw new HostException(
                    $"{project} has {all.Count} scenes and none in its build settings; name one of {string.Join(", ", all)}."),
            };
        }

        /// <summary>Locates a scene as if the sample had been imported by the Package Manager's button; null without one.</summary>
        static LocatedScene InSample(string project, string scene)
        {
            List<MountedFolder> mounts = ProjectFolders.Of(project);
            foreach (MountedFolder package in mounts.Where(mount => mount.AssetPath.StartsWith("Packages/", StringComparison.Ordinal)))
            {
                if (!Directory.Exists(Path.Combine(package.Folder, "Samples~")))
                    continue;
                LocatedScene found;
                try
                {
                    found = SceneLocator.Find(scene, package.Folder);
                }
                catch (AssetException)
                {
                    continue;       // this package has none of that name
                }
                List<MountedFolder> samples =
                    found.Mounts.Where(mount => mount.AssetPath.StartsWith("Assets/Samples/", StringComparison.Ordinal)).ToList();
                if (samples.Count > 0)
                    return new LocatedScene { File = found.File, Root = project, Mounts = mounts.Concat(samples).ToList(),
                        AssetPath = found.AssetPath };
            }
            return null;
        }
    }
}
