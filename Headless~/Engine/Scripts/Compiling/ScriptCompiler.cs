using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using Host.Assets;
using Host.Scripts.Assemblies;
using Host.Scripts.Stubs;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Emit;
using Microsoft.CodeAnalysis.Text;

namespace Host.Scripts.Compiling
{
    /// <summary>
    /// Compiles a plan's assemblies against the host, as Unity's C# 9 for .NET Standard 2.1. Scripts with errors are left out one
    /// after another until the rest compiles: a member that the host lacks must not take the whole project away. Errors of syntax
    /// are errors in Unity too, and stop everything as they do there.
    /// </summary>
    internal sealed class ScriptCompiler
    {
        readonly ProjectIndex index;
        readonly StubAssembly stubs;
        readonly IReadOnlyDictionary<string, Assembly> hosted;
        readonly string hostKey;
        readonly Dictionary<ScriptAssembly, CompiledAssembly> done = new Dictionary<ScriptAssembly, CompiledAssembly>();
        public readonly List<string> Notes = new List<string>();

        /// <param name="hosted">The host's assemblies by name; UnityEngine is one of them.</param>
        public ScriptCompiler(ProjectIndex index, StubAssembly stubs, IReadOnlyDictionary<string, Assembly> hosted)
        {
            this.index = index;
            this.stubs = stubs;
            this.hosted = hosted;
            hostKey = ScriptCache.Key(hosted.Values.Select(a => a.ManifestModule.ModuleVersionId.ToString())
                .Append(typeof(ScriptCompiler).Module.ModuleVersionId.ToString()).Append(stubs.File).ToArray());
        }

        public CompiledAssembly Compile(ScriptAssembly assembly)
        {
            var response = ResponseOf(assembly);
            foreach (var unknown in response?.Unknown ?? new List<string>())
                Notes.Add($"{assembly.Name}: the option {unknown} of csc.rsp is not taken over");
            var sources = assembly.Files.Select(f => (file: f, text: File.ReadAllText(f.File))).ToList();
            var defines = assembly.Defines.Concat(response?.Defines ?? new List<string>()).Distinct()
                .OrderBy(d => d, StringComparer.Ordinal).ToList();

            var parts = new List<string> { assembly.Name, hostKey, string.Join(";", defines), assembly.AllowUnsafe.ToString(),
                assembly.NoEngineReferences.ToString(), response?.Language + response?.Unsafe + response?.Nullable };
            parts.AddRange(assembly.Hosted);
            parts.AddRange(assembly.References.Select(r => done[r].Key));
            parts.AddRange(assembly.Plugins.Select(p => p.Path
                + Convert.ToHexString(System.Security.Cryptography.SHA256.HashData(File.ReadAllBytes(p.File)))));
            foreach (var (file, text) in sources)
            {
                parts.Add(file.Path);
                parts.Add(text);
            }
            var key = ScriptCache.Key(parts.ToArray());
            var folder = ScriptCache.Folder(assembly.Name, key, into => Make(into, assembly, response, defines, sources));
            return done[assembly] = CompiledAssembly.In(folder, assembly.Name, key, sources.Count);
        }

        ResponseFile ResponseOf(ScriptAssembly assembly)
        {
            var beside = assembly.Definition == null ? "Assets/csc.rsp"
                : assembly.Definition.Substring(0, assembly.Definition.LastIndexOf('/')) + "/csc.rsp";
            return index.ByPath(beside) is AssetEntry entry ? ResponseFile.Read(entry) : null;
        }

        void Make(string folder, ScriptAssembly assembly, ResponseFile response, List<string> defines, List<(AssetEntry file, string text)> sources)
        {
            var language = LanguageVersion.CSharp9;
            if (response?.Language != null && LanguageVersionFacts.TryParse(response.Language, out var asked)) language = asked;
            var parsing = new CSharpParseOptions(language, DocumentationMode.None, preprocessorSymbols: defines);
            var trees = sources.Select(s => CSharpSyntaxTree.ParseText(SourceText.From(s.text, Encoding.UTF8), parsing, s.file.Path)).ToList();
            RefuseBadSyntax(assembly, trees.SelectMany(t => t.GetDiagnostics()));

            var options = new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: assembly.AllowUnsafe
                || response?.Unsafe == true, optimizationLevel: OptimizationLevel.Release,
                warningLevel: 0, deterministic: true, nullableContextOptions: response?.Nullable == true ? NullableContextOptions.Enable
                    : NullableContextOptions.Disable);
            var compilation = CSharpCompilation.Create(assembly.Name, trees, ReferencesOf(assembly), options);
            RefuseBadSyntax(assembly, compilation.GetDeclarationDiagnostics().Where(d => d.Id == NewerLanguage));
            var leftOut = LeaveOut(ref compilation);

