using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Profiling;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Reports of a player's GPU time: recorders three frames late, whole frames four, or nothing.</summary>
    public class GpuTimeTests : GraphicsFixture
    {
        const string Name = "GpuTimeTests.Outer", Inner = "GpuTimeTests.Inner";

        [TearDown]
        public void ReportEverything() => Player.GpuTimes = GpuTimes.Samples;

        [Test]
        public void A_recorder_tells_of_the_frame_three_frames_ago()
        {
            using var work = new Work();
            Recorder recorder = CustomSampler.Create(Name, true).GetRecorder();
            Assert.That(recorder.isValid);
            recorder.enabled = true;
            var blocks = new List<int>();
            for (int frame = 0; frame < 8; frame++)
            {
                Frame();
                Player.Device.WaitIdle();
                blocks.Add(recorder.gpuSampleBlockCount);
                Assert.That(recorder.gpuElapsedNanoseconds > 0, Is.EqualTo(blocks[^1] > 0), $"frame {frame}");
                if (frame is 1 or 3)
                    work.Run(times: frame, Name);
            }
            Assert.That(blocks, Is.EqualTo(new[] { 0, 0, 0, 0, 1, 0, 3, 0 }));
        }

        [Test]
        public void An_outer_sample_takes_at_least_as_long_as_what_lies_in_it()
        {
            using var work = new Work();
            Recorder outer = CustomSampler.Create(Name, true).GetRecorder(), inner = CustomSampler.Create(Inner, true).GetRecorder();
            outer.enabled = inner.enabled = true;
            Frame();
            work.Run(times: 1, Name, Inner);
            Player.Device.WaitIdle();
            for (int i = 0; i < 3; i++)
                Frame();
            Assert.That(inner.gpuElapsedNanoseconds, Is.GreaterThan(0));
            Assert.That(outer.gpuElapsedNanoseconds, Is.GreaterThanOrEqualTo(inner.gpuElapsedNanoseconds));
        }

        [Test]
        public void A_recorder_that_is_not_enabled_and_a_sampler_without_gpu_data_tell_nothing()
        {
            using var work = new Work();
            Recorder off = CustomSampler.Create(Name, true).GetRecorder(), cpuOnly = CustomSampler.Create("GpuTimeTests.Cpu").GetRecorder();
            cpuOnly.enabled = true;
            Frame();
            work.Run(times: 1, Name, "GpuTimeTests.Cpu");
            Player.Device.WaitIdle();
            for (int i = 0; i < 3; i++)
                Frame();
            Assert.That(off.gpuSampleBlockCount + cpuOnly.gpuSampleBlockCount, Is.Zero);
            Assert.That(cpuOnly.isValid, Is.False);
        }

        [Test]
        public void A_mark_of_time_is_not_there_before_the_stream_has_got_to_it()
        {
            using DeviceTimeMark mark = Player.Device.MarkTime();
            Assert.That(mark.TryRead(out _), Is.False);
            Player.Device.WaitIdle();
            Assert.That(mark.TryRead(out double first));
            using DeviceTimeMark later = Player.Device.MarkTime();
            Player.Device.WaitIdle();
            Assert.That(later.TryRead(out double second));
            Assert.That(second, Is.GreaterThanOrEqualTo(first));
        }

        [Test]
        public void Frame_timings_are_four_frames_late_and_hold_all_work_of_the_frame()
        {
            using var work = new Work();
            Recorder recorder = CustomSampler.Create(Name, true).GetRecorder();
            recorder.enabled = true;
            Assert.That(FrameTimingManager.IsFeatureEnabled());
            FrameTimingManager.CaptureFrameTimings();
            var timings = new FrameTiming[2];
            work.InUpdate(Name);
            for (int frame = 1; frame <= 5; frame++)
            {
                Frame();
                Player.Device.WaitIdle();
                FrameTimingManager.CaptureFrameTimings();
                Assert.That(FrameTimingManager.GetLatestTimings(2, timings), Is.EqualTo(frame == 5 ? 1u : 0u), $"frame {frame}");
                if (frame == 4)
                    Assert.That(recorder.gpuSampleBlockCount, Is.EqualTo(1), "of the first frame");
                double sampled = recorder.gpuElapsedNanoseconds * 1e-6;
                if (frame == 4)
                    timings[1].gpuFrameTime = sampled;
            }
            Assert.That(timings[0].gpuFrameTime, Is.GreaterThanOrEqualTo(timings[1].gpuFrameTime).And.GreaterThan(0));
            Assert.That(timings[0].cpuFrameTime, Is.GreaterThan(0));
        }

        [TestCase("Samples", true, true)]
        [TestCase("Frames", false, true)]
        [TestCase("None", false, false)]
        public void A_player_that_tells_less_says_so(string told, bool samples, bool frames)
        {
            Player.GpuTimes = Enum.Parse<GpuTimes>(told);
            Assert.That(SystemInfo.supportsGpuRecorder, Is.EqualTo(samples));
            Assert.That(CustomSampler.Create(Name, true).GetRecorder().isValid, Is.EqualTo(samples));
            Assert.That(FrameTimingManager.IsFeatureEnabled(), Is.EqualTo(frames));
        }

        [TestCase("Samples", 0f, GpuTimeKind.Measured)]
        [TestCase("Frames", 0f, GpuTimeKind.Modeled)]
        [TestCase("None", 5f, GpuTimeKind.Modeled)]
        [TestCase("None", 0f, GpuTimeKind.None)]
        public void A_budget_takes_the_best_time_that_the_player_tells(string told, float deviceFactor, GpuTimeKind expected)
        {
            Player.GpuTimes = Enum.Parse<GpuTimes>(told);
            FluidSimulation fluid = Fluid(deviceFactor);
            for (int i = 0; i < 90; i++)
            {
                Frame();
                if (i % 2 == 0)
                    Player.Device.WaitIdle();
            }
            Assert.That(fluid.BudgetState.source, Is.EqualTo(expected));
            if (expected == GpuTimeKind.None)
            {
                Assert.That(fluid.BudgetState.reason, Is.EqualTo(BudgetReason.TimeUnknown));
                Assert.That(fluid.BudgetState.iterations, Is.EqualTo(fluid.Settings.iterations));
                return;
            }
            Assert.That(fluid.BudgetState.milliseconds, Is.GreaterThan(0f));
            Assert.That(fluid.BudgetState.iterations, Is.EqualTo(16), "a second is enough for the best");
        }

        [Test]
        public void Steps_are_marked_only_while_the_budget_is_on()
        {
            FluidSimulation fluid = Fluid();
            SolverBudget on = fluid.Budget;
            Assert.That(Marked(), Is.True);
            fluid.Budget = SolverBudget.Default;
            Assert.That(Marked(), Is.False);
            fluid.Budget = on;
            Assert.That(Marked(), Is.True);
            FluidSimulation other = Fluid();
            Frame();
            Recorder first = Recorder.Get("Rill.Steps"), second = Recorder.Get("Rill.Steps 2");
            Assert.That(first.enabled && second.enabled, "each simulation has a name of its own");
            other.enabled = false;
            Assert.That(second.enabled, Is.False);
            Assert.That(first.enabled);

            static bool Marked()
            {
                Player.Device.Timing = true;
                Frame();
                Player.Device.Timing = false;
                return Player.Device.CollectSamples().Any(sample => sample.Name == "Rill.Steps");
            }
        }

        static FluidSimulation Fluid(float deviceFactor = 0f)
        {
            var gameObject = new GameObject("Fluid");
            gameObject.SetActive(false);
            var fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(new Vector3(0.6f, 0.4f, 0.4f), 0.05f, 200);
            fluid.StatisticsInterval = 0;
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            budget.milliseconds = 1000f;
            budget.deviceFactor = deviceFactor;
            fluid.Budget = budget;
            gameObject.AddComponent<FluidVolume>().Size = new Vector3(0.2f, 0.2f, 0.2f);
            gameObject.SetActive(true);
            return fluid;
        }

        /// <summary>A little work under samples of given names.</summary>
        sealed class Work : IDisposable
        {
            readonly CommandBuffer cmd = new CommandBuffer { name = "Work" };
            readonly GraphicsBuffer values = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 64, 4);
            readonly ComputeShader shader = Compute("Work");

            public Work() => values.SetData(new uint[64]);

            public void Run(int times, params string[] samples)
            {
                cmd.Clear();
                int kernel = shader.FindKernel("AddOne");
                cmd.SetComputeIntParam(shader, "_Count", 64);
                cmd.SetComputeIntParam(shader, "_Step", 1);
                cmd.SetComputeBufferParam(shader, kernel, "_Values", values);
                for (int i = 0; i < times; i++)
                {
                    foreach (string name in samples)
                        cmd.BeginSample(name);
                    cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                    foreach (string name in samples.Reverse())
                        cmd.EndSample(name);
                }
                Graphics.ExecuteCommandBuffer(cmd);
            }

            public void InUpdate(string sample)
            {
                var runner = new GameObject("Runner").AddComponent<Runner>();
                runner.Work = this;
                runner.Sample = sample;
            }

            public void Dispose()
            {
                cmd.Dispose();
                values.Dispose();
            }
        }

        sealed class Runner : MonoBehaviour
        {
            public Work Work;
            public string Sample;
            void Update() => Work.Run(1, Sample);
        }
    }
}
