using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>Tests the action of the window's button, without the window.</summary>
    public class BakePlanTests
    {
        const string Folder = "Assets/Rill Bake Tests/Fields";

        readonly List<Object> made = new List<Object>();

        [TearDown]
        public void End()
        {
            foreach (Object one in made.Where(o => o != null))
                Object.DestroyImmediate(one);
            made.Clear();
            AssetDatabase.DeleteAsset("Assets/Rill Bake Tests");
        }

        static MeshSdfSettings Settings(int resolution)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            return settings;
        }

        GameObject Cube(string name)
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.name = name;
            made.Add(cube);
            return cube;
        }

        /// <summary>A mesh that is an asset of its own.</summary>
        Mesh MeshAsset(string name, float size = 1f, string folder = "Assets/Rill Bake Tests")
        {
            Mesh cube = Cube("Source").GetComponent<MeshFilter>().sharedMesh;
            var mesh = new Mesh { name = name, vertices = cube.vertices.Select(v => size * v).ToArray(), triangles = cube.triangles };
            Assert.That(FieldAssets.TryMakeFolder(folder));
            AssetDatabase.CreateAsset(mesh, $"{folder}/{name}.mesh");
            return mesh;
        }

        static bool GoOn(float fraction, string what) => true;

        static BakePlan Plan(params Object[] selection) => BakePlan.Of(selection, Folder, new MeshAnalyses());

        [Test]
        public void A_mesh_is_baked_once_for_all_the_objects_that_show_it()
        {
            GameObject root = Cube("Root"), child = Cube("Child"), other = Cube("Other");
            child.transform.SetParent(root.transform);
            BakePlan plan = Plan(root, other, other.GetComponent<MeshFilter>());
            BakeItem item = plan.Items.Single();
            Assert.That(item.Objects, Is.EquivalentTo(new[] { root, child, other }));
            Assert.That(item.Path, Is.EqualTo(Folder + "/Cube Distances.asset"));
            Assert.That(item.Existing, Is.Null);
            Assert.That(plan.Notes, Is.Empty);
        }

        [Test]
        public void What_has_no_mesh_is_named()
        {
            var empty = new GameObject("Empty");
            var without = new GameObject("Without", typeof(MeshFilter));
            var material = new Material(Shader.Find("Standard")) { name = "Paint" };
            made.AddRange(new Object[] { empty, without, material });
            BakePlan plan = Plan(empty, without, material, null);
            Assert.That(plan.Items, Is.Empty);
            Assert.That(plan.Notes, Is.EqualTo(new[] { "'Empty' has no Mesh Filter: left out.",
                "The Mesh Filter of 'Without' has no mesh: assign one.", "'Paint' has no mesh: left out." }));
        }

        [Test]
        public void Several_meshes_become_assets_of_their_own_with_a_report_each()
        {
            Mesh one = MeshAsset("Pot"), two = MeshAsset("Pot", 2f, "Assets/Rill Bake Tests/Others"), three = MeshAsset("Cup");
            BakePlan plan = Plan(one, two, three);
            Assert.That(plan.Items.Select(item => item.Path),
                Is.EqualTo(new[] { Folder + "/Pot Distances.asset", Folder + "/Pot Distances 2.asset", Folder + "/Cup Distances.asset" }));
            var told = new List<float>();
            Assert.That(plan.Bake(Settings(12), BakeAssign.Nothing, (fraction, what) =>
            {
                told.Add(fraction);
                return what.Contains("of 3)");
            }));
            Assert.That(told, Is.Ordered);
            Assert.That(told.Last(), Is.EqualTo(1f).Within(1e-5f));
            foreach (BakeItem item in plan.Items)
            {
                Assert.That(item.Failed, Is.False, item.Outcome);
                Assert.That(item.Outcome, Does.StartWith("12 x 12 x 12 voxels of").And.Contain("winding number, 16 bits"));
                Assert.That(AssetDatabase.LoadAssetAtPath<SignedDistanceField>(item.Path), Is.SameAs(item.Field));
                Assert.That(AssetDatabase.GetAssetPath(item.Field.Texture), Is.EqualTo(item.Path), "the texture lies in the field's file");
                Assert.That(FieldAssets.MeshOf(item.Field, out _), Is.SameAs(item.Mesh));
                Assert.That(item.Field.IsStale(TriangleMesh.Of(item.Mesh)), Is.False);
            }
            Assert.That(plan.Items[1].Field.Bounds.size.x, Is.EqualTo(2f * plan.Items[0].Field.Bounds.size.x).Within(1e-4f));
        }

        [Test]
        public void A_field_is_baked_in_place_and_keeps_its_guid_and_references()
        {
            Mesh mesh = MeshAsset("Pot");
            BakePlan first = Plan(mesh);
            first.Bake(Settings(12), BakeAssign.Nothing, GoOn);
            SignedDistanceField field = first.Items[0].Field;
            string guid = AssetDatabase.AssetPathToGUID(first.Items[0].Path);
            Texture3D before = field.Texture;
            Assert.That(guid, Is.Not.Empty);

            foreach (BakePlan again in new[] { Plan(mesh), Plan(field) })
            {
                BakeItem item = again.Items.Single();
                Assert.That(item.Existing, Is.SameAs(field), "found by its mesh, or selected itself");
                Assert.That(again.Bake(Settings(16), BakeAssign.Nothing, GoOn));
                Assert.That(item.Field, Is.SameAs(field));
            }
            Assert.That(field.Resolution, Is.EqualTo(16 * Vector3Int.one));
            Assert.That(before == null, "the texture of the old size is gone");
            Assert.That(AssetDatabase.LoadAllAssetsAtPath(first.Items[0].Path), Is.EquivalentTo(new Object[] { field, field.Texture }));
            Assert.That(AssetDatabase.AssetPathToGUID(AssetDatabase.GetAssetPath(field)), Is.EqualTo(guid));
        }

        [Test]
        public void An_asset_of_that_name_which_is_something_else_is_not_overwritten()
        {
            Plan(MeshAsset("Pot")).Bake(Settings(12), BakeAssign.Nothing, GoOn);
            Mesh second = MeshAsset("Pot", 2f, "Assets/Rill Bake Tests/Others");
            BakePlan other = Plan(second);
            Assert.That(other.Items.Single().Existing, Is.Null);
            Assert.That(other.Items.Single().Path, Is.EqualTo(Folder + "/Pot Distances 2.asset"));
            other.Bake(Settings(12), BakeAssign.Nothing, GoOn);
            Assert.That(Plan(second).Items.Single().Existing, Is.SameAs(other.Items[0].Field), "and its own is found under its number");
        }

        [Test]
        public void Names_that_no_file_may_have_are_made_ones()
        {
            Assert.That(FieldAssets.FileName("a/b: c?"), Is.EqualTo("a_b_ c_"));
            Assert.That(FieldAssets.FileName(" . "), Is.EqualTo("Mesh"));
        }

        [Test]
        public void A_bad_mesh_says_why_and_does_not_keep_the_others_from_being_baked()
        {
            var flat = new Mesh { name = "Point", vertices = new Vector3[3], triangles = new[] { 0, 1, 2 } };
            made.Add(flat);
            BakePlan plan = Plan(flat, Cube("Good"));
            Assert.That(plan.Bake(Settings(12), BakeAssign.Nothing, GoOn), Is.True);
            Assert.That(plan.Items.Select(item => item.Failed), Is.EqualTo(new[] { true, false }));
            Assert.That(plan.Items[0].Outcome, Does.Contain("'Point': none of its 1 triangles has an area").And.EqualTo(plan.Items[0].Problem));
            Assert.That(plan.Items[1].Field, Is.Not.Null);
        }

        [Test]
        public void A_mesh_that_scripts_may_not_read_is_baked_all_the_same_and_is_not_stale()
        {
            Mesh mesh = MeshAsset("Sealed");
            ulong hash = TriangleMesh.Of(mesh).Hash();
            mesh.UploadMeshData(true);
            Assert.That(mesh.isReadable, Is.False);
            BakePlan plan = Plan(mesh);
            Assert.That(plan.Bake(Settings(12), BakeAssign.Nothing, GoOn), Is.True);
            Assert.That(plan.Items[0].Failed, Is.False, plan.Items[0].Outcome);
            Assert.That(plan.Items[0].Field.SourceHash, Is.EqualTo(hash));
            Assert.That(plan.Items[0].Field.IsStale(EditorMesh.Read(mesh)), Is.False);
        }

        [Test]
        public void A_second_bake_goes_into_the_asset_of_the_first()
        {
            BakePlan plan = Plan(Cube("Good"));
            plan.Bake(Settings(12), BakeAssign.Nothing, GoOn);
            SignedDistanceField first = plan.Items[0].Field;
            plan.Bake(Settings(16), BakeAssign.Nothing, GoOn);
            Assert.That(plan.Items[0].Field, Is.SameAs(first));
            Assert.That(first.Resolution, Is.EqualTo(16 * Vector3Int.one));
        }

        [Test]
        public void The_memory_is_told_before_and_a_cap_that_is_too_low_refuses()
        {
            BakeItem item = Plan(Cube("Good")).Items.Single();
            Assert.That(item.TryEstimate(Settings(64), out _, out string early), Is.False, "before it is analyzed");
            Assert.That(early, Is.Null);
            Assert.That(item.Analysis.Finish(GoOn, out _));
            Assert.That(item.TryEstimate(Settings(64), out MeshSdfEstimate estimate, out _));
            Assert.That(BakeTexts.Of(estimate), Does.StartWith("64 x 64 x 64 voxels of").And.Contain("6.0 MiB while it bakes"));
            MeshSdfSettings settings = Settings(64);
            settings.memoryCap = 1;
            Assert.That(item.TryEstimate(settings, out _, out string problem), Is.False);
            Assert.That(problem, Does.Contain("memory cap of 1 MiB").And.Contain("raise the cap"));
            settings.padding = 0;
            Assert.That(item.TryEstimate(settings, out _, out problem), Is.False);
            Assert.That(problem, Does.Contain("Padding 0"));
            item.Bake(settings, GoOn);
            Assert.That(item.Failed && item.Outcome == problem && item.Field == null);
        }

        [Test]
        public void A_plan_that_is_canceled_keeps_what_was_done_and_writes_nothing_more()
        {
            Mesh one = MeshAsset("One"), two = MeshAsset("Two"), three = MeshAsset("Three");
            BakePlan plan = Plan(one, two, three);
            Assert.That(plan.Bake(Settings(12), BakeAssign.Nothing, (fraction, what) => fraction < 0.5f), Is.False);
            Assert.That(plan.Items[0].Field, Is.Not.Null);
            Assert.That(plan.Items[1].Outcome, Does.StartWith("Canceled"));
            Assert.That(plan.Items[2].Outcome, Is.Null);
            Assert.That(AssetDatabase.LoadAssetAtPath<SignedDistanceField>(plan.Items[1].Path), Is.Null);
        }

        [Test]
        public void A_folder_outside_of_the_project_is_refused()
        {
            BakeItem item = BakePlan.Of(new Object[] { Cube("Good") }, "Elsewhere/Fields", new MeshAnalyses()).Items.Single();
            item.Bake(Settings(12), GoOn);
            Assert.That(item.Failed && item.Outcome.Contains("choose one below Assets"), item.Outcome);
        }

        [TestCase(BakeAssign.Nothing, 0, 1)]
        [TestCase(BakeAssign.ToColliders, 1, 1)]
        [TestCase(BakeAssign.AddColliders, 2, 2)]
        public void Colliders_take_the_field_as_told(object how, int assigned, int colliders)
        {
            GameObject with = Cube("With"), without = Cube("Without");
            with.AddComponent<FluidCollider>();
            BakePlan plan = Plan(with, without);
            plan.Bake(Settings(12), (BakeAssign)how, GoOn);
            FluidCollider[] all = new[] { with, without }.Select(o => o.GetComponent<FluidCollider>()).Where(c => c != null).ToArray();
            Assert.That(all.Length, Is.EqualTo(colliders));
            Assert.That(all.Count(c => c.Shape == ColliderShape.Mesh && c.Field == plan.Items[0].Field), Is.EqualTo(assigned));
        }

        [Test]
        public void A_mesh_that_has_changed_makes_its_field_stale_however_its_triangles_are_ordered()
        {
            Mesh mesh = MeshAsset("Pot");
            BakePlan plan = Plan(mesh);
            plan.Bake(Settings(12), BakeAssign.Nothing, GoOn);
            SignedDistanceField field = plan.Items[0].Field;
            int[] t = mesh.triangles;
            // Each triangle begins with another corner, and the last comes first.
            mesh.triangles = Enumerable.Range(0, t.Length).Select(i => t[t.Length - 3 - i / 3 * 3 + (i + 1) % 3]).ToArray();
            Assert.That(field.IsStale(TriangleMesh.Of(mesh)), Is.False);
            mesh.triangles = Enumerable.Range(1, t.Length).Select(i => t[t.Length - i]).ToArray();
            Assert.That(field.IsStale(TriangleMesh.Of(mesh)), Is.True, "turned inside out");
            mesh.triangles = t;
            Vector3[] vertices = mesh.vertices;
            vertices[5] += 0.001f * Vector3.up;
            mesh.vertices = vertices;
            Assert.That(field.IsStale(TriangleMesh.Of(mesh)), Is.True, "a vertex has moved");
        }

        [Test]
        public void Facts_name_the_format_with_its_error_the_memory_and_the_source()
        {
            BakePlan plan = Plan(MeshAsset("Pot"));
            plan.Bake(Settings(16), BakeAssign.Nothing, GoOn);
            Dictionary<string, string> facts = BakeTexts.Facts(plan.Items[0].Field).ToDictionary(fact => fact.label, fact => fact.text);
            Assert.That(facts["Resolution"], Is.EqualTo("16 x 16 x 16 = 4,096 voxels"));
            Assert.That(facts["Format"], Does.Match("16 bits a voxel, error at most .* voxel"));
            Assert.That(facts["Memory"], Does.StartWith("0.0 MiB"));
            Assert.That(facts["Volume Inside"], Does.StartWith("1").Or.StartsWith("0.99"));
            Assert.That(facts["Source Mesh"], Is.EqualTo("Pot in Assets/Rill Bake Tests/Pot.mesh"));
            Assert.That(facts["Baked With"], Is.EqualTo("16 voxels along the longest axis, 3 of padding, sign automatic"));
            Assert.That(facts["Version"], Is.EqualTo("1 of 1"));
        }

        [Test]
        public void A_field_whose_mesh_is_gone_says_so()
        {
            BakePlan plan = Plan(MeshAsset("Pot"));
            plan.Bake(Settings(12), BakeAssign.Nothing, GoOn);
            AssetDatabase.DeleteAsset("Assets/Rill Bake Tests/Pot.mesh");
            BakePlan again = Plan(plan.Items[0].Field);
            Assert.That(again.Items, Is.Empty);
            Assert.That(again.Notes.Single(), Does.Contain("'Pot Distances'").And.Contain("is gone").And.Contain("choose one"));
        }
    }
}
