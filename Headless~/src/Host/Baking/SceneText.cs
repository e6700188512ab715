using System;

namespace Host.Baking
{
    /// <summary>A scene's file as text, of which a single value is changed.</summary>
    static class SceneText
    {
        /// <param name="id">File id of the component.</param>
        /// <param name="field">A reference of its own, on one line.</param>
        /// <param name="value">As Unity writes it, with its braces.</param>
        /// <returns>Null where the file has no such component of its own.</returns>
        public static string WithReference(string text, long id, string field, string value)
        {
            string newLine = text.Contains("\r\n", StringComparison.Ordinal) ? "\r\n" : "\n";
            string head = $"--- !u!114 &{id}{newLine}";
            int start = text.IndexOf(head, StringComparison.Ordinal);
            if (id == 0 || start < 0)
                return null;
            start += head.Length;
            int end = text.IndexOf(newLine + "--- ", start, StringComparison.Ordinal);
            end = end < 0 ? text.Length : end + newLine.Length;
            string key = $"  {field}: ", line = $"{key}{value}{newLine}";
            int at = text.IndexOf(newLine + key, start, end - start, StringComparison.Ordinal);
            if (at < 0)
                // Saved before the component had the field.
                return text.Insert(end, (text[end - 1] == '\n' ? "" : newLine) + line);
            at += newLine.Length;
            int next = text.IndexOf(newLine, at, StringComparison.Ordinal);
            return text.Substring(0, at) + line + (next < 0 ? "" : text.Substring(next + newLine.Length));
        }
    }
}
