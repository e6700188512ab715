using UnityEngine;

namespace Rill.Editor
{
    /// <summary>
    /// Rectangles of the label, the value and the unit of a field in its row: the unit behind the value, the label in the label
    /// column, in a wider one, or above the value, whichever is the first that clips nothing.
    /// </summary>
    readonly struct FieldRowLayout
    {
        /// <summary>Pixels between two of the three.</summary>
        public const float Gap = 4f;

        /// <summary>Pixels that a value needs to be read and edited.</summary>
        public const float MinValue = 50f;

        readonly float indent, labelHeight, unitWidth, lineHeight, valueHeight;

        FieldRowLayout(float indent, float labelWidth, float labelHeight, float unitWidth, float lineHeight, float valueHeight)
        {
            this.indent = indent;
            LabelWidth = labelWidth;
            this.labelHeight = labelHeight;
            this.unitWidth = unitWidth;
            this.lineHeight = lineHeight;
            this.valueHeight = valueHeight;
        }

        /// <param name="width">Width of the row, pixels.</param>
        /// <param name="indent">Indent of its left end.</param>
        /// <param name="labelWidth">Width of the label column, the indent included.</param>
        /// <param name="lineHeight">Height of one line.</param>
        /// <param name="valueHeight">Height of the value with its label beside it; above a line if the label has one for itself.</param>
        /// <param name="unit">Null or "" for none.</param>
        public static FieldRowLayout Of(float width, float indent, float labelWidth, float lineHeight, float valueHeight, string label,
            string unit, ITextMeasure texts)
        {
            float unitWidth = string.IsNullOrEmpty(unit) ? 0f : texts.Width(unit) + Gap;
            float needed = indent + texts.Width(label) + Gap;
            bool ownsLine = valueHeight > lineHeight;
            float free = width - unitWidth - (ownsLine ? 0f : MinValue);
            if (needed <= free)
                return new FieldRowLayout(indent, ownsLine ? labelWidth : Mathf.Max(Mathf.Min(labelWidth, free), needed), 0f, unitWidth,
                    lineHeight, valueHeight);
            return new FieldRowLayout(indent, 0f, texts.Height(label, width - indent), unitWidth, lineHeight, valueHeight);
        }

        /// <summary>Whether the label stands above the value.</summary>
        public bool IsStacked => labelHeight > 0f;

        /// <summary>Width of the label column in this row, the indent included; 0 where the label stands above.</summary>
        public float LabelWidth { get; }

        public float Height => labelHeight + valueHeight;

        /// <summary>The label where it stands above the value.</summary>
        public Rect LabelIn(Rect row) => new Rect(row.x + indent, row.y, row.width - indent, labelHeight);

        /// <summary>The value, with its label beside it unless that stands above.</summary>
        public Rect FieldIn(Rect row) => new Rect(row.x, row.y + labelHeight, row.width - unitWidth, valueHeight);

        /// <summary>Rectangle after the first line of the value, with width 0 without a unit.</summary>
        public Rect UnitIn(Rect row) => new Rect(row.xMax - unitWidth + Gap, row.y + labelHeight, Mathf.Max(unitWidth - Gap, 0f), lineHeight);
    }
}
