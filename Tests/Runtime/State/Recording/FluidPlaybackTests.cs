using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Playback of a recording: the particles that were recorded, at any time, in any order.</summary>
    public class FluidPlaybackTests
    {
        const float Step60 = 1f / 60f;
        const int Steps = 16;

        RecordedWater water;
        byte[] recording;

        [OneTimeSetUp]
        public void RecordOne()
        {
            water = new RecordedWater().Run(Steps);
            recording = water.End();
        }

        [OneTimeTearDown]
        public void Dispose() => water.Dispose();

        [Test]
        public void Every_frame_shows_the_particles_that_were_recorded_also_backwards()
        {
            Assert.That(water.States.Last().Count, Is.GreaterThan(water.States[0].Count + 20), "the emitter makes it grow");
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                Assert.That((playback.FrameCount, playback.WasCutShort, playback.HasIds), Is.EqualTo((Steps, false, true)));
                Assert.That(playback.Duration, Is.EqualTo((Steps - 1) / 60.0).Within(1e-6));
                foreach (int frame in Enumerable.Range(0, Steps).Concat(new[] { 3, 12, 11, 10, 0, 15, 1 }))
                {
                    playback.Time = frame / 60.0;
                    scene.Step();
                    Assert.That(playback.ShownFrame, Is.EqualTo(frame));
                    RecordedWater.AssertNear(scene.Read(), water.States[frame]);
                    Assert.That((scene.Fluid.StepCount, scene.Fluid.FrameTime), Is.EqualTo((frame + 3, scene.Fluid.FluidTime)));
                    Assert.That(scene.Fluid.FluidTime, Is.EqualTo((frame + 3) / 60.0).Within(1e-5));
                    AssertPhases(scene, frame);
                }
                Assert.That(playback.MissedFrames, Is.Zero);
            }
        }

        void AssertPhases(SourceScene scene, int frame)
        {
            Dictionary<uint, uint> expected = PhasesOf(water.States[frame].ids, water.Tags[frame]),
                actual = PhasesOf(scene.Read().ids, GpuTest.Read<uint>(scene.Fluid.Solver.Tags, water.States[frame].Count));
            Assert.That(actual, Is.EquivalentTo(expected));
            Assert.That(frame < 4 || expected.Values.Contains(2u));
        }

        static Dictionary<uint, uint> PhasesOf(uint[] ids, uint[] tags)
            => Enumerable.Range(0, ids.Length).ToDictionary(i => ids[i], i => tags[i] >> ParticleTags.PhaseShift);

        [Test]
        public void Between_frames_each_particle_goes_on_along_its_velocity()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                playback.Time = 7.25 / 60.0;
                scene.Step();
                ParticleState state = scene.Read();
                RecordedWater.AssertNear(state, water.States[7]);
                float4[] before = GpuTest.Read<float4>(scene.Fluid.Solver.StartPositions, state.Count);
                Assert.That(scene.Fluid.FrameTime - scene.Fluid.FluidTime, Is.EqualTo(0.25 / 60.0).Within(1e-6));
                for (int i = 0; i < state.Count; i++)
                {
                    float3 path = (state.positions[i].xyz - before[i].xyz) * scene.Fluid.Clock.FrameLag.x;     // as DrawnParticles.hlsl draws it
                    Assert.That(math.distance(path, state.velocities[i].xyz * (0.25f / 60f)), Is.LessThan(1e-4f));
                }
            }
        }

        [Test]
        public void Time_passes_at_the_speed_stops_at_the_end_or_begins_again()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                playback.Play();
                playback.Speed = 2f;
                scene.Step(3);
                Assert.That((playback.ShownFrame, playback.IsPlaying), Is.EqualTo((6, true)));
                scene.Step(20);
                Assert.That((playback.ShownFrame, playback.IsPlaying, playback.Time), Is.EqualTo((Steps - 1, false, playback.Duration)));
                playback.Speed = -1f;
                playback.Play();
                scene.Step(5);
                Assert.That(playback.ShownFrame, Is.EqualTo(Steps - 6));
                playback.Loop = true;
                scene.Step(Steps);
                Assert.That((playback.ShownFrame, playback.IsPlaying), Is.EqualTo((Steps - 7, true)), "round, over the start");
                playback.Speed = 1f;
                playback.Time = 0.0;
                scene.Step(Steps + 2);
                Assert.That(playback.ShownFrame, Is.EqualTo(3), "and over the end");
                RecordedWater.AssertNear(scene.Read(), water.States[3]);
            }
        }

        [Test]
        public void A_shown_frame_has_the_surface_and_the_answers_to_probes_of_the_fluid_that_was_recorded()
        {
            using (SourceScene live = RecordedWater.MakeScene(), scene = RecordedWater.MakeScene())
            {
                FluidProbe Probe(SourceScene of) => of.Add<FluidProbe>(new Vector3(-0.2f, -0.42f, 0.1f), Vector3.forward);
                FluidProbe expected = Probe(live), actual = Probe(scene);
                live.Fill(0.2f).Step(4);
                var recorder = live.Fluid.gameObject.AddComponent<FluidRecorder>();
                var file = new MemoryStream();
                recorder.OpenFile = _ => file;
                recorder.Record("memory");
                live.Fluid.Results.Surface.IsNeeded = true;
                live.Step();
                recorder.enabled = false;
                live.Fluid.FlushQueries();

                FluidPlayback playback = RecordedWater.Play(scene, file.ToArray());
                scene.Fluid.Results.Surface.IsNeeded = true;
                scene.Step();
                scene.Fluid.FlushQueries();
                Assert.That(actual.TryGetSample(out FluidProbeSample played));
                Assert.That(expected.TryGetSample(out FluidProbeSample sample));
                TestContext.Out.WriteLine($"density {sample.density} and {played.density}, height {sample.height} and {played.height} " +
                    $"m, velocity {sample.velocity.x} {sample.velocity.y} {sample.velocity.z} and {played.velocity.x} " +
                    $"{played.velocity.y} {played.velocity.z} m/s");
                Assert.That(played.density, Is.EqualTo(sample.density).Within(2e-3f));
                Assert.That(played.height, Is.EqualTo(sample.height).Within(0.01f * RecordedWater.Spacing));
                Assert.That(math.length(played.velocity - sample.velocity), Is.LessThan(5e-3f),
                    "the cells of a step are those before its correction");
                uint drawn = Drawn(scene), before = Drawn(live);
                Assert.That(drawn, Is.EqualTo(before).Within(before / 50), "ellipsoids");
                Assert.That(before, Is.GreaterThan(100));
            }
        }

        static uint Drawn(SourceScene scene)
        {
            Assert.That(scene.Fluid.Solver.SurfaceIsCurrent);
            return GpuTest.Read<uint>(scene.Fluid.Solver.Surface.Counters,
                scene.Fluid.Solver.Surface.Counters.count)[(int)SurfaceParticles.Counter.Drawn];
        }

        [Test]
        public void When_it_is_closed_the_fluid_goes_on_from_what_is_shown()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                playback.Time = 9.0 / 60.0;
                scene.Step();
                Assert.That(scene.Fluid.IsPlayedBack);
                playback.Close();
                scene.Step(3);
                Assert.That((scene.Fluid.IsPlayedBack, scene.Fluid.StepCount), Is.EqualTo((false, 12 + 3)));
                scene.AssertConserved();
                Assert.That(scene.Read().Count, Is.EqualTo(water.States[9].Count));
                Assert.That(scene.Read().positions.Zip(water.States[9].positions, (a, b) => math.distance(a.xyz, b.xyz)).Max(),
                    Is.GreaterThan(0.1f), "it moves");
            }
        }

        [Test]
        public void Nothing_is_done_for_a_frame_that_is_shown_already_and_a_restart_shows_it_again()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                playback.Time = 5.0 / 60.0;
                scene.Step();
                int version = scene.Fluid.Solver.StateVersion;
                scene.Step(3);
                Assert.That(scene.Fluid.Solver.StateVersion, Is.EqualTo(version));
                scene.Fluid.Restart();
                scene.Step();
                RecordedWater.AssertNear(scene.Read(), water.States[5]);
            }
        }

        [TestCase(RecordingFields.None)]
        [TestCase(RecordingFields.Velocities)]
        [TestCase(RecordingFields.Ids | RecordingFields.Phases)]
        public void Fields_that_are_left_out_take_no_bytes_and_are_shown_as_none(RecordingFields fields)
        {
            byte[] less = RecordedWater.Record(8, r => r.Fields = fields);
            using (SourceScene scene = RecordedWater.MakeScene())
            using (var reader = new RecordingReader(new MemoryStream(less)))
            {
                int bytes = 6 + ((fields & RecordingFields.Velocities) != 0 ? 6 : 0) + ((fields & RecordingFields.Ids) != 0 ? 4 : 0)
                    + ((fields & RecordingFields.Phases) != 0 ? 1 : 0);
                Assert.That(reader.Header.Layout.Words(reader.MaxParticles) * 4,
                    Is.InRange(bytes * reader.MaxParticles, bytes * reader.MaxParticles + 12));
                FluidPlayback playback = RecordedWater.Play(scene, less);
                playback.Time = 6.5 / 60.0;
                scene.Step();
                ParticleState state = scene.Read(), expected = water.States[6];
                Assert.That(state.Count, Is.EqualTo(expected.Count));
                float tolerance = math.length(0.5f * reader.Header.Layout.StepSize(expected.box)) + 1e-5f;
                foreach (float4 position in expected.positions)
                    Assert.That(state.positions.Min(p => math.distance(p.xyz, position.xyz)), Is.LessThanOrEqualTo(tolerance));
                bool moves = (fields & RecordingFields.Velocities) != 0;
                Assert.That(state.velocities.Any(v => math.length(v.xyz) > 0.1f), Is.EqualTo(moves));
                Assert.That(scene.Fluid.Solver.Tags != null, Is.EqualTo((fields & RecordingFields.Phases) != 0));
                Assert.That(playback.HasIds, Is.EqualTo((fields & RecordingFields.Ids) != 0));
                Assert.That(playback.Lag, moves ? Is.EqualTo(0.5 / 60.0).Within(1e-5) : Is.Zero, "s: without velocities nothing goes on");
            }
        }

        // Without ids a slot holds another particle in each frame. A version that is one more than that before goes on from its surface.
        [TestCase(RecordingFields.Velocities | RecordingFields.Ids, true)]
        [TestCase(RecordingFields.Velocities, false)]
        public void The_surface_goes_on_from_the_frame_before_only_where_particles_have_ids(RecordingFields fields, bool goesOn)
        {
            byte[] file = RecordedWater.Record(6, r => r.Fields = fields);
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, file);
                int Shown()
                {
                    scene.Fluid.Results.Surface.IsNeeded = true;
                    scene.Step();
                    Assert.That(scene.Fluid.Solver.SurfaceIsCurrent);
                    return scene.Fluid.Solver.SurfaceVersion;
                }
                int last = Shown();
                playback.Play();
                for (int frame = 1; frame < 4; frame++)
                {
                    int version = Shown();
                    Assert.That(playback.ShownFrame, Is.EqualTo(frame));
                    Assert.That(version - last, goesOn ? Is.EqualTo(1) : Is.GreaterThan(1), $"frame {frame}");
                    last = version;
                }
                playback.Time = 5.0 / 60.0;
                Assert.That(Shown() - last, Is.GreaterThan(1), "a jump");
            }
        }

        [Test]
        public void A_frame_that_is_not_read_in_time_is_counted_and_what_is_shown_stays()
        {
            var disk = new GatedFile(recording);
            using (SourceScene scene = RecordedWater.MakeScene().Fill(0.1f))
            {
                ParticleState before = scene.Read();
                FluidPlayback playback = scene.Fluid.gameObject.AddComponent<FluidPlayback>();
                playback.OpenFile = _ => disk;
                playback.Open("memory");
                playback.Pause();
                scene.Step(2);
                (int shown, int missed) = (playback.ShownFrame, playback.MissedFrames);
                disk.Gate.Set();
                Assert.That((shown, missed), Is.EqualTo((-1, 2)));
                TestFluid.AssertSame(scene.Read(), before);
                playback.WaitForFrames = true;
                scene.Step();
                Assert.That((playback.ShownFrame, playback.MissedFrames), Is.EqualTo((0, 2)));
                RecordedWater.AssertNear(scene.Read(), water.States[0]);
            }
        }

        [Test]
        public void A_damaged_frame_is_left_out_in_words_and_the_others_are_shown()
        {
            var damaged = (byte[])recording.Clone();
            long at;
            using (var reader = new RecordingReader(new MemoryStream(recording)))
                at = RecordingFormat.HeaderBytes + Enumerable.Range(0, 4)
                    .Sum(i => RecordingFormat.FrameHeaderBytes + 4 * reader.Header.Layout.Words(water.States[i].Count));
            damaged[at + 1000] ^= 16;
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, damaged);
                playback.Time = 3.0 / 60.0;
                scene.Step();
                LogAssert.Expect(LogType.Error,
                    new Regex("FluidPlayback 'Fluid' leaves out frame 4 of 'memory': Frame 4 of the recording was changed"));
                playback.Time = 4.0 / 60.0;
                scene.Step(3);
                Assert.That(playback.ShownFrame, Is.EqualTo(3));
                RecordedWater.AssertNear(scene.Read(), water.States[3]);
                playback.Time = 5.0 / 60.0;
                scene.Step();
                RecordedWater.AssertNear(scene.Read(), water.States[5]);
            }
        }

        [Test]
        public void A_recording_that_was_cut_short_plays_up_to_its_last_whole_frame()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, recording.Take(recording.Length * 2 / 3).ToArray());
                Assert.That((playback.WasCutShort, playback.FrameCount), Is.EqualTo((true, 10)).Or.EqualTo((true, 9)).Or.EqualTo((true, 11)));
                playback.Time = 1.0;
                scene.Step();
                Assert.That(playback.ShownFrame, Is.EqualTo(playback.FrameCount - 1));
                RecordedWater.AssertNear(scene.Read(), water.States[playback.FrameCount - 1]);
            }
        }

        [TestCase(0.04f, 4000, "particle spacing of 0.05 m, but this one has 0.04 m. Set the Particle Spacing to 0.05")]
        [TestCase(0.05f, 300, "more than the capacity of 300. Raise the Capacity to at least")]
        public void A_fluid_that_cannot_show_it_says_why_and_stays(float spacing, int capacity, string expected)
        {
            using (SourceScene scene = new SourceScene(RecordedWater.Box, spacing, capacity).Fill(0.05f))
            {
                ParticleState before = scene.Read();
                LogAssert.Expect(LogType.Error, new Regex("FluidPlayback 'Fluid' does not show 'memory': .*" + Regex.Escape(expected)));
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                scene.Step(2);
                TestFluid.AssertSame(scene.Read(), before);
                Assert.That(playback.Problem, Does.Contain(expected));
            }
        }

        [Test]
        public void A_fluid_in_another_box_does_not_show_it_and_says_which_box_it_takes()
        {
            using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 1f), RecordedWater.Spacing, RecordedWater.Capacity).Fill(0.05f))
            {
                ParticleState before = scene.Read();
                LogAssert.Expect(LogType.Error, new Regex("FluidPlayback 'Fluid' does not show 'memory': it is of a box of 1 x 1 x 0.8 m, but " +
                    "this one is 1 x 1 x 1 m. Set the Domain Size to that of the recording"));
                RecordedWater.Play(scene, recording);
                scene.Step(2);
                TestFluid.AssertSame(scene.Read(), before);
            }
        }

        [Test]
        public void A_file_is_closed_with_its_recording_and_where_it_holds_no_frame([Values] bool hasFrames)
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                var file = new MemoryStream(hasFrames ? recording : recording.Take(100).ToArray());
                FluidPlayback playback = scene.Fluid.gameObject.AddComponent<FluidPlayback>();
                playback.OpenFile = _ => file;
                if (hasFrames)
                {
                    playback.Open("memory");
                    scene.Step();
                    Assert.That(file.CanRead);
                    playback.Close();
                }
                else
                    Assert.Throws<InvalidDataException>(() => playback.Open("memory"));
                Assert.That(file.CanRead, Is.False);
            }
        }

        // Four frames: the one asked for and those that come next, round the ends.
        [Test]
        public void Frames_are_read_ahead_in_the_direction_in_which_it_plays()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                var disk = new WatchedFile(recording);
                FluidPlayback playback = scene.Fluid.gameObject.AddComponent<FluidPlayback>();
                playback.OpenFile = _ => disk;
                playback.WaitForFrames = true;
                playback.Open("memory");
                playback.Pause();
                scene.Step();
                AssertRead(0, 1, 2, 3);
                playback.Time = 10.0 / 60.0;
                scene.Step();
                AssertRead(0, 1, 2, 3, 10, 11, 12, 13);
                playback.Time = 9.0 / 60.0;
                scene.Step();
                AssertRead(0, 1, 2, 3, 6, 7, 8, 9, 10, 11, 12, 13);
                playback.Time = 1.0 / 60.0;
                scene.Step();
                Assert.That(SpinWait.SpinUntil(() => disk.Frames.Contains(14), 20_000), "before the first is the last");

                void AssertRead(params int[] frames)
                {
                    Assert.That(SpinWait.SpinUntil(() => frames.All(disk.Frames.Contains), 20_000), string.Join(" ", disk.Frames));
                    Assert.That(disk.Frames, Is.EquivalentTo(frames));
                }
            }
        }

        [Test]
        public void Statistics_are_measured_of_the_frames_that_are_shown()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                scene.Fluid.StatisticsInterval = 1;
                foreach (int frame in new[] { 0, 5, 12, 3 })
                {
                    playback.Time = frame / 60.0;
                    scene.Step();
                    AsyncGPUReadback.WaitAllRequests();
                    Assert.That(scene.Fluid.TryGetStatistics(out FluidStatistics statistics), $"frame {frame}");
                    Assert.That((statistics.particles, statistics.step), Is.EqualTo((water.States[frame].Count, frame + 3)));
                }
            }
        }

        // It was on the other side of the water when the fluid last took a step.
        [Test]
        public void A_collider_that_is_put_elsewhere_while_it_plays_does_not_sweep_the_water_when_it_is_closed()
        {
            using (SourceScene scene = RecordedWater.MakeScene().Fill(0.1f))
            {
                var collider = new GameObject("Obstacle").AddComponent<FluidCollider>();
                try
                {
                    collider.Size = 0.1f * Vector3.one;
                    collider.transform.position = new Vector3(-0.58f, -0.42f, 0f);
                    scene.Step(2);
                    FluidPlayback playback = RecordedWater.Play(scene, recording);
                    playback.Time = 9.0 / 60.0;
                    scene.Step();
                    collider.transform.position = new Vector3(0.58f, -0.42f, 0f);
                    scene.Step();
                    float before = Fastest(scene);
                    playback.Close();
                    scene.Step();
                    TestContext.Out.WriteLine($"{before:0.00} m/s as shown, {Fastest(scene):0.00} m/s after a step");
                    Assert.That(Fastest(scene), Is.LessThan(before + 1f), "it came 1.16 m in a step");
                }
                finally
                {
                    UnityEngine.Object.DestroyImmediate(collider.gameObject);
                }
            }
        }

        static float Fastest(SourceScene scene) => scene.Read().velocities.Max(v => math.length(v.xyz)) * RecordedWater.Spacing;

        [Test]
        public void What_is_let_in_after_it_is_closed_gets_ids_that_no_particle_of_the_frame_has()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                scene.Add<FluidEmitter>(new Vector3(-0.2f, 0.3f, 0f), Vector3.down, e => (e.Rate, e.Speed, e.Radius) = (0.02f, 1.5f, 0.1f));
                FluidPlayback playback = RecordedWater.Play(scene, recording);
                playback.Time = 9.0 / 60.0;
                scene.Step();
                playback.Close();
                scene.Step(12);
                ParticleState state = scene.Read();
                Assert.That(state.Count, Is.GreaterThan(water.States[9].Count + 10), "it lets some in");
                Assert.That(state.ids, Is.Unique);
                Assert.That(water.States[9].ids, Is.SubsetOf(state.ids));
            }
        }

        [Test]
        [Category("EditMode")]
        public void Without_Play_the_length_of_a_recording_is_that_from_its_first_frame_on()
        {
            var gameObject = new GameObject("Fluid");
            try
            {
                gameObject.SetActive(false);
                FluidPlayback playback = gameObject.AddComponent<FluidPlayback>();
                playback.OpenFile = _ => new MemoryStream(recording);
                Assert.That(playback.TryFindDuration(out _), Is.False, "none is named");
                playback.Recording = "memory";
                Assert.That(playback.TryFindDuration(out double seconds));
                Assert.That(seconds, Is.EqualTo((Steps - 1) / 60.0).Within(1e-6), "the first frame is that of step 3");
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(gameObject);
            }
        }

        [Test]
        public void What_cannot_be_played_is_refused_in_words()
        {
            using (SourceScene scene = RecordedWater.MakeScene())
            {
                FluidPlayback playback = scene.Fluid.gameObject.AddComponent<FluidPlayback>();
                Assert.Throws<ArgumentNullException>(() => playback.Open(null));
                Assert.That(Assert.Throws<FileNotFoundException>(() =>
                    playback.Open(Path.Combine(Path.GetTempPath(), "rill-no-such-file"))).Message, Does.Contain("rill-no-such-file"));
                playback.OpenFile = _ => new MemoryStream(recording.Take(100).ToArray());
                Assert.That(Assert.Throws<InvalidDataException>(() => playback.Open("short")).Message, Does.Contain("'short' holds no whole frame"));
                playback.Platform = RuntimePlatform.WebGLPlayer;
                Assert.That(Assert.Throws<InvalidOperationException>(() => playback.Open("memory")).Message, Does.Contain("WebGL has no threads"));
                playback.Platform = RuntimePlatform.Android;
                Assert.That(Assert.Throws<IOException>(() => playback.Open("films/well.rill")).Message,
                    Does.Contain("'films/well.rill'").And.Contain("Copy it to Application.persistentDataPath"));
                Assert.Throws<InvalidDataException>(() => playback.Open("/data/files/well.rill"), "a copy is opened");
                playback.Platform = null;
                Assert.Throws<ArgumentException>(() => playback.Time = double.NaN);
                Assert.That(Assert.Throws<ArgumentOutOfRangeException>(() => playback.TimeOf(0)).Message, Does.Contain("has 0 frames"));
                playback.enabled = false;
                Assert.That(Assert.Throws<InvalidOperationException>(() => playback.Open("memory")).Message, Does.Contain("is disabled"));
                Assert.That((playback.IsOpen, playback.Duration, playback.FrameCount, scene.Fluid.IsPlayedBack), Is.EqualTo((false, 0.0, 0, false)));
                LogAssert.Expect(LogType.Warning, new Regex("speed 200 is outside -100 to 100"));
                playback.Speed = 200f;
            }
            LogAssert.NoUnexpectedReceived();
        }

        /// <summary>A file that notes which frames are read.</summary>
        sealed class WatchedFile : MemoryStream
        {
            readonly List<long> starts = new List<long>();
            readonly ConcurrentDictionary<int, bool> read = new ConcurrentDictionary<int, bool>();
            readonly int opener = Thread.CurrentThread.ManagedThreadId;

            public WatchedFile(byte[] bytes) : base(bytes)
            {
                using (var reader = new RecordingReader(new MemoryStream(bytes)))
                {
                    var frame = new RecordedFrame();
                    long at = RecordingFormat.HeaderBytes;
                    for (int i = 0; i < reader.FrameCount; i++)
                    {
                        reader.Read(i, frame);
                        starts.Add(at);
                        at += RecordingFormat.FrameHeaderBytes + 4 * reader.Header.Layout.Words(frame.particles);
                    }
                }
            }

            public ICollection<int> Frames => read.Keys;

            public override int Read(Span<byte> to)
            {
                int frame = starts.IndexOf(Position);
                if (frame >= 0 && Thread.CurrentThread.ManagedThreadId != opener)
                    read[frame] = true;
                return base.Read(to);
            }
        }

        /// <summary>A file whose frames are not read before the gate is open.</summary>
        sealed class GatedFile : MemoryStream
        {
            public readonly ManualResetEventSlim Gate = new ManualResetEventSlim(false);
            readonly int opener = Thread.CurrentThread.ManagedThreadId;

            public GatedFile(byte[] bytes) : base(bytes) { }

            public override int Read(Span<byte> to)
            {
                if (Thread.CurrentThread.ManagedThreadId != opener)
                    Gate.Wait();
                var bytes = new byte[to.Length];
                int read = base.Read(bytes, 0, bytes.Length);
                bytes.AsSpan(0, read).CopyTo(to);
                return read;
            }
        }
    }
}
