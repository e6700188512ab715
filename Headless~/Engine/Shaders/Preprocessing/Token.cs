using System.Collections.Generic;

namespace Host.Shaders
{
    enum TokenKind { Identifier, Number, Text, Symbol, Space }

    /// <summary>A preprocessing token. Hidden lists the macros whose expansion it came from and that it must not start again.</summary>
    sealed class Token
    {
        public readonly TokenKind Kind;
        public readonly string Text;
        public readonly HiddenMacros Hidden;

        public Token(TokenKind kind, string text, HiddenMacros hidden = null)
        {
            Kind = kind;
            Text = text;
            Hidden = hidden;
        }

        public static readonly Token Blank = new Token(TokenKind.Space, " ");

        public bool Is(string symbol) => Kind == TokenKind.Symbol && Text == symbol;
        public Token Hide(HiddenMacros more) => more == null || Kind != TokenKind.Identifier ? this
            : new Token(Kind, Text, HiddenMacros.Union(Hidden, more));

        public static List<Token> Split(string line)
        {
            var tokens = new List<Token>();
            for (int i = 0; i < line.Length;)
            {
                int start = i;
                char c = line[i];
                TokenKind kind;
                if (char.IsWhiteSpace(c))
                {
                    kind = TokenKind.Space;
                    while (i < line.Length && char.IsWhiteSpace(line[i]))
                        i++;
                }
                else if (char.IsLetter(c) || c == '_' || c == '$')
                {
                    kind = TokenKind.Identifier;
                    while (i < line.Length && (char.IsLetterOrDigit(line[i]) || line[i] == '_' || line[i] == '$'))
                        i++;
                }
                else if (char.IsDigit(c) || c == '.' && i + 1 < line.Length && char.IsDigit(line[i + 1]))
                {
                    kind = TokenKind.Number;
                    bool hex = c == '0' && i + 1 < line.Length && (line[i + 1] | 32) == 'x';
                    while (i < line.Length && (char.IsLetterOrDigit(line[i]) || line[i] == '.' || line[i] == '_'
                        || !hex && (line[i] == '+' || line[i] == '-') && (line[i - 1] | 32) == 'e'))
                        i++;
                }
                else if (c == '"')
                {
                    kind = TokenKind.Text;
                    int end = line.IndexOf('"', i + 1);
                    i = end < 0 ? line.Length : end + 1;
                }
                else
                {
                    kind = TokenKind.Symbol;
                    i += i + 1 < line.Length && IsPair(c, line[i + 1]) ? 2 : 1;
                    if (i < line.Length && line[i] == '=' && i - start == 2 && (line[start] == '<' || line[start] == '>') && line[start + 1] == c)
                        i++;    // <<= and >>=
                }
                tokens.Add(new Token(kind, line.Substring(start, i - start)));
            }
            return tokens;
        }

        /// <summary>Whether the two would read as something else without a space between them.</summary>
        public static bool WouldMerge(Token left, Token right)
        {
            if (left.Text.Length == 0 || right.Text.Length == 0 || left.Kind == TokenKind.Space || right.Kind == TokenKind.Space)
                return false;
            bool wordLeft = left.Kind == TokenKind.Identifier || left.Kind == TokenKind.Number,
                wordRight = right.Kind == TokenKind.Identifier || right.Kind == TokenKind.Number;
            if (wordLeft && wordRight)
                return true;
            return left.Kind == TokenKind.Symbol && right.Kind == TokenKind.Symbol && IsPair(left.Text[left.Text.Length - 1], right.Text[0]);
        }

        static bool IsPair(char a, char b) => b == '=' && "=!<>+-*/%&|^".IndexOf(a) >= 0 || a == b && "#&|<>+-:".IndexOf(a) >= 0;
    }

    /// <summary>An immutable list of macro names.</summary>
    sealed class HiddenMacros
    {
        readonly string name;
        readonly HiddenMacros rest;

        HiddenMacros(string name, HiddenMacros rest)
        {
            this.name = name;
            this.rest = rest;
        }

        public static bool Contains(HiddenMacros list, string name)
        {
            for (; list != null; list = list.rest)
                if (list.name == name)
                    return true;
            return false;
        }

        public static HiddenMacros Add(HiddenMacros list, string name) => Contains(list, name) ? list : new HiddenMacros(name, list);

        public static HiddenMacros Union(HiddenMacros a, HiddenMacros b)
        {
            for (; b != null; b = b.rest)
                a = Add(a, b.name);
            return a;
        }

        public static HiddenMacros Intersect(HiddenMacros a, HiddenMacros b)
        {
            HiddenMacros both = null;
            for (; a != null; a = a.rest)
                if (Contains(b, a.name))
                    both = Add(both, a.name);
            return both;
        }
    }
}
