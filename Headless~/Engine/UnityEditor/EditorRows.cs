using System;
using UnityEngine;
using UnityEngine.Headless;

namespace UnityEditor
{
    // Controls that take a row of an inspector: where it is and how wide, so that tests see what is clipped.
    public partial class EditorGUI
    {
        public static bool PropertyField(Rect position, SerializedProperty property) => PropertyField(position, property, null, false);
        public static bool PropertyField(Rect position, SerializedProperty property, bool includeChildren)
            => PropertyField(position, property, null, includeChildren);
        public static bool PropertyField(Rect position, SerializedProperty property, GUIContent label)
            => PropertyField(position, property, label, false);

        /// <summary>Says what it would draw to <see cref="GuiTrace"/>, and its label to <see cref="GuiDrawing"/>; no label with
        /// GUIContent.none.</summary>
        public static bool PropertyField(Rect position, SerializedProperty property, GUIContent label, bool includeChildren)
        {
            string text = label?.text ?? property.displayName;
            GuiTrace.Field(property, text);
            if (label != GUIContent.none)
            {
                float indent = 15f * indentLevel;
                bool ownsLine = GetPropertyHeight(property, label, includeChildren) > EditorGUIUtility.singleLineHeight;
                GuiDrawing.Label(new Rect(position.x + indent, position.y,
                    (ownsLine ? position.width : Math.Min(EditorGUIUtility.labelWidth, position.width)) - indent,
                    EditorGUIUtility.singleLineHeight), text, EditorStyles.label);
            }
            return property.isExpanded && includeChildren;
        }

        public static float GetPropertyHeight(SerializedProperty property) => GetPropertyHeight(property, null, true);
        public static float GetPropertyHeight(SerializedProperty property, bool includeChildren)
            => GetPropertyHeight(property, null, includeChildren);
        public static float GetPropertyHeight(SerializedProperty property, GUIContent label) => GetPropertyHeight(property, label, true);

        /// <summary>Vectors have a line of their own below the label in narrow views; children are not counted.</summary>
        public static float GetPropertyHeight(SerializedProperty property, GUIContent label, bool includeChildren)
        {
            bool isVector = property.propertyType == SerializedPropertyType.Vector2 || property.propertyType == SerializedPropertyType.Vector3;
            return EditorGUIUtility.singleLineHeight * (isVector && !EditorGUIUtility.wideMode ? 2 : 1);
        }

        public static GUIContent BeginProperty(Rect totalPosition, GUIContent label, SerializedProperty property)
        {
            GuiGroups.Begin("Property");
            return label ?? new GUIContent(property.displayName);
        }
    }

    public partial class EditorGUILayout
    {
        public static Rect GetControlRect(params GUILayoutOption[] options) => GetControlRect(true, options);
        public static Rect GetControlRect(bool hasLabel, params GUILayoutOption[] options)
            => GetControlRect(hasLabel, EditorGUIUtility.singleLineHeight, options);
        public static Rect GetControlRect(bool hasLabel, float height, params GUILayoutOption[] options)
            => new Rect(18f, 0f, EditorGUIUtility.currentViewWidth - 18f - 5f, height);
        public static Rect GetControlRect(bool hasLabel, float height, GUIStyle style, params GUILayoutOption[] options)
            => GetControlRect(hasLabel, height, options);

        public static void LabelField(string label, params GUILayoutOption[] options)
            => LabelField(new GUIContent(label), EditorStyles.label, options);
        public static void LabelField(string label, GUIStyle style, params GUILayoutOption[] options)
            => LabelField(new GUIContent(label), style, options);
        public static void LabelField(GUIContent label, params GUILayoutOption[] options) => LabelField(label, EditorStyles.label, options);
        public static void LabelField(string label, string label2, params GUILayoutOption[] options)
            => LabelField(new GUIContent(label), new GUIContent(label2), EditorStyles.label, options);
        public static void LabelField(string label, string label2, GUIStyle style, params GUILayoutOption[] options)
            => LabelField(new GUIContent(label), new GUIContent(label2), style, options);
        public static void LabelField(GUIContent label, GUIContent label2, params GUILayoutOption[] options)
            => LabelField(label, label2, EditorStyles.label, options);

        public static void LabelField(GUIContent label, GUIStyle style, params GUILayoutOption[] options)
        {
            Rect row = GetControlRect();
            float indent = 15f * EditorGUI.indentLevel;
            GuiDrawing.Label(new Rect(row.x + indent, row.y, row.width - indent, style.CalcHeight(label, row.width - indent)), label.text, style);
        }

        /// <summary>The second text wraps as in Unity, and takes lines, only in a style that wraps.</summary>
        public static void LabelField(GUIContent label, GUIContent label2, GUIStyle style, params GUILayoutOption[] options)
        {
            Rect row = GetControlRect();
            float column = EditorGUIUtility.labelWidth, indent = 15f * EditorGUI.indentLevel;
            GuiDrawing.Label(new Rect(row.x + indent, row.y, column - indent, row.height), label.text, EditorStyles.label);
            GuiDrawing.Label(new Rect(row.x + column, row.y, row.width - column, style.wordWrap
                ? style.CalcHeight(label2, row.width - column) : row.height), label2.text, style);
        }
    }

    public partial class EditorGUIUtility
    {
        static float ownLabelWidth;

        /// <summary>Pixels; a test makes it narrow.</summary>
        public static float currentViewWidth { get; internal set; } = 400f;

        /// <summary>0 gives back the editor's own.</summary>
        public static float labelWidth
        {
            get => ownLabelWidth > 0f ? ownLabelWidth : Math.Max(0.45f * currentViewWidth - 40f, 120f);
            set => ownLabelWidth = value;
        }
    }
}
