using System;
using System.Collections.Generic;
using System.Linq;

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
        };

        /// <summary>A folder that holds no other files, below the package's root with '/' at its end; null where they lie among others.</summary>
        public virtual string Folder => null;

        /// <summary>Content that each has to hold, by its path below the package's root; null where their sources are not in the package, or where
        /// these have faults, which are named.</summary>
        public abstract IReadOnlyDictionary<string, string> Texts(PackageTree package, Findings findings);

        /// <summary>Files of the folder that nothing generates any more.</summary>
        public IEnumerable<string> Leftover(PackageTree package, IReadOnlyDictionary<string, string> texts) =>
            Folder == null ? Enumerable.Empty<string>()
            : package.Files.Where(file => file.StartsWith(Folder, StringComparison.Ordinal) && !texts.ContainsKey(file));
    }
}
