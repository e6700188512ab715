using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>
    /// Syntax of Direct3D 9 that FXC accepts and glslang (12.0) does not, or not fully: samplers that carry their texture, and
    /// assignments to several elements of a matrix. Works on preprocessed text and keeps its lines.
    /// </summary>
    static class LegacySyntax
    {
        const string Helpers =
            "float2 rill_uv2(float2 u) { return u; } float2 rill_uv2(float3 u) { return u.xy; } float2 rill_uv2(float4 u) { return u.xy; } " +
            "float3 rill_uv3(float3 u) { return u; } float3 rill_uv3(float4 u) { return u.xyz; } " +
            "float2 rill_proj2(float3 u) { return u.xy / u.z; } float2 rill_proj2(float4 u) { return u.xy / u.w; } ";

        /// <exception cref="LegacySyntaxException"/>
        public static string Rewrite(string text)
        {
            List<Token> tokens = Token.Split(text);
            bool changed = MatrixSwizzle.ExpandAssignments(tokens);
            if (tokens.Any(t => t.Kind == TokenKind.Identifier && CombinedSamplers.IsType(t.Text)))
            {
                tokens = new CombinedSamplers(tokens).Rewrite();
                tokens.Insert(0, new Token(TokenKind.Text, Helpers));
                changed = true;
            }
            return changed ? Preprocessor.Print(tokens) : text;
        }
    }

    /// <summary>A fault at a line of preprocessed text, counted from 0; the compiler adds the file.</summary>
    sealed class LegacySyntaxException : System.Exception
    {
        public readonly int Line;
        public LegacySyntaxException(List<Token> tokens, int at, string message) : base(message)
            => Line = tokens.Take(at).Sum(t => t.Text.Count(c => c == '\n'));
    }
}
