using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Text;

namespace Host.Check
{
    /// <summary>The rooms of assembly Rill: folders of Runtime, each compiled as an assembly of its own that knows only those before it.</summary>
    /// <remarks>Unity and the host compile all of them as one assembly, since scenes and events store its name.</remarks>
    sealed class Rooms
    {
        /// <summary>Rooms of the package, from the lowest to the highest.</summary>
        public static readonly IReadOnlyList<string> OfRill = new[]
        {
            "Core", "Stages", "Gpu", "Gpu/Device", "Baking", "Solver", "Simulation", "Components", "Rendering", "Recording",
        };

        const string Root = "Runtime/", Assembly = "Rill.";
        const int MaxFaults = 20;

        readonly IReadOnlyList<string> order;
        readonly List<HashSet<int>> uses = new();

        /// <summary>Files that lie in a room.</summary>
        public int Files { get; private set; }

        /// <param name="order">Folders below Runtime, from the lowest to the highest. What lies in a folder and in none within it that is named
        /// too is one room.</param>
        public Rooms(IReadOnlyList<string> order) => this.order = order;

        /// <summary>Compiles the rooms one after the other, up to the first that has faults.</summary>
        /// <param name="sources">Paths below the package's root, and texts.</param>
        /// <param name="references">What the whole assembly is compiled against.</param>
        /// <returns>Whether all rooms compile.</returns>
        public bool Compile(IReadOnlyList<(string File, string Text)> sources, IEnumerable<MetadataReference> references, Findings findings)
        {
            var options = new CSharpParseOptions(LanguageVersion.CSharp9,
                preprocessorSymbols: new[] { "UNITY_5_3_OR_NEWER", "UNITY_2022_3", "UNITY_2022_3_OR_NEWER", "UNITY_STANDALONE" });
            foreach ((string file, string _) in sources.Where(source => RoomOf(source.File) < 0))
                findings.Fault($"{file} lies in no room. Put it into one of {string.Join(", ", order)}.");
            string friends = string.Concat(Enumerable.Range(0, order.Count)
                .Select(room => $"[assembly: System.Runtime.CompilerServices.InternalsVisibleTo(\"{NameOf(room)}\")]\n"));
            var known = references.ToList();
            var rooms = new List<MetadataReference>();
            for (int room = 0; room < order.Count; room++)
            {
                List<SyntaxTree> trees = sources.Where(source => RoomOf(source.File) == room)
                    .Select(source => CSharpSyntaxTree.ParseText(SourceText.From(source.Text), options, source.File)).ToList();
                Files += trees.Count;
                trees.Add(CSharpSyntaxTree.ParseText(friends, options));
                CSharpCompilation compilation = CSharpCompilation.Create(NameOf(room), trees, known.Concat(rooms),
                    new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
                List<Diagnostic> errors = compilation.GetDiagnostics().Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error).ToList();
                foreach (Diagnostic error in errors.Take(MaxFaults))
                    findings.Fault($"{error.Location.SourceTree?.FilePath}({error.Location.GetLineSpan().StartLinePosition.Line + 1}): " +
                        $"room {order[room]} does not compile with the rooms before it: {error.GetMessage()} Move what it names down, or itself up.");
                if (errors.Count > 0)
                    return false;
                List<MetadataReference> used = compilation.GetUsedAssemblyReferences().ToList();
                uses.Add(Enumerable.Range(0, room).Where(lower => used.Contains(rooms[lower])).ToHashSet());
                rooms.Add(compilation.ToMetadataReference());
            }
            return true;
        }

        /// <summary>Which room uses which, as a table in Markdown; after <see cref="Compile"/>.</summary>
        public string Matrix()
        {
            IEnumerable<string> rows = Enumerable.Range(0, order.Count).Select(room => $"| `{order[room]}` | " + string.Join(" | ",
                Enumerable.Range(0, order.Count - 1).Select(lower => uses[room].Contains(lower) ? "x" : "")) + " |");
            return string.Join("\n", new[]
            {
                "| uses | " + string.Join(" | ", order.Take(order.Count - 1).Select(name => $"`{name}`")) + " |",
                "| --- |" + string.Concat(Enumerable.Repeat(" --- |", order.Count - 1)),
            }.Concat(rows)) + "\n";
        }

        int RoomOf(string file)
        {
            int room = -1;
            for (int i = 0; i < order.Count; i++)
                if (file.StartsWith(Root + order[i] + "/", StringComparison.Ordinal) && (room < 0 || order[i].Length > order[room].Length))
                    room = i;
            return room;
        }

        string NameOf(int room) => Assembly + order[room].Replace('/', '.');
    }
}
