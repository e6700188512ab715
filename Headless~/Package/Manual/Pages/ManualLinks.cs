using System.Text.RegularExpressions;

namespace Host.Manual
{
    /// <summary>Targets of links on the manual's Markdown pages, as its HTML pages have them, which lie a folder deeper.</summary>
    static class ManualLinks
    {
        const string Html = "html/", TableOfContents = "TableOfContents.md";

        /// <summary>A page of the manual becomes its HTML; all else, pages outside and pictures, stays the file that it is.</summary>
        public static string InHtml(string target)
        {
            if (target.Length == 0 || target[0] == '#' || Regex.IsMatch(target, "^[a-z]+:"))
                return target;
            if (target.StartsWith(Html, System.StringComparison.Ordinal))
                return target.Substring(Html.Length);
            if (target == TableOfContents)
                return "index.html";
            Match page = Regex.Match(target, @"^(?<name>[\w-]+)\.md(?<anchor>#.*)?$");
            return page.Success ? page.Groups["name"].Value + ".html" + page.Groups["anchor"].Value : "../" + target;
        }
    }
}
