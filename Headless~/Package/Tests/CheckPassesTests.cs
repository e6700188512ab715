using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Shaders that lack a pass, planted.</summary>
    public sealed class CheckPassesTests
    {
        const string Program = "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\nENDHLSL";

        static string Pass(string mode, string state = "") => $"Pass {{ Tags {{ \"LightMode\" = \"{mode}\" }} {state} {Program} }}\n";
        static string SubShader(string pipeline, params string[] modes) =>
            $"SubShader {{ PackageRequirements {{ \"com.absent\" }} Tags {{ \"RenderPipeline\" = \"{pipeline}\" " +
            $"}}\n{string.Concat(modes.Select(m => Pass(m)))} }}\n";

        static readonly string BuiltIn = SubShader("", "ForwardBase", "ShadowCaster", "MotionVectors");
        static readonly string Universal = SubShader("UniversalPipeline", "UniversalForward", "DepthOnly", "DepthNormals", "ShadowCaster",
            "MotionVectors");
        static readonly string HighDefinition = SubShader("HDRenderPipeline", "ForwardOnly", "DepthForwardOnly", "ShadowCaster", "MotionVectors");

        static string[] Faults(params string[] subShaders)
        {
            using var package = new SyntheticPackage();
            return new RenderPassesRule().Examine(package.Add("S.shader", $"Shader \"S\" {{\n{string.Concat(subShaders)}}}").Tree).Faults.ToArray();
        }

        [Test]
        public void All_passes_are_enough() => Assert.That(Faults(BuiltIn, Universal, HighDefinition), Is.Empty);

        [Test]
        public void A_pass_that_is_missing_is_named([Values("DepthOnly", "DepthNormals", "ShadowCaster", "MotionVectors",
            "UniversalForward")] string mode)
        {
            string fault = Faults(BuiltIn, Universal.Replace($"\"{mode}\"", "\"Other\""), HighDefinition).Single();
            Assert.That(fault, Does.StartWith(
                "S.shader: it writes depth but its SubShader for UniversalPipeline has no pass with LightMode").And.Contains(mode));
        }

        [Test]
        public void A_pipeline_that_is_missing_is_named()
        {
            Assert.That(Faults(BuiltIn, Universal).Single(), Does.Contain("no SubShader for HDRenderPipeline"));
            Assert.That(Faults(HighDefinition, Universal).Single(), Does.Contain("no SubShader for the Built-in pipeline"));
        }

        [Test]
        public void Transparent_ones_need_their_color_alone()
        {
            string[] transparent = { "", "\"RenderPipeline\" = \"UniversalPipeline\"", "\"RenderPipeline\" = \"HDRenderPipeline\"" };
            string[] modes = { "ForwardBase", "UniversalForwardOnly", "ForwardOnly" };
            string[] subShaders = transparent.Zip(modes,
                (tag, mode) => $"SubShader {{ Tags {{ {tag} \"Queue\" = \"Transparent-50\" }} {Pass(mode)} }}").ToArray();
            Assert.That(Faults(subShaders), Is.Empty);
            Assert.That(Faults(subShaders[0], subShaders[1], subShaders[2].Replace("ForwardOnly", "Other")).Single(),
                Does.Contain("no pass with LightMode ForwardOnly"));
        }

        [Test]
        public void What_writes_no_depth_needs_none() => Assert.That(Faults($"SubShader {{ {Pass("Always", "ZWrite Off")} }}"), Is.Empty);
    }
}
