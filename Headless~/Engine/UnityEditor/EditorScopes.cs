using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Headless;

namespace UnityEditor
{
    public partial class EditorGUI
    {
        static readonly Stack<bool> changesBefore = new Stack<bool>();

        public static void BeginChangeCheck()
        {
            GuiGroups.Begin("ChangeCheck");
            changesBefore.Push(GUI.changed);
            GUI.changed = false;
        }

        public static bool EndChangeCheck()
        {
            GuiGroups.End("ChangeCheck");
            bool changed = GUI.changed;
            GUI.changed |= changesBefore.Pop();
            return changed;
        }

        public struct DisabledScope : IDisposable
        {
            public DisabledScope(bool disabled) => BeginDisabledGroup(disabled);
            public void Dispose() => EndDisabledGroup();
        }

        public class IndentLevelScope : GUI.Scope
        {
            readonly int increment;

            public IndentLevelScope() : this(1) { }

            public IndentLevelScope(int increment)
            {
                this.increment = increment;
                indentLevel += increment;
                GuiGroups.Begin(nameof(IndentLevelScope));
            }

            protected override void CloseScope()
            {
                GuiGroups.End(nameof(IndentLevelScope));
                indentLevel -= increment;
            }
        }

        public class ChangeCheckScope : GUI.Scope
        {
            bool closed;

            public ChangeCheckScope() => BeginChangeCheck();
            public bool changed => GUI.changed;

            protected override void CloseScope()
            {
                if (!closed)
                    EndChangeCheck();
                closed = true;
            }
        }
    }

    public partial class EditorGUILayout
    {
        public class HorizontalScope : GUI.Scope
        {
            public HorizontalScope(params GUILayoutOption[] options) => rect = BeginHorizontal(options);
            public HorizontalScope(GUIStyle style, params GUILayoutOption[] options) => rect = BeginHorizontal(style, options);
            public Rect rect { get; protected set; }
            protected override void CloseScope() => EndHorizontal();
        }

        public class VerticalScope : GUI.Scope
        {
            public VerticalScope(params GUILayoutOption[] options) => rect = BeginVertical(options);
            public VerticalScope(GUIStyle style, params GUILayoutOption[] options) => rect = BeginVertical(style, options);
            public Rect rect { get; protected set; }
            protected override void CloseScope() => EndVertical();
        }

        public static bool BeginFoldoutHeaderGroup(bool foldout, string content, GUIStyle style = null, Action<Rect> menuAction = null,
            GUIStyle menuIcon = null)
        {
            GuiGroups.Begin("FoldoutHeaderGroup");
            return foldout;
        }

        public static bool BeginFoldoutHeaderGroup(bool foldout, GUIContent content, GUIStyle style = null, Action<Rect> menuAction = null,
            GUIStyle menuIcon = null)
            => BeginFoldoutHeaderGroup(foldout, content.text, style, menuAction, menuIcon);

        public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) => PropertyField(property, null, options);
        public static bool PropertyField(SerializedProperty property, bool includeChildren, params GUILayoutOption[] options)
            => PropertyField(property, null, includeChildren, options);
        public static bool PropertyField(SerializedProperty property, GUIContent label, params GUILayoutOption[] options)
            => PropertyField(property, label, IsVectorLike(property), options);

        /// <summary>Says what it would draw to <see cref="GuiTrace"/>; as in Unity, a property that is not there throws.</summary>
        public static bool PropertyField(SerializedProperty property, GUIContent label, bool includeChildren, params GUILayoutOption[] options)
        {
            GuiTrace.Field(property, label?.text ?? property.displayName);
            return property.isExpanded && includeChildren;
        }

        public static void HelpBox(string message, MessageType type) => GuiTrace.Help(type, message);
        public static void HelpBox(string message, MessageType type, bool wide) => GuiTrace.Help(type, message);
        public static void HelpBox(GUIContent content, bool wide = true) => GuiTrace.Help(MessageType.None, content.text);

        static bool IsVectorLike(SerializedProperty property) => property.propertyType != SerializedPropertyType.Generic;
    }

    public partial class Handles
    {
        public struct DrawingScope : IDisposable
        {
            readonly Color originalColor;
            readonly Matrix4x4 originalMatrix;

            public DrawingScope(Color color) : this(color, Handles.matrix) { }
            public DrawingScope(Matrix4x4 matrix) : this(Handles.color, matrix) { }

            public DrawingScope(Color color, Matrix4x4 matrix)
            {
                originalColor = Handles.color;
                originalMatrix = Handles.matrix;
                Handles.color = color;
                Handles.matrix = matrix;
            }

            public void Dispose()
            {
                Handles.color = originalColor;
                Handles.matrix = originalMatrix;
            }
        }
    }

    public enum MessageType { None = 0, Info = 1, Warning = 2, Error = 3 }
}
