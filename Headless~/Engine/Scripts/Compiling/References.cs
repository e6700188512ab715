using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Microsoft.CodeAnalysis;

namespace Host.Scripts.Compiling
{
    /// <summary>References that scripts are compiled against: .NET Standard 2.1 as Unity has it, and the host's own assemblies.</summary>
    internal static class References
    {
        const string Prefix = "netstandard2.1/";

        static readonly Assembly Here = typeof(References).Assembly;
        static List<MetadataReference> standard;

        /// <summary>The reference assemblies of .NET Standard 2.1 with the façades through which plugins built for .NET Framework find
        /// their types.</summary>
        public static IReadOnlyList<MetadataReference> Standard
            => standard ??= Here.GetManifestResourceNames().Where(n => n.StartsWith(Prefix, System.StringComparison.Ordinal))
            .Select(name => (MetadataReference)MetadataReference.CreateFromStream(Here.GetManifestResourceStream(name),
                filePath: name.Substring(Prefix.Length))).ToList();

        /// <summary>A source file carried inside of this assembly.</summary>
        public static string Source(string name)
        {
            using var reader = new StreamReader(Here.GetManifestResourceStream("stubs/" + name));
            return reader.ReadToEnd();
        }
    }
}
