using System;
using System.Collections.Generic;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Host.Report.Extremes
{
    /// <summary>A FluidSimulation with one volume of water, played frame by frame; what it logs is kept and not printed.</summary>
    sealed class ExtremeComponent : IDisposable
    {
        public const float Frame = 1f / 60f;

        public readonly GameObject Object;
        public readonly FluidSimulation Fluid;
        public readonly List<string> Messages = new();
        public readonly List<FluidStatistics> Samples = new();

        readonly Action<LogEntry> writer = LogSink.Writer;

        /// <param name="box">m.</param>
        /// <param name="water">Size of the volume, in the box's lowest corner, m.</param>
        /// <param name="setUp">Before the component is enabled.</param>
        public ExtremeComponent(Vector3 box, float spacing, int capacity, Vector3 water, Action<FluidSimulation> setUp = null)
        {
            LogSink.Writer = entry => Messages.Add(entry.Message);
            Object = new GameObject("Tank");
            Object.SetActive(false);
            Fluid = Object.AddComponent<FluidSimulation>();
            Fluid.Configure(box, spacing, capacity);
            Fluid.StatisticsInterval = 0;
            var volume = new GameObject("Water");
            volume.transform.SetParent(Object.transform, false);
            volume.transform.localPosition = (water - box) * 0.5f;
            volume.AddComponent<FluidVolume>().Size = water;
            setUp?.Invoke(Fluid);
            Object.SetActive(true);
        }

        public bool Said(string text) => Messages.Exists(message => message.Contains(text, StringComparison.Ordinal));

        public ExtremeComponent Frames(int count)
        {
            for (int i = 0; i < count; i++)
                Fluid.Advance(Frame);
            return this;
        }

        public void Add(float3 world, float3 velocity)
        {
            using var positions = new NativeArray<float3>(new[] { world }, Allocator.Persistent);
            using var velocities = new NativeArray<float3>(new[] { velocity }, Allocator.Persistent);
            Fluid.AddParticles(positions, velocities);
        }

        public FluidStatistics Measure()
        {
            using var commands = new CommandBuffer { name = "extreme" };
            Fluid.Solver.RecordStatistics(commands, Fluid.Input);
            Graphics.ExecuteCommandBuffer(commands);
            Fluid.Solver.RequestStatistics();
            AsyncGPUReadback.WaitAllRequests();
            if (!Fluid.Solver.TryGetStatistics(Fluid.Input, out FluidStatistics statistics))
                throw new InvalidOperationException("The statistics did not come with the device's other answers.");
            Samples.Add(statistics);
            return statistics;
        }

        /// <summary>Positions of all particles by their ids, d.</summary>
        public float3[] Read()
        {
            int count = Samples[^1].particles;
            var positions = new float4[count];
            var ids = new uint[count];
            Fluid.Solver.Positions.GetData(positions, 0, 0, count);
            Fluid.Solver.ParticleIds.GetData(ids, 0, 0, count);
            Array.Sort(ids, positions);
            return Array.ConvertAll(positions, p => p.xyz);
        }

        public ExtremeCounts Counts(long added) => ExtremeCounts.Of(added, Samples);

        public void Dispose()
        {
            UnityEngine.Object.DestroyImmediate(Object);
            LogSink.Writer = writer;
        }
    }
}
