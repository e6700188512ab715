using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The table of the page about performance is that of its figures.</summary>
    public sealed class PerformancePageTests
    {
        const string Page = "Research~/performance.md", Figures = "Research~/data/field-costs.csv";
        const string Start = "<!-- fields: written by rill generate -->", End = "<!-- end of fields -->";
        const string Csv = "# A card (driver 1); a dam\nparticles,field,median_ms,p10_ms,p90_ms,steps,bytes\n" +
            "1000000,Defaults,1.27306,1.24637,1.31683,100,378\n1000000,Deep Water off,34.9453,6.69162,115.201,100,372\n" +
            "100000,Defaults,0.281824,0.27,0.29,100,379\n100000,Vorticity 0.1,0.275,0.27,0.28,100,410\n";

        SyntheticPackage package;

        [SetUp]
        public void Make() => package = new SyntheticPackage().Add(Figures, Csv).Add(Page, $"# Before\n\n{Start}\n{End}\n\nAfter\n");

        [TearDown]
        public void Remove() => package.Dispose();

        string[] Faults() => new GeneratedFilesRule(new GeneratedFiles[] { new PerformancePage() }).Examine(package.Tree).Faults.ToArray();

        string Text() => new PerformancePage().Text(package.Tree, new Findings());

        [Test]
        public void The_table_has_each_field_for_each_number_of_particles_the_smaller_first()
        {
            string[] lines = Text().Split('\n');
            Assert.That(lines.Take(3), Is.EqualTo(new[] { "# Before", "", Start }));
            Assert.That(lines[4], Does.StartWith("A card (driver 1); a dam: ").And.Contain("rill bench fields --page"));
            Assert.That(lines.Where(line => line.StartsWith("|")), Is.EqualTo(new[]
            {
                "| | 100,000 particles | more | 1,000,000 particles | more | bytes a particle |",
                "| --- | --- | --- | --- | --- | --- |",
                "| Defaults | 0.282 (0.27 to 0.29) | 0 | 1.27 (1.25 to 1.32) | 0 | 378, 379 |",
                "| Deep Water off | – | – | 34.9 (6.69 to 115) | +33.672 | 372 |",
                "| Vorticity 0.1 | 0.275 (0.27 to 0.28) | -0.007 | – | – | 410 |",
            }));
            Assert.That(lines.TakeLast(4), Is.EqualTo(new[] { End, "", "After", "" }));
        }

        [Test]
        public void What_was_just_written_is_up_to_date()
        {
            package.Add(Page, Text());
            Assert.That(Faults(), Is.Empty);
            Assert.That(Text(), Is.EqualTo(package.Tree.Read(Page)));
        }

        [Test]
        public void The_page_of_the_repository_has_the_figures_that_are_stored()
        {
            Findings found = new GeneratedFilesRule(new GeneratedFiles[] { new PerformancePage() }).Examine(new PackageTree(Session.Root()));
            Assert.That(found.Faults, Is.Empty, "`Headless~/rill bench fields --write-only` writes it");
            Assert.That(found.Looked, Is.EqualTo("1 files"));
        }

        [TestCase("34.9453", "35.9453", "Deep Water off")]
        [TestCase("driver 1", "driver 2", "A card")]
        [TestCase(",410", ",411", "Vorticity")]
        public void A_figure_that_has_changed_since_is_a_fault_at_the_line_that_differs(string stored, string changed, string of)
        {
            string page = Text();
            package.Add(Page, page).Add(Figures, Csv.Replace(stored, changed));
            int line = page.Split('\n').TakeWhile(row => !row.Contains(of)).Count() + 1;
            Assert.That(Faults(), Is.EqualTo(new[] { $"{Page}({line}) is not what its sources say: run `Headless~/rill generate`." }));
        }

        [TestCase("0.282 (", "0.281 (")]
        [TestCase("| Vorticity", "| Smoothing")]
        public void A_page_that_was_edited_by_hand_is_a_fault(string written, string edited)
        {
            string page = Text();
            package.Add(Page, page.Replace(written, edited));
            Assert.That(Faults().Single(), Does.StartWith(Page + "("));
        }

        [TestCase(Start)]
        [TestCase(End)]
        public void A_page_without_its_marks_is_a_fault(string mark)
        {
            package.Add(Page, package.Tree.Read(Page).Replace(mark, ""));
            Assert.That(Faults().Single(), Does.StartWith(Page + " has lost the marks of its table of fields"));
        }

        [TestCase("100000,Defaults,0.281824,0.27,0.29,100,379\n", "")]
        [TestCase("# A card (driver 1); a dam\n", "")]
        [TestCase("particles,field,", "particles,name,")]
        [TestCase(",100,372", ",372")]
        public void Figures_that_are_no_table_are_a_fault(string stored, string changed)
        {
            package.Add(Figures, Csv.Replace(stored, changed));
            Assert.That(Faults().Single(), Does.StartWith(Figures + " is not a line '# device; settings'"));
        }
    }
}
