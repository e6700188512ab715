using System.Linq;
using Host.Check;
using Host.Output;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Each rule about the package's files sees the fault that it exists for.</summary>
    public class CheckPackageTests
    {
        const string Scene = "Samples~/Dam Break/DamBreak.unity", Bodies = "Samples~/Floating Bodies/FloatingBodies.unity", Manifest = "package.json";

        PackageCopy copy;

        [SetUp]
        public void CopyThePackage() => copy = new PackageCopy();

        [TearDown]
        public void RemoveTheCopy() => copy.Dispose();

        [Test]
        public void A_missing_meta_file_is_named()
            => copy.Catches(new MetaFilesRule(), () => copy.Delete("Runtime/Rill.asmdef.meta"), "Runtime/Rill.asmdef has no .meta file");

        [Test]
        public void Results_of_the_command_line_are_no_part_of_the_package()
        {
            copy[$"{ResultsFolder.Root}/DamBreak/aux.png"] = "";
            foreach (Rule rule in new Rule[] { new MetaFilesRule(), new FileNamesRule(), new TarballRule() })
                Assert.That(copy.Examine(rule).Faults, Is.Empty, rule.Name);
            copy.Catches(new MetaFilesRule(), () => copy["results/aux.png"] = "", "results has no .meta file");
        }

        [Test]
        public void A_meta_file_without_its_asset_is_named()
            => copy.Catches(new MetaFilesRule(),
            () => copy["Shaders/Gone.hlsl.meta"] = "fileFormatVersion: 2\nguid: 0123456789abcdef0123456789abcdef\n",
            "Shaders/Gone.hlsl.meta", "gone");

        [Test]
        public void A_guid_given_twice_is_named_with_both_assets() =>
            copy.Catches(new MetaFilesRule(), () => copy["Runtime/Rill.asmdef.meta"] = copy["Editor/Rill.Editor.asmdef.meta"],
            "Runtime/Rill.asmdef", "Editor/Rill.Editor.asmdef");

        [Test]
        public void A_sample_s_guid_must_differ_from_the_package_s_too() =>
            copy.Catches(new MetaFilesRule(), () => copy[Scene + ".meta"] = copy["Editor/Rill.Editor.asmdef.meta"], "DamBreak.unity",
            "Editor/Rill.Editor.asmdef");

        [Test]
        public void A_malformed_guid_is_named()
            => copy.Catches(new MetaFilesRule(), () => copy["Runtime/Rill.asmdef.meta"] = "fileFormatVersion: 2\nguid: ABC\n",
            "Rill.asmdef.meta", "'ABC'");

        [TestCase("Shaders/aux.hlsl", "aux.hlsl", "Windows")]
        [TestCase("Shaders/a:b.hlsl", "a:b.hlsl", "Windows")]
        [TestCase("shaders/Other.hlsl", "Shaders and shaders", "case")]
        public void A_file_name_that_another_system_cannot_hold_is_named(string file, string what, string why)
            => copy.Catches(new FileNamesRule(), () => copy[file] = "", what, why);

        [Test]
        public void A_path_too_long_for_Windows_is_named()
            => copy.Catches(new FileNamesRule(), () => copy["Shaders/" + new string('a', 140)] = "", "148 characters");

        [Test]
        public void A_file_of_six_megabytes_is_named()
            => copy.Catches(new FileNamesRule(), () => copy.Write("Documentation~/images/big.png", new byte[6_000_000]), "big.png",
            "6,000,000 bytes");

        [Test]
        public void Another_version_than_the_change_log_s_is_told()
            => copy.Catches(new ManifestRule(), () => copy["CHANGELOG.md"] = "## [Unreleased]\n\n## [0.0.9] - 2026-11-21\n",
            "CHANGELOG.md", "0.0.9", "0.1.0");

        [TestCase("# Changelog\n")]
        [TestCase("## [Unreleased]\n\n## Version 0.1.0\n")]
        public void A_change_log_without_a_version_is_told(string text)
            => copy.Catches(new ManifestRule(), () => copy["CHANGELOG.md"] = text, "CHANGELOG.md", "not of the form");

        [Test]
        public void Before_the_first_release_the_change_log_may_have_none()
        {
            copy["CHANGELOG.md"] = "## [Unreleased]\n\n### Added\n";
            Assert.That(copy.Examine(new ManifestRule()).Faults, Is.Empty);
        }

        [TestCase("\"version\": \"0.1.0\"", "\"version\": \"0.1\"", "version", "0.1")]
        [TestCase("com.rill.fluids", "Rill Fluids", "name", "com.company.package")]
        [TestCase("\"displayName\": \"Rill Fluids\",", "", "displayName", "package.json")]
        [TestCase("1.2.6", "^1.2.6", "com.unity.mathematics", "^1.2.6")]
        [TestCase("\"keywords\": [", "\"keywords\": [[", "package.json", "cannot be read")]
        public void A_wrong_field_of_the_manifest_is_named(string what, string with, string word, string other)
            => copy.Catches(new ManifestRule(), () => copy.Replace(Manifest, what, with), word, other);

        [Test]
        public void A_sample_that_is_not_there_is_named()
            => copy.Catches(new ManifestRule(), () => copy.Replace(Manifest, "Samples~/Column", "Samples~/Colum"), "Samples~/Colum",
            "no such folder");

        [Test]
        public void A_sample_that_is_not_listed_is_named()
            => copy.Catches(new ManifestRule(), () => copy["Samples~/New/New.unity"] = "", "Samples~/New", "not among the samples");

        [Test]
        public void A_script_that_no_project_compiles_here_is_named() =>
            copy.Catches(new AssemblyDefinitionsRule(),
            () => copy.Replace("Headless~/Package/Rill/Rill.csproj", "Runtime/**/*.cs", "Runtime/Solver/**/*.cs"), "lacks scripts",
            "Runtime/Simulation/FluidSimulation.cs");

        [Test]
        public void A_reference_that_only_the_project_has_is_named() =>
            copy.Catches(new AssemblyDefinitionsRule(), () => copy.Replace("Runtime/Rill.asmdef", "\"Unity.Mathematics\"", ""),
            "Rill.csproj has references", "Unity.Mathematics");

        [Test]
        public void A_test_assembly_that_players_would_contain_is_named() =>
            copy.Catches(new AssemblyDefinitionsRule(),
            () => copy.Replace("Tests/Runtime/Rill.Tests.asmdef", "UNITY_INCLUDE_TESTS", "OTHER"), "Rill.Tests.asmdef",
            "UNITY_INCLUDE_TESTS");

        [Test]
        public void A_test_assembly_that_does_not_ask_for_the_framework_is_named() =>
            copy.Catches(new AssemblyDefinitionsRule(), () => copy.Replace("Tests/Physics/Rill.Physics.Tests.asmdef", "com.unity.test-framework",
            "com.unity.other"), "Rill.Physics.Tests.asmdef", "com.unity.test-framework");

        [TestCase("UNITY_INCLUDE_TESTS || RILL_TESTING", "OTHER", "every player contains it")]
        [TestCase("UNITY_INCLUDE_TESTS || RILL_TESTING", "UNITY_INCLUDE_TESTS", "testables")]
        public void Assertions_that_players_contain_or_projects_lack_are_named(string what, string with, string why) =>
            copy.Catches(new AssemblyDefinitionsRule(), () => copy.Replace("Testing/Rill.Testing.asmdef", what, with), "Rill.Testing.asmdef", why);

        [Test]
        public void Editor_code_that_players_would_compile_is_named() =>
            copy.Catches(new AssemblyDefinitionsRule(), () => copy.Replace("Editor/Rill.Editor.asmdef", "\"Editor\"\n", "\n"),
            "Rill.Editor.asmdef", "includePlatforms");

        [Test]
        public void A_script_outside_of_every_assembly_is_named()
            => copy.Catches(new AssemblyDefinitionsRule(), () => copy["Shaders/Stray.cs"] = "class Stray { }", "Shaders/Stray.cs",
            "no folder with an .asmdef");

        [Test]
        public void An_assembly_definition_that_is_no_json_is_named()
            => copy.Catches(new AssemblyDefinitionsRule(), () => copy["Runtime/Rill.asmdef"] = "{", "Runtime/Rill.asmdef cannot be read");

        [Test]
        public void A_component_in_a_file_of_another_name_is_named() =>
            copy.Catches(new ScriptNamesRule(), () => copy.Move("Runtime/Simulation/Filling/FluidVolume.cs", "Runtime/Simulation/Filling/Volume.cs"),
            "Rill.FluidVolume", "FluidVolume.cs");

        [Test]
        public void A_reference_to_a_guid_that_nothing_has_is_named_with_its_line() => copy.Catches(new ReferencesRule(), () =>
        {
            string script = copy["Runtime/Simulation/Filling/FluidVolume.cs.meta"].Split('\n').First(line => line.StartsWith("guid: "))
                .Substring(6).Trim();
            copy.Replace(Scene, script, "0123456789abcdef0123456789abcdef");
        }, "DamBreak.unity(", "0123456789abcdef0123456789abcdef");

        [Test]
        public void A_reference_to_an_object_that_the_file_lacks_is_named()
            => copy.Catches(new ReferencesRule(),
            () => copy[Scene] += "--- !u!114 &987\nMonoBehaviour:\n  m_GameObject: {fileID: 12345678}\n", "DamBreak.unity(",
            "{fileID: 12345678}");

        [Test]
        public void A_scene_that_is_no_yaml_is_named()
            => copy.Catches(new ReferencesRule(), () => copy[Scene] = "binary", "DamBreak.unity", "Force Text");

        [Test]
        public void A_stored_field_that_the_class_lacks_is_named()
            => copy.Catches(new ScriptFieldsRule(), () => copy.Replace(Scene, "particleSpacing:", "particleDistance:"), "particleDistance",
            "FluidSimulation");

        [TestCase("10303", "f", "Default-Material.mat")]
        [TestCase("10306", "f", "Default-Line.mat")]
        public void A_built_in_material_is_named(string id, string guid, string what) =>
            copy.Catches(new PipelineMaterialsRule(), () => copy.Replace(Bodies, MaterialOf("Ball"),
            $"{{fileID: {id}, guid: 0000000000000000{guid}000000000000000, type: 0}}"), "FloatingBodies.unity(", "MeshRenderer", what, "pink");

        [Test]
        public void A_material_with_a_built_in_shader_is_named() =>
            copy.Catches(new PipelineMaterialsRule(), () => copy.Replace("Samples~/Floating Bodies/Ball.mat",
            copy["Samples~/Floating Bodies/Ball.mat"].Split('\n').First(line => line.Contains("m_Shader")).Trim(),
            "m_Shader: {fileID: 46, guid: 0000000000000000f000000000000000, type: 0}"), "Ball.mat(", "Standard", "pink");

        [Test]
        public void A_sky_that_a_renderer_has_is_named() =>
            copy.Catches(new PipelineMaterialsRule(), () => copy.Replace("Samples~/Floating Bodies/Ball.mat",
            copy["Samples~/Floating Bodies/Ball.mat"].Split('\n').First(line => line.Contains("m_Shader")).Trim(),
            "m_Shader: {fileID: 106, guid: 0000000000000000f000000000000000, type: 0}"), "FloatingBodies.unity(", "MeshRenderer", "sky", "pink");

        [Test]
        public void A_renderer_without_a_material_is_named() =>
            copy.Catches(new PipelineMaterialsRule(), () => copy.Replace(Bodies, MaterialOf("Plank"), "{fileID: 0}"), "FloatingBodies.unity(",
            "MeshRenderer lacks a material");

        [TestCase("HDRenderPipeline")]
        [TestCase("UniversalPipeline")]
        public void A_material_whose_shader_lacks_a_pipeline_is_named(string pipeline) =>
            copy.Catches(new PipelineMaterialsRule(), () => copy.Replace("Samples~/Waterspout/ParticleGlints.shader",
            $"\"RenderPipeline\" = \"{pipeline}\"", "\"RenderPipeline\" = \"Other\""), "Glints.mat(", "ParticleGlints.shader",
            "no SubShader for " + pipeline);

        [TestCase("--- !u!157 &3", "--- !u!156 &3", "LightmapSettings")]
        [TestCase("--- !u!196 &4", "--- !u!195 &4", "NavMeshSettings")]
        [TestCase("m_GIWorkflowMode: 1", "m_GIWorkflowMode: 0", "baked as the scene is opened")]
        public void A_scene_without_its_settings_is_named(string what, string with, string why)
            => copy.Catches(new SceneSettingsRule(), () => copy.Replace(Scene, what, with), "DamBreak.unity", why);

        [TestCase(" (887be4894c44)", "")]
        [TestCase("m_EditorVersionWithRevision: 2022.3.22f1", "m_EditorVersionWithRevision: 2022.3.21f1")]
        public void A_test_project_whose_editor_the_Hub_cannot_offer_is_told(string what, string with)
            => copy.Catches(new TestProjectRule(), () => copy.Replace("TestProject~/ProjectSettings/ProjectVersion.txt", what, with),
            "ProjectVersion.txt", "m_EditorVersionWithRevision");

        string MaterialOf(string body) => "{fileID: 2100000, guid: " + copy[$"Samples~/Floating Bodies/{body}.mat.meta"].Split('\n')
            .First(line => line.StartsWith("guid: ")).Substring(6) + ", type: 2}";

        [Test]
        public void A_file_that_only_developers_need_is_not_shipped()
            => copy.Catches(new TarballRule(), () => copy.Replace(".npmignore", "/Headless~/", ""), "Headless~/Package/Rill/Rill.csproj",
            "shipped");

        [Test]
        public void A_file_that_users_need_is_shipped()
            => copy.Catches(new TarballRule(), () => copy[".npmignore"] += "\n/Samples~/\n", "DamBreak.unity", "would not be shipped");

        [TestCase("Packages/manifest.json", "Packages/")]
        [TestCase("ProjectSettings/ProjectVersion.txt", "ProjectSettings/")]
        [TestCase("Assets/Scene.unity", "Assets/")]
        public void A_root_that_Unity_would_open_as_a_project_is_told(string file, string folder)
            => copy.Catches(new RootRule(), () => copy[file] = "", folder, "TestProject~");

        [Test]
        public void A_test_project_without_testables_is_told()
            => copy.Catches(new TestProjectRule(), () => copy.Replace("TestProject~/Packages/manifest.json", "testables", "untestables"),
            "testables", "com.rill.fluids");

        [Test]
        public void A_test_project_over_another_folder_is_told()
            => copy.Catches(new TestProjectRule(), () => copy.Replace("TestProject~/Packages/manifest.json", "file:../..", "file:../../.."),
            "file:../../..");

        [TestCase("[there](nowhere.md)", "nowhere.md")]
        [TestCase("![picture](images/nothing.png)", "images/nothing.png")]
        [TestCase("[above](../../secret.md)", "../../secret.md")]
        [TestCase("[part](solver.md#no-such-part)", "no heading of that name")]
        public void A_link_that_leads_nowhere_is_named(string link, string what)
            => copy.Catches(new LinksRule(), () => copy["Documentation~/index.md"] += "\n" + link + "\n", "Documentation~/index.md(", what);

        [TestCase("Documentation~/", "TableOfContents.md")]
        [TestCase("Research~/", "README.md")]
        public void A_page_that_its_table_of_contents_lacks_is_named(string folder, string contents)
            => copy.Catches(new LinksRule(), () => copy[folder + "lost.md"] = "# Lost\n", folder + "lost.md", folder + contents);
    }
}
