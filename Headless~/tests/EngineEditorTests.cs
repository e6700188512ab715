using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Host.Tests
{
    public class EngineEditorTests : EngineFixture
    {
        enum Mode { First, Second = 5 }

        [Serializable]
        struct Part { public float length; public Vector3 place; }

        class Settings : MonoBehaviour
        {
            [SerializeField] int count = 3;
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
            serialized.FindProperty("parts").GetArrayElementAtIndex(1).FindPropertyRelative("place").vector3Value = Vector3.one;
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
            Assert.That(settings.parts[1].place, Is.EqualTo(Vector3.one));
            Assert.That(settings.parts[1].length, Is.EqualTo(4));
            Assert.That(settings.other, Is.SameAs(settings.gameObject));
            Assert.That(serialized.FindProperty("missing"), Is.Null);
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
