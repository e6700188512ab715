using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Rill.Tests.ColliderTests;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>The mesh of the water touches the colliders that the water lies on. Boxes of 15 x 14 x 15 d, d = 5 cm.</summary>
    public class SurfaceMeshContactTests
    {
        const float Spacing = 0.05f;
        const float Medium = 0.75f;
        const float Depth = 5f;
        static readonly float3 Box = new float3(15f, 14f, 15f);

        public enum Solid { Ball, Box, TiltedBox, Capsule, Slope, Ground, Mesh }

        SignedDistanceField cube;
        HeightField ground;

        [TearDown]
        public void DisposeFields()
        {
            ground?.Dispose();
            ground = null;
            if (cube == null)
                return;
            Object.DestroyImmediate(cube.Texture);
            Object.DestroyImmediate(cube);
            cube = null;
        }

        // The collider, and the shape of the same surface whose distance has a formula.
        ColliderMotion Make(Solid solid, out ColliderMotion formula)
        {
            float3 center = new float3(7.5f, 4.5f, 7.5f);
            quaternion tilt = quaternion.Euler(0.4f, 0.3f, 0.2f);
            switch (solid)
            {
                case Solid.Ball: return formula = Still(ColliderShape.Sphere, 3.2f, center, quaternion.identity);
                case Solid.Box: return formula = Still(ColliderShape.Box, new float3(2.3f, 9f, 2.8f), center, quaternion.identity);
                case Solid.TiltedBox: return formula = Still(ColliderShape.Box, new float3(2.2f, 5f, 2.2f), center, tilt);
                case Solid.Capsule: return formula = Still(ColliderShape.Capsule, new float3(2f, 2.5f, 0f), center, quaternion.Euler(1.2f, 0.3f, 0f));
                case Solid.Slope: return formula = Still(ColliderShape.Plane, 0f, new float3(7.5f, 1f, 7.5f), quaternion.Euler(0.6f, 0f, 0.2f));
                case Solid.Ground: return Ground(out formula);
                default: return Cube(center, tilt, out formula);
            }
        }

        ColliderMotion Ground(out ColliderMotion formula)
        {
            const int Count = 61;
            var heights = new float[Count, Count];
            for (int z = 0; z < Count; z++)
                for (int x = 0; x < Count; x++)
                    heights[z, x] = Spacing * (1.5f + 7f * x / (Count - 1) - 1.5f * z / (Count - 1));
            ground = new HeightField(heights, Box.x * Spacing, Box.z * Spacing);
            ColliderMotion motion = Still(ColliderShape.HeightField, ground.Extents / Spacing, ground.Center / Spacing, quaternion.identity);
            motion.field = ground.Texture;
            motion.fieldUnit = 1f / Spacing;
            motion.minFraction = ground.MinFraction;
            motion.voxel = Box.x / (Count - 1);
            float3 up = math.normalize(new float3(-7f / Box.x, 1f, 1.5f / Box.z));
            formula = Still(ColliderShape.Plane, 0f, new float3(0f, 1.5f, 0f), Quaternion.FromToRotation(Vector3.up, up));
            return motion;
        }

        ColliderMotion Cube(float3 center, quaternion tilt, out ColliderMotion formula)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 24;
            settings.padding = 4;
            cube = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Box(5f * Spacing * Vector3.one), settings));
            ColliderMotion motion = Still(ColliderShape.Mesh, cube.Bounds.extents / Spacing, center, tilt);
            motion.field = cube.Texture;
            motion.voxel = cube.VoxelSize / Spacing;
            motion.fieldUnit = 1f / Spacing;
            formula = Still(ColliderShape.Box, 2.5f, center, tilt);
            return motion;
        }

        // Depth below the surface beside it, d, at which a pocket of a few cells without water begins, not the line. Some paths leave one at a mesh
        // as the water comes to rest, of up to a seventh of the points.
        const double Pocket = 1.0;

        // Particles do not get into a wedge between the surface and a collider that leans: there the surface ends lower than it is beside.
        static double LineError(Solid solid)
        {
            switch (solid)
            {
                case Solid.Slope: return 0.8;
                case Solid.TiltedBox: return 0.5;
                case Solid.Ground: return 0.4;
                case Solid.Capsule:
                case Solid.Mesh: return 0.35;
                default: return 0.2;
            }
        }

        [Test, Category("LongRun")]
        public void Water_touches_what_it_lies_on([Values] Solid solid)
        {
            ColliderMotion motion = Make(solid, out ColliderMotion formula);
            using (TestFluid fluid = Pool(motion, formula))
                AssertContact(fluid.Step(40), Medium, formula, $"{solid}", LineError(solid));
        }

        [Test]
        public void Water_touches_what_it_lies_on_at_each_quality([Values(0.5f, 1f)] float cell, [Values] bool deep)
        {
            ColliderMotion motion = Make(Solid.Box, out _);
            using (TestFluid fluid = Pool(motion, motion, deep))
                AssertContact(fluid.Step(40), cell, motion, $"nodes {cell} d apart", 0.25);
        }

        [Test]
        public void Water_touches_what_moves_in_it()
        {
            ColliderMotion ball = Make(Solid.Ball, out _);
            using (TestFluid fluid = Pool(ball, ball))
            {
                fluid.Step(20);
                for (int i = 0; i < 20; i++)
                {
                    ball.start = ball.end;
                    ball.end.position += new float3(0.05f, 0.02f, 0f);
                    Use(fluid, ball);
                    fluid.Step();
                }
                DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                double[] gaps = Gaps(fluid, mesh, ball);
                TestContext.Out.WriteLine($"{gaps.Length} particles lie on it, gaps up to {gaps.Max():0.000} d");
                Assert.That(gaps.Length, Is.GreaterThan(30));
                Assert.That(gaps.Max(), Is.LessThan(0.05));
                Assert.That(mesh.OpenEdges, Is.Zero);
            }
        }

        // Parts thinner than a third of a cell are not held.
        [Test, Category("LongRun")]
        public void Water_at_a_thin_plate_is_not_seen_on_its_other_side([Values(0.5f, Medium, 1f)] float cell,
            [Values(0.3f, 0.6f, 1f)] float thickness, [Values(0f, 0.25f)] float tilt)
        {
            if (thickness < 0.4f * cell)
                Assert.Pass("Low does not hold what is so much thinner than a cell");
            ColliderMotion plate = Still(ColliderShape.Box, new float3(0.5f * thickness, 40f, 40f), new float3(7.6f, 4f, 7.5f),
                quaternion.Euler(0f, 0f, tilt));
            using (TestFluid fluid = new TestFluid(Box * Spacing, Spacing, 1200))
            {
                float3[] positions = ParticleState.Lattice(0f, 0.5f, new int3(7, 4, 15), 0.02f).positions.Select(p => p.xyz)
                    .Where(p => Reference.Shapes.Distance(plate, p) > 0.5 && In(plate, p).x < 0.0).Select(p => p * Spacing).ToArray();
                Use(fluid, plate);
                DrawnMesh mesh = DrawnMesh.Of(fluid.Add(positions).Step(20), cell);
                double beyond = mesh.positions.Max(p => In(plate, p).x) - 0.5 * thickness;
                double[] gaps = Gaps(fluid, mesh, plate);
                TestContext.Out.WriteLine($"{beyond:0.000} d beyond it; gaps of {gaps.Length} up to {gaps.Max():0.000} d");
                Assert.That(beyond, Is.LessThan(0.0), "d beyond the plate's other side");
                Assert.That(gaps.Length, Is.GreaterThan(15));
                Assert.That(gaps.Max(), Is.LessThan(0.05));
                Assert.That(mesh.OpenEdges, Is.Zero);
            }
        }

        [Test]
        public void A_drop_on_a_collider_is_no_water_of_the_mesh()
        {
            ColliderMotion floor = Still(ColliderShape.Plane, 0f, new float3(7.5f, 3f, 7.5f), quaternion.identity);
            using (TestFluid fluid = new TestFluid(Box * Spacing, Spacing, 100))
            {
                fluid.Input.gravity = 0f;
                Use(fluid, floor);
                fluid.Add(new[] { new float3(4f, 3.5f, 4f), new float3(10f, 3.5f, 10f), new float3(10.9f, 3.5f, 10f) }
                    .Select(p => p * Spacing).ToArray()).Step();
                DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                Assert.That(mesh[SurfaceMesh.Counter.Bricks], Is.GreaterThan(0), "the collider is touched");
                Assert.That(mesh[SurfaceMesh.Counter.Drops], Is.EqualTo(3));
                Assert.That(mesh.positions, Is.Empty);
            }
        }

        [Test]
        public void Beside_colliders_too_the_mesh_of_the_same_water_is_the_same_on_every_run()
        {
            uint[] Words()
            {
                ColliderMotion motion = Make(Solid.TiltedBox, out _);
                using (TestFluid fluid = Pool(motion, motion))
                {
                    DrawnMesh mesh = DrawnMesh.Of(fluid.Step(10), Medium);
                    return GpuTest.Read<uint>(fluid.Solver.Mesh.Vertices, mesh.positions.Length * SurfaceMesh.VertexBytes / sizeof(uint))
                        .Concat(mesh.indices).ToArray();
                }
            }
            uint[] first = Words();
            Assert.That(first.Length, Is.GreaterThan(5000));
            Assert.That(Words(), Is.EqualTo(first));
        }

        // Beside a collider all users of the workspace are there, and in a splash drops are too.
        [Test]
        public void Nothing_that_the_last_surface_left_in_the_workspace_is_read()
        {
            uint[] Words(bool isOverwritten)
            {
                ColliderMotion motion = Make(Solid.Ball, out _);
                using (TestFluid fluid = Pool(motion, motion))
                {
                    fluid.Add(new[] { new float3(2f, 11f, 2f), new float3(12f, 11f, 3f) }.Select(p => p * Spacing).ToArray());
                    DrawnMesh.Of(fluid.Step(3), Medium);
                    if (isOverwritten)
                        GpuTest.FillWithGarbage(fluid.Solver.Mesh.Drops);
                    DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                    Assert.That(mesh[SurfaceMesh.Counter.Drops], Is.EqualTo(2));
                    return GpuTest.Read<uint>(fluid.Solver.Mesh.Vertices, mesh.positions.Length * SurfaceMesh.VertexBytes / sizeof(uint))
                        .Concat(mesh.indices).ToArray();
                }
            }
            uint[] whole = Words(false);
            Assert.That(whole.Length, Is.GreaterThan(5000));
            Assert.That(Words(true), Is.EqualTo(whole));
        }

        [Test]
        public void Only_a_mesh_beside_colliders_is_mirrored_by_them()
        {
            ColliderMotion motion = Make(Solid.Ball, out _);
            using (TestFluid fluid = Pool(motion, motion).Step())
            {
                DrawnMesh.Of(fluid, Medium);
                Assert.That(fluid.Solver.Surface.HasContacts, Is.True);
                fluid.Solver.MeshCell = 0f;
                GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                Assert.That(fluid.Solver.Surface.HasContacts, Is.False, "ellipsoids");
                fluid.Input.colliders = null;
                DrawnMesh.Of(fluid.Step(), Medium);
                Assert.That(fluid.Solver.Surface.HasContacts, Is.False, "no collider");
            }
        }

        static void AssertContact(TestFluid fluid, float cell, ColliderMotion shape, string what, double lineError)
        {
            DrawnMesh mesh = DrawnMesh.Of(fluid, cell);
            double[] gaps = Gaps(fluid, mesh, shape).OrderBy(x => x).ToArray();
            double[] line = ContactErrors(mesh, shape).OrderBy(x => x).ToArray();
            double volume = VolumeOutside(mesh, shape) / fluid.Added;
            TestContext.Out.WriteLine($"{what}: gaps of {gaps.Length} particles {gaps.First():0.000} to {gaps.Last():0.000} d; contact line of " +
                $"{line.Length}: {Rms(line):0.000} d rms, {line.FirstOrDefault():0.000} to {line.LastOrDefault():0.000}; volume {volume:0.000}");
            Assert.That(gaps.Length, Is.GreaterThan(40));
            Assert.That(gaps.Last(), Is.LessThan(0.05));
            Assert.That(mesh.positions.Min(p => Reference.Shapes.Distance(shape, p)), Is.GreaterThan(-1.0), "it ends in the collider");
            Assert.That(mesh.OpenEdges, Is.Zero);
            Assert.That(mesh[SurfaceMesh.Counter.Holes], Is.Zero);
            Assert.That(volume, Is.EqualTo(1.0).Within(0.035));
            double[] onLine = line.Where(error => error > -Pocket).ToArray();
            Assert.That(onLine.Length, Is.GreaterThan(10));
            Assert.That(line.Length - onLine.Length, Is.LessThanOrEqualTo(0.15 * line.Length), "points around pockets under the line");
            Assert.That(Rms(onLine), Is.LessThan(lineError));
        }

        // Returns how far from a shape the water ends below the particles on it, positive at a gap.
        static double[] Gaps(TestFluid fluid, DrawnMesh mesh, ColliderMotion shape)
        {
            var gaps = new List<double>();
            double top = Level(mesh, shape) - 0.5;
            foreach (float4 particle in fluid.Read().positions)
            {
                double3 p = particle.xyz;
                double distance = Reference.Shapes.Distance(shape, p);
                if (distance > 0.7 || p.y > top || math.cmin(math.min(p, (double3)fluid.Solver.Layout.DomainSize - p)) < 1.2)
                    continue;
                double3 along = math.normalize(-Normal(shape, p) + 1e-3 * new double3(0.31, 0.17, -0.23));    // not along the nodes
                gaps.Add(distance - mesh.Exit(p, along, distance + 1.0));
            }
            return gaps.ToArray();
        }

        static double Level(DrawnMesh mesh, ColliderMotion shape)
        {
            double[] heights = mesh.positions.Where((p, i) => mesh.normals[i].y > 0.9 && Reference.Shapes.Distance(shape, p) > 1.5)
                .Select(p => p.y).OrderBy(y => y).ToArray();
            return heights[heights.Length / 2];
        }

        static double3 Normal(ColliderMotion shape, double3 p)
        {
            const double step = 1e-4;
            double Slope(double3 along) => Reference.Shapes.Distance(shape, p + step * along) - Reference.Shapes.Distance(shape, p - step * along);
            return math.normalize(new double3(Slope(new double3(1, 0, 0)), Slope(new double3(0, 1, 0)), Slope(new double3(0, 0, 1))));
        }

        // How far the line in which the surface meets a shape is over the surface beside it, d.
        static double[] ContactErrors(DrawnMesh mesh, ColliderMotion shape)
        {
            double level = Level(mesh, shape);      // far below, water may not get into what is narrow
            double[] distances = mesh.positions.Select(p => Reference.Shapes.Distance(shape, p)).ToArray();
            double3[] top = mesh.positions.Where((p, i) => mesh.normals[i].y > 0.8 && distances[i] > 1.0 && distances[i] < 3.0
                && p.y > level - 1.5).ToArray();
            var line = new List<double>();
            for (int i = 0; i < mesh.indices.Length; i++)
            {
                uint a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
                double3 center = 0.5 * (mesh.positions[a] + mesh.positions[b]);
                if (distances[a] >= 0.0 || distances[b] < 0.0 || center.y < level - 1.5
                    || math.cmin(math.min(center, Box - center).xz) < 1.0)
                    continue;
                double3 at = math.lerp(mesh.positions[a], mesh.positions[b], distances[a] / (distances[a] - distances[b]));
                double[] beside = top.Where(p => math.distance(p.xz, at.xz) < 2.5).Select(p => p.y).ToArray();
                if (beside.Length > 0)
                    line.Add(at.y - beside.Average());
            }
            return line.ToArray();
        }

        // Volume that the mesh encloses outside of a shape, d³.
        static double VolumeOutside(DrawnMesh mesh, ColliderMotion shape)
        {
            double3[] p = mesh.positions.Select(q => q - Normal(shape, q) * Math.Min(Reference.Shapes.Distance(shape, q), 0.0)).ToArray();
            double sum = 0.0;
            for (int i = 0; i < mesh.indices.Length; i += 3)
                sum += math.dot(p[mesh.indices[i]], math.cross(p[mesh.indices[i + 1]], p[mesh.indices[i + 2]]));
            return sum / 6.0;
        }

        // A place in the frame of a shape.
        static float3 In(ColliderMotion shape, double3 p) => math.mul(math.conjugate(shape.end.rotation), (float3)p - shape.end.position);

        static TestFluid Pool(ColliderMotion motion, ColliderMotion formula, bool deep = false)
        {
            var fluid = new TestFluid(Box * Spacing, Spacing, 1300);
            if (deep)
                fluid.Input.settings.deepWater = DeepWater.On;
            fluid.AddAround(formula, 0f, new float3(Box.x, Depth, Box.z));
            Use(fluid, motion);
            return fluid;
        }

        static double Rms(IEnumerable<double> values) => Math.Sqrt(values.DefaultIfEmpty().Average(x => x * x));
    }
}
