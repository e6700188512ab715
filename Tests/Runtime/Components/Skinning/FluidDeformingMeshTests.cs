using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Meshes that deform, in water.</summary>
    public class FluidDeformingMeshTests : PlayedFluidFixture
    {
        const float Spacing = 0.05f, Step = 1f / 60f;

        // Frames that a bake is spread over, and frames a second: at 30 a frame has two steps.
        static readonly int2[] Rates = { new int2(3, 60), new int2(1, 30) };

        SkinnedArm arm;
        GameObject ballObject;
        Mesh ball;

        [TearDown]
        public void DestroyShapes()
        {
            Object.DestroyImmediate(ballObject);
            arm?.Dispose();
            arm = null;
            Object.DestroyImmediate(ball);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator What_a_swinging_arm_meets_moves_with_the_surface_that_pushes_it([ValueSource(nameof(Rates))] int2 rates)
            => PushWithArm(rates);

        [UnityTest, Category("GpuOnly")]
        public IEnumerator What_a_swinging_arm_meets_moves_with_it_where_each_frame_has_a_bake() => PushWithArm(new int2(1, 60));

        // Particles that hang still in front of the lower arm, too far apart to feel each other.
        IEnumerator PushWithArm(int2 rates)
        {
            int framesPerBake = rates.x, steps = 60 / rates.y;
            float turn = 5f * steps;        // degrees a frame: 1.8 m/s at the hand, 0.6 spacings a step
            Time.captureDeltaTime = steps * Step;
            FluidDeformingMesh deforming = AddArm(mesh => mesh.Resolution = 64);
            deforming.TrianglesPerFrame = (deforming.TriangleCount + framesPerBake - 1) / framesPerBake;
            FluidSimulation fluid = Fluid("Still", new Vector3(3f, 3f, 1f), Spacing, 4000, Vector3.zero, f => f.Gravity = Vector3.zero);
            yield return null;
            for (int i = 0; i < 3; i++)
                Add(fluid, new float3(0.66f + 0.12f * i, 0.24f, 0.02f), 0f);
            yield return null;
            Assert.That(deforming.BakedFields, Is.EqualTo(1));

            int touching = 0;
            var met = new HashSet<uint>();      // before this frame: a particle that is met has not moved with the arm for all of a step
            float deepest = float.PositiveInfinity, asked = 0f, found = 0f;
            for (int i = 1; i <= 14 / steps; i++)
            {
                arm.Bend(i * turn);
                yield return null;
                // A field that takes several frames is late by those in which it is baked, and by those in which it is moved to.
                float angle = math.radians((i - 2 * (framesPerBake - 1)) * turn), rate = math.radians(turn) / (steps * Step);
                if (i < 2 * framesPerBake + 1)
                    continue;
                var axis = new float3(math.cos(angle), math.sin(angle), 0f);
                ParticleState state = TestFluid.Read(fluid.Solver);
                for (int k = 0; k < state.Count; k++)
                {
                    float3 position = fluid.DomainToWorld.MultiplyPoint3x4(state.positions[k].xyz) - arm.Lower.position;
                    float along = math.clamp(math.dot(position, axis), 0f, SkinnedArm.Length - 0.5f - SkinnedArm.Radius);
                    float3 from = position - along * axis;
                    float gap = math.length(from) - SkinnedArm.Radius;
                    deepest = math.min(deepest, gap);
                    if (gap > 0.6f * Spacing || along < 0.15f || met.Add(state.ids[k]))
                        continue;
                    touching++;
                    float3 normal = math.normalize(from);
                    asked += rate * along * math.dot(normal, new float3(-axis.y, axis.x, 0f));
                    found += Spacing * math.dot(state.velocities[k].xyz, normal);
                }
            }
            Assert.That(deforming.FramesPerBake, Is.EqualTo(framesPerBake));
            Assert.That(touching, Is.GreaterThan(3));
            Debug.Log($"{found / asked} of the velocity of the surface, {touching} times");
            Assert.That(found, Is.EqualTo(asked).Within(0.1f * asked), "sum of the velocities along the surface's normal");
            Assert.That(deepest, Is.GreaterThan(-0.25f * Spacing), "nothing is in the arm");
        }

        // Particles of 0.15 m feel it 0.3 m off, which is near the edges of its field. Sides of no multiple of a group of threads.
        [UnityTest]
        public IEnumerator Its_distances_are_there_up_to_the_edges_of_its_field()
        {
            const float large = 0.15f;
            FluidDeformingMesh deforming = AddArm(mesh => mesh.Resolution = 30);
            FluidSimulation fluid = Fluid("Air", new Vector3(2.1f, 1.2f, 1.2f), large, 2000, Vector3.zero, f =>
            {
                f.Gravity = Vector3.zero;
                f.transform.position = new Vector3(0.5f, 0f, 0f);
            });
            yield return null;
            var random = new Unity.Mathematics.Random(7u);
            for (int i = 0; i < 300; i++)
                Add(fluid, random.NextFloat3(new float3(-0.45f, -0.5f, -0.5f), new float3(1.45f, 0.5f, 0.5f)), 0f);
            yield return Frames(2);
            GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
            int3 sides = ((IDeformingShape)deforming).Field.Resolution;
            ParticleState state = TestFluid.Read(fluid.Solver);
            float[] distances = GpuTest.Read<float>(fluid.Solver.Colliders.ContactOffsets, state.Count);
            int far = 0;
            for (int i = 0; i < state.Count; i++)
            {
                float3 position = fluid.DomainToWorld.MultiplyPoint3x4(state.positions[i].xyz);
                float along = math.clamp(position.x, SkinnedArm.Radius, SkinnedArm.Length - SkinnedArm.Radius);
                float wanted = math.min((math.length(position - new float3(along, 0f, 0f)) - SkinnedArm.Radius) / large, 2f);
                if (wanted < 0f)
                    continue;
                Assert.That(distances[i], Is.EqualTo(wanted).Within(0.15f), $"at {position}");
                far += wanted > 1.2f && wanted < 2f ? 1 : 0;
            }
            TestContext.Out.WriteLine($"{sides} voxels, {far} of {state.Count} particles far off");
            Assert.That(math.any(sides % 4 != 0));
            Assert.That(far, Is.GreaterThan(30));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Water_around_a_swinging_arm_stays_out_of_it([Values] bool deep)
        {
            AddArm();
            FluidSimulation fluid = Fluid("Pool", new Vector3(1.8f, 1.6f, 0.6f), Spacing, 12000, new Vector3(1.8f, 1.1f, 0.6f), f =>
            {
                SolverSettings settings = f.Settings;
                settings.deepWater = deep ? DeepWater.On : DeepWater.Off;
                f.Settings = settings;
                f.transform.position = new Vector3(0.6f, 0.2f, 0f);
            });
            yield return Frames(2);
            int count = fluid.Solver == null ? 0 : TestFluid.Read(fluid.Solver).Count;
            float deepest = float.PositiveInfinity;
            for (int i = 0; i < 24; i++)
            {
                // Up to 2.3 m/s at the hand: 0.8 spacings a step.
                arm.Bend(-35f * math.sin(i * Step * 2.4f * math.PI));
                yield return null;
                if (i > 5)
                    deepest = math.min(deepest, Deepest(fluid));
            }
            ParticleState state = TestFluid.Read(fluid.Solver);
            Assert.That(state.Count, Is.EqualTo(count));
            Assert.That(deepest, Is.GreaterThan(-Spacing));
            Assert.That(state.velocities.Max(v => math.length(v.xyz)) * Spacing, Is.LessThan(6f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_ball_that_breathes_pushes_water_out_and_lets_it_back_without_a_loss()
        {
            TriangleMesh sphere = TestMeshes.Sphere(0.25f, 10);
            Vector3[] rest = sphere.Vertices;
            FluidDeformingMesh deforming = AddBall(sphere);
            FluidSimulation fluid = Fluid("Pool", new Vector3(1f, 1.3f, 1f), Spacing, 12000, new Vector3(1f, 0.9f, 1f),
                f => f.transform.position = new Vector3(0f, 0.2f, 0f));
            yield return Frames(50);
            int count = TestFluid.Read(fluid.Solver).Count;
            float before = Top(fluid), highest = 0f, deepest = float.PositiveInfinity;
            for (int i = 0; i <= 48; i++)
            {
                float radius = 1f + 0.3f * math.sin(i * math.PI / 48f);      // 1.3 after 0.4 s, and back
                ball.vertices = Array.ConvertAll(rest, v => radius * v);
                yield return null;
                ParticleState now = TestFluid.Read(fluid.Solver);
                highest = math.max(highest, Top(fluid));
                for (int k = 0; k < now.Count; k++)
                    deepest = math.min(deepest, fluid.DomainToWorld.MultiplyPoint3x4(now.positions[k].xyz).magnitude - 0.25f * radius);
            }
            yield return Frames(15);
            Assert.That(deforming.BakedFields, Is.GreaterThan(40));
            Assert.That(TestFluid.Read(fluid.Solver).Count, Is.EqualTo(count));
            Assert.That(deepest, Is.GreaterThan(-0.75f * Spacing));
            // 0.078 m³ more in 1 m² of water.
            Assert.That(highest - before, Is.InRange(0.04f, 0.3f));
            Assert.That(Top(fluid), Is.EqualTo(before).Within(0.06f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_mesh_that_rests_is_baked_once_and_the_water_may_sleep_beside_it()
        {
            FluidDeformingMesh deforming = AddArm();
            FluidSimulation fluid = Fluid("Pool", new Vector3(2f, 1f, 0.5f), Spacing, 4000, new Vector3(2f, 0.3f, 0.5f));
            // Kernels that blend two fields take longer.
            bool Blends(string stage) => StageShader.LoadCompute(stage).IsKeywordEnabled("RILL_DEFORMING");
            yield return Frames(5);
            Assert.That(deforming.BakedFields, Is.EqualTo(1));
            Assert.That((Blends("Colliders"), Blends("CoarseColliders")), Is.EqualTo((false, false)), "at rest");
            Assert.That(fluid.Input.colliders.Moves, Is.False);
            Assert.That(deforming.FieldAge, Is.Zero);

            arm.Object.transform.position += 0.3f * Vector3.up;
            arm.Object.transform.Rotate(0f, 20f, 0f);
            yield return Frames(2);
            Assert.That(deforming.BakedFields, Is.EqualTo(1), "carried as a whole it is the same field");

            arm.Bend(10f);
            yield return null;
            Assert.That(deforming.BakedFields, Is.EqualTo(2));
            Assert.That(fluid.Input.colliders.Moves, Is.True);
            Assert.That((Blends("Colliders"), Blends("CoarseColliders")), Is.EqualTo((true, true)), "while it deforms");
            yield return Frames(3);
            Assert.That(deforming.BakedFields, Is.EqualTo(2));
            Assert.That(fluid.Input.colliders.Moves, Is.False);
            Assert.That((Blends("Colliders"), Blends("CoarseColliders")), Is.EqualTo((false, false)), "at rest again");
        }

        [UnityTest]
        public IEnumerator The_age_of_a_field_grows_while_a_bake_is_spread_over_frames()
        {
            FluidDeformingMesh deforming = AddArm(mesh => mesh.TrianglesPerFrame = 200);
            Fluid("Pool", new Vector3(2f, 1f, 0.5f), Spacing, 4000, new Vector3(2f, 0.3f, 0.5f));
            yield return Frames(2);
            float oldest = 0f;
            for (int i = 0; i < 20; i++)
            {
                arm.Bend(2f * i);
                yield return null;
                oldest = math.max(oldest, deforming.FieldAge);
            }
            int frames = (deforming.TriangleCount + 199) / 200;
            Assert.That(frames, Is.GreaterThan(2));
            Assert.That(deforming.FramesPerBake, Is.EqualTo(frames));
            Assert.That(deforming.BakedFields, Is.InRange(20 / frames, 22 / frames + 1));
            Assert.That(oldest, Is.InRange((frames - 1) * Step, 2 * frames * Step));
        }

        [UnityTest]
        public IEnumerator Without_a_fluid_near_nothing_is_baked_or_held()
        {
            FluidDeformingMesh deforming = AddArm();
            Fluid("Far", Vector3.one, Spacing, 4000, new Vector3(1f, 0.3f, 1f), f => f.transform.position = 20f * Vector3.right);
            for (int i = 0; i < 5; i++)
            {
                arm.Bend(5f * i);
                yield return null;
            }
            Assert.That(deforming.BakedFields, Is.Zero);
            Assert.That(((IDeformingShape)deforming).Field, Is.Null);
            Assert.That(deforming.VoxelSize, Is.EqualTo(1.8f / 28f).Within(1e-5f), "m: an arm of 1 m and 0.4 m beyond, in 28 of 32 voxels");
        }

        [UnityTest]
        public IEnumerator What_cannot_be_baked_is_said_by_name()
        {
            GameObject bare = ballObject = new GameObject("Bare");
            LogAssert.Expect(LogType.Error,
                new Regex("FluidDeformingMesh 'Bare' is not a collider: it has no Skinned Mesh Renderer and no Mesh Filter"));
            var deforming = bare.AddComponent<FluidDeformingMesh>();
            ball = new Mesh { name = "Drop", vertices = new[] { Vector3.zero, Vector3.right, Vector3.up }, triangles = new[] { 0, 1, 2 } };
            bare.AddComponent<MeshFilter>().sharedMesh = ball;
            deforming.Refresh();
            var collider = bare.GetComponent<FluidCollider>();
            Assert.That(collider.Describe(out _), Is.Null);
            ball.vertices = ball.vertices.Append(Vector3.back).ToArray();
            Assert.That(collider.Describe(out _), Does.Contain("its mesh has 4 vertices now and had 3. Call Refresh"));
            ball.UploadMeshData(true);
            LogAssert.Expect(LogType.Error, new Regex("its mesh 'Drop' cannot be read. Tick Read/Write"));
            deforming.Refresh();

            LogAssert.Expect(LogType.Warning, new Regex("FluidDeformingMesh 'Bare': resolution 8 is outside 16 to 64; using 16"));
            deforming.Resolution = 8;
            LogAssert.Expect(LogType.Warning, new Regex("triangles per frame 1 is outside 100 to 10000000"));
            deforming.TrianglesPerFrame = 1;
            yield return null;
            LogAssert.NoUnexpectedReceived();
        }

        FluidDeformingMesh AddArm(Action<FluidDeformingMesh> setUp = null)
        {
            arm = new SkinnedArm();
            var deforming = arm.Object.AddComponent<FluidDeformingMesh>();
            deforming.Margin = 0.4f;
            setUp?.Invoke(deforming);
            arm.Object.SetActive(true);
            return deforming;
        }

        FluidDeformingMesh AddBall(TriangleMesh mesh)
        {
            ball = new Mesh { name = mesh.Name, vertices = mesh.Vertices, triangles = mesh.Triangles };
            ballObject = new GameObject("Ball");
            ballObject.SetActive(false);
            ballObject.AddComponent<MeshFilter>().sharedMesh = ball;
            var deforming = ballObject.AddComponent<FluidDeformingMesh>();
            deforming.Margin = 0.4f;
            ballObject.SetActive(true);
            return deforming;
        }

        // How far the particle that is deepest in the lower arm is from its surface, away from the elbow, m.
        float Deepest(FluidSimulation fluid)
        {
            ParticleState state = TestFluid.Read(fluid.Solver);
            Matrix4x4 toArm = arm.Lower.worldToLocalMatrix * fluid.DomainToWorld;
            float deepest = float.PositiveInfinity;
            for (int i = 0; i < state.Count; i++)
            {
                float3 position = toArm.MultiplyPoint3x4(state.positions[i].xyz);
                float along = math.clamp(position.x, 0f, SkinnedArm.Length - 0.5f - SkinnedArm.Radius);
                if (position.x > 0.15f)
                    deepest = math.min(deepest, math.length(position - new float3(along, 0f, 0f)) - SkinnedArm.Radius);
            }
            return deepest;
        }

        // Mean height of the highest particles, m.
        static float Top(FluidSimulation fluid)
        {
            ParticleState state = TestFluid.Read(fluid.Solver);
            return state.positions.Select(p => p.y).OrderByDescending(y => y).Take(state.Count / 20).Average() * Spacing;
        }
    }
}
