using System;
using System.Collections.Generic;
using System.Text;

namespace Host.UnityApi
{
    /// <summary>A signature in words: identifiers, literals, and punctuation sign by sign.</summary>
    sealed class SignatureTokens
    {
        readonly List<string> words = new();
        int at;

        public SignatureTokens(string text)
        {
            int i = 0;
            while (i < text.Length)
            {
                char c = text[i];
                if (char.IsWhiteSpace(c))
                {
                    i++;
                    continue;
                }
                int start = i;
                if (c == '/' && i + 1 < text.Length && text[i + 1] == '/')
                    throw new FormatException("a comment to the line's end swallows what follows");
                if (c == '/' && i + 1 < text.Length && text[i + 1] == '*')
                {
                    int end = text.IndexOf("*/", i + 2, StringComparison.Ordinal);
                    if (end < 0)
                        throw new FormatException("a comment does not end");
                    i = end + 2;
                    continue;
                }
                if (c is '"' or '\'')
                    i = Quoted(text, i);
                else if (IsWord(c) || c == '@')
                    do
                        i++;
                    while (i < text.Length && (IsWord(text[i]) || text[i] == '.' && char.IsDigit(c)));
                else if (string.CompareOrdinal(text, i, ".ctor", 0, 5) == 0)
                    i += 5;
                else if (string.CompareOrdinal(text, i, "::", 0, 2) == 0)
                    i += 2;
                else
                    i++;
                words.Add(text.Substring(start, i - start));
            }
        }

        public int Count => words.Count;
        public string Peek => PeekAt(0);
        public string PeekAt(int ahead) => at + ahead < words.Count ? words[at + ahead] : "";

        public string Next()
        {
            if (at >= words.Count)
                throw new FormatException("ends too early");
            return words[at++];
        }

        public bool Take(string word)
        {
            if (Peek != word)
                return false;
            at++;
            return true;
        }

        public void Expect(string word)
        {
            if (!Take(word))
                throw new FormatException($"'{word}' expected, not '{Peek}'");
        }

        public string Identifier()
        {
            string word = Next();
            if (word[0] == '@')
                word = word.Substring(1);
            if (word.Length == 0 || !IsWord(word[0]) || char.IsDigit(word[0]))
                throw new FormatException($"a name expected, not '{word}'");
            return word;
        }

        /// <summary>From an opening sign to the one that closes it, both included.</summary>
        public string Balanced(string open, string close)
        {
            var text = new StringBuilder();
            int depth = 0;
            do
            {
                string word = Next();
                depth += word == open ? 1 : word == close ? -1 : 0;
                text.Append(word);
            }
            while (depth > 0);
            return text.ToString();
        }

        /// <summary>Up to one of two signs outside brackets, which is left.</summary>
        public string Until(string first, string second)
        {
            var text = new StringBuilder();
            int depth = 0;
            while (depth > 0 || Peek != first && Peek != second)
            {
                string word = Next();
                depth += word is "(" or "[" or "<" or "{" ? 1 : word is ")" or "]" or ">" or "}" ? -1 : 0;
                if (text.Length > 0 && IsWord(text[^1]) && IsWord(word[0]))
                    text.Append(' ');
                text.Append(word);
            }
            return text.ToString();
        }

        public void End()
        {
            if (at < words.Count)
                throw new FormatException($"'{Peek}' is one word too many");
        }

        static bool IsWord(char c) => char.IsLetterOrDigit(c) || c == '_';

        static int Quoted(string text, int i)
        {
            char quote = text[i++];
            while (i < text.Length && text[i] != quote)
                i += text[i] == '\\' ? 2 : 1;
            if (i >= text.Length)
                throw new FormatException("a literal does not end");
            return i + 1;
        }
    }
}
