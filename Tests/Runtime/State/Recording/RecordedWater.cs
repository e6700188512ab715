using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>A fluid that an emitter makes grow, recorded in memory, with what each step left.</summary>
    sealed class RecordedWater : IDisposable
    {
        public static readonly Vector3 Box = new Vector3(1f, 1f, 0.8f);
        public const float Spacing = 0.05f;
        public const int Capacity = 4000;

        public readonly SourceScene Scene;
        public readonly FluidRecorder Recorder;
        public readonly List<ParticleState> States = new List<ParticleState>();
        public readonly List<uint[]> Tags = new List<uint[]>();

        readonly MemoryStream file = new MemoryStream();

        public RecordedWater(bool records = true, Action<FluidRecorder> set = null)
        {
            Scene = new SourceScene(Box, Spacing, Capacity);
            Scene.Add<FluidEmitter>(new Vector3(0.1f, 0.3f, 0f), Vector3.down, e =>
            {
                e.Rate = 0.02f;
                e.Speed = 1.5f;
                e.Radius = 0.1f;
                e.Phase = 2;
            });
            Scene.Fill(0.2f).Step(2);
            Recorder = Scene.Fluid.gameObject.AddComponent<FluidRecorder>();
            Recorder.OpenFile = _ => file;
            set?.Invoke(Recorder);
            if (records)
                Recorder.Record("memory");
        }

        /// <summary>Steps, and keeps what each leaves.</summary>
        public RecordedWater Run(int steps)
        {
            for (int i = 0; i < steps; i++)
            {
                Scene.Step();
                AsyncGPUReadback.WaitAllRequests();      // as frames of a player do in time
                States.Add(Scene.Read());
                Tags.Add(Scene.Fluid.Solver.Tags != null ? GpuTest.Read<uint>(Scene.Fluid.Solver.Tags, States.Last().Count) : null);
            }
            return this;
        }

        /// <summary>Ends the recording; its file.</summary>
        public byte[] End()
        {
            Recorder.enabled = false;       // waits for all
            Assert.That((Recorder.IsRecording, Recorder.IsWriting, Recorder.Problem), Is.EqualTo((false, false, (string)null)));
            return file.ToArray();
        }

        public static byte[] Record(int steps, Action<FluidRecorder> set = null)
        {
            using (RecordedWater water = new RecordedWater(true, set).Run(steps))
                return water.End();
        }

        /// <summary>A fluid of the same kind that shows a recording, paused at its start, and waits for frames.</summary>
        public static FluidPlayback Play(SourceScene scene, byte[] recording)
        {
            FluidPlayback playback = scene.Fluid.gameObject.AddComponent<FluidPlayback>();
            playback.OpenFile = _ => new MemoryStream(recording);
            playback.WaitForFrames = true;
            playback.Open("memory");
            playback.Pause();
            return playback;
        }

        public static SourceScene MakeScene() => new SourceScene(Box, Spacing, Capacity);

        /// <summary>Fails unless both have the same particles, by id, but for the rounding of a recording.</summary>
        public static void AssertNear(ParticleState actual, ParticleState expected)
        {
            Assert.That(actual.Count, Is.EqualTo(expected.Count));
            Assert.That(actual.ids, Is.EquivalentTo(expected.ids));
            float3 tolerance = 0.5f * new FrameLayout(RecordingFields.All, false).StepSize(expected.box) + 1e-5f;
            int[] order = Enumerable.Range(0, actual.Count).ToArray(), expectedOrder = (int[])order.Clone();
            Array.Sort((uint[])actual.ids.Clone(), order);
            Array.Sort((uint[])expected.ids.Clone(), expectedOrder);
            for (int i = 0; i < order.Length; i++)
            {
                float3 away = math.abs(actual.positions[order[i]].xyz - expected.positions[expectedOrder[i]].xyz);
                Assert.That(math.all(away <= tolerance), $"particle {expected.ids[expectedOrder[i]]} is {away} d away, and may be {tolerance}");
                float3 moves = expected.velocities[expectedOrder[i]].xyz, other = math.abs(actual.velocities[order[i]].xyz - moves);
                Assert.That(math.all(other <= math.abs(moves) / 2048f + 2e-3f), $"its velocity {moves} d/s became another by {other}");
            }
        }

        public void Dispose() => Scene.Dispose();
    }
}
