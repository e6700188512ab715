using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>
    /// Facts that only the source tells: glslang's module has the same type for a ByteAddressBuffer and a StructuredBuffer of uint,
    /// for an append buffer and one that counts.
    /// </summary>
    sealed class SourceDeclarations
    {
        static readonly HashSet<string> BufferTypes = new HashSet<string>
        {
            "ByteAddressBuffer", "RWByteAddressBuffer", "StructuredBuffer", "RWStructuredBuffer", "AppendStructuredBuffer", "ConsumeStructuredBuffer",
        };

        readonly Dictionary<string, string> typeOf = new Dictionary<string, string>();
        readonly HashSet<string> words = new HashSet<string>();
        readonly HashSet<string> functions = new HashSet<string>();
        readonly HashSet<string> kernels = new HashSet<string>();
        readonly HashSet<string> strideQueries = new HashSet<string>();
        readonly Dictionary<string, int> packOffsets = new Dictionary<string, int>();

        public SourceDeclarations(string preprocessed)
        {
            List<Token> tokens = Token.Split(preprocessed).Where(t => t.Kind != TokenKind.Space).ToList();
            bool numThreads = false;    // [numthreads] stands before the next function
            int depth = 0;      // only globals count: a parameter may have a global's name
            for (int i = 0; i < tokens.Count; i++)
            {
                Token token = tokens[i];
                if (token.Kind == TokenKind.Identifier)
                    words.Add(token.Text);
                if (token.Text == "numthreads")
                    numThreads = true;
                if (depth == 0 && token.Kind == TokenKind.Identifier && i > 0
                    && (tokens[i - 1].Kind == TokenKind.Identifier || tokens[i - 1].Is(">")) && i + 1 < tokens.Count
                    && tokens[i + 1].Is("("))
                {
                    functions.Add(token.Text);
                    if (numThreads)
                        kernels.Add(token.Text);
                    numThreads = false;
                }
                if (token.Text == "packoffset")
                    Locate(tokens, i);
                if (token.Text == "GetDimensions" && i > 1 && tokens[i - 1].Is("."))
                    strideQueries.Add(tokens[i - 2].Text);
                depth += token.Is("{") || token.Is("(") ? 1 : token.Is("}") || token.Is(")") ? -1 : 0;
                if (depth == 0 && token.Kind == TokenKind.Identifier && BufferTypes.Contains(token.Text))
                    Declare(tokens, i);
            }
        }

        /// <summary>StructuredBuffer and kin as declared at global scope; null for other names.</summary>
        public string TypeOf(string name) => typeOf.TryGetValue(name, out string type) ? type : null;
        public bool IsRaw(string name) => TypeOf(name) is "ByteAddressBuffer" or "RWByteAddressBuffer";
        public bool HasFunction(string name) => functions.Contains(name);
        public bool HasNumThreads(string name) => kernels.Contains(name);
        public bool AsksDimensions(string name) => strideQueries.Contains(name);
        /// <summary>Byte at which packoffset puts a constant; null for others.</summary>
        public int? PackOffset(string name) => packOffsets.TryGetValue(name, out int bytes) ? bytes : (int?)null;
        public bool Mentions(string word) => words.Contains(word);

        // "name[2] : packoffset(c3.y)" at the word.
        void Locate(List<Token> tokens, int at)
        {
            const int register = 16, word = 4;
            int name = at - 2;
            while (name > 0 && tokens[name].Kind != TokenKind.Identifier || name > 0 && tokens[name - 1].Is("["))
                name--;
            if (name < 0 || at + 2 >= tokens.Count || !int.TryParse(tokens[at + 2].Text.TrimStart('c'), out int number))
                return;     // the compiler says what is wrong
            bool hasComponent = at + 4 < tokens.Count && tokens[at + 3].Is(".");
            int component = hasComponent ? Math.Max("xyzw".IndexOf(tokens[at + 4].Text, StringComparison.Ordinal),
                "rgba".IndexOf(tokens[at + 4].Text, StringComparison.Ordinal)) : 0;
            packOffsets[tokens[name].Text] = number * register + component * word;
        }

        // "Type<Element> a, b;" from the type on.
        void Declare(List<Token> tokens, int at)
        {
            string type = tokens[at].Text;
            int angle = 0;
            bool named = false;
            for (int i = at + 1; i < tokens.Count && !tokens[i].Is(";") && !tokens[i].Is("("); i++)
            {
                angle += tokens[i].Is("<") ? 1 : tokens[i].Is(">") ? -1 : tokens[i].Is(">>") ? -2 : 0;
                if (angle == 0 && tokens[i].Is(","))
                    named = false;
                else if (angle == 0 && !named && tokens[i].Kind == TokenKind.Identifier)
                {
                    typeOf[tokens[i].Text] = type;
                    named = true;
                }
            }
        }
    }
}
