using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.Check.Api
{
    /// <summary>Location of the assemblies to examine: beside the host, or where the build puts each.</summary>
    static class PackageAssemblies
    {
        /// <summary>Assemblies of the package: what its users compile, its samples' scripts, and its tests.</summary>
        public static readonly string[] Package = { "Rill", "Rill.Physics", "Rill.Terrain", "Rill.TerrainPhysics", "Rill.Timeline",
            "Rill.Editor", "Rill.Samples", "Rill.Testing", "Rill.Physics.Editor", "Rill.Terrain.Editor", "Rill.TerrainPhysics.Editor",
            "Rill.Tests", "Rill.Physics.Tests", "Rill.Terrain.Tests", "Rill.TerrainPhysics.Tests", "Rill.Timeline.Tests", "Rill.Editor.Tests" };
        /// <summary>Those whose texts a user reads.</summary>
        public static readonly string[] WithoutTests = Package.Where(name => !name.EndsWith(".Tests", StringComparison.Ordinal)).ToArray();
        /// <summary>Assemblies of the host that stand in for Unity.</summary>
        public static readonly string[] StandIns = { "UnityEngine", "UnityEngine.PhysicsModule", "UnityEngine.TerrainModule",
            "UnityEngine.TerrainPhysicsModule", "UnityEngine.DirectorModule", "Unity.Timeline", "UnityEditor", "Unity.Mathematics",
            "UnityEngine.TestRunner" };

        /// <summary>Opens those that are there; each that is not is a fault.</summary>
        public static List<CompiledAssembly> Open(PackageTree package, IEnumerable<string> names, Findings findings)
        {
            var opened = new List<CompiledAssembly>();
            foreach (string name in names)
            {
                string path = Find(package.Assemblies, name);
                if (path != null)
                    opened.Add(new CompiledAssembly(path));
                else
                    findings.Fault($"{name}.dll is not in {package.Assemblies} nor where the build puts it: build " +
                    $"Headless~/Headless.proj, or run through Headless~/rill.");
            }
            return opened;
        }

        /// <summary>Null: it is nowhere.</summary>
        public static string Find(string folder, string name)
        {
            string here = Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder));
            return new[] { here, Path.Combine(here, "..", "..", name, Path.GetFileName(here)) }
                .Select(candidate => Path.GetFullPath(Path.Combine(candidate, name + ".dll"))).FirstOrDefault(File.Exists);
        }
    }
}
