using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>The file on disk behind an include path such as "Packages/com.x/A.hlsl", "Assets/B.hlsl" or "UnityCG.cginc"; null when
    /// there is none.</summary>
    internal delegate string IncludeResolver(string path);

    /// <summary>A piece of source to preprocess: a whole file or a block of a .shader file.</summary>
    sealed class SourceSegment
    {
        public string Text;
        public string DisplayPath;
        /// <summary>Its includes are looked up beside this file.</summary>
        public string DiskPath;
        public int FirstLine = 1;
    }

    readonly struct PragmaLine
    {
        public readonly string Text;
        public readonly SourceLine Where;
        public PragmaLine(string text, SourceLine where) { Text = text; Where = where; }
    }

    sealed class PreprocessedSource
    {
        public string Text;
        /// <summary>Source of each line of the text.</summary>
        public List<SourceLine> Lines = new List<SourceLine>();
        /// <summary>#pragma lines of the root and of files included with #include_with_pragmas.</summary>
        public List<PragmaLine> Pragmas = new List<PragmaLine>();
        /// <summary>Every file that was read, on disk.</summary>
        public HashSet<string> Files = new HashSet<string>();
    }

    /// <summary>Who reads the text.</summary>
    enum SourceReader
    {
        /// <summary>Nobody: the pragmas alone are wanted.</summary>
        Survey,
        /// <summary>Matrix swizzles are written out.</summary>
        Glslang,
        /// <summary>HLSL as it was written.</summary>
        Fxc,
    }

    /// <summary>
    /// A C preprocessor for HLSL. glslang has one, but it cannot know Unity's include paths and pragmas, and only a text
    /// that is expanded here can name the file and line of an error inside an include, and be the key of a cache.
    /// </summary>
    sealed class Preprocessor
    {
        const int MaxIncludeDepth = 64;

        readonly IncludeResolver resolver;
        readonly Macros macros = new Macros();
        readonly HashSet<string> onceOnly = new HashSet<string>();
        readonly PreprocessedSource result = new PreprocessedSource();
        readonly StringBuilder output = new StringBuilder();
        readonly SourceReader reader;
        readonly bool survey;
        int depth;

        Preprocessor(IncludeResolver resolver, SourceReader reader)
        {
            this.resolver = resolver;
            this.reader = reader;
            survey = reader == SourceReader.Survey;
        }

        /// <summary>
        /// The pragmas alone, before it is known which keywords are on: what #error says then, or an include that no
        /// variant may need, does not count.
        /// </summary>
        public static List<PragmaLine> ReadPragmas(IEnumerable<SourceSegment> segments, IEnumerable<KeyValuePair<string, string>> defines,
            IncludeResolver resolver)
            => Run(new Preprocessor(resolver, SourceReader.Survey), segments, defines).Pragmas;

        /// <param name="defines">Name and value; the value may be empty.</param>
        /// <exception cref="ShaderCompileException"/>
        public static PreprocessedSource Run(IEnumerable<SourceSegment> segments, IEnumerable<KeyValuePair<string, string>> defines,
            IncludeResolver resolver, SourceReader reader = SourceReader.Glslang)
            => Run(new Preprocessor(resolver, reader), segments, defines);

        static PreprocessedSource Run(Preprocessor preprocessor, IEnumerable<SourceSegment> segments, IEnumerable<KeyValuePair<string,
            string>> defines)
        {
            foreach (KeyValuePair<string, string> define in defines)
                preprocessor.macros.Add(define.Key, define.Value);
            foreach (SourceSegment segment in segments)
                preprocessor.Process(segment, true);
            preprocessor.result.Text = preprocessor.output.ToString();
            return preprocessor.result;
        }

        public static string Print(IEnumerable<Token> tokens)
        {
            var text = new StringBuilder();
            Token last = null;
            foreach (Token token in tokens)
            {
                if (last != null && Token.WouldMerge(last, token))
                    text.Append(' ');
                text.Append(token.Text);
                last = token;
            }
            return text.ToString();
        }

        // One #if ... #endif: whether its present branch counts, and whether one has counted already.
        struct Branch { public bool ParentActive, Active, Taken, SawElse; public int Line; }

        void Process(SourceSegment segment, bool pragmasCount)
        {
            if (segment.DiskPath != null)
                result.Files.Add(segment.DiskPath);
            List<string> lines = SourceText.Lines(segment.Text);
            var branches = new Stack<Branch>();
            bool active = true;
            int i = 0;
            try
            {
                for (; i < lines.Count; i++)
                {
                    string line = lines[i];
                    string trimmed = line.TrimStart();
                    if (trimmed.StartsWith('#'))
                    {
                        Directive(trimmed.Substring(1).Trim(), segment, segment.FirstLine + i, pragmasCount, branches, ref active);
                        continue;
                    }
                    if (!active || survey || trimmed.Length == 0)
                        continue;

                    int first = i;
                    List<Token> tokens = Token.Split(line);
                    while (macros.EndsInsideCall(tokens) && i + 1 < lines.Count && !lines[i + 1].TrimStart().StartsWith('#'))
                    {
                        tokens.Add(Token.Blank);
                        tokens.AddRange(Token.Split(lines[++i]));
                    }
                    tokens = macros.Expand(tokens);
                    Emit(Print(reader == SourceReader.Glslang ? MatrixSwizzle.Expand(tokens) : tokens), segment, first);
                }
            }
            catch (PreprocessorException e)
            {
                throw new ShaderCompileException(segment.DisplayPath, segment.FirstLine + Math.Min(i, lines.Count - 1), e.Message);
            }
            if (branches.Count > 0)
                throw new ShaderCompileException(segment.DisplayPath, branches.Peek().Line, "this #if has no #endif");
        }

        void Emit(string text, SourceSegment segment, int line)
        {
            output.Append(text).Append('\n');
            result.Lines.Add(new SourceLine(segment.DisplayPath, segment.FirstLine + line));
        }

        void Directive(string text, SourceSegment segment, int line, bool pragmasCount, Stack<Branch> branches, ref bool active)
        {
            int end = 0;
            while (end < text.Length && (char.IsLetter(text[end]) || text[end] == '_'))
                end++;
            string name = text.Substring(0, end), rest = text.Substring(end).Trim();
            switch (name)
            {
                case "if":
                case "ifdef":
                case "ifndef":
                {
                    bool taken = active && (name == "if" ? Condition.IsTrue(rest, macros)
                        : macros.Contains(FirstWord(rest, name)) == (name == "ifdef"));
                    branches.Push(new Branch { ParentActive = active, Active = taken, Taken = taken, Line = line });
                    active = taken;
                    return;
                }
                case "elif":
                case "else":
                {
                    if (branches.Count == 0)
                        throw new PreprocessorException($"#{name} without #if");
                    Branch branch = branches.Pop();
                    if (branch.SawElse)
                        throw new PreprocessorException($"#{name} after #else");
                    branch.SawElse = name == "else";
                    branch.Active = branch.ParentActive && !branch.Taken && (name == "else" || Condition.IsTrue(rest, macros));
                    branch.Taken |= branch.Active;
                    branches.Push(branch);
                    active = branch.Active;
                    return;
                }
                case "endif":
                    if (branches.Count == 0)
                        throw new PreprocessorException("#endif without #if");
                    active = branches.Pop().ParentActive;
                    return;
            }

            if (!active)
                return;
            switch (name)
            {
                case "define":
                    Define(rest);
                    break;
                case "undef":
                    macros.Remove(FirstWord(rest, name));
                    break;
                case "include":
                case "include_with_pragmas":
                    Include(rest, segment, line, pragmasCount && name == "include_with_pragmas");
                    break;
                case "pragma":
                    Pragma(rest, segment, line, pragmasCount);
                    break;
                case "error":
                    if (survey)
                        break;
                    throw new PreprocessorException(rest);
                case "warning":
                case "line":
                case "":
                    break;
                default:
                    throw new PreprocessorException($"unknown directive #{name}");
            }
        }

        static string FirstWord(string text, string directive)
        {
            Token first = Token.Split(text).FirstOrDefault();
            if (first == null || first.Kind != TokenKind.Identifier)
                throw new PreprocessorException($"#{directive} needs a name");
            return first.Text;
        }

        void Define(string text)
        {
            List<Token> tokens = Token.Split(text);
            var macro = new Macro { Name = FirstWord(text, "define") };
            int body = 1;
            if (tokens.Count > 1 && tokens[1].Is("("))
            {
                int close = tokens.FindIndex(t => t.Is(")"));
                if (close < 0)
                    throw new PreprocessorException($"the parameters of macro '{macro.Name}' have no closing parenthesis");
                macro.Parameters = tokens.GetRange(2, close - 2).Where(t => t.Kind == TokenKind.Identifier).Select(t => t.Text).ToList();
                body = close + 1;
            }
            macro.Body = tokens.GetRange(body, tokens.Count - body);
            while (macro.Body.Count > 0 && macro.Body[0].Kind == TokenKind.Space)
                macro.Body.RemoveAt(0);
            macros.Add(macro);
        }

        void Include(string text, SourceSegment segment, int line, bool pragmasCount)
        {
            if (text.Length > 0 && text[0] != '"' && text[0] != '<')
                text = Print(macros.Expand(Token.Split(text))).Trim();
            int end = text.Length < 2 ? -1 : text.IndexOf(text[0] == '<' ? '>' : '"', 1);
            if (end < 0 || text[0] != '"' && text[0] != '<')
                throw new PreprocessorException("#include needs a \"path\"");
            string path = text.Substring(1, end - 1).Replace('\\', '/');

            if (!TryFind(path, segment, out string disk, out string display))
            {
                if (survey)
                    return;
                throw new PreprocessorException($"Couldn't open include file '{path}'");
            }
            if (onceOnly.Contains(disk))
                return;
            if (++depth > MaxIncludeDepth)
                throw new PreprocessorException(
                    $"'{path}' is included more than {MaxIncludeDepth} files deep: does it include itself? Give it an include guard");
            Process(new SourceSegment { Text = SourceText.Read(disk), DiskPath = disk, DisplayPath = display }, pragmasCount);
            depth--;
        }

        bool TryFind(string path, SourceSegment from, out string disk, out string display)
        {
            string beside = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(from.DiskPath), path));
            bool rooted = path.StartsWith("Packages/") || path.StartsWith("Assets/");
            if (!rooted && File.Exists(beside))
            {
                disk = beside;
                display = Combine(from.DisplayPath, path);
                return true;
            }
            disk = resolver?.Invoke(path);
            display = path;
            if (disk == null && rooted && File.Exists(beside))
                disk = beside;
            disk ??= BuiltInFiles.FindInclude(path);
            return disk != null && File.Exists(disk);
        }

        // The path beside a displayed path, with "..", without asking the disk.
        static string Combine(string displayPath, string relative)
        {
            bool rooted = displayPath.StartsWith('/');
            List<string> parts = displayPath.Split('/', StringSplitOptions.RemoveEmptyEntries).ToList();
            if (parts.Count > 0)
                parts.RemoveAt(parts.Count - 1);
            foreach (string part in relative.Split('/', StringSplitOptions.RemoveEmptyEntries))
            {
                if (part == ".." && parts.Count > 0 && parts[parts.Count - 1] != "..")
                    parts.RemoveAt(parts.Count - 1);
                else if (part != ".")
                    parts.Add(part);
            }
            return (rooted ? "/" : "") + string.Join("/", parts);
        }

        void Pragma(string text, SourceSegment segment, int line, bool pragmasCount)
        {
            string name = text.Split(new[] { ' ', '\t', '(' }, 2)[0];
            if (name == "once")
                onceOnly.Add(segment.DiskPath);
            // Unity leaves pragmas of regular includes to the compiler (manual, "pragma directives in HLSL"). Its own do nothing there, of
            // which FXC warns.
            else if (name == "pack_matrix" || reader == SourceReader.Fxc && !pragmasCount)
                Emit("#pragma " + text, segment, line - segment.FirstLine);
            else if (pragmasCount)
                result.Pragmas.Add(new PragmaLine(text, new SourceLine(segment.DisplayPath, line)));
        }
    }
}
