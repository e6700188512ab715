using System;
using System.IO;
using UnityEngine;

namespace Rill
{
    /// <summary>The page of the manual that the question mark of a component or an asset opens. The manual comes with the package, so that
    /// it is that of the version in use.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    sealed class ManualPageAttribute : HelpURLAttribute
    {
        /// <param name="page">A file in <see cref="PackagePaths.Manual"/>.</param>
        public ManualPageAttribute(string page) : base(AddressOf(PackagePaths.Manual + page)) => Page = page;

        public string Page { get; }

        // The editor finds a package's files by Path.GetFullPath, wherever its source is.
        static string AddressOf(string file) => new Uri(Path.GetFullPath(file)).AbsoluteUri;
    }
}
