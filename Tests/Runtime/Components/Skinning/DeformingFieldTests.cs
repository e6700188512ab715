using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Fields that are baked again as a mesh deforms, without a fluid.</summary>
    public class DeformingFieldTests
    {
        GameObject thing;
        Mesh made;

        [TearDown]
        public void Destroy()
        {
            Object.DestroyImmediate(thing);
            Object.DestroyImmediate(made);
        }

        [Test]
        public void The_field_of_a_posed_arm_is_the_distance_from_the_posed_triangles([Values(0f, 35f, 80f)] float angle)
        {
            using (var arm = new SkinnedArm())
            {
                arm.Bend(angle);
                arm.Object.transform.SetPositionAndRotation(new Vector3(-1f, 3f, 0.5f), Quaternion.Euler(20f, -50f, 5f));
                FluidDeformingMesh deforming = Begin(arm.Object);
                float[] distances = Bake(deforming);
                Mesh posed = arm.PosedMesh();
                AssertDistances(distances, deforming.Grid, TriangleMesh.Of(posed));

                SdfBake baked = MeshSdfBaker.Bake(posed, MeshSdfSettings.Default);
                Assert.That(MaxDifference(distances, deforming.Grid, baked), Is.LessThan(0.5f * deforming.VoxelSize));
                Object.DestroyImmediate(posed);
            }
        }

        [Test]
        public void An_arm_that_bends_further_than_its_box_makes_the_box_grow()
        {
            using (var arm = new SkinnedArm())
            {
                FluidDeformingMesh deforming = Begin(arm.Object);
                Bake(deforming);
                Bounds before = deforming.Grid.Bounds;
                arm.Bend(90f);
                float[] distances = Bake(deforming);
                Assert.That(deforming.Grid.Bounds.max.y, Is.GreaterThan(before.max.y));
                Mesh posed = arm.PosedMesh();
                AssertDistances(distances, deforming.Grid, TriangleMesh.Of(posed));
                Object.DestroyImmediate(posed);
            }
        }

        [Test]
        public void A_mesh_follows_what_scripts_make_of_its_vertices_and_its_uneven_mirrored_scale()
        {
            TriangleMesh ball = TestMeshes.Sphere(0.3f, 8);
            FluidDeformingMesh deforming = Filter(ball);
            thing.transform.localScale = new Vector3(-1f, 0.5f, 1.5f);
            Vector3[] moved = Array.ConvertAll(ball.Vertices, v => 0.8f * v + new Vector3(0.02f, 0.1f * v.x, 0f));
            made.vertices = moved;
            deforming.Refresh();
            float[] distances = Bake(deforming);
            Vector3[] expected = Array.ConvertAll(moved, v => Vector3.Scale(v, thing.transform.localScale));
            // A mirror turns the triangles over.
            AssertDistances(distances, deforming.Grid, new TriangleMesh("Expected", expected, Turned(ball.Triangles)));
        }

        [Test]
        public void Vertices_that_are_no_numbers_and_triangles_without_area_leave_the_rest_of_the_field_as_it_is()
        {
            TriangleMesh ball = TestMeshes.Sphere(0.3f, 12);
            FluidDeformingMesh deforming = Filter(ball);
            Bake(deforming);
            Vector3[] broken = ball.Vertices;
            broken[40] = new Vector3(float.NaN, 0f, 0f);
            broken[90] = new Vector3(0f, float.PositiveInfinity, 0f);
            broken[150] = new Vector3(1e30f, 0f, 0f);
            broken[100] = broken[101];
            made.vertices = broken;
            LogAssert.Expect(LogType.Warning, new Regex("FluidDeformingMesh 'Thing' reaches over more than 4 times its size"));
            float[] distances = Bake(deforming);
            Assert.That(distances.All(d => !float.IsNaN(d) && math.abs(d) < 1e4f));
            Assert.That(distances.Min(), Is.LessThan(-0.15f), "the center of the ball is still solid");

            made.vertices = Enumerable.Repeat(new Vector3(float.NaN, float.NaN, float.NaN), broken.Length).ToArray();
            distances = Bake(deforming);
            Assert.That(distances.Min(), Is.GreaterThan(1f), "nothing is there");
            Assert.That(distances.All(d => !float.IsNaN(d) && !float.IsInfinity(d)));
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void An_open_mesh_becomes_a_shell_of_the_given_thickness()
        {
            var sheet = new TriangleMesh("Sheet", new[] { new Vector3(-0.5f, 0f, -0.5f), new Vector3(-0.5f, 0f, 0.5f),
                new Vector3(0.5f, 0f, 0.5f), new Vector3(0.5f, 0f, -0.5f) }, new[] { 0, 1, 2, 0, 2, 3 });
            FluidDeformingMesh deforming = Filter(sheet);
            deforming.ShellThickness = 0.1f;
            deforming.Refresh();
            float[] distances = Bake(deforming);
            SdfGrid grid = deforming.Grid;
            for (int i = 0; i < distances.Length; i++)
                Assert.That(distances[i], Is.EqualTo(MeshDistance.Unsigned(sheet, VoxelCenter(grid, i)) - 0.05).Within(0.5f * grid.VoxelSize));
        }

        [Test]
        public void A_budget_spreads_a_bake_over_frames_and_the_old_fields_last_until_it_is_done()
        {
            using (var arm = new SkinnedArm())
            {
                var mesh = DeformedMesh.Of(arm.Renderer, MeshSdfSign.Automatic, out string problem);
                Assert.That(problem, Is.Null);
                var box = new Bounds(new Vector3(0.5f, 0f, 0f), new Vector3(1.2f, 1.2f, 1.2f));
                var grid = new SdfGrid(box, MeshSdfSettings.Default, false);
                using (var field = new DeformingField(mesh, grid))
                {
                    field.Begin();
                    Assert.That(field.Advance(mesh.TriangleCount), Is.True, "all at once");
                    float[] straight = Read(field);

                    arm.Bend(60f);
                    Assert.That(mesh.Follow(1e-4f), Is.True);
                    field.Begin();
                    arm.Bend(0f);       // the pose is that of the beginning
                    int frames = 1, third = (mesh.TriangleCount + 2) / 3;
                    for (; !field.Advance(third); frames++)
                        Assert.That(Read(field).SequenceEqual(straight), "until it is done");
                    Assert.That(frames, Is.EqualTo(3));
                    float[] spread = Read(field);

                    arm.Bend(60f);
                    mesh.Follow(1e-4f);
                    field.Begin();
                    field.Advance(mesh.TriangleCount);
                    Assert.That(spread.SequenceEqual(Read(field)), "to the bit what it is at once");
                    Assert.That(GpuTest.Read<float>(field.Older, spread.Length).SequenceEqual(spread), "for the step to come from");
                }
            }
        }

        FluidDeformingMesh Filter(TriangleMesh mesh)
        {
            made = new Mesh { name = mesh.Name, vertices = (Vector3[])mesh.Vertices.Clone(), triangles = mesh.Triangles };
            thing = new GameObject("Thing");
            thing.AddComponent<MeshFilter>().sharedMesh = made;
            return Begin(thing);
        }

        static FluidDeformingMesh Begin(GameObject on)
        {
            var deforming = on.AddComponent<FluidDeformingMesh>();
            on.SetActive(true);
            Assert.That(on.GetComponent<FluidCollider>().TryDescribe(out _));
            return deforming;
        }

        // Bakes like a fluid that takes a step.
        static float[] Bake(FluidDeformingMesh deforming)
        {
            Assert.That(deforming.GetComponent<FluidCollider>().TryDescribe(out _));
            deforming.StartFrame();
            ((IDeformingShape)deforming).Follow(1f);
            return Read(((IDeformingShape)deforming).Field);
        }

        static float[] Read(DeformingField field)
            => GpuTest.Read<float>(field.Newer, field.Resolution.x * field.Resolution.y * field.Resolution.z);

        static int[] Turned(int[] triangles)
            => triangles.Select((_, i) => triangles[i % 3 == 0 ? i : i % 3 == 1 ? i + 1 : i - 1]).ToArray();

        static double3 VoxelCenter(in SdfGrid grid, int i)
        {
            int3 r = grid.Resolution;
            return grid.Min + grid.VoxelSize * (new float3(i % r.x, i / r.x % r.y, i / (r.x * r.y)) + 0.5f);
        }

        // Every seventh voxel: near the surface as it is, beyond to half a voxel, and on the same side everywhere.
        static void AssertDistances(float[] distances, in SdfGrid grid, TriangleMesh mesh)
        {
            int near = 0;
            for (int i = 0; i < distances.Length; i += 7)
            {
                double3 center = VoxelCenter(grid, i);
                double expected = MeshDistance.Unsigned(mesh, center) * (MeshDistance.Winding(mesh, center) > 0.5 ? -1 : 1);
                bool isNear = Math.Abs(expected) < 2f * grid.VoxelSize;
                near += isNear ? 1 : 0;
                Assert.That(distances[i], Is.EqualTo(expected).Within((isNear ? 0.02f : 0.5f) * grid.VoxelSize), $"at {center}");
            }
            Assert.That(near, Is.GreaterThan(20));
        }

        // Difference of the baker's field, halfway between its voxels, from the voxels of this one, where both are near the surface.
        static float MaxDifference(float[] distances, in SdfGrid grid, SdfBake baked)
        {
            float largest = 0f;
            Vector3Int size = baked.Resolution;
            for (int i = 0; i < distances.Length; i++)
            {
                float3 at = ((float3)VoxelCenter(grid, i) - (float3)baked.Bounds.min) / baked.VoxelSize - 0.5f;
                int3 low = (int3)math.floor(at);
                if (math.any(low < 0) || math.any(low + 1 >= new int3(size.x, size.y, size.z))
                    || math.abs(distances[i]) > 2f * grid.VoxelSize)
                    continue;
                float3 part = at - low;
                float sum = 0f;
                for (int k = 0; k < 8; k++)
                {
                    int3 corner = new int3(k & 1, k >> 1 & 1, k >> 2), voxel = low + corner;
                    float3 weight = math.select(1f - part, part, corner == 1);
                    sum += weight.x * weight.y * weight.z * baked.Distances[(voxel.z * size.y + voxel.y) * size.x + voxel.x];
                }
                largest = math.max(largest, math.abs(sum - distances[i]));
            }
            return largest;
        }
    }
}
