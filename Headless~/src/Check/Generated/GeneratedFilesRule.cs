using System.Collections.Generic;
using System.Linq;

namespace Host.Check
{
    /// <summary>Generated files hold what their sources say now.</summary>
    sealed class GeneratedFilesRule : Rule
    {
        readonly IReadOnlyList<GeneratedFile> files;

        public GeneratedFilesRule() : this(GeneratedFile.All) { }

        public GeneratedFilesRule(IReadOnlyList<GeneratedFile> files) => this.files = files;

        public override string Name => "generated files are up to date";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int compared = 0;
            foreach (GeneratedFile file in files)
            {
                string expected = file.Text(package, findings);
                if (expected == null)
                    continue;
                compared++;
                if (!package.Has(file.Path))
                    findings.Fault($"{file.Path} is missing: run `Headless~/rill generate`.");
                else if (FirstDifference(package.Read(file.Path), expected) is int line)
                    findings.Fault($"{file.Path}({line}) is not what its sources say: run `Headless~/rill generate`.");
            }
            findings.Looked = $"{compared} files";
            return findings;
        }

        // Null where there is none. Line ends do not count: git may have changed them.
        static int? FirstDifference(string actual, string expected)
        {
            string[] actualLines = Lines(actual), expectedLines = Lines(expected);
            if (actualLines.SequenceEqual(expectedLines))
                return null;
            return actualLines.Zip(expectedLines).TakeWhile(pair => pair.First == pair.Second).Count() + 1;
        }

        static string[] Lines(string text) => text.Replace("\r\n", "\n").Split('\n');
    }
}
