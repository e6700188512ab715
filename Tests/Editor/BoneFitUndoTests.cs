using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>The changes by Fit to Bones can be undone.</summary>
    [Category("EditMode")]
    public class BoneFitUndoTests
    {
        EditorScene scene;

        [SetUp]
        public void MakeScene() => scene = new EditorScene();

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        [Test]
        public void One_undo_removes_fitted_capsules_and_gives_edited_ones_their_sizes_back()
        {
            var renderer = scene.Add<SkinnedMeshRenderer>("Limb");
            Mesh mesh = Column();
            renderer.sharedMesh = mesh;
            renderer.bones = new[] { renderer.transform };
            var bones = renderer.gameObject.AddComponent<FluidBoneColliders>();
            bones.Clear();
            Undo.IncrementCurrentGroup();
            Assert.That(bones.Fit(), Is.EqualTo(1));
            float fitted = bones.Capsules[0].Radius;

            Undo.IncrementCurrentGroup();
            bones.Capsules[0].Radius = 7f;
            bones.Fit();
            Assert.That(bones.Capsules[0].Radius, Is.EqualTo(fitted));
            Undo.PerformUndo();
            Assert.That(bones.Capsules[0].Radius, Is.EqualTo(7f));

            Undo.PerformUndo();
            Assert.That(bones.GetComponentsInChildren<FluidCollider>(true), Is.Empty);
            Assert.That(bones.Capsules.Count(capsule => capsule != null), Is.Zero);
            Object.DestroyImmediate(mesh);
        }

        // Points around the y axis, all on one bone.
        static Mesh Column()
        {
            Vector3[] vertices = Enumerable.Range(0, 64).Select(i => Quaternion.Euler(0f, 45f * i, 0f) * Vector3.right + 0.25f * (i / 8) * Vector3.up)
                .ToArray();
            return new Mesh
            {
                name = "Column", vertices = vertices, bindposes = new[] { Matrix4x4.identity },
                boneWeights = vertices.Select(_ => new BoneWeight { weight0 = 1f }).ToArray(),
            };
        }
    }
}
