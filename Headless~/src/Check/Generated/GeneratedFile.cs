using System.Collections.Generic;

namespace Host.Check
{
    /// <summary>A file of the package that is derived from other files of it: `rill generate` writes it, `rill check` compares it.</summary>
    abstract class GeneratedFile
    {
        /// <summary>In the order in which they are written: a later one may read what an earlier one wrote.</summary>
        public static IReadOnlyList<GeneratedFile> All { get; } = new GeneratedFile[]
        {
            new KernelNeedsFile(),
            new ReferencePage(),
        };

        /// <summary>Below the package's root, with '/'.</summary>
        public abstract string Path { get; }

        /// <summary>What it has to hold; null where its sources are not in the package, or where they have faults, which are named.</summary>
        public abstract string Text(PackageTree package, Findings findings);
    }
}
