using System;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Host.Scripts.Stubs
{
    /// <summary>One line of the API list as C# whose body does nothing or throws. Always a single line, so that a compiler's message finds
    /// it.</summary>
    internal sealed class StubMember
    {
        static readonly Regex Property = new Regex(@"^(?<head>.*?)\s*\{(?<access>[^}]*)\}$", RegexOptions.Compiled);
        static readonly Regex Operator = new Regex(@"^operator (?<op>\S+?)\s*\((?<parameters>.*)\) : (?<type>.+)$", RegexOptions.Compiled);
        static readonly Regex Conversion = new Regex(@"^conversion (?<type>[^(]+)\((?<parameters>.*)\)$", RegexOptions.Compiled);
        static readonly Regex Generic = new Regex(@"\w<(?<names>[\w, ]+)>\(", RegexOptions.Compiled);
        static readonly Regex Out = new Regex(@"\bout\s+[^,()]+?\s+(?<name>@?\w+)\s*(?=,|$)", RegexOptions.Compiled);
        static readonly string[] Inherited = { "override string ToString()", "override int GetHashCode()", "override bool Equals(object " };

        readonly StubType owner;
        readonly string signature;
        public string Signature => (IsProtected ? "protected " : "") + signature;
        /// <summary>Left out of the assembly after the compiler refused it.</summary>
        public bool Dropped;
        /// <summary>The lists hold no constraints; value types are what the engine's generic methods mostly ask for.</summary>
        public bool ValueTypesOnly;

        public StubMember(StubType owner, string signature)
        {
            this.owner = owner;
            this.signature = signature.StartsWith("protected ", StringComparison.Ordinal) ? signature.Substring(10) : signature;
            IsProtected = signature.StartsWith("protected ", StringComparison.Ordinal);
        }

        public bool IsProtected { get; }
        public bool IsAbstract => signature.StartsWith("abstract ", StringComparison.Ordinal) && owner.Kind == "class";
        public bool IsStatic => signature.StartsWith("static ", StringComparison.Ordinal) || signature.StartsWith("const ", StringComparison.Ordinal);
        public bool IsExtension => Regex.IsMatch(signature, @"\(\s*(ref |in )?this ");
        public bool IsConstructor => signature.StartsWith(".ctor(", StringComparison.Ordinal);
        public bool CanBeConstrained => !ValueTypesOnly && Generic.IsMatch(signature);
        /// <summary>Every class has these already, and one that throws would hinder messages and look-ups.</summary>
        public bool IsInherited => Inherited.Any(start => signature.StartsWith(start, StringComparison.Ordinal));

        string Access => IsProtected ? "protected " : "public ";

        string Named => Quoted(owner.FullName + "." + Regex.Match(signature, @"(@?\w+)(<[\w, ]*>)?\s*(\(|\{|$|\[)").Groups[1].Value);

        public string Text(Manner manner)
        {
            if (owner.Kind == "interface") return InInterface();
            if (IsConstructor) return Constructor(manner);
            if (signature.StartsWith("const ", StringComparison.Ordinal)) return $"{Access}{signature} = default;";
            if (signature.StartsWith("event ", StringComparison.Ordinal) || signature.StartsWith("static event ", StringComparison.Ordinal))
                return $"{Access}{signature} {{ add => {Counted}; remove {{ }} }}";

            var match = Operator.Match(signature);
            if (match.Success)
                return $"public static {match.Groups["type"]} operator {match.Groups["op"]}({match.Groups["parameters"]}) => {Thrown};";
            match = Conversion.Match(signature);
            if (match.Success) return $"public static implicit operator {match.Groups["type"]}({match.Groups["parameters"]}) => {Thrown};";
            match = Property.Match(signature);
            if (match.Success) return PropertyText(match.Groups["head"].Value, match.Groups["access"].Value, manner);
            if (signature.Contains(" this[")) return PropertyText(signature, "get set", manner == Manner.Holds ? Manner.Throws : manner);
            return signature.EndsWith(")", StringComparison.Ordinal) ? Method(manner) : $"{Access}{signature};";
        }

        string InInterface()
        {
            var match = Property.Match(signature);
            if (match.Success) return $"{match.Groups["head"]} {{ {Accessors(match.Groups["access"].Value, ";")} }}";
            return signature.Contains(" this[") ? $"{signature} {{ get; set; }}" : signature + ";";
        }

        string Constructor(Manner manner)
        {
            var body = owner.MakesOf || manner != Manner.Throws ? $"{{ {OutValues} }}" : $"=> {Thrown};";
            return $"{Access}{owner.ShortName}{signature.Substring(5)}{(owner.BaseIsStub ? " : base((global::UnityEngine.Headless.StubCalls)null)" : owner.Kind == "struct" ? " : this()" : "")} {body}";
        }

        string PropertyText(string head, string access, Manner manner)
        {
            var indexer = head.Contains("this[");
            if (IsAbstract) return $"{Access}{head} {{ {Accessors(access, ";")} }}";
            // A struct holds what is put into it; there is nothing else that it could do.
            var holds = !indexer && (manner != Manner.Throws || owner.HoldsData) && !head.Contains("ref ");
            if (holds) return $"{Access}{head} {{ {(access.Contains("get") ? Accessors(access, ";") : "get; set;")} " +
                $"}}{(owner.Kind == "struct" ? "" : Initial(Regex.Replace(head, @"^((static|virtual|override|abstract) )+|\s*@?\w+$", "")))}";
            return $"{Access}{head} {{ {Accessors(access, $" => {Thrown};")} }}";
        }

        /// <summary>Nothing pressed, nothing found: scripts go through lists and texts without asking for null.</summary>
        static string Nothing(string type) => type == "string" ? "\"\"" : type.EndsWith("[]", StringComparison.Ordinal)
            && !type.EndsWith("[][]", StringComparison.Ordinal) ? $"System.Array.Empty<{type.Substring(0, type.Length - 2)}>()" : "default";
        static string Initial(string type) => Nothing(type) is var value && value != "default" ? $" = {value};" : "";

        static string Accessors(string access, string body)
            => string.Join(" ", access.Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(a => a + body));

        string Method(Manner manner)
        {
            var constraint = "";
            if (ValueTypesOnly)
                foreach (var name in Generic.Match(signature).Groups["names"].Value.Split(',', StringSplitOptions.TrimEntries))
                    constraint += $" where {name} : struct";
            if (IsAbstract) return $"{Access}{signature}{constraint};";
            if (manner != Manner.Quiet || signature.Contains("ref ") && signature.IndexOf("ref ", StringComparison.Ordinal) < signature.IndexOf('('))
                return $"{Access}{signature}{constraint} => {Thrown};";
            var returns = Regex.IsMatch(signature, @"(^|\s)void\s+\w+(<[^(]*>)?\(") ? ""
                : $" return {Nothing(Regex.Replace(signature.Substring(0, signature.IndexOf('(')), @"^((static|virtual|override|abstract) )+|\s*@?\w+(<[^(]*>)?\s*$", ""))};";
            return $"{Access}{signature}{constraint} {{ {Counted}; {OutValues}{returns} }}";
        }

        string OutValues
        {
            get
            {
                var text = new StringBuilder();
                var open = signature.IndexOf('(');
                foreach (Match match in Out.Matches(signature.Substring(open + 1, signature.Length - open - 2)))
                    text.Append(match.Groups["name"].Value).Append(" = default; ");
                return text.ToString();
            }
        }

        string Thrown => $"throw global::UnityEngine.Headless.StubCalls.Missing({Named})";
        string Counted => $"global::UnityEngine.Headless.StubCalls.Count({Named})";

        static string Quoted(string text) => "\"" + text.Replace("\"", "\\\"") + "\"";
    }
}
