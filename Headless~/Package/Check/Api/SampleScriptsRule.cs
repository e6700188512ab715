using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Host.Check.Api
{
    /// <summary>The samples' scripts and their tests compile, and what they name of Unity's is there in every supported version and not
    /// obsolete. They are compiled here with and without what they ask for by #if, so that both branches are examined.</summary>
    sealed class SampleScriptsRule : Rule
    {
        const string Folder = "Samples~/";

        static readonly string[] Always = { "UNITY_5_3_OR_NEWER", "UNITY_2022_3", "UNITY_2022_3_OR_NEWER", "UNITY_STANDALONE", "UNITY_INCLUDE_TESTS" };
        static readonly string[] Switches = { "UNITY_EDITOR", "ENABLE_LEGACY_INPUT_MANAGER" };
        // What the host lacks. That Unity has these, with these signatures, is compared as all else.
        const string Input = "namespace UnityEngine { public class Input { public static bool anyKeyDown => false; " +
            "public static float GetAxisRaw(string axisName) => 0f; public static bool GetKey(KeyCode key) => false; " +
            "public static bool GetKeyDown(KeyCode key) => false; } }";

        static readonly string[] References = { "Rill", "Rill.Physics", "Rill.Testing" };

        public override string Name => "API: the samples' scripts and tests use what every version has";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<string> files = package.WithExtension(".cs").Where(file => file.StartsWith(Folder, StringComparison.Ordinal)).ToList();
            if (files.Count == 0)
                findings.Fault($"no C# source below {Folder} of {package.Root}");
            var types = new HashSet<string>();
            var members = new HashSet<string>();
            HashSet<string> names = SourceNamesRule.ConstantNames(PackageAssemblies.StandIns
                .Select(name => PackageAssemblies.Find(package.Assemblies, name)).Where(path => path != null)
                .Select(path => new CompiledAssembly(path)));
            var said = new HashSet<string>();
            foreach (string[] symbols in new[] { Always, Always.Concat(Switches).ToArray() })
            {
                var found = new Findings();
                Examine(package, files, symbols, names, types, members, found);
                foreach (string fault in found.Faults.Where(said.Add))
                    findings.Fault(fault);
            }
            findings.Looked = $"{files.Count} sources, with and without {string.Join(" and ", Switches)}: {types.Count} types and " +
                $"{members.Count} members of Unity against {string.Join(", ", UnityCatalogs.All.Select(unity => unity.Version))}";
            return findings;
        }

        static void Examine(PackageTree package, List<string> files, string[] symbols, ISet<string> names, ISet<string> types,
            ISet<string> members, Findings findings)
        {
            var options = new CSharpParseOptions(LanguageVersion.CSharp9, preprocessorSymbols: symbols);
            List<SyntaxTree> trees = files.Select(file =>
                CSharpSyntaxTree.ParseText(SourceText.From(package.Read(file), System.Text.Encoding.UTF8), options, file)).ToList();
            foreach (SyntaxTree tree in trees)
                CheckConditions(tree, findings);
            IEnumerable<MetadataReference> own = References.Select(name => PackageAssemblies.Find(package.Assemblies, name))
                .Where(path => path != null).Select(path => MetadataReference.CreateFromFile(path));
            List<MetadataReference> references = SourceNamesRule.References(package).Concat(own).ToList();
            CSharpCompilation input = Compile("UnityEngine.InputLegacyModule", new[] { CSharpSyntaxTree.ParseText(Input) }, references);
            CSharpCompilation compilation = Compile("Samples", trees, references.Append(input.ToMetadataReference()));
            using var image = new MemoryStream();
            foreach (Diagnostic error in compilation.Emit(image).Diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error))
                findings.Fault($"{SourceNamesRule.Where(error.Location)}: {error.GetMessage()}");
            if (findings.Faults.Count == 0)
            {
                image.Position = 0;
                using var assembly = new CompiledAssembly(image);
                UnityMembersRule.Examine(assembly, UnityCatalogs.All, types, members, findings);
                SourceNamesRule.Examine(compilation, names, UnityCatalogs.All, new HashSet<string>(), findings);
            }
        }

        static CSharpCompilation Compile(string name, IEnumerable<SyntaxTree> trees, IEnumerable<MetadataReference> references)
            => CSharpCompilation.Create(name, trees, references, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));

        static void CheckConditions(SyntaxTree tree, Findings findings)
        {
            foreach (ConditionalDirectiveTriviaSyntax condition in tree.GetRoot().DescendantTrivia().Select(trivia => trivia.GetStructure())
                .OfType<ConditionalDirectiveTriviaSyntax>())
                foreach (string symbol in condition.Condition.DescendantNodesAndSelf().OfType<IdentifierNameSyntax>()
                    .Select(name => name.Identifier.ValueText).Except(Switches))
                    findings.Fault($"{SourceNamesRule.Where(condition.GetLocation())}: #if {symbol}: only {string.Join(" and ", Switches)} are " +
                        $"compiled both ways here, so that a branch would go unexamined. Do without it, or add it to {nameof(SampleScriptsRule)}.");
        }
    }
}
