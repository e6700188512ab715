using System.Linq;
using System.Reflection;
using System.Threading;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>The window and the inspector of baking draw whatever they are given, and their menus are where users look.</summary>
    public class BakeEditorTests : GraphicsFixture
    {
        const string Folder = "Assets/Drawn";

        [TearDown]
        public void Delete()
        {
            GuiTrace.Clear();
            AssetDatabase.DeleteAsset(Folder);
            Selection.objects = new Object[0];
        }

        static SignedDistanceField Field(Mesh mesh)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 12;
            BakePlan plan = BakePlan.Of(new Object[] { mesh }, Folder, new MeshAnalyses());
            plan.Bake(settings, BakeAssign.Nothing, (fraction, stage) => true);
            return plan.Items[0].Field;
        }

        static void Draw(object drawn, string method)
        {
            void Call() => drawn.GetType().GetMethod(method, BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public)
                .Invoke(drawn, null);
            if (method.EndsWith("GUI"))
                Assert.That(GuiPasses.Draw(Call), Is.Null, drawn.GetType().Name);
            else
                Call();
        }

        [Test]
        public void The_window_draws_nothing_good_and_bad_meshes_and_their_outcome()
        {
            var flat = new Mesh { name = "Point", vertices = new Vector3[3], triangles = new[] { 0, 1, 2 } };
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube), empty = new GameObject("Empty");
            BakeWindow window = BakeWindow.Open(new Object[0]);
            Draw(window, "OnGUI");
            window.Choose(new Object[] { cube, flat, empty });
            Draw(window, "OnGUI");
            Assert.That(window.Plan.Items.Count, Is.EqualTo(2));
            Assert.That(window.Plan.Notes.Count, Is.EqualTo(1));
            Draw(window, "Bake");
            Draw(window, "OnGUI");
            Assert.That(window.Plan.Items.Select(item => item.Failed), Is.EqualTo(new[] { false, true }));
            AssetDatabase.DeleteAsset("Assets/Distance Fields");
            window.Close();
            foreach (Object made in new Object[] { flat, cube, empty })
                Object.DestroyImmediate(made);
        }

        [TestCase("Tap and Basin")]
        [TestCase("Water Wheel")]
        [TestCase("Flooded Quay")]
        public void The_meshes_of_a_sample_are_read_without_Read_Write_and_its_fields_are_of_them(string sample)
        {
            using (new SampleScene(sample))
            {
                SignedDistanceField[] fields = Object.FindObjectsOfType<FluidCollider>().Select(collider => collider.Field)
                    .Where(field => field != null).Distinct().ToArray();
                Assert.That(fields, Is.Not.Empty);
                foreach (SignedDistanceField field in fields)
                {
                    Mesh mesh = FieldAssets.MeshOf(field, out string problem);
                    Assert.That(problem, Is.Null);
                    Assert.That(mesh.isReadable, Is.False, "as its import settings say");
                    Assert.That(field.IsStale(EditorMesh.Read(mesh)), Is.False, mesh.name);
                    Assert.That(MeshCheck.Run(EditorMesh.Read(mesh)).Problem, Is.Null);
                    Assert.That(new MeshAnalysis(mesh).Finish((fraction, stage) => true, out _));
                    Editor editor = Editor.CreateEditor(field);
                    Draw(editor, nameof(editor.OnInspectorGUI));
                    Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.None.Contain("has changed"));
                    Object.DestroyImmediate(editor);
                }
            }
        }

        [Test]
        public void A_mesh_is_analyzed_once_however_often_it_is_chosen_and_whatever_is_set()
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            BakeWindow window = BakeWindow.Open(new Object[] { cube });
            Draw(window, "OnGUI");
            Assert.That(window.Analyses.Started, Is.Zero, "not while it is chosen");
            Assert.That(GuiDrawing.Buttons, Has.Some.StartWith("Cancel Analysis (1"));
            Assert.That(SpinWait.SpinUntil(() =>
            {
                EditorTick.Run();
                Draw(window, "OnGUI");
                return window.Plan.Items[0].Analysis.IsDone;
            }, 30000));

            string[] estimates = new[] { 32, 64 }.Select(resolution =>
            {
                GuiTrace.Edit = property =>
                {
                    if (property.propertyPath != "settings")
                        return false;
                    property.FindPropertyRelative("resolution").intValue = resolution;
                    return true;
                };
                Draw(window, "OnGUI");
                GuiTrace.Edit = null;
                GuiDrawing.Labels.Clear();
                EditorTick.Run();
                Draw(window, "OnGUI");
                return GuiDrawing.Labels.Select(label => label.text).Single(text => text.Contains("voxels of"));
            }).ToArray();
            Assert.That(estimates[0], Does.StartWith("32 x"));
            Assert.That(estimates[1], Does.StartWith("64 x"));
            Selection.activeGameObject = cube;
            Draw(window, "OnSelectionChange");
            Draw(window, "OnFocus");
            EditorTick.Run();
            Assert.That(window.Plan.Items[0].Report, Is.Not.Null);
            Assert.That(window.Analyses.Started, Is.EqualTo(1));

            GuiDrawing.Press = text => text == "Analyze Again";
            Draw(window, "OnGUI");
            GuiDrawing.Press = null;
            EditorTick.Run();
            Assert.That(window.Analyses.Started, Is.EqualTo(2));
            window.Close();
            Object.DestroyImmediate(cube);
        }

        [Test]
        public void The_window_tells_what_is_lost_and_its_button_takes_the_remedy()
        {
            Vector3[] corners = { Vector3.zero, Vector3.right, Vector3.up, Vector3.forward, 90f * Vector3.right, 90.001f * Vector3.right,
                new Vector3(90f, 0.001f, 0f) };
            var mesh = new Mesh { name = "Far", vertices = corners, triangles = new[] { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 4, 5, 6 } };
            BakeWindow window = BakeWindow.Open(new Object[] { mesh });
            Assert.That(SpinWait.SpinUntil(() =>
            {
                EditorTick.Run();
                Draw(window, "OnGUI");
                return window.Plan.Items[0].Analysis.IsDone;
            }, 30000));
            GuiTrace.Clear();
            GuiDrawing.Press = text => text == "Leave Out Far";
            Draw(window, "OnGUI");
            GuiDrawing.Press = null;
            Assert.That(GuiTrace.HelpBoxes, Has.Some.Matches<(MessageType type, string text)>(box => box.type == MessageType.Warning
                && box.text.StartsWith("1 triangles far from the rest, at (90, 0, 0) m, make the box")));
            GuiTrace.Clear();
            GuiDrawing.Labels.Clear();
            EditorTick.Run();
            Draw(window, "OnGUI");
            Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.Some.Contain("are left out"));
            Assert.That(GuiDrawing.Labels.Select(label => label.text), Has.Some.StartWith("64 x 64 x 64 voxels"));
            window.Close();
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void A_mesh_that_is_destroyed_while_the_window_shows_it_leaves_it()
        {
            Mesh mesh = new Mesh { name = "Gone", vertices = new Vector3[3], triangles = new[] { 0, 1, 2 } };
            BakeWindow window = BakeWindow.Open(new Object[] { mesh });
            Draw(window, "OnGUI");
            EditorTick.Run();
            Object.DestroyImmediate(mesh);
            EditorTick.Run();
            Draw(window, "OnGUI");
            Assert.That(window.Plan.Items, Is.Empty);
            window.Close();
        }

        [Test]
        public void A_canceled_analysis_waits_to_be_asked_for_and_a_bake_makes_up_for_it()
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            BakeWindow window = BakeWindow.Open(new Object[] { cube });
            GuiDrawing.Press = text => text.StartsWith("Cancel Analysis");
            Draw(window, "OnGUI");
            GuiDrawing.Press = null;
            EditorTick.Run();
            Assert.That((window.Analyses.Started, window.Plan.Items[0].Analysis.IsDone), Is.EqualTo((0, false)));
            GuiDrawing.Buttons.Clear();
            Draw(window, "OnGUI");
            Assert.That(GuiDrawing.Buttons, Has.Member("Analyze").And.Member("Bake"));
            Draw(window, "Bake");
            Assert.That(window.Plan.Items[0].Failed, Is.False, window.Plan.Items[0].Outcome);
            AssetDatabase.DeleteAsset("Assets/Distance Fields");
            window.Close();
            Object.DestroyImmediate(cube);
        }

        [Test]
        public void The_inspector_draws_facts_slices_and_the_surface_and_bakes_again()
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            Mesh mesh = Object.Instantiate(cube.GetComponent<MeshFilter>().sharedMesh);
            Assert.That(FieldAssets.TryMakeFolder(Folder));
            AssetDatabase.CreateAsset(mesh, Folder + "/Cube.mesh");
            SignedDistanceField field = Field(mesh);
            Undo.ClearAll();
            Editor editor = Editor.CreateEditor(field);
            Assert.That(editor, Is.InstanceOf<SignedDistanceFieldEditor>());
            Draw(editor, nameof(editor.OnInspectorGUI));
            Assert.That(editor.HasPreviewGUI());
            editor.OnPreviewGUI(new Rect(0, 0, 200, 100), null);
            var serialized = new SerializedObject(editor);
            serialized.FindProperty("settings.resolution").intValue = 20;
            serialized.ApplyModifiedProperties();
            Undo.IncrementCurrentGroup();
            Draw(editor, "Bake");
            Assert.That(field.Resolution, Is.EqualTo(20 * Vector3Int.one));
            Draw(editor, nameof(editor.OnInspectorGUI));
            editor.OnPreviewGUI(new Rect(0, 0, 200, 100), null);

            Undo.PerformUndo();
            serialized.Update();
            Assert.That(field.Resolution, Is.EqualTo(12 * Vector3Int.one));
            Assert.That(serialized.FindProperty("settings.resolution").intValue, Is.EqualTo(12), "what was baked with, for the next bake");
            Draw(editor, nameof(editor.OnInspectorGUI));
            editor.OnPreviewGUI(new Rect(0, 0, 200, 100), null);
            Object.DestroyImmediate(editor);
            Object.DestroyImmediate(cube);
        }

        [Test]
        public void The_inspector_of_an_empty_field_says_what_is_missing()
        {
            var field = ScriptableObject.CreateInstance<SignedDistanceField>();
            Editor editor = Editor.CreateEditor(field);
            Draw(editor, nameof(editor.OnInspectorGUI));
            Assert.That(editor.HasPreviewGUI(), Is.False);
            Object.DestroyImmediate(editor);
            Object.DestroyImmediate(field);
        }

        [Test]
        public void Menus_are_on_mesh_filters_meshes_assets_and_windows()
        {
            string[] items = typeof(BakeWindow).GetMethods(BindingFlags.Static | BindingFlags.NonPublic)
                .SelectMany(m => m.GetCustomAttributes<MenuItem>()).Where(m => !m.validate).Select(m => m.menuItem).ToArray();
            Assert.That(items, Is.EquivalentTo(new[] { "Window/Rill/Bake Signed Distance Field",
                "CONTEXT/MeshFilter/Bake Signed Distance Field", "CONTEXT/Mesh/Bake Signed Distance Field",
                "Assets/Bake Signed Distance Field" }));
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            typeof(BakeWindow).GetMethod("OpenOnFilter", BindingFlags.Static | BindingFlags.NonPublic)
                .Invoke(null, new object[] { new MenuCommand(cube.GetComponent<MeshFilter>()) });
            BakeWindow window = EditorWindow.GetWindow<BakeWindow>();
            Assert.That(window.Plan.Items.Single().Objects, Is.EqualTo(new[] { cube }));
            window.Close();
            Object.DestroyImmediate(cube);
        }
    }
}
