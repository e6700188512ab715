using System;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>What GameObject > Rill makes.</summary>
    public class SceneSetupTests
    {
        static readonly Func<GameObject, GameObject>[] Parts = { SceneSetup.CreateVolume, SceneSetup.CreateEmitter, SceneSetup.CreateDrain,
            SceneSetup.CreateForceField, SceneSetup.CreateProbe, SceneSetup.CreateDetector };

        EditorScene scene;

        [SetUp]
        public void MakeScene() => scene = new EditorScene();

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        [Test]
        public void A_fluid_has_all_that_it_needs_to_be_seen()
        {
            GameObject fluid = scene.Keep(SceneSetup.CreateFluid(null));
            Assert.That(Selection.activeGameObject, Is.SameAs(fluid));
            Assert.That(fluid.GetComponent<FluidSurface>() != null && fluid.GetComponent<DomainRenderer>() != null);
            var simulation = fluid.GetComponent<FluidSimulation>();
            Assert.That(FillEstimate.Particles(simulation), Is.InRange(1000, simulation.Capacity));
            Assert.That(ProblemList.Of(fluid.GetComponentsInChildren<MonoBehaviour>()), Is.Empty);
        }

        [Test]
        public void What_is_made_is_undone_in_one_step()
        {
            GameObject fluid = scene.Keep(SceneSetup.CreateFluid(null));
            foreach (Func<GameObject, GameObject> create in Parts.Append(SceneSetup.CreateCollider))
            {
                Undo.IncrementCurrentGroup();
                GameObject made = scene.Keep(create(null));
                Assert.That(Undo.GetCurrentGroupName(), Is.EqualTo($"Create {made.name}"));
                Undo.PerformUndo();
                Assert.That(made == null, "gone");
                Assert.That(fluid != null, "what was there before stays");
            }
        }

        [TestCaseSource(nameof(Parts))]
        public void A_part_is_made_below_the_selection_and_acts_on_its_fluid(Func<GameObject, GameObject> create)
        {
            scene.Keep(SceneSetup.CreateFluid(null));
            GameObject fluid = scene.Keep(SceneSetup.CreateFluid(null));
            var child = new GameObject("Child");
            child.transform.SetParent(fluid.transform, false);
            GameObject made = create(child);
            Assert.That(made.transform.parent, Is.SameAs(child.transform));
            Assert.That(Selection.activeGameObject, Is.SameAs(made));
            Assert.That(made.activeInHierarchy);
            Assert.That(made.GetComponentInParent<FluidSimulation>().gameObject, Is.SameAs(fluid));
            Assert.That(ProblemList.Of(made.GetComponents<MonoBehaviour>()), Is.Empty);
        }

        [TestCaseSource(nameof(Parts))]
        public void A_part_without_a_fluid_gets_one_and_both_go_with_one_undo(Func<GameObject, GameObject> create)
        {
            GameObject made = scene.Keep(create(null));
            GameObject fluid = made.GetComponentInParent<FluidSimulation>().gameObject;
            Assert.That(Selection.activeGameObject, Is.SameAs(made));
            Assert.That(ProblemList.Of(made.GetComponents<MonoBehaviour>()), Is.Empty);
            Undo.PerformUndo();
            Assert.That(made == null && fluid == null);
        }

        [Test]
        public void A_part_made_below_another_object_refers_to_the_fluid_of_the_scene()
        {
            scene.Keep(SceneSetup.CreateFluid(null));
            GameObject tap = scene.Keep(new GameObject("Tap"));
            GameObject made = SceneSetup.CreateEmitter(tap);
            Assert.That(made.transform.parent, Is.SameAs(tap.transform));
            Assert.That(ProblemList.Of(made.GetComponents<MonoBehaviour>()), Is.Empty);
        }

        [Test]
        public void Parts_are_where_they_act_in_a_box_that_is_turned()
        {
            GameObject fluid = scene.Keep(SceneSetup.CreateFluid(null));
            fluid.transform.SetPositionAndRotation(new Vector3(5f, 1f, -2f), Quaternion.Euler(0f, 0f, 30f));
            Vector3 half = 0.5f * fluid.GetComponent<FluidSimulation>().DomainSize;
            foreach (Func<GameObject, GameObject> create in Parts.Append(SceneSetup.CreateCollider))
            {
                Vector3 local = Quaternion.Inverse(fluid.transform.rotation) * (create(fluid).transform.position - fluid.transform.position);
                Assert.That(Mathf.Abs(local.x) < half.x && Mathf.Abs(local.y) < half.y && Mathf.Abs(local.z) < half.z, $"{local}");
            }
        }

        [Test]
        public void A_connection_joins_the_two_fluids_that_are_selected_and_is_undone_alone()
        {
            GameObject left = scene.Keep(SceneSetup.CreateFluid(null)), right = scene.Keep(SceneSetup.CreateFluid(null));
            right.transform.position = left.transform.position + 1.5f * Vector3.right;
            Undo.IncrementCurrentGroup();
            GameObject made = scene.Keep(SceneSetup.CreateConnection(new[] { left.transform.GetChild(0).gameObject, left, right }));
            var connection = made.GetComponent<FluidConnection>();
            Assert.That((connection.First.gameObject, connection.Second.gameObject), Is.EqualTo((left, right)));
            Assert.That(Selection.activeGameObject, Is.SameAs(made));
            Assert.That(ProblemList.Of(made.GetComponents<MonoBehaviour>()), Is.Empty);
            Assert.That(Undo.GetCurrentGroupName(), Is.EqualTo("Create Fluid Connection"));
            Undo.PerformUndo();
            Assert.That(made == null, "gone");
            Assert.That(left != null && right != null, "both fluids stay");
        }

        [Test]
        public void A_connection_made_without_two_fluids_says_what_to_set()
        {
            GameObject one = scene.Keep(SceneSetup.CreateFluid(null));
            GameObject made = scene.Keep(SceneSetup.CreateConnection(new[] { one }));
            Assert.That(made.GetComponent<FluidConnection>().First.gameObject, Is.SameAs(one));
            Assert.That(ProblemList.Of(made.GetComponents<MonoBehaviour>()), Has.Exactly(1).Contains("Set First and Second"));
        }

        [Test]
        public void Names_of_siblings_differ()
        {
            GameObject fluid = scene.Keep(SceneSetup.CreateFluid(null));
            Assert.That(SceneSetup.CreateDrain(fluid).name, Is.Not.EqualTo(SceneSetup.CreateDrain(fluid).name));
        }

        [Test]
        public void A_collider_has_the_same_size_below_a_scaled_object()
        {
            GameObject fluid = scene.Keep(SceneSetup.CreateFluid(null));
            GameObject parent = scene.Keep(new GameObject("Scaled"));
            parent.transform.localScale = new Vector3(2f, 4f, 0.5f);
            GameObject free = scene.Keep(SceneSetup.CreateCollider(null)), below = SceneSetup.CreateCollider(parent);
            Assert.That(Vector3.Distance(below.transform.lossyScale, free.transform.lossyScale), Is.LessThan(1e-5f));
        }
    }
}
