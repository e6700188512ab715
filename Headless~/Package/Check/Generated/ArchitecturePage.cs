using System;
using System.Linq;

namespace Host.Check
{
    /// <summary>The page about the architecture, with the table of rooms between its marks.</summary>
    sealed class ArchitecturePage : MarkedPage
    {
        public override string Path => "ARCHITECTURE.md";

        protected override string Part => "rooms";

        protected override bool HasSources(PackageTree package)
            => package.WithExtension(".cs").Any(file => file.StartsWith("Runtime/", StringComparison.Ordinal));

        protected override string TextOfPart(PackageTree package, Findings findings)
        {
            int before = findings.Faults.Count;
            Rooms rooms = RoomsRule.Compile(package, Rooms.OfRill, findings);
            return findings.Faults.Count > before ? null : rooms.Matrix();
        }
    }
}
