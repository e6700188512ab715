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
            Assert.That(All(report), Does.Contain("39 of 153 vertices lie exactly at another's position").And.Contain(
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

        static IEnumerable<(string, TriangleMesh, float)> NearlyClosed()
        {
            TriangleMesh box = TestMeshes.Box(new Vector3(1f, 0.7f, 0.4f));
            yield return ("1e-7 of the size", box, 1e-7f);
            yield return ("5e-6 of the size", box, 5e-6f);
            yield return ("in micrometers", box.Shrunk(1e-6f), 1e-12f);
            yield return ("in kilometers", box.Shrunk(1e3f), 1e-3f);
            yield return ("where coordinates are rounded to 8 mm", TestMeshes.Box(Vector3.one, new Vector3(1e5f, -9e4f, 3f)), 4e-3f);
            yield return ("of many triangles", TestMeshes.Torus(1f, 0.4f, 60), 3e-6f);
            yield return ("a plate of 1e-4 of its size", TestMeshes.Box(new Vector3(1f, 1e-4f, 1f)), 2e-6f);
        }

        [Test]
        public void Corners_that_lie_almost_at_one_place_are_one()
        {
            foreach ((string what, TriangleMesh mesh, float distance) in NearlyClosed())
            {
                MeshReport exact = MeshCheck.Run(mesh), report = MeshCheck.Run(mesh.Apart(distance));
                Assert.That((report.IsWatertight, report.Holes, report.InconsistentEdges, report.FlippedTriangles, report.Sign),
                    Is.EqualTo((true, 0, 0, 0, MeshSdfSign.WindingNumber)), what);
                Assert.That(report.Vertices - report.DuplicateVertices - report.JoinedVertices,
                    Is.EqualTo(exact.Vertices - exact.DuplicateVertices), $"{what}: none too many");
                Assert.That(exact.JoinedVertices, Is.Zero);
                Assert.That(All(report), Does.Contain("almost at another's position").And.Not.Contain("holes"), what);
                Assert.That(report.SelfIntersections, Is.Zero, what);
            }
        }

        [Test]
        public void Gaps_that_are_wider_stay_holes()
        {
            foreach (float distance in new[] { 2e-4f, 1e-2f })
            {
                MeshReport report = MeshCheck.Run(TestMeshes.Box(Vector3.one).Apart(distance));
                Assert.That((report.Holes, report.BoundaryEdges, report.JoinedVertices, report.Sign), Is.EqualTo((12, 36, 0, MeshSdfSign.OpenShell)));
            }
            // Each triangle of a small model is a hole that can be seen through, though beside a large plane it is next to nothing.
            TriangleMesh torus = TestMeshes.Torus(0.1f, 0.04f, 8);
            var corners = torus.Triangles.Select((v, i) => Vector3.Lerp(torus.Vertices[v], torus.CenterOf(i / 3), 0.05f)).ToArray();
            var gaps = new TriangleMesh("Gaps", corners, Enumerable.Range(0, corners.Length).ToArray());
            MeshReport beside = MeshCheck.Run(TriangleMesh.Combine("Beside a plane", new[] { gaps, TestMeshes.Sheet(1e4f) }));
            Assert.That((beside.BoundaryEdges, beside.JoinedVertices), Is.EqualTo((3 * gaps.TriangleCount + 4, 0)));
        }

        [Test]
        public void Corners_are_joined_as_by_comparing_every_pair()
        {
            // Clouds of corners somewhat wider than what is joined: some are chains, and some fall into two.
            TriangleMesh mesh = TestMeshes.Sphere(1f, 6).Apart(6e-5f);
            double most = MeshCheck.Run(mesh).JoinDistance;
            Assert.That(most, Is.EqualTo(2e-5).Within(1e-6));
            int[] set = Enumerable.Range(0, mesh.Vertices.Length).ToArray();
            int joined = 0;
            for (int a = 0; a < set.Length; a++)
                for (int b = 0; b < a; b++)
                {
                    double3 apart = math.abs((double3)(float3)mesh.Vertices[a] - (float3)mesh.Vertices[b]);
                    if (math.cmax(apart) > most || set[a] == set[b])
                        continue;
                    joined++;
                    int from = set[a], to = set[b];
                    for (int i = 0; i < set.Length; i++)
                        set[i] = set[i] == from ? to : set[i];
                }
            Assert.That(MeshCheck.Run(mesh).JoinedVertices, Is.EqualTo(joined).And.GreaterThan(100));
            Assert.That(MeshCheck.Run(mesh).BoundaryEdges, Is.GreaterThan(0));
        }

        [Test]
        public void Closed_meshes_are_left_alone_however_small_their_parts_are()
        {
            TriangleMesh mesh = TriangleMesh.Combine("Plate and speck",
                new[] { TestMeshes.Box(new Vector3(1f, 2e-6f, 1f)), TestMeshes.Box(1e-6f * Vector3.one, new Vector3(0f, 0.1f, 0f)) });
            MeshReport report = MeshCheck.Run(mesh);
            Assert.That((report.IsWatertight, report.JoinedVertices, report.DuplicateVertices), Is.EqualTo((true, 0, 0)));
        }

        [Test]
        public void A_triangle_whose_corners_are_joined_does_not_part_its_neighbors()
        {
            // A box with an edge that is a strip of two slivers, and every triangle apart.
            var vertices = new List<Vector3>(TestMeshes.Box(Vector3.one).Vertices);
            int[] triangles = TestMeshes.Box(Vector3.one).Triangles;
            vertices.Add(vertices[0] + new Vector3(0f, 0f, 2e-6f));
            vertices.Add(vertices[1] + new Vector3(0f, 0f, 2e-6f));
            for (int i = 18; i < triangles.Length; i++)        // the floor and the sides that stand on the strip's other edge
                triangles[i] = triangles[i] == 0 && i >= 24 && i < 30 ? 8 : triangles[i] == 1 && i >= 30 ? 9 : triangles[i];
            for (int i = 12; i < 18; i++)
                triangles[i] = triangles[i] == 0 ? 8 : triangles[i] == 1 ? 9 : triangles[i];
            var mesh = new TriangleMesh("Strip", vertices.ToArray(), triangles.Concat(new[] { 0, 1, 8, 1, 9, 8 }).ToArray());
            MeshReport report = MeshCheck.Run(mesh.Apart(2e-7f));
            Assert.That((report.IsWatertight, report.FlippedTriangles), Is.EqualTo((true, 0)));
        }

        [Test]
        public void Corners_on_edges_bound_no_area()
        {
            // The top of a box as three triangles, of which two have a common corner on an edge that the side knows as one.
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            var vertices = box.Vertices.Concat(new[] { new Vector3(0.1f, 0.5f, 0.5f) }).ToArray();
            int[] triangles = box.Triangles.Take(21).Concat(new[] { 3, 6, 8, 3, 8, 7 }).Concat(box.Triangles.Skip(24)).ToArray();
            MeshReport report = MeshCheck.Run(new TriangleMesh("T", vertices, triangles));
            Assert.That((report.BoundaryEdges, report.Sign), Is.EqualTo((3, MeshSdfSign.WindingNumber)));
            Assert.That(All(report), Does.Contain("3 open edges bound no area").And.Not.Contain("holes"));
            TriangleMesh triangle = TestMeshes.Sheet(1e-4f).Without(t => t > 0).Transformed(Matrix4x4.Translate(0.6f * Vector3.up));
            Assert.That(All(MeshCheck.Run(TriangleMesh.Combine("Speck", new[] { box, triangle }))), Does.Contain("1 holes"), "however small it is");
        }

        [Test]
        public void Doubled_faces_and_parts_that_touch_keep_the_mesh_closed()
        {
            TriangleMesh box = TestMeshes.Box(Vector3.one);
            TriangleMesh face = box.Without(t => t > 1);
            var meshes = new[]
            {
                TriangleMesh.Combine("Doubled face", new[] { box, face }),
                TriangleMesh.Combine("Doubled", new[] { box, box }),
                TriangleMesh.Combine("Touching", new[] { box, TestMeshes.Box(Vector3.one, Vector3.right) }),
            };
            foreach (TriangleMesh mesh in meshes.Concat(meshes.Select(mesh => mesh.Apart(2e-7f))))
            {
                MeshReport report = MeshCheck.Run(mesh);
                Assert.That((report.BoundaryEdges, report.Sign, report.IsInsideOut), Is.EqualTo((0, MeshSdfSign.WindingNumber, false)), mesh.Name);
                Assert.That(report.NonManifoldEdges, Is.GreaterThan(0), mesh.Name);
            }
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
        public void A_part_that_is_inside_out_beside_others_is_turned_over()
        {
            TriangleMesh large = TestMeshes.Box(2f * Vector3.one), small = TestMeshes.Box(Vector3.one, 3f * Vector3.right);
            TriangleMesh beside = small.Turned(t => true);
            // Within the box around the other, but not within it.
            TriangleMesh ring = TestMeshes.Torus(3f, 0.5f, 12), within = TestMeshes.Box(Vector3.one).Turned(t => true);
            foreach ((TriangleMesh mesh, double volume) in new[] {
                (TriangleMesh.Combine("Beside", new[] { large, beside }), 9.0),
                (TriangleMesh.Combine("The larger one", new[] { large.Turned(t => true), small }), -9.0),
                (TriangleMesh.Combine("In a ring", new[] { ring, within }), MeshCheck.Run(ring).SignedVolume + 1),
                (TriangleMesh.Combine("On a face", new[] { large, TestMeshes.Box(Vector3.one, 1.5f * Vector3.right).Turned(t => true) }), 9.0) })
            {
                MeshReport report = MeshCheck.Run(mesh);
                Assert.That((report.InvertedParts, report.Parts, report.FlippedTriangles), Is.EqualTo((1, 2, 0)), mesh.Name);
                Assert.That(report.SignedVolume, Is.EqualTo(volume).Within(1e-5), mesh.Name);
                Assert.That(All(report), Does.Contain("1 of 2 parts face the other side than the rest"), mesh.Name);
            }
            Assert.That(MeshCheck.Run(TriangleMesh.Combine("Both", new[] { large, small }).Turned(t => true)).InvertedParts, Is.Zero, "as a whole");
        }

        [Test]
        public void A_cavity_is_no_inverted_part([Values(false, true)] bool isInsideOut)
        {
            TriangleMesh mesh = TriangleMesh.Combine("Hollow",
                new[] { TestMeshes.Box(2f * Vector3.one), TestMeshes.Box(Vector3.one).Turned(t => true) });
            MeshReport report = MeshCheck.Run(mesh.Turned(t => isInsideOut));
            Assert.That((report.InvertedParts, report.Parts, report.IsInsideOut), Is.EqualTo((0, 2, isInsideOut)));
            Assert.That(report.SignedVolume, Is.EqualTo(isInsideOut ? -7 : 7).Within(1e-5));
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
            Assert.That(report.SelfIntersectionsChecked, Is.InRange(0.01f, 0.1f), "500 of some 12,000");
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
            Assert.That(told.First().fraction, Is.Zero);
            Assert.That(told.Last().fraction, Is.GreaterThanOrEqualTo(0.7f), "where its last stage begins");
            Assert.That(told.Select(one => one.fraction).Distinct().Count(), Is.GreaterThan(20));
            Assert.That(told.Select(one => one.stage).Distinct().Count(), Is.EqualTo(3));
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
            Assert.That(Assert.Throws<ArgumentNullException>(() => MeshCheck.Run((Mesh)null)).Message, Does.Contain("No mesh"));
            UnityEngine.Object.DestroyImmediate(mesh);
        }
    }
}
