using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Emitters, drains and force fields as components: come and go, wrong input, several fluids, all at once.</summary>
    public class FluidPartTests
    {
        const float Spacing = 0.05f;
        static readonly Vector3 Box = new Vector3(1f, 1f, 1f);

        // From one side of the box to the other, both outside of it.
        [Test, Category("LongRun")]
        public void What_moves_while_time_stands_still_does_not_move_through_the_fluid([Values("drain", "emitter", "obstacle")] string what,
            [Values("paused", "restarted", "box lost", "disabled")] string still)
        {
            using (var scene = new SourceScene(Box, Spacing, 5000).Fill(0.3f))
            {
                var mover = new GameObject("Mover");
                mover.SetActive(false);
                float side = what == "obstacle" ? 0.58f : 0.7f;     // one that is far off is not followed
                Vector3 path = new Vector3(2f * side, 0f, 0f);
                mover.transform.SetPositionAndRotation(new Vector3(-side, what == "emitter" ? 0f : -0.4f, 0f),
                    Quaternion.LookRotation(Vector3.up, Vector3.forward));
                if (what == "obstacle")
                    mover.AddComponent<FluidCollider>().Size = 0.1f * Vector3.one;
                else if (what == "drain")
                    mover.AddComponent<FluidDrain>().Size = 0.1f * Vector3.one;
                else
                    mover.AddComponent<FluidEmitter>().Rate = 0.05f;
                if (what != "obstacle")
                    mover.GetComponent<FluidPart>().Simulation = scene.Fluid;
                var holder = new GameObject("Holder");
                holder.transform.position = new Vector3(2f, 0f, 0f);
                scene.Fluid.transform.SetParent(holder.transform, true);
                mover.SetActive(true);
                scene.Step(20);

                if (still == "box lost")
                {
                    LogAssert.Expect(LogType.Error, new Regex("FluidSimulation 'Fluid': its transform is not finite"));
                    holder.transform.localScale = 3e38f * Vector3.one;
                    scene.Step();
                    holder.transform.localScale = Vector3.one;
                    holder.transform.position -= path;
                }
                else if (still == "disabled")
                {
                    mover.SetActive(false);     // and enabled again before the next step, as of a pool
                    mover.transform.position += path;
                    mover.SetActive(true);
                }
                else
                {
                    scene.Fluid.Paused = still == "paused";
                    scene.Step();
                    mover.transform.position += path;
                    scene.Step(still == "paused" ? 1 : 0);
                    scene.Fluid.Paused = false;
                    if (still == "restarted")
                        scene.Fluid.Restart();
                }
                scene.Step(2);
                FluidStatistics statistics = scene.AssertConserved();
                float fastest = scene.Read().velocities.Max(v => math.length(v.xyz)) * Spacing;
                Assert.That(statistics.drained + statistics.emitted, Is.Zero);
                TestContext.Out.WriteLine($"fastest {fastest:0.00} m/s");
                Assert.That(fastest, Is.LessThan(4f), "it stands, or falls for two steps; a collider that came through throws it");
                Object.DestroyImmediate(mover);
                scene.Fluid.transform.SetParent(null, true);
                Object.DestroyImmediate(holder);
            }
        }

        [Test]
        public void Every_particle_is_accounted_for_over_many_steps_whatever_comes_and_goes()
        {
            var said = new List<string>();
            Application.LogCallback hear = (text, trace, type) => said.Add(text);
            Application.logMessageReceived += hear;
            using (var scene = new SourceScene(Box, Spacing, 900).Fill(0.1f))
            {
                var random = new Unity.Mathematics.Random(11);
                FluidEmitter fountain = scene.Add<FluidEmitter>(new Vector3(-0.3f, -0.2f, 0f), Vector3.up, e => (e.name, e.Rate) = ("Fountain", 0f));
                scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => (e.name, e.Rate) = ("Tap", 0.03f));
                scene.Add<FluidDrain>(new Vector3(0.3f, -0.45f, 0f), Vector3.up, d => d.RateLimit = 0.02f);
                int full = 0;
                for (int round = 0; round < 25; round++)
                {
                    FluidPart part = null;
                    switch (round % 5)
                    {
                        case 0:
                            part = scene.Add<FluidEmitter>(random.NextFloat3(-0.4f, 0.4f), random.NextFloat3Direction(), e =>
                            {
                                e.name = $"Emitter {round}";
                                e.Rate = 0.05f;
                                e.Mode = (EmitterMode)(round / 5 % 3);
                                e.Lifetime = 0.2f;
                                e.Phase = round / 5;
                            });
                            break;
                        case 1:
                            part = scene.Add<FluidDrain>(random.NextFloat3(-0.4f, 0.4f), random.NextFloat3Direction(), d =>
                            {
                                d.Size = Vector3.one * 0.2f;
                                d.RecycleTo = fountain;
                            });
                            break;
                        case 2:
                            part = scene.Add<FluidForceField>(random.NextFloat3(-0.4f, 0.4f), random.NextFloat3Direction(), f => f.Strength = 30f);
                            break;
                        case 3:
                            using (var positions = new Unity.Collections.NativeArray<float3>(new[] { new float3(float.NaN),
                                new float3(0f, 0.2f, 0f) }, Unity.Collections.Allocator.Persistent))
                            using (var velocities = new Unity.Collections.NativeArray<float3>(2, Unity.Collections.Allocator.Persistent))
                                scene.Fluid.AddParticles(positions, velocities);
                            break;
                    }
                    scene.Step(6);
                    FluidStatistics s = scene.AssertConserved();
                    full += s.particles >= 900 ? 1 : 0;
                    if (part != null && round % 2 == 0)
                        Object.DestroyImmediate(part.gameObject);
                }
                FluidStatistics last = scene.Step().AssertConserved();
                TestContext.Out.WriteLine($"emitted {last.emitted}, drained {last.drained}, not finite {last.nonFinite}, refused " +
                    $"{last.refused}, alive {last.particles}, recycling {last.recycling}, full {full} times");
                Assert.That(last.emitted, Is.GreaterThan(300));
                Assert.That(last.drained, Is.GreaterThan(200));
                Assert.That(last.nonFinite, Is.InRange(1, 5));
                Assert.That(last.refused, Is.GreaterThan(0));
                AsyncGPUReadback.WaitAllRequests();
                scene.Step(20);
                Application.logMessageReceived -= hear;
                Assert.That(said, Has.Some.Contains("capacity of FluidSimulation"));
                Assert.That(said, Is.Unique, "once of each emitter, however often the fluid was full");
                scene.Fluid.Restart();
                FluidStatistics again = scene.Step().AssertConserved();
                Assert.That(again.added, Is.EqualTo(800));
                Assert.That(again.drained + again.emitted, Is.LessThan(60));
            }
        }

        [Test]
        public void A_lost_particle_would_be_seen()
        {
            using (var scene = new SourceScene(Box, Spacing, 900).Fill(0.1f))
            {
                scene.Step();
                uint[] counters = GpuTest.Read<uint>(scene.Fluid.Solver.Counters, ParticleBuffers.CounterCount);
                counters[(int)ParticleCounter.Alive]--;
                scene.Fluid.Solver.Counters.SetData(counters);
                Assert.Throws<AssertionException>(() => scene.AssertConserved());
            }
        }

        [TestCase(float.NaN, "rate NaN is outside 0 to 1000000; using 0.")]
        [TestCase(-1f, "rate -1 is outside 0 to 1000000; using 0.")]
        [TestCase(float.PositiveInfinity, "is outside 0 to 1000000; using 0.")]
        public void A_rate_that_is_none_lets_nothing_in_and_says_so(float rate, string message)
        {
            using (var scene = new SourceScene(Box, Spacing, 500))
            {
                LogAssert.Expect(LogType.Warning, new Regex("Rill: FluidEmitter 'FluidEmitter': .*" + Regex.Escape(message)));
                FluidEmitter emitter = scene.Add<FluidEmitter>(Vector3.zero, Vector3.up, e => e.Rate = rate);
                scene.Step(5);
                Assert.That(emitter.Rate, Is.Zero);
                Assert.That(scene.AssertConserved().particles, Is.Zero);
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Values_out_of_range_are_clamped_with_a_message()
        {
            using (var scene = new SourceScene(Box, Spacing, 500))
            {
                FluidEmitter emitter = scene.Add<FluidEmitter>(Vector3.zero, Vector3.up);
                FluidDrain drain = scene.Add<FluidDrain>(Vector3.zero, Vector3.up);
                FluidForceField field = scene.Add<FluidForceField>(Vector3.zero, Vector3.up);
                Expect("speed NaN", () => emitter.Speed = float.NaN);
                Expect("spread 200", () => emitter.Spread = 200f);
                Expect("inherit velocity 1.5", () => emitter.InheritVelocity = 1.5f);
                Expect("inherit velocity NaN", () => emitter.InheritVelocity = float.NaN);
                Expect("delay -1", () => emitter.Delay = -1f);
                Expect("duration NaN", () => emitter.Duration = float.NaN);
                Expect("phase 9", () => emitter.Phase = 9);
                Expect("lifetime -2", () => emitter.Lifetime = -2f);
                Expect("size", () => emitter.Size = Vector3.one * float.NaN);
                Expect("radius", () => emitter.Radius = float.NaN);
                Expect("rate limit NaN", () => drain.RateLimit = float.NaN);
                Expect("size", () => drain.Size = Vector3.one * float.PositiveInfinity);
                Expect("strength NaN", () => field.Strength = float.NaN);
                Expect("strength 2000", () => field.Strength = 2000f);
                Expect("drag -1", () => field.Drag = -1f);
                Assert.That(field.Strength, Is.EqualTo(1000f));
                Assert.That(emitter.InheritVelocity, Is.EqualTo(1f));
                LogAssert.NoUnexpectedReceived();
            }

            void Expect(string text, Action set)
            {
                LogAssert.Expect(LogType.Warning, new Regex("^Rill: Fluid(Emitter|Drain|ForceField) '.*" + Regex.Escape(text)));
                set();
            }
        }

        [Test]
        public void A_transform_that_is_no_place_is_said_once_and_nothing_is_lost_until_it_is_one()
        {
            using (var scene = new SourceScene(Box, Spacing, 2000).Fill(0.1f))
            {
                var parts = new FluidPart[]
                {
                    scene.Add<FluidDrain>(new Vector3(0f, 0f, 0f), Vector3.up),
                    scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => e.Rate = 0.02f),
                    scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f => f.Bounds = ForceFieldBounds.Sphere),
                };
                scene.Step(3);
                int emitted = scene.Count(ParticleCounter.Emitted);
                var stretched = new GameObject("Stretched");
                stretched.transform.SetParent(scene.Fluid.transform, false);
                stretched.transform.localPosition = new Vector3(0f, -2f, 0f);
                foreach (FluidPart part in parts)
                {
                    LogAssert.Expect(LogType.Warning, new Regex($"{part.GetType().Name} '.*its transform is not finite"));
                    part.transform.SetParent(stretched.transform, true);
                }
                stretched.transform.localScale = Vector3.one * 3e38f;
                scene.Step(5);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(emitted));
                stretched.transform.localScale = Vector3.one;
                scene.Step(3);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.GreaterThan(emitted));
                LogAssert.NoUnexpectedReceived();
                scene.AssertConserved();
            }
        }

        [Test]
        public void A_shape_without_a_size_or_a_mesh_is_said_once_and_mended()
        {
            using (var scene = new SourceScene(Box, Spacing, 2000).Fill(0.1f))
            {
                LogAssert.Expect(LogType.Warning, new Regex("FluidEmitter .*its Disc has the radius 0 m.*lets nothing in"));
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => e.Radius = 0f);
                scene.Step(4);
                LogAssert.Expect(LogType.Warning, new Regex("FluidEmitter .*its box of 0 x 0.2 x 0.2 m has no size"));
                emitter.Size = new Vector3(0f, 0.2f, 0.2f);
                emitter.Shape = EmitterShape.Box;
                scene.Step(4);
                LogAssert.Expect(LogType.Warning, new Regex("FluidEmitter .*it has no mesh"));
                emitter.Shape = EmitterShape.MeshSurface;
                scene.Step(4);
                LogAssert.Expect(LogType.Warning, new Regex("FluidEmitter .*its mesh 'Empty' has no triangles"));
                emitter.Mesh = new Mesh { name = "Empty" };
                scene.Step(4);
                LogAssert.Expect(LogType.Warning, new Regex("FluidEmitter .*more than 1,048,576 particles at once"));
                emitter.Shape = EmitterShape.Sphere;
                emitter.Mode = EmitterMode.Fill;
                emitter.Radius = 100f;
                scene.Step(4);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.Zero);
                emitter.Radius = 0.1f;
                scene.Step(4);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.GreaterThan(0));

                LogAssert.Expect(LogType.Warning, new Regex("FluidDrain .*box of 1 x 0 x 1 m has no size"));
                scene.Add<FluidDrain>(Vector3.zero, Vector3.up, d => d.Size = new Vector3(1f, 0f, 1f));
                LogAssert.Expect(LogType.Warning, new Regex("FluidForceField .*sphere of radius 0 m has no size"));
                scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f =>
                {
                    f.Bounds = ForceFieldBounds.Sphere;
                    f.Radius = 0f;
                });
                scene.Step(4);
                Assert.That(scene.Count(ParticleCounter.Drained), Is.Zero);
                LogAssert.NoUnexpectedReceived();
                scene.AssertConserved();
            }
        }

        [Test]
        public void A_rate_that_no_shape_of_this_size_lets_through_is_said_once_with_the_most()
        {
            using (var scene = new SourceScene(Box, Spacing, 2000))
            {
                LogAssert.Expect(LogType.Warning,
                    new Regex("rate of 0.1 m³/s is more than leaves its shape at rest density: at most 0.0[36]\\d* m³/s do at 1 m/s"));
                scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e =>
                {
                    e.Rate = 0.1f;
                    e.Speed = 1f;
                });
                scene.Step(30);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.waiting, Is.GreaterThan(100));
                Assert.That(statistics.densityErrorMax, Is.LessThan(1f));
                LogAssert.NoUnexpectedReceived();
            }
        }

        // 2 spacings in a step of 1/60 s.
        [TestCase(300f, 60f, "2 particle spacings in a substep.*Step Rate of FluidSimulation 'Fluid' to 120 or more, take more Substeps")]
        [TestCase(300f, 120f, null)]
        [TestCase(100f, 60f, null)]
        public void A_jet_of_thick_fluid_that_tears_into_rings_is_told_once(float viscosity, float stepRate, string message)
        {
            using (var scene = new SourceScene(Box, Spacing, 2000))
            {
                if (message != null)
                    LogAssert.Expect(LogType.Warning, new Regex(message));
                scene.Fluid.Material = FluidMaterial.Viscous(1000f, viscosity);     // 150 Pa s is a spacing² in such a step
                scene.Fluid.StepRate = stepRate;
                scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e =>
                {
                    e.Rate = 0.01f;
                    e.Speed = 2f * Spacing * 60f;
                });
                scene.Step(6);
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void An_emitter_outside_the_box_lets_nothing_in_and_counts_it()
        {
            using (var scene = new SourceScene(Box, Spacing, 500))
            {
                scene.Add<FluidEmitter>(new Vector3(3f, 0f, 0f), Vector3.up, e => e.Rate = 0.02f);
                scene.Step(90);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.emitted, Is.Zero);
                Assert.That(statistics.blocked + statistics.waiting, Is.EqualTo(240).Within(1));
            }
        }

        [UnityTest]
        public IEnumerator What_is_put_below_a_fluid_in_the_frame_in_which_it_is_made_says_nothing()
        {
            using (var scene = new SourceScene(Box, Spacing, 500))
            {
                var prefab = new GameObject("Prefab");
                prefab.SetActive(false);
                prefab.AddComponent<FluidEmitter>();
                GameObject copy = Object.Instantiate(prefab);
                copy.SetActive(true);
                Assert.That(copy.GetComponent<FluidEmitter>().Simulation, Is.Null);
                copy.transform.SetParent(scene.Fluid.transform);
                for (int frame = 0; frame < 3; frame++)
                    yield return null;
                LogAssert.NoUnexpectedReceived();
                Assert.That(copy.GetComponent<FluidEmitter>().Simulation, Is.SameAs(scene.Fluid));
                Object.DestroyImmediate(copy);
                Object.DestroyImmediate(prefab);
            }
        }

        [UnityTest]
        public IEnumerator Without_a_fluid_it_says_so_and_with_one_it_works()
        {
            using (var scene = new SourceScene(Box, Spacing, 500))
            {
                var alone = new GameObject("Alone");
                FluidEmitter emitter = alone.AddComponent<FluidEmitter>();
                LogAssert.NoUnexpectedReceived();
                LogAssert.Expect(LogType.Warning, new Regex("FluidEmitter 'Alone': there is no FluidSimulation"));
                yield return null;
                yield return null;
                Assert.That(emitter.Simulation, Is.Null);
                Assert.That(emitter.DueVolume, Is.Zero);
                emitter.Simulation = scene.Fluid;
                scene.Step(10);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.GreaterThan(5));
                emitter.Simulation = null;
                Assert.That(emitter.Simulation, Is.Null);
                alone.transform.SetParent(scene.Fluid.transform);
                Assert.That(emitter.Simulation, Is.SameAs(scene.Fluid));
                Object.DestroyImmediate(alone);
                int emitted = scene.Count(ParticleCounter.Emitted);
                scene.Step(10);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(emitted));
                scene.AssertConserved();
            }
        }

        [Test]
        public void A_part_that_takes_the_number_of_another_begins_at_nothing()
        {
            using (var scene = new SourceScene(Box, Spacing, 2000).Fill(0.2f))
            {
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0f, -0.4f, 0f), Vector3.down, e =>
                {
                    e.Mode = EmitterMode.Fill;      // under water, where it waits for room
                    e.Rate = 0.02f;
                });
                FluidDrain drain = scene.Add<FluidDrain>(new Vector3(0.4f, -0.45f, 0f), Vector3.up);
                scene.Step(10);
                scene.ReadBack();
                int drained = drain.Drained;
                Assert.That(drained, Is.GreaterThan(0));
                Assert.That(emitter.Waiting, Is.GreaterThan(0));
                Object.DestroyImmediate(emitter.gameObject);
                Object.DestroyImmediate(drain.gameObject);
                emitter = scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => e.Rate = 0f);
                drain = scene.Add<FluidDrain>(new Vector3(0f, 5f, 0f), Vector3.up);
                Assert.That(emitter.Number + drain.Number, Is.Zero);
                scene.Step(2);
                Assert.That(emitter.Waiting + emitter.Emitted + drain.Drained, Is.Zero);
                scene.ReadBack();
                Assert.That(emitter.Waiting + emitter.Emitted + drain.Drained, Is.Zero);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.waiting, Is.Zero);
                Assert.That(statistics.blocked, Is.GreaterThan(0), "what waited for the first was given up");
                Assert.That(statistics.drained, Is.EqualTo(drained));
            }
        }

        [Test]
        public void The_thirty_third_of_a_kind_is_left_out_by_name_and_takes_a_place_that_gets_free()
        {
            using (var scene = new SourceScene(Box, Spacing, 500))
            {
                FluidForceField first = null;
                for (int i = 0; i < 32; i++)
                {
                    FluidForceField field = scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f => f.Bounds = ForceFieldBounds.Sphere);
                    first = first ?? field;
                }
                LogAssert.Expect(LogType.Warning,
                    new Regex(
                    "FluidForceField 'FluidForceField': FluidSimulation 'Fluid' has 32 of its kind, the most it takes, and leaves this one out"));
                FluidForceField late = scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f => f.Bounds = ForceFieldBounds.Sphere);
                scene.Step();
                Assert.That(scene.Fluid.Input.sources.fieldCount, Is.EqualTo(32));
                late.enabled = false;
                late.enabled = true;
                scene.Step();
                Assert.That(late.Number, Is.EqualTo(-1));
                LogAssert.NoUnexpectedReceived();
                first.enabled = false;
                late.enabled = false;
                late.enabled = true;
                Assert.That(late.Number, Is.Zero);
                scene.Step();
                Assert.That(scene.Fluid.Input.sources.fieldCount, Is.EqualTo(32));
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_drain_whose_emitter_is_of_another_fluid_says_so_and_takes_out_for_good()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 900).Fill(0.1f), other = new SourceScene(Box, Spacing, 900))
            {
                FluidEmitter elsewhere = other.Add<FluidEmitter>(Vector3.zero, Vector3.up);
                LogAssert.Expect(LogType.Warning, new Regex("FluidDrain .*its emitter 'FluidEmitter' is disabled or belongs to another fluid"));
                scene.Add<FluidDrain>(new Vector3(0f, -0.5f, 0f), Vector3.up, d => d.RecycleTo = elsewhere);
                scene.Step(5);
                FluidStatistics statistics = scene.AssertConserved();
                Assert.That(statistics.drained, Is.GreaterThan(50));
                Assert.That(statistics.recycling, Is.Zero);
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void Two_fluids_with_parts_of_their_own_do_not_disturb_each_other()
        {
            ParticleState alone, beside, otherAlone, otherTogether;
            using (SourceScene scene = First())
                alone = scene.Step(30).Read();
            using (SourceScene scene = Second())
                otherAlone = scene.Step(30).Read();
            using (SourceScene scene = First(), other = Second())
            {
                for (int i = 0; i < 30; i++)
                {
                    scene.Step();
                    other.Step();
                }
                beside = scene.Read();
                otherTogether = other.Read();
            }
            TestFluid.AssertSame(beside, alone);
            TestFluid.AssertSame(otherTogether, otherAlone);

            SourceScene First()
            {
                var scene = new SourceScene(Box, Spacing, 900);
                scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => e.Rate = 0.02f);
                scene.Add<FluidForceField>(Vector3.zero, Vector3.right);
                return scene;
            }

            SourceScene Second()
            {
                SourceScene scene = new SourceScene(Box, 0.04f, 3000).Fill(0.1f);
                scene.Add<FluidEmitter>(new Vector3(0.1f, 0.4f, 0f), Vector3.left, e =>
                {
                    e.Rate = 0.01f;
                    e.Phase = 3;
                    e.Lifetime = 0.3f;
                });
                scene.Add<FluidDrain>(new Vector3(0f, -0.5f, 0f), Vector3.up, d => d.RateLimit = 0.01f);
                return scene;
            }
        }

        [Test]
        public void A_disabled_part_does_nothing_and_one_enabled_again_goes_on()
        {
            using (var scene = new SourceScene(Box, Spacing, 900))
            {
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => e.Rate = 0.02f);
                scene.Step(6);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(16).Within(1));
                emitter.enabled = false;
                Assert.That(emitter.IsEmitting, Is.False);
                scene.Step(6);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(16).Within(1));
                emitter.enabled = true;
                scene.Step(6);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(32).Within(2));
                scene.Fluid.KeepStateOnDisable = false;
                scene.Fluid.enabled = false;
                Assert.That(emitter.Emitted, Is.Zero);
                scene.Fluid.enabled = true;
                scene.Step(6);
                Assert.That(scene.Count(ParticleCounter.Emitted), Is.EqualTo(16).Within(1), "a fluid that is enabled again begins again");
                Object.DestroyImmediate(scene.Fluid.gameObject);      // with its parts
            }
        }
    }
}
