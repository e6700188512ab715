using System;
using System.IO;
using System.Linq;
using Host.Report;
using NUnit.Framework;

namespace Host.Tests
{
    public class ReportTableTests
    {
        string folder;

        [SetUp]
        public void NameFolder() => folder = Path.Combine(Path.GetTempPath(), "rill-table-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void RemoveFolder()
        {
            if (Directory.Exists(folder))
                Directory.Delete(folder, true);
        }

        [Test]
        public void A_table_comes_back_from_its_file()
        {
            var table = new ReportTable("scene", "n", "ms", "note") { MeasuredOn = "a device; 60 Hz" };
            table.Add("dam", 1_000_000, 1.25, null);
            table.Add("drop", 7, double.NaN, "x y");
            string file = Path.Combine(folder, "inner", "t.csv");
            table.Save(file);

            ReportTable loaded = ReportTable.Load(file);
            Assert.That(loaded.MeasuredOn, Is.EqualTo("a device; 60 Hz"));
            Assert.That(loaded.Columns, Is.EqualTo(table.Columns));
            ReportTable.Row[] rows = loaded.Rows.ToArray();
            Assert.That(rows.Length, Is.EqualTo(2));
            Assert.That(rows[0]["scene"], Is.EqualTo("dam"));
            Assert.That(rows[0].Number("n"), Is.EqualTo(1_000_000));
            Assert.That(rows[0].Number("ms"), Is.EqualTo(1.25));
            Assert.That(rows[1].Number("ms"), Is.NaN);
            Assert.That(rows[1]["note"], Is.EqualTo("x y"));
        }

        [Test]
        public void A_value_with_a_comma_is_refused()
        {
            var error = Assert.Throws<ArgumentException>(() => new ReportTable("a").Add("1,5"));
            Assert.That(error.Message, Does.Contain("\"1,5\""));
        }

        [Test]
        public void A_row_of_another_length_is_refused_with_the_columns()
        {
            var error = Assert.Throws<ArgumentException>(() => new ReportTable("a", "b").Add(1));
            Assert.That(error.Message, Does.Contain("a, b"));
        }

        [Test]
        public void A_column_that_is_not_there_is_refused_with_those_that_are()
        {
            var table = new ReportTable("a", "b");
            table.Add(1, 2);
            var error = Assert.Throws<ArgumentException>(() => table.Rows.First().Number("c"));
            Assert.That(error.Message, Does.Contain("\"c\"").And.Contain("a, b"));
        }

        [Test]
        public void A_file_that_is_not_there_is_named_with_what_makes_it()
        {
            var error = Assert.Throws<HostException>(() => ReportTable.Load(Path.Combine(folder, "none.csv")));
            Assert.That(error.Message, Does.Contain("none.csv").And.Contain("--write-only"));
        }

        [TestCase("", "no table")]
        [TestCase("# device\n", "no table")]
        [TestCase("a,b\n1,2\n3\n", "\"3\" has 1 values for 2 columns")]
        public void A_broken_file_is_named_with_what_is_wrong(string text, string expected)
        {
            Directory.CreateDirectory(folder);
            string file = Path.Combine(folder, "broken.csv");
            File.WriteAllText(file, text);
            var error = Assert.Throws<HostException>(() => ReportTable.Load(file));
            Assert.That(error.Message, Does.Contain("broken.csv").And.Contain(expected));
        }
    }
}
