using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Shaders
{
    /// <summary>FXC's text of messages.</summary>
    static class FxcLog
    {
        // "Z:\folder\name(12,3-9): warning X3206: implicit truncation of vector type"; in older forms and for whole programs parts are missing.
        static readonly Regex Message = new Regex(
            @"^(?:.*?\((?<line>\d+)(?:,[\d-]+)?\): )?(?<kind>error|warning)(?: (?<number>X\d+))?: (?<text>.*)$");

        /// <summary>Each message once, on the line that was written.</summary>
        public static List<FxcMessage> Read(string log, FxcRequest request)
        {
            var messages = new List<FxcMessage>();
            foreach (string line in log.Replace("\r", "").TrimEnd('\0').Split('\n').Select(l => l.TrimEnd('\0', ' ')).Where(l => l.Length > 0))
            {
                Match match = Message.Match(line);
                if (match.Success)
                    messages.Add(new FxcMessage
                    {
                        IsError = match.Groups["kind"].Value == "error",
                        Number = match.Groups["number"].Value,
                        Where = Written(match.Groups["line"].Value, request),
                        Text = match.Groups["text"].Value,
                    });
                else if (messages.Count > 0)
                    messages[messages.Count - 1].Text += " " + line.Trim();     // the candidates of an overload and the like
                else
                    messages.Add(new FxcMessage { IsError = true, Where = request.EntryLine, Text = line });
            }
            return messages.GroupBy(m => m.ToString()).Select(g => g.First()).ToList();
        }

        static SourceLine Written(string number, FxcRequest request)
        {
            int index = number.Length == 0 ? -1 : int.Parse(number) - 1;
            return index >= 0 && index < request.Source.Lines.Count ? request.Source.Lines[index] : request.EntryLine;
        }
    }
}
