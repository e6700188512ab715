using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using Host.Scripts.Compiling;
using Host.UnityApi;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Text;

namespace Host.Scripts.Stubs
{
    /// <summary>
    /// The assembly of stubs: what Unity 2022.3 has and the host lacks, compiled once and kept. Lines of the lists that
    /// are no C# by themselves are left out one by one, by what the compiler says of them.
    /// </summary>
    internal sealed class StubAssembly
    {
        public const string Name = "UnityEngine.Stubs", UserInterface = "UnityEngine.UI";
        /// <summary>Assemblies that every script of the engine sees.</summary>
        public static readonly string[] Engine = { "UnityEngine", "UnityEngine.PhysicsModule" };

        const string Version = "2022.3", Revision = "1";
        const int Rounds = 25;

        /// <summary>UnityEngine.Stubs.dll, and UnityEngine.UI.dll for projects with com.unity.ugui.</summary>
        public readonly string File, UserInterfaceFile;
        public readonly int Types, Members, Dropped;
        /// <summary>Code that the compiler refused and Sources/fixes.txt does not list yet.</summary>
        public readonly IReadOnlyList<string> Refused;

        StubAssembly(string folder)
        {
            File = Path.Combine(folder, Name + ".dll");
            UserInterfaceFile = Path.Combine(folder, UserInterface + ".dll");
            var lines = System.IO.File.ReadAllLines(Path.Combine(folder, "counts.txt"));
            var counts = lines[0].Split(' ').Select(int.Parse).ToArray();
            Refused = lines.Skip(1).ToList();
            (Types, Members, Dropped) = (counts[0], counts[1], counts[2]);
        }

        /// <summary>The assemblies whose types need no stubs.</summary>
        public static readonly IReadOnlyList<Assembly> Host = new[] { typeof(UnityEngine.Object).Assembly, typeof(UnityEngine.Physics).Assembly,
            typeof(Unity.Mathematics.math).Assembly };

        public static StubAssembly Get()
        {
            var host = Host;
            var key = ScriptCache.Key(host.Select(a => a.ManifestModule.ModuleVersionId.ToString())
                .Append(typeof(UnityApiLists).Module.ModuleVersionId.ToString())
                .Append(typeof(StubAssembly).Module.ModuleVersionId.ToString()).Append(Revision).ToArray());
            return new StubAssembly(ScriptCache.Folder("stubs", key, folder => Make(folder, host)));
        }

        static void Make(string folder, IReadOnlyList<Assembly> host)
        {
            var sources = new StubSources(UnityApiLists.Load().In(Version), host);
            Fixes.Apply(sources, References.Source("fixes.txt").Split('\n'));
            var maker = new StubCompilation(sources, host);
            // The compiler's refusals at the time of writing are known; a host with other types may bring up more.
            var file = Path.Combine(folder, Name + ".dll");
            if (!TryEmit(maker.Compilation, file, out _))
            {
                maker.Settle(Rounds);
                Emit(maker.Compilation, file);
            }

            var ui = CSharpCompilation.Create(UserInterface,
                new[] { CSharpSyntaxTree.ParseText(References.Source("UnityEngine.UI.cs"), StubCompilation.Language, "UnityEngine.UI.cs") },
                maker.Compilation.References.Append(MetadataReference.CreateFromFile(file)), StubCompilation.Options);
            Emit(ui, Path.Combine(folder, UserInterface + ".dll"));
            var all = sources.Types.SelectMany(t => t.WithNested()).ToList();
            System.IO.File.WriteAllLines(Path.Combine(folder, "counts.txt"), new[] { $"{all.Count(t => !t.Dropped)} " +
                $"{all.Sum(t => t.Members.Count(m => !m.Dropped))} {all.Sum(t => t.Members.Count(m => m.Dropped))}" }.Concat(
                maker.Refused));
            System.IO.File.WriteAllLines(Path.Combine(folder, "fixes.txt"), Fixes.Of(sources));
        }

        static bool TryEmit(CSharpCompilation compilation, string file, out IEnumerable<Diagnostic> errors)
        {
            using var stream = System.IO.File.Create(file);
            var result = compilation.Emit(stream);
            errors = result.Diagnostics.Where(d => d.Severity == DiagnosticSeverity.Error);
            return result.Success;
        }

        static void Emit(CSharpCompilation compilation, string file)
        {
            if (!TryEmit(compilation, file, out var errors))
                throw new ScriptException($"the host's own stubs do not compile: {string.Join("; ", errors.Take(5))}");
        }
    }

    /// <summary>The stubs' sources under the compiler until nothing is refused any more.</summary>
    internal sealed class StubCompilation
    {
        public static readonly CSharpParseOptions Language = new CSharpParseOptions(LanguageVersion.CSharp9);
        public static readonly CSharpCompilationOptions Options = new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: true,
            optimizationLevel: OptimizationLevel.Release, warningLevel: 0, deterministic: true, generalDiagnosticOption: ReportDiagnostic.Default);

        readonly Dictionary<SyntaxTree, (StubType type, List<object> lines)> trees = new Dictionary<SyntaxTree, (StubType, List<object>)>();
        readonly string usings;
        public CSharpCompilation Compilation;
        public readonly List<string> Refused = new List<string>();

