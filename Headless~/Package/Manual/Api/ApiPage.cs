using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using System.Xml.Linq;
using Microsoft.CodeAnalysis;

namespace Host.Manual
{
    /// <summary>The page of a type in the scripting reference.</summary>
    sealed class ApiPage
    {
        readonly ApiLibrary library;
        readonly ApiComment comments;
        readonly ApiSignature signatures;

        public ApiPage(ApiLibrary library) => (this.library, comments, signatures) = (library, new ApiComment(library), new ApiSignature(library));

        /// <param name="help">Null for a type without a section in the manual.</param>
        public string Body(ApiType type, HelpTopic help)
        {
            XElement comment = library.CommentOf(type.Symbol);
            var html = new StringBuilder($"<h1>{Html.Escape(type.Name)} <small>{type.Kind}</small></h1>\n");
            if (help != null)
                html.Append(SeeAlso(help));
            html.Append($"<div class=\"lead\">{comments.Of(comment?.Element("summary"))}</div>\n");
            html.Append($"<pre class=\"declaration\"><code>{signatures.Of(type.Symbol)}</code></pre>\n");
            html.Append($"<p class=\"where\">Namespace <code>{Html.Escape(type.Symbol.ContainingNamespace.ToDisplayString())}</code>, assembly " +
                $"<code>{Html.Escape(type.Symbol.ContainingAssembly.Name)}</code></p>\n");
            AppendParts(html, type.Symbol, comment);
            foreach (IGrouping<ApiGroup, ApiMember> group in type.Members.GroupBy(member => member.Group))
            {
                if (type.Symbol.TypeKind == TypeKind.Enum)
                    AppendValues(html, group);
                else
                {
                    html.Append($"<h2 id=\"{GroupAnchor(group.Key)}\">{group.Key}</h2>\n");
                    foreach (ApiMember member in group)
                        AppendMember(html, member);
                }
            }
            AppendInherited(html, type.Symbol);
            return html.ToString();
        }

        /// <summary>Headings of the page.</summary>
        public IEnumerable<PageHeading> Headings(ApiType type) => type.Symbol.TypeKind == TypeKind.Enum ? Enumerable.Empty<PageHeading>()
            : type.Members.GroupBy(member => member.Group).SelectMany(group => group.Select(member => new PageHeading(3, member.Anchor, member.Title))
                .Prepend(new PageHeading(2, GroupAnchor(group.Key), group.Key.ToString())));

        static string GroupAnchor(ApiGroup group) => "group-" + group.ToString().ToLowerInvariant();

        static string SeeAlso(HelpTopic help) => $"<p class=\"see\"><a href=\"../{help.Address}\">Guide</a>" +
            (help.Fields != null ? $" <a href=\"../{help.Fields}\">Fields in the inspector</a>" : "") + "</p>\n";

        void AppendMember(StringBuilder html, ApiMember member)
        {
            XElement comment = library.CommentOf(member.Symbol);
            html.Append($"<section id=\"{member.Anchor}\">\n<h3><a href=\"#{member.Anchor}\">{Html.Escape(member.Title)}</a></h3>\n");
            html.Append($"<pre class=\"declaration\"><code>{signatures.Of(member.Symbol)}</code></pre>\n");
            string summary = comments.Of(comment?.Element("summary")) + RangeOf(member.Symbol);
            if (summary.Length > 0)
                html.Append($"<p>{summary}</p>\n");
            AppendParts(html, member.Symbol, comment);
            html.Append("</section>\n");
        }

        // Parameters, result, exceptions and remarks.
        void AppendParts(StringBuilder html, ISymbol symbol, XElement comment)
        {
            if (comment == null)
                return;
            var rows = new List<(string name, string text)>();
            foreach (XElement parameter in comment.Elements().Where(element => element.Name.LocalName is "param" or "typeparam"))
                rows.Add(($"<code>{Html.Escape((string)parameter.Attribute("name"))}</code>", comments.Of(parameter)));
            foreach (string result in new[] { "returns", "value" })
                if (comment.Element(result) is XElement returned)
                    rows.Add(("Returns", comments.Of(returned)));
            foreach (XElement exception in comment.Elements("exception"))
                rows.Add(($"<code>{Html.Escape(((string)exception.Attribute("cref")).Split('.').Last())}</code>", comments.Of(exception)));
            if (rows.Count > 0)
            {
                html.Append("<dl>\n");
                foreach ((string name, string text) in rows)
                    html.Append($"<dt>{name}<dd>{text}\n");
                html.Append("</dl>\n");
            }
            foreach (XElement remarks in comment.Elements().Where(element => element.Name.LocalName is "remarks" or "example"))
                html.Append($"<div class=\"remarks\">{comments.Of(remarks)}</div>\n");
        }

        void AppendValues(StringBuilder html, IEnumerable<ApiMember> values)
        {
            html.Append("<div class=\"table\">\n<table>\n<thead><tr><th>Value<th>Number<th>Meaning</thead>\n<tbody>\n");
            foreach (ApiMember value in values)
                html.Append($"<tr id=\"{value.Anchor}\"><td><code>{value.Title}</code>" +
                    $"<td>{Convert.ToString(((IFieldSymbol)value.Symbol).ConstantValue, CultureInfo.InvariantCulture)}" +
                    $"<td>{comments.Of(library.CommentOf(value.Symbol)?.Element("summary"))}\n");
            html.Append("</tbody>\n</table>\n</div>\n");
        }

        // Those of Unity's own classes are in Unity's manual.
        void AppendInherited(StringBuilder html, INamedTypeSymbol type)
        {
            for (INamedTypeSymbol ancestor = type.BaseType; ancestor != null; ancestor = ancestor.BaseType)
            {
                ApiType known = library.Types.FirstOrDefault(t => SymbolEqualityComparer.Default.Equals(t.Symbol, ancestor.OriginalDefinition));
                if (known == null || known.Members.Count == 0)
                    continue;
                html.Append($"<p class=\"inherited\">From <a href=\"../{known.Address}\"><code>{Html.Escape(known.Name)}</code></a>: " +
                    string.Join(", ", known.Members.Select(member => $"<a href=\"../{known.Address}#{member.Anchor}\"><code>" +
                        $"{Html.Escape(member.Title)}</code></a>")) + "</p>\n");
            }
        }

        // Ranges of the inspector.
        static string RangeOf(ISymbol symbol)
        {
            foreach (AttributeData attribute in symbol.GetAttributes())
            {
                string[] limits = attribute.ConstructorArguments.Where(argument => argument.Value is float)
                    .Select(argument => ((float)argument.Value).ToString("0.#######", CultureInfo.InvariantCulture)).ToArray();
                if (attribute.AttributeClass?.Name == "RangeAttribute" && limits.Length == 2)
                    return $" <em>In the inspector {limits[0]} to {limits[1]}.</em>";
                if (attribute.AttributeClass?.Name == "MinAttribute" && limits.Length == 1)
                    return $" <em>In the inspector {limits[0]} or more.</em>";
            }
            return "";
        }

        /// <summary>Text that a search looks through: the summaries of the type and its members.</summary>
        public string SearchText(ApiType type) => string.Join(' ', type.Members
            .Select(member => $"{member.Title}: {ApiComment.Plain(library.CommentOf(member.Symbol)?.Element("summary"))}").Prepend(Summary(type)));

        /// <summary>Summary of a type in plain text.</summary>
        public string Summary(ApiType type) => ApiComment.Plain(library.CommentOf(type.Symbol)?.Element("summary"));
    }
}
