using System;
using System.Linq;

namespace Host.Check
{
    /// <summary>The page about the architecture, with the table of rooms between its marks.</summary>
    sealed class ArchitecturePage : GeneratedFile
    {
        const string Start = "<!-- rooms: written by rill generate -->\n", End = "<!-- end of rooms -->";

        public override string Path => "ARCHITECTURE.md";

        public override string Text(PackageTree package, Findings findings)
        {
            if (!package.Has(Path) || !package.WithExtension(".cs").Any(file => file.StartsWith("Runtime/", StringComparison.Ordinal)))
                return null;
            string page = package.Read(Path);
            int start = page.IndexOf(Start, StringComparison.Ordinal), end = page.IndexOf(End, StringComparison.Ordinal);
            if (start < 0 || end < start)
            {
                findings.Fault($"{Path} has lost the marks of its table of rooms: '{Start.Trim()}' and '{End}'. Put them back.");
                return null;
            }
            int before = findings.Faults.Count;
            Rooms rooms = RoomsRule.Compile(package, Rooms.OfRill, findings);
            return findings.Faults.Count > before ? null : page[..(start + Start.Length)] + "\n" + rooms.Matrix() + "\n" + page[end..];
        }
    }
}
