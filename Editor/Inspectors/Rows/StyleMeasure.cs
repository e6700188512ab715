using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Measures texts by a style.</summary>
    sealed class StyleMeasure : ITextMeasure
    {
        readonly GUIStyle style;
        readonly GUIContent content = new GUIContent();

        /// <param name="style">One that wraps, so that heights are those of several lines.</param>
        public StyleMeasure(GUIStyle style) => this.style = style;

        // A pixel more: a width that is rounded down wraps the last word.
        public float Width(string text) => Mathf.Ceil(style.CalcSize(Content(text)).x) + 1f;

        public float Height(string text, float width) => style.CalcHeight(Content(text), width);

        GUIContent Content(string text)
        {
            content.text = text;
            return content;
        }
    }
}
