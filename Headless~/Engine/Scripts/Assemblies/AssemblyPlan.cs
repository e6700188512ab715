using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Shaders;
using System.Reflection.PortableExecutable;
using System.Text.RegularExpressions;
using Host.Assets;

namespace Host.Scripts.Assemblies
{
    /// <summary>Which scripts of a project make up which assembly, and in which order they are compiled. Scripts of the editor and of tests
    /// are none of it, but where the tests are run.</summary>
    internal sealed class AssemblyPlan
    {
        const string Main = "Assembly-CSharp", First = "Assembly-CSharp-firstpass";

        readonly ProjectIndex index;
        readonly Packages packages;
        readonly List<string> common;
        readonly HashSet<string> provided;
        readonly bool tests;
        readonly Dictionary<string, AssemblyDefinition> byName = new Dictionary<string, AssemblyDefinition>();
        readonly Dictionary<string, AssemblyDefinition> byGuid = new Dictionary<string, AssemblyDefinition>();
        readonly Dictionary<AssemblyDefinition, ScriptAssembly> planned = new Dictionary<AssemblyDefinition, ScriptAssembly>();
        readonly Dictionary<string, List<string>> notCompiled = new Dictionary<string, List<string>>();

        /// <summary>Each after those that it refers to.</summary>
        public readonly List<ScriptAssembly> Assemblies = new List<ScriptAssembly>();
        /// <summary>Managed plugins of the project, referred to or not.</summary>
        public readonly List<AssetEntry> Plugins = new List<AssetEntry>();
        /// <summary>Skipped parts and the reasons: references that lead nowhere, assemblies of other platforms.</summary>
        public readonly List<string> Notes = new List<string>();
        /// <summary>Scripts that belong to no assembly of a player, with the reason.</summary>
        public readonly Dictionary<string, string> NotForPlayers = new Dictionary<string, string>();

        /// <param name="hosted">Names of assemblies that the host itself has, whatever the project brings.</param>
        /// <exception cref="ScriptException">Definitions contradict each other: two of a name, references in a circle, a file that cannot
        /// be read.</exception>
        /// <param name="tests">As the Editor has it where its tests run, with assemblies of the editor and of tests; else as a player.</param>
        public AssemblyPlan(string project, ProjectIndex index, Packages packages, IEnumerable<string> hosted, bool tests = false)
        {
            this.tests = tests;
            this.index = index;
            this.packages = packages;
            provided = hosted.ToHashSet();
            common = Defines.Of(project, tests);
            if (tests)
                common.Add(Defines.IncludeTests);
            Plugins.AddRange(index.Entries.Where(IsPlugin));
            var folders = ReadDefinitions();
            Distribute(folders);
            foreach (var definition in planned.Keys.ToList()) Refer(definition);
            Order();
            foreach (var (reason, files) in notCompiled)
                if (reason.Length > 0) Notes.Add($"{reason}: {(files.Count == 1 ? files[0] : $"{files.Count} scripts, {files[0]} and others")}");
        }

        // ---- which folder belongs to which definition

        Dictionary<string, AssemblyDefinition> ReadDefinitions()
        {
            var folders = new Dictionary<string, AssemblyDefinition>();
            foreach (var entry in index.Entries.Where(e => !e.IsFolder && e.Extension == ".asmdef"))
            {
                var definition = AssemblyDefinition.Read(entry);
                if (byName.TryGetValue(definition.Name, out var other))
                    throw new ScriptException(
                    $"{entry.Path} and {other.Entry.Path} both define the assembly '{definition.Name}': rename one");
                byName.Add(definition.Name, definition);
                if (entry.Guid != null) byGuid.TryAdd(entry.Guid, definition);
                Claim(folders, entry, definition);
            }
            foreach (var entry in index.Entries.Where(e => !e.IsFolder && e.Extension == ".asmref"))
            {
                var reference = AssemblyDefinition.ReadReference(entry);
                var definition = Find(reference);
                if (definition == null) Notes.Add($"{entry.Path} refers to the assembly {Shown(reference)}, which is not in the " +
                    $"project: the scripts below it are not compiled");
                Claim(folders, entry, definition);
            }
            return folders;
        }

