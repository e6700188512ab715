using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Host.Scripts.Stubs
{
    /// <summary>A type of Unity's that the host lacks, as C#: the headline, then a member a line, then the types within.</summary>
    internal sealed class StubType
    {
        public readonly string FullName, ShortName;
        public readonly List<StubType> Nested = new List<StubType>();
        public readonly List<StubMember> Members = new List<StubMember>();
        readonly List<string> values = new List<string>();

        /// <summary>"class", "struct", "interface", "enum" or "delegate"; null when the lists do not say.</summary>
        public string Kind;
        public List<string> Bases = new List<string>();
        public bool Dropped, ForcedAbstract, IsProtected;
        string delegateSignature;
        readonly string typeParameters;

        public StubType(string fullName)
        {
            FullName = fullName;
            var open = fullName.IndexOf('<');
            typeParameters = open < 0 ? "" : LastPart(fullName) is var part && part.Contains('<') ? part.Substring(part.IndexOf('<')) : "";
            ShortName = LastPart(fullName).Split('<')[0];
        }

        /// <summary>Set when the base class is a stub too: those have a constructor of their own for it.</summary>
        public bool BaseIsStub;
        /// <summary>Objects of it must come to be without throwing: the engine makes components, the runtime attributes.</summary>
        public bool MakesOf;
        public bool HoldsData => Kind == "struct" || MakesOf && ShortName.EndsWith("Attribute", StringComparison.Ordinal);

        /// <summary>After the last dot that is not within type parameters.</summary>
        public static string LastPart(string fullName) => fullName.Substring(OuterLength(fullName) + 1);
        /// <summary>Index of the last dot outside of type parameters; -1 without one.</summary>
        public static int OuterLength(string fullName)
        {
            var depth = 0;
            for (var i = fullName.Length - 1; i >= 0; i--)
                if (fullName[i] == '>') depth++;
                else if (fullName[i] == '<') depth--;
                else if (fullName[i] == '.' && depth == 0) return i;
            return -1;
        }

        static readonly Regex Head = new Regex(
            @"^(?<protected>protected )?(?<kind>class|struct|interface|enum|delegate)\b\s*(: )?(?<rest>.*)$", RegexOptions.Compiled);

        public void Add(string signature)
        {
            var head = Head.Match(signature);
            if (head.Success)
            {
                // Partial classes have a line for each part, of which one may name no base.
                Kind ??= head.Groups["kind"].Value;
                IsProtected = head.Groups["protected"].Success;
                if (Kind == "delegate") delegateSignature = head.Groups["rest"].Value;
                else Bases = Bases.Concat(Split(head.Groups["rest"].Value)).Distinct().ToList();
            }
            else if (signature.StartsWith("value ", StringComparison.Ordinal)) values.Add(signature.Substring(6));
            else if (new StubMember(this, signature) is var member && !member.IsInherited) Members.Add(member);
        }

        static List<string> Split(string bases)
        {
            var parts = new List<string>();
            int depth = 0, start = 0;
            for (var i = 0; i <= bases.Length; i++)
            {
                if (i < bases.Length && bases[i] == '<') depth++;
                if (i < bases.Length && bases[i] == '>') depth--;
                if (i < bases.Length && (bases[i] != ',' || depth > 0)) continue;
                var part = bases.Substring(start, i - start).Trim();
                if (part.Length > 0) parts.Add(part);
                start = i + 1;
            }
            return parts;
        }

        public readonly List<string> BasesLeftOut = new List<string>();

        public void Without(string parent)
        {
            if (Bases.Count > 0 && Bases[0] == parent) BaseIsStub = false;
            if (Bases.Remove(parent)) BasesLeftOut.Add(parent);
        }

        public IEnumerable<StubType> WithNested() => Nested.SelectMany(n => n.WithNested()).Prepend(this);

        /// <param name="lines">Gets for each written line what it holds: a StubMember, or the StubType of a headline.</param>
        public void Write(StringBuilder text, List<object> lines, Manner manner, bool nested)
        {
            if (Dropped || Kind == null) return;
            void Line(string line, object holds)
            {
                text.Append(line).Append('\n');
                lines.Add(holds);
            }

            var access = nested && IsProtected ? "protected" : "public";
            if (Kind == "delegate")
            {
                var open = delegateSignature.IndexOf('(');
                Line(open < 0 ? "" : $"{access} unsafe delegate {delegateSignature.Substring(0, open).Trim()} " +
                    $"{ShortName}{typeParameters}{delegateSignature.Substring(open)};", this);
                return;
            }
            if (Kind == "enum")
            {
                // The lists hold names without numbers.
                Line($"{access} enum {ShortName}{(Bases.Count > 0 ? " : " + Bases[0] : "")} {{ {string.Join(", ", values)} }}", this);
                return;
            }
            var members = Members.Where(m => !m.Dropped).ToList();
            var isStatic = Kind == "class" && members.Any(m => m.IsExtension);
            var isAbstract = Kind == "class" && !isStatic && (ForcedAbstract || members.Any(m => m.IsAbstract));
            if (MakesOf && ShortName.EndsWith("Attribute", StringComparison.Ordinal))
                Line("[global::System.AttributeUsage(global::System.AttributeTargets.All, AllowMultiple = true)]", this);
            // Nothing must keep a user's class from holding one of these in a serialized field.
            if (Kind == "struct") Line("[global::System.Serializable]", this);
            Line($"{access} {(isStatic ? "static " : isAbstract ? "abstract " : "")}unsafe {(Kind == "class" ? "partial " : "")}{Kind} " +
                $"{ShortName}{typeParameters}{(Bases.Count > 0 && !isStatic ? " : " + string.Join(", ", Bases) : "")} {{", this);
            if (Kind == "class" && !isStatic)
            {
                Line($"internal {ShortName}(global::UnityEngine.Headless.StubCalls stub){(BaseIsStub ? " : base(stub)" : "")} {{ }}", this);
                if (!members.Any(m => m.IsConstructor)) Line($"{(isAbstract ? "protected" : "public")} " +
                    $"{ShortName}(){(BaseIsStub ? " : base((global::UnityEngine.Headless.StubCalls)null)" : "")} {{ }}", this);
            }
            foreach (var member in members)
                if (!isStatic || member.IsStatic) Line(member.Text(manner), member);
            foreach (var type in Nested) type.Write(text, lines, manner, true);
            Line("}", this);
        }
    }
}
