using System.Linq;
using Host.Manual;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Markdown of the manual's kind as HTML.</summary>
    public sealed class HtmlPageTests
    {
        static string Body(string markdown)
            => new MarkdownPage("page", markdown).Body(name => name == "FluidEmitter" ? "api/FluidEmitter.html" : null, heading => null);

        [TestCase("colliders.md", "colliders.html")]
        [TestCase("colliders.md#terrain", "colliders.html#terrain")]
        [TestCase("#terrain", "#terrain")]
        [TestCase("TableOfContents.md", "index.html")]
        [TestCase("html/api/index.html", "api/index.html")]
        [TestCase("images/honey.png", "../images/honey.png")]
        [TestCase("../Research~/report.md#figures", "../../Research%7E/report.md#figures")]
        [TestCase("https://unity.com/a.md", "https://unity.com/a.md")]
        public void A_link_leads_where_it_led_on_the_page(string target, string expected)
            => Assert.That(Body("[a](" + target + ")"), Is.EqualTo("<p><a href=\"" + expected + "\">a</a></p>\n"));

        [Test]
        public void Headings_have_the_anchors_that_GitHub_gives_them()
        {
            var page = new MarkdownPage("page", "# A page\n\n## What it is, and what it is not\n\n" +
                "## `rill explain` (2)\n\n## Limits\n\n### Limits\n");
            Assert.That(page.Headings.Select(heading => heading.Id),
                Is.EqualTo(new[] { "a-page", "what-it-is-and-what-it-is-not", "rill-explain-2", "limits", "limits-1" }));
            Assert.That(page.Title, Is.EqualTo("A page"));
        }

        [Test]
        public void A_name_of_the_reference_is_a_link_but_not_within_one()
        {
            Assert.That(Body("`FluidEmitter` and `Other`, [`FluidEmitter`](a.md)"), Is.EqualTo("<p><a href=\"api/FluidEmitter.html\">" +
                "<code>FluidEmitter</code></a> and <code>Other</code>, <a href=\"a.html\"><code>FluidEmitter</code></a></p>\n"));
        }

        [Test]
        public void Code_has_colors_and_links_and_no_other_HTML()
        {
            Assert.That(Body("```csharp\nif (a < 1f) // <b>\n    FluidEmitter.Of(\"if\");\n```\n"),
                Is.EqualTo("<pre><code><span class=\"k\">if</span> (a &lt; <span class=\"n\">1f</span>) " +
                "<span class=\"c\">// &lt;b&gt;</span>\n    <a href=\"api/FluidEmitter.html\">FluidEmitter</a>" +
                ".Of(<span class=\"s\">&quot;if&quot;</span>);</code></pre>\n"));
            Assert.That(Body("```\nif (a) // b\n```\n"), Is.EqualTo("<pre><code>if (a) // b</code></pre>\n"));
        }

        [Test]
        public void A_section_is_searched_by_its_text_without_code_blocks()
        {
            const string Page = "# A\n\nOne *two* `three`.\n\n```csharp\nfour();\n```\n\n## B\n\n| x | y |\n| --- | --- |\n| 1 | 2 |\n";
            Assert.That(new MarkdownPage("page", Page).Sections().Select(section => section.Heading.Text + ": " + section.Text),
                Is.EqualTo(new[] { "A: One two three.", "B: x y 1 2" }));
        }

        [Test]
        public void Pages_of_the_contents_stand_in_groups()
        {
            var contents = new Contents("* [Home](index.md)\n* Start\n  * [A](a.md)\n  * [B](html/api/index.html)\n* [Alone](c.md)\n");
            Assert.That(contents.Groups.Select(group => group.Title + ": " + string.Join(" ", group.Entries.Select(entry => entry.Address))),
                Is.EqualTo(new[] { ": index.html", "Start: a.html api/index.html", ": c.html" }));
            Assert.That(contents.Entries.Select(entry => entry.Title), Is.EqualTo(new[] { "Home", "A", "B", "Alone" }));
        }
    }
}
