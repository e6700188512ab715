using System;
using System.Collections.Generic;
using Markdig.Extensions.Tables;
using Markdig.Renderers;
using Markdig.Renderers.Html;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace Host.Manual
{
    /// <summary>A heading that is a link to itself.</summary>
    sealed class HeadingHtml : HtmlObjectRenderer<HeadingBlock>
    {
        readonly IReadOnlyDictionary<HeadingBlock, PageHeading> headings;
        readonly Func<PageHeading, string> below;

        public HeadingHtml(IReadOnlyDictionary<HeadingBlock, PageHeading> headings, Func<PageHeading, string> below)
            => (this.headings, this.below) = (headings, below);

        protected override void Write(HtmlRenderer renderer, HeadingBlock block)
        {
            PageHeading heading = headings[block];
            bool isTitle = heading.Level == 1;
            renderer.Write($"<h{heading.Level} id=\"{heading.Id}\">");
            if (!isTitle)
                renderer.Write($"<a href=\"#{heading.Id}\">");
            renderer.WriteLeafInline(block);
            renderer.Write(isTitle ? "" : "</a>").WriteLine($"</h{heading.Level}>");
            if (below(heading) is string html)
                renderer.WriteLine(html);
        }
    }

    /// <summary>A block of code in colors.</summary>
    sealed class CodeBlockHtml : HtmlObjectRenderer<CodeBlock>
    {
        readonly Func<string, string> link;

        public CodeBlockHtml(Func<string, string> link) => this.link = link;

        protected override void Write(HtmlRenderer renderer, CodeBlock block)
        {
            string language = (block as FencedCodeBlock)?.Info ?? "";
            string code = block.Lines.ToString().Replace("\r\n", "\n");
            renderer.EnsureLine();
            renderer.WriteLine($"<pre><code>{CodeColors.Html(code, language.ToLowerInvariant(), link)}</code></pre>");
        }
    }

    /// <summary>Code within a sentence: the name of a type or member leads to its page.</summary>
    sealed class CodeInlineHtml : HtmlObjectRenderer<CodeInline>
    {
        readonly Func<string, string> link;

        public CodeInlineHtml(Func<string, string> link) => this.link = link;

        protected override void Write(HtmlRenderer renderer, CodeInline inline)
        {
            string code = $"<code>{Html.Escape(inline.Content)}</code>";
            bool inLink = false;
            for (Inline parent = inline.Parent; parent != null; parent = parent.Parent)
                inLink |= parent is LinkInline || parent.ParentBlock() is HeadingBlock;
            renderer.Write(!inLink && link(inline.Content) is string address ? $"<a href=\"{address}\">{code}</a>" : code);
        }
    }

    /// <summary>A table that scrolls by itself where it is wider than the page.</summary>
    sealed class TableHtml : HtmlTableRenderer
    {
        protected override void Write(HtmlRenderer renderer, Table table)
        {
            renderer.EnsureLine();
            renderer.WriteLine("<div class=\"table\">");
            base.Write(renderer, table);
            renderer.WriteLine("</div>");
        }
    }

    static class Inlines
    {
        /// <summary>Block whose outermost inline this is; null within others.</summary>
        public static LeafBlock ParentBlock(this Inline inline) => (inline as ContainerInline)?.ParentBlock;
    }
}
