using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Host.Scripts.Assemblies;
using Host.Shaders;

namespace Host.Pipelines
{
    /// <summary>An .asmdef of a package that is compiled where a render pipeline's package is installed.</summary>
    sealed class AdapterDefinition
    {
        public string File { get; private init; }
        public string Name { get; private init; }
        public IReadOnlyList<string> Constraints { get; private init; }
        /// <summary>Assemblies that it refers to, those of the pipelines left out.</summary>
        public IReadOnlyList<string> References { get; private init; }
        readonly List<VersionDefine> defines = new();

        public string Folder => Path.GetDirectoryName(File);

        /// <summary>Its sources.</summary>
        public IEnumerable<string> Sources => Directory.EnumerateFiles(Folder, "*.cs", SearchOption.AllDirectories)
            .OrderBy(file => file, StringComparer.Ordinal);

        public static AdapterDefinition Read(string file)
        {
            using JsonDocument json = JsonDocument.Parse(System.IO.File.ReadAllText(file));
            JsonElement root = json.RootElement;
            IEnumerable<string> references = Texts(root, "references");
            var read = new AdapterDefinition
            {
                File = file, Name = root.GetProperty("name").GetString(),
                Constraints = Texts(root, "defineConstraints").ToList(),
                References = references.Where(name => !name.StartsWith(PipelineAssemblies.Prefix, StringComparison.Ordinal)).ToList(),
            };
            read.defines.AddRange(root.GetProperty("versionDefines").EnumerateArray().Select(define =>
                new VersionDefine(define.GetProperty("name").GetString(), define.GetProperty("expression").GetString(),
                define.GetProperty("define").GetString())));
            return read;
        }

        static IEnumerable<string> Texts(JsonElement of, string name) => of.GetProperty(name).EnumerateArray().Select(value => value.GetString());

        /// <summary>The adapter of a package to a pipeline: the assembly definition below Runtime that is compiled by a version of the
        /// pipeline's package. Null where there is none.</summary>
        public static AdapterDefinition Find(string root, PipelineKind kind)
        {
            string runtime = root == null ? null : Path.Combine(root, "Runtime");
            return !Directory.Exists(runtime) ? null : Directory.EnumerateFiles(runtime, "*.asmdef", SearchOption.AllDirectories)
                .OrderBy(file => file, StringComparer.Ordinal)
                .Where(file => System.IO.File.ReadAllText(file).Contains(kind.Package, StringComparison.Ordinal)).Select(Read).FirstOrDefault();
        }

        /// <summary>All symbols with which the editor compiles it; null where it does not compile it at all.</summary>
        /// <param name="version">Of the pipeline's package, whichever it asks for; null: the project has none.</param>
        public List<string> Defines(PipelineVersion version, bool editor)
        {
            var all = version == null ? new List<string>() : version.Defines(editor).ToList();
            if (version != null)
                all.AddRange(defines.Where(define => PipelineKind.All.Any(kind => kind.Package == define.Resource)
                    && VersionRange.Contains(define.Expression, version.Package)).Select(define => define.Define));
            return Scripts.Assemblies.Defines.Hold(Constraints, all) ? all : null;
        }
    }
}
