using System;
using System.Collections.Generic;
using System.Linq;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>
    /// A shader that writes depth has the passes by which each render pipeline asks for its depth, shadow and motion: what lacks one
    /// vanishes under a depth prepass, casts no shadow or smears under temporal antialiasing. Transparent ones are asked for their
    /// color alone, and those of the menu "Hidden" by no one but our own command buffers.
    /// </summary>
    sealed class RenderPassesRule : Rule
    {
        // By the RenderPipeline tag: for each pass, the color first, the values of LightMode that will do; "" is a pass without.
        static readonly Dictionary<string, string[][]> Wanted = new Dictionary<string, string[][]>
        {
            [""] = new[] { new[] { "ForwardBase" }, new[] { "ShadowCaster" }, new[] { "MotionVectors" } },
            ["UniversalPipeline"] = new[]
            {
                new[] { "UniversalForwardOnly", "UniversalForward" }, new[] { "DepthOnly" }, new[] { "DepthNormalsOnly", "DepthNormals" },
                    new[] { "ShadowCaster" }, new[] { "MotionVectors" },
            },
            ["HDRenderPipeline"] = new[]
            { new[] { "ForwardOnly" }, new[] { "DepthForwardOnly" }, new[] { "ShadowCaster" }, new[] { "MotionVectors" } },
        };

        public override string Name => "package: shaders that write depth have every pipeline's passes";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int passes = 0, shaders = 0;
            foreach (string file in PackageShaders.Files(package, ".shader"))
                try
                {
                    ParsedShader shader = ShaderLabParser.Parse(package.Read(file), file, (_, _) => true);
                    if (shader.Name.StartsWith("Hidden/", StringComparison.Ordinal) || !shader.SubShaders.Any(s => s.Passes.Any(WritesDepth)))
                        continue;
                    shaders++;
                    passes += shader.SubShaders.Sum(s => s.Passes.Count);
                    foreach (string fault in Faults(shader))
                        findings.Fault($"{file}: {fault}");
                }
                catch (ShaderCompileException e)
                {
                    findings.Fault(e.Message);
                }
            findings.Looked = $"{passes} passes of {shaders} shaders";
            return findings;
        }

        static IEnumerable<string> Faults(ParsedShader shader)
        {
            foreach ((string pipeline, string[][] wanted) in Wanted)
            {
                string name = pipeline.Length > 0 ? pipeline : "the Built-in pipeline";
                List<ParsedSubShader> own = shader.SubShaders.Where(s => Tag(s.Tags, "RenderPipeline") == pipeline).ToList();
                if (own.Count == 0)
                    yield return $"it writes depth but has no SubShader for {name}, where it draws nothing; add one";
                foreach (ParsedSubShader subShader in own)
                    foreach (string[] modes in IsTransparent(subShader) ? wanted.Take(1) : wanted)
                        if (!subShader.Passes.Any(pass => modes.Contains(Tag(pass.Tags, "LightMode"))))
                            yield return $"it writes depth but its SubShader for {name} has no pass with LightMode " +
                                $"{string.Join(" or ", modes)}; add one";
            }
        }

        static bool IsTransparent(ParsedSubShader subShader) => Tag(subShader.Tags, "Queue").StartsWith("Transparent", StringComparison.Ordinal);

        static string Tag(Dictionary<string, string> tags, string name) => tags.TryGetValue(name, out string value) ? value : "";

        // A property decides: it may.
        static bool WritesDepth(ParsedPass pass) => pass.State.Resolve(_ => 1).DepthWrite;
    }
}
