using System;
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
    /// <summary>Emitters in a fluid, judged by counts, by instants and by the room that particles leave each other.</summary>
    public class EmitterTests
    {
        const float Spacing = 0.05f;
        static readonly Vector3 Box = new Vector3(2f, 2f, 2f);

        static Action<FluidEmitter> Jet(float rate, float speed = 2f, float radius = 0.1f) => emitter =>
        {
            emitter.Rate = rate;
            emitter.Speed = speed;
            emitter.Radius = radius;
        };

        [Test]
        public void A_jet_lets_in_the_rate_times_the_time_at_any_frame_rate([Values(1f / 30f, 1f / 60f, 1f / 144f, 0.05f)] float frame,
            [Values(0.003f, 0.02f)] float rate)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                FluidEmitter emitter = scene.Add(new Vector3(0f, 0.9f, 0f), Vector3.down, Jet(rate));
                for (int i = 0; i < 20; i++)
                {
                    scene.Fluid.Advance(frame);
                    double due = rate * scene.Fluid.FluidTime / scene.ParticleVolume;
                    Assert.That(scene.Count(ParticleCounter.Emitted), Is.InRange((int)Math.Floor(due - 1e-3), (int)Math.Floor(due + 1e-3)),
                        $"after {scene.Fluid.FluidTime} s");
                }
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.blocked + statistics.waiting + statistics.refused, Is.Zero);
                scene.ReadBack();
                Assert.That(emitter.Emitted, Is.EqualTo(statistics.emitted));
                Assert.That(emitter.EmittedVolume, Is.EqualTo(emitter.DueVolume).Within(1e-9));
            }
        }

        // Without gravity and at rest density nothing else moves them: each is as far out as its own instant says, across all steps.
        [Test]
        public void A_particle_is_where_it_would_be_by_then([Values(1, 5, 12)] int steps, [Values(0.004f, 0.015f)] float rate)
        {
            const float speed = 2.3f;
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.Add(new Vector3(-0.9f, 0.1f, 0.2f), Vector3.right, Jet(rate, speed));
                scene.Step(steps);
                ParticleState state = scene.Read();
                Assert.That(state.Count, Is.EqualTo((int)(rate * steps / 60f / scene.ParticleVolume)));
                for (int i = 0; i < state.Count; i++)
                {
                    float age = steps / 60f - (state.ids[i] + 1) * scene.ParticleVolume / rate;
                    float3 meters = state.positions[i].xyz * Spacing - (float3)Box * 0.5f;
                    Assert.That(meters.x, Is.EqualTo(-0.9f + 0.5f * Spacing + speed * age).Within(0.1f * Spacing),
                        $"particle {state.ids[i]} of age {age}");
                    Assert.That(math.length(meters.yz - new float2(0.1f, 0.2f)), Is.LessThan(0.1f + 0.1f * Spacing));
                    Assert.That(math.distance(state.velocities[i].xyz * Spacing, new float3(speed, 0f, 0f)), Is.LessThan(0.15f));
                }
            }
        }

        // Without gravity: each particle comes from where the emitter was at its own instant, whatever the frames and steps.
        [Test]
        public void A_moving_emitter_lets_in_along_all_of_its_way([Values(1, 2, 4)] int stepsInAFrame, [Values] bool turns)
        {
            const float rate = 0.004f, speed = 2.3f, moved = 0.8f;
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                FluidEmitter emitter = scene.Add(new Vector3(-0.8f, turns ? 0f : -0.9f, 0f), Vector3.up, Jet(rate, speed, 0.01f));
                emitter.InheritVelocity = 0f;
                Quaternion first = emitter.transform.rotation;
                double before = FrameOf(scene, stepsInAFrame), all = before;
                for (int frame = 1; frame <= 8 / stepsInAFrame; frame++)
                {
                    float fraction = frame * stepsInAFrame / 8f;
                    if (turns)
                        emitter.transform.rotation = Quaternion.Euler(0f, 0f, -70f * fraction) * first;
                    else
                        emitter.transform.position = new Vector3(-0.8f + moved * fraction, -0.9f, 0f);
                    all += FrameOf(scene, stepsInAFrame);
                }
                ParticleState state = scene.Read();
                Assert.That(state.Count, Is.EqualTo((int)(rate * all / scene.ParticleVolume + 1e-6)));
                for (int i = 0; i < state.Count; i++)
                {
                    double instant = (state.ids[i] + 1) * scene.ParticleVolume / rate;
                    float fraction = (float)math.saturate((instant - before) / (all - before));
                    Vector3 position = new Vector3(-0.8f + (turns ? 0f : moved * fraction), turns ? 0f : -0.9f, 0f);
                    Vector3 direction = turns ? Quaternion.Euler(0f, 0f, -70f * fraction) * Vector3.up : Vector3.up;
                    float3 expected = position + direction * (0.5f * Spacing + speed * (float)(all - instant));
                    Assert.That(math.distance(state.positions[i].xyz * Spacing - (float3)Box * 0.5f, expected),
                        Is.LessThan(0.25f * Spacing), $"particle {state.ids[i]}, let in at {instant} s of {all} s");
                }
                Assert.That(scene.AssertConserved().waiting, Is.Zero);
            }
        }

        // Without gravity each goes straight from where the nozzle was, with the nozzle's velocity then besides its own. The nozzle
        // sits on an arm that turns while its foot moves, and turns with it; points off its axis go round it.
        [Test, Category("LongRun")]
        public void What_leaves_a_moving_emitter_takes_its_velocity_along([Values(1, 4)] int stepsInAFrame, [Values(0f, 0.4f, 1f)] float fraction)
        {
            const float rate = 0.007f, speed = 1.1f;        // about one particle a step
            const int frames = 6;
            using (var scene = new SourceScene(2f * Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                FluidEmitter emitter = scene.Add<FluidEmitter>(Vector3.zero, Vector3.up, e =>
                {
                    e.Mode = EmitterMode.Spray;
                    e.Rate = rate;
                    e.Speed = speed;
                    e.Radius = 0.4f;
                    e.InheritVelocity = fraction;
                });
                var at = new (double time, Vector3 position, Quaternion rotation)[frames + 2];
                double time = 0.0;
                for (int frame = 0; frame <= frames; frame++)
                {
                    Quaternion turn = Quaternion.Euler(0f, 25f * frame, 8f * frame);
                    emitter.transform.SetPositionAndRotation(new Vector3(-0.5f + 0.12f * frame, -0.3f, 0f) + turn * new Vector3(0.3f, 0f,
                        0f), turn * Quaternion.LookRotation(Vector3.up, Vector3.forward));
                    time += FrameOf(scene, stepsInAFrame);
                    at[frame + 1] = (time, emitter.transform.position, emitter.transform.rotation);
                }
                at[0] = (0.0, at[1].position, at[1].rotation);
                ParticleState state = scene.Read();
                Assert.That(state.Count, Is.EqualTo((int)(rate * time / scene.ParticleVolume + 1e-6)));
                float worst = 0f, fastest = 0f;
                for (int i = 0; i < state.Count; i++)
                {
                    double instant = (state.ids[i] + 1) * scene.ParticleVolume / rate;
                    int frame = Array.FindIndex(at, a => a.time >= instant - 1e-9);
                    float part = (float)((instant - at[frame - 1].time) / (at[frame].time - at[frame - 1].time)),
                        duration = (float)(at[frame].time - at[frame - 1].time);
                    Vector3 position = Vector3.Lerp(at[frame - 1].position, at[frame].position, part);
                    Quaternion rotation = Quaternion.Slerp(at[frame - 1].rotation, at[frame].rotation, part);
                    float3 axis = rotation * Vector3.forward, linear = (float3)(at[frame].position - at[frame - 1].position) / duration;
                    (at[frame].rotation * Quaternion.Inverse(at[frame - 1].rotation)).ToAngleAxis(out float angle, out Vector3 around);
                    float3 spin = angle > 180f ? -math.radians(360f - angle) / duration * (float3)around
                        : math.radians(angle) / duration * (float3)around;

                    // The point of the outlet at which it left follows from where it has got to: offset = arm + fraction age (spin x arm).
                    float age = (float)(time - instant);
                    float3 velocity = state.velocities[i].xyz * Spacing, point = state.positions[i].xyz * Spacing - (float3)Box;
                    float3 offset = point - (float3)position - axis * (0.5f * Spacing + speed * age) - fraction * linear * age;
                    float3 turned = fraction * age * spin;
                    float3 arm = (offset - math.cross(turned, offset) + turned * math.dot(turned, offset)) / (1f + math.lengthsq(turned));
                    float3 expected = axis * speed + fraction * (linear + math.cross(spin, arm));
                    Assert.That(math.abs(math.dot(arm, axis)), Is.LessThan(0.1f * Spacing),
                        $"particle {state.ids[i]} left in the plane of the outlet");
                    Assert.That(math.length(arm), Is.LessThan(0.4f + 0.1f * Spacing), $"particle {state.ids[i]} left within the outlet");
                    // A place is off by up to 0.02 d along each axis so that no pattern is perfect, and viscosity takes a little beside others.
                    worst = math.max(worst, math.distance(velocity, expected) / (fraction * math.length(spin) * 0.035f * Spacing + 0.01f));
                    fastest = math.max(fastest, math.length(velocity - axis * speed));
                }
                TestContext.Out.WriteLine(
                    $"{state.Count} particles, at most {fastest:0.00} m/s besides the jet's, off by {worst:0.00} of what may be");
                Assert.That(worst, Is.LessThan(1f));
                Assert.That(fastest, fraction > 0f ? Is.GreaterThan(2f * fraction) : Is.LessThan(0.05f));
            }
        }

        // Frames and steps differ: the path of a frame is walked in its time, however many steps it takes.
        [Test]
        public void What_a_moving_emitter_lets_in_goes_at_its_speed_at_any_frame_rate([Values(1f / 144f, 1f / 60f, 1f / 25f, 0.5f)] float frame)
        {
            const float cart = 1.5f, speed = 2f;
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                // too far apart to touch
                FluidEmitter emitter = scene.Add(new Vector3(-0.9f, -0.9f, 0f), Vector3.up, Jet(0.002f, speed, 0.01f));
                for (int i = 0; i * frame < 1.01f; i++)
                {
                    emitter.transform.position = new Vector3(-0.9f + cart * frame * i, -0.9f, 0f);
                    scene.Fluid.Advance(frame);
                }
                ParticleState state = scene.Read();
                float[] along = state.positions.Zip(state.velocities, (p, v) => (p, v)).Where(pair => pair.p.x > 3f)
                    .Select(pair => pair.v.x * Spacing).ToArray();
                TestContext.Out.WriteLine($"{along.Length} of {state.Count} particles, {along.Min():0.000} to {along.Max():0.000} m/s");
                Assert.That(along.Length, Is.GreaterThan(1));
                Assert.That(along, Is.All.EqualTo(cart).Within(0.01f),
                    "a step's displacement over a step's time is off by a quarter at 144 Hz, and after a hitch by seven times");
            }
        }

        [Test]
        public void A_teleport_is_no_motion_that_the_fluid_takes_along([Values] bool told)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                FluidEmitter emitter = scene.Add(new Vector3(-0.8f, -0.9f, 0f), Vector3.up, Jet(0.02f, 2f, 0.1f));
                scene.Step(4);
                emitter.transform.position = new Vector3(0.8f, -0.9f, 0f);
                if (told)
                    emitter.Teleport();
                scene.Step();
                float fastest = scene.Read().velocities.Max(v => math.abs(v.x)) * Spacing;
                TestContext.Out.WriteLine($"fastest aside {fastest:0.0} m/s");
                Assert.That(fastest, told ? Is.LessThan(0.3f) : Is.GreaterThan(50f));
                scene.AssertConserved();
            }
        }

        // In its own frame it is a jet like any: as dense as one from a nozzle at rest, where water that stays behind is pressed into or torn.
        [Test]
        public void A_jet_from_a_nozzle_that_moves_is_as_dense_as_from_one_at_rest([Values(-6f, 0f, 6f)] float cart)
        {
            using (var scene = new SourceScene(2f * Box, Spacing, 9000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                FluidEmitter emitter = scene.Add(new Vector3(-0.2f * cart, 0f, 0f), Vector3.right, Jet(0.03f, 3f, 0.2f));
                for (int i = 0; i < 20; i++)
                {
                    emitter.transform.position = new Vector3((i / 60f - 0.2f) * cart, 0f, 0f);
                    scene.Step();
                }
                FluidStatistics statistics = scene.AssertConserved();
                ParticleState state = scene.Read();
                TestContext.Out.WriteLine($"{statistics.particles} particles, neighbors {statistics.neighborsMean:0.0}, C+ " +
                    $"{statistics.densityError:0.000}, waiting {statistics.waiting}, mean " +
                    $"{state.velocities.Average(v => v.x) * Spacing:0.00} m/s");
                Assert.That(statistics.waiting + statistics.blocked, Is.Zero);
                Assert.That(statistics.neighborsMean, Is.EqualTo(12f).Within(1f));
                Assert.That(state.velocities.Average(v => v.x) * Spacing, Is.EqualTo(3f + cart).Within(0.3f));
            }
        }

        [Test]
        public void An_emitter_that_moves_with_the_box_does_not_move_in_it()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.Fluid.Inertial = false;
                scene.Add(new Vector3(0f, -0.9f, 0f), Vector3.up, Jet(0.01f, 2f, 0.1f));
                for (int i = 0; i < 10; i++)
                {
                    scene.Fluid.transform.SetPositionAndRotation(new Vector3(0.1f * i, 0f, 0f), Quaternion.Euler(0f, 6f * i, 0f));
                    scene.Step();
                }
                float3[] velocities = scene.Read().velocities.Select(v => v.xyz * Spacing).ToArray();
                Assert.That(velocities, Is.All.Matches<float3>(v => math.distance(v, new float3(0f, 2f, 0f)) < 0.15f));
            }
        }

        // Lets a frame pass; its fluid time.
        static double FrameOf(SourceScene scene, int steps)
        {
            double before = scene.Fluid.FluidTime;
            scene.Fluid.Advance(steps * scene.Fluid.FixedStep * 1.00001f);
            Assert.That(scene.Fluid.FluidTime - before, Is.EqualTo(steps * (double)scene.Fluid.FixedStep).Within(1e-6));
            return scene.Fluid.FluidTime - before;
        }

        [Test]
        public void An_emitter_that_is_teleported_lets_nothing_in_between()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                FluidEmitter emitter = scene.Add(new Vector3(-0.8f, -0.9f, 0f), Vector3.up, Jet(0.01f, 2f, 0.01f));
                scene.Step(4);
                emitter.transform.position = new Vector3(0.8f, -0.9f, 0f);
                emitter.Teleport();
                scene.Step(4);
                float[] x = scene.Read().positions.Select(p => p.x * Spacing - 1f).ToArray();
                Assert.That(x, Is.All.Matches<float>(at => math.abs(math.abs(at) - 0.8f) < Spacing));
                Assert.That(x.Count(at => at > 0f), Is.EqualTo(x.Length / 2).Within(1));
            }
        }

        [Test]
        public void Gravity_acts_on_a_particle_within_the_step_in_which_it_is_let_in()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Add(new Vector3(-0.9f, 0f, 0f), Vector3.right, Jet(0.01f, 3f));
                scene.Step();
                ParticleState state = scene.Read();
                for (int i = 0; i < state.Count; i++)
                {
                    float age = 1f / 60f - (state.ids[i] + 1) * scene.ParticleVolume / 0.01f;
                    Assert.That(state.velocities[i].y * Spacing, Is.EqualTo(-9.81f * age).Within(1e-4f));
                }
                Assert.That(state.Count, Is.EqualTo(1));
            }
        }

        [Test]
        public void A_jet_is_as_wide_as_its_rate_needs_and_dense([Values(0.002f, 0.01f, 0.03f)] float rate)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.Add(new Vector3(-0.95f, 0f, 0f), Vector3.right, Jet(rate, 2f, 0.2f));
                scene.Step(40);
                float2[] across = scene.Read().positions.Select(p => p.yz * Spacing - 1f).ToArray();
                float radius = math.sqrt(rate / 2f / math.PI);
                Assert.That(across.Max(p => math.length(p)), Is.InRange(radius - Spacing, radius + Spacing));
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.Out.WriteLine($"radius {radius:0.000} m, neighbors {statistics.neighborsMean:0.0}, C+ " +
                    $"{statistics.densityError:0.000}, p99.9 {statistics.densityError999:0.000}");
                Assert.That(statistics.densityErrorMax, Is.LessThan(0.2f));
                Assert.That(statistics.blocked + statistics.waiting, Is.Zero);
            }
        }

        [Test, Category("LongRun")]
        public void What_is_no_number_while_it_lets_water_in_is_named_and_loses_nothing([Values("rate NaN", "speed NaN",
            "transform is not finite")] string what, [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            const float rate = 0.006f;      // 0.8 particles a step
            using (var scene = new SourceScene(Box, Spacing, 500, deepWater))
            {
                FluidEmitter emitter = scene.Add(Vector3.zero, Vector3.down, Jet(rate));
                scene.Step(15);
                LogAssert.Expect(LogType.Warning, new Regex("Rill: FluidEmitter 'FluidEmitter': .*" + what));
                var far = new GameObject("Far");
                switch (what)
                {
                    case "rate NaN":
                        emitter.Rate = float.NaN;
                        break;
                    case "speed NaN":
                        emitter.Speed = float.NaN;
                        break;
                    default:
                        emitter.Simulation = scene.Fluid;       // and not the one above it
                        far.transform.position = new Vector3(2f, 0f, 0f);
                        emitter.transform.SetParent(far.transform);
                        far.transform.localScale = 3e38f * Vector3.one;
                        break;
                }
                scene.Step(15).AssertConserved();
                far.transform.localScale = Vector3.one;
                emitter.Rate = rate;
                FluidStatistics last = scene.Step(15).AssertConserved();
                int steps = what == "speed NaN" ? 45 : 30;      // 1 m/s instead of no number
                Assert.That(last.emitted, Is.EqualTo(steps * rate / 60f / scene.ParticleVolume).Within(1));
                Assert.That(last.nonFinite + last.refused + last.blocked + last.waiting, Is.Zero);
                Object.DestroyImmediate(emitter.gameObject);
                Object.DestroyImmediate(far);
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void Nothing_is_put_nearer_to_another_than_room_allows([Values(EmitterMode.Jet, EmitterMode.Spray, EmitterMode.Fill)] EmitterMode mode)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 8000).Fill(0.5f))
            {
                for (int e = 0; e < 3; e++)     // three that overlap, half under water
                    scene.Add<FluidEmitter>(new Vector3(0.013f * e, 0.05f, 0.02f * e), Vector3.up, emitter =>
                    {
                        emitter.Shape = EmitterShape.Sphere;
                        emitter.Mode = mode;
                        emitter.Radius = 0.2f;
                        emitter.Rate = 0.05f;
                        emitter.Speed = 1f;
                    });
                int nearest = 0;
                for (int step = 0; step < 6; step++)
                {
                    int before = scene.Count(ParticleCounter.Emitted);
                    scene.Step();
                    ParticleState state = scene.Read();
                    int fresh = scene.Count(ParticleCounter.Emitted) - before;
                    Assert.That(CountTooNear(state, fresh, mode == EmitterMode.Fill ? 0.7f : 0.3f), Is.Zero, $"in step {step}, {fresh} let in");
                    nearest += fresh;
                }
                Assert.That(nearest, Is.GreaterThan(20));
                scene.AssertConserved();
            }
        }

        // Counts the last ones of a state that are nearer to any other than is allowed.
        static int CountTooNear(ParticleState state, int fresh, float clearance) => Enumerable.Range(state.Count - fresh, fresh)
            .Count(i => Enumerable.Range(0, state.Count)
                .Any(j => j != i && math.distance(state.positions[i].xyz, state.positions[j].xyz) < clearance - 1e-3f));

        [Test]
        public void Two_particles_in_one_place_would_be_seen()
        {
            var state = new ParticleState(10f, new[] { new float3(1f), new float3(5f), new float3(5.2f) });
            Assert.That(CountTooNear(state, 1, 0.7f), Is.EqualTo(1));
        }

        [Test]
        public void A_volume_is_filled_once_and_what_has_no_room_waits_and_is_given_up()
        {
            using (var scene = new SourceScene(new Vector3(0.3f, 0.3f, 0.3f), Spacing, 1000))
            {
                scene.Add<FluidEmitter>(Vector3.zero, Vector3.forward, emitter =>
                {
                    emitter.Shape = EmitterShape.Box;
                    emitter.Mode = EmitterMode.Fill;
                    emitter.Size = Vector3.one * 0.3f;
                    emitter.Rate = 0.06f;      // 8 particles a step, the box in 27
                    emitter.Speed = 0f;
                });
                scene.Step(120);
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.Out.WriteLine($"{statistics.particles} of 216, waiting {statistics.waiting}, blocked {statistics.blocked}, " +
                    $"C+ {statistics.densityError}");
                Assert.That(statistics.particles, Is.InRange(200, 229), "up to the density that is allowed");
                Assert.That(statistics.densityError, Is.LessThan(0.07f));
                Assert.That(statistics.waiting, Is.EqualTo(480), "a second's worth");
                Assert.That(statistics.emitted + statistics.waiting + statistics.blocked, Is.EqualTo(960).Within(1));
            }
        }

        [Test]
        public void Nothing_is_let_into_a_collider()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                var ball = new GameObject("Ball");
                ball.transform.SetParent(scene.Fluid.transform, false);
                var collider = ball.AddComponent<FluidCollider>();
                collider.Shape = ColliderShape.Sphere;
                collider.Radius = 0.25f;
                scene.Add<FluidEmitter>(new Vector3(0.1f, 0f, 0f), Vector3.up, emitter =>
                {
                    emitter.Shape = EmitterShape.Box;
                    emitter.Mode = EmitterMode.Fill;
                    emitter.Size = Vector3.one * 0.6f;
                    emitter.Rate = 10f;
                    emitter.Speed = 0f;
                });
                scene.Step();
                ParticleState state = scene.Read();
                float[] distances = state.positions.Select(p => math.length(p.xyz * Spacing - 1f)).ToArray();
                Assert.That(distances.Min(), Is.GreaterThan(0.25f + 0.44f * Spacing));
                Assert.That(state.Count, Is.InRange(900, 1728 - 450), "1,728 less what the ball takes of it");
                scene.Step(20);
                Assert.That(scene.AssertConserved().waiting, Is.GreaterThan(0));
            }
        }

        static FluidCollider Obstacle(SourceScene scene, Vector3 position, Vector3 size, bool insideOut = false)
        {
            var gameObject = new GameObject("Collider");
            gameObject.transform.SetParent(scene.Fluid.transform, false);
            gameObject.transform.position = position;
            var collider = gameObject.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Box;
            collider.Size = size;
            collider.InsideOut = insideOut;
            return collider;
        }

        [Test]
        public void An_outlet_that_a_collider_covers_in_part_lets_in_what_the_rest_holds(
            [Values(EmitterMode.Jet, EmitterMode.Spray)] EmitterMode mode)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                Obstacle(scene, new Vector3(0.5f, 0f, 0f), new Vector3(1f, 1f, 1f));     // all with x above 0
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0f, -0.3f, 0f), Vector3.up, e =>
                {
                    e.Mode = mode;
                    e.Rate = 0.06f;
                    e.Speed = 1f;
                    e.Radius = 0.2f;
                });
                for (int i = 0; i < 25; i++)
                {
                    scene.Step();
                    Assert.That(scene.Read().positions.Max(p => p.x * Spacing - 1f), Is.LessThan(-0.4f * Spacing), $"step {i}");
                }
                FluidStatistics statistics = scene.AssertConserved();
                double due = emitter.DueVolume / scene.ParticleVolume;
                TestContext.Out.WriteLine($"{statistics.emitted} of {due} let in, {statistics.waiting} wait, {statistics.blocked} " +
                    $"given up, C+ max {statistics.densityErrorMax:0.00}");
                Assert.That(statistics.emitted + statistics.waiting + statistics.blocked, Is.EqualTo(due).Within(1));
                Assert.That(statistics.emitted, Is.GreaterThan(0.2 * due));
                Assert.That(statistics.waiting, Is.GreaterThan(0.2 * due), "half of the outlet is not enough for the rate");
                scene.ReadBack();
                Assert.That(emitter.Emitted, Is.EqualTo(statistics.emitted));
            }
        }

        // Less than a particle a step: the places that the flow alone would use are those that the collider covers.
        [Test, Category("LongRun")]
        public void A_low_rate_finds_what_a_collider_leaves_of_the_outlet([Values(EmitterMode.Jet, EmitterMode.Spray)] EmitterMode mode,
            [Values(1f, 20f)] float speed, [Values(0.0006f, 0.004f)] float rate)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                Obstacle(scene, new Vector3(0.44f, 0f, 0f), new Vector3(1f, 1f, 1f));     // all with x above -0.06
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0f, 0.3f, 0f), Vector3.down, e =>
                {
                    e.Mode = mode;
                    e.Rate = rate;
                    e.Speed = speed;
                    e.Radius = 0.2f;
                });
                Pass(scene, 120);
                FluidStatistics statistics = scene.AssertConserved();
                double due = emitter.DueVolume / scene.ParticleVolume;
                TestContext.Out.WriteLine($"{statistics.emitted} of {due} let in, {statistics.waiting} wait, {statistics.blocked} given up");
                Assert.That(statistics.emitted, Is.EqualTo(due).Within(2), "of the outlet's 50 places 15 are free");
                Assert.That(statistics.blocked, Is.Zero);
                LogAssert.NoUnexpectedReceived();
            }
        }

        static void Pass(SourceScene scene, int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                scene.Step();
                UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
            }
        }

        [Test, Category("LongRun")]
        public void What_lets_nothing_in_any_more_is_not_covered([Values("stopped", "over", "no rate", "no drain")] string cause)
        {
            using (SourceScene scene = cause == "no drain" ? new SourceScene(Box, Spacing, 9000).Fill(0.2f) : new SourceScene(Box, Spacing, 5000))
            {
                Obstacle(scene, Vector3.zero, 0.6f * Vector3.one);
                scene.Add(new Vector3(0.6f, 0f, 0f), Vector3.up, Jet(0.001f));      // goes on
                FluidEmitter emitter = scene.Add<FluidEmitter>(Vector3.zero, Vector3.down, e =>
                {
                    Jet(0.01f)(e);
                    e.Duration = cause == "over" ? 1.2f : 0f;
                    e.PlayOnEnable = cause != "no drain";
                });
                FluidDrain drain = cause != "no drain" ? null : scene.Add<FluidDrain>(new Vector3(0f, -0.9f, 0f), Vector3.up, d =>
                {
                    d.RateLimit = 0.01f;
                    d.RecycleTo = emitter;
                });
                LogAssert.Expect(LogType.Warning, new Regex("a collider covers all of its outlet"));
                Pass(scene, 90);
                Assert.That(ProblemsOf(emitter), Has.Some.Contains("a collider covers"));
                if (cause == "stopped")
                    emitter.StopEmission();
                else if (cause == "no rate")
                    emitter.Rate = 0f;
                else if (cause == "no drain")
                    Object.DestroyImmediate(drain.gameObject);
                Pass(scene, 72);        // with the second that what waits at the end of the duration has
                Assert.That(ProblemsOf(emitter), Is.Empty);
                Assert.That(scene.AssertConserved().waiting, Is.Zero);
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void An_emitter_that_is_over_keeps_its_numbers()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                FluidEmitter emitter = scene.Add(new Vector3(0f, 0.9f, 0f), Vector3.down, Jet(0.02f));
                Pass(scene, 30);
                emitter.StopEmission();
                Pass(scene, 30);
                Assert.That(emitter.Emitted, Is.EqualTo(scene.Count(ParticleCounter.Emitted)));
                emitter.StartEmission();
                Pass(scene, 30);
                Assert.That(emitter.Emitted, Is.EqualTo(scene.Count(ParticleCounter.Emitted)).Within(40), "ten steps old");
            }
        }

        static List<string> ProblemsOf(FluidPart part)
        {
            var problems = new List<string>();
            ((IHasProblems)part).ListProblems(problems);
            return problems;
        }

        [Test]
        public void Nothing_is_let_in_beyond_a_thin_plate_before_the_outlet([Values(2f, 20f)] float speed)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                Obstacle(scene, new Vector3(-0.7f, 0f, 0f), new Vector3(0.02f, 2f, 2f));
                scene.Add(new Vector3(-0.9f, 0f, 0f), Vector3.right, Jet(0.05f, speed));
                scene.Step(30);
                ParticleState state = scene.Read();
                Assert.That(state.Count, Is.GreaterThan(20), "up to the plate there is room");
                Assert.That(state.positions.Max(p => p.x * Spacing - 1f), Is.LessThan(-0.71f - 0.4f * Spacing));
                scene.AssertConserved();
            }
        }

        [Test, Category("LongRun")]
        public void An_outlet_that_a_collider_covers_is_said_once_and_goes_on_when_it_is_free()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                FluidCollider obstacle = Obstacle(scene, Vector3.zero, 0.6f * Vector3.one);
                FluidEmitter emitter = scene.Add(Vector3.zero, Vector3.down, Jet(0.01f, 22f));       // would be out of it within a step
                string message = "Rill: FluidEmitter 'FluidEmitter': a collider covers all of its outlet";
                Pass(scene, 50);
                LogAssert.NoUnexpectedReceived();       // less than a second: it may only pass by
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.Zero);
                LogAssert.Expect(LogType.Warning, new Regex(message));
                Pass(scene, 100);
                FluidStatistics shut = scene.AssertConserved();
                Assert.That(shut.waiting + shut.blocked, Is.EqualTo(emitter.DueVolume / scene.ParticleVolume).Within(1));
                Assert.That(shut.blocked, Is.GreaterThan(50));
                obstacle.transform.position = new Vector3(0.9f, 0.9f, 0.9f);
                obstacle.Teleport();
                Pass(scene, 30);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.GreaterThan(50));
                obstacle.transform.position = Vector3.zero;
                obstacle.Teleport();
                LogAssert.Expect(LogType.Warning, new Regex(message));
                Pass(scene, 90);
                scene.AssertConserved();
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void An_outlet_flush_with_a_wall_keeps_its_rate([Values(-0.01f, 0f, 0.02f)] float before)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                Obstacle(scene, new Vector3(-0.8f, 0f, 0f), new Vector3(0.4f, 2f, 2f));      // up to -0.6
                FluidEmitter emitter = scene.Add(new Vector3(-0.6f + before, 0f, 0f), Vector3.right, Jet(0.01f, 3f));
                scene.Step(40);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.emitted, Is.EqualTo(emitter.DueVolume / scene.ParticleVolume).Within(2));
                Assert.That(statistics.blocked, Is.Zero);
            }
        }

        // Fills like a domain of that size: see A_volume_is_filled_once.
        [Test]
        public void A_volume_between_colliders_is_filled_to_rest_density_and_no_more()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                Obstacle(scene, Vector3.zero, 0.3f * Vector3.one, true);
                scene.Add<FluidEmitter>(Vector3.zero, Vector3.forward, emitter =>
                {
                    emitter.Shape = EmitterShape.Box;
                    emitter.Mode = EmitterMode.Fill;
                    emitter.Size = Vector3.one * 0.3f;
                    emitter.Rate = 0.06f;
                    emitter.Speed = 0f;
                });
                scene.Step(120);
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.Out.WriteLine($"{statistics.particles} of 216, waiting {statistics.waiting}, blocked {statistics.blocked}, " +
                    $"C+ {statistics.densityError}");
                Assert.That(statistics.particles, Is.InRange(200, 229), "up to the density that is allowed");
                Assert.That(statistics.densityError, Is.LessThan(0.005f), "216 are at rest density, and 224 went in where colliders did not count");
            }
        }

        // In each step all positions beside the water look free at once; if all were taken, they would be too dense together.
        [Test]
        public void Water_that_is_filled_up_fast_stays_at_rest_density()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000).Fill(0.3f))
            {
                scene.Step(30);
                scene.Add<FluidEmitter>(new Vector3(0.017f, -0.19f, 0.011f), Vector3.forward, emitter =>
                {
                    emitter.Shape = EmitterShape.Box;
                    emitter.Mode = EmitterMode.Fill;
                    emitter.Size = new Vector3(0.9f, 0.6f, 0.9f);
                    emitter.Rate = 10f;
                    emitter.Speed = 0f;
                });
                for (int i = 0; i < 8; i++)
                {
                    scene.Step();
                    FluidStatistics statistics = scene.AssertConserved();
                    TestContext.Out.WriteLine($"{statistics.emitted} let in, C+ {statistics.densityError:0.000}, p99.9 " +
                        $"{statistics.densityError999:0.000}, max {statistics.densityErrorMax:0.000}");
                    Assert.That(statistics.densityErrorMax, Is.LessThan(0.3f));
                }
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.GreaterThan(1500));
            }
        }

        [Test]
        public void What_waited_is_let_in_as_soon_as_there_is_room()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000).Fill(1f))
            {
                FluidEmitter emitter = scene.Add(new Vector3(0f, 0.3f, 0f), Vector3.down, Jet(0.01f, 2f, 0.15f));
                scene.Step(20);
                int waiting = scene.Count(ParticleCounter.Waiting);
                Assert.That(waiting, Is.GreaterThan(15), "no room under water");
                scene.Add<FluidDrain>(Vector3.zero, Vector3.forward, drain => drain.Size = Box * 1.1f).gameObject.AddComponent<OneStep>();
                scene.Step();
                Object.DestroyImmediate(scene.Fluid.GetComponentInChildren<OneStep>().gameObject);
                scene.Step(39);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.waiting, Is.Zero);
                Assert.That(statistics.emitted, Is.EqualTo((int)math.round(emitter.DueVolume / scene.ParticleVolume)));
                Assert.That(statistics.blocked, Is.Zero);
            }
        }

        sealed class OneStep : MonoBehaviour { }

        [Test]
        public void At_capacity_what_does_not_fit_is_refused_counted_and_said_once([Values(0, 37)] int room)
        {
            using (var scene = new SourceScene(Box, Spacing, 40 * 40 * 2 + room).Fill(0.1f))
            {
                scene.Add(new Vector3(0f, 0.9f, 0f), Vector3.down, Jet(0.02f));
                LogAssert.Expect(LogType.Warning,
                    new Regex(
                    "FluidEmitter 'FluidEmitter'.*capacity of FluidSimulation 'Fluid': .* particles are all in use.*Raise the capacity"));
                for (int i = 0; i < 40; i++)
                {
                    scene.Step();
                    UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
                }
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.emitted, Is.EqualTo(room));
                Assert.That(statistics.emitted + statistics.refused, Is.EqualTo((int)(0.02 * 40 / 60 / scene.ParticleVolume + 1e-3)));
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void Two_runs_end_in_the_same_bits()
        {
            ParticleState[] runs = Enumerable.Range(0, 2).Select(_ =>
            {
                using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 500).Fill(0.05f))
                {
                    scene.Add(new Vector3(0f, 0.45f, 0f), Vector3.down, Jet(0.02f));
                    scene.Add<FluidEmitter>(new Vector3(0.02f, 0.4f, 0f), Vector3.right, emitter =>
                    {
                        emitter.Mode = EmitterMode.Spray;
                        emitter.Spread = 30f;
                    });
                    scene.Add<FluidDrain>(new Vector3(0f, -0.45f, 0f), Vector3.up, drain => drain.RateLimit = 0.01f);
                    return scene.Step(60).Read();
                }
            }).ToArray();
            Assert.That(runs[0].Count, Is.GreaterThan(350));
            TestFluid.AssertSame(runs[0], runs[1]);
        }

        [Test]
        public void A_restart_repeats_what_was_let_in()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 2000))
            {
                scene.Add(new Vector3(0f, 0.45f, 0f), Vector3.down, Jet(0.013f));
                ParticleState first = scene.Step(25).Read();
                scene.Fluid.Restart();
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.Zero);
                TestFluid.AssertSame(scene.Step(25).Read(), first);
                scene.AssertConserved();
            }
        }

        [Test]
        public void It_lets_in_the_rate_times_the_duration_after_the_delay_and_again_when_started_again()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0f, 0.9f, 0f), Vector3.down, e =>
                {
                    Jet(0.013f)(e);
                    e.PlayOnEnable = false;
                    e.Delay = 0.105f;
                    e.Duration = 0.33f;
                });
                scene.Step(20);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.Zero);
                Assert.That(emitter.IsEmitting, Is.False);
                int expected = (int)(0.013 * 0.33 / scene.ParticleVolume);
                for (int time = 1; time <= 2; time++)
                {
                    emitter.StartEmission();
                    scene.Step(6);
                    Assert.That(emitter.IsEmitting, Is.False);
                    scene.Step(1);
                    Assert.That(emitter.IsEmitting, Is.True);
                    scene.Step(33);
                    Assert.That(emitter.IsEmitting, Is.False);
                    Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(time * expected));
                }
            }
        }

        [Test]
        public void Stopped_it_lets_nothing_in_and_gives_up_what_waits()
        {
            using (var scene = new SourceScene(new Vector3(1f, 0.5f, 1f), Spacing, 5000).Fill(0.5f))
            {
                FluidEmitter emitter = scene.Add(Vector3.zero, Vector3.down, Jet(0.02f));
                scene.Step(30);
                int due = (int)math.round(emitter.DueVolume / scene.ParticleVolume);
                Assert.That(scene.Count(ParticleCounter.Waiting), Is.GreaterThan(0));
                emitter.StopEmission();
                scene.Step(10);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.waiting, Is.Zero);
                Assert.That(statistics.emitted + statistics.blocked, Is.EqualTo(due));
            }
        }

        [Test]
        public void Its_surface_emits_everywhere_along_the_normals()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                GameObject sphere = GameObject.CreatePrimitive(PrimitiveType.Sphere);
                Mesh mesh = sphere.GetComponent<MeshFilter>().sharedMesh;
                Object.DestroyImmediate(sphere);
                scene.Add<FluidEmitter>(new Vector3(0.1f, 0f, 0f), Vector3.forward, emitter =>
                {
                    emitter.Shape = EmitterShape.MeshSurface;
                    emitter.Mesh = mesh;            // of radius 0.5 m
                    emitter.Rate = 0.1f;
                    emitter.Speed = 1f;
                });
                scene.Step(10);
                ParticleState state = scene.Read();
                float3[] positions = state.positions.Select(p => p.xyz * Spacing - 1f - new float3(0.1f, 0f, 0f)).ToArray();
                Assert.That(state.Count, Is.EqualTo((int)(0.1 / 6 / scene.ParticleVolume)));
                for (int i = 0; i < positions.Length; i++)
                    Assert.That(math.dot(math.normalize(positions[i]), math.normalize(state.velocities[i].xyz)), Is.GreaterThan(0.9f));
                Assert.That(positions.Select(p => math.length(p)).Min(), Is.GreaterThan(0.47f));
                for (int axis = 0; axis < 3; axis++)
                    Assert.That(math.abs(positions.Average(p => p[axis])), Is.LessThan(0.1f), "evenly over the sphere");
            }
        }

        [Test]
        public void Spread_stays_within_its_angle_and_reaches_it()
        {
            using (var scene = new SourceScene(Box, Spacing, 5000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.Add<FluidEmitter>(new Vector3(-0.9f, 0f, 0f), Vector3.right, emitter =>
                {
                    Jet(0.03f, 3f, 0.3f)(emitter);
                    emitter.Spread = 25f;
                });
                var angles = new List<float>();
                scene.Step(4);
                ParticleState state = scene.Read();
                int fresh = scene.Count(ParticleCounter.Alive) - scene.Count(ParticleCounter.Sorted);
                foreach (float4 velocity in state.velocities.Skip(state.Count - fresh))
                    angles.Add(math.degrees(math.acos(math.normalize(velocity.xyz).x)));
                Assert.That(angles.Max(), Is.InRange(12f, 25.1f));
                Assert.That(angles.Count, Is.GreaterThanOrEqualTo(3));
            }
        }
    }
}
