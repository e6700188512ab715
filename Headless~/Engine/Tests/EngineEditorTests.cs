using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    public class EngineEditorTests : EngineFixture
    {
        enum Mode { First, Second = 5 }

        [Serializable]
        struct Part { public float length; public Vector3 position; }

        [Serializable]
        class Tally { public int stored; [NonSerialized] public int running; }

        class Settings : MonoBehaviour
        {
            [SerializeField] int count = 3;
            public Tally tally = new Tally();
            public Mode mode = Mode.Second;
            public Part part = new Part { length = 2 };
            public List<Part> parts = new List<Part> { default, new Part { length = 4 } };
            public GameObject other;
            public int Count => count;
            void OnValidate() => Story.Tell($"valid {count}");
        }

        [CustomEditor(typeof(Settings))]
        class SettingsEditor : Editor
        {
            public override void OnInspectorGUI()
            {
                Story.Tell($"inspect {target.name}");
                base.OnInspectorGUI();
            }
        }

        [Test]
        public void Properties_read_and_write_the_fields_they_name()
        {
            Settings settings = Add<Settings>();
            var serialized = new SerializedObject(settings);
            serialized.FindProperty("count").intValue = 9;
            serialized.FindProperty("part.length").floatValue = 8;
            serialized.FindProperty("parts").GetArrayElementAtIndex(1).FindPropertyRelative("position").vector3Value = Vector3.one;
            serialized.FindProperty("parts").arraySize = 3;
            serialized.FindProperty("other").objectReferenceValue = settings.gameObject;
            Assert.That(serialized.FindProperty("mode").enumValueIndex, Is.EqualTo(1));
            Assert.That(serialized.FindProperty("mode").intValue, Is.EqualTo(5));
            Assert.That(serialized.ApplyModifiedProperties());
            Assert.That(serialized.ApplyModifiedProperties(), Is.False);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "valid 9" }));
            Assert.That(settings.Count, Is.EqualTo(9));
            Assert.That(settings.part.length, Is.EqualTo(8));
            Assert.That(settings.parts, Has.Count.EqualTo(3));
            Assert.That(settings.parts[1].position, Is.EqualTo(Vector3.one));
            Assert.That(settings.parts[1].length, Is.EqualTo(4));
            Assert.That(settings.other, Is.SameAs(settings.gameObject));
            Assert.That(serialized.FindProperty("missing"), Is.Null);
        }

        [Test]
        public void What_is_written_reaches_the_object_only_when_applied()
        {
            Settings settings = Add<Settings>();
            var serialized = new SerializedObject(settings);
            serialized.FindProperty("count").intValue = 9;
            Assert.That(settings.Count, Is.EqualTo(3));
            serialized.Update();
            Assert.That(serialized.FindProperty("count").intValue, Is.EqualTo(3));
            Assert.That(serialized.ApplyModifiedProperties(), Is.False);
            Assert.That(Story.Take(), Is.Empty);
        }

        [Test]
        public void Properties_of_several_objects_say_where_they_differ_and_are_written_to_all()
        {
            Settings first = Add<Settings>(), second = Add<Settings>();
            second.part.length = 7;
            second.parts[1] = new Part { length = 7 };
            var serialized = new SerializedObject(new UnityEngine.Object[] { first, second });
            Assert.That(serialized.isEditingMultipleObjects);
            Assert.That(serialized.FindProperty("part.length").hasMultipleDifferentValues);
            Assert.That(serialized.FindProperty("parts").hasMultipleDifferentValues);
            Assert.That(serialized.FindProperty("part.position").hasMultipleDifferentValues, Is.False);
            serialized.FindProperty("part.position").vector3Value = Vector3.up;
            serialized.ApplyModifiedProperties();
            Assert.That(Story.Take(), Is.EqualTo(new[] { "valid 3", "valid 3" }));
            Assert.That((first.part.position, second.part.position), Is.EqualTo((Vector3.up, Vector3.up)));
            Assert.That((first.part.length, second.part.length), Is.EqualTo((2f, 7f)), "what was not written stays each object's own");
        }

        [Test]
        public void Applied_values_recorded_ones_and_creations_are_undone_newest_first()
        {
            Undo.ClearAll();
            Settings settings = Add<Settings>();
            var serialized = new SerializedObject(settings);
            serialized.FindProperty("count").intValue = 9;
            serialized.ApplyModifiedProperties();
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(settings, "Mode");
            settings.mode = Mode.First;
            Undo.RecordObject(settings.transform, "Move");
            settings.transform.localPosition = Vector3.one;
            Undo.IncrementCurrentGroup();
            var made = new GameObject("made");
            Undo.RegisterCreatedObjectUndo(made, "Create made");
            Assert.That(Undo.GetCurrentGroupName(), Is.EqualTo("Create made"));
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(settings, "Nothing");
            Story.Take();

            Undo.PerformUndo();
            Assert.That((bool)made, Is.False);
            Assert.That(settings.mode, Is.EqualTo(Mode.First));
            Undo.PerformUndo();
            Assert.That((settings.mode, settings.transform.localPosition), Is.EqualTo((Mode.Second, Vector3.zero)));
            Assert.That(settings.Count, Is.EqualTo(9));
            Undo.PerformUndo();
            Assert.That(settings.Count, Is.EqualTo(3));
            Assert.That(Story.Take(), Is.EqualTo(new[] { "valid 9", "valid 3" }));
        }

        [Test]
        public void An_inline_class_stays_and_keeps_what_is_not_serialized()
        {
            Undo.ClearAll();
            Settings settings = Add<Settings>();
            Tally tally = settings.tally;
            tally.running = 7;
            var serialized = new SerializedObject(settings);
            serialized.FindProperty("tally.stored").intValue = 5;
            serialized.ApplyModifiedProperties();
            Assert.That((tally.stored, tally.running), Is.EqualTo((5, 7)));
            Undo.PerformUndo();
            Assert.That((tally.stored, tally.running), Is.EqualTo((0, 7)));
            Assert.That(settings.tally, Is.SameAs(tally));
            Settings copy = UnityEngine.Object.Instantiate(settings);
            Assert.That((copy.tally == tally, copy.tally.running), Is.EqualTo((false, 0)), "a copy has its own");
        }

        [Test]
        public void What_was_undone_is_redone_until_something_new_is_recorded_and_both_are_told()
        {
            Undo.ClearAll();
            int told = 0;
            Undo.UndoRedoCallback count = () => told++;
            Undo.undoRedoPerformed += count;
            Settings settings = Add<Settings>();
            Undo.PerformUndo();
            Undo.PerformRedo();
            Assert.That(told, Is.Zero, "nothing to do");
            for (int i = 0; i < 2; i++)
            {
                Undo.IncrementCurrentGroup();
                Undo.RegisterCompleteObjectUndo(settings, "Mode");
                settings.mode = i == 0 ? Mode.First : Mode.Second;
                Undo.RecordObject(settings.transform, "Move");
                settings.transform.localPosition = (i + 1) * Vector3.one;
                Undo.RecordObject(settings.transform, "Move on");
                settings.transform.localPosition += Vector3.up;
            }
            Undo.PerformUndo();
            Assert.That((settings.mode, settings.transform.localPosition), Is.EqualTo((Mode.First, new Vector3(1f, 2f, 1f))));
            Undo.PerformUndo();
            Assert.That(settings.transform.localPosition, Is.EqualTo(Vector3.zero));
            Undo.PerformRedo();
            Assert.That((settings.mode, settings.transform.localPosition), Is.EqualTo((Mode.First, new Vector3(1f, 2f, 1f))));
            Undo.PerformRedo();
            Assert.That((settings.mode, settings.transform.localPosition), Is.EqualTo((Mode.Second, new Vector3(2f, 3f, 2f))));
            Undo.PerformRedo();
            Assert.That(told, Is.EqualTo(4), "nothing is left to redo");
            Undo.PerformUndo();
            Assert.That(settings.mode, Is.EqualTo(Mode.First));
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(settings.transform, "Elsewhere");
            settings.transform.localPosition = Vector3.zero;
            Undo.PerformRedo();
            Assert.That((settings.mode, told), Is.EqualTo((Mode.First, 5)));
            Undo.undoRedoPerformed -= count;
        }

        [Test]
        public void A_creation_that_was_undone_is_not_redone_in_silence()
        {
            Undo.ClearAll();
            Undo.IncrementCurrentGroup();
            Undo.RegisterCreatedObjectUndo(new GameObject("made"), "Create made");
            Undo.PerformUndo();
            Assert.That(() => Undo.PerformRedo(), Throws.TypeOf<NotSupportedException>().With.Message.Contains("'made'"));
        }

        [InitializeOnLoadMethod]
        static void OnLoad() => loads++;
        static int loads;

        [Test]
        public void Methods_that_run_when_scripts_are_loaded_have_run_once()
        {
            Assert.That(loads, Is.EqualTo(1));
        }

        [Test]
        public void Temporary_files_lie_in_a_Temp_folder_each_with_a_name_of_its_own()
        {
            string one = FileUtil.GetUniqueTempPathInProject(), two = FileUtil.GetUniqueTempPathInProject();
            Assert.That(one, Is.Not.EqualTo(two));
            Assert.That(System.IO.Path.GetFileName(System.IO.Path.GetDirectoryName(one)), Is.EqualTo("Temp"));
            Assert.That(System.IO.File.Exists(one), Is.False);
            System.IO.File.WriteAllText(one, "kept until the process ends");
        }

        [TestCase("maxSteps", "Max Steps")]
        [TestCase("m_mesh", "Mesh")]
        [TestCase("mesh", "Mesh")]
        [TestCase("_useGPUTime2", "Use GPU Time 2")]
        public void Names_are_shown_as_words(string name, string shown)
        {
            Assert.That(ObjectNames.NicifyVariableName(name), Is.EqualTo(shown));
        }

        [Test]
        public void Groups_that_do_not_match_throw()
        {
            EditorGUILayout.BeginHorizontal();
            Assert.That(() => EditorGUILayout.EndVertical(), Throws.InvalidOperationException.With.Message.Contains("BeginHorizontal is open"));
            GuiGroups.Clear();
            Assert.That(() => EditorGUI.EndDisabledGroup(), Throws.InvalidOperationException);
            EditorGUILayout.BeginFoldoutHeaderGroup(true, "outer");
            Assert.That(() => EditorGUILayout.BeginFoldoutHeaderGroup(true, "inner"), Throws.InvalidOperationException);
            GuiGroups.Clear();
            using (new EditorGUI.DisabledScope(true))
            using (new EditorGUILayout.HorizontalScope())
            using (new EditorGUI.IndentLevelScope())
                Assert.That((GuiGroups.Open, EditorGUI.indentLevel), Is.EqualTo((3, 1)));
            Assert.That((GuiGroups.Open, EditorGUI.indentLevel), Is.EqualTo((0, 0)));
        }

        [Test]
        public void A_dragged_handle_counts_as_a_change()
        {
            var handle = new BoxBoundsHandle { size = new Vector3(1f, -2f, 3f) };
            Assert.That(handle.size, Is.EqualTo(new Vector3(1f, 2f, 3f)));
            EditorGUI.BeginChangeCheck();
            handle.DrawHandle();
            Assert.That(EditorGUI.EndChangeCheck(), Is.False);
            PrimitiveBoundsHandle.Drag = dragged => true;
            try
            {
                EditorGUI.BeginChangeCheck();
                handle.DrawHandle();
                Assert.That(EditorGUI.EndChangeCheck());
            }
            finally
            {
                PrimitiveBoundsHandle.Drag = null;
                GUI.changed = false;
            }
            var capsule = new CapsuleBoundsHandle { radius = 1f, height = 0.5f };
            Assert.That((capsule.height, capsule.radius), Is.EqualTo((2f, 1f)));
            Assert.That(new SphereBoundsHandle { radius = 3f }.radius, Is.EqualTo(3f));
        }

        [Test]
        public void The_custom_editor_of_a_type_is_found_and_draws()
        {
            Settings settings = Add<Settings>("settings");
            Editor editor = Editor.CreateEditor(settings);
            Assert.That(editor, Is.InstanceOf<SettingsEditor>());
            editor.OnInspectorGUI();
            Assert.That(Story.Take(), Is.EqualTo(new[] { "inspect settings" }));
            UnityEngine.Object.DestroyImmediate(editor);
        }

        [Test]
        public void Fields_give_back_what_goes_in()
        {
            Assert.That(EditorGUILayout.FloatField("label", 2.5f), Is.EqualTo(2.5f));
            Assert.That(EditorGUILayout.Foldout(true, "label"));
            Assert.That(GUILayout.Button("press"), Is.False);
            Assert.That(EditorGUILayout.IntSlider("label", 4, 0, 10), Is.EqualTo(4));
        }
    }
}