        static void Claim(Dictionary<string, AssemblyDefinition> folders, AssetEntry entry, AssemblyDefinition definition)
        {
            var folder = Folder(entry.Path);
            if (!folders.TryAdd(folder, definition))
                throw new ScriptException(
                $"{folder} holds more than one assembly definition or reference, {entry.Path} among them: Unity takes one a folder");
        }

        static string Folder(string path) => path.Substring(0, path.LastIndexOf('/'));

        AssemblyDefinition Find(string reference) =>
            reference.StartsWith("GUID:", StringComparison.OrdinalIgnoreCase)
            ? byGuid.TryGetValue(reference.Substring(5).ToLowerInvariant(), out var found) ? found : null
            : byName.TryGetValue(reference, out found) ? found : null;

        static string NameOf(string reference) => reference.StartsWith("GUID:", StringComparison.OrdinalIgnoreCase)
            ? WellKnownAssemblies.NameOf(reference.Substring(5).ToLowerInvariant()) : reference;
        static string Shown(string reference) => NameOf(reference) is string name
            ? $"'{name}'{(name == reference ? "" : $" ({reference})")}" : $"'{reference}'";

        // ---- which script belongs to which assembly

        void Distribute(Dictionary<string, AssemblyDefinition> folders)
        {
            ScriptAssembly first = null, main = null;
            foreach (var entry in index.Entries.Where(e => !e.IsFolder && e.Extension == ".cs"))
            {
                if (TryOwner(folders, Folder(entry.Path), out var definition))
                {
                    if (definition == null) Without(entry, "it lies below an assembly reference that leads nowhere", "");
                    else if (Planned(definition, entry) is ScriptAssembly assembly) assembly.Files.Add(entry);
                    continue;
                }
                if (!entry.Path.StartsWith("Assets/", StringComparison.Ordinal))
                    Without(entry, "it lies in a package, but below no assembly definition",
                        "scripts of packages need an assembly definition and are not compiled without one");
                else if (Within(entry.Path, "Editor")) Without(entry, "it lies in an Editor folder, and what is played is a player", "");
                else if (Within(entry.Path, "StreamingAssets") || Within(entry.Path, "WebGLTemplates"))
                    Without(entry, "Unity does not compile scripts in StreamingAssets and WebGLTemplates", "");
                else if (IsFirst(entry.Path)) (first ??= Predefined(First)).Files.Add(entry);
                else (main ??= Predefined(Main)).Files.Add(entry);
            }
            if (first != null) Assemblies.Add(first);
            if (main != null) Assemblies.Add(main);
            var automatic = planned.Where(p => p.Key.AutoReferenced).Select(p => p.Value).ToList();
            foreach (var predefined in new[] { first, main })
            {
                if (predefined == null) continue;
                predefined.References.AddRange(automatic);
                predefined.Hosted.AddRange(packages.HostedAssemblies.Where(name => provided.Contains(name) && name != TestAssemblies.Runner));
                if (tests) predefined.Hosted.Add(TestAssemblies.Editor);
                predefined.Plugins.AddRange(Plugins.Where(p => !IsExplicit(p)));
            }
            if (main != null && first != null) main.References.Add(first);
            foreach (var assembly in planned.Values) Assemblies.Add(assembly);
        }

        void Without(AssetEntry entry, string reason, string note)
        {
            NotForPlayers[entry.Path] = reason;
            if (!notCompiled.TryGetValue(note, out var files)) notCompiled.Add(note, files = new List<string>());
            files.Add(entry.Path);
        }

        ScriptAssembly Predefined(string name)
        {
            var assembly = new ScriptAssembly { Name = name };
            assembly.Defines.AddRange(common);
            return assembly;
        }

        static bool Within(string path, string folder) => path.Split('/').SkipLast(1).Contains(folder, StringComparer.OrdinalIgnoreCase);
        static bool IsFirst(string path) => path.Split('/') is { Length: > 2 } parts
            && parts[1].ToLowerInvariant() is "plugins" or "standard assets" or "pro standard assets";

