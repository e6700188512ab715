using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace Host.Check
{
    /// <summary>The headless engine serves any Unity project: its projects refer to nothing outside of their folder, its code does not name
    /// this package.</summary>
    sealed class EngineRule : Rule
    {
        const string Engine = "Headless~/Engine/", CommonProperties = "Headless~/Directory.Build.props";

        // Names of environment variables, which are the command's, are written in capitals.
        static readonly Regex Package = new(@"\bRill\b");

        public override string Name => "host: the engine knows nothing of the package";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<string> projects = package.Files.Where(file => IsEngine(file) && Path.GetExtension(file) is ".csproj" or ".props").ToList();
            List<string> code = package.Files.Where(file => IsEngine(file) && Path.GetExtension(file) == ".cs").ToList();
            foreach (string project in projects)
                foreach (string path in XDocument.Parse(package.Read(project)).Descendants().SelectMany(Paths))
                    if (Resolve(project, path) is var file && file != CommonProperties && !IsEngine(file))
                        findings.Fault($"{project} refers to {path}, which is not in {Engine}: move what both need into the engine, or " +
                            $"what refers to it into Headless~/Package");
            foreach (string file in code)
            {
                string[] lines = package.Read(file).Split('\n');
                for (int i = 0; i < lines.Length; i++)
                    if (Package.IsMatch(lines[i]))
                        findings.Fault($"{file}({i + 1}) names Rill: let BuiltInPackage ask for it, and the package's half answer");
            }
            if (projects.Count == 0)
                findings.Fault($"{Engine} has no project");
            findings.Looked = $"{code.Count} sources and {projects.Count} project files";
            return findings;
        }

        static bool IsEngine(string file) => file.StartsWith(Engine, StringComparison.Ordinal);

        // Files that a project refers to: packages of NuGet and names of assemblies are not paths.
        static IEnumerable<string> Paths(XElement element)
            => element.Name.LocalName is "PackageReference" or "PackageDownload" or "InternalsVisibleTo" ? Enumerable.Empty<string>()
            : element.Attributes().Where(attribute => attribute.Name.LocalName is "Include" or "Project")
                .SelectMany(attribute => attribute.Value.Split(';'))
                .Where(path => !path.StartsWith("$(NuGetPackageRoot)", StringComparison.Ordinal));

        static string Resolve(string project, string path)
        {
            var parts = new List<string>(project.Split('/').SkipLast(1));
            foreach (string part in path.Replace('\\', '/').Replace("$(PackageRoot)", string.Concat(Enumerable.Repeat("../", parts.Count)))
                .Split('/'))
                if (part == ".." && parts.Count > 0)
                    parts.RemoveAt(parts.Count - 1);
                else if (part.Length > 0 && part != ".")
                    parts.Add(part);
            return string.Join('/', parts);
        }
    }
}
