using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.Check
{
    /// <summary>A checkout on Windows or macOS must come out whole.</summary>
    sealed class FileNamesRule : Rule
    {
        const long MaxBytes = 5 * 1000 * 1000;
        // Windows ends paths at 260; a project's own folder and Library/PackageCache/<name>@<hash>/ come before ours.
        const int MaxPath = 140;
        static readonly char[] Forbidden = "<>:\"|?*\\".ToCharArray();
        static readonly HashSet<string> Reserved =
            new(new[] { "CON", "PRN", "AUX", "NUL" }.Concat(Enumerable.Range(1, 9).SelectMany(i => new[] { "COM" + i, "LPT" + i })),
            StringComparer.OrdinalIgnoreCase);

        public override string Name => "package: file names suit every system, no file is large";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            foreach (string file in package.Files)
            {
                foreach (string part in file.Split('/'))
                    if (part.IndexOfAny(Forbidden) >= 0 || part.Any(char.IsControl) || part.EndsWith('.') || part.EndsWith(' ')
                        || Reserved.Contains(part.Split('.')[0]))
                        findings.Fault($"{file}: \"{part}\" is not a file name on Windows: rename it");
                if (file.Length > MaxPath)
                    findings.Fault($"{file}: the path has {file.Length} characters, more than {MaxPath}: shorten it, Windows ends at 260 in all");
                long bytes = new FileInfo(package.FullPath(file)).Length;
                if (bytes > MaxBytes)
                    findings.Fault($"{file} has {bytes:N0} bytes, more than {MaxBytes:N0}: everybody who installs by git URL downloads it");
            }
            foreach (IGrouping<string, string> same in package.Files.SelectMany(Parents).Distinct()
                .GroupBy(f => f, StringComparer.OrdinalIgnoreCase).Where(g => g.Count() > 1))
                findings.Fault($"{string.Join(" and ", same)} differ in case alone, and are one file on Windows and macOS");
            findings.Looked = $"{package.Files.Count} files, largest " +
                $"{package.Files.Select(f => new FileInfo(package.FullPath(f)).Length).DefaultIfEmpty().Max():N0} bytes";
            return findings;
        }

        // A file and the folders around it.
        static IEnumerable<string> Parents(string file)
        {
            for (int end = file.Length; end > 0; end = file.LastIndexOf('/', end - 1))
                yield return file.Substring(0, end);
        }
    }
}
