using System;
using System.IO;
using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>A copy of the package in a temporary folder, in which a test plants the fault that a rule exists for.</summary>
    sealed class PackageCopy : IDisposable
    {
        static readonly string[] NotNeeded = { "Headless~/Engine/", "Headless~/Package/Tests/", "Headless~/Package/Host/",
            "Headless~/Package/data/" };

        public readonly string Root = Path.Combine(Path.GetTempPath(), "rill-check-" + Guid.NewGuid().ToString("N"));
        readonly string assemblies;

        /// <param name="assemblies">Folder of the compiled assemblies; null: this host's.</param>
        public PackageCopy(string assemblies = null)
        {
            this.assemblies = assemblies;
            string package = PackageFolder.Path;
            foreach (string file in new PackageTree(package).Files.Where(f =>
                !NotNeeded.Any(folder => f.StartsWith(folder, StringComparison.Ordinal))).Append("Headless~/Engine/README.md")
                .Append(".npmignore").Append("TestProject~/Assets/.gitkeep"))
                Write(file, File.ReadAllBytes(Path.Combine(package, file)));
        }

        public string this[string file]
        {
            get => File.ReadAllText(Path.Combine(Root, file));
            set => Write(file, System.Text.Encoding.UTF8.GetBytes(value));
        }

        public void Write(string file, byte[] bytes)
        {
            string path = Path.Combine(Root, file);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllBytes(path, bytes);
        }

        public void Delete(string file) => File.Delete(Path.Combine(Root, file));
        public void Move(string from, string to) => File.Move(Path.Combine(Root, from), Path.Combine(Root, to));

        public void Replace(string file, string what, string with)
        {
            Assert.That(this[file], Does.Contain(what), "the text in which the fault is planted");
            this[file] = this[file].Replace(what, with);
        }

        public Findings Examine(Rule rule) => rule.Examine(new PackageTree(Root, assemblies));

        /// <summary>The rule holds in the copy, and after the fault fails in these words, each in one fault.</summary>
        public void Catches(Rule rule, Action plant, params string[] words)
        {
            Assert.That(Examine(rule).Faults, Is.Empty, "before the fault is planted");
            plant();
            var faults = Examine(rule).Faults;
            Assert.That(faults.Any(fault => words.All(fault.Contains)),
                $"a fault with \"{string.Join("\" and \"", words)}\" among:\n{string.Join("\n", faults)}");
        }

        public void Dispose() => Directory.Delete(Root, true);
    }
}
