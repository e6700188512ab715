using System;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Baking;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Host.Tests
{
    /// <summary>The command <c>bake</c> on a scene: which colliders are baked, and what its file then says.</summary>
    public class SceneBakeTests : AssetFixture
    {
        // GUID of the package's FluidCollider.cs.
        const string ColliderScript = "fe5b6666c01393a8a1bd54979e9c559e";
        const int Cube = 10202, Sphere = 10207;

        string pictures;

        [SetUp]
        public void Start() => pictures = Directory.CreateTempSubdirectory("rill-slices-").FullName;

        [TearDown]
        public void End() => Directory.Delete(pictures, recursive: true);

        /// <summary>An object with a collider and, unless the mesh is 0, a mesh filter; ids count up from the first.</summary>
        static string Solid(int id, string name, int shape, int mesh, string field = "{fileID: 0}") =>
            $"--- !u!1 &{id}\nGameObject:\n  m_Component:\n  - component: {{fileID: {id + 1}}}\n  - component: {{fileID: " +
            $"{id + 2}}}\n{(mesh == 0 ? "" : $"  - component: {{fileID: {id + 3}}}\n")}  m_Name: {name}\n  m_IsActive: 1\n"
            + $"--- !u!4 &{id + 1}\nTransform:\n  m_GameObject: {{fileID: {id}}}\n  m_Father: {{fileID: 0}}\n"
            + $"--- !u!114 &{id + 2}\nMonoBehaviour:\n  m_GameObject: {{fileID: {id}}}\n  m_Enabled: 1\n  m_Script: {{fileID: " +
            $"11500000, guid: {ColliderScript}, type: 3}}\n  m_Name: \n  shape: {shape}\n  height: 2\n  field: {field}\n  bounce: 0\n"
            + (mesh == 0 ? "" : $"--- !u!33 &{id + 3}\nMeshFilter:\n  m_GameObject: {{fileID: {id}}}\n  m_Mesh: {{fileID: {mesh}, " +
            $"guid: 0000000000000000e000000000000000, type: 0}}\n");

        TemporaryProject Project(string solids)
            => Temporary().Write("Assets/Quay/Main.unity", TemporaryProject.Header + solids, "a0000000000000000000000000000001");

        SceneBakeRun Bake(string root, out string said, bool again = false, int resolution = 12)
        {
            var assets = new ProjectAssets(ProjectFolders.Of(root).Concat(ProjectFolders.Of(Session.Root())),
                new[] { typeof(FluidCollider).Assembly, typeof(AssetFixture).Assembly }, strict: true);
            Play(assets, root);
            var scene = new LocatedScene { Root = root, File = Path.Combine(root, "Assets/Quay/Main.unity"), AssetPath = "Assets/Quay/Main.unity" };
            SceneManager.LoadNow(scene.AssetPath, LoadSceneMode.Single);
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            var output = new StringWriter();
            var run = new SceneBakeRun(scene, assets, settings, again, pictures, output);
            run.Run();
            said = output.ToString();
            TestContext.WriteLine(said);
            return run;
        }

        static string Line(string said, string name) => said.Split('\n').Single(line => line.StartsWith(name + ":", StringComparison.Ordinal));

        static string[] Files(string root) => Directory.GetFiles(Path.Combine(root, "Assets/Quay")).Select(Path.GetFileName)
            .OrderBy(f => f, StringComparer.Ordinal).ToArray();

        [Test]
        public void Colliders_without_a_field_get_one_each_mesh_once_and_the_scene_refers_to_it() => WithDevice(() =>
        {
            string root = Project(Solid(100, "Pier", 4, Cube) + Solid(200, "Pole", 4, Cube) + Solid(300, "Ball", 4, Sphere)
                + Solid(400, "Box", 1, Cube)).Root;
            string before = File.ReadAllText(Path.Combine(root, "Assets/Quay/Main.unity"));
            SceneBakeRun run = Bake(root, out string said);
            Assert.That((run.Baked, run.Failures), Is.EqualTo((2, 0)));
            Assert.That(said, Does.Contain("3 mesh colliders"));
            Assert.That(Line(said, "Pier"), Does.Contain("no field; 12 triangles, watertight").And.Contain(
                "baked: 12 x 12 x 12 voxels").And.Contain("assigned in Main.unity"));
            Assert.That(Line(said, "Pole"), Does.Contain("shares the field above, assigned"));
            Assert.That(Files(root), Is.EqualTo(new[] { "Cube Distances.asset", "Cube Distances.asset.meta", "Main.unity",
                "Main.unity.meta", "Sphere Distances.asset", "Sphere Distances.asset.meta" }));
            Assert.That(Directory.GetFiles(pictures).Select(Path.GetFileName),
                Is.EquivalentTo(new[] { "Cube Distances-slices.png", "Sphere Distances-slices.png" }));

            // Three lines have changed and nothing else.
            string[] old = before.Split('\n'), now = File.ReadAllText(Path.Combine(root, "Assets/Quay/Main.unity")).Split('\n');
            Assert.That(now.Length, Is.EqualTo(old.Length));
            Assert.That(now.Where((line, i) => line != old[i]).ToArray(),
                Has.Length.EqualTo(3).And.All.StartsWith("  field: {fileID: 11400000, guid: "));

            SceneBakeRun second = Bake(root, out said);
            Assert.That((second.Baked, second.Failures), Is.EqualTo((0, 0)));
            foreach (string name in new[] { "Ball", "Pier", "Pole" })
                Assert.That(Line(said, name), Does.Contain("up to date"));
            FluidCollider pier = UnityEngine.Object.FindObjectsOfType<FluidCollider>().Single(c => c.name == "Pier");
            Assert.That((pier.Field.SourceMesh, pier.Field.SourceMeshId), Is.EqualTo(("0000000000000000e000000000000000", (long)Cube)));
            Assert.That(pier.Field.TrySample(Vector3.zero, out float center) && center < -0.4f);

            Assert.That(Bake(root, out said, again: true, resolution: 40).Baked, Is.EqualTo(2));
            Assert.That(Line(said, "Pier"), Does.Contain("asked for").And.Contain("12 x 12 x 12").And.Contain("in place"),
                "with the settings that it had");
            Assert.That(Line(said, "Pole"), Does.Contain("shares the field above"));
        });

        [Test]
        public void A_stale_field_is_baked_in_place_and_one_of_two_meshes_is_refused() => WithDevice(() =>
        {
            string root = Project(Solid(100, "Pier", 4, Cube) + Solid(200, "Pole", 4, Cube)).Root,
                scene = Path.Combine(root, "Assets/Quay/Main.unity");
            Bake(root, out _);
            string meta = File.ReadAllText(Path.Combine(root, "Assets/Quay/Cube Distances.asset.meta"));
            string text = File.ReadAllText(scene);
            int at = text.IndexOf("fileID: 10202", StringComparison.Ordinal);
            File.WriteAllText(scene, text.Remove(at, 13).Insert(at, "fileID: 10207"));

            SceneBakeRun run = Bake(root, out string said, resolution: 30);
            Assert.That((run.Baked, run.Failures), Is.EqualTo((1, 1)));
            Assert.That(Line(said, "Pier"), Does.Contain("the mesh has changed").And.Contain("12 x 12 x 12 voxels").And.Contain("in place"));
            Assert.That(Line(said, "Pole"), Does.Contain("ERROR").And.Contain("baked from 'Sphere' for another collider").And.Contain(
                "assign a field of its own"));
            Assert.That(File.ReadAllText(Path.Combine(root, "Assets/Quay/Cube Distances.asset.meta")), Is.EqualTo(meta), "it keeps its GUID");
        });

        const string PierPrefab = "a0000000000000000000000000000002", RowPrefab = "a0000000000000000000000000000003",
            ThickPrefab = "a0000000000000000000000000000004";

        /// <param name="changes">The list as Unity writes it, from the end of its name on.</param>
        static string Instance(long id, string prefab, string changes = " []\n") =>
            $"--- !u!1001 &{id}\nPrefabInstance:\n  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Modification:\n    " +
            $"serializedVersion: 3\n    m_TransformParent: {{fileID: 0}}\n    m_Modifications:{changes}"
            + $"    m_RemovedComponents: []\n    m_AddedComponents: []\n  m_SourcePrefab: {{fileID: 100100000, guid: {prefab}, type: 3}}\n";

        static string Change(long target, string prefab, string path, string value, string reference = "{fileID: 0}") =>
            $"    - target: {{fileID: {target}, guid: {prefab},\n        type: 3}}\n      propertyPath: {path}\n      value: {value}\n " +
            $"     objectReference: {reference}\n";

        // A prefab, one with an instance of it, and a variant of it; the scene has what it should have of each.
        [Test]
        public void Colliders_out_of_prefabs_are_given_their_field_as_overrides_of_their_instances() => WithDevice(() =>
        {
            string pier = TemporaryProject.Header + Solid(100, "Pier", 4, Cube);
            string row = TemporaryProject.Header + Solid(500, "Row", 1, 0) + Instance(700, PierPrefab,
                "\n" + Change(100, PierPrefab, "m_Name", "Pier of the row"));
            string thick = TemporaryProject.Header + Instance(800, PierPrefab,
                "\n" + Change(100, PierPrefab, "m_Name", "Thick") + Change(103, PierPrefab, "m_Mesh", "",
                $"{{fileID: {Sphere}, guid: 0000000000000000e000000000000000, type: 0}}"));
            string solids = Instance(1000, PierPrefab) + Solid(200, "Pole", 4, Cube)
                + Instance(2000, PierPrefab, "\n" + Change(100, PierPrefab, "m_Name", "Second") + Change(102, PierPrefab, "field", "")
                    + Change(102, PierPrefab, "friction", "0.5"))
                + Instance(3000, RowPrefab, "\n" + Change(500, RowPrefab, "m_Name", "Row here")) + Instance(4000, ThickPrefab);
            string root = Project(solids).Write("Assets/Quay/Pier.prefab", pier, PierPrefab).Write("Assets/Quay/Row.prefab", row, RowPrefab)
                .Write("Assets/Quay/Thick.prefab", thick, ThickPrefab).Root;
            string scene = Path.Combine(root, "Assets/Quay/Main.unity"), before = File.ReadAllText(scene);

            SceneBakeRun run = Bake(root, out string said);
            Assert.That((run.Baked, run.Failures), Is.EqualTo((2, 0)));
            foreach (string name in new[] { "Pier", "Second", "Pier of the row", "Thick" })
                Assert.That(Line(said, name), Does.EndWith(", as an override of its prefab").Or.Contain(", as an override of its prefab;"));
            foreach ((string file, string text) in new[] { ("Pier", pier), ("Row", row), ("Thick", thick) })
                Assert.That(File.ReadAllText(Path.Combine(root, $"Assets/Quay/{file}.prefab")), Is.EqualTo(text), "prefabs stay as they are");

            // All old content is still there, but for the pole's reference, an override of none and two lists that were empty.
            string[] now = File.ReadAllText(scene).Split('\n');
            var lost = before.Split('\n').ToList();
            foreach (string line in now)
                lost.Remove(line);
            Assert.That(lost, Is.EquivalentTo(new[] { "    m_Modifications: []", "  field: {fileID: 0}",
                "      objectReference: {fileID: 0}", "    m_Modifications: []" }));
            Assert.That(now.Count(line => line == "      propertyPath: field"), Is.EqualTo(4), "one for each instance");

            SceneBakeRun second = Bake(root, out said);
            Assert.That((second.Baked, second.Failures), Is.EqualTo((0, 0)));
            FluidCollider[] colliders = UnityEngine.Object.FindObjectsOfType<FluidCollider>().Where(c => c.Shape == ColliderShape.Mesh).ToArray();
            Assert.That(colliders.Select(c => c.name), Is.EquivalentTo(new[] { "Pier", "Second", "Pier of the row", "Thick", "Pole" }));
            foreach (FluidCollider collider in colliders)
            {
                Assert.That(Line(said, collider.name == "Pier of the row" ? "Pier of the row" : collider.name), Does.Contain("up to date"));
                Assert.That(collider.Field.SourceMeshId, Is.EqualTo(collider.name == "Thick" ? (long)Sphere : Cube));
            }
            Assert.That(colliders.Single(c => c.name == "Second").Friction, Is.EqualTo(0.5f), "other overrides stay");
        });

        [Test]
        public void What_cannot_be_baked_is_named_with_the_remedy_and_the_others_are_baked() => WithDevice(() =>
        {
            string root = Project(Solid(100, "Lost", 4, 0) + Solid(200, "Pole", 4, Cube)).Root;
            SceneBakeRun run = Bake(root, out string said);
            Assert.That((run.Baked, run.Failures), Is.EqualTo((1, 1)));
            Assert.That(Line(said, "Lost"), Does.Contain("ERROR: it has no signed distance field").And.Contain(
                "no Mesh Filter").And.Contain("add one, or assign a field"));
            run = Bake(root, out said, resolution: 12);
            Assert.That((run.Baked, run.Failures), Is.EqualTo((0, 1)));
        });

        [Test]
        public void The_settings_are_checked_before_anything_is_written() => WithDevice(() =>
        {
            string root = Project(Solid(200, "Pole", 4, Cube)).Root;
            Assert.That(Assert.Throws<HostException>(() => Bake(root, out _, resolution: 2)).Message,
                Does.Contain("Resolution 2 is outside 8 to 1024"));
            Assert.That(Files(root).Length, Is.EqualTo(2));
        });

        const string Component = "--- !u!1 &7\nGameObject:\n--- !u!114 &8\nMonoBehaviour:\n  shape: 4\n  field: {fileID: 0}\n  fields: " +
            "3\n--- !u!114 &88\nMonoBehaviour:\n  field: {fileID: 0}\n";

        [TestCase("\n")]
        [TestCase("\r\n")]
        public void Only_the_line_of_the_component_changes(string newLine)
        {
            string text = Component.Replace("\n", newLine);
            string[] changed = SceneText.WithReference(text, 8, "field", "{fileID: 1}").Split(newLine), old = text.Split(newLine);
            Assert.That(Enumerable.Range(0, old.Length).Where(i => changed[i] != old[i]), Is.EqualTo(new[] { 5 }));
            Assert.That(changed[5], Is.EqualTo("  field: {fileID: 1}"));
            Assert.That(SceneText.WithReference(text, 88, "field", "{fileID: 2}"),
                Does.EndWith($"&88{newLine}MonoBehaviour:{newLine}  field: {{fileID: 2}}{newLine}"));
        }

        [TestCase("\n")]
        [TestCase("\r\n")]
        public void An_override_is_added_or_changed_in_its_own_instance_alone(string newLine)
        {
            string other = Instance(7, PierPrefab, "\n" + Change(12, PierPrefab, "field", "")), empty = Instance(8, PierPrefab),
                behind = Solid(100, "Pier", 4, Cube);
            string text = (other + empty + behind).Replace("\n", newLine);
            string added = SceneText.WithOverride(text, 8, 12, "field", "{fileID: 1}");
            string entry = $"    m_Modifications:\n    - target: {{fileID: 12, guid: {PierPrefab}, type: 3}}\n      propertyPath: " +
                $"field\n      value: \n      objectReference: {{fileID: 1}}\n";
            Assert.That(added, Is.EqualTo((other + empty.Replace("    m_Modifications: []\n", entry) + behind).Replace("\n", newLine)));
            Assert.That(SceneText.WithOverride(added, 8, 12, "field", "{fileID: 2}"), Is.EqualTo(added.Replace("{fileID: 1}", "{fileID: 2}")));
            Assert.That(SceneText.WithOverride(added, 8, 123, "field", "{fileID: 2}"),
                Is.EqualTo(added.Replace(entry.Replace("\n", newLine),
                (entry + entry.Substring(entry.IndexOf("    - ", StringComparison.Ordinal)).Replace("12,", "123,").Replace("1}", "2}"))
                .Replace("\n", newLine))), "another component of the instance");
            Assert.That(SceneText.WithOverride(text, 7, 12, "field", "{fileID: 1}"),
                Is.EqualTo((other.Replace("objectReference: {fileID: 0}", "objectReference: {fileID: 1}") + empty + behind)
                .Replace("\n", newLine)));
            string longer = SceneText.WithOverride(text, 8, 123, "fields", "{fileID: 2}");
            longer = SceneText.WithOverride(SceneText.WithOverride(longer, 8, 123, "field", "{fileID: 3}"), 8, 12, "field", "{fileID: 1}");
            Assert.That(Enumerable.Range(1, 3).Select(i => longer.Split($"objectReference: {{fileID: {i}}}").Length), Is.All.EqualTo(2),
                "ids and names that begin alike are others");
            Assert.That(SceneText.WithOverride(text, 9, 12, "field", "{fileID: 1}"), Is.Null);
        }

        [Test]
        public void A_component_without_the_field_gets_it_and_one_of_another_file_is_left()
        {
            Assert.That(SceneText.WithReference(Component, 8, "other", "{fileID: 1}"),
                Is.EqualTo(Component.Replace("  fields: 3\n", "  fields: 3\n  other: {fileID: 1}\n")));
            Assert.That(SceneText.WithReference(Component, 7, "field", "{}"), Is.Null);
            Assert.That(SceneText.WithReference(Component, 0, "field", "{}"), Is.Null);
        }
    }
}
