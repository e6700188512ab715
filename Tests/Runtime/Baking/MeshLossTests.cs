using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Losses that a bake would have, and whether its remedy helps.</summary>
    public class MeshLossTests
    {
        static MeshSdfSettings Settings(int resolution = 64)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            return settings;
        }

        static IReadOnlyList<MeshLoss> Losses(TriangleMesh mesh, MeshSdfSettings settings) => MeshCheck.Run(mesh).LossesOf(settings);

        static TriangleMesh Together(params TriangleMesh[] meshes) => TriangleMesh.Combine("Together", meshes);

        /// <summary>A tray of 1 x 0.2 x 1 m on its floor: walls and floor are as thick.</summary>
        static TriangleMesh Tray(float thickness)
        {
            var outer = new Vector3(1f, 0.2f, 1f);
            TriangleMesh box = TestMeshes.Box(outer), hollow = TestMeshes.Box(outer - thickness * new Vector3(2f, 1f, 2f),
                0.5f * thickness * Vector3.up).Turned(t => true);
            // Without their lids, and with a rim between them.
            bool IsLid(TriangleMesh mesh, int t) => mesh.CenterOf(t).y > 0.0999f;
            TriangleMesh sides = Together(box.Without(t => IsLid(box, t)), hollow.Without(t => IsLid(hollow, t)));
            var rim = new List<int>();
            foreach ((int a, int b) in new[] { (2, 6), (6, 7), (7, 3), (3, 2) })
                rim.AddRange(new[] { a, b, 8 + a, b, 8 + b, 8 + a });
            return new TriangleMesh("Tray", sides.Vertices, sides.Triangles.Concat(rim).ToArray());
        }

        /// <summary>Fraction of triangles with a voxel inside beneath them, by the field.</summary>
        static double Represented(TriangleMesh mesh, MeshSdfSettings settings, float depth)
        {
            SignedDistanceField field = SignedDistanceField.Create(MeshSdfBaker.Bake(mesh, settings));
            try
            {
                int inside = 0;
                for (int t = 0; t < mesh.TriangleCount; t++)
                {
                    float3 At(int k) => mesh.Vertices[mesh.Triangles[3 * t + k]];
                    float3 a = At(0), b = At(1), c = At(2);
                    Assert.That(field.TrySample(mesh.CenterOf(t) - (Vector3)(depth * math.normalize(math.cross(b - a, c - a))), out float distance));
                    inside += distance < 0f ? 1 : 0;
                }
                return (double)inside / mesh.TriangleCount;
            }
            finally
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        }

        [Test]
        public void A_mesh_that_is_thick_enough_loses_nothing()
        {
            foreach (TriangleMesh mesh in new[] {
                TestMeshes.Box(Vector3.one), TestMeshes.Torus(1f, 0.35f, 20), TestMeshes.Sphere(0.7f, 18, 100f * Vector3.up), Tray(0.05f),
                Together(TestMeshes.Box(Vector3.one), TestMeshes.Box(Vector3.one, Vector3.right)),
                Together(TestMeshes.Box(2f * Vector3.one), TestMeshes.Box(Vector3.one).Turned(t => true)), TestMeshes.Sheet(1f) })
                Assert.That(Losses(mesh, Settings()).Select(loss => loss.Text), Is.Empty, mesh.Name);
        }

        [Test]
        public void A_part_thinner_than_a_voxel_is_named_with_the_voxel_that_does()
        {
            TriangleMesh plate = TestMeshes.Box(new Vector3(0.5f, 0.004f, 0.3f), new Vector3(0f, 1f, 0f));
            TriangleMesh mesh = Together(TestMeshes.Box(Vector3.one), plate);
            MeshLoss loss = Losses(mesh, Settings(48)).Single();
            Assert.That(loss.Text, Is.EqualTo("Part 2 of 2, (0.5, 0.004, 0.3) m large, around (0, 1, 0) m, is thinner than a voxel, 0.004 m for " +
                "0.0358 m: it may vanish, or leak. Voxels of 0.002 m would be too many: make it thicker, bake it by itself, or set the sign " +
                "to open shell."));
            Assert.That(loss.Remedy, Is.Null, "the memory cap");
            MeshSdfSettings large = Settings(48);
            large.memoryCap = 1 << 16;
            loss = Losses(TestMeshes.Box(new Vector3(0.5f, 0.004f, 0.3f)), large).Single();
            Assert.That(loss.Text, Does.EndWith("Use voxels of at most 0.002 m."));
            Assert.That(loss.Remedy?.voxelSize, Is.EqualTo(0.002f).Within(1e-6f));
        }

        [Test]
        public void Thin_walls_of_a_thick_mesh_are_told_and_the_remedy_keeps_them()
        {
            TriangleMesh tray = Tray(0.02f);
            MeshReport report = MeshCheck.Run(tray);
            Assert.That((report.IsWatertight, report.Parts), Is.EqualTo((true, 1)));
            MeshSdfSettings settings = Settings(24);
            MeshLoss loss = report.LossesOf(settings).Single();
            Assert.That(loss.Text, Does.StartWith("The mesh, (1, 0.2, 1) m large, around").And.Contain("thinner than a voxel, 0.02 m for 0.0556 m"));
            Assert.That(Represented(tray, settings, 0.01f), Is.LessThan(0.9));
            Assert.That(Represented(tray, loss.Remedy.Value, 0.01f), Is.EqualTo(1));
            Assert.That(report.LossesOf(loss.Remedy.Value), Is.Empty);

            // A fin on a box: a fraction of the surface.
            TriangleMesh fin = Together(TestMeshes.Box(Vector3.one),
                TestMeshes.Box(new Vector3(0.4f, 0.4f, 0.01f), new Vector3(0f, 0.7f - 1e-6f, 0f)));
            int[] joined = fin.Triangles.Concat(new[] { 2, 8, 3 }).ToArray();       // hangs both together
            Assert.That(Losses(new TriangleMesh("Fin", fin.Vertices, joined), Settings(32)).First().Text,
                Does.Match(@"around \(0, 0\.6.*on [45]\.?\d? % of its surface"));
        }

        [Test]
        public void Thickness_is_that_of_every_triangle_in_turn()
        {
            foreach (TriangleMesh mesh in new[] { TestMeshes.Torus(1f, 0.4f, 9),
                Together(TestMeshes.Sphere(1f, 8), TestMeshes.Box(0.3f * Vector3.one, 1.8f * Vector3.up)) })
            {
                var edges = new MeshEdges(new BakedTriangles(mesh));
                float[] found = MeshThickness.Of(edges, fraction => true);
                for (int t = 0; t < mesh.TriangleCount; t++)
                    if (edges.Triangles.TakesPart(t))
                        Assert.That(found[t], Is.EqualTo(Thickness(edges, t)).Within(1e-4).Percent, $"{mesh.Name} {t}");
            }
        }

        // Every triangle one after the other: the plane, then three signs.
        static double Thickness(MeshEdges edges, int triangle)
        {
            TriangleMesh mesh = edges.Triangles.Mesh;
            double3 At(int t, int k) => (float3)mesh.Vertices[mesh.Triangles[3 * t + k % 3]];
            double3 Normal(int t) => math.normalize(math.cross(At(t, 1) - At(t, 0), At(t, 2) - At(t, 0)));
            double3 from = (At(triangle, 0) + At(triangle, 1) + At(triangle, 2)) / 3, along = -Normal(triangle);
            double nearest = double.PositiveInfinity;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                if (t == triangle || !edges.Triangles.TakesPart(t) || !(math.dot(Normal(t), along) > 0))
                    continue;
                double distance = math.dot(Normal(t), At(t, 0) - from) / math.dot(Normal(t), along);
                double3 hit = from + distance * along;
                bool IsLeftOf(int k) => math.dot(Normal(t), math.cross(At(t, k + 1) - At(t, k), hit - At(t, k))) >= -1e-9;
                if (distance > 1e-6 && Enumerable.Range(0, 3).All(IsLeftOf))
                    nearest = math.min(nearest, distance);
            }
            return nearest;
        }

        [Test]
        public void Many_thin_parts_are_told_of_in_a_few_lines()
        {
            TriangleMesh[] blades = Enumerable.Range(0, 30)
                .Select(i => TestMeshes.Box(new Vector3(0.01f, 1f, 0.01f), new Vector3(0.3f * i, 0f, 0f))).ToArray();
            IReadOnlyList<MeshLoss> losses = Losses(Together(blades), Settings());
            Assert.That(losses.Count, Is.EqualTo(5));
            Assert.That(losses[4].Text, Does.StartWith("26 more parts are thinner than a voxel, from 0.01 m on"));
        }

        [Test]
        public void A_part_without_an_inside_is_told_beside_one_that_has_one()
        {
            TriangleMesh sheet = TestMeshes.Sheet(0.6f).Transformed(Matrix4x4.Translate(Vector3.up));
            MeshLoss loss = Losses(Together(TestMeshes.Box(Vector3.one), sheet), Settings()).Single();
            Assert.That(loss.Text, Does.StartWith("Part 2 of 2, (0.6, 0, 0.6) m large, around (0, 1, 0) m, has no inside, with 50 % of holes: " +
                "it vanishes"));
            Assert.That(loss.Remedy?.sign, Is.EqualTo(MeshSdfSign.OpenShell));
        }

        [Test]
        public void A_shell_thinner_than_a_voxel_is_told()
        {
            MeshSdfSettings settings = Settings(16);
            settings.shellThickness = 0.01f;
            MeshLoss loss = Losses(TestMeshes.Sheet(1f), settings).Single();
            Assert.That(loss.Text, Does.StartWith("The shell of 0.01 m is thinner than a voxel"));
            Assert.That(Losses(TestMeshes.Sheet(1f), loss.Remedy.Value), Is.Empty);
        }

        static TriangleMesh Speck(Vector3 at, float size)
            => new TriangleMesh("Speck", new[] { at, at + size * Vector3.right, at + size * Vector3.up }, new[] { 0, 2, 1 });

        [Test]
        public void A_far_speck_is_told_with_what_the_voxels_would_be_without_it()
        {
            TriangleMesh tray = Tray(0.05f), mesh = Together(tray, Speck(new Vector3(40f, 0f, 0f), 0.001f), Speck(new Vector3(39f, 0f, 1f), 0.001f));
            MeshReport report = MeshCheck.Run(mesh);
            IReadOnlyList<MeshLoss> losses = report.LossesOf(Settings());
            Assert.That(losses[0].Text,
                Does.StartWith("2 triangles far from the rest, at (40, 0, 0) m, make the box 40.").And.Contain(
                    "voxels of 0.698 m instead of 0.0172 m"));
            Assert.That(losses[1].Text, Does.StartWith("Part 1 of 3, (1, 0.2, 1) m large"), "what that does to the tray");
            Assert.That(losses.Count, Is.EqualTo(2), "the specks are told once");

            MeshSdfSettings without = losses[0].Remedy.Value;
            Assert.That(without.leaveOutFar);
            Assert.That(report.LossesOf(without).Single().Text, Does.Contain("2 triangles far from the rest, at (40, 0, 0) m, are left out"));
            Assert.That(MeshSdfBaker.Estimate(report, without).Resolution, Is.EqualTo(MeshSdfBaker.Estimate(tray, Settings()).Resolution));
            SdfBake bake = MeshSdfBaker.Bake(mesh, without), alone = MeshSdfBaker.Bake(tray, Settings());
            Assert.That(bake.Distances, Is.EqualTo(alone.Distances));
            Assert.That(bake.SourceHash, Is.EqualTo(mesh.Hash()), "of the whole mesh, so that it is not stale");
            Assert.That(MeshSdfBaker.Estimate(mesh, without).VoxelSize, Is.EqualTo(bake.VoxelSize));
        }

        [Test]
        public void A_corner_that_strayed_is_told()
        {
            TriangleMesh ball = TestMeshes.Torus(1f, 0.4f, 20);
            ball.Vertices[ball.Triangles[300]] = new Vector3(0f, 70f, 0f);
            MeshReport report = MeshCheck.Run(ball);
            MeshLoss loss = report.LossesOf(Settings())[0];
            Assert.That(loss.Text, Does.StartWith("6 triangles at one corner that strayed, at (0, 70, 0) m, make the box 2"));
            Assert.That(report.WithoutFar.Sign, Is.EqualTo(MeshSdfSign.WindingNumber), "the hole that is left is small");
            Assert.That(MeshSdfBaker.Estimate(report, loss.Remedy.Value).Bounds.size.y, Is.LessThan(1.2f));
        }

        [Test]
        public void Large_parts_apart_spires_and_debris_nearby_are_not_far()
        {
            foreach (TriangleMesh mesh in new[] { Together(Tray(0.05f), Tray(0.05f).Transformed(Matrix4x4.Translate(40f * Vector3.right))),
                Together(TestMeshes.Sheet(100f), TestMeshes.Box(Vector3.one)), Together(Tray(0.05f), Speck(0.9f * Vector3.right, 0.01f)),
                new TriangleMesh("Spire", new[] { Vector3.zero, Vector3.right, Vector3.forward, 20f * Vector3.up },
                    new[] { 0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0 }) })
                Assert.That(MeshCheck.Run(mesh).WithoutFar, Is.Null);
        }
    }
}
