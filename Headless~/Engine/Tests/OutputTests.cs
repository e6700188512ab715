using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Host.Assets;
using Host.Commands;
using Host.Output;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    public class OutputTests
    {
        string folder;

        [SetUp]
        public void CreateFolder()
        {
            folder = Path.Combine(Path.GetTempPath(), "rill-output-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        [Test]
        public void A_csv_has_a_line_for_each_step_and_nothing_where_a_value_is_not_known()
        {
            var statistics = new Statistics(new[] { "time_s", "error" });
            statistics.Add(new[] { 0.5, double.NaN });
            statistics.Add(new[] { 1, 0.1 });
            string file = Path.Combine(folder, "s.csv");
            statistics.WriteCsv(file);
            Assert.That(File.ReadAllText(file), Is.EqualTo("time_s,error\n0.5,\n1,0.1\n"));
            Assert.That(statistics.Known("error"), Is.EqualTo(new[] { 0.1 }));
        }

        [Test]
        public void Results_go_where_the_user_says_or_where_Unity_does_not_look()
        {
            Assert.That(ResultsFolder.Of("a/b", "Scene"), Is.EqualTo(Path.GetFullPath("a/b")));
            Assert.That(ResultsFolder.Of(null, "Scene"), Is.EqualTo(Path.Combine(Directory.GetCurrentDirectory(), ResultsFolder.Root, "Scene")));
            Assert.That(ProjectIndex.IsHidden(ResultsFolder.Root), ResultsFolder.Root);
        }

        [Test]
        public void Two_columns_of_one_name_are_refused()
        {
            var error = Assert.Throws<ArgumentException>(() => new Statistics(new[] { "a", "b", "a" }));
            Assert.That(error.Message, Does.Contain("\"a\""));
        }

        [TestCase(0, 12, new int[0])]
        [TestCase(1, 12, new[] { 0 })]
        [TestCase(5, 3, new[] { 0, 2, 4 })]
        [TestCase(151, 4, new[] { 0, 50, 100, 150 })]
        public void A_contact_sheet_shows_the_first_and_the_last_frame(int count, int wanted, int[] expected)
            => Assert.That(Video.Spread(count, wanted), Is.EqualTo(expected));

        [Test]
        public void A_percentile_is_the_value_of_nearest_rank()
        {
            double[] values = Enumerable.Range(1, 1000).Select(i => (double)i).Reverse().ToArray();
            Assert.That(StatisticsPage.Percentile(values, 0.999), Is.EqualTo(999));
            Assert.That(StatisticsPage.Percentile(values, 0.5), Is.EqualTo(500));
            Assert.That(StatisticsPage.Percentile(new[] { 7.0 }, 0.999), Is.EqualTo(7));
        }

        [Test]
        public void Buffers_of_the_same_or_of_no_name_get_files_of_their_own()
        {
            Assert.That(BufferDump.FileNames(new[] { "Water.Sums", "a/b", "", "Water.Sums", "" }),
                Is.EqualTo(new[] { "Water.Sums.bin", "a_b.bin", "unnamed.bin", "Water.Sums-2.bin", "unnamed-2.bin" }));
        }

        [Test]
        public void A_dump_holds_each_buffers_bytes_and_shape()
        {
            using (var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 3, 8) { name = "OutputTests.Dumped" })
            {
                buffer.SetData(new[] { 1u, 2u, 3u, 4u, 5u, 0xFFFFFFFFu });
                BufferDump.Write(folder, 60);
            }
            using (JsonDocument json = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "60", "buffers.json"))))
            {
                JsonElement entry = json.RootElement.EnumerateArray().Single(e => e.GetProperty("name").GetString() == "OutputTests.Dumped");
                Assert.That(entry.GetProperty("count").GetInt32(), Is.EqualTo(3));
                Assert.That(entry.GetProperty("stride").GetInt32(), Is.EqualTo(8));
                Assert.That(entry.GetProperty("target").GetString(), Is.EqualTo("Structured"));
                byte[] bytes = File.ReadAllBytes(Path.Combine(folder, "60", entry.GetProperty("file").GetString()));
                Assert.That(bytes, Is.EqualTo(new[] { 1u, 2u, 3u, 4u, 5u, 0xFFFFFFFFu }.SelectMany(BitConverter.GetBytes)));
            }
        }

        [Test]
        public void A_hash_of_the_buffers_changes_with_one_byte()
        {
            using (var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1000, 4) { name = "OutputTests.Hashed" })
            {
                buffer.SetData(new uint[1000]);
                string before = BufferDump.Hash();
                Assert.That(BufferDump.Hash(), Is.EqualTo(before));
                buffer.SetData(new[] { 1u }, 0, 999, 1);
                Assert.That(BufferDump.Hash(), Is.Not.EqualTo(before));
            }
        }

        [Test]
        public void Plots_and_a_page_are_made_of_statistics()
        {
            var statistics = new Statistics(new[] { "time_s", "error", "never" });
            for (int i = 1; i <= 50; i++)
                statistics.Add(new[] { i / 50.0, Math.Exp(-i / 10.0), double.NaN });
            statistics.WriteCsv(Path.Combine(folder, "statistics.csv"));
            var plots = new[] { new Plot("error", "Error's decay", "error", "error", "never") { Logarithmic = true },
                new Plot("none", "Nothing", "none", "never") };
            foreach (Plot plot in plots)
                plot.Draw(folder, statistics, "time_s");
            new StatisticsPage { Title = "A <test>", Command = "rill run", Statistics = statistics, Plots = plots.ToList() }.Write(folder);

            foreach (Plot plot in plots)
                Assert.That(new FileInfo(Path.Combine(folder, plot.File + ".png")).Length, Is.GreaterThan(1000), plot.File);
            Assert.That(File.ReadAllText(Path.Combine(folder, "index.html")), Does.Contain("A &lt;test&gt;").And.Contain("error.png"));
            Assert.That(File.ReadAllText(Path.Combine(folder, "statistics.md")), Does.Contain("![Error's decay](error.png)"));
        }

        [TestCase("1280")]
        [TestCase("0x720")]
        [TestCase("axb")]
        [TestCase("1280x720x3")]
        public void A_size_that_is_none_is_refused_by_example(string text)
        {
            var error = Assert.Throws<HostException>(() => RunCommand.Size(text));
            Assert.That(error.Message, Does.Contain($"--size {text}").And.Contain("1280x720"));
        }

        [Test]
        public void A_frame_number_that_is_none_is_refused()
        {
            Assert.That(RunCommand.Frames("1,60"), Is.EqualTo(new[] { 1, 60 }));
            var error = Assert.Throws<HostException>(() => RunCommand.Frames("1,x"));
            Assert.That(error.Message, Does.Contain("\"x\""));
        }

        [Test]
        public void A_tool_that_fails_is_named_with_what_it_said()
        {
            var error = Assert.Throws<HostException>(() => Video.Encode(Path.Combine(folder, "no_%04d.png"), 30, Path.Combine(folder, "v.mp4")));
            Assert.That(error.Message, Does.Contain("ffmpeg failed").And.Contain("no_%04d.png"));
            error = Assert.Throws<HostException>(() => new Tool("no-such-program", "its-package").Run(Array.Empty<string>()));
            Assert.That(error.Message, Does.Contain("its-package"));
        }
    }
}
