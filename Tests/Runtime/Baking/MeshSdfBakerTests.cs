using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    public class MeshSdfBakerTests
    {
        // The bars, voxels.
        const double Band = 1e-3, Beyond = 0.5, BeyondMean = 0.05;

        static MeshSdfSettings Settings(int resolution, MeshSdfSign sign = MeshSdfSign.Automatic)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            settings.sign = sign;
            return settings;
        }

        /// <summary>Triangles anywhere in the unit cube: large ones, or needles of which most are thousands of times longer than wide.</summary>
        static TriangleMesh Soup(int count, bool needles)
        {
            var random = new Unity.Mathematics.Random(7);
            var vertices = new Vector3[3 * count];
            for (int i = 0; i < vertices.Length; i++)
                vertices[i] = needles && i % 3 == 2 ? Vector3.Lerp(vertices[i - 1], vertices[i - 2], random.NextFloat())
                    + 1e-4f * random.NextFloat() * (Vector3)random.NextFloat3Direction()
                    : (Vector3)random.NextFloat3();
            return new TriangleMesh("Soup", vertices, Enumerable.Range(0, vertices.Length).ToArray());
        }

        /// <summary>Triangles smaller than a voxel, far from each other.</summary>
        static TriangleMesh SmallParts()
        {
            TriangleMesh soup = Soup(30, needles: false);
            for (int i = 0; i < soup.Vertices.Length; i++)
                soup.Vertices[i] = Vector3.Lerp(soup.Vertices[i - i % 3], soup.Vertices[i], 0.02f);
            return soup;
        }

        /// <summary>Some four hundred voxels long and two wide, through the centers of voxels.</summary>
        static TriangleMesh Slivers()
        {
            var random = new Unity.Mathematics.Random(3);
            var vertices = new Vector3[18];
            for (int i = 0; i < vertices.Length; i++)
                vertices[i] = new Vector3(new[] { 0f, 1f, 0.4f }[i % 3], 0.02f * random.NextFloat(), 0.005f * random.NextFloat());
            return new TriangleMesh("Slivers", vertices, Enumerable.Range(0, vertices.Length).ToArray());
        }

        static TriangleMesh Shape(string name)
        {
            switch (name)
            {
                case "sphere": return TestMeshes.Sphere(0.7f, 18, new Vector3(100f, -20f, 3f));
                case "torus": return TestMeshes.Torus(1f, 0.35f, 20);
                case "box": return TestMeshes.Box(new Vector3(1f, 2f, 3f));
                case "soup": return Soup(40, needles: false);
                case "needles": return Soup(60, needles: true);
                case "slivers": return Slivers();
                case "small parts": return SmallParts();
                default: return TestMeshes.Sheet(2f);
            }
        }

        [Test]
        public void A_part_that_is_inside_out_beside_another_is_solid_all_the_same([Values(false, true)] bool isLarger)
        {
            TriangleMesh large = TestMeshes.Box(2f * Vector3.one), small = TestMeshes.Box(Vector3.one, 3f * Vector3.right);
            TriangleMesh two = TriangleMesh.Combine("Two", new[] { large.Turned(t => isLarger), small.Turned(t => !isLarger) });
            SignedDistanceField field = SignedDistanceField.Create(MeshSdfBaker.Bake(two, Settings(24)));
            int SideOf(float x) => field.TrySample(x * Vector3.right, out float distance) ? Math.Sign(distance) : 0;
            Assert.That((SideOf(0f), SideOf(3f), SideOf(1.75f)), Is.EqualTo((-1, -1, 1)));
            UnityEngine.Object.DestroyImmediate(field.Texture);
            UnityEngine.Object.DestroyImmediate(field);
        }

        static void HoldsTheBars(string what, BakeError error)
        {
            TestContext.WriteLine($"{what}: {error}");
            Assert.That(error.BandVoxels, Is.GreaterThan(100), what);
            Assert.That(error.BeyondVoxels, Is.GreaterThan(100), what);
            Assert.That(error.Band, Is.LessThanOrEqualTo(Band), $"{what}: {error}");
            Assert.That(error.Beyond, Is.LessThanOrEqualTo(Beyond), $"{what}: {error}");
            Assert.That(error.BeyondMean, Is.LessThanOrEqualTo(BeyondMean), $"{what}: {error}");
        }

        [TestCase("sphere", 32, 13)]
        [TestCase("torus", 40, 13)]
        [TestCase("box", 40, 1)]
        [TestCase("soup", 40, 1)]
        [TestCase("needles", 40, 1)]
        [TestCase("slivers", 400, 1)]
        [TestCase("small parts", 48, 1)]
        public void Distances_are_those_to_the_nearest_of_all_triangles(string shape, int resolution, int every)
        {
            TriangleMesh mesh = Shape(shape);
            SdfBake bake = MeshSdfBaker.Bake(mesh, Settings(resolution, MeshSdfSign.WindingNumber));
            HoldsTheBars(shape, BakeError.OfTriangles(bake, mesh, every, signs: false));
        }

        // Before the flood, which hides what is missing: it finds most of that as well.
        [TestCase("soup", 40)]
        [TestCase("needles", 40)]
        [TestCase("slivers", 200)]
        [TestCase("small parts", 48)]
        [TestCase("sheets", 48)]
        public void Every_voxel_within_two_of_a_triangle_is_found_near_it_and_no_other(string shape, int resolution)
        {
            TriangleMesh mesh = shape == "sheets" ? Sheets() : Shape(shape);
            var triangles = new BakedTriangles(mesh);
            var grid = new SdfGrid(triangles.Bounds, Settings(resolution), isShell: shape == "sheets");
            var geometry = new BakeGeometry(mesh, TriangleOrder.Of(triangles), null, grid, turnAll: false);
            uint[] found;
            using (var passes = new MeshSdfPasses(geometry, grid))
            {
                passes.Gather(0, geometry.TriangleCount);
                passes.Clear();
                passes.SplatDistances(0, geometry.TriangleCount);
                foreach (BakeGeometry.Slice slice in geometry.Slices(1 << 19))
                    passes.SplatDistances(slice);
                found = GpuTest.Read<uint>(passes.Distances, (int)grid.VoxelCount);
            }
            int near = 0;
            double worst = 0;
            for (int i = 0; i < found.Length; i++)
            {
                int3 at = new int3(i % grid.Resolution.x, i / grid.Resolution.x % grid.Resolution.y, i / grid.Resolution.x / grid.Resolution.y);
                double exact = MeshDistance.Unsigned(mesh, (double3)grid.Min + (double)grid.VoxelSize * ((double3)at + 0.5)) / grid.VoxelSize;
                bool isFound = found[i] != MeshSdfPasses.None;
                if (Math.Abs(exact - 2.0) > Band)
                    Assert.That(isFound, Is.EqualTo(exact < 2.0), $"voxel {at}, {exact} from the nearest triangle");
                if (!isFound)
                    continue;
                near++;
                worst = Math.Max(worst, Math.Abs(Math.Sqrt(math.asfloat(found[i])) - exact));
            }
            TestContext.WriteLine(
                $"{near} of {found.Length} voxels, {geometry.Large.Length} of {geometry.TriangleCount} triangles are large, {worst:E1} off");
            Assert.That(worst, Is.LessThanOrEqualTo(Band));
            Assert.That(near, Is.InRange(300, found.Length - 300));
            Assert.That(geometry.Large.Length, shape == "small parts" ? Is.Zero : Is.GreaterThan(0));
        }

        // Open, large and across the diagonal of the bricks, each a little further on than the last: some bricks touch them with a corner alone.
        static TriangleMesh Sheets()
        {
            TriangleMesh sheet = TestMeshes.Sheet(0.5f);
            return TriangleMesh.Combine("Sheets",
                Enumerable.Range(0, 9).Select(i => sheet.Transformed(Matrix4x4.TRS(0.21f * i * Vector3.one.normalized,
                Quaternion.FromToRotation(Vector3.up, Vector3.one), Vector3.one))).ToArray());
        }

        // Flat faces lie inside of the round shape: what the mesh itself is off by comes on top.
        [Test]
        public void A_sphere_has_the_distances_of_a_sphere()
        {
            const int rings = 36;
            SdfBake bake = MeshSdfBaker.Bake(TestMeshes.Sphere(1f, rings), Settings(32));
            double meshing = 1 - Math.Pow(Math.Cos(Math.PI / (2 * rings)), 2);
            HoldsTheBars("sphere", Analytic(bake, meshing, p => math.length(p) - 1));
        }

        [Test]
        public void A_torus_has_the_distances_of_a_torus()
        {
            const int rings = 36;
            SdfBake bake = MeshSdfBaker.Bake(TestMeshes.Torus(1f, 0.4f, rings), Settings(40));
            double meshing = 0.4 * (1 - Math.Cos(Math.PI / rings)) + 1.4 * (1 - Math.Cos(Math.PI / (2 * rings)));
            HoldsTheBars("torus", Analytic(bake, meshing, p => math.length(new double2(math.length(p.xz) - 1, p.y)) - 0.4));
        }

        [Test]
        public void A_box_has_the_distances_of_a_box()
        {
            SdfBake bake = MeshSdfBaker.Bake(TestMeshes.Box(new Vector3(1f, 2f, 3f)), Settings(40));
            HoldsTheBars("box", Analytic(bake, 0, p =>
            {
                double3 outside = math.abs(p) - new double3(0.5, 1, 1.5);
                return math.length(math.max(outside, 0)) + math.min(math.cmax(outside), 0);
            }));
        }

        static BakeError Analytic(SdfBake bake, double meshing, Func<double3, double> signed)
        {
            int index = 0, wrong = 0;
            BakeError error = BakeError.Of(bake, 1, p =>
            {
                double exact = Math.Abs(signed(p)), baked = Math.Abs(bake.Distances[index]);
                wrong += exact > bake.VoxelSize && signed(p) < 0 != bake.Distances[index] < 0 ? 1 : 0;
                index++;
                return Math.Abs(baked - exact) <= meshing ? baked : exact + meshing * Math.Sign(baked - exact);
            }, null);
            Assert.That(wrong, Is.EqualTo(0), "voxels on the wrong side");
            return error;
        }

        [TestCase("sphere", 24, 5)]
        [TestCase("torus", 32, 5)]
        [TestCase("box", 32, 1)]
        public void Watertight_meshes_have_every_sign_right_beyond_a_voxel(string shape, int resolution, int every)
        {
            TriangleMesh mesh = Shape(shape);
            Assert.That(MeshCheck.Run(mesh).IsWatertight);
            BakeError error = BakeError.OfTriangles(MeshSdfBaker.Bake(mesh, Settings(resolution)), mesh, every);
            Assert.That(error.Signs, Is.GreaterThan(1000));
            Assert.That(error.WrongSigns, Is.EqualTo(0), error.ToString());
        }

        [Test]
        public void Parts_that_overlap_are_inside_and_a_cavity_is_outside()
        {
            TriangleMesh cavity = TestMeshes.Sphere(0.5f, 12, new Vector3(-1f, 0f, 0f)).Turned(t => true);
            TriangleMesh mesh = TriangleMesh.Combine("Parts", new[]
            {
                TestMeshes.Sphere(1f, 16, new Vector3(-1f, 0f, 0f)), cavity, TestMeshes.Box(Vector3.one, new Vector3(0.2f, 0f, 0f)),
            });
            SignedDistanceField field = SignedDistanceField.Create(MeshSdfBaker.Bake(mesh, Settings(40)));
            Assert.That(Sample(field, new float3(-1f, 0f, 0f)), Is.GreaterThan(0.3f), "in the cavity");
            Assert.That(Sample(field, new float3(-1.75f, 0f, 0f)), Is.LessThan(-0.1f), "in the wall of the sphere");
            Assert.That(Sample(field, new float3(-0.15f, 0.1f, 0.1f)), Is.LessThan(0f), "where sphere and box overlap");
            Assert.That(Sample(field, new float3(0.5f, 0f, 0f)), Is.LessThan(-0.1f), "in the box");
            Destroy(field);
        }

        [TestCase("sphere with small holes")]
        [TestCase("torus with small holes")]
        [TestCase("sphere without a cap")]
        [TestCase("half a sphere")]
        [TestCase("tube")]
        public void Meshes_with_holes_have_the_sign_of_the_winding_number(string shape)
        {
            TriangleMesh sphere = TestMeshes.Sphere(1f, 16), torus = TestMeshes.Torus(1f, 0.4f, 16);
            TriangleMesh mesh =
                shape == "sphere with small holes" ? sphere.Without(t => t % 11 == 0)
                : shape == "torus with small holes" ? torus.Without(t => t % 7 == 0)
                : shape == "sphere without a cap" ? sphere.Without(t => sphere.CenterOf(t).y < -0.6f)
                : shape == "half a sphere" ? sphere.Without(t => sphere.CenterOf(t).y < 0f)
                : TestMeshes.Tube(1f, 2f, 24, 4);
            BakeError error = BakeError.OfTriangles(MeshSdfBaker.Bake(mesh, Settings(32, MeshSdfSign.WindingNumber)), mesh, 5);
            Assert.That(error.Signs, Is.GreaterThan(2000));
            Assert.That(error.WrongSigns, Is.LessThanOrEqualTo(error.Signs / 1000), error.ToString());
        }

        // The result for a brick's center has to hold in its corners. Two surfaces of which that is least true: a stack
        // of small triangles, seen from its side, where the winding number is 0 however large it is a little further on; and
        // sheets above one another with a hole through all of them, about whose center it is the same.
        [TestCase(200, 0f, 4.8f, 30f)]
        [TestCase(8, 7f, 0f, 0f)]
        public void No_voxel_of_a_brick_beside_open_sheets_is_on_another_side_than_the_winding_number_says(int layers, float hole,
            float away, float aslant)
        {
            int inside = 0, most = 0;
            foreach (int corner in new[] { 0, 3, 5 })
                foreach (float facing in new[] { -1f, 1f })
                {
                    float3 diagonal = math.normalize(new float3(corner & 1, corner >> 1 & 1, corner >> 2) - 0.5f),
                        aside = math.normalize(math.cross(diagonal, new float3(0.3f, 1f, 0.1f)));
                    math.sincos(math.radians(aslant), out float sin, out float cos);
                    float3 center = 18f, at = center + away * (cos * diagonal + sin * aside), normal = hole > 0f ? diagonal
                        : cos * aside - sin * diagonal;
                    TriangleMesh sheet = hole > 0f ? Washer(hole, 15f) : Washer(0f, 0.8f);
                    Quaternion turn = Quaternion.FromToRotation(Vector3.up, facing * normal);
                    TriangleMesh mesh = TriangleMesh.Combine("Stack",
                        Enumerable.Range(0, layers)
                        .Select(i => sheet.Transformed(Matrix4x4.TRS(at + 0.001f * (i - 0.5f * layers) * normal, turn, Vector3.one)))
                        .Append(Corners(40f)).ToArray());
                    MeshSdfSettings settings = Settings(8, MeshSdfSign.WindingNumber);
                    settings.voxelSize = 1f;
                    settings.padding = 1;
                    SdfBake bake = MeshSdfBaker.Bake(mesh, settings);
                    Assert.That((float3)bake.Bounds.min, Is.EqualTo(float3.zero), "bricks are where they are meant to be");
                    bool isTurned = new MeshEdges(new BakedTriangles(mesh)).SignedVolume < 0;

                    int here = 0;
                    for (int i = 0; i < 64; i++)
                    {
                        int3 voxel = (int3)center - 2 + new int3(i % 4, i / 4 % 4, i / 16);
                        double winding = MeshDistance.Winding(mesh, (float3)voxel + 0.5f) * (isTurned ? -1 : 1);
                        here += winding > 0.5 ? 1 : 0;
                        if (Math.Abs(winding - 0.5) > 0.1)
                            Assert.That(bake.Distances[(voxel.z * bake.Resolution.y + voxel.y) * bake.Resolution.x + voxel.x] < 0,
                                Is.EqualTo(winding > 0.5),
                                $"voxel {voxel}, winding number {winding}, in its center {MeshDistance.Winding(mesh, center)}");
                    }
                    inside += here;
                    most = Math.Max(most, here);
                }
            TestContext.WriteLine($"{inside} voxels inside, at most {most} of a brick");
            Assert.That(most, Is.InRange(1, 63), "some bricks have both sides");
        }

        // Up to half the way to the surface the center speaks for a brick, as long as the winding number is nearly whole there.
        [TestCase("half a sphere")]
        [TestCase("tube")]
        [TestCase("sphere without a triangle")]
        public void Bricks_of_an_open_mesh_are_told_as_a_whole_up_to_half_the_way_to_it_and_no_further(string shape)
        {
            const double corner = 2.598;        // from a brick's center to its last voxel
            TriangleMesh sphere = TestMeshes.Sphere(1f, 12), mesh = shape == "tube" ? TestMeshes.Tube(1f, 2f, 20, 2)
            : shape == "half a sphere" ? sphere.Without(t => sphere.CenterOf(t).y < 0f) : sphere.Without(t => t == 200);
            MeshSdfSettings settings = Settings(56, MeshSdfSign.WindingNumber);
            settings.padding = 12;
            var triangles = new BakedTriangles(mesh);
            var grid = new SdfGrid(triangles.Bounds, settings, isShell: false);
            int3 bricks = (grid.Resolution + 3) / 4;
            uint[] sides;
            using (var baker = new MeshSdfBaker(mesh, settings))
            {
                while (baker.Stage != "Inside and outside")
                    baker.Step();
                for (int level = 0; level < baker.Passes.LevelCount; level++)      // and the sides after the last of them
                    baker.Step();
                sides = GpuTest.Read<uint>(baker.Passes.Sides, bricks.x * bricks.y * bricks.z);
            }
            bool isTurned = new MeshEdges(triangles).SignedVolume < 0;
            var told = new int[3];
            int near = 0;
            for (int i = 0; i < sides.Length; i++)
            {
                double3 center = 4 * new double3(i % bricks.x, i / bricks.x % bricks.y, i / bricks.x / bricks.y) + 2,
                    position = (double3)grid.Min + (double)grid.VoxelSize * center;
                double distance = MeshDistance.Unsigned(mesh, position) / grid.VoxelSize,
                    winding = MeshDistance.Winding(mesh, position) * (isTurned ? -1 : 1);
                double whole = Math.Abs(winding - Math.Round(winding));
                told[sides[i]]++;
                near += distance < 2 * corner ? 1 : 0;
                if (sides[i] != (uint)BrickSide.Mixed)
                {
                    Assert.That(distance, Is.GreaterThanOrEqualTo(2 * corner), $"brick {i} is told as a whole");
                    Assert.That(sides[i] == (uint)BrickSide.Inside, Is.EqualTo(winding > 0.5), $"brick {i}, winding number {winding}");
                }
                // Its distance is that of a voxel beside the center, which counts as too large by half a voxel.
                else if (distance > 2 * (corner + Math.Sqrt(0.75)) + 0.5 && whole < 0.04)
                    Assert.Fail($"brick {i} is not told as a whole: {distance} voxels away, winding number {winding}");
            }
            TestContext.WriteLine($"of {sides.Length} bricks {told[0]} are outside, {told[1]} inside, {told[2]} in doubt, {near} of them too near");
            Assert.That(told[0], Is.GreaterThan(200));
            Assert.That(told[1], shape == "sphere without a triangle" ? Is.GreaterThan(20) : Is.Zero);
            Assert.That(told[2], Is.GreaterThan(near / 2).And.LessThan(sides.Length - 200));
        }

        // A triangle without a hole, a ring of them with one, about the y axis.
        static TriangleMesh Washer(float hole, float radius) => hole > 0f
            ? TestMeshes.Make("Washer", (u, v) => (hole + (radius - hole) * v) * new double3(Math.Cos(2 * Math.PI * u), 0,
            Math.Sin(2 * Math.PI * u)), 12, 1, wrapsAlong: false)
            : new TriangleMesh("Triangle", new[] { radius * Vector3.right, radius * new Vector3(-0.5f, 0f, 0.8660254f),
                radius * new Vector3(-0.5f, 0f, -0.8660254f) }, new[] { 0, 1, 2 });

        // Next to nothing, at both ends of a box of that many voxels with a padding of one.
        static TriangleMesh Corners(float size)
        {
            Vector3 low = Vector3.one, high = (size - 1f) * Vector3.one;
            return new TriangleMesh("Corners",
                new[] { low, low + 0.01f * Vector3.right, low + 0.01f * Vector3.up, high, high - 0.01f * Vector3.right,
                high - 0.01f * Vector3.up }, new[] { 0, 1, 2, 3, 4, 5 });
        }

        // Why not the cheaper rays: what they cross through a hole is missing all along them.
        [Test]
        public void Votes_of_rays_fail_where_the_winding_number_holds()
        {
            TriangleMesh tube = TestMeshes.Tube(1f, 2f, 24, 4);
            SdfBake bake = MeshSdfBaker.Bake(tube, Settings(32, MeshSdfSign.WindingNumber));
            int rays = 0, voxels = 0;
            for (int i = 0; i < bake.Distances.Length; i += 5, voxels++)
                rays += RayVotes.IsInside(tube, BakeError.CenterOf(bake, i)) != MeshDistance.Winding(tube, BakeError.CenterOf(bake, i)) > 0.5 ? 1 : 0;
            Assert.That(rays, Is.GreaterThan(voxels / 100));
            TriangleMesh closed = TestMeshes.Torus(1f, 0.4f, 10);
            Assert.That(RayVotes.IsInside(closed, new double3(1.01, 0.02, 0.03))
                && !RayVotes.IsInside(closed, new double3(0.01, 0.02, 0.03)), "the votes themselves are right");
        }

        [Test]
        public void Flipped_triangles_are_turned_and_a_mesh_that_is_inside_out_too()
        {
            TriangleMesh sphere = TestMeshes.Sphere(1f, 12);
            SdfBake whole = MeshSdfBaker.Bake(sphere, Settings(24));
            foreach (TriangleMesh mesh in new[] { sphere.Turned(t => t % 5 == 0), sphere.Turned(t => true) })
            {
                SdfBake bake = MeshSdfBaker.Bake(mesh, Settings(24));
                for (int i = 0; i < bake.Distances.Length; i++)
                    Assert.That(bake.Distances[i], Is.EqualTo(whole.Distances[i]).Within(0.01f * whole.VoxelSize), $"{mesh.Name}, voxel {i}");
            }
        }

        [Test]
        public void An_open_surface_becomes_a_shell_of_the_thickness()
        {
            MeshSdfSettings settings = Settings(32);
            settings.shellThickness = 0.3f;
            TriangleMesh sheet = TestMeshes.Sheet(2f);
            SdfBake bake = MeshSdfBaker.Bake(sheet, settings);
            Assert.That(bake.Sign, Is.EqualTo(MeshSdfSign.OpenShell));
            Assert.That(bake.ShellThickness, Is.EqualTo(0.3f));
            for (int i = 0; i < bake.Distances.Length; i++)
                Assert.That(bake.Distances[i], Is.EqualTo(MeshDistance.Unsigned(sheet, BakeError.CenterOf(bake, i)) - 0.15)
                    .Within(1e-3 * bake.VoxelSize), $"voxel {i}");
            Assert.That(bake.Distances.Min(), Is.LessThan(-0.1f));
        }

        [Test]
        public void A_shell_without_a_thickness_is_two_voxels_thick_and_lies_within_the_bounds()
        {
            TriangleMesh tube = TestMeshes.Tube(1f, 2f, 24, 4);
            SdfBake bake = MeshSdfBaker.Bake(tube, Settings(32));
            Assert.That(bake.Sign, Is.EqualTo(MeshSdfSign.OpenShell));
            Assert.That(bake.ShellThickness, Is.EqualTo(2 * bake.VoxelSize).Within(1e-6f));
            Vector3Int n = bake.Resolution;
            Assert.That(Mathf.Max(n.x, Mathf.Max(n.y, n.z)), Is.EqualTo(32));
            for (int i = 0; i < bake.Distances.Length; i++)
            {
                int3 at = new int3(i % n.x, i / n.x % n.y, i / n.x / n.y);
                if (math.any(at == 0) || math.any(at == new int3(n.x, n.y, n.z) - 1))
                    Assert.That(bake.Distances[i], Is.GreaterThan(bake.VoxelSize), $"voxel {at} of {n}");
            }
            Assert.That(bake.Distances.Min(), Is.LessThan(-0.4f * bake.VoxelSize));
        }

        [TestCase(MeshSdfSign.Automatic)]
        [TestCase(MeshSdfSign.OpenShell)]
        public void A_mesh_is_never_nearer_to_the_bounds_than_its_padding(MeshSdfSign sign)
        {
            MeshSdfSettings settings = Settings(0, sign);
            settings.resolution = 8;
            settings.voxelSize = 0.1f;
            settings.padding = 2;
            SdfBake bake = MeshSdfBaker.Bake(TestMeshes.Box(new Vector3(1f, 0.55f, 0.31f), new Vector3(5f, 6f, 7f)), settings);
            float shell = sign == MeshSdfSign.OpenShell ? 1f : 0f;
            Assert.That(bake.VoxelSize, Is.EqualTo(0.1f));
            Assert.That(bake.Resolution, Is.EqualTo(new Vector3Int(14, 10, 8) + 2 * (int)shell * Vector3Int.one));
            Assert.That(Vector3.Distance(bake.Bounds.center, new Vector3(5f, 6f, 7f)), Is.LessThan(1e-5f));
            Assert.That(Vector3.Distance(bake.Bounds.size, 0.1f * (Vector3)bake.Resolution), Is.LessThan(1e-5f));
        }

        [Test, Category("LongRun")]
        public void Two_bakes_give_the_same_bits_however_the_work_is_split()
        {
            // more triangles than 65,535 groups, and large ones
            TriangleMesh mesh = TriangleMesh.Combine("Parts", new[] { TestMeshes.Sphere(1f, 130), TestMeshes.Box(Vector3.one) });
            MeshSdfSettings settings = Settings(24);
            float[] first = MeshSdfBaker.Bake(mesh, settings).Distances;
            using (var split = new MeshSdfBaker(mesh, settings,
                new MeshSdfBaker.StepSize { pairs = 101, triangles = 30011, voxels = 5003, bricks = 61, blocks = 3 }))
                Assert.That(split.Complete().Distances, Is.EqualTo(first));
        }

        [Test]
        public void A_fold_of_the_groups_is_needed_for_that()
        {
            Assert.That(TestMeshes.Sphere(1f, 130).TriangleCount, Is.GreaterThan(65535).And.LessThan(MeshSdfBaker.StepSize.Default.triangles));
        }

        [TestCase(1)]
        [TestCase(100)]
        [TestCase(int.MaxValue)]
        public void Slices_hold_every_pair_once(int most)
        {
            TriangleMesh mesh = Soup(20, needles: false);
            var triangles = new BakedTriangles(mesh);
            var grid = new SdfGrid(triangles.Bounds, Settings(24), isShell: false);
            var geometry = new BakeGeometry(mesh, TriangleOrder.Of(triangles), null, grid, turnAll: false);
            long next = 0;
            foreach (BakeGeometry.Slice slice in geometry.Slices(most))
            {
                Assert.That(slice.First, Is.EqualTo(next));
                Assert.That(slice.Count, Is.InRange(1, most));
                Assert.That(geometry.Large[slice.Low].firstPair, Is.LessThanOrEqualTo(slice.First));
                Assert.That(geometry.Large[slice.High].firstPair, Is.LessThan(slice.First + slice.Count));
                Assert.That(slice.High == geometry.Large.Length - 1 || geometry.Large[slice.High + 1].firstPair >= slice.First + slice.Count);
                next += slice.Count;
            }
            Assert.That(next, Is.EqualTo(geometry.PairCount).And.GreaterThan(500));
        }

        [Test]
        public void Few_triangles_and_one_make_a_tree()
        {
            foreach (int count in new[] { 1, 3, 4, 5, 16, 17, 100003 })
            {
                uint2[] levels = ClusterLevels.Of(count);
                Assert.That(levels[levels.Length - 1].y, Is.EqualTo(1), $"root of {count}");
                Assert.That(levels[0].y, Is.EqualTo((count + ClusterLevels.Fan - 1) / ClusterLevels.Fan), $"leaves of {count}");
                for (int i = 1; i < levels.Length; i++)
                    Assert.That(levels[i].x, Is.EqualTo(levels[i - 1].x + levels[i - 1].y), $"level {i} of {count}");
            }
            SdfBake single = MeshSdfBaker.Bake(new TriangleMesh("One", new[] { Vector3.zero, Vector3.right, Vector3.up },
                new[] { 0, 1, 2 }), Settings(16, MeshSdfSign.WindingNumber));
            Assert.That(single.Distances.Min(), Is.GreaterThanOrEqualTo(0f), "one triangle has no inside");
        }

        [Test]
        public void Storage_is_chosen_by_the_error_that_it_makes()
        {
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            MeshSdfSettings settings = Settings(24);
            SdfBake bake = MeshSdfBaker.Bake(box, settings);
            Assert.That(bake.Format, Is.EqualTo(SdfFormat.Half));
            ushort[] stored = bake.ToHalf();
            float most = stored.Select((bits, i) => Math.Abs(Mathf.HalfToFloat(bits) - bake.Distances[i])).Max();
            Assert.That(bake.StorageError, Is.EqualTo(most));
            Assert.That(most, Is.GreaterThan(0f).And.LessThan(0.05f * bake.VoxelSize));

            // Halves are coarse below 6e-5: a mesh as small as that needs 32 bits.
            SdfBake tiny = MeshSdfBaker.Bake(box.Shrunk(1e-4f), settings);
            Assert.That(tiny.Format, Is.EqualTo(SdfFormat.Float));
            Assert.That(tiny.StorageError, Is.EqualTo(0f));
            Assert.That(tiny.HalfError, Is.GreaterThan(1e-3f * tiny.VoxelSize));

            settings.format = SdfFormat.Float;
            Assert.That(MeshSdfBaker.Bake(box, settings).Format, Is.EqualTo(SdfFormat.Float));
            settings.format = SdfFormat.Half;
            Assert.That(MeshSdfBaker.Bake(box.Shrunk(1e-4f), settings).StorageError, Is.EqualTo(tiny.HalfError).Within(1e-12f));
        }

        [Test]
        public void The_error_of_halves_is_what_converting_there_and_back_makes()
        {
            var random = new Unity.Mathematics.Random(11);
            float worst = 0f;
            for (int i = 0; i < 100003; i++)
            {
                // All sizes that distances have, those below the least normal half with them; and places halfway between two halves.
                float value = math.exp2(random.NextFloat(-27f, 15.99f)) * (random.NextBool() ? 1f : -1f);
                if (i % 3 == 0)
                    value = math.asfloat(math.asuint(value) & 0xFFFFE000 | 0x1000);
                float expected = Math.Abs(Mathf.HalfToFloat(Mathf.FloatToHalf(value)) - value);
                worst = Math.Max(worst, expected);
                Assert.That(SdfBake.HalfErrorOf(value), Is.EqualTo(expected), $"{value:R}");
            }
            Assert.That(worst, Is.GreaterThan(10f));
            Assert.That(SdfBake.HalfErrorOf(0f), Is.EqualTo(0f));
            Assert.That(SdfBake.HalfErrorOf(65519f), Is.EqualTo(15f));
            Assert.That(SdfBake.HalfErrorOf(-65520f), Is.EqualTo(float.PositiveInfinity), "more than a half can be");
        }

        // Property that keeps runs of triangles small: the curve never jumps.
        [Test]
        public void The_order_of_triangles_goes_from_cell_to_neighboring_cell()
        {
            const int cells = 16, bits = 3 * 6;      // 4 of the 10 bits per axis
            var positions = new int3[cells * cells * cells];
            var seen = new bool[positions.Length];
            for (int i = 0; i < positions.Length; i++)
            {
                var cell = new int3(i % cells, i / cells % cells, i / cells / cells);
                int rank = (int)(TriangleOrder.KeyOf(((float3)cell + 0.5f) * (1024 / cells)) >> bits);
                Assert.That(seen[rank], Is.False, $"two cells at {rank}");
                seen[rank] = true;
                positions[rank] = cell;
            }
            for (int i = 1; i < positions.Length; i++)
                Assert.That(math.csum(math.abs(positions[i] - positions[i - 1])), Is.EqualTo(1), $"{positions[i - 1]} to {positions[i]}");
            Assert.That(TriangleOrder.KeyOf(new float3(-1f)), Is.EqualTo(TriangleOrder.KeyOf(0f)), "outside of the box is its rim");
            Assert.That(TriangleOrder.KeyOf(new float3(1e9f)), Is.EqualTo(TriangleOrder.KeyOf(1023.5f)));
        }

        [Test]
        public void Every_triangle_that_takes_part_is_in_the_order_once()
        {
            TriangleMesh mesh = TestMeshes.Sphere(1f, 130);      // several chunks
            for (int t = 0; t < mesh.TriangleCount; t += 7)
                mesh.Triangles[3 * t + 1] = mesh.Triangles[3 * t];
            var part = new BakedTriangles(mesh);
            uint[] order = TriangleOrder.Of(part);
            Assert.That(part.Count, Is.LessThan(mesh.TriangleCount - mesh.TriangleCount / 8));
            Assert.That(order.OrderBy(t => t), Is.EqualTo(Enumerable.Range(0, mesh.TriangleCount).Where(part.TakesPart)));
            uint[] keys = order.Select(t => TriangleOrder.KeyOf(TriangleOrder.CenterOf(mesh, (int)t, part.Bounds.min,
                TriangleOrder.ScaleOf(part)))).ToArray();
            Assert.That(keys, Is.Ordered);
            for (int i = 1; i < keys.Length; i++)
                Assert.That(keys[i] > keys[i - 1] || order[i] > order[i - 1], "those in one place as in the mesh");
        }

        [Test]
        public void The_estimate_is_what_the_bake_makes()
        {
            TriangleMesh mesh = TestMeshes.Tube(1f, 2f, 24, 4);
            MeshSdfEstimate estimate = MeshSdfBaker.Estimate(mesh, Settings(32));
            SdfBake bake = MeshSdfBaker.Bake(mesh, Settings(32));
            Assert.That(estimate.Problem, Is.Null);
            Assert.That(estimate.Resolution, Is.EqualTo(bake.Resolution));
            Assert.That(estimate.VoxelSize, Is.EqualTo(bake.VoxelSize));
            Assert.That(estimate.Bounds, Is.EqualTo(bake.Bounds));
            Assert.That(estimate.TextureBytes, Is.EqualTo(4 * bake.Distances.Length));
            Assert.That(estimate.TotalBytes, Is.GreaterThan(2 * estimate.TextureBytes + 16 * bake.Distances.Length));
        }

        [Test]
        public void Progress_rises_to_one_and_the_stages_have_names()
        {
            var fractions = new List<float>();
            var stages = new HashSet<string>();
            SdfBake bake = MeshSdfBaker.Bake(TestMeshes.Sphere(1f, 12), Settings(24), (fraction, stage) =>
            {
                fractions.Add(fraction);
                stages.Add(stage);
                return true;
            });
            Assert.That(bake, Is.Not.Null);
            Assert.That(fractions, Is.Ordered);
            Assert.That(fractions.First(), Is.GreaterThan(0f));
            Assert.That(fractions.Last(), Is.EqualTo(1f).Within(1e-6f), "all steps were foreseen");
            Assert.That(stages, Is.EquivalentTo(new[] { "Distances near the surface", "Distances beyond", "Inside and outside", "Reading back" }));
        }

        [Test]
        public void A_bake_that_is_canceled_ends_at_once()
        {
            int asked = 0;
            Assert.That(MeshSdfBaker.Bake(TestMeshes.Sphere(1f, 12), Settings(24), (fraction, stage) => ++asked < 3), Is.Null);
            Assert.That(asked, Is.EqualTo(3));

            var baker = new MeshSdfBaker(TestMeshes.Sphere(1f, 12), Settings(24));
            baker.Step();
            baker.Dispose();
            baker.Dispose();
            Assert.That(baker.Result, Is.Null);
            Assert.That(Assert.Throws<ObjectDisposedException>(() => baker.Step()).Message, Does.Contain("'Sphere' was canceled"));
        }

        [Test]
        public void Steps_alone_come_to_an_end_where_no_frame_passes()
        {
            using (var baker = new MeshSdfBaker(TestMeshes.Sphere(1f, 12), Settings(24)))
            {
                var clock = System.Diagnostics.Stopwatch.StartNew();
                while (baker.Step())
                    Assert.That(clock.Elapsed.TotalSeconds, Is.LessThan(60), "it hangs at: " + baker.Stage);
                Assert.That(baker.Result, Is.Not.Null);
            }
        }

        [Test]
        public void The_estimate_of_a_checked_mesh_is_that_of_the_mesh()
        {
            foreach (TriangleMesh mesh in new[] { TestMeshes.Torus(1f, 0.3f, 8), TestMeshes.Sheet(2f) })
                foreach (MeshSdfSign sign in new[] { MeshSdfSign.Automatic, MeshSdfSign.WindingNumber, MeshSdfSign.OpenShell })
                    Assert.That(MeshSdfBaker.Estimate(MeshCheck.Run(mesh), Settings(32, sign)),
                        Is.EqualTo(MeshSdfBaker.Estimate(mesh, Settings(32, sign))), $"{mesh.Name}, {sign}");
            MeshReport nothing = MeshCheck.Run(new TriangleMesh("Nothing", new Vector3[3], new int[0]));
            Assert.That(Assert.Throws<ArgumentException>(() => MeshSdfBaker.Estimate(nothing, Settings(32))).Message,
                Does.Contain("'Nothing' has no triangles"));
        }

        // A shell does not ask the mesh for what the sign is told.
        [Test]
        public void A_shell_that_was_asked_for_is_that_of_an_open_mesh_whichever_way_its_triangles_face()
        {
            TriangleMesh tube = TestMeshes.Tube(1f, 2f, 24, 4);
            float[] distances = MeshSdfBaker.Bake(tube, Settings(24)).Distances;
            Assert.That(MeshSdfBaker.Bake(tube, Settings(24, MeshSdfSign.OpenShell)).Distances, Is.EqualTo(distances), "as automatic comes to");
            float[] turned = MeshSdfBaker.Bake(tube.Turned(t => t % 3 == 0), Settings(24, MeshSdfSign.OpenShell)).Distances;
            Assert.That(turned.Select((d, i) => Math.Abs(d - distances[i])).Max(), Is.LessThan(1e-5f));
        }

        [UnityTest]
        public IEnumerator Steps_can_be_spread_over_frames_and_never_wait()
        {
            using (var baker = new MeshSdfBaker(TestMeshes.Sphere(1f, 12), Settings(24)))
            {
                int frames = 0;
                while (baker.Step() && frames < 1000)
                {
                    frames++;
                    yield return null;
                }
                Assert.That(baker.IsDone);
                Assert.That(baker.Progress, Is.EqualTo(1f));
                Assert.That(baker.Step(), Is.False);
                Assert.That(baker.Result.Distances, Is.EqualTo(MeshSdfBaker.Bake(TestMeshes.Sphere(1f, 12), Settings(24)).Distances));
            }
        }

        [UnityTest]
        public IEnumerator A_bake_can_be_canceled_while_it_is_read_back()
        {
            for (int tries = 0; tries < 20; tries++)
            {
                var baker = new MeshSdfBaker(TestMeshes.Sphere(1f, 12), Settings(24));
                while (baker.Stage != MeshSdfBaker.ReadingBack)
                    baker.Step();
                bool isThere = baker.IsDone;        // by the same step, on a machine that did something else meanwhile
                baker.Dispose();
                yield return null;
                if (isThere)
                    continue;
                Assert.That(baker.Result, Is.Null);
                yield break;
            }
            Assert.Fail("It was never reading back.");
        }

        [Test]
        public void A_mesh_asset_is_baked_with_all_its_submeshes()
        {
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            var mesh = new Mesh { name = "Parts", vertices = box.Vertices, subMeshCount = 3 };
            mesh.SetIndices(box.Triangles.Take(18).ToArray(), MeshTopology.Triangles, 0);
            mesh.SetIndices(new[] { 0, 1 }, MeshTopology.Lines, 1);
            mesh.SetIndices(box.Triangles.Skip(18).ToArray(), MeshTopology.Triangles, 2);
            Assert.That(MeshSdfBaker.Bake(mesh, Settings(16)).Distances, Is.EqualTo(MeshSdfBaker.Bake(box, Settings(16)).Distances));
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        // ---- bad input: what, the limit, the remedy

        static string Refusal(TriangleMesh mesh, MeshSdfSettings settings)
            => Assert.Throws<ArgumentException>(() => MeshSdfBaker.Bake(mesh, settings)).Message;

        [Test]
        public void Bad_meshes_are_refused_by_name()
        {
            MeshSdfSettings settings = Settings(16);
            Assert.That(Assert.Throws<ArgumentNullException>(() => MeshSdfBaker.Bake((Mesh)null, settings)).Message, Does.Contain("No mesh to bake"));
            Assert.That(Assert.Throws<ArgumentNullException>(() => MeshSdfBaker.Bake((TriangleMesh)null, settings)).Message,
                Does.Contain("No mesh to bake"));
            Assert.That(Refusal(new TriangleMesh("Nothing", new Vector3[3], new int[0]), settings), Does.Contain("'Nothing' has no triangles"));
            Assert.That(Refusal(new TriangleMesh("Point", new Vector3[3], new[] { 0, 1, 2 }), settings),
                Does.Contain("'Point': none of its 1 triangles has an area").And.Contain("repair"));
            Vector3[] vertices = TestMeshes.Box(Vector3.one).Vertices;
            vertices[3].y = float.NaN;
            Assert.That(Refusal(new TriangleMesh("Broken", vertices, TestMeshes.Box(Vector3.one).Triangles), settings),
                Does.Contain("'Broken'").And.Contain("5 of 12 triangles").And.Contain("repair"));
            Assert.That(Assert.Throws<ArgumentException>(() => new TriangleMesh("Odd", vertices, new[] { 0, 1 })).Message,
                Does.Contain("'Odd': 2 indices"));
            Assert.That(Assert.Throws<ArgumentException>(() => new TriangleMesh("Far", vertices, new[] { 0, 1, 8 })).Message,
                Does.Contain("vertex 8 of 8"));
        }

        [Test]
        public void A_mesh_that_scripts_cannot_read_is_refused_with_the_remedy()
        {
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            var mesh = new Mesh { name = "Sealed", vertices = box.Vertices, triangles = box.Triangles };
            mesh.UploadMeshData(markNoLongerReadable: true);
            Assert.That(Assert.Throws<ArgumentException>(() => MeshSdfBaker.Bake(mesh, Settings(16))).Message,
                Does.Contain("'Sealed'").And.Contain("Read/Write"));
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        [Test]
        public void Bad_settings_are_refused_with_the_limit_and_the_remedy()
        {
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            Assert.That(Refusal(box, With(s => { s.voxelSize = -0.1f; return s; })),
                Does.Contain("'Box'").And.Contain("Voxel size -0.1 m must be above 0"));
            Assert.That(Refusal(box, With(s => { s.voxelSize = float.NaN; return s; })), Does.Contain("Voxel size NaN"));
            Assert.That(Refusal(box, With(s => { s.resolution = 5000; return s; })), Does.Contain("Resolution 5000 is outside 8 to 1024"));
            Assert.That(Refusal(box, With(s => { s.padding = 0; return s; })), Does.Contain("Padding 0 is outside 1 to 64"));
            Assert.That(Refusal(box, With(s => { s.memoryCap = 0; return s; })), Does.Contain("Memory cap 0 MiB"));
            Assert.That(Refusal(box, With(s => { s.shellThickness = -1f; return s; })), Does.Contain("Shell thickness -1 m"));
            Assert.That(Refusal(box, With(s => { s.voxelSize = 1e-3f; return s; })),
                Does.Contain("1006 x 1006 x 1006").And.Contain("memory cap of 1024 MiB").And.Contain("larger voxels"));
            Assert.That(Refusal(box, With(s => { s.voxelSize = 1e-4f; return s; })), Does.Contain("a side"));
            MeshSdfSettings settings = With(s => { s.memoryCap = 1; s.resolution = 64; return s; });
            Assert.That(MeshSdfBaker.Estimate(box, settings).Problem, Does.Contain("64 x 64 x 64").And.Contain("cap of 1 MiB"), "told before baking");
            Assert.That(Refusal(box, settings), Does.Contain("cap of 1 MiB"));
        }

        static MeshSdfSettings With(Func<MeshSdfSettings, MeshSdfSettings> change) => change(MeshSdfSettings.Default);

        static float Sample(SignedDistanceField field, float3 at)
        {
            Assert.That(field.TrySample(at, out float distance));
            return distance;
        }

        static void Destroy(SignedDistanceField field)
        {
            UnityEngine.Object.DestroyImmediate(field.Texture);
            UnityEngine.Object.DestroyImmediate(field);
        }
    }
}