            using (var file = File.Create(Path.Combine(folder, assembly.Name + ".dll")))
            {
                var result = compilation.Emit(file, options: new EmitOptions(debugInformationFormat: DebugInformationFormat.Embedded));
                if (!result.Success) throw new ScriptException($"the assembly {assembly.Name} cannot be compiled: " +
                    $"{result.Diagnostics.First(d => d.Severity == DiagnosticSeverity.Error)}");
            }
            CompiledAssembly.WriteLeftOut(folder, leftOut);
        }

        // "Feature ... is not available in C# 9.0": some features are found out after parsing.
        const string NewerLanguage = "CS8773";

        static void RefuseBadSyntax(ScriptAssembly assembly, IEnumerable<Diagnostic> said)
        {
            const int shown = 10;
            var errors = said.Where(d => d.Severity == DiagnosticSeverity.Error).ToList();
            if (errors.Count == 0) return;
            throw new ScriptException($"{assembly.Name} has errors of syntax, which stop Unity " +
                $"too:\n{string.Join("\n", errors.Take(shown).Select(Said))}{(errors.Count > shown ? $"\nand {errors.Count - shown} more" : "")}");
        }

        static List<LeftOutFile> LeaveOut(ref CSharpCompilation compilation)
        {
            var leftOut = new List<LeftOutFile>();
            // Declarations of the left-out files: others that need them are left out because of them, and should report it.
            var gone = new Dictionary<string, string>();
            while (true)
            {
                var errors = compilation.GetDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error).ToList();
                if (errors.Count == 0) return leftOut;
                var bad = errors.Where(e => e.Location.SourceTree != null).GroupBy(e => e.Location.SourceTree).ToList();
                if (bad.Count == 0) return leftOut;     // no file is to blame; emitting throws what it is
                foreach (var file in bad)
                {
                    var first = file.OrderBy(e => e.Location.SourceSpan.Start).First();
                    var because = gone.FirstOrDefault(g => first.GetMessage().Contains("'" + g.Key + "'", StringComparison.Ordinal)).Value;
                    leftOut.Add(new LeftOutFile(file.Key.FilePath,
                        Said(first) + (because != null ? $" (it was in {because}{LeftOutFile.BecauseOfAnother}" : Hints.Of(first))));
                }
                foreach (var file in bad)
                    foreach (var declared in file.Key.GetRoot().DescendantNodes().OfType<BaseTypeDeclarationSyntax>())
                        gone.TryAdd(declared.Identifier.Text, file.Key.FilePath);
                compilation = compilation.RemoveSyntaxTrees(bad.Select(b => b.Key));
            }
        }

        static string Said(Diagnostic error)
        {
            var at = error.Location.GetLineSpan().StartLinePosition;
            return $"{error.Location.SourceTree.FilePath}({at.Line + 1},{at.Character + 1}): error {error.Id}: {error.GetMessage()}";
        }

        List<MetadataReference> ReferencesOf(ScriptAssembly assembly)
        {
            var all = new List<MetadataReference>(References.Standard);
            void Add(string file) => all.Add(MetadataReference.CreateFromFile(file));
            if (!assembly.NoEngineReferences)
            {
                foreach (var engine in StubAssembly.Engine) Add(hosted[engine].Location);
                Add(stubs.File);
            }
            foreach (var name in assembly.Hosted.Distinct())
                if (name == StubAssembly.UserInterface) Add(stubs.UserInterfaceFile);
                else if (!StubAssembly.Engine.Contains(name)) Add(hosted[name].Location);
            foreach (var reference in assembly.References.Distinct()) Add(done[reference].File);
            foreach (var plugin in assembly.Plugins) Add(plugin.File);
            return all;
        }
    }
}
