using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Assets
{
    /// <summary>
    /// An .obj file as Unity's model importer makes it: one mesh, x mirrored, scaled by the settings in its .meta file. What the
    /// importer would do and this does not is refused by name.
    /// </summary>
    internal static class ModelReader
    {
        const int MeshClass = 43;
        const string NoGroup = "default";       // what Unity calls the mesh of faces that no g names

        /// <summary>Settings of the importer that must have the value at which they do nothing.</summary>
        static readonly (string Key, int Value, string What)[] Unread =
        {
            ("meshCompression", 0, "Mesh Compression"), ("keepQuads", 0, "Keep Quads"), ("swapUVChannels", 0, "Swap UVs"),
                ("generateSecondaryUV", 0, "Generate Lightmap UVs"),
            ("addColliders", 0, "Generate Colliders"), ("weldVertices", 1, "Weld Vertices off"),
        };

        public static LoadedAsset Read(LoadedAsset asset)
        {
            var entry = asset.Entry;
            var settings = Settings(entry);
            var meshes = settings["meshes"] ?? new YamlMapping(default);
            foreach (var (key, value, what) in Unread)
                if (meshes.Int(key, value) != value) throw Unable(entry, $"its import settings ask for {what}");

            if (new FileInfo(entry.File).Length == 0) throw new AssetException($"{entry.Path} is empty");
            var file = ObjReader.Read(entry.Name, File.ReadAllBytes(entry.File), entry.Path, withLooks: true);
            var name = MeshName(entry, file.Looks);
            for (var i = 0; i < file.CrossingPolygons; i++)
                Debug.LogWarning($"A polygon of Mesh '{name}' in {entry.Path} is self-intersecting and has been discarded.");
            var mesh = Build(file, meshes.Float("globalScale", 1), NormalMode(entry, settings["tangentSpace"], file.Looks));
            mesh.name = name;
            mesh.IsAsset = true;
            if (mesh.HasVertexAttribute(VertexAttribute.TexCoord0) && (settings["tangentSpace"]?.Int("tangentImportMode", 3) ?? 3) == 3)
                mesh.RecalculateTangents();
            if (!(settings["animations"]?.Bool("isReadable") ?? false)) mesh.UploadMeshData(true);
            asset.With(FileId(settings, meshes, entry, name), mesh);
            return asset;
        }

        /// <summary>Unity's rule for parts of a model (fileIdsGeneration 2): a hash of class, name and the count of those of that name
        /// before it.</summary>
        public static long HashedId(string typeName, string name, int before = 0)
            => unchecked((long)XxHash64.Of(Encoding.UTF8.GetBytes($"Type:{typeName}->{name}{before}")));

        /// <summary>File ids of the objects that Unity makes of the file and this reads.</summary>
        public static IEnumerable<long> FileIds(AssetEntry entry)
        {
            var settings = Settings(entry);
            var file = ObjReader.Read(entry.Name, File.ReadAllBytes(entry.File), entry.Path, withLooks: true);
            yield return FileId(settings, settings["meshes"], entry, MeshName(entry, file.Looks));
        }

        static YamlNode Settings(AssetEntry entry)
        {
            var meta = entry.File + ".meta";
            return (File.Exists(meta) ? UnityYaml.ParsePlain(File.ReadAllText(meta), entry.Path + ".meta")["ModelImporter"] : null)
                ?? new YamlMapping(default);
        }

        /// <summary>Id from the table of the .meta file, or the hash.</summary>
        static long FileId(YamlNode settings, YamlNode meshes, AssetEntry entry, string name)
        {
            foreach (var row in settings.Items("internalIDToNameTable"))
                if (row["first"]?[MeshClass.ToString()] is YamlScalar id && row.Text("second") == name) return id.ToLong();
            if (meshes != null && meshes.Int("fileIdsGeneration", 2) != 2)
                throw Unable(entry, $"its .meta file numbers its parts by an older rule (fileIdsGeneration " +
                    $"{meshes.Int("fileIdsGeneration")}) and its internalIDToNameTable does not have the mesh '{name}'");
            return HashedId("Mesh", name);
        }

        static string MeshName(AssetEntry entry, MeshLooks looks)
        {
            if (looks.Groups.Count == 0) throw new AssetException($"{entry.Path} has no faces");
            if (looks.Groups.Count > 1)
                throw Unable(entry,
                $"it has {looks.Groups.Count} groups with faces ({Listed(looks.Groups)}), each of which is a mesh of its own");
            if (looks.Objects.Count > 1) throw Unable(entry, $"it has {looks.Objects.Count} objects with faces ({Listed(looks.Objects)})");
            if (looks.Materials.Count > 1)
                throw Unable(entry, $"it has {looks.Materials.Count} materials ({Listed(looks.Materials)}), each of which is a sub-mesh");
            if (looks.Objects[0].Length > 0 && looks.Groups[0].Length == 0)
                throw Unable(entry,
                $"its faces belong to the object '{looks.Objects[0]}' and to no group, and how Unity names that mesh is not known here");
            return looks.Groups[0].Length > 0 ? looks.Groups[0] : NoGroup;
        }

        static string Listed(List<string> names) => string.Join(", ", names.Take(5).Select(name => $"'{name}'")) + (names.Count > 5 ? ", ..." : "");

        /// <returns>Whether the mesh has the file's normals; false for none at all.</returns>
        static bool NormalMode(AssetEntry entry, YamlNode tangentSpace, MeshLooks looks)
        {
            const int import = 0, none = 2;
            var mode = tangentSpace?.Int("normalImportMode") ?? import;
            if (mode == none) return false;
            if (mode != import) throw Unable(entry, "its import settings ask for Normals: Calculate");
            if (looks.NormalOf.Contains(-1)) throw Unable(entry, "it has corners without a normal, for which Unity calculates one");
            return true;
        }

        static AssetException Unable(AssetEntry entry, string why) =>
            new($"{entry.Path}: {why}: the host does not do that. Export the file as one group of one material with normals, or change " +
            $"its import settings");

        /// <summary>A vertex for every combination of position, normal and texture coordinate that the corners have.</summary>
        static Mesh Build(MeshFile file, float scale, bool hasNormals)
        {
            var looks = file.Looks;
            var hasUvs = looks.Uvs.Count > 0;
            var known = new Dictionary<(int, int, int), int>();
            var vertices = new List<Vector3>();
            var normals = new List<Vector3>();
            var uvs = new List<Vector2>();
            var indices = new int[file.Triangles.Length];
            for (var i = 0; i < indices.Length; i++)
            {
                var key = (file.Triangles[i], hasNormals ? looks.NormalOf[i] : -1, looks.UvOf[i]);
                if (!known.TryGetValue(key, out indices[i]))
                {
                    known[key] = indices[i] = vertices.Count;
                    vertices.Add(scale * file.Vertices[key.Item1]);
                    if (hasNormals) normals.Add(looks.Normals[key.Item2].normalized);
                    if (hasUvs) uvs.Add(key.Item3 >= 0 ? looks.Uvs[key.Item3] : Vector2.zero);
                }
            }
            var mesh = new Mesh { indexFormat = vertices.Count > ushort.MaxValue ? IndexFormat.UInt32 : IndexFormat.UInt16 };
            mesh.SetVertices(vertices);
            if (hasNormals) mesh.SetNormals(normals);
            if (hasUvs) mesh.SetUVs(0, uvs);
            mesh.SetTriangles(indices, 0);
            mesh.RecalculateBounds();
            return mesh;
        }
    }
}
