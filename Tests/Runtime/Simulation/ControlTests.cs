using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = NUnit.Framework.Is;

namespace Rill.Tests
{
    /// <summary>Scripts that add, fill and remove while the fluid runs.</summary>
    public class ControlTests
    {
        const float Spacing = 0.1f;

        static readonly Vector3 Box = new Vector3(1f, 1f, 0.5f);

        // Water 4 particles deep, at rest: 200.
        static SourceScene Basin(int capacity = 2000) => new SourceScene(Box, Spacing, capacity).Fill(0.4f);

        [Test]
        public void Clear_removes_all_water_at_once_and_time_statistics_and_emitters_go_on()
        {
            using (SourceScene scene = Basin().Step(5))
            {
                scene.Fluid.Clear();
                Assert.That(scene.Read().Count, Is.Zero);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(5));
                scene.Add<FluidEmitter>(new Vector3(0f, 0.2f, 0f), Vector3.down, e => (e.Rate, e.Speed) = (0.01f, 1f));
                scene.Step(30);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.step, Is.EqualTo(35));
                Assert.That(statistics.added, Is.EqualTo(200));
                Assert.That(statistics.drained, Is.EqualTo(200));
                Assert.That(statistics.particles, Is.EqualTo(statistics.emitted).And.GreaterThan(3));
            }
        }

        [Test]
        public void Clear_and_fill_in_one_frame_use_the_whole_capacity_and_give_new_ids()
        {
            using (SourceScene scene = Basin(200).Step(3))
            {
                scene.Fluid.Clear();
                scene.Fluid.Fill(FluidShape.Box(new Vector3(0f, -0.3f, 0f), new Vector3(1f, 0.4f, 0.5f)));
                Assert.That(scene.Read().Count, Is.EqualTo(200));
                Assert.That(scene.Read().ids.Min(), Is.EqualTo(200u));
                FluidStatistics statistics = scene.Step(3).AssertConserved();
                Assert.That(statistics.added, Is.EqualTo(400));
                Assert.That(statistics.refused, Is.Zero);
            }
        }

        // Between steps what was removed is only marked.
        [Test]
        public void What_was_removed_since_the_last_step_is_in_no_reading_of_the_particles([Values] bool byTheBox)
        {
            using (SourceScene scene = Basin().Step(5))
            using (var readback = new ParticleReadback())
            {
                ParticleState before = scene.Read();
                bool IsLeft(float4 position) => byTheBox ? position.y > 1f : position.x > 5f;
                uint[] left = Enumerable.Range(0, before.Count).Where(i => IsLeft(before.positions[i])).Select(i => before.ids[i]).ToArray();
                scene.Fluid.Paused = true;
                if (byTheBox)
                    scene.Fluid.Recenter(new Vector3(0f, Spacing, 0f));
                else
                    scene.Fluid.RemoveInside(FluidShape.Box(new Vector3(-0.25f, 0f, 0f), new Vector3(0.5f, 1f, 0.5f)));
                ParticleFrame frame = null;
                ParticleExport.Request(scene.Fluid, (found, problem) => frame = found);
                scene.Fluid.RequestParticles(readback, ParticleFields.Velocities | ParticleFields.Ids);
                AsyncGPUReadback.WaitAllRequests();
                Compare.Same("ids of the file", frame.Ids, left);
                Assert.That(frame.Positions.All(p => math.all(math.isfinite(p))) && frame.Velocities.All(v => math.all(math.isfinite(v))));
                Compare.Same("ids of the readback", readback.Ids.ToArray(), left);
                Assert.That(readback.Velocities.ToArray().All(v => math.all(math.isfinite(v))));
                Assert.That(() => readback.Positions, Throws.InvalidOperationException, "they were not asked for");
                FluidStatistics statistics = scene.Fluid.Results.Measurements.MeasureNow();
                Assert.That((statistics.particles, statistics.nonFinite), Is.EqualTo((left.Length, 0)));
            }
        }

        [Test]
        public void A_sphere_a_capsule_and_a_turned_box_remove_exactly_the_particles_whose_center_is_inside([Values(0, 1, 2)] int kind,
            [Values(false, true)] bool sleeps)
        {
            using (SourceScene scene = Basin())
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.sleepSpeed = sleeps ? 0.02f : 0f;
                scene.Fluid.Settings = settings;
                scene.Fluid.transform.SetPositionAndRotation(new Vector3(3f, -2f, 1f), Quaternion.Euler(10f, 40f, 5f));
                scene.Fluid.Restart();
                scene.Step(4);
                Vector3 center = scene.Fluid.transform.TransformPoint(new Vector3(0.1f, -0.35f, 0.02f));
                Quaternion turn = Quaternion.Euler(25f, -70f, 15f);
                var size = new Vector3(0.5f, 0.3f, 0.33f);
                Vector3 end = center + 0.33f * (turn * Vector3.right);
                Func<Vector3, bool> isInside = kind == 0 ? p => (p - center).magnitude <= 0.27f
                    : kind == 1 ? p => DistanceToSegment(p, center, end) <= 0.18f
                    : (Func<Vector3, bool>)(p => IsInBox(Quaternion.Inverse(turn) * (p - center), size));
                FluidShape shape = kind == 0 ? FluidShape.Sphere(center, 0.27f) : kind == 1 ? FluidShape.Capsule(center, end, 0.18f)
                    : FluidShape.Box(center, size, turn);

                ParticleState before = scene.Read();
                Matrix4x4 toWorld = scene.Fluid.DomainToWorld;
                uint[] expected = before.ids.Where((_, i) => !isInside(toWorld.MultiplyPoint3x4(before.positions[i].xyz))).OrderBy(id => id)
                    .ToArray();
                Assert.That(expected.Length, Is.InRange(20, before.Count - 10));
                scene.Fluid.RemoveInside(shape);
                scene.Step();
                Assert.That(scene.Read().ids.OrderBy(id => id), Is.EqualTo(expected));
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.drained, Is.EqualTo(before.Count - expected.Length));
                Assert.That(statistics.nonFinite, Is.Zero);
            }
        }

        [Test]
        public void What_is_removed_inside_and_then_cleared_is_counted_once()
        {
            using (SourceScene scene = Basin().Step())
            {
                scene.Fluid.RemoveInside(FluidShape.Sphere(Vector3.down * 0.3f, 0.25f));
                scene.Fluid.RemoveInside(FluidShape.Sphere(Vector3.down * 0.3f, 0.3f));
                scene.Fluid.Clear();
                FluidStatistics statistics = scene.Step().AssertConserved();
                Assert.That(statistics.drained, Is.EqualTo(200));
                Assert.That(statistics.nonFinite, Is.Zero);
            }
        }

        [Test]
        public void A_fill_of_water_that_is_there_adds_nothing_and_over_it_the_missing_half()
        {
            using (SourceScene scene = Basin().Step(60))
            {
                int before = scene.Read().Count;
                scene.Fluid.Fill(FluidShape.Box(new Vector3(0f, -0.35f, 0f), new Vector3(1f, 0.3f, 0.5f)));
                int same = scene.Read().Count;
                scene.Fluid.Fill(FluidShape.Box(new Vector3(0f, -0.1f, 0f), new Vector3(1f, 0.8f, 0.5f)));
                int full = scene.Read().Count;
                FluidStatistics statistics = scene.Step(90).AssertConserved();
                TestContext.Out.WriteLine($"{before} particles, {same} after a fill of the same space, {full} of 400 after one twice as " +
                    $"high, {statistics.densityError:0.0000} density error");
                Assert.That(same - before, Is.InRange(0, 5));
                Assert.That(full, Is.InRange(340, 410));
                Assert.That(statistics.densityError, Is.LessThan(0.02f));
            }
        }

        [Test]
        public void A_volume_anywhere_in_the_scene_fills_with_its_velocity_and_what_lies_outside_is_left_out()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 1000))
            {
                var gameObject = new GameObject("Elsewhere");
                try
                {
                    var volume = gameObject.AddComponent<FluidVolume>();
                    volume.Size = new Vector3(0.4f, 0.4f, 0.2f);
                    volume.Velocity = new Vector3(1f, 0f, 0f);
                    gameObject.transform.position = new Vector3(0.5f, 0f, 0f);      // half of it
                    scene.Fluid.Fill(volume);
                    ParticleState state = scene.Read();
                    Assert.That(state.Count, Is.EqualTo(16));
                    Assert.That(state.velocities.All(v => math.abs(v.x * Spacing - 1f) < 1e-5f));

                    LogAssert.Expect(LogType.Warning,
                        new Regex("'Fluid' filled nothing of FluidVolume 'Elsewhere': none of its 32 particles lies in the box"));
                    gameObject.transform.position = Vector3.right * 5f;
                    scene.Fluid.Fill(volume);
                    scene.Fluid.Fill(volume);
                    Assert.That(scene.Read().Count, Is.EqualTo(16));
                }
                finally
                {
                    UnityEngine.Object.DestroyImmediate(gameObject);
                }
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_fill_leaves_colliders_free()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 1000))
            {
                var gameObject = new GameObject("Ball");
                try
                {
                    var ball = gameObject.AddComponent<FluidCollider>();
                    (ball.Shape, ball.Radius) = (ColliderShape.Sphere, 0.2f);
                    scene.Step();
                    scene.Fluid.Fill(FluidShape.Box(Vector3.zero, Box));
                    ParticleState state = scene.Read();
                    float nearest = state.positions.Min(p => Vector3.Distance(scene.Fluid.DomainToWorld.MultiplyPoint3x4(p.xyz), Vector3.zero));
                    TestContext.Out.WriteLine($"{state.Count} particles, the nearest {nearest:0.000} m from the center");
                    Assert.That(state.Count, Is.InRange(420, 490));     // of 500; the ball with half a spacing around it holds 65
                    Assert.That(nearest, Is.GreaterThan(0.2f + 0.4f * Spacing));
                }
                finally
                {
                    UnityEngine.Object.DestroyImmediate(gameObject);
                }
            }
        }

        [Test]
        public void A_fill_is_the_same_on_every_run()
        {
            ParticleState first = null;
            for (int run = 0; run < 2; run++)
                using (SourceScene scene = Basin().Step(20))
                {
                    scene.Fluid.Fill(FluidShape.Sphere(new Vector3(0f, 0.1f, 0f), 0.35f), Vector3.down);
                    ParticleState state = scene.Step(10).Read();
                    first ??= state;
                    TestFluid.AssertSame(state, first);
                }
        }

        [Test]
        public void Phase_and_lifetime_of_what_a_script_adds_are_kept_and_end_on_time([Values(false, true)] bool fills)
        {
            using (SourceScene scene = Basin().Step(2))
            {
                if (fills)
                    scene.Fluid.Fill(FluidShape.Box(new Vector3(0f, 0.3f, 0f), new Vector3(0.2f, 0.2f, 0.2f)), default, 5, 0.1f);
                else
                    Add(scene.Fluid, 8, 5, 0.1f);
                Assert.That(Phases(scene).Count(phase => phase == 5), Is.EqualTo(8));
                Assert.That(scene.Step(6).Read().Count, Is.EqualTo(208));
                Assert.That(Phases(scene).Count(phase => phase == 5), Is.EqualTo(8));
                Assert.That(scene.Step().Read().Count, Is.EqualTo(200));        // 6 steps are over
                Assert.That(Phases(scene).All(phase => phase == 0));
                scene.AssertConserved();
            }
        }

        [Test]
        public void What_the_capacity_does_not_hold_is_refused_counted_and_logged_once()
        {
            using (SourceScene scene = Basin(250).Step())
            {
                LogAssert.Expect(LogType.Warning, new Regex("'Fluid' refused 50 particles that scripts added: its capacity of 250 is full"));
                Add(scene.Fluid, 100);
                AsyncGPUReadback.WaitAllRequests();
                scene.Fluid.Fill(FluidShape.Box(new Vector3(0f, 0.3f, 0f), new Vector3(0.2f, 0.2f, 0.2f)));
                AsyncGPUReadback.WaitAllRequests();
                FluidStatistics statistics = scene.Step().AssertConserved();
                Assert.That(statistics.refused, Is.InRange(51, 58));
                Assert.That(scene.Fluid.Solver.RefusedOfScripts, Is.EqualTo(statistics.refused));
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void Adding_clearing_and_removing_in_every_frame_allocate_no_managed_memory()
        {
            using (SourceScene scene = Basin(5000).Step())
            using (var positions = new NativeArray<float3>(50, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(50, Allocator.Persistent))
            {
                int frames = 0;
                TestDelegate frame = () =>
                {
                    frames++;
                    scene.Fluid.AddParticles(positions, velocities, 2, 1f);
                    scene.Fluid.RemoveInside(FluidShape.Sphere(Vector3.zero, 0.1f));
                    scene.Step();
                };
                for (int i = 0; i < 10; i++)
                {
                    frame();
                    AsyncGPUReadback.WaitAllRequests();
                }
                for (int i = 0; i < 10; i++)
                {
                    Assert.That(frame, Is.Not.AllocatingGCMemory(), $"frame {i}");
                    AsyncGPUReadback.WaitAllRequests();
                }
                Assert.That(scene.AssertConserved().drained, Is.EqualTo(frames * 50).And.GreaterThan(900));
            }
        }

        [Test]
        public void A_box_that_is_put_elsewhere_leaves_the_water_where_it_is_in_the_world_and_removes_what_is_outside()
        {
            using (SourceScene scene = Basin())
            {
                scene.Fluid.transform.SetPositionAndRotation(new Vector3(30f, 1f, -8f), Quaternion.Euler(0f, 30f, 0f));
                scene.Fluid.Restart();
                scene.Step(5);
                ParticleState before = scene.Read();
                Matrix4x4 toWorld = scene.Fluid.DomainToWorld;
                Vector3 along = scene.Fluid.transform.right;
                scene.Fluid.Recenter(scene.Fluid.transform.position + 0.3f * along);
                ParticleState after = scene.Read();
                Assert.That(after.Count, Is.EqualTo(before.Count), "until the step");
                int removed = 0;
                for (int i = 0; i < after.Count; i++)
                {
                    bool isOutside = before.positions[i].x < 3f + 0.25f;
                    removed += isOutside ? 1 : 0;
                    Assert.That(math.all(math.isfinite(after.positions[i].xyz)), Is.EqualTo(!isOutside),
                        $"particle {i} at {before.positions[i].x} d");
                    Vector3 was = toWorld.MultiplyPoint3x4(before.positions[i].xyz);
                    if (!isOutside)
                        Assert.That(Vector3.Distance(scene.Fluid.DomainToWorld.MultiplyPoint3x4(after.positions[i].xyz), was),
                            Is.LessThan(0.26f * Spacing).And.LessThan(before.positions[i].x < 3.5f ? 1f : 1e-4f));
                }
                Compare.Same("velocities", after.velocities, before.velocities);
                Assert.That(removed, Is.EqualTo(60));       // three layers of 20
                scene.Step(3);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.drained, Is.EqualTo(removed));
                Assert.That(statistics.speedMax, Is.LessThan(1.5f));        // what gravity gives in 3 steps and a wall that is gone
            }
        }

        [Test, Category("LongRun")]
        public void A_lake_around_a_target_that_moves_stays_calm_and_keeps_its_amount([Values] DeepWater deepWater)
        {
            using (var scene = new SourceScene(new Vector3(1.6f, 1f, 0.8f), Spacing, 2000, deepWater))
            {
                scene.Fill(0.8f).Step(60);
                int before = scene.Read().Count;
                float worst = 0f;
                for (int i = 1; i <= 6; i++)
                {
                    scene.Fluid.Recenter(new Vector3(0.2f * i, 0f, 0f));
                    scene.Fluid.Fill(FluidShape.Box(new Vector3(0.2f * i, -0.1f, 0f), new Vector3(1.6f, 0.8f, 0.8f)));
                    scene.Step(15);
                    worst = math.max(worst, scene.Measure().speed);
                }
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.Out.WriteLine($"{before} particles, {statistics.particles} after six moves, rms speed at most " +
                    $"{worst:0.000} m/s, density error {statistics.densityError:0.0000}");
                Assert.That(statistics.particles, Is.EqualTo(before).Within(0.05f * before));
                Assert.That(worst, Is.LessThan(0.3f));
                Assert.That(statistics.drained, Is.GreaterThan(600));
            }
        }

        [Test]
        public void Misuse_names_what_is_wrong()
        {
            using (SourceScene scene = Basin().Step())
            {
                FluidSimulation fluid = scene.Fluid;
                Assert.That(Assert.Throws<ArgumentException>(() => FluidShape.Sphere(Vector3.zero, -1f)).Message, Does.Contain("radius -1"));
                Assert.That(Assert.Throws<ArgumentException>(() => FluidShape.Box(Vector3.zero, new Vector3(1f, float.NaN, 1f))).Message,
                    Does.Contain("finite"));
                Assert.That(Assert.Throws<ArgumentException>(() => fluid.Fill(FluidShape.Sphere(Vector3.zero, 100f))).Message,
                    Does.Contain("more than 16,777,216 particles of spacing 0.1 m"));
                Assert.That(Assert.Throws<ArgumentOutOfRangeException>(() => fluid.Fill(FluidShape.Sphere(Vector3.zero, 1f), default,
                    8)).Message, Does.Contain("0 to 7"));
                Assert.That(Assert.Throws<ArgumentOutOfRangeException>(() => fluid.Fill(FluidShape.Sphere(Vector3.zero, 1f), default, 0,
                    -1f)).Message, Does.Contain("86400"));
                Assert.That(Assert.Throws<ArgumentException>(() => fluid.Recenter(new Vector3(float.NaN, 0f, 0f))).Message, Does.Contain("finite"));
                Assert.Throws<ArgumentNullException>(() => fluid.Fill((FluidVolume)null));
                Exception inPass = null;
                fluid.BeforeStep += (commands, particles) => inPass = Assert.Throws<InvalidOperationException>(() => fluid.Clear());
                scene.Step();
                Assert.That(inPass.Message, Does.Contain("BeforeStep").And.Contain("Update"));
                fluid.enabled = false;
                Assert.That(Assert.Throws<InvalidOperationException>(() => fluid.Clear()).Message, Does.Contain("'Fluid' is not running"));
                Assert.That(Assert.Throws<InvalidOperationException>(() => fluid.RemoveInside(default)).Message,
                    Does.Contain("before removing particles"));
            }
        }

        static void Add(FluidSimulation fluid, int count, int phase = 0, float lifetime = 0f)
        {
            float3[] points = Enumerable.Range(0, count)
                .Select(i => new float3(-0.4f + 0.1f * (i % 8), 0.05f + 0.1f * (i / 8 % 4), -0.15f + 0.1f * (i / 32))).ToArray();
            using (var positions = new NativeArray<float3>(points, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(count, Allocator.Persistent))
                fluid.AddParticles(positions, velocities, phase, lifetime);
        }

        static uint[] Phases(SourceScene scene)
            => GpuTest.Read<uint>(scene.Fluid.Solver.Tags, scene.Read().Count).Select(tag => tag >> ParticleTags.PhaseShift).ToArray();

        static float DistanceToSegment(Vector3 p, Vector3 a, Vector3 b)
        {
            float along = Mathf.Clamp01(Vector3.Dot(p - a, b - a) / (b - a).sqrMagnitude);
            return Vector3.Distance(p, a + along * (b - a));
        }

        static bool IsInBox(Vector3 p, Vector3 size) => Mathf.Abs(p.x) <= 0.5f * size.x && Mathf.Abs(p.y) <= 0.5f * size.y
            && Mathf.Abs(p.z) <= 0.5f * size.z;
    }
}
