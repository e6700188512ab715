using System.Linq;
using Microsoft.CodeAnalysis;

namespace Host.Manual
{
    /// <summary>Page and section that the question mark of a component or an asset opens, from its <c>[ManualPage]</c>.</summary>
    /// <param name="Page">Name of a page of the manual.</param>
    /// <param name="Section">Anchor of a heading on it.</param>
    /// <param name="Title">Name in the menu of components; null for an asset.</param>
    sealed record HelpTopic(ApiType Type, string Page, string Section, string Title)
    {
        public string Address => $"{Page}.html#{Section}";

        /// <summary>A page of its own that leads there. Where a system opens the address of a file, what stands behind '#' may be lost.</summary>
        public string Redirect => $"help/{Page}.{Section}.html";

        /// <summary>Section with the fields; null for an asset.</summary>
        public string Fields => Title == null ? null : $"reference.html#{Anchor.Of(Title)}";

        /// <summary>Null for a type without the attribute.</summary>
        public static HelpTopic Of(ApiType type)
        {
            object[] page = Arguments(type.Symbol, "ManualPageAttribute"), menu = Arguments(type.Symbol, "AddComponentMenu");
            return page == null ? null : new HelpTopic(type, (string)page[0], (string)page[1], ((string)menu?[0])?.Split('/').Last());
        }

        static object[] Arguments(INamedTypeSymbol type, string attribute) => type.GetAttributes()
            .FirstOrDefault(data => data.AttributeClass?.Name == attribute)?.ConstructorArguments.Select(argument => argument.Value).ToArray();

        /// <summary>The page that leads on.</summary>
        public string RedirectHtml(string title) => $"<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>{Html.Escape(title)}</title>\n" +
            $"<meta http-equiv=\"refresh\" content=\"0; url=../{Address}\">\n<p><a href=\"../{Address}\">{Html.Escape(title)}</a></p>\n";
    }
}
