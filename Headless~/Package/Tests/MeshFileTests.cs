using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Host.Assets;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Mesh files as triangles in Unity's frame.</summary>
    public class MeshFileTests
    {
        const string CubeVertices = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 3\nv 2 0 3\nv 2 1 3\nv 0 1 3\n";
        const string CubeFaces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

        string folder;

        [SetUp]
        public void Start() => folder = Directory.CreateTempSubdirectory("rill-mesh-file-").FullName;

        [TearDown]
        public void End() => Directory.Delete(folder, recursive: true);

        MeshFile Obj(string text) => MeshFile.Read(Write("Mesh.obj", Encoding.UTF8.GetBytes(text)));

        string Write(string name, byte[] bytes)
        {
            string file = Path.Combine(folder, name);
            File.WriteAllBytes(file, bytes);
            return file;
        }

        static MeshReport Check(MeshFile mesh) => MeshCheck.Run(new TriangleMesh(mesh.Name, mesh.Vertices, mesh.Triangles));

        static void IsTheBox(MeshFile mesh, Vector3 min, Vector3 max)
        {
            MeshReport report = Check(mesh);
            Assert.That((report.Triangles, report.IsWatertight, report.FlippedTriangles), Is.EqualTo((12, true, 0)));
            Vector3 size = max - min;
            Assert.That(report.SignedVolume, Is.EqualTo(size.x * size.y * size.z).Within(1e-5), "positive: faces look outside in Unity's frame");
            for (int axis = 0; axis < 3; axis++)
            {
                Assert.That(mesh.Vertices.Min(v => v[axis]), Is.EqualTo(min[axis]).Within(1e-6));
                Assert.That(mesh.Vertices.Max(v => v[axis]), Is.EqualTo(max[axis]).Within(1e-6));
            }
        }

        [Test]
        public void An_obj_is_mirrored_in_x_and_faces_still_look_outside() => IsTheBox(Obj(CubeVertices + CubeFaces), new Vector3(-2, 0, 0),
            new Vector3(0, 1, 3));

        [TestCase("f -8 -5 -6 -7\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -5 -1 -2 -6\nf -8 -4 -1 -5\nf -7 -6 -2 -3\n",
            TestName = "Corners_count_backwards_from_the_latest")]
        [TestCase("vn 0 0 1\nvt 0 0\nf 1/1 4/1 3/1 2/1\nf 5//1 6//1 7//1 8//1\nf 1/1/1 2/1/1 6/1/1 5/1/1\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n",
            TestName = "Corners_carry_texture_and_normal")]
        [TestCase("# a box\no Box\ng a\nusemtl red\r\ns 1\r\n\tf  1 4 3 \\\r\n 2 # bottom\r\n\r\nf 5 6 7 8\rf 1 2 6 5\nf 4 8 7 3\ng b\nf 1 5 " +
            "8 4\nf 2 3 7 6", TestName = "Comments_groups_line_ends_and_lines_that_go_on")]
        [TestCase("fo 1 4 3 2\nfo 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n", TestName = "Faces_by_their_old_name")]
        [TestCase("f 1 4 3\nf 1 3 2\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 4 8 7\nf 4 7 3\nf 1 5 8\nf 1 8 4\nf 2 3 7\nf 2 7 6\n",
            TestName = "Triangles")]
        public void Every_way_to_write_faces_gives_the_same_mesh(string faces)
        {
            MeshFile expected = Obj(CubeVertices + CubeFaces), mesh = Obj(CubeVertices + faces);
            Assert.That(mesh.Vertices, Is.EqualTo(expected.Vertices));
            Assert.That(mesh.Triangles, Is.EqualTo(expected.Triangles));
        }

        [Test]
        public void Groups_with_faces_are_counted_and_lines_and_points_are_told()
        {
            MeshFile mesh = Obj(CubeVertices + "g empty\ng a\nf 1 4 3 2\nusemtl red\nf 5 6 7 8\nl 1 2 3\nl 4 5\np 1\n");
            Assert.That(mesh.Parts, Is.EqualTo(2));
            Assert.That(mesh.Notes, Is.EqualTo(new[] { "2 lines are left out, the first in line 14.",
                "1 points are left out, the first in line 16." }));
        }

        /// <summary>A polygon in the plane z = 0 and the same at z = 1, joined by quads: what is not cut as its outline says is not closed, or has
        /// more surface.</summary>
        static string Prism(params (double X, double Y)[] outline)
        {
            var text = new StringBuilder();
            foreach (int z in new[] { 0, 1 })
                foreach ((double x, double y) in outline)
                    text.Append(FormattableString.Invariant($"v {x:R} {y:R} {z}\n"));
            int n = outline.Length;
            text.Append("f " + string.Join(" ", Enumerable.Range(1, n).Reverse()) + "\nf " + string.Join(" ", Enumerable.Range(n + 1, n)) + "\n");
            for (int i = 0; i < n; i++)
                text.Append($"f {1 + i} {1 + (i + 1) % n} {1 + n + (i + 1) % n} {1 + n + i}\n");
            return text.ToString();
        }

        static (double X, double Y)[] Outline(string corners) => corners.Split(' ').Select(corner => corner.Split(',').Select(double.Parse).ToArray())
            .Select(p => (p[0], p[1])).ToArray();

        static (double X, double Y)[] Star(int corners, Func<int, double> radius)
            => Enumerable.Range(0, corners).Select(i => (Radius: radius(i), Angle: 2 * Math.PI * i / corners))
            .Select(p => (p.Radius * Math.Cos(p.Angle), p.Radius * Math.Sin(p.Angle))).ToArray();

        static IEnumerable<TestCaseData> Outlines()
        {
            TestCaseData Named(string name, (double X, double Y)[] outline) => new TestCaseData(new object[] { outline }).SetName("{m}_" + name);
            yield return Named("channel", Outline("0,0 4,0 4,3 3,3 3,1 1,1 1,3 0,3"));
            yield return Named("arrow_of_four_corners", Outline("0,0 2,1 0,2 1,1"));
            yield return Named("arrow_that_begins_at_its_notch", Outline("1,1 0,0 2,1 0,2"));
            yield return Named("comb", Outline("0,0 7,0 7,3 6,3 6,1 5,1 5,3 4,3 4,1 3,1 3,3 2,3 2,1 1,1 1,3 0,3"));
            yield return Named("spiral", Outline("0,0 6,0 6,6 1,6 1,2 4,2 4,4 3,4 3,3 2,3 2,5 5,5 5,1 0,1"));
            yield return Named("square_with_corners_along_its_sides", Outline("0,0 1,0 2,0 3,0 3,1 3,2 3,3 2,3 1,3 0,3 0,2 0,1"));
            yield return Named("star", Star(10, i => i % 2 == 0 ? 1 : 0.3));
            yield return Named("outline_of_2000_corners", Star(2000, i => 1 + 0.3 * Math.Sin(40 * 2 * Math.PI * i / 2000)));
            var random = new System.Random(3);
            yield return Named("ragged", Star(60, i => 0.1 + random.NextDouble()));
        }

        [TestCaseSource(nameof(Outlines))]
        public void A_polygon_is_cut_along_its_outline((double X, double Y)[] outline)
        {
            double area = 0, around = 0;
            for (int i = 0; i < outline.Length; i++)
            {
                (double X, double Y) a = outline[i], b = outline[(i + 1) % outline.Length];
                area += 0.5 * (a.X * b.Y - a.Y * b.X);
                around += Math.Sqrt((a.X - b.X) * (a.X - b.X) + (a.Y - b.Y) * (a.Y - b.Y));
            }
            MeshFile mesh = Obj(Prism(outline));
            MeshReport report = Check(mesh);
            Assert.That(mesh.Notes, Is.Empty);
            Assert.That((report.IsWatertight, report.FlippedTriangles, report.ZeroAreaTriangles), Is.EqualTo((true, 0, 0)));
            Assert.That(report.Area, Is.EqualTo(2 * Math.Abs(area) + around).Within(1e-5).Percent, "no sheet across a notch");
            Assert.That(report.SignedVolume, Is.EqualTo(Math.Abs(area)).Within(1e-5).Percent);
        }

        [Test]
        public void A_hole_is_left_open_where_a_cut_leads_to_it()
        {
            // Out along 1 to 4, in to 5, around to 8 and 5, and back to 1.
            MeshFile mesh = Obj("v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nf 1 2 3 4 1 5 6 7 8 5\n");
            MeshReport report = Check(mesh);
            Assert.That((report.Triangles, report.BoundaryEdges, report.Holes, report.NonManifoldEdges), Is.EqualTo((8, 8, 2, 0)));
            Assert.That(report.Area, Is.EqualTo(8).Within(1e-6));
        }

        [Test]
        public void Corners_that_are_named_twice_and_polygons_that_are_not_flat_are_cut()
        {
            Assert.That(Obj(CubeVertices + "f 1 1 4 3 3 2 1\n").Triangles.Length, Is.EqualTo(6));
            Assert.That(Obj(CubeVertices + "f 1 4 3 7 3 2\n").Triangles.Length, Is.EqualTo(6), "there and back again bounds nothing");
            MeshReport bent = Check(Obj("v 0 0 0\nv 4 0 1\nv 4 3 0\nv 3 3 1\nv 3 1 0\nv 1 1 1\nv 1 3 0\nv 0 3 1\nf 1 2 3 4 5 6 7 8\n"));
            Assert.That((bent.Triangles, bent.Holes, bent.BoundaryEdges), Is.EqualTo((6, 1, 8)));
        }

        [Test]
        public void Polygons_that_cross_themselves_are_left_out_by_line()
        {
            MeshFile mesh = Obj(CubeVertices + CubeFaces + "f 1 3 2 4\nf 1 1 2 2\n" + "v 0 1 9\nv 0.6 -0.8 9\nv -1 0.3 9\nv 1 0.3 9\nv -0.6 " +
                "-0.8 9\nf 9 10 11 12 13\n");
            Assert.That(mesh.Triangles.Length, Is.EqualTo(36 + 6));
            Assert.That(mesh.Notes, Is.EqualTo(new[] { "2 polygons that cross themselves are left out, the first in line 15." }));
            Assert.That(Check(mesh).ZeroAreaTriangles, Is.EqualTo(2), "the check tells of a polygon without area");
        }

        [Test]
        public void What_a_file_says_beyond_its_shape_does_no_harm_and_what_it_alone_knows_is_told()
        {
            MeshFile plain = Obj(CubeVertices + CubeFaces);
            string more = CubeVertices.Replace(" 0\n", " 0 1.0\n").Replace(" 3\n", " 3 0.2 0.4 0.6\n") + "s off\nmtllib a.mtl\n" + CubeFaces;
            Assert.That(Obj(more).Vertices, Is.EqualTo(plain.Vertices));
            Assert.That(Obj(more).Notes, Is.Empty);
            Assert.That(Obj(CubeVertices + "face 1 2 3\nF 1 2 3\ncall other.obj\n" + CubeFaces).Notes,
                Is.EqualTo(new[] { "2 lines that no OBJ file has are left out, the first in line 9.",
                "1 calls of other files are left out, the first in line 11." }));
            Assert.That(Obj((CubeVertices + CubeFaces.Replace("4 3", "4 \\\n3")).Replace('\n', '\r')).Triangles, Is.EqualTo(plain.Triangles),
                "lines of old Macs that go on");
        }

        [Test]
        public void Numbers_are_read_in_every_form_of_c()
        {
            Assert.That(Obj("v -1e-3 +.5 3. 1.0 0.5 0.5 0.5\nv nan -inf 1.#IND\n").Vertices[0], Is.EqualTo(new Vector3(1e-3f, 0.5f, 3f)));
            Assert.That(Obj("v nan 0 0\n").Vertices[0].x, Is.NaN);
        }

        [Test]
        public void A_byte_order_mark_is_no_part_of_the_first_line()
            => Assert.That(Obj("\uFEFF" + CubeVertices + CubeFaces).Vertices, Is.EqualTo(Obj(CubeVertices + CubeFaces).Vertices));

        [Test]
        public void Texture_coordinates_and_normals_count_backwards_from_their_own_latest()
        {
            const string text = CubeVertices + "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nf -8/-2/-3 -5/-1/-2 -6/-1/-1\n";
            MeshLooks looks = ObjReader.Read("Mesh", Encoding.UTF8.GetBytes(text), "Mesh.obj", withLooks: true).Looks;
            Assert.That(looks.UvOf, Is.EqualTo(new[] { 0, 1, 1 }));
            Assert.That(looks.NormalOf, Is.EqualTo(new[] { 0, 2, 1 }), "reversed");
        }

        [TestCase("v 0 0 0\nv 1 0 0\nf 1 2\n", "Mesh.obj(3): a face of 2 corners")]
        [TestCase("v 0 0 0\nf 1 2 3\n", "Mesh.obj(2): the face refers to vertex 2, but 1 come before it")]
        [TestCase("v 0 0 0\nf 0 1 1\n", "Mesh.obj(2): the face refers to vertex 0")]
        [TestCase("v 0 0 0\nf -2 1 1\n", "Mesh.obj(2): the face refers to vertex -2")]
        [TestCase("v 0 0 0\n\\\n\nf 1x 1 1\n", "Mesh.obj(4): '1x' is not a corner")]
        [TestCase("v 0 0\n", "Mesh.obj(1): a vertex takes three numbers")]
        [TestCase("v 0 zero 0\n", "Mesh.obj(1): 'zero' is not a number")]
        [TestCase("v 0,5 1 0\n", "Mesh.obj(1): '0,5' is not a number (decimals take a point)")]
        [TestCase("v 0 1 0 red\n", "Mesh.obj(1): 'red' is not a number")]
        [TestCase("PNG and other things\n", "is no OBJ file: no line starts with v or f")]
        [TestCase("", "Mesh.obj is empty")]
        public void A_broken_obj_is_refused_with_its_line(string text, string message)
        {
            Assert.That(Assert.Throws<AssetException>(() => Obj(text)).Message, Does.Contain(message));
        }

        [Test]
        public void What_is_no_mesh_is_refused_by_name()
        {
            Assert.That(Assert.Throws<AssetException>(() => MeshFile.Read(Path.Combine(folder, "None.obj"))).Message,
                Does.EndWith("None.obj does not exist"));
            Assert.That(Assert.Throws<AssetException>(() => MeshFile.Read(folder)).Message, Does.Contain("is a folder"));
            Assert.That(Assert.Throws<AssetException>(() => MeshFile.Read(Write("Mesh.fbx", new byte[9]))).Message,
                Does.Contain("save it as .obj or .glb"));
        }

        // ---- GLB

        static readonly float[] CubePositions = { 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 0, 0, 3, 2, 0, 3, 2, 1, 3, 0, 1, 3 };
        static readonly ushort[] CubeIndices = { 0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 3, 7, 6, 3, 6, 2, 0, 4, 7, 0, 7, 3, 1, 2, 6, 1,
            6, 5 };

        static byte[] Glb(string json, uint version = 2)
        {
            byte[] binary = CubePositions.SelectMany(BitConverter.GetBytes).Concat(CubeIndices.SelectMany(BitConverter.GetBytes)).ToArray();
            byte[] text = Encoding.UTF8.GetBytes(json.Replace('\'', '"'));
            text = text.Concat(Enumerable.Repeat((byte)' ', (4 - text.Length % 4) % 4)).ToArray();
            var file = new List<byte>();
            foreach (uint word in new[] { 0x46546C67u, version, (uint)(28 + text.Length + binary.Length), (uint)text.Length, 0x4E4F534Au })
                file.AddRange(BitConverter.GetBytes(word));
            file.AddRange(text);
            file.AddRange(BitConverter.GetBytes((uint)binary.Length));
            file.AddRange(BitConverter.GetBytes(0x004E4942u));
            file.AddRange(binary);
            return file.ToArray();
        }

        static string Scene(string nodes, string primitive = "'attributes':{'POSITION':0},'indices':1", string more = "") =>
            "{'asset':{'version':'2.0'}," + more + "'scene':0,'scenes':[{'nodes':[0]}],'nodes':[" + nodes + "],'meshes':[{'primitives':[{" +
            primitive + "}]}],"
            + "'accessors':[{'bufferView':0,'componentType':5126,'count':8,'type':'VEC3'},{'bufferView':1,'componentType':5123,'count':36,'type':'SCALAR'}],"
            + "'bufferViews':[{'buffer':0,'byteOffset':0,'byteLength':96},{'buffer':0,'byteOffset':96,'byteLength':72}],'buffers':[{'byteLength':168}]}";

        MeshFile ReadGlb(string json) => MeshFile.Read(Write("Mesh.glb", Glb(json)));

        [Test]
        public void A_glb_is_mirrored_in_x_and_faces_still_look_outside() => IsTheBox(ReadGlb(Scene("{'mesh':0}")), new Vector3(-2, 0, 0),
            new Vector3(0, 1, 3));

        [Test]
        public void Nodes_place_their_meshes()
        {
            // Moved by (10, 0, 0), and below that turned by 90 degrees about y: x to -z, z to x.
            IsTheBox(ReadGlb(Scene("{'translation':[10,0,0],'children':[1]},{'mesh':0,'rotation':[0,0.70710678,0,0.70710678]}")),
            new Vector3(-13, 0, -2), new Vector3(-10, 1, 0));
            IsTheBox(ReadGlb(Scene("{'mesh':0,'matrix':[2,0,0,0, 0,3,0,0, 0,0,1,0, 0,0,5,1]}")), new Vector3(-4, 0, 5), new Vector3(0, 3, 8));
        }

        [Test]
        public void A_node_that_mirrors_keeps_outside_outside() => IsTheBox(ReadGlb(Scene("{'mesh':0,'scale':[1,-1,1]}")), new Vector3(-2, -1, 0),
            new Vector3(0, 0, 3));

        [Test]
        public void A_strip_and_a_fan_have_the_corners_of_their_list()
        {
            string Primitive(int mode) => Scene("{'mesh':0}", "'mode':" + mode + ",'attributes':{'POSITION':0}");
            Assert.That(ReadGlb(Primitive(5)).Triangles.Take(9), Is.EqualTo(new[] { 0, 2, 1, 2, 3, 1, 2, 4, 3 }),
                "every second triangle of a strip is reversed");
            Assert.That(ReadGlb(Primitive(6)).Triangles.Take(6), Is.EqualTo(new[] { 0, 2, 1, 0, 3, 2 }));
            MeshFile lines = ReadGlb(Primitive(1));
            Assert.That((lines.Triangles.Length, lines.Notes.Single()), Is.EqualTo((0, "1 primitives of points or lines are left out.")));
            Assert.That(ReadGlb(Primitive(4)).Notes.Single(), Does.Contain("1 primitives end within a triangle"), "8 corners");
            Assert.That(ReadGlb(Scene("{'mesh':0}").Replace("'scenes':[", "'scenes':[{'nodes':[0]},{},").Replace("'scene':0",
                "'scene':1")).Notes.Single(),
                Does.Contain("2 further scenes are left out"));
        }

        [Test]
        public void A_broken_glb_is_refused_by_what_is_wrong()
        {
            string Refusal(byte[] file) => Assert.Throws<AssetException>(() => MeshFile.Read(Write("Mesh.glb", file))).Message;
            byte[] good = Glb(Scene("{'mesh':0}"));
            Assert.That(Refusal(Encoding.ASCII.GetBytes("solid of some other program")), Does.Contain("does not start with \"glTF\""));
            Assert.That(Refusal(Glb("{}", version: 1)), Does.Contain("is of glTF 1"));
            Assert.That(Refusal(good.Take(good.Length - 10).ToArray()), Does.Contain("it is cut off"));
            Assert.That(Refusal(Glb("{'nodes':")), Does.Contain("is damaged"));
            Assert.That(Refusal(Glb(Scene("{'mesh':7}"))), Does.Contain("is damaged"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0}", "'mode':7,'attributes':{'POSITION':0}"))),
                Does.Contain("mode 7 of a primitive does not exist"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0,'extensions':{'EXT_mesh_gpu_instancing':{}}}"))),
                Does.Contain("repeats node 0 by the glTF extension EXT_mesh_gpu_instancing"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0}").Replace("'count':36", "'count':36,'sparse':{}"))), Does.Contain("has sparse accessors"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0,'children':[0]}"))), Does.Contain("node 0 has two parents"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0}").Replace("'count':36", "'count':37"))), Does.Contain("accessor 1 reaches beyond the end"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0}").Replace("'count':8", "'count':7"))), Does.Contain("an index is not below the 7 vertices"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0}", more: "'extensionsRequired':['KHR_draco_mesh_compression'],"))),
                Does.Contain("KHR_draco_mesh_compression"));
            Assert.That(Refusal(Glb(Scene("{'mesh':0}").Replace("{'byteLength':168}", "{'byteLength':168,'uri':'a.bin'}"))),
                Does.Contain("keeps its vertices in another file"));
        }

        // Positions are accessor 0 of the first view, indices accessor 1 of the second.
        const string PositionView = "{'buffer':0,'byteOffset':0,'byteLength':96}", IndexView = "{'buffer':0,'byteOffset':96,'byteLength':72}";

        [TestCase("'nodes':[0]", "'nodes':[1]", "is damaged")]
        [TestCase("'nodes':[0]", "'nodes':[-1]", "is damaged")]
        [TestCase("'scene':0", "'scene':1", "is damaged")]
        [TestCase("{'mesh':0}", "{'mesh':-1}", "is damaged")]
        [TestCase("{'mesh':0}", "{'mesh':0,'children':[1]}", "is damaged")]
        [TestCase("{'mesh':0}", "{'mesh':0,'matrix':[1,0,0,0]}", "is damaged")]
        [TestCase("{'mesh':0}", "{'mesh':0,'rotation':[0,0,1]}", "is damaged")]
        [TestCase("{'mesh':0}", "{'mesh':0,'scale':[1,1]}", "is damaged")]
        [TestCase("{'mesh':0}", "{'mesh':0,'translation':'far'}", "is damaged")]
        [TestCase("'POSITION':0", "'NORMAL':0", "is damaged")]
        [TestCase("'POSITION':0", "'POSITION':2", "is damaged")]
        [TestCase("'POSITION':0", "'POSITION':1", "accessor 1 is no VEC3")]
        [TestCase("'indices':1", "'indices':0", "accessor 0 is no SCALAR")]
        [TestCase("'indices':1", "'indices':-1", "is damaged")]
        [TestCase("'indices':1", "'mode':-1", "mode -1 of a primitive does not exist")]
        [TestCase("'componentType':5126", "'componentType':5124", "component type 5124 of accessor 0 does not exist")]
        [TestCase("'componentType':5123", "'componentType':5124", "component type 5124 of accessor 1 does not exist")]
        [TestCase("'componentType':5123", "'componentType':5122", "indices of component type 5122 do not exist")]
        [TestCase("'componentType':5123,'count':36", "'componentType':5126,'count':18", "indices of component type 5126 do not exist")]
        [TestCase("'count':8", "'count':9", "accessor 0 reaches beyond the end")]
        [TestCase("'count':8", "'count':-1", "accessor 0 reaches beyond the end")]
        [TestCase("'count':36", "'count':-1", "accessor 1 reaches beyond the end")]
        [TestCase("'count':36", "'count':2147483647", "accessor 1 reaches beyond the end")]
        [TestCase("'count':36", "'count':4294967296", "is damaged")]
        [TestCase("'count':8", "'byteOffset':4,'count':8", "accessor 0 reaches beyond the end")]
        [TestCase("'count':36", "'byteOffset':2,'count':36", "accessor 1 reaches beyond the end")]
        [TestCase("'count':36", "'byteOffset':-2,'count':36", "accessor 1 reaches beyond the end")]
        [TestCase("'bufferView':1,'componentType'", "'bufferView':2,'componentType'", "is damaged")]
        [TestCase("'bufferView':1,'componentType'", "'componentType'", "has sparse accessors")]
        [TestCase(PositionView, "{'buffer':0,'byteOffset':-4,'byteLength':96}", "accessor 0 reaches beyond the end")]
        [TestCase(PositionView, "{'buffer':0,'byteOffset':0,'byteLength':95}", "accessor 0 reaches beyond the end")]
        [TestCase(PositionView, "{'buffer':0,'byteOffset':0,'byteLength':96,'byteStride':11}", "accessor 0 reaches beyond the end")]
        [TestCase(PositionView, "{'buffer':0,'byteOffset':0,'byteLength':96,'byteStride':13}", "accessor 0 reaches beyond the end")]
        [TestCase(PositionView, "{'buffer':1,'byteOffset':0,'byteLength':96}", "keeps its vertices in another file")]
        [TestCase(IndexView, "{'buffer':0,'byteOffset':97,'byteLength':72}", "accessor 1 reaches beyond the end")]
        [TestCase(IndexView, "{'buffer':0,'byteOffset':98,'byteLength':71}", "accessor 1 reaches beyond the end")]
        [TestCase(IndexView, "{'buffer':0,'byteOffset':96,'byteLength':71}", "accessor 1 reaches beyond the end")]
        [TestCase(IndexView, "{'buffer':0,'byteOffset':9223372036854775807,'byteLength':72}", "accessor 1 reaches beyond the end")]
        [TestCase(IndexView, "{'buffer':0,'byteOffset':96}", "is damaged")]
        [TestCase(IndexView, "{'buffer':1,'byteOffset':96,'byteLength':72}", "keeps its vertices in another file")]
        public void A_glb_with_one_number_damaged_is_refused(string field, string damaged, string message)
        {
            string json = Scene("{'mesh':0}");
            Assert.That(json, Does.Contain(field));
            Assert.That(Assert.Throws<AssetException>(() => ReadGlb(json.Replace(field, damaged))).Message, Does.Contain(message));
        }

        // Its length, and what it is.
        [TestCase(12)]
        [TestCase(16)]
        public void A_glb_whose_first_chunk_is_damaged_is_refused(int at)
        {
            byte[] file = Glb(Scene("{'mesh':0}"));
            foreach (uint value in new[] { 0u, 7u, 1u << 31, uint.MaxValue })
            {
                BitConverter.GetBytes(value).CopyTo(file, at);
                Assert.That(Assert.Throws<AssetException>(() => MeshFile.Read(Write("Mesh.glb", file)), $"{value}").Message,
                    Does.Contain("is damaged"));
            }
        }

        // Three vertices, one along each axis, 12 bytes apart.
        [TestCase(5120, true, 127, 1f)]
        [TestCase(5120, true, -128, -1f)]
        [TestCase(5120, false, -3, -3f)]
        [TestCase(5121, true, 51, 0.2f)]
        [TestCase(5121, false, 200, 200f)]
        [TestCase(5122, true, -32768, -1f)]
        [TestCase(5122, true, 32767, 1f)]
        [TestCase(5122, false, -300, -300f)]
        [TestCase(5123, true, 13107, 0.2f)]
        [TestCase(5123, false, 60000, 60000f)]
        public void Positions_of_whole_numbers_are_read_by_their_kind(int kind, bool normalized, int number, float expected)
        {
            string json = Scene("{'mesh':0}", "'attributes':{'POSITION':0}").Replace("'componentType':5126,'count':8",
                $"'componentType':{kind},'normalized':{(normalized ? "true" : "false")},'byteOffset':4,'count':3")
                .Replace(PositionView, "{'buffer':0,'byteOffset':12,'byteLength':40,'byteStride':12}");
            byte[] file = Glb(json);
            int size = kind <= 5121 ? 1 : 2, at = file.Length - 168 + 12 + 4;
            for (int vertex = 0; vertex < 3; vertex++)
                for (int axis = 0; axis < 3; axis++)
                {
                    byte[] bytes = BitConverter.GetBytes(vertex == axis ? number : 0);
                    Array.Copy(bytes, 0, file, at + 12 * vertex + size * axis, size);
                }
            MeshFile mesh = MeshFile.Read(Write("Mesh.glb", file));
            for (int vertex = 0; vertex < 3; vertex++)
                for (int axis = 0; axis < 3; axis++)
                    Assert.That(mesh.Vertices[vertex][axis], Is.EqualTo(vertex != axis ? 0f : axis == 0 ? -expected : expected).Within(1e-6f));
        }

        [TestCase(5121, 1)]
        [TestCase(5123, 2)]
        [TestCase(5125, 4)]
        public void Indices_are_read_by_their_kind(int kind, int size)
        {
            byte[] file = Glb(Scene("{'mesh':0}").Replace("'componentType':5123,'count':36", $"'componentType':{kind},'count':6"));
            int at = file.Length - 72;
            Array.Clear(file, at, 72);
            int[] indices = { 0, 3, 2, 7, 2, 1 };
            for (int i = 0; i < 6; i++)
                file[at + size * i] = (byte)indices[i];
            Assert.That(MeshFile.Read(Write("Mesh.glb", file)).Triangles, Is.EqualTo(new[] { 0, 2, 3, 7, 1, 2 }));
        }

        [Test]
        public void A_skinned_mesh_stays_where_it_is_stored_and_a_file_without_scenes_shows_all_its_nodes()
        {
            MeshFile skinned = ReadGlb(Scene("{'mesh':0,'skin':0,'translation':[9,9,9]}"));
            IsTheBox(skinned, new Vector3(-2, 0, 0), new Vector3(0, 1, 3));
            Assert.That(skinned.Notes.Single(), Does.Contain("1 skinned meshes"));
            string library = Scene("{'translation':[0,0,7],'children':[2]},{'mesh':0},{'mesh':0}").Replace("'scene':0,'scenes':[{'nodes':[0]}],", "");
            MeshFile mesh = ReadGlb(library);
            Assert.That((mesh.Parts, mesh.Vertices.Min(v => v.z), mesh.Vertices.Max(v => v.z)), Is.EqualTo((2, 0f, 10f)));
        }

        // Parent: half a turn about y, twice as large. Child: 1 along x.
        [Test]
        public void A_child_is_placed_in_the_frame_of_its_parent() => IsTheBox(
            ReadGlb(Scene("{'rotation':[0,1,0,0],'scale':[2,2,2],'children':[1]},{'mesh':0,'translation':[1,0,0]}")),
            new Vector3(2, 0, -6), new Vector3(6, 2, 0));
    }
}
