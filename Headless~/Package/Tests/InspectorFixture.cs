using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Draws the package's inspectors and handles as the Editor would, and sees what came of it.</summary>
    public abstract class InspectorFixture : GraphicsFixture
    {
        readonly List<Editor> editors = new List<Editor>();

        [SetUp]
        public void ClearGui()
        {
            GuiTrace.Clear();
            GuiGroups.Clear();
            Undo.ClearAll();
            Selection.activeObject = null;
        }

        [TearDown]
        public void CloseInspectors()
        {
            GuiTrace.Clear();
            PrimitiveBoundsHandle.Drag = null;
            GUI.changed = false;
            EditorGUIUtility.currentViewWidth = 400f;
            EditorGUIUtility.labelWidth = 0f;
            foreach (Editor editor in editors)
                if (editor)
                    Object.DestroyImmediate(editor);
            editors.Clear();
            PlayerLoop.Reset();
            Assert.That(HeldStages(), Is.Empty, "held by no component that is left: another test would find them in a build without them");
        }

        static List<string> HeldStages()
        {
            Func<string, StageShader> findBefore = StageShader.EditorFind;
            StageShader.EditorFind = null;
            List<string> held = Stages.Where(stage => StageShader.Find(stage) != null).ToList();
            StageShader.EditorFind = findBefore;
            return held;
        }

        /// <summary>The names of all groups' stages.</summary>
        internal static IEnumerable<string> Stages
            => Features.All.SelectMany(feature => feature.Stages);

        /// <summary>The package's custom inspectors, by what they inspect.</summary>
        internal static IEnumerable<(Type inspected, Type editor)> Inspectors
        {
            get
            {
                foreach (Assembly assembly in new[] { typeof(SceneSetup).Assembly, Assembly.Load("Rill.Physics.Editor"),
                    Assembly.Load("Rill.Terrain.Editor") })
                    foreach (Type type in assembly.GetTypes())
                        foreach (CustomEditor mark in type.GetCustomAttributes<CustomEditor>(false))
                            yield return (mark.Inspected, type);
            }
        }

        internal Editor Inspect(params Object[] targets)
        {
            Editor editor = Editor.CreateEditor(targets);
            editors.Add(editor);
            return editor;
        }

        /// <summary>Draws everything that an inspector has, with all foldouts open.</summary>
        internal static void Draw(Editor editor)
        {
            foreach (string title in new[] { "Statistics", "GPU time",
                "GPU memory" }.Concat((editor as RillEditor)?.Sections.Select(s => s.Title) ?? new string[0]))
                SessionState.SetBool($"Rill.{editor.GetType().Name}.{title}", true);
            Assert.That(GuiPasses.Draw(editor.OnInspectorGUI), Is.Null, editor.GetType().Name);
            AssertClosed(editor);
        }

        /// <summary>Draws the handles of each target.</summary>
        internal static void DrawHandles(Editor editor)
        {
            MethodInfo draw = editor.GetType().GetMethod("OnSceneGUI", BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public);
            draw?.Invoke(editor, null);
            AssertClosed(editor);
        }

        static void AssertClosed(Editor editor)
        {
            Assert.That(GuiGroups.Open, Is.Zero, $"groups of {editor.GetType().Name} that were left open");
            Assert.That(EditorGUI.indentLevel, Is.Zero);
            Assert.That(Handles.matrix, Is.EqualTo(Matrix4x4.identity));
        }
    }
}
