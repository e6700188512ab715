using System;
using System.Collections.Generic;

namespace Host.Shaders
{
    sealed class Macro
    {
        public string Name;
        /// <summary>Null for a macro that takes no parentheses.</summary>
        public List<string> Parameters;
        public List<Token> Body;
    }

    /// <summary>
    /// Macro definitions and their expansion, by the C standard's algorithm (each token carries the macros it must not
    /// start again), with ## and #.
    /// </summary>
    sealed class Macros
    {
        readonly Dictionary<string, Macro> byName = new Dictionary<string, Macro>();

        public bool Contains(string name) => byName.ContainsKey(name);
        public void Remove(string name) => byName.Remove(name);
        public Macro Find(string name) => byName.TryGetValue(name, out Macro macro) ? macro : null;
        public void Add(Macro macro) => byName[macro.Name] = macro;
        public void Add(string name, string value) => Add(new Macro { Name = name, Body = Token.Split(value) });

        /// <summary>Whether the tokens end inside the parentheses of a macro call, so that the next line belongs to it.</summary>
        public bool EndsInsideCall(List<Token> tokens)
        {
            int depth = 0;
            for (int i = 0; i < tokens.Count; i++)
            {
                if (depth > 0)
                    depth += tokens[i].Is("(") ? 1 : tokens[i].Is(")") ? -1 : 0;
                else if (tokens[i].Kind == TokenKind.Identifier && Find(tokens[i].Text)?.Parameters != null)
                {
                    int open = SkipSpace(tokens, i + 1);
                    if (open < tokens.Count && tokens[open].Is("("))
                    {
                        depth = 1;
                        i = open;
                    }
                }
            }
            return depth > 0;
        }

        public List<Token> Expand(IEnumerable<Token> source)
        {
            var output = new List<Token>();
            var input = new List<Token>(source);
            input.Reverse();    // a stack: the next token is the last
            while (input.Count > 0)
            {
                Token token = Pop(input);
                Macro macro = token.Kind == TokenKind.Identifier ? Find(token.Text) : null;
                if (macro == null || HiddenMacros.Contains(token.Hidden, token.Text))
                {
                    output.Add(token);
                    continue;
                }

                HiddenMacros hidden;
                List<List<Token>> arguments = null;
                if (macro.Parameters == null)
                    hidden = HiddenMacros.Add(token.Hidden, macro.Name);
                else
                {
                    arguments = ReadArguments(input, macro, out Token close);
                    if (arguments == null)
                    {
                        output.Add(token);
                        continue;
                    }
                    hidden = HiddenMacros.Add(HiddenMacros.Intersect(token.Hidden, close.Hidden), macro.Name);
                }

                List<Token> body = Substitute(macro, arguments);
                for (int i = body.Count - 1; i >= 0; i--)
                    input.Add(body[i].Hide(hidden));
            }
            return output;
        }

        static Token Pop(List<Token> stack)
        {
            Token token = stack[stack.Count - 1];
            stack.RemoveAt(stack.Count - 1);
            return token;
        }

        static int SkipSpace(List<Token> tokens, int i)
        {
            while (i < tokens.Count && tokens[i].Kind == TokenKind.Space)
                i++;
            return i;
        }

        // Null, and nothing taken, when no parenthesis follows: then the name is an ordinary identifier.
        static List<List<Token>> ReadArguments(List<Token> input, Macro macro, out Token close)
        {
            close = null;
            int open = input.Count - 1;
            while (open >= 0 && input[open].Kind == TokenKind.Space)
                open--;
            if (open < 0 || !input[open].Is("("))
                return null;
            input.RemoveRange(open, input.Count - open);

            var arguments = new List<List<Token>> { new List<Token>() };
            for (int depth = 0; ;)
            {
                if (input.Count == 0)
                    throw new PreprocessorException($"the arguments of macro '{macro.Name}' have no closing parenthesis");
                Token token = Pop(input);
                if (depth == 0 && token.Is(")"))
                {
                    close = token;
                    break;
                }
                if (depth == 0 && token.Is(","))
                {
                    arguments.Add(new List<Token>());
                    continue;
                }
                depth += token.Is("(") ? 1 : token.Is(")") ? -1 : 0;
                arguments[arguments.Count - 1].Add(token);
            }

            foreach (List<Token> argument in arguments)
                Trim(argument);
            if (macro.Parameters.Count == 0 && arguments.Count == 1 && arguments[0].Count == 0)
                arguments.Clear();
            if (arguments.Count != macro.Parameters.Count)
                throw new PreprocessorException($"macro '{macro.Name}' takes {macro.Parameters.Count} arguments, got {arguments.Count}");
            return arguments;
        }

        static void Trim(List<Token> tokens)
        {
            while (tokens.Count > 0 && tokens[tokens.Count - 1].Kind == TokenKind.Space)
                tokens.RemoveAt(tokens.Count - 1);
            while (tokens.Count > 0 && tokens[0].Kind == TokenKind.Space)
                tokens.RemoveAt(0);
        }

        List<Token> Substitute(Macro macro, List<List<Token>> arguments)
        {
            var result = new List<Token>();
            List<Token> body = macro.Body;
            for (int i = 0; i < body.Count; i++)
            {
                Token token = body[i];
                int parameter = IndexOf(macro, token);
                int after = SkipSpace(body, i + 1);
                if (token.Is("#") && macro.Parameters != null && after < body.Count && IndexOf(macro, body[after]) is int quoted && quoted >= 0)
                {
                    result.Add(new Token(TokenKind.Text, "\"" + Preprocessor.Print(arguments[quoted]) + "\""));
                    i = after;
                }
                else if (token.Is("##") && result.Count > 0 && after < body.Count)
                {
                    Trim(result);
                    int next = IndexOf(macro, body[after]);
                    List<Token> right = next >= 0 ? arguments[next] : new List<Token> { body[after] };
                    Paste(result, right);
                    i = after;
                }
                else if (parameter >= 0)
                {
                    bool pasted = after < body.Count && body[after].Is("##");
                    // An empty operand of ## still has to stand for itself, so that the paste does not take the token before it.
                    if (pasted && arguments[parameter].Count == 0)
                        result.Add(new Token(TokenKind.Symbol, ""));
                    else
                        result.AddRange(pasted ? arguments[parameter] : Expand(arguments[parameter]));
                }
                else
                    result.Add(token);
            }
            return result;
        }

        static int IndexOf(Macro macro, Token token) => macro.Parameters != null && token.Kind == TokenKind.Identifier
            ? macro.Parameters.IndexOf(token.Text) : -1;

        static void Paste(List<Token> left, List<Token> right)
        {
            if (right.Count == 0)
                return;
            Token last = left.Count > 0 ? left[left.Count - 1] : new Token(TokenKind.Symbol, "");
            if (left.Count > 0)
                left.RemoveAt(left.Count - 1);
            List<Token> pasted = Token.Split(last.Text + right[0].Text);
            foreach (Token token in pasted)
                left.Add(token.Hide(HiddenMacros.Intersect(last.Hidden, right[0].Hidden)));
            for (int i = 1; i < right.Count; i++)
                left.Add(right[i]);
        }
    }

    /// <summary>A fault found while preprocessing; the preprocessor adds file and line.</summary>
    sealed class PreprocessorException : Exception { public PreprocessorException(string message) : base(message) { } }
}
