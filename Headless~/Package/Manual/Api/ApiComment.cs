using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace Host.Manual
{
    /// <summary>Elements of the compiler's documentation as HTML and as plain text.</summary>
    sealed class ApiComment
    {
        static readonly Regex Page = new(@"Documentation~/(?<page>[\w-]+)\.md");
        static readonly Regex FirstSentence = new(@"^.*?[.!?](?=\s+[A-Z(]|\s*$)", RegexOptions.Singleline);

        readonly ApiLibrary library;

        public ApiComment(ApiLibrary library) => this.library = library;

        /// <summary>Content of an element; empty for null.</summary>
        public string Of(XElement element) => element == null ? "" : Content(element).Trim();

        public static string Plain(XElement element) => element == null ? "" : Regex.Replace(string.Concat(element.DescendantNodes().Select(node
            => node switch
        {
            XText text => text.Value,
            XElement { IsEmpty: true } reference => NameOf(reference),
            _ => "",
        })), @"\s+", " ").Trim();

        /// <summary>The whole where it has no end of a sentence.</summary>
        public static string Sentence(string text) => FirstSentence.Match(text) is { Success: true } sentence ? sentence.Value : text;

        string Content(XElement element) => string.Concat(element.Nodes().Select(node => node switch
        {
            XText text => Text(text.Value),
            XElement child => Element(child),
            _ => "",
        }));

        static string Text(string text) => Page.Replace(Html.Escape(Regex.Replace(text, @"\s+", " ")),
            match => $"<a href=\"../{match.Groups["page"].Value}.html\">{match.Groups["page"].Value}.md</a>");

        string Element(XElement element)
        {
            switch (element.Name.LocalName)
            {
                case "see" or "seealso":
                    return See(element);
                case "paramref" or "typeparamref":
                    return $"<code>{Html.Escape(NameOf(element))}</code>";
                case "c":
                    return $"<code>{Html.Escape(element.Value)}</code>";
                case "code":
                    return $"<pre><code>{CodeColors.Html(element.Value.Trim('\n', '\r'), "csharp", _ => null)}</code></pre>";
                case "para":
                    return $"<p>{Content(element).Trim()}</p>";
                case "list":
                    string tag = (string)element.Attribute("type") == "number" ? "ol" : "ul";
                    return $"<{tag}>{string.Concat(element.Elements("item").Select(item => $"<li>{Content(item).Trim()}</li>"))}</{tag}>";
                case "i" or "b" or "em" or "strong":
                    return $"<{element.Name.LocalName}>{Content(element)}</{element.Name.LocalName}>";
                default:
                    return Content(element);
            }
        }

        string See(XElement element)
        {
            if ((string)element.Attribute("href") is string web)
                return $"<a href=\"{Html.Escape(web)}\">{(element.IsEmpty ? Html.Escape(web) : Content(element))}</a>";
            string text = $"<code>{Html.Escape(element.Nodes().Any() ? element.Value : NameOf(element))}</code>";
            return (string)element.Attribute("cref") is string id && library.AddressOf(id) is string address
                ? $"<a href=\"../{address}\">{text}</a>" : text;
        }

        // A member of another type has the type's name before its own.
        static string NameOf(XElement element)
        {
            string id = (string)element.Attribute("cref");
            if (id == null)
                return (string)element.Attribute("langword") ?? (string)element.Attribute("name") ?? "";
            string[] path = Regex.Replace(id.Split(':').Last().Split('(')[0], @"`+\d+", "").Split('.');
            bool isMember = id[0] is 'M' or 'P' or 'F' or 'E' && path.Length > 1;
            string own = path[^1] == "#ctor" ? path[^2] : path[^1];
            string declaring = isMember ? string.Join('.', path.SkipLast(1)) : null;
            bool sameType = declaring != null && (string)element.Ancestors("member").FirstOrDefault()?.Attribute("name") is string member
                && (member.Substring(2) == declaring || member.Substring(2).StartsWith(declaring + ".", System.StringComparison.Ordinal));
            return isMember && !sameType && path[^1] != "#ctor" ? $"{path[^2]}.{own}" : own;
        }
    }
}
