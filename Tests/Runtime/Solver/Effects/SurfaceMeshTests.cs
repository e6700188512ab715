using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Random = Unity.Mathematics.Random;

namespace Rill.Tests
{
    /// <summary>The mesh of the water's surface is closed, lies where the surface is and encloses the water's volume.</summary>
    public class SurfaceMeshTests
    {
        const float Spacing = 0.05f;
        const float Medium = 0.75f;

        static readonly float[] Cells = { 0.5f, Medium, 1f };

        [Test, Category("LongRun")]
        public void Water_that_breaks_has_a_closed_mesh_of_its_volume([ValueSource(nameof(Cells))] float cell, [Values] bool deep)
        {
            double bound = cell > Medium ? 0.01 : 0.004;
            int reversed = 0, triangles = 0;
            using (TestFluid fluid = Dam(deep))
                for (int time = 0; time < 4; time++)
                {
                    DrawnMesh mesh = DrawnMesh.Of(fluid.Step(15), cell);
                    int drops = Kinds(fluid)[SurfaceElementKind.Drop];
                    string at = $"after {15 * (time + 1)} steps: {mesh.Volume / fluid.Added:0.000} of its volume in the mesh, " +
                        $"{(double)drops / fluid.Added:0.000} in drops, {100.0 * mesh.CrowdedEdges:0.00} % of the edges have 4 triangles";
                    TestContext.Out.WriteLine(at);
                    Assert.That(mesh.OpenEdges, Is.Zero, at);
                    Assert.That(mesh[SurfaceMesh.Counter.Holes], Is.Zero, at);
                    Assert.That((mesh.Volume + drops) / fluid.Added, Is.EqualTo(1.0).Within(cell > Medium ? 0.04 : 0.025), at);
                    Assert.That(mesh.CrowdedEdges, Is.LessThan(cell > Medium ? 0.02 : 0.01), at);
                    reversed += AssertNormals(mesh, 2.0 * bound, at);       // of one splash: how it breaks up is chance
                    triangles += mesh.indices.Length / 3;
                }
            TestContext.Out.WriteLine($"{100.0 * reversed / triangles:0.000} % of the triangles have reversed normals");
            Assert.That(reversed, Is.LessThan(bound * triangles), "triangles whose normals are reversed, of all times");
        }

        [Test]
        public void Particles_anywhere_in_the_box_have_a_closed_mesh([ValueSource(nameof(Cells))] float cell, [Values(200, 1500, 3000)] int count)
        {
            var random = new Random((uint)count);
            using (TestFluid fluid = Still(new float3(16f, 13.3f, 11.1f), 3000))
            {
                fluid.Add(Enumerable.Range(0, count).Select(i => random.NextFloat3(0.5f, new float3(15.5f, 12.8f, 10.6f)) * Spacing).ToArray());
                DrawnMesh mesh = DrawnMesh.Of(fluid.Step(), cell);
                Assert.That(mesh.positions.Length, Is.GreaterThan(count / 50));
                Assert.That(mesh.OpenEdges, Is.Zero);
                Assert.That(mesh.Volume, Is.GreaterThan(0.0), "the right side is out");
            }
        }

        // The bars are those of a relaxed ball and of one cut from a lattice, which is rougher.
        [Test]
        public void A_ball_has_a_smooth_mesh_of_its_radius([ValueSource(nameof(Cells))] float cell)
        {
            using (TestFluid fluid = Still(32f, 6000))
            {
                fluid.Add(Ball(16f, 10f)).Step();
                DrawnMesh mesh = DrawnMesh.Of(fluid, cell);
                double radius = Math.Pow(fluid.Added * 0.75 / Math.PI, 1.0 / 3.0);
                double rms = Rms(mesh.positions.Select(p => math.distance(p, 16.0) - radius));
                double angle = math.degrees(Rms(mesh.positions.Select((p, i) => Angle(math.normalize(p - 16.0), mesh.normals[i]))));
                TestContext.Out.WriteLine($"rms {rms:0.000} d, normals {angle:0.00} degrees, volume {mesh.Volume / fluid.Added:0.0000}");
                Assert.That(rms, Is.LessThan(0.035));
                Assert.That(angle, Is.LessThan(2.0));
                Assert.That(mesh.Volume / fluid.Added, Is.EqualTo(1.0).Within(0.01));
                Assert.That(mesh.OpenEdges, Is.Zero);
            }
        }

