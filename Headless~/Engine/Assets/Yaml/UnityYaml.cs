using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Host.Assets
{
    /// <summary>One object of a file: "--- !u!114 &amp;123", its type's name and its fields.</summary>
    internal sealed class UnityDocument
    {
        public int ClassId;
        public long FileId;
        /// <summary>Stands for an object that lives in a prefab: only what tells which one is here.</summary>
        public bool Stripped;
        public string TypeName;
        public YamlMapping Fields;
        public SourceLocation Location;
        /// <summary>Prefab instance of this file that it comes from; null for the file's own.</summary>
        public PrefabOrigin Origin;

        public UnityDocument Clone(long fileId) =>
            new UnityDocument { ClassId = ClassId, FileId = fileId, Stripped = Stripped, TypeName = TypeName,
            Fields = (YamlMapping)Fields.Clone(), Location = Location };

        public override string ToString() => $"{TypeName} &{FileId}";
    }

    /// <summary>Address of an override of an object.</summary>
    internal sealed class PrefabOrigin
    {
        /// <summary>File id of the instance in the file that overrides.</summary>
        public readonly long Instance;
        /// <summary>File id of the object in the instance's prefab, which may have it from another.</summary>
        public readonly long Target;

        public PrefabOrigin(long instance, long target) => (Instance, Target) = (instance, target);
    }

    /// <summary>A .unity, .prefab, .asset or .mat file as its documents.</summary>
    internal sealed class UnityYaml
    {
        public readonly string File;
        public readonly List<UnityDocument> Documents = new List<UnityDocument>();
        /// <summary>Ids of objects of prefab instances that could not be expanded: references to them are none.</summary>
        public readonly HashSet<long> LeftOut = new HashSet<long>();
        readonly Dictionary<long, UnityDocument> byId = new Dictionary<long, UnityDocument>();

        public UnityYaml(string file) => File = file;

        public void Add(UnityDocument document)
        {
            if (!byId.TryAdd(document.FileId, document))
                throw document.Location.Error($"file id {document.FileId} is that of the document in line {byId[document.FileId].Location.Line} too");
            Documents.Add(document);
        }

        public UnityDocument Find(long fileId) => byId.TryGetValue(fileId, out var document) ? document : null;

        public static UnityYaml Load(string path, string shownAs) => Parse(System.IO.File.ReadAllText(path), shownAs);

        /// <summary>
        /// The separators are read here and each body goes to the YAML reader alone: Unity writes "stripped" behind the
        /// anchor and declares its tag once for all documents, and YAML allows neither.
        /// </summary>
        public static UnityYaml Parse(string text, string file)
        {
            var yaml = new UnityYaml(file);
            if (text.StartsWith("version https://git-lfs", StringComparison.Ordinal))
                throw new SourceLocation(file, 1).Error("this is a Git LFS pointer, not the file itself: run 'git lfs pull'");
            if (!text.StartsWith("%YAML", StringComparison.Ordinal) && !text.StartsWith("--- !u!", StringComparison.Ordinal))
                throw new SourceLocation(file, 1)
                    .Error(
                    "this is no Unity YAML file: set Project Settings > Editor > Asset Serialization to Force Text and save it again");

            UnityDocument current = null;
            int bodyStart = 0, bodyLine = 0, line = 0;
            for (var at = 0; at < text.Length;)
            {
                line++;
                var end = text.IndexOf('\n', at);
                if (end < 0) end = text.Length;
                var starts = text.AsSpan(at, end - at);
                if (starts.StartsWith("--- "))
                {
                    if (current != null) yaml.Add(current, text.Substring(bodyStart, at - bodyStart), bodyLine);
                    current = Header(starts.TrimEnd().ToString(), new SourceLocation(file, line));
                    bodyStart = Math.Min(end + 1, text.Length);
                    bodyLine = line;
                }
                else if (starts.StartsWith("<<<<<<< ") || starts.StartsWith(">>>>>>> "))
                    throw new SourceLocation(file, line).Error("a merge conflict is left in this file: resolve it");
                at = end + 1;
            }
            if (current != null) yaml.Add(current, text.Substring(bodyStart), bodyLine);
            return yaml;
        }

        /// <summary>YAML of one unnamed document, such as a .meta file.</summary>
        public static YamlNode ParsePlain(string text, string file) => new BodyReader(file, 0).Read(text);

        static UnityDocument Header(string header, SourceLocation location)
        {
            var words = header.Split(' ', StringSplitOptions.RemoveEmptyEntries);
            if (words.Length < 3 || !words[1].StartsWith("!u!", StringComparison.Ordinal) || words[2][0] != '&'
                || !int.TryParse(words[1].AsSpan(3), NumberStyles.None, CultureInfo.InvariantCulture, out var classId)
                || !long.TryParse(words[2].AsSpan(1), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var fileId))
                throw location.Error($"'{header}' is not a document header: expected '--- !u!<class id> &<file id>'");
            return new UnityDocument { ClassId = classId, FileId = fileId, Stripped = words.Length > 3 && words[3] == "stripped",
                Location = location };
        }

        void Add(UnityDocument document, string body, int linesBefore)
        {
            var reader = new BodyReader(File, linesBefore);
            if (reader.Read(body) is not YamlMapping { Entries: { Count: > 0 } } root)
                throw document.Location.Error("the document is empty");
            document.TypeName = root.Entries[0].Key;
            document.Fields = root.Entries[0].Value as YamlMapping ?? new YamlMapping(root.Location);
            Add(document);
        }

        sealed class BodyReader
        {
            readonly string file;
            readonly int linesBefore;
            IParser events;

            public BodyReader(string file, int linesBefore) { this.file = file; this.linesBefore = linesBefore; }

            public YamlNode Read(string body)
            {
                try
                {
                    events = new Parser(new StringReader(body));
                    events.Consume<StreamStart>();
                    if (!events.TryConsume<DocumentStart>(out _)) return null;
                    return Node();
                }
                catch (YamlException e)
                {
                    throw new AssetException($"{new SourceLocation(file, linesBefore + (int)e.Start.Line)}: {e.Message}", e);
                }
            }

            YamlNode Node()
            {
                if (events.TryConsume<Scalar>(out var scalar)) return new YamlScalar(Location(scalar), scalar.Value);
                if (events.TryConsume<SequenceStart>(out var list))
                {
                    var sequence = new YamlSequence(Location(list));
                    while (!events.TryConsume<SequenceEnd>(out _)) sequence.Elements.Add(Node());
                    return sequence;
                }
                var start = events.Consume<MappingStart>();
                var mapping = new YamlMapping(Location(start));
                while (!events.TryConsume<MappingEnd>(out _))
                {
                    var key = events.Consume<Scalar>();
                    mapping.Entries.Add(new KeyValuePair<string, YamlNode>(key.Value, Node()));
                }
                return mapping;
            }

            SourceLocation Location(ParsingEvent e) => new SourceLocation(file, linesBefore + (int)e.Start.Line);
        }
    }
}
