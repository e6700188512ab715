using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Running recordings: what comes between their frames, and that a second one knows nothing of the first.</summary>
    public class RecordingStateTests
    {
        const double Step = 1.0 / 60.0;

        // Between two frames of the recording.
        public enum Between { Pause, FramesWithoutTime, DisableAndEnable, Teleport, Snapshot, Gravity, LongFrame }

        [Test]
        public void A_recording_goes_on_with_the_next_step_whatever_comes_between([Values] Between between)
        {
            using (var water = new RecordedWater().Run(3))
            {
                FluidSimulation fluid = water.Scene.Fluid;
                int steps = 3;
                switch (between)
                {
                    case Between.Pause:
                        fluid.Paused = true;
                        water.Scene.Step(3);
                        fluid.Paused = false;
                        break;
                    case Between.FramesWithoutTime:
                        fluid.Advance(0f);
                        fluid.Advance(0f);
                        break;
                    case Between.DisableAndEnable:
                        fluid.enabled = false;
                        fluid.enabled = true;
                        break;
                    case Between.Teleport:
                        fluid.transform.position += 3f * Vector3.right;
                        fluid.Teleport();
                        break;
                    case Between.Snapshot: fluid.RequestSnapshot(); break;
                    case Between.Gravity: fluid.Gravity = Vector3.right; break;
                    case Between.LongFrame:
                        fluid.Advance(0.2f);
                        steps += 4;
                        break;
                }
                water.Run(3);
                steps += 3;
                byte[] file = water.End();
                Assert.That(FluidRecorderTests.Steps(file), Is.EqualTo(Enumerable.Range(3, steps)));
                Assert.That(Times(file), Is.EqualTo(Enumerable.Range(3, steps).Select(step => step * Step)).Within(1e-6));
            }
        }

        [Test]
        public void A_second_recording_knows_nothing_of_the_first([Values] bool disables)
        {
            using (var water = new RecordedWater(true, r => r.Rate = 30f))
            {
                water.Run(4);
                Assert.That(FluidRecorderTests.Steps(water.End()), Is.EqualTo(new[] { 3, 5 }));
                water.Recorder.enabled = true;
                water.Run(1);       // so that the second begins at an even step
                foreach (int first in new[] { 8, 13 })
                {
                    var file = new MemoryStream();
                    water.Recorder.OpenFile = _ => file;
                    water.Recorder.Record("again");
                    water.Run(5);
                    End(water.Recorder, disables);
                    Assert.That(FluidRecorderTests.Steps(file.ToArray()), Is.EqualTo(new[] { first, first + 2, first + 4 }));
                }
                Assert.That(water.Recorder.Problem, Is.Null);
            }
        }

        [Test]
        public void A_recording_after_one_that_failed_has_no_problem_and_its_own_number_of_frames_that_wait()
        {
            using (var water = new RecordedWater())
            {
                water.Run(2);
                water.Scene.Fluid.Restart();
                LogAssert.Expect(LogType.Error, new Regex("stopped to record: the fluid was started again"));
                water.Run(1);
                End(water.Recorder, true);
                Assert.That(water.Recorder.Problem, Is.Not.Null);
                var disk = new HeldStream();
                water.Recorder.OpenFile = _ => disk;
                water.Recorder.BufferedFrames = 5;
                water.Recorder.Record("again");
                Assert.That((water.Recorder.Problem, water.Recorder.FrameCount), Is.EqualTo(((string)null, 0)));
                LogAssert.Expect(LogType.Error, new Regex("all 5 frames that Buffered Frames allows are pending"));
                water.Run(6);
                disk.Go();
                End(water.Recorder, true);
                Assert.That(FluidRecorderTests.Steps(disk.ToArray()), Is.EqualTo(Enumerable.Range(2, 5)));
            }
        }

        [Test]
        public void While_a_stopped_recording_is_still_written_no_other_begins()
        {
            var disk = new HeldStream();
            using (var water = new RecordedWater(true, r => r.OpenFile = _ => disk))
            {
                water.Run(2);
                water.Recorder.Stop();
                Assert.That((water.Recorder.IsRecording, water.Recorder.IsWriting), Is.EqualTo((false, true)));
                Assert.That(Assert.Throws<InvalidOperationException>(() => water.Recorder.Record("other")).Message, Does.Contain("already records"));
                water.Run(2);
                disk.Go();
                End(water.Recorder, true);
                Assert.That(FluidRecorderTests.Steps(disk.ToArray()), Is.EqualTo(new[] { 3, 4 }), "what came after it was stopped is not in it");
                var file = new MemoryStream();
                water.Recorder.OpenFile = _ => file;
                water.Recorder.Record("other");
                water.Run(2);
                End(water.Recorder, true);
                Assert.That(FluidRecorderTests.Steps(file.ToArray()), Is.EqualTo(new[] { 7, 8 }));
            }
        }

        // Works like a player: the frames are yet to come from the GPU.
        [Test]
        public void A_recorder_that_is_disabled_waits_for_what_the_GPU_has()
        {
            using (var water = new RecordedWater())
            {
                water.Scene.Step(3);
                Assert.That(water.Recorder.FrameCount, Is.Zero);
                Assert.That(FluidRecorderTests.Steps(water.End()), Is.EqualTo(new[] { 3, 4, 5 }));
            }
        }

        [Test]
        public void All_steps_of_a_frame_have_their_own_times()
        {
            using (var water = new RecordedWater())
            {
                water.Scene.Fluid.Advance(3f / 60f);
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(Times(water.End()), Is.EqualTo(new[] { 3 * Step, 4 * Step, 5 * Step }).Within(1e-6));
            }
        }

        // Fifty steps a second are each a hair short of 0.02 s.
        [Test]
        public void Half_the_rate_of_steps_takes_every_second_one_however_they_are_rounded()
        {
            using (var water = new RecordedWater(false))
            {
                var file = new MemoryStream();
                water.Scene.Fluid.StepRate = 50f;
                water.Recorder.OpenFile = _ => file;
                water.Recorder.Rate = 25f;
                water.Recorder.Record("memory");
                for (int i = 0; i < 40; i++)
                {
                    water.Scene.Fluid.Advance(0.02f);
                    AsyncGPUReadback.WaitAllRequests();
                }
                End(water.Recorder, true);
                Assert.That(FluidRecorderTests.Steps(file.ToArray()), Is.EqualTo(Enumerable.Range(0, 20).Select(i => 3 + 2 * i)));
            }
        }

        // From the first step on, so that the steps of the new run are later than that with which the recording began.
        [Test]
        public void A_restart_ends_a_recording_from_the_first_step_on()
        {
            using (SourceScene scene = RecordedWater.MakeScene().Fill(0.1f))
            {
                var file = new MemoryStream();
                var recorder = scene.Fluid.gameObject.AddComponent<FluidRecorder>();
                recorder.OpenFile = _ => file;
                recorder.Record("memory");
                scene.Step(3);
                AsyncGPUReadback.WaitAllRequests();
                scene.Fluid.Restart();
                LogAssert.Expect(LogType.Error, new Regex("stopped to record: the fluid was started again, restored or replaced"));
                scene.Step(2);
                End(recorder, true);
                Assert.That(FluidRecorderTests.Steps(file.ToArray()), Is.EqualTo(new[] { 1, 2, 3 }));
            }
        }

        // Its steps are counted on, and its particles are others.
        [UnityTest]
        public IEnumerator Another_resolution_ends_a_recording()
        {
            using (var water = new RecordedWater().Run(3))
            {
                water.Scene.Fluid.ParticleSpacing = 0.06f;
                LogAssert.Expect(LogType.Error, new Regex("stopped to record: the fluid was started again, restored or replaced"));
                for (int i = 0; i < 5; i++)
                {
                    water.Scene.Step();
                    AsyncGPUReadback.WaitAllRequests();
                    yield return null;
                }
                Assert.That(water.Scene.Fluid.StepCount, Is.GreaterThan(5), "which counts on");
                Assert.That(water.Recorder.IsRecording, Is.False);
                End(water.Recorder, true);
            }
        }

        static void End(FluidRecorder recorder, bool disables)
        {
            if (disables)
            {
                recorder.enabled = false;
                recorder.enabled = true;
            }
            else
            {
                recorder.Stop();
                SpinWait.SpinUntil(() => !recorder.IsWriting, 20_000);
            }
            Assert.That((recorder.IsRecording, recorder.IsWriting), Is.EqualTo((false, false)));
        }

        static List<double> Times(byte[] recording)
        {
            using (var reader = new RecordingReader(new MemoryStream(recording)))
            {
                var frame = new RecordedFrame();
                var times = new List<double>();
                for (int i = 0; i < reader.FrameCount; i++)
                {
                    reader.Read(i, frame);
                    times.Add(frame.time);
                }
                return times;
            }
        }
    }
}
