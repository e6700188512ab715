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
        public static readonly IReadOnlyDictionary<string, string> Hosted = new Dictionary<string, string> { ["com.unity.mathematics"] = "Unity.Mathematics", ["com.unity.ugui"] = "UnityEngine.UI" };

        static readonly JsonDocumentOptions Lenient = new JsonDocumentOptions { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip };

        readonly Dictionary<string, string> versions = new Dictionary<string, string>();

        /// <summary>"com.unity.render-pipelines.universal 14.0.8": asked for and nowhere to be found.</summary>
        public readonly List<string> Missing = new List<string>();

        public Packages(string project, IEnumerable<MountedFolder> mounts)
        {
            versions["Unity"] = Defines.UnityVersion;
            var wanted = new Dictionary<string, string>();
            var here = new HashSet<string>();
            foreach (var mount in mounts.Where(m => m.AssetPath.StartsWith("Packages/", StringComparison.Ordinal)))
            {
                using var json = Read(Path.Combine(mount.Folder, "package.json"));
                if (json == null) continue;
                var name = mount.AssetPath.Substring("Packages/".Length);
                here.Add(name);
                versions[name] = json.RootElement.TryGetProperty("version", out var version) ? version.GetString() ?? "" : "0.0.0";
                Dependencies(json.RootElement, wanted);
            }
            using (var manifest = Read(Path.Combine(project, "Packages", "manifest.json")))
                if (manifest != null) Dependencies(manifest.RootElement, wanted);
            foreach (var package in wanted.Where(p => !here.Contains(p.Key)))
            {
                if (!package.Value.StartsWith("file:", StringComparison.Ordinal)) versions.TryAdd(package.Key, package.Value);
                // The engine's own modules are what the host and its stubs are.
                if (!Hosted.ContainsKey(package.Key) && !package.Key.StartsWith("com.unity.modules.", StringComparison.Ordinal)) Missing.Add(package.Key + " " + package.Value);
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

        /// <summary>Null for a package that nobody asks for; a git address or the like counts as version 0.</summary>
        public string VersionOf(string package) => !versions.TryGetValue(package, out var version) ? null : version.Length > 0 && char.IsDigit(version[0]) ? version : "0.0.0";

        /// <summary>The host's assemblies that the project may use.</summary>
        public IEnumerable<string> HostedAssemblies => Hosted.Where(h => versions.ContainsKey(h.Key)).Select(h => h.Value);
    }
}
