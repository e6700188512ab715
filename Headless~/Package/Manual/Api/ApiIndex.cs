using System.Collections.Generic;
using System.Linq;
using System.Text;
using Microsoft.CodeAnalysis;

namespace Host.Manual
{
    /// <summary>The scripting reference's first page: all types by what they are, with a sentence each.</summary>
    static class ApiIndex
    {
        public const string Address = ApiLibrary.Folder + "index.html", Title = "Scripting reference";

        static readonly string[] Groups = { "Components", "Assets", "Classes", "Structs", "Interfaces and delegates", "Enums" };

        /// <summary>The first page with the groups on it, and the types of one group: lists of all types would be most of the pages' size.</summary>
        /// <param name="type">Null for the first page.</param>
        public static IReadOnlyList<LinkGroup> Navigation(ApiLibrary library, ApiType type)
        {
            var navigation = new List<LinkGroup>
            {
                new(null, new[] { new PageLink("← Manual", "index.html") }),
                new(Title, Present(library).Select(group => new PageLink(group, $"{Address}#{Anchor.Of(group)}"))
                    .Prepend(new PageLink("All types", Address)).ToList()),
            };
            if (type != null)
                navigation.Add(new LinkGroup(GroupOf(type), library.Types.Where(other => GroupOf(other) == GroupOf(type))
                    .Select(other => new PageLink(Html.Escape(other.Name), other.Address)).ToList()));
            return navigation;
        }

        public static IEnumerable<PageHeading> Headings(ApiLibrary library)
            => Present(library).Select(group => new PageHeading(2, Anchor.Of(group), group));

        static IEnumerable<string> Present(ApiLibrary library) => Groups.Where(group => library.Types.Any(type => GroupOf(type) == group));

        public static string Body(ApiLibrary library, ApiPage pages)
        {
            var html = new StringBuilder($"<h1>{Title}</h1>\n<p class=\"lead\">Every public type of the package. " +
                "<a href=\"../scripting.html\">Scripting</a> shows them in use; the <a href=\"../reference.html\">component reference</a> has what " +
                "the inspector shows. Left out is <code>FluidSurfaceFeature</code>, which is there with URP alone: see " +
                "<a href=\"../rendering.html\">Rendering</a>.</p>\n");
            foreach (string group in Present(library))
            {
                string anchor = Anchor.Of(group);
                html.Append($"<h2 id=\"{anchor}\"><a href=\"#{anchor}\">{group}</a></h2>\n<div class=\"table\">\n<table>\n<tbody>\n");
                foreach (ApiType type in library.Types.Where(type => GroupOf(type) == group))
                    html.Append($"<tr><td><a href=\"../{type.Address}\"><code>{Html.Escape(type.Name)}</code></a>" +
                        $"<td>{Html.Escape(ApiComment.Sentence(pages.Summary(type)))}\n");
                html.Append("</tbody>\n</table>\n</div>\n");
            }
            return html.ToString();
        }

        static string GroupOf(ApiType type)
        {
            if (Derives(type.Symbol, "MonoBehaviour"))
                return Groups[0];
            if (Derives(type.Symbol, "ScriptableObject"))
                return Groups[1];
            return type.Symbol.TypeKind switch
            {
                TypeKind.Struct => Groups[3],
                TypeKind.Interface or TypeKind.Delegate => Groups[4],
                TypeKind.Enum => Groups[5],
                _ => Groups[2],
            };
        }

        static bool Derives(INamedTypeSymbol type, string name)
        {
            for (INamedTypeSymbol ancestor = type.BaseType; ancestor != null; ancestor = ancestor.BaseType)
                if (ancestor.Name == name)
                    return true;
            return false;
        }
    }
}
