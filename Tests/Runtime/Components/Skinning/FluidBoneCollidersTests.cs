using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Capsules fitted to the bones of a skinned mesh.</summary>
    public class FluidBoneCollidersTests
    {
        SkinnedArm arm;
        FluidBoneColliders bones;

        [SetUp]
        public void MakeArm()
        {
            arm = new SkinnedArm();
            bones = arm.Object.AddComponent<FluidBoneColliders>();
        }

        [TearDown]
        public void Destroy() => arm.Dispose();

        [Test]
        public void Fitted_capsules_lie_on_the_surface_of_a_bent_arm_and_follow_its_bones([Values(0f, 40f, -70f)] float angle)
        {
            Assert.That(bones.Fit(), Is.EqualTo(2));
            arm.Object.transform.SetPositionAndRotation(new Vector3(1f, 2f, -3f), Quaternion.Euler(10f, 80f, 20f));
            arm.Object.transform.localScale = 2f * Vector3.one;
            arm.Bend(angle);
            float worst = 0f;
            foreach (Vector3 vertex in arm.Posed())
                worst = math.max(worst, math.abs(Distance(vertex)));
            // At the elbow a blended skin is thinner than its bones.
            Assert.That(worst, Is.LessThan((angle == 0f ? 0.1f : 0.5f) * 2f * SkinnedArm.Radius));
            Assert.That(arm.Posed().Average(vertex => math.abs(Distance(vertex))), Is.LessThan(0.1f * 2f * SkinnedArm.Radius));
        }

        [Test]
        public void Each_capsule_is_as_wide_as_its_limb_and_lies_along_it()
        {
            bones.Fit();
            foreach (FluidCollider capsule in bones.Capsules)
            {
                Assert.That(capsule.Radius, Is.EqualTo(SkinnedArm.Radius).Within(0.05f * SkinnedArm.Radius));
                Assert.That(math.abs(Vector3.Dot(capsule.transform.up, Vector3.right)), Is.GreaterThan(0.99f));
                Assert.That(capsule.Height, Is.EqualTo(0.65f).Within(0.15f), "half the arm and the round end beyond the elbow");
            }
            Assert.That(bones.Capsules[0].transform.parent, Is.SameAs(arm.Upper));
            Assert.That(bones.Capsules[1].transform.parent, Is.SameAs(arm.Lower));
        }

        [Test]
        public void Fitting_again_keeps_what_was_set_and_changes_only_what_it_made()
        {
            var own = new GameObject("Shield").AddComponent<FluidCollider>();
            own.transform.SetParent(arm.Lower, false);
            own.Radius = 3f;
            bones.Fit();
            FluidCollider upper = bones.Capsules[0], lower = bones.Capsules[1];
            upper.Friction = 0.7f;
            upper.transform.localPosition += Vector3.up;
            Vector3 moved = upper.transform.localPosition;

            Assert.That(bones.Fit(), Is.EqualTo(2));
            Assert.That(bones.Capsules[0], Is.SameAs(upper));
            Assert.That(upper.Friction, Is.EqualTo(0.7f));
            Assert.That(upper.transform.localPosition, Is.Not.EqualTo(moved));

            arm.Mesh.boneWeights = arm.Mesh.boneWeights.Select(_ => new BoneWeight { weight0 = 1f }).ToArray();
            Assert.That(bones.Fit(), Is.EqualTo(1), "all hangs on the upper arm now");
            Assert.That(lower == null, "and the lower capsule is gone");
            bones.Clear();
            Assert.That(arm.Object.GetComponentsInChildren<FluidCollider>(true), Is.EqualTo(new[] { own }));
            Assert.That(own.Radius, Is.EqualTo(3f));
        }

        [Test]
        public void A_bone_that_carries_few_vertices_gets_no_capsule()
        {
            BoneWeight[] weights = arm.Mesh.boneWeights;
            for (int i = 0; i < weights.Length; i++)
                weights[i] = new BoneWeight { boneIndex0 = i < 5 ? 1 : 0, weight0 = 1f };
            arm.Mesh.boneWeights = weights;
            bones.MinVertices = 6;
            Assert.That(bones.Fit(), Is.EqualTo(1));
            bones.MinVertices = 5;
            Assert.That(bones.Fit(), Is.EqualTo(2));
        }

        [Test]
        public void Vertices_that_are_no_numbers_do_not_count()
        {
            Vector3[] vertices = arm.Mesh.vertices;
            vertices[40] = new Vector3(float.NaN, 0f, 0f);
            vertices[41] = new Vector3(float.PositiveInfinity, 0f, 0f);
            arm.Mesh.vertices = vertices;
            Assert.That(bones.Fit(), Is.EqualTo(2));
            Assert.That(bones.Capsules[0].Radius, Is.EqualTo(SkinnedArm.Radius).Within(0.1f * SkinnedArm.Radius));
        }

        [Test]
        public void A_mesh_none_of_whose_bones_carries_enough_is_said_by_name()
        {
            bones.MinVertices = 1000;
            Refused("no bone carries 1000 vertices by 0.4 and more. Lower Min Vertices or Min Weight");
        }

        [Test]
        public void More_capsules_than_a_fluid_takes_are_refused()
        {
            const int many = 257;
            using (var large = new SkinnedArm(64, 32))
            {
                large.Renderer.bones = Enumerable.Repeat(large.Upper, many).ToArray();
                large.Mesh.bindposes = Enumerable.Repeat(Matrix4x4.identity, many).ToArray();
                large.Mesh.boneWeights = large.Mesh.vertices.Select((_, i) => new BoneWeight { boneIndex0 = i % many, weight0 = 1f })
                    .ToArray();
                var fitter = large.Object.AddComponent<FluidBoneColliders>();
                fitter.MinVertices = 4;
                LogAssert.Expect(LogType.Error, new Regex("257 bones carry 4 vertices and more, and a fluid takes 256 colliders"));
                Assert.That(fitter.Fit(), Is.Zero);
                Assert.That(fitter.Capsules, Is.Empty);
            }
        }

        [Test]
        public void A_mesh_that_cannot_be_read_or_has_no_skin_is_said_by_name()
        {
            arm.Mesh.bindposes = null;
            Refused("its mesh 'Arm' has no bind poses");
            arm.Mesh.boneWeights = null;
            Refused("its mesh 'Arm' has no bone weights");
            arm.Renderer.bones = null;
            Refused("its Skinned Mesh Renderer has no bones");
            arm.Mesh.UploadMeshData(true);
            Refused("its mesh 'Arm' cannot be read. Tick Read/Write");
            arm.Renderer.sharedMesh = null;
            Refused("its Skinned Mesh Renderer has no mesh");
        }

        [Test]
        public void Settings_out_of_range_are_clamped_and_said()
        {
            LogAssert.Expect(LogType.Warning, new Regex("FluidBoneColliders 'Arm': min weight 2 is outside 0.05 to 1"));
            bones.MinWeight = 2f;
            LogAssert.Expect(LogType.Warning, new Regex("min vertices 0 is outside 4 to"));
            bones.MinVertices = 0;
            LogAssert.Expect(LogType.Warning, new Regex("coverage 0 is outside 0.5 to 1"));
            bones.Coverage = 0f;
            LogAssert.NoUnexpectedReceived();
        }

        void Refused(string problem)
        {
            LogAssert.Expect(LogType.Error, new Regex("FluidBoneColliders 'Arm' fits nothing: " + problem));
            Assert.That(bones.Fit(), Is.Zero);
        }

        float Distance(Vector3 position) => bones.Capsules.Min(capsule =>
        {
            Assert.That(capsule.TryDescribe(out ColliderMotion motion));
            return (float)Reference.Shapes.Distance(motion, (float3)position);
        });
    }
}
