using System.Diagnostics;
using System.IO;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Work of the script <c>rill</c> itself, before anything is built.</summary>
    public class EntryPointTests
    {
        string folder;

        [SetUp]
        public void CreateFolder() => folder = Directory.CreateTempSubdirectory("rill-entry-").FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        [TestCase("--help")]
        [TestCase("-h")]
        [TestCase("-?")]
        public void Help_on_publishing_is_printed_and_nothing_made(string option)
        {
            Assert.That(Publish(out string output, option), Is.Zero);
            Assert.That(output, Does.Contain("rill publish <folder>").And.Contain("RILL_PUBLISHED"));
            Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
        }

        [TestCase("--release", "no option --release")]
        [TestCase("-o", "no option -o")]
        [TestCase("", "takes the folder")]
        public void What_is_no_folder_to_publish_into_is_named(string argument, string problem)
        {
            Assert.That(Publish(out string output, argument), Is.EqualTo(2));
            Assert.That(output, Does.Contain(problem));
            Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
        }

        int Publish(out string output, string argument)
        {
            string script = Path.Combine(PackageFolder.Path, "Headless~", "rill");
            using var process = Process.Start(new ProcessStartInfo("sh", new[] { "-c", "exec \"$0\" publish \"$1\" 2>&1", script, argument }) {
                WorkingDirectory = folder, RedirectStandardOutput = true });
            output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return process.ExitCode;
        }
    }
}
