using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Baking;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using Rill.Tests;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using Random = System.Random;

namespace Host.Tests
{
    /// <summary>The command <c>bake</c>, from the mesh's file to the asset's.</summary>
    public class BakeRunTests : AssetFixture
    {
        const int Points = 3000;

        string folder;

        [SetUp]
        public void Start() => folder = Directory.CreateTempSubdirectory("rill-bake-").FullName;

        [TearDown]
        public void End() => Directory.Delete(folder, recursive: true);

        static MeshSdfSettings Settings(int resolution, MeshSdfSign sign = MeshSdfSign.Automatic, SdfFormat format = SdfFormat.Automatic)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            settings.sign = sign;
            settings.format = format;
            return settings;
        }

        BakeRun Bake(string mesh, MeshSdfSettings settings, out string said, float scale = 1f)
        {
            var output = new StringWriter();
            var run = new BakeRun(mesh, Path.Combine(folder, "out"), settings, scale, output);
            run.Read();
            run.Bake((ProjectAssets)Player.Assets, "this device");
            said = output.ToString();
            TestContext.WriteLine(said);
            return run;
        }

        /// <summary>The written file, as a project that it was copied into has it.</summary>
        SignedDistanceField Load(BakeRun run)
        {
            string script = ((ProjectAssets)Player.Assets).Index.Entries.Single(entry => entry.Extension == ".cs"
                && entry.Name == nameof(SignedDistanceField)).Guid;
            TemporaryProject copy = Temporary().Write("Assets/Scripts/SignedDistanceField.cs",
                "namespace Rill { class SignedDistanceField {} }", script);
            copy.Write("Assets/Baked.asset", File.ReadAllText(run.AssetFile), "e0000000000000000000000000000088");
            ProjectAssets project = ProjectAssets.Open(copy.Root, new[] { typeof(SignedDistanceField).Assembly, typeof(AssetFixture).Assembly });
            Play(project, copy.Root);
            return project.LoadAtPath<SignedDistanceField>("Assets/Baked.asset");
        }

        /// <summary>Against all triangles one after the other, at the centers of voxels drawn at random.</summary>
        static (double Near, double Mean, double Most, double WrongSigns) Errors(SignedDistanceField field, TriangleMesh mesh, int points = Points)
        {
            var random = new Random(5);
            double near = 0, sum = 0, most = 0;
            int signs = 0, wrong = 0;
            Vector3Int n = field.Resolution;
            for (int i = 0; i < points; i++)
            {
                double3 p = (double3)(float3)field.Bounds.min
                    + (double)field.VoxelSize * (new double3(random.Next(n.x), random.Next(n.y), random.Next(n.z)) + 0.5);
                Assert.That(field.TrySample((float3)p, out float distance));
                double expected = MeshDistance.Unsigned(mesh, p) / field.VoxelSize, found = distance / (double)field.VoxelSize;
                bool isShell = field.Sign == MeshSdfSign.OpenShell;
                double error = isShell ? Math.Abs(found + 0.5 * field.ShellThickness / field.VoxelSize - expected)
                    : Math.Abs(Math.Abs(found) - expected);
                sum += error;
                most = Math.Max(most, error);
                if (expected <= 2)
                    near = Math.Max(near, error);
                if (isShell || expected <= 1)
                    continue;
                signs++;
                wrong += MeshDistance.Winding(mesh, p) > 0.5 != distance < 0f ? 1 : 0;
            }
            (double, double, double, double) errors = (near, sum / points, most, wrong / (double)Math.Max(signs, 1));
            TestContext.WriteLine($"near {near:E1}, mean {sum / points:E1}, most {most:E1} voxel, signs wrong {wrong} of {signs}");
            return errors;
        }

        static void Holds((double Near, double Mean, double Most, double WrongSigns) errors, double wrongSigns)
        {
            // Exact to 1e-3 and stored to another 1e-3.
            Assert.That(errors.Near, Is.LessThan(2e-3), "within two voxels of the surface, voxel");
            Assert.That(errors.Mean, Is.LessThan(0.05), "mean, voxel");
            Assert.That(errors.Most, Is.LessThan(0.5), "anywhere, voxel");
            Assert.That(errors.WrongSigns, Is.AtMost(wrongSigns), "fraction of wrong signs beyond a voxel");
        }

        [Test]
        public void Stanfords_bunny_is_right_everywhere() => WithDevice(() =>
        {
            BakeRun run = Bake(NpmMeshes.Bunny(folder), Settings(56), out string said);
            Assert.That(said, Does.Contain("3,674 triangles").And.Contain("check: watertight").And.Contain(
                "sign by winding number").And.Contain("on this device"));
            Holds(Errors(Load(run), run.Mesh), wrongSigns: 0);
        });

