using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Baking
{
    /// <summary>A scene's file as text, of which a single value is changed.</summary>
    static class SceneText
    {
        const int MonoBehaviour = 114, PrefabInstance = 1001;

        /// <param name="id">File id of the component.</param>
        /// <param name="field">A reference of its own, on one line.</param>
        /// <param name="value">As Unity writes it, with its braces.</param>
        /// <returns>Null where the file has no such component of its own.</returns>
        public static string WithReference(string text, long id, string field, string value)
        {
            if (!TryFind(text, MonoBehaviour, id, out int start, out int end))
                return null;
            string newLine = NewLineOf(text), key = $"  {field}: ", line = $"{key}{value}{newLine}";
            int at = text.IndexOf(newLine + key, start, end - start, StringComparison.Ordinal);
            if (at < 0)
                // Saved before the component had the field.
                return text.Insert(end, (text[end - 1] == '\n' ? "" : newLine) + line);
            at += newLine.Length;
            int next = text.IndexOf(newLine, at, StringComparison.Ordinal);
            return text.Substring(0, at) + line + (next < 0 ? "" : text.Substring(next + newLine.Length));
        }

        /// <summary>Replaces a list of references in a field that holds nothing else.</summary>
        /// <param name="list">Name of the list in the field's class.</param>
        /// <param name="values">As Unity writes them, with their braces.</param>
        /// <returns>Null where the file has no such component of its own.</returns>
        public static string WithReferences(string text, long id, string field, string list, IReadOnlyList<string> values)
        {
            if (!TryFind(text, MonoBehaviour, id, out int start, out int end))
                return null;
            string newLine = NewLineOf(text);
            string lines = $"  {field}:{newLine}    {list}:{(values.Count == 0 ? " []" : "")}{newLine}"
                + string.Concat(values.Select(value => $"    - {value}{newLine}"));
            Match old = Regex.Match(text.Substring(start, end - start), $@"^  {Regex.Escape(field)}:[^\n]*\n(?:   [^\n]*\n?)*",
                RegexOptions.Multiline);
            return old.Success ? Replace(text, start + old.Index, old.Length, lines)
                : text.Insert(end, (text[end - 1] == '\n' ? "" : newLine) + lines);
        }

        /// <summary>Sets a field of a component that a prefab instance brings.</summary>
        /// <param name="instance">File id of the instance.</param>
        /// <param name="target">File id of the component in the instance's prefab.</param>
        /// <returns>Null where the file has no such instance.</returns>
        public static string WithOverride(string text, long instance, long target, string field, string value)
        {
            if (!TryFind(text, PrefabInstance, instance, out int start, out int end))
                return null;
            string document = text.Substring(start, end - start), newLine = NewLineOf(text);
            Match prefab = Regex.Match(document, @"m_(?:SourcePrefab|ParentPrefab):\s*\{[^}]*guid:\s*([0-9a-f]{32}),\s*type:\s*(\d)");
            // The list's entries and the lines that go on with them are indented deeper than its name, or have its dash.
            Match list = Regex.Match(document, @"^    m_Modifications:[^\S\n]*(\[\])?[^\S\n]*\n((?:    - [^\n]*\n|     [^\n]*\n)*)",
                RegexOptions.Multiline);
            if (!prefab.Success || !list.Success)
                return null;

            string reference = $"      objectReference: {value}{newLine}";
            foreach (Match entry in Regex.Matches(list.Groups[2].Value, @"    - [^\n]*\n(?:     [^\n]*\n)*"))
                if (Regex.IsMatch(entry.Value, $@"target:\s*\{{fileID:\s*{target}\s*,")
                    && Regex.IsMatch(entry.Value, $@"^      propertyPath: {Regex.Escape(field)}\r?$", RegexOptions.Multiline))
                {
                    string changed = Regex.Replace(entry.Value, @"^      objectReference: \{[^}]*\}[^\n]*\n", _ => reference, RegexOptions.Multiline);
                    return Replace(text, start + list.Groups[2].Index + entry.Index, entry.Length, changed);
                }
            string added = $"    - target: {{fileID: {target}, guid: {prefab.Groups[1].Value}, type: " +
                $"{prefab.Groups[2].Value}}}{newLine}      propertyPath: {field}{newLine}      value: {newLine}{reference}";
            return Replace(text, start + list.Index, list.Length, $"    m_Modifications:{newLine}{list.Groups[2].Value}{added}");
        }

        // From the end of a document's head to the end of its last line.
        static bool TryFind(string text, int classId, long id, out int start, out int end)
        {
            string newLine = NewLineOf(text), head = $"--- !u!{classId} &{id}{newLine}";
            start = id == 0 ? -1 : text.IndexOf(head, StringComparison.Ordinal);
            end = text.Length;
            if (start < 0)
                return false;
            start += head.Length;
            int next = text.IndexOf(newLine + "--- ", start, StringComparison.Ordinal);
            if (next >= 0)
                end = next + newLine.Length;
            return true;
        }

        static string NewLineOf(string text) => text.Contains("\r\n", StringComparison.Ordinal) ? "\r\n" : "\n";

        static string Replace(string text, int at, int length, string by) => text.Substring(0, at) + by + text.Substring(at + length);
    }
}
