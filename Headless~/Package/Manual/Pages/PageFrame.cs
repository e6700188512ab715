using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Host.Manual
{
    /// <summary>A link with its text, which is HTML.</summary>
    sealed record PageLink(string Text, string Address);

    /// <summary>Links under one title.</summary>
    /// <param name="Title">Null for links that stand for themselves.</param>
    sealed record LinkGroup(string Title, IReadOnlyList<PageLink> Links);

    /// <summary>Content of a page between head and foot.</summary>
    sealed class PageContent
    {
        /// <summary>Below the folder of the HTML.</summary>
        public string Address, Title, Body;
        public IReadOnlyList<LinkGroup> Navigation;
        /// <summary>Headings of the page; those of level 3 stand further in.</summary>
        public IEnumerable<PageHeading> Headings;
        /// <summary>Neighbors in reading order, or null.</summary>
        public PageLink Previous, Next;
    }

    /// <summary>The page around a content: head, search, table of contents, headings.</summary>
    sealed class PageFrame
    {
        readonly string product, version;

        public PageFrame(string product, string version) => (this.product, this.version) = (Html.Escape(product), Html.Escape(version));

        public string Around(PageContent page)
        {
            string root = string.Concat(Enumerable.Repeat("../", page.Address.Count(letter => letter == '/')));
            string title = page.Title == product ? product : $"{Html.Escape(page.Title)} – {product}";
            var html = new StringBuilder();
            html.Append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
            html.Append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
            html.Append($"<title>{title}</title>\n<link rel=\"icon\" href=\"{root}../../Editor/Icons/Drop.png\">\n");
            html.Append($"<link rel=\"stylesheet\" href=\"{root}../style/manual.css\">\n");
            html.Append($"<script defer src=\"{root}../style/manual.js\"></script>\n</head>\n<body>\n");
            html.Append($"<header>\n<a class=\"brand\" href=\"{root}index.html\">");
            html.Append($"<img src=\"{root}../../Editor/Icons/Drop.png\" alt=\"\">{product}</a>");
            html.Append($"<span class=\"version\">{version}</span>\n");
            html.Append("<div class=\"search\" role=\"search\" hidden><input type=\"search\" placeholder=\"Search\" " +
                "aria-label=\"Search the manual\" autocomplete=\"off\" spellcheck=\"false\"><ol hidden></ol></div>\n</header>\n");
            html.Append("<input type=\"checkbox\" id=\"menu\"><label for=\"menu\">Contents</label>\n<div class=\"columns\">\n");
            AppendNavigation(html, page, root);
            html.Append($"<main>\n{page.Body.TrimEnd()}\n");
            AppendNeighbors(html, page, root);
            html.Append("</main>\n");
            AppendHeadings(html, page);
            return html.Append("</div>\n</body>\n</html>\n").ToString();
        }

        static void AppendNavigation(StringBuilder html, PageContent page, string root)
        {
            html.Append("<nav aria-label=\"Manual\">\n");
            foreach (LinkGroup group in page.Navigation)
            {
                if (group.Title != null)
                    html.Append($"<h2>{Html.Escape(group.Title)}</h2>\n");
                html.Append("<ul>\n");
                foreach (PageLink link in group.Links)
                    html.Append($"<li><a href=\"{FromTo(page.Address, link.Address, root)}\"" +
                        $"{(link.Address == page.Address ? " aria-current=\"page\"" : "")}>{link.Text}</a>\n");
                html.Append("</ul>\n");
            }
            html.Append("</nav>\n");
        }

        // Short within a folder: the lists of links are a large part of all pages.
        static string FromTo(string page, string target, string root)
        {
            int folder = page.LastIndexOf('/') + 1;
            return folder > 0 && target.StartsWith(page.Substring(0, folder), System.StringComparison.Ordinal) ? target.Substring(folder)
                : root + target;
        }

        static void AppendNeighbors(StringBuilder html, PageContent page, string root)
        {
            if (page.Previous == null && page.Next == null)
                return;
            html.Append("<footer>\n");
            if (page.Previous != null)
                html.Append($"<a rel=\"prev\" href=\"{root}{page.Previous.Address}\">{page.Previous.Text}</a>\n");
            if (page.Next != null)
                html.Append($"<a rel=\"next\" href=\"{root}{page.Next.Address}\">{page.Next.Text}</a>\n");
            html.Append("</footer>\n");
        }

        static void AppendHeadings(StringBuilder html, PageContent page)
        {
            List<PageHeading> headings = page.Headings.Where(heading => heading.Level is 2 or 3).ToList();
            if (headings.Count < 2)
                return;
            html.Append("<aside>\n<h2>On this page</h2>\n<ul>\n");
            foreach (PageHeading heading in headings)
                html.Append($"<li{(heading.Level == 3 ? " class=\"sub\"" : "")}><a href=\"#{heading.Id}\">{Html.Escape(heading.Text)}</a>\n");
            html.Append("</ul>\n</aside>\n");
        }
    }
}
