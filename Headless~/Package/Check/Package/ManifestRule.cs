using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Check
{
    /// <summary>package.json as the Package Manager reads it, and the change log and sample folders that it speaks of.</summary>
    /// <remarks>Unity's manual, "Package manifest" and "Creating samples for packages".</remarks>
    sealed class ManifestRule : Rule
    {
        static readonly Regex PackageName = new(@"^[a-z0-9][a-z0-9\-_]*(\.[a-z0-9\-_]+){2,}$");
        static readonly Regex SemanticVersion = new(@"^(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)(-[0-9A-Za-z\-.]+)?(\+[0-9A-Za-z\-.]+)?$");
        static readonly Regex EditorVersion = new(@"^\d{4}\.\d+$");
        static readonly Regex Released = new(@"^## \[(?<version>[^\]]+)\] - (?<date>\d{4}-\d{2}-\d{2})\s*$");

        public override string Name => "package: package.json, change log and samples agree";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            PackageManifest manifest = PackageManifest.Read(package, findings);
            if (manifest == null)
                return findings;
            CheckFields(manifest, findings);
            CheckChangeLog(package, manifest, findings);
            CheckSamples(package, manifest, findings);
            findings.Looked = $"version {manifest.Version}, {manifest.Samples.Count} samples, {manifest.Dependencies.Count} dependencies";
            return findings;
        }

        static void CheckFields(PackageManifest manifest, Findings findings)
        {
            void Matches(string key, Regex form, string example)
            {
                if (!manifest.Texts.TryGetValue(key, out string value))
                    findings.Fault($"package.json has no \"{key}\", as in \"{example}\"");
                else if (!form.IsMatch(value))
                    findings.Fault($"package.json: \"{key}\" is \"{value}\", which is not of the form \"{example}\"");
            }
            Matches("name", PackageName, "com.company.package");
            Matches("version", SemanticVersion, "1.2.3");
            Matches("unity", EditorVersion, "2022.3");
            foreach (string key in new[] { "displayName", "description", "license" })
                if (string.IsNullOrWhiteSpace(manifest.Texts.GetValueOrDefault(key)))
                    findings.Fault($"package.json has no \"{key}\", which the Package Manager shows");
            foreach ((string name, string version) in manifest.Dependencies)
                if (!SemanticVersion.IsMatch(version))
                    findings.Fault($"package.json: the dependency {name} has the version \"{version}\"; packages may depend on plain " +
                        $"versions only, as in \"1.2.3\"");
        }

        static void CheckChangeLog(PackageTree package, PackageManifest manifest, Findings findings)
        {
            const string file = "CHANGELOG.md";
            if (!package.Has(file))
            {
                findings.Fault($"{file} is missing");
                return;
            }
            string[] versions = package.Read(file).Split('\n').Where(line => line.StartsWith("## ", StringComparison.Ordinal)).ToArray();
            string top = versions.FirstOrDefault(line => !line.StartsWith("## [Unreleased]", StringComparison.Ordinal));
            if (top == null && versions.Length > 0)     // nothing was released yet
                return;
            Match match = Released.Match((top ?? "").TrimEnd('\r'));
            if (!match.Success)
                findings.Fault($"{file}: its first version is \"{top}\", not of the form \"## [1.2.3] - 2026-01-31\"");
            else if (match.Groups["version"].Value != manifest.Version)
                findings.Fault(
                    $"{file} begins with version {match.Groups["version"].Value}, package.json has {manifest.Version}: bring them together");
        }

        static void CheckSamples(PackageTree package, PackageManifest manifest, Findings findings)
        {
            HashSet<string> folders = package.Files.Where(f => f.StartsWith("Samples~/", StringComparison.Ordinal))
                .Select(f => string.Join('/', f.Split('/').Take(2))).Where(f => Directory.Exists(package.FullPath(f))).ToHashSet();
            foreach (PackageSample sample in manifest.Samples)
            {
                if (sample.DisplayName.Length == 0 || sample.Description.Length == 0)
                    findings.Fault($"package.json: the sample at \"{sample.Path}\" needs a displayName and a description");
                if (!folders.Remove(sample.Path))
                    findings.Fault($"package.json: the sample \"{sample.DisplayName}\" lies at \"{sample.Path}\", but it has no such " +
                        $"folder, or it is listed twice");
                else if (!package.Files.Any(f => f.StartsWith(sample.Path + "/", StringComparison.Ordinal)
                    && f.EndsWith(".unity", StringComparison.Ordinal)))
                    findings.Fault($"{sample.Path} has no scene");
            }
            foreach (string folder in folders.OrderBy(f => f, StringComparer.Ordinal))
                findings.Fault($"{folder} is not among the samples of package.json, so no one can import it");
        }
    }
}
