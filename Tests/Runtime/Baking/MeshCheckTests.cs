using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    public class MeshCheckTests
    {
        static string All(MeshReport report) => string.Join("\n", report.Texts);

        [Test]
        public void A_closed_mesh_has_no_faults()
        {
            foreach (TriangleMesh mesh in new[] { TestMeshes.Box(Vector3.one), TestMeshes.Torus(1f, 0.4f, 12) })
            {
                MeshReport report = MeshCheck.Run(mesh);
                Assert.That(report.IsWatertight, mesh.Name);
                Assert.That(report.Problem, Is.Null);
                Assert.That((report.BoundaryEdges, report.Holes, report.NonManifoldEdges, report.InconsistentEdges, report.FlippedTriangles,
                    report.ZeroAreaTriangles, report.SelfIntersections),
                    Is.EqualTo((0, 0, 0, 0, 0, 0, 0)), mesh.Name);
                Assert.That(report.SelfIntersectionsChecked, Is.EqualTo(1f));
                Assert.That(report.Sign, Is.EqualTo(MeshSdfSign.WindingNumber));
            }
            Assert.That(MeshCheck.Run(TestMeshes.Box(Vector3.one)).Texts, Is.Empty);
        }

        [Test]
        public void Area_and_volume_are_those_of_the_shape()
        {
            MeshReport report = MeshCheck.Run(TestMeshes.Box(new Vector3(1f, 2f, 3f), new Vector3(50f, 0f, 0f)));
            Assert.That(report.Area, Is.EqualTo(22).Within(1e-6));
            Assert.That(report.SignedVolume, Is.EqualTo(6).Within(1e-5));
        }

        [Test]
        public void Seams_are_welded_and_counted()
        {
            TriangleMesh sphere = TestMeshes.Sphere(1f, 8);
            MeshReport report = MeshCheck.Run(sphere);
            Assert.That(report.DuplicateVertices, Is.EqualTo(7 + 2 * 16), "the seam and the poles");
            Assert.That(report.IsWatertight);
            Assert.That(report.ZeroAreaTriangles, Is.EqualTo(2 * 16), "at the poles");
            Assert.That(All(report), Does.Contain("39 of 153 vertices lie exactly at another's place").And.Contain(
                "32 triangles have no area: left out"));
        }

        [Test]
        public void Holes_are_counted_with_their_edges_and_their_share_of_the_surface()
        {
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            MeshReport one = MeshCheck.Run(box.Without(t => t == 3));
            Assert.That((one.Holes, one.BoundaryEdges), Is.EqualTo((1, 3)));
            Assert.That(one.HoleFraction, Is.EqualTo(0.5 / 6).Within(1e-6));
            Assert.That(one.Sign, Is.EqualTo(MeshSdfSign.WindingNumber));
            Assert.That(All(one), Does.Contain("1 holes with 3 edges, 8.3 % of the surface: closed smoothly"));

            MeshReport lid = MeshCheck.Run(box.Without(t => t == 6 || t == 7));
            Assert.That((lid.Holes, lid.BoundaryEdges), Is.EqualTo((1, 4)));
            Assert.That(lid.HoleFraction, Is.EqualTo(1.0 / 6).Within(1e-6));
            Assert.That(lid.Sign, Is.EqualTo(MeshSdfSign.OpenShell));
            Assert.That(All(lid), Does.Contain("baked as an open shell"));

            Assert.That(MeshCheck.Run(TestMeshes.Tube(1f, 2f, 12, 3)).Holes, Is.EqualTo(2));
        }

        [Test]
        public void Both_sides_of_a_sheet_have_no_volume()
        {
            TriangleMesh sheet = TestMeshes.Sheet(1f);
            MeshReport report = MeshCheck.Run(TriangleMesh.Combine("Two sides", new[] { sheet, sheet.Turned(t => true) }));
            Assert.That(report.Sign, Is.EqualTo(MeshSdfSign.OpenShell));
            Assert.That(All(report), Does.Contain("no volume"));
        }

        [Test]
        public void Flipped_triangles_are_found_wherever_the_walk_starts()
        {
            TriangleMesh torus = TestMeshes.Torus(1f, 0.4f, 10);
            foreach (Func<int, bool> rule in new Func<int, bool>[] { t => t < 3, t => t == 100, t => t % 17 == 0 })
            {
                MeshReport report = MeshCheck.Run(torus.Turned(rule));
                Assert.That(report.FlippedTriangles, Is.EqualTo(Enumerable.Range(0, torus.TriangleCount).Count(rule)));
                Assert.That(report.InconsistentEdges, Is.GreaterThan(0));
                Assert.That(report.SignedVolume, Is.EqualTo(MeshCheck.Run(torus).SignedVolume).Within(1e-6));
                Assert.That(All(report), Does.Contain($"{report.FlippedTriangles} triangles face the other side").And.Contain("turned over"));
            }
        }

        [Test]
        public void A_mesh_that_is_inside_out_is_told()
        {
            MeshReport report = MeshCheck.Run(TestMeshes.Box(Vector3.one).Turned(t => true));
            Assert.That(report.IsInsideOut);
            Assert.That(report.FlippedTriangles, Is.EqualTo(0));
            Assert.That(All(report), Does.Contain("inside out"));
        }

        [Test]
        public void A_band_with_one_twist_cannot_be_turned_right()
        {
            TriangleMesh strip = TestMeshes.Make("Twisted", (u, v) =>
            {
                double turn = Math.PI * u, r = 1 + (v - 0.5) * Math.Cos(turn);
                return new double3(r * Math.Cos(2 * turn), (v - 0.5) * Math.Sin(turn), r * Math.Sin(2 * turn));
            }, 20, 2, wrapsAlong: false);
            // The last column meets the first one upside down.
            int[] triangles = strip.Triangles.Select(i => i % 21 == 20 ? (2 - i / 21) * 21 : i).ToArray();
            MeshReport report = MeshCheck.Run(new TriangleMesh("Twisted", strip.Vertices, triangles));
            Assert.That(report.Holes, Is.EqualTo(1));
            Assert.That(report.InconsistentEdges, Is.GreaterThan(0));
        }

        [Test]
        public void Edges_of_more_than_two_triangles_are_counted()
        {
            MeshReport report = MeshCheck.Run(TriangleMesh.Combine("Fin", new[] { TestMeshes.Box(Vector3.one), new TriangleMesh("Fin", new[]
            {
                new Vector3(-0.5f, 0.5f, -0.5f), new Vector3(0.5f, 0.5f, -0.5f), new Vector3(0f, 2f, -0.5f),
            }, new[] { 0, 2, 1 }) }));
            Assert.That(report.NonManifoldEdges, Is.EqualTo(1));
            Assert.That(report.IsWatertight, Is.False);
            Assert.That(All(report), Does.Contain("1 edges have more than two triangles"));
        }

        [Test]
        public void Triangles_that_cross_are_counted_as_pairs()
        {
            // A small box half in a large one's top: 8 edges of its sides pierce the two triangles there.
            TriangleMesh mesh = TriangleMesh.Combine("Crossing",
                new[] { TestMeshes.Box(Vector3.one), TestMeshes.Box(0.2f * Vector3.one, new Vector3(0.11f, 0.5f, -0.03f)) });
            MeshReport report = MeshCheck.Run(mesh);
            Assert.That(report.SelfIntersections, Is.EqualTo(Crossing(mesh)).And.GreaterThan(7));
            Assert.That(All(report), Does.Contain($"{report.SelfIntersections} pairs of triangles cross"));

            TriangleMesh rings = TriangleMesh.Combine("Rings",
                new[] { TestMeshes.Torus(1f, 0.4f, 14),
                TestMeshes.Torus(1f, 0.4f, 13).Transformed(Matrix4x4.Translate(new Vector3(0.63f, 0.11f, 0.27f))) });
            Assert.That(MeshCheck.Run(rings).SelfIntersections, Is.EqualTo(Crossing(rings)).And.GreaterThan(30),
                "found by the grid as by every pair");
        }

        // Every pair of triangles without a common corner.
        static int Crossing(TriangleMesh mesh)
        {
            double3 At(int t, int k) => (float3)mesh.Vertices[mesh.Triangles[3 * t + k % 3]];
            bool Pierces(int a, int k, int b)
            {
                double3 p = At(a, k), q = At(a, k + 1), o = At(b, 0), u = At(b, 1) - o, v = At(b, 2) - o, d = q - p;
                double3 n = math.cross(u, v);
                double facing = math.dot(n, d);
                if (facing == 0)
                    return false;
                double s = math.dot(n, o - p) / facing;
                double3 hit = p + s * d - o;
                double area = math.lengthsq(n);
                double x = math.dot(math.cross(hit, v), n) / area, y = math.dot(math.cross(u, hit), n) / area;
                return s > 0 && s < 1 && x > 0 && y > 0 && x + y < 1;
            }
            int count = 0;
            for (int a = 0; a < mesh.TriangleCount; a++)
                for (int b = a + 1; b < mesh.TriangleCount; b++)
                    count += !Enumerable.Range(0, 9).Any(k => At(a, k / 3).Equals(At(b, k)))
                        && Enumerable.Range(0, 3).Any(k => Pierces(a, k, b) || Pierces(b, k, a)) ? 1 : 0;
            return count;
        }

        [Test]
        public void A_mesh_too_large_for_all_its_crossings_says_how_much_was_seen()
        {
            MeshReport report = MeshCheck.Run(TestMeshes.Torus(1f, 0.4f, 20), maxCrossingTests: 500);
            Assert.That(report.SelfIntersectionsChecked, Is.InRange(0f, 0.9f));
            Assert.That(All(report), Does.Contain("The mesh is large"));
        }

        [Test]
        public void Vertices_that_are_no_numbers_are_counted_and_refused_where_triangles_use_them()
        {
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            box.Vertices[7] = new Vector3(float.PositiveInfinity, 0f, 0f);
            MeshReport report = MeshCheck.Run(box);
            Assert.That((report.NonFiniteVertices, report.NonFiniteTriangles), Is.EqualTo((1, 3)));
            Assert.That(report.Problem, Does.Contain("3 of 12 triangles").And.Contain("repair"));

            Vector3[] more = TestMeshes.Box(Vector3.one).Vertices.Concat(new[] { new Vector3(float.NaN, 0f, 0f) }).ToArray();
            MeshReport unused = MeshCheck.Run(new TriangleMesh("Unused", more, box.Triangles));
            Assert.That(unused.Problem, Is.Null);
            Assert.That(unused.SignedVolume, Is.EqualTo(1).Within(1e-6));
            Assert.That(All(unused), Does.Contain("no triangle uses them"));
        }

        [Test]
        public void No_triangles_and_triangles_without_area_are_refused()
        {
            Assert.That(MeshCheck.Run(new TriangleMesh("Nothing", new Vector3[0], new int[0])).Problem, Does.Contain("'Nothing' has no triangles"));
            MeshReport flat = MeshCheck.Run(new TriangleMesh("Flat", new[] { Vector3.zero, Vector3.one, 2 * Vector3.one }, new[] { 0, 1, 2 }));
            Assert.That(flat.ZeroAreaTriangles, Is.EqualTo(1));
            Assert.That(flat.Problem, Does.Contain("none of its 1 triangles has an area"));
        }

        [Test]
        public void Submeshes_are_counted_with_those_of_lines()
        {
            var mesh = new Mesh { name = "Parts", vertices = TestMeshes.Box(Vector3.one).Vertices, subMeshCount = 3 };
            mesh.SetIndices(TestMeshes.Box(Vector3.one).Triangles, MeshTopology.Triangles, 0);
            mesh.SetIndices(new[] { 0, 1 }, MeshTopology.Lines, 1);
            mesh.SetIndices(new[] { 0, 1, 3, 2 }, MeshTopology.Quads, 2);
            MeshReport report = MeshCheck.Run(mesh);
            Assert.That((report.SubMeshes, report.SubMeshesWithoutTriangles, report.Triangles), Is.EqualTo((3, 1, 14)));
            Assert.That(All(report), Does.Contain("3 submeshes").And.Contain("1 submeshes of points or lines: left out"));
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        [Test]
        public void The_check_tells_how_far_it_is_and_can_be_canceled_at_each_stage()
        {
            TriangleMesh mesh = TestMeshes.Torus(1f, 0.4f, 60);
            var told = new List<(float fraction, string stage)>();
            MeshReport report = MeshCheck.Run(mesh, MeshCheck.MaxCrossingTests, (fraction, stage) =>
            {
                told.Add((fraction, stage));
                return true;
            });
            Assert.That(report.Triangles, Is.EqualTo(MeshCheck.Run(mesh).Triangles));
            Assert.That(told.Select(one => one.fraction), Is.Ordered.And.All.InRange(0f, 1f));
            Assert.That(told.Select(one => one.stage).Distinct().Count(), Is.EqualTo(2));
            foreach (string stage in told.Select(one => one.stage).Distinct())
                Assert.That(MeshCheck.Run(mesh, MeshCheck.MaxCrossingTests, (fraction, now) => now != stage), Is.Null, stage);
        }

        [Test]
        public void A_mesh_without_vertices_has_no_triangles()
        {
            var mesh = new Mesh { name = "Empty" };
            Assert.That(TriangleMesh.Of(mesh).TriangleCount, Is.Zero);
            Assert.That(MeshCheck.Run(mesh).Problem, Does.Contain("'Empty' has no triangles"));
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        [Test]
        public void A_mesh_that_cannot_be_read_says_what_to_switch()
        {
            var mesh = new Mesh
            {
                name = "Sealed", vertices = TestMeshes.Box(Vector3.one).Vertices,
                triangles = TestMeshes.Box(Vector3.one).Triangles
            };
            mesh.UploadMeshData(true);
            Assert.That(Assert.Throws<ArgumentException>(() => MeshCheck.Run(mesh)).Message,
                Does.Contain("'Sealed'").And.Contain("Read/Write").And.Contain("in the editor"));
            Assert.That(Assert.Throws<ArgumentNullException>(() => MeshCheck.Run((Mesh)null)).Message, Does.Contain("no mesh"));
            UnityEngine.Object.DestroyImmediate(mesh);
        }
    }
}