        public StubCompilation(StubSources sources, IReadOnlyList<Assembly> host)
        {
            // The lists write names as their files did, which had usings of their own: here all namespaces are open.
            var spaces = sources.Types.Select(StubSources.NamespaceOf)
                .Concat(host.SelectMany(a => a.GetExportedTypes()).Select(t => t.Namespace ?? "")).Distinct()
                .Where(s => s.StartsWith("UnityEngine", StringComparison.Ordinal) || s.StartsWith("Unity.", StringComparison.Ordinal));
            usings = string.Concat(new[] { "System", "System.Collections", "System.Collections.Generic", "System.Reflection",
                "System.Threading", "System.Threading.Tasks", "System.Text", "UnityEngine", "UnityEngine.Rendering", "UnityEngine.Events",
                "UnityEngine.SceneManagement", "UnityEngine.Experimental.Rendering", "Unity.Collections" }
                .Concat(spaces).Distinct().Select(s => $"using {s};")) + "using Object = UnityEngine.Object; using Random = " +
                    "UnityEngine.Random; using MinMaxCurve = UnityEngine.ParticleSystem.MinMaxCurve; using MinMaxGradient = " +
                    "UnityEngine.ParticleSystem.MinMaxGradient; using ThreadPriority = UnityEngine.ThreadPriority; using " +
                    "DebugScreenCapture = Unity.Profiling.DebugScreenCapture;";
            foreach (var type in sources.Types) Write(type);
            Compilation = CSharpCompilation.Create(StubAssembly.Name,
                trees.Keys.Append(CSharpSyntaxTree.ParseText(References.Source("StubCalls.cs"), Language)),
                References.Standard.Concat(host.Select(a => MetadataReference.CreateFromFile(a.Location))), Options);
        }

        SyntaxTree Write(StubType type)
        {
            var text = new StringBuilder(usings).Append("namespace ").Append(StubSources.NamespaceOf(type)).Append(" {\n");
            var lines = new List<object> { null };
            var outermost = type.FullName.Split('<')[0];
            type.Write(text, lines, StubManners.Of(outermost), false);
            text.Append("}\n");
            var tree = CSharpSyntaxTree.ParseText(SourceText.From(text.ToString()), Language, outermost);
            trees.Add(tree, (type, lines));
            return tree;
        }

        public void Settle(int rounds)
        {
            for (var round = 0; round < rounds; round++)
            {
                var errors = Compilation.GetParseDiagnostics().Concat(Compilation.GetDeclarationDiagnostics())
                    .Where(d => d.Severity == DiagnosticSeverity.Error && d.Location.SourceTree != null).ToList();
                if (errors.Count == 0)
                {
                    // Bodies are looked at last: what they say is about members whose declarations are already good.
                    errors = Compilation.GetDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error
                        && d.Location.SourceTree != null).ToList();
                    if (errors.Count == 0) return;
                }
                var touched = new HashSet<SyntaxTree>();
                var blamed = new HashSet<object>();
                foreach (var error in errors)
                    if (trees.TryGetValue(error.Location.SourceTree, out var source))
                    {
                        touched.Add(error.Location.SourceTree);
                        var at = source.lines[Math.Min(error.Location.GetLineSpan().StartLinePosition.Line, source.lines.Count - 1)];
                        if (at != null && blamed.Add(at)) Mend(at, error);
                    }
                if (touched.Count == 0) return;     // what is left is not about the stubs; emitting says it
                foreach (var old in touched)
                {
                    var type = trees[old].type;
                    trees.Remove(old);
                    Compilation = Compilation.ReplaceSyntaxTree(old, Write(type));
                }
            }
        }

        void Mend(object what, Diagnostic error)
        {
            if (what is StubMember member)
            {
                if (member.CanBeConstrained && error.Id is "CS0453" or "CS0208" or "CS8377" or "CS8337") member.ValueTypesOnly = true;
                else Refuse(error, () => member.Dropped = true);
                return;
            }
            var type = (StubType)what;
            var text = error.Location.SourceTree.GetText();
            var span = text.ToString(error.Location.SourceSpan);
            var culprit = type.Bases.FirstOrDefault(b => b == span || b.EndsWith("." + span, StringComparison.Ordinal)
                || b.StartsWith(span + "<", StringComparison.Ordinal) || Regex.IsMatch(b, $@"\b{Regex.Escape(span)}\b"));
            if (error.Id == "CS0534" && !type.ForcedAbstract) type.ForcedAbstract = true;
            else if (culprit != null && type.ShortName != span) Refuse(error, () => type.Without(culprit));
            else if (type.Bases.Count > 0) Refuse(error, () => type.Without(type.Bases[type.Bases.Count - 1]));
            else Refuse(error, () => type.Dropped = true);
        }

        void Refuse(Diagnostic error, Action leaveOut)
        {
            leaveOut();
            Refused.Add($"{error.Location.SourceTree.FilePath}: {error.Id} {error.GetMessage()}: " +
                $"{error.Location.SourceTree.GetText().Lines[error.Location.GetLineSpan().StartLinePosition.Line]}");
        }
    }
}
