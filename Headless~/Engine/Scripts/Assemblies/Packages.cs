using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Host.Assets;

namespace Host.Scripts.Assemblies
{
    /// <summary>Which packages a project asks for, which of them are here, and their versions.</summary>
    internal sealed class Packages
    {
        /// <summary>Packages whose assemblies the host stands in for, when the project asks for them.</summary>
        public static readonly IReadOnlyDictionary<string, string> Hosted = new Dictionary<string,
            string> { ["com.unity.mathematics"] = "Unity.Mathematics", ["com.unity.ugui"] = "UnityEngine.UI" };

        static readonly JsonDocumentOptions Lenient = new JsonDocumentOptions { AllowTrailingCommas = true,
            CommentHandling = JsonCommentHandling.Skip };

        const string TestFramework = "com.unity.test-framework";

        // Packages of the Editor alone: a player has nothing of them, so none is missed here.
        static readonly string[] EditorOnly = { TestFramework, "com.unity.ext.nunit", "com.unity.testtools.", "com.unity.ide.",
            "com.unity.collab-proxy", "com.unity.editorcoroutines", "com.unity.performance.profile-analyzer", "com.unity.feature.development" };

        readonly Dictionary<string, string> versions = new Dictionary<string, string>();
        readonly Dictionary<string, string> hosted;
        readonly HashSet<string> testable = new HashSet<string>();

        /// <summary>"com.unity.render-pipelines.universal 14.0.8": asked for and nowhere to be found.</summary>
        public readonly List<string> Missing = new List<string>();

        /// <summary>Packages that are taken from elsewhere than the project asks for.</summary>
        public readonly List<string> Notes = new List<string>();

        /// <param name="tests">The host stands in for the test framework too.</param>
        public Packages(string project, IEnumerable<MountedFolder> mounts, bool tests = false)
        {
            hosted = new Dictionary<string, string>(Hosted);
            if (tests) hosted.Add(TestFramework, TestAssemblies.Runner);
            versions["Unity"] = Defines.UnityVersion;
            var wanted = new Dictionary<string, string>();
            var here = new HashSet<string>();
            foreach (var mount in mounts.Where(m => m.AssetPath.StartsWith("Packages/", StringComparison.Ordinal)))
            {
                using var json = Read(Path.Combine(mount.Folder, "package.json"));
                if (json == null) continue;
                var name = mount.AssetPath.Substring("Packages/".Length);
                here.Add(name);
                // Unity takes the tests of a package that lies in the project, and of others where "testables" names them.
                if (mount.Folder.StartsWith(Path.Combine(Path.GetFullPath(project), "Packages") + Path.DirectorySeparatorChar,
                    StringComparison.Ordinal)) testable.Add(name);
                versions[name] = json.RootElement.TryGetProperty("version", out var version) ? version.GetString() ?? "" : "0.0.0";
                Dependencies(json.RootElement, wanted);
            }
            using (var manifest = Read(Path.Combine(project, "Packages", "manifest.json")))
                if (manifest != null)
                {
                    Dependencies(manifest.RootElement, wanted);
                    if (manifest.RootElement.TryGetProperty("testables", out var names) && names.ValueKind == JsonValueKind.Array)
                        testable.UnionWith(names.EnumerateArray().Select(n => n.GetString()));
                }
            foreach (var mount in mounts.Where(m => ProjectFolders.IsAtHand(m.Folder)))
                if (mount.AssetPath.Substring("Packages/".Length) is var name && wanted.TryGetValue(name, out var asked)
                    && !asked.StartsWith("file:", StringComparison.Ordinal))
                    Notes.Add($"the package {name} is taken from {mount.Folder}: of {asked}, which Packages/manifest.json asks for, " +
                        $"this machine has no copy");
            foreach (var package in wanted.Where(p => !here.Contains(p.Key)))
            {
                if (!package.Value.StartsWith("file:", StringComparison.Ordinal)) versions.TryAdd(package.Key, package.Value);
                // The engine's own modules are what the host and its stubs are.
                if (!hosted.ContainsKey(package.Key) && !package.Key.StartsWith("com.unity.modules.", StringComparison.Ordinal)
                    && (tests || !Array.Exists(EditorOnly, name => package.Key.StartsWith(name, StringComparison.Ordinal))))
                    Missing.Add(package.Key + " " + package.Value);
            }
            Missing.Sort(StringComparer.Ordinal);
        }

        static void Dependencies(JsonElement of, Dictionary<string, string> wanted)
        {
            if (!of.TryGetProperty("dependencies", out var all) || all.ValueKind != JsonValueKind.Object) return;
            foreach (var one in all.EnumerateObject()) wanted.TryAdd(one.Name, one.Value.GetString() ?? "");
        }

        static JsonDocument Read(string file)
        {
            if (!File.Exists(file)) return null;
            try
            {
                return JsonDocument.Parse(File.ReadAllText(file), Lenient);
            }
            catch (JsonException e)
            {
                throw new ScriptException($"{file}({e.LineNumber + 1}): {e.Message}");
            }
        }

        /// <summary>Null for a package that no one asks for; a git address or the like counts as version 0.</summary>
        public string VersionOf(string package) => !versions.TryGetValue(package, out var version) ? null : version.Length > 0
            && char.IsDigit(version[0]) ? version : "0.0.0";

        /// <summary>The host's assemblies that the project may use.</summary>
        public IEnumerable<string> HostedAssemblies => hosted.Where(h => versions.ContainsKey(h.Key)).Select(h => h.Value);

        /// <summary>The package that an assembly of the host stands in for; null when it is none's.</summary>
        public string OfAssembly(string name) => hosted.FirstOrDefault(h => h.Value == name).Key;

        /// <summary>Whether tests below a path of the project are the project's: in Assets, in a package that lies in Packages, or in one
        /// that the manifest lists as testable.</summary>
        public bool HasTests(string assetPath) => assetPath.StartsWith("Assets/", StringComparison.Ordinal)
            || assetPath.Split('/') is { Length: > 1 } parts && testable.Contains(parts[1]);
    }
}
