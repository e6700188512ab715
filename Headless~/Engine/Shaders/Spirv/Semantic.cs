namespace Host.Shaders
{
    /// <summary>A semantic's name in capitals and its index: TEXCOORD is TEXCOORD0.</summary>
    readonly struct Semantic
    {
        public readonly string Name;
        public readonly int Index;

        public Semantic(string name, int index)
        {
            Name = name;
            Index = index;
        }

        public static Semantic Parse(string text)
        {
            int digits = text.Length;
            while (digits > 0 && char.IsDigit(text[digits - 1]))
                digits--;
            return new Semantic(text.Substring(0, digits).ToUpperInvariant(), digits < text.Length ? int.Parse(text.Substring(digits)) : 0);
        }

        public string Full => Name + Index;
        /// <summary>Usual spelling: POSITION, NORMAL, COLOR, but TEXCOORD0.</summary>
        public string Short => Index == 0 && Name != "TEXCOORD" ? Name : Full;
    }
}
