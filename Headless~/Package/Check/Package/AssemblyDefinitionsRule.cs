using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Xml.Linq;

namespace Host.Check
{
    /// <summary>The assemblies that Unity compiles by its assembly definitions are those that were compiled and tested here by projects of the same
    /// names.</summary>
    sealed class AssemblyDefinitionsRule : Rule
    {
        const string Projects = "Headless~/Package/";

        public override string Name => "package: assembly definitions agree with the projects that build them";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<AssemblyDefinition> all = AssemblyDefinition.All(package, findings);
            int scripts = 0;
            foreach (AssemblyDefinition definition in all)
            {
                scripts += definition.Scripts(package, all).Count();
                CheckDefinition(definition, findings);
                // Adapters have a rule of their own: PipelineAdaptersRule.
                if (!definition.IsAdapter)
                    CheckProject(package, definition, all, findings);
            }
            foreach (string script in package.Visible.Where(f => f.EndsWith(".cs", StringComparison.Ordinal)
                && AssemblyDefinition.Owner(f, all) == null))
                findings.Fault($"{script} lies in no folder with an .asmdef, so Unity does not compile it: packages need one");
            findings.Looked = $"{all.Count} assembly definitions over {scripts} scripts";
            return findings;
        }

        static void CheckDefinition(AssemblyDefinition definition, Findings findings)
        {
            void Must(bool holds, string what) { if (!holds) findings.Fault($"{definition.File}: {what}"); }

            Must(Path.GetFileNameWithoutExtension(definition.File) == definition.Name,
                $"the file should have the assembly's name, {definition.Name}");
            Must(definition.RootNamespace == definition.Name,
                $"\"rootNamespace\" is \"{definition.RootNamespace}\", not the assembly's name {definition.Name}");
            bool editor = definition.Folder.Split('/').Contains("Editor");
            Must(editor == (definition.IncludePlatforms.Length == 1 && definition.IncludePlatforms[0] == "Editor"),
                editor ? "code in a folder Editor needs \"includePlatforms\": [\"Editor\"], or players do not compile"
                    : "\"includePlatforms\" should be empty, so that it works on every platform");
            Must(!definition.AllowUnsafeCode, "\"allowUnsafeCode\" is on; the package promises to do without");

            bool tests = definition.Folder.StartsWith("Tests/", StringComparison.Ordinal);
            Must(tests == definition.IsTest, tests
                ? "a test assembly needs \"defineConstraints\": [\"UNITY_INCLUDE_TESTS\"], or players contain it"
                : "UNITY_INCLUDE_TESTS would keep it out of players");
            Must(!definition.Folder.StartsWith("Testing/", StringComparison.Ordinal) || definition.IsForTests,
                "what users' tests call needs a constraint of the form \"UNITY_INCLUDE_TESTS || SYMBOL\", or every player contains it. " +
                "UNITY_INCLUDE_TESTS alone would hide it from projects whose \"testables\" do not list the package");
            if (tests)
            {
                Must(definition.OverrideReferences && definition.PrecompiledReferences.Contains("nunit.framework.dll"),
                    "a test assembly needs \"overrideReferences\" with nunit.framework.dll, or it does not compile");
                Must(definition.NeedsPresent("com.unity.test-framework"), "a test assembly needs a version define of com.unity.test-framework and " +
                    "its symbol among the constraints, or a project without the framework that embeds the package does not compile");
                foreach (string runner in new[] { "UnityEngine.TestRunner", "UnityEditor.TestRunner" })
                    Must(definition.References.Contains(runner), $"a test assembly needs a reference to {runner}");
            }
        }

        static void CheckProject(PackageTree package, AssemblyDefinition definition, List<AssemblyDefinition> all, Findings findings)
        {
            string file = $"{Projects}{definition.Name}/{definition.Name}.csproj";
            if (!package.Has(file))
            {
                findings.Fault($"{definition.File}: there is no {file}, so it is neither compiled nor tested here");
                return;
            }
            XDocument project = XDocument.Parse(package.Read(file));
            void Same(string what, IEnumerable<string> inUnity, IEnumerable<string> here)
            {
                string[] missing = inUnity.Except(here).ToArray(), extra = here.Except(inUnity).ToArray();
                if (missing.Length > 0)
                    findings.Fault($"{file} lacks {what} that {definition.File} has: {string.Join(", ", missing)}");
                if (extra.Length > 0)
                    findings.Fault($"{file} has {what} that {definition.File} lacks: {string.Join(", ", extra)}");
            }

            Same("scripts", definition.Scripts(package, all), Compiled(package, project));
            // The engine itself is not a reference in Unity; both test runners are one assembly here.
            Same("references", definition.References.Where(r => r != "UnityEditor.TestRunner"),
                project.Descendants("ProjectReference").Select(r => Path.GetFileNameWithoutExtension(r.Attribute("Include").Value))
                    .Where(r => r is not ("UnityEngine" or "UnityEngine.PhysicsModule" or "UnityEngine.TerrainModule"
                        or "UnityEngine.TerrainPhysicsModule" or "UnityEngine.DirectorModule" or "UnityEditor")));
            foreach ((string property, string wanted) in new[] { ("AssemblyName", definition.Name),
                ("RootNamespace", definition.RootNamespace), ("AllowUnsafeBlocks", definition.AllowUnsafeCode ? "true" : "false") })
                if (project.Descendants(property).FirstOrDefault()?.Value is var value && value != wanted)
                    findings.Fault($"{file}: {property} is \"{value}\", {definition.File} asks for \"{wanted}\"");
        }

        // Includes of the form "$(PackageRoot)Folder/**/*.cs" and excludes of the same form.
        static HashSet<string> Compiled(PackageTree package, XDocument project)
        {
            IEnumerable<string> Files(XAttribute pattern) => (pattern?.Value ?? "").Split(';', StringSplitOptions.RemoveEmptyEntries).SelectMany(p =>
            {
                string folder = p.Replace("$(PackageRoot)", "").Replace("**/*.cs", "");
                return package.Files.Where(f => f.StartsWith(folder, StringComparison.Ordinal) && f.EndsWith(".cs", StringComparison.Ordinal));
            });
            return project.Descendants("Compile").SelectMany(c => Files(c.Attribute("Include")).Except(Files(c.Attribute("Exclude")))).ToHashSet();
        }
    }
}
