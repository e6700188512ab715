using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>
    /// Splits "sampler2D X" into a texture X and a sampler samplerX, which is what FXC makes of it: declarations, parameters,
    /// arguments, and tex2D with its kin.
    /// </summary>
    sealed class CombinedSamplers
    {
        static readonly Dictionary<string, string> TextureTypes = new Dictionary<string, string>
        {
            ["sampler2D"] = "Texture2D", ["sampler3D"] = "Texture3D", ["samplerCUBE"] = "TextureCube", ["sampler1D"] = null,
        };

        // Method, and how the coordinate becomes its arguments; {0} is the coordinate.
        static readonly Dictionary<string, (string method, string coordinate)> Calls = new Dictionary<string, (string, string)>
        {
            ["tex2D"] = ("Sample", "rill_uv2({0})"), ["tex2Dlod"] = ("SampleLevel", "({0}).xy,({0}).w"),
                ["tex2Dbias"] = ("SampleBias", "({0}).xy,({0}).w"),
            ["tex2Dproj"] = ("Sample", "rill_proj2({0})"), ["tex2Dgrad"] = ("SampleGrad", "rill_uv2({0})"),
            ["tex3D"] = ("Sample", "rill_uv3({0})"), ["tex3Dlod"] = ("SampleLevel", "({0}).xyz,({0}).w"),
                ["tex3Dbias"] = ("SampleBias", "({0}).xyz,({0}).w"), ["tex3Dgrad"] = ("SampleGrad", "rill_uv3({0})"),
            ["texCUBE"] = ("Sample", "rill_uv3({0})"), ["texCUBElod"] = ("SampleLevel", "({0}).xyz,({0}).w"),
                ["texCUBEbias"] = ("SampleBias", "({0}).xyz,({0}).w"), ["texCUBEgrad"] = ("SampleGrad", "rill_uv3({0})"),
        };

        readonly List<Token> tokens;
        readonly HashSet<string> globals = new HashSet<string>(), parameters = new HashSet<string>();

        public CombinedSamplers(List<Token> tokens) => this.tokens = tokens;

        public static bool IsType(string word) => TextureTypes.ContainsKey(word);

        /// <exception cref="LegacySyntaxException"/>
        public List<Token> Rewrite()
        {
            var output = new List<Token>();
            int braces = 0, parentheses = 0;
            for (int i = 0; i < tokens.Count; i++)
            {
                Token token = tokens[i];
                braces += token.Is("{") ? 1 : token.Is("}") ? -1 : 0;
                parentheses += token.Is("(") ? 1 : token.Is(")") ? -1 : 0;
                if (token.Is("}") && braces == 0 || token.Is(";") && braces == 0)
                    parameters.Clear();     // the function, or its prototype, is over
                if (token.Kind == TokenKind.Identifier && IsType(token.Text))
                    i = parentheses > 0 ? Parameter(i, output) : Declaration(i, output);
                else
                    i = Expression(i, output);
            }
            return output;
        }

        // Each takes the token there and returns the last one that it used.

        int Declaration(int at, List<Token> output)
        {
            string type = TypeAt(at);
            var names = new List<string>();
            int end = at + 1;
            for (bool expectName = true; end < tokens.Count && !tokens[end].Is(";"); end++)
            {
                if (tokens[end].Is("[") || tokens[end].Is("{") || tokens[end].Is("="))
                    throw new LegacySyntaxException(tokens, end, $"{tokens[at].Text} {string.Join(", ", names)}: arrays and initial " +
                        $"states of samplers are not supported by this host; declare them one by one");
                if (expectName && tokens[end].Kind == TokenKind.Identifier)
                {
                    names.Add(tokens[end].Text);
                    expectName = false;
                }
                else if (tokens[end].Is(","))
                    expectName = true;
                else if (tokens[end].Is("("))
                    end = Close(end);       // register(s0)
            }
            foreach (string name in names)
                globals.Add(name);
            Add(output, $"{type} {string.Join(", ", names)}; SamplerState {string.Join(", ", names.Select(n => "sampler" + n))};");
            Newlines(output, at, end);
            return end;
        }

        int Parameter(int at, List<Token> output)
        {
            int name = Skip(at + 1);
            if (name >= tokens.Count || tokens[name].Kind != TokenKind.Identifier)
                throw new LegacySyntaxException(tokens, at, $"a parameter of type {tokens[at].Text} needs a name");
            parameters.Add(tokens[name].Text);
            Add(output, $"{TypeAt(at)} {tokens[name].Text}, SamplerState sampler{tokens[name].Text}");
            Newlines(output, at, name);
            return name;
        }

        string TypeAt(int at) => TextureTypes[tokens[at].Text]
            ?? throw new LegacySyntaxException(tokens, at, $"{tokens[at].Text} is not supported by this host; use a sampler2D of height 1");

        int Expression(int at, List<Token> output)
        {
            Token token = tokens[at];
            if (token.Kind != TokenKind.Identifier || IsMember(at))
            {
                output.Add(token);
                return at;
            }
            int open = Skip(at + 1);
            if (Calls.TryGetValue(token.Text, out (string method, string coordinate) call) && open < tokens.Count && tokens[open].Is("("))
                return Call(at, open, call.method, call.coordinate, output);
            output.Add(token);
            if (IsSampler(token.Text))
                Add(output, $", sampler{token.Text}");
            return at;
        }

        int Call(int at, int open, string method, string coordinate, List<Token> output)
        {
            int close = Close(open);
            List<(int begin, int end)> arguments = Arguments(open, close);
            int first = arguments.Count > 0 ? Skip(arguments[0].begin) : close;
            string name = tokens[first].Text;
            if (arguments.Count < 2 || first >= arguments[0].end || !IsSampler(name))
                throw new LegacySyntaxException(tokens, at, $"{tokens[at].Text} takes a sampler by its name and a coordinate");
            if (arguments.Count == 4)
                method = "SampleGrad";      // with both derivatives

            string coordinates = Preprocessor.Print(Rewritten(arguments[1])).Replace('\n', ' ');
            Add(output, $"{name}.{method}(sampler{name}, {string.Format(coordinate, coordinates)}");
            foreach ((int begin, int end) more in arguments.Skip(2))
            {
                output.Add(new Token(TokenKind.Symbol, ","));
                output.AddRange(Rewritten(more).Where(t => !t.Text.Contains('\n')));
            }
            output.Add(new Token(TokenKind.Symbol, ")"));
            Newlines(output, at, close);
            return close;
        }

        List<Token> Rewritten((int begin, int end) range)
        {
            var output = new List<Token>();
            for (int i = range.begin; i < range.end; i++)
                i = Expression(i, output);
            return output;
        }

        bool IsSampler(string name) => parameters.Contains(name) || globals.Contains(name);

        bool IsMember(int at)
        {
            int before = at - 1;
            while (before >= 0 && tokens[before].Kind == TokenKind.Space)
                before--;
            return before >= 0 && tokens[before].Is(".");
        }

        int Skip(int at)
        {
            while (at < tokens.Count && tokens[at].Kind == TokenKind.Space)
                at++;
            return at;
        }

        int Close(int open)
        {
            int depth = 0;
            for (int i = open; i < tokens.Count; i++)
            {
                depth += tokens[i].Is("(") ? 1 : tokens[i].Is(")") ? -1 : 0;
                if (depth == 0)
                    return i;
            }
            throw new LegacySyntaxException(tokens, open, "this ( has no )");
        }

        List<(int begin, int end)> Arguments(int open, int close)
        {
            var arguments = new List<(int, int)>();
            int depth = 0, begin = open + 1;
            for (int i = open + 1; i <= close; i++)
            {
                if (i == close || depth == 0 && tokens[i].Is(","))
                {
                    arguments.Add((begin, i));
                    begin = i + 1;
                }
                depth += tokens[i].Is("(") || tokens[i].Is("[") || tokens[i].Is("{") ? 1 : tokens[i].Is(")") || tokens[i].Is("]")
                    || tokens[i].Is("}") ? -1 : 0;
            }
            return arguments;
        }

        static void Add(List<Token> output, string text) => output.AddRange(Token.Split(text));

        // Lines are counted from here on as before.
        void Newlines(List<Token> output, int first, int last)
        {
            int count = tokens.GetRange(first, last - first + 1).Sum(t => t.Text.Count(c => c == '\n'));
            if (count > 0)
                output.Add(new Token(TokenKind.Space, new string('\n', count)));
        }
    }
}
