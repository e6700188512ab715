using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>That what GameObject > Rill makes runs as it is.</summary>
    public class CreateMenuTests : InspectorFixture
    {
        const int FramesToRun = 16;
        const float CoarseSpacing = 0.1f;       // m: an eighth of the particles

        const string Connection = "GameObject/Rill/Fluid Connection";       // of two fluids, and so below neither

        static IEnumerable<string> Items => Methods.Select(item => item.Key).Where(item => item != Connection);

        static Dictionary<string, MethodInfo> Methods
            => new[] { typeof(SceneSetup).Assembly, Assembly.Load("Rill.Physics.Editor"), Assembly.Load("Rill.Terrain.Editor") }
            .SelectMany(assembly => assembly.GetTypes())
                .SelectMany(type => type.GetMethods(BindingFlags.Static | BindingFlags.NonPublic | BindingFlags.Public))
            .SelectMany(method => method.GetCustomAttributes<MenuItem>().Select(item => (item.menuItem, method)))
            .Where(item => item.menuItem.StartsWith("GameObject/Rill/")).ToDictionary(item => item.menuItem, item => item.method);

        [Test]
        public void The_menu_has_what_scenes_are_made_of()
        {
            Assert.That(Methods.Keys.Select(item => item.Split('/').Last()),
                Is.EquivalentTo(new[] { "Fluid", "Fluid Scene", "Fluid Volume", "Emitter", "Drain", "Force Field", "Collider", "Probe", "Detector",
                "Fluid Connection", "Floating Body", "Floating Boat" }));
        }

        // A boat that is 0.4 as dense as the water over its hull lies 0.4 of that deep: here in water that stands 0.6 m.
        [Test]
        public void A_boat_floats_upright_at_four_tenths_of_its_hull()
        {
            GameObject fluid = SceneSetup.CreateFluid(null);
            FluidSimulation simulation = fluid.GetComponent<FluidSimulation>();
            simulation.Configure(new Vector3(2f, 2f, 1f), 0.05f, 20000);
            Object.DestroyImmediate(fluid.transform.Find("Drop").gameObject);
            FluidVolume water = fluid.GetComponentInChildren<FluidVolume>();
            water.Size = new Vector3(2f, 0.6f, 1f);
            water.transform.localPosition = new Vector3(0f, -0.7f, 0f);
            GameObject boat = Choose("GameObject/Rill/Floating Boat", fluid);
            var body = boat.GetComponent<Rigidbody>();
            Assert.That(boat.GetComponentsInChildren<FluidCollider>().Length, Is.EqualTo(3));
            Assert.That(boat.GetComponent<FluidBuoyancy>() != null);
            Assert.That(body.mass, Is.EqualTo(0.4f * 1000f * (0.45f * 0.15f * 0.3f + 0.15f * 0.15f * 0.18f)).Within(0.01f));
            boat.transform.position = fluid.transform.position + new Vector3(0f, -0.35f, 0f);
            Run(240);
            Vector3 position = fluid.transform.InverseTransformPoint(boat.transform.position);
            TestContext.Out.WriteLine($"at {position}, up {boat.transform.up}");
            Assert.That(Vector3.Angle(boat.transform.up, Vector3.up), Is.LessThan(12f), "upright");
            Assert.That(position.y, Is.EqualTo(-0.4f + 0.1f * 0.15f).Within(0.05f), "within a spacing");
        }

        [TestCaseSource(nameof(Items))]
        public void What_a_menu_item_makes_in_an_empty_scene_runs_with_particles_and_no_complaint(string item)
        {
            GameObject made = Choose(item, null);
            if (made.GetComponent<FluidSimulation>() == null)
                Coarsen(Object.FindObjectOfType<FluidSimulation>());
            Run();
        }

        [TestCaseSource(nameof(Items))]
        public void What_a_menu_item_makes_below_a_fluid_runs_with_particles_and_no_complaint(string item)
        {
            GameObject fluid = SceneSetup.CreateFluid(null);
            Coarsen(fluid.GetComponent<FluidSimulation>());
            GameObject made = Choose(item, fluid);
            Assert.That(made.transform.parent, Is.SameAs(fluid.transform));
            if (made.GetComponentInChildren<FluidSimulation>() == null)
                Assert.That(Object.FindObjectsOfType<FluidSimulation>().Length, Is.EqualTo(1), "no fluid beside the one that is there");
            Run();
        }

        [TestCase("GameObject/Rill/Fluid")]
        [TestCase("GameObject/Rill/Fluid Scene")]
        public void The_scene_view_shows_the_box_of_a_new_fluid_which_stands_where_it_looked(string item)
        {
            SceneView.lastActiveSceneView = new SceneView { pivot = new Vector3(5f, 1f, 2f) };
            try
            {
                GameObject made = Choose(item, null);
                FluidSimulation fluid = made.GetComponentInChildren<FluidSimulation>();
                Bounds framed = SceneView.lastActiveSceneView.Framed;
                Assert.That(Vector3.Distance(framed.center, fluid.transform.position), Is.LessThan(1e-5f));
                Assert.That(Vector3.Distance(framed.size, fluid.DomainSize), Is.LessThan(1e-5f));
                Vector3 foot = fluid.transform.position - 0.5f * fluid.DomainSize.y * Vector3.up;
                Assert.That(Vector3.Distance(foot, new Vector3(5f, 1f + SceneSetup.Stand, 2f)), Is.LessThan(1e-5f));
            }
            finally
            {
                SceneView.lastActiveSceneView = null;
            }
        }

        // All that the drain takes comes back through the spout, so the water stays what it was at the start.
        [Test]
        public void A_fluid_scene_goes_round_and_its_ball_floats()
        {
            GameObject made = Choose("GameObject/Rill/Fluid Scene", null);
            FluidSimulation fluid = made.GetComponentInChildren<FluidSimulation>();
            fluid.Configure(fluid.DomainSize, 0.05f, 8000);
            Transform ball = made.transform.Find("Ball");
            Run(90);
            fluid.TryGetStatistics(out FluidStatistics statistics);
            float height = ball.position.y - SceneSetup.Stand - FluidSceneSetup.Depth, radius = 0.5f * ball.localScale.x;
            TestContext.Out.WriteLine($"{statistics.particles} particles, {fluid.GetComponentInChildren<FluidDrain>().Drained} drained, " +
                $"{fluid.GetComponentInChildren<FluidEmitter>().Emitted} emitted, the ball {height:0.000} m above the water's level");
            Assert.That(fluid.GetComponentInChildren<FluidDrain>().Drained, Is.GreaterThan(20));
            Assert.That(fluid.GetComponentInChildren<FluidEmitter>().Emitted, Is.GreaterThan(20));
            Assert.That(height, Is.InRange(-radius, radius), "between under and above the water");
        }

        [Test]
        public void A_menu_item_that_is_called_on_nothing_takes_the_selection_unless_that_is_an_asset()
        {
            var selected = new GameObject("Selected");
            Selection.activeGameObject = selected;
            GameObject made = Choose("GameObject/Rill/Collider", null);
            Assert.That(made.transform.parent, Is.SameAs(selected.transform));
            selected.IsAsset = true;
            Selection.activeGameObject = selected;
            Assert.That(Choose("GameObject/Rill/Drain", null).transform.parent.GetComponent<FluidSimulation>() != null);
            selected.IsAsset = false;
        }

        [TestCaseSource(nameof(Items))]
        public void A_menu_item_on_several_objects_makes_one(string item)
        {
            GameObject fluid = SceneSetup.CreateFluid(null);
            GameObject[] selected = { fluid, new GameObject("Second"), new GameObject("Third") };
            int before = Object.FindObjectsOfType<Transform>().Length;
            Choose(item, fluid);
            int ofOne = Object.FindObjectsOfType<Transform>().Length - before;
            Undo.PerformUndo();

            // Calls it like the editor from the hierarchy's context menu: once for each, one right after the other.
            Selection.objects = selected;
            EditorTick.Run();
            foreach (GameObject on in selected.Reverse())
                Methods[item].Invoke(null, new object[] { new MenuCommand(on) });
            Assert.That(Object.FindObjectsOfType<Transform>().Length - before, Is.EqualTo(ofOne));
            Assert.That(Selection.activeGameObject.transform.parent, Is.SameAs(fluid.transform), "below the active one");
            Assert.That(Choose(item, fluid).transform.parent, Is.SameAs(fluid.transform), "the menu can be chosen again");
        }

        [TestCaseSource(nameof(Items))]
        public void What_is_made_while_a_prefab_is_open_is_part_of_it(string item)
        {
            SceneSetup.CreateFluid(null);
            var stage = ScriptableObject.CreateInstance<PrefabStage>();
            stage.prefabContentsRoot = new GameObject("Prefab");
            PrefabStage.Current = stage;
            Selection.activeObject = null;
            try
            {
                GameObject made = Choose(item, null);
                Assert.That(made.transform.root, Is.SameAs(stage.prefabContentsRoot.transform));
                Assert.That(stage.prefabContentsRoot.GetComponentInChildren<FluidSimulation>(), Is.Not.Null, "with a fluid of its own");
            }
            finally
            {
                PrefabStage.Current = null;
                Object.DestroyImmediate(stage);
            }
        }

        [Test]
        public void Water_flows_between_two_fluids_that_were_selected()
        {
            var fluids = new FluidSimulation[2];
            for (int i = 0; i < 2; i++)
            {
                fluids[i] = SceneSetup.CreateFluid(null).GetComponent<FluidSimulation>();
                Coarsen(fluids[i]);
                fluids[i].transform.position = new Vector3(i * (fluids[i].DomainSize.x - 8f * CoarseSpacing), 0f, 0f);
            }
            Selection.objects = new Object[] { fluids[0].gameObject, fluids[1].gameObject };
            EditorTick.Run();
            foreach (FluidSimulation fluid in fluids)       // once for each, as from the hierarchy's context menu
                Methods[Connection].Invoke(null, new object[] { new MenuCommand(fluid.gameObject) });
            Assert.That(Object.FindObjectsOfType<FluidConnection>().Length, Is.EqualTo(1));
            Run();
            Assert.That(Object.FindObjectOfType<FluidConnection>().IsOpen);
        }

        [Test]
        public void A_floating_body_floats()
        {
            GameObject made = Choose("GameObject/Rill/Floating Body", null);
            var body = made.GetComponent<Rigidbody>();
            Coarsen(Object.FindObjectOfType<FluidSimulation>());
            Run();
            Assert.That(made.GetComponent<FluidBuoyancy>().isActiveAndEnabled);
            Assert.That(body.mass, Is.EqualTo(500f * Mathf.Pow(0.25f, 3f)).Within(0.01f));
            Undo.PerformUndo();
            Assert.That((bool)made, Is.False);
            Assert.That(Object.FindObjectOfType<FluidSimulation>(), Is.Null, "its fluid went with it");
        }

        static GameObject Choose(string item, GameObject on)
        {
            Undo.IncrementCurrentGroup();
            EditorTick.Run();
            Methods[item].Invoke(null, new object[] { new MenuCommand(on) });
            Assert.That(Selection.activeGameObject, Is.Not.Null);
            return Selection.activeGameObject;
        }

        static void Coarsen(FluidSimulation fluid) => fluid.Configure(fluid.DomainSize, CoarseSpacing, 2000);

        void Run(int frames = FramesToRun)
        {
            for (int i = 0; i < frames; i++)
                PlayerLoop.Frame(1f / 60f);
            FluidSimulation[] fluids = Object.FindObjectsOfType<FluidSimulation>();
            Assert.That(fluids, Is.Not.Empty);
            foreach (FluidSimulation fluid in fluids)
            {
                Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
                Assert.That(statistics.particles, Is.Positive);
                Assert.That(statistics.refused + statistics.nonFinite + statistics.escaped, Is.Zero);
            }
            Assert.That(Logged, Is.Empty);
        }
    }
}
