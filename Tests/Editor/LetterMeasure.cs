namespace Rill.Editor.Tests
{
    /// <summary>Measures texts as if every letter were equally wide: what the editor's font takes or a little more.</summary>
    sealed class LetterMeasure : ITextMeasure
    {
        public const float Letter = 7f, Line = 15f;

        public float Width(string text) => Letter * text.Length;

        public float Height(string text, float width)
        {
            int lines = 1;
            float at = 0f;
            foreach (string word in text.Split(' '))
            {
                float with = at == 0f ? Width(word) : at + Letter + Width(word);
                bool isNew = at > 0f && with > width;
                lines += isNew ? 1 : 0;
                at = isNew ? Width(word) : with;
            }
            return lines * Line;
        }

        public float WidestWord(string text)
        {
            float widest = 0f;
            foreach (string word in text.Split(' '))
                widest = System.Math.Max(widest, Width(word));
            return widest;
        }
    }
}
