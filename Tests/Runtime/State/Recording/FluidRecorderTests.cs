using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Content of a recording, its end, and that it does not affect the fluid.</summary>
    public class FluidRecorderTests
    {
        static void Expect(string message) => LogAssert.Expect(LogType.Error, new Regex(Regex.Escape(message)));

        [Test]
        public void Recording_changes_no_bit_of_the_fluid()
        {
            using (RecordedWater recorded = new RecordedWater().Run(12), free = new RecordedWater(false).Run(12))
            {
                for (int i = 0; i < free.States.Count; i++)
                    TestFluid.AssertSame(recorded.States[i], free.States[i]);
                Assert.That(Steps(recorded.End()), Is.EqualTo(Enumerable.Range(3, 12)));
            }
        }

        [UnityTest]
        public IEnumerator Frames_are_written_without_waiting_and_a_stopped_file_is_whole()
        {
            string path = Path.Combine(Path.GetTempPath(), $"rill-{Guid.NewGuid():N}.rillrec");
            using (var water = new RecordedWater(false))
            {
                water.Recorder.OpenFile = File.Create;
                water.Recorder.Record(path);
                water.Scene.Step(3);
                Assert.That((water.Recorder.IsRecording, water.Recorder.FrameCount), Is.EqualTo((true, 0)), "nothing waited for");
                water.Recorder.Stop();
                Assert.That((water.Recorder.IsRecording, water.Recorder.IsWriting), Is.EqualTo((false, true)));
                for (int frame = 0; frame < 2000 && water.Recorder.IsWriting; frame++)
                    yield return null;
                Assert.That((water.Recorder.IsWriting, water.Recorder.FrameCount, water.Recorder.Problem), Is.EqualTo((false, 3, (string)null)));
                Assert.That(water.Recorder.FileSize, Is.EqualTo(new FileInfo(path).Length));
                Assert.That(Steps(File.ReadAllBytes(path)), Is.EqualTo(new[] { 3, 4, 5 }));
            }
            File.Delete(path);
        }

        [Test]
        public void A_rate_of_30_takes_every_second_of_60_steps_and_all_steps_of_a_frame_count()
        {
            using (var water = new RecordedWater(true, r => r.Rate = 30f))
            {
                water.Run(5);
                for (int i = 0; i < 3; i++)
                    water.Scene.Fluid.Advance(3f / 60f);        // three steps in a frame
                Assert.That(Steps(water.End()), Is.EqualTo(new[] { 3, 5, 7, 9, 11, 13, 15 }));
            }
            Assert.That(Steps(RecordedWater.Record(4, r => r.Rate = 1000f)), Is.EqualTo(new[] { 3, 4, 5, 6 }), "at most one for each step");
        }

        [Test]
        public void A_disk_that_falls_behind_ends_the_recording_in_words_and_every_frame_that_waited_is_kept()
        {
            using (var disk = new HeldStream())
            using (var water = new RecordedWater(true, r => { r.OpenFile = _ => disk; r.BufferedFrames = 4; }))
            {
                water.Run(4);
                bool recordsStill = water.Recorder.IsRecording;
                Expect("FluidRecorder 'Fluid' stopped to record: all 4 frames that Buffered Frames allows are pending, 0 from the GPU " +
                    "and 4 to the disk. Record fewer Fields or at a lower Rate");
                water.Run(3);
                bool recordsThen = water.Recorder.IsRecording, writesThen = water.Recorder.IsWriting;
                disk.Go();
                water.Recorder.enabled = false;
                Assert.That((recordsStill, recordsThen, writesThen), Is.EqualTo((true, false, true)));
                Assert.That(water.Recorder.Problem, Does.Contain("'memory' holds the"));
                Assert.That(Steps(disk.ToArray()), Is.EqualTo(new[] { 3, 4, 5, 6 }));
            }
        }

        [Test]
        public void A_full_disk_ends_the_recording_in_words()
        {
            var disk = new FullStream(1000);
            using (var water = new RecordedWater(true, r => r.OpenFile = _ => disk))
            {
                water.Run(3);
                Expect("FluidRecorder 'Fluid' stopped to record: the disk did not take it: No space left on device. Make room");
                water.Recorder.enabled = false;
            }
        }

        [Test]
        public void A_fluid_that_starts_again_ends_the_recording_in_words()
        {
            using (var water = new RecordedWater())
            {
                water.Run(3);
                water.Scene.Fluid.Restart();
                Expect("FluidRecorder 'Fluid' stopped to record: the fluid was started again, restored or replaced");
                water.Run(2);
                water.Recorder.enabled = false;
                Assert.That(water.Recorder.FrameCount, Is.EqualTo(3));
            }
        }

        [Test]
        public void A_recorder_that_is_disabled_in_a_pass_of_a_script_keeps_the_frames_before()
        {
            using (var water = new RecordedWater())
            {
                water.Run(2);
                water.Scene.Fluid.BeforeStep += (commands, particles) => water.Recorder.enabled &= water.Scene.Fluid.StepCount < 4;
                water.Scene.Fluid.Advance(2f / 60f);
                Assert.That((water.Recorder.enabled, water.Recorder.FrameCount), Is.EqualTo((false, 2)));
                water.Run(1);
                Assert.That(Steps(water.End()), Is.EqualTo(new[] { 3, 4 }));
            }
        }

        // The first of two steps of a frame is recorded, and never taken.
        [Test]
        public void A_step_that_is_given_up_is_in_the_recording_only_when_it_is_taken([Values(0f, 60f)] float rate)
        {
            using (var water = new RecordedWater(true, r => r.Rate = rate))
            {
                FluidSimulation fluid = water.Scene.Fluid;
                water.Run(2);
                int passes = 0;
                Action<CommandBuffer, FluidParticles> pass = (commands, particles) => fluid.enabled &= ++passes < 2;
                fluid.BeforeStep += pass;
                fluid.Advance(2f / 60f);
                fluid.BeforeStep -= pass;
                Assert.That((passes, fluid.enabled), Is.EqualTo((2, false)));
                fluid.enabled = true;
                Assert.That((fluid.StepCount, water.Recorder.IsRecording), Is.EqualTo((4, true)));
                water.Run(2);
                Assert.That(Steps(water.End()), Is.EqualTo(new[] { 3, 4, 5, 6 }));
            }
        }

        [Test]
        public void What_cannot_be_recorded_is_refused_in_words()
        {
            using (var water = new RecordedWater())
            {
                Assert.That(Assert.Throws<InvalidOperationException>(() => water.Recorder.Record("other")).Message,
                    Does.Contain("already records into 'memory'"));
                Assert.Throws<ArgumentNullException>(() => water.Recorder.Record(null));
                water.End();
                Assert.That(Assert.Throws<InvalidOperationException>(() => water.Recorder.Record("other")).Message,
                    Does.Contain("enable both before"));
                water.Recorder.enabled = true;
                water.Recorder.Platform = RuntimePlatform.WebGLPlayer;
                Assert.That(Assert.Throws<InvalidOperationException>(() => water.Recorder.Record("other")).Message,
                    Does.Contain("WebGL has no threads"));
                water.Recorder.Platform = null;
                water.Recorder.OpenFile = File.Create;
                Assert.Throws<DirectoryNotFoundException>(() => water.Recorder.Record(Path.Combine(Path.GetTempPath(),
                    "rill-no-such-folder", "file")));
                Assert.That(water.Recorder.IsRecording, Is.False);
                LogAssert.Expect(LogType.Warning, new Regex("rate -1 is outside 0 to 1000"));
                water.Recorder.Rate = -1f;
                LogAssert.Expect(LogType.Warning, new Regex("buffered frames 2 is outside 4 to 64"));
                water.Recorder.BufferedFrames = 2;
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_recorder_takes_no_managed_memory_for_each_frame_but_what_a_readback_takes()
        {
            using (var water = new RecordedWater(true, r => r.OpenFile = _ => new MemoryStream(1 << 22)))
            {
                long recorded = AllocatedByFrame(water, () => { });
                water.End();
                Assert.That(water.Recorder.FrameCount, Is.GreaterThan(20));
                GraphicsBuffer buffer = water.Scene.Fluid.Solver.Counters;
                Action<AsyncGPUReadbackRequest> arrived = _ => { };
                Assert.That(recorded, Is.LessThanOrEqualTo(AllocatedByFrame(water, () => AsyncGPUReadback.Request(buffer, 16, 0, arrived))));
            }
        }

        static long AllocatedByFrame(RecordedWater water, Action act)
        {
            long before = 0;
            for (int i = 0; i < 24; i++)
            {
                before = GC.GetAllocatedBytesForCurrentThread();
                water.Scene.Step();
                act();
                AsyncGPUReadback.WaitAllRequests();
            }
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }

        internal static List<int> Steps(byte[] recording)
        {
            using (var reader = new RecordingReader(new MemoryStream(recording)))
            {
                var frame = new RecordedFrame();
                var steps = new List<int>();
                for (int i = 0; i < reader.FrameCount; i++)
                {
                    reader.Read(i, frame);
                    steps.Add(frame.step);
                }
                return steps;
            }
        }
    }
}
