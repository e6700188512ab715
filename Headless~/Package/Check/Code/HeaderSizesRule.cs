using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Check
{
    /// <summary>The header of a shader gives a buffer's size by the name of a constant, or by what there is one for each of: a number would be wrong
    /// once the constant changes.</summary>
    sealed class HeaderSizesRule : Rule
    {
        // "//   _Name   [16]" and "[256 * 13]"; "[1]" says that there is one.
        static readonly Regex Size = new(@"^//\s+(_\w+)\s+\[([\d\s*+]+)(\swords)?\]", RegexOptions.Compiled);

        public override string Name => "code: headers of shaders give sizes by name";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int sizes = 0;
            foreach (string file in package.Visible.Where(file => file.StartsWith("Shaders/", StringComparison.Ordinal) && IsShader(file)))
            {
                string[] lines = package.Read(file).Split('\n');
                for (int i = 0; i < lines.Length; i++)
                {
                    sizes += lines[i].StartsWith("//   _", StringComparison.Ordinal) && lines[i].Contains('[') ? 1 : 0;
                    Match match = Size.Match(lines[i]);
                    if (match.Success && match.Groups[2].Value.Trim() != "1")
                        findings.Fault($"{file}({i + 1}): the size of {match.Groups[1].Value} is the number {match.Groups[2].Value.Trim()}: " +
                            "write the constant's name, or what there is one for each of");
                }
            }
            findings.Looked = $"{sizes} sizes";
            return findings;
        }

        static bool IsShader(string file) => Path.GetExtension(file) is ".hlsl" or ".compute" or ".shader";
    }
}
