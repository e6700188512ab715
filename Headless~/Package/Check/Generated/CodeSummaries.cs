using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace Host.Check
{
    /// <summary>The summaries of types and fields in the documentation that the compiler writes beside an assembly, as comments of ASCII.</summary>
    sealed class CodeSummaries
    {
        static readonly Dictionary<string, string> Ascii = new()
        {
            ["²"] = "^2", ["³"] = "^3", ["⁴"] = "^4", ["⁶"] = "^6", ["−"] = "-", ["·"] = " ", ["×"] = "x", ["≤"] = "<=", ["≥"] = ">=", ["ρ"] = "rho",
                ["ω"] = "omega", ["ℓ"] = "l", ["Δ"] = "delta ", ["π"] = "pi", ["λ"] = "lambda", ["ε"] = "epsilon",
        };

        readonly Dictionary<string, string> byId;

        CodeSummaries(Dictionary<string, string> byId) => this.byId = byId;

        public static readonly CodeSummaries None = new(new Dictionary<string, string>());

        /// <summary>Without the file all are empty.</summary>
        public static CodeSummaries Load(string path) => File.Exists(path) ? Parse(File.ReadAllText(path)) : None;

        public static CodeSummaries Parse(string xml)
            => new(XDocument.Parse(xml).Descendants("member").Where(member => member.Element("summary") != null)
            .GroupBy(member => (string)member.Attribute("name")).ToDictionary(members => members.Key,
                members => Text(members.First().Element("summary"))));

        /// <summary>In one line; empty where there is none.</summary>
        public string Of(MemberInfo member)
        {
            string id = member is Type type ? $"T:{type.FullName}" : $"F:{member.DeclaringType.FullName}.{member.Name}";
            return byId.TryGetValue(id.Replace('+', '.'), out string text) ? text : "";
        }

        static string Text(XElement summary)
        {
            var text = new StringBuilder();
            foreach (XNode node in summary.DescendantNodes())
                if (node is XText words)
                    text.Append(words.Value);
                else if (node is XElement { Name.LocalName: "see" or "paramref" } reference)
                    text.Append(((string)reference.Attribute("cref") ?? (string)reference.Attribute("name") ?? "").Split('(')[0].Split('.',
                        ':').Last());
            string line = Regex.Replace(text.ToString(), @"\s+", " ").Trim();
            foreach ((string letter, string ascii) in Ascii)
                line = line.Replace(letter, ascii);
            return line;
        }
    }
}
