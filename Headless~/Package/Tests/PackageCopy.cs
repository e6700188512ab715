using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>
    /// A copy of the package in a temporary folder, in which a test plants the fault that a rule exists for. What a test has changed through
    /// this class is put back at its end and the copy is lent to the next one: to copy everything took longer than most rules.
    /// </summary>
    sealed class PackageCopy : IDisposable
    {
        static readonly string[] NotNeeded = { "Headless~/Engine/", "Headless~/Package/Tests/", "Headless~/Package/Host/",
            "Headless~/Package/data/" };

        static readonly ConcurrentBag<string> Unused = new();
        static readonly ConcurrentBag<string> Made = new();

        /// <summary>Rules without parameters, and the folder of their assemblies, that hold in an unchanged copy.</summary>
        static readonly ConcurrentDictionary<(Type rule, string assemblies), bool> Held = new();

        public readonly string Root;
        readonly string assemblies;
        /// <summary>Content of files before the test, null for a missing one.</summary>
        readonly Dictionary<string, byte[]> before = new();

        static PackageCopy() => AppDomain.CurrentDomain.ProcessExit += (_, _) =>
        {
            foreach (string root in Made)
                Directory.Delete(root, true);
        };

        /// <param name="assemblies">Folder of the compiled assemblies; null: this host's.</param>
        public PackageCopy(string assemblies = null)
        {
            this.assemblies = assemblies;
            if (Unused.TryTake(out Root))
                return;
            Root = Path.Combine(Path.GetTempPath(), "rill-check-" + Guid.NewGuid().ToString("N"));
            Made.Add(Root);
            foreach (string file in new PackageTree(PackageFolder.Path).Files.Where(f =>
                !NotNeeded.Any(folder => f.StartsWith(folder, StringComparison.Ordinal))).Append("Headless~/Engine/README.md")
                .Append(".npmignore").Append("TestProject~/Assets/.gitkeep"))
                Store(file, File.ReadAllBytes(Path.Combine(PackageFolder.Path, file)));
        }

        public string this[string file]
        {
            get => File.ReadAllText(Path.Combine(Root, file));
            set => Write(file, System.Text.Encoding.UTF8.GetBytes(value));
        }

        public void Write(string file, byte[] bytes)
        {
            Remember(file);
            Store(file, bytes);
        }

        public void Delete(string file)
        {
            Remember(file);
            File.Delete(Path.Combine(Root, file));
        }

        public void Move(string from, string to)
        {
            Remember(from);
            Remember(to);
            File.Move(Path.Combine(Root, from), Path.Combine(Root, to));
        }

        public void Replace(string file, string what, string with)
        {
            Assert.That(this[file], Does.Contain(what), "the text in which the fault is planted");
            this[file] = this[file].Replace(what, with);
        }

        public Findings Examine(Rule rule) => rule.Examine(new PackageTree(Root, assemblies));

        /// <summary>The rule holds in the copy, and after the fault fails in these words, each in one fault.</summary>
        public void Catches(Rule rule, Action plant, params string[] words)
        {
            (Type, string) key = (rule.GetType(), assemblies);
            bool isKnown = before.Count == 0 && rule.GetType().GetConstructors().Length == 1
                && rule.GetType().GetConstructor(Type.EmptyTypes) != null;
            if (!isKnown || !Held.ContainsKey(key))
                Assert.That(Examine(rule).Faults, Is.Empty, "before the fault is planted");
            if (isKnown)
                Held[key] = true;
            plant();
            var faults = Examine(rule).Faults;
            Assert.That(faults.Any(fault => words.All(fault.Contains)),
                $"a fault with \"{string.Join("\" and \"", words)}\" among:\n{string.Join("\n", faults)}");
        }

        public void Dispose()
        {
            foreach ((string file, byte[] content) in before)
            {
                string here = Path.Combine(Root, file);
                if (content != null)
                    Store(file, content);
                else
                    File.Delete(here);
                for (string folder = Path.GetDirectoryName(here); folder != Root && !Directory.EnumerateFileSystemEntries(folder).Any();
                    folder = Path.GetDirectoryName(folder))
                    Directory.Delete(folder);
            }
            Unused.Add(Root);
        }

        void Remember(string file)
        {
            string here = Path.Combine(Root, file);
            before.TryAdd(file, File.Exists(here) ? File.ReadAllBytes(here) : null);
        }

        void Store(string file, byte[] bytes)
        {
            string path = Path.Combine(Root, file);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllBytes(path, bytes);
        }
    }
}
