using System;
using System.Globalization;
using System.Text;
using UnityEngine.Headless;

namespace Host.Shaders
{
    enum LabTokenKind { Word, Number, Text, Symbol, End }

    /// <summary>A program or include block, with the text between its two words.</summary>
    sealed class CodeBlock
    {
        public string Text;
        public int FirstLine;
        /// <summary>CGPROGRAM and CGINCLUDE rather than HLSLPROGRAM and HLSLINCLUDE.</summary>
        public bool Cg;
    }

    /// <summary>The words, numbers, strings and symbols of a .shader file, with comments left out.</summary>
    sealed class ShaderLabReader
    {
        readonly string text, path;
        int at, line = 1;

        public ShaderLabReader(string text, string path)
        {
            this.text = text;
            this.path = path;
            Next();
        }

        public LabTokenKind Kind { get; private set; }
        public string Value { get; private set; }
        public int Line { get; private set; }
        public string Path => path;

        public ShaderCompileException Error(string what) => new ShaderCompileException(path, Line, what);
        public ShaderCompileException Unexpected(string wanted)
            => Error($"expected {wanted}, found {(Kind == LabTokenKind.End ? "the end of the file" : $"'{Value}'")}");

        public bool IsWord(string word) => Kind == LabTokenKind.Word && string.Equals(Value, word, StringComparison.OrdinalIgnoreCase);
        public bool IsSymbol(char symbol) => Kind == LabTokenKind.Symbol && Value[0] == symbol;

        public bool TryReadWord(string word)
        {
            if (!IsWord(word))
                return false;
            Next();
            return true;
        }

        public bool TryReadSymbol(char symbol)
        {
            if (!IsSymbol(symbol))
                return false;
            Next();
            return true;
        }

        public void Expect(char symbol)
        {
            if (!TryReadSymbol(symbol))
                throw Unexpected($"'{symbol}'");
        }

        public string ReadText() => Expect(LabTokenKind.Text, "a \"string\"");
        public string ReadWord(string what) => Expect(LabTokenKind.Word, what);

        string Expect(LabTokenKind kind, string what)
        {
            if (Kind != kind)
                throw Unexpected(what);
            string value = Value;
            Next();
            return value;
        }

        public float ReadNumber()
        {
            string value = Expect(LabTokenKind.Number, "a number");
            if (!float.TryParse(value.TrimEnd('f', 'F'), NumberStyles.Float, CultureInfo.InvariantCulture, out float number))
                throw Error($"'{value}' is not a number");
            return number;
        }

        public void Next()
        {
            SkipBlanks();
            Line = line;
            if (at >= text.Length)
            {
                Kind = LabTokenKind.End;
                Value = "";
                return;
            }
            int start = at;
            char c = text[at];
            bool sign = (c == '-' || c == '+' || c == '.') && at + 1 < text.Length && (char.IsDigit(text[at + 1]) || text[at + 1] == '.');
            if (c == '"')
            {
                int end = text.IndexOf('"', at + 1);
                int newline = text.IndexOf('\n', at + 1);
                if (end < 0 || newline >= 0 && newline < end)
                    throw Error("this string has no closing quote");
                Kind = LabTokenKind.Text;
                Value = text.Substring(at + 1, end - at - 1);
                at = end + 1;
            }
            else if (char.IsDigit(c) || sign)
            {
                at++;
                // "2D", "3D" and "2DArray" are words that begin with a digit.
                while (at < text.Length && (char.IsLetterOrDigit(text[at]) || text[at] == '.' || (text[at] == '-' || text[at] == '+')
                    && (text[at - 1] | 32) == 'e'))
                    at++;
                Value = text.Substring(start, at - start);
                Kind = Value.Length > 1 && (Value[1] == 'D' || Value[1] == 'd') ? LabTokenKind.Word : LabTokenKind.Number;
            }
            else if (char.IsLetter(c) || c == '_')
            {
                while (at < text.Length && (char.IsLetterOrDigit(text[at]) || text[at] == '_' || text[at] == '.'))
                    at++;
                Kind = LabTokenKind.Word;
                Value = text.Substring(start, at - start);
            }
            else
            {
                at++;
                Kind = LabTokenKind.Symbol;
                Value = c.ToString();
            }
        }

        void SkipBlanks()
        {
            while (at < text.Length)
            {
                if (text[at] == '/' && at + 1 < text.Length && text[at + 1] == '/')
                    while (at < text.Length && text[at] != '\n')
                        at++;
                else if (text[at] == '/' && at + 1 < text.Length && text[at + 1] == '*')
                {
                    Line = line;
                    int end = text.IndexOf("*/", at + 2, StringComparison.Ordinal);
                    if (end < 0)
                        throw Error("this comment has no end");
                    for (; at < end + 2; at++)
                        if (text[at] == '\n')
                            line++;
                }
                else if (char.IsWhiteSpace(text[at]))
                {
                    if (text[at++] == '\n')
                        line++;
                }
                else
                    return;
            }
        }

        /// <summary>With an opening bracket as the present token: the text up to the closing one, e.g. of [Header(Surface, again)].</summary>
        public string ReadBrackets()
        {
            if (!IsSymbol('['))
                throw Unexpected("'['");
            var inside = new StringBuilder();
            while (at < text.Length && text[at] != ']' && text[at] != '\n')
                inside.Append(text[at++]);
            if (at >= text.Length || text[at] != ']')
                throw Error("this [ has no ]");
            at++;
            Next();
            return inside.ToString().Trim();
        }

        /// <summary>With an opening brace as the present token: skips past its closing one.</summary>
        public void SkipBraces()
        {
            int open = Line;
            Expect('{');
            for (int depth = 1; depth > 0; Next())
            {
                if (Kind == LabTokenKind.End)
                    throw new ShaderCompileException(path, open, "this { has no }");
                depth += IsSymbol('{') ? 1 : IsSymbol('}') ? -1 : 0;
            }
        }

        /// <summary>With HLSLPROGRAM or the like as the present token: takes the block. False when it is another token.</summary>
        public bool TryTakeCode(string kind, out CodeBlock block)
        {
            block = null;
            bool cg = IsWord("CG" + kind), hlsl = IsWord("HLSL" + kind);
            if (!cg && !hlsl)
                return false;
            string end = cg ? "ENDCG" : "ENDHLSL";
            int stop = FindEnd(end);
            if (stop < 0)
                throw Error($"{Value} has no {end}");
            block = new CodeBlock { Text = text.Substring(at, stop - at), FirstLine = line, Cg = cg };
            for (; at < stop; at++)
                if (text[at] == '\n')
                    line++;
            at += end.Length;
            Next();
            return true;
        }

        int FindEnd(string word)
        {
            for (int i = text.IndexOf(word, at, StringComparison.Ordinal); i >= 0; i = text.IndexOf(word, i + 1, StringComparison.Ordinal))
            {
                int lineStart = text.LastIndexOf('\n', i) + 1;
                bool wholeWord = i + word.Length >= text.Length || !char.IsLetterOrDigit(text[i + word.Length]) && text[i + word.Length] != '_';
                if (wholeWord && text.IndexOf("//", lineStart, i - lineStart, StringComparison.Ordinal) < 0)
                    return i;
            }
            return -1;
        }
    }
}