        [Test]
        public void The_field_is_the_distance_from_the_surface_near_it_and_its_sign_is_right_everywhere()
        {
            using (TestFluid fluid = Still(32f, 6000))
            {
                fluid.Add(Ball(16f, 10f)).Step();
                DrawnMesh.Of(fluid, Medium);
                SurfaceMesh mesh = fluid.Solver.Mesh;
                double radius = Math.Pow(fluid.Added * 0.75 / Math.PI, 1.0 / 3.0);
                var field = new ReadField(mesh);
                int near = 0;
                foreach (int3 node in field.Nodes)
                {
                    double depth = radius - math.distance(((double3)node - 0.5) * Medium, 16.0);
                    float value = field[node];
                    if (Math.Abs(depth) > 0.15)
                        Assert.That(value > 0f, Is.EqualTo(depth > 0.0), $"node {node}, {depth:0.00} d under the surface");
                    if (Math.Abs(depth) < 0.8)
                    {
                        near++;
                        Assert.That(value, Is.EqualTo(depth).Within(0.15), $"node {node}");
                    }
                }
                Assert.That(near, Is.GreaterThan(1000));
            }
        }

        [Test]
        public void Sheets_are_as_thick_as_their_particles_are_water([ValueSource(nameof(Cells))] float cell, [Values(1, 2)] int layers)
        {
            if (cell > Medium && layers == 1)
                Assert.Pass("thinner than a cell: Low tears such sheets");
            using (TestFluid fluid = Still(new float3(28f, 16f, 28f), 3000))
            {
                var positions = new List<float3>();
                for (int z = 0; z < 24; z++)
                    for (int y = 0; y < layers; y++)
                        for (int x = 0; x < 24; x++)
                            positions.Add((new float3(x, y, z) + 0.02f * math.sin(37f * new float3(x + z, y + x, z - y))
                                + new float3(2.5f, 7.2f, 2.5f)) * Spacing);
                fluid.Input.settings.iterations = 0;
                DrawnMesh mesh = DrawnMesh.Of(fluid.Add(positions.ToArray()).Step(), cell);
                Assert.That(mesh.OpenEdges, Is.Zero);
                double[] heights = mesh.positions.Where(p => math.all(p.xz > 6.0) && math.all(p.xz < 22.0))
                    .Select(p => p.y - 7.2 - 0.5 * (layers - 1)).ToArray();
                double top = heights.Where(y => y > 0.0).Average(), bottom = heights.Where(y => y < 0.0).Average();
                TestContext.Out.WriteLine($"{layers} layers, nodes {cell} d apart: thickness {top - bottom:0.00} d");
                Assert.That(top - bottom, Is.EqualTo((double)layers).Within(0.15 * layers));
                Assert.That(HolesSeenFromAbove(mesh, 6, 22), Is.Zero, "of 16 x 16 looks");
            }
        }

        [Test]
        public void Fewer_particles_together_than_the_mesh_can_hold_are_drops()
        {
            using (TestFluid fluid = Still(24f, 100))
            {
                fluid.Input.settings.iterations = 0;
                fluid.Add(new[] { new float3(6f), new float3(12f, 6f, 6f), new float3(13f, 6f, 6f), new float3(6f, 18f, 6f), new float3(6f, 18f, 7f),
                    new float3(6f, 18f, 8f) }.Select(p => p * Spacing).ToArray()).Step();
                DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                Assert.That(mesh.positions, Is.Empty);
                Assert.That(Kinds(fluid)[SurfaceElementKind.Drop], Is.EqualTo(6));
                Assert.That(mesh[SurfaceMesh.Counter.Drops], Is.EqualTo(6));
                uint[] arguments = GpuTest.Read<uint>(fluid.Solver.Mesh.Arguments, 4 * SurfaceMesh.MonoDropCommand + 8);
                Assert.That(arguments.Skip(4 * SurfaceMesh.MonoDropCommand).Take(8),
                    Is.EqualTo(new uint[] { 6 * 12 * 6, 1, 0, 0, 6 * 12 * 6, 2, 0, 0 }));
            }
        }

        // It has no neighbors yet: a fluid in its first frame or paused from the start, after a restore, and where a script has just removed some.
        [Test]
        public void What_no_step_has_moved_is_a_mesh_and_not_a_cloud_of_drops([ValueSource(nameof(Cells))] float cell)
        {
            using (TestFluid fluid = Still(32f, 6000))
            {
                fluid.Add(Ball(16f, 10f));
                DrawnMesh mesh = DrawnMesh.Of(fluid, cell);
                double radius = Math.Pow(fluid.Added * 0.75 / Math.PI, 1.0 / 3.0);
                double rms = Rms(mesh.positions.Select(p => math.distance(p, 16.0) - radius));
                TestContext.Out.WriteLine($"rms {rms:0.000} d, volume {mesh.Volume / fluid.Added:0.000}");
                Assert.That(Kinds(fluid)[SurfaceElementKind.Drop], Is.Zero);
                Assert.That(mesh.OpenEdges, Is.Zero);
                Assert.That(mesh.Volume / fluid.Added, Is.EqualTo(1.0).Within(0.1));
                Assert.That(rms, Is.LessThan(0.25));
            }
        }

