using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using UnityEngine;

namespace Host.Reference
{
    /// <summary>A surface that another program made, as OBJ or PLY, in the coordinates in which <c>rill export</c> writes particles.</summary>
    static class SurfaceFile
    {
        /// <exception cref="HostException">It cannot be read; with the reason.</exception>
        public static MeshData Read(string file)
        {
            if (!File.Exists(file))
                throw new HostException($"--mesh {file}: the file does not exist.");
            try
            {
                MeshData data = Path.GetExtension(file).ToLowerInvariant() switch
                {
                    ".obj" => Obj(File.ReadLines(file)),
                    ".ply" => Ply(File.ReadAllBytes(file)),
                    _ => throw new HostException($"--mesh {file}: give an .obj or a .ply file."),
                };
                if (data.Faces.Count == 0)
                    throw new HostException($"--mesh {file}: it has no faces. A mesh is wanted, not the particles.");
                if (data.Faces.Any(face => face.Length < 3 || face.Any(corner => corner < 0 || corner >= data.Vertices.Count)))
                    throw new HostException($"--mesh {file}: a face names a vertex that is not there.");
                if (data.Vertices.Any(vertex => !float.IsFinite(vertex.x + vertex.y + vertex.z)))
                    throw new HostException($"--mesh {file}: a vertex is nowhere: one of its coordinates is not a number.");
                return data;
            }
            catch (Exception fault) when (fault is FormatException or OverflowException or IndexOutOfRangeException or ArgumentOutOfRangeException
                or InvalidDataException)
            {
                throw new HostException($"--mesh {file}: it is damaged or of a kind that is not read ({fault.Message.TrimEnd('.')}).");
            }
        }

        static float Number(string word) => float.Parse(word, CultureInfo.InvariantCulture);

        static MeshData Obj(IEnumerable<string> lines)
        {
            var data = new MeshData();
            foreach (string line in lines)
            {
                string[] words = line.Split((char[])null, StringSplitOptions.RemoveEmptyEntries);
                if (words.Length > 0 && words[0] == "v")
                    data.Vertices.Add(new Vector3(Number(words[1]), Number(words[2]), Number(words[3])));
                else if (words.Length > 0 && words[0] == "f")
                    data.Faces.Add(words.Skip(1).Select(word =>
                    {
                        int index = int.Parse(word.Split('/')[0], CultureInfo.InvariantCulture);
                        return index < 0 ? data.Vertices.Count + index : index - 1;
                    }).ToArray());
            }
            return data;
        }

        // Text or little endian: elements vertex and face, other ones skipped.
        static MeshData Ply(byte[] bytes)
        {
            int at = 0;
            string Line()
            {
                int end = Array.IndexOf(bytes, (byte)'\n', at);
                if (end < 0)
                    throw new InvalidDataException("its header has no end");
                string line = Encoding.ASCII.GetString(bytes, at, end - at).Trim();
                at = end + 1;
                return line;
            }

            if (Line() != "ply")
                throw new InvalidDataException("it does not begin with ply");
            string format = null;
            var elements = new List<(string Name, int Count, List<string[]> Properties)>();
            for (string line = Line(); line != "end_header"; line = Line())
            {
                string[] words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
                if (words.Length > 1 && words[0] == "format")
                    format = words[1];
                else if (words.Length > 2 && words[0] == "element")
                    elements.Add((words[1], int.Parse(words[2], CultureInfo.InvariantCulture), new List<string[]>()));
                else if (words.Length > 2 && words[0] == "property")
                    elements[^1].Properties.Add(words);
            }
            Func<string, double> next;
            if (format == "ascii")
            {
                string[] words = Encoding.ASCII.GetString(bytes, at, bytes.Length - at).Split((char[])null, StringSplitOptions.RemoveEmptyEntries);
                int word = 0;
                next = _ => double.Parse(words[word++], CultureInfo.InvariantCulture);
            }
            else if (format == "binary_little_endian")
                next = type => Binary(bytes, ref at, type);
            else
                throw new InvalidDataException($"its format is {format}; ascii and binary_little_endian are read");

            // Nothing in the file takes less than a byte.
            int Count(double value) => value >= 0.0 && value <= bytes.Length ? (int)value
                : throw new InvalidDataException(FormattableString.Invariant($"it says that there are {value} of something"));

            var data = new MeshData();
            foreach (var (name, count, properties) in elements)
                for (int i = 0; i < Count(count); i++)
                {
                    var position = Vector3.zero;
                    foreach (string[] property in properties)
                        if (property[1] == "list")
                        {
                            var corners = new int[Count(next(property[2]))];
                            for (int corner = 0; corner < corners.Length; corner++)
                                corners[corner] = (int)next(property[3]);
                            if (name == "face" && property[4] is "vertex_indices" or "vertex_index")
                                data.Faces.Add(corners);
                        }
                        else
                        {
                            double value = next(property[1]);
                            int axis = "xyz".IndexOf(property[2], StringComparison.Ordinal);
                            if (property[2].Length == 1 && axis >= 0)
                                position[axis] = (float)value;
                        }
                    if (name == "vertex")
                        data.Vertices.Add(position);
                }
            return data;
        }

        static double Binary(byte[] bytes, ref int at, string type)
        {
            (int length, Func<byte[], int, double> read) = type switch
            {
                "char" or "int8" => (1, (Func<byte[], int, double>)((b, i) => (sbyte)b[i])),
                "uchar" or "uint8" => (1, (b, i) => b[i]),
                "short" or "int16" => (2, (b, i) => BinaryPrimitives.ReadInt16LittleEndian(b.AsSpan(i))),
                "ushort" or "uint16" => (2, (b, i) => BinaryPrimitives.ReadUInt16LittleEndian(b.AsSpan(i))),
                "int" or "int32" => (4, (b, i) => BinaryPrimitives.ReadInt32LittleEndian(b.AsSpan(i))),
                "uint" or "uint32" => (4, (b, i) => BinaryPrimitives.ReadUInt32LittleEndian(b.AsSpan(i))),
                "float" or "float32" => (4, (b, i) => BinaryPrimitives.ReadSingleLittleEndian(b.AsSpan(i))),
                "double" or "float64" => (8, (b, i) => BinaryPrimitives.ReadDoubleLittleEndian(b.AsSpan(i))),
                _ => throw new InvalidDataException($"it has a property of the type {type}"),
            };
            double value = read(bytes, at);
            at += length;
            return value;
        }
    }
}
