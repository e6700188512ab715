using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Generated files that are stale, missing, or cannot be made.</summary>
    public sealed class CheckGeneratedTests
    {
        const string Table = "Runtime/Gpu/Device/KernelNeeds.Generated.cs";

        const string Shader = "#pragma kernel A Name=A WIDE=1\n#pragma kernel B\n#pragma multi_compile_local _ " +
            "MORE\nStructuredBuffer<uint> _In; RWStructuredBuffer<uint> _Out; RWStructuredBuffer<uint> _Other; Texture2D<float> " +
            "_Map;\ngroupshared uint g_A[64];\n" +
            "#ifdef WIDE\n[numthreads(64,2,1)] void Name(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex) { g_A[t & 63] = id.x; " +
            "GroupMemoryBarrierWithGroupSync(); _Out[id.x] = _In[id.x] + g_A[63 - (t & 63)]\n" +
            "#ifdef MORE\n + _Other[id.x]++ + _Map[id.xy]\n#endif\n; }\n#else\n[numthreads(8,1,1)] void B(uint3 id : " +
            "SV_DispatchThreadID) { _Out[id.x] = 1; }\n#endif\n";

        SyntheticPackage package;

        [SetUp]
        public void Make() => package = new SyntheticPackage().Add("Shaders/Two.compute", Shader);

        [TearDown]
        public void Remove() => package.Dispose();

        Findings Examine() => new GeneratedFilesRule().Examine(package.Tree);

        string Generate()
        {
            string text = new KernelNeedsFile().Text(package.Tree, new Findings());
            package.Add(Table, text);
            return text;
        }

        [Test]
        public void The_table_has_the_needs_of_each_variant()
        {
            string[] rows = Generate().Split('\n').Where(line => line.Contains("new KernelNeed(")).Select(line => line.Trim()).ToArray();
            Assert.That(rows, Is.EqualTo(new[]
            {
                "new KernelNeed(\"Two\", \"A\", \"WIDE\", 128, 256, 2, 1, 0),",
                "new KernelNeed(\"Two\", \"A\", \"WIDE MORE\", 128, 256, 3, 2, 1),",
                "new KernelNeed(\"Two\", \"B\", \"\", 8, 0, 1, 1, 0),",
            }));
        }

        [Test]
        public void What_was_just_generated_is_up_to_date()
        {
            Generate();
            Assert.That(Examine().Faults, Is.Empty);
            Assert.That(Examine().Looked, Is.EqualTo("1 files"));
        }

        [Test]
        public void Other_line_ends_are_no_difference()
        {
            package.Add(Table, Generate().Replace("\n", "\r\n"));
            Assert.That(Examine().Faults, Is.Empty);
        }

        [Test]
        public void A_file_that_is_missing_is_a_fault()
            => Assert.That(Examine().Faults, Is.EqualTo(new[] { Table + " is missing: run `Headless~/rill generate`." }));

        [Test]
        public void A_shader_that_has_changed_since_is_a_fault_at_the_line_that_differs()
        {
            string text = Generate();
            package.Add("Shaders/Two.compute", Shader.Replace("numthreads(8,1,1)", "numthreads(16,1,1)"));
            int line = text.Split('\n').TakeWhile(row => !row.Contains("\"B\"")).Count() + 1;
            Assert.That(Examine().Faults, Is.EqualTo(new[] { $"{Table}({line}) is not what its sources say: run `Headless~/rill generate`." }));
        }

        [Test]
        public void A_shader_that_does_not_compile_is_a_fault_and_nothing_is_generated()
        {
            package.Add("Shaders/Two.compute", Shader.Replace("_Out[id.x] = 1", "_None[id.x] = 1"));
            Assert.That(new KernelNeedsFile().Text(package.Tree, new Findings()), Is.Null);
            Assert.That(Examine().Faults, Has.Some.StartsWith("Shaders/Two.compute (B): ").And.Some.Contains("_None"));
        }

        // Two files in a folder of their own.
        sealed class Pair : GeneratedFiles
        {
            public override string Folder => "Shaders/Pair/";

            public override IReadOnlyDictionary<string, string> Texts(PackageTree package, Findings findings) =>
                new Dictionary<string, string> { [Folder + "One.hlsl"] = "a\nb\n", [Folder + "Two.hlsl"] = "c\n" };
        }

        [Test]
        public void Each_of_several_generated_files_is_compared_and_what_is_left_over_beside_them_is_a_fault()
        {
            package.Add("Shaders/Pair/One.hlsl", "a\nB\n").Add("Shaders/Pair/Three.hlsl", "d\n");
            Findings findings = new GeneratedFilesRule(new GeneratedFiles[] { new Pair() }).Examine(package.Tree);
            Assert.That(findings.Faults, Is.EqualTo(new[]
            {
                "Shaders/Pair/One.hlsl(2) is not what its sources say: run `Headless~/rill generate`.",
                "Shaders/Pair/Two.hlsl is missing: run `Headless~/rill generate`.",
                "Shaders/Pair/Three.hlsl is generated from nothing any more: run `Headless~/rill generate`, which deletes it.",
            }));
            Assert.That(findings.Looked, Is.EqualTo("2 files"));
        }

        static SyntheticPackage WithStages(SyntheticPackage package) => package
            .Add("Runtime/Stages/StageShader.cs.meta", "fileFormatVersion: 2\nguid: 0000000000000000000000000000000a\n")
            .Add("Runtime/Simulation/FluidShaders.cs.meta", "fileFormatVersion: 2\nguid: 0000000000000000000000000000000b\n")
            .Add("Shaders/Two.compute.meta", "fileFormatVersion: 2\nguid: 0000000000000000000000000000000c\n");

        [Test]
        public void A_stage_has_an_asset_that_refers_to_its_shaders_and_stands_in_the_list()
        {
            WithStages(package).Add("Runtime/Stages/Two.asset.meta", "fileFormatVersion: 2\nguid: 0000000000000000000000000000000d\n");
            IReadOnlyDictionary<string, string> texts = StageAssets.Texts(package.Tree, new[] { "Two" }, new Findings());
            Assert.That(texts.Keys, Is.EquivalentTo(new[] { "Runtime/Stages/Two.asset", "Runtime/FluidShaders.asset" }), "its .meta stays");
            Assert.That(texts["Runtime/Stages/Two.asset"], Does.Contain("guid: 0000000000000000000000000000000a")
                .And.Contain("  compute: {fileID: 7200000, guid: 0000000000000000000000000000000c, type: 3}\n  shader: {fileID: 0}\n"));
            Assert.That(texts["Runtime/FluidShaders.asset"],
                Does.EndWith("  stages:\n  - {fileID: 11400000, guid: 0000000000000000000000000000000d, type: 2}\n"));
        }

        [Test]
        public void A_new_stage_gets_a_meta_with_the_guid_by_which_the_list_refers_to_it()
        {
            IReadOnlyDictionary<string, string> texts = StageAssets.Texts(WithStages(package).Tree, new[] { "Two" }, new Findings());
            string meta = texts["Runtime/Stages/Two.asset.meta"];
            string guid = meta.Split('\n').Single(line => line.StartsWith("guid: ")).Substring("guid: ".Length);
            Assert.That(guid, Has.Length.EqualTo(32));
            Assert.That(texts["Runtime/FluidShaders.asset"], Does.Contain(guid));
        }

        [Test]
        public void An_asset_that_is_there_stays()
        {
            WithStages(package).Add("Runtime/Stages/Two.asset", "by hand").Add("Runtime/Stages/Two.asset.meta", "guid: 0000000000000000000000000000000d\n");
            IReadOnlyDictionary<string, string> texts = StageAssets.Texts(package.Tree, new[] { "Two" }, new Findings());
            Assert.That(texts.Keys, Is.EquivalentTo(new[] { "Runtime/FluidShaders.asset" }));
            Assert.That(texts["Runtime/FluidShaders.asset"], Does.Contain("0000000000000000000000000000000d"));
        }

        [Test]
        public void A_stage_without_a_shader_is_named()
        {
            var findings = new Findings();
            StageAssets.Texts(WithStages(package).Tree, new[] { "Thre" }, findings);
            Assert.That(findings.Faults.Single(), Does.Contain("Thre.compute").And.Contain("row of Features"));
        }

        [Test]
        public void A_package_without_shaders_has_nothing_to_generate()
        {
            File.Delete(package.Tree.FullPath("Shaders/Two.compute"));
            Assert.That(Examine().Faults, Is.Empty);
            Assert.That(Examine().Looked, Is.EqualTo("0 files"));
        }
    }
}
