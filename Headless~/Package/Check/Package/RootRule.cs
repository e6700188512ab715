using System;
using System.IO;
using System.Linq;

namespace Host.Check
{
    /// <summary>The package's root cannot be opened as a Unity project: Unity would write Library/ and the like into the package.</summary>
    sealed class RootRule : Rule
    {
        // Folders by which Unity and its Hub recognize a project. Library/ and its kin are left by opening one.
        static readonly string[] OfProjects = { "Assets", "Packages", "ProjectSettings" };

        public override string Name => "package: the root is not a project that Unity could open";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            // On any system's file system, "packages" is the same folder.
            string[] folders = Directory.GetDirectories(package.Root).Select(Path.GetFileName).ToArray();
            foreach (string folder in folders.Where(folder => OfProjects.Contains(folder, StringComparer.OrdinalIgnoreCase)))
                findings.Fault($"{folder}/ at the root makes the package a project of its own, and opening it puts Library/ inside of " +
                    $"the package: remove the folder and open TestProject~");
            findings.Looked = $"{folders.Length} folders at the root";
            return findings;
        }
    }
}
