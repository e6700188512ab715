using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json.Nodes;
using Host.Assets;
using Host.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Host.Tests
{
    /// <summary><c>rill reference</c>: what it hands to Blender, reads from other programs, and says. None of this needs Blender.</summary>
    public class ReferenceTests
    {
        string folder;

        [SetUp]
        public void CreateFolder() => folder = Directory.CreateTempSubdirectory("rill-reference-").FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        // In a process of its own, as a user would.
        int Rill(string path, out string[] said, params string[] arguments)
        {
            string host = Path.Combine(Path.GetDirectoryName(typeof(Session).Assembly.Location), "Host.dll");
            var start = new ProcessStartInfo("sh", new[] { "-c", "exec dotnet \"$0\" \"$@\" 2>&1", host }.Concat(arguments))
            { RedirectStandardOutput = true };
            if (path != null)
                start.Environment["PATH"] = path;
            using var process = Process.Start(start);
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            TestContext.WriteLine(output);
            said = output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
            return process.ExitCode;
        }

        [TestCase("Dam Break")]
        [TestCase("--board", "sphere")]
        public void Without_Blender_one_line_says_how_to_install_it(params string[] arguments)
        {
            using (ToolPath.Without("blender"))
            {
                int code = Rill(null, out string[] said, new[] { "reference" }.Concat(arguments).Concat(new[] { "--out", folder }).ToArray());
                Assert.That(code, Is.EqualTo(2));
                Assert.That(said, Is.EqualTo(new[] { "rill: the reference is drawn by Blender, which is not installed: " +
                    "apt-get install --no-install-recommends blender" }));
            }
        }

        // A program of Blender's name that gives back our own picture.
        [Test]
        public void A_reference_that_is_our_own_picture_differs_by_nothing()
        {
            string programs = Directory.CreateDirectory(Path.Combine(folder, "programs")).FullName, results = Path.Combine(folder, "results");
            string program = Path.Combine(programs, "blender");
            File.WriteAllText(program, "#!/bin/sh\nfor scene; do :; done\nresults=$(dirname \"$scene\")\ncp \"$scene\" \"$results/seen.json\"\n" +
                "cp \"$results/ours.png\" \"$results/reference.png\"\ncp \"$results/ours.png\" \"$results/mask.png\"\n");
            File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
            int code = Rill(programs + Path.PathSeparator + Environment.GetEnvironmentVariable("PATH"), out _, "reference", "Dam Break",
                "--frame", "2", "--size", "64x36", "--samples", "7", "--seed", "5", "--out", results);
            Assert.That(code, Is.Zero);
            string[] figures = File.ReadAllLines(Path.Combine(results, "figures.txt"));
            Assert.That(figures[0], Does.StartWith("DamBreak, frame 2 at 60 a second, 64 x 36, foam off, commit "));
            Assert.That(figures[1], Does.StartWith("20000 particles, d 0.04 m; index 1.333"));
            Assert.That(figures[2], Does.Contain("0 open edges"));
            Assert.That(figures, Has.Some.StartsWith("Cycles: 7 samples, seed 5"));
            Assert.That(figures, Has.Some.StartsWith("FLIP 0.0000").And.Some.EqualTo("SSIM 1.0000"));
            PngImage beside = PngImage.Read(File.ReadAllBytes(Path.Combine(results, "beside.png")), "beside.png");
            Assert.That((beside.Width, beside.Height), Is.EqualTo((128, 36)));
            for (int i = 0; i < 64 * 36; i++)
                Assert.That(beside.Pixels[i / 64 * 128 + i % 64], Is.EqualTo(beside.Pixels[i / 64 * 128 + 64 + i % 64]));
            CheckScene(JsonNode.Parse(File.ReadAllText(Path.Combine(results, "seen.json"))));
            Assert.That(Directory.GetFiles(results).Select(Path.GetFileName),
                Is.EquivalentTo(new[] { "ours.png", "reference.png", "mask.png", "beside.png", "flip.png", "figures.txt", "seen.json" }));
        }

        static void CheckScene(JsonNode scene)
        {
            Assert.That(((int)scene["width"], (int)scene["height"], (int)scene["samples"], (int)scene["seed"]), Is.EqualTo((64, 36, 7, 5)));
            string[] materials = scene["materials"].AsArray().Select(material => (string)material["name"]).ToArray();
            Assert.That(materials, Is.Unique.And.Contain("water"));
            string[] used = scene["objects"].AsArray().Select(placed => (string)placed["material"]).ToArray();
            Assert.That(used, Is.All.Matches<string>(name => materials.Contains(name)));
            Assert.That(used.Count(name => name == "water"), Is.EqualTo(1));
            Assert.That((string)scene["world"]["sky"], Is.EqualTo("sky.hdr"));
            Assert.That((double)scene["sun"]["irradiance"], Is.GreaterThan(1.0));
        }

        // files of other programs

        static readonly Vector3[] corners = { Vector3.zero, new Vector3(0f, 1.5f, 0f), new Vector3(2f, 0f, -0.25f), new Vector3(2f, 1f, 0f) };

        void Reads(string name, byte[] file)
        {
            string path = Path.Combine(folder, name);
            File.WriteAllBytes(path, file);
            MeshData data = SurfaceFile.Read(path);
            Assert.That(data.Vertices, Is.EqualTo(corners));
            Assert.That(data.Faces, Is.EqualTo(new[] { new[] { 0, 1, 2 }, new[] { 2, 1, 3 } }));
        }

        [Test]
        public void An_OBJ_file_is_read_as_it_is_written()
            => Reads("a.obj", Encoding.ASCII.GetBytes("# s\nv 0 0 0\nv 0 1.5 0\nvn 0 0 1\nv 2 0 -0.25\nv 2 1 0\nf 1 2 3\nf 3//1 -3//1 4//1\n"));

        [Test]
        public void A_PLY_file_of_text_is_read_as_it_is_written()
            => Reads("a.ply", Encoding.ASCII.GetBytes("ply\nformat ascii 1.0\ncomment s\nelement vertex 4\nproperty float x\nproperty float y\n" +
                "property float z\nproperty float nx\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n" +
                "0 0 0 9\n0 1.5 0 9\n2 0 -0.25 9\n2 1 0 9\n3 0 1 2\n3 2 1 3\n"));

        [Test]
        public void A_binary_PLY_file_is_read_as_it_is_written()
        {
            var stream = new MemoryStream();
            stream.Write(Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\n" +
                "property uchar red\nproperty float z\nelement face 2\nproperty list uint8 uint32 vertex_index\nproperty short flags\nend_header\n"));
            using var writer = new BinaryWriter(stream);
            foreach (Vector3 corner in corners)
            {
                writer.Write((double)corner.x);
                writer.Write(corner.y);
                writer.Write((byte)200);
                writer.Write(corner.z);
            }
            foreach (int[] face in new[] { new[] { 0, 1, 2 }, new[] { 2, 1, 3 } })
            {
                writer.Write((byte)3);
                foreach (int corner in face)
                    writer.Write(corner);
                writer.Write((short)-1);
            }
            Reads("a.ply", stream.ToArray());
        }

        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "it has no faces. A mesh is wanted, not the particles.")]
        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "a face names a vertex that is not there.")]
        [TestCase("a.obj", "v 0 x 0\n", "it is damaged")]
        [TestCase("a.ply", "plyx\n", "it does not begin with ply")]
        [TestCase("a.ply", "ply\nformat binary_big_endian 1.0\nend_header\n", "its format is binary_big_endian")]
        [TestCase("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n", "it is damaged")]
        [TestCase("a.obj", "v 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "it is damaged")]
        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "a face names a vertex that is not there.")]
        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a face names a vertex that is not there.")]
        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", "a face names a vertex that is not there.")]
        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999\n", "it is damaged")]
        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n", "a vertex is nowhere")]
        [TestCase("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1e99 0\nf 1 2 3\n", "a vertex is nowhere")]
        [TestCase("a.stl", "solid", "give an .obj or a .ply file.")]
        public void A_surface_that_cannot_be_read_is_told(string name, string text, string reason)
        {
            string path = Path.Combine(folder, name);
            File.WriteAllText(path, text);
            Assert.That(Assert.Throws<HostException>(() => SurfaceFile.Read(path)).Message, Does.StartWith($"--mesh {path}: ").And.Contain(reason));
        }

        const string Ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n" +
            "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

        [TestCase("3 0 1 2", "3 0 1", "it is damaged")]
        [TestCase("3 0 1 2", "-3 0 1 2", "there are -3 of something")]
        [TestCase("3 0 1 2", "2000000000 0 1 2", "there are 2000000000 of something")]
        [TestCase("3 0 1 2", "nan 0 1 2", "there are NaN of something")]
        [TestCase("3 0 1 2", "2 0 1", "a face names a vertex that is not there.")]
        [TestCase("3 0 1 2", "3 0 1 3", "a face names a vertex that is not there.")]
        [TestCase("3 0 1 2", "3 0 1 -1", "a face names a vertex that is not there.")]
        [TestCase("0 1 0\n", "0 one 0\n", "it is damaged")]
        [TestCase("0 1 0\n", "0 nan 0\n", "a vertex is nowhere")]
        [TestCase("0 1 0\n", "0 1e99 0\n", "a vertex is nowhere")]
        [TestCase("element vertex 3", "element vertex -1", "there are -1 of something")]
        [TestCase("element vertex 3", "element vertex three", "it is damaged")]
        [TestCase("element vertex 3", "element vertex 2000000000", "there are 2000000000 of something")]
        [TestCase("element vertex 3", "element vertex 99999999999", "it is damaged")]
        [TestCase("element vertex 3", "element vertex 4", "it is damaged")]
        [TestCase("element face 1", "element face 2", "it is damaged")]
        [TestCase("element face 1", "element face 0", "it has no faces")]
        [TestCase("element vertex 3\n", "", "it is damaged")]
        [TestCase("property list uchar int vertex_indices", "property list uchar int", "it is damaged")]
        [TestCase("end_header\n", "", "it is damaged")]
        public void A_PLY_file_with_one_thing_damaged_is_told(string field, string damaged, string reason)
        {
            Assert.That(Ply, Does.Contain(field));
            A_surface_that_cannot_be_read_is_told("a.ply", Ply.Replace(field, damaged), reason);
        }

        [TestCase("uchar", "word", "a property of the type word")]
        [TestCase("uchar", "int", "it says that there are 50331648 of something")]      // 3 and three bytes of what follows it, in another order
        [TestCase("uchar", "double", "of something")]
        public void A_binary_PLY_file_with_one_thing_damaged_is_told(string type, string damaged, string reason)
        {
            byte[] header = Encoding.ASCII.GetBytes(Ply.Substring(0, Ply.IndexOf("0 0 0\n", StringComparison.Ordinal))
                .Replace("ascii", "binary_little_endian").Replace($"list {type}", $"list {damaged}"));
            var stream = new MemoryStream();
            stream.Write(header);
            using var writer = new BinaryWriter(stream);
            for (int i = 0; i < 9; i++)
                writer.Write(i == 3 || i == 7 ? 1f : 0f);
            foreach (byte value in new byte[] { 0, 0, 0, 3, 0, 0, 0, 255, 0, 0, 0 })
                writer.Write(value);
            string path = Path.Combine(folder, "a.ply");
            File.WriteAllBytes(path, stream.ToArray());
            Assert.That(Assert.Throws<HostException>(() => SurfaceFile.Read(path)).Message, Does.StartWith($"--mesh {path}: ").And.Contain(reason));
        }

        // meshes

        // A cube of Unity's as it is, mirrored, and half as high.
        [TestCase(1f, 1f)]
        [TestCase(-1f, 1f)]
        [TestCase(1f, 0.5f)]
        public void A_solid_keeps_its_outside_and_grows_by_what_is_asked(float x, float y)
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            try
            {
                MeshData mesh = MeshData.Of(cube.GetComponent<MeshFilter>().sharedMesh, 0);
                Assert.That((mesh.Vertices.Count, mesh.Faces.Count), Is.EqualTo((8, 12)));
                MeshData moved = mesh.InWorld(Matrix4x4.TRS(new Vector3(3f, 0f, 0f), Quaternion.identity, new Vector3(x, y, 1f)), 0.01f);
                double volume = 0.0;
                foreach (int[] face in moved.Faces)
                    volume += Vector3.Dot(moved.Vertices[face[0]], Vector3.Cross(moved.Vertices[face[1]], moved.Vertices[face[2]])) / 6.0;
                Assert.That(volume, Is.GreaterThan(y).And.LessThan(1.06 * y));
                Assert.That(moved.Vertices.Max(vertex => vertex.x), Is.InRange(3.502f, 3.51f));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(cube);
            }
        }

        // images

        [Test]
        public void A_particle_at_a_solid_is_mirrored_in_it_and_one_further_away_is_not()
        {
            var solids = new SolidImages(1.0);
            solids.Add(new[] { new double3(0, 0, 0), new double3(0, 0, 10), new double3(10, 0, 0) });
            List<double3> images = solids.Of(new[] { new double3(2, 0.5, 2), new double3(3, 1.1, 3), new double3(-0.3, 0.4, 5) });
            var expected = new[] { new double3(2, -0.5, 2), new double3(0.3, -0.4, 5) };
            Assert.That(images, Is.EqualTo(expected).Using<double3>((a, b) => math.length(a - b) < 1e-12 ? 0 : 1));
        }

        [Test]
        public void The_nearest_point_of_a_triangle_is_nearer_than_all_others()
        {
            var random = new System.Random(2);
            double3 Point() => new double3(random.NextDouble(), random.NextDouble(), random.NextDouble()) * 2.0 - 1.0;
            for (int i = 0; i < 200; i++)
            {
                double3 p = Point(), a = Point(), b = Point(), c = Point(), nearest = SolidImages.Nearest(p, a, b, c);
                double best = double.PositiveInfinity;
                for (int u = 0; u <= 60; u++)
                    for (int v = 0; u + v <= 60; v++)
                        best = Math.Min(best, math.length(a + u / 60.0 * (b - a) + v / 60.0 * (c - a) - p));
                Assert.That(math.length(nearest - p), Is.LessThan(best + 1e-9).And.GreaterThan(best - 0.06));
            }
        }

        // Looks up like Cycles' environment texture: its center is x, a quarter from the left is Unity's z, the top is up.
        [Test]
        public void The_sky_lies_as_Cycles_looks_it_up()
        {
            void Is(Vector3 direction, Vector3 expected) => Assert.That(Vector3.Angle(direction, expected), NUnit.Framework.Is.LessThan(0.4f));
            Is(SkyPicture.DirectionOf(512, 256), Vector3.right);
            Is(SkyPicture.DirectionOf(256, 256), Vector3.forward);
            Is(SkyPicture.DirectionOf(768, 256), Vector3.back);
            Is(SkyPicture.DirectionOf(100, 0), Vector3.up);
        }
    }
}
