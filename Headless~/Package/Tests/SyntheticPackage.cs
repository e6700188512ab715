using System;
using System.IO;
using Host.Check;

namespace Host.Tests
{
    /// <summary>A package of a few files, for rules to find the faults in.</summary>
    sealed class SyntheticPackage : IDisposable
    {
        public readonly string Folder = Directory.CreateTempSubdirectory("rill-check-").FullName;

        public SyntheticPackage() => Add("package.json", "{ \"name\": \"com.test.planted\" }");

        public void Dispose() => Directory.Delete(Folder, recursive: true);

        public SyntheticPackage Add(string file, string text)
        {
            string path = Path.Combine(Folder, file);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, text);
            return this;
        }

        public PackageTree Tree => new PackageTree(Folder);
    }
}