        [Test]
        public void The_list_of_drops_names_those_elements_that_are_drops_and_each_knows_where_it_flies()
        {
            var velocity = new float3(1.5f, -0.5f, 0.75f);
            using (TestFluid fluid = Still(24f, 400))
            {
                fluid.Add(new[] { new float3(20f), new float3(4f, 20f, 20f), new float3(20f, 4f, 20f) }.Select(p => p * Spacing).ToArray(), velocity);
                fluid.Add(Ball(12f, 3f), velocity).Step();
                DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                float3 chord = velocity * (fluid.Input.timeStep / fluid.Solver.LastSubsteps / Spacing);
                AssertDrops(fluid, mesh, 3, chord);
                Assert.That(mesh.positions, Is.Not.Empty);
                var kinds = Kinds(fluid);
                fluid.Add(new[] { new float3(20f, 20f, 4f), new float3(4f) }.Select(p => p * Spacing).ToArray(), velocity);
                DrawnMesh after = DrawnMesh.Of(fluid, Medium);
                AssertDrops(fluid, after, 3, chord);
                // New particles have taken part in no step: they are not known to fly, and may belong to a jet.
                Assert.That(Kinds(fluid)[SurfaceElementKind.Surface], Is.EqualTo(kinds[SurfaceElementKind.Surface] + 2));
            }
        }

        static void AssertDrops(TestFluid fluid, DrawnMesh mesh, int count, float3 chord)
        {
            int drawn = (int)GpuTest.Read<uint>(fluid.Solver.Surface.Counters, 3)[(int)SurfaceParticles.Counter.Drawn];
            SurfaceParticles.Element[] elements = GpuTest.Read<SurfaceParticles.Element>(fluid.Solver.Surface.Particles, drawn);
            Assert.That(mesh[SurfaceMesh.Counter.Drops], Is.EqualTo(count));
            uint[] listed = GpuTest.Read<uint>(fluid.Solver.Mesh.Drops, count).OrderBy(i => i).ToArray();
            Assert.That(listed, Is.EqualTo(Enumerable.Range(0, drawn).Where(i => elements[i].b.x >> 24 == (uint)SurfaceElementKind.Drop)));
            Assert.That(listed.Select(i => elements[i].a.w).Distinct().Count(), Is.EqualTo(count), "ids");
            foreach (uint i in listed)
            {
                uint4 b = elements[i].b;
                var stored = new float3(Half(b.y), Half(b.y >> 16), Half(b.z));
                Assert.That(math.distance(stored, chord), Is.LessThan(0.03f * math.length(chord)),
                    $"displacement {stored} for {chord}, of {count} drops");
            }
        }

        // A filtered fetch reads one brick alone. Beyond it: another brick, all air, all water, and the end of the box.
        [Test]
        public void Each_brick_of_the_field_holds_the_first_nodes_of_those_beyond_it()
        {
            using (TestFluid fluid = Still(24f, 6000))
            {
                fluid.AddBlock(7f * Spacing, 24f * Spacing).Step();
                DrawnMesh.Of(fluid, Medium);
                var field = new ReadField(fluid.Solver.Mesh);
                var beyond = new HashSet<float>();
                foreach (int3 brick in field.Bricks)
                    for (int t = 0; t < 125; t++)
                    {
                        var local = new int3(t % 5, t / 5 % 5, t / 25);
                        float expected = field.IsIn(4 * brick + local) ? field[4 * brick + local] : -2f;
                        Assert.That(field.Stored(brick, local), Is.EqualTo(expected), $"brick {brick}, {local}");
                        if (math.any(local == 4))
                            beyond.Add(expected);
                    }
                Assert.That(beyond, Has.Some.EqualTo(2f).And.Some.EqualTo(-2f));
                Assert.That(beyond.Count, Is.GreaterThan(100));
            }
        }

        static float Half(uint bits) => UnityEngine.Mathf.HalfToFloat((ushort)(bits & 0xFFFF));

        [Test]
        public void The_field_beside_a_wall_is_that_of_the_water_and_its_mirror_image()
        {
            const float center = 18f;       // a wall there has the same nodes beside it as one at 0: 24 nodes of 0.75 d, whole bricks
            float3[] ball = Ball(center, 4f);
            ReadField Field(float3 box, IEnumerable<float3> positions)
            {
                using (TestFluid fluid = Still(box, 1000))
                {
                    fluid.Input.settings.iterations = 0;
                    fluid.Add(positions.ToArray()).Step();
                    DrawnMesh.Of(fluid, Medium);
                    return new ReadField(fluid.Solver.Mesh);
                }
            }
            var offset = new float3(center, 0f, 0f);
            ReadField whole = Field(2f * center, ball);
            ReadField half = Field(new float3(center, 2f * center, 2f * center),
                ball.Where(p => p.x > center * Spacing).Select(p => p - offset * Spacing));
            var errors = new List<double>();
            foreach (int3 node in half.Nodes)
            {
                if (node.x < 1 || node.x > 4)
                    continue;
                float expected = whole[node + new int3(24, 0, 0)];
                if (Math.Abs(expected) < 0.8f)
                    errors.Add(half[node] - expected);
            }
            TestContext.Out.WriteLine($"{errors.Count} nodes, {Rms(errors):0.0000} d rms, at most {errors.Max(e => Math.Abs(e)):0.000} d");
            Assert.That(errors.Count, Is.GreaterThan(100));
            Assert.That(Rms(errors), Is.LessThan(0.006));
            Assert.That(errors.Max(e => Math.Abs(e)), Is.LessThan(0.02));
        }

