using System;
using System.Buffers.Text;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using UnityEngine;

namespace Host.Assets
{
    /// <summary>Wavefront OBJ: positions and faces; polygons become fans around their first corner. What else a file has does not bear on
    /// its shape, and is read only where its looks are asked for.</summary>
    /// <remarks>Wavefront, Advanced Visualizer manual, appendix B1 "Object Files". Works on the bytes: a million triangles are read in less
    /// than a second.</remarks>
    internal sealed class ObjReader
    {
        /// <summary>Statements that would add to the shape; the others name, shade or group.</summary>
        static readonly Dictionary<string, string> Elements = new() { ["l"] = "lines", ["p"] = "points", ["curv"] = "curves",
            ["curv2"] = "curves", ["surf"] = "free-form surfaces" };

        readonly string shownAs;
        readonly List<Vector3> vertices = new();
        readonly List<int> triangles = new();
        readonly List<Corner> corners = new();
        readonly MeshLooks looks;
        readonly Dictionary<string, int> leftOut = new();
        int line, parts;
        bool isNewPart = true;
        string group = "", item = "", material = "";

        /// <summary>Indices from 0; -1 for none.</summary>
        struct Corner { public int Vertex, Uv, Normal; }

        ObjReader(string shownAs, bool withLooks)
        {
            this.shownAs = shownAs;
            looks = withLooks ? new MeshLooks() : null;
        }

        /// <param name="withLooks">Whether normals, texture coordinates and names are wanted too; without, damage to them does no harm.</param>
        public static MeshFile Read(string name, byte[] text, string shownAs, bool withLooks = false)
        {
            var reader = new ObjReader(shownAs, withLooks);
            reader.ReadLines(text);
            if (reader.vertices.Count == 0 && reader.triangles.Count == 0)
                throw new AssetException($"{shownAs} is no OBJ file: no line starts with v or f");
            return new MeshFile(name, reader.vertices.ToArray(), reader.triangles.ToArray(), reader.parts,
                reader.leftOut.Select(kind => $"{kind.Value.ToString("N0", CultureInfo.InvariantCulture)} {kind.Key} are left out.")
                .ToList()) { Looks = reader.looks };
        }

        void ReadLines(ReadOnlySpan<byte> text)
        {
            if (text.StartsWith("\uFEFF"u8)) text = text.Slice(3);
            while (text.Length > 0)
            {
                var end = text.IndexOfAny((byte)'\n', (byte)'\r');
                var one = end < 0 ? text : text.Slice(0, end);
                line++;
                if (one.Length > 0 && one[^1] == '\\')
                {
                    text = Joined(text);
                    continue;
                }
                Statement(one);
                text = end < 0 ? default : text.Slice(end + (text[end] == '\r' && end + 1 < text.Length && text[end + 1] == '\n' ? 2 : 1));
            }
        }

        /// <summary>Reads a statement that goes on in the next lines; what follows it.</summary>
        ReadOnlySpan<byte> Joined(ReadOnlySpan<byte> text)
        {
            var whole = new List<byte>();
            for (var more = true; more && text.Length > 0;)
            {
                var end = text.IndexOf((byte)'\n');
                var one = (end < 0 ? text : text.Slice(0, end)).TrimEnd((byte)'\r');
                more = one.Length > 0 && one[^1] == '\\';
                foreach (var c in more ? one.Slice(0, one.Length - 1) : one) whole.Add(c);
                whole.Add((byte)' ');
                text = end < 0 ? default : text.Slice(end + 1);
                line += more ? 1 : 0;
            }
            Statement(whole.ToArray());
            return text;
        }

        void Statement(ReadOnlySpan<byte> rest)
        {
            var comment = rest.IndexOf((byte)'#');
            if (comment >= 0) rest = rest.Slice(0, comment);
            var word = Word(ref rest);
            if (word.Length == 0) return;
            if (word.SequenceEqual("v"u8)) Vertex(rest);
            else if (word.SequenceEqual("f"u8) || word.SequenceEqual("fo"u8)) Face(rest);
            else if (word.SequenceEqual("o"u8)) Part(ref item, rest);
            else if (word.SequenceEqual("g"u8)) Part(ref group, rest);
            else if (word.SequenceEqual("usemtl"u8)) Part(ref material, rest);
            else if (looks != null && word.SequenceEqual("vn"u8))
                looks.Normals.Add(new Vector3(-Number(ref rest), Number(ref rest), Number(ref rest)));
            else if (looks != null && word.SequenceEqual("vt"u8)) looks.Uvs.Add(new Vector2(Number(ref rest), Number(ref rest)));
            else if (word[0] != 'v' && Elements.TryGetValue(Encoding.ASCII.GetString(word), out var kind))
                leftOut[kind] = leftOut.GetValueOrDefault(kind) + 1;
        }

