using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Host.Check
{
    /// <summary>An .asmdef file.</summary>
    sealed class AssemblyDefinition
    {
        public readonly string File, Folder, Name, RootNamespace;
        public readonly string[] References, IncludePlatforms, PrecompiledReferences, DefineConstraints;
        public readonly bool AllowUnsafeCode, OverrideReferences;
        /// <summary>Symbols that a package or module defines by being there.</summary>
        public readonly (string Package, string Symbol)[] VersionDefines;

        /// <summary>Whether Unity takes it for one with tests: it compiles those of a package only where "testables" lists it.</summary>
        public bool IsTest => DefineConstraints.Contains("UNITY_INCLUDE_TESTS");

        /// <summary>Whether players contain it only where they are built with tests, or by a symbol of the project.</summary>
        public bool IsForTests => DefineConstraints.Any(constraint => constraint.StartsWith("UNITY_INCLUDE_TESTS || ", StringComparison.Ordinal));

        /// <summary>Those that Unity sees; one that cannot be read is a fault.</summary>
        public static List<AssemblyDefinition> All(PackageTree package, Findings findings) => Read(package, package.Visible, findings);

        /// <summary>Those among files.</summary>
        public static List<AssemblyDefinition> Read(PackageTree package, IEnumerable<string> files, Findings findings)
        {
            var all = new List<AssemblyDefinition>();
            foreach (string file in files.Where(f => f.EndsWith(".asmdef", StringComparison.Ordinal)))
                try
                {
                    using JsonDocument json = JsonDocument.Parse(package.Read(file));
                    all.Add(new AssemblyDefinition(file, json.RootElement));
                }
                catch (Exception e) when (e is JsonException or KeyNotFoundException or InvalidOperationException)
                {
                    findings.Fault($"{file} cannot be read: {e.Message}");
                }
            return all;
        }

        AssemblyDefinition(string file, JsonElement root)
        {
            File = file;
            Folder = file.Substring(0, file.LastIndexOf('/') + 1);
            Name = root.GetProperty("name").GetString();
            RootNamespace = root.TryGetProperty("rootNamespace", out JsonElement space) ? space.GetString() : "";
            string[] Strings(string key) => root.TryGetProperty(key, out JsonElement list)
                ? list.EnumerateArray().Select(e => e.GetString()).ToArray() : Array.Empty<string>();
            bool Flag(string key) => root.TryGetProperty(key, out JsonElement flag) && flag.GetBoolean();
            References = Strings("references");
            IncludePlatforms = Strings("includePlatforms");
            PrecompiledReferences = Strings("precompiledReferences");
            DefineConstraints = Strings("defineConstraints");
            VersionDefines = root.TryGetProperty("versionDefines", out JsonElement defines)
                ? defines.EnumerateArray().Select(d => (d.GetProperty("name").GetString(), d.GetProperty("define").GetString())).ToArray()
                    : Array.Empty<(string, string)>();
            AllowUnsafeCode = Flag("allowUnsafeCode");
            OverrideReferences = Flag("overrideReferences");
        }

        /// <summary>Set for a render pipeline: compiled for each version of it against stand-ins, not by a project of its own.</summary>
        public bool IsAdapter => VersionDefines.Any(define => define.Package.StartsWith("com.unity.render-pipelines.", StringComparison.Ordinal));

        /// <summary>Whether Unity compiles it only where the package or module is there.</summary>
        public bool NeedsPresent(string package)
            => VersionDefines.Any(define => define.Package == package && DefineConstraints.Contains(define.Symbol));

        /// <summary>The scripts that Unity compiles into this assembly: those below its folder and not below a nested definition's.</summary>
        public IEnumerable<string> Scripts(PackageTree package, IEnumerable<AssemblyDefinition> all)
            => package.Visible.Where(f => f.EndsWith(".cs", StringComparison.Ordinal) && Owner(f, all) == this);

        /// <summary>Null for a script in no definition's folder.</summary>
        public static AssemblyDefinition Owner(string script, IEnumerable<AssemblyDefinition> all) =>
            all.Where(a => script.StartsWith(a.Folder, StringComparison.Ordinal)).OrderByDescending(a => a.Folder.Length).FirstOrDefault();
    }
}
