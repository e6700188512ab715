namespace Rill.Editor
{
    /// <summary>How large a text is in the style that it is drawn in, pixels.</summary>
    interface ITextMeasure
    {
        /// <summary>In one line.</summary>
        float Width(string text);

        /// <summary>In as many lines as a column of a width takes, broken between words.</summary>
        float Height(string text, float width);
    }
}