        [Test]
        public void Each_wall_is_shown_by_its_own_bit([Values(0, 1, 2, 3, 4, 5)] int wall)
        {
            using (TestFluid fluid = Still(new float3(9f, 8f, 7f), 600))
            {
                fluid.AddBlock(0f, new float3(9f, 8f, 7f) * Spacing).Step();
                DrawnMesh.Of(fluid, Medium);
                fluid.Solver.MeshWalls = 1 << wall;
                DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                double3 box = fluid.Solver.Layout.DomainSize;
                int axis = wall / 2;
                double area = box.x * box.y * box.z / box[axis];
                Assert.That(mesh.Area, Is.EqualTo(area).Within(0.01 * area));
                foreach (uint i in mesh.indices)
                    Assert.That(mesh.positions[i][axis], Is.EqualTo(wall % 2 == 0 ? 0.0 : box[axis]).Within(1e-3));
            }
        }

        [Test]
        public void Where_water_stood_before_what_no_step_has_moved_is_air()
        {
            using (TestFluid fluid = Still(24f, 4000))
            {
                fluid.AddBlock(4f * Spacing, 15f * Spacing).Step();
                DrawnMesh.Of(fluid, Medium);
                int3 bricks = fluid.Solver.Mesh.Bricks;
                Assert.That(GpuTest.Read<uint>(fluid.Solver.Mesh.Top, bricks.x * bricks.y * bricks.z), Has.Some.EqualTo(1u), "water");
                fluid.Solver.Clear();
                fluid.Add(new[] { new float3(2f) * Spacing });
                DrawnMesh.Of(fluid, Medium);
                Assert.That(GpuTest.Read<uint>(fluid.Solver.Mesh.Top, bricks.x * bricks.y * bricks.z), Has.None.EqualTo(1u));
            }
        }

        [Test]
        public void Few_particles_in_a_corner_are_drops_though_the_walls_mirror_them()
        {
            using (TestFluid fluid = Still(24f, 100))
            {
                fluid.Input.settings.iterations = 0;
                fluid.Add(new[] { new float3(0.5f), new float3(1.4f, 0.5f, 0.5f), new float3(0.5f, 0.5f, 1.4f) }
                    .Select(p => p * Spacing).ToArray()).Step();
                DrawnMesh.Of(fluid, Medium);
                Assert.That(Kinds(fluid)[SurfaceElementKind.Surface], Is.Zero);
                Assert.That(Kinds(fluid)[SurfaceElementKind.Drop], Is.EqualTo(3));
            }
        }

        [Test]
        public void Ghosts_that_no_step_has_moved_are_not_drawn()
        {
            using (TestFluid fluid = Still(24f, 100))
            {
                fluid.Add(new[] { new float3(6f), new float3(12f), new float3(18f) }.Select(p => p * Spacing).ToArray());
                UnityEngine.GraphicsBuffer ids = fluid.Solver.ParticleIds;
                uint[] words = GpuTest.Read<uint>(ids, 3);
                words[1] |= 0x80000000u;        // see Ghosts.hlsl
                ids.SetData(words, 0, 0, 3);
                DrawnMesh.Of(fluid, Medium);
                Assert.That(Kinds(fluid)[SurfaceElementKind.None], Is.EqualTo(1));
                Assert.That(Kinds(fluid)[SurfaceElementKind.Surface], Is.EqualTo(2));
            }
        }

