using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Rectangles of a label, the figure after it and the bar below both.</summary>
    readonly struct BarRowLayout
    {
        readonly float indent, figureWidth;

        BarRowLayout(float indent, float figureWidth, float height)
        {
            this.indent = indent;
            this.figureWidth = figureWidth;
            Height = height;
        }

        /// <param name="width">Width of the row, pixels.</param>
        /// <param name="indent">Indent of its left end.</param>
        public static BarRowLayout Of(float width, float indent, float lineHeight, string label, string figure, ITextMeasure texts)
        {
            float figureWidth = texts.Width(figure);
            return new BarRowLayout(indent, figureWidth,
                Mathf.Max(lineHeight, texts.Height(label, width - indent - figureWidth - FieldRowLayout.Gap)));
        }

        public float Height { get; }

        public Rect LabelIn(Rect row) => new Rect(row.x + indent, row.y, row.width - indent - figureWidth - FieldRowLayout.Gap, Height);

        public Rect FigureIn(Rect row) => new Rect(row.xMax - figureWidth, row.y, figureWidth, Height);

        /// <param name="fraction">Fraction of the longest bar, 0 to 1.</param>
        public Rect BarIn(Rect row, float fraction)
            => new Rect(row.x + indent, row.y + 1f, (row.width - indent) * Mathf.Clamp01(fraction), Height - 2f);
    }
}
