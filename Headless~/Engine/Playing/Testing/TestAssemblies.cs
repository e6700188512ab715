using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.Loader;

namespace Host.Testing
{
    /// <summary>Finds and loads built test assemblies: beside the host when published, else where the build put them.</summary>
    static class TestAssemblies
    {
        static readonly string[] EngineTests = { "Engine.Tests" };

        /// <param name="only">The file of another assembly, instead of all of these; null for none.</param>
        public static List<Assembly> Load(bool host, bool package, string only = null)
        {
            string[] files = only != null ? new[] { Path.GetFullPath(only) } : Files(host, package);
            if (files.Length == 0)
                throw new HostException($"no test assembly found near {AppContext.BaseDirectory}; build them, or run through Headless~/rill.");
            return Load(files);
        }

        /// <summary>Whether its tests are of the host, and never run in Unity.</summary>
        public static bool IsOfHost(string assembly) => EngineTests.Concat(BuiltInPackage.Current.ProgramTests).Contains(assembly);

        /// <summary>Returns those that are there, which may be none.</summary>
        public static List<Assembly> LoadBuilt(bool host, bool package) => Load(Files(host, package));

        static string[] Files(bool host, bool package) => (host ? EngineTests.Concat(BuiltInPackage.Current.ProgramTests) : Array.Empty<string>())
            .Concat(package ? BuiltInPackage.Current.Tests : Array.Empty<string>()).Select(Find).Where(file => file != null).ToArray();

        static List<Assembly> Load(string[] files)
        {
            // Dependencies of a test assembly beyond the host's own assemblies lie beside it.
            AssemblyLoadContext.Default.Resolving += (context, name) => files
                .Select(file => Path.Combine(Path.GetDirectoryName(file), name.Name + ".dll"))
                .Where(File.Exists).Select(context.LoadFromAssemblyPath).FirstOrDefault();
            return files.Select(AssemblyLoadContext.Default.LoadFromAssemblyPath).ToList();
        }

        static string Find(string name)
        {
            string here = AppContext.BaseDirectory.TrimEnd(Path.DirectorySeparatorChar);
            string configuration = Path.GetFileName(here);
            return new[] { here, Path.Combine(here, "..", "..", name, configuration) }
                .Select(folder => Path.GetFullPath(Path.Combine(folder, name + ".dll")))
                .FirstOrDefault(File.Exists);
        }
    }
}
