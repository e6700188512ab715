using System;
using System.IO;
using UnityEngine;

namespace Rill
{
    /// <summary>The section of the manual that the question mark of a component or an asset opens. The manual comes with the package, so that
    /// it is that of the version in use.</summary>
    /// <remarks>The address is that of a file which leads on to the section: Windows opens a file, and drops what follows a '#'.</remarks>
    [AttributeUsage(AttributeTargets.Class)]
    sealed class ManualPageAttribute : HelpURLAttribute
    {
        /// <param name="page">Name of a page in Documentation~, without its extension.</param>
        /// <param name="section">Its heading in lower case with hyphens, as behind the '#' of a link.</param>
        public ManualPageAttribute(string page, string section) : base(AddressOf(PackagePaths.Help + page + "." + section + ".html"))
            => (Page, Section) = (page, section);

        public string Page { get; }

        public string Section { get; }

        // The editor finds a package's files by Path.GetFullPath, wherever its source is.
        static string AddressOf(string file) => new Uri(Path.GetFullPath(file)).AbsoluteUri;
    }
}