        // Not watertight, with edges of more than two triangles and parts thinner than a voxel.
        [Test]
        public void Stanfords_dragon_is_right_everywhere() => WithDevice(() =>
        {
            BakeRun run = Bake(NpmMeshes.Dragon(folder, coarsest: true), Settings(64), out string said);
            Assert.That(said, Does.Contain("11,102 triangles").And.Contain("sign by winding number"));
            Holds(Errors(Load(run), run.Mesh, 1000), wrongSigns: 0.001);
        });

        [Test]
        public void The_bunnys_open_base_is_closed_by_the_winding_number() => WithDevice(() =>
        {
            BakeRun run = Bake(NpmMeshes.OpenBunny(folder, height: 0.2f), Settings(48, format: SdfFormat.Float), out string said);
            Assert.That(said, Does.Contain("check: not watertight").And.Contain("closed smoothly").And.Contain(
                "sign by winding number").And.Contain("32 bits a voxel"));
            Holds(Errors(Load(run), run.Mesh), wrongSigns: 0.001);
        });

        [TestCase(MeshSdfSign.Automatic, "sign by open shell")]
        [TestCase(MeshSdfSign.WindingNumber, "sign by winding number")]
        public void Utahs_teapot_with_its_open_rims_is_a_shell_or_a_solid(MeshSdfSign sign, string expected) => WithDevice(() =>
        {
            BakeRun run = Bake(NpmMeshes.Teapot(folder), Settings(56, sign), out string said);
            Assert.That(said, Does.Contain("baked as an open shell").And.Contain(expected));
            Holds(Errors(Load(run), run.Mesh), wrongSigns: 0.001);
        });

        string Box(float x, float y, float z)
        {
            string file = Path.Combine(folder, "Box.obj");
            File.WriteAllText(file, FormattableString.Invariant(
                $"v 0 0 0\nv {x} 0 0\nv {x} {y} 0\nv 0 {y} 0\nv 0 0 {z}\nv {x} 0 {z}\nv {x} {y} {z}\nv 0 {y} {z}\n")
                + "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n");
            return file;
        }

        [Test]
        public void The_asset_keeps_its_guid_when_baked_again_and_knows_its_meshs() => WithDevice(() =>
        {
            string mesh = Box(1, 2, 3), source = "0123456789abcdef0123456789abcdef";
            File.WriteAllText(mesh + ".meta", $"fileFormatVersion: 2\nguid: {source}\nModelImporter:\n");
            string Meta(BakeRun run) => File.ReadAllText(run.AssetFile + ".meta");
            string first = Meta(Bake(mesh, Settings(12), out _));
            BakeRun again = Bake(mesh, Settings(16), out _, scale: 0.5f);
            Assert.That(Meta(again), Is.EqualTo(first));
            SignedDistanceField field = Load(again);
            Assert.That((field.SourceMesh, field.Resolution.z, field.name), Is.EqualTo((source, 16, "Box")));
            Assert.That((Vector3)field.Bounds.center, Is.EqualTo(new Vector3(-0.25f, 0.5f, 0.75f)), "mirrored and scaled");
            Assert.That(field.TrySample(new Vector3(-0.25f, 0.5f, 0.75f), out float center) && center < 0f, "the box's center is inside");
        });

        [Test]
        public void What_is_lost_is_told_with_the_option_that_is_its_remedy() => WithDevice(() =>
        {
            string mesh = Box(1, 1, 0.01f);
            File.AppendAllText(mesh, "v 80 0 0\nv 80.001 0 0\nv 80 0.001 0\nf 9 10 11\n");
            MeshSdfSettings settings = Settings(24);
            Bake(mesh, settings, out string said);
            Assert.That(said, Does.Contain("WARNING: 1 triangles far from the rest, at (-80, 0, 0) m, make the box").And.Contain("(--leave-out-far)"));
            settings.leaveOutFar = true;
            BakeRun run = Bake(mesh, settings, out said);
            Assert.That(said, Does.Contain("1 triangles far from the rest, at (-80, 0, 0) m, are left out").And.Contain(
                "WARNING: The mesh, (1, 1, 0.01) m large, around (-0.5, 0.5, 0.005) m, is thinner than a voxel, 0.01 m for 0.0556 m")
                .And.Contain("Use voxels of at most 0.005 m. (--voxel 0.005)"));
            Assert.That(Load(run).Settings.leaveOutFar, "for a bake in place");
        });

        [Test]
        public void Slices_show_inside_outside_and_the_line_between() => WithDevice(() =>
        {
            BakeRun run = Bake(Box(1, 2, 3), Settings(20), out string said);
            Assert.That(said, Does.Contain(run.SlicesFile));
            Color32[] pixels = PngImage.Read(File.ReadAllBytes(run.SlicesFile), run.SlicesFile).Pixels;
            Assert.That(pixels.Count(p => p.b > p.r + 30), Is.GreaterThan(5000), "blue: inside");
            Assert.That(pixels.Count(p => p.r > p.b + 30), Is.GreaterThan(20000), "orange: outside");
            Assert.That(pixels.Count(p => p.r + p.g + p.b < 60), Is.GreaterThan(500), "black: the zero line and the labels");
        });