        [Test]
        public void Water_at_the_walls_ends_in_their_planes_with_their_normals()
        {
            using (TestFluid fluid = Still(new float3(12.3f, 16f, 10f), 1000))
            {
                fluid.Input.gravity = new float3(0f, -9.81f, 0f);
                fluid.AddBlock(0f, new float3(12f, 8f, 10f) * Spacing).Step(60);
                DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                double3 box = fluid.Solver.Layout.DomainSize;
                int flat = 0, rim = 0;
                for (int i = 0; i < mesh.positions.Length; i++)
                {
                    double3 p = mesh.positions[i], beyond = math.min(p, box - p);
                    Assert.That(math.cmin(beyond), Is.GreaterThan(-1e-4), "in the box");
                    bool isRim = !mesh.areFlat[i] && math.cmin(beyond) < 1e-3 && p.y > 4.0;
                    rim += isRim ? 1 : 0;
                    Assert.That(isRim && mesh.normals[i].y < 0.9, Is.False, $"the surface's normal at the rim: {mesh.normals[i]} at {p}");
                    if (!mesh.areFlat[i])
                        continue;
                    flat++;
                    Assert.That(math.cmin(beyond), Is.LessThan(1e-3), "on a wall");
                    double3 onWalls = new double3(Sign(p.x, box.x), Sign(p.y, box.y), Sign(p.z, box.z));
                    if (math.dot(onWalls, onWalls) < 1.5)       // not in an edge of the box
                        Assert.That(math.distance(mesh.normals[i], onWalls), Is.LessThan(1e-3), $"at {p}");
                }
                Assert.That(flat, Is.GreaterThan(300));
                Assert.That(rim, Is.GreaterThan(30));
                Assert.That(mesh.Volume / fluid.Added, Is.EqualTo(1.0).Within(0.02));
                Assert.That(mesh.OpenEdges, Is.Zero);
                double whole = mesh.Area, top = box.x * box.z;
                fluid.Solver.MeshWalls = 0;
                DrawnMesh open = DrawnMesh.Of(fluid, Medium);
                Assert.That(open.Area, Is.EqualTo(top).Within(0.05 * top), $"without walls; {whole} with them");
                fluid.Solver.MeshWalls = 1 << 2;
                Assert.That(DrawnMesh.Of(fluid, Medium).Area - open.Area, Is.EqualTo(top).Within(0.01 * top), "the floor alone");
            }
        }

        [Test]
        public void The_surface_meets_the_walls_where_it_is_beside_them()
        {
            using (TestFluid fluid = Dam(deep: false))
            {
                DrawnMesh mesh = DrawnMesh.Of(fluid.Step(22), Medium);
                double3 box = fluid.Solver.Layout.DomainSize;
                foreach (double wall in new[] { 0.0, box.z })
                {
                    var errors = new List<double>();
                    for (int i = 0; i < mesh.positions.Length; i++)
                    {
                        double3 p = mesh.positions[i];
                        if (mesh.areFlat[i] || Math.Abs(p.z - wall) > 1e-3 || p.x < 3.0 || p.y < 1.5 || mesh.normals[i].y < 0.5)
                            continue;
                        double3[] beside = mesh.positions.Where((q, k) => mesh.normals[k].y > 0.5 && Math.Abs(q.x - p.x) < 0.5
                            && Math.Abs(q.z - wall) > 0.5 && Math.Abs(q.z - wall) < 2.0).ToArray();
                        if (beside.Length > 0)
                            errors.Add(beside.Average(q => q.y) - p.y);
                    }
                    TestContext.Out.WriteLine($"at {wall}: {errors.Count} vertices, {Rms(errors):0.000} d rms");
                    Assert.That(errors.Count, Is.GreaterThan(8));
                    Assert.That(errors.Count(e => Math.Abs(e) > 0.2), Is.LessThan(0.15 * errors.Count), "but for what falls on it");
                }
            }
        }

        [Test]
        public void The_mesh_of_the_same_water_is_the_same_on_every_run()
        {
            uint[] Words()
            {
                using (TestFluid fluid = Dam(deep: false))
                {
                    DrawnMesh mesh = DrawnMesh.Of(fluid.Step(25), Medium);
                    SurfaceMesh stage = fluid.Solver.Mesh;
                    return GpuTest.Read<uint>(stage.Vertices, mesh.positions.Length * SurfaceMesh.VertexBytes / sizeof(uint))
                        .Concat(mesh.indices).ToArray();
                }
            }
            uint[] first = Words();
            Assert.That(first.Length, Is.GreaterThan(10000));
            Assert.That(Words(), Is.EqualTo(first));
        }

        [Test]
        public void Vertices_move_as_the_water_does()
        {
            using (TestFluid fluid = Still(new float3(40f, 20f, 20f), 2000))
            {
                fluid.AddBlock(new float3(5f) * Spacing, new float3(10f) * Spacing, velocity: new float3(1.5f, 0f, 0.75f)).Step(3);
                DrawnMesh mesh = DrawnMesh.Of(fluid, Medium);
                double substep = fluid.Input.timeStep / fluid.Solver.LastSubsteps / Spacing;
                Assert.That(mesh.positions.Length, Is.GreaterThan(500));
                foreach (double3 displacement in mesh.displacements)
                    Assert.That(math.distance(displacement, new double3(1.5, 0.0, 0.75) * substep), Is.LessThan(0.02));
            }
        }

        [Test, Category("LongRun")]
        public void Still_water_has_a_mesh_that_stands()
        {
            using (TestFluid fluid = Still(new float3(20f, 16f, 20f), 2000))
            {
                fluid.Input.gravity = new float3(0f, -9.81f, 0f);
                fluid.AddBlock(0f, new float3(20f, 5f, 20f) * Spacing).Step(300);
                for (int i = 0; i < 20; i++)
                    DrawnMesh.Of(fluid.Step(), Medium);
                DrawnMesh before = DrawnMesh.Of(fluid.Step(), Medium), after = DrawnMesh.Of(fluid.Step(), Medium);
                double[] moved = before.positions.Where((p, i) => !before.areFlat[i])
                    .Select(p => after.positions.Min(q => math.distance(p, q))).OrderBy(x => x).ToArray();
                double rms = Rms(moved), most = moved[(int)(0.999 * (moved.Length - 1))];
                TestContext.Out.WriteLine($"from a frame to the next {rms:0.0000} d rms, 99.9 % below {most:0.0000} d");
                Assert.That(rms, Is.LessThan(0.001));
                Assert.That(most, Is.LessThan(0.004));
            }
        }