        static bool TryOwner(Dictionary<string, AssemblyDefinition> folders, string folder, out AssemblyDefinition definition)
        {
            while (!folders.TryGetValue(folder, out definition))
            {
                var slash = folder.LastIndexOf('/');
                if (slash < 0) return false;
                folder = folder.Substring(0, slash);
            }
            return true;
        }

        /// <summary>Null for an assembly that a player has not.</summary>
        ScriptAssembly Planned(AssemblyDefinition definition, AssetEntry script)
        {
            if (planned.TryGetValue(definition, out var assembly)) return assembly;
            var defines = DefinesOf(definition);
            var reason = WhyNot(definition, defines);
            if (reason != null)
            {
                NotForPlayers[script.Path] = $"its assembly {definition.Name} {reason}";
                return null;
            }
            assembly = new ScriptAssembly
            {
                Name = definition.Name, Definition = definition.Entry.Path, AllowUnsafe = definition.AllowUnsafe,
                    NoEngineReferences = definition.NoEngineReferences,
                HoldsTests = HoldsTests(definition),
                    IsEditorOnly = definition.IncludePlatforms.SequenceEqual(new[] { Defines.EditorPlatform }),
            };
            assembly.Defines.AddRange(defines);
            planned.Add(definition, assembly);
            return assembly;
        }

        // Decides like Unity: by the constraint alone, not by one with alternatives.
        static bool HoldsTests(AssemblyDefinition definition)
            => definition.IsTest || definition.DefineConstraints.Contains(Defines.IncludeTests);

        List<string> DefinesOf(AssemblyDefinition definition) => common.Concat(VersionDefines(definition)).Distinct().ToList();

        string WhyNot(AssemblyDefinition definition, List<string> defines)
        {
            var platform = tests ? Defines.EditorPlatform : Defines.Platform;
            if (provided.Contains(definition.Name)) return "is one that the host has itself";
            if (definition.IsTest && !defines.Contains(Defines.IncludeTests)) return "holds tests";
            if (tests && HoldsTests(definition) && !packages.HasTests(definition.Entry.Path))
                return "holds tests of a package that \"testables\" does not list";
            if (definition.IncludePlatforms.Count > 0 && !definition.IncludePlatforms.Contains(platform))
                return $"is for {string.Join(", ", definition.IncludePlatforms)} only";
            if (definition.ExcludePlatforms.Contains(platform)) return $"is not for {platform}";
            return Defines.Hold(definition.DefineConstraints, defines) ? null
                : $"needs the defines {string.Join(", ", definition.DefineConstraints)}";
        }

        IEnumerable<string> VersionDefines(AssemblyDefinition definition)
        {
            foreach (var define in definition.VersionDefines)
            {
                var version = packages.VersionOf(define.Resource);
                var holds = false;
                try
                {
                    holds = version != null && VersionRange.Contains(define.Expression, version);
                }
                catch (FormatException e)
                {
                    throw new ScriptException($"{definition.Entry.Path}: the version define {define.Define}: {e.Message}");
                }
                if (holds) yield return define.Define;
            }
        }

        // ---- references

