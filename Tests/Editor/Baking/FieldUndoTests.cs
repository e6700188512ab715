using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Editor.Tests
{
    /// <summary>A bake into a field that is there is taken back whole: what the field says and what its texture holds.</summary>
    public class FieldUndoTests
    {
        const string Root = "Assets/Rill Undo Tests";

        Mesh mesh;
        SignedDistanceField field;

        [SetUp]
        public void Begin()
        {
            Undo.ClearAll();
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            Mesh source = cube.GetComponent<MeshFilter>().sharedMesh;
            mesh = new Mesh { name = "Pot", vertices = source.vertices, triangles = source.triangles };
            Object.DestroyImmediate(cube);
            Assert.That(FieldAssets.TryMakeFolder(Root));
            AssetDatabase.CreateAsset(mesh, Root + "/Pot.mesh");
            field = Bake(12);
        }

        [TearDown]
        public void End()
        {
            Undo.ClearAll();
            AssetDatabase.DeleteAsset(Root);
        }

        SignedDistanceField Bake(int resolution)
        {
            Undo.IncrementCurrentGroup();
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            BakePlan plan = BakePlan.Of(new Object[] { mesh }, Root, new MeshAnalyses());
            plan.Bake(settings, BakeAssign.Nothing, (fraction, what) => true);
            Assert.That(plan.Items[0].Failed, Is.False, plan.Items[0].Outcome);
            return plan.Items[0].Field;
        }

        void Stretch(float factor) => mesh.vertices = mesh.vertices.Select(v => factor * v).ToArray();

        // All of it; without the texture's name.
        static (string says, Vector3Int resolution, byte[] voxels) State(SignedDistanceField field) =>
            (FormattableState(field), field.Resolution, field.Texture.GetPixelData<byte>(0).ToArray());

        static string FormattableState(SignedDistanceField field) =>
            $"{field.Version} {field.Bounds} {field.VoxelSize} {field.Sign} {field.ShellThickness} {field.StorageError} " +
            $"{field.SourceMesh} {field.SourceMeshId} {field.SourceHash} {JsonUtility.ToJson(field.Settings)} {field.Volume}";

        void AssertIs((string says, Vector3Int resolution, byte[] voxels) expected)
        {
            (string says, Vector3Int resolution, byte[] voxels) state = State(field);
            Assert.That(state.says, Is.EqualTo(expected.says));
            Assert.That(state.resolution, Is.EqualTo(expected.resolution));
            Assert.That(state.voxels.SequenceEqual(expected.voxels), "the same distances in each voxel");
            Assert.That(field.Validate(out string problem), problem);
            Assert.That(AssetDatabase.LoadAllAssetsAtPath(AssetDatabase.GetAssetPath(field)),
                Is.EquivalentTo(new Object[] { field, field.Texture }), "one texture in the file");
            Assert.That(EditorUtility.IsDirty(field), Is.False, "written, as after a bake");
        }

        [TestCase(16, 1f, TestName = "A_bake_of_another_size_is_undone_and_redone_whole")]
        [TestCase(12, 2f, TestName = "A_bake_of_the_same_size_is_undone_and_redone_whole")]
        public void Undone(int resolution, float stretched)
        {
            string guid = AssetDatabase.AssetPathToGUID(AssetDatabase.GetAssetPath(field));
            var before = State(field);
            Stretch(stretched);
            Assert.That(Bake(resolution), Is.SameAs(field));
            var after = State(field);
            Assert.That(after.voxels.SequenceEqual(before.voxels), Is.False);
            for (int i = 0; i < 2; i++)
            {
                Undo.PerformUndo();
                AssertIs(before);
                Undo.PerformRedo();
                AssertIs(after);
            }
            Assert.That(AssetDatabase.AssetPathToGUID(AssetDatabase.GetAssetPath(field)), Is.EqualTo(guid));
        }

        [Test]
        public void Several_bakes_are_undone_one_by_one_and_a_new_one_goes_on_from_there()
        {
            var states = new List<(string, Vector3Int, byte[])> { State(field) };
            foreach (int resolution in new[] { 16, 12, 20 })
            {
                Stretch(1.5f);
                Bake(resolution);
                states.Add(State(field));
            }
            foreach (int i in new[] { 2, 1 })
            {
                Undo.PerformUndo();
                AssertIs(states[i]);
            }
            Undo.PerformRedo();
            AssertIs(states[2]);
            Undo.PerformUndo();
            Bake(24);
            var other = State(field);
            Undo.PerformUndo();
            AssertIs(states[1]);
            Undo.PerformRedo();
            AssertIs(other);
            Undo.PerformUndo();
            Undo.PerformUndo();
            AssertIs(states[0]);
        }

        [Test]
        public void Distances_that_were_lost_are_told_and_the_field_says_so_with_its_settings_of_before()
        {
            Bake(16);
            var after = State(field);
            Undo.PerformUndo();
            string file = FieldUndo.FileOf(field);
            Assert.That(File.Exists(file), file);
            Undo.PerformRedo();
            File.Delete(file);
            LogAssert.Expect(LogType.Error, new Regex("'Pot Distances' has its settings of before back, but not its distances: bake it again"));
            Undo.PerformUndo();
            Assert.That(field.Settings.resolution, Is.EqualTo(12));
            Assert.That(field.Validate(out string problem), Is.False);
            Assert.That(problem, Does.Contain("has no distances"));
            Undo.PerformRedo();
            AssertIs(after);
        }

        [Test]
        public void A_field_that_another_hand_changed_stays_as_it_is()
        {
            Bake(16);
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 20;
            field.Apply(MeshSdfBaker.Bake(mesh, settings));      // as version control does
            FieldAssets.KeepTextureOf(field);
            var state = State(field);
            MoveAndUndo();
            AssertIs(state);
        }

        [Test]
        public void Another_undo_leaves_fields_alone()
        {
            Bake(16);
            var state = State(field);
            Texture3D texture = field.Texture;
            MoveAndUndo();
            Assert.That(field.Texture, Is.SameAs(texture));
            AssertIs(state);
        }

        static void MoveAndUndo()
        {
            var other = new GameObject("Other");
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(other.transform, "Move");
            other.transform.position = Vector3.one;
            Undo.PerformUndo();
            Assert.That(other.transform.position, Is.EqualTo(Vector3.zero));
            Object.DestroyImmediate(other);
        }
    }
}
