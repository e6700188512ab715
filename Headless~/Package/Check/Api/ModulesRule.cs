using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>
    /// Every built-in module and package whose types the package's assemblies name is a dependency of package.json, or the
    /// assembly is compiled only where it is there. What the tests alone need, the test project has.
    /// </summary>
    sealed class ModulesRule : Rule
    {
        const string TestManifest = "TestProject~/Packages/manifest.json", Mathematics = "com.unity.mathematics",
            List = "Headless~/Engine/data/unity-api/modules.txt", BuiltIn = "com.unity.modules.";
        // Its scripts are compiled in the user's project, once imported.
        const string Samples = "Rill.Samples";

        readonly IReadOnlyList<string> names;
        readonly Func<UnityModules> list;

        public ModulesRule(IReadOnlyList<string> assemblies = null, Func<UnityModules> list = null)
        {
            names = assemblies ?? PackageAssemblies.Package;
            this.list = list ?? UnityModules.Load;
        }

        public override string Name => "API: every module in use is a dependency";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            PackageManifest manifest = PackageManifest.Read(package, findings);
            List<AssemblyDefinition> definitions = AssemblyDefinition.All(package, findings);
            HashSet<string> inTestProject = TestDependencies(package, findings);
            if (manifest == null || inTestProject == null)
                return findings;
            HashSet<string> dependencies = manifest.Dependencies.Select(dependency => dependency.Key).ToHashSet();
            HashSet<string> optional = definitions.Where(d => !d.IsTest).SelectMany(d => d.VersionDefines.Select(define => define.Package))
                .ToHashSet();
            UnityModules modules = list();

            var used = new SortedSet<string>(StringComparer.Ordinal);
            foreach (CompiledAssembly assembly in PackageAssemblies.Open(package, names, findings))
                using (assembly)
                    foreach ((string module, ApiTypeName type) in Uses(assembly, modules, findings))
                    {
                        used.Add(module);
                        AssemblyDefinition definition = definitions.Find(d => d.Name == assembly.Name);
                        bool isTest = definition != null && definition.IsTest;
                        if (dependencies.Contains(module))
                            continue;
                        // Tests are compiled in projects with the Test Framework alone.
                        bool isOptional = definition != null && definition.NeedsPresent(module) || assembly.Name == Samples
                            && optional.Contains(module) || isTest && !module.StartsWith(BuiltIn, StringComparison.Ordinal);
                        if (!isOptional)
                            findings.Fault($"{assembly.Name}.dll uses {type} of {module}, which is not a dependency of package.json: a " +
                                $"project without that module does not compile it. Add \"{module}\", or a version define and a define " +
                                $"constraint to the .asmdef");
                        else if (isTest && !inTestProject.Contains(module))
                            findings.Fault($"{assembly.Name}.dll uses {type} of {module}, which {TestManifest} lacks, so that the Test " +
                                $"Runner would not show its tests there: add it");
                    }
            foreach (string dependency in dependencies.Where(dependency => dependency.StartsWith(BuiltIn, StringComparison.Ordinal)
                && !used.Contains(dependency)))
                findings.Fault($"package.json depends on {dependency}, of which no assembly uses a type: remove it");
            findings.Looked = $"{used.Count} modules and packages: {string.Join(", ", used)}";
            return findings;
        }

        /// <summary>Each module with the first type of it; a type that the list lacks is a fault.</summary>
        /// <param name="unlisted">An assembly whose types the list does not have.</param>
        internal static IEnumerable<(string Module, ApiTypeName Type)> Uses(CompiledAssembly assembly, UnityModules modules, Findings findings,
            string unlisted = null)
        {
            var first = new SortedDictionary<string, ApiTypeName>(StringComparer.Ordinal);
            foreach ((string from, ApiTypeName type) in assembly.TypesUsed.Where(use => UnityMembersRule.IsUnity(use.Assembly)
                && use.Assembly != unlisted))
            {
                string module;
                if (type.Path[0] == "UnityEditor")
                    continue;
                if (type.Path[0] == "Unity" && type.Path[1] == "Mathematics")
                    module = Mathematics;
                else if (!modules.TryFind(type, out _, out module))
                    findings.Fault($"{assembly.Name}.dll uses {type}, and {List} does not say which module has it: add it below its assembly");
                if (module != null)
                    first.TryAdd(module, type);
            }
            return first.Select(use => (use.Key, use.Value));
        }

        static HashSet<string> TestDependencies(PackageTree package, Findings findings)
        {
            try
            {
                using JsonDocument json = JsonDocument.Parse(package.Read(TestManifest));
                return json.RootElement.GetProperty("dependencies").EnumerateObject().Select(dependency => dependency.Name).ToHashSet();
            }
            catch (Exception e) when (e is JsonException or System.IO.IOException or KeyNotFoundException)
            {
                findings.Fault($"{TestManifest} cannot be read: {e.Message}");
                return null;
            }
        }
    }
}
