using System;
using System.IO;
using System.Linq;

namespace Host.Check.Build
{
    /// <summary>Unity puts every asset of a Resources folder into every build, used or not.</summary>
    sealed class ResourcesRule : Rule
    {
        public override string Name => "build: nothing lies in a Resources folder";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int files = 0;
            // Samples are imported into the project's Assets; the host's own test projects never are.
            foreach (string file in package.Files.Where(file => !file.StartsWith("Headless~/", StringComparison.Ordinal)
                && !file.EndsWith(".meta", StringComparison.Ordinal)))
            {
                files++;
                if (Path.GetDirectoryName(file).Split('/', '\\').Any(folder => folder.Equals("Resources", StringComparison.OrdinalIgnoreCase)))
                    findings.Fault(
                        $"{file} lies in a Resources folder, so every build contains it: put it elsewhere and let what uses it refer to it");
            }
            findings.Looked = $"{files} files";
            return findings;
        }
    }
}
