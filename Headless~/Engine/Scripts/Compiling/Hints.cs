using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Host.UnityApi;
using Microsoft.CodeAnalysis;

namespace Host.Scripts.Compiling
{
    /// <summary>Whose fault an error is: something that Unity has and the host lacks, or something that Unity lacks as well.</summary>
    internal static class Hints
    {
        public const string HostLacksIt = " (Unity 2022.3 has it, the host does not)";

        static readonly Regex Member = new Regex(@"^'(?<type>[\w.<>, ]+)' does not contain a definition for '(?<name>\w+)'", RegexOptions.Compiled);
        static ILookup<string, ApiLine> lines;

        static ILookup<string, ApiLine> Lines => lines ??= UnityApiLists.Load().In("2022.3").ToLookup(l => l.Type.Split('<')[0].Split('.').Last());

        /// <summary>Empty when there is nothing to say.</summary>
        public static string Of(Diagnostic error)
        {
            if (error.Id != "CS0117" && error.Id != "CS1061") return "";
            var match = Member.Match(error.GetMessage());
            if (!match.Success) return "";
            var name = new Regex($@"\b{match.Groups["name"].Value}\b");
            var type = match.Groups["type"].Value.Split('<')[0].Split('.').Last();
            if (!Lines.Contains(type)) return "";
            return Lines[type].Any(l => name.IsMatch(l.Signature)) ? HostLacksIt : "";
        }
    }
}
