using System;
using System.IO;
using System.Linq;

namespace Host.Check
{
    /// <summary>Lines of the package's code fit beside each other on a screen. The formatter does not break lines, so this rule asks for
    /// it.</summary>
    /// <remarks>Left out: what a program writes, preprocessor lines, which end with their line, and lines with a string that long.</remarks>
    sealed class LineLengthRule : Rule
    {
        const int MaxColumns = 150;
        // A text that is looked for in one piece, or code for another compiler, may stay in one.
        const int LongString = 90;

        public override string Name => "code: lines are no longer than a screen";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int files = 0, longest = 0;
            foreach (string file in package.Visible.Where(IsCode))
            {
                files++;
                string[] lines = package.Read(file).Split('\n');
                for (int i = 0; i < lines.Length; i++)
                {
                    string line = lines[i].TrimEnd('\r');
                    if (line.TrimStart().StartsWith('#') || HasLongString(line))
                        continue;
                    longest = Math.Max(longest, line.Length);
                    if (line.Length > MaxColumns)
                        findings.Fault($"{file}({i + 1}) has {line.Length} columns, more than {MaxColumns}: break the line");
                }
            }
            findings.Looked = $"{files} files, longest line {longest} columns";
            return findings;
        }

        static bool IsCode(string file) => Path.GetExtension(file) is ".cs" or ".hlsl" or ".compute" or ".shader"
            && !file.Contains(".Generated.") && !file.StartsWith("Shaders/Generated/", StringComparison.Ordinal);

        // Quotes within a string's holes count as its ends, so what is longer is at least as long.
        static bool HasLongString(string line)
        {
            int start = -1;
            for (int i = 0; i < line.Length; i++)
            {
                if (line[i] == '\\')
                    i++;
                else if (line[i] == '"' && start >= 0 && i - start > LongString)
                    return true;
                else if (line[i] == '"')
                    start = start < 0 ? i : -1;
            }
            return start >= 0 && line.Length - start > LongString;
        }
    }
}
