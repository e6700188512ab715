using System;
using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using static Rill.Tests.WaterScene;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>The surface of a played fluid as a mesh that a Mesh Renderer draws.</summary>
    public class FluidSurfaceMeshTests
    {
        const int Pixels = 48, VertexFloats = 8;

        WaterScene scene;
        FluidSurfaceMesh mesh;
        MeshFilter filter;

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        // A block of water that falls, drawn red and unlit before white.
        void Make(bool keepsSurface = false)
        {
            scene = new WaterScene(Pixels, new Vector3(0.6f, 0.5f, 0.6f), 0.2f, 800);
            scene.Root.GetComponentInChildren<FluidVolume>(true).transform.localPosition = Vector3.zero;
            if (!keepsSurface)
                Object.DestroyImmediate(scene.Surface);
            mesh = scene.Root.AddComponent<FluidSurfaceMesh>();
            filter = scene.Root.GetComponent<MeshFilter>();
            var red = scene.Keep(new Material(Shader.Find("Unlit/Color")));
            red.color = Color.red;
            scene.Root.GetComponent<MeshRenderer>().sharedMaterial = red;
        }

        SurfaceMesh Found => scene.Fluid.Solver.Mesh;

        bool IsRed => scene.Mean().r > 0.99f && scene.Mean().g < 0.01f;

        static float[] Vertices(Mesh mesh)
        {
            using (GraphicsBuffer buffer = mesh.GetVertexBuffer(0))
                return GpuTest.Read<float>(buffer, VertexFloats * mesh.vertexCount);
        }

        static uint[] Indices(Mesh mesh)
        {
            using (GraphicsBuffer buffer = mesh.GetIndexBuffer())
                return GpuTest.Read<uint>(buffer, (int)mesh.GetIndexCount(0));
        }

        [UnityTest]
        public IEnumerator It_is_the_surface_at_the_time_of_the_frame_whatever_the_transform([Values(1f, -0.5f)] float scale)
        {
            Make();
            Transform root = scene.Root.transform;
            root.SetPositionAndRotation(new Vector3(0.3f, -0.2f, 0.1f), Quaternion.Euler(0f, 30f, 0f));
            root.localScale = new Vector3(2f, 1f, scale);
            Time.captureDeltaTime = 1f / 90f;       // between the steps
            scene.Root.SetActive(true);
            yield return Frames(8);
            var found = new DrawnMesh(Found);
            float lag = scene.Fluid.Clock.FrameLag.x;
            Assert.That(math.abs(lag), Is.GreaterThan(0.1f));
            float[] floats = Vertices(mesh.Mesh);
            Matrix4x4 toWorld = root.localToWorldMatrix, fluidToWorld = scene.Fluid.DomainToWorld, normalToWorld = toWorld.inverse.transpose;
            float shift = 0f;
            var local = new double3[found.positions.Length];
            Assert.That(local.Length, Is.GreaterThan(100));
            for (int i = 0; i < local.Length; i++)
            {
                int at = VertexFloats * i;
                var position = new Vector3(floats[at], floats[at + 1], floats[at + 2]);
                var normal = new Vector3(floats[at + 3], floats[at + 4], floats[at + 5]);
                local[i] = (float3)position;
                float3 size = scene.Fluid.DomainSize / Spacing, there = (float3)found.positions[i];
                float3 moved = math.clamp(there + (float3)found.displacements[i] * lag, math.min(there, 0f), math.max(there, size));
                shift = math.max(shift, math.distance(moved, there));
                Vector3 world = fluidToWorld.MultiplyPoint3x4(moved);
                Assert.That((toWorld.MultiplyPoint3x4(position) - world).magnitude, Is.LessThan(2e-5f), $"position of vertex {i}");
                Vector3 worldNormal = fluidToWorld.MultiplyVector((float3)found.normals[i]).normalized;
                Assert.That((normalToWorld.MultiplyVector(normal).normalized - worldNormal).magnitude, Is.LessThan(1e-3f), $"normal of vertex {i}");
                Assert.That(normal.magnitude, Is.EqualTo(1f).Within(1e-4f));
                Assert.That(math.distance(new float2(floats[at + 6], floats[at + 7]), new float2(world.x, world.z)), Is.LessThan(2e-5f));
                Assert.That(mesh.Mesh.bounds.SqrDistance(position), Is.LessThan(1e-8f));
            }
            Assert.That(shift, Is.GreaterThan(0.02f), "it has gone on since the step");

            uint[] indices = Indices(mesh.Mesh);
            double volume = 0.0;
            for (int i = 0; i < indices.Length; i += 3)
                volume += math.dot(local[indices[i]], math.cross(local[indices[i + 1]], local[indices[i + 2]])) / 6.0;
            double expected = found.Volume * math.pow(Spacing, 3f) / math.abs(2f * scale);
            Assert.That(volume, Is.EqualTo(expected).Within(0.05 * expected), "clockwise seen from the air, as of any mesh");
            Assert.That(indices.Length, Is.EqualTo(6 * Found.QuadCapacity));
            if (scale > 0f)
                Assert.That(indices.Take(found.indices.Length), Is.EqualTo(found.indices));
            Assert.That(indices.Skip(found.indices.Length).Max(), Is.Zero, "no triangle behind the last");
        }

        [UnityTest]
        public IEnumerator It_is_drawn_by_every_camera_and_nothing_stale_is_left_where_the_water_is_gone()
        {
            Make();
            Camera other = scene.NewCamera(scene.NewTarget(Pixels, Pixels), new Vector3(0f, 0f, 2f));
            other.orthographicSize = 0.05f;
            scene.Fluid.Gravity = Vector3.zero;
            yield return scene.Settle(3);
            Assert.That(IsRed);
            Assert.That(WaterScene.Mean(other.targetTexture).g, Is.LessThan(0.01f), "from the side");
            scene.Fluid.Paused = false;
            scene.Fluid.Clear();
            yield return Frames(2);
            Assert.That(mesh.Mesh != null);
            Assert.That(Indices(mesh.Mesh).Max(), Is.Zero);
            Assert.That(scene.Mean(), Is.EqualTo(Color.white));
        }

        [UnityTest]
        public IEnumerator Off_or_destroyed_it_gives_all_back([Values] bool destroyed)
        {
            Make();
            yield return scene.Settle(3);
            Mesh made = mesh.Mesh;
            Assert.That(filter.sharedMesh == made);
            if (destroyed)
                Object.Destroy(mesh);
            else
                mesh.enabled = false;
            yield return Frames(2);
            Assert.That(made == null, "the mesh is destroyed");
            Assert.That(filter.sharedMesh == null);
            Assert.That(scene.Mean(), Is.EqualTo(Color.white));
            yield return Frames(40);
            Assert.That(Found, Is.Null, "the solver makes none any more");
            if (destroyed)
                yield break;
            mesh.enabled = true;
            yield return Frames(2);
            Assert.That(IsRed);
        }

        [UnityTest]
        public IEnumerator While_its_renderer_or_its_fluid_is_off_there_is_no_mesh([Values] bool ofFluid)
        {
            Make();
            yield return scene.Settle(3);
            Mesh made = mesh.Mesh;
            var drawn = scene.Root.GetComponent<MeshRenderer>();
            (ofFluid ? (Action<bool>)(on => scene.Fluid.enabled = on) : on => drawn.enabled = on)(false);
            yield return Frames(2);
            Assert.That(made == null && mesh.Mesh == null);
            Assert.That(scene.Mean(), Is.EqualTo(Color.white));
            (ofFluid ? (Action<bool>)(on => scene.Fluid.enabled = on) : on => drawn.enabled = on)(true);
            yield return Frames(2);
            Assert.That(IsRed);
        }

        [UnityTest]
        public IEnumerator With_a_surface_on_the_object_both_draw_the_finer_mesh_with_the_walls_of_both()
        {
            Make(keepsSurface: true);
            scene.Surface.Quality = SurfaceQuality.Low;
            scene.Surface.HiddenWalls = BoxWalls.Left | BoxWalls.Bottom;
            mesh.Quality = SurfaceQuality.High;
            mesh.HiddenWalls = BoxWalls.Bottom | BoxWalls.Top;
            yield return scene.Settle(3);
            LogAssert.NoUnexpectedReceived();
            Assert.That(mesh.Mesh != null);
            Assert.That(Found.Cell, Is.EqualTo(0.5f));
            Assert.That(scene.Fluid.Solver.MeshWalls, Is.EqualTo((int)(BoxWalls.All & ~BoxWalls.Bottom)));
            scene.Surface.enabled = false;
            yield return Frames(2);
            Assert.That(IsRed);
            mesh.enabled = false;
            scene.Surface.enabled = true;
            yield return Frames(3);
            Assert.That(Found.Cell, Is.EqualTo(1f));
        }

        [UnityTest]
        public IEnumerator Without_a_material_or_with_a_scale_of_zero_it_says_so_once()
        {
            Make();
            var drawn = scene.Root.GetComponent<MeshRenderer>();
            Material red = drawn.sharedMaterial;
            drawn.sharedMaterial = null;
            LogAssert.Expect(LogType.Warning, new Regex("FluidSurfaceMesh 'Fluid': the Mesh Renderer on this object has no material. Give it one"));
            yield return scene.Settle(3);
            drawn.sharedMaterial = red;
            yield return Frames(2);
            scene.Root.transform.localScale = new Vector3(1f, 0f, 1f);
            LogAssert.Expect(LogType.Warning, new Regex("FluidSurfaceMesh 'Fluid': .*scale of its transform is 0"));
            yield return Frames(3);
            Assert.That(mesh.Mesh == null);
            scene.Root.transform.localScale = Vector3.one;
            yield return Frames(2);
            Assert.That(IsRed);
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator It_grows_with_the_room_of_the_surface_and_is_seen_in_every_frame()
        {
            Make();
            scene.Fluid.Gravity = Vector3.zero;
            yield return scene.Settle(3);
            Mesh before = mesh.Mesh;
            uint[] counters = GpuTest.Read<uint>(Found.Counters, Enum.GetValues(typeof(SurfaceMesh.Counter)).Length);
            counters[(int)SurfaceMesh.Counter.VerticesNeeded] = (uint)Found.VertexCapacity + 1000;
            counters[(int)SurfaceMesh.Counter.QuadsNeeded] = (uint)Found.QuadCapacity + 1000;
            Found.Counters.SetData(counters);
            for (int frame = 0; frame < 8; frame++)
            {
                yield return null;
                Assert.That(IsRed, $"in frame {frame}");
            }
            Assert.That(before == null, "the smaller one is destroyed");
            Assert.That(mesh.Mesh.vertexCount, Is.EqualTo(Found.VertexCapacity));
            Assert.That(mesh.Mesh.GetIndexCount(0), Is.EqualTo(6 * Found.QuadCapacity));
            Assert.That(filter.sharedMesh == mesh.Mesh);
        }

        [Test]
        public void A_mesh_too_large_for_the_device_is_told_with_what_to_do()
        {
            Make();
            long most = GpuBuffer.MaxBinding / 32;
            Assert.That(RenderedMesh.RoomProblem((int)most), Is.Null);
            Assert.That(RenderedMesh.RoomProblem((int)most + 1), Does.Contain("Lower its Quality, or the fluid's capacity"));
        }
    }
}
