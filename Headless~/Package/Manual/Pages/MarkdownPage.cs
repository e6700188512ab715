using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Markdig;
using Markdig.Extensions.Tables;
using Markdig.Renderers;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace Host.Manual
{
    /// <summary>A heading of a page.</summary>
    sealed record PageHeading(int Level, string Id, string Text);

    /// <summary>A heading with the text up to the next one.</summary>
    sealed record PageSection(PageHeading Heading, string Text);

    /// <summary>A page of the manual, from Markdown to HTML.</summary>
    sealed class MarkdownPage
    {
        static readonly MarkdownPipeline Pipeline = new MarkdownPipelineBuilder().UsePipeTables().UseEmphasisExtras().Build();

        readonly MarkdownDocument document;
        readonly Dictionary<HeadingBlock, PageHeading> headings = new();

        /// <summary>Name of the file without folder and extension.</summary>
        public readonly string Name;

        public string Address => Name + ".html";
        public string Title => headings.Values.FirstOrDefault(heading => heading.Level == 1)?.Text ?? Name;
        public IReadOnlyCollection<PageHeading> Headings => headings.Values;

        public MarkdownPage(string name, string markdown)
        {
            Name = name;
            document = Markdown.Parse(markdown.Replace("\r\n", "\n"), Pipeline);
            var taken = new Dictionary<string, int>();
            foreach (HeadingBlock heading in document.Descendants<HeadingBlock>())
            {
                string text = TextOf(heading), id = Anchor.Of(text);
                taken[id] = taken.TryGetValue(id, out int count) ? count + 1 : 0;
                headings.Add(heading, new PageHeading(heading.Level, taken[id] == 0 ? id : $"{id}-{taken[id]}", text));
            }
            foreach (LinkInline link in document.Descendants<LinkInline>())
                link.Url = ManualLinks.InHtml(link.Url ?? "");
        }

        /// <param name="link">Address of a name in code, or null.</param>
        /// <param name="below">HTML that follows a heading, or null.</param>
        public string Body(Func<string, string> link, Func<PageHeading, string> below)
        {
            var writer = new StringWriter { NewLine = "\n" };
            var renderer = new HtmlRenderer(writer);
            Pipeline.Setup(renderer);
            renderer.ObjectRenderers.Replace<Markdig.Renderers.Html.HeadingRenderer>(new HeadingHtml(headings, below));
            renderer.ObjectRenderers.Replace<Markdig.Renderers.Html.CodeBlockRenderer>(new CodeBlockHtml(link));
            renderer.ObjectRenderers.Replace<Markdig.Renderers.Html.Inlines.CodeInlineRenderer>(new CodeInlineHtml(link));
            renderer.ObjectRenderers.Replace<HtmlTableRenderer>(new TableHtml());
            renderer.Render(document);
            return writer.ToString();
        }

        /// <summary>Returns the texts of a search: the page by its headings, without blocks of code.</summary>
        public IEnumerable<PageSection> Sections()
        {
            PageHeading heading = null;
            var text = new StringBuilder();
            foreach (Block block in document)
            {
                if (block is HeadingBlock next)
                {
                    if (heading != null)
                        yield return new PageSection(heading, OneLine(text));
                    heading = headings[next];
                    text.Clear();
                }
                else
                    text.Append(TextOf(block)).Append(' ');
            }
            if (heading != null)
                yield return new PageSection(heading, OneLine(text));
        }

        static string OneLine(StringBuilder text) => string.Join(' ', text.ToString().Split((char[])null, StringSplitOptions.RemoveEmptyEntries));

        static string TextOf(Block block)
        {
            var text = new StringBuilder();
            if (block is LeafBlock { Inline: not null } leaf)
                foreach (Inline inline in leaf.Inline.Descendants())
                    text.Append(inline switch
                    {
                        LiteralInline literal => literal.Content.ToString(),
                        CodeInline code => code.Content,
                        HtmlEntityInline entity => entity.Transcoded.ToString(),
                        LineBreakInline => " ",
                        _ => ""
                    });
            else if (block is ContainerBlock container)
                foreach (Block child in container)
                    text.Append(TextOf(child)).Append(' ');
            return text.ToString();
        }
    }
}
