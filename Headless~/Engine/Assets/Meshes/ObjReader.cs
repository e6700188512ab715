using System;
using System.Buffers.Text;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using UnityEngine;

namespace Host.Assets
{
    /// <summary>Wavefront OBJ: positions and faces; polygons are cut into triangles along their outline, and those that cross themselves left out,
    /// as Unity's importer does. What else a file has does not bear on its shape, and is read only where its looks are asked for.</summary>
    /// <remarks>Wavefront, Advanced Visualizer manual, appendix B1 "Object Files". Works on the bytes: a million triangles are read in less
    /// than a second.</remarks>
    internal sealed class ObjReader
    {
        /// <summary>Statements that would add to the shape; the others name, shade or group.</summary>
        static readonly Dictionary<string, string> Elements = new() { ["l"] = "lines", ["p"] = "points", ["curv"] = "curves",
            ["curv2"] = "curves", ["surf"] = "free-form surfaces", ["call"] = "calls of other files" };

        /// <summary>Keywords that name, shade, group, or belong to a free-form surface.</summary>
        static readonly HashSet<string> Unneeded = new() { "vt", "vn", "vp", "s", "mg", "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp",
            "lod", "shadow_obj", "trace_obj", "ctech", "stech", "cstype", "deg", "bmat", "step", "parm", "trim", "hole", "scrv", "sp", "end", "con",
            "csh" };

        const string Crossing = "polygons that cross themselves";

        static ReadOnlySpan<byte> Blanks => " \t\0"u8;

        readonly string shownAs;
        readonly List<Vector3> vertices = new();
        readonly List<int> triangles = new();
        readonly List<Corner> corners = new();
        readonly MeshLooks looks;
        readonly Dictionary<string, (int Count, int FirstLine)> leftOut = new();
        readonly List<Vector3> outline = new();
        readonly List<int> cut = new();
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
            return new MeshFile(name, reader.vertices.ToArray(), reader.triangles.ToArray(), reader.parts, reader.Notes())
                { Looks = reader.looks, CrossingPolygons = reader.leftOut.GetValueOrDefault(Crossing).Count };
        }

        List<string> Notes() => leftOut.Select(kind => string.Create(CultureInfo.InvariantCulture,
            $"{kind.Value.Count:N0} {kind.Key} are left out, the first in line {kind.Value.FirstLine:N0}.")).ToList();

        void LeaveOut(string what)
        {
            var (count, firstLine) = leftOut.GetValueOrDefault(what, (0, line));
            leftOut[what] = (count + 1, firstLine);
        }

        void ReadLines(ReadOnlySpan<byte> text)
        {
            if (text.StartsWith("\uFEFF"u8)) text = text.Slice(3);
            while (text.Length > 0)
            {
                var from = text;
                var one = Line(ref text);
                line++;
                if (one.Length > 0 && one[^1] == '\\') text = Joined(from);
                else Statement(one);
            }
        }

        /// <summary>Ends with any of the three line ends, or with the file.</summary>
        static ReadOnlySpan<byte> Line(ref ReadOnlySpan<byte> text)
        {
            var end = text.IndexOfAny((byte)'\n', (byte)'\r');
            var one = end < 0 ? text : text.Slice(0, end);
            text = end < 0 ? default : text.Slice(end + (text[end] == '\r' && end + 1 < text.Length && text[end + 1] == '\n' ? 2 : 1));
            return one;
        }

        /// <summary>Reads a statement that goes on in the next lines; what follows it.</summary>
        ReadOnlySpan<byte> Joined(ReadOnlySpan<byte> text)
        {
            var whole = new List<byte>();
            for (var more = true; more && text.Length > 0;)
            {
                var one = Line(ref text);
                more = one.Length > 0 && one[^1] == '\\';
                foreach (var c in more ? one.Slice(0, one.Length - 1) : one) whole.Add(c);
                whole.Add((byte)' ');
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
            else if (!word.SequenceEqual("vn"u8) && !word.SequenceEqual("vt"u8)) Other(Encoding.UTF8.GetString(word));
        }

        void Other(string word)
        {
            if (Elements.TryGetValue(word, out var kind)) LeaveOut(kind);
            else if (!Unneeded.Contains(word)) LeaveOut("lines that no OBJ file has");
        }

        // Beside the position a weight, which is of curves and surfaces alone, or a color.
        void Vertex(ReadOnlySpan<byte> rest)
        {
            vertices.Add(new Vector3(-Number(ref rest), Number(ref rest), Number(ref rest)));
            while (rest.TrimStart(Blanks).Length > 0) Number(ref rest);
        }

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
            Cut();
            for (var i = 0; i < cut.Count; i += 3)
            {
                // Reversed: x is mirrored.
                Add(corners[cut[i]]);
                Add(corners[cut[i + 2]]);
                Add(corners[cut[i + 1]]);
            }
            if (isNewPart)
            {
                parts++;
                NamePart();
            }
            isNewPart = false;
        }

        /// <summary>Numbers of the face's corners, three for each triangle.</summary>
        void Cut()
        {
            outline.Clear();
            cut.Clear();
            foreach (var corner in corners) outline.Add(vertices[corner.Vertex]);
            if (!Polygon.TryCut(outline, cut)) LeaveOut(Crossing);
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

        AssetException NoCorner(ReadOnlySpan<byte> word) => Bad($"'{Shown(word)}' is not a corner of a face, as in 7, 7/2 or 7/2/3");

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
            // Other programs' words for what is not a number: the mesh's check says what comes of it.
            var text = Shown(word).TrimStart('+', '-').ToLowerInvariant();
            if (text.Contains("nan") || text.Contains("ind")) return float.NaN;
            if (text.StartsWith("inf") || text.StartsWith("1.#inf")) return float.PositiveInfinity;
            throw Bad(word.Length == 0 ? "a vertex takes three numbers"
                : $"'{Shown(word)}' is not a number{(text.Contains(',') ? " (decimals take a point)" : "")}");
        }

        static ReadOnlySpan<byte> Word(ref ReadOnlySpan<byte> rest)
        {
            rest = rest.TrimStart(Blanks);
            var end = rest.IndexOfAny((byte)' ', (byte)'\t');
            var word = end < 0 ? rest : rest.Slice(0, end);
            rest = rest.Slice(word.Length);
            return word;
        }

        static string Shown(ReadOnlySpan<byte> word) => Encoding.UTF8.GetString(word.Length > 40 ? word.Slice(0, 40) : word);

        AssetException Bad(string what) => new($"{shownAs}({line}): {what}: repair the file or export it again");
    }
}
