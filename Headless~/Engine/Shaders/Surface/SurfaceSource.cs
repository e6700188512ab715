using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>A member of a struct or a parameter of a function; the type with its qualifiers apart.</summary>
    sealed class SourceField
    {
        public string Type, Name, Semantic = "";
    }

    /// <summary>Structs and functions of a preprocessed source, as far as code is to be written around them.</summary>
    sealed class SurfaceSource
    {
        static readonly HashSet<string> Qualifiers = new HashSet<string> { "in", "out", "inout", "const", "uniform", "nointerpolation",
            "linear", "centroid", "noperspective", "sample", "precise" };

        readonly List<Token> tokens;

        public SurfaceSource(string preprocessed) => tokens = Token.Split(preprocessed).Where(t => t.Kind != TokenKind.Space).ToList();

        public bool Mentions(string word) => tokens.Any(t => t.Text == word);

        /// <summary>Returns a struct; null if it does not exist.</summary>
        public List<SourceField> Struct(string name)
        {
            for (int i = 0; i + 2 < tokens.Count; i++)
                if (tokens[i].Text == "struct" && tokens[i + 1].Text == name && tokens[i + 2].Is("{"))
                    return Fields(i + 3, ";", "}");
            return null;
        }

        /// <summary>The parameters of a function that is defined; null when there is none of that name.</summary>
        public List<SourceField> Function(string name) => Find(name, out int open) ? Fields(open + 1, ",", ")") : null;

        /// <summary>Whether a function's body assigns to a member of that name of something.</summary>
        public bool Writes(string function, string member)
        {
            if (!Find(function, out int open))
                return false;
            int depth = 0;
            for (int i = open; i + 2 < tokens.Count; i++)
            {
                depth += tokens[i].Is("{") ? 1 : tokens[i].Is("}") ? -1 : 0;
                if (depth == 0 && tokens[i].Is("}"))
                    break;
                if (!tokens[i].Is(".") || tokens[i + 1].Text != member)
                    continue;
                int next = i + 2;
                if (next + 1 < tokens.Count && tokens[next].Is("."))
                    next += 2;      // o.Normal.xy
                if (tokens[next].Is("=") || tokens[next].Is("+=") || tokens[next].Is("-=") || tokens[next].Is("*=") || tokens[next].Is("/="))
                    return true;
            }
            return false;
        }

        bool Find(string name, out int open)
        {
            int depth = 0;
            for (int i = 1; i + 1 < tokens.Count; i++)
            {
                depth += tokens[i].Is("{") || tokens[i].Is("(") ? 1 : tokens[i].Is("}") || tokens[i].Is(")") ? -1 : 0;
                if (depth != 0 || tokens[i].Text != name || tokens[i].Kind != TokenKind.Identifier || !tokens[i + 1].Is("(")
                    || tokens[i - 1].Kind != TokenKind.Identifier)
                    continue;
                int close = i + 1;
                for (int inner = 0; close < tokens.Count; close++)
                {
                    inner += tokens[close].Is("(") ? 1 : tokens[close].Is(")") ? -1 : 0;
                    if (inner == 0)
                        break;
                }
                if (close + 1 < tokens.Count && !tokens[close + 1].Is(";"))     // a prototype is none
                {
                    open = i + 1;
                    return true;
                }
            }
            open = -1;
            return false;
        }

        // "type a : SEMANTIC, b;" as fields, up to the end symbol.
        List<SourceField> Fields(int at, string separator, string end)
        {
            var fields = new List<SourceField>();
            while (at < tokens.Count && !tokens[at].Is(end))
            {
                int begin = at, depth = 0;
                while (at < tokens.Count && (depth > 0 || !tokens[at].Is(separator) && !tokens[at].Is(end)))
                {
                    depth += tokens[at].Is("(") || tokens[at].Is("[") ? 1 : tokens[at].Is(")") || tokens[at].Is("]") ? -1 : 0;
                    at++;
                }
                Add(fields, tokens.GetRange(begin, at - begin));
                if (at < tokens.Count && tokens[at].Is(separator))
                    at++;
            }
            return fields;
        }

        static void Add(List<SourceField> fields, List<Token> declaration)
        {
            List<Token> words = declaration.SkipWhile(t => Qualifiers.Contains(t.Text)).ToList();
            if (words.Count < 2)
                return;
            string type = words[0].Text;
            for (int i = 1; i < words.Count; i++)
            {
                var field = new SourceField { Type = type, Name = words[i].Text };
                for (i++; i < words.Count && !words[i].Is(","); i++)
                    if (words[i].Is(":") && i + 1 < words.Count)
                        field.Semantic = words[i + 1].Text;
                fields.Add(field);
            }
        }
    }
}