        void Refer(AssemblyDefinition definition)
        {
            var assembly = planned[definition];
            if (tests && !definition.NoEngineReferences) assembly.Hosted.Add(TestAssemblies.Editor);
            // The older form of a test assembly: a check box that stands for three references.
            if (definition.IsTest) assembly.Hosted.AddRange(new[] { TestAssemblies.Runner, TestAssemblies.NUnit });
            foreach (var reference in definition.References)
            {
                var name = NameOf(reference);
                // Both of the test framework's assemblies are one here.
                if (tests && name == TestAssemblies.EditorRunner) name = TestAssemblies.Runner;
                var target = Find(reference);
                if (name != null && provided.Contains(name) || target != null && provided.Contains(target.Name))
                    Hosted(assembly, definition, target?.Name ?? name);
                else if (target == null)
                {
                    // One that tells by a version define whether a package is there does without.
                    if (definition.VersionDefines.All(define => packages.VersionOf(define.Resource) != null))
                        Notes.Add($"{definition.Entry.Path} refers to the assembly {Shown(reference)}, which is not in the project: the scripts " +
                            $"that use it will not compile");
                }
                else if (planned.TryGetValue(target, out var other)) assembly.References.Add(other);
                else if (WhyNot(target, DefinesOf(target)) is string reason) Notes.Add($"{definition.Entry.Path} refers to " +
                    $"{target.Name}, which {reason}: {(tests ? "it is not compiled here" : "a player has it not")}");
            }
            if (!definition.OverrideReferences) assembly.Plugins.AddRange(Plugins.Where(p => !IsExplicit(p)));
            else
                foreach (var name in definition.PrecompiledReferences)
                    if (tests && name == TestAssemblies.NUnit + ".dll") assembly.Hosted.Add(TestAssemblies.NUnit);
                    else if (Plugins.Find(p => p.Path.EndsWith("/" + name, StringComparison.OrdinalIgnoreCase)) is AssetEntry plugin)
                        assembly.Plugins.Add(plugin);
                    else Notes.Add($"{definition.Entry.Path} refers to {name}, which is not in the project");
        }

        void Hosted(ScriptAssembly assembly, AssemblyDefinition definition, string name)
        {
            var package = packages.OfAssembly(name);
            if (package == null || packages.VersionOf(package) != null) assembly.Hosted.Add(name);
            else Notes.Add($"{definition.Entry.Path} refers to {name}, but neither Packages/manifest.json nor a package asks for " +
                $"{package}: the scripts that use it will not compile");
        }

        void Order()
        {
            var sorted = new List<ScriptAssembly>();
            var path = new List<ScriptAssembly>();
            void Visit(ScriptAssembly assembly)
            {
                if (sorted.Contains(assembly)) return;
                if (path.Contains(assembly))
                {
                    var circle = path.Skip(path.IndexOf(assembly)).Append(assembly).ToList();
                    throw new ScriptException($"assembly definitions refer to each other in a circle: {string.Join(" -> ", circle)} " +
                        $"({string.Join(", ", circle.Skip(1).Select(a => a.Definition))}): remove one of these references");
                }
                path.Add(assembly);
                foreach (var reference in assembly.References) Visit(reference);
                path.RemoveAt(path.Count - 1);
                sorted.Add(assembly);
            }
            foreach (var assembly in Assemblies) Visit(assembly);
            Assemblies.Clear();
            Assemblies.AddRange(sorted);
        }

        // ---- plugins

        /// <summary>A .dll with managed code that a player may load.</summary>
        static bool IsPlugin(AssetEntry entry)
        {
            if (entry.IsFolder || entry.Extension != ".dll" || Within(entry.Path, "Editor")) return false;
            using var file = File.OpenRead(entry.File);
            using var image = new PEReader(file);
            try
            {
                return image.HasMetadata && !IsEditorOnly(entry);
            }
            catch (BadImageFormatException)
            {
                return false;       // native code of another kind of system
            }
        }

        // The importer's table of platforms: "Any" off and nothing but "Editor" on.
        static bool IsEditorOnly(AssetEntry entry)
        {
            var meta = Meta(entry);
            return Regex.IsMatch(meta, @"Any:[^\n]*\n\s*second:\s*\n\s*enabled: 0")
                && Regex.IsMatch(meta, @"Editor: Editor\s*\n\s*second:\s*\n\s*enabled: 1")
                && !Regex.IsMatch(meta, @"Standalone:[^\n]*\n\s*second:\s*\n\s*enabled: 1");
        }

        static bool IsExplicit(AssetEntry entry) => Meta(entry).Contains("isExplicitlyReferenced: 1");
        static string Meta(AssetEntry entry) => File.Exists(entry.File + ".meta") ? File.ReadAllText(entry.File + ".meta") : "";
    }
}
