using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>The buttons that bake where a field is missing.</summary>
    public class BakeButtonTests : InspectorFixture
    {
        const string Bake = "Bake...", BakeMissing = "Bake Missing Fields...", Folder = "Assets/Distance Fields";
        const int Layer = 8;

        readonly List<Object> made = new List<Object>();

        [TearDown]
        public void DestroyAll()
        {
            if (EditorWindow.HasOpenInstances<BakeWindow>())
                EditorWindow.GetWindow<BakeWindow>().Close();
            foreach (Object one in made.Where(one => one != null))
                Object.DestroyImmediate(one);
            made.Clear();
            AssetDatabase.DeleteAsset(Folder);
        }

        [Test]
        public void An_empty_field_of_a_mesh_has_a_button_that_bakes_and_assigns_it(
            [Values(typeof(FluidCollider), typeof(FluidVolume), typeof(FluidDetector))] Type type)
        {
            GameObject cup = Cube("Cup");
            Component component = cup.AddComponent(type);
            SetShape(component, true);
            var box = type == typeof(FluidCollider) ? null : cup.AddComponent<FluidCollider>();
            Press(component, Bake);
            BakeWindow window = EditorWindow.GetWindow<BakeWindow>();
            Assert.That(window.Plan.Items.Single().Mesh, Is.SameAs(cup.GetComponent<MeshFilter>().sharedMesh));
            BakeIn(window);
            Assert.That(FieldOf(component), Is.SameAs(window.Plan.Items.Single().Field).And.Not.Null);
            if (box != null)
                Assert.That((box.Shape, box.Field), Is.EqualTo((ColliderShape.Box, (SignedDistanceField)null)), "which was not asked for");
            Assert.That(GuiTrace.Fields.Select(field => field.path), Has.None.EqualTo("assign"), "where it goes is known");
            Assert.That(GuiDrawing.Labels.Select(label => label.text), Has.Member("Field of 'Cup'"));

            Draw(Inspect(component));
            Assert.That(GuiDrawing.Buttons, Has.No.Member(Bake));
            Undo.PerformUndo();
            Assert.That(FieldOf(component), Is.Null);
            Draw(Inspect(component));
            Assert.That(GuiDrawing.Buttons, Has.Member(Bake));
        }

        [Test]
        public void Without_a_mesh_or_with_another_shape_there_is_no_such_button(
            [Values(typeof(FluidCollider), typeof(FluidVolume), typeof(FluidDetector))] Type type)
        {
            Component other = Cube("Cup").AddComponent(type), alone = Keep(new GameObject("Alone")).AddComponent(type);
            SetShape(other, false);
            SetShape(alone, true);
            foreach (Component component in new[] { other, alone })
            {
                Draw(Inspect(component));
                Assert.That(GuiDrawing.Buttons, Has.No.Member(Bake), component.name);
            }
        }

        [Test]
        public void A_mesh_below_in_a_frame_of_its_own_is_left_to_the_window()
        {
            var collider = Keep(new GameObject("Root")).AddComponent<FluidCollider>();
            SetShape(collider, true);
            GameObject part = Cube("Part");
            part.transform.SetParent(collider.transform, false);
            part.transform.localPosition = Vector3.up;
            Press(collider, Bake);
            BakeIn(EditorWindow.GetWindow<BakeWindow>());
            Assert.That(collider.Field, Is.Null, "it would be in the wrong place");
            Assert.That(GuiTrace.Fields.Select(field => field.path), Has.Member("assign"));
            part.transform.localPosition = Vector3.zero;
            Press(collider, Bake);
            BakeIn(EditorWindow.GetWindow<BakeWindow>());
            Assert.That(collider.Field, Is.Not.Null);
        }

        [Test]
        public void Meshes_near_the_box_without_a_field_are_baked_into_Mesh_Fields_and_undone()
        {
            FluidPhysicsColliders colliders = Pool();
            Mesh rock = Stone("Rock", Cube("Cube").GetComponent<MeshFilter>().sharedMesh, Vector3.zero);
            Stone("Twin", rock, 0.2f * Vector3.up);
            Mesh second = Stone("Second", Copy(rock, "Second"), Vector3.zero);
            Mesh point = Stone("Point", Made(new Mesh { name = "Point", vertices = new[] { Vector3.zero, Vector3.zero, Vector3.zero },
                triangles = new[] { 0, 1, 2 } }), Vector3.zero);
            Stone("Far", Copy(rock, "Far"), new Vector3(50f, 0f, 0f));
            colliders.MeshFields.Add(new MeshField(second, null));

            Press(colliders, BakeMissing);
            BakeWindow window = EditorWindow.GetWindow<BakeWindow>();
            Assert.That(window.Plan.Items.Select(item => item.Mesh), Is.EqualTo(new[] { rock, second, point }));
            BakeIn(window);
            Assert.That(window.Plan.Items.Select(item => item.Failed), Is.EqualTo(new[] { false, false, true }));
            Assert.That(GuiDrawing.Labels.Select(label => label.text), Has.Member("Mesh Fields of 'Pool', until play mode ends").And.Member("Point"));
            Assert.That(colliders.MeshFields.Select(pair => (pair.Mesh, pair.Field)), Is.EqualTo(new[] { (second, window.Plan.Items[1].Field),
                (rock, window.Plan.Items[0].Field) }), "a pair without a field gets it");
            Assert.That(colliders.MeshFields.Select(pair => pair.Field), Has.None.Null);

            Press(colliders, BakeMissing);
            Assert.That(window.Plan.Items.Select(item => item.Mesh), Is.EqualTo(new[] { point }), "the others have one now");
            Undo.PerformUndo();
            Assert.That(colliders.MeshFields.Select(pair => (pair.Mesh, pair.Field)), Is.EqualTo(new[] { (second, (SignedDistanceField)null) }));
        }

        [Test]
        public void Where_no_field_is_missing_a_dialog_says_so_and_without_layers_there_is_no_button()
        {
            FluidPhysicsColliders colliders = Pool();
            var said = new List<string>();
            Application.LogCallback listen = (message, stack, type) => said.Add(message);
            Application.logMessageReceived += listen;
            Press(colliders, BakeMissing);
            Application.logMessageReceived -= listen;
            Assert.That(said.Single(), Does.Contain("Bake Missing Fields: The mesh of every Mesh Collider"));
            Assert.That(EditorWindow.HasOpenInstances<BakeWindow>(), Is.False);
            colliders.ColliderLayers = 0;
            Draw(Inspect(colliders));
            Assert.That(GuiDrawing.Buttons, Has.No.Member(BakeMissing));
        }

        [Test]
        public void What_another_window_or_nobody_takes_does_no_harm()
        {
            GameObject cup = Cube("Cup");
            var volume = cup.AddComponent<FluidVolume>();
            SetShape(volume, true);
            Press(volume, Bake);
            BakeWindow window = EditorWindow.GetWindow<BakeWindow>();
            window.Choose(new Object[] { cup });
            BakeIn(window);
            Assert.That(volume.Field, Is.Null, "another choice is for no component");
            Press(volume, Bake);
            Object.DestroyImmediate(volume);
            BakeIn(window);
            Assert.That(window.Plan.Items.Single().Failed, Is.False);
        }

        void Press(Component component, string button)
        {
            GuiDrawing.Press = text => text == button;
            Draw(Inspect(component));
            Assert.That(GuiDrawing.Buttons, Has.Member(button));
            GuiDrawing.Press = null;
        }

        static void BakeIn(BakeWindow window)
        {
            using (var serialized = new SerializedObject(window))
            {
                serialized.FindProperty("settings.resolution").intValue = 12;
                serialized.ApplyModifiedPropertiesWithoutUndo();
            }
            Undo.IncrementCurrentGroup();
            typeof(BakeWindow).GetMethod("Bake", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(window, null);
            void OnGUI() => typeof(BakeWindow).GetMethod("OnGUI", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(window, null);
            Assert.That(GuiPasses.Draw(OnGUI), Is.Null);
        }

        FluidPhysicsColliders Pool()
        {
            GameObject pool = Keep(new GameObject("Pool"));
            pool.SetActive(false);
            var colliders = pool.AddComponent<FluidPhysicsColliders>();
            colliders.ColliderLayers = 1 << Layer;
            return colliders;
        }

        Mesh Stone(string name, Mesh mesh, Vector3 position)
        {
            GameObject stone = Keep(new GameObject(name) { layer = Layer });
            stone.transform.position = position;
            stone.AddComponent<MeshCollider>().sharedMesh = mesh;
            return mesh;
        }

        static void SetShape(Component component, bool isMesh)
        {
            if (component is FluidCollider collider)
                collider.Shape = isMesh ? ColliderShape.Mesh : ColliderShape.Sphere;
            else if (component is FluidVolume volume)
                volume.Shape = isMesh ? VolumeShape.SignedDistanceField : VolumeShape.Box;
            else
                ((FluidDetector)component).Shape = isMesh ? DetectorShape.Mesh : DetectorShape.Box;
        }

        static SignedDistanceField FieldOf(Component component) => (component as FluidCollider)?.Field ?? (component as FluidVolume)?.Field
            ?? (component as FluidDetector)?.Field;

        GameObject Cube(string name)
        {
            GameObject cube = Keep(GameObject.CreatePrimitive(PrimitiveType.Cube));
            cube.name = name;
            return cube;
        }

        Mesh Copy(Mesh mesh, string name)
        {
            Mesh copy = Made(Object.Instantiate(mesh));
            copy.name = name;
            return copy;
        }

        GameObject Keep(GameObject gameObject) => Made(gameObject);

        T Made<T>(T one) where T : Object
        {
            made.Add(one);
            return one;
        }
    }
}
