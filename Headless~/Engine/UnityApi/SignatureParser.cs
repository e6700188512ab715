using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.UnityApi
{
    /// <summary>Reads the lists' signatures. What it does not know is an error, never a guess.</summary>
    sealed class SignatureParser
    {
        static readonly HashSet<string> Modifiers = new() { "static", "protected", "abstract", "virtual", "override", "sealed", "readonly",
            "const", "event", "ref", "new", "unsafe", "extern", "volatile" };

        static readonly Dictionary<string, (string Unary, string Binary)> Operators = new()
        {
            ["+"] = ("op_UnaryPlus", "op_Addition"), ["-"] = ("op_UnaryNegation", "op_Subtraction"), ["*"] = (null, "op_Multiply"),
                ["/"] = (null, "op_Division"),
            ["%"] = (null, "op_Modulus"), ["&"] = (null, "op_BitwiseAnd"), ["|"] = (null, "op_BitwiseOr"), ["^"] = (null, "op_ExclusiveOr"),
            ["<<"] = (null, "op_LeftShift"), [">>"] = (null, "op_RightShift"), ["=="] = (null, "op_Equality"), ["!="] = (null, "op_Inequality"),
            ["<"] = (null, "op_LessThan"), [">"] = (null, "op_GreaterThan"), ["<="] = (null, "op_LessThanOrEqual"),
                [">="] = (null, "op_GreaterThanOrEqual"),
            ["!"] = ("op_LogicalNot", null), ["~"] = ("op_OnesComplement", null), ["++"] = ("op_Increment", null), ["--"] = ("op_Decrement", null),
            ["true"] = ("op_True", null), ["false"] = ("op_False", null),
        };

        readonly ApiLine line;
        readonly SignatureTokens tokens;
        readonly ApiMember member;

        SignatureParser(ApiLine line)
        {
            this.line = line;
            tokens = new SignatureTokens(line.Signature);
            member = new ApiMember { Line = line };
        }

        /// <exception cref="FormatException">The line is of a form that is not known.</exception>
        public static ApiMember Parse(ApiLine line)
        {
            try
            {
                var parser = new SignatureParser(line);
                parser.Member();
                return parser.member;
            }
            catch (FormatException problem)
            {
                throw new FormatException($"{line}: {problem.Message}", problem);
            }
        }

        /// <summary>A type by itself, e.g. the full name of a line: "UnityEngine.Pool.ObjectPool&lt;T&gt;".</summary>
        public static ApiTypeName ParseType(string text)
        {
            var tokens = new SignatureTokens(text);
            ApiTypeName type = TypeReader.Read(tokens);
            tokens.End();
            return type;
        }

        void Member()
        {
            if (tokens.Take("protected"))
                member.Protected = true;
            switch (tokens.Peek)
            {
                case "class": Type(ApiKind.Class); break;
                case "struct": Type(ApiKind.Struct); break;
                case "interface": Type(ApiKind.Interface); break;
                case "enum": Enumeration(); break;
                case "delegate" when tokens.PeekAt(1) != "*": Delegate(); break;
                case "value" when tokens.Count == 2: Value(); break;
                case "operator": Operator(); break;
                case "conversion": Conversion(); break;
                case ".ctor": Constructor(); break;
                default: Ordinary(); break;
            }
            tokens.End();
        }

        void Type(ApiKind kind)
        {
            tokens.Next();
            member.Kind = kind;
            if (tokens.Take(":"))
                member.Bases = TypeReader.List(tokens);
        }

        void Enumeration()
        {
            tokens.Next();
            member.Kind = ApiKind.Enum;
            member.Type = tokens.Take(":") ? TypeReader.Read(tokens) : ApiTypeName.Written(new[] { "int" });
        }

        void Delegate()
        {
            tokens.Next();
            member.Kind = ApiKind.Delegate;
            member.ReturnsReference = tokens.Take("ref");
            member.Type = TypeReader.Read(tokens);
            member.Parameters = Parameters("(", ")");
        }

        void Value()
        {
            tokens.Next();
            member.Kind = ApiKind.Value;
            member.Name = tokens.Identifier();
            member.Static = true;
        }

        void Operator()
        {
            tokens.Next();
            member.Kind = ApiKind.Operator;
            member.Static = true;
            string symbol = tokens.Next();
            while (tokens.Peek != "(" || symbol == "")
                symbol += tokens.Next();
            member.Parameters = Parameters("(", ")");
            tokens.Expect(":");
            member.Type = TypeReader.Read(tokens);
            if (!Operators.TryGetValue(symbol, out (string Unary, string Binary) name)
                || (member.Parameters.Count == 1 ? name.Unary : name.Binary) == null)
                throw new FormatException($"unknown operator '{symbol}'");
            member.Name = member.Parameters.Count == 1 ? name.Unary : name.Binary;
        }

        void Conversion()
        {
            tokens.Next();
            member.Kind = ApiKind.Conversion;
            member.Name = "op_Conversion";
            member.Static = true;
            member.Type = TypeReader.Read(tokens);
            member.Parameters = Parameters("(", ")");
        }

        void Constructor()
        {
            tokens.Next();
            member.Kind = ApiKind.Constructor;
            member.Name = ".ctor";
            member.Parameters = Parameters("(", ")");
        }

        void Ordinary()
        {
            bool isEvent = false;
            while (Modifiers.Contains(tokens.Peek))
                switch (tokens.Next())
                {
                    case "static": member.Static = true; break;
                    case "protected": member.Protected = true; break;
                    case "abstract": member.Abstract = true; break;
                    case "virtual": member.Virtual = true; break;
                    case "override": member.Override = true; break;
                    case "readonly": member.ReadOnly = true; break;
                    case "const": member.Constant = member.Static = true; break;
                    case "event": isEvent = true; break;
                    case "ref": member.ReturnsReference = true; break;
                }
            member.Type = TypeReader.Read(tokens);
            if (tokens.Peek == "this")
            {
                tokens.Next();
                member.Kind = ApiKind.Indexer;
                member.Name = "this";
                member.Parameters = Parameters("[", "]");
                // The lists do not say which accessors an indexer has.
                member.CanRead = member.CanWrite = true;
                Accessors();
                return;
            }
            member.Name = tokens.Identifier();
            if (isEvent)
            {
                member.Kind = ApiKind.Event;
                return;
            }
            if (tokens.Peek == "<")
                member.TypeParameters = TypeParameters();
            if (tokens.Peek == "(")
            {
                member.Kind = ApiKind.Method;
                member.Parameters = Parameters("(", ")");
                return;
            }
            member.Kind = ApiKind.Field;
            if (Accessors())
                member.Kind = ApiKind.Property;
        }

        bool Accessors()
        {
            if (!tokens.Take("{"))
                return false;
            member.CanRead = member.CanWrite = false;
            while (!tokens.Take("}"))
                switch (tokens.Next())
                {
                    case "get": member.CanRead = true; break;
                    case "set" or "init": member.CanWrite = true; break;
                    case var other: throw new FormatException($"unknown accessor '{other}'");
                }
            return true;
        }

        IReadOnlyList<string> TypeParameters()
        {
            var names = new List<string>();
            tokens.Expect("<");
            do
                names.Add(tokens.Identifier());
            while (tokens.Take(","));
            tokens.Expect(">");
            return names;
        }

        IReadOnlyList<ApiParameter> Parameters(string open, string close)
        {
            var parameters = new List<ApiParameter>();
            tokens.Expect(open);
            if (tokens.Take(close))
                return parameters;
            do
                parameters.Add(Parameter(close));
            while (tokens.Take(","));
            tokens.Expect(close);
            return parameters;
        }

        ApiParameter Parameter(string close)
        {
            string standard = null;
            // Unity's own [DefaultValue] only tells its documentation what the overload without the parameter passes.
            while (tokens.Peek == "[")
                tokens.Balanced("[", "]");
            bool isParams = false, isThis = false;
            var pass = ApiPass.ByValue;
            while (tokens.Peek is "params" or "this" or "ref" or "in" or "out" or "readonly" or "scoped")
                switch (tokens.Next())
                {
                    case "params": isParams = true; break;
                    case "this": isThis = true; break;
                    case "ref": pass = ApiPass.Ref; break;
                    case "in": pass = ApiPass.In; break;
                    case "out": pass = ApiPass.Out; break;
                }
            ApiTypeName type = TypeReader.Read(tokens);
            string name = tokens.Identifier();
            if (tokens.Take("="))
                standard = tokens.Until(",", close);
            return new ApiParameter(name, type, pass, isParams, isThis, standard);
        }
    }
}
