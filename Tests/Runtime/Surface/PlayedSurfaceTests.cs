using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using static Rill.Tests.WaterScene;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>The surface of a played fluid, as cameras and shadows show it.</summary>
    public class PlayedSurfaceTests
    {
        const int Pixels = 48;

        readonly List<Object> kept = new List<Object>();
        WaterScene scene;

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            foreach (Object one in kept)
                Object.Destroy(one);
            kept.Clear();
            yield return scene.End();
        }

        [UnityTest]
        public IEnumerator Water_is_drawn_and_absorbs_light_on_its_way_through([Values] SurfaceQuality quality)
        {
            Make(new Vector3(0.8f, 0.5f, 0.8f), 0.25f, 1500);
            scene.Surface.Quality = quality;
            yield return scene.Settle(12);
            Assert.That(scene.Fluid.Solver.Mesh, Is.Not.Null);
            Color color = scene.Mean();
            float3 seen = new float3(color.r, color.g, color.b), expected = (1f - 0.0204f) * math.pow(Left, 0.25f / 0.5f);
            TestContext.Out.WriteLine($"seen {seen}, Fresnel, Beer and Lambert {expected}");
            Assert.That(math.cmax(math.abs(seen / expected - 1f)), Is.LessThan(0.05f));
        }

        [UnityTest]
        public IEnumerator Hidden_walls_have_no_faces_also_while_the_fluid_is_paused()
        {
            Make(new Vector3(0.6f, 0.5f, 0.6f), 0.2f, 800);
            yield return scene.Settle(3);
            scene.Fluid.Paused = true;
            yield return Frames(2);
            double3 Area()
            {
                DrawnMesh mesh = new DrawnMesh(scene.Fluid.Solver.Mesh);
                double3 low = 0.0;      // of faces in the planes x, y and z = 0, d
                for (int i = 0; i < mesh.indices.Length; i += 3)
                {
                    double3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]], c = mesh.positions[mesh.indices[i + 2]];
                    double area = 0.5 * math.length(math.cross(b - a, c - a));
                    double3 most = math.max(math.max(a, b), c);
                    low += area * new double3(most.x < 1e-3 ? 1.0 : 0.0, most.y < 1e-3 ? 1.0 : 0.0, most.z < 1e-3 ? 1.0 : 0.0);
                }
                return low;
            }
            double3 all = Area();
            Assert.That(math.cmin(all), Is.GreaterThan(30.0));
            scene.Surface.HiddenWalls = BoxWalls.Left | BoxWalls.Bottom;
            yield return Frames(2);
            double3 some = Area();
            Assert.That(some.x, Is.Zero);
            Assert.That(some.y, Is.Zero);
            Assert.That(some.z, Is.EqualTo(all.z).Within(0.1));
        }

        [UnityTest]
        public IEnumerator Off_it_gives_back_the_mesh()
        {
            Make(new Vector3(0.6f, 0.5f, 0.6f), 0.2f, 800);
            yield return scene.Settle(3);
            GraphicsBuffer vertices = scene.Fluid.Solver.Mesh.Vertices;
            scene.Surface.enabled = false;
            yield return Frames(40);
            Assert.That(scene.Fluid.Solver.Mesh, Is.Null);
            Assert.That(vertices.IsValid(), Is.False);
            Assert.That(scene.Mean(), Is.EqualTo(Color.white));
        }

        [UnityTest]
        public IEnumerator Particles_that_fly_by_themselves_are_seen_as_drops_where_they_are()
        {
            Make(new Vector3(0.6f, 0.5f, 0.6f), 0f, 64);
            scene.Fluid.Gravity = Vector3.zero;
            scene.Root.SetActive(true);
            yield return Frames(1);
            var positions = new[] { new float3(-0.15f, 0f, -0.15f), new float3(0.15f, 0.1f, -0.15f), new float3(0.15f, -0.1f, 0.15f) };
            Add(positions);
            yield return Frames(4);
            uint[] counters = Counters();
            Assert.That(counters[(int)SurfaceMesh.Counter.Drops], Is.EqualTo(3));
            Assert.That(counters[(int)SurfaceMesh.Counter.Vertices], Is.Zero);
            float4[] pixels = scene.Pixels();
            int near = 0, far = 0;
            for (int i = 0; i < pixels.Length; i++)
            {
                if (math.abs(pixels[i].y - 1f) < 0.01f)
                    continue;
                float2 at = (new float2(i % Pixels, i / Pixels) + 0.5f) / Pixels * 0.6f - 0.3f;
                if (positions.Any(p => math.distance(p.xz, at) < 2f * Spacing))
                    near++;
                else
                    far++;
            }
            TestContext.Out.WriteLine($"{near} pixels near the particles differ, {far} elsewhere");
            Assert.That(near, Is.GreaterThan(10));
            Assert.That(far, Is.Zero);
        }

        // In the air, under light from straight above; the camera sees the floor alone.
        [UnityTest]
        public IEnumerator The_mesh_throws_a_shadow_by_how_much_water_the_light_passes()
        {
            Make(new Vector3(0.8f, 0.5f, 0.8f), 0.3f, 2000);
            Light sun = Keep(new GameObject("Sun")).AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            sun.shadows = LightShadows.Hard;
            GameObject floor = Keep(GameObject.CreatePrimitive(PrimitiveType.Plane));
            floor.transform.position = new Vector3(0f, -0.8f, 0f);
            scene.Camera.transform.position = new Vector3(0f, -0.4f, 0f);
            scene.Camera.nearClipPlane = 0.05f;
            scene.Surface.ShadowOpacity = 1f;
            scene.Fluid.Gravity = Vector3.zero;
            scene.Fluid.KeepStateOnDisable = false;      // each time it begins with other water
            FluidVolume volume = scene.Root.GetComponentInChildren<FluidVolume>(true);
            volume.transform.localPosition = Vector3.zero;
            AmbientMode mode = RenderSettings.ambientMode;
            Color sky = RenderSettings.ambientSkyColor;
            ShadowResolution resolution = QualitySettings.shadowResolution;
            var left = new float[3];
            try
            {
                (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (AmbientMode.Flat, Color.black);
                QualitySettings.shadowResolution = ShadowResolution.Low;
                for (int i = 0; i < 3; i++)
                {
                    volume.Size = new Vector3(0.7f, i == 1 ? 2f * Spacing : 0.3f, 0.7f);
                    scene.Surface.CastShadows = i == 0 ? ShadowCastingMode.Off : ShadowCastingMode.On;
                    scene.Root.SetActive(true);
                    yield return Frames(3);
                    left[i] = scene.Mean().g;
                    scene.Root.SetActive(false);
                }
            }
            finally
            {
                (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (mode, sky);
                QualitySettings.shadowResolution = resolution;
            }
            TestContext.Out.WriteLine($"on the floor {left[0]:F3}, under 2 layers {left[1] / left[0]:F3} of it, under 6 {left[2] / left[0]:F3}");
            Assert.That(left[0], Is.GreaterThan(0.1f));
            Assert.That(left[2] / left[0], Is.LessThan(0.05f), "all the light is gone");
            Assert.That(left[1] / left[0], Is.InRange(0.35f, 0.65f), "half of it: of 4 layers it is all");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_mesh_that_outgrows_its_room_is_whole_soon_and_is_seen_in_every_frame()
        {
            Make(new Vector3(1.6f, 1f, 1.6f), 0f, 2100);
            scene.Camera.orthographicSize = 0.8f;
            scene.Surface.Quality = SurfaceQuality.High;
            scene.Fluid.Gravity = Vector3.zero;
            scene.Root.SetActive(true);
            yield return Frames(1);
            var positions = new List<float3>();        // clumps of 27, far apart
            for (int clump = 0; clump < 75; clump++)
            {
                float3 at = 3f + 6f * new float3(clump % 5, clump / 25, clump / 5 % 5);
                for (int k = 0; k < 27; k++)
                    positions.Add((at + new float3(k % 3, k / 3 % 3, k / 9)) * Spacing - new float3(0.8f, 0.5f, 0.8f));
            }
            Add(positions.ToArray());
            yield return Frames(1);
            int vertexRoom = scene.Fluid.Solver.Mesh.VertexCapacity, brickRoom = scene.Fluid.Solver.Mesh.BrickCapacity;
            var dark = new List<int>();
            for (int frame = 0; frame < 14; frame++)
            {
                yield return Frames(1);
                dark.Add(scene.Pixels().Count(pixel => pixel.x < 0.95f));
            }
            TestContext.Out.WriteLine($"pixels with water: {string.Join(" ", dark)}");
            uint[] counters = Counters();
            SurfaceMesh mesh = scene.Fluid.Solver.Mesh;
            Assert.That(mesh.VertexCapacity, Is.GreaterThan(vertexRoom));
            Assert.That(mesh.BrickCapacity, Is.GreaterThan(brickRoom));
            Assert.That(counters[(int)SurfaceMesh.Counter.Bricks], Is.EqualTo(counters[(int)SurfaceMesh.Counter.BricksNeeded]));
            Assert.That(counters[(int)SurfaceMesh.Counter.Vertices], Is.EqualTo(counters[(int)SurfaceMesh.Counter.VerticesNeeded]));
            Assert.That(counters[(int)SurfaceMesh.Counter.Quads], Is.EqualTo(counters[(int)SurfaceMesh.Counter.QuadsNeeded]));
            Assert.That(new DrawnMesh(mesh).OpenEdges, Is.Zero);
            for (int frame = 1; frame < dark.Count; frame++)
                Assert.That(dark[frame], Is.GreaterThan(0.9f * dark[frame - 1]), $"less than in the frame before is seen in frame {frame}");
        }

        [UnityTest]
        public IEnumerator A_mesh_that_the_device_cannot_hold_is_no_longer_drawn_and_the_fluid_goes_on()
        {
            Make(new Vector3(0.6f, 0.5f, 0.6f), 0.2f, 800);
            yield return scene.Settle(3);
            uint[] counters = Counters();
            counters[(int)SurfaceMesh.Counter.VerticesNeeded] = 200000000;      // 3.2 GB
            scene.Fluid.Solver.Mesh.Counters.SetData(counters);
            LogAssert.Expect(LogType.Error, new Regex("FluidSimulation 'Fluid' goes on without the water's surface: Rill.Surface.Workspace"));
            yield return Frames(8);
            Assert.That(scene.Fluid.Solver.Mesh, Is.Null);
            Assert.That(scene.Mean(), Is.EqualTo(Color.white));
            scene.Fluid.Paused = false;
            long steps = scene.Fluid.StepCount;
            yield return Frames(2);
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(steps + 2));
        }

        /// <param name="depth">Of the water, m; 0 for none.</param>
        void Make(Vector3 box, float depth, int capacity)
        {
            scene = new WaterScene(Pixels, box, depth, capacity);
            scene.Surface.CastShadows = ShadowCastingMode.Off;
            if (depth <= 0f)
                scene.Root.GetComponentInChildren<FluidVolume>(true).gameObject.SetActive(false);
        }

        T Keep<T>(T one) where T : Object
        {
            kept.Add(one);
            return one;
        }

        // World, m; at rest.
        void Add(float3[] points)
        {
            using (var positions = new NativeArray<float3>(points, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(points.Length, Allocator.Persistent))
                scene.Fluid.AddParticles(positions, velocities);
        }

        uint[] Counters() => GpuTest.Read<uint>(scene.Fluid.Solver.Mesh.Counters, Enum.GetValues(typeof(SurfaceMesh.Counter)).Length);
    }
}
