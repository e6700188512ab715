using System;
using System.Collections.Generic;
using System.Text;
using System.Text.RegularExpressions;

namespace Host.Manual
{
    /// <summary>Code as HTML, with classes for comments (c), strings (s), numbers (n), keywords (k) and directives (d).</summary>
    static class CodeColors
    {
        static readonly Regex Token = new(@"(?<c>//[^\n]*|/\*.*?\*/)|(?<s>[@$]*""(?:\\.|[^""\\\n])*"")|" +
            @"(?<n>\b\d[\w.]*)|(?<d>^[ \t]*#\w+)|(?<word>[A-Za-z_]\w*)",
            RegexOptions.Singleline | RegexOptions.Multiline);

        static readonly HashSet<string> CSharp = Words("abstract as async await base bool break byte case catch char class const continue decimal " +
            "default delegate do double else enum event explicit extern false finally fixed float for foreach get goto if implicit in int " +
            "interface internal is lock long namespace new null object operator out override params private protected public " +
            "readonly ref return sbyte sealed set short sizeof static string struct switch this throw true try " +
            "typeof uint ulong unsafe using var virtual void while yield");

        static readonly HashSet<string> Hlsl = Words("Buffer ByteAddressBuffer RWByteAddressBuffer RWStructuredBuffer RWTexture2D RWTexture3D " +
            "SamplerState StructuredBuffer Texture2D Texture3D bool break case cbuffer const continue default discard do else false float float2 " +
            "float3 float4 float4x4 for groupshared half half2 half3 half4 if in inout int int2 int3 int4 numthreads out return " +
            "static struct switch true uint uint2 uint3 uint4 void while");

        static HashSet<string> Words(string words) => new(words.Split(' '), StringComparer.Ordinal);

        /// <param name="language">As a block of Markdown names it; code of other ones has no colors.</param>
        /// <param name="link">Address for a word, or null.</param>
        public static string Html(string code, string language, Func<string, string> link)
        {
            HashSet<string> keywords = language switch { "csharp" or "cs" => CSharp, "hlsl" => Hlsl, "json" => new HashSet<string>(), _ => null };
            if (keywords == null)
                return Manual.Html.Escape(code);
            var html = new StringBuilder();
            int at = 0;
            foreach (Match token in Token.Matches(code))
            {
                html.Append(Manual.Html.Escape(code.Substring(at, token.Index - at)));
                html.Append(Colored(token, keywords, link));
                at = token.Index + token.Length;
            }
            return html.Append(Manual.Html.Escape(code.Substring(at))).ToString();
        }

        static string Colored(Match token, HashSet<string> keywords, Func<string, string> link)
        {
            string text = Manual.Html.Escape(token.Value);
            if (token.Groups["word"].Success)
                return keywords.Contains(token.Value) ? Span("k", text)
                    : keywords == CSharp && link(token.Value) is string address ? $"<a href=\"{address}\">{text}</a>" : text;
            foreach (string kind in new[] { "c", "s", "n", "d" })
                if (token.Groups[kind].Success)
                    return Span(kind, text);
            return text;
        }

        public static string Span(string kind, string text) => $"<span class=\"{kind}\">{text}</span>";
    }
}
