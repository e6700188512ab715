using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Shaders
{
    /// <summary>
    /// Writes M._m03_m13_m23 out as float3(M._m03, M._m13, M._m23): glslang (12.0) makes nonsense of matrix swizzles of more
    /// than one element, and Unity's sources are full of them.
    /// </summary>
    static class MatrixSwizzle
    {
        static readonly Regex Several = new Regex(@"^(?:(_m[0-3][0-3]){2,4}|(_[1-4][1-4]){2,4})$");
        static readonly string[] Assignments = { "=", "+=", "-=", "*=", "/=" };
        static readonly Regex Element = new Regex(@"_m?\d\d");

        /// <summary>Expands swizzles that are read.</summary>
        public static List<Token> Expand(List<Token> tokens)
        {
            for (int i = 0; i < tokens.Count; i++)
            {
                if (tokens[i].Kind != TokenKind.Identifier || tokens[i].Text.Length < 6 || i < 2 || !tokens[i - 1].Is(".")
                    || !Several.IsMatch(tokens[i].Text))
                    continue;
                int next = i + 1;
                while (next < tokens.Count && tokens[next].Kind == TokenKind.Space)
                    next++;
                if (next < tokens.Count && tokens[next].Kind == TokenKind.Symbol && Array.IndexOf(Assignments, tokens[next].Text) >= 0)
                    continue;       // a statement may go over several lines: see ExpandAssignments

                int begin = Begin(tokens, i - 2);
                List<Token> matrix = tokens.GetRange(begin, i - 1 - begin);
                string[] elements = Element.Matches(tokens[i].Text).Select(m => m.Value).ToArray();
                var call = new List<Token> { new Token(TokenKind.Identifier, "float" + elements.Length), new Token(TokenKind.Symbol, "(") };
                for (int e = 0; e < elements.Length; e++)
                {
                    if (e > 0)
                        call.Add(new Token(TokenKind.Symbol, ","));
                    call.AddRange(matrix);
                    call.Add(new Token(TokenKind.Symbol, "."));
                    call.Add(new Token(TokenKind.Identifier, elements[e]));
                }
                call.Add(new Token(TokenKind.Symbol, ")"));
                tokens.RemoveRange(begin, i + 1 - begin);
                tokens.InsertRange(begin, call);
                i = begin + call.Count - 1;
            }
            return tokens;
        }

        /// <summary>Expands swizzles that are assigned to: "M._11_21 = v;" becomes a block that assigns one by one. In whole texts.</summary>
        /// <exception cref="LegacySyntaxException">It is a part of a larger expression.</exception>
        public static bool ExpandAssignments(List<Token> tokens)
        {
            bool any = false;
            for (int i = 2; i < tokens.Count; i++)
            {
                if (tokens[i].Kind != TokenKind.Identifier || tokens[i].Text.Length < 6 || !tokens[i - 1].Is(".") || !Several.IsMatch(tokens[i].Text))
                    continue;
                int assign = i + 1;
                while (assign < tokens.Count && tokens[assign].Kind == TokenKind.Space)
                    assign++;
                if (assign == tokens.Count || tokens[assign].Kind != TokenKind.Symbol || Array.IndexOf(Assignments, tokens[assign].Text) < 0)
                    continue;
                int begin = Begin(tokens, i - 2), before = begin - 1, end = assign;
                while (before >= 0 && tokens[before].Kind == TokenKind.Space)
                    before--;
                for (int depth = 0; end < tokens.Count && (depth > 0 || !tokens[end].Is(";")); end++)
                    depth += tokens[end].Is("(") || tokens[end].Is("{") ? 1 : tokens[end].Is(")") || tokens[end].Is("}") ? -1 : 0;
                if (end == tokens.Count || before >= 0 && !tokens[before].Is(";") && !tokens[before].Is("{") && !tokens[before].Is("}")
                    && !tokens[before].Is(")") && tokens[before].Text != "else")
                    throw new LegacySyntaxException(tokens, i,
                        $"'{tokens[i].Text}' is assigned to inside of an expression; make that a statement of its own");

                string matrix = Preprocessor.Print(tokens.GetRange(begin, i - 1 - begin)), operation = tokens[assign].Text;
                string[] elements = Element.Matches(tokens[i].Text).Select(m => m.Value).ToArray();
                var block = Token.Split($"{{ float{elements.Length} rill_v = ");
                block.AddRange(tokens.GetRange(assign + 1, end - assign - 1));
                block.AddRange(Token.Split("; "
                    + string.Join(" ", elements.Select((e, k) => $"{matrix}.{e} {operation} rill_v.{"xyzw"[k]};")) + " }"));
                tokens.RemoveRange(begin, end + 1 - begin);
                tokens.InsertRange(begin, block);
                any = true;
            }
            return any;
        }

        // Returns where the expression that ends at that token begins: names, members, indices and calls.
        static int Begin(List<Token> tokens, int last)
        {
            int at = last;
            while (true)
            {
                while (tokens[at].Is(")") || tokens[at].Is("]"))
                {
                    bool call = tokens[at].Is(")");
                    for (int depth = 0; at >= 0; at--)
                    {
                        depth += tokens[at].Is(")") || tokens[at].Is("]") ? 1 : tokens[at].Is("(") || tokens[at].Is("[") ? -1 : 0;
                        if (depth == 0)
                            break;
                    }
                    if (at <= 0 || call && tokens[at - 1].Kind != TokenKind.Identifier)
                        return at < 0 ? 0 : at;
                    at--;
                }
                if (at < 2 || !tokens[at - 1].Is("."))
                    return at;
                at -= 2;
            }
        }
    }
}
