using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Draws rows of an inspector or a window that fit whatever width it has.</summary>
    /// <remarks>Heights come from the view's width, which is the same in every event, not from the row's rectangle, which the layout event
    /// does not know yet.</remarks>
    static class InspectorRows
    {
        // Pixels that the inspector leaves free at both sides, and a scroll bar takes.
        const float Margins = 18f + 5f + 13f;
        const float IndentStep = 15f, MinWidth = 150f;

        static readonly Color Bar = new Color(0.25f, 0.5f, 0.85f, 0.6f);

        /// <summary>A serialized field followed by its unit.</summary>
        /// <param name="unit">Null for none.</param>
        public static void Field(SerializedProperty property, GUIContent label, string unit)
        {
            GUIStyle style = EditorStyles.wordWrappedLabel;
            FieldRowLayout layout = FieldRowLayout.Of(Width, Indent, EditorGUIUtility.labelWidth, EditorGUIUtility.singleLineHeight,
                EditorGUI.GetPropertyHeight(property, label, true), label.text, unit, new StyleMeasure(style));
            Rect row = EditorGUILayout.GetControlRect(true, layout.Height);
            float before = EditorGUIUtility.labelWidth;
            if (layout.IsStacked)
            {
                GUI.Label(layout.LabelIn(row), EditorGUI.BeginProperty(row, label, property), style);
                EditorGUI.PropertyField(layout.FieldIn(row), property, GUIContent.none, true);
                EditorGUI.EndProperty();
            }
            else
            {
                EditorGUIUtility.labelWidth = layout.LabelWidth;
                EditorGUI.PropertyField(layout.FieldIn(row), property, label, true);
                EditorGUIUtility.labelWidth = before;
            }
            if (!string.IsNullOrEmpty(unit))
                GUI.Label(layout.UnitIn(row), unit, EditorStyles.label);
        }

        /// <summary>A text with its label, in as many lines as it takes.</summary>
        public static void Text(string label, string text)
        {
            GUIStyle style = EditorStyles.wordWrappedLabel;
            TextRowLayout layout = TextRowLayout.Of(Width, Indent, EditorGUIUtility.labelWidth, label, text, new StyleMeasure(style));
            Rect row = EditorGUILayout.GetControlRect(true, layout.Height);
            GUI.Label(layout.LabelIn(row), label, style);
            GUI.Label(layout.TextIn(row), text, style);
        }

        /// <summary>A label and a figure over a bar.</summary>
        /// <param name="fraction">Fraction of the longest bar, 0 to 1.</param>
        public static void BarOf(string label, float fraction, string figure)
        {
            GUIStyle style = EditorStyles.wordWrappedLabel;
            BarRowLayout layout = BarRowLayout.Of(Width, Indent, EditorGUIUtility.singleLineHeight, label, figure, new StyleMeasure(style));
            Rect row = EditorGUILayout.GetControlRect(true, layout.Height);
            EditorGUI.DrawRect(layout.BarIn(row, fraction), Bar);
            GUI.Label(layout.LabelIn(row), label, style);
            GUI.Label(layout.FigureIn(row), figure, style);
        }

        static float Width => Mathf.Max(EditorGUIUtility.currentViewWidth - Margins, MinWidth);

        static float Indent => IndentStep * EditorGUI.indentLevel;
    }
}
