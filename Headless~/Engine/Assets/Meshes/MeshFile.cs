using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace Host.Assets
{
    /// <summary>
    /// The triangles of a mesh file in Unity's frame: left-handed, clockwise as seen from outside. Files are right-handed;
    /// x is mirrored, as Unity's importer does with OBJ and glTFast with glTF, so that what is made of it fits the imported mesh.
    /// </summary>
    internal sealed class MeshFile
    {
        public readonly string Name;
        /// <summary>In the file's unit, which Unity takes for meters.</summary>
        public readonly Vector3[] Vertices;
        /// <summary>Three indices a triangle.</summary>
        public readonly int[] Triangles;
        /// <summary>Objects, groups, materials or primitives that have triangles.</summary>
        public readonly int Parts;
        /// <summary>Content of the file that was left out, or was read differently from what it says.</summary>
        public readonly IReadOnlyList<string> Notes;
        /// <summary>Content of an OBJ file beside its shape; null if not requested.</summary>
        public MeshLooks Looks;
        /// <summary>Left out, as Unity does; noted too.</summary>
        public int CrossingPolygons;

        public MeshFile(string name, Vector3[] vertices, int[] triangles, int parts, IReadOnlyList<string> notes)
        {
            Name = name;
            Vertices = vertices;
            Triangles = triangles;
            Parts = parts;
            Notes = notes;
        }

        /// <exception cref="AssetException">The file does not exist, it is of another kind, or it is damaged.</exception>
        public static MeshFile Read(string file)
        {
            string kind = Path.GetExtension(file).ToLowerInvariant();
            if (Directory.Exists(file)) throw new AssetException($"{file} is a folder: name a .obj or .glb file");
            if (!File.Exists(file)) throw new AssetException($"{file} does not exist");
            if (kind != ".obj" && kind != ".glb") throw new AssetException($"{file} is not a mesh that can be read here: save it as .obj or .glb");
            if (new FileInfo(file).Length == 0) throw new AssetException($"{file} is empty");
            if (new FileInfo(file).Length > Array.MaxLength)
                throw new AssetException($"{file} has more than 2 GB: split it, or reduce its triangles");
            byte[] bytes = File.ReadAllBytes(file);
            string name = Path.GetFileNameWithoutExtension(file);
            return kind == ".obj" ? ObjReader.Read(name, bytes, file) : GlbReader.Read(name, bytes, file);
        }
    }

    /// <summary>Normals, texture coordinates and names of an OBJ file, in Unity's frame.</summary>
    internal sealed class MeshLooks
    {
        public readonly List<Vector3> Normals = new();
        public readonly List<Vector2> Uvs = new();
        /// <summary>Entry of every corner of the triangles in those lists, or -1.</summary>
        public readonly List<int> NormalOf = new(), UvOf = new();
        /// <summary>Names of parts with faces: those after g, o and usemtl, each once; "" for faces before the first of the kind.</summary>
        public readonly List<string> Groups = new(), Objects = new(), Materials = new();
    }
}
