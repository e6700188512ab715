using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.UnityApi;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Host.Check.Api
{
    /// <summary>
    /// What the compiler leaves no trace of: values of enums and constants are written into the code as numbers, arguments that are
    /// passed by name by their place, and what stands behind an #if that is not met is not compiled at all. So this rule reads the sources.
    /// </summary>
    sealed class SourceNamesRule : Rule
    {
        static readonly string[] Folders = { "Runtime/", "Editor/", "Tests/" };

        public override string Name => "API: constants, enum values and named arguments exist in every version";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            var options = new CSharpParseOptions(LanguageVersion.CSharp9, preprocessorSymbols: new[] { "UNITY_5_3_OR_NEWER", "UNITY_2022_3", "UNITY_2022_3_OR_NEWER", "UNITY_EDITOR", "UNITY_STANDALONE", "UNITY_INCLUDE_TESTS" });
            List<SyntaxTree> trees = package.WithExtension(".cs").Where(file => Folders.Any(folder => file.StartsWith(folder, StringComparison.Ordinal)))
                .Select(file => CSharpSyntaxTree.ParseText(SourceText.From(package.Read(file)), options, file)).ToList();
            if (trees.Count == 0)
                findings.Fault($"no C# source below {string.Join(", ", Folders)} of {package.Root}");
            foreach (SyntaxTree tree in trees)
                Conditions(tree, findings);

            CSharpCompilation compilation = CSharpCompilation.Create("Sources", trees, References(package, findings), new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
            foreach (Diagnostic error in compilation.GetDiagnostics().Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error).Take(10))
                findings.Fault($"{Where(error.Location)}: does not compile here: {error.GetMessage()}");

            var constants = new HashSet<string>();
            int arguments = 0;
            foreach (SyntaxTree tree in trees)
            {
                SemanticModel model = compilation.GetSemanticModel(tree);
                foreach (SyntaxNode node in tree.GetRoot().DescendantNodes())
                    if (node is IdentifierNameSyntax { Parent: NameColonSyntax { Parent: ArgumentSyntax } } argument)
                    {
                        if (model.GetSymbolInfo(argument).Symbol is IParameterSymbol { ContainingSymbol: IMethodSymbol method } && IsUnity(method))
                        {
                            arguments++;
                            NamedArgument(method.OriginalDefinition, argument, findings);
                        }
                    }
                    else if (node is IdentifierNameSyntax name && model.GetSymbolInfo(name).Symbol is IFieldSymbol { HasConstantValue: true } field && IsUnity(field))
                    {
                        constants.Add(field.ToString());
                        var member = new CompiledMember(TypeOf(field.ContainingType), field.Name, true, true, 0, Constant(field), Array.Empty<ApiTypeName>());
                        Report(findings, name, field.ToString(), unity => ApiLookup.Complaint(unity, member));
                    }
            }
            findings.Looked = $"{constants.Count} constants and enum values, {arguments} arguments passed by name in {trees.Count} sources, against {string.Join(", ", UnityCatalogues.All.Select(unity => unity.Version))}";
            return findings;
        }

        // One set of defines is compiled and examined; what another would compile is not.
        static void Conditions(SyntaxTree tree, Findings findings)
        {
            foreach (ConditionalDirectiveTriviaSyntax condition in tree.GetRoot().DescendantTrivia().Select(trivia => trivia.GetStructure()).OfType<ConditionalDirectiveTriviaSyntax>())
                findings.Fault($"{Where(condition.GetLocation())}: #if {condition.Condition}: only one set of defines is compiled here, so that the other branch would go unexamined. Do without it, or let the API rules compile both.");
        }

        static IEnumerable<MetadataReference> References(PackageTree package, Findings findings)
        {
            foreach (string name in PackageAssemblies.StandIns.Append("nunit.framework"))
                if (PackageAssemblies.Find(package.Assemblies, name) is { } path)
                    yield return MetadataReference.CreateFromFile(path);
                else
                    findings.Fault($"{name}.dll is not in {package.Assemblies}: build Headless~/Headless.proj.");
            // The tests' NUnit is compiled for the .NET that runs here.
            foreach (string path in ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(Path.PathSeparator).Where(path => Path.GetFileName(path) is var file && (file.StartsWith("System.") || file is "netstandard.dll" or "mscorlib.dll")))
                yield return MetadataReference.CreateFromFile(path);
        }

        static void NamedArgument(IMethodSymbol method, IdentifierNameSyntax argument, Findings findings)
        {
            string parameter = argument.Identifier.ValueText;
            string name = method.MethodKind == MethodKind.Constructor ? ".ctor" : method.Name;
            Report(findings, argument, $"{method.ContainingType}.{method.Name}({parameter}:)", unity =>
            {
                ApiType type = unity.Find(TypeOf(method.ContainingType).Key);
                if (type == null)
                    return "has no such type";
                List<ApiMember> overloads = unity.Lineage(type).SelectMany(inherited => inherited.Type.Named(name)).Where(listed => listed.Parameters.Count == method.Parameters.Length).ToList();
                return overloads.Any(listed => listed.Parameters.Any(p => p.Name == parameter)) ? null : $"has no parameter of that name{string.Concat(overloads.Take(2).Select(listed => $" ({listed.Line.Signature})"))}";
            });
        }

        static ApiTypeName Constant(IFieldSymbol field) => TypeOf((INamedTypeSymbol)field.Type);

        static ApiTypeName TypeOf(INamedTypeSymbol type)
        {
            var path = new List<string>();
            for (INamedTypeSymbol part = type; part != null; part = part.ContainingType)
                path.Insert(0, part.MetadataName);
            for (INamespaceSymbol space = type.ContainingNamespace; space is { IsGlobalNamespace: false }; space = space.ContainingNamespace)
                path.Insert(0, space.Name);
            return ApiTypeName.Named(path);
        }

        static bool IsUnity(ISymbol symbol) => symbol.ContainingAssembly is { } assembly && UnityMembersRule.IsUnity(assembly.Name);

        static string Where(Location location) => $"{location.SourceTree?.FilePath}:{location.GetLineSpan().StartLinePosition.Line + 1}";

        static void Report(Findings findings, SyntaxNode node, string what, Func<ApiCatalogue, string> complain)
        {
            foreach (IGrouping<string, string> same in UnityCatalogues.All.Select(unity => (unity.Version, complaint: complain(unity))).Where(v => v.complaint != null).GroupBy(v => v.complaint, v => v.Version))
                findings.Fault($"{Where(node.GetLocation())}: {what}: Unity {string.Join(", ", same)} {same.Key}");
        }
    }
}
