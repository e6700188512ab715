using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>A bar with a label before it and a figure on it.</summary>
    static class BarChart
    {
        static readonly Color Bar = new Color(0.25f, 0.5f, 0.85f, 0.6f);

        /// <param name="share">Length of the bar, 0 to 1.</param>
        public static void Draw(string label, float share, string figure)
        {
            Rect row = EditorGUILayout.GetControlRect();
            float labelWidth = EditorGUIUtility.labelWidth;
            var bar = new Rect(row.x + labelWidth, row.y + 1f, Mathf.Max(row.width - labelWidth, 0f) * Mathf.Clamp01(share), row.height - 2f);
            EditorGUI.DrawRect(bar, Bar);
            EditorGUI.LabelField(row, label, figure);
        }
    }
}
