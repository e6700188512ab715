using System.Collections.Generic;
using System.Linq;

namespace Host.Check
{
    /// <summary>Generated files hold what their sources say now.</summary>
    sealed class GeneratedFilesRule : Rule
    {
        readonly IReadOnlyList<GeneratedFiles> all;

        public GeneratedFilesRule() : this(GeneratedFiles.All) { }

        public GeneratedFilesRule(IReadOnlyList<GeneratedFiles> all) => this.all = all;

        public override string Name => "generated files are up to date";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int compared = 0;
            foreach (GeneratedFiles generated in all)
            {
                IReadOnlyDictionary<string, string> texts = generated.Texts(package, findings);
                if (texts == null)
                    continue;
                foreach ((string path, string expected) in texts)
                {
                    compared++;
                    if (!package.Has(path))
                        findings.Fault($"{path} is missing: run `Headless~/rill generate`.");
                    else if (FirstDifference(package.Read(path), expected) is int line)
                        findings.Fault($"{path}({line}) is not what its sources say: run `Headless~/rill generate`.");
                }
                foreach (string path in generated.Leftover(package, texts))
                    findings.Fault($"{path} is generated from nothing any more: run `Headless~/rill generate`, which deletes it.");
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
