using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Measurements of detectors in their shapes, against geometry and counts.</summary>
    public class FluidDetectorTests
    {
        const float Spacing = QueryScene.Spacing;

        // A block at rest without gravity, larger than the shapes: each finds its own volume, however it is turned.
        [Test]
        public void The_volume_in_a_known_block_is_that_of_the_shape_within_one_percent(
            [Values(DetectorShape.Box, DetectorShape.Sphere, DetectorShape.Capsule)] DetectorShape shape, [Values(0f, 1f)] float turned)
        {
            using (var scene = new SourceScene(new Vector3(1.6f, 1.2f, 1.2f), Spacing, 25000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.AddWhere(p => p.x < 0.5f);
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(-0.1f, 0.02f, 0.01f),
                    new Vector3(0.3f * turned, 0.2f * turned, 1f), d =>
                {
                    d.Shape = shape;
                    d.Size = new Vector3(0.6f, 0.5f, 0.4f);
                    d.Radius = 0.3f;
                    d.Height = 0.9f;
                });
                scene.Step();
                FluidDetectorSample sample = detector.Flushed();
                TestContext.Out.WriteLine($"{sample.volume:0.00000} m³ of {detector.ShapeVolume:0.00000}: " +
                    $"{100f * (sample.volume / detector.ShapeVolume - 1f):0.00} %");
                Assert.That(sample.volume, Is.EqualTo(detector.ShapeVolume).Within(0.01f * detector.ShapeVolume));
                Assert.That(sample.fill, Is.EqualTo(1f).Within(0.01f));
                Assert.That(sample.mass, Is.EqualTo(sample.volume * 1000f).Within(1e-3f));
            }
        }

        // Groups of threads look at the box around their particles first: one that reaches a detector alone is in it all the same.
        [Test]
        public void A_lone_particle_is_found_wherever_it_is_in_memory([Values(0, 60, 122, 509, 700)] int others)
        {
            using (var scene = new SourceScene(new Vector3(1.6f, 1.6f, 1.6f), Spacing, 1000))
            {
                Vector3[] directions = { Vector3.left, Vector3.down, Vector3.back, Vector3.right, Vector3.up, Vector3.forward };
                FluidDetector[] detectors = directions.Select(direction => scene.Add<FluidDetector>(0.6f * direction, Vector3.forward,
                    d => d.Size = 4f * Spacing * Vector3.one)).ToArray();
                scene.Run(1);
                var lattice = Enumerable.Range(0, others).Select(i => Spacing * new float3(i % 9 - 4, i / 9 % 9 - 4, i / 81 - 4));
                float3[] all = lattice.Concat(directions.Select(direction => (float3)(0.6f * direction))).ToArray();
                using (var positions = new NativeArray<float3>(all, Allocator.Persistent))
                using (var velocities = new NativeArray<float3>(all.Length, Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, velocities);
                Assert.That(detectors[0].MeasureNow().volume, Is.EqualTo(scene.ParticleVolume).Within(0.01).Percent);
                foreach (FluidDetector detector in detectors)
                    Assert.That(detector.Latest.volume, Is.EqualTo(scene.ParticleVolume).Within(0.01).Percent, $"at {detector.transform.position}");
            }
        }

        // A ball of water in the far end of a long shape that is turned about no axis of the box: turned otherwise it finds none.
        [Test]
        public void Water_in_one_end_of_a_turned_shape_is_found_there([Values(DetectorShape.Box, DetectorShape.Capsule,
            DetectorShape.Mesh)] DetectorShape shape)
        {
            SignedDistanceField field = null;
            if (shape == DetectorShape.Mesh)
            {
                MeshSdfSettings settings = MeshSdfSettings.Default;
                settings.resolution = 32;
                field = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Box(new Vector3(0.9f, 0.3f, 0.3f), Vector3.zero), settings));
            }
            using (var scene = new SourceScene(new Vector3(1.6f, 1.2f, 1.2f), Spacing, 1000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                Quaternion turn = Quaternion.Euler(20f, 35f, 50f);
                Vector3 end = turn * (shape == DetectorShape.Capsule ? new Vector3(0f, 0.28f, 0f) : new Vector3(0.32f, 0f, 0f));
                int count = scene.AddWhere(p => Vector3.Distance(p, end) < 0.09f);
                FluidDetector detector = scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d =>
                {
                    (d.Shape, d.Size, d.Radius, d.Height, d.Field) = (shape, new Vector3(0.9f, 0.3f, 0.3f), 0.15f, 0.9f, field);
                    d.transform.rotation = turn;
                });
                scene.Step();
                Assert.That(count, Is.GreaterThan(10));
                Assert.That(detector.Flushed().volume, Is.EqualTo(count * scene.ParticleVolume).Within(0.02f * count * scene.ParticleVolume));
            }
            if (field != null)
                UnityEngine.Object.DestroyImmediate(field.Texture);
            UnityEngine.Object.DestroyImmediate(field);
        }

        // A mesh that is not around its object's position, in a box that is moved and turned: in water it finds its own volume, and beside it none.
        [Test]
        public void A_listener_that_throws_is_logged_and_all_others_hear_all_the_same()
        {
            using (var scene = new SourceScene(new Vector3(0.4f, 0.4f, 0.4f), Spacing, 300).Fill(0.2f))
            {
                var told = new List<string>();
                for (int i = 0; i < 2; i++)
                {
                    FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.1f, 0f), Vector3.forward, d => d.Size = 0.2f * Vector3.one);
                    detector.OnEnter += () => throw new InvalidOperationException("of a listener");
                    detector.OnEnter += () => told.Add("entered");
                    detector.OnFilled += () => told.Add("filled");
                    LogAssert.Expect(LogType.Exception, new Regex("InvalidOperationException: of a listener"));
                }
                scene.Run(3);
                Assert.That(told, Is.EqualTo(new[] { "entered", "filled", "entered", "filled" }));
            }
        }

        [Test]
        public void Of_a_million_reads_at_any_time_none_is_passed_as_valid_that_is_not()
        {
            using (var scene = new SourceScene(new Vector3(0.4f, 0.4f, 0.4f), Spacing, 300).Fill(0.2f))
            {
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.1f, 0f), Vector3.forward, d => d.Size = 0.4f * Vector3.one);
                const float volume = 0.4f * 0.2f * 0.4f;
                int heard = 0, reads = 0, valid = 0;
                detector.OnFilled += () => heard++;
                void Read(int count)
                {
                    for (int i = 0; i < count; i++, reads++)
                    {
                        bool isValid = detector.TryGetSample(out FluidDetectorSample s);
                        if (isValid != s.valid || isValid && (s.step < 1 || s.step > scene.Fluid.StepCount || !(s.age >= 0f)
                            || !(Math.Abs(s.volume - volume) < 0.1f * volume) || !s.hasVelocity
                            || Math.Abs(s.time + s.age - scene.Fluid.FrameTime) > 1e-5))
                            Assert.Fail($"read {reads}: {isValid}, step {s.step} of {scene.Fluid.StepCount}, age {s.age}, {s.volume} m³");
                        valid += isValid ? 1 : 0;
                    }
                }
                QueryScene.ReadAtAnyTime(scene.Fluid, Read);
                TestContext.Out.WriteLine($"{reads:N0} reads, {valid:N0} valid, filled {heard} times");
                Assert.That(reads, Is.GreaterThanOrEqualTo(1000000));
                Assert.That(valid, Is.GreaterThan(reads / 4).And.LessThan(reads));
            }
        }

        [Test]
        public void The_volume_in_a_mesh_is_that_of_its_field_at_the_objects_pose_and_scale(
            [Values(SdfFormat.Half, SdfFormat.Float)] SdfFormat format)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 40;
            settings.format = format;
            TriangleMesh block = TestMeshes.Box(new Vector3(0.6f, 0.5f, 0.4f), new Vector3(0.2f, 0f, 0f));
            SignedDistanceField box = SignedDistanceField.Create(MeshSdfBaker.Bake(block, settings));
            SignedDistanceField ball = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Sphere(0.4f, 24), settings));
            try
            {
                using (var scene = new SourceScene(new Vector3(1.6f, 1.2f, 1.2f), Spacing, 25000))
                {
                    scene.Fluid.Gravity = Vector3.zero;
                    scene.AddWhere(p => p.x < 0.5f, 0.5f * Vector3.right);
                    scene.Fluid.Inertial = false;
                    scene.Fluid.transform.SetPositionAndRotation(new Vector3(3f, 1f, 2f), Quaternion.Euler(10f, 30f, 0f));
                    FluidDetector Mesh(SignedDistanceField field, Vector3 local, Quaternion turn, float scale)
                        => scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d =>
                        {
                            d.Shape = DetectorShape.Mesh;
                            d.Field = field;
                            d.transform.localPosition = local;
                            d.transform.localRotation = turn;
                            d.transform.localScale = scale * Vector3.one;
                        });
                    Quaternion turned = Quaternion.Euler(20f, 35f, 50f);
                    FluidDetector[] inside =
                    {
                        Mesh(box, new Vector3(-0.3f, 0.02f, 0.01f), Quaternion.identity, 1f), Mesh(box, new Vector3(-0.2f, 0f, 0f), turned, 1f),
                        Mesh(ball, new Vector3(-0.15f, 0f, 0f), turned, 1f),
                        Mesh(box, new Vector3(-0.1f, 0f, 0f) - turned * new Vector3(0.23f, 0f, 0f), turned, 1.15f),
                    };
                    FluidDetector half = Mesh(ball, new Vector3(0.5f, 0f, 0f), Quaternion.identity, 0.5f);
                    FluidDetector beside = Mesh(box, new Vector3(-2f, 0f, 0f), Quaternion.identity, 1f);
                    FluidDetector plain = scene.Add<FluidDetector>(scene.Fluid.transform.position, scene.Fluid.transform.forward,
                        d => d.Size = 0.4f * Vector3.one);
                    scene.Step();
                    foreach (FluidDetector detector in inside)
                    {
                        FluidDetectorSample sample = detector.Flushed();
                        TestContext.Out.WriteLine($"{sample.volume:0.00000} m³ of {detector.ShapeVolume:0.00000}: " +
                            $"{100f * (sample.volume / detector.ShapeVolume - 1f):0.00} %");
                        Assert.That(sample.volume, Is.EqualTo(detector.ShapeVolume).Within(0.01f * detector.ShapeVolume));
                        Assert.That(Vector3.Distance(sample.velocity, scene.Fluid.transform.rotation * (0.5f * Vector3.right)), Is.LessThan(0.02f));
                    }
                    Assert.That(inside[0].ShapeVolume, Is.EqualTo(0.12f).Within(0.002f));
                    Assert.That(inside[3].ShapeVolume, Is.EqualTo(0.12f * 1.15f * 1.15f * 1.15f).Within(0.003f));
                    // The water's face went through its center and has moved on by a step since.
                    Assert.That(half.Flushed().fill, Is.EqualTo(0.5f + 0.75f * 0.5f / 60f / 0.2f).Within(0.02f));
                    Assert.That(beside.Flushed().volume, Is.Zero);
                    Assert.That(plain.Flushed().volume, Is.EqualTo(0.064f).Within(0.001f), "a box beside meshes");
                }
            }
            finally
            {
                foreach (SignedDistanceField field in new[] { box, ball })
                {
                    UnityEngine.Object.DestroyImmediate(field.Texture);
                    UnityEngine.Object.DestroyImmediate(field);
                }
            }
        }

        [Test]
        public void A_mesh_without_a_field_says_so_and_measures_nothing()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000).Fill(0.3f))
            {
                FluidDetector detector = scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d => d.Shape = DetectorShape.Mesh);
                LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidDetector 'FluidDetector': it is a mesh without a signed distance field, " +
                    "so it measures nothing. Bake one from the mesh and assign it."));
                scene.Run(2);
                Assert.That(detector.TryGetSample(out FluidDetectorSample sample) || sample.valid, Is.False);
                Assert.That(detector.ShapeVolume, Is.Zero);
            }
            LogAssert.NoUnexpectedReceived();
        }

        // Moved a tenth of a spacing at a time, a box in water never finds more or less.
        [Test]
        public void The_volume_does_not_jump_by_particles_as_the_shape_moves()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.AddWhere(_ => true);
                FluidDetector[] boxes = Enumerable.Range(0, 20)
                    .Select(i => scene.Add<FluidDetector>(new Vector3(0.1f, 0.05f, 0f) + 0.1f * i * Spacing * new Vector3(1f, 0.7f, 0.3f),
                    Vector3.forward, d => d.Size = new Vector3(0.3f, 0.25f, 0.2f))).ToArray();
                scene.Step();
                float[] volumes = boxes.Select(box => box.Flushed().volume / box.ShapeVolume).ToArray();
                TestContext.Out.WriteLine($"{volumes.Min():0.0000} to {volumes.Max():0.0000}");
                Assert.That(volumes, Is.All.EqualTo(1f).Within(0.01f));
            }
        }

        [Test]
        public void A_detector_around_everything_finds_every_particle_once_with_its_phase_and_momentum()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 6000))
            {
                scene.AddWhere(position => position.y < -0.2f && position.x < 0.2f);
                FluidEmitter emitter = scene.Add<FluidEmitter>(new Vector3(0.3f, 0.3f, 0f), Vector3.down, e =>
                {
                    e.Rate = 0.05f;
                    e.Phase = 3;
                });
                FluidDetector detector = scene.Add<FluidDetector>(Vector3.zero, new Vector3(0.1f, 0.2f, 1f), d => d.Size = Vector3.one * 3f);
                FluidDetector half = scene.Add<FluidDetector>(new Vector3(-1f, 0f, 0f), Vector3.forward, d => d.Size = Vector3.one * 2f);
                scene.Run(20);
                FluidDetectorSample sample = detector.Flushed(), of = half.Flushed();
                ParticleState state = scene.Read();
                float particle = scene.ParticleVolume;
                Assert.That(sample.volume, Is.EqualTo(state.Count * particle).Within(1e-5f * state.Count * particle));
                int emitted = scene.Count(ParticleCounter.Emitted);
                Assert.That(emitted, Is.GreaterThan(50));
                Assert.That(sample.VolumeOf(3), Is.EqualTo(emitted * particle).Within(1e-5f * emitted * particle));
                Assert.That(sample.VolumeOf(0), Is.EqualTo((state.Count - emitted) * particle).Within(1e-5f * state.Count * particle));
                double3 momentum = state.velocities.Aggregate(new double3(0.0), (sum, v) => sum + (double3)v.xyz) * (Spacing * particle * 1000.0);
                Assert.That(math.distance(momentum, (double3)(float3)sample.momentum), Is.LessThan(2e-3 * math.length(momentum)));
                double left = state.positions.Sum(p => Math.Min(Math.Max(0.5 - (p.x - 0.5 * state.box.x), 0.0), 1.0));
                Assert.That(of.volume, Is.EqualTo(left * particle).Within(1e-4 * left * particle));
                Assert.Throws<ArgumentOutOfRangeException>(() => sample.VolumeOf(8));
            }
        }

        // The velocity of water that a plunger lifts is known: the plunger's.
        [Test]
        public void Water_before_a_plunger_moves_as_the_plunger_within_three_percent()
        {
            const float Speed = 0.4f;
            using (var scene = new SourceScene(new Vector3(1.6f, 0.4f, 0.4f), Spacing, 3000))
            {
                scene.Fluid.Gravity = 9.81f * Vector3.left;      // so that the water stays with it
                scene.AddWhere(p => p.x > -0.5f && p.x < 0.1f);
                var plunger = new GameObject("Plunger");
                plunger.transform.SetParent(scene.Fluid.transform, false);
                plunger.transform.localPosition = new Vector3(-0.6f, 0f, 0f);
                plunger.AddComponent<FluidCollider>().Size = new Vector3(0.2f, 0.6f, 0.6f);
                FluidDetector detector = scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d => d.Size = new Vector3(0.2f, 0.4f, 0.4f));
                FluidProbe probe = scene.Probe(Vector3.zero);
                for (int i = 0; i < 60; i++)
                {
                    plunger.transform.localPosition += Speed * SourceScene.Step60 * Vector3.right;
                    scene.Run(1);
                }
                // The remaining sloshing goes to and fro; a probe also sees what its particles do.
                const int Frames = 20;
                Vector3 mean = Vector3.zero, at = Vector3.zero;
                for (int i = 0; i < Frames; i++)
                {
                    plunger.transform.localPosition += Speed * SourceScene.Step60 * Vector3.right;
                    scene.Run(1);
                    mean += detector.Flushed().velocity / Frames;
                    at += probe.Flushed().velocity / Frames;
                }
                TestContext.Out.WriteLine($"plunger {Speed} m/s, detector {mean}, probe {at}");
                Assert.That(Vector3.Distance(mean, Speed * Vector3.right), Is.LessThan(0.03f * Speed));
                Assert.That(at.x, Is.EqualTo(Speed).Within(0.03f * Speed));     // aside, its few particles creep
            }
        }

        [Test]
        public void Events_come_once_for_each_crossing_and_not_again_within_the_hysteresis()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 3000))
            {
                // A block that falls through a box.
                scene.AddWhere(p => p.y > 0.1f && p.y < 0.35f && Math.Abs(p.x) < 0.25f && Math.Abs(p.z) < 0.25f);
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.1f, 0f), Vector3.forward, d =>
                {
                    d.Size = new Vector3(0.4f, 0.2f, 0.4f);
                    d.ImpactSpeed = 1.5f;
                });
                var said = new List<string>();
                var fills = new List<float>();
                detector.OnEnter += () => said.Add("entered");
                detector.OnFilled += () => said.Add("filled");
                detector.OnImpact += () => said.Add("impact");
                detector.OnEmptied += () => said.Add("emptied");
                detector.OnExit += () => said.Add("left");
                detector.OnEnter += () => Assert.That(detector.Latest.fill, Is.GreaterThanOrEqualTo(detector.EnterFill));
                for (int i = 0; i < 28; i++)       // until before the splash comes up again
                {
                    scene.Run(1);
                    fills.Add(detector.Latest.fill);
                }
                TestContext.Out.WriteLine(string.Join(", ", said) + "; " + string.Join(" ", fills.Select(fill => $"{fill:0.00}")));
                Assert.That(fills.Max(), Is.GreaterThan(0.6f));
                Assert.That(said.Where(what => what != "impact"), Is.EqualTo(new[] { "entered", "filled", "emptied", "left" }));
                Assert.That(said.Count(what => what == "impact"), Is.EqualTo(1));
            }
        }

        // Water that drifts evenly, and thresholds that are set just inside of each band around what is measured, and just beyond.
        [Test]
        public void Each_event_comes_again_only_after_its_threshold_was_left_by_the_whole_band()
        {
            using (var scene = new SourceScene(0.6f * Vector3.one, Spacing, 100))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.AddWhere(p => Math.Abs(p.x) < 0.1f && Math.Abs(p.y) < 0.1f && Math.Abs(p.z) < 0.1f, 0.1f * Vector3.right);
                FluidDetector detector = scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d =>
                {
                    d.Size = 0.6f * Vector3.one;
                    d.EnterFill = d.FillLevel = 1f;
                    d.ImpactSpeed = 100f;
                    d.Hysteresis = 0.01f;
                });
                string called = "";
                detector.OnEnter += () => called += "entered ";
                detector.OnExit += () => called += "left ";
                detector.OnFilled += () => called += "filled ";
                detector.OnEmptied += () => called += "emptied ";
                detector.OnImpact += () => called += "impact ";
                scene.Run(1);
                float fill = detector.Latest.fill, speed = detector.Latest.velocity.magnitude;
                Assert.That(fill, Is.EqualTo(64f * Spacing * Spacing * Spacing / 0.216f).Within(0.1f).Percent);
                Assert.That(speed, Is.EqualTo(0.1f).Within(1).Percent);

                Expect("", () => detector.EnterFill = 1.01f * fill);
                Expect("entered ", () => detector.EnterFill = 0.99f * fill);
                Expect("", () => detector.EnterFill = 1.98f * fill);
                Expect("", () => detector.EnterFill = 0.99f * fill);
                Expect("left ", () => detector.EnterFill = 2.02f * fill);
                Expect("", () => detector.EnterFill = 1.01f * fill);
                Expect("entered ", () => detector.EnterFill = 0.99f * fill);

                Expect("", () => detector.FillLevel = 1.01f * fill);
                Expect("filled ", () => detector.FillLevel = 0.99f * fill);
                Expect("", () => detector.FillLevel = fill + 0.0099f);
                Expect("", () => detector.FillLevel = 0.99f * fill);
                Expect("emptied ", () => detector.FillLevel = fill + 0.0101f);
                Expect("", () => detector.FillLevel = 1.01f * fill);
                Expect("filled ", () => detector.FillLevel = 0.99f * fill);

                Expect("", () => detector.ImpactSpeed = 1.01f * speed);
                Expect("impact ", () => detector.ImpactSpeed = 0.99f * speed);
                Expect("", () => detector.ImpactSpeed = 1.24f * speed);
                Expect("", () => detector.ImpactSpeed = 0.99f * speed);
                Expect("", () => detector.ImpactSpeed = 1.26f * speed);
                Expect("", () => detector.ImpactSpeed = 1.01f * speed);
                Expect("impact ", () => detector.ImpactSpeed = 0.99f * speed);

                void Expect(string events, Action set)
                {
                    called = "";
                    set();
                    scene.Run(1);
                    Assert.That(called, Is.EqualTo(events), $"enters at {detector.EnterFill / fill}, fills at {detector.FillLevel / fill} of " +
                        $"the fill, hits at {detector.ImpactSpeed / speed} of the speed");
                }
            }
        }

        [Test]
        public void After_a_restart_every_event_comes_again_as_the_first_time()
        {
            using (var scene = new SourceScene(0.6f * Vector3.one, Spacing, 100))
            {
                scene.Fluid.Gravity = Vector3.zero;
                string called = "";
                FluidDetector detector = scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d =>
                {
                    d.Size = 0.6f * Vector3.one;
                    d.EnterFill = d.FillLevel = 0.01f;
                    d.ImpactSpeed = 0.05f;
                    d.LevelStep = 0.5f;
                });
                detector.OnEnter += () => called += "entered ";
                detector.OnExit += () => called += "left ";
                detector.OnFilled += () => called += "filled ";
                detector.OnEmptied += () => called += "emptied ";
                detector.OnImpact += () => called += "impact ";
                detector.OnLevelChanged += level => called += "level ";
                for (int run = 0; run < 2; run++)
                {
                    called = "";
                    scene.AddWhere(p => Math.Abs(p.x) < 0.1f && Math.Abs(p.y) < 0.1f && Math.Abs(p.z) < 0.1f, 0.1f * Vector3.right);
                    scene.Run(2);
                    Assert.That(called, Is.EqualTo("entered filled impact level "), $"run {run}");
                    scene.Fluid.Restart();
                }
            }
        }

        // The fill that the detector says goes up and down by less than the hysteresis around the level.
        [Test]
        public void A_fill_that_trembles_about_the_level_calls_once()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 5000).Fill(0.3f))
            {
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.2f, 0f), Vector3.forward, d =>
                {
                    d.Size = new Vector3(1f, 0.2f, 1f);
                    d.FillLevel = 1f;
                });
                scene.Run(40);
                int filled = 0, emptied = 0;
                detector.OnFilled += () => filled++;
                detector.OnEmptied += () => emptied++;
                for (int i = 0; i < 30; i++)
                {
                    detector.transform.position = new Vector3(0f, -0.2f + 0.003f * (i % 3 - 1), 0f);     // the fill by 0.015 up and down
                    scene.Run(1);
                    if (i == 0)
                        detector.FillLevel = detector.Latest.fill - 0.01f;
                }
                Assert.That(filled, Is.EqualTo(1));
                Assert.That(emptied, Is.Zero);
                detector.Hysteresis = 0f;
                for (int i = 0; i < 12; i++)
                {
                    detector.transform.position = new Vector3(0f, -0.2f + 0.01f * (i % 3 - 1), 0f);
                    scene.Run(1);
                }
                Assert.That(emptied, Is.GreaterThan(2), "without hysteresis it calls at every crossing");
            }
        }

        // The box goes up through the surface of a pool, and out of it.
        [Test]
        public void A_level_is_told_when_it_has_changed_by_the_step_and_with_the_first_result()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 2000).Fill(0.3f))
            {
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.2f, 0f), Vector3.forward, d =>
                {
                    d.Size = new Vector3(0.4f, 0.2f, 0.4f);
                    d.LevelStep = 0.25f;
                });
                FluidProbe probe = scene.Add<FluidProbe>(new Vector3(0f, -0.2f, 0f), Vector3.forward, p => p.LevelStep = 1e-6f);
                FluidProbe dry = scene.Add<FluidProbe>(new Vector3(0f, 0.2f, 0f), Vector3.forward, p => p.LevelStep = 1f);
                var fills = new List<float>();
                var heights = new List<float>();
                int told = 0, first = 0;
                detector.OnLevelChanged += fills.Add;
                probe.OnLevelChanged += heights.Add;
                dry.OnLevelChanged += height => first++;
                void Count(float height) => told++;
                probe.OnLevelChanged += Count;
                for (int i = 0; i <= 10; i++)
                {
                    detector.transform.position = new Vector3(0f, -0.2f + 0.04f * i, 0f);
                    scene.Run(1);
                }
                TestContext.Out.WriteLine(string.Join(" ", fills) + "; " + string.Join(" ", heights));
                Assert.That(fills.Count, Is.InRange(4, 5), "first, and each quarter of what goes from full to empty");
                Assert.That(fills[0], Is.GreaterThan(0.9f));
                for (int i = 1; i < fills.Count; i++)
                    Assert.That(fills[i - 1] - fills[i], Is.GreaterThanOrEqualTo(0.25f));
                Assert.That(heights.Count, Is.GreaterThan(4), "each change");
                Assert.That(heights, Has.All.EqualTo(0f).Within(0.05f), "the surface's height");
                Assert.That(told, Is.EqualTo(heights.Count));
                Assert.That(first, Is.EqualTo(1), "a probe above the water has the surface below it");

                probe.OnLevelChanged -= Count;
                scene.Fluid.Restart();
                scene.Run(2);
                Assert.That(first, Is.EqualTo(2), "the first after a restart");
                Assert.That(heights.Count, Is.GreaterThan(told), "one that no longer listens is not told");
            }
        }

        [Test]
        public void A_listener_may_restart_the_fluid_and_disable_the_detector()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000).Fill(0.3f))
            {
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.2f, 0f), Vector3.forward,
                    d => d.Size = Vector3.one * 0.1f), second = scene.Add<FluidDetector>(new Vector3(0f, -0.2f, 0f), Vector3.forward, d
                    => d.Size = Vector3.one * 0.1f);
                int calls = 0;
                detector.OnEnter += () =>
                {
                    calls++;
                    scene.Fluid.Restart();
                    detector.enabled = false;
                };
                scene.Run(1);
                Assert.That(calls, Is.EqualTo(1));
                Assert.That(second.TryGetSample(out _), Is.False, "what was of before the restart");
                scene.Run(2);
                Assert.That(calls, Is.EqualTo(1));
                Assert.That(second.Flushed().step, Is.EqualTo(2));
            }
        }

        [Test]
        public void An_empty_shape_is_valid_with_no_volume_and_one_without_size_is_named_and_never_valid()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000).Fill(0.2f))
            {
                FluidDetector empty = scene.Add<FluidDetector>(new Vector3(0f, 0.25f, 0f), Vector3.forward, d => d.Size = Vector3.one * 0.1f);
                FluidDetector flat = scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d => d.Size = new Vector3(1f, 0f, 1f));
                Assert.That(empty.TryGetSample(out _), Is.False, "before the first result");
                LogAssert.Expect(LogType.Warning,
                    new Regex(
                    "^Rill: FluidDetector 'FluidDetector': its box of 1 x 0 x 1 m has no size, so it measures nothing. Set its size above 0."));
                scene.Step();
                FluidDetectorSample sample = empty.Flushed();
                Assert.That(sample.volume, Is.Zero);
                Assert.That(sample.hasVelocity, Is.False);
                flat.Flush();
                Assert.That(flat.TryGetSample(out _), Is.False);
                scene.Fluid.Restart();
                Assert.That(empty.TryGetSample(out _), Is.False, "after a restart");
                scene.Step();
                Assert.That(empty.Flushed().step, Is.EqualTo(1));
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void One_detector_more_than_there_is_room_for_is_refused_by_name()
        {
            using (var scene = new SourceScene(new Vector3(0.4f, 0.4f, 0.4f), Spacing, 300).Fill(0.2f))
            {
                for (int i = 0; i < Queries.MaxDetectors; i++)
                    scene.Add<FluidDetector>(Vector3.zero, Vector3.forward);
                LogAssert.Expect(LogType.Warning,
                    new Regex("^Rill: FluidDetector 'FluidDetector': FluidSimulation 'Fluid' has 32 of its kind, the most it takes"));
                scene.Add<FluidDetector>(Vector3.zero, Vector3.forward);
                scene.Step();
                List<FluidDetector> all = scene.Fluid.GetComponentsInChildren<FluidDetector>().ToList();
                Assert.That(all.Count(detector => detector.Number >= 0 && detector.Flushed().volume > 0f), Is.EqualTo(32));
            }
            LogAssert.NoUnexpectedReceived();
        }
    }
}