        [Test]
        public void What_has_no_room_is_counted_and_has_it_once_the_mesh_is_enlarged()
        {
            var random = new Random(7);
            using (TestFluid fluid = Still(64f, 6480))
            {
                DrawnMesh mesh = DrawnMesh.Recorded(fluid.Add(Clumps(random).ToArray()).Step(), 0.5f);
                Assert.That(mesh[SurfaceMesh.Counter.BricksNeeded], Is.GreaterThan(mesh[SurfaceMesh.Counter.Bricks]));
                Assert.That(mesh[SurfaceMesh.Counter.Bricks], Is.EqualTo(fluid.Solver.Mesh.BrickCapacity));
                Assert.That(mesh.OpenEdges, Is.Zero, "it ends where the bricks do");
                Assert.That(fluid.Solver.Mesh.Enlarge(mesh.counters), Is.True);
                mesh = DrawnMesh.Recorded(fluid, 0.5f);
                Assert.That(mesh[SurfaceMesh.Counter.VerticesNeeded], Is.GreaterThan(mesh[SurfaceMesh.Counter.Vertices]));
                Assert.That(mesh.positions.Length, Is.InRange(fluid.Solver.Mesh.VertexCapacity / 2, fluid.Solver.Mesh.VertexCapacity));
                double off = mesh.positions.Max(p => math.cmax(math.abs((p - 1.0) % 6.0 - 3.0)));
                Assert.That(off, Is.LessThan(2.6), "d from a clump's center: none is drawn towards a vertex that has no room");
                Assert.That(fluid.Solver.Mesh.Enlarge(mesh.counters), Is.True);
                mesh = DrawnMesh.Recorded(fluid, 0.5f);
                Assert.That(mesh[SurfaceMesh.Counter.Vertices], Is.EqualTo(mesh[SurfaceMesh.Counter.VerticesNeeded]));
                Assert.That(mesh[SurfaceMesh.Counter.Bricks], Is.EqualTo(mesh[SurfaceMesh.Counter.BricksNeeded]));
                Assert.That(mesh.OpenEdges, Is.Zero);
                Assert.That(fluid.Solver.Mesh.Enlarge(mesh.counters), Is.False, "there is room");
            }
        }

        [Test]
        public void The_finest_mesh_that_is_asked_for_serves_all_with_the_walls_of_all([Values] bool finestFirst)
        {
            using (SourceScene scene = new SourceScene(Vector3.one, Spacing, 2000).Fill(0.2f))
            {
                FluidSimulation fluid = scene.Fluid;
                fluid.Results.Surface.Requesting += () =>
                {
                    fluid.Results.Surface.IsNeeded = true;
                    fluid.Results.Surface.RequestMesh(finestFirst ? 0.5f : 1f, BoxWalls.Left);
                    fluid.Results.Surface.RequestMesh(finestFirst ? 1f : 0.5f, BoxWalls.Top);
                };
                scene.Step(2);
                Assert.That((fluid.Solver.Mesh.Cell, fluid.Solver.MeshWalls), Is.EqualTo((0.5f, (int)(BoxWalls.Left | BoxWalls.Top))));
            }
        }

        // No step finds it again there, and the buffers with more room hold nothing.
        [Test]
        public void A_mesh_that_lacks_room_is_whole_after_a_few_frames_also_while_the_fluid_stands()
        {
            var random = new Random(7);
            using (var scene = new SourceScene(64f * Spacing * Vector3.one, Spacing, 6480))
            {
                FluidSimulation fluid = scene.Fluid;
                fluid.Gravity = Vector3.zero;
                fluid.Results.Surface.Requesting += () =>
                {
                    fluid.Results.Surface.IsNeeded = true;
                    fluid.Results.Surface.RequestMesh(0.5f, BoxWalls.All);
                };
                using (var positions = new NativeArray<float3>(Clumps(random).Select(p => p - 32f * Spacing).ToArray(), Allocator.Persistent))
                using (var velocities = new NativeArray<float3>(positions.Length, Allocator.Persistent))
                    fluid.AddParticles(positions, velocities);
                scene.Step();
                fluid.Paused = true;
                uint[] first = GpuTest.Read<uint>(fluid.Solver.Mesh.Counters, Enum.GetValues(typeof(SurfaceMesh.Counter)).Length);
                Assert.That(first[(int)SurfaceMesh.Counter.Bricks], Is.LessThan(first[(int)SurfaceMesh.Counter.BricksNeeded]));
                for (int frame = 0; frame < 6; frame++)
                {
                    AsyncGPUReadback.WaitAllRequests();
                    scene.Step();
                }
                uint[] last = GpuTest.Read<uint>(fluid.Solver.Mesh.Counters, first.Length);
                Assert.That(last[(int)SurfaceMesh.Counter.Bricks], Is.EqualTo(first[(int)SurfaceMesh.Counter.BricksNeeded]));
                Assert.That(last[(int)SurfaceMesh.Counter.Vertices], Is.EqualTo(last[(int)SurfaceMesh.Counter.VerticesNeeded]).And.GreaterThan(0));
                Assert.That(last[(int)SurfaceMesh.Counter.Quads], Is.EqualTo(last[(int)SurfaceMesh.Counter.QuadsNeeded]).And.GreaterThan(0));
            }
        }

