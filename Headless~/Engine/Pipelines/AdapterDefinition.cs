using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Host.Scripts.Assemblies;
using Host.Shaders;

namespace Host.Pipelines
{
    /// <summary>An .asmdef of the package that is compiled where a render pipeline's package is installed.</summary>
    sealed class AdapterDefinition
    {
        public string File { get; private init; }
        public string Name { get; private init; }
        public IReadOnlyList<string> Constraints { get; private init; }
        readonly List<VersionDefine> defines = new();

        public string Folder => Path.GetDirectoryName(File);

        /// <summary>Its sources.</summary>
        public IEnumerable<string> Sources => Directory.EnumerateFiles(Folder, "*.cs", SearchOption.AllDirectories).OrderBy(file => file, StringComparer.Ordinal);

        public static AdapterDefinition Read(string file)
        {
            using JsonDocument json = JsonDocument.Parse(System.IO.File.ReadAllText(file));
            JsonElement root = json.RootElement;
            var read = new AdapterDefinition
            {
                File = file, Name = root.GetProperty("name").GetString(),
                Constraints = root.GetProperty("defineConstraints").EnumerateArray().Select(value => value.GetString()).ToList(),
            };
            read.defines.AddRange(root.GetProperty("versionDefines").EnumerateArray().Select(define =>
                new VersionDefine(define.GetProperty("name").GetString(), define.GetProperty("expression").GetString(), define.GetProperty("define").GetString())));
            return read;
        }

        /// <summary>All symbols with which the editor compiles it; null where it does not compile it at all.</summary>
        /// <param name="version">Of the pipeline's package, whichever it asks for; null: the project has none.</param>
        public List<string> Defines(PipelineVersion version, bool editor)
        {
            var all = version == null ? new List<string>() : version.Defines(editor).ToList();
            if (version != null)
                all.AddRange(defines.Where(define => PipelineKind.All.Any(kind => kind.Package == define.Resource) && VersionRange.Contains(define.Expression, version.Package)).Select(define => define.Define));
            return Scripts.Assemblies.Defines.Hold(Constraints, all) ? all : null;
        }
    }
}
