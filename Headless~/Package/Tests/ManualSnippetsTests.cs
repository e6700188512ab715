using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The snippets of the manual are regions of code that is compiled and run.</summary>
    public sealed class ManualSnippetsTests
    {
        [Test]
        public void Each_snippet_of_the_manual_is_a_region_of_ManualSnippets_word_for_word()
        {
            string code = File.ReadAllText(Path.Combine(Session.Root(), "Tests", "Runtime", "ManualSnippets.cs"));
            string page = File.ReadAllText(Path.Combine(Session.Root(), "Documentation~", "scripting.md"));
            Assert.That(Blocks(page).Count, Is.GreaterThanOrEqualTo(8));
            Assert.That(Blocks(page), Is.EqualTo(Regions(code)));
        }

        [TestCase("## One\n\ntext\n\n```csharp\na();\n    b();\n```\n", true)]
        [TestCase("## One\n\n```csharp\na();\n    c();\n```\n", false)]
        [TestCase("## Two\n\n```csharp\na();\n    b();\n```\n", false)]
        [TestCase("## One\n\ntext\n", false)]
        public void A_page_that_differs_from_the_code_is_seen(string page, bool same)
        {
            const string Code =
                "class A\n{\n    void F()\n    {\n        #region One\n        a();\n            b();\n        #endregion\n    }\n}\n";
            Assert.That(Blocks(page).SequenceEqual(Regions(Code)), Is.EqualTo(same));
        }

        // Heading above it and text of each code block, in order.
        static List<(string title, string text)> Blocks(string page)
        {
            return Regex.Matches(Lines(page), @"^## (?<title>.+)\n(?:(?!^## |^```)[^\n]*\n)*^```csharp\n(?<text>(?:.*\n)*?)```$",
                RegexOptions.Multiline)
                .Select(match => (match.Groups["title"].Value, match.Groups["text"].Value)).ToList();
        }

        // Name and text of each region, in order, moved to the left as far as the region's own line.
        static List<(string title, string text)> Regions(string code)
        {
            return Regex.Matches(Lines(code), @"^(?<indent> *)#region (?<title>.+)\n(?<text>(?:.*\n)*?) *#endregion$", RegexOptions.Multiline)
                .Select(match => (match.Groups["title"].Value,
                    Regex.Replace(match.Groups["text"].Value, "^" + match.Groups["indent"].Value, "", RegexOptions.Multiline))).ToList();
        }

        static string Lines(string text) => text.Replace("\r\n", "\n");
    }
}
