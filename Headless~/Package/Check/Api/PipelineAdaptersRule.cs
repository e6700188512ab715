using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Host.Pipelines;
using Host.UnityApi;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Text;

namespace Host.Check.Api
{
    /// <summary>
    /// The package's adapters are compiled once for each version of their pipeline with the symbols that its editor sets, without a
    /// warning, and what they name is in the lists of that version. Without the pipeline they are not compiled.
    /// </summary>
    sealed class PipelineAdaptersRule : Rule
    {
        /// <summary>Members of the path that URP calls obsolete and runs all the same until 6000.3: upgraded projects start with it.</summary>
        static readonly string[] CompatibilityPath = { "ScriptableRenderPass.Execute(", "ScriptableRenderer.get_cameraColorTargetHandle()",
            "ScriptableRenderer.get_cameraDepthTargetHandle()" };

        readonly IReadOnlyList<PipelineKind> kinds;

        /// <param name="kinds">Those whose adapters are examined; null: all.</param>
        public PipelineAdaptersRule(IReadOnlyList<PipelineKind> kinds = null) => this.kinds = kinds ?? PipelineKind.All;

        public override string Name => "API: render pipeline adapters compile in every version";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            var types = new HashSet<string>();
            var members = new HashSet<string>();
            foreach (PipelineKind kind in kinds)
                Examine(package, kind, types, members, findings);
            findings.Looked =
                $"{string.Join(" and ", kinds.Select(kind => Path.GetFileNameWithoutExtension(PipelineAdapters.FileOf(kind))))} " +
                $"compiled {2 * PipelineVersion.All.Count} times each, as player and for the editor, in " +
                $"{string.Join(", ", PipelineVersion.All)}: {types.Count} types and {members.Count} members";
            return findings;
        }

        static void Examine(PackageTree package, PipelineKind kind, ISet<string> types, ISet<string> members, Findings findings)
        {
            if (!package.Has(PipelineAdapters.FileOf(kind)))
            {
                findings.Fault($"{PipelineAdapters.FileOf(kind)} is not there");
                return;
            }
            AdapterDefinition adapter = AdapterDefinition.Read(package.FullPath(PipelineAdapters.FileOf(kind)));
            if (adapter.Defines(null, false) != null)
                findings.Fault($"{PipelineAdapters.FileOf(kind)}: without {kind.Package} it is compiled all the same, and its " +
                    $"references are missing: add a define constraint that a version define of that package meets");
            foreach (PipelineVersion version in PipelineVersion.All)
                foreach (bool editor in new[] { false, true })
                    Examine(adapter, version, editor, types, members, findings);
        }

        static void Examine(AdapterDefinition adapter, PipelineVersion version, bool editor, ISet<string> types, ISet<string> members,
            Findings findings)
        {
            PipelineAssemblies stands = PipelineAssemblies.Of(version);
            byte[] image = stands.CompileAdapter(adapter, editor, out List<string> errors);
            if (image == null && errors.Count == 0)
            {
                findings.Fault($"{adapter.Name} is not compiled in {version}: its version define or constraint does not hold");
                return;
            }
            foreach (string error in errors)
                findings.Fault($"{version}{(editor ? ", in the editor" : "")}: {error}");
            if (image == null)
                return;

            IReadOnlyList<ApiCatalog> unity = UnityCatalogs.All.Where(catalog => catalog.Version == version.ListedAs).ToList();
            using (var assembly = new CompiledAssembly(new MemoryStream(image)))
            {
                Func<string, string, bool> isKnown = version.HasCompatibilityPath ? IsCompatibilityPath : null;
                UnityMembersRule.Examine(assembly, unity, types, members, findings, isKnown);
                NetStandardRule.Examine(assembly, new HashSet<string>(), new HashSet<string>(), findings);
            }
            var options = new CSharpParseOptions(LanguageVersion.CSharp9, preprocessorSymbols: adapter.Defines(version, editor));
            IEnumerable<SyntaxTree> trees = adapter.Sources.Select(file =>
                CSharpSyntaxTree.ParseText(SourceText.From(File.ReadAllText(file), Encoding.UTF8), options, file));
            CSharpCompilation compilation = CSharpCompilation.Create(adapter.Name, trees, stands.ReferencesOf(adapter, editor),
                new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
            List<CompiledAssembly> offering = stands.Images.Values.Select(offered => new CompiledAssembly(new MemoryStream(offered))).ToList();
            offering.Add(new CompiledAssembly(typeof(UnityEngine.Object).Assembly.Location));
            SourceNamesRule.Examine(compilation, SourceNamesRule.ConstantNames(offering), unity, new HashSet<string>(), findings);
        }

        static bool IsCompatibilityPath(string what, string complaint) => complaint == "has it as obsolete"
            && CompatibilityPath.Any(member => what.Contains(member, StringComparison.Ordinal));
    }
}