        [Test]
        public void A_slice_lies_as_its_axes_say() => WithDevice(() =>
        {
            var box = new BakeRun(Box(1, 2, 3), folder, Settings(20), 1f, TextWriter.Null);
            box.Read();
            SdfBake bake = MeshSdfBaker.Bake(box.Mesh, Settings(20));
            Vector3Int n = bake.Resolution;
            SdfVolume volume = SdfVolume.Of(bake);
            float[,] x = SdfSlice.Across(0).Values(volume, 2), y = SdfSlice.Across(1).Values(volume, 6), z = SdfSlice.Across(2).Values(volume, 17);
            int At(int i, int j, int k) => (k * n.y + j) * n.x + i;
            for (int i = 0; i < bake.Distances.Length; i++)
            {
                (int a, int b, int c) = (i % n.x, i / n.x % n.y, i / n.x / n.y);
                Assert.That((x[b, c], y[c, a], z[b, a]),
                    Is.EqualTo((bake.Distances[At(2, b, c)], bake.Distances[At(a, 6, c)], bake.Distances[At(a, b, 17)])));
            }
        });

        [Test]
        public void The_zero_line_of_a_circle_is_closed_and_round()
        {
            var values = new float[24, 30];
            for (int y = 0; y < 24; y++)
                for (int x = 0; x < 30; x++)
                    values[y, x] = Mathf.Sqrt((x - 14.3f) * (x - 14.3f) + (y - 11.6f) * (y - 11.6f)) - 8f;
            List<(Vector2 From, Vector2 To)> pieces = ZeroLine.Of(values);
            List<Vector2> ends = pieces.SelectMany(piece => new[] { piece.From, piece.To }).ToList();
            Assert.That(ends.Select(p => (p - new Vector2(14.3f, 11.6f)).magnitude), Is.All.EqualTo(8f).Within(0.03f));
            Assert.That(ends.GroupBy(p => (Mathf.Round(p.x * 1000), Mathf.Round(p.y * 1000))).Select(end => end.Count()), Is.All.EqualTo(2),
                "each end is the next piece's start");
        }

        [Test]
        public void The_zero_line_of_a_saddle_goes_around_the_corners_that_its_middle_cuts_off()
        {
            List<(Vector2 From, Vector2 To)> pieces = ZeroLine.Of(new[,] { { -1f, 0.5f }, { 0.5f, -1f } });
            Assert.That(pieces.Select(piece => (piece.From + piece.To) / 2).Any(p => p.x > 0.6f && p.y < 0.4f),
                "the center is negative: the line goes around the positive corner at (1, 0)");
            Assert.That(pieces.Count, Is.EqualTo(2));
        }

        [Test]
        public void What_cannot_be_baked_is_refused_with_limit_and_remedy() => WithDevice(() =>
        {
            string Refusal(string mesh, MeshSdfSettings settings) => Assert.Throws<HostException>(() => Bake(mesh, settings, out _)).Message;
            MeshSdfSettings capped = Settings(400);
            capped.memoryCap = 64;
            Assert.That(Refusal(Box(1, 2, 3), capped), Does.Contain("more than the memory cap of 64 MiB").And.Contain("raise the cap"));
            Assert.That(Refusal(Box(1, 2, 3), Settings(2)), Does.Contain("Resolution 2 is outside 8 to 1024"));
            Assert.That(Refusal(Box(0, 0, 0), Settings(16)), Does.Contain("none of its 12 triangles has an area"));
            string points = Path.Combine(folder, "Points.obj");
            File.WriteAllText(points, "v 0 0 0\n");
            Assert.That(Refusal(points, Settings(16)), Does.Contain("'Points' has no triangles"));
            Assert.That(Directory.Exists(Path.Combine(folder, "out")), Is.False, "nothing was written");
        });

        [TestCase("67108864", 64)]
        [TestCase("512M", 512)]
        [TestCase("1.5g", 1536)]
        public void Memory_is_given_in_bytes_or_larger_units(string text, int mebi) => Assert.That(BakeCommand.MebiBytes(text), Is.EqualTo(mebi));

        [TestCase("much", "give bytes")]
        [TestCase("-1", "give bytes")]
        [TestCase("1000", "the least is 1M")]
        public void Memory_that_is_none_is_refused(string text, string message)
            => Assert.That(Assert.Throws<HostException>(() => BakeCommand.MebiBytes(text)).Message, Does.Contain(message));

        [Test]
        public void Choices_are_written_with_hyphens_and_others_are_refused_with_the_list()
        {
            Assert.That(BakeCommand.Choice<MeshSdfSign>("open-shell", "--sign"), Is.EqualTo(MeshSdfSign.OpenShell));
            Assert.That(Assert.Throws<HostException>(() => BakeCommand.Choice<MeshSdfSign>("rays", "--sign")).Message,
                Is.EqualTo("--sign rays: it is one of automatic, winding-number, open-shell."));
        }
    }
}
