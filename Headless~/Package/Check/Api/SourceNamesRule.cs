using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.UnityApi;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Host.Check.Api
{
    /// <summary>
    /// Names of which the compiler leaves no trace: values of enums and constants are written into the code as numbers, arguments that are
    /// passed by name by their position, and code under an #if that is not met is not compiled at all. So this rule reads the sources.
    /// </summary>
    sealed class SourceNamesRule : Rule
    {
        static readonly string[] Folders = { "Runtime/", "Editor/", "Testing/", "Tests/" };
        // Compiled and examined once for each version of the pipeline: PipelineAdaptersRule.
        internal static readonly string[] AdapterFolders = { "Runtime/Rendering.Universal/", "Runtime/Rendering.HighDefinition/" };

        public override string Name => "API: constants, enum values and named arguments exist in every version";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            var options = new CSharpParseOptions(LanguageVersion.CSharp9,
                preprocessorSymbols: new[] { "UNITY_5_3_OR_NEWER", "UNITY_2022_3", "UNITY_2022_3_OR_NEWER", "UNITY_EDITOR",
                "UNITY_STANDALONE", "UNITY_INCLUDE_TESTS" });
            List<SyntaxTree> trees = package.WithExtension(".cs")
                .Where(file => Folders.Any(folder => file.StartsWith(folder, StringComparison.Ordinal))
                && !AdapterFolders.Any(folder => file.StartsWith(folder, StringComparison.Ordinal)))
                .Select(file => CSharpSyntaxTree.ParseText(SourceText.From(package.Read(file)), options, file)).ToList();
            if (trees.Count == 0)
                findings.Fault($"no C# source below {string.Join(", ", Folders)} of {package.Root}");
            foreach (SyntaxTree tree in trees)
                Conditions(tree, findings);

            CSharpCompilation compilation = CSharpCompilation.Create("Sources", trees, References(package),
                new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
            var constants = new HashSet<string>();
            int arguments = Examine(compilation, ConstantNames(PackageAssemblies.Open(package, PackageAssemblies.StandIns, findings)),
                UnityCatalogs.Supported, constants, findings);
            findings.Looked = $"{constants.Count} constants and enum values, {arguments} arguments passed by name in {trees.Count} " +
                $"sources, against {string.Join(", ", UnityCatalogs.Supported.Select(unity => unity.Version))}";
            return findings;
        }

        /// <summary>Compares what the sources of a compilation name of Unity with these versions.</summary>
        /// <param name="names">Of constants and values of enums that are there at all.</param>
        /// <param name="constants">Gets those that are used.</param>
        /// <returns>How many arguments were passed by name.</returns>
        internal static int Examine(CSharpCompilation compilation, ISet<string> names, IReadOnlyList<ApiCatalog> versions,
            ISet<string> constants, Findings findings)
        {
            int arguments = 0;
            foreach (SyntaxTree tree in compilation.SyntaxTrees)
            {
                SemanticModel model = compilation.GetSemanticModel(tree);
                foreach (IdentifierNameSyntax name in Candidates(tree.GetCompilationUnitRoot(), names))
                {
                    SymbolInfo info = model.GetSymbolInfo(name);
                    switch (info.Symbol)
                    {
                        case null when info.CandidateSymbols.IsEmpty:
                            findings.Fault($"{Where(name.GetLocation())}: what {name.Parent} names is not to be told: it does not compile here.");
                            break;
                        case IParameterSymbol { ContainingSymbol: IMethodSymbol method } when IsUnity(method):
                            arguments++;
                            NamedArgument(method.OriginalDefinition, name, versions, findings);
                            break;
                        case IFieldSymbol { HasConstantValue: true } field when IsUnity(field):
                            constants.Add(field.ToString());
                            var member = new CompiledMember(TypeOf(field.ContainingType), field.Name, true, true, 0,
                                TypeOf((INamedTypeSymbol)field.Type), Array.Empty<ApiTypeName>());
                            // Nothing but the source names a type of which only a value is used.
                            Report(findings, versions, name, field.ToString(), unity => ApiLookup.Complaint(unity, member.Owner)
                                ?? ApiLookup.Complaint(unity, member));
                            break;
                    }
                }
            }
            return arguments;
        }

        // Names of arguments, and those that some type of Unity's has a constant of: to bind all the others would take the compiler's time.
        static IEnumerable<IdentifierNameSyntax> Candidates(CompilationUnitSyntax root, ISet<string> constants)
        {
            bool unqualified = root.Usings.Any(directive => directive.StaticKeyword != default);
            return root.DescendantNodes().OfType<IdentifierNameSyntax>().Where(name => name.Parent switch
            {
                NameColonSyntax colon => colon.Parent is ArgumentSyntax,
                NameEqualsSyntax => false,      // of an alias, or an attribute's argument
                MemberAccessExpressionSyntax access when access.Name == name => constants.Contains(name.Identifier.ValueText),
                QualifiedNameSyntax qualified when qualified.Right == name => constants.Contains(name.Identifier.ValueText),
                _ => unqualified && constants.Contains(name.Identifier.ValueText),
            });
        }

        internal static HashSet<string> ConstantNames(IEnumerable<CompiledAssembly> assemblies)
        {
            var names = new HashSet<string>();
            foreach (CompiledAssembly assembly in assemblies)
                using (assembly)
                    names.UnionWith(assembly.Metadata.FieldDefinitions.Select(assembly.Metadata.GetFieldDefinition)
                        .Where(field => (field.Attributes & FieldAttributes.Literal) != 0).Select(field => assembly.Metadata.GetString(field.Name)));
            return names;
        }

        // One set of defines is compiled and examined; what another would compile is not.
        static void Conditions(SyntaxTree tree, Findings findings)
        {
            foreach (ConditionalDirectiveTriviaSyntax condition in tree.GetRoot().DescendantTrivia().Select(trivia => trivia.GetStructure())
                .OfType<ConditionalDirectiveTriviaSyntax>())
                findings.Fault($"{Where(condition.GetLocation())}: #if {condition.Condition}: only one set of defines is compiled " +
                    $"here, so that the other branch would go unexamined. Do without it, or let the API rules compile both.");
        }

        internal static IEnumerable<MetadataReference> References(PackageTree package)
        {
            foreach (string name in PackageAssemblies.StandIns.Append("nunit.framework"))
                if (PackageAssemblies.Find(package.Assemblies, name) is { } path)
                    yield return MetadataReference.CreateFromFile(path);
            // The tests' NUnit is compiled for the .NET that runs here.
            foreach (string path in ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(Path.PathSeparator)
                .Where(path => Path.GetFileName(path) is var file
                && (file.StartsWith("System.") || file is "netstandard.dll" or "mscorlib.dll")))
                yield return MetadataReference.CreateFromFile(path);
        }

        static void NamedArgument(IMethodSymbol method, IdentifierNameSyntax argument, IReadOnlyList<ApiCatalog> versions, Findings findings)
        {
            string parameter = argument.Identifier.ValueText;
            string name = method.MethodKind == MethodKind.Constructor ? ".ctor" : method.Name;
            Report(findings, versions, argument, $"{method.ContainingType}.{method.Name}({parameter}:)", unity =>
            {
                ApiType type = unity.Find(TypeOf(method.ContainingType).Key);
                if (type == null)
                    return "has no such type";
                List<ApiMember> overloads = unity.Lineage(type).SelectMany(inherited => inherited.Type.Named(name))
                    .Where(listed => listed.Parameters.Count == method.Parameters.Length).ToList();
                return overloads.Any(listed => listed.Parameters.Any(p => p.Name == parameter)) ? null
                    : $"has no parameter of that name{string.Concat(overloads.Take(2).Select(listed => $" ({listed.Line.Signature})"))}";
            });
        }

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

        internal static string Where(Location location) => $"{location.SourceTree?.FilePath}:{location.GetLineSpan().StartLinePosition.Line + 1}";

        static void Report(Findings findings, IReadOnlyList<ApiCatalog> versions, SyntaxNode node, string what, Func<ApiCatalog, string> complain)
        {
            foreach (IGrouping<string, string> same in versions.Where(unity => unity.IsFor(what))
                .Select(unity => (unity.Version, complaint: complain(unity)))
                .Where(v => v.complaint != null).GroupBy(v => v.complaint, v => v.Version))
                findings.Fault($"{Where(node.GetLocation())}: {what}: Unity {string.Join(", ", same)} {same.Key}");
        }
    }
}
