using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Host.Check
{
    /// <summary>package.json, read leniently: what is missing or of the wrong kind is null, and the rules say so.</summary>
    sealed class PackageManifest
    {
        public string Name { get; private set; }
        public string Version { get; private set; }
        public string Unity { get; private set; }
        public readonly Dictionary<string, string> Texts = new();
        public readonly List<KeyValuePair<string, string>> Dependencies = new();
        public readonly List<PackageSample> Samples = new();

        /// <summary>Null with a fault when no file can be read.</summary>
        public static PackageManifest Read(PackageTree package, Findings findings)
        {
            const string file = "package.json";
            if (!package.Has(file))
            {
                findings.Fault($"{file} is missing: the Package Manager does not take a folder without it");
                return null;
            }
            try
            {
                using JsonDocument json = JsonDocument.Parse(package.Read(file));
                return new PackageManifest(json.RootElement);
            }
            catch (Exception e) when (e is JsonException or InvalidOperationException)
            {
                findings.Fault($"{file} cannot be read: {e.Message}");
                return null;
            }
        }

        PackageManifest(JsonElement root)
        {
            foreach (JsonProperty field in root.EnumerateObject())
                if (field.Value.ValueKind == JsonValueKind.String)
                    Texts[field.Name] = field.Value.GetString();
            Name = Texts.GetValueOrDefault("name");
            Version = Texts.GetValueOrDefault("version");
            Unity = Texts.GetValueOrDefault("unity");
            if (root.TryGetProperty("dependencies", out JsonElement dependencies))
                Dependencies.AddRange(dependencies.EnumerateObject().Select(d => KeyValuePair.Create(d.Name, d.Value.ToString())));
            if (root.TryGetProperty("samples", out JsonElement samples))
                foreach (JsonElement sample in samples.EnumerateArray())
                    Samples.Add(new PackageSample(Text(sample, "displayName"), Text(sample, "description"), Text(sample, "path")));
        }

        static string Text(JsonElement element, string key) => element.TryGetProperty(key, out JsonElement value) ? value.ToString() : "";
    }

    sealed record PackageSample(string DisplayName, string Description, string Path);
}
