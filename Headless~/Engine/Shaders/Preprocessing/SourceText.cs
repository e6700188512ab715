using System.Collections.Generic;
using System.IO;
using System.Text;

namespace Host.Shaders
{
    /// <summary>A line of a source file, for messages.</summary>
    readonly struct SourceLine
    {
        public readonly string File;
        public readonly int Line;
        public SourceLine(string file, int line) { File = file; Line = line; }
    }

    /// <summary>Reads source files as Unity does: any byte-order mark, any line ending.</summary>
    static class SourceText
    {
        public static string Read(string path)
        {
            using var reader = new StreamReader(path, new UTF8Encoding(false), detectEncodingFromByteOrderMarks: true);
            return reader.ReadToEnd().Replace("\r\n", "\n").Replace('\r', '\n');
        }

        /// <summary>
        /// Lines without comments, with backslash-continued lines joined: the joined line stands where it began and
        /// empty lines replace the rest, so that line numbers hold.
        /// </summary>
        public static List<string> Lines(string text)
        {
            var lines = new List<string>();
            var line = new StringBuilder();
            int joined = 0;
            bool inComment = false;
            for (int i = 0; i <= text.Length; i++)
            {
                char c = i < text.Length ? text[i] : '\n';
                char next = i + 1 < text.Length ? text[i + 1] : '\0';
                if (c == '\n')
                {
                    if (inComment && i < text.Length)
                    {
                        joined++;   // a comment over several lines is one blank, as the standard has it
                        continue;
                    }
                    lines.Add(line.ToString());
                    line.Clear();
                    for (; joined > 0; joined--)
                        lines.Add("");
                }
                else if (inComment)
                {
                    if (c == '*' && next == '/')
                    {
                        inComment = false;
                        i++;
                    }
                }
                else if (c == '\\' && next == '\n')
                {
                    joined++;
                    i++;
                }
                else if (c == '/' && next == '*')
                {
                    inComment = true;
                    line.Append(' ');
                    i++;
                }
                else if (c == '/' && next == '/')
                {
                    while (i + 1 < text.Length && text[i + 1] != '\n')
                    {
                        // A line comment that ends in a backslash goes on.
                        if (text[i + 1] == '\\' && i + 2 < text.Length && text[i + 2] == '\n')
                        {
                            joined++;
                            i++;
                        }
                        i++;
                    }
                }
                else if (c == '"')
                {
                    line.Append(c);
                    while (i + 1 < text.Length && text[i + 1] != '\n')
                    {
                        line.Append(text[++i]);
                        if (text[i] == '"')
                            break;
                    }
                }
                else
                    line.Append(c);
            }
            return lines;
        }
    }
}
