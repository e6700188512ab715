using System.Linq;
using System.Text;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>.obj files as Unity's model importer makes them.</summary>
    public class ModelImportTests : AssetFixture
    {
        const string Guid = "f0000000000000000000000000000001", Path = "Assets/Part.obj";
        // A square in the plane z = 0 that looks towards -z, as the file has it; two triangles have a common edge.
        const string Square = "v 0 0 0\nv 0 2 0\nv 3 2 0\nv 3 0 0\nvn 0 0 -1\nf 1//1 2//1 3//1 4//1\n";

        ProjectAssets Project(string obj, string settings = "")
        {
            TemporaryProject project = Temporary().Write(Path, obj, null);
            project.Write(Path + ".meta", $"fileFormatVersion: 2\nguid: {Guid}\nModelImporter:\n  serializedVersion: 22200\n{settings}", null);
            return project.Open();
        }

        Mesh Import(string obj, string settings = "  animations:\n    isReadable: 1\n") => Project(obj, settings).LoadAtPath<Mesh>(Path);

        string Refusal(string obj, string settings = "") => Assert.Throws<AssetException>(() => Import(obj, settings)).Message;

        // Ids that Unity gave, as public projects' files have them: the mesh and the material of an .obj file without groups.
        [TestCase("Mesh", "default", -2432090755550338912)]
        [TestCase("Material", "defaultMat", -3033667219593020291)]
        public void Parts_of_a_model_have_the_file_ids_that_unity_hashes(string type, string name, long id)
            => Assert.That(ModelReader.HashedId(type, name), Is.EqualTo(id));

        // The hash's own test vectors, seed 0: below and above the 32 bytes from which it works in lanes.
        [TestCase("", 0xEF46DB3751D8E999)]
        [TestCase("a", 0xD24EC4F1A98C6E5B)]
        [TestCase("abc", 0x44BC2CF5AD770999UL)]
        [TestCase("Nobody inspects the spammish repetition", 0xFBCEA83C8A378BF1)]
        public void The_hash_is_xxhash64(string text, ulong hash) => Assert.That(XxHash64.Of(Encoding.ASCII.GetBytes(text)), Is.EqualTo(hash));

        [Test]
        public void The_mesh_is_mirrored_in_x_and_looks_the_same_way()
        {
            Mesh mesh = Import(Square);
            Assert.That(mesh.name, Is.EqualTo("default"));
            Assert.That(mesh.vertices, Is.EquivalentTo(new[] { new Vector3(0, 0, 0), new Vector3(0, 2, 0), new Vector3(-3, 2, 0),
                new Vector3(-3, 0, 0) }));
            Assert.That(mesh.normals, Is.EqualTo(Enumerable.Repeat(Vector3.back, 4)));
            int[] triangles = mesh.triangles;
            for (int i = 0; i < 6; i += 3)
            {
                Vector3 a = mesh.vertices[triangles[i]], b = mesh.vertices[triangles[i + 1]], c = mesh.vertices[triangles[i + 2]];
                Assert.That(Vector3.Cross(b - a, c - a).z, Is.LessThan(0f), "clockwise from where the normal points, in a left-handed frame");
            }
            Assert.That(mesh.bounds, Is.EqualTo(new Bounds(new Vector3(-1.5f, 1, 0), new Vector3(3, 2, 0))));
        }

        [Test]
        public void A_corner_with_another_normal_or_texture_coordinate_is_a_vertex_of_its_own()
        {
            Mesh mesh =
                Import(
                "v 0 0 0\nv 0 2 0\nv 3 2 0\nv 3 0 0\nvn 0 0 -1\nvn 2 0 0\nvt 0.25 0.5\nvt 1 0\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/2/2\n");
            Assert.That(mesh.vertexCount, Is.EqualTo(4));
            mesh = Import("v 0 0 0\nv 0 2 0\nv 3 2 0\nv 3 0 0\nvn 0 0 -1\nvn 2 0 0\nvt 0.25 0.5\nf 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/2 4/1/2\n");
            Assert.That(mesh.vertexCount, Is.EqualTo(6));
            Assert.That(mesh.normals.Distinct(), Is.EquivalentTo(new[] { Vector3.back, Vector3.left }), "mirrored, and of length 1");
            Assert.That(mesh.uv, Is.EqualTo(Enumerable.Repeat(new Vector2(0.25f, 0.5f), 6)), "as they stand");
            Assert.That(mesh.tangents.Length, Is.EqualTo(6), "there are tangents where there are texture coordinates");
        }

        [Test]
        public void A_polygon_that_crosses_itself_is_discarded_with_unitys_warning()
        {
            LogAssert.Expect(LogType.Warning, "A polygon of Mesh 'default' in Assets/Part.obj is self-intersecting and has been discarded.");
            Mesh mesh = Import(Square + "f 1//1 3//1 2//1 4//1\n");
            Assert.That(mesh.triangles.Length, Is.EqualTo(6));
        }

        [Test]
        public void Settings_scale_it_and_take_or_leave_normals()
        {
            Mesh mesh =
                Import(Square,
                "  animations:\n    isReadable: 1\n  meshes:\n    globalScale: 0.5\n  tangentSpace:\n    normalImportMode: 2\n");
            Assert.That(mesh.bounds.size, Is.EqualTo(new Vector3(1.5f, 1, 0)));
            Assert.That(mesh.normals, Is.Empty);
            Assert.That(Import(Square, "").isReadable, Is.False, "as the editor imports it, unless Read/Write is on");
        }

        [Test]
        public void A_group_names_the_mesh_and_with_it_its_file_id()
        {
            ProjectAssets project = Project("g Wheel\n" + Square);
            Assert.That(project.LoadAsset(Guid, ModelReader.HashedId("Mesh", "Wheel"), typeof(Mesh))?.name, Is.EqualTo("Wheel"));
        }

        [Test]
        public void The_meta_file_may_state_the_file_id()
        {
            const string table =
                "  internalIDToNameTable:\n  - first:\n      43: 4300000\n    second: default\n  meshes:\n    fileIdsGeneration: 1\n";
            Assert.That(Project(Square, table).LoadAsset(Guid, 4300000, typeof(Mesh))?.name, Is.EqualTo("default"));
        }

        [TestCase("f 1//1 2//1 3//1\n", "", "it has 2 groups with faces ('', 'b')", "g b\n")]
        [TestCase("f 1//1 2//1 3//1\n", "", "it has 2 materials ('', 'red')", "usemtl red\n")]
        [TestCase("", "", "belong to the object 'Cube' and to no group", "o Cube\n")]
        [TestCase("", "  meshes:\n    fileIdsGeneration: 1\n", "numbers its parts by an older rule (fileIdsGeneration 1)", "")]
        [TestCase("", "  meshes:\n    keepQuads: 1\n", "ask for Keep Quads", "")]
        [TestCase("", "  meshes:\n    meshCompression: 2\n", "ask for Mesh Compression", "")]
        [TestCase("", "  meshes:\n    weldVertices: 0\n", "ask for Weld Vertices off", "")]
        [TestCase("", "  tangentSpace:\n    normalImportMode: 1\n", "ask for Normals: Calculate", "")]
        public void What_the_host_does_not_do_is_refused_by_name(string facesBefore, string settings, string message, string between)
        {
            string vertices = Square.Substring(0, Square.IndexOf('f')), faces = Square.Substring(Square.IndexOf('f'));
            Assert.That(Refusal(vertices + facesBefore + between + faces, settings),
                Does.StartWith(Path).And.Contains(message).And.Contains("the host does not do that"));
        }

        [TestCase("v 0 0 0\nv 0 2 0\nv 3 2 0\nf 1 2 3\n", "corners without a normal")]
        [TestCase("v 0 0 0\nv 0 2 0\nv 3 2 0\n", "Part.obj has no faces")]
        [TestCase("v 0 0 0\nvn 0 0 1\nf 1//2 1//1 1//1\n", "Part.obj(3): the face refers to normal 2, but 1 come before it")]
        [TestCase("v 0 0 0\nvn 0 0 1\nf 1/1/1 1//1 1//1\n", "the face refers to texture coordinate 1, but 0 come before it")]
        [TestCase("v 0 0 0\nvn 0 0 1\nf 1//1x 1//1 1//1\n", "'1//1x' is not a corner")]
        [TestCase("v 0 0 0\nvn 0 zero 1\nf 1//1 1//1 1//1\n", "Part.obj(2): 'zero' is not a number")]
        [TestCase("", "Part.obj is empty")]
        public void A_broken_file_is_refused_with_its_line(string obj, string message) => Assert.That(Refusal(obj), Does.Contain(message));
    }
}
