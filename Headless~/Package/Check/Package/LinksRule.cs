using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Host.Manual;

namespace Host.Check
{
    /// <summary>Links and pictures of the Markdown pages lead somewhere; the table of contents lists each page of the manual, its index each
    /// page of the research.</summary>
    sealed class LinksRule : Rule
    {
        static readonly Regex Link = new(@"!?\[(?:[^\]\[]|\[[^\]]*\])*\]\((?<target><[^>]+>|[^)\s]+)(?:\s+""[^""]*"")?\)|<img[^>]*\ssrc=""(?<target>[^""]+)""");
        static readonly Regex Heading = new(@"^#{1,6}\s+(?<text>.+?)\s*#*$");

        public override string Name => "documentation: links and pictures resolve";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int links = 0;
            List<string> pages = package.WithExtension(".md").Where(page => !page.Contains("/Tests/Projects/", StringComparison.Ordinal)).ToList();
            foreach (string page in pages)
            {
                bool code = false;
                string[] lines = package.Read(page).Split('\n');
                for (int i = 0; i < lines.Length; i++)
                {
                    if (lines[i].StartsWith("```", StringComparison.Ordinal))
                        code = !code;
                    if (code)
                        continue;
                    foreach (Match match in Link.Matches(Regex.Replace(lines[i], "`[^`]*`", "")))
                    {
                        links++;
                        if (Problem(package, page, match.Groups["target"].Value.Trim('<', '>')) is string problem)
                            findings.Fault($"{page}({i + 1}): {problem}");
                    }
                }
            }
            CheckContents(package, pages, "Documentation~/", "TableOfContents.md", findings);
            CheckContents(package, pages, "Research~/", "README.md", findings);
            findings.Looked = $"{links} links in {pages.Count} pages";
            return findings;
        }

        // Null when the link is good. What lies on the web is not asked for.
        static string Problem(PackageTree package, string page, string target)
        {
            if (Regex.IsMatch(target, "^(https?|mailto):"))
                return null;
            string[] parts = target.Split('#', 2);
            string file = parts[0].Length == 0 ? page : Resolve(page, Uri.UnescapeDataString(parts[0]));
            if (file == null || !package.Has(file) && !Directory.Exists(package.FullPath(file)))
                return $"the link to {target} leads nowhere";
            if (parts.Length == 2 && file.EndsWith(".md", StringComparison.Ordinal) && !Anchors(package.Read(file)).Contains(parts[1]))
                return $"the link to {target}: {file} has no heading of that name";
            return null;
        }

        // Null above the package's root, which no one has who installed the package.
        static string Resolve(string page, string target)
        {
            var path = new List<string>(page.Split('/').SkipLast(1));
            foreach (string part in target.Split('/'))
            {
                if (part == ".." && path.Count == 0)
                    return null;
                if (part == "..")
                    path.RemoveAt(path.Count - 1);
                else if (part.Length > 0 && part != ".")
                    path.Add(part);
            }
            return string.Join('/', path);
        }

        static HashSet<string> Anchors(string text) => text.Split('\n').Select(line => Heading.Match(line.TrimEnd('\r')))
            .Where(match => match.Success).Select(match => Anchor.Of(match.Groups["text"].Value)).ToHashSet();

        static void CheckContents(PackageTree package, List<string> pages, string folder, string name, Findings findings)
        {
            string contents = folder + name;
            if (!package.Has(contents))
            {
                findings.Fault($"{contents} is missing");
                return;
            }
            string text = package.Read(contents);
            foreach (string page in pages.Where(p => p.StartsWith(folder, StringComparison.Ordinal) && p != contents))
                if (!text.Contains("(" + page.Substring(folder.Length) + ")"))
                    findings.Fault($"{page} is not in {contents}");
        }
    }
}
