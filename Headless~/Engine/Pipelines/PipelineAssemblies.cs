using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.Loader;
using System.Text;
using Host.Scripts.Compiling;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Emit;
using Microsoft.CodeAnalysis.Text;

namespace Host.Pipelines
{
    /// <summary>The stand-ins of one version, compiled, and what is compiled against them.</summary>
    sealed class PipelineAssemblies
    {
        /// <summary>Prefix of the names of the pipelines' assemblies.</summary>
        public const string Prefix = "Unity.RenderPipelines.";

        const string Core = Prefix + "Core.Runtime";

        static readonly Dictionary<PipelineVersion, PipelineAssemblies> made = new();

        readonly List<MetadataReference> references = new();
        readonly Dictionary<string, byte[]> images = new();

        public PipelineVersion Version { get; }

        /// <summary>Images of the stand-ins, by name.</summary>
        public IReadOnlyDictionary<string, byte[]> Images => images;

        PipelineAssemblies(PipelineVersion version)
        {
            Version = version;
            references.AddRange(Scripts.Compiling.References.Standard);
            references.Add(MetadataReference.CreateFromFile(typeof(UnityEngine.Object).Assembly.Location));
            Make(Core, "Core/");
            foreach (PipelineKind kind in PipelineKind.All)
                Make(kind.Assembly, kind.Folder + "/");
        }

        /// <summary>Compiled once in a process.</summary>
        public static PipelineAssemblies Of(PipelineVersion version)
        {
            lock (made)
                return made.TryGetValue(version, out PipelineAssemblies found) ? found : made[version] = new PipelineAssemblies(version);
        }

        void Make(string name, string folder)
        {
            Assembly here = typeof(PipelineAssemblies).Assembly;
            string prefix = "sources/" + folder;
            IEnumerable<(string, string)> sources = here.GetManifestResourceNames()
                .Where(resource => resource.Replace('\\', '/').StartsWith(prefix, StringComparison.Ordinal)).OrderBy(resource => resource,
                StringComparer.Ordinal).Select(resource =>
            {
                using var reader = new StreamReader(here.GetManifestResourceStream(resource));
                return (resource, reader.ReadToEnd());
            });
            byte[] image = Compile(name, sources.Append(("friends.cs", Friends(name))), Version.StandInDefines, references, out List<string> errors);
            if (image == null)
                throw new InvalidOperationException($"the stand-in {name} of {Version} does not compile:\n{string.Join("\n", errors)}");
            images.Add(name, image);
            references.Add(MetadataReference.CreateFromImage(image));
        }

        static string Friends(string name) => name == Core
            ? string.Concat(PipelineKind.All.Select(kind =>
            $"[assembly: System.Runtime.CompilerServices.InternalsVisibleTo(\"{kind.Assembly}\")]")) : "";

        // References of an adapter beside the pipeline.
        static IEnumerable<MetadataReference> OfPackage(AdapterDefinition adapter, bool editor)
            => adapter.References.Append("Unity.Mathematics").Concat(editor ? new[] { "UnityEditor" } : Array.Empty<string>()).Distinct()
            .Select(name => MetadataReference.CreateFromFile(FileOf(name)));

        /// <summary>Beside the host, or where the build puts each.</summary>
        static string FileOf(string name)
        {
            string here = Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory);
            return new[] { here, Path.Combine(here, "..", "..", name, Path.GetFileName(here)) }.Select(folder =>
                Path.GetFullPath(Path.Combine(folder, name + ".dll"))).FirstOrDefault(File.Exists)
                ?? throw new InvalidOperationException(
                    $"{name}.dll is not in {here} nor where the build puts it: build Headless~/Headless.proj, or run through Headless~/rill");
        }

        /// <summary>References that an adapter is compiled against.</summary>
        public IReadOnlyList<MetadataReference> ReferencesOf(AdapterDefinition adapter, bool editor)
            => references.Concat(OfPackage(adapter, editor)).ToList();

        /// <summary>The adapter as that editor compiles it; null where it does not.</summary>
        /// <param name="errors">The compiler's, with file and line.</param>
        public byte[] CompileAdapter(AdapterDefinition adapter, bool editor, out List<string> errors)
        {
            errors = new List<string>();
            List<string> defines = adapter.Defines(Version, editor);
            return defines == null ? null : Compile(adapter.Name, adapter.Sources.Select(file => (file, File.ReadAllText(file))), defines,
                ReferencesOf(adapter, editor), out errors);
        }

        /// <summary>Sources of a test, as scripts of a project with this pipeline.</summary>
        public byte[] CompileScripts(string name, string source, out List<string> errors) =>
            Compile(name, new[] { (name + ".cs", source) }, Version.Defines(false), references, out errors);

        static byte[] Compile(string name, IEnumerable<(string File, string Text)> sources, IEnumerable<string> defines,
            IEnumerable<MetadataReference> references, out List<string> errors)
        {
            var language = new CSharpParseOptions(LanguageVersion.CSharp9, preprocessorSymbols: defines);
            var trees = sources.Select(source => CSharpSyntaxTree.ParseText(SourceText.From(source.Text, Encoding.UTF8), language, source.File));
            // Warns like Unity, where a warning of the compiler stands in the user's console: the package has none.
            var options = new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Release,
                deterministic: true, warningLevel: 4,
                specificDiagnosticOptions: new Dictionary<string,
                    ReportDiagnostic> { ["CS0649"] = ReportDiagnostic.Suppress, ["CS1701"] = ReportDiagnostic.Suppress,
                    ["CS1702"] = ReportDiagnostic.Suppress });
            CSharpCompilation compilation = CSharpCompilation.Create(name, trees, references, options);
            using var image = new MemoryStream();
            EmitResult result = compilation.Emit(image, options: new EmitOptions(debugInformationFormat: DebugInformationFormat.Embedded));
            errors = result.Diagnostics.Where(said => said.Severity >= DiagnosticSeverity.Warning).Select(said =>
            {
                FileLinePositionSpan at = said.Location.GetLineSpan();
                return $"{at.Path}({at.StartLinePosition.Line + 1}): {said.Severity.ToString().ToLowerInvariant()} {said.Id}: {said.GetMessage()}";
            }).ToList();
            return result.Success ? image.ToArray() : null;
        }
    }

    /// <summary>Stand-ins and what was compiled against them, loaded beside the host: of one version.</summary>
    sealed class PipelineContext : AssemblyLoadContext
    {
        readonly Dictionary<string, Assembly> loaded = new();

        public PipelineContext(PipelineAssemblies assemblies) : base("render pipelines " + assemblies.Version.Name)
        {
            foreach ((string name, byte[] image) in assemblies.Images)
                Add(name, image);
        }

        public Assembly Add(string name, byte[] image) => loaded[name] = LoadFromStream(new MemoryStream(image));

        public Assembly this[string name] => loaded[name];

        protected override Assembly Load(AssemblyName name) => loaded.TryGetValue(name.Name, out Assembly found) ? found : null;
    }
}
