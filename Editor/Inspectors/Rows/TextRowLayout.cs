using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Rectangles of a label and a text of any length: side by side, the text in as many lines as it takes, or one above the
    /// other.</summary>
    readonly struct TextRowLayout
    {
        /// <summary>Pixels below which a column of text is no longer worth reading.</summary>
        public const float MinText = 100f;

        // Indentation of a text below its label.
        const float Step = 15f;

        readonly float indent, column, labelHeight, textHeight;

        TextRowLayout(float indent, float column, float labelHeight, float textHeight)
        {
            this.indent = indent;
            this.column = column;
            this.labelHeight = labelHeight;
            this.textHeight = textHeight;
        }

        /// <param name="width">Width of the row, pixels.</param>
        /// <param name="indent">Indent of its left end.</param>
        /// <param name="labelWidth">Width of the label column, the indent included.</param>
        public static TextRowLayout Of(float width, float indent, float labelWidth, string label, string text, ITextMeasure texts)
        {
            float column = Mathf.Max(labelWidth, indent + texts.Width(label) + FieldRowLayout.Gap);
            if (width - column >= Mathf.Min(MinText, texts.Width(text)))
                return new TextRowLayout(indent, column, texts.Height(label, column - indent), texts.Height(text, width - column));
            return new TextRowLayout(indent, 0f, texts.Height(label, width - indent), texts.Height(text, width - indent - Step));
        }

        /// <summary>Whether the label stands above the text.</summary>
        public bool IsStacked => column == 0f;

        public float Height => IsStacked ? labelHeight + textHeight : Mathf.Max(labelHeight, textHeight);

        public Rect LabelIn(Rect row) => new Rect(row.x + indent, row.y, (IsStacked ? row.width : column) - indent, labelHeight);

        public Rect TextIn(Rect row)
        {
            float left = IsStacked ? indent + Step : column;
            return new Rect(row.x + left, row.y + (IsStacked ? labelHeight : 0f), row.width - left, textHeight);
        }
    }
}
