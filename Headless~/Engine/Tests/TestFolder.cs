using System;
using System.IO;
using System.Runtime.CompilerServices;

namespace Host.Tests
{
    /// <summary>This folder, with the files that tests read; a published copy of the tests may run where it lies elsewhere.</summary>
    static class TestFolder
    {
        public static string Path { get; } = Find();

        static string Find([CallerFilePath] string here = "")
        {
            string root = Environment.GetEnvironmentVariable("RILL_ROOT");
            return string.IsNullOrEmpty(root) ? System.IO.Path.GetDirectoryName(here) : System.IO.Path.Combine(root, "Headless~", "Engine", "Tests");
        }
    }
}
