using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using Host.Manual;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The manual as HTML is complete, has no dead links, and is the same whoever builds it.</summary>
    public sealed class HtmlManualTests
    {
        const int MaxBytes = 2000000;
        const BindingFlags Declared = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

        IReadOnlyDictionary<string, string> files;

        static string Pages => Path.Combine(Session.Root(), "Documentation~");

        static string Folder => Path.Combine(Pages, "html");

        static IReadOnlyDictionary<string, string> Build(string root, List<string> faults)
            => ManualBuilder.Build(root, AppContext.BaseDirectory, faults.Add);

        [OneTimeSetUp]
        public void BuildOnce()
        {
            var faults = new List<string>();
            files = Build(Session.Root(), faults);
            Assert.That(faults, Is.Empty);
        }

        [Test]
        public void Each_page_of_the_manual_has_its_HTML_with_its_heading()
        {
            int pages = 0;
            foreach (string page in Directory.GetFiles(Pages, "*.md").Where(file => Path.GetFileName(file) != "TableOfContents.md"))
            {
                pages++;
                string heading = File.ReadLines(page).First(line => line.StartsWith("# ", StringComparison.Ordinal)).Substring(2).Trim();
                Assert.That(files[Path.GetFileNameWithoutExtension(page) + ".html"], Does.Contain(">" + heading + "</h1>"));
            }
            Assert.That(pages, Is.GreaterThanOrEqualTo(33));
        }

        [Test]
        public void The_table_of_contents_leads_to_each_page_from_each_page()
        {
            string[] pages = files.Keys.Where(file => file.EndsWith(".html", StringComparison.Ordinal) && !file.Contains("/")).ToArray();
            foreach (string page in pages)
                foreach (string other in pages)
                    Assert.That(files[page], Does.Contain("<li><a href=\"" + other + "\""), page);
        }

        [Test]
        public void Every_link_and_picture_leads_somewhere()
        {
            Assert.That(HtmlLinks.Dead(files, Folder, out int links), Is.Empty);
            Assert.That(links, Is.GreaterThan(5000));
        }

        [TestCase("<a href=\"b.html#two\">", 0)]
        [TestCase("<a href=\"b.html#three\">", 1)]
        [TestCase("<a href=\"c.html\">", 1)]
        [TestCase("<a href=\"#one\">", 0)]
        [TestCase("<a href=\"#two\">", 1)]
        [TestCase("<img src=\"../images/none.png\">", 1)]
        [TestCase("<a href=\"../index.md\">", 0)]
        [TestCase("<meta http-equiv=\"refresh\" content=\"0; url=b.html#three\">", 1)]
        public void A_link_that_leads_nowhere_is_seen(string link, int dead)
        {
            var planted = new Dictionary<string, string> { ["a.html"] = "<h2 id=\"one\">" + link, ["b.html"] = "<h2 id=\"two\">" };
            Assert.That(HtmlLinks.Dead(planted, Folder, out int links), Has.Count.EqualTo(dead));
            Assert.That(links, Is.EqualTo(1));
        }

        [Test]
        public void No_page_has_an_anchor_twice()
        {
            foreach (KeyValuePair<string, string> file in files)
                Assert.That(Regex.Matches(file.Value, @"<[^>]*\sid=""([^""]+)""").Select(match => match.Groups[1].Value), Is.Unique, file.Key);
        }

        [Test]
        public void The_search_looks_through_each_page_and_each_type()
        {
            HashSet<string> found = Regex.Matches(files["search-documents.js"], "^\\[\"([^\"#]+)", RegexOptions.Multiline)
                .Select(match => match.Groups[1].Value).ToHashSet();
            Assert.That(files.Keys.Where(file => file.EndsWith(".html", StringComparison.Ordinal)
                && !file.StartsWith("help/", StringComparison.Ordinal) && file != "api/index.html" && !found.Contains(file)), Is.Empty);
        }

        [Test]
        public void Each_public_type_has_a_page_with_a_summary_and_each_of_its_members()
        {
            int types = 0, members = 0;
            foreach (Type type in ManualBuilder.Assemblies.SelectMany(name => Assembly.Load(name).GetExportedTypes()))
            {
                types++;
                string name = type.IsNested ? type.DeclaringType.Name + "." + type.Name : type.Name;
                Assert.That(files.TryGetValue("api/" + name + ".html", out string page), name);
                Assert.That(page, Does.Match("<div class=\"lead\">.{10,}</div>"), name);
                Assert.That(files["api/index.html"], Does.Match("<code>" + Regex.Escape(name) + "</code></a><td>.{10,}"), name);
                foreach (MemberInfo member in type.GetMembers(Declared).Where(IsWritten))
                {
                    members++;
                    Assert.That(page, Does.Contain("id=\"" + member.Name + "\""), name);
                }
            }
            Assert.That(types, Is.GreaterThan(80));
            Assert.That(members, Is.GreaterThan(700));
        }

        static bool IsWritten(MemberInfo member) => member is PropertyInfo { Name: not "Item" } || member is EventInfo
            || member is FieldInfo { IsSpecialName: false } || member is MethodInfo { IsSpecialName: false } method
            && method.DeclaringType.BaseType != typeof(MulticastDelegate);

        [Test]
        public void Below_the_declaration_of_a_member_stands_what_it_is()
        {
            foreach (KeyValuePair<string, string> file in files.Where(file => file.Key.StartsWith("api/", StringComparison.Ordinal)))
                Assert.That(file.Value, Does.Not.Match("</code></pre>\n(?!<p|<dl)"), file.Key);
        }

        [Test]
        public void A_second_build_is_the_same_in_another_culture_and_says_nothing_of_the_machine()
        {
            var culture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            culture.NumberFormat.NumberDecimalSeparator = ",";
            culture.NumberFormat.NegativeSign = "~";
            CultureInfo before = CultureInfo.CurrentCulture;
            CultureInfo.CurrentCulture = culture;
            try
            {
                IReadOnlyDictionary<string, string> again = Build(Session.Root(), new List<string>());
                Assert.That(again.Keys, Is.EqualTo(files.Keys));
                foreach (KeyValuePair<string, string> file in files)
                    Assert.That(again[file.Key], Is.EqualTo(file.Value), file.Key);
            }
            finally
            {
                CultureInfo.CurrentCulture = before;
            }
            foreach (KeyValuePair<string, string> file in files)
                Assert.That(file.Value, Does.Not.Contain(Session.Root()).And.Not.Contain("\r"), file.Key);
        }

        [Test]
        public void It_is_small_enough_to_come_with_the_package()
            => Assert.That(files.Values.Sum(Encoding.UTF8.GetByteCount), Is.LessThan(MaxBytes));

        [Test]
        public void A_section_that_a_component_names_and_a_page_has_not_is_a_fault()
        {
            string root = Path.Combine(Path.GetTempPath(), "rill-manual-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Path.Combine(root, "Documentation~"));
            try
            {
                File.Copy(Path.Combine(Session.Root(), "package.json"), Path.Combine(root, "package.json"));
                foreach (string page in Directory.GetFiles(Pages, "*.md"))
                    File.WriteAllText(Path.Combine(root, "Documentation~", Path.GetFileName(page)),
                        File.ReadAllText(page).Replace("# Fluid Drain\n", "# Fluid Sink\n"));
                var faults = new List<string>();
                Build(root, faults);
                Assert.That(faults, Is.EqualTo(new[] { "FluidDrain has [ManualPage(\"sources\", \"fluid-drain\")], and Documentation~/sources.md " +
                    "has no heading of that name: write the heading, or name another." }));
            }
            finally
            {
                Directory.Delete(root, true);
            }
        }
    }
}
