using System;
using System.Collections.Generic;
using System.Globalization;

namespace Host.Assets
{
    /// <summary>Location at which a value was read, for messages: "Assets/Scene.unity(120)".</summary>
    internal readonly struct SourceLocation
    {
        public readonly string File;
        public readonly int Line;
        public SourceLocation(string file, int line) { File = file; Line = line; }
        public override string ToString() => Line > 0 ? $"{File}({Line})" : File;
        public AssetException Error(string what) => new AssetException($"{this}: {what}");
    }

    /// <summary>A value of a Unity YAML document. Scalars stay text until a field asks for a type.</summary>
    internal abstract class YamlNode
    {
        public readonly SourceLocation Location;
        protected YamlNode(SourceLocation location) => Location = location;
        public abstract YamlNode Clone();
        public abstract string Kind { get; }

        /// <summary>Null if this is not a mapping or lacks the key.</summary>
        public YamlNode this[string key] => (this as YamlMapping)?.Find(key);
        public string Text(string key, string otherwise = "") => this[key] is YamlScalar scalar ? scalar.Value : otherwise;
        public int Int(string key, int otherwise = 0) => this[key] is YamlScalar { IsEmpty: false } scalar ? scalar.ToInt() : otherwise;
        public float Float(string key, float otherwise = 0) => this[key] is YamlScalar { IsEmpty: false } scalar ? scalar.ToFloat() : otherwise;
        public bool Bool(string key, bool otherwise = false) => Int(key, otherwise ? 1 : 0) != 0;
        public FileReference Reference(string key) => FileReference.Of(this[key]);

        /// <summary>The items of a list; an absent, empty or {} value is an empty list.</summary>
        public IEnumerable<YamlNode> Items(string key) => this[key] is YamlSequence list ? list.Elements : Array.Empty<YamlNode>();
    }

    internal sealed class YamlScalar : YamlNode
    {
        public readonly string Value;
        public YamlScalar(SourceLocation location, string value) : base(location) => Value = value;
        public override YamlNode Clone() => this;
        public override string Kind => $"the value '{(Value.Length > 40 ? Value.Substring(0, 40) + "..." : Value)}'";
        public bool IsEmpty => Value.Length == 0;
        public override string ToString() => Value;

        public float ToFloat() => (float)ToDouble();

        public double ToDouble()
        {
            // Unity writes what C's printf does for values that are not finite.
            switch (Value.ToLowerInvariant())
            {
                case "inf": case "+inf": case ".inf": case "infinity": case "1.#inf": return double.PositiveInfinity;
                case "-inf": case "-.inf": case "-infinity": case "-1.#inf": return double.NegativeInfinity;
                case "nan": case "-nan": case ".nan": case "-nan(ind)": case "-1.#ind": case "1.#qnan": return double.NaN;
            }
            return double.TryParse(Value, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) ? value
                : throw Location.Error($"'{Value}' is not a number");
        }

        public long ToLong()
        {
            if (long.TryParse(Value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var value)) return value;
            if (ulong.TryParse(Value, NumberStyles.None, CultureInfo.InvariantCulture, out var large)) return unchecked((long)large);
            throw Location.Error($"'{Value}' is not a whole number");
        }

        /// <summary>Masks are written unsigned (4294967295): such a value is taken bit for bit.</summary>
        public int ToInt()
        {
            var value = ToLong();
            return value >= int.MinValue && value <= uint.MaxValue ? unchecked((int)value) : throw Location.Error($"{Value} does not fit 32 bits");
        }
    }

    /// <summary>An element that a longer list has and no one gave a value: it stays as its constructor leaves it.</summary>
    internal sealed class YamlUnset : YamlNode
    {
        public YamlUnset(SourceLocation location) : base(location) { }
        public override YamlNode Clone() => this;
        public override string Kind => "nothing";
    }

    /// <summary>A packed list of numbers with overrides: only the field that reads it knows how wide its numbers are.</summary>
    internal sealed class YamlPackedList : YamlNode
    {
        public const int Size = -1;
        public readonly YamlScalar Packed;
        /// <summary>Values by index, or the list's new size.</summary>
        public readonly List<KeyValuePair<int, YamlScalar>> Changes = new List<KeyValuePair<int, YamlScalar>>();
        public YamlPackedList(YamlScalar packed) : base(packed.Location) => Packed = packed;
        public override string Kind => Packed.Kind;

        public override YamlNode Clone()
        {
            var copy = new YamlPackedList(Packed);
            copy.Changes.AddRange(Changes);
            return copy;
        }
    }

    internal sealed class YamlSequence : YamlNode
    {
        public readonly List<YamlNode> Elements = new List<YamlNode>();
        public YamlSequence(SourceLocation location) : base(location) { }
        public override string Kind => $"a list of {Elements.Count}";

        public override YamlNode Clone()
        {
            var copy = new YamlSequence(Location);
            foreach (var item in Elements) copy.Elements.Add(item.Clone());
            return copy;
        }
    }

    /// <summary>Keys in file order. Files of old editors repeat keys, so the first of a name is found and all are listed.</summary>
    internal sealed class YamlMapping : YamlNode
    {
        public readonly List<KeyValuePair<string, YamlNode>> Entries = new List<KeyValuePair<string, YamlNode>>();
        public YamlMapping(SourceLocation location) : base(location) { }
        public override string Kind => "a group of fields";

        public YamlNode Find(string key)
        {
            foreach (var entry in Entries)
                if (entry.Key == key) return entry.Value;
            return null;
        }

        public void Set(string key, YamlNode value)
        {
            for (var i = 0; i < Entries.Count; i++)
                if (Entries[i].Key == key)
                {
                    Entries[i] = new KeyValuePair<string, YamlNode>(key, value);
                    return;
                }
            Entries.Add(new KeyValuePair<string, YamlNode>(key, value));
        }

        public override YamlNode Clone()
        {
            var copy = new YamlMapping(Location);
            foreach (var entry in Entries) copy.Entries.Add(new KeyValuePair<string, YamlNode>(entry.Key, entry.Value.Clone()));
            return copy;
        }
    }

    /// <summary>{fileID: 11500000, guid: ..., type: 3}. Without guid: an object of the same file. File id 0: none.</summary>
    internal readonly struct FileReference
    {
        public readonly long FileId;
        public readonly string Guid;
        public readonly SourceLocation Location;
        public FileReference(long fileId, string guid, SourceLocation location) { FileId = fileId; Guid = guid; Location = location; }
        public bool IsNone => FileId == 0;
        public bool IsLocal => string.IsNullOrEmpty(Guid);
        public override string ToString() => IsLocal ? $"{{fileID: {FileId}}}" : $"{{fileID: {FileId}, guid: {Guid}}}";

        public static bool Is(YamlNode node) => node?["fileID"] != null;
        public static FileReference Of(YamlNode node) =>
            node?["fileID"] is YamlScalar id ? new FileReference(id.ToLong(), node.Text("guid", null), node.Location) : default;
    }
}
