using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text;
using Host.Assets;

namespace Host.Check
{
    /// <summary>The list of all stages that a row of Rill.Features names, by which Unity takes their shaders into a build, and the asset of a
    /// stage that has none yet. An asset that is there stays: it may refer to shaders of other names.</summary>
    sealed class StageAssets : GeneratedFiles
    {
        const string Stages = "Runtime/Stages/", List = "Runtime/FluidShaders.asset";
        const string StageScript = "Runtime/Stages/StageShader.cs", ListScript = "Runtime/Simulation/FluidShaders.cs";

        public override IReadOnlyDictionary<string, string> Texts(PackageTree package, Findings findings)
        {
            if (!package.Has(StageScript) || !package.Has(ListScript))
                return null;
            Assembly assembly = Compiled(package, "Rill", findings);
            return assembly == null ? null : Texts(package, StagesOf(assembly), findings);
        }

        /// <param name="stages">Names of stages, each once, in the order of the list.</param>
        public static IReadOnlyDictionary<string, string> Texts(PackageTree package, IEnumerable<string> stages, Findings findings)
        {
            var texts = new Dictionary<string, string>();
            var list = new StringBuilder(Head(GuidOf(package, ListScript, findings), "FluidShaders")).Append("  stages:\n");
            foreach (string stage in stages)
            {
                string path = $"{Stages}{stage}.asset";
                if (!package.Has(path) && !AddAsset(package, stage, path, texts, findings))
                    continue;
                list.Append($"  - {{fileID: 11400000, guid: {GuidOf(package, path, findings)}, type: 2}}\n");
            }
            texts.Add(List, list.ToString());
            return texts;
        }

        static bool AddAsset(PackageTree package, string stage, string path, Dictionary<string, string> texts, Findings findings)
        {
            string compute = Find(package, stage + ".compute"), shader = Find(package, stage + ".shader");
            if (compute == null && shader == null)
            {
                findings.Fault($"a row of Features names the stage {stage}, but Shaders has no {stage}.compute and no {stage}.shader. " +
                    $"Write one, or {path} by hand, or correct the row.");
                return false;
            }
            texts.Add(path, Head(GuidOf(package, StageScript, findings), stage) +
                $"  compute: {Reference(package, compute, 7200000, findings)}\n  shader: {Reference(package, shader, 4800000, findings)}\n");
            if (!package.Has(path + ".meta"))
                texts.Add(path + ".meta", Meta(path, "NativeFormatImporter", "  mainObjectFileID: 11400000\n"));
            return true;
        }

        static IEnumerable<string> StagesOf(Assembly rill)
        {
            var features = (Array)rill.GetType("Rill.Features", true).GetField("All").GetValue(null);
            return features.Cast<object>().SelectMany(feature => (string[])feature.GetType().GetField("Stages").GetValue(feature))
                .Distinct();
        }

        static string Find(PackageTree package, string name) => package.Files.FirstOrDefault(file =>
            file.StartsWith("Shaders/", StringComparison.Ordinal) && file.EndsWith("/" + name, StringComparison.Ordinal));

        static string Reference(PackageTree package, string file, int fileId, Findings findings) =>
            file == null ? "{fileID: 0}" : $"{{fileID: {fileId}, guid: {GuidOf(package, file, findings)}, type: 3}}";

        static string GuidOf(PackageTree package, string path, Findings findings)
        {
            string file = path + ".meta";
            if (!package.Has(file))
                return NewGuid(path);
            if (MetaFile.TryRead(package.FullPath(file), file, out MetaFile meta, out string problem))
                return meta.Guid;
            findings.Fault(problem);
            return "";
        }

        static string Head(string script, string name) =>
            "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &11400000\nMonoBehaviour:\n  m_ObjectHideFlags: 0\n" +
            "  m_CorrespondingSourceObject: {fileID: 0}\n  m_PrefabInstance: {fileID: 0}\n  m_PrefabAsset: {fileID: 0}\n" +
            "  m_GameObject: {fileID: 0}\n  m_Enabled: 1\n  m_EditorHideFlags: 0\n" +
            $"  m_Script: {{fileID: 11500000, guid: {script}, type: 3}}\n  m_Name: {name}\n  m_EditorClassIdentifier: \n";
    }
}
