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
        const string OfAnotherPage = ".md)";      // ends the name of a region that is not on scripting.md

        [Test]
        public void Each_snippet_of_the_manual_is_a_region_of_ManualSnippets_word_for_word()
        {
            List<(string title, string text)> blocks = Blocks(Read("Documentation~", "scripting.md"));
            Assert.That(blocks.Count, Is.GreaterThanOrEqualTo(33));
            Assert.That(blocks, Is.EquivalentTo(Compiled().Where(region => !region.title.EndsWith(OfAnotherPage))));
        }

        [Test]
        public void Every_block_of_CSharp_on_any_page_is_compiled_word_for_word()
        {
            HashSet<string> compiled = Compiled().Select(region => region.text).ToHashSet();
            var loose = new List<string>();
            int blocks = 0, pages = 0;
            foreach (string page in Pages())
            {
                pages++;
                foreach (string block in AllBlocks(File.ReadAllText(page)))
                {
                    blocks++;
                    if (!compiled.Contains(block))
                        loose.Add($"{Path.GetFileName(page)}:\n{block}");
                }
            }
            Assert.That(loose, Is.Empty, "no region of a ManualSnippets.cs");
            Assert.That(pages, Is.GreaterThanOrEqualTo(50));
            Assert.That(blocks, Is.GreaterThanOrEqualTo(39));
        }

        [TestCase("```csharp\na();\n```\n", "a();\n")]
        [TestCase("1. Do:\n\n   ```csharp\n   a();\n       b();\n   ```\n", "a();\n    b();\n")]
        [TestCase("```cs\na();\n```\n", "a();\n")]
        [TestCase("```C#\na();\n```\n", "a();\n")]
        [TestCase("```hlsl\na();\n```\n", null)]
        public void A_block_of_CSharp_is_found_in_whatever_way_it_is_written(string page, string text)
            => Assert.That(AllBlocks(page).SingleOrDefault(), Is.EqualTo(text));

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

        static string Read(params string[] path) => File.ReadAllText(Path.Combine(path.Prepend(Session.Root()).ToArray()));

        static IEnumerable<string> Pages()
        {
            string root = Session.Root();
            return Directory.GetFiles(Path.Combine(root, "Documentation~"), "*.md", SearchOption.AllDirectories)
                .Concat(Directory.GetFiles(root, "*.md")).Concat(Directory.GetFiles(Path.Combine(root, "Samples~"), "*.md",
                    SearchOption.AllDirectories));
        }

        static List<(string title, string text)> Compiled()
        {
            string[] files = Directory.GetFiles(Path.Combine(Session.Root(), "Tests"), "*ManualSnippets.cs", SearchOption.AllDirectories);
            Assert.That(files, Has.Length.GreaterThanOrEqualTo(3));
            return files.SelectMany(file => Regions(File.ReadAllText(file))).ToList();
        }

        // Also those in lists, moved to the left as far as their fence.
        static List<string> AllBlocks(string page)
        {
            return Regex.Matches(Lines(page), @"^(?<indent> *)```(?:csharp|cs|c#) *\n(?<text>(?:.*\n)*?) *```$", RegexOptions.Multiline
                | RegexOptions.IgnoreCase).Select(match => Regex.Replace(match.Groups["text"].Value, "^" + match.Groups["indent"].Value, "",
                RegexOptions.Multiline)).ToList();
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
