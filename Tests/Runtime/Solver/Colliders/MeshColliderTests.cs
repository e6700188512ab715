using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Baked meshes as colliders: the same as the shape that the mesh stands for.</summary>
    public class MeshColliderTests
    {
        const float Spacing = 0.05f;

        SignedDistanceField ball, box;
        GameObject water;

        [OneTimeSetUp]
        public void Bake()
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 24;
            settings.padding = 3;
            ball = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Sphere(0.5f, 24, new Vector3(0.1f, 0f, 0f)), settings));
            box = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Box(new Vector3(1f, 0.6f, 0.8f)), settings));
        }

        [OneTimeTearDown]
        public void DestroyFields()
        {
            foreach (SignedDistanceField field in new[] { ball, box })
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        }

        [TearDown]
        public void DestroyAll()
        {
            foreach (FluidCollider collider in SceneColliders.Enabled.ToArray())
                Object.DestroyImmediate(collider.gameObject);
            Object.DestroyImmediate(water);
        }

        [Test]
        public void A_scaled_and_turned_ball_is_as_far_away_as_the_sphere_that_it_is()
        {
            FluidSimulation simulation = Simulation(Points());
            FluidCollider collider = Add(ball, new Vector3(0.05f, 0.1f, -0.05f));
            collider.transform.localScale = 0.8f * Vector3.one;
            simulation.Advance(simulation.FixedStep);

            float3 center = simulation.DomainToWorld.inverse.MultiplyPoint3x4(collider.transform.TransformPoint(new Vector3(0.1f, 0f, 0f)));
            AssertDistances(simulation, p => math.distance(p, center) - 0.4f / Spacing);
        }

        [Test]
        public void Two_meshes_share_the_atlas_and_keep_their_distances()
        {
            FluidSimulation simulation = Simulation(Points());
            FluidCollider first = Add(ball, new Vector3(-0.5f, 0f, 0f)), second = Add(box, new Vector3(0.45f, 0f, 0f));
            first.transform.localScale = second.transform.localScale = 0.7f * Vector3.one;
            simulation.Advance(simulation.FixedStep);

            float3 center = simulation.DomainToWorld.inverse.MultiplyPoint3x4(first.transform.TransformPoint(new Vector3(0.1f, 0f, 0f)));
            float3 mid = simulation.DomainToWorld.inverse.MultiplyPoint3x4(second.transform.position);
            quaternion toBox = Quaternion.Inverse(second.transform.rotation) * water.transform.rotation;
            AssertDistances(simulation, p =>
            {
                float3 beyond = math.abs(math.mul(toBox, p - mid)) - 0.35f / Spacing * new float3(1f, 0.6f, 0.8f);
                float toTheBox = math.length(math.max(beyond, 0f)) + math.min(math.cmax(beyond), 0f);
                return math.min(math.distance(p, center) - 0.35f / Spacing, toTheBox);
            });
        }

        [Test]
        public void A_cube_whose_corners_lie_a_little_apart_lets_no_water_stay_inside()
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 24;
            SignedDistanceField cube = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Box(0.5f * Vector3.one).Apart(5e-8f), settings));
            try
            {
                float3 center = 8f;
                using (TestFluid fluid = new TestFluid(2f * center * Spacing, Spacing, 512).AddBlock((center - 4f) * Spacing, 8f * Spacing))
                {
                    ColliderMotion solid = ColliderTests.Still(ColliderShape.Mesh, cube.Bounds.extents / Spacing, center, quaternion.identity);
                    solid.field = cube.Texture;
                    solid.voxel = cube.VoxelSize / Spacing;
                    solid.fieldUnit = 1f / Spacing;
                    ColliderTests.Use(fluid, solid);
                    fluid.Step(60);
                    // Half a spacing is what a surface may be off.
                    Assert.That(fluid.Read().positions.Count(p => math.cmax(math.abs(p.xyz - center)) < 4.5f), Is.Zero);
                }
            }
            finally
            {
                Object.DestroyImmediate(cube.Texture);
                Object.DestroyImmediate(cube);
            }
        }

        // Two balls of which no mirror image is a turn, on an object or below a parent with a negative scale.
        [TestCase(-1f, 1f, 1f, 1f)]
        [TestCase(1f, 1f, -1f, 1f)]
        [TestCase(-1f, -1f, -1f, 1f)]
        [TestCase(1f, 1f, 1f, -1f)]
        [TestCase(1f, -1f, 1f, -1f)]
        public void A_negative_scale_mirrors_the_mesh(float x, float y, float z, float parentX)
        {
            FluidSimulation simulation = Simulation(Points());
            SignedDistanceField field = Balls();
            var parent = new GameObject("Parent");
            try
            {
                FluidCollider collider = Add(field, new Vector3(0.05f, 0.1f, -0.05f));
                collider.transform.SetParent(parent.transform);
                parent.transform.localScale = new Vector3(parentX, 1f, 1f);
                parent.transform.SetPositionAndRotation(water.transform.TransformPoint(new Vector3(0.1f, 0.1f, 0f)), Quaternion.Euler(-20f, 40f, 5f));
                collider.transform.localPosition = Vector3.zero;
                collider.transform.localScale = 0.8f * new Vector3(x, y, z);
                simulation.Advance(simulation.FixedStep);

                float3 ToDomain(Vector3 local) => simulation.DomainToWorld.inverse.MultiplyPoint3x4(collider.transform.TransformPoint(local));
                float3 large = ToDomain(LargeBall), small = ToDomain(SmallBall);
                AssertDistances(simulation, p => math.min(math.distance(p, large) - 0.8f * LargeRadius / Spacing,
                    math.distance(p, small) - 0.8f * SmallRadius / Spacing));
            }
            finally
            {
                Object.DestroyImmediate(parent);
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        }

        [Test]
        public void A_mesh_that_is_stretched_is_refused_by_name()
        {
            FluidSimulation simulation = Simulation(Points());
            FluidCollider collider = Add(box, Vector3.zero);
            collider.transform.localScale = new Vector3(1f, 0.5f, 1f);
            UnityEngine.TestTools.LogAssert.Expect(LogType.Error,
                new System.Text.RegularExpressions.Regex("'Collider' is left out: its scale .* is not the same along all axes"));
            simulation.Advance(simulation.FixedStep);
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.Zero);
        }

        // Half a voxel of the field is 0.8 d at most here; what counts is the surface, within 2 d.
        void AssertDistances(FluidSimulation simulation, System.Func<float3, float> expected)
        {
            PbfSolver solver = simulation.Solver;
            GpuTest.Run(cmd => solver.RecordStatistics(cmd, simulation.Input));
            ParticleState state = TestFluid.Read(solver);
            float[] distances = GpuTest.Read<float>(solver.Colliders.ContactOffsets, state.Count);
            int near = 0;
            for (int i = 0; i < state.Count; i++)
            {
                float wanted = math.min(expected(state.positions[i].xyz), 2f);
                if (wanted < -1f)
                    continue;
                Assert.That(distances[i], Is.EqualTo(wanted).Within(0.12f), $"at {state.positions[i].xyz}");
                near += wanted < 1.9f ? 1 : 0;
            }
            Assert.That(near, Is.GreaterThan(50));
        }

        const float LargeRadius = 0.35f, SmallRadius = 0.2f;
        static readonly Vector3 LargeBall = new Vector3(-0.25f, 0.1f, 0f), SmallBall = new Vector3(0.3f, -0.3f, 0.25f);

        // Result of a bake of both, finely meshed.
        static SignedDistanceField Balls()
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 48;
            settings.padding = 3;
            var bounds = new Bounds(LargeBall, 2f * LargeRadius * Vector3.one);
            bounds.Encapsulate(new Bounds(SmallBall, 2f * SmallRadius * Vector3.one));
            var grid = new SdfGrid(bounds, settings, false);
            int3 resolution = grid.Resolution;
            var distances = new float[resolution.x * resolution.y * resolution.z];
            for (int i = 0; i < distances.Length; i++)
            {
                float3 position = grid.Min + (new float3(i % resolution.x, i / resolution.x % resolution.y, i / (resolution.x * resolution.y))
                    + 0.5f) * grid.VoxelSize;
                distances[i] = math.min(math.distance(position, LargeBall) - LargeRadius, math.distance(position, SmallBall) - SmallRadius);
            }
            return SignedDistanceField.Create(new SdfBake("Balls", grid, distances, settings, MeshSdfSign.WindingNumber, 1));
        }

        static float3[] Points()
        {
            var random = new Unity.Mathematics.Random(5u);
            return Enumerable.Range(0, 1500).Select(_ => random.NextFloat3(-0.9f, 0.9f)).ToArray();
        }

        // Without gravity, in a box of 2 m; the particles stay about where they are given.
        FluidSimulation Simulation(float3[] points)
        {
            water = new GameObject("Water");
            water.SetActive(false);
            water.transform.SetPositionAndRotation(new Vector3(3f, 2f, -1f), Quaternion.Euler(0f, 30f, 0f));
            var simulation = water.AddComponent<FluidSimulation>();
            simulation.Configure(2f * Vector3.one, Spacing, 2000);
            simulation.StatisticsInterval = 0;
            simulation.Gravity = Vector3.zero;
            water.SetActive(true);
            using (var positions = new Unity.Collections.NativeArray<float3>(points.Select(p => (float3)water.transform.TransformPoint(p))
                .ToArray(), Unity.Collections.Allocator.Persistent))
            using (var velocities = new Unity.Collections.NativeArray<float3>(points.Length, Unity.Collections.Allocator.Persistent))
                simulation.AddParticles(positions, velocities);
            return simulation;
        }

        FluidCollider Add(SignedDistanceField field, Vector3 local)
        {
            var obstacle = new GameObject("Collider");
            obstacle.transform.SetPositionAndRotation(water.transform.TransformPoint(local), Quaternion.Euler(10f, 20f, 30f));
            var collider = obstacle.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Mesh;
            collider.Field = field;
            return collider;
        }
    }
}