        void Vertex(ReadOnlySpan<byte> rest) => vertices.Add(new Vector3(-Number(ref rest), Number(ref rest), Number(ref rest)));

        void Part(ref string name, ReadOnlySpan<byte> rest)
        {
            isNewPart = true;
            if (looks != null) name = Encoding.UTF8.GetString(rest).Trim();
        }

        void Face(ReadOnlySpan<byte> rest)
        {
            corners.Clear();
            for (var word = Word(ref rest); word.Length > 0; word = Word(ref rest)) corners.Add(ReadCorner(word));
            if (corners.Count < 3) throw Bad($"a face of {corners.Count} corners; it takes at least 3");
            for (var i = 1; i + 1 < corners.Count; i++)
            {
                // The other way around: x is mirrored.
                Add(corners[0]);
                Add(corners[i + 1]);
                Add(corners[i]);
            }
            if (isNewPart)
            {
                parts++;
                NamePart();
            }
            isNewPart = false;
        }

        void Add(in Corner corner)
        {
            triangles.Add(corner.Vertex);
            if (looks == null) return;
            looks.UvOf.Add(corner.Uv);
            looks.NormalOf.Add(corner.Normal);
        }

        void NamePart()
        {
            if (looks == null) return;
            foreach (var (names, name) in new[] { (looks.Groups, group), (looks.Objects, item), (looks.Materials, material) })
                if (!names.Contains(name)) names.Add(name);
        }

        /// <summary>v, v/vt, v//vn or v/vt/vn.</summary>
        Corner ReadCorner(ReadOnlySpan<byte> word)
        {
            if (!Utf8Parser.TryParse(word, out int index, out var read) || read < word.Length && word[read] != '/') throw NoCorner(word);
            var corner = new Corner { Vertex = Index(index, vertices.Count, "vertex"), Uv = -1, Normal = -1 };
            if (looks == null || read == word.Length) return corner;

            var rest = word.Slice(read + 1);
            if (rest.Length > 0 && rest[0] != '/')
            {
                if (!Utf8Parser.TryParse(rest, out index, out read) || read < rest.Length && rest[read] != '/') throw NoCorner(word);
                corner.Uv = Index(index, looks.Uvs.Count, "texture coordinate");
                rest = rest.Slice(read);
            }
            if (rest.Length <= 1) return corner;
            if (!Utf8Parser.TryParse(rest.Slice(1), out index, out read) || read < rest.Length - 1) throw NoCorner(word);
            corner.Normal = Index(index, looks.Normals.Count, "normal");
            return corner;
        }

        AssetException NoCorner(ReadOnlySpan<byte> word) => Bad($"'{Shown(word)}' is no corner of a face, as in 7, 7/2 or 7/2/3");

        /// <summary>From 1 on, or backwards from the latest with -1.</summary>
        int Index(int index, int count, string what)
        {
            var at = index < 0 ? count + index : index - 1;
            if (index == 0 || at < 0 || at >= count)
                throw Bad($"the face refers to {what} {index}, but {count.ToString("N0", CultureInfo.InvariantCulture)} come before it");
            return at;
        }

        float Number(ref ReadOnlySpan<byte> rest)
        {
            var word = Word(ref rest);
            if (Utf8Parser.TryParse(word, out float value, out var read) && read == word.Length) return value;
            // Other programs' words for what is no number: the mesh's check says what comes of it.
            var text = Shown(word).TrimStart('+', '-').ToLowerInvariant();
            if (text.Contains("nan") || text.Contains("ind")) return float.NaN;
            if (text.StartsWith("inf") || text.StartsWith("1.#inf")) return float.PositiveInfinity;
            throw Bad(word.Length == 0 ? "a vertex takes three numbers" : $"'{Shown(word)}' is no number");
        }

        static ReadOnlySpan<byte> Word(ref ReadOnlySpan<byte> rest)
        {
            rest = rest.TrimStart(" \t\0"u8);
            var end = rest.IndexOfAny((byte)' ', (byte)'\t');
            var word = end < 0 ? rest : rest.Slice(0, end);
            rest = rest.Slice(word.Length);
            return word;
        }

        static string Shown(ReadOnlySpan<byte> word) => Encoding.UTF8.GetString(word.Length > 40 ? word.Slice(0, 40) : word);

        AssetException Bad(string what) => new($"{shownAs}({line}): {what}: repair the file or export it again");
    }
}
