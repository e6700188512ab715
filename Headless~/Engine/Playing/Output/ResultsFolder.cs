using System.IO;

namespace Host.Output
{
    /// <summary>
    /// Folder of results without a given folder: below out~ in the current one. That may be a package's root or a project's Assets,
    /// and only names that end in ~ are hidden from Unity.
    /// </summary>
    static class ResultsFolder
    {
        public const string Root = "out~";

        /// <param name="given">What the user asked for; null for out~/name.</param>
        /// <returns>Full path; the folder need not be there.</returns>
        public static string Of(string given, string name) => Path.GetFullPath(given ?? Path.Combine(Root, name));
    }
}
