using System;
using System.IO;
using System.Linq;

namespace Host.Tests
{
    /// <summary>The programs of the PATH but for some, for this process and those that it starts, until it is disposed of.</summary>
    sealed class ToolPath : IDisposable
    {
        readonly string before = Environment.GetEnvironmentVariable("PATH");
        readonly string folder = Directory.CreateTempSubdirectory("rill-path-").FullName;

        /// <param name="without">Names of programs.</param>
        public static ToolPath Without(params string[] without) => new ToolPath(without);

        /// <summary>A program that says something and fails instead of the one of that name.</summary>
        public static ToolPath WithFailing(string program)
        {
            var path = new ToolPath(new[] { program });
            string file = Path.Combine(path.folder, program);
            File.WriteAllText(file, "#!/bin/sh\necho out of paper >&2\nexit 3\n");
            File.SetUnixFileMode(file, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
            return path;
        }

        ToolPath(string[] without)
        {
            foreach (string program in before.Split(Path.PathSeparator).Where(Directory.Exists).SelectMany(Directory.EnumerateFiles))
            {
                string link = Path.Combine(folder, Path.GetFileName(program));
                if (!without.Contains(Path.GetFileName(program)) && !File.Exists(link))
                    File.CreateSymbolicLink(link, program);
            }
            Environment.SetEnvironmentVariable("PATH", folder);
        }

        public void Dispose()
        {
            Environment.SetEnvironmentVariable("PATH", before);
            Directory.Delete(folder, true);
        }
    }
}
