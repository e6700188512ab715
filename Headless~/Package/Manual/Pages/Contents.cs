using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Manual
{
    /// <summary>A page in the table of contents.</summary>
    /// <param name="Address">Below the folder of the HTML.</param>
    sealed record ContentsEntry(string Title, string Address);

    /// <summary>Pages under one title.</summary>
    /// <param name="Title">Null for pages that stand for themselves.</param>
    sealed record ContentsGroup(string Title, List<ContentsEntry> Entries);

    /// <summary>The manual's table of contents: a list in Markdown, whose points without a link are the titles of groups.</summary>
    sealed class Contents
    {
        static readonly Regex Point = new(@"^(?<indent>\s*)[*-] (?:\[(?<title>[^\]]+)\]\((?<target>[^)]+)\)|(?<group>.+?))\s*$");

        public readonly List<ContentsGroup> Groups = new();

        /// <summary>Pages in reading order.</summary>
        public readonly List<ContentsEntry> Entries;

        public Contents(string markdown)
        {
            foreach (Match point in markdown.Split('\n').Select(line => Point.Match(line)).Where(match => match.Success))
            {
                if (point.Groups["group"].Success)
                    Groups.Add(new ContentsGroup(point.Groups["group"].Value, new List<ContentsEntry>()));
                else
                {
                    bool alone = point.Groups["indent"].Length == 0;
                    if (Groups.Count == 0 || alone && Groups[^1].Title != null)
                        Groups.Add(new ContentsGroup(null, new List<ContentsEntry>()));
                    Groups[^1].Entries.Add(new ContentsEntry(point.Groups["title"].Value, ManualLinks.InHtml(point.Groups["target"].Value)));
                }
            }
            Entries = Groups.SelectMany(group => group.Entries).ToList();
        }
    }
}
