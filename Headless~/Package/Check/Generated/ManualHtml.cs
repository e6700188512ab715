using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Manual;

namespace Host.Check
{
    /// <summary>The manual as HTML, which the question marks of components open.</summary>
    sealed class ManualHtml : GeneratedFiles
    {
        const string OfThePackage = "Documentation~/TableOfContents.md";

        public override string Folder => "Documentation~/html/";

        public override IReadOnlyDictionary<string, string> Texts(PackageTree package, Findings findings)
        {
            if (!package.Has(OfThePackage) || ManualBuilder.Assemblies.Any(name => Compiled(package, name, findings) == null))
                return null;
            int before = findings.Faults.Count;
            IReadOnlyDictionary<string, string> files = ManualBuilder.Build(package.Root, Path.GetFullPath(package.Assemblies), findings.Fault);
            return findings.Faults.Count > before ? null : files.ToDictionary(file => Folder + file.Key, file => file.Value);
        }
    }
}
