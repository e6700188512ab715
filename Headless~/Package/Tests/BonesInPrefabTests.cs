using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Fit to Bones on characters that are prefabs, which the Editor keeps as their prefab has them.</summary>
    public class BonesInPrefabTests
    {
        GameObject limb;
        Mesh mesh;
        FluidBoneColliders bones;

        [SetUp]
        public void MakeArm()
        {
            EditMode.IsOn = true;
            Vector3[] vertices = Enumerable.Range(0, 64)
                .Select(i => Quaternion.Euler(0f, 45f * i, 0f) * Vector3.right + 0.25f * (i / 8) * Vector3.up).ToArray();
            mesh = new Mesh
            {
                vertices = vertices, bindposes = new[] { Matrix4x4.identity },
                boneWeights = vertices.Select(_ => new BoneWeight { weight0 = 1f }).ToArray(),
            };
            limb = new GameObject("Limb");
            limb.SetActive(false);
            var renderer = limb.AddComponent<SkinnedMeshRenderer>();
            renderer.sharedMesh = mesh;
            renderer.bones = new[] { limb.transform };
            bones = limb.AddComponent<FluidBoneColliders>();
            bones.Fit();
        }

        [TearDown]
        public void Destroy()
        {
            Object.DestroyImmediate(limb);
            Object.DestroyImmediate(mesh);
            Undo.ClearAll();
            EditMode.IsOn = false;
        }

        [Test]
        public void Capsules_of_the_prefab_lose_their_colliders_and_are_used_again()
        {
            PrefabUtility.Connect(limb);
            FluidCollider[] before = bones.Capsules.ToArray();
            GameObject[] objects = before.Select(capsule => capsule.gameObject).ToArray();
            Assert.That(() => Object.DestroyImmediate(objects[0]), Throws.InvalidOperationException, "as Unity does");

            bones.Clear();
            Assert.That(bones.Capsules, Is.Empty);
            Assert.That(before.All(capsule => capsule == null) && objects.All(one => one != null));
            Assert.That(bones.Fit(), Is.EqualTo(1));
            Assert.That(bones.Capsules.Select(capsule => capsule.gameObject), Is.EqualTo(objects));
        }

        [Test]
        public void One_undo_brings_the_colliders_of_the_prefab_back()
        {
            PrefabUtility.Connect(limb);
            Undo.IncrementCurrentGroup();
            bones.Clear();
            Undo.PerformUndo();
            Assert.That(bones.Capsules, Has.Count.EqualTo(1));
        }

        [Test]
        public void Capsules_that_were_added_to_an_instance_go_with_their_objects()
        {
            bones.Clear();
            PrefabUtility.Connect(limb);
            bones.Fit();
            GameObject[] objects = bones.Capsules.Select(capsule => capsule.gameObject).ToArray();
            Assert.That(objects.All(PrefabUtility.IsAddedGameObjectOverride));
            bones.Clear();
            Assert.That(objects.All(one => one == null));
        }

        [Test]
        public void A_prefab_that_is_not_open_stays_as_it_is_and_says_what_to_do()
        {
            foreach (Transform part in limb.GetComponentsInChildren<Transform>(true))
                part.gameObject.SceneOf = null;         // as an asset
            int before = limb.GetComponentsInChildren<Transform>(true).Length;
            LogAssert.Expect(LogType.Error, new Regex("fits nothing: it is in a prefab that is not open. Open the prefab"));
            Assert.That(bones.Fit(), Is.Zero);
            LogAssert.Expect(LogType.Error, new Regex("removes nothing: it is in a prefab that is not open"));
            bones.Clear();
            Assert.That(bones.Capsules, Has.Count.EqualTo(1).And.All.Not.Null);
            Assert.That(limb.GetComponentsInChildren<Transform>(true), Has.Length.EqualTo(before));
        }
    }
}
