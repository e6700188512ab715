using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Host.Experiments;
using Host.Manual;
using Host.Report;
using Host.Report.ErrorTime;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>From sections to a page with pictures and tables that its links reach.</summary>
    public class ReportTests : GraphicsFixture
    {
        string folder;

        [SetUp]
        public void CreateFolder()
        {
            folder = Path.Combine(Path.GetTempPath(), "rill-report-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        sealed class Line : ReportSection
        {
            readonly string name;
            readonly bool onlyByName;

            public Line(string name, bool onlyByName = false)
            {
                this.name = name;
                this.onlyByName = onlyByName;
            }

            public override string Name => name;
            public override string Title => "A line";
            public override bool OnlyByName => onlyByName;

            public override void Measure(ReportRun run)
            {
                var table = new ReportTable("x", "y");
                for (int x = 0; x < 5; x++)
                    table.Add(x, x * x);
                run.Save(name, table, "by hand");
            }

            public override void Write(ReportPage page)
            {
                page.Line($"The last is {page.Load(name).Rows.Last()["y"]}.");
                page.Plot(name, "A parabola", $"plot '{page.DataFile(name)}' using 1:2 every ::1 with lines ls 1 notitle\n");
            }
        }

        static readonly ReportSection[] Three = { new Line("first"), new Line("second"), new Line("long", onlyByName: true) };

        void Measure(ReportSection section, bool quick = false, string device = "a device") =>
            ReportCommand.Measure(section, new ReportRun(Path.Combine(folder, "data"), quick, device, TextWriter.Null));

        static void Links_lead_somewhere(string page)
        {
            string[] targets = Regex.Matches(File.ReadAllText(page), @"\]\(([^)]+)\)").Select(match => match.Groups[1].Value).ToArray();
            Assert.That(targets, Is.Not.Empty);
            string[] anchors = File.ReadLines(page).Where(line => line.StartsWith('#'))
                .Select(line => "#" + Anchor.Of(line.TrimStart('#', ' '))).ToArray();
            foreach (string target in targets)
                if (target.StartsWith('#'))
                    Assert.That(anchors, Does.Contain(target));
                else
                    Assert.That(new FileInfo(Path.Combine(Path.GetDirectoryName(page), target)).Exists, target);
        }

        [Test]
        public void The_page_says_what_was_run_on_what_and_its_links_lead_somewhere()
        {
            Measure(Three[0]);
            ReportFolders folders = ReportFolders.Of(folder, null);
            ReportWriter.Write(new[] { Three[0] }, folders);
            string text = File.ReadAllText(folders.Page);
            Assert.That(text, Does.StartWith("# Report\n").And.Contain("a device").And.Contain("`rill report first`").And.Contain("The last is 16."));
            Assert.That(text, Does.Contain("| commit |").And.Contain($"| {SourceCommit.Describe()} |"));
            Assert.That(text, Does.Not.Contain("quick run").IgnoreCase);
            Links_lead_somewhere(folders.Page);
        }

        [Test]
        public void A_page_elsewhere_has_its_pictures_and_tables_beside_it()
        {
            Measure(Three[0]);
            ReportFolders folders = ReportFolders.Of(folder, Path.Combine(folder, "pages", "report.md"));
            ReportWriter.Write(new[] { Three[0] }, folders);
            Assert.That(File.Exists(Path.Combine(folder, "pages", "images", "report", "first.png")));
            Assert.That(File.ReadAllText(Path.Combine(folder, "pages", "data", "first.csv")),
                Is.EqualTo(File.ReadAllText(Path.Combine(folder, "data", "first.csv"))));
            Links_lead_somewhere(folders.Page);
        }

        [Test]
        public void A_page_can_be_written_again_from_what_lies_beside_it()
        {
            foreach (ReportSection section in Three.Take(2))
                Measure(section);
            string pages = Path.Combine(folder, "pages"), page = Path.Combine(pages, "report.md");
            ReportWriter.Write(Three.Take(2).ToArray(), ReportFolders.Of(folder, page));
            string first = File.ReadAllText(page);
            Directory.Delete(Path.Combine(folder, "data"), true);
            ReportWriter.Write(Three.Take(2).ToArray(), ReportFolders.Of(pages, page));
            Assert.That(File.ReadAllText(page), Is.EqualTo(first));
        }

        [Test]
        public void A_quick_run_says_so_first()
        {
            Measure(Three[0], quick: true, device: "a processor (in software)");
            Measure(Three[1]);
            ReportFolders folders = ReportFolders.Of(folder, null);
            ReportWriter.Write(Three.Take(2).ToArray(), folders);
            string first = File.ReadLines(folders.Page).Skip(1).First(line => line.Length > 0);
            Assert.That(first, Does.StartWith("**A quick run on a CPU** (first)"));
        }

        [Test]
        public void What_was_not_measured_is_named_with_the_command_that_does()
        {
            Measure(Three[0]);
            var error = Assert.Throws<HostException>(() => ReportWriter.Write(Three.Take(2).ToArray(), ReportFolders.Of(folder, null)));
            Assert.That(error.Message, Does.StartWith("second:").And.Contain("\"rill report second\""));
        }

        [Test]
        public void Sections_are_chosen_by_name_or_all_but_the_long_ones_or_those_measured()
        {
            string data = Path.Combine(folder, "data");
            string[] Chosen(bool measure, params string[] names)
                => ReportCommand.Chosen(Three, names, measure, data).Select(section => section.Name).ToArray();
            Assert.That(Chosen(true), Is.EqualTo(new[] { "first", "second" }));
            Assert.That(Chosen(true, "long"), Is.EqualTo(new[] { "long" }));
            Assert.That(Assert.Throws<HostException>(() => Chosen(true, "third")).Message,
                Does.Contain("\"third\"").And.Contain("first, second, long"));
            Assert.That(Assert.Throws<HostException>(() => Chosen(false)).Message, Does.Contain(data).And.Contain("--write-only"));
            Measure(Three[2]);
            Assert.That(Chosen(false), Is.EqualTo(new[] { "long" }));
        }

        [Test]
        public void Rows_that_are_left_to_the_csv_are_counted_and_those_that_fail_are_shown()
        {
            var page = new ReportPage(folder, folder, "images");
            page.Table(new[] { "x", "figure", "bar" }, new[] { "yes", "yes", "**no**", "yes" }.Select((verdict, i) => new[] { $"row {i}",
                "1 %", verdict }),
                i => i == 0);
            Assert.That(page.ToString(), Does.Contain("row 0").And.Contain("row 2").And.Contain("2 of 4 rows are in the table below only"));
            Assert.That(page.ToString(), Does.Not.Contain("row 1").And.Not.Contain("row 3"));
            Assert.That(page.Failures.Rows.Single()[3], Is.EqualTo("1 of 4"));
        }

        [Test]
        public void The_report_of_the_repository_is_short()
        {
            string page = File.ReadAllText(Path.Combine(Session.Root(), "Research~", "report.md"));
            // Words, not the bars between the cells of its tables.
            Assert.That(page.Split(' ', '\n', '|').Count(word => word.Any(char.IsLetterOrDigit)), Is.InRange(1_000, 9_000));
        }

        [Test]
        public void A_plot_is_drawn_of_series_that_have_points_and_says_so_where_none_has()
        {
            var page = new ReportPage(folder, folder, "images");
            var values = new[] { 0.02, 5 };
            page.Plot("some", "Two points", new PlotData().Add("using 1:2 with points title 'none'", new object[0][])
                .Add("using 1:2 with lines title 'it''s'", values.Select(v => new object[] { v, v }))
                .Script(LogAxis.Script("x", values) + LogAxis.Script("y", values)));
            page.Plot("none", "Nothing", new PlotData().Script(LogAxis.Script("x", new double[0])));
            foreach (string name in new[] { "some", "none" })
                Assert.That(new FileInfo(Path.Combine(folder, name + ".png")).Length, Is.GreaterThan(1000), name);
        }

        [Test]
        public void A_logarithmic_axis_is_labeled_between_its_ends()
        {
            Assert.That(LogAxis.Script("y", new[] { 0.3, 4, 0, double.NaN }), Does.Contain("set ytics (0.5, 1, 2, 5)").And.Contain("set logscale y"));
            Assert.That(LogAxis.Script("x", new[] { 1e-6, 10 }), Does.Contain("(1E-06, 1E-05, 0.0001, 0.001, 0.01, 0.1, 1, 10)"));
        }

        [Test]
        public void A_small_sweep_ends_in_a_page_with_pictures_and_a_front()
        {
            var plan = new ErrorTimePlan(ExperimentScene.Tank(3, 6, 0.05f), 0.6, new SweepSetting[] { new(false, 1, 2), new(true, 1, 1) });
            var section = new ErrorTimeSection(new ErrorTimePlan[0], new[] { plan });
            Measure(section, quick: true, device: "any (in software)");

            ReportTable sweep = ReportTable.Load(Path.Combine(folder, "data", "error-time.csv")),
                front = ReportTable.Load(Path.Combine(folder, "data", "front.csv"));
            Assert.That(sweep.Rows.Select(row => row["deep"]), Is.EqualTo(new[] { "off", "on" }));
            foreach (ReportTable.Row row in sweep.Rows)
            {
                Assert.That(row.Number("particles"), Is.EqualTo(108));
                Assert.That(row.Number("ms_moving"), Is.GreaterThan(0));
                Assert.That(row.Number("error_settled"), Is.GreaterThan(0).And.LessThan(0.2));
            }
            Assert.That(front.Rows.Count(), Is.InRange(1, 2));
            Assert.That(front.Rows.Select(row => row.Number("ms")), Is.Ordered);

            ReportFolders folders = ReportFolders.Of(folder, null);
            ReportWriter.Write(new[] { section }, folders);
            Links_lead_somewhere(folders.Page);
            Assert.That(new FileInfo(Path.Combine(folder, "images", "error-time-tank-108.png")).Length, Is.GreaterThan(5000));
            Assert.That(File.ReadAllText(folders.Page), Does.Contain("Tank, 108 particles, 3 layers").And.Contain("Times are of a CPU"));
        }
    }
}
