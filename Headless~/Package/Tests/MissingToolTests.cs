using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Host.Output;
using Host.Report;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Programs that draw plots and films are told missing before the work, and nothing else is lost with them.</summary>
    public class MissingToolTests
    {
        string folder;

        [SetUp]
        public void CreateFolder() => folder = Directory.CreateTempSubdirectory("rill-tools-").FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        static readonly string[] Written = { "index.html", "statistics.csv", "statistics.md" };
        static readonly string[] Plots = { "step-time.png", "density-error.png", "volume.png", "energy.png", "speed.png" };
        static readonly string[] Films = { "contact.png", "stills.png", "video.mp4" };

        /// <summary>In a process of its own, as a user would.</summary>
        /// <param name="said">Lines of both streams, in their order.</param>
        static int Rill(string[] arguments, out string[] said)
        {
            string host = Path.Combine(Path.GetDirectoryName(typeof(Session).Assembly.Location), "Host.dll");
            using var process = Process.Start(new ProcessStartInfo("sh",
                new[] { "-c", "exec dotnet \"$0\" \"$@\" 2>&1", host }.Concat(arguments)) { RedirectStandardOutput = true });
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            TestContext.WriteLine(output);
            said = output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
            return process.ExitCode;
        }

        int Play(out string[] said, params string[] more) =>
            Rill(new[] { "run", "Still Pool", "--frames", "2", "--every", "1", "--size", "64x36", "--stills", "0", "--out",
            folder }.Concat(more).ToArray(), out said);

        static void Begins(string[] said, string warning)
        {
            Assert.That(said[0], Is.EqualTo(warning));
            Assert.That(said.Skip(1).Where(IsComplaint), Is.Empty);
        }

        static bool IsComplaint(string line) => line.StartsWith("warning:", StringComparison.Ordinal)
            || line.StartsWith("rill:", StringComparison.Ordinal);

        /// <summary>Checks the files in the folder beside the frames, and that the pages show no picture but these.</summary>
        void Holds(IEnumerable<string> expected)
        {
            string[] files = Directory.GetFiles(folder).Select(Path.GetFileName).ToArray();
            Assert.That(files, Is.EquivalentTo(expected));
            Assert.That(files.Select(file => new FileInfo(Path.Combine(folder, file)).Length), Is.All.GreaterThan(0));
            string pages = File.ReadAllText(Path.Combine(folder, "index.html")) + File.ReadAllText(Path.Combine(folder, "statistics.md"));
            foreach (string picture in Plots.Append("contact.png").Append("video.mp4"))
                Assert.That(pages.Contains(picture), Is.EqualTo(files.Contains(picture)), picture);
        }

        [Test]
        public void Without_gnuplot_a_run_makes_all_but_the_plots_and_says_so_once()
        {
            using var path = ToolPath.Without("gnuplot");
            Assert.That(Play(out string[] said), Is.EqualTo(0));
            Begins(said, "warning: gnuplot is not installed (Debian package gnuplot-nox): no plots");
            Holds(Written.Concat(Films));
        }

        [Test]
        public void Without_ffmpeg_a_run_makes_all_but_what_it_puts_together_and_says_so_once()
        {
            using var path = ToolPath.Without("ffmpeg");
            Assert.That(Play(out string[] said), Is.EqualTo(0));
            Begins(said, "warning: ffmpeg is not installed (Debian package ffmpeg): no contact sheet, stills, film");
            Holds(Written.Concat(Plots));
            Assert.That(Directory.GetFiles(Path.Combine(folder, "frames")).Length, Is.EqualTo(3));
        }

        [Test]
        public void Without_either_one_warning_names_both()
        {
            using var path = ToolPath.Without("gnuplot", "ffmpeg");
            Assert.That(Play(out string[] said, "--no-video"), Is.EqualTo(0));
            Begins(said, "warning: gnuplot is not installed (Debian package gnuplot-nox): no plots; ffmpeg is not installed (Debian " +
                "package ffmpeg): no contact sheet, stills");
            Holds(Written);
        }

        [Test]
        public void A_tool_that_fails_is_told_after_the_rest_was_written()
        {
            using var path = ToolPath.WithFailing("gnuplot");
            Assert.That(Play(out string[] said), Is.EqualTo(2));
            Assert.That(said.Where(IsComplaint), Is.EqualTo(new[] { "rill: gnuplot failed with exit code 3: out of paper" }));
            Holds(Written.Concat(Films));
        }

        [Test]
        public void Without_gnuplot_a_bake_writes_its_asset_and_no_slices()
        {
            string mesh = Path.Combine(folder, "Box.obj");
            File.WriteAllText(mesh, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 4 3 2\nf 5 6 7 8\nf 1 " +
                "2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n");
            using var path = ToolPath.Without("gnuplot");
            Assert.That(Rill(new[] { "bake", mesh, "--resolution", "8", "--out", folder }, out string[] said), Is.EqualTo(0));
            Begins(said, "warning: gnuplot is not installed (Debian package gnuplot-nox): no picture of the slices");
            Assert.That(Directory.GetFiles(folder).Select(Path.GetFileName), Is.EquivalentTo(new[] { "Box.obj", "Box.asset", "Box.asset.meta" }));
        }

        [Test]
        public void Without_gnuplot_a_report_measures_and_leaves_the_page_for_later_or_refuses_at_once()
        {
            TextWriter console = Console.Error;
            var errors = new StringWriter();
            using (var path = ToolPath.Without("gnuplot"))
            {
                Console.SetError(errors);
                try
                {
                    Assert.That(ReportCommand.CanWrite(measure: true), Is.False);
                }
                finally
                {
                    Console.SetError(console);
                }
                Assert.That(Rill(new[] { "report", "--write-only", "--out", folder }, out string[] refused), Is.EqualTo(2));
                Assert.That(refused, Is.EqualTo(new[] {
                    "rill: gnuplot is not installed (Debian package gnuplot-nox), and the report's page consists of plots." }));
            }
            Assert.That(errors.ToString(), Does.StartWith(
                "warning: gnuplot is not installed (Debian package gnuplot-nox): no plots and no page").And.Contain(
                "rill report --write-only"));
            Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
            Assert.That(ReportCommand.CanWrite(measure: false), "with it");
        }
    }
}
