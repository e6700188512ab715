using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>
    /// Draws what is wrong, the sections of a component and, while it plays, what it measures. What there is to draw comes from
    /// plain classes; nothing here decides.
    /// </summary>
    abstract class RillEditor : UnityEditor.Editor
    {
        readonly List<(string label, string text)> rows = new List<(string, string)>();

        /// <summary>All serialized fields, each once.</summary>
        internal abstract InspectorSection[] Sections { get; }

        /// <summary>Lists the live values of one component while it plays.</summary>
        internal virtual void ListLive(List<(string label, string text)> live) { }

        /// <summary>Below what is wrong with the component itself.</summary>
        private protected virtual void DrawMessages() { }

        /// <summary>Above all sections, playing or not.</summary>
        private protected virtual void DrawAboveSections() { }

        /// <summary>Draws what stands above the fields of a section, given by its title.</summary>
        private protected virtual void DrawAbove(string title) { }

        /// <summary>Draws what stands below the fields of a section, given by its title.</summary>
        private protected virtual void DrawBelow(string title) { }

        /// <summary>Below all sections, playing or not.</summary>
        private protected virtual void DrawBelowSections() { }

        /// <summary>Below these, while it plays.</summary>
        private protected virtual void DrawLive() { }

        /// <summary>Returns the bounds that F frames for one component in the scene view; false where it has no size.</summary>
        internal virtual bool TryGetFrame(Object of, out Bounds bounds)
        {
            bounds = default;
            return false;
        }

        // Unity finds these two by name, and no private ones of a base class. It frames what one editor says, so that is of all its objects.
        protected bool HasFrameBounds() => TryGetFrame(out _);

        protected Bounds OnGetFrameBounds()
        {
            TryGetFrame(out Bounds bounds);
            return bounds;
        }

        bool TryGetFrame(out Bounds bounds)
        {
            bool isThere = false;
            bounds = default;
            foreach (Object one in targets)
                if (one != null && TryGetFrame(one, out Bounds more))
                    FrameBounds.Join(ref isThere, ref bounds, more);
            return isThere;
        }

        public override bool RequiresConstantRepaint() => Plays;

        // In play mode, or with a fluid that is simulated without Play.
        bool Plays => Application.isPlaying || target is MonoBehaviour script && script.runInEditMode;

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            foreach (string problem in ProblemList.Of(targets))
                EditorGUILayout.HelpBox(problem, MessageType.Warning);
            DrawMessages();
            DrawAboveSections();
            foreach (InspectorSection section in Sections)
                Draw(section);
            serializedObject.ApplyModifiedProperties();
            DrawBelowSections();
            if (!Plays || targets.Length > 1)
                return;
            rows.Clear();
            ListLive(rows);
            DrawRows(rows);
            DrawLive();
        }

        private protected static void DrawRows(List<(string label, string text)> rows)
        {
            foreach ((string label, string text) in rows)
                InspectorRows.Text(label, text);
        }

        /// <summary>A foldout whose state lasts for the session.</summary>
        // Not a foldout header group: lists have headers of their own, which may not be nested in one.
        private protected bool Unfold(string title, bool startsOpen)
        {
            string key = $"Rill.{GetType().Name}.{title}";
            bool wasOpen = SessionState.GetBool(key, startsOpen);
            bool isOpen = EditorGUILayout.Foldout(wasOpen, title, true, EditorStyles.foldoutHeader);
            if (isOpen != wasOpen)
                SessionState.SetBool(key, isOpen);
            return isOpen;
        }

        void Draw(InspectorSection section)
        {
            if (!Unfold(section.Title, section.StartsOpen))
                return;
            using (new EditorGUI.IndentLevelScope())
            {
                DrawAbove(section.Title);
                foreach (InspectorField field in section.Shown(serializedObject))
                {
                    SerializedProperty property = serializedObject.FindProperty(field.Path);
                    InspectorRows.Field(property, field.Label(serializedObject, property), field.Unit(serializedObject));
                }
                DrawBelow(section.Title);
            }
        }
    }
}
