using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Host.Assets;

namespace Host.Scripts.Assemblies
{
    /// <summary>A package (or "Unity" itself) whose version sets a define.</summary>
    internal sealed record VersionDefine(string Resource, string Expression, string Define);

    /// <summary>Content of an .asmdef file.</summary>
    internal sealed class AssemblyDefinition
    {
        static readonly JsonDocumentOptions Lenient = new JsonDocumentOptions { AllowTrailingCommas = true,
            CommentHandling = JsonCommentHandling.Skip };

        public AssetEntry Entry;
        public string Name;
        public List<string> References, IncludePlatforms, ExcludePlatforms, DefineConstraints, PrecompiledReferences;
        public List<VersionDefine> VersionDefines;
        public bool AllowUnsafe, OverrideReferences, AutoReferenced, NoEngineReferences, IsTest;

        /// <exception cref="ScriptException">It is no JSON or has no name.</exception>
        public static AssemblyDefinition Read(AssetEntry entry)
        {
            using var json = Json(entry);
            var root = json.RootElement;
            var name = Text(root, "name");
            if (name.Length == 0) throw new ScriptException($"{entry.Path}: the assembly definition has no \"name\"");
            return new AssemblyDefinition
            {
                Entry = entry, Name = name,
                References = Texts(root, "references"), IncludePlatforms = Texts(root, "includePlatforms"),
                    ExcludePlatforms = Texts(root, "excludePlatforms"),
                DefineConstraints = Texts(root, "defineConstraints"), PrecompiledReferences = Texts(root, "precompiledReferences"),
                AllowUnsafe = Flag(root, "allowUnsafeCode", false), OverrideReferences = Flag(root, "overrideReferences", false),
                AutoReferenced = Flag(root, "autoReferenced", true), NoEngineReferences = Flag(root, "noEngineReferences", false),
                IsTest = Texts(root, "optionalUnityReferences").Contains("TestAssemblies"),
                VersionDefines = root.TryGetProperty("versionDefines", out var defines) && defines.ValueKind == JsonValueKind.Array
                    ? defines.EnumerateArray().Select(d => new VersionDefine(Text(d, "name"), Text(d, "expression"), Text(d, "define"))).ToList()
                    : new List<VersionDefine>(),
            };
        }

        /// <summary>The "reference" of an .asmref file.</summary>
        public static string ReadReference(AssetEntry entry)
        {
            using var json = Json(entry);
            var reference = Text(json.RootElement, "reference");
            return reference.Length > 0 ? reference : throw new ScriptException($"{entry.Path}: the assembly reference has no \"reference\"");
        }

        static JsonDocument Json(AssetEntry entry)
        {
            try
            {
                var json = JsonDocument.Parse(File.ReadAllText(entry.File), Lenient);
                return json.RootElement.ValueKind == JsonValueKind.Object ? json : throw new ScriptException($"{entry.Path}: this is no JSON object");
            }
            catch (JsonException e)
            {
                throw new ScriptException($"{entry.Path}({e.LineNumber + 1}): {e.Message}");
            }
        }

        static string Text(JsonElement of, string name) => of.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.String
            ? value.GetString() : "";

        static bool Flag(JsonElement of, string name, bool otherwise) => of.TryGetProperty(name, out var value)
            && value.ValueKind is JsonValueKind.True or JsonValueKind.False ? value.GetBoolean() : otherwise;

        static List<string> Texts(JsonElement of, string name) => of.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.Array
            ? value.EnumerateArray().Where(v => v.ValueKind == JsonValueKind.String && v.GetString().Length > 0).Select(v => v.GetString()).ToList()
            : new List<string>();
    }
}