        // Clumps of 27 particles each, far apart in a box of 64 d, m.
        static List<float3> Clumps(Random random)
        {
            var positions = new List<float3>();
            for (int clump = 0; clump < 240; clump++)
            {
                float3 at = 3f + 6f * new float3(clump % 10, clump / 10 % 6, clump / 60);
                for (int k = 0; k < 27; k++)
                    positions.Add((at + new float3(k % 3, k / 3 % 3, k / 9) + random.NextFloat3(-0.02f, 0.02f)) * Spacing);
            }
            return positions;
        }

        // The first frames of a splash may lack one of the three alone.
        [TestCase(SurfaceMesh.Counter.BricksNeeded)]
        [TestCase(SurfaceMesh.Counter.VerticesNeeded)]
        [TestCase(SurfaceMesh.Counter.QuadsNeeded)]
        public void What_lacks_room_gets_a_quarter_more_than_it_needs_and_nothing_else_does(object lacks)
        {
            int which = (int)lacks;     // of an internal type
            using (TestFluid fluid = Still(16f, 100))
            {
                DrawnMesh.Recorded(fluid.Add(new[] { new float3(8f) * Spacing }).Step(), 0.5f);
                SurfaceMesh mesh = fluid.Solver.Mesh;
                var room = new Dictionary<SurfaceMesh.Counter, int>
                {
                    { SurfaceMesh.Counter.BricksNeeded, mesh.BrickCapacity },
                    { SurfaceMesh.Counter.VerticesNeeded, mesh.VertexCapacity },
                    { SurfaceMesh.Counter.QuadsNeeded, mesh.QuadCapacity },
                };
                var needed = new uint[Enum.GetValues(typeof(SurfaceMesh.Counter)).Length];
                foreach (SurfaceMesh.Counter counter in room.Keys)
                    needed[(int)counter] = (uint)room[counter];
                Assert.That(mesh.Enlarge(needed), Is.False, "just enough");
                needed[which]++;
                Assert.That(mesh.Enlarge(needed), Is.True);
                room[(SurfaceMesh.Counter)which] = (int)needed[which] + (int)needed[which] / 4;
                Assert.That(new[] { mesh.BrickCapacity, mesh.VertexCapacity, mesh.QuadCapacity }, Is.EqualTo(room.Values));
                Assert.That(mesh.Enlarge(needed), Is.False, "there is room");
            }
        }

        [Test]
        public void A_box_with_too_many_bricks_is_refused_by_its_message()
        {
            var layout = new SolverLayout(new float3(8000f, 8000f, 4f), 1f, 100, 60, 1.1f, GpuBuffer.MaxBytes);
            using (var workspace = new SurfaceWorkspace())
            {
                var problem = Assert.Throws<ArgumentOutOfRangeException>(() => new SurfaceMesh(layout, workspace, 0.25f));
                Assert.That(problem.Message, Does.Contain("bricks of the water's mesh").And.Contain("Lower the quality of the surface"));
            }
        }

        static TestFluid Still(float3 box, int capacity)
        {
            var fluid = new TestFluid(box * Spacing, Spacing, capacity);
            fluid.Input.gravity = 0f;
            return fluid;
        }

        static TestFluid Dam(bool deep)
        {
            var fluid = new TestFluid(new float3(24f, 20f, 8f) * Spacing, Spacing, 2000);
            if (deep)
            {
                fluid.Input.settings.deepWater = DeepWater.On;
                fluid.Input.settings.iterations = 2;
            }
            return fluid.AddBlock(0f, new float3(10f, 16f, 8f) * Spacing);
        }

        static float3[] Ball(float center, float radius)
        {
            var positions = new List<float3>();
            for (float z = center - radius; z < center + radius; z++)
                for (float y = center - radius; y < center + radius; y++)
                    for (float x = center - radius; x < center + radius; x++)
                    {
                        float3 p = math.floor(new float3(x, y, z)) + 0.5f;
                        if (math.distance(p, center) < radius)
                            positions.Add(p * Spacing);
                    }
            return positions.ToArray();
        }

        enum SurfaceElementKind { None, Surface, Wall, Drop }

