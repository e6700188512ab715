using System;
using System.IO;
using System.Runtime.CompilerServices;

namespace Host.Tests
{
    /// <summary>The package that the tests are of, and their own folder in it; a published copy of the tests may run where they lie
    /// elsewhere.</summary>
    static class PackageFolder
    {
        public static string Path { get; } = Find();

        public static string Tests => System.IO.Path.Combine(Path, "Headless~", "Package", "Tests");

        static string Find([CallerFilePath] string here = "")
        {
            string root = Environment.GetEnvironmentVariable("RILL_ROOT");
            return string.IsNullOrEmpty(root) ? System.IO.Path.GetFullPath(System.IO.Path.Combine(here, "..", "..", "..", "..")) : root;
        }
    }
}
