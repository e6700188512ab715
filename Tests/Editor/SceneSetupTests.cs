using System;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Editor.Tests
{
    /// <summary>Objects that GameObject > Rill creates.</summary>
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
            Assert.That(fluid.GetComponent<FluidSurface>() != null && fluid.GetComponent<FluidFoam>() != null);
            Assert.That(fluid.GetComponentsInChildren<MeshRenderer>().Select(one => one.sharedMaterial != null), Has.Some.True.And.All.True);
            var simulation = fluid.GetComponent<FluidSimulation>();
            Assert.That(FillEstimate.Particles(simulation), Is.InRange(1000, simulation.Capacity));
            Assert.That(ProblemList.Of(fluid.GetComponentsInChildren<MonoBehaviour>()), Is.Empty);
        }

        [Test]
        public void The_water_of_a_fluid_lies_within_its_walls_and_the_walls_outside_of_its_box()
        {
            GameObject fluid = scene.Keep(SceneSetup.CreateFluid(null));
            Vector3 half = 0.5f * fluid.GetComponent<FluidSimulation>().DomainSize;
            Transform pool = fluid.transform.Find("Water"), drop = fluid.transform.Find("Drop");
            Vector3 size = pool.GetComponent<FluidVolume>().Size;
            Assert.That(pool.localPosition.y - 0.5f * size.y, Is.EqualTo(-half.y).Within(1e-5f), "on the floor");
            Assert.That(pool.localPosition.y + 0.5f * size.y + half.y, Is.InRange(0.1f, BasinSetup.WallHeight - 0.1f), "below the rim");
            Assert.That(drop.localPosition.y + drop.GetComponent<FluidVolume>().Radius, Is.LessThan(half.y));
            foreach (MeshRenderer wall in fluid.transform.Find("Basin").GetComponentsInChildren<MeshRenderer>())
            {
                Vector3 center = fluid.transform.InverseTransformPoint(wall.transform.position), side = 0.5f * wall.transform.localScale;
                Vector3 gap = new Vector3(Mathf.Abs(center.x), Mathf.Abs(center.y), Mathf.Abs(center.z)) - side - half;
                Assert.That(Mathf.Max(gap.x, gap.y, gap.z), Is.EqualTo(0f).Within(1e-5f), $"{wall.name} touches the box from outside");
            }
        }

        [TestCase(false)]
        [TestCase(true)]
        public void A_fluid_scene_brings_the_camera_and_the_light_that_a_scene_lacks(bool hasThem)
        {
            Light light = null;
            if (hasThem)
            {
                scene.Keep(new GameObject("Mine")).AddComponent<Camera>();
                light = scene.Keep(new GameObject("Sun")).AddComponent<Light>();
                light.type = LightType.Directional;
            }
            GameObject made = scene.Keep(FluidSceneSetup.Create(null));
            Assert.That(made.GetComponentsInChildren<Camera>().Length, Is.EqualTo(hasThem ? 0 : 1));
            Assert.That(made.GetComponentsInChildren<Light>().Length, Is.EqualTo(hasThem ? 0 : 1));
            light = hasThem ? light : made.GetComponentInChildren<Light>();
            Assert.That(made.GetComponentInChildren<FluidSurface>().Sun, Is.Not.Null.And.SameAs(light));
            Assert.That(Selection.activeGameObject, Is.SameAs(made));
            Assert.That(ProblemList.Of(made.GetComponentsInChildren<MonoBehaviour>()), Is.Empty);
            Assert.That(made.GetComponentInChildren<FluidDrain>().RecycleTo, Is.SameAs(made.GetComponentInChildren<FluidEmitter>()));
            Assert.That(Undo.GetCurrentGroupName(), Is.EqualTo("Create Fluid Scene"));
            Undo.PerformUndo();
            Assert.That(made == null, "gone, with all that it brought");
        }

        [Test]
        public void The_camera_of_a_fluid_scene_sees_all_of_its_basin()
        {
            GameObject made = scene.Keep(FluidSceneSetup.Create(null));
            made.transform.position = new Vector3(3f, 1f, -2f);
            Camera camera = made.GetComponentInChildren<Camera>();
            Matrix4x4 clip = Matrix4x4.Perspective(camera.fieldOfView, 16f / 9f, camera.nearClipPlane, camera.farClipPlane)
                * camera.worldToCameraMatrix;
            foreach (MeshRenderer one in made.GetComponentInChildren<FluidSimulation>().GetComponentsInChildren<MeshRenderer>())
                for (int corner = 0; corner < 8; corner++)
                {
                    var at = new Vector3((corner & 1) - 0.5f, ((corner >> 1) & 1) - 0.5f, (corner >> 2) - 0.5f);
                    Vector3 seen = clip.MultiplyPoint(one.transform.TransformPoint(one.name == "Pipe" || one.name == "Lip" ? 2f * at : at));
                    Assert.That(Mathf.Max(Mathf.Abs(seen.x), Mathf.Abs(seen.y)), Is.LessThan(1f), one.name);
                }
        }

        [Test]
        public void A_fluid_below_a_scaled_object_has_its_basin_around_its_box()
        {
            GameObject parent = scene.Keep(new GameObject("Scaled"));
            parent.transform.localScale = new Vector3(2f, 4f, 0.5f);
            GameObject fluid = SceneSetup.CreateFluid(parent);
            Assert.That(Vector3.Distance(fluid.transform.lossyScale, Vector3.one), Is.LessThan(1e-5f));
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
            Assert.That(scene.Keep(FluidSceneSetup.Create(null)).name, Is.Not.EqualTo(scene.Keep(FluidSceneSetup.Create(null)).name));
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
