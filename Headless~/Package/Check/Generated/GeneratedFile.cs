using System.Collections.Generic;

namespace Host.Check
{
    /// <summary>A single generated file.</summary>
    abstract class GeneratedFile : GeneratedFiles
    {
        /// <summary>Below the package's root, with '/'.</summary>
        public abstract string Path { get; }

        /// <summary>Content that it has to hold; null where its sources are not in the package, or where they have faults, which are named.</summary>
        public abstract string Text(PackageTree package, Findings findings);

        public sealed override IReadOnlyDictionary<string, string> Texts(PackageTree package, Findings findings) =>
            Text(package, findings) is string text ? new Dictionary<string, string> { [Path] = text } : null;
    }
}
