using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Host.Assets;
using Host.Baking;
using Host.Check.Build;
using Host.Commands;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>The rules about what a build contains see the faults that they exist for.</summary>
    public class CheckBuildTests
    {
        const string Scene = "Samples~/Tap and Basin/TapAndBasin.unity";

        PackageCopy copy;

        [SetUp]
        public void CopyThePackage() => copy = new PackageCopy();

        [TearDown]
        public void RemoveTheCopy() => copy.Dispose();

        [TestCase("Runtime/Resources/Rill/More.asset")]
        [TestCase("Tests/Runtime/resources/Probe.compute")]
        [TestCase("Samples~/Column/Resources/Notes.txt")]
        public void An_asset_that_every_build_would_contain_is_named(string file)
            => copy.Catches(new ResourcesRule(), () => copy[file] = "", file, "every build contains it");

        [Test]
        public void A_scene_without_a_stage_that_it_needs_is_named() =>
            copy.Catches(new SceneReferencesRule(), () => copy.Replace(Scene, $"    - {Reference("CoarseSolver")}\n", ""), Scene,
            "FluidSimulation 'Fluid'", "CoarseGrid, CoarseColliders", "CoarseGrid, CoarseSolver, CoarseColliders", "references --write");

        [Test]
        public void A_scene_with_a_stage_that_it_does_not_need_is_named() =>
            copy.Catches(new SceneReferencesRule(),
            () => copy.Replace(Scene, $"    - {Reference("Drains")}\n", $"    - {Reference("Drains")}\n    - {Reference("MeshSdf")}\n"),
            Scene, "FluidDrain 'Outlet'", "refers to Drains, MeshSdf in shaders.stages, and a build to Drains");

        [Test]
        public void A_setting_that_needs_another_stage_than_the_scene_has_is_named() =>
            copy.Catches(new SceneReferencesRule(), () => copy.Replace(Scene, "    vorticity: 0\n", "    vorticity: 1\n"),
            "FluidSimulation 'Fluid'", "VorticityConfinement");

        [TestCase("Rendering.Universal", "Rill.Universal has UniversalSurfaces.Listen")]
        [TestCase("Rendering.HighDefinition", "Rill.HighDefinition has HighDefinitionSurfaces.Listen")]
        public void A_pipeline_s_hook_in_an_assembly_that_a_build_may_drop_is_named(string folder, string what) =>
            copy.Catches(new StrippingRule(), () => copy.Replace($"Runtime/{folder}/AssemblyInfo.cs", "[assembly: AlwaysLinkAssembly]", ""),
            what, "AlwaysLinkAssembly", $"Runtime/{folder}/AssemblyInfo.cs");

        [TestCase("", "[UnityEngine.RuntimeInitializeOnLoadMethod]", 1)]
        [TestCase("", "[UnityEngine.Scripting.Preserve]", 1)]
        [TestCase("", "", 0)]
        [TestCase("[assembly: UnityEngine.Scripting.AlwaysLinkAssembly]", "[UnityEngine.RuntimeInitializeOnLoadMethod]", 0)]
        public void A_hook_in_an_assembly_that_a_build_may_drop_is_named(string ofAssembly, string ofMethod, int faults)
        {
            using (var planted = new PlantedAssemblies())
            {
                planted.Bring("UnityEngine");
                planted.Compile("Planted", $"{ofAssembly} static class Hook {{ {ofMethod} static void Install() {{ }} }}");
                planted.Write("Runtime/Planted.asmdef", "{ \"name\": \"Planted\" }");
                Assert.That(planted.Examine(new StrippingRule()).Faults, faults == 0 ? (NUnit.Framework.Constraints.IResolveConstraint)Is.Empty
                    : Has.Count.EqualTo(1).And.Some.Contains("Planted has Hook.Install"));
            }
        }

        [Test]
        public void The_command_stores_what_is_missing_and_nothing_else()
        {
            string stored = copy[Scene];
            copy.Replace(Scene, $"    - {Reference("CoarseSolver")}\n", "");
            Assert.That(ReferencesCommand.Execute(Tree(), false, TextWriter.Null), Is.EqualTo(1));
            Assert.That(copy[Scene], Is.Not.EqualTo(stored));
            Assert.That(ReferencesCommand.Execute(Tree(), true, TextWriter.Null), Is.Zero);
            Assert.That(copy[Scene], Is.EqualTo(stored));
        }

        [Test]
        public void Every_stage_asset_belongs_to_one_group_and_to_the_asset_of_all_shaders()
        {
            string[] assets = Directory.GetFiles(Path.Combine(copy.Root, "Runtime/Stages"), "*.asset")
                .Select(Path.GetFileNameWithoutExtension).ToArray();
            Assert.That(InspectorFixture.Stages, Is.EquivalentTo(assets));
            foreach (string asset in assets)
                Assert.That(copy["Runtime/FluidShaders.asset"], Does.Contain(Reference(asset)), asset);
        }

        Host.Check.PackageTree Tree() => new Host.Check.PackageTree(copy.Root);

        string Reference(string stage) => $"{{fileID: 11400000, guid: " +
            $"{copy[$"Runtime/Stages/{stage}.asset.meta"].Split('\n').First(line => line.StartsWith("guid: ")).Substring(6)}, type: 2}}";
    }

    /// <summary>A sample from which a stage was taken, played as a player would.</summary>
    public class MissingStageSceneTests : GraphicsFixture
    {
        [Test]
        public void A_scene_that_lacks_a_stage_says_so_by_name_and_plays_on()
        {
            using (var copy = new PackageCopy())
            {
                const string scene = "Samples~/Tap and Basin/TapAndBasin.unity";
                string guid = copy["Runtime/Stages/Colliders.asset.meta"].Split('\n').First(line => line.StartsWith("guid: ")).Substring(6);
                copy.Replace(scene, $"    - {{fileID: 11400000, guid: {guid}, type: 2}}\n", "");
                LogAssert.Expect(LogType.Error, new Regex("goes on without colliders"));
                using (new SampleScene(Path.Combine(copy.Root, scene)))
                {
                    for (int i = 0; i < 4; i++)
                        Frame();
                    Assert.That(Logged.Count(line =>
                        line.Contains("FluidSimulation 'Fluid' goes on without colliders: the shaders of the stage 'Colliders'")),
                        Is.EqualTo(1), string.Join("\n", Logged));
                    Assert.That(Object.FindObjectOfType<FluidSimulation>().StepCount, Is.EqualTo(4));
                }
            }
        }
    }

    /// <summary>Prefabs of a project with the package, as they are when a build begins, and after the menu's command.</summary>
    public class PrefabBuildTests : AssetFixture
    {
        const string Prefab = "Assets/Tap.prefab", Emitter = "Runtime/Components/FluidEmitter.cs";
        static readonly string Package = PackageFolder.Path;

        [TearDown]
        public void Unlock() => AssetDatabase.Locked.Clear();

        [Test]
        public void A_build_names_a_prefab_without_the_stages_that_it_uses_and_writes_nothing()
        {
            Project("Assets", "  lifetime: 2\n", Emitter);
            LogAssert.Expect(LogType.Warning, new Regex("^Rill: the prefab Assets/Tap.prefab uses stages that its file does not refer to.*: " +
                "Emitters, Drains. Run Tools > Rill > Update Prefabs and build again.$"));
            Build();
            Assert.That(PrefabUtility.Saved, Is.Empty);
        }

        [Test]
        public void The_menu_saves_a_prefab_with_the_stages_that_it_uses()
        {
            ProjectAssets project = Project("Assets", "  lifetime: 2\n", Emitter);
            LogAssert.Expect(LogType.Log, "Rill: the prefab Assets/Tap.prefab now refers to the stages Emitters, Drains.");
            Update();
            Assert.That(PrefabUtility.Saved, Is.EqualTo(new[] { Prefab }));
            IUsesFeatures emitter = project.LoadAtPath<FluidEmitter>(Prefab);
            Assert.That(emitter.StageReferences.Stages.Select(stage => stage.name), Is.EqualTo(new[] { "Emitters", "Drains" }));
        }

        [Test]
        public void A_prefab_that_refers_to_its_stages_is_left_alone()
        {
            Project("Assets",
                $"  shaders:\n    stages:\n    - {{fileID: 11400000, guid: {Guid("Runtime/Stages/Emitters.asset")}, type: 2}}\n", Emitter);
            Build();
            LogAssert.Expect(LogType.Log, "Rill: each prefab refers to the stages that it uses.");
            Update();
            Assert.That(PrefabUtility.Saved, Is.Empty);
        }

        [Test]
        public void A_prefab_of_other_scripts_is_left_alone_and_not_even_loaded()
        {
            ProjectAssets project = Project("Assets", "  size: 2\n", null);
            Build();
            Assert.That(PrefabUtility.Saved, Is.Empty);
            Assert.That(project.IsLoaded(Prefab), Is.False);
        }

        [Test]
        public void A_prefab_that_has_another_in_it_is_not_saved_for_the_stages_of_that_one()
        {
            Project("Assets", "", Emitter, Nesting);
            LogAssert.Expect(LogType.Warning, new Regex("the prefab Assets/Kitchen.prefab uses stages"));
            LogAssert.Expect(LogType.Warning, new Regex("the prefab Assets/Tap.prefab uses stages"));
            Build();
            LogAssert.Expect(LogType.Log, "Rill: the prefab Assets/Tap.prefab now refers to the stages Emitters.");
            // The host writes no files: the one around it lacks the stages still.
            LogAssert.Expect(LogType.Log, "Rill: the prefab Assets/Kitchen.prefab now refers to the stages Emitters.");
            Update();
            Assert.That(PrefabUtility.Saved, Is.EqualTo(new[] { Prefab, "Assets/Kitchen.prefab" }), "that one first");
        }

        [Test]
        public void A_prefab_around_another_that_has_its_stages_needs_none()
        {
            Project("Assets",
                $"  shaders:\n    stages:\n    - {{fileID: 11400000, guid: {Guid("Runtime/Stages/Emitters.asset")}, type: 2}}\n", Emitter, Nesting);
            Build();
        }

        [TestCase("Packages/com.other", false)]
        [TestCase("Assets", true)]
        public void A_prefab_that_cannot_be_written_is_named_with_the_remedy(string folder, bool isLocked)
        {
            Project(folder, "", Emitter);
            if (isLocked)
                AssetDatabase.Locked.Add(Prefab);
            LogAssert.Expect(LogType.Warning, new Regex($"^Rill: the prefab {folder}/Tap.prefab lacks the stages Emitters, and its file cannot be " +
                "written. .*FluidShaders.*Preloaded Assets"));
            Update();
            Assert.That(PrefabUtility.Saved, Is.Empty);
        }

        // A prefab that is nothing but an instance of the other.
        const string Nesting = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!1001 &100\nPrefabInstance:\n  m_ObjectHideFlags: 0\n" +
            "  serializedVersion: 2\n  m_Modification:\n    m_TransformParent: {fileID: 0}\n    m_Modifications: []\n    m_RemovedComponents: []\n" +
            "  m_SourcePrefab: {fileID: 100100000, guid: e0000000000000000000000000000009, type: 3}\n";

        static void Build()
        {
            EditorInitializers.Run();
            PrefabUtility.Saved.Clear();
            new PrefabBuildStep().OnPreprocessBuild(null);
        }

        static void Update()
        {
            EditorInitializers.Run();
            PrefabUtility.Saved.Clear();
            PrefabBuildStep.UpdatePrefabs();
        }

        // A prefab of one object with one component, in a folder beside the package, and one around it.
        ProjectAssets Project(string folder, string fields, string script, string around = null)
        {
            TemporaryProject files = Temporary()
                .Write("Assets/Tap.prefab", TemporaryProject.SceneText(fields, script == null ? TemporaryProject.PartGuid : Guid(script)),
                "e0000000000000000000000000000009");
            if (around != null)
                files.Write("Assets/Kitchen.prefab", around, "e0000000000000000000000000000010");
            var mounts = new List<MountedFolder> { new("Packages/com.rill.fluids", Package), new(folder, Path.Combine(files.Root, "Assets")) };
            var project = new ProjectAssets(mounts, new[] { typeof(FluidEmitter).Assembly, typeof(AssetFixture).Assembly }, strict: true);
            Play(project, files.Root);
            return project;
        }

        static string Guid(string file) => File.ReadAllLines(Path.Combine(Package, file + ".meta"))[1].Substring(6);
    }

    /// <summary>Output of <c>rill explain</c> about builds.</summary>
    public class ExplainBuildTests : GraphicsFixture
    {
        [Test]
        public void The_stages_of_a_build_are_listed_with_what_asks_for_them()
        {
            using (new SampleScene("Tap and Basin"))
            {
                var text = new StringWriter();
                ExplainCommand.WriteBuild(Object.FindObjectsOfType<MonoBehaviour>(true), text);
                string[] lines = text.ToString().Split('\n');
                Assert.That(lines, Has.Some.Match("^      Colliders: [0-9]+ kernels.*, for FluidCollider 'Basin' and 'Cup'$"));
                Assert.That(lines, Has.Some.Match("^      Water: .*the shader Rill/Water.*, for FluidSurface 'Fluid'$"));
                Assert.That(lines, Has.None.Contains("Viscoelasticity"));
            }
        }
    }
}