        // How many elements there are of each kind; see SurfaceElement.hlsl.
        static Dictionary<SurfaceElementKind, int> Kinds(TestFluid fluid)
        {
            int drawn = (int)GpuTest.Read<uint>(fluid.Solver.Surface.Counters, 3)[(int)SurfaceParticles.Counter.Drawn];
            SurfaceParticles.Element[] elements = GpuTest.Read<SurfaceParticles.Element>(fluid.Solver.Surface.Particles, drawn);
            return Enum.GetValues(typeof(SurfaceElementKind)).Cast<SurfaceElementKind>()
                .ToDictionary(kind => kind, kind => elements.Count(e => e.b.x >> 24 == (uint)kind));
        }

        // They are of length 1 and look to where the triangles do.
        // Returns how many triangles have normals that are reversed.
        static int AssertNormals(DrawnMesh mesh, double fraction, string at)
        {
            int against = 0;
            for (int i = 0; i < mesh.indices.Length; i += 3)
            {
                double3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]], c = mesh.positions[mesh.indices[i + 2]];
                double3 face = math.cross(b - a, c - a);
                if (math.length(face) > 0.05)
                {
                    double3 sum = mesh.normals[mesh.indices[i]] + mesh.normals[mesh.indices[i + 1]] + mesh.normals[mesh.indices[i + 2]];
                    against += math.dot(face, sum) < 0.0 ? 1 : 0;
                }
            }
            Assert.That(against, Is.LessThan(fraction * mesh.indices.Length / 3 + 1), $"triangles whose normals are reversed, {at}");
            foreach (double3 normal in mesh.normals)
                Assert.That(math.length(normal), Is.EqualTo(1.0).Within(1e-3));
            return against;
        }

        // Squares of d² through which nothing is met from above.
        static int HolesSeenFromAbove(DrawnMesh mesh, int from, int to)
        {
            var seen = new HashSet<(int, int)>();
            for (int i = 0; i < mesh.indices.Length; i += 3)
            {
                double3 p = (mesh.positions[mesh.indices[i]] + mesh.positions[mesh.indices[i + 1]] + mesh.positions[mesh.indices[i + 2]]) / 3.0;
                seen.Add(((int)math.floor(p.x), (int)math.floor(p.z)));
            }
            int holes = 0;
            for (int z = from; z < to; z++)
                for (int x = from; x < to; x++)
                    holes += seen.Contains((x, z)) ? 0 : 1;
            return holes;
        }

        static double Sign(double x, double size) => x < 1e-3 ? -1.0 : x > size - 1e-3 ? 1.0 : 0.0;
        static double Rms(IEnumerable<double> values) => Math.Sqrt(values.Average(x => x * x));
        static double Angle(double3 a, double3 b) => Math.Acos(math.clamp(math.dot(a, b), -1.0, 1.0));

        /// <summary>The field's nodes, read back.</summary>
        sealed class ReadField
        {
            readonly int3 bricks;
            readonly uint[] top;
            readonly ushort[] texels;
            readonly int width;

            public ReadField(SurfaceMesh mesh)
            {
                bricks = mesh.Bricks;
                top = GpuTest.Read<uint>(mesh.Top, bricks.x * bricks.y * bricks.z);
                AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(mesh.Field);
                request.WaitForCompletion();
                width = mesh.Field.width;
                int layer = width * width;
                texels = new ushort[layer * request.layerCount];
                for (int z = 0; z < request.layerCount; z++)
                    NativeArray<ushort>.Copy(request.GetData<ushort>(z), 0, texels, layer * z, layer);
            }

            public IEnumerable<int3> Nodes => from z in Enumerable.Range(0, 4 * bricks.z)
                                              from y in Enumerable.Range(0, 4 * bricks.y)
                                              from x in Enumerable.Range(0, 4 * bricks.x)
                                              select new int3(x, y, z);

            /// <summary>Coordinates of the bricks that exist.</summary>
            public IEnumerable<int3> Bricks => Nodes.Where(node => math.all(node % 4 == 0) && Top(node / 4) >= 2).Select(node => node / 4);

            public bool IsIn(int3 node) => math.all(node >= 0) && math.all(node < 4 * bricks);

            /// <summary>Distance of a node from the surface, d; 2 or -2 where no brick is.</summary>
            public float this[int3 node] => Top(node / 4) < 2 ? Top(node / 4) == 1 ? 2f : -2f : Stored(node / 4, node % 4);

            /// <summary>Value stored in a brick that exists, local 0 to 4.</summary>
            public float Stored(int3 brick, int3 local)
            {
                uint number = Top(brick) - 2;
                int3 texel = 5 * (int3)new uint3(number % 32, number / 32 % 32, number / 1024) + local;
                return UnityEngine.Mathf.HalfToFloat(texels[(texel.z * width + texel.y) * width + texel.x]);
            }

            uint Top(int3 brick) => top[(brick.z * bricks.y + brick.y) * bricks.x + brick.x];
        }
    }
}
