using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Security.Cryptography;
using System.Text;

namespace Host.Check
{
    /// <summary>Files of the package that are derived from other files of it: `rill generate` writes them, `rill check` compares them.</summary>
    abstract class GeneratedFiles
    {
        /// <summary>In the order in which they are written: a later one may read what an earlier one wrote.</summary>
        public static IReadOnlyList<GeneratedFiles> All { get; } = new GeneratedFiles[]
        {
            new HlslFiles(),
            new KernelNeedsFile(),
            new StageAssets(),
            new ReferencePage(),
            new ArchitecturePage(),
            new PerformancePage(),
            new ManualHtml(),
        };

        /// <summary>Those of the manual: the others take longer, and a change of a page needs none of them.</summary>
        public static IReadOnlyList<GeneratedFiles> OfManual { get; } = new GeneratedFiles[] { new ReferencePage(), new ManualHtml() };

        /// <summary>A folder that holds no other files, below the package's root with '/' at its end; null where they lie among others.</summary>
        public virtual string Folder => null;

        /// <summary>Content that each has to hold, by its path below the package's root; null where their sources are not in the package, or where
        /// these have faults, which are named.</summary>
        public abstract IReadOnlyDictionary<string, string> Texts(PackageTree package, Findings findings);

        /// <summary>Returns an assembly of the package; null, and a fault, where it is not built.</summary>
        protected static Assembly Compiled(PackageTree package, string name, Findings findings)
        {
            string file = Path.Combine(package.Assemblies, name + ".dll");
            if (File.Exists(file))
                return Assembly.LoadFrom(file);
            findings.Fault($"{file} is not there: build it first (Headless~/rill does)");
            return null;
        }

        /// <summary>Returns a .meta file as Headless~/Engine/tools/make-meta writes it: its GUID comes from the path.</summary>
        /// <param name="importer">Name of the importer, with lines before it.</param>
        /// <param name="settings">Lines of the importer.</param>
        protected static string Meta(string path, string importer, string settings = "") => $"fileFormatVersion: 2\nguid: {NewGuid(path)}\n" +
            $"{importer}:\n  externalObjects: {{}}\n{settings}  userData: \n  assetBundleName: \n  assetBundleVariant: \n";

        /// <summary>Returns the GUID that a path has in a new .meta file.</summary>
        protected static string NewGuid(string path)
            => Convert.ToHexString(MD5.HashData(Encoding.UTF8.GetBytes("com.rill.fluids:" + path))).ToLowerInvariant();

        /// <summary>Files of the folder that nothing generates any more.</summary>
        public IEnumerable<string> Leftover(PackageTree package, IReadOnlyDictionary<string, string> texts) =>
            Folder == null ? Enumerable.Empty<string>()
            : package.Files.Where(file => file.StartsWith(Folder, StringComparison.Ordinal) && !texts.ContainsKey(file));
    }
}
