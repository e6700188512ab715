using System.Linq;
using Host.Assets;

namespace Host.Check
{
    /// <summary>A scene brings the settings that every scene of the editor's has: where they are missing, the editor makes them up as it
    /// opens the scene, and may bake light.</summary>
    sealed class SceneSettingsRule : Rule
    {
        const int Lightmaps = 157, OnDemand = 1;

        static readonly (int ClassId, string Name)[] Wanted = { (29, "OcclusionCullingSettings"), (104, "RenderSettings"),
            (Lightmaps, "LightmapSettings"), (196, "NavMeshSettings") };

        public override string Name => "package: scenes open without a bake";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int scenes = 0;
            foreach (AssetEntry entry in ProjectView.Index(package).Entries.Where(entry => entry.Extension == ".unity"))
                try
                {
                    scenes++;
                    UnityYaml scene = UnityYaml.Load(entry.File, entry.Path);
                    foreach ((int id, string name) in Wanted)
                        if (scene.Documents.Count(document => document.ClassId == id) != 1)
                            findings.Fault($"{entry.Path} does not have one {name} (!u!{id}): copy that of another sample");
                    if (scene.Documents.Find(document => document.ClassId == Lightmaps) is { } light
                        && light.Fields.Int("m_GIWorkflowMode") != OnDemand)
                        findings.Fault($"{light.Location}: m_GIWorkflowMode is not {OnDemand}: light would be baked as the scene is opened");
                }
                catch (AssetException e)
                {
                    findings.Fault(e.Message);
                }
            findings.Looked = $"{scenes} scenes";
            return findings;
        }
    }
}
