using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Host.Check
{
    /// <summary>The project in which a user runs the package's tests opens with one click.</summary>
    sealed class TestProjectRule : Rule
    {
        const string Folder = "TestProject~/", Manifest = Folder + "Packages/manifest.json",
            EditorVersion = Folder + "ProjectSettings/ProjectVersion.txt";
        // 2022.3 carries 1.1; the tests are written for 1.4.
        const string Framework = "com.unity.test-framework";
        static readonly Version MinFramework = new(1, 4);
        // Matches the version, twice.
        static readonly Regex Revision = new(@"m_EditorVersion: (\S+)\s+m_EditorVersionWithRevision: \1 \([0-9a-f]{12}\)\s*$");

        public override string Name => "package: the test project opens and runs the tests";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            PackageManifest manifest = PackageManifest.Read(package, findings);
            foreach (string file in new[] { Manifest, EditorVersion }.Where(file => !package.Has(file)))
                findings.Fault($"{file} is missing");
            if (!Directory.Exists(package.FullPath(Folder + "Assets")))
                findings.Fault($"{Folder}Assets is missing: without it Unity does not take the folder for a project");
            if (manifest == null || findings.Faults.Count > 0)
                return findings;

            string version = package.Read(EditorVersion);
            if (!version.Contains($"m_EditorVersion: {manifest.Unity}."))
                findings.Fault($"{EditorVersion} names another editor than package.json's {manifest.Unity}");
            if (!Revision.IsMatch(version))
                findings.Fault($"{EditorVersion} has no m_EditorVersionWithRevision as in \"2022.3.22f1 (887be4894c44)\", by which the Hub " +
                    "offers that editor");
            try
            {
                using JsonDocument json = JsonDocument.Parse(package.Read(Manifest));
                Check(json.RootElement, package, manifest, findings);
            }
            catch (JsonException e)
            {
                findings.Fault($"{Manifest} cannot be read: {e.Message}");
            }
            findings.Looked = version.Split('\n')[0].Trim();
            return findings;
        }

        static void Check(JsonElement root, PackageTree package, PackageManifest manifest, Findings findings)
        {
            string Dependency(string name) => root.TryGetProperty("dependencies", out JsonElement all)
                && all.TryGetProperty(name, out JsonElement one) ? one.GetString() : null;

            string source = Dependency(manifest.Name);
            if (source == null || !source.StartsWith("file:", StringComparison.Ordinal)
                || Path.GetFullPath(Path.Combine(package.FullPath(Folder + "Packages"), source.Substring(5))) != package.Root)
                findings.Fault($"{Manifest}: {manifest.Name} is at \"{source}\", not at \"file:../..\", this package");
            if (!root.TryGetProperty("testables", out JsonElement testables) || testables.EnumerateArray().All(t => t.GetString() != manifest.Name))
                findings.Fault($"{Manifest}: \"testables\" does not name {manifest.Name}, so the Test Runner shows none of its tests");
            string framework = Dependency(Framework);
            if (framework == null || !Version.TryParse(framework, out Version has) || has < MinFramework)
                findings.Fault($"{Manifest}: {Framework} is \"{framework}\"; the tests need {MinFramework} or newer");
        }
    }
}
