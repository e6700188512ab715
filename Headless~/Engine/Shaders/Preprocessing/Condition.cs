using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>The value of an #if expression: integers, names left over after macro expansion are 0.</summary>
    sealed class Condition
    {
        static readonly string[][] Levels =
        {
            new[] { "||" }, new[] { "&&" }, new[] { "|" }, new[] { "^" }, new[] { "&" }, new[] { "==", "!=" },
            new[] { "<", ">", "<=", ">=" }, new[] { "<<", ">>" }, new[] { "+", "-" }, new[] { "*", "/", "%" },
        };

        readonly List<Token> tokens;
        int at;

        Condition(List<Token> tokens) { this.tokens = tokens; }

        public static bool IsTrue(string text, Macros macros)
        {
            List<Token> resolved = ResolveDefined(Token.Split(text).Where(t => t.Kind != TokenKind.Space).ToList(), macros);
            // A macro may expand to defined(X), which FXC takes too.
            List<Token> expanded = ResolveDefined(macros.Expand(resolved).Where(t => t.Kind != TokenKind.Space).ToList(), macros);
            var condition = new Condition(expanded);
            if (expanded.Count == 0)
                throw new PreprocessorException("#if needs an expression");
            long value = condition.Choice();
            if (condition.at < expanded.Count)
                throw new PreprocessorException($"unexpected '{expanded[condition.at].Text}' in a preprocessor expression");
            return value != 0;
        }

        static List<Token> ResolveDefined(List<Token> tokens, Macros macros)
        {
            var result = new List<Token>();
            for (int i = 0; i < tokens.Count; i++)
            {
                if (tokens[i].Kind != TokenKind.Identifier || tokens[i].Text != "defined")
                {
                    result.Add(tokens[i]);
                    continue;
                }
                bool parenthesis = i + 1 < tokens.Count && tokens[i + 1].Is("(");
                int name = i + (parenthesis ? 2 : 1);
                if (name >= tokens.Count || tokens[name].Kind != TokenKind.Identifier || parenthesis
                    && (name + 1 >= tokens.Count || !tokens[name + 1].Is(")")))
                    throw new PreprocessorException("'defined' needs a name");
                result.Add(new Token(TokenKind.Number, macros.Contains(tokens[name].Text) ? "1" : "0"));
                i = parenthesis ? name + 1 : name;
            }
            return result;
        }

        bool Take(string symbol)
        {
            if (at >= tokens.Count || !tokens[at].Is(symbol))
                return false;
            at++;
            return true;
        }

        long Choice()
        {
            long value = Binary(0);
            if (!Take("?"))
                return value;
            long yes = Choice();
            if (!Take(":"))
                throw new PreprocessorException("'?' without ':' in a preprocessor expression");
            long no = Choice();
            return value != 0 ? yes : no;
        }

        long Binary(int level)
        {
            if (level == Levels.Length)
                return Unary();
            long value = Binary(level + 1);
            while (at < tokens.Count && tokens[at].Kind == TokenKind.Symbol && Array.IndexOf(Levels[level], tokens[at].Text) >= 0)
            {
                string op = tokens[at++].Text;
                value = Apply(op, value, Binary(level + 1));
            }
            return value;
        }

        static long Apply(string op, long a, long b)
        {
            switch (op)
            {
                case "||": return a != 0 || b != 0 ? 1 : 0;
                case "&&": return a != 0 && b != 0 ? 1 : 0;
                case "|": return a | b;
                case "^": return a ^ b;
                case "&": return a & b;
                case "==": return a == b ? 1 : 0;
                case "!=": return a != b ? 1 : 0;
                case "<": return a < b ? 1 : 0;
                case ">": return a > b ? 1 : 0;
                case "<=": return a <= b ? 1 : 0;
                case ">=": return a >= b ? 1 : 0;
                case "<<": return a << (int)b;
                case ">>": return a >> (int)b;
                case "+": return a + b;
                case "-": return a - b;
                case "*": return a * b;
                default:
                    // The right side of && and || is evaluated too, where a guard may stand on the left: no error then.
                    return b == 0 ? 0 : op == "/" ? a / b : a % b;
            }
        }

        long Unary()
        {
            if (Take("!")) return Unary() == 0 ? 1 : 0;
            if (Take("-")) return -Unary();
            if (Take("+")) return Unary();
            if (Take("~")) return ~Unary();
            if (Take("("))
            {
                long value = Choice();
                if (!Take(")"))
                    throw new PreprocessorException("')' is missing in a preprocessor expression");
                return value;
            }
            if (at >= tokens.Count)
                throw new PreprocessorException("a preprocessor expression ends too early");
            Token token = tokens[at++];
            if (token.Kind == TokenKind.Number)
                return Number(token.Text);
            if (token.Kind != TokenKind.Identifier)
                throw new PreprocessorException($"unexpected '{token.Text}' in a preprocessor expression");
            if (Take("("))
                throw new PreprocessorException($"'{token.Text}' is not a macro that takes arguments");
            return token.Text == "true" ? 1 : 0;
        }

        static long Number(string text)
        {
            string digits = text.TrimEnd('u', 'U', 'l', 'L');
            bool hex = digits.StartsWith("0x", StringComparison.OrdinalIgnoreCase);
            if (hex && long.TryParse(digits.Substring(2), NumberStyles.HexNumber, CultureInfo.InvariantCulture, out long value))
                return value;
            if (!hex && digits.Length > 1 && digits[0] == '0' && digits.All(char.IsDigit))
                return Convert.ToInt64(digits, 8);
            if (long.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out value))
                return value;
            throw new PreprocessorException($"'{text}' is not an integer");
        }
    }
}
