using System.Collections.Generic;
using System.Linq;
using Host.Assets;

namespace Host.Check
{
    /// <summary>Every GUID and file id in a scene, prefab, material or asset means something.</summary>
    sealed class ReferencesRule : Rule
    {
        // File ids that importers give to the main object (Unity's class id * 100,000).
        static readonly Dictionary<string, long[]> Imported = new()
        {
            [".cs"] = new[]
            { 11500000L }, [".shader"] = new[] { 4800000L }, [".compute"] = new[] { 7200000L }, [".png"] = new[] { 2800000L, 21300000L },
            [".txt"] = new[] { 4900000L }, [".json"] = new[] { 4900000L }, [".csv"] = new[] { 4900000L }, [".bytes"] = new[] { 4900000L },
        };

        readonly Dictionary<string, UnityYaml> read = new();

        public override string Name => "package: references in scenes, prefabs and assets resolve";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            ProjectIndex index = ProjectView.Index(package);
            read.Clear();
            int references = 0, files = 0;
            foreach (AssetEntry entry in ProjectView.Documents(index))
            {
                files++;
                UnityYaml yaml = Read(entry, findings);
                if (yaml == null)
                    continue;
                foreach (FileReference reference in yaml.Documents.SelectMany(document => References(document.Fields)).Where(r => !r.IsNone))
                {
                    references++;
                    if (Problem(index, yaml, reference, findings) is string problem)
                        findings.Fault($"{reference.Location}: {reference} {problem}");
                }
            }
            findings.Looked = $"{references} references in {files} files";
            return findings;
        }

        UnityYaml Read(AssetEntry entry, Findings findings)
        {
            if (read.TryGetValue(entry.Path, out UnityYaml yaml))
                return yaml;
            try
            {
                yaml = UnityYaml.Load(entry.File, entry.Path);
            }
            catch (AssetException e)
            {
                findings.Fault(e.Message);
            }
            return read[entry.Path] = yaml;
        }

        static IEnumerable<FileReference> References(YamlNode node)
        {
            if (FileReference.Is(node))
                return new[] { FileReference.Of(node) };
            return node switch
            {
                YamlMapping mapping => mapping.Entries.SelectMany(entry => References(entry.Value)),
                YamlSequence list => list.Elements.SelectMany(References),
                _ => Enumerable.Empty<FileReference>(),
            };
        }

        string Problem(ProjectIndex index, UnityYaml from, FileReference reference, Findings findings)
        {
            if (reference.IsLocal)
                return from.Find(reference.FileId) == null ? "means an object that this file does not have" : null;
            if (BuiltInAssets.IsBuiltIn(reference.Guid))
                return BuiltInAssets.IsKnown(reference.FileId) ? null
                    : "means an object of the editor's built-in resources that is not known here: see BuiltInAssets";
            AssetEntry target = index.ByGuid(reference.Guid);
            if (target == null)
                return "means an asset that no .meta file of the package has";
            if (Imported.TryGetValue(target.Extension, out long[] ids))
                return ids.Contains(reference.FileId) ? null
                    : $"means an object of {target.Path} that its importer does not make: {string.Join(" or ", ids)} would do";
            if (target.Extension == ".obj")
                return ModelProblem(target, reference);
            if (!ProjectView.Documents(index).Contains(target))
                return $"means {target.Path}, a kind of asset whose objects are not known here";
            UnityYaml document = Read(target, findings);
            return document != null && document.Find(reference.FileId) == null ? $"means an object that {target.Path} does not have" : null;
        }

        static string ModelProblem(AssetEntry model, FileReference reference)
        {
            try
            {
                long[] ids = ModelReader.FileIds(model).ToArray();
                return ids.Contains(reference.FileId) ? null
                    : $"means an object of {model.Path} that its importer does not make: {string.Join(" or ", ids)} would do";
            }
            catch (AssetException e)
            {
                return $"means an object of a model that is not read here: {e.Message}";
            }
        }
    }
}
