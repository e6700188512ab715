using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Check;
using Host.Check.Api;
using Host.Pipelines;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rules about render pipelines see what a version of them lacks.</summary>
    public class CheckPipelinesTests
    {
        const string Definition = @"{ ""name"": ""Planted"", ""references"": [], ""defineConstraints"": [""PLANTED""],
            ""versionDefines"": [{ ""name"": ""com.unity.render-pipelines.universal"", ""expression"": ""14.0"", ""define"": ""PLANTED"" }, { ""name"": ""com.unity.render-pipelines.universal"", ""expression"": ""17.0"", ""define"": ""GRAPH"" }, { ""name"": ""com.unity.render-pipelines.universal"", ""expression"": ""17.3"", ""define"": ""GRAPH_BY_DEFAULT"" }, { ""name"": ""com.unity.render-pipelines.universal"", ""expression"": ""17.4"", ""define"": ""GRAPH_ONLY"" }] }";

        const string Start = "using UnityEngine; using UnityEngine.Rendering; using UnityEngine.Rendering.Universal; ";

        PlantedAssemblies planted;

        [SetUp]
        public void MakeFolder() => planted = new PlantedAssemblies();

        [TearDown]
        public void RemoveFolder() => planted.Dispose();

        List<string> Faults(string source, string definition = Definition)
        {
            planted.Write("Runtime/Rendering.Universal/Rill.Universal.asmdef", definition);
            planted.Write("Runtime/Rendering.Universal/Planted.cs", Start + source);
            return planted.Examine(new PipelineAdaptersRule(new[] { PipelineKind.Universal })).Faults;
        }

        const string Pass = @"
            #if !GRAPH_BY_DEFAULT || URP_COMPATIBILITY_MODE && !GRAPH_ONLY
            #pragma warning disable 0618, 0672
            #endif
            class P : ScriptableRenderPass
            {
            #if !GRAPH_BY_DEFAULT || URP_COMPATIBILITY_MODE && !GRAPH_ONLY
                public override void Execute(ScriptableRenderContext context, ref RenderingData data) => Debug.Log(data.cameraData.camera.name);
            #endif
            }";

        [Test]
        public void An_adapter_that_every_version_compiles_is_no_fault() => Assert.That(Faults(Pass), Is.Empty);

        [Test]
        public void Passes_that_are_executed_are_a_fault_where_the_editor_has_no_such_path()
        {
            List<string> faults = Faults(Pass.Replace("#if !GRAPH_BY_DEFAULT || URP_COMPATIBILITY_MODE && !GRAPH_ONLY", "#if true"));
            Assert.That(faults, Has.Count.EqualTo(4), string.Join("\n", faults));      // 17.3 and 17.4, each as player and in the editor
            Assert.That(faults, Has.All.Contains("override UnityEngine.Rendering.Universal.ScriptableRenderPass.Execute(").And.All.Contains(
            "has it as obsolete"));
        }

        [Test]
        public void A_version_without_the_member_is_named()
        {
            List<string> faults = Faults("class X { bool f(ScriptableRenderPass pass) => pass.requiresIntermediateTexture; }");
            Assert.That(faults, Has.All.Contains("Unity 2022.3 with URP 14.0.10").And.All.Contains("Planted.cs(1)").And.All.Contains(
                "requiresIntermediateTexture"));
            Assert.That(faults, Has.Count.EqualTo(2));
        }

        [Test]
        public void A_field_that_later_versions_have_as_a_property_is_taken_as_what_it_is_in_each() =>
            Assert.That(Faults("class X { Camera f(ref RenderingData data) => data.cameraData.camera; }"), Is.Empty);

        [Test]
        public void A_value_that_a_version_lacks_is_named() =>
            Assert.That(Faults("class X { object f() => UpscalingFilterSelection.STP; }"),
            Has.Count.EqualTo(2).And.All.Contains("14.0.10").And.All.Contains("STP"));

        [Test]
        public void A_warning_of_the_compiler_is_a_fault()
            => Assert.That(Faults("class X { void f() { int unused = 1; } }"), Has.Count.EqualTo(10).And.All.Contains("warning CS0219"));

        [Test]
        public void An_obsolete_member_is_a_fault_where_it_is_one() =>
            Assert.That(Faults("class X { RTHandle f(ScriptableRenderer r) => r.cameraColorTargetHandle; }"),
            Has.Some.Contains("Unity 6000.0 with URP 17.0.3").And.Some.Contains("CS0618").And.None.Contains("14.0.10"));

        [Test]
        public void An_adapter_that_is_compiled_without_its_pipeline_is_named() =>
            Assert.That(Faults("class X { }", Definition.Replace("[\"PLANTED\"]", "[]")),
            Has.Count.EqualTo(1).And.Some.Contains("without com.unity.render-pipelines.universal it is compiled all the same"));

        [Test]
        public void An_adapter_that_a_version_does_not_compile_is_named() =>
            Assert.That(Faults("class X { }", Definition.Replace("14.0", "15.0")),
            Has.Count.EqualTo(2).And.All.Contains("not compiled in Unity 2022.3 with URP 14.0.10"));

        [Test]
        public void A_member_that_a_later_version_of_HDRP_has_is_a_fault_in_the_earlier()
        {
            planted.Write("Runtime/Rendering.HighDefinition/Rill.HighDefinition.asmdef", Definition.Replace("universal", "high-definition"));
            planted.Write("Runtime/Rendering.HighDefinition/Planted.cs",
                "using UnityEngine.Rendering.HighDefinition; class X { object f() => CustomPassInjectionPoint.BeforePreRefraction; }");
            Assert.That(planted.Examine(new PipelineAdaptersRule(new[] { PipelineKind.HighDefinition })).Faults, Is.Empty);
            planted.Write("Runtime/Rendering.HighDefinition/Planted.cs",
                "using UnityEngine.Rendering.HighDefinition; class X { void f() => CustomPassVolume.UnregisterAllGlobalCustomPasses(); }");
            Assert.That(planted.Examine(new PipelineAdaptersRule(new[] { PipelineKind.HighDefinition })).Faults,
                Has.Some.Contains("Unity 2022.3").And.Some.Contains("UnregisterAllGlobalCustomPasses"));
        }

        [Test]
        public void A_missing_adapter_is_named()
            => planted.Catches(new PipelineAdaptersRule(new[] { PipelineKind.Universal }), "Rill.Universal.asmdef is not there");

        [Test]
        public void A_member_of_a_stand_in_that_the_pipeline_lacks_is_named()
        {
            planted.Compile("UnityEngine", "namespace UnityEngine.Rendering.Universal { public enum CameraRenderType { Base, Overlay, Sideways } }");
            byte[] image = File.ReadAllBytes(Path.Combine(planted.Assemblies, "UnityEngine.dll"));
            List<string> faults = planted.Examine(new PipelineSurfaceRule(version => new[] { image })).Faults;
            Assert.That(faults, Has.Count.EqualTo(PipelineVersion.All.Count).And.All.Contains("CameraRenderType.Sideways"));
            Assert.That(faults.First(), Does.Contain("2022.3 has no such member"));
        }
    }
}
