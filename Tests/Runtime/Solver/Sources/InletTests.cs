using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Emitters under water let water in at their rate and press away the water there, or say why they cannot.</summary>
    public class InletTests
    {
        const float Spacing = 0.05f;

        [Test, Category("LongRun")]
        public void Under_water_an_inlet_lets_in_its_rate_and_the_water_stays_calm([Values(0.2f, 1f, 3f)] float speed,
            [Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 20000, deepWater).Fill(0.3f))
            {
                scene.Step(30);
                float before = Fastest(scene), fastest = 0f, densest = 0f;
                FluidEmitter emitter = Inlet(scene, -0.5f, speed);
                for (int i = 0; i < 40; i++)
                {
                    scene.Step();
                    fastest = math.max(fastest, Fastest(scene));
                    if (i % 10 == 9)
                        densest = math.max(densest, scene.Measure().densityError);
                }
                FluidStatistics statistics = scene.AssertConserved();
                double due = emitter.DueVolume / scene.ParticleVolume;
                TestContext.Out.WriteLine($"{statistics.emitted} of {due:0.0} let in, C+ {densest:0.000}, fastest {fastest:0.00} m/s, before " +
                    $"{before:0.00}");
                Assert.That(statistics.emitted, Is.EqualTo(due).Within(0.01 * due + 1.0));
                Assert.That(statistics.blocked, Is.Zero);
                Assert.That(densest, Is.LessThan(0.04f), "mean error of the density");
                Assert.That(fastest, Is.LessThan(2.5f * speed + before + 0.5f));
            }
        }

        [Test, Category("LongRun")]
        public void Every_shape_that_has_an_outlet_presses_water_away(
            [Values(EmitterShape.Box, EmitterShape.Sphere, EmitterShape.Disc)] EmitterShape shape,
            [Values(EmitterMode.Jet, EmitterMode.Spray)] EmitterMode mode, [Values("up", "aside")] string direction)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 20000, DeepWater.On).Fill(0.4f))
            {
                scene.Step(30);
                Vector3 position = direction == "up" ? new Vector3(0.1f, -0.5f, 0f) : new Vector3(-0.5f, -0.3f, 0f);
                FluidEmitter emitter = scene.Add<FluidEmitter>(position, direction == "up" ? Vector3.up : Vector3.right, e =>
                {
                    e.Shape = shape;
                    e.Mode = mode;
                    e.Size = new Vector3(0.2f, 0.2f, 0.2f);
                    e.Radius = 0.12f;
                    e.Rate = 0.012f;
                    e.Speed = 1f;
                });
                scene.Step(60);
                FluidStatistics statistics = scene.AssertConserved();
                double due = emitter.DueVolume / scene.ParticleVolume;
                TestContext.Out.WriteLine($"{statistics.emitted} of {due:0.0}, waiting {statistics.waiting}, {Fastest(scene):0.00} m/s");
                Assert.That(statistics.emitted, Is.EqualTo(due).Within(0.01 * due + 1.0));
                Assert.That(statistics.densityError, Is.LessThan(0.01f));
                Assert.That(Fastest(scene), Is.LessThan(3f));
            }
        }

        [Test]
        public void An_inlet_keeps_its_rate_as_the_level_rises_over_it()
        {
            using (var scene = new SourceScene(new Vector3(0.5f, 1f, 0.5f), Spacing, 9000, DeepWater.On))
            {
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0f, -0.3f, 0f), Vector3.down, e =>
                {
                    e.Rate = 0.05f;
                    e.Speed = 2f;
                });
                scene.Step(150);
                FluidStatistics statistics = scene.AssertConserved();
                double due = emitter.DueVolume / scene.ParticleVolume;
                TestContext.Out.WriteLine($"{statistics.emitted} let in, {statistics.waiting} wait, C+ {statistics.densityError:0.000}");
                Assert.That(due, Is.EqualTo(1000).Within(1), "0.5 m of water");
                Assert.That(statistics.emitted, Is.EqualTo(due).Within(0.01 * due));
                Assert.That(statistics.densityError, Is.LessThan(0.02f));
            }
        }

        [Test, Category("LongRun")]
        public void What_cannot_let_in_says_why_once_with_the_remedy([Values("full box", "closed vessel", "outside", "fill", "mesh")] string cause)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 20000, DeepWater.On))
            {
                if (cause == "closed vessel")
                    Vessel(scene);
                else
                    scene.Fill(cause == "full box" ? 1f : 0.6f);
                scene.Step(20);
                LogAssert.Expect(LogType.Warning, new Regex(cause == "full box" ? "box of FluidSimulation 'Fluid' is full.*Drain the fluid"
                    : cause == "closed vessel" ? "water before it cannot yield.*Give the water an outlet"
                    : cause == "outside" ? "lies outside the box of FluidSimulation 'Fluid'.*Move it into the box"
                    : "water fills its shape.*Move it out of the water, or choose a Jet"));
                FluidEmitter emitter = Inlet(scene, cause == "outside" ? 3f : cause == "closed vessel" ? -0.2f : -0.3f, 1f, e =>
                {
                    e.Mode = cause == "fill" ? EmitterMode.Fill : EmitterMode.Jet;
                    if (cause != "mesh")
                        return;
                    e.Shape = EmitterShape.MeshSurface;
                    GameObject sphere = GameObject.CreatePrimitive(PrimitiveType.Sphere);
                    e.Mesh = sphere.GetComponent<MeshFilter>().sharedMesh;
                    UnityEngine.Object.DestroyImmediate(sphere);
                    e.transform.localScale = 0.2f * Vector3.one;
                });
                for (int i = 0; i < 170; i++)
                {
                    scene.Step();
                    AsyncGPUReadback.WaitAllRequests();
                }
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.Out.WriteLine($"{statistics.emitted} let in, {statistics.waiting} wait, {statistics.blocked} given up, C+ " +
                    $"{statistics.densityError:0.000}, {Fastest(scene):0.00} m/s");
                Assert.That(statistics.emitted + statistics.waiting + statistics.blocked,
                    Is.EqualTo(emitter.DueVolume / scene.ParticleVolume).Within(1));
                Assert.That(statistics.blocked, Is.GreaterThan(100));
                Assert.That(statistics.densityError, Is.LessThan(0.25f));
                Assert.That(Fastest(scene), Is.LessThan(6f));
                LogAssert.NoUnexpectedReceived();
            }
        }

        // Between the plate and the outlet the water turns aside.
        [Test, Category("LongRun")]
        public void An_inlet_that_faces_a_wall_stays_calm([Values(0.1f, 0.25f)] float gap)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 20000, DeepWater.On).Fill(0.4f))
            {
                Box(scene, new Vector3(0f, -0.5f + gap + 0.05f, 0f), new Vector3(0.5f, 0.1f, 0.5f));
                scene.Step(20);
                Inlet(scene, -0.5f, 1f);
                float fastest = 0f;
                for (int i = 0; i < 60; i++)
                    fastest = math.max(fastest, Fastest(scene.Step()));
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.Out.WriteLine($"{statistics.emitted} let in, {statistics.waiting} wait, C+ {statistics.densityError:0.000}, " +
                    $"{fastest:0.00} m/s");
                Assert.That(statistics.emitted, Is.GreaterThan(100));
                Assert.That(fastest, Is.LessThan(6f));
                Assert.That(statistics.densityError, Is.LessThan(0.1f));
            }
        }

        [Test]
        public void Water_that_a_turning_inlet_presses_away_turns_along()
        {
            const float perStep = 4f, radius = 0.25f, speed = 0.4f;     // degrees, m, m/s
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 20000).Fill(0.5f))
            {
                scene.Step(20);
                int before = scene.Read().Count, count = 0;
                FluidEmitter emitter = Inlet(scene, -0.5f, speed, e =>
                {
                    e.Radius = radius;
                    e.Rate = math.PI * radius * radius * speed;
                });
                float along = 0f, whole = 0f;
                for (int step = 0; step < 12; step++)
                {
                    emitter.transform.Rotate(0f, perStep, 0f, Space.World);
                    scene.Step();
                    ParticleState state = scene.Read();
                    for (int i = 0; i < state.Count && step >= 2; i++)
                    {
                        float3 arm = state.positions[i].xyz * Spacing - new float3(0.5f, 0f, 0.5f);
                        if (state.ids[i] >= before || arm.y > 2f * Spacing || math.length(arm.xz) > radius)
                            continue;
                        arm.y = 0f;
                        float3 expected = math.cross(new float3(0f, math.radians(perStep) / SourceScene.Step60, 0f), arm);
                        along += math.dot(state.velocities[i].xyz * Spacing, expected);
                        whole += math.lengthsq(expected);
                        count++;
                    }
                }
                TestContext.Out.WriteLine($"{along / whole:0.00} of the turn, by {count}");
                Assert.That(along / whole, Is.GreaterThan(0.8f));
            }
        }

        [Test]
        public void Where_a_step_has_substeps_each_lets_in_its_part([Values(1, 2, 3)] int substeps)
        {
            const float rate = 0.011f, speed = 2.3f;
            using (var scene = new SourceScene(new Vector3(2f, 2f, 2f), Spacing, 5000))
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.substeps = substeps;
                scene.Fluid.Settings = settings;
                scene.Fluid.Gravity = Vector3.zero;
                scene.Add<FluidEmitter>(new Vector3(-0.9f, 0.1f, 0.2f), Vector3.right, e =>
                {
                    e.Rate = rate;
                    e.Speed = speed;
                });
                for (int step = 1; step <= 12; step++)
                {
                    scene.Step();
                    ParticleState state = scene.Read();
                    Assert.That(state.Count, Is.EqualTo((int)(rate * step / 60f / scene.ParticleVolume + 1e-4)), $"after step {step}");
                    for (int i = 0; i < state.Count; i++)
                    {
                        float age = step / 60f - (state.ids[i] + 1) * scene.ParticleVolume / rate;
                        Assert.That(state.positions[i].x * Spacing - 1f, Is.EqualTo(-0.9f + 0.5f * Spacing + speed * age).Within(0.1f * Spacing),
                            $"particle {state.ids[i]} of age {age}");
                    }
                    int fresh = state.Count - scene.Count(ParticleCounter.Moved);
                    Assert.That(fresh, Is.LessThanOrEqualTo(math.ceil(rate / 60f / substeps / scene.ParticleVolume)), "let in by the last substep");
                }
            }
        }

        static FluidEmitter Inlet(SourceScene scene, float y, float speed, Action<FluidEmitter> set = null) => scene.Add<FluidEmitter>(
            new Vector3(0f, y, 0f), Vector3.up, e =>
            {
                e.Rate = math.PI * 0.01f * speed;       // all of the outlet at rest density
                e.Speed = speed;
                e.Radius = 0.105f;
                set?.Invoke(e);
            });

        // Six plates around water that fills all between them.
        static void Vessel(SourceScene scene)
        {
            for (int side = 0; side < 6; side++)
            {
                float3 at = 0f, size = 0.6f;
                at[side / 2] = side % 2 == 0 ? -0.25f : 0.25f;
                size[side / 2] = 0.1f;
                Box(scene, at, size);
            }
            var water = new GameObject("Water");
            water.transform.SetParent(scene.Fluid.transform, false);
            water.AddComponent<FluidVolume>().Size = 0.4f * Vector3.one;
            scene.Fluid.Restart();
        }

        static void Box(SourceScene scene, Vector3 at, Vector3 size)
        {
            var gameObject = new GameObject("Plate");
            gameObject.transform.SetParent(scene.Fluid.transform, false);
            gameObject.transform.localPosition = at;
            var collider = gameObject.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Box;
            collider.Size = size;
        }

        static float Fastest(SourceScene scene) => scene.Read().velocities.Max(v => math.length(v.xyz)) * scene.Fluid.ParticleSpacing;
    }
}
