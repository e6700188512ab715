using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Check.Api;
using Microsoft.CodeAnalysis;

namespace Host.Check
{
    /// <summary>Code of a room names only what is in that room and in those before it.</summary>
    sealed class RoomsRule : Rule
    {
        // Assemblies of their own.
        static readonly string[] Others = { "Physics", "Terrain", "TerrainPhysics", "Timeline", "Rendering.Universal", "Rendering.HighDefinition" };

        readonly IReadOnlyList<string> order;

        public RoomsRule(IReadOnlyList<string> order = null) => this.order = order ?? Rooms.OfRill;

        public override string Name => "code: each room compiles with those before it";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            Rooms rooms = Compile(package, order, findings);
            findings.Looked = $"{rooms.Files} files in {order.Count} rooms";
            return findings;
        }

        /// <summary>Compiles the rooms of a package.</summary>
        public static Rooms Compile(PackageTree package, IReadOnlyList<string> order, Findings findings)
        {
            List<(string, string)> sources = package.WithExtension(".cs").Where(IsOfRill).Select(file => (file, package.Read(file))).ToList();
            if (sources.Count == 0)
                findings.Fault($"no C# source below Runtime of {package.Root}");
            var rooms = new Rooms(order);
            rooms.Compile(sources, References(package), findings);
            return rooms;
        }

        // Unity's compiler sees .NET Standard; for Unity stand the host's assemblies.
        static IEnumerable<MetadataReference> References(PackageTree package)
        {
            using (Stream netStandard = typeof(RoomsRule).Assembly.GetManifestResourceStream("netstandard.dll"))
                yield return MetadataReference.CreateFromStream(netStandard);
            foreach (string name in PackageAssemblies.StandIns)
                if (PackageAssemblies.Find(package.Assemblies, name) is { } path)
                    yield return MetadataReference.CreateFromFile(path);
        }

        static bool IsOfRill(string file) => file.StartsWith("Runtime/", StringComparison.Ordinal)
            && !Others.Any(other => file.StartsWith($"Runtime/{other}/", StringComparison.Ordinal));
    }
}
