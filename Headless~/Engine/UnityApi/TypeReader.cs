using System;
using System.Collections.Generic;

namespace Host.UnityApi
{
    /// <summary>Reads a type out of a signature.</summary>
    static class TypeReader
    {
        public static ApiTypeName Read(SignatureTokens tokens)
        {
            while (tokens.Peek == "[")
                tokens.Balanced("[", "]");
            ApiTypeName type = tokens.Peek == "(" ? Tuple(tokens) : Named(tokens);
            while (true)
            {
                if (tokens.Take("?"))
                    type = ApiTypeName.NullableOf(type);
                else if (tokens.Take("*"))
                    type = ApiTypeName.PointerTo(type);
                else if (tokens.Peek == "[")
                    type = Array(tokens, type);
                else
                    return type;
            }
        }

        public static IReadOnlyList<ApiTypeName> List(SignatureTokens tokens)
        {
            var types = new List<ApiTypeName>();
            do
                types.Add(Read(tokens));
            while (tokens.Take(","));
            return types;
        }

        static ApiTypeName Named(SignatureTokens tokens)
        {
            var path = new List<string>();
            var arguments = new List<ApiTypeName>();
            if (tokens.Peek == "global" && tokens.PeekAt(1) == "::")
            {
                tokens.Next();
                tokens.Next();
            }
            do
            {
                string name = tokens.Identifier();
                int own = 0;
                if (tokens.Take("<"))
                {
                    do
                    {
                        _ = tokens.Take("in") || tokens.Take("out");        // variance, in the name of a declared type
                        arguments.Add(Read(tokens));
                        own++;
                    }
                    while (tokens.Take(","));
                    tokens.Expect(">");
                }
                path.Add(own == 0 ? name : $"{name}`{own}");
            }
            while (tokens.Take("."));
            return ApiTypeName.Written(path, arguments);
        }

        static ApiTypeName Tuple(SignatureTokens tokens)
        {
            var elements = new List<ApiTypeName>();
            tokens.Expect("(");
            do
            {
                elements.Add(Read(tokens));
                if (tokens.Peek is not ("," or ")"))
                    tokens.Identifier();
            }
            while (tokens.Take(","));
            tokens.Expect(")");
            return ApiTypeName.TupleOf(elements);
        }

        // T[,][] is a two-dimensional array of arrays: C# reads the brackets from left to right.
        static ApiTypeName Array(SignatureTokens tokens, ApiTypeName element)
        {
            int rank = 1;
            tokens.Expect("[");
            while (tokens.Take(","))
                rank++;
            tokens.Expect("]");
            if (tokens.Peek == "[")
                element = Array(tokens, element);
            return ApiTypeName.ArrayOf(element, rank);
        }
    }
}
