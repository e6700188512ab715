using System.Collections.Generic;
using System.Linq;
using Host.Assets;
using Host.Pipelines;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>
    /// Objects of scenes, prefabs and assets are drawn in every render pipeline: by a material of the package's or sample's own whose shader
    /// has a SubShader for each. The editor's own materials are of the Built-in pipeline, and pink in others; so is a renderer without one.
    /// </summary>
    sealed class PipelineMaterialsRule : Rule
    {
        const int Material = 21;
        // MeshRenderer, ParticleSystemRenderer, TrailRenderer, LineRenderer, SkinnedMeshRenderer, SpriteRenderer.
        static readonly int[] Renderers = { 23, 199, 96, 120, 137, 212 };
        // A new scene has the built-in sky, which Built-in and URP draw and HDRP passes over; so has a material of such a shader, as a sky.
        const string Sky = "m_SkyboxMaterial", SkyShaders = "Skybox/";

        public override string Name => "package: materials draw in every render pipeline";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            ProjectIndex index = ProjectView.Index(package);
            int materials = 0, renderers = 0;
            foreach (AssetEntry entry in ProjectView.Documents(index))
                try
                {
                    foreach (UnityDocument document in UnityYaml.Load(entry.File, entry.Path).Documents)
                    {
                        foreach (FileReference builtIn in BuiltIn(document.Fields, null))
                            findings.Fault($"{builtIn.Location}: {document.TypeName} refers to the built-in " +
                                $"{BuiltInAssets.NameOf(builtIn.FileId)}, which is pink in URP and HDRP: make a material of the sample's own " +
                                "with the shader Rill/Solid");
                        if (document.ClassId == Material)
                        {
                            materials++;
                            CheckShader(package, index, document, findings);
                        }
                        if (!Renderers.Contains(document.ClassId) || document.Stripped)
                            continue;
                        renderers++;
                        List<YamlNode> given = document.Fields.Items("m_Materials").ToList();
                        if (given.Count == 0 || given.Any(material => FileReference.Of(material).IsNone))
                            findings.Fault($"{document.Location}: {document.TypeName} lacks a material, which is pink in every pipeline: " +
                                "give it one");
                        foreach (FileReference sky in given.Select(FileReference.Of).Where(material => IsSky(index, material)))
                            findings.Fault($"{sky.Location}: {document.TypeName} has a material of a sky, which is pink in URP and HDRP: " +
                                "give it one with the shader Rill/Solid");
                    }
                }
                catch (AssetException e)
                {
                    findings.Fault(e.Message);
                }
            findings.Looked = $"{materials} materials and {renderers} renderers";
            return findings;
        }

        // But for meshes, which are drawn by whatever material.
        static IEnumerable<FileReference> BuiltIn(YamlNode node, string key)
        {
            if (FileReference.Is(node))
            {
                FileReference reference = FileReference.Of(node);
                return BuiltInAssets.IsBuiltIn(reference.Guid) && !BuiltInAssets.IsMesh(reference.FileId) && key != Sky
                    && !(key == "m_Shader" && IsSkyShader(reference)) ? new[] { reference } : Enumerable.Empty<FileReference>();
            }
            return node switch
            {
                YamlMapping mapping => mapping.Entries.SelectMany(entry => BuiltIn(entry.Value, entry.Key)),
                YamlSequence list => list.Elements.SelectMany(element => BuiltIn(element, key)),
                _ => Enumerable.Empty<FileReference>(),
            };
        }

        static bool IsSkyShader(FileReference shader)
            => BuiltInAssets.IsBuiltIn(shader.Guid) && BuiltInAssets.NameOf(shader.FileId).Contains(SkyShaders);

        static bool IsSky(ProjectIndex index, FileReference material)
            => index.ByGuid(material.Guid ?? "") is { Extension: ".mat" } file && UnityYaml.Load(file.File, file.Path).Documents
            .Any(document => document.ClassId == Material && IsSkyShader(document.Fields.Reference("m_Shader")));

        static void CheckShader(PackageTree package, ProjectIndex index, UnityDocument material, Findings findings)
        {
            FileReference reference = material.Fields.Reference("m_Shader");
            if (reference.IsNone)
                findings.Fault($"{material.Location}: the material has no shader");
            // Assets outside of the package are reported as built in, or by the rule about references.
            if (reference.IsNone || index.ByGuid(reference.Guid ?? "") is not { Extension: ".shader" } file)
                return;
            try
            {
                ParsedShader shader = ShaderLabParser.Parse(System.IO.File.ReadAllText(file.File), file.Path, (_, _) => true);
                foreach (string tag in PipelineKind.All.Select(kind => kind.Tag).Prepend(""))
                    if (!shader.SubShaders.Any(own => (own.Tags.TryGetValue("RenderPipeline", out string pipeline) ? pipeline : "") == tag))
                        findings.Fault($"{material.Location}: its shader {file.Path} has no SubShader for " +
                            $"{(tag.Length > 0 ? tag : "the Built-in pipeline")}, where nothing is drawn: add one");
            }
            catch (ShaderCompileException e)
            {
                findings.Fault(e.Message);
            }
        }
    }
}
